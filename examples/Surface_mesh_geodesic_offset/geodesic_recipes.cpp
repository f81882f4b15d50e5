// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The recipes of the manual: one function for each. All work on a square plate, so that their results are known.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_polylines.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/function_property_map.hpp>

#include <chrono>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <vector>

//! [Types]
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;
namespace parameters = CGAL::parameters;
//! [Types]

int failures = 0;

void expect(const char* recipe, double value, double right)
{
  std::cout << recipe << ": " << value << std::endl;
  if(!(std::abs(value - right) <= 1e-9 * std::abs(right)))
  {
    ++failures;
    std::cerr << recipe << ": " << right << " was expected" << std::endl;
  }
}

double length(const std::vector<Geodesic::Offset_curve>& curves)
{
  double sum = 0;
  for(const Geodesic::Offset_curve& c : curves) sum += c.length();
  return sum;
}

// The corners of a square of side 2r around (x, y), counterclockwise.
std::vector<Point> square(double x, double y, double r)
{
  return {Point(x - r, y - r, 0), Point(x + r, y - r, 0), Point(x + r, y + r, 0), Point(x - r, y + r, 0)};
}

void pocket_with_islands(const Mesh& mesh)
{
  //! [Pocket]
  Geodesic geodesic(mesh);
  const auto closed = parameters::is_closed(true);
  std::map<std::size_t, CGAL::Offset_side> sides; // by the id of the source
  sides[geodesic.add_source_polyline(geodesic.locate_polyline(square(5, 5, 4), closed))] = CGAL::Offset_side::INSIDE;
  sides[geodesic.add_source_polyline(geodesic.locate_polyline(square(5, 5, 1), closed))] = CGAL::Offset_side::OUTSIDE;
  std::vector<Geodesic::Offset_curve> curves;
  geodesic.build_with_offset_curves({0.5}, std::back_inserter(curves), parameters::offset_side(sides));
  //! [Pocket]
  expect("pocket with an island", length(curves), 4 * 7 + 4 * 2 + CGAL_PI);
}

void half_a_step_at_the_border(const Mesh& mesh)
{
  //! [Half]
  const double step = 2;
  Geodesic geodesic(mesh);
  geodesic.add_source_boundary();
  std::vector<Geodesic::Offset_curve> curves; // at 1, 3, 5, ..., as far as the surface extends
  geodesic.build_with_offset_curves(
    CGAL::Offset_levels<double>::equally_spaced(step, CGAL::Offset_levels<double>::unlimited, step / 2),
    std::back_inserter(curves));
  //! [Half]
  expect("half a step at the border", length(curves), 4 * 8 + 4 * 4);
}

void one_side(const Mesh& mesh)
{
  //! [Side]
  Geodesic geodesic(mesh);
  geodesic.add_source_polyline(geodesic.locate_polyline(std::vector<Point>{Point(0, 5, 0), Point(10, 5, 0)}));
  std::vector<Geodesic::Offset_curve> curves; // on the left, seen along the polyline from outside of the surface
  geodesic.build_with_offset_curves({2.}, std::back_inserter(curves), parameters::offset_side(CGAL::Offset_side::LEFT));
  //! [Side]
  std::vector<Point> points;
  for(const Geodesic::Offset_curve& c : curves) c.points(0.01, std::back_inserter(points));
  expect("one side", points.empty() ? 0 : points.front().y(), 7);
  expect("one side", length(curves), 10);
}

void distance_at_a_point_in_space(const Mesh& mesh)
{
  //! [Point]
  Geodesic geodesic(mesh);
  geodesic.add_source_point(geodesic.locate(Point(1, 1, 0)));
  const Geodesic::Field field = geodesic.build(parameters::keep_windows(true)); // for points that are no vertices
  const auto [location, height] = geodesic.locate_with_distance(Point(4, 5, 0.1));
  const double distance = field.distance_to_sources(location);
  //! [Point]
  expect("distance at a point in space", distance, 5);
  expect("its distance from the surface", height, 0.1);
}

