// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Estimates of numbers, for decisions that may be left open: those that prune, trim or order. An estimate of a floating
// point number is the number itself; an estimate of an exact number is an interval of doubles. Then
//
//   - a window is pruned only where an estimate says so with certainty, CGAL::certainly(a < b); what stays open is kept;
//   - a window is cut where an estimate says, rounded so that it keeps more rays rather than fewer, lower_cut() and
//     upper_cut(). Any set of rays within a window's own will do, so the cut needs no exactness: it is a double;
//   - a bounding box is one of estimates, lower_bound() and upper_bound().

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_INTERVAL_FILTER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_INTERVAL_FILTER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <utility>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Bounds of an exact number that are near to it, without a decision whether it is zero, if the number type can do that.
template <class FT>
inline std::pair<double, double> bounds_of(const FT& x)
{
  return CGAL::to_interval(x);
}

// For the places where windows end. No better than by estimates, if the number type has nothing better.
template <class FT>
inline Uncertain<Comparison_result> compare_bounds(const FT& a, const FT& b)
{
  return CGAL::compare(Interval_nt<>(bounds_of(a)), Interval_nt<>(bounds_of(b)));
}

// For number types whose comparisons are to be taken for true: floating point ones.
template <class FT, bool is_inexact = Number_policy<FT>::is_inexact>
struct Interval_filter
{
  typedef FT Estimate;
  typedef FT Bound;
  static constexpr bool leaves_open = false;

  static const FT& estimate(const FT& x) { return x; }
  static const FT& key(const FT& x) { return x; } // for what is only ordered
  static const FT& lower_cut(const Estimate& t) { return t; }
  static const FT& upper_cut(const Estimate& t) { return t; }
  static const FT& lower_bound(const Estimate& t) { return t; }
  static const FT& upper_bound(const Estimate& t) { return t; }
};

// For exact ones.
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

// The number that is less, for what needs either; if that stays open, the first.
template <class FT>
inline const FT& lesser(const FT& a, const FT& b)
{
  return certainly_less(b, a) ? b : a;
}

// The smallest distance on the interval of a window; where it stays open which one that is, one that is not larger.
template <class FT>
inline FT minimum(const Window<FT>& w)
{
  if (!w.is_parallel() && CGAL::possibly(estimate(w.b0) < estimate(w.x)) &&
      CGAL::possibly(estimate(w.x) < estimate(w.b1)))
    return w.sigma - w.y;
  return lesser(w.d1, w.d0);
}

// The distance function of a window along its halfedge, estimated.
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

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
