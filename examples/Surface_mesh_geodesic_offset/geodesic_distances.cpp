// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Geodesic distances of all vertices from one vertex and from a point in a face.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.number_of_faces() == 0)
  {
    std::cerr << "Not a triangle mesh: " << filename << std::endl;
    return 1;
  }

  // the first vertex, and the centre of the last face
  const Mesh::Face_index last_face = *std::prev(mesh.faces().end());
  Geodesic geodesic(mesh);
  geodesic.add_source_point(*mesh.vertices().begin());
  geodesic.add_source_point(Geodesic::Face_location(last_face, {1. / 3, 1. / 3, 1. / 3}));
  geodesic.build();

  // all distances in a property map
  Mesh::Property_map<Mesh::Vertex_index, double> distance =
    mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0).first;
  geodesic.vertex_distances(distance);

  Mesh::Vertex_index farthest = *mesh.vertices().begin();
  std::size_t unreachable = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    if(std::isinf(distance[v]))
      ++unreachable;
    else if(distance[v] > distance[farthest])
      farthest = v;
  }
  std::cout << "farthest vertex: " << farthest << " at distance " << geodesic.distance_to_sources(farthest) << '\n'
            << "unreachable vertices: " << unreachable << std::endl;
  return 0;
}
