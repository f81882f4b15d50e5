// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where in its face a window reaches, and how far: cheap bounds that keep levels in faces with thousands of windows from
// being compared all against all.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOW_EXTENT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOW_EXTENT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Face_field.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
struct Box_in_face
{
  typedef Point_in_face<FT> Point;

  Point low, high;

  explicit Box_in_face(const Point& p) : low(p), high(p) {}

  void add(const Point& p)
  {
    low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y)};
    high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y)};
  }
  void widen(const FT& d)
  {
    low = {low.x - d, low.y - d};
    high = {high.x + d, high.y + d};
  }
  bool contains(const Point& p) const { return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y; }
  bool meets(const Box_in_face& o) const
  {
    return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y;
  }
  void intersect(const Box_in_face& o)
  {
    low = {(std::max)(low.x, o.low.x), (std::max)(low.y, o.low.y)};
    high = {(std::min)(high.x, o.high.x), (std::min)(high.y, o.high.y)};
  }
};

// The bounding box of the part of the face in the window's cone, and the largest distance there, both with a margin.
template <class FT>
struct Window_extent
{
  Box_in_face<FT> box;
  FT highest;
};

template <class FT>
Window_extent<FT> extent_of(const Face_window<FT>& w, const Face_frame<FT>& frame, const FT& margin)
{
  typedef Point_in_face<FT> Point;
  // the triangle, clipped at the two bounding rays
  Point polygon[5] = {frame.corner(0), frame.corner(1), frame.corner(2), {}, {}}, clipped[5];
  int n = 3;
  for (int side = 0; side < 2; ++side)
  {
    const auto outside = [&](const Point& p) { return side == 0 ? w.left_side(p) : FT(-w.right_side(p)); };
    int m = 0;
    for (int i = 0; i < n; ++i)
    {
      const Point &p = polygon[i], &q = polygon[(i + 1) % n];
      const FT a = outside(p), b = outside(q);
      if (!CGAL::is_positive(a)) clipped[m++] = p;
      if (m < 5 && ((CGAL::is_positive(a) && CGAL::is_negative(b)) || (CGAL::is_negative(a) && CGAL::is_positive(b))))
        clipped[m++] = p + (a / (a - b)) * (q - p);
      if (m == 5) break;
    }
    std::copy(clipped, clipped + m, polygon);
    n = m;
  }
  Window_extent<FT> extent{Box_in_face<FT>(w.left), w.distance_at(w.left)};
  const auto add = [&](const Point& p) {
    extent.box.add(p);
    extent.highest = (std::max)(extent.highest, w.distance_at(p));
  };
  add(w.right);
  for (int i = 0; i < n; ++i) add(polygon[i]);
  if (w.origin >= STARTS_IN_FACE && !w.is_parallel()) extent.box.add(w.image());
  extent.box.widen(margin);
  extent.highest += margin;
  return extent;
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
