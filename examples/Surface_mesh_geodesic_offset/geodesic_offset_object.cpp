// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The program geodesic_offset_curves with the class, which sets up the mesh and builds the field once for all results.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_offset_curves.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <fstream>
#include <iterator>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"), mesh)) return 1;
  const std::vector<Point> line{Point(0.1, 0.2, 0), Point(0.2, 0.1, 0.1), Point(0.1, 0, 0.2)};

  Geodesic geodesic(mesh);
  geodesic.add_source_polyline(geodesic.locate_polyline(line).locations);
  const Geodesic::Field field = geodesic.build(CGAL::parameters::keep_windows(true));

  std::vector<Geodesic::Offset_curve> curves;
  field.offset_curves(std::vector<double>{0.05, 0.1, 0.2}, std::back_inserter(curves));
  std::vector<Point> path;
  field.shortest_path_points_to_sources(geodesic.locate(Point(0, 0.5, 0)), std::back_inserter(path));

  std::ofstream file("path.polylines.txt");
  file << path.size();
  for(const Point& p : path) file << ' ' << p;
  return file.flush() && CGAL::IO::write_offset_curves("offsets.vtk", curves) ? 0 : 1;
}
