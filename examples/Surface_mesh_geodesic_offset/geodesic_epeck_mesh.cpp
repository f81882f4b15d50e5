// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh with exact points, as the result of a Boolean operation has them. The field is computed with the floating point
// numbers of the kernel of the traits: coordinates are converted, and the mesh is not copied.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_exact_constructions_kernel Exact_kernel;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Exact_kernel::Point_3> Mesh;
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

  Geodesic geodesic(mesh);
  geodesic.add_source_point(*mesh.vertices().begin());
  geodesic.build(CGAL::parameters::keep_windows(true));

  // points of the results belong to the kernel of the traits
  std::vector<Kernel::Point_3> path;
  geodesic.shortest_path_points_to_sources(geodesic.farthest_point()->first, std::back_inserter(path));
  std::cout << "largest distance: " << geodesic.farthest_point()->second << '\n'
            << "from " << path.back() << " to " << path.front() << std::endl;
  return 0;
}
