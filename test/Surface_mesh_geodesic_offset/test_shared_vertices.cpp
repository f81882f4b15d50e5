// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A vertex shared by several fans of faces is one point of the surface, whether the fans are open or closed: distances,
// paths and offset curves pass through it between all fans, and splits divide all of them.

#include "geodesic_types.h"
#include "test_check.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace test_shared_vertices {

using namespace test;

typedef test::Surface_mesh Mesh;
typedef Mesh::Vertex_index Vertex;

// Two right-angled corners of cubes with a common tip, vertex 0: faces 0 to 2 and 4 to 6 are at the tip, faces 3 and 7
// close the corners. The fans at the tip are closed; the first is open without face 2, the second without face 6.
Mesh two_corners(const std::vector<int>& left_out)
{
  const Point_3 points[] = {Point_3(0, 0, 0),  Point_3(1, 0, 0),  Point_3(0, 1, 0), Point_3(0, 0, 1),
                            Point_3(-1, 0, 0), Point_3(0, -1, 0), Point_3(0, 0, -1)};
  const int faces[][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}};
  Mesh mesh;
  std::vector<Vertex> vertices;
  for (const Point_3& p : points) vertices.push_back(mesh.add_vertex(p));
  const Vertex copy = mesh.add_vertex(points[0]); // initially the tip of the second corner
  for (int f = 0; f < 8; ++f)
  {
    if (std::find(left_out.begin(), left_out.end(), f) != left_out.end()) continue;
    std::array<Vertex, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = f >= 4 && faces[f][k] == 0 ? copy : vertices[std::size_t(faces[f][k])];
    CHECK(mesh.add_face(corners[0], corners[1], corners[2]) != Mesh::null_face());
  }
  for (const Mesh::Halfedge_index h : mesh.halfedges())
    if (mesh.target(h) == copy) mesh.set_target(h, vertices[0]);
  mesh.remove_vertex(copy);
  mesh.collect_garbage();
  return mesh;
}

void run(const std::string& name, const std::vector<int>& left_out)
{
  Report::instance().set_context(name);
  const Mesh mesh = two_corners(left_out);
  const double angle = CGAL_PI / 2;
  const bool second_is_open = std::find(left_out.begin(), left_out.end(), 6) != left_out.end();

  Geodesic geodesic(mesh);
  geodesic.add_source_point(Vertex(1));
  // the tracer may displace a level by 1024 units in the last place, and a length is up to 5 times the distance from the
  // tip
  const double rounding = 5 * 1024 * 2.3e-16 * 2;
  const double level = 1.6; // beyond the first corner, and 0.6 from the tip in the second one
  std::vector<Geodesic::Offset_curve> curves;
  geodesic.build_with_offset_curves(std::vector<double>{level}, std::back_inserter(curves),
                                    CGAL::parameters::keep_windows(true));
  const double s = std::sqrt(2.), expected[] = {1, 0, s, s, 2, 2, 2};
  for (std::size_t i = 0; i < 7; ++i)
  {
    const double d = geodesic.distance_to_sources(Vertex(static_cast<unsigned>(i)));
    CHECK_DETAIL(std::abs(d - expected[i]) < 1e-14, std::to_string(i) + ": " + std::to_string(d));
  }
  // the field is 1-Lipschitz along all edges
  for (const Mesh::Edge_index e : mesh.edges())
  {
    const double length = std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
    CHECK(std::abs(geodesic.distance_to_sources(mesh.vertex(e, 0)) - geodesic.distance_to_sources(mesh.vertex(e, 1))) <=
          length * (1 + 1e-14));
  }
  // a path through the tip
  std::vector<Point_3> path;
  geodesic.shortest_path_points_to_sources(Vertex(5), std::back_inserter(path));
  CHECK(path.size() == 3 && path[1] == Point_3(0, 0, 0) && path.front() == Point_3(0, -1, 0) &&
        path.back() == Point_3(1, 0, 0));
  // an arc in each face at the tip
  double length = 0;
  for (const Geodesic::Offset_curve& curve : curves)
  {
    CHECK(curve.is_closed() == !second_is_open);
    length += curve.length();
  }
  CHECK(curves.size() == 1);
  CHECK_DETAIL(std::abs(length - (second_is_open ? 2 : 3) * angle * (level - 1)) < rounding, std::to_string(length));

  // the shared vertex as source: arcs in all faces at the tip
  Geodesic from_tip(mesh);
  from_tip.add_source_point(Vertex(0));
  curves.clear();
  from_tip.build_with_offset_curves(std::vector<double>{0.5}, std::back_inserter(curves));
  length = 0;
  for (const Geodesic::Offset_curve& curve : curves) length += curve.length();
  CHECK(curves.size() == 2);
  CHECK_DETAIL(std::abs(length - double(6 - left_out.size()) * angle * 0.5) < rounding, std::to_string(length));
  for (unsigned i = 1; i < 7; ++i) CHECK(from_tip.distance_to_sources(Vertex(i)) == 1);
}

// Splits find the edges of all fans at a vertex.
void splits()
{
  Report::instance().set_context("splits");
  const Mesh mesh = two_corners({3, 7});
  Geodesic geodesic(mesh);
  for (unsigned v = 1; v < 7; ++v) geodesic.add_source_point(Vertex(v));
  const auto field = geodesic.build(CGAL::parameters::keep_windows(true));
  const auto area = [](const Mesh& m) { return CGAL::Polygon_mesh_processing::area(m); };
  for (const bool is_voronoi : {true, false})
  {
    Mesh split = mesh;
    auto label = split.add_property_map<Mesh::Face_index, std::size_t>("f:label", 99).first;
    auto is_curve = split.add_property_map<Mesh::Edge_index, bool>("e:curve", false).first;
    if (is_voronoi)
      CGAL::split_along_geodesic_voronoi_diagram(split, field.voronoi_diagram(),
                                                 CGAL::parameters::face_source_map(label).edge_is_constrained_map(is_curve));
    else
    {
      std::vector<Geodesic::Offset_curve> curves;
      geodesic.offset_curves(std::vector<double>{0.6, 0.9}, std::back_inserter(curves));
      CGAL::split_along_offset_curves(split, curves, CGAL::parameters::face_band_map(label).edge_is_constrained_map(is_curve));
    }
    CHECK(split.number_of_faces() > mesh.number_of_faces() && CGAL::is_triangle_mesh(split));
    CHECK_DETAIL(std::abs(area(split) - area(mesh)) < 1e-12, std::to_string(area(split)));
    std::size_t curve_edges = 0;
    for (const Mesh::Edge_index e : split.edges())
    {
      curve_edges += is_curve[e] ? 1 : 0;
      if (split.is_border(e)) continue;
      const auto h = split.halfedge(e);
      CHECK((label[split.face(h)] != label[split.face(split.opposite(h))]) == bool(is_curve[e]));
    }
    CHECK(curve_edges >= 6);
  }
}

} // namespace test_shared_vertices

GEODESIC_OFFSET_TEST(test_shared_vertices)
{
  splits();
  run("two closed fans", {});
  run("an open and a closed fan", {2});
  run("a closed and an open fan", {6});
  run("two open fans", {2, 6});
  return Report::instance().finish("test_shared_vertices");
}
