// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bundle of rays inside a face, in the face's frame: what a window becomes when it has entered, what starts at a
// source inside the face, and what spreads from a corner.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_FACE_WINDOW_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_FACE_WINDOW_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Chord_path.h>

#include <algorithm>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

enum Face_window_origin : unsigned char
{
  ENTERS_HALFEDGE_0 = 0, // a window of the list of the face's halfedge 0, 1, 2
  ENTERS_HALFEDGE_1 = 1,
  ENTERS_HALFEDGE_2 = 2,
  STARTS_IN_FACE = 3,    // a source primitive in the face
  STARTS_AT_CORNER = 4   // what a source vertex sends into the face, or the function d(v) + |p - v| of another corner
};

// The cone lies between the rays through `left` and `right`, seen along the rays; less than a half turn wide (for
// w = 0: a strip).
template <class FT>
struct Face_window
{
  typedef Point_in_face<FT> Point;

  FT x, y, sigma;
  Point left, right; // the chord
  Root root;
  Index bits; // as in Window
  Face_window_origin origin;
  unsigned char edge; // STARTS_IN_FACE: the halfedge that its chord lies on, 3 if the chord is the source itself;
                      // STARTS_AT_CORNER: the corner

  bool is_parallel() const { return bits & 1u; }
  Index pseudo_source() const { return (bits >> 2) - 1; } // no_index if none
  Point image() const { return {x, y}; }

  // Direction of the ray through the point p, not normalised.
  Point ray_direction(const Point& p) const { return with_rays([&](const auto& rays) { return rays.direction(p); }); }

  // A cone without extent.
  bool is_empty() const { return left.x == right.x && left.y == right.y; }

  FT distance_at(const Point& p) const { return with_rays([&](const auto& rays) { return rays.distance_at(p); }); }

  // See Rays_through_chord.
  FT left_side(const Point& p) const { return with_rays([&](const auto& rays) { return rays.left_side(p); }); }
  FT right_side(const Point& p) const { return with_rays([&](const auto& rays) { return rays.right_side(p); }); }

  // For strips that start inside the face: p is not behind the source, or by the allowance at most.
  bool is_in_front(const Point& p, const FT& allowance = FT(0)) const
  {
    return !starts_in_strip() || distance_at(p) >= -allowance;
  }

  bool contains(const Point& p) const
  {
    return !CGAL::is_positive(left_side(p)) && !CGAL::is_negative(right_side(p)) && is_in_front(p);
  }

  // The same for p up to a distance beyond the bounding rays.
  bool contains(const Point& p, const FT& allowance) const
  {
    return left_side(p) <= allowance * length(ray_direction(left)) &&
           right_side(p) >= -allowance * length(ray_direction(right)) && is_in_front(p, allowance);
  }

  // The length of a path through the window to p: straight if p is in the cone, or if the rays start at a point of the
  // face; else round the nearer end of the chord.
  FT path_length(const Point& p) const
  {
    bool is_straight;
    return path_length(p, is_straight);
  }

  FT path_length(const Point& p, bool& is_straight) const
  {
    if (origin >= STARTS_IN_FACE && !is_parallel())
    {
      is_straight = contains(p);
      return distance_at(p);
    }
    is_straight = false;
    if (starts_in_strip() && distance_at(p) < -rounding_at(p)) return Number_policy<FT>::infinity();
    const FT d = with_rays([&](const auto& rays) { return rays.path_length(p, is_straight); });
    return is_straight ? (std::max)(d, FT(0)) : d;
  }

private:
  bool starts_in_strip() const { return is_parallel() && origin == STARTS_IN_FACE; }

  // A point on the source is in front of it on both sides, whatever rounding does: that of the point, and of the source,
  // which may be much longer and farther from the origin of the frame.
  FT rounding_at(const Point& p) const
  {
    const FT at_chord = (std::max)(CGAL::abs(left.x) + CGAL::abs(left.y), CGAL::abs(right.x) + CGAL::abs(right.y));
    return Number_policy<FT>::rounding(16) * (CGAL::abs(sigma) + CGAL::abs(p.x) + CGAL::abs(p.y) + at_chord);
  }

  template <class Function>
  auto with_rays(const Function& f) const
  {
    const Point p = image();
    return f(Rays_through_chord<FT>{p, is_parallel(), sigma, left, right});
  }
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
