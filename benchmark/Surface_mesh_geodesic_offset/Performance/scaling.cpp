// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Growth of time as the answer grows, as a Markdown table: per row of the list below, and per size, the number of items of the
// answer (pieces of curves, windows, sides) and the seconds, and the exponents e of seconds = c answer^e between consecutive sizes and of the
// best fit over all sizes. All exponents are about 1 if the time grows with the answer.
//
//   scaling [WORD]         only the rows whose name contains the word

#include "fastest_run.h"
#include "generated_flat_meshes.h"
#include "geodesic_types.h"
#include "growth_exponent.h"
#include "planar_polyline.h"
#include "wavy_torus.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace test;

struct Row
{
  std::string name;
  std::vector<std::size_t> sizes;
  std::function<double(std::size_t)> run; // returns the number of items of the answer for a size
};

typedef std::vector<Point_2> Polygon;

Point_2 around(const Point_2& center, double radius, double turn)
{
  return center + radius * Vector_2(std::cos(2 * CGAL_PI * turn), std::sin(2 * CGAL_PI * turn));
}

// Number of pieces of offsets in a unit square of two triangles.
double offsets(const std::vector<Polygon>& lines, bool closed, double spacing, std::size_t levels)
{
  const Planar_mesh plate(planar_grid(1, 1));
  Geodesic geodesic(plate.data.mesh);
  for (const Polygon& line : lines) plate.add(geodesic, line, closed);
  geodesic.build_with_offset_curves_by_distance(CGAL::Offset_levels<double>::equally_spaced(spacing, levels),
                                                [](double, std::vector<Geodesic::Offset_curve>&&) {});
  return static_cast<double>(geodesic.statistics().pieces);
}

// A closed curve of n points with coves.
Polygon coves(std::size_t n)
{
  Polygon result;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double t = double(i) / double(n);
    const double radius = 0.25 + 0.1 * std::sin(10 * CGAL_PI * t) + 0.03 * std::sin(62 * CGAL_PI * t);
    result.push_back(around(Point_2(0.5, 0.5), radius, t));
  }
  return result;
}

// n contours of 30 points in rows.
double contours(std::size_t n)
{
  const std::size_t side = static_cast<std::size_t>(std::lround(std::sqrt(double(n))));
  const double cell = 1. / double(side);
  std::vector<Polygon> lines(side * side);
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (int j = 0; j < 30; ++j)
      lines[i].push_back(around(Point_2((double(i % side) + 0.5) * cell, (double(i / side) + 0.5) * cell),
                                0.3 * cell * (1 + 0.3 * std::sin(0.2 * CGAL_PI * j + double(i))), j / 30.));
  return offsets(lines, true, 0.08 * cell, 1);
}

// n segments of the given length, at random.
double segments(std::size_t n, double length, double level)
{
  Random random(7);
  std::vector<Polygon> lines;
  while (lines.size() < n)
  {
    const Point_2 p(uniform(random), uniform(random)), q = around(p, length, uniform(random));
    if (q.x() > 0 && q.x() < 1 && q.y() > 0 && q.y() < 1) lines.push_back({p, q});
  }
  return offsets(lines, false, level, 1);
}

// Windows from a vertex of a ring of n long faces around a hole: each vertex of the hole is a pseudo-source.
double ring(std::size_t n)
{
  Soup soup;
  for (const double radius : {1., 2.})
    for (std::size_t i = 0; i < n; ++i)
    {
      const Point_2 p = around(Point_2(0, 0), radius, double(i) / double(n));
      soup.points.push_back(Point_3(p.x(), p.y(), 0));
    }
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t j = (i + 1) % n;
    soup.add_triangle({i, n + i, n + j});
    soup.add_triangle({i, n + j, j});
  }
  const Generated_mesh<Surface_mesh> data(soup);
  Geodesic geodesic(data.mesh);
  geodesic.add_source_point(data.vertices[0]);
  geodesic.build();
  return static_cast<double>(geodesic.statistics().windows_propagated);
}

