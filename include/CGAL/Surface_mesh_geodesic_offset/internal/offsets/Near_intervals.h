// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The intervals of a straight segment where the distance is less than a level: the union of one interval per window. The
// segment is an edge, or it divides a face. A point is near if its distance is less than the level, and far otherwise.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_NEAR_INTERVALS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_NEAR_INTERVALS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Face_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Near_intervals
{
public:
  typedef Point_in_face<FT> Point;

  // `reach`: longest edge of the faces around the segment.
  void start(const FT& length, const FT& reach, const FT& level)
  {
    CGAL_precondition(CGAL::is_positive(length));
    m_intervals.clear();
    m_length = length;
    m_level = level;
    m_gap = Offset_tolerances<FT>::interval_gap(reach + level);
    m_longest_shallow = Offset_tolerances<FT>::longest_shallow_interval(reach + level);
  }

  const FT& length() const { return m_length; }
  const FT& level() const { return m_level; }

  // Adds the points up to the distance r from an end of the segment.
  void add_end(bool is_source, const FT& r)
  {
    if (is_source) add(FT(0), r, r);
    else add(m_length - r, m_length, r);
  }

  // Adds the interval [lo, hi], where the distance is below the level by at most `depth`. As the distance is 1-Lipschitz, the
  // interval is extended at each end by level - d_lo and level - d_hi, with the distances d_lo and d_hi at its ends. This
  // closes gaps due to rounding between consecutive windows. `reversed`: lo and hi count from the other end of the segment.
  void add(FT lo, FT hi, const FT& d_lo, const FT& d_hi, const FT& depth, bool reversed)
  {
    if (!(lo < hi)) return;
    if (d_lo < m_level) lo -= m_level - d_lo;
    if (d_hi < m_level) hi += m_level - d_hi;
    add_whole(lo, hi, depth, reversed);
  }

  // Adds a window of a list, on its own halfedge.
  void add_window(const Window<FT>& w, bool reversed)
  {
    FT lo = w.b0, hi = w.b1;
    if (cut_near_part(w.is_parallel(), w.x, w.y, FT(m_level - w.sigma), lo, hi))
      add(lo, hi, lo == w.b0 ? w.d0 : m_level, hi == w.b1 ? w.d1 : m_level, depth([&] { return FT(m_level - minimum(w)); }),
          reversed);
  }

  // Adds a window in a face, on the segment from o in the unit direction u.
  void add_window(const Face_window<FT>& w, const Point& o, const Point& u, bool reversed)
  {
    // The image is a point of the face, so straight paths from it to all points of the face are on the surface. The cone is not
    // tested: a ray may run along the segment up to rounding.
    if (w.origin >= STARTS_IN_FACE && !w.is_parallel())
      return add_disk(w.image(), FT(m_level - w.sigma), o, u, reversed, FT(0), m_length);
    // Add the ends of a source segment as points, too. An edge perpendicular to it at an end may be outside its rays by
    // rounding.
    if (w.origin >= STARTS_IN_FACE)
      for (const Point& end : {w.left, w.right}) add_disk(end, FT(m_level - w.start_value), o, u, reversed, FT(0), m_length);
    cut_cone(w, o, u, [&](FT lo, FT hi) {
      if (w.is_parallel() ? cut_near_part(true, dot(w.image(), u), FT(0), FT(m_level - w.distance_at(o)), lo, hi)
                          : cut_near_part(w.image(), FT(m_level - w.sigma), o, u, lo, hi))
      {
        // A point without a path is behind the source segment by less than the slack, so it is on the segment up to rounding.
        const auto distance = [&](const FT& t) {
          const FT d = w.path_length(o + t * u);
          return Number_policy<FT>::is_finite(d) ? d : w.start_value;
        };
        const FT d_lo = distance(lo), d_hi = distance(hi);
        const auto lowest = [&] {
          const FT foot = w.is_parallel() ? lo : dot(w.image() - o, u);
          return lo < foot && foot < hi ? distance(foot) : (std::min)(d_lo, d_hi);
        };
        add(lo, hi, d_lo, d_hi, depth([&] { return FT(m_level - lowest()); }), reversed);
      }
    });
    // Paths that bend at an end of the chord are valid in the whole face. They close gaps beside the cone: a ray may run along the
    // segment.
    for (const Point& bend : {w.left, w.right})
      add_disk(bend, FT(m_level - w.distance_at(bend)), o, u, reversed, FT(0), m_length);
  }

  // Calls out(t, falling) for the ends of the united intervals, by increasing t from 0 to the length, alternately from far to
  // near (`falling`) and from near to far. Intervals and gaps up to interval_gap() are dropped, and so are intervals up to
  // longest_shallow_interval(), or at an end of the segment that is not near, whose depth is at most half of interval_gap().
  // The caller decides which ends of the segment are near. The number of calls is odd exactly if one end is near.
  template <class Function>
  void for_each_end(bool source_is_near, bool target_is_near, const Function& out)
  {
    if (source_is_near) add_end(true, FT(0));
    if (target_is_near) add_end(false, FT(0));
    std::sort(m_intervals.begin(), m_intervals.end());
    std::size_t n = 0;
    for (const Interval& i : m_intervals)
    {
      if (n > 0 && are_joined(m_intervals[n - 1], i)) unite(m_intervals[n - 1], i);
      else m_intervals[n++] = i;
    }
    CGAL_assertion_code(std::size_t ends = 0);
    for (std::size_t i = 0; i < n; ++i)
    {
      CGAL_assertion(i == 0 || m_intervals[i - 1].last < m_intervals[i].first);
      const bool at_source = i == 0 && source_is_near, at_target = i + 1 == n && target_is_near;
      const FT first = (std::max)(m_intervals[i].first, FT(0)), last = (std::min)(m_intervals[i].last, m_length);
      const bool reaches_end = !(first > m_gap) || !(m_length - last > m_gap);
      if (!at_source && !at_target && is_shallow(FT(last - first), m_intervals[i].depth, reaches_end)) continue;
      if (!at_source) out(first, true);
      if (!at_target) out(last, false);
      CGAL_assertion_code(ends += std::size_t(!at_source) + std::size_t(!at_target));
    }
    CGAL_assertion((ends % 2 == 1) == (source_is_near != target_is_near));
  }

private:
  struct Interval
  {
    FT first, last;
    FT depth; // largest value of level minus distance
    friend bool operator<(const Interval& a, const Interval& b)
    {
      return a.first < b.first || (!(b.first < a.first) && a.last < b.last);
    }
  };

  static constexpr bool is_inexact = Number_policy<FT>::is_inexact;

  // Depth of an interval. It is needed only with rounding, to recognize shallow intervals; zero with exact numbers.
  template <class Function>
  static FT depth(const Function& f)
  {
    if constexpr (is_inexact) return f();
    else return FT(0);
  }

  // True if an interval is due to rounding: the level only touches the segment. `reaches_end`: the interval extends to an end
  // of the segment that is not near, so this end is on the level up to rounding.
  bool is_shallow(const FT& width, const FT& depth, bool reaches_end) const
  {
    if (!(width > m_gap)) return true;
    if constexpr (is_inexact) return (reaches_end || !(width > m_longest_shallow)) && !(FT(2) * depth > m_gap);
    else return false;
  }

  // Consecutive windows of a list mostly have one interval, which is united here, before the sort.
  void add(const FT& first, const FT& last, const FT& depth)
  {
    const Interval i{first, last, depth};
    if (!m_intervals.empty() && are_joined(m_intervals.back(), i)) unite(m_intervals.back(), i);
    else m_intervals.push_back(i);
  }

  // True if there is no gap between two intervals.
  bool are_joined(const Interval& a, const Interval& b) const { return b.first <= a.last + m_gap && a.first <= b.last + m_gap; }

  static void unite(Interval& a, const Interval& b)
  {
    a.first = (std::min)(a.first, b.first);
    a.last = (std::max)(a.last, b.last);
    if constexpr (is_inexact) a.depth = (std::max)(a.depth, b.depth);
  }

  void add_whole(const FT& lo, const FT& hi, const FT& depth, bool reversed)
  {
    if (reversed) add(m_length - hi, m_length - lo, depth);
    else add(lo, hi, depth);
  }

  // Adds the part of [lo, hi] in the disk of radius r about c.
  void add_disk(const Point& c, const FT& r, const Point& o, const Point& u, bool reversed, FT lo, FT hi)
  {
    if (!cut_near_part(c, r, o, u, lo, hi)) return;
    const auto nearest = [&] { return o + (std::max)(lo, (std::min)(dot(c - o, u), hi)) * u; };
    add_whole(lo, hi, depth([&] { return FT(r - internal::length(c - nearest())); }), reversed);
  }

  // Clips [lo, hi] to the part where the distance from an image, in the frame of the segment, is less than r. The image is the
  // point (x, y), or the direction (x, y) of parallel rays (see Window).
  static bool cut_near_part(bool parallel, const FT& x, const FT& y, const FT& r, FT& lo, FT& hi)
  {
    if (parallel)
    { // -x t < r
      if (CGAL::is_zero(x)) return CGAL::is_positive(r);
      const FT t = -r / x;
      if (CGAL::is_positive(x)) lo = (std::max)(lo, t);
      else hi = (std::min)(hi, t);
      return lo < hi;
    }
    const FT height = CGAL::abs(y);
    if (r <= height) return false;
    const FT half = square_root<FT>((r - height) * (r + height));
    lo = (std::max)(lo, FT(x - half));
    hi = (std::min)(hi, FT(x + half));
    return lo < hi;
  }

  // Overload for the distance from a point, on the segment from o in the unit direction u.
  static bool cut_near_part(const Point& c, const FT& r, const Point& o, const Point& u, FT& lo, FT& hi)
  {
    const Point v = c - o;
    return cut_near_part(false, dot(v, u), cross(u, v), r, lo, hi);
  }

  // Calls f(lo, hi) for the part of the segment in the cone of a window. If the source runs along the segment up to rounding,
  // the segment counts as in front of the source.
  template <class Function>
  void cut_cone(const Face_window<FT>& w, const Point& o, const Point& u, const Function& f) const
  {
    FT lo(0), hi = m_length;
    if (!clip(-w.left_side(o), -cross(w.left_ray(), u), FT(0), lo, hi)) return;
    if (!clip(w.right_side(o), cross(w.right_ray(), u), FT(0), lo, hi)) return;
    if (w.is_parallel() && (is_inexact || w.origin == STARTS_IN_FACE))
    { // only points in front of the source or chord: rays along the chord also pass points behind it, by rounding
      const FT nearest = w.origin == STARTS_IN_FACE ? w.start_value : (std::min)(w.distance_at(w.left), w.distance_at(w.right));
      if (!clip(w.distance_at(o) - nearest, -dot(w.image(), u), Offset_tolerances<FT>::ray_slack(m_length), lo, hi)) return;
    }
    f(lo, hi);
  }

  // Clips [lo, hi] to the part where a + b t >= -allowance.
  static bool clip(const FT& a, const FT& b, const FT& allowance, FT& lo, FT& hi)
  {
    const FT g0 = a + b * lo + allowance, g1 = a + b * hi + allowance;
    if (CGAL::is_negative(g0) && CGAL::is_negative(g1)) return false;
    const FT old = lo;
    if (CGAL::is_negative(g0)) lo = old + (g0 / (g0 - g1)) * (hi - old);
    else if (CGAL::is_negative(g1)) hi = old + (g0 / (g0 - g1)) * (hi - old);
    return true;
  }

  std::vector<Interval> m_intervals;
  FT m_length = FT(0), m_level = FT(0), m_gap = FT(0), m_longest_shallow = FT(0);
};

} // namespace CGAL::Geodesic_offset::internal

#endif
