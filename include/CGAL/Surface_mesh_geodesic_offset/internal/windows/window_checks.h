// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Predicates on lists of windows, for assertions.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_CHECKS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_CHECKS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>

#include <CGAL/number_utils.h>

namespace CGAL::Geodesic_offset::internal {

// True if a window has an interval, and no distance at its ends is negative by more than rounding. Rays may be narrower than
// rounding. `length`: of the halfedge.
template <class FT>
inline bool has_interval(const Window<FT>& w, const FT& length)
{
  FT least(0); // smallest distance
  if constexpr (Number_policy<FT>::is_inexact)
    least = -Number_policy<FT>::rounding(64) * (length + CGAL::abs(w.x) + CGAL::abs(w.y) + CGAL::abs(w.sigma));
  return CGAL::possibly(estimate(w.b0) <= estimate(w.b1)) && CGAL::possibly(estimate(w.d0) >= estimate(least)) &&
         CGAL::possibly(estimate(w.d1) >= estimate(least));
}

// True if windows are ordered by their intervals and disjoint, on a halfedge of the given length. Exact windows may overlap
// where either may be nearer; they are ordered by estimates of their begin.
template <class FT>
inline bool are_in_order(const Window<FT>* first, const Window<FT>* last, const FT& length)
{
  for (const Window<FT>* w = first; w != last; ++w)
  {
    if (!has_interval(*w, length) || CGAL::certainly(estimate(w->b0) < 0) ||
        CGAL::certainly(estimate(w->b1) > estimate(length)))
      return false;
    if (w == first) continue;
    if (Interval_filter<FT>::leaves_open ? CGAL::certainly(estimate(w->b0) < estimate(w[-1].b0))
                                         : CGAL::certainly(estimate(w->b0) < estimate(w[-1].b1)))
      return false;
  }
  return true;
}

// True if the distances at the ends of a window are those of its image, up to the rounding over many faces, as each window
// inherits them. Always true for merged windows, whose distances take precedence, and for exact numbers.
template <class FT>
inline bool has_consistent_distances(const Window<FT>& w)
{
  if constexpr (!Number_policy<FT>::is_inexact) return true;
  else
  {
    if (w.is_merged()) return true;
    const FT size = w.d0 + w.d1 + w.b1 + CGAL::abs(w.x) + CGAL::abs(w.y) + CGAL::abs(w.sigma);
    const FT allowance = Number_policy<FT>::rounding(1 << 20) * size;
    return CGAL::abs(FT(w.distance_at(w.b0) - w.d0)) <= allowance && CGAL::abs(FT(w.distance_at(w.b1) - w.d1)) <= allowance;
  }
}

template <class FT>
inline bool have_consistent_distances(const Window<FT>* first, const Window<FT>* last)
{
  for (; first != last; ++first)
    if (!has_consistent_distances(*first)) return false;
  return true;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
