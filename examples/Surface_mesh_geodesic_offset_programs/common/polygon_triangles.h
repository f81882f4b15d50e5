// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangulation of polygons whose projection to a plane is not simple: far from planar, self-intersecting, or with a
// repeated vertex.

#ifndef GEODESIC_OFFSET_POLYGON_TRIANGLES_H
#define GEODESIC_OFFSET_POLYGON_TRIANGLES_H

#include "common.h"

#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Projection_traits_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace geodesic_offset {
namespace internal {

inline Vector area_vector(const Point& a, const Point& b, const Point& c) { return CGAL::cross_product(b - a, c - a); }

inline std::vector<Point> corners_of(const Polygon& polygon, const std::vector<Point>& points)
{
  std::vector<Point> corners;
  corners.reserve(polygon.size());
  for(std::uint32_t v : polygon) corners.push_back(points[v]);
  return corners;
}

} // namespace internal

// Whether the projection of a polygon along its normal is simple: its edges meet only at common corners.
inline bool is_simple(const Polygon& polygon, const std::vector<Point>& points)
{
  using internal::area_vector;
  if(polygon.size() == 3) return true;
  const std::vector<Point> p = internal::corners_of(polygon, points);
  if(p.size() == 4) // then with at least one diagonal the two triangles do not overlap
    return area_vector(p[0], p[1], p[2]) * area_vector(p[0], p[2], p[3]) > 0 ||
           area_vector(p[1], p[2], p[3]) * area_vector(p[1], p[3], p[0]) > 0;
  Vector normal = CGAL::NULL_VECTOR;
  for(std::size_t i = 1; i + 1 < p.size(); ++i) normal = normal + area_vector(p[0], p[i], p[i + 1]);
  return normal != CGAL::NULL_VECTOR && CGAL::is_simple_2(p.begin(), p.end(), CGAL::Projection_traits_3<Kernel>(normal));
}

// Corners of polygons that are divided as below: the time is cubic in their number, about a second.
constexpr std::size_t largest_divided_polygon = 300;

// The triangulation of a polygon with the smallest area; of those with the same area up to rounding, that whose triangles are
// least thin: the sum of the squares of their sums of squared sides, divided by their areas, is smallest. The parts that a
// polygon covers twice, such as spikes, become triangles without area.
class Polygon_division
{
  std::size_t m_n;
  std::vector<std::size_t> m_third;

public:
  // Precondition: 3 <= p.size() <= largest_divided_polygon
  explicit Polygon_division(const std::vector<Point>& p) : m_n(p.size()), m_third(m_n * m_n, 0)
  {
    std::vector<double> area(m_n * m_n, 0), thinness(m_n * m_n, 0);
    for(std::size_t j = 2; j < m_n; ++j)
      for(std::size_t i = j - 1; i-- > 0;)
      {
        double &least = area[i * m_n + j], &least_thinness = thinness[i * m_n + j];
        least = infinity;
        for(std::size_t k = i + 1; k < j; ++k)
        {
          const double triangle = std::sqrt(internal::area_vector(p[i], p[k], p[j]).squared_length());
          const double sum = area[i * m_n + k] + area[k * m_n + j] + triangle;
          const double squares =
            CGAL::squared_distance(p[i], p[j]) + CGAL::squared_distance(p[i], p[k]) + CGAL::squared_distance(p[k], p[j]);
          const double sum_of_thinness = thinness[i * m_n + k] + thinness[k * m_n + j] +
                                         squares * std::min(most_thin, squares / triangle); // also if that is 0 / 0
          const bool is_same = std::abs(sum - least) <= rounding * sum;
          if(is_same ? !(sum_of_thinness < least_thinness) : !(sum < least)) continue;
          least = sum;
          least_thinness = sum_of_thinness;
          m_third[i * m_n + j] = k;
        }
      }
  }

  // The corner of the triangle at the diagonal, or the side, between the corners i and j.
  std::size_t third(std::size_t i, std::size_t j) const { return m_third[i * m_n + j]; }

private:
  static constexpr double rounding = 1e-12; // of areas, well above that of the sums
  static constexpr double most_thin = 1e60; // instead of infinity, so that the number of triangles without area counts
};

// As above; a fan if the polygon is larger.
inline std::vector<Polygon> triangles_of(const Polygon& polygon, const std::vector<Point>& points)
{
  const std::size_t n = polygon.size();
  std::vector<Polygon> triangles;
  if(n > largest_divided_polygon)
  {
    for(std::size_t k = 1; k + 1 < n; ++k) triangles.push_back({polygon[0], polygon[k], polygon[k + 1]});
    return triangles;
  }
  const Polygon_division division(internal::corners_of(polygon, points));
  std::vector<std::array<std::size_t, 2>> diagonals{{0, n - 1}};
  while(!diagonals.empty())
  {
    const auto [i, j] = diagonals.back();
    diagonals.pop_back();
    if(j - i < 2) continue;
    const std::size_t k = division.third(i, j);
    triangles.push_back({polygon[i], polygon[k], polygon[j]});
    diagonals.push_back({i, k});
    diagonals.push_back({k, j});
  }
  return triangles;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_POLYGON_TRIANGLES_H
