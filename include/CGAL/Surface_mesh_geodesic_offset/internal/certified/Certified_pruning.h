// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pruning and trimming of windows by paths via vertices that are certainly shorter.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_PRUNING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_PRUNING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_pruning.h>

#include <boost/config.hpp>

namespace CGAL::Geodesic_offset::internal {

// A window is certainly longer than another path if it is longer by this margin. `farthest`: largest distance in its
// interval; `size`: size of the faces on both sides of its halfedge.
inline double pruning_margin(double radius, double farthest, double size)
{
  return radius + length_error * (farthest + 2 * size);
}

// Certified counterpart of Window_pruning, with upper bounds of vertex distances. `margin`: an upper bound of the margins
// of all windows.
class Certified_pruning
{
public:
  Certified_pruning(double length, double upper_source, double upper_target, double margin)
    : m_length(length), m_margin(margin), m_by_source(upper_source + margin), m_by_target(upper_target + margin)
  {
  }

  void set_far_vertex(double x, double y, double upper)
  {
    m_far_x = x;
    m_far_yy = y * y;
    m_by_far = upper + 2 * m_margin;
  }

  // D(t) - t decreases, so a certain comparison at t also holds before t.
  BOOST_FORCEINLINE bool trim(Certified_window& w) const
  {
    const bool at_source = m_by_source + w.b0 < w.d0, at_target = m_by_target + (m_length - w.b1) < w.d1;
    return (!at_source && !at_target) || cut(w, at_source, at_target);
  }

  BOOST_FORCEINLINE bool is_filtered(double t, double d) const
  {
    const double u = t - m_far_x, r = d - m_by_far;
    return r > 0 && u * u + m_far_yy <= r * r;
  }

private:
  bool cut(Certified_window& w, bool at_source, bool at_target) const
  {
    if (m_by_source + w.b1 < w.d1 || m_by_target + (m_length - w.b0) < w.d0) return false;
    if (at_source)
    {
      const double t = tie_with_end(w, w.x, w.sigma, m_by_source + m_margin), d = w.distance_at(t);
      if (w.b0 < t && t < w.b1 && m_by_source + t < d)
      {
        w.b0 = t;
        w.d0 = d;
      }
    }
    if (at_target)
    {
      const double x = w.is_parallel() ? -w.x : m_length - w.x, at_end = w.is_parallel() ? w.sigma - w.x * m_length : 0.;
      const double t = m_length - tie_with_end(w, x, at_end, m_by_target + m_margin), d = w.distance_at(t);
      if (w.b0 < t && t < w.b1 && m_by_target + (m_length - t) < d)
      {
        w.b1 = t;
        w.d1 = d;
      }
    }
    return true;
  }

  const double m_length, m_margin, m_by_source, m_by_target;
  double m_far_x = 0, m_far_yy = 0, m_by_far = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
