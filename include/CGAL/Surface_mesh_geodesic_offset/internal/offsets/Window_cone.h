// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geometry of a window that is common to all levels in a face: half-planes and unit directions of its bounding rays, the
// bounding box of the part of the face in its cone, and the largest distance there.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_WINDOW_CONE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_WINDOW_CONE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Box_in_face.h>

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_offset::internal {

// The half-plane { p : n . p < m }, n a unit vector.
template <class FT>
struct Half_plane
{
  Point_in_face<FT> n;
  FT m;
  FT value(const Point_in_face<FT>& p) const { return dot(n, p) - m; }
  Half_plane opposite() const { return {FT(-1) * n, -m}; }
};

template <class FT>
class Window_cone
{
public:
  typedef Point_in_face<FT> Point;

  // `margin` widens the box and the largest distance.
  Window_cone(const Face_window<FT>& w, const Face_frame<FT>& frame, const FT& margin) : m_box(w.left)
  {
    const Point l = w.left_ray(), r = w.right_ray();
    m_left_direction = (FT(1) / length(l)) * l;
    m_right_direction = (FT(1) / length(r)) * r;
    const Point nl = quarter_turn(m_left_direction), nr = FT(-1) * quarter_turn(m_right_direction);
    m_left = {nl, dot(nl, w.is_parallel() ? w.left : w.image())};
    m_right = {nr, dot(nr, w.is_parallel() ? w.right : w.image())};
    clip_face(w, frame, margin);
    if (w.origin >= STARTS_IN_FACE && !w.is_parallel()) m_box.add(w.image());
    m_box.widen(margin);
    m_highest = Estimates::upper_bound(m_highest + estimate(margin));
  }

  // The cone is { left() <= 0, right() <= 0 }.
  const Half_plane<FT>& left() const { return m_left; }
  const Half_plane<FT>& right() const { return m_right; }
  // Unit vectors along the bounding rays.
  const Point& left_direction() const { return m_left_direction; }
  const Point& right_direction() const { return m_right_direction; }
  // Vector along the bisector of the rays, of length 1 between equal rays and 0 between opposite ones.
  Point middle_direction() const { return FT(0.5) * (m_left_direction + m_right_direction); }
  // Bounding box of the part of the face in the cone, and a test whether distances there reach a level.
  const Box_in_face<FT>& box() const { return m_box; }
  bool reaches(const FT& level) const { return CGAL::possibly(Estimate(m_highest) >= estimate(level)); }

private:
  typedef Interval_filter<FT> Estimates;
  typedef typename Estimates::Estimate Estimate;
  typedef Point_in_face<Estimate> Estimated_point;

  // Adds the part of the face in the cone: its corners in the cone, and the points where a ray crosses its boundary. Points up
  // to the margin outside the cone count.
  void clip_face(const Face_window<FT>& w, const Face_frame<FT>& frame, const FT& margin)
  {
    const Estimate allowance = estimate(margin);
    const auto may_be_in = [&](const Estimate& value) { return CGAL::possibly(value <= allowance); };
    Estimated_point corner[3], points[9]; // at most three corners, and three crossings with each ray
    Estimate value[2][3];                 // per ray and corner
    int n = 0;
    for (int k = 0; k < 3; ++k)
    {
      corner[k] = estimated(frame.corner(k));
      value[0][k] = dot(estimated(m_left.n), corner[k]) - estimate(m_left.m);
      value[1][k] = dot(estimated(m_right.n), corner[k]) - estimate(m_right.m);
      if (may_be_in(value[0][k]) && may_be_in(value[1][k])) points[n++] = corner[k];
    }
    for (int ray = 0; ray < 2; ++ray)
      for (int k = 0; k < 3; ++k)
      {
        if (w.origin == Face_window_origin(k)) continue; // the chord
        const int next = (k + 1) % 3;
        const Estimate &a = value[ray][k], &b = value[ray][next];
        const bool falls = CGAL::certainly(CGAL::is_positive(a)) && CGAL::possibly(CGAL::is_negative(b));
        const bool rises = CGAL::possibly(CGAL::is_negative(a)) && CGAL::certainly(CGAL::is_positive(b));
        if (!falls && !rises) continue;
        const Estimate t = crossing(a, b);
        const Estimate &c = value[1 - ray][k], &d = value[1 - ray][next];
        if (may_be_in(c + t * (d - c))) points[n++] = corner[k] + t * (corner[next] - corner[k]);
      }
    m_box.add(w.right);
    for (int i = 0; i < n; ++i) m_box.add(Box_in_face<FT>(points[i].x, points[i].y));
    m_highest = highest(w, points, n);
  }

  // Zero of a linear function between a and b, which have different signs, as a fraction from 0 to 1.
  static Estimate crossing(const Estimate& a, const Estimate& b)
  {
    const Estimate t = a / (a - b);
    if constexpr (Estimates::leaves_open)
      return Estimate((std::max)(0., t.inf()), (std::min)(1., t.sup())); // also excludes NaN
    else return t;
  }

  // The largest distance at the ends of the chord and at n other points.
  static typename Estimates::Bound highest(const Face_window<FT>& w, const Estimated_point* points, int n)
  {
    const Estimated_point image = estimated(w.image()), left = estimated(w.left), right = estimated(w.right);
    const auto largest = [&](const auto& f) {
      Estimate result = (std::max)(f(left), f(right), is_less);
      for (int i = 0; i < n; ++i) result = (std::max)(result, f(points[i]), is_less);
      return result;
    };
    const auto along_rays = [&](const Estimated_point& p) { return Estimate(-dot(image, p)); };
    const auto squared_way = [&](const Estimated_point& p) {
      return Estimate(CGAL::square(p.x - image.x) + CGAL::square(p.y - image.y));
    };
    const Estimate way = w.is_parallel() ? largest(along_rays) : Estimate(CGAL::sqrt(largest(squared_way)));
    return Estimates::upper_bound(estimate(w.sigma) + way);
  }

  // Compares the upper bounds of estimates.
  static bool is_less(const Estimate& a, const Estimate& b) { return Estimates::upper_bound(a) < Estimates::upper_bound(b); }

  static Estimated_point estimated(const Point& p) { return {estimate(p.x), estimate(p.y)}; }

  Half_plane<FT> m_left, m_right;
  Point m_left_direction, m_right_direction;
  Box_in_face<FT> m_box;
  typename Estimates::Bound m_highest;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
