// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bundle of rays inside a face, in the frame of the face. It is a window that has entered the face, a source inside the face,
// or the rays from a corner.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_FACE_WINDOW_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_FACE_WINDOW_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Rays_through_chord.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

#include <algorithm>

namespace CGAL::Geodesic_offset::internal {

enum Face_window_origin : unsigned char {
  ENTERS_HALFEDGE_0 = 0, // window of halfedge 0, 1, 2 of the face
  ENTERS_HALFEDGE_1 = 1,
  ENTERS_HALFEDGE_2 = 2,
  STARTS_IN_FACE = 3,  // source primitive in the face
  STARTS_AT_CORNER = 4 // rays of a source vertex, or the function d(v) + |p - v| of another corner
};

// The cone lies between the bounding rays through `left` and `right`, seen along the rays, and is narrower than a half turn.
// Parallel rays have a strip instead.
template <class FT>
struct Face_window
{
  typedef Point_in_face<FT> Point;

  FT x, y, sigma;
  Point left, right; // the chord
  Source_ref source_ref;
  Index bits; // as in Window
  Face_window_origin origin;
  unsigned char edge;     // STARTS_IN_FACE: halfedge of the chord, 3 if the chord is the source;
                          // STARTS_AT_CORNER: the corner
  FT start_value = FT(0); // distance at the source, of windows of sources in the face
  // Directions of the bounding rays through `right` and `left` from a point image; zero if they are those of the chord.
  Point from{FT(0), FT(0)}, to{FT(0), FT(0)};

  bool is_parallel() const { return bits & 1u; }
  Index pseudo_source() const { return (bits >> 2) - 1; } // no_index if none
  Point image() const { return {x, y}; }

  // Direction of the ray through p, not normalized.
  Point ray_direction(const Point& p) const { return is_parallel() ? Point{-x, -y} : p - image(); }

  // Directions of the bounding rays.
  Point left_ray() const { return has_direction(to) ? to : ray_direction(left); }
  Point right_ray() const { return has_direction(from) ? from : ray_direction(right); }

  // True for a cone without extent. The chord of an open cone may have none, next to the image.
  bool is_empty() const { return left.x == right.x && left.y == right.y && !CGAL::is_positive(cross(right_ray(), left_ray())); }

  FT distance_at(const Point& p) const { return Rays_through_chord<FT>::distance(image(), is_parallel(), sigma, p); }

  // See Rays_through_chord.
  FT left_side(const Point& p) const
  {
    return with_rays([&](const auto& rays) { return rays.left_side(p); });
  }
  FT right_side(const Point& p) const
  {
    return with_rays([&](const auto& rays) { return rays.right_side(p); });
  }

  // False if p lies behind the source of a strip by more than the allowance.
  bool is_in_front(const Point& p, const FT& allowance = FT(0)) const
  {
    return !starts_in_strip() || distance_at(p) - start_value >= -allowance;
  }

  bool contains(const Point& p) const
  {
    return !CGAL::is_positive(left_side(p)) && !CGAL::is_negative(right_side(p)) && is_in_front(p);
  }

  // Overload for points up to `allowance` outside the bounding rays.
  bool contains(const Point& p, const FT& allowance) const
  {
    return left_side(p) <= allowance * length(left_ray()) && right_side(p) >= -allowance * length(right_ray()) &&
           is_in_front(p, allowance);
  }

  // Length of a path through the window to p: straight if p lies in the cone or the rays start at a point of the face,
  // otherwise around the nearer end of the chord.
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
    if (starts_in_strip() && distance_at(p) - start_value < -rounding_at(p)) return Number_policy<FT>::infinity();
    const FT d = with_rays([&](const auto& rays) { return rays.path_length(p, is_straight); });
    return is_straight ? (std::max)(d, start_value) : d;
  }

  // End of the chord around which the shorter path to p leads.
  const Point& end_around(const Point& p) const
  {
    return distance_at(left) + length(p - left) <= distance_at(right) + length(p - right) ? left : right;
  }

private:
  static bool has_direction(const Point& u) { return !CGAL::is_zero(u.x) || !CGAL::is_zero(u.y); }

  bool starts_in_strip() const { return is_parallel() && origin == STARTS_IN_FACE; }

  // Rounding error of p and of the source, which may be longer and farther from the origin of the frame than p. A point on the
  // source counts as in front of it on both sides.
  FT rounding_at(const Point& p) const
  {
    const FT at_chord = (std::max)(CGAL::abs(left.x) + CGAL::abs(left.y), CGAL::abs(right.x) + CGAL::abs(right.y));
    return Number_policy<FT>::rounding(16) * (CGAL::abs(sigma) + CGAL::abs(p.x) + CGAL::abs(p.y) + at_chord);
  }

  template <class Function>
  auto with_rays(const Function& f) const
  {
    const Point p = image(), to_left = left_ray(), to_right = right_ray();
    return f(Rays_through_chord<FT>{p, is_parallel(), sigma, left, right, to_left, to_right});
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
