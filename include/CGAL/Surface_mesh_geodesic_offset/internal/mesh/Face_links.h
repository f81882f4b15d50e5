// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connectivity of the faces as plain indices.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_FACE_LINKS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_FACE_LINKS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/assertions.h>

#include <boost/container/vector.hpp>

#include <array>

namespace CGAL::Geodesic_offset::internal {

// Indices of the mesh. The halfedges of a face are numbered from halfedge(f).
struct Face_links
{
  std::array<Index, 3> source; // vertices; no_index if the face does not exist
  std::array<Index, 3> beyond; // faces across the halfedges; no_index on the border

  bool is_face() const { return source[0] != no_index; }

  // The halfedge, 0 to 2, whose source is the vertex.
  Index halfedge_from(Index vertex) const
  {
    CGAL_precondition(source[0] == vertex || source[1] == vertex || source[2] == vertex);
    return Index(source[1] == vertex) + 2 * Index(source[2] == vertex);
  }
};

typedef boost::container::vector<Face_links> All_face_links; // by face index

} // namespace CGAL::Geodesic_offset::internal

#endif
