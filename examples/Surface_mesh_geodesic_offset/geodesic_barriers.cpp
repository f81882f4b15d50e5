// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A pocket with an island and a clamp on a plate: the faces of the pocket are a mesh of their own, and no path crosses the clamp.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_polylines.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Mesh_traits;
typedef CGAL::Geodesic_mesh<Mesh_traits> On_mesh;
typedef CGAL::Face_filtered_graph<Mesh> Region;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Region> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;
namespace parameters = CGAL::parameters;

// The corners of a square of side 2r around (x, y)
std::vector<Point> square(double x, double y, double r)
{
  return {Point(x - r, y - r, 0), Point(x + r, y - r, 0), Point(x + r, y + r, 0), Point(x - r, y + r, 0)};
}

int main()
{
  Mesh mesh;
  CGAL::make_grid(
    7, 7, mesh, [](std::size_t i, std::size_t j) { return Point(10. / 7 * double(i), 10. / 7 * double(j), 0); }, true);

  //! [Barriers]
  // the curves become edges
  std::vector<On_mesh::Polyline> curves;
  {
    const On_mesh on_mesh(mesh); // not to be used after the mesh changes
    curves.push_back(on_mesh.locate_polyline(square(5, 5, 4), parameters::is_closed(true))); // pocket
    curves.push_back(on_mesh.locate_polyline(square(5, 5, 1), parameters::is_closed(true))); // island
    curves.push_back(on_mesh.locate_polyline(std::vector<Point>{Point(1.5, 4, 0), Point(1.5, 6, 0)})); // clamp
  }
  auto is_barrier = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_barrier", false).first;
  CGAL::split_along_polylines(mesh, curves, parameters::edge_is_constrained_map(is_barrier));

  // the faces that are connected with one in the pocket without crossing the curves
  const Mesh::Face_index inside = On_mesh(mesh).locate(Point(2, 3, 0)).first;
  std::vector<Mesh::Face_index> faces;
  CGAL::Polygon_mesh_processing::connected_component(inside, mesh, std::back_inserter(faces),
                                                     parameters::edge_is_constrained_map(is_barrier));
  const Region pocket(mesh, faces);

  // the border of the pocket is the source; the clamp is a barrier
  Geodesic geodesic(pocket, parameters::edge_is_constrained_map(is_barrier));
  geodesic.add_source_boundary();
  std::vector<Geodesic::Offset_curve> offsets;
  geodesic.build_with_offset_curves({1.}, std::back_inserter(offsets));
  //! [Barriers]

  double length = 0;
  for(const Geodesic::Offset_curve& c : offsets) length += c.length();
  // The offset of the pocket without a part of length 2 behind the clamp, where two quarter circles about its ends lead to it, and
  // the offset of the island.
  const double expected = (24 - 2 + CGAL_PI / 2) + (8 + 2 * CGAL_PI);
  std::cout << "length of the offset: " << length << std::endl;
  return std::abs(length - expected) <= 1e-9 * expected ? 0 : 1;
}
