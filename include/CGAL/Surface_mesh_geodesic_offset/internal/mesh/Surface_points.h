// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the core reads of the user's mesh beside the unfolded mesh: points in space, and the order of faces.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SURFACE_POINTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SURFACE_POINTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <cstddef>

namespace CGAL::Geodesic_offset::internal {

// Indices are those of the unfolded mesh. Several threads call these functions at the same time.
template <class Kernel>
struct Surface_points
{
  typedef typename Kernel::Point_3 Point_3;

  virtual ~Surface_points() = default;

  // \throws std::logic_error if the mesh has lengths instead of points
  virtual Point_3 point_of_vertex(Index v) const = 0;

  virtual std::size_t mesh_index_of_face(Index f) const = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
