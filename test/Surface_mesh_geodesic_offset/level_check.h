// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Check of one level with a known number and length of curves.

#ifndef GEODESIC_OFFSET_TEST_LEVEL_CHECK_H
#define GEODESIC_OFFSET_TEST_LEVEL_CHECK_H

#include "curve_checks.h"
#include "planar_polyline.h"
#include "search_tolerances.h"

#include <array>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace test {

constexpr double pi = CGAL_PI;
constexpr std::array<Diagonals, 4> all_diagonals{
  {Diagonals::forward, Diagonals::backward, Diagonals::alternating, Diagonals::random}};

/// Figures of all calls of `check_level`.
struct Level_totals
{
  static Level_totals& instance()
  {
    static Level_totals totals;
    return totals;
  }
  double worst_length = 0;
  std::size_t levels = 0;
};

inline void print_level_totals()
{
  const Level_totals& totals = Level_totals::instance();
  std::cout.precision(3);
  std::cout << totals.levels << " levels, lengths off by at most " << totals.worst_length << " of themselves" << std::endl;
}

struct Expected
{
  std::size_t curves, closed;
  double length;
  double growth = 0; // derivative of the length with respect to the level
};

typedef std::function<void(Geodesic&)> Add_sources;

// Checks the number of curves and of closed curves, the length, everything in Curve_checker (such as crossings), and
// likewise the curves cut during a build.
inline void check_level(const std::string& name, const test::Surface_mesh& mesh, const Add_sources& add_sources, double level,
                        const Expected& expected)
{
  Report::instance().set_context(name + ", level " + std::to_string(level));
  try
  {
    Geodesic geodesic(mesh);
    add_sources(geodesic);
    geodesic.build(CGAL::parameters::keep_windows(true));
    const Offset_curves kept = offsets(geodesic, level);
    Validation_options options;
    options.probes = 200;
    options.quadrature_faces = 2;
    options.largest_number_of_texts = 2;
    Curve_checker(mesh, geodesic, options).check({level}, kept);
    Offset_curves on_the_way;
    geodesic.build_with_offset_curves(level, std::back_inserter(on_the_way));
    double& worst = Level_totals::instance().worst_length;
    for (const Offset_curves* curves : {&kept, static_cast<const Offset_curves*>(&on_the_way)})
    {
      CHECK_DETAIL(curves->size() == expected.curves, std::to_string(curves->size()) + " curves");
      CHECK_DETAIL(number_of_closed(*curves) == expected.closed, std::to_string(number_of_closed(*curves)) + " closed");
      const double length = total_length(*curves), off = std::abs(length - expected.length);
      if (expected.length > 0) worst = (std::max)(worst, off / expected.length);
      const double allowed =
        Known_level_tolerances::length * expected.length + Known_level_tolerances::level * level * expected.growth;
      CHECK_DETAIL(off <= allowed, values(length, expected.length));
    }
    CHECK(geodesic.statistics().forced_joints == 0);
    ++Level_totals::instance().levels;
  }
  catch (const std::exception& e)
  {
    CHECK_DETAIL(!"an exception was thrown", e.what());
  }
}

typedef Generated_mesh<test::Surface_mesh> Data;

// [0, 4]^2 in squares of side `side`.
struct Square
{
  Square(Diagonals diagonals, double side)
    : n(std::size_t(4 / side)), side(side), plane(planar_grid(n, n, diagonals, side)), mesh(plane.data.mesh)
  {
  }
  test::Surface_mesh::Vertex_index vertex(double x, double y) const
  {
    return plane.data.vertices[std::size_t(y / side) * (n + 1) + std::size_t(x / side)];
  }
  Add_sources vertices(std::vector<Point_2> points) const
  {
    return [=](Geodesic& g) {
      for (const Point_2& p : points) g.add_source_point(vertex(p.x(), p.y()));
    };
  }
  Add_sources polylines(std::vector<std::vector<Point_2>> lines, bool closed = false) const
  {
    return [=](Geodesic& g) {
      for (const auto& l : lines) plane.add(g, l, closed);
    };
  }
  std::size_t n;
  double side;
  Planar_mesh plane;
  const test::Surface_mesh& mesh;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_LEVEL_CHECK_H
