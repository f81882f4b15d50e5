// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plane geometry of a piece of an offset curve: its left side, separation of points, area, and crossing depth of two
// pieces.

#ifndef GEODESIC_OFFSET_TEST_VALIDATION_VALIDATION_PIECE_H
#define GEODESIC_OFFSET_TEST_VALIDATION_VALIDATION_PIECE_H

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Geodesic_offset::internal {

// An arc of less than a half turn, counterclockwise around `center`, or a segment with unit normal `center` away from the
// smaller distances and distance `radius` from the origin along the normal, in the face frame.
struct Validation_piece
{
  typedef Point_in_face<double> Point;

  Index face;
  std::size_t curve, level; // numbers
  bool is_straight;
  Point center;
  double radius;
  Point start, end;
  Point low, high; // bounding box

  // `p`: a Geodesic_offset_piece
  template <class Piece>
  Validation_piece(const Piece& p, Index f, std::size_t c, std::size_t l)
    : face(f), curve(c), level(l), is_straight(p.is_segment()), start(plain(p.start_2())), end(plain(p.end_2()))
  {
    double reach = 0;
    if (is_straight)
    {
      const auto line = p.supporting_line();
      const double a = CGAL::to_double(line.a()), b = CGAL::to_double(line.b()), norm = std::sqrt(a * a + b * b);
      center = {-a / norm, -b / norm};
      radius = CGAL::to_double(line.c()) / norm;
    }
    else
    {
      center = plain(p.center());
      radius = CGAL::to_double(p.radius());
      // the height of an arc of less than a half turn over a chord c is at most c^2 / (4 r)
      reach = chord() * chord() / (4 * radius);
    }
    low = {(std::min)(start.x, end.x) - reach, (std::min)(start.y, end.y) - reach};
    high = {(std::max)(start.x, end.x) + reach, (std::max)(start.y, end.y) + reach};
  }

  // Distance of a point from the whole circle or line.
  double off(const Point& p) const { return std::abs((is_straight ? dot(center, p) : length(p - center)) - radius); }

  double chord() const { return length(end - start); }

  Point middle() const
  {
    if (is_straight) return 0.5 * (start + end);
    const Point sum = (start - center) + (end - center);
    const double l = length(sum);
    // to the right of the chord if the arc is close to a half turn
    const Point u = l > 0.1 * radius ? (1 / l) * sum : (-1 / chord()) * quarter_turn(end - start);
    return center + radius * u;
  }

  // Unit direction of decreasing distances at a point of the piece.
  Point left_at(const Point& p) const { return is_straight ? -1. * center : (1 / length(center - p)) * (center - p); }

  // Whether the direction of travel agrees with the side of the smaller distances.
  bool runs_forward() const { return cross(end - start, left_at(middle())) > 0; }

  // Whether the segment pq crosses the piece an odd number of times: either it crosses the chord an odd number of times, or
  // exactly one of p and q is between chord and arc. Both conditions share the side tests of the chord, so rounding affects
  // only points near the piece, not those near the chord.
  bool separates(const Point& p, const Point& q) const
  {
    const bool p_left = is_left(start, end, p), q_left = is_left(start, end, q);
    const bool crosses_chord = p_left != q_left && is_left(p, q, start) != is_left(p, q, end);
    return (crosses_chord != is_beside_chord(p, p_left)) != is_beside_chord(q, q_left);
  }

  // By Green's theorem: twice the area swept by the ray from the origin o to the piece.
  double twice_area_from(const Point& o) const
  {
    const double triangle = cross(start - o, end - o);
    if (is_straight) return triangle;
    const double s = angle();
    const double s_minus_sine =
      s < 0.1 ? s * s * s / 6 * (1 - s * s / 20 * (1 - s * s / 42 * (1 - s * s / 72))) : s - std::sin(s);
    return triangle + radius * radius * s_minus_sine;
  }

  double angle() const
  {
    const double half_sine = chord() / (2 * radius);
    if (half_sine < 0.7) return 2 * std::asin(half_sine);
    const double s = std::atan2(cross(start - center, end - center), dot(start - center, end - center));
    return s < 0 ? s + 2 * CGAL_PI : s;
  }

  bool may_meet(const Validation_piece& b) const
  {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y;
  }

  // Lower bound of the extent of two pieces beyond each other on both sides of a crossing; 0 if they do not cross. Because
  // of rounding, circles that touch may cross in two points, but with a depth less than rounding.
  double crossing_depth(const Validation_piece& b) const
  {
    Point p[2];
    const int n = meet(*this, b, p);
    const double apart = n == 2 ? length(p[1] - p[0]) / 2 : std::numeric_limits<double>::infinity();
    double depth = 0;
    for (int i = 0; i < n; ++i)
    {
      if (!reaches(p[i]) || !b.reaches(p[i])) continue;
      const double rest =
        (std::min)({apart, length(p[i] - start), length(p[i] - end), length(p[i] - b.start), length(p[i] - b.end)});
      depth = (std::max)(depth, rest * std::abs(cross(left_at(p[i]), b.left_at(p[i]))) / 2);
    }
    return depth;
  }

private:
  template <class Point_2>
  static Point plain(const Point_2& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
  }

  static bool is_left(const Point& a, const Point& b, const Point& p) { return cross(b - a, p - a) > 0; }

  // Whether p is between chord and arc. A chord as short as rounding has an arbitrary direction, so its side alone does not
  // decide.
  bool is_beside_chord(const Point& p, bool is_left_of_chord) const
  {
    return !is_straight && !is_left_of_chord && length(p - center) < radius && reaches(p);
  }

  // Whether a point is in the sector of the piece; for points of the circle or line, whether it is on the piece.
  bool reaches(const Point& p) const
  {
    if (is_straight) return dot(p - start, end - start) >= 0 && dot(p - end, start - end) >= 0;
    return cross(start - center, p - center) >= 0 && cross(p - center, end - center) >= 0;
  }

  // Intersections of the whole circles or lines.
  static int meet(const Validation_piece& a, const Validation_piece& b, Point p[2])
  {
    if (!a.is_straight && (b.is_straight || b.radius < a.radius)) return meet(b, a, p); // a small circle keeps its digits
    Point foot, across; // the intersections are foot + across, foot - across
    if (a.is_straight && b.is_straight)
    {
      const Point u = a.end - a.start, v = b.end - b.start;
      const double determinant = cross(u, v);
      if (determinant == 0) return 0;
      p[0] = a.start + (cross(b.start - a.start, v) / determinant) * u;
      return 1;
    }
    if (a.is_straight)
    {
      const double height = dot(a.start - b.center, a.center), h2 = (b.radius - height) * (b.radius + height);
      if (!(h2 > 0)) return 0;
      foot = b.center + height * a.center;
      across = std::sqrt(h2) * quarter_turn(a.center);
    }
    else
    {
      const Point u = b.center - a.center;
      const double uu = dot(u, u);
      if (!(uu > 0)) return 0;
      const double apart = std::sqrt(uu), along = 0.5 * (apart + (a.radius - b.radius) * (a.radius + b.radius) / apart);
      const double h2 = (a.radius - along) * (a.radius + along);
      if (!(h2 > 0)) return 0;
      foot = a.center + (along / apart) * u;
      across = (std::sqrt(h2) / apart) * quarter_turn(u);
    }
    p[0] = foot + across;
    p[1] = foot - across;
    return 2;
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif // GEODESIC_OFFSET_TEST_VALIDATION_VALIDATION_PIECE_H
