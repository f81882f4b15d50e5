// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Converts a scanned polygon soup to a manifold triangle mesh: merges duplicate points, orients, splits non-manifold
// elements, removes degenerate faces, and keeps the largest component without isolated vertices. Prints "x y z diagonal" of
// the bounding box: its center and the length of its diagonal.
//
//   clean_mesh IN OUT.off

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <iostream>
#include <vector>

int main(int argc, char* argv[])
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  if (argc != 3)
  {
    std::cerr << "usage: clean_mesh IN OUT.off\n";
    return 2;
  }
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(argv[1], points, polygons) || polygons.empty())
  {
    std::cerr << "cannot read " << argv[1] << '\n';
    return 1;
  }
  std::cerr << "read " << points.size() << " points, " << polygons.size() << " polygons\n";
  PMP::repair_polygon_soup(points, polygons);
  PMP::orient_polygon_soup(points, polygons); // splits non-manifold elements
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  PMP::triangulate_faces(mesh);
  PMP::remove_degenerate_faces(mesh);
  PMP::keep_largest_connected_components(mesh, 1);
  for (Mesh::Vertex_index v : vertices(mesh))
    if (mesh.is_isolated(v)) mesh.remove_vertex(v);
  mesh.collect_garbage();
  std::cerr << "kept " << num_vertices(mesh) << " vertices, " << num_faces(mesh) << " faces\n";
  if (!CGAL::IO::write_polygon_mesh(argv[2], mesh, CGAL::parameters::stream_precision(17)))
  {
    std::cerr << "cannot write " << argv[2] << '\n';
    return 1;
  }
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  std::cout.precision(17);
  std::cout << (box.xmin() + box.xmax()) / 2 << ' ' << (box.ymin() + box.ymax()) / 2 << ' ' << (box.zmin() + box.zmax()) / 2
            << ' ' << std::hypot(box.x_span(), box.y_span(), box.z_span()) << '\n';
  return 0;
}
