// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A surface given by the lengths of its edges: the flat torus, a unit square whose opposite sides are joined. It embeds
// nowhere in space as a mesh of this shape, and the points of the mesh are not read.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>

#include <cmath>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

int main()
{
  const unsigned n = 20; // n x n small squares, each of two triangles
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for(unsigned i = 0; i < n * n; ++i) vertices.push_back(mesh.add_vertex(Point(0, 0, 0)));
  const auto at = [&](unsigned i, unsigned j) { return vertices[(i % n) * n + j % n]; };
  for(unsigned i = 0; i < n; ++i)
    for(unsigned j = 0; j < n; ++j)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }

  const auto length = mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
  for(Mesh::Edge_index e : mesh.edges())
  {
    const unsigned v = mesh.vertex(e, 0).idx(), w = mesh.vertex(e, 1).idx();
    const bool is_diagonal = v / n != w / n && v % n != w % n;
    length[e] = (is_diagonal ? std::sqrt(2.0) : 1.0) / n;
  }

  const auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  CGAL::geodesic_distances(mesh, at(0, 0), distance, CGAL::parameters::edge_length_map(length));
  std::cout << "to the centre of the square: " << distance[at(n / 2, n / 2)] << ", half of its diagonal\n"
            << "to the vertex before the source: " << distance[at(0, n - 1)] << ", one edge" << std::endl;
  return 0;
}
