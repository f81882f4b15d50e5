// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of the overlap of two windows on a halfedge where one is certainly farther than the other.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_OVERLAP_SPLIT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_OVERLAP_SPLIT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_bisector.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_offset::internal {

// Few disjoint intervals in order.
class Interval_set
{
public:
  struct Interval
  {
    double from, to;
  };

  int size() const { return m_size; }
  const Interval& operator[](int i) const { return m_intervals[i]; }

  // Precondition: the interval begins at or after the end of the last one.
  void append(const Interval& i)
  {
    if (m_size > 0 && i.from <= m_intervals[m_size - 1].to) m_intervals[m_size - 1].to = i.to;
    else m_intervals[m_size++] = i;
  }
  void append_all(const Interval_set& o)
  {
    for (int i = 0; i < o.m_size; ++i) append(o.m_intervals[i]);
  }

private:
  Interval m_intervals[4];
  int m_size = 0;
};

// Two windows a and b on the overlap [low, high] of their intervals; b begins within a.
//
// The difference of the two distances has at most one stationary point. So a window that is certainly farther at two points
// is farther everywhere between them unless a minimum of the difference lies there. No minimum exists if the difference
// does not decrease at the first point or does not increase at the second.
class Certified_overlap_split
{
public:
  typedef Certified_window Window;

  Certified_overlap_split(const Window& a, const Window& b, double length)
    : m_a(a), m_b(b), m_bisector(a, b, length), m_low(b.b0), m_high((std::min)(a.b1, b.b1)), m_margin(m_bisector.margin())
  {
    m_at_low = m_bisector.difference(m_low);
    m_at_high = m_bisector.difference(m_high);
    m_has_middle = m_bisector.stationary_point(m_middle) && m_low < m_middle && m_middle < m_high;
    if (m_has_middle) m_at_middle = m_bisector.difference(m_middle);
  }

  double low() const { return m_low; }
  double high() const { return m_high; }

  // True if neither window is certainly farther anywhere.
  bool is_tie() const
  {
    return std::abs(m_at_low) <= m_margin && std::abs(m_at_high) <= m_margin &&
           (!m_has_middle || std::abs(m_at_middle) <= m_margin);
  }

  // Parts of the overlap where a, or b, is not certainly farther than the other window.
  Interval_set kept_of_first() const { return kept(1); }
  Interval_set kept_of_second() const { return kept(-1); }

private:
  // `of` = 1: for a; `of` = -1: for b.
  Interval_set kept(int of) const
  {
    const auto excess = [&](double g) { return of * g - m_margin; };
    Interval_set result;
    const double low = excess(m_at_low), high = excess(m_at_high);
    if (low > 0 && high > 0)
    {
      if (is_farther_between(of, m_low, m_high)) return result;
      if (m_has_middle)
      {
        const double middle = excess(m_at_middle);
        if (middle > 0)
        { // a minimum above the margin: distances are 1-Lipschitz
          const double from = (std::max)(m_low, m_middle - middle / 4), to = (std::min)(m_high, m_middle + middle / 4);
          if (is_farther_between(of, m_low, from) && is_farther_between(of, to, m_high)) return result;
        }
        else
        {
          double from = last_farther(of, m_low, low, m_middle, middle);
          double to = last_farther(of, m_high, high, m_middle, middle);
          if (!is_farther_between(of, m_low, from)) from = m_low;
          if (!is_farther_between(of, to, m_high)) to = m_high;
          result.append({from, to});
          return result;
        }
      }
      result.append({m_low, m_high});
      return result;
    }
    if (low > 0 || high > 0)
    {
      const double good = low > 0 ? m_low : m_high, bad = low > 0 ? m_high : m_low;
      const double t = last_farther(of, good, low > 0 ? low : high, bad, low > 0 ? high : low);
      const bool is_cut = is_farther_between(of, (std::min)(good, t), (std::max)(good, t));
      if (!is_cut) result.append({m_low, m_high});
      else result.append(low > 0 ? Interval_set::Interval{t, m_high} : Interval_set::Interval{m_low, t});
      return result;
    }
    if (m_has_middle && excess(m_at_middle) > 0)
    {
      const double from = last_farther(of, m_middle, excess(m_at_middle), m_low, low);
      const double to = last_farther(of, m_middle, excess(m_at_middle), m_high, high);
      if (is_farther_between(of, from, to))
      {
        result.append({m_low, from});
        result.append({to, m_high});
        return result;
      }
    }
    result.append({m_low, m_high});
    return result;
  }

  // Precondition: the window is certainly farther at both points.
  bool is_farther_between(int of, double from, double to) const
  {
    return from == to || !m_bisector.may_turn_between(of, from, to) || is_farther_everywhere(of);
  }

  // By the triangle inequality for both images.
  bool is_farther_everywhere(int of) const
  {
    if (m_a.is_parallel() || m_b.is_parallel()) return false;
    const double x = (m_a.x - m_b.x) + (m_a.x_low - m_b.x_low), y = (m_a.y - m_b.y) + (m_a.y_low - m_b.y_low);
    const double apart = std::abs(x) + std::abs(y);
    return of * (m_a.sigma - m_b.sigma) - apart > m_margin;
  }

  // A point where the window is certainly farther, near the end of that part. `good` is in the part, `bad` is not; at_good
  // and at_bad are the excesses there.
  double last_farther(int of, double good, double at_good, double bad, double at_bad) const
  {
    const double enough = unit_roundoff * 16 * (std::abs(good) + std::abs(bad));
    for (int i = 0; i < 30 && std::abs(good - bad) > enough && at_good > 16 * m_margin; ++i)
    {
      // aim beside the root, on the good side
      const double aim = 4 * m_margin;
      double t = i % 3 == 2 ? 0.5 * (good + bad) : good + (bad - good) * ((at_good - aim) / (at_good - at_bad));
      if (!((good < t && t < bad) || (bad < t && t < good))) t = 0.5 * (good + bad);
      const double g = of * m_bisector.difference(t) - m_margin;
      if (g > 0)
      {
        good = t;
        at_good = g;
      }
      else
      {
        bad = t;
        at_bad = g;
      }
    }
    return good;
  }

  const Window& m_a;
  const Window& m_b;
  const Certified_bisector m_bisector;
  double m_low, m_high, m_middle = 0;
  const double m_margin;
  double m_at_low, m_at_high, m_at_middle = 0;
  bool m_has_middle;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
