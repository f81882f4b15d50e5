// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The class, with kept windows, and a path.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/boost/graph/generators.h>

#include <iterator>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;

int main()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  Geodesic geodesic(mesh);
  geodesic.add_source_point(Mesh::Vertex_index(0));
  geodesic.build(CGAL::parameters::keep_windows(true));
  std::vector<Point> path;
  geodesic.shortest_path_points_to_sources(geodesic.locate(Point(0, 0.4, 0.3)), std::back_inserter(path));
  return path.size() > 1 ? 0 : 1;
}
