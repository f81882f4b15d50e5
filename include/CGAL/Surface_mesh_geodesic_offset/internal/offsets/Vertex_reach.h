// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The size of the faces around a place. The coordinates of windows have the rounding of the largest face on their path: next to
// a face of size 1, those in a face of size 1e-7 are exact to 1e-16, not to 1e-23.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_VERTEX_REACH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_VERTEX_REACH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Per vertex, the longest edge of the faces around it. Zero for exact numbers, which have no rounding.
template <class FT>
class Vertex_reach
{
public:
  explicit Vertex_reach(const Unfolded_mesh<FT>& mesh) : m_mesh(&mesh)
  {
    if constexpr (!Number_policy<FT>::is_inexact) return;
    m_reach.resize(mesh.number_of_vertices(), FT(0));
    for (Index h = 0; h < Index(mesh.number_of_halfedges()); h += 3)
    {
      if (mesh.source(h) == no_index) continue;
      const FT longest = (std::max)({mesh[h].length, mesh[h + 1].length, mesh[h + 2].length});
      for (Index k = h; k < h + 3; ++k) m_reach[mesh.source(k)] = (std::max)(m_reach[mesh.source(k)], longest);
    }
  }

  // Longest edge of the faces around the ends of an edge.
  FT of_edge(Index h) const { return (std::max)(at(m_mesh->source(h)), at(m_mesh->target(h))); }

  // Longest edge of the faces around the corners of a face.
  FT of_face(Index f) const { return (std::max)(of_edge(3 * f), at(m_mesh->source(3 * f + 2))); }

private:
  FT at(Index v) const { return m_reach.empty() ? FT(0) : m_reach[v]; }

  const Unfolded_mesh<FT>* m_mesh;
  std::vector<FT> m_reach;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
