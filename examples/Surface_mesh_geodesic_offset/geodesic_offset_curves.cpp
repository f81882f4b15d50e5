// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets of a polyline at three distances, and a shortest path to it, by free functions. README.md shows a part of it.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/shortest_path_to_sources.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <fstream>
#include <iterator>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"), mesh)) return 1;
  const std::vector<Point> line{Point(0.1, 0.2, 0), Point(0.2, 0.1, 0.1), Point(0.1, 0, 0.2)}; // located on the mesh
  std::vector<CGAL::Geodesic_offset_curve_type<Mesh>> curves;
  CGAL::geodesic_offset_curves(mesh, line, std::vector<double>{0.05, 0.1, 0.2}, std::back_inserter(curves));
  std::vector<Point> path;
  CGAL::shortest_path_to_sources(mesh, Point(0, 0.5, 0), line, std::back_inserter(path));
  std::ofstream file("path.polylines.txt");
  file << path.size();
  for(const Point& p : path) file << ' ' << p;
  return file.flush() && CGAL::IO::write_offset_curves("offsets.vtk", curves) ? 0 : 1;
}
