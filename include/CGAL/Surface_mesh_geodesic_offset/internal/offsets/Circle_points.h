// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of one circle, counterclockwise: how far one is ahead of another, and the point in the middle.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CIRCLE_POINTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CIRCLE_POINTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Advance from p to q, for points less than a half turn apart: the sign is exact up to the rounding of the points; for near
// points, the value is the length between them.
template <class FT>
FT advance_on_circle(const Point_in_face<FT>& center, const FT& radius, const Point_in_face<FT>& p, const Point_in_face<FT>& q)
{
  return cross(p - center, q - p) / radius;
}

// The point in the middle between p and q, for points up to a half turn apart.
template <class FT>
Point_in_face<FT> middle_on_circle(const Point_in_face<FT>& center, const FT& radius, const Point_in_face<FT>& p,
                                   const Point_in_face<FT>& q)
{
  const Point_in_face<FT> a = p - center, b = q - center;
  // Perpendicular to the chord of a wide arc, where the sum is short.
  const Point_in_face<FT> u = CGAL::is_positive(dot(a, b)) ? a + b : quarter_turn(a - b);
  return center + (radius / length(u)) * u;
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
