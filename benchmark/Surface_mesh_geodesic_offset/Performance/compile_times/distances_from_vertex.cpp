// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances from a vertex.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>
#include <CGAL/boost/graph/generators.h>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

int main()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  const auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0).first;
  CGAL::geodesic_distances(mesh, Mesh::Vertex_index(0), distance);
  return distance[Mesh::Vertex_index(1)] > 0 ? 0 : 1;
}