// Windows from a contour with noise in one of two faces.
double distances_from_contour(std::size_t n)
{
  Random random(3);
  Polygon line;
  for (std::size_t i = 0; i < n; ++i)
    line.push_back(around(Point_2(0.6, 0.3), 0.2 + 0.004 * uniform(random, -1, 1), double(i) / double(n)));
  const Planar_mesh plate(planar_grid(1, 1));
  Geodesic geodesic(plate.data.mesh);
  plate.add(geodesic, line, true);
  geodesic.build();
  return static_cast<double>(geodesic.statistics().windows_created);
}

// Pieces of the Voronoi diagram of 10 vertices of a smooth surface with n vertices.
double diagram(std::size_t n)
{
  const benchmark::Wavy_torus<Surface_mesh> shape(n);
  Geodesic geodesic(shape.mesh);
  for (const auto v : shape.spread_vertices(10)) geodesic.add_source_point(v);
  geodesic.build(CGAL::parameters::keep_windows(true));
  std::size_t pieces = 0;
  const auto result = geodesic.field().voronoi_diagram();
  for (const auto& c : result.curves()) pieces += c.number_of_pieces();
  return static_cast<double>(pieces);
}

// Vertices of a grid on a side of a polyline.
double sides(std::size_t n)
{
  const std::size_t k = static_cast<std::size_t>(std::lround(std::sqrt(double(n))));
  const Planar_mesh plate(planar_grid(k, k));
  Geodesic geodesic(plate.data.mesh);
  std::vector<Geodesic::Face_location> line;
  for (const Point_2& p : {Point_2(0.21, 0.32), Point_2(0.53, 0.61), Point_2(0.82, 0.43)})
    line.push_back(plate.location(Point_2(double(k) * p.x(), double(k) * p.y())));
  geodesic.add_source_polyline(geodesic.join_polyline(line));
  geodesic.build();
  std::size_t result = 0;
  for (const auto v : vertices(plate.data.mesh)) result += geodesic.signed_distance_to_sources(v) ? 1 : 0;
  return static_cast<double>(result);
}

const std::vector<Row>& rows()
{
  static const std::vector<Row> result = {
    {"offset of a contour", {1000, 4000, 16000}, [](std::size_t n) { return offsets({coves(n)}, true, 0.02, 1); }},
    {"20 offsets of a contour", {500, 2000, 8000}, [](std::size_t n) { return offsets({coves(n)}, true, 0.005, 20); }},
    {"offset of contours of 30 points", {64, 256, 1024}, contours},
    {"offset of separate segments",
     {500, 2000, 8000},
     [](std::size_t n) { return segments(n, 0.5 / std::sqrt(double(n)), 0.3 / std::sqrt(double(n))); }},
    {"distances around a hole of long faces", {500, 1000, 2000, 4000}, ring},
    {"distances from a contour", {4000, 16000, 64000}, distances_from_contour},
    {"Voronoi diagram of 10 vertices", {12500, 50000, 200000}, diagram},
    {"sides of vertices", {10000, 40000, 160000}, sides},
    {"offset of crossing segments", {50, 100, 200, 400}, [](std::size_t n) { return segments(n, 0.6, 0.2 / double(n)); }},
  };
  return result;
}

void run(const Row& row)
{
  std::vector<double> answers, seconds;
  for (const std::size_t n : row.sizes)
  {
    const benchmark::Measured_run result =
      benchmark::fastest_run([&](std::vector<double>& figures, std::uint64_t&) { figures = {row.run(n)}; });
    answers.push_back(result.distances.front());
    seconds.push_back(result.seconds);
    std::cout << "| " << row.name << " | " << n << " | " << std::fixed << std::setprecision(0) << answers.back() << " | "
              << std::setprecision(4) << seconds.back() << " | " << std::setprecision(2);
    if (answers.size() > 1)
      std::cout << benchmark::growth_exponent({answers.end() - 2, answers.end()}, {seconds.end() - 2, seconds.end()});
    std::cout << " | ";
    if (answers.size() == row.sizes.size()) std::cout << benchmark::growth_exponent(answers, seconds);
    std::cout << " |" << std::endl;
  }
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    std::cout << "| row | size | answer | seconds | exponent | best fit |\n|---|---|---|---|---|---|\n";
    for (const Row& row : rows())
      if (argc < 2 || row.name.find(argv[1]) != std::string::npos) run(row);
  }
  catch (const std::exception& e)
  {
    std::cerr << "scaling: " << e.what() << '\n';
    return 1;
  }
  return 0;
}
