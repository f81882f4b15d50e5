// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes without a closed form: tori, spheres, and implicit surfaces with tiny and needle faces.

#ifndef GEODESIC_OFFSET_TEST_GENERATED_CURVED_MESHES_H
#define GEODESIC_OFFSET_TEST_GENERATED_CURVED_MESHES_H

#include "generated_soup.h"

#include <functional>

namespace test {

/// Torus of n x m flat (trapezoidal) quads, each split in two.
inline Soup torus(std::size_t n, std::size_t m, double major = 1, double minor = 0.4)
{
  Soup soup;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j)
    {
      const double a = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(n);
      const double b = 2 * CGAL_PI * static_cast<double>(j) / static_cast<double>(m);
      const double r = major + minor * std::cos(b);
      soup.points.push_back(Point_3(r * std::cos(a), r * std::sin(a), minor * std::sin(b)));
    }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j)
    {
      const std::size_t i1 = (i + 1) % n, j1 = (j + 1) % m;
      const std::size_t a = i * m + j, b = i1 * m + j, c = i1 * m + j1, d = i * m + j1;
      soup.add_triangle({{a, b, c}});
      soup.add_triangle({{a, c, d}});
    }
  return soup;
}

/// Icosahedron subdivided `levels` times, with all vertices on the unit sphere: 20 x 4^levels faces, many ties.
inline Soup icosphere(std::size_t levels)
{
  const double g = (1 + std::sqrt(5.)) / 2;
  Soup soup;
  for (double s : {-1., 1.})
    for (double t : {-g, g})
    {
      soup.points.push_back(Point_3(0, s, t));
      soup.points.push_back(Point_3(s, t, 0));
      soup.points.push_back(Point_3(t, 0, s));
    }
  // faces are the triples of mutual neighbours, whose distance is 2
  const auto adjacent = [&](std::size_t i, std::size_t j) {
    return std::abs(CGAL::squared_distance(soup.points[i], soup.points[j]) - 4) < 1e-9;
  };
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = j + 1; k < 12; ++k)
        if (adjacent(i, j) && adjacent(j, k) && adjacent(i, k))
        {
          const Vector_3 p = soup.points[i] - CGAL::ORIGIN;
          const Vector_3 normal = CGAL::cross_product(soup.points[j] - soup.points[i], soup.points[k] - soup.points[i]);
          if (normal * p > 0) soup.add_triangle({{i, j, k}});
          else soup.add_triangle({{i, k, j}});
        }
  const auto to_sphere = [](const Point_3& p) {
    const Vector_3 v = p - CGAL::ORIGIN;
    return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  };
  for (Point_3& p : soup.points) p = to_sphere(p);
  for (std::size_t level = 0; level < levels; ++level)
  {
    Soup finer;
    finer.points = soup.points;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t i, std::size_t j) {
      const auto inserted = middles.emplace(std::minmax(i, j), finer.points.size());
      if (inserted.second)
      {
        const Point_3 p = finer.points[i], q = finer.points[j]; // copies: push_back may reallocate
        finer.points.push_back(to_sphere(CGAL::midpoint(p, q)));
      }
      return inserted.first->second;
    };
    for (const std::array<std::size_t, 3>& t : soup.triangles)
    {
      const std::size_t a = middle(t[1], t[2]), b = middle(t[2], t[0]), c = middle(t[0], t[1]);
      finer.add_triangle({{t[0], c, b}});
      finer.add_triangle({{t[1], a, c}});
      finer.add_triangle({{t[2], b, a}});
      finer.add_triangle({{a, b, c}});
    }
    soup = finer;
  }
  return soup;
}

