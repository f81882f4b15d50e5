// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generated_soup.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace test {

std::vector<std::array<std::size_t, 3>> delaunay_triangles(const std::vector<Point_2>& points)
{
  typedef CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel> Vertex_base;
  typedef CGAL::Triangulation_data_structure_2<Vertex_base> Structure;
  CGAL::Delaunay_triangulation_2<Kernel, Structure> triangulation;
  for (std::size_t i = 0; i < points.size(); ++i) triangulation.insert(points[i])->info() = i;
  std::vector<std::array<std::size_t, 3>> triangles;
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
    triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return triangles;
}

} // namespace test
