// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Polylines for curves: their distance from the curve, and the necessary number of points (Douglas-Peucker).

#ifndef GEODESIC_OFFSET_TEST_THIN_POLYLINES_H
#define GEODESIC_OFFSET_TEST_THIN_POLYLINES_H

#include "generated_soup.h"
#include "test_check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace test {

typedef std::vector<Point_3> Polyline_3;

inline double distance_to_segment(const Point_3& p, const Point_3& a, const Point_3& b)
{
  const double l = CGAL::squared_distance(a, b);
  const double t = l > 0 ? (std::min)((std::max)(((p - a) * (b - a)) / l, 0.), 1.) : 0;
  return std::sqrt(CGAL::squared_distance(p, a + t * (b - a)));
}

inline double polyline_length(const Polyline_3& polyline)
{
  double sum = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) sum += std::sqrt(CGAL::squared_distance(polyline[i - 1], polyline[i]));
  return sum;
}

/// Tests whether points are within a distance of a polyline. The search starts at the segment that was near the last point,
/// so points that follow the polyline take constant time.
class Near_polyline
{
public:
  Near_polyline(const Polyline_3& polyline, double distance) : polyline_(polyline), distance_(distance) {}

  bool operator()(const Point_3& p)
  {
    const std::size_t n = polyline_.size() - 1;
    for (std::size_t step = 0; step <= n / 2; ++step)
      for (const std::size_t i : {(last_ + step) % n, (last_ + n - step) % n})
        if (distance_to_segment(p, polyline_[i], polyline_[i + 1]) <= distance_)
        {
          last_ = i;
          return true;
        }
    return false;
  }

private:
  const Polyline_3& polyline_; // of two points at least
  double distance_;
  std::size_t last_ = 0;
};

/// Decides whether the Frechet distance of two polylines is at most a given distance, by the free space diagram of Alt and
/// Godau. A polyline that continues past a reversal of the other one is farther from it, although each point of both is
/// near the other. Only reached cells of the diagram are visited.
class Frechet_decision
{
public:
  Frechet_decision(const Polyline_3& p, const Polyline_3& q, double distance) : p_(p), q_(q), distance_(distance) {}

  bool operator()() const
  {
    const std::size_t n = p_.size() - 1, m = q_.size() - 1;
    if (!is_near(p_[0], q_[0]) || !is_near(p_[n], q_[m])) return false;
    // Reached part of segment i of p at vertex j of q, for i in [first, end), nonempty for the first and last; and whether
    // vertex 0 of p is reached at vertex j.
    std::vector<Interval> reached(n), next(n);
    std::size_t first = 0, end = 0;
    for (bool goes_on = true; goes_on && end < n; goes_on = reached[end - 1].high == 1)
    {
      reached[end] = free_part(q_[0], p_[end], p_[end + 1]);
      if (reached[end].low > 0) break;
      ++end;
    }
    bool is_start_reached = true;
    for (std::size_t j = 0; j < m; ++j)
    {
      Interval below; // reached part of segment j of q at vertex i of p
      if (is_start_reached) below = free_part(p_[0], q_[j], q_[j + 1]);
      if (below.low > 0) below = Interval();
      is_start_reached = below.high == 1;
      std::size_t next_first = n, next_end = n;
      for (std::size_t i = below.is_empty() ? first : 0; i < n && (i < end || !below.is_empty()); ++i)
      {
        const Interval left = i >= first && i < end ? reached[i] : Interval();
        next[i] = Interval();
        Interval above;
        if (!left.is_empty() || !below.is_empty())
        {
          next[i] = free_part(q_[j + 1], p_[i], p_[i + 1]);
          if (below.is_empty()) next[i].low = (std::max)(next[i].low, left.low);
          above = free_part(p_[i + 1], q_[j], q_[j + 1]);
          if (left.is_empty()) above.low = (std::max)(above.low, below.low);
        }
        if (!next[i].is_empty())
        {
          next_first = (std::min)(next_first, i);
          next_end = i + 1;
        }
        below = above;
      }
      reached.swap(next);
      first = next_first;
      end = next_end;
      if (first == n && !is_start_reached) return false;
    }
    return first < n && end == n && reached[n - 1].high == 1;
  }

private:
  struct Interval
  {
    double low = 1, high = 0;
    bool is_empty() const { return !(low <= high); }
  };

  bool is_near(const Point_3& p, const Point_3& q) const { return CGAL::squared_distance(p, q) <= distance_ * distance_; }

  // The part of a segment near a point; it ends exactly at 0 or 1 if that end is near.
  Interval free_part(const Point_3& p, const Point_3& a, const Point_3& b) const
  {
    Interval result;
    const Vector_3 d = b - a;
    const double l = d * d, along = l > 0 ? ((p - a) * d) / l : 0;
    const double h = distance_ * distance_ - CGAL::squared_distance(p, a + along * d);
    if (h >= 0 && l > 0)
    {
      result.low = (std::max)(along - std::sqrt(h / l), 0.);
      result.high = (std::min)(along + std::sqrt(h / l), 1.);
    }
    if (is_near(p, a)) result = {0, result.is_empty() ? 0 : result.high};
    if (is_near(p, b)) result = {result.is_empty() ? 1 : result.low, 1};
    return result;
  }

  const Polyline_3& p_;
  const Polyline_3& q_;
  double distance_;
};

