// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets of a polyline in space, as polylines.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_offset_curves.h>
#include <CGAL/boost/graph/generators.h>

#include <iterator>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

int main()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  const std::vector<Point> polyline{Point(1, 0, 0), Point(0, 0.5, 0)};
  std::vector<CGAL::Geodesic_offset_curve_type<Mesh>> offsets;
  CGAL::geodesic_offset_curves(mesh, polyline, 0.1, std::back_inserter(offsets));
  std::vector<Point> points;
  for (const auto& curve : offsets) curve.points(1e-3, std::back_inserter(points));
  return points.empty() ? 1 : 0;
}
