// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Arcs and segments in a plane: length, points, distance of a point.

#ifndef GEODESIC_OFFSET_TEST_PLANAR_PIECES_H
#define GEODESIC_OFFSET_TEST_PLANAR_PIECES_H

#include "closed_forms.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace test {

inline double cross(const Vector_2& u, const Vector_2& v) { return u.x() * v.y() - u.y() * v.x(); }

inline Vector_2 quarter_turn(const Vector_2& v) { return Vector_2(-v.y(), v.x()); }

inline Vector_2 turned(const Vector_2& v, double angle) { return std::cos(angle) * v + std::sin(angle) * quarter_turn(v); }

/// Segment, or counterclockwise arc around its center by an angle of up to 2 pi.
struct Planar_piece
{
  bool is_arc;
  Point_2 center;       // of an arc
  double radius, angle; // of an arc
  Point_2 start, end;

  static Planar_piece segment(const Point_2& a, const Point_2& b) { return {false, Point_2(0, 0), 0, 0, a, b}; }

  static Planar_piece arc(const Point_2& center, double radius, double angle, const Point_2& start, const Point_2& end)
  {
    return {true, center, radius, angle, start, end};
  }

  double length() const { return is_arc ? radius * angle : distance(start, end); }

  Point_2 at(double t) const
  {
    if (t <= 0) return start;
    if (t >= 1) return end;
    return is_arc ? center + turned(start - center, t * angle) : start + t * (end - start);
  }

  double distance_to(const Point_2& p) const
  {
    if (!is_arc) return segment_distance(p, start, end);
    const Vector_2 v = p - center;
    if (is_in_sector(v)) return std::abs(std::hypot(v.x(), v.y()) - radius);
    return (std::min)(distance(p, start), distance(p, end));
  }

  /// Lower bound of `distance_to`.
  double lower_bound(const Point_2& p) const
  {
    if (is_arc) return std::abs(std::hypot(p.x() - center.x(), p.y() - center.y()) - radius);
    const double x = (std::max)((std::min)(start.x(), end.x()) - p.x(), p.x() - (std::max)(start.x(), end.x()));
    const double y = (std::max)((std::min)(start.y(), end.y()) - p.y(), p.y() - (std::max)(start.y(), end.y()));
    return (std::max)(x, y);
  }

private:
  bool is_in_sector(const Vector_2& v) const
  {
    const Vector_2 first = start - center, last = end - center;
    if (angle <= CGAL_PI) return cross(first, v) >= 0 && cross(v, last) >= 0;
    return !(cross(last, v) > 0 && cross(v, first) > 0);
  }
};

inline double distance_to_pieces(const Point_2& p, const std::vector<Planar_piece>& pieces)
{
  double result = std::numeric_limits<double>::infinity();
  for (const Planar_piece& piece : pieces)
    if (piece.lower_bound(p) < result) result = (std::min)(result, piece.distance_to(p));
  return result;
}

/// Largest distance of `samples` + 1 points on each piece of `from` from the nearest point of `to`.
inline double directed_hausdorff_distance(const std::vector<Planar_piece>& from, const std::vector<Planar_piece>& to,
                                          int samples)
{
  double result = 0;
  for (const Planar_piece& piece : from)
    for (int i = 0; i <= samples; ++i)
      result = (std::max)(result, distance_to_pieces(piece.at(static_cast<double>(i) / samples), to));
  return result;
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_PLANAR_PIECES_H
