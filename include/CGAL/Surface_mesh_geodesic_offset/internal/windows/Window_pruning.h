// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filtering theorem in its sound form, and trimming: a window keeps the points of its interval to which it is nearer than
// the paths through nearby vertices.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_PRUNING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_PRUNING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_number_pair.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/window_allowance.h>

#include <boost/config.hpp>

namespace CGAL::Geodesic_offset::internal {

// Tolerance by which a path through a vertex must be shorter to remove rays, so that no window goes by a vertex that only the rays
// of this window reach. `scale`: upper bound of the compared distances and coordinates.
template <class FT>
inline auto pruning_allowance(const typename Interval_filter<FT>::Estimate& scale, const FT& longest_edge)
{
  typedef typename Interval_filter<FT>::Estimate Estimate;
  if constexpr (!Number_policy<FT>::is_inexact) return Estimate(0);
  else return Estimate(Number_policy<FT>::rounding(roundings_of_window) * scale + error_of_image(longest_edge));
}

// The point at distance t from an end of the halfedge, whose vertex has distance dv, where dv + t equals the window's distance;
// x is the image's coordinate relative to that end. There is at most one, since D(t) - t decreases.
//   W = 1:  (t + k)^2 = (t - x)^2 + y^2  with k = dv - sigma        W = 0:  dv + t = D(0) - x t
template <class Window, class Estimate>
inline Estimate tie_with_end(const Window& w, const Estimate& x, const Estimate& distance_at_end, const Estimate& dv)
{
  if (w.is_parallel()) return (distance_at_end - dv) / (1 + x);
  const Estimate k = dv - estimate(w.sigma);
  const Estimate y = estimate(w.y);
  return (x * x + y * y - k * k) / (2 * (k + x));
}

// Removes the parts of windows on a halfedge that nearby vertices dominate.
template <class FT>
class Window_pruning
{
  typedef typename Interval_filter<FT>::Estimate Estimate;

public:
  // The halfedge: its length, and the distances of its source and its target.
  Window_pruning(const FT& length, const FT& d_source, const FT& d_target, const Estimate& allowance)
    : m_length(estimate(length)), m_min_width(estimate(FT(Number_policy<FT>::rounding(8) * length))),
      m_by(estimate(d_source) + allowance, estimate(d_target) + allowance), m_ends(Estimate(0), m_length)
  {
  }

  // Sets the far vertex of the edge through which the windows enter, in the frame of the halfedge.
  void set_far_vertex(const FT& x, const FT& y, const FT& distance, const Estimate& allowance)
  {
    m_far_x = estimate(x);
    m_far_yy = CGAL::square(estimate(y));
    m_by_far = estimate(distance) + allowance;
  }

  // The first two cases of the filtering theorem (Xin and Wang; for parallel-source windows Xin, Ying and He, 4.3), for the
  // ends of the halfedge, and the trimming by the same two vertices. Returns false if nothing remains.
  BOOST_FORCEINLINE bool trim(Window<FT>& w) const
  {
    const bool at_source = CGAL::certainly(by_source() + estimate(w.b0) < estimate(w.d0));
    const bool at_target = CGAL::certainly(by_target() + (m_length - estimate(w.b1)) < estimate(w.d1));
    if (Interval_filter<FT>::leaves_open || at_source || at_target) return cut(w, at_source, at_target);
    return is_wide(w.b0, w.b1) || w.is_open();
  }

  // True if neither vertex removes a part of a window with the ends b and the distances d there, for floating-point numbers.
  BOOST_FORCEINLINE bool leaves_all(const Geodesic_number_pair<FT>& b, const Geodesic_number_pair<FT>& d) const
  {
    return (m_by + (m_ends + b.with_second_negated()) < d).bits() == 0;
  }

  BOOST_FORCEINLINE bool is_wide(const FT& b0, const FT& b1) const
  {
    return CGAL::possibly(estimate(b1) - estimate(b0) > m_min_width);
  }

  // The third case: the far vertex is at least as near to the end (t, 0) of the window, at distance d, that is next to the
  // vertex shared by entry and exit.
  BOOST_FORCEINLINE bool is_filtered(const FT& t, const FT& d) const
  {
    const Estimate r = estimate(d) - m_by_far;
    return bool(int(CGAL::certainly(r > 0)) &
                int(CGAL::certainly(CGAL::square(estimate(t) - m_far_x) + m_far_yy <= r * r))); // one branch for the caller
  }

private:
  BOOST_NOINLINE bool cut(Window<FT>& w, bool at_source, bool at_target) const
  {
    Estimate b0 = estimate(w.b0), b1 = estimate(w.b1);
    if (CGAL::certainly(by_source() + b1 <= estimate(w.d1))) return false;
    if (CGAL::certainly(by_target() + (m_length - b0) <= estimate(w.d0))) return false;
    if (at_source)
    {
      const Estimate t = tie_with_end(w, estimate(w.x), estimate(w.sigma), by_source());
      if (CGAL::certainly(t >= b1)) return false;
      if (CGAL::certainly(t > b0))
      {
        const FT at = Interval_filter<FT>::lower_cut(t), d = w.distance_at(at);
        if (is_cut(d, by_source() + estimate(at)))
        {
          w.set_begin(at, d);
          b0 = t;
        }
      }
    }
    if (at_target)
    {
      const Estimate x = estimate(w.x), from_target = w.is_parallel() ? Estimate(-x) : Estimate(m_length - x);
      const Estimate of_target = w.is_parallel() ? Estimate(estimate(w.sigma) - x * m_length) : Estimate(0);
      const Estimate t = m_length - tie_with_end(w, from_target, of_target, by_target());
      if (CGAL::certainly(t <= b0)) return false;
      if (CGAL::certainly(t < b1))
      {
        const FT at = Interval_filter<FT>::upper_cut(t), d = w.distance_at(at);
        if (is_cut(d, by_target() + (m_length - estimate(at))))
        {
          w.set_end(at, d);
          b1 = t;
        }
      }
    }
    return CGAL::possibly(b1 - b0 > m_min_width) || w.is_open();
  }

  // True if a vertex is as near as a window at a tie, which is ill-conditioned for rays that graze the halfedge. Otherwise the window
  // stays whole.
  static bool is_cut(const FT& distance, const Estimate& by_vertex)
  {
    if constexpr (!Number_policy<FT>::is_inexact) return true;
    else return distance >= by_vertex - Number_policy<FT>::rounding(8) * by_vertex;
  }

  Estimate by_source() const { return m_by.first(); }
  Estimate by_target() const { return m_by.second(); }

  Estimate m_length, m_min_width;
  Geodesic_number_pair<Estimate> m_by, m_ends; // of source and target: the path through it, and its position
  Estimate m_far_x, m_far_yy, m_by_far;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