/// Number of points selected by the algorithm of Douglas and Peucker: between two selected points, the point farthest from
/// their segment is selected if it is farther than the tolerance. Of a closed polyline, whose last point equals the first,
/// the point farthest from the first one is also selected.
inline std::size_t points_needed(const Polyline_3& polyline, double tolerance)
{
  if (polyline.size() < 3) return polyline.size();
  std::size_t count = 2;
  std::vector<std::pair<std::size_t, std::size_t>> parts(1, {0, polyline.size() - 1});
  while (!parts.empty())
  {
    const auto part = parts.back();
    parts.pop_back();
    std::size_t farthest = part.first;
    double largest = 0;
    for (std::size_t i = part.first + 1; i < part.second; ++i)
    {
      const double d = distance_to_segment(polyline[i], polyline[part.first], polyline[part.second]);
      if (d <= largest) continue;
      largest = d;
      farthest = i;
    }
    if (largest <= tolerance) continue;
    ++count;
    parts.push_back({part.first, farthest});
    parts.push_back({farthest, part.second});
  }
  return count;
}

template <class Curve>
Polyline_3 curve_points(const Curve& curve, double tolerance)
{
  Polyline_3 points;
  curve.points(tolerance, std::back_inserter(points));
  return points;
}

template <class Curve>
Polyline_3 piecewise_points(const Curve& curve, double tolerance)
{
  Polyline_3 points;
  curve.discretize(tolerance, [&](const auto& location, std::size_t) { points.push_back(curve.point(location)); });
  return points;
}

/// Whether all points are within a tolerance of the line through the first point and the point farthest from it.
inline bool is_on_line(const Polyline_3& points, double tolerance)
{
  const Point_3& p = points.front();
  Vector_3 direction(0, 0, 0);
  for (const Point_3& q : points)
    if ((q - p).squared_length() > direction.squared_length()) direction = q - p;
  for (const Point_3& q : points)
    if (CGAL::cross_product(q - p, direction).squared_length() > tolerance * tolerance * direction.squared_length())
      return false;
  return true;
}

/// Checks that the polyline of a curve and the curve are within the tolerance of each other, by samples, and so is their
/// Frechet distance; that the points of the polyline are on the curve; that it has the ends of an open curve, and closes a
/// closed one; and that it has no more points than the polyline with a point at each end of a piece. `size`: of the
/// coordinates.
template <class Curve>
void check_thin_polyline(const Curve& curve, double tolerance, double size)
{
  const double rounding = 1e-12 * size;
  const Polyline_3 points = curve_points(curve, tolerance), piecewise = piecewise_points(curve, tolerance);
  if (!CHECK(points.size() >= 2)) return;
  if (curve.is_closed())
  {
    CHECK(points.front() == points.back());
    Polyline_3 distinct(points.begin(), points.end() - 1);
    std::sort(distinct.begin(), distinct.end());
    const bool has_copies = std::adjacent_find(distinct.begin(), distinct.end()) != distinct.end();
    const bool has_triangle = distinct.size() >= 3 || is_on_line(piecewise, rounding);
    CHECK_DETAIL(has_triangle && !has_copies, std::to_string(distinct.size()) + " distinct points");
  }
  else CHECK(points.front() == piecewise.front() && points.back() == piecewise.back());
  CHECK_DETAIL(points.size() <= (std::max)(piecewise.size(), std::size_t(curve.is_closed() ? 4 : 2)),
               std::to_string(points.size()) + " points, piece by piece " + std::to_string(piecewise.size()));
  // each segment is longer than its part of the curve by the rounding of its ends at most
  CHECK(polyline_length(points) <= curve.length() * (1 + 1e-9) + double(points.size()) * rounding);

  // height of the curve over the chords of `samples`, relative to the tolerance
  const double part = tolerance > 1e-5 * size ? 1. / 1024 : 1. / 64;
  const Polyline_3 samples = piecewise_points(curve, part * tolerance);
  Near_polyline is_near_polyline(points, tolerance * (1 + 1e-9) + rounding);
  std::size_t off_polyline = 0, off_curve = 0, off_points = 0;
  for (const Point_3& p : samples) off_polyline += is_near_polyline(p) ? 0 : 1;
  CHECK_DETAIL(off_polyline == 0, std::to_string(off_polyline) + " of " + std::to_string(samples.size()) +
                                    " points of the curve are off its polyline, tolerance " + std::to_string(tolerance));
  Near_polyline is_near_curve(samples, tolerance * (1 + part) + rounding), is_on_curve(samples, part * tolerance + rounding);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    off_points += is_on_curve(points[i]) ? 0 : 1;
    for (int k = 1; k < 8 && i + 1 < points.size(); ++k)
      off_curve += is_near_curve(points[i] + (k / 8.) * (points[i + 1] - points[i])) ? 0 : 1;
  }
  CHECK_DETAIL(off_points == 0, std::to_string(off_points) + " points are not on the curve");
  CHECK_DETAIL(off_curve == 0, std::to_string(off_curve) + " points of the polyline are off the curve");

  const auto is_frechet_near = [&](const Polyline_3& s) {
    return Frechet_decision(points, s, tolerance * (1 + part) + rounding)();
  };
  bool is_frechet_near_any = !curve.is_closed() && is_frechet_near(samples);
  // a closed polyline may begin at any end of a piece; a curve may pass a point twice
  for (std::size_t i = 0; curve.is_closed() && !is_frechet_near_any && i + 1 < samples.size(); ++i)
  {
    if (samples[i] != points.front()) continue;
    Polyline_3 turned(samples.begin() + static_cast<std::ptrdiff_t>(i), samples.end());
    turned.insert(turned.end(), samples.begin() + 1, samples.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    is_frechet_near_any = is_frechet_near(turned);
  }
  CHECK_DETAIL(is_frechet_near_any, "the Frechet distance is larger than the tolerance " + std::to_string(tolerance));
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_THIN_POLYLINES_H
