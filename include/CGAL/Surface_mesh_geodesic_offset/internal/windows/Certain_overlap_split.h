// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Split of the overlap of two windows if distances are only estimated (Interval_filter.h): each window keeps all parts except
// those where the other one is certainly nearer.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_CERTAIN_OVERLAP_SPLIT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_CERTAIN_OVERLAP_SPLIT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <limits>

namespace CGAL::Geodesic_offset::internal {

// The overlap consists of zones: a certainly nearer, b certainly nearer, open. The difference of the distances is monotone on
// either side of the point collinear with both images (see Window_bisector), so bisection with estimates finds the limits of
// the zones; the closed form of the bisector is not needed.
//
// A zone that is too narrow is left open, so that a window that was cut once is not cut again.
template <class FT>
class Certain_overlap_split
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef typename Interval_filter<FT>::Estimate Estimate;

  // Precondition: a does not begin behind b.
  Certain_overlap_split(const Window& a, const Window& b, const FT& length)
    : m_a(a), m_b(b), m_least_width(CGAL::to_double(length) / double(1ull << 44))
  {
    const Estimate a1 = estimate(a.b1), b0 = estimate(b.b0), b1 = estimate(b.b1);
    CGAL_precondition(Interval_filter<FT>::key(a.b0) <= Interval_filter<FT>::key(b.b0));
    m_low = b0.inf();
    m_high = (std::min)(a1.sup(), b1.sup());
    if (m_high - b0.sup() <= m_least_width) return;
    find_zones();
    remove_narrow_zones();
    if (m_size == 1 && m_zones[0].nearer == OPEN)
    {
      m_size = 0;
      return;
    }
    const Uncertain<Comparison_result> ends = compare_bounds(a.b1, b.b1);
    if (CGAL::possibly_not(ends == EQUAL))
      append(CGAL::certainly(ends == SMALLER)  ? SECOND
             : CGAL::certainly(ends == LARGER) ? FIRST
                                               : OPEN,
             (std::min)(a1.inf(), b1.inf()), std::numeric_limits<double>::infinity());
    m_end_of_lead = b0.sup();
  }

  // True if neither window is certainly nearer anywhere; both are then kept unchanged.
  bool is_open() const { return m_size == 0; }

  // Calls f(window) for the kept parts of a, first to last. The first one begins where a begins, if a keeps any part.
  template <class Function>
  void for_each_part_of_first(const Function& f) const
  {
    const bool leads = CGAL::possibly(compare_bounds(m_a.b0, m_b.b0) == SMALLER);
    if (leads && m_zones[0].nearer == SECOND) f(part(m_a, -std::numeric_limits<double>::infinity(), m_end_of_lead));
    for_each_part(m_a, SECOND, f);
  }
  template <class Function>
  void for_each_part_of_second(const Function& f) const
  {
    for_each_part(m_b, FIRST, f);
  }

private:
  enum Nearer { FIRST = -1, OPEN = 0, SECOND = 1 }; // sign of the difference of distances
  struct Zone
  {
    int nearer;
    double from, to;
  };

  template <class Function>
  void for_each_part(const Window& w, int other, const Function& f) const
  {
    for (int i = 0; i < m_size; ++i)
    {
      if (m_zones[i].nearer == other) continue;
      const double from = m_zones[i].from;
      while (i + 1 < m_size && m_zones[i + 1].nearer != other) ++i;
      f(part(w, from, m_zones[i].to));
    }
  }

  // The part of a window between two cuts; a limit at or beyond the end of the overlap is no cut.
  Window part(const Window& whole, double from, double to) const
  {
    Window w = whole;
    if (from > m_low)
    {
      w.b0 = FT(from);
      w.d0 = w.distance_at(w.b0);
    }
    if (to < m_high)
    {
      w.b1 = FT(to);
      w.d1 = w.distance_at(w.b1);
    }
    return w;
  }

  void find_zones()
  {
    // Positive on one side of the collinear point.
    const Estimated_distance<FT> a(m_a), b(m_b);
    const Estimate n = a.x * b.y - b.x * a.y, den = (a.is_parallel ? Estimate(0) : b.y) - (b.is_parallel ? Estimate(0) : a.y);
    const auto side = [&](const Estimate& t) { return n - t * den; };
    const auto difference = [&](const Estimate& t) { return a(t) - b(t); };
    double p = m_high, q = m_high;
    if (!(a.is_parallel && b.is_parallel)) find_change(side, m_low, m_high, p, q);
    find_zones_between(difference, m_low, p);
    if (p < q) append(sign_of(difference(Estimate(p, q))), p, q);
    find_zones_between(difference, q, m_high);
  }

  template <class Function>
  void find_zones_between(const Function& difference, double u, double v)
  {
    if (!(u < v)) return;
    double p, q;
    find_change(difference, u, v, p, q);
    append(sign_at(difference, u), u, p);
    append(OPEN, p, q);
    append(sign_at(difference, v), q, v);
  }

  // The part [p, q] of [u, v] where a monotone function may change its sign; p = q = v if it certainly does not.
  template <class Function>
  void find_change(const Function& f, double u, double v, double& p, double& q) const
  {
    const int su = sign_at(f, u), sv = sign_at(f, v);
    p = q = v;
    if (su == sv && su != 0) return;
    p = u;
    if (su == 0 && sv == 0) return;
    double open_at = su == 0 ? u : v;
    bool is_found = su == 0 || sv == 0;
    while (!is_found && narrows(p, q))
    {
      const double m = p + (q - p) / 2;
      const int s = sign_at(f, m);
      if (s == su) p = m;
      else if (s == sv) q = m;
      else
      {
        open_at = m;
        is_found = true;
      }
    }
    if (!is_found) return;
    if (su != 0) p = last_with_sign(f, su, p, open_at);
    if (sv != 0) q = last_with_sign(f, sv, q, open_at);
  }

  // The point nearest to `open_at` where the sign is certain.
  template <class Function>
  double last_with_sign(const Function& f, int s, double from, double open_at) const
  {
    while (narrows(from, open_at))
    {
      const double m = from + (open_at - from) / 2;
      (sign_at(f, m) == s ? from : open_at) = m;
    }
    return from;
  }

  bool narrows(double p, double q) const
  {
    const double m = p + (q - p) / 2;
    return CGAL::abs(q - p) > m_least_width / 64 && m != p && m != q;
  }

  static int sign_of(const Estimate& e) { return e.inf() > 0 ? 1 : e.sup() < 0 ? -1 : 0; }
  template <class Function>
  static int sign_at(const Function& f, double t)
  {
    return sign_of(f(Estimate(t)));
  }

  void append(int nearer, double from, double to)
  {
    if (!(from < to)) return;
    if (m_size > 0 && m_zones[m_size - 1].nearer == nearer) m_zones[m_size - 1].to = to;
    else
    {
      CGAL_assertion(m_size < 8); // two signs and an open zone on both sides of the turning point, and the tail
      m_zones[m_size++] = Zone{nearer, from, to};
    }
  }

  void remove_narrow_zones()
  {
    const int n = m_size;
    m_size = 0;
    for (int i = 0; i < n; ++i)
    {
      const Zone z = m_zones[i];
      append(z.to - z.from > m_least_width ? z.nearer : int(OPEN), z.from, z.to);
    }
  }

  const Window &m_a, &m_b;
  const double m_least_width;
  double m_low, m_high, m_end_of_lead;
  Zone m_zones[8];
  int m_size = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
