// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Small meshes with sources, levels and options from bytes, which libFuzzer changes one by one. Half of the meshes are grown
// triangle by triangle; their coordinates are mostly on a coarse grid, where paths tie, or displaced by an arbitrarily small
// amount. The others are cases of ../certified_cases.h, of which a few vertices are displaced.

#ifndef GEODESIC_OFFSET_TEST_FUZZ_CASE_H
#define GEODESIC_OFFSET_TEST_FUZZ_CASE_H

#include "../certified_cases.h"
#include "../geodesic_types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace test {

/// Ends the program, which libFuzzer reports.
[[noreturn]] inline void fail_fuzzing(const std::string& text)
{
  std::cerr << text << std::endl;
  std::abort();
}

/// Numbers from bytes; zeros after the last byte.
class Fuzz_bytes
{
public:
  Fuzz_bytes(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  bool is_empty() const { return next_ == end_; }
  unsigned byte() { return is_empty() ? 0 : *next_++; }
  std::size_t index(std::size_t n) { return byte() % n; }
  bool flag() { return byte() % 2 != 0; }

  /// From -1 to 1: a multiple of 1/32, displaced by 0 or 1e-16 to 1e-1.
  double coordinate()
  {
    const unsigned b = byte();
    const double x = (double(b % 65) - 32) / 32;
    if (b < 195) return x;
    const unsigned c = byte();
    return x + (c % 2 == 0 ? -1 : 1) * std::pow(10, -1. - double(c / 2 % 16));
  }
  /// From 0 to 1: a multiple of 1/16, or within 1e-12 to 1e-1 of 0 or 1.
  double weight()
  {
    const unsigned b = byte();
    if (b < 200) return double(b % 17) / 16;
    const double x = std::pow(10, -1. - double(b % 12));
    return b % 2 == 0 ? x : 1 - x;
  }

private:
  const std::uint8_t *next_, *end_;
};

/// Mesh of at most some 30 triangles with a few sources.
class Fuzz_case
{
public:
  typedef Certified_case::Location Location;

  explicit Fuzz_case(Fuzz_bytes& bytes) : bytes_(bytes)
  {
    const std::size_t kind = bytes_.index(4);
    if (kind < 2) add_mesh();
    else
    {
      const unsigned high = bytes_.byte(), seed = 256 * high + bytes_.byte();
      case_ = kind == 2 ? Certified_cases::general(seed) : Certified_cases::adversarial(seed);
      case_.queries.clear();
      displace_vertices();
      if (bytes_.flag()) case_.source_vertices.clear(), case_.sources.clear();
    }
    const std::size_t least = case_.source_vertices.empty() && case_.sources.empty() ? 1 : 0;
    const std::size_t sources = least + bytes_.index(3);
    for (std::size_t i = 0; i < sources; ++i)
      if (bytes_.flag()) case_.source_vertices.push_back(vertex());
      else case_.sources.push_back(location());
    for (int i = 0; i < 3; ++i) case_.queries.push_back(location());
  }

  const Certified_case& certified_case() const { return case_; }

  /// Largest absolute value of a coordinate.
  double size() const
  {
    double result = 0;
    for (const auto& p : case_.points)
      for (const double x : p) result = (std::max)(result, std::abs(x));
    return result;
  }

  /// Smallest ratio of the height of a face to its longest side.
  double flatness() const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& t : case_.triangles)
    {
      const Point_3 p = point(t[0]), q = point(t[1]), r = point(t[2]);
      const double longest =
        (std::max)({CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p)});
      if (!(longest > 0)) return 0;
      least = (std::min)(least, std::sqrt(CGAL::cross_product(q - p, r - p).squared_length()) / longest);
    }
    return least;
  }

private:
  Point_3 point(std::size_t v) const { return Point_3(case_.points[v][0], case_.points[v][1], case_.points[v][2]); }
  std::size_t vertex() { return case_.triangles[bytes_.index(case_.triangles.size())][bytes_.index(3)]; }

  // By up to 1/10 of the size.
  void displace_vertices()
  {
    const double scale = size();
    for (std::size_t n = bytes_.index(5); n > 0; --n)
    {
      double& x = case_.points[bytes_.index(case_.points.size())][bytes_.index(3)];
      const unsigned b = bytes_.byte();
      x += (b % 2 == 0 ? -scale : scale) * std::pow(10, -1. - double(b / 2 % 16));
    }
  }

  // Connected, of up to 12 triangles; the border is one cycle, or the mesh is closed.
  void add_mesh()
  {
    for (int i = 0; i < 3; ++i) add_point();
    case_.triangles.push_back({0, 1, 2});
    std::vector<std::size_t> border = {0, 1, 2}; // along the halfedges of the faces
    const std::size_t triangles = 1 + bytes_.index(12);
    while (case_.triangles.size() < triangles)
    {
      const std::size_t n = border.size(), i = bytes_.index(n), j = (i + 1) % n, k = (i + 2) % n;
      const std::size_t a = border[i], b = border[j], c = border[k];
      if (bytes_.index(3) == 0 && (n > 3 ? !has_edge(a, c) : case_.triangles.size() > 1))
      { // between two edges of the border; with only two edges this closes the mesh
        case_.triangles.push_back({c, b, a});
        if (n == 3) return;
        border.erase(border.begin() + std::ptrdiff_t(j));
      }
      else
      {
        case_.triangles.push_back({b, a, case_.points.size()});
        border.insert(border.begin() + std::ptrdiff_t(i) + 1, case_.points.size());
        add_point();
      }
    }
  }

  void add_point()
  {
    const double x = bytes_.coordinate(), y = bytes_.coordinate();
    case_.points.push_back({x, y, bytes_.flag() ? bytes_.coordinate() : 0});
  }

  bool has_edge(std::size_t p, std::size_t q) const
  {
    for (const auto& t : case_.triangles)
      if (std::count(t.begin(), t.end(), p) + std::count(t.begin(), t.end(), q) == 2) return true;
    return false;
  }

  // Nonzero weights exceed the tolerance for zero.
  Location location()
  {
    Location l{bytes_.index(case_.triangles.size()), {0, 0, 0}};
    const std::size_t k = bytes_.index(3);
    const double s = bytes_.weight(), t = bytes_.flag() ? bytes_.weight() : 0;
    l.weights[k] = s * (1 - t);
    l.weights[(k + 1) % 3] = (1 - s) * (1 - t);
    l.weights[(k + 2) % 3] = t;
    const double sum = l.weights[0] + l.weights[1] + l.weights[2];
    for (double& w : l.weights) w = w < 2e-13 * sum ? 0 : w;
    return l;
  }

  Fuzz_bytes& bytes_;
  Certified_case case_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_FUZZ_CASE_H
