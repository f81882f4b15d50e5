// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Indices of vertices and faces in the flat arrays: those of the mesh, or, if these scatter neighbours in memory, indices
// along a space-filling curve.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_INDEX_RENUMBERING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_INDEX_RENUMBERING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_links.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Spatial_order.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class TriangleMesh, class VertexIndexMap, class FaceIndexMap>
class Index_renumbering
{
public:
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  // vertices, faces: all of the mesh.
  Index_renumbering(const TriangleMesh& tm, const VertexIndexMap& vim, const FaceIndexMap& fim,
                    const std::vector<vertex_descriptor>& vertices, const std::vector<face_descriptor>& faces)
    : m_tm(tm), m_vim(vim), m_fim(fim)
  {
    std::size_t largest_vertex = 0, largest_face = 0;
    for (const vertex_descriptor v : vertices) largest_vertex = (std::max)(largest_vertex, std::size_t(get(vim, v)));
    for (const face_descriptor f : faces) largest_face = (std::max)(largest_face, std::size_t(get(fim, f)));
    if (largest_vertex >= (std::size_t(1) << 29) - 1 || largest_face >= (std::size_t(1) << 30) - 1)
      throw std::length_error("Surface_mesh_geodesic_offset: the mesh has too many elements for 32-bit indices, or indices "
                              "that are not set");
    if (!vertices.empty()) m_vertices_end = largest_vertex + 1;
    if (!faces.empty()) m_faces_end = largest_face + 1;
  }

  // Links by face index of the mesh.
  template <class Team>
  All_face_links face_links(const std::vector<face_descriptor>& faces, Team& team) const
  {
    return internal::face_links(m_tm, faces, m_vim, m_fim, m_faces_end, team);
  }

  // Replaces the indices if neighbours are scattered.
  template <class VertexPointMap, class Team>
  void renumber_if_scattered(const All_face_links& links, const std::vector<vertex_descriptor>& vertices,
                             const VertexPointMap& vpm, Team& team)
  {
    if (is_scattered(links)) renumber(links, vertices, vpm, team);
  }

  // Upper bounds of the indices; indices below may be unused.
  std::size_t vertices_end() const { return m_vertices_end; }
  std::size_t faces_end() const { return m_faces_end; }

  // Returns no_index or an unused index for elements of another mesh.
  Index of(vertex_descriptor v) const { return number(m_vertex, get(m_vim, v)); }
  Index of(face_descriptor f) const { return number(m_face, get(m_fim, f)); }
  Index of_halfedge(halfedge_descriptor h) const // precondition: h is not a border halfedge
  {
    const face_descriptor f = face(h, m_tm);
    const halfedge_descriptor first = halfedge(f, m_tm);
    return 3 * of(f) + (h == first ? 0 : next(first, m_tm) == h ? 1 : 2);
  }

  // Precondition: index is an index of the mesh.
  Index of_vertex(Index index) const { return m_vertex.empty() ? index : m_vertex[index]; }
  Index of_face(Index index) const { return m_face.empty() ? index : m_face[index]; }

  // Index in the user's mesh.
  std::size_t index_in_mesh(vertex_descriptor v) const { return std::size_t(get(m_vim, v)); }
  std::size_t index_in_mesh(face_descriptor f) const { return std::size_t(get(m_fim, f)); }

private:
  enum {
    worthwhile = 1 << 14, // faces: smaller meshes fit in the caches
    near = 1 << 10,       // index distance of neighbours that are likely to be cached together
    sample = 1 << 12      // faces
  };

  template <class I>
  static Index number(const std::vector<Index>& renumbered, const I& i)
  {
    return renumbered.empty() ? Index(i) : std::size_t(i) < renumbered.size() ? renumbered[std::size_t(i)] : no_index;
  }

  // True if the indices of neighbours are often far apart, from a sample of faces.
  static bool is_scattered(const All_face_links& links)
  {
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

  template <class VertexPointMap, class Team>
  void renumber(const All_face_links& links, const std::vector<vertex_descriptor>& vertices, const VertexPointMap& vpm,
                Team& team)
  {
    const auto coordinate = [](const auto& x) {
      const double d = CGAL::to_double(x);
      return std::isfinite(d) ? d : 0.; // reported later
    };
    const auto point = [&](std::size_t i) {
      const auto& p = get(vpm, vertices[i]);
      return Spatial_order::Point{coordinate(p.x()), coordinate(p.y()), coordinate(p.z())};
    };
    m_vertex.assign(m_vertices_end, no_index);
    const Spatial_order order(vertices.size(), point, team);
    for (std::size_t i = 0; i < vertices.size(); ++i) m_vertex[get(m_vim, vertices[order[i]])] = Index(i);
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

  const TriangleMesh& m_tm;
  VertexIndexMap m_vim;
  FaceIndexMap m_fim;
  std::size_t m_vertices_end = 0, m_faces_end = 0;
  std::vector<Index> m_vertex, m_face; // by mesh index; empty: identity
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
