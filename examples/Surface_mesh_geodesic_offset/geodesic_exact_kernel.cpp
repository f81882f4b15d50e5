// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact distances: with a kernel that has exact square roots, the distance of opposite corners of a cube equals the square
// root of 5. The number type needs the header Radical_numbers.h.

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/Radical_numbers.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt Kernel;
typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;

int main()
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), // lower face
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), mesh);
  const std::vector<Mesh::Face_index> squares(mesh.faces().begin(), mesh.faces().end());
  for(Mesh::Face_index f : squares) CGAL::Euler::split_face(mesh.halfedge(f), mesh.next(mesh.next(mesh.halfedge(f))), mesh);

  Geodesic geodesic(mesh);
  geodesic.add_source_point(Mesh::Vertex_index(0));
  geodesic.build();

  const Kernel::FT distance = geodesic.distance_to_sources(Mesh::Vertex_index(7));
  const bool is_exact = distance == CGAL::sqrt(Kernel::FT(5));
  std::cout << "distance of opposite corners: " << CGAL::to_double(distance) << (is_exact ? ", exactly" : ", not exactly")
            << " the square root of 5" << std::endl;
  return is_exact ? 0 : 1;
}
