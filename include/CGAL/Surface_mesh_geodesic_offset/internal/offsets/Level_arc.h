// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The level of one window inside a face: an arc round the window's image, or, for a parallel-source window, a straight
// segment; traversed with the smaller distances on the left, that is from the window's right ray to its left one.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_ARC_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_ARC_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Window_cone.h>

#include <algorithm>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Level_arc
{
public:
  typedef Point_in_face<FT> Point;

  Level_arc(const Face_window<FT>& w, const Window_cone<FT>& cone, const FT& level)
    : m_window(&w), m_cone(&cone), m_radius(level - w.sigma)
  {
  }

  const Face_window<FT>& window() const { return *m_window; }
  const FT& radius() const { return m_radius; }
  bool is_straight() const { return m_window->is_parallel(); }
  Point image() const { return m_window->image(); }
  Point forward() const { return FT(-1) * m_window->image(); } // direction of a parallel-source window's rays
  const Half_plane<FT>& left() const { return m_cone->left(); }
  const Half_plane<FT>& right() const { return m_cone->right(); }

  // The parameter runs along the chord, or the directions of a wide cone, 0 on the right ray and 1 on the left one.
  Point point(const FT& t) const
  {
    if (m_cone->is_wide()) return image() + m_radius * m_cone->direction(t);
    const Face_window<FT>& w = *m_window;
    const Point c = w.right + t * (w.left - w.right);
    if (is_straight()) return c + (m_radius - dot(forward(), c)) * forward();
    const Point u = c - image();
    return image() + (m_radius / length(u)) * u;
  }

  Point start() const
  {
    if (is_straight()) return point(FT(0));
    return image() + m_radius * m_cone->right_direction();
  }
  Point end() const
  {
    if (is_straight()) return point(FT(1));
    return image() + m_radius * m_cone->left_direction();
  }

  // The bounding box of the part in the face, with a margin.
  Box_in_face<FT> box(const FT& margin) const
  {
    Box_in_face<FT> b(start());
    b.add(end());
    // an arc of less than a half turn rises over its chord c by at most c^2 / (4 r)
    const Point c = end() - start();
    b.widen(is_straight() ? margin : FT(margin + dot(c, c) / (FT(4) * m_radius)));
    b.intersect(m_cone->box());
    return b;
  }

  FT parameter(const Point& p) const
  {
    if (m_cone->is_wide()) return m_cone->parameter(p - image());
    const Face_window<FT>& w = *m_window;
    const Point u = is_straight() ? forward() : p - image();
    const Point o = is_straight() ? p : image();
    const FT r = cross(u, w.right - o), l = cross(u, w.left - o);
    return r / (r - l);
  }

  // For a point of the circle: is it on the side of the cone, or behind the image?
  bool is_ahead(const Point& p) const
  {
    if (is_straight()) return true;
    const Face_window<FT>& w = *m_window;
    return CGAL::is_positive(cross(p - image(), w.left - w.right));
  }

  Point tangent(const Point& p) const
  {
    if (is_straight()) return quarter_turn(forward());
    return (FT(1) / m_radius) * quarter_turn(p - image());
  }

  // How far a point p is from the cone (negative inside).
  FT outside_cone(const Point& p) const
  {
    FT out = (std::max)(left().value(p), right().value(p));
    if (is_straight() && m_window->origin == STARTS_IN_FACE) out = (std::max)(out, FT(-m_window->distance_at(p)));
    return out;
  }

  // Distance given to p, less the level.
  FT excess(const Point& p) const
  {
    if (is_straight()) return dot(forward(), p) - m_radius;
    return length(p - image()) - m_radius;
  }

  // Where the whole circle or line enters, or leaves, a disk.
  bool meet_disk(const Point& center, const FT& radius, bool leave, Point& p) const
  {
    if (is_straight())
    {
      const FT delta = dot(forward(), center) - m_radius;
      const FT h2 = radius * radius - delta * delta;
      if (!CGAL::is_positive(h2)) return false;
      const Point t = quarter_turn(forward());
      p = center - delta * forward() + (leave ? square_root<FT>(h2) : FT(-square_root<FT>(h2))) * t;
      return true;
    }
    const Point u = center - image();
    const FT uu = dot(u, u);
    if (!CGAL::is_positive(uu)) return false;
    // In units of u: a along u, h across. From the centre of the smaller circle: h is small where the circles touch, and
    // would lose its digits otherwise.
    const bool from_disk = radius < m_radius;
    const FT own = from_disk ? radius : m_radius, other = from_disk ? m_radius : radius, d = length(u);
    const FT a = FT(0.5) * ((d - other) * (d + other) + own * own) / uu;
    const FT h2 = own * own / uu - a * a;
    if (!CGAL::is_positive(h2)) return false;
    p = (from_disk ? center - a * u : image() + a * u) +
        (leave ? square_root<FT>(h2) : FT(-square_root<FT>(h2))) * quarter_turn(u);
    return true;
  }

  // Where it enters a half-plane; leaving is entering the opposite one.
  bool enter_half_plane(const Half_plane<FT>& s, Point& p) const
  {
    if (is_straight())
    {
      const Point t = quarter_turn(forward());
      const FT q = dot(s.n, t);
      if (!CGAL::is_negative(q)) return false;
      const Point o = m_radius * forward();
      p = o - (s.value(o) / q) * t;
      return true;
    }
    const FT m = -s.value(image());
    const FT h2 = (m_radius - m) * (m_radius + m);
    if (!CGAL::is_positive(h2)) return false;
    p = image() + m * s.n + square_root<FT>(h2) * quarter_turn(s.n);
    return true;
  }

private:
  const Face_window<FT>* m_window;
  const Window_cone<FT>* m_cone;
  FT m_radius;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
