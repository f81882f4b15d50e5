// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Polylines that stand for curves: how near they are, and how many points are needed (Douglas-Peucker).

#ifndef GEODESIC_OFFSET_TEST_THIN_POLYLINES_H
#define GEODESIC_OFFSET_TEST_THIN_POLYLINES_H

#include "generated_soup.h"
#include "test_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
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

/// Whether points are within a distance of a polyline. The segments are in the cells of a grid that are as wide as four times
/// the distance at least; a segment is in the cells of points of it that are half a cell apart.
class Near_polyline
{
public:
  Near_polyline(const Polyline_3& polyline, double distance) : polyline_(polyline), distance_(distance)
  {
    cell_ = (std::max)(4 * distance, polyline_length(polyline) / static_cast<double>(polyline.size()));
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i)
    {
      const double length = std::sqrt(CGAL::squared_distance(polyline[i], polyline[i + 1]));
      const int parts = 1 + static_cast<int>(std::ceil(2 * length / cell_));
      for (int k = 0; k <= parts; ++k)
      {
        std::vector<std::size_t>& segments =
          segments_[cell_of(polyline[i] + (static_cast<double>(k) / parts) * (polyline[i + 1] - polyline[i]))];
        if (segments.empty() || segments.back() != i) segments.push_back(i);
      }
    }
  }

  bool operator()(const Point_3& p) const
  {
    const Cell c = cell_of(p);
    for (long x = c[0] - 1; x <= c[0] + 1; ++x)
      for (long y = c[1] - 1; y <= c[1] + 1; ++y)
        for (long z = c[2] - 1; z <= c[2] + 1; ++z)
        {
          const auto found = segments_.find(Cell{x, y, z});
          if (found == segments_.end()) continue;
          for (std::size_t i : found->second)
            if (distance_to_segment(p, polyline_[i], polyline_[i + 1]) <= distance_) return true;
        }
    return false;
  }

private:
  typedef std::array<long, 3> Cell;

  Cell cell_of(const Point_3& p) const
  {
    return {std::lround(std::floor(p.x() / cell_)), std::lround(std::floor(p.y() / cell_)),
            std::lround(std::floor(p.z() / cell_))};
  }

  const Polyline_3& polyline_;
  double distance_, cell_;
  std::map<Cell, std::vector<std::size_t>> segments_;
};

/// The number of points that Douglas and Peucker select: of a part between two points that are selected, the point that is
/// farthest from their segment if it is farther than the tolerance. Of a closed polyline, which ends with its first point, the
/// point that is farthest from the first one is selected, too.
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

/// The polyline of a curve is within the tolerance of the curve and the curve within the tolerance of it, as samples show;
/// its points are on the curve; it has the ends of an open curve, and closes a closed one; it has no more points than the
/// polyline that goes from piece to piece. `size`: of the coordinates.
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
    CHECK_DETAIL(distinct.size() >= 3 && !has_copies, std::to_string(distinct.size()) + " distinct points");
  }
  else CHECK(points.front() == piecewise.front() && points.back() == piecewise.back());
  CHECK_DETAIL(points.size() <= (std::max)(piecewise.size(), std::size_t(curve.is_closed() ? 4 : 2)),
               std::to_string(points.size()) + " points, piece by piece " + std::to_string(piecewise.size()));
  CHECK(polyline_length(points) <= curve.length() * (1 + 1e-9));

  // of the tolerance: the height of the curve over the chords of `samples`
  const double part = tolerance > 1e-5 * size ? 1. / 1024 : 1. / 64;
  const Polyline_3 samples = piecewise_points(curve, part * tolerance);
  const Near_polyline is_near_polyline(points, tolerance * (1 + 1e-9) + rounding);
  std::size_t off_polyline = 0, off_curve = 0, off_points = 0;
  for (const Point_3& p : samples) off_polyline += is_near_polyline(p) ? 0 : 1;
  CHECK_DETAIL(off_polyline == 0, std::to_string(off_polyline) + " of " + std::to_string(samples.size()) +
                                    " points of the curve are off its polyline, tolerance " + std::to_string(tolerance));
  const Near_polyline is_near_curve(samples, tolerance * (1 + part) + rounding),
    is_on_curve(samples, part * tolerance + rounding);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    off_points += is_on_curve(points[i]) ? 0 : 1;
    for (int k = 1; k < 8 && i + 1 < points.size(); ++k)
      off_curve += is_near_curve(points[i] + (k / 8.) * (points[i + 1] - points[i])) ? 0 : 1;
  }
  CHECK_DETAIL(off_points == 0, std::to_string(off_points) + " points are not on the curve");
  CHECK_DETAIL(off_curve == 0, std::to_string(off_curve) + " points of the polyline are off the curve");
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_THIN_POLYLINES_H
