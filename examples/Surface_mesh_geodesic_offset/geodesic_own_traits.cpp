// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Own traits: distances in a space that is stretched vertically, where climbing one unit costs as much as two units on
// level ground. One functor is replaced, the one that lays a face out in the plane.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/boost/graph/generators.h>

#include <cstddef>
#include <iostream>
#include <iterator>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

struct Stretching_traits : CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>
{
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Base;

  struct Construct_apices_2
  {
    auto operator()(const Point& p, const Point& q, const Point& r) const
    {
      return Base().construct_apices_2_object()(stretched(p), stretched(q), stretched(r));
    }
    static Point stretched(const Point& p) { return Point(p.x(), p.y(), 2 * p.z()); }
  };
  Construct_apices_2 construct_apices_2_object() const { return Construct_apices_2(); }
};

int main()
{
  Mesh mesh; // an upright wall of side 1
  const auto point = [](std::size_t i, std::size_t j) { return Point(i / 10.0, 0, j / 10.0); };
  CGAL::make_grid(10, 10, mesh, point, true);
  const Mesh::Vertex_index foot = *mesh.vertices().begin(), top = *std::prev(mesh.vertices().end());

  CGAL::Surface_mesh_geodesic_offset<Stretching_traits> geodesic(mesh);
  geodesic.add_source_point(foot);
  geodesic.build();
  std::cout << "from " << mesh.point(foot) << " to " << mesh.point(top) << ": " << geodesic.distance_to_sources(top)
            << ", the square root of 1 + 2 * 2" << std::endl;
  return 0;
}
