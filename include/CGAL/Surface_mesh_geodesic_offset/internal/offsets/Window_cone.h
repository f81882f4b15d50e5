// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of a window's geometry that all levels in a face share: half-planes and unit directions of its bounding rays,
// the bounding box of the part of the face that its rays reach, and the largest distance there.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_WINDOW_CONE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_WINDOW_CONE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Box_in_face.h>

#include <algorithm>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

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
  Window_cone(const Face_window<FT>& w, const Face_frame<FT>& frame, const FT& margin)
    : m_box(w.left), m_highest(w.distance_at(w.left))
  {
    const Point l = w.ray_direction(w.left), r = w.ray_direction(w.right);
    m_left_direction = (FT(1) / length(l)) * l;
    m_right_direction = (FT(1) / length(r)) * r;
    const Point nl = quarter_turn(m_left_direction), nr = FT(-1) * quarter_turn(m_right_direction);
    m_left = {nl, dot(nl, w.left)};
    m_right = {nr, dot(nr, w.right)};
    // the face, clipped at the two rays
    Point polygon[5] = {frame.corner(0), frame.corner(1), frame.corner(2), {}, {}}, clipped[5];
    int n = 3;
    for (const Half_plane<FT>* side : {&m_left, &m_right})
    {
      int m = 0;
      for (int i = 0; i < n && m < 5; ++i)
      {
        const Point &p = polygon[i], &q = polygon[i + 1 == n ? 0 : i + 1];
        const FT a = side->value(p), b = side->value(q);
        if (!CGAL::is_positive(a)) clipped[m++] = p;
        if (m < 5 && ((CGAL::is_positive(a) && CGAL::is_negative(b)) || (CGAL::is_negative(a) && CGAL::is_positive(b))))
          clipped[m++] = p + (a / (a - b)) * (q - p);
      }
      std::copy(clipped, clipped + m, polygon);
      n = m;
    }
    const auto add = [&](const Point& p) {
      m_box.add(p);
      m_highest = (std::max)(m_highest, w.distance_at(p));
    };
    add(w.right);
    for (int i = 0; i < n; ++i) add(polygon[i]);
    if (w.origin >= STARTS_IN_FACE && !w.is_parallel()) m_box.add(w.image());
    m_box.widen(margin);
    m_highest += margin;
  }

  // The cone is { left() <= 0, right() <= 0 }.
  const Half_plane<FT>& left() const { return m_left; }
  const Half_plane<FT>& right() const { return m_right; }
  // Unit vectors along the bounding rays.
  const Point& left_direction() const { return m_left_direction; }
  const Point& right_direction() const { return m_right_direction; }
  // Bounds of the part of the face in the cone, and of the distances there.
  const Box_in_face<FT>& box() const { return m_box; }
  const FT& highest() const { return m_highest; }

private:
  Half_plane<FT> m_left, m_right;
  Point m_left_direction, m_right_direction;
  Box_in_face<FT> m_box;
  FT m_highest;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
