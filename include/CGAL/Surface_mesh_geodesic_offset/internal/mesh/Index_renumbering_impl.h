// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for Index_renumbering.h.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_INDEX_RENUMBERING_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_INDEX_RENUMBERING_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Index_renumbering.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Spatial_order.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// True if the indices of neighbours are often far apart, from a sample of faces.
inline bool Index_renumbering::is_scattered(const All_face_links& links)
{
  constexpr std::size_t worthwhile = 1 << 14; // faces: smaller meshes fit in the caches
  constexpr std::size_t near = 1 << 10;       // index distance of neighbours that are likely to be cached together
  constexpr std::size_t sample = 1 << 12;     // faces
  if (links.size() < worthwhile) return false;
  const auto are_far = [](std::size_t i, std::size_t j) { return (i < j ? j - i : i - j) >= near; };
  const std::size_t step = (std::max)(std::size_t(1), links.size() / sample);
  std::size_t pairs = 0, far = 0;
  for (std::size_t f = 0; f < links.size(); f += step)
  {
    const Face_links& l = links[f];
    if (!l.is_face()) continue;
    for (std::size_t k = 0; k < 3; ++k)
    {
      far += l.beyond[k] != no_index && are_far(f, l.beyond[k]);
      far += are_far(l.source[k], l.source[(k + 1) % 3]);
    }
    pairs += 6;
  }
  return 4 * far > pairs;
}

template <class Team>
void Index_renumbering::renumber_if_scattered(const All_face_links& links, const std::vector<Index>& vertices,
                                              const Coordinates& coordinates, Team& team)
{
  if (!is_scattered(links)) return;
  m_vertex.assign(m_vertices_end, no_index);
  const Spatial_order order(vertices.size(), coordinates, team);
  for (std::size_t i = 0; i < vertices.size(); ++i) m_vertex[vertices[order[i]]] = Index(i);
  m_vertices_end = vertices.size();

  // order faces by the lowest index of their vertices
  std::vector<Index> first(m_vertices_end + 1, 0);
  m_face.assign(m_faces_end, no_index);
  for (std::size_t f = 0; f < links.size(); ++f)
  {
    const auto& v = links[f].source;
    if (links[f].is_face()) ++first[(m_face[f] = (std::min)({m_vertex[v[0]], m_vertex[v[1]], m_vertex[v[2]]})) + 1];
  }
  for (std::size_t i = 1; i <= m_vertices_end; ++i) first[i] += first[i - 1];
  m_faces_end = first.back();
  for (Index& f : m_face)
    if (f != no_index) f = first[f]++;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
