// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shortest way to a point of a face through the part of an edge, or of a source, that a window's rays come through.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_CHORD_PATH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_CHORD_PATH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>

#include <algorithm>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// The rays of a window, in any frame of the face: from `image`, at the distance sigma; parallel ones towards -image, with
// sigma the distance of the frame's origin. The chord reaches from `left` to `right`, seen along the rays.
template <class FT>
struct Rays_through_chord
{
  typedef Point_in_face<FT> Point;

  const Point& image;
  bool is_parallel;
  const FT& sigma;
  const Point &left, &right;

  // Direction of the ray through the point p, not normalised.
  Point direction(const Point& p) const { return is_parallel ? Point{-image.x, -image.y} : p - image; }

  FT distance_at(const Point& p) const { return is_parallel ? FT(sigma - dot(image, p)) : FT(sigma + length(p - image)); }

  // Cross products of a bounding ray's direction and the vector to p: at most 0 for the left and at least 0 for the
  // right ray if a ray reaches p.
  FT left_side(const Point& p) const { return cross(direction(left), p - left); }
  FT right_side(const Point& p) const { return cross(direction(right), p - right); }

  // The length of the way to p: straight if a ray reaches it, else round the nearer end of the chord. An upper bound of the
  // distance of p in any case, and continuous.
  FT path_length(const Point& p, bool& is_straight) const
  {
    const bool off_left = CGAL::is_positive(left_side(p)), off_right = CGAL::is_negative(right_side(p));
    is_straight = !off_left && !off_right;
    if (is_straight)
    {
      const FT d = distance_at(p);
      if (!Number_policy<FT>::is_inexact || !is_parallel || !(d < (std::min)(distance_at(left), distance_at(right)) - rounding_at(p))) return d;
      // Parallel rays that run along the chord, up to rounding, reach points behind it, too. The distance grows along rays, so
      // such a point is nearer than both ends.
      is_straight = false;
    }
    const auto round = [&](const Point& end) { return FT(distance_at(end) + length(p - end)); };
    if (off_left == off_right) return (std::min)(round(left), round(right));
    return off_left ? round(left) : round(right);
  }

  // Rounding of the distance of p by parallel rays.
  FT rounding_at(const Point& p) const
  {
    return Number_policy<FT>::rounding(16) * (CGAL::abs(sigma) + CGAL::abs(p.x) + CGAL::abs(p.y) + CGAL::abs(left.x) +
                                              CGAL::abs(left.y) + CGAL::abs(right.x) + CGAL::abs(right.y));
  }
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
