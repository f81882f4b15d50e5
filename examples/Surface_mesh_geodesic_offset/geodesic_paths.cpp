// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The shortest path from the farthest point of a mesh to the nearer one of two sources.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

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

  // The first source is the point of the surface nearest to the origin.
  Geodesic geodesic(mesh);
  geodesic.add_source_point(geodesic.locate(Kernel::Point_3(0, 0, 0)));
  geodesic.build(CGAL::parameters::keep_windows(true));

  // The second source is a farthest point from the first one; the update propagates only shorter distances.
  geodesic.add_source_point(geodesic.farthest_point()->first);
  geodesic.update();

  const Geodesic::Face_location query = geodesic.farthest_point()->first;
  std::vector<Kernel::Point_3> path;
  geodesic.shortest_path_points_to_sources(query, std::back_inserter(path));
  std::cout << "largest distance: " << geodesic.distance_to_sources(query) << " from source "
            << geodesic.nearest_source(query)->source << '\n'
            << "gradient there: " << *geodesic.gradient(query) << '\n'
            << "the path has " << path.size() << " points, from " << path.front() << " to " << path.back() << std::endl;
  return 0;
}
