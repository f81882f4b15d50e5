// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves of a milling machine for a planar pocket with two islands: the elements of offset curves as G1, G2 and G3.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;
typedef Geodesic::Offset_curve Curve;

// The material is on the left of the curve. A pass in the other direction has it on the right.
void print_element(const Curve::Element& e, bool is_reversed)
{
  const Point from = is_reversed ? e.end() : e.start(), to = is_reversed ? e.start() : e.end();
  const bool is_counterclockwise = (e.normal().z() > 0) != is_reversed; // seen from above
  std::cout << (e.is_segment() ? "G1" : is_counterclockwise ? "G3" : "G2") << " X" << to.x() << " Y" << to.y();
  if(e.is_arc()) std::cout << " I" << e.center().x() - from.x() << " J" << e.center().y() - from.y();
  std::cout << '\n';
}

void print_curve(const Curve& curve, bool is_reversed)
{
  std::vector<Curve::Element> elements = curve.elements(0);
  if(is_reversed) std::reverse(elements.begin(), elements.end());
  const Point start = is_reversed ? elements.front().end() : elements.front().start();
  std::cout << "(distance " << curve.distance() << ": " << elements.size() << " moves, " << curve.number_of_pieces()
            << " pieces in faces)\nG0 X" << start.x() << " Y" << start.y() << '\n';
  for(const Curve::Element& e : elements) print_element(e, is_reversed);
}

int main()
{
  Mesh plate; // 100 x 60, of 3000 triangles
  CGAL::make_grid(
    50, 30, plate, [](int i, int j) { return Point(2 * i, 2 * j, 0); }, true);

  // The pocket is on the left: its border is counterclockwise, the islands are clockwise.
  const std::vector<std::vector<Point>> lines = {
    {Point(5, 5, 0), Point(95, 5, 0), Point(95, 55, 0), Point(60, 55, 0), Point(60, 45, 0), Point(5, 45, 0)},
    {Point(20, 18, 0), Point(20, 30, 0), Point(32, 30, 0), Point(32, 18, 0)},
    {Point(70, 20, 0), Point(76, 34, 0), Point(84, 22, 0)}};
  Geodesic geodesic(plate);
  for(const std::vector<Point>& line : lines)
    geodesic.add_source_polyline(geodesic.locate_polyline(line, CGAL::parameters::is_closed(true)));
  geodesic.build();

  std::vector<Curve> curves;
  geodesic.offset_curves(std::vector<double>{3, 6, 9, 12}, std::back_inserter(curves),
                         CGAL::parameters::offset_side(CGAL::Offset_side::LEFT));
  std::cout << std::fixed << std::setprecision(4);
  for(const Curve& curve : curves) print_curve(curve, curve.distance() == 3); // the pass along the material is reversed
  return curves.empty() ? 1 : 0;
}
