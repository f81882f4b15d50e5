// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Estimates of numbers, for decisions that may stay open: pruning, trimming, ordering. The estimate of a floating-point number
// is the number itself; the estimate of an exact number is an interval of doubles.
//
//   - A window is pruned only where estimates are certain, CGAL::certainly(a < b). Otherwise it is kept.
//   - A window is cut at an estimate rounded so that more rays stay, lower_cut() and upper_cut(). Any subset of its rays is a
//     valid window, so the cut is a double.
//   - Bounding boxes consist of estimates, lower_bound() and upper_bound().

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_INTERVAL_FILTER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_INTERVAL_FILTER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <utility>

namespace CGAL::Geodesic_offset::internal {

// Close bounds of an exact number, without a decision about its sign if the number type supports that.
template <class FT>
inline std::pair<double, double> bounds_of(const FT& x)
{
  return CGAL::to_interval(x);
}

// Comparison of ends of windows; that of estimates if the number type has no better one.
template <class FT>
inline Uncertain<Comparison_result> compare_bounds(const FT& a, const FT& b)
{
  return CGAL::compare(Interval_nt<>(bounds_of(a)), Interval_nt<>(bounds_of(b)));
}

// For floating-point numbers, whose comparisons count as true.
template <class FT, bool is_inexact = Number_policy<FT>::is_inexact>
struct Interval_filter
{
  typedef FT Estimate;
  typedef FT Bound;
  static constexpr bool leaves_open = false;

  static const FT& estimate(const FT& x) { return x; }
  static const FT& key(const FT& x) { return x; } // for ordering only
  static const FT& lower_cut(const Estimate& t) { return t; }
  static const FT& upper_cut(const Estimate& t) { return t; }
  static const FT& lower_bound(const Estimate& t) { return t; }
  static const FT& upper_bound(const Estimate& t) { return t; }
};

// For exact numbers.
template <class FT>
struct Interval_filter<FT, false>
{
  typedef Interval_nt<> Estimate;
  typedef double Bound;
  static constexpr bool leaves_open = true;

  static Estimate estimate(const FT& x) { return Estimate(bounds_of(x)); }
  static double key(const FT& x) { return bounds_of(x).first; }
  static FT lower_cut(const Estimate& t) { return FT(t.inf()); }
  static FT upper_cut(const Estimate& t) { return FT(t.sup()); }
  static Bound lower_bound(const Estimate& t) { return t.inf(); }
  static Bound upper_bound(const Estimate& t) { return t.sup(); }
};

template <class FT>
inline decltype(auto) estimate(const FT& x)
{
  return Interval_filter<FT>::estimate(x);
}

template <class FT>
inline bool certainly_less(const FT& a, const FT& b)
{
  return CGAL::certainly(estimate(a) < estimate(b));
}

// Smaller of two estimates; the first if undecided.
template <class FT>
inline const FT& lesser(const FT& a, const FT& b)
{
  return certainly_less(b, a) ? b : a;
}

// Smallest distance on the interval [b0, b1] of a window: `at_foot` if the foot x of its image is inside; a lower bound if
// undecided. The choice is a load for floating-point numbers, as a branch would be unpredictable.
template <class FT>
inline FT minimum(bool is_parallel, const FT& b0, const FT& b1, const FT& x, const FT& at_foot, const FT& d0, const FT& d1)
{
  const bool is_inside =
    int(!is_parallel) & int(CGAL::possibly(estimate(b0) < estimate(x))) & int(CGAL::possibly(estimate(x) < estimate(b1)));
  if constexpr (!Number_policy<FT>::is_inexact) return is_inside ? at_foot : lesser(d1, d0);
  const FT candidates[2] = {lesser(d1, d0), at_foot};
  return candidates[is_inside];
}

template <class FT>
inline FT minimum(const Window<FT>& w)
{
  return minimum(w.is_parallel(), w.b0, w.b1, w.x, FT(w.sigma - w.y), w.d0, w.d1);
}

// Estimated distance function of a window along its halfedge.
template <class FT>
struct Estimated_distance
{
  typedef typename Interval_filter<FT>::Estimate Estimate;

  explicit Estimated_distance(const Window<FT>& w)
    : x(estimate(w.x)), y(estimate(w.y)), sigma(estimate(w.sigma)), is_parallel(w.is_parallel())
  {
  }

  Estimate operator()(const Estimate& t) const
  {
    if (is_parallel) return sigma - x * t;
    return sigma + CGAL::sqrt(CGAL::square(t - x) + CGAL::square(y));
  }

  Estimate x, y, sigma;
  bool is_parallel;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
