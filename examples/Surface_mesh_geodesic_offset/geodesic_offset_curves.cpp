// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offset curves of a mesh vertex at ten distances, as curves with their lengths, and as polylines.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_polylines.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel           Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                           Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>       Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits>                    Geodesic;
typedef CGAL::Offset_levels<Geodesic::FT>                             Levels;

// geodesic_offset_curves [MESH [SPACING [OUT.polylines.txt]]]
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

  std::cout << curves.size() << " curves\n";
  for(const Geodesic::Offset_curve& curve : curves)
    std::cout << "  at distance " << curve.distance() << ": length " << curve.length()
              << (curve.is_closed() ? ", closed" : ", from boundary to boundary") << '\n';

  if(argc > 3)
  {
    // polylines only here: no point of them is farther than this from the exact curve
    const double chord_tolerance = 0.001 * spacing;
    std::ofstream out(argv[3]);
    if(!CGAL::IO::write_offset_polylines(out, curves, chord_tolerance))
    {
      std::cerr << "Cannot write " << argv[3] << std::endl;
      return 1;
    }
  }
  return 0;
}
