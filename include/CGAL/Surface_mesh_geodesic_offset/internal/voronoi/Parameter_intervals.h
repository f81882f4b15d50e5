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

  Parameter_intervals(NT begin, NT end) { add(begin, end); }

  // The numbers t where a quadratic polynomial in t - shift is not positive.
  static Parameter_intervals<NT> not_positive(const Quadratic<NT>& q, NT shift = 0)
  {
    const NT infinity = std::numeric_limits<NT>::infinity();
    Parameter_intervals<NT> result;
    if (q.q2 == 0)
    {
      if (q.q1 == 0)
      {
        if (q.q0 <= 0) result.add(-infinity, infinity);
      }
      else if (q.q1 > 0) result.add(-infinity, shift - q.q0 / q.q1);
      else result.add(shift - q.q0 / q.q1, infinity);
      return result;
    }
    const NT discriminant = q.q1 * q.q1 - 4 * q.q2 * q.q0;
    if (!(discriminant > 0))
    {
      if (q.q2 < 0) result.add(-infinity, infinity);
      return result;
    }
    const NT root = square_root<NT>(discriminant);
    const NT s = -(q.q1 + (q.q1 < NT(0) ? -root : root)) / NT(2); // without cancellation
    NT r = shift + s / q.q2, t = shift + q.q0 / s;
    if (t < r) std::swap(r, t);
    if (q.q2 > 0) result.add(r, t);
    else
    {
      result.add(-infinity, r);
      result.add(t, infinity);
    }
    return result;
  }

  bool is_empty() const { return m_intervals.empty(); }
  auto begin() const { return m_intervals.begin(); }
  auto end() const { return m_intervals.end(); }

  void intersect(const Parameter_intervals<NT>& other)
  {
    Intervals result;
    for (const Interval& i : m_intervals)
      for (const Interval& j : other.m_intervals)
      {
        const Interval k{(std::max)(i.begin, j.begin), (std::min)(i.end, j.end)};
        if (k.begin < k.end) result.push_back(k);
      }
    m_intervals.swap(result);
  }

  void subtract(const Parameter_intervals<NT>& other)
  {
    for (const Interval& j : other.m_intervals)
    {
      Intervals result;
      for (const Interval& i : m_intervals)
      {
        if (i.begin < (std::min)(i.end, j.begin)) result.push_back({i.begin, (std::min)(i.end, j.begin)});
        if ((std::max)(i.begin, j.end) < i.end) result.push_back({(std::max)(i.begin, j.end), i.end});
      }
      m_intervals.swap(result);
    }
  }

private:
  typedef boost::container::small_vector<Interval, 4> Intervals;

  Parameter_intervals() = default;

  void add(NT begin, NT end)
  {
    if (begin < end) m_intervals.push_back({begin, end});
  }

  Intervals m_intervals; // in order
};

} // namespace CGAL::Geodesic_offset::internal

#endif
