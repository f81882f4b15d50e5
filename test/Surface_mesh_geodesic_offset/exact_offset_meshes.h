// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes and counters for measurements of exact offsets.

#ifndef GEODESIC_OFFSET_TEST_EXACT_OFFSET_MESHES_H
#define GEODESIC_OFFSET_TEST_EXACT_OFFSET_MESHES_H

#include "generated_meshes.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/Radical_numbers.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace test {

/// Relative tolerance for lengths of curves in doubles against exact ones: about 2^16 units in the last place, for the
/// rounding of the joints of curves with a hundred pieces and of their sum, with a reserve for joints at small angles.
constexpr double same_length = 1e-11;

/// Convex hull of random points on a sphere, with coordinates of 53 bits: an even number of faces in general position.
inline Soup random_hull(std::size_t faces, unsigned seed)
{
  Random random(seed);
  std::vector<Point_3> points;
  while (points.size() < faces / 2 + 2)
  {
    const double z = uniform(random, -1, 1), angle = uniform(random, 0, 2 * CGAL_PI), r = std::sqrt(1 - z * z);
    points.push_back(Point_3(r * std::cos(angle), r * std::sin(angle), z));
  }
  CGAL::Surface_mesh<Point_3> hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  // in the order of the points, which differs from that of the hull
  std::map<Point_3, std::size_t> index;
  for (const Point_3& p : points) index.emplace(p, index.size());
  Soup soup;
  soup.points = points;
  std::set<std::array<std::size_t, 3>> triangles;
  for (const auto f : hull.faces())
  {
    std::array<std::size_t, 3> corners;
    std::size_t k = 0;
    for (const auto v : CGAL::vertices_around_face(hull.halfedge(f), hull)) corners[k++] = index.at(hull.point(v));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.insert(corners);
  }
  for (const auto& t : triangles) soup.add_triangle(t);
  return soup;
}

/// Signs decided so far neither by intervals of up to 256 bits nor by identities of parts.
inline std::size_t signs_by_exact_arithmetic()
{
  const auto& c = CGAL::Radical_numbers::internal::Radical_sign::counts();
  return std::size_t(c.exactly_zero + c.exactly_not_zero + c.by_high_precision + c.by_root_bound + c.by_core);
}

struct Exact_offset_mesh
{
  std::string kind;
  std::size_t faces; // approximate
  bool is_random;
  std::function<Soup(unsigned seed)> make;
};

inline std::vector<Exact_offset_mesh> exact_offset_meshes()
{
  std::vector<Exact_offset_mesh> meshes;
  for (std::size_t n : {20, 50, 100})
    meshes.push_back({"random hull", n, true, [n](unsigned seed) { return random_hull(n, seed); }});
  meshes.push_back({"flat graded disc", 200, true, [](unsigned seed) { return graded_disc(107, 3, 0, seed); }});
  meshes.push_back({"regular grid", 288, false, [](unsigned) { return planar_grid(12, 12); }});
  return meshes;
}

} // namespace test

#endif
