// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the connectivity of the user's mesh. The mesh is traversed once, in its own memory order; later passes in other orders use
// the arrays.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_FACE_LINKS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_FACE_LINKS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_links.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL::Geodesic_offset::internal {

// Precondition: all face indices are less than `end`.
template <class TriangleMesh, class Faces, class VertexIndexMap, class FaceIndexMap, class Team>
All_face_links face_links(const TriangleMesh& tm, const Faces& faces, const VertexIndexMap& vim, const FaceIndexMap& fim,
                          std::size_t end, Team& team)
{
  All_face_links links(end, boost::container::default_init);
  if (faces.size() < end) // some indices are unused
    std::fill(links.begin(), links.end(), Face_links{{no_index, no_index, no_index}, {no_index, no_index, no_index}});
  Blocks(faces.size(), team.size()).for_each(team, [&](Index, std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k)
    {
      const std::size_t i = std::size_t(get(fim, faces[k]));
      const auto h0 = halfedge(faces[k], tm), h1 = next(h0, tm), h2 = next(h1, tm);
      if (h1 == h0 || next(h2, tm) != h0)
        throw std::invalid_argument("Surface_mesh_geodesic_offset: face " + std::to_string(i) + " is not a triangle");
      if (target(h0, tm) == target(h1, tm) || target(h1, tm) == target(h2, tm) || target(h2, tm) == target(h0, tm))
        throw std::invalid_argument("Surface_mesh_geodesic_offset: face " + std::to_string(i) + " has a vertex twice");
      const auto end_of = [&](const auto& h) { return Index(get(vim, target(h, tm))); };
      const auto beyond = [&](const auto& h) {
        const auto o = opposite(h, tm);
        return is_border(o, tm) ? no_index : Index(get(fim, face(o, tm)));
      };
      links[i] = {{end_of(h2), end_of(h0), end_of(h1)}, {beyond(h0), beyond(h1), beyond(h2)}};
    }
  });
  return links;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
