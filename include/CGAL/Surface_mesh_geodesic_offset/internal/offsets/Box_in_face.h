// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounding boxes in the frame of a face. The boxes of exact numbers have bounds of type double, rounded outward, so no exact
// number is compared.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_BOX_IN_FACE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_BOX_IN_FACE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>

#include <algorithm>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
struct Box_in_face
{
  typedef Interval_filter<FT> Estimates;
  typedef typename Estimates::Estimate Estimate;
  typedef Point_in_face<typename Estimates::Bound> Corner;

  Corner low, high;

  explicit Box_in_face(const Point_in_face<FT>& p) : Box_in_face(estimate(p.x), estimate(p.y)) {}
  Box_in_face(const Estimate& x, const Estimate& y)
    : low{Estimates::lower_bound(x), Estimates::lower_bound(y)}, high{Estimates::upper_bound(x), Estimates::upper_bound(y)}
  {
  }

  void add(const Point_in_face<FT>& p) { add(Box_in_face(p)); }
  void add(const Box_in_face& o)
  {
    low = {(std::min)(low.x, o.low.x), (std::min)(low.y, o.low.y)};
    high = {(std::max)(high.x, o.high.x), (std::max)(high.y, o.high.y)};
  }
  void widen(const FT& d)
  {
    const Estimate e = estimate(d);
    low = {Estimates::lower_bound(low.x - e), Estimates::lower_bound(low.y - e)};
    high = {Estimates::upper_bound(high.x + e), Estimates::upper_bound(high.y + e)};
  }
  void intersect(const Box_in_face& o)
  {
    low = {(std::max)(low.x, o.low.x), (std::max)(low.y, o.low.y)};
    high = {(std::min)(high.x, o.high.x), (std::min)(high.y, o.high.y)};
  }
  bool is_empty() const { return high.x < low.x || high.y < low.y; }
  bool meets(const Box_in_face& o) const
  {
    return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y;
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
