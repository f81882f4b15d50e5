// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A translation unit of a user's program, compiled once per entry of units.h, whose name is the macro UNIT. The header of the package
// comes first: headers must not depend on other includes.

#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iterator>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;

#if defined(EXPECTS_LIBRARY) != defined(CGAL_GEODESIC_OFFSET_COMPILED)
#error "the target must define the macro of the compiled library, and no other target may"
#endif

// On the unit square, from one corner: the distance of the opposite corner, sqrt(2), and the length of the offset at 1/2, a quarter
// circle from side to side; then the distances of all vertices of a wavy grid from a polyline.
std::vector<double> UNIT()
{
  std::vector<double> results;
  Mesh square;
  const Mesh::Vertex_index a = square.add_vertex(Point_3(0, 0, 0));
  const Mesh::Vertex_index b = square.add_vertex(Point_3(1, 0, 0));
  const Mesh::Vertex_index c = square.add_vertex(Point_3(1, 1, 0));
  const Mesh::Vertex_index d = square.add_vertex(Point_3(0, 1, 0));
  square.add_face(a, b, d);
  square.add_face(b, c, d);
  Geodesic on_square(square);
  on_square.add_source_point(a);
  on_square.build(CGAL::parameters::keep_windows(true));
  results.push_back(on_square.distance_to_sources(c));
  std::vector<Geodesic::Offset_curve> curves;
  on_square.offset_curves(0.5, std::back_inserter(curves));
  results.push_back(curves.size() == 1 && !curves.front().is_closed() ? curves.front().length() : -1);

  Mesh grid;
  const int n = 12;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) grid.add_vertex(Point_3(i, j, std::sin(0.9 * i) * std::cos(1.1 * j)));
  const auto vertex = [](int i, int j) { return Mesh::Vertex_index((n + 1) * i + j); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
      grid.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      grid.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  Geodesic on_grid(grid);
  on_grid.add_source_polyline(on_grid.locate_polyline(std::vector<Point_3>{Point_3(2.3, 1.2, 0), Point_3(8.1, 7.4, 0)}));
  on_grid.build(CGAL::parameters::distance_limit(100));
  for (const Mesh::Vertex_index v : grid.vertices()) results.push_back(on_grid.distance_to_sources(v));
  return results;
}
