// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances from a mesh vertex, and offset curves at ten distances, with their lengths and as a file. README.md shows this
// program.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_offset_curves.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                           Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>       Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits>                    Geodesic;
typedef CGAL::Offset_levels<Geodesic::FT>                             Levels;

// geodesic_offset_curves [MESH [SPACING [FILE]]]
int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const double spacing = argc > 2 ? std::stod(argv[2]) : 0.05;
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.number_of_faces() == 0)
  {
    std::cerr << "Not a triangle mesh: " << filename << std::endl;
    return 1;
  }

  Geodesic geodesic(mesh);
  geodesic.add_source_point(*mesh.vertices().begin());

  // one propagation for the distances and for the offsets at all levels
  std::vector<Geodesic::Offset_curve> curves;
  geodesic.build_with_offset_curves(Levels::equally_spaced(spacing, 10), std::back_inserter(curves));

  std::cout << "farthest vertex: at distance " << geodesic.largest_vertex_distance() << '\n';
  for(const Geodesic::Offset_curve& curve : curves)
    std::cout << "offset at distance " << curve.distance() << ": length " << curve.length()
              << (curve.is_closed() ? ", closed" : ", from boundary to boundary") << '\n';

  // arcs become polylines in the file, if its format has no arcs: .vtk, .obj and .polylines.txt
  const double chord_tolerance = 0.001 * spacing;
  if(argc > 3 && !CGAL::IO::write_offset_curves(argv[3], curves, CGAL::parameters::chord_tolerance(chord_tolerance)))
  {
    std::cerr << "Cannot write " << argv[3] << std::endl;
    return 1;
  }
  return 0;
}
