// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filtering theorem in its sound form, and trimming: a window keeps only the points of its interval to which it is
// nearer than the paths through the vertices around.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOW_PRUNING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOW_PRUNING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Estimation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A path by way of a vertex takes rays from a window only if it is shorter beyond doubt. In needle faces all paths to points
// tie up to rounding, and a window that is lost there is not replaced by another one: the vertex may be no pseudo-source.
template <class FT>
inline auto pruning_allowance(const typename Estimation<FT>::Estimate& scale)
{
  typedef typename Estimation<FT>::Estimate Estimate;
  if constexpr (Number_policy<FT>::is_inexact) return Estimate(Number_policy<FT>::rounding(256) * scale);
  else return Estimate(0);
}

// The point at distance t from an end of the halfedge, whose vertex has distance dv, where dv + t equals the window's
// distance; x is the image's coordinate counted from that end. At most one: D(t) - t decreases.
//   W = 1:  (t + k)^2 = (t - x)^2 + y^2  with k = dv - sigma        W = 0:  dv + t = D(0) - x t
template <class FT, class Estimate>
inline Estimate tie_with_end(const Window<FT>& w, const Estimate& x, const Estimate& distance_at_end, const Estimate& dv)
{
  if (w.is_parallel()) return (distance_at_end - dv) / (1 + x);
  const Estimate k = dv - estimate(w.sigma);
  const Estimate y = estimate(w.y);
  return (x * x + y * y - k * k) / (2 * (k + x));
}

// The first two cases of the filtering theorem (Xin and Wang; for parallel-source windows Xin, Ying and He, 4.3), with
// the ends of the halfedge, and the trimming against the same two vertices. False if nothing is left.
template <class FT>
inline bool trim_by_ends(Window<FT>& w, const FT& length, const FT& d_source, const FT& d_target, const FT& min_width)
{
  typedef typename Estimation<FT>::Estimate Estimate;
  const Estimate l = estimate(length), d0 = estimate(w.d0), d1 = estimate(w.d1);
  Estimate b0 = estimate(w.b0), b1 = estimate(w.b1);
  const Estimate allowance = pruning_allowance<FT>(d1 + l), by_source = estimate(d_source) + allowance,
                 by_target = estimate(d_target) + allowance;
  if (CGAL::certainly(by_source + b1 <= d1) || CGAL::certainly(by_target + (l - b0) <= d0)) return false;
  if (CGAL::certainly(by_source + b0 < d0))
  {
    const Estimate t = tie_with_end<FT>(w, estimate(w.x), estimate(w.sigma), by_source);
    if (CGAL::certainly(t >= b1)) return false;
    if (CGAL::certainly(t > b0))
    {
      w.b0 = Estimation<FT>::lower_cut(t);
      w.d0 = w.distance_at(w.b0);
      b0 = t;
    }
  }
  if (CGAL::certainly(by_target + (l - b1) < d1))
  {
    const Estimate x = estimate(w.x), from_target = w.is_parallel() ? Estimate(-x) : Estimate(l - x);
    const Estimate at_target = w.is_parallel() ? Estimate(estimate(w.sigma) - x * l) : Estimate(0);
    const Estimate t = l - tie_with_end<FT>(w, from_target, at_target, by_target);
    if (CGAL::certainly(t <= b0)) return false;
    if (CGAL::certainly(t < b1))
    {
      w.b1 = Estimation<FT>::upper_cut(t);
      w.d1 = w.distance_at(w.b1);
      b1 = t;
    }
  }
  return CGAL::possibly(b1 - b0 > estimate(min_width));
}

// The third case: the far vertex of the entry edge, at (vx, vy), is at least as near to the end (t, 0) of the window,
// at distance d, that is next to the vertex shared by entry and exit.
template <class FT>
inline bool filtered_by_far_vertex(const FT& t, const FT& d, const FT& dv, const FT& vx, const FT& vy)
{
  typedef typename Estimation<FT>::Estimate Estimate;
  const Estimate x = estimate(vx), y = estimate(vy), e = estimate(d);
  const Estimate u = estimate(t) - x, r = e - estimate(dv) - pruning_allowance<FT>(e + CGAL::abs(x));
  return CGAL::certainly(r > 0) && CGAL::certainly(u * u + y * y <= r * r);
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
