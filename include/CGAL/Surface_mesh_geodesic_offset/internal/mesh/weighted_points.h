// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points in space from weights.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_WEIGHTED_POINTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_WEIGHTED_POINTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>

#include <cstddef>

namespace CGAL::Geodesic_offset::internal {

// The point on the segment from p to q at parameter t.
template <class Point_3, class FT>
Point_3 point_between(const Point_3& p, const Point_3& q, const FT& t)
{
  const FT s = FT(1) - t;
  return Point_3(FT(s * p.x() + t * q.x()), FT(s * p.y() + t * q.y()), FT(s * p.z() + t * q.z()));
}

// The point of a face with these weights of its corners.
template <class Point_3, class FT, class Weights>
Point_3 weighted_point(const Weights& weights, const Per_corner<Point_3>& corners)
{
  FT x(0), y(0), z(0);
  for (std::size_t k = 0; k < 3; ++k)
  {
    x += weights[k] * corners[k].x();
    y += weights[k] * corners[k].y();
    z += weights[k] * corners[k].z();
  }
  return Point_3(x, y, z);
}

} // namespace CGAL::Geodesic_offset::internal

#endif
