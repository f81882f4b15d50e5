// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sets of numbers that consist of disjoint intervals.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_PARAMETER_INTERVALS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_PARAMETER_INTERVALS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_conic.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL::Geodesic_offset::internal {

template <class NT>
class Parameter_intervals
{
public:
  struct Interval
  {
    NT begin, end;
  };

  Parameter_intervals(NT begin, NT end)
  {
    if (begin < end) m_intervals.push_back({begin, end});
  }

  // Keeps the numbers t where a quadratic polynomial in t - shift is not positive.
  void keep_not_positive(const Quadratic<NT>& q, NT shift = 0)
  {
    if (q.q2 == 0)
    {
      if (q.q1 == 0)
      {
        if (!(q.q0 <= 0)) m_intervals.clear();
      }
      else if (q.q1 > 0) keep(-infinity, shift - q.q0 / q.q1);
      else keep(shift - q.q0 / q.q1, infinity);
      return;
    }
    const NT discriminant = q.q1 * q.q1 - 4 * q.q2 * q.q0;
    if (!(discriminant > 0))
    {
      if (!(q.q2 < 0)) m_intervals.clear();
      return;
    }
    const NT root = square_root<NT>(discriminant);
    const NT s = -(q.q1 + (q.q1 < NT(0) ? -root : root)) / NT(2); // without cancellation
    NT r = shift + s / q.q2, t = shift + q.q0 / s;
    if (t < r) std::swap(r, t);
    if (q.q2 > 0) keep(r, t);
    else subtract(r, t);
  }

  bool is_empty() const { return m_intervals.empty(); }
  auto begin() const { return m_intervals.begin(); }
  auto end() const { return m_intervals.end(); }

  void subtract(const Parameter_intervals<NT>& other)
  {
    for (const Interval& j : other.m_intervals) subtract(j.begin, j.end);
  }

private:
  static constexpr NT infinity = std::numeric_limits<NT>::infinity();

  void keep(NT begin, NT end)
  {
    auto out = m_intervals.begin();
    for (const Interval& i : m_intervals)
    {
      const Interval part{(std::max)(i.begin, begin), (std::min)(i.end, end)};
      if (part.begin < part.end) *out++ = part;
    }
    m_intervals.erase(out, m_intervals.end());
  }

  void subtract(NT begin, NT end)
  {
    for (std::size_t n = m_intervals.size(); n-- > 0;)
    {
      const Interval i = m_intervals[n], before{i.begin, (std::min)(i.end, begin)}, behind{(std::max)(i.begin, end), i.end};
      const auto at = m_intervals.erase(m_intervals.begin() + std::ptrdiff_t(n));
      if (behind.begin < behind.end) m_intervals.insert(at, behind);
      if (before.begin < before.end) m_intervals.insert(m_intervals.begin() + std::ptrdiff_t(n), before);
    }
  }

  boost::container::small_vector<Interval, 4> m_intervals; // in order
};

} // namespace CGAL::Geodesic_offset::internal

#endif
