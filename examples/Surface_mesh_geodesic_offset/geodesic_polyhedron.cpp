// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances on a Polyhedron_3 without ids: any FaceListGraph will do. The mesh is numbered internally, and results are
// kept in a std::map.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <map>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Polyhedron_3<Kernel> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.empty())
  {
    std::cerr << "Not a triangle mesh: " << filename << std::endl;
    return 1;
  }

  std::map<vertex_descriptor, double> distance;
  const vertex_descriptor source = *vertices(mesh).begin();
  CGAL::geodesic_distances(mesh, source, boost::make_assoc_property_map(distance));

  vertex_descriptor farthest = source;
  for(vertex_descriptor v : vertices(mesh))
    if(distance[v] > distance[farthest]) farthest = v;
  std::cout << "distance from " << source->point() << " to " << farthest->point() << ": " << distance[farthest] << std::endl;
  return 0;
}
