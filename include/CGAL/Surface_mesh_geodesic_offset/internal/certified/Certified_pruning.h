// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What paths by way of vertices take from a window, where they are certainly shorter.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_PRUNING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_PRUNING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_window.h>

#include <algorithm>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// How much longer than another path the window must be to be certainly longer than it is said to be at most.
inline double pruning_margin(const Certified_window& w, double length)
{
  return w.radius + length_error * ((std::max)(w.d0, w.d1) + 2 * length);
}

// As `tie_with_end`: where D(t) = dv + t, x counted from that end.
inline double tie_with_end(const Certified_window& w, double x, double distance_at_end, double dv)
{
  if (w.is_parallel()) return (distance_at_end - dv) / (1 + x);
  const double k = dv - w.sigma;
  return (x * x + w.y * w.y - k * k) / (2 * (k + x));
}

// As `trim_by_ends`, with upper bounds of the distances of both ends. D(t) - t decreases: what is certain at t is so before.
inline bool trim_by_ends(Certified_window& w, double length, double upper_source, double upper_target)
{
  const double margin = pruning_margin(w, length), source = upper_source + margin, target = upper_target + margin;
  if (source + w.b1 < w.d1 || target + (length - w.b0) < w.d0) return false;
  if (source + w.b0 < w.d0)
  {
    const double t = tie_with_end(w, w.x, w.sigma, source + margin), d = w.distance_at(t);
    if (w.b0 < t && t < w.b1 && source + t < d)
    {
      w.b0 = t;
      w.d0 = d;
    }
  }
  if (target + (length - w.b1) < w.d1)
  {
    const double x = w.is_parallel() ? -w.x : length - w.x;
    const double at_end = w.is_parallel() ? w.sigma - w.x * length : 0.;
    const double t = length - tie_with_end(w, x, at_end, target + margin), d = w.distance_at(t);
    if (w.b0 < t && t < w.b1 && target + (length - t) < d)
    {
      w.b1 = t;
      w.d1 = d;
    }
  }
  return true;
}

// As `filtered_by_far_vertex`.
inline bool filtered_by_far_vertex(const Certified_window& w, double t, double d, double upper, double vx, double vy,
                                   double length)
{
  const double u = t - vx, r = d - upper - 2 * pruning_margin(w, length);
  return r > 0 && u * u + vy * vy <= r * r;
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
