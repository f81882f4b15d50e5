// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shortest path to a point of a face through a chord: the interval of a window, or a source segment inside the face.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_RAYS_THROUGH_CHORD_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_RAYS_THROUGH_CHORD_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>

#include <algorithm>

namespace CGAL::Geodesic_offset::internal {

// The rays of a window, in any frame of the face. Point rays start at `image`, at distance sigma. Parallel rays have the
// direction -image, and sigma is the distance at the origin of the frame. The chord has the ends `left` and `right`, seen along
// the rays.
template <class FT>
struct Rays_through_chord
{
  typedef Point_in_face<FT> Point;

  const Point& image;
  bool is_parallel;
  const FT& sigma;
  const Point &left, &right, &to_left, &to_right; // of the directions only those of point images count

  // Direction of the ray through p, not normalized.
  Point direction(const Point& p) const { return is_parallel ? Point{-image.x, -image.y} : p - image; }

  FT distance_at(const Point& p) const { return distance(image, is_parallel, sigma, p); }

  static FT distance(const Point& image, bool is_parallel, const FT& sigma, const Point& p)
  {
    return is_parallel ? FT(sigma - dot(image, p)) : FT(sigma + length(p - image));
  }

  // Cross product of the direction of a bounding ray with the vector from a point of the ray to p. A ray reaches p if the value is
  // at most 0 for the left and at least 0 for the right bounding ray.
  FT left_side(const Point& p) const { return is_parallel ? cross(direction(left), p - left) : cross(to_left, p - image); }
  FT right_side(const Point& p) const { return is_parallel ? cross(direction(right), p - right) : cross(to_right, p - image); }

  // Length of the path to p: straight if a ray reaches p, otherwise around the nearer end of the chord. The length is
  // continuous in p and an upper bound of the distance of p.
  FT path_length(const Point& p, bool& is_straight) const
  {
    const bool off_left = CGAL::is_positive(left_side(p)), off_right = CGAL::is_negative(right_side(p));
    is_straight = !off_left && !off_right;
    if (is_straight)
    {
      const FT d = distance_at(p);
      if (!Number_policy<FT>::is_inexact || !is_parallel ||
          !(d < (std::min)(distance_at(left), distance_at(right)) - rounding_at(p)))
        return d;
      // Rounding lets parallel rays along the chord reach points behind it. The distance grows along rays, so such a point is
      // nearer than both ends.
      is_straight = false;
    }
    const auto by = [&](const Point& end) { return FT(distance_at(end) + length(p - end)); };
    const FT around = off_left == off_right ? (std::min)(by(left), by(right)) : off_left ? by(left) : by(right);
    if (!Number_policy<FT>::is_inexact || !is_at_line_of_chord(p)) return around;
    // A ray that grazes the chord meets it far beside p if rounding has moved p off the chord.
    const Point chord = right - left;
    const FT part = dot(p - left, chord) / dot(chord, chord);
    if (!(part > FT(0) && part < FT(1))) return around;
    const FT through = by(left + part * chord);
    if (!(through < around)) return around;
    is_straight = true;
    return through;
  }

  // True if p lies on the line through the chord, up to rounding.
  bool is_at_line_of_chord(const Point& p) const
  {
    const Point chord = right - left;
    return CGAL::abs(cross(chord, p - left)) <= rounding_at(p) * (CGAL::abs(chord.x) + CGAL::abs(chord.y));
  }

  // Rounding error of p, of the chord, and of the distance of p along parallel rays.
  FT rounding_at(const Point& p) const
  {
    return Number_policy<FT>::rounding(16) * (CGAL::abs(sigma) + CGAL::abs(p.x) + CGAL::abs(p.y) + CGAL::abs(left.x) +
                                              CGAL::abs(left.y) + CGAL::abs(right.x) + CGAL::abs(right.y));
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