void cancel(const Mesh& mesh)
{
  //! [Cancel]
  Geodesic geodesic(mesh);
  geodesic.add_source_point(*mesh.vertices().begin());
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  const auto visitor = [&](double part) {
    std::cerr << "\rdone: " << int(100 * part) << " %";
    return std::chrono::steady_clock::now() < end; // false stops the build
  };
  const Geodesic::Field field = geodesic.build(parameters::visitor(visitor));
  const double known = field.is_cancelled() ? field.covered_distance() : field.infinity(); // right up to here
  //! [Cancel]
  std::cerr << std::endl;
  expect("cancel", known == field.infinity(), 1);
}

void own_point_map(const Mesh& mesh)
{
  //! [Map]
  // the plate in inches, without a copy
  const auto inches = boost::make_function_property_map<Vertex>([&](Vertex v) {
    return Point(mesh.point(v).x() / 25.4, mesh.point(v).y() / 25.4, mesh.point(v).z() / 25.4);
  });
  std::map<Vertex, double> distance;
  CGAL::geodesic_distances(mesh, *mesh.vertices().begin(), boost::make_assoc_property_map(distance),
                           parameters::vertex_point_map(inches));
  //! [Map]
  double largest = 0;
  for(const auto& d : distance) largest = (std::max)(largest, d.second);
  expect("own point map", largest, 10 * std::sqrt(2.) / 25.4);
}

void ribbon(Mesh mesh)
{
  //! [Ribbon]
  const std::vector<Point> line = {Point(2, 10.2, 0), Point(18, 10.2, 0)};
  const std::vector<double> starts = {4, 0};
  CGAL::split_along_polylines(mesh, std::vector<Geodesic::Polyline>{Geodesic(mesh).locate_polyline(line)}); // edges of it
  Geodesic geodesic(mesh);
  geodesic.add_source_polyline(geodesic.locate_polyline(line, parameters::start_values(starts)));
  std::vector<Geodesic::Offset_curve> curves;
  geodesic.build_with_offset_curves({6.}, std::back_inserter(curves));
  //! [Ribbon]
  double widest = 0; // radius of the round end
  for(const Geodesic::Offset_curve& c : curves)
    for(const auto& piece : c.pieces())
      if(piece.is_arc()) widest = (std::max)(widest, piece.radius());
  expect("ribbon", widest, 6);
}

void matrix(const Mesh& mesh)
{
  //! [Matrix]
  const std::vector<Vertex> all(mesh.vertices().begin(), mesh.vertices().end());
  double diameter = 0;
  CGAL::geodesic_distance_matrix(mesh, all, all, [&](std::size_t, const std::vector<double>& row) {
    diameter = (std::max)(diameter, *std::max_element(row.begin(), row.end()));
  });
  //! [Matrix]
  expect("matrix", diameter, 10 * std::sqrt(2.));
}

void which_source(const Mesh& mesh)
{
  //! [Which]
  Geodesic geodesic(mesh);
  const std::size_t first = geodesic.add_source_point(geodesic.locate(Point(2, 2, 0)));
  geodesic.add_source_point(geodesic.locate(Point(8, 8, 0)));
  geodesic.build(parameters::keep_windows(true));
  const auto nearest = geodesic.nearest_source(geodesic.locate(Point(3, 4, 0)));
  const bool is_first = nearest && nearest->source == first;
  //! [Which]
  expect("which source", is_first, 1);
}

int main()
{
  Mesh mesh;
  CGAL::make_grid(
    10, 10, mesh, [](std::size_t i, std::size_t j) { return Point(double(i), double(j), 0); }, true);
  pocket_with_islands(mesh);
  half_a_step_at_the_border(mesh);
  one_side(mesh);
  distance_at_a_point_in_space(mesh);
  cancel(mesh);
  own_point_map(mesh);
  which_source(mesh);
  matrix(mesh);
  Mesh large;
  CGAL::make_grid(
    20, 20, large, [](std::size_t i, std::size_t j) { return Point(double(i), double(j), 0); }, true);
  ribbon(large);
  return failures == 0 ? 0 : 1;
}
