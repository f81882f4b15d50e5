// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangulation of polygons whose projection to a plane is not simple: far from planar, self-intersecting, or with a
// repeated vertex.

#ifndef GEODESIC_OFFSET_POLYGON_TRIANGLES_H
#define GEODESIC_OFFSET_POLYGON_TRIANGLES_H

#include "common.h"

#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/utility.h>

#include <cstddef>
#include <iterator>
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

// Triangulation with the smallest dihedral angles and the smallest area. A fan if all triangles are degenerate, or if the
// polygon is large, since the time is cubic in its size.
inline std::vector<Polygon> triangles_of(const Polygon& polygon, const std::vector<Point>& points)
{
  using Triangle = CGAL::Triple<int, int, int>;
  constexpr std::size_t largest = 300; // corners: about a second
  std::vector<Triangle> corners;
  if(polygon.size() <= largest)
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(internal::corners_of(polygon, points), std::back_inserter(corners));
  if(corners.empty())
    for(int i = 1; i + 1 < static_cast<int>(polygon.size()); ++i) corners.push_back(Triangle(0, i, i + 1));
  const auto vertex = [&](int corner) { return polygon[static_cast<std::size_t>(corner)]; };
  std::vector<Polygon> triangles;
  for(const Triangle& t : corners) triangles.push_back({vertex(t.first), vertex(t.second), vertex(t.third)});
  return triangles;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_POLYGON_TRIANGLES_H