/// Zero set of `f` (negative inside) over an n^3 grid of [-1, 1]^3, by marching tetrahedra: as with marching cubes, faces
/// are the smaller and thinner the closer the surface passes to grid points.
inline Soup marching_tetrahedra(const std::function<double(double, double, double)>& f, std::size_t n)
{
  Soup soup;
  const auto coordinate = [n](std::size_t i) { return 2 * static_cast<double>(i) / static_cast<double>(n) - 1; };
  std::vector<double> values;
  std::vector<Point_3> nodes;
  for (std::size_t k = 0; k <= n; ++k)
    for (std::size_t j = 0; j <= n; ++j)
      for (std::size_t i = 0; i <= n; ++i)
      {
        nodes.push_back(Point_3(coordinate(i), coordinate(j), coordinate(k)));
        values.push_back(f(coordinate(i), coordinate(j), coordinate(k)));
      }
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> crossings;
  const auto crossing = [&](std::size_t inside, std::size_t outside) {
    const auto inserted = crossings.emplace(std::minmax(inside, outside), soup.points.size());
    if (inserted.second)
    {
      const double t = values[inside] / (values[inside] - values[outside]);
      soup.points.push_back(nodes[inside] + t * (nodes[outside] - nodes[inside]));
    }
    return inserted.first->second;
  };
  // The six even permutations that move each vertex, or each pair of vertices, of a tetrahedron to the front.
  static const std::array<std::size_t, 4> single_first[] = {{{0, 1, 2, 3}}, {{1, 0, 3, 2}}, {{2, 3, 0, 1}}, {{3, 2, 1, 0}}};
  static const std::array<std::size_t, 4> pair_first[] = {{{0, 1, 2, 3}}, {{0, 2, 3, 1}}, {{0, 3, 1, 2}},
                                                          {{1, 2, 0, 3}}, {{1, 3, 2, 0}}, {{2, 3, 0, 1}}};
  const auto march = [&](const std::array<std::size_t, 4>& t) { // t is positively oriented
    const auto inside = [&](std::size_t i) { return values[t[i]] < 0; };
    const int count = inside(0) + inside(1) + inside(2) + inside(3);
    for (const std::array<std::size_t, 4>& p : single_first)
    {
      if (count == 1 && inside(p[0]))
        soup.add_triangle({{crossing(t[p[0]], t[p[1]]), crossing(t[p[0]], t[p[2]]), crossing(t[p[0]], t[p[3]])}});
      if (count == 3 && !inside(p[0]))
        soup.add_triangle({{crossing(t[p[1]], t[p[0]]), crossing(t[p[3]], t[p[0]]), crossing(t[p[2]], t[p[0]])}});
    }
    for (const std::array<std::size_t, 4>& p : pair_first)
      if (count == 2 && inside(p[0]) && inside(p[1]))
      {
        const std::size_t a = crossing(t[p[0]], t[p[2]]), b = crossing(t[p[0]], t[p[3]]);
        const std::size_t c = crossing(t[p[1]], t[p[3]]), d = crossing(t[p[1]], t[p[2]]);
        soup.add_triangle({{a, b, c}});
        soup.add_triangle({{a, c, d}});
      }
  };
  const std::size_t step[3] = {1, n + 1, (n + 1) * (n + 1)};
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
      {
        const std::size_t base = i * step[0] + j * step[1] + k * step[2];
        const std::size_t end = base + step[0] + step[1] + step[2];
        for (std::size_t a = 0; a < 3; ++a)
        {
          const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
          march({{base, base + step[a], base + step[a] + step[b], end}});
          march({{base, base + step[a] + step[c], base + step[a], end}});
        }
      }
  return soup;
}

/// Sphere that passes within about 1e-7 of grid points: many tiny and needle faces.
inline Soup marching_sphere(std::size_t n = 12)
{
  const double radius = 0.5 + 1e-7;
  return marching_tetrahedra([=](double x, double y, double z) { return x * x + y * y + z * z - radius * radius; }, n);
}

/// Surface of genus 5 (the tangle cube) with saddles everywhere.
inline Soup marching_genus_5(std::size_t n = 20)
{
  const auto along = [](double x) { return (x * x - 5) * x * x; };
  return marching_tetrahedra(
    [=](double x, double y, double z) { return along(2.35 * x) + along(2.35 * y) + along(2.35 * z) + 11.8; }, n);
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_GENERATED_CURVED_MESHES_H
