// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The level of one window in the plane of a face: an arc about the window's image or, for a parallel-source window, a straight
// segment. It runs from the window's right ray to its left ray, with the smaller distances on the left, and turns by less than
// a half turn.
//
// Side tests of their directions from the image order the points of an arc, without a parameter.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_ARC_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_ARC_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/circle_points.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Window_cone.h>

#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Level_arc
{
public:
  typedef Point_in_face<FT> Point;

  Level_arc(const Face_window<FT>& w, const Window_cone<FT>& cone, const FT& level)
    : m_window(&w), m_cone(&cone), m_radius(level - w.sigma)
  {
    CGAL_precondition(is_straight() || CGAL::is_positive(m_radius));
    if (is_straight())
    {
      m_start = foot(w.right);
      m_end = foot(w.left);
    }
    else
    {
      m_start = image() + m_radius * cone.right_direction();
      m_end = image() + m_radius * cone.left_direction();
    }
  }

  const Face_window<FT>& window() const { return *m_window; }
  const FT& radius() const { return m_radius; }
  bool is_straight() const { return m_window->is_parallel(); }
  Point image() const { return m_window->image(); }
  Point forward() const { return FT(-1) * m_window->image(); } // direction of a parallel-source window's rays
  const Half_plane<FT>& left() const { return m_cone->left(); }
  const Half_plane<FT>& right() const { return m_cone->right(); }
  const Point& start() const { return m_start; } // on the right ray
  const Point& end() const { return m_end; }     // on the left ray

  // Bounding box of the part in the face, with a margin.
  Box_in_face<FT> box(const FT& margin) const
  {
    Box_in_face<FT> b(m_start);
    b.add(m_end);
    b.widen(FT(margin + rise(m_start, m_end)));
    b.intersect(m_cone->box());
    return b;
  }

  // Upper bound of the rise of the part from p to q over its chord. On an arc of less than a half turn, a chord c has a rise of
  // at most c^2 / (4 r).
  FT rise(const Point& p, const Point& q) const
  {
    if (is_straight()) return FT(0);
    const Point c = q - p;
    return dot(c, c) / (FT(4) * m_radius);
  }

  Point tangent(const Point& p) const
  {
    if (is_straight()) return quarter_turn(forward());
    return (FT(1) / m_radius) * quarter_turn(p - image());
  }

  // Advance from p to q, two points of the arc (advance_on_circle).
  FT advance(const Point& p, const Point& q) const
  {
    if (is_straight()) return dot(quarter_turn(forward()), q - p);
    return advance_on_circle(image(), m_radius, m_end - m_start, p, q);
  }

  // True if q is between p and r, which are less than a half turn apart, and not behind the image.
  bool is_between(const Point& p, const Point& q, const Point& r) const
  {
    if (is_straight())
    {
      const Point t = quarter_turn(forward());
      return CGAL::is_positive(dot(t, q - p)) && CGAL::is_positive(dot(t, r - q));
    }
    const Point u = q - image();
    return CGAL::is_positive(cross(p - image(), u)) && CGAL::is_positive(cross(u, r - image()));
  }

  // Middle of the arc between two of its points.
  Point middle(const Point& p, const Point& q) const
  {
    if (is_straight()) return foot(FT(0.5) * (p + q));
    return middle_on_circle(image(), m_radius, p, q);
  }

  // Distance of p from the cone (negative inside).
  FT outside_cone(const Point& p) const
  {
    FT out = (std::max)(left().value(p), right().value(p));
    // A point behind the image of a narrow cone may be near the lines of both rays.
    if (starts_at_point_of_face()) out = (std::max)(out, FT(-dot(m_cone->middle_direction(), p - image())));
    if (starts_in_strip()) out = (std::max)(out, FT(m_window->start_value - m_window->distance_at(p)));
    return out;
  }

  bool starts_at_point_of_face() const { return !is_straight() && m_window->origin >= STARTS_IN_FACE; }

  bool is_in_cone(const Point& p) const
  {
    return CGAL::is_negative(left().value(p)) && CGAL::is_negative(right().value(p)) &&
           (!starts_in_strip() || !CGAL::is_negative(FT(m_window->distance_at(p) - m_window->start_value)));
  }

  // Distance of p through this window minus the level.
  FT excess(const Point& p) const
  {
    if (is_straight()) return dot(forward(), p) - m_radius;
    return length(p - image()) - m_radius;
  }

  // Points where the whole circle or line enters and leaves the region nearer than another arc's level minus a depth. Returns
  // false if it does not cross the boundary of the region.
  bool meet(const Level_arc& b, const FT& depth, Point& enter, Point& leave) const
  {
    if (b.is_straight()) return meet({b.forward(), FT(b.m_radius - depth)}, enter, leave);
    return meet_disk(b.image(), FT(b.m_radius - depth), enter, leave);
  }

  // Overload for a half-plane. The boundary has one point in common with a line, which is returned twice.
  bool meet(const Half_plane<FT>& s, Point& enter, Point& leave) const
  {
    if (is_straight())
    {
      const Point t = quarter_turn(forward());
      const FT q = dot(s.n, t);
      if (CGAL::is_zero(q)) return false;
      const Point o = m_radius * forward();
      enter = leave = o - (s.value(o) / q) * t;
      return true;
    }
    const FT m = -s.value(image());
    const FT h2 = (m_radius - m) * (m_radius + m);
    if (!CGAL::is_positive(h2)) return false;
    const Point foot = image() + m * s.n, half = square_root<FT>(h2) * quarter_turn(s.n);
    enter = foot + half;
    leave = foot - half;
    return true;
  }

  // Range of the signed distances of the part from p to q from a half-plane (positive outside).
  struct Range
  {
    FT least, largest;
  };

  Range values(const Half_plane<FT>& s, const Point& p, const Point& q) const
  {
    const FT at_p = s.value(p), at_q = s.value(q);
    Range range{(std::min)(at_p, at_q), (std::max)(at_p, at_q)};
    if (is_straight()) return range;
    // The nearest or farthest point of the circle, if it is on the part.
    const FT from_p = cross(p - image(), s.n), to_q = cross(s.n, q - image());
    if (CGAL::is_positive(from_p) && CGAL::is_positive(to_q))
      range.largest = (std::max)(range.largest, FT(s.value(image()) + m_radius));
    else if (CGAL::is_negative(from_p) && CGAL::is_negative(to_q))
      range.least = (std::min)(range.least, FT(s.value(image()) - m_radius));
    return range;
  }

private:
  bool starts_in_strip() const { return is_straight() && m_window->origin == STARTS_IN_FACE; }

  // Nearest point of the line of a straight segment.
  Point foot(const Point& p) const { return p + (m_radius - dot(forward(), p)) * forward(); }

  bool meet_disk(const Point& center, const FT& radius, Point& enter, Point& leave) const
  {
    if (!CGAL::is_positive(radius)) return false;
    if (is_straight())
    {
      const FT delta = dot(forward(), center) - m_radius;
      const FT h2 = (radius - delta) * (radius + delta);
      if (!CGAL::is_positive(h2)) return false;
      const Point half = square_root<FT>(h2) * quarter_turn(forward()), middle = center - delta * forward();
      enter = middle - half;
      leave = middle + half;
      return true;
    }
    const Point u = center - image();
    const FT uu = dot(u, u), sum = m_radius + radius, difference = m_radius - radius;
    // Heron's formula: 16 times the squared area of the triangle of both images and a common point.
    const FT area2 = (sum * sum - uu) * (uu - difference * difference);
    if (!CGAL::is_positive(area2)) return false;
    // From the centre of the smaller circle: small terms keep their digits where the circles touch.
    const bool from_disk = radius < m_radius;
    const FT along = (uu - CGAL::abs(difference) * sum) / (FT(2) * uu);
    const Point half = (square_root<FT>(area2) / (FT(2) * uu)) * quarter_turn(u);
    const Point foot = from_disk ? center - along * u : image() + along * u;
    enter = foot - half;
    leave = foot + half;
    return true;
  }

  const Face_window<FT>* m_window;
  const Window_cone<FT>* m_cone;
  FT m_radius;
  Point m_start, m_end;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
