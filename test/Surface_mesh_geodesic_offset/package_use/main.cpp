// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A user's first program, with a result in closed form: on the unit square, from one corner, the opposite corner is at
// distance sqrt(2), and the offset at 1/2 is a quarter circle from side to side.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic_offset;

// Defined in second_unit.cpp, which includes the same headers: they must link together.
std::size_t number_of_sources(const Geodesic_offset& geodesic_offset);

// Distances are correct up to rounding; a level is cut below itself by a fraction of 2^-42.
bool is_near(double found, double expected, double tolerance = 1e-14) { return std::abs(found - expected) <= tolerance; }

int main()
{
  Mesh square;
  const Mesh::Vertex_index a = square.add_vertex(Point_3(0, 0, 0));
  const Mesh::Vertex_index b = square.add_vertex(Point_3(1, 0, 0));
  const Mesh::Vertex_index c = square.add_vertex(Point_3(1, 1, 0));
  const Mesh::Vertex_index d = square.add_vertex(Point_3(0, 1, 0));
  square.add_face(a, b, d);
  square.add_face(b, c, d);

  Geodesic_offset geodesic_offset(square);
  geodesic_offset.add_source_point(a);
  geodesic_offset.build(CGAL::parameters::keep_windows(true));
  const double distance = geodesic_offset.distance_to_sources(c);

  std::vector<Geodesic_offset::Offset_curve> curves;
  geodesic_offset.offset_curves(0.5, std::back_inserter(curves));

  const double quarter_circle = std::atan(1.0);
  const bool is_right = is_near(distance, std::sqrt(2.0)) && number_of_sources(geodesic_offset) == 1 && curves.size() == 1 &&
                        !curves.front().is_closed() && is_near(curves.front().length(), quarter_circle, 3e-13);
  std::cout << "distance " << distance << ", " << curves.size() << " offset curve(s)\n";
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
