// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Voronoi diagram of vertices.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/construct_geodesic_voronoi_diagram.h>
#include <CGAL/boost/graph/generators.h>

#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

int main()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  const std::vector<Mesh::Vertex_index> sources{Mesh::Vertex_index(0), Mesh::Vertex_index(3)};
  return CGAL::construct_geodesic_voronoi_diagram(mesh, sources).number_of_curves() > 0 ? 0 : 1;
}
