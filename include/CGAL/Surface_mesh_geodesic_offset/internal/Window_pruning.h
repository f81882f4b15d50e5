// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filtering theorem in its sound form, and trimming: a window keeps only the points of its interval to which it is
// nearer than the paths through the vertices around.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOW_PRUNING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOW_PRUNING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Window.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A path by way of a vertex takes rays from a window only if it is shorter beyond doubt. In needle faces all paths to a point
// tie up to rounding, and a window that is lost there is not replaced by another one: the vertex may be no pseudo-source.
template <class FT>
inline FT pruning_allowance(const FT& scale)
{
  return Number_policy<FT>::rounding(256) * scale;
}

// The point at distance t from an end of the halfedge, whose vertex has distance dv, where dv + t equals the window's
// distance; x is the image's coordinate counted from that end. At most one: D(t) - t decreases.
//   W = 1:  (t + k)^2 = (t - x)^2 + y^2  with k = dv - sigma        W = 0:  dv + t = D(0) - x t
template <class FT>
inline FT tie_with_end(const Window<FT>& w, const FT& x, const FT& distance_at_end, const FT& dv)
{
  if (w.is_parallel()) return (distance_at_end - dv) / (1 + x);
  const FT k = dv - w.sigma;
  return (x * x + w.y * w.y - k * k) / (2 * (k + x));
}

// The first two cases of the filtering theorem (Xin and Wang; for parallel-source windows Xin, Ying and He, 4.3), with
// the ends of the halfedge, and the trimming against the same two vertices. False if nothing is left.
template <class FT>
inline bool trim_by_ends(Window<FT>& w, const FT& length, const FT& d_source, const FT& d_target, const FT& min_width)
{
  const FT allowance = pruning_allowance<FT>(w.d1 + length), by_source = d_source + allowance, by_target = d_target + allowance;
  if (by_source + w.b1 <= w.d1 || by_target + (length - w.b0) <= w.d0) return false;
  if (by_source + w.b0 < w.d0)
  {
    const FT t = tie_with_end<FT>(w, w.x, w.sigma, by_source);
    if (t >= w.b1) return false;
    if (t > w.b0)
    {
      w.b0 = t;
      w.d0 = w.distance_at(t);
    }
  }
  if (by_target + (length - w.b1) < w.d1)
  {
    const FT x = w.is_parallel() ? FT(-w.x) : FT(length - w.x);
    const FT t = length - tie_with_end<FT>(w, x, w.is_parallel() ? FT(w.sigma - w.x * length) : FT(0), by_target);
    if (t <= w.b0) return false;
    if (t < w.b1)
    {
      w.b1 = t;
      w.d1 = w.distance_at(t);
    }
  }
  return w.b1 - w.b0 > min_width;
}

// The third case: the far vertex of the entry edge, at (vx, vy), is at least as near to the end (t, 0) of the window,
// at distance d, that is next to the vertex shared by entry and exit.
template <class FT>
inline bool filtered_by_far_vertex(const FT& t, const FT& d, const FT& dv, const FT& vx, const FT& vy)
{
  const FT u = t - vx, r = d - dv - pruning_allowance<FT>(d + CGAL::abs(vx));
  return CGAL::is_positive(r) && u * u + vy * vy <= r * r;
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
