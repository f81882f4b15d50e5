// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A smooth closed surface without symmetries at any resolution: a torus with waves, given by a formula.

#ifndef GEODESIC_OFFSET_BENCHMARK_WAVY_TORUS_H
#define GEODESIC_OFFSET_BENCHMARK_WAVY_TORUS_H

#include <CGAL/squared_distance_3.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace benchmark {

/// Mesh of about `n` vertices, all on the surface: a grid in the two angles, jittered within the surface, with each square
/// split by its shorter diagonal.
template <class Mesh>
class Wavy_torus
{
public:
  typedef typename Mesh::Point Point;
  typedef typename Mesh::Vertex_index Vertex_index;

  explicit Wavy_torus(std::size_t n, unsigned seed = 1)
    : m_along(rounded(std::sqrt(2.5 * static_cast<double>(n)))),
      m_around(rounded(static_cast<double>(n) / static_cast<double>(m_along)))
  {
    mesh.reserve(static_cast<size_type>(size()), static_cast<size_type>(3 * size()), static_cast<size_type>(2 * size()));
    std::mt19937 random(seed);
    const auto jitter = [&] { return 0.5 * (static_cast<double>(random()) / 4294967296.0 - 0.5); };
    for (std::size_t i = 0; i < m_along; ++i)
      for (std::size_t j = 0; j < m_around; ++j)
      {
        const double s = static_cast<double>(i) + jitter(), t = static_cast<double>(j) + jitter();
        mesh.add_vertex(point(turn * s / static_cast<double>(m_along), turn * t / static_cast<double>(m_around)));
      }
    for (std::size_t i = 0; i < m_along; ++i)
      for (std::size_t j = 0; j < m_around; ++j)
        add_square(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  }

  /// `count` vertices all over the surface, near the same points at every resolution.
  std::vector<Vertex_index> spread_vertices(std::size_t count) const
  {
    std::vector<Vertex_index> result;
    for (std::size_t k = 0; k < count; ++k)
    {
      // a sequence of low discrepancy
      const double s = std::fmod(0.1 + 0.7548776662466927 * static_cast<double>(k), 1.);
      const double t = std::fmod(0.3 + 0.5698402909980532 * static_cast<double>(k), 1.);
      result.push_back(vertex(static_cast<std::size_t>(s * static_cast<double>(m_along)),
                              static_cast<std::size_t>(t * static_cast<double>(m_around))));
    }
    return result;
  }

  Mesh mesh;

private:
  typedef typename Mesh::size_type size_type;
  static constexpr double turn = 6.283185307179586;

  static std::size_t rounded(double x) { return static_cast<std::size_t>(std::lround(x)); }

  // a: the angle along the tube, b: the angle around it
  static Point point(double a, double b)
  {
    const double minor =
      0.4 * (1 + 0.15 * std::sin(3 * a + b + 0.4) + 0.1 * std::sin(2 * b - 5 * a + 1.3) + 0.05 * std::sin(4 * b + 7 * a + 2.1));
    const double distance = 1 + 0.1 * std::sin(2 * a + 0.7) + minor * std::cos(b);
    const double height = 0.2 * std::sin(a + 0.3) + 0.1 * std::sin(3 * a) + minor * std::sin(b);
    return Point(distance * std::cos(a), distance * std::sin(a), height);
  }

  std::size_t size() const { return m_along * m_around; }

  Vertex_index vertex(std::size_t i, std::size_t j) const
  {
    return Vertex_index(static_cast<size_type>(i % m_along * m_around + j % m_around));
  }

  void add_square(Vertex_index a, Vertex_index b, Vertex_index c, Vertex_index d)
  {
    if (CGAL::squared_distance(mesh.point(a), mesh.point(c)) < CGAL::squared_distance(mesh.point(b), mesh.point(d)))
    {
      mesh.add_face(a, b, c);
      mesh.add_face(a, c, d);
    }
    else
    {
      mesh.add_face(a, b, d);
      mesh.add_face(b, c, d);
    }
  }

  std::size_t m_along, m_around;
};

} // namespace benchmark

#endif // GEODESIC_OFFSET_BENCHMARK_WAVY_TORUS_H
