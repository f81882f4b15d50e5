// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of one circle, counterclockwise: how far one is ahead of another, and the point in the middle.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_CIRCLE_POINTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_CIRCLE_POINTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

namespace CGAL::Geodesic_offset::internal {

// Advance from p to q, two points of an arc of at most a half turn with the given chord, from its start to its end. For near
// points, the value is the length between them, with a sign that is exact up to the rounding of the points; it increases with
// the turn up to twice the radius. The chord decides the sign of turns of more than a quarter: that of a half turn would be
// rounding.
template <class FT>
FT advance_on_circle(const Point_in_face<FT>& center, const FT& radius, const Point_in_face<FT>& chord,
                     const Point_in_face<FT>& p, const Point_in_face<FT>& q)
{
  const Point_in_face<FT> v = p - center;
  const FT advance = cross(v, q - p) / radius;
  if (!CGAL::is_negative(dot(v, q - center))) return advance;
  const FT wide = FT(2) * radius - CGAL::abs(advance);
  return CGAL::is_negative(dot(chord, q - p)) ? FT(-wide) : wide;
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

} // namespace CGAL::Geodesic_offset::internal

#endif
