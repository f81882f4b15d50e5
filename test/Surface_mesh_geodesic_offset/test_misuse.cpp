// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that documented exceptions answer, and that leave objects as they were: null and removed elements, locations that are
// not valid, moved-from diagrams, ranges that throw midway, builds inside a check, start values and spacings beyond the range
// of numbers, meshes without faces, isolated vertices.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "offset_tools.h"
#include "path_tools.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/iterator/transform_iterator.hpp>
#include <boost/range/iterator_range.hpp>

#include <array>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_misuse {

using namespace test;

namespace parameters = CGAL::parameters;
typedef CGAL::Surface_mesh_geodesic_enclosure<Geodesic::Traits> Enclosure;
typedef Geodesic::Field::Voronoi_diagram Diagram;

const double infinity = std::numeric_limits<double>::infinity();

// A field with kept windows and two sources, and what is made of it.
struct Example
{
  const Generated_mesh<test::Surface_mesh> data{rotated(torus(14, 9), 1)};
  Geodesic geodesic{data.mesh};
  Offset_curves curves;

  Example()
  {
    geodesic.add_source_points(std::vector<Vertex_index>{data.vertices[3], data.vertices[70]});
    geodesic.build(parameters::keep_windows(true));
    geodesic.offset_curves(0.2, std::back_inserter(curves));
  }
};

void null_and_foreign_faces()
{
  const Example e;
  const Diagram diagram = e.geodesic.field().voronoi_diagram();
  const Face_index none, foreign(unsigned(e.data.faces.size()));
  for (const Face_index f : {none, foreign})
  {
    const Face_location l(f, {{0.3, 0.3, 0.4}});
    CHECK_THROWS(diagram.source_at_face(f), std::invalid_argument);
    CHECK_THROWS(diagram.source_at(l), std::invalid_argument);
    CHECK_THROWS(diagram.curve(0).point(l), std::invalid_argument);
    CHECK_THROWS(e.curves.at(0).point(l), std::invalid_argument);
    CHECK_THROWS(e.geodesic.distance_to_sources(l), std::invalid_argument);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::array<double, 3>& w : {std::array<double, 3>{{nan, 0.5, 0.5}}, {{2, -1, 0}}, {{0, 0, 0}}, {{infinity, 0, 0}}})
    CHECK_THROWS(diagram.source_at(Face_location(e.data.faces[0], w)), std::invalid_argument);
  // any positive sum, as in other queries
  for (const Face_index f : e.data.faces)
    CHECK(diagram.source_at(Face_location(f, {{5, 2, 3}})) == diagram.source_at(Face_location(f, {{0.5, 0.2, 0.3}})));
}

// Removed elements between others, whose indices are in range: errors in each function, with the index in the message.
void removed_elements()
{
  Generated_mesh<test::Surface_mesh> data(planar_grid(6, 6));
  auto& mesh = data.mesh;
  const std::size_t number_of_faces = mesh.number_of_faces();
  const Vertex_index vertex = mesh.add_vertex(Point_3(20, 0, 0));
  const Face_index face = mesh.add_face(vertex, mesh.add_vertex(Point_3(21, 0, 0)), mesh.add_vertex(Point_3(20, 1, 0)));
  const auto halfedge = mesh.halfedge(face), border = mesh.opposite(halfedge);
  const auto edge = mesh.edge(halfedge);
  const Vertex_index last[] = {mesh.add_vertex(Point_3(30, 0, 0)), mesh.add_vertex(Point_3(31, 0, 0)),
                               mesh.add_vertex(Point_3(30, 1, 0))};
  mesh.add_face(last[0], last[1], last[2]);
  CGAL::Euler::remove_face(halfedge, mesh);
  for (Vertex_index v : mesh.vertices())
    if (mesh.is_isolated(v)) mesh.remove_vertex(v);
  CHECK(mesh.is_removed(vertex) && mesh.is_removed(face) && mesh.is_removed(edge) && vertex < last[0]);
  CHECK(mesh.number_of_faces() == number_of_faces + 1);

  const Face_location l(face, {{0.3, 0.3, 0.4}});
  const std::vector<Vertex_index> vertices{vertex};
  const std::vector<Face_location> locations{l};
  const std::vector<test::Surface_mesh::Edge_index> edges{edge};
  Geodesic geodesic(mesh);
  Enclosure enclosure(geodesic.mesh());
  const auto check_sources = [&](auto& object) {
    CHECK_THROWS(object.add_source_point(vertex), std::invalid_argument);
    CHECK_THROWS(object.add_source_point(l), std::invalid_argument);
    CHECK_THROWS(object.add_source_points(vertices), std::invalid_argument);
    CHECK_THROWS(object.add_source_polyline(locations), std::invalid_argument);
    CHECK_THROWS(object.add_source_edges(edges), std::invalid_argument);
    CHECK(object.number_of_sources() == 0);
  };
  check_sources(geodesic);
  check_sources(enclosure);
  CHECK_THROWS(geodesic.add_source_boundary(border), std::invalid_argument);
  std::vector<double> distances(mesh.num_vertices());
  const auto map = CGAL::make_property_map(distances);
  CHECK_THROWS(CGAL::geodesic_distances(mesh, vertex, map), std::invalid_argument);
  CHECK_THROWS(CGAL::geodesic_distances(mesh, l, map), std::invalid_argument);
  CHECK_THROWS(CGAL::geodesic_distances(mesh, edges, map), std::invalid_argument);
  CHECK_THROWS(CGAL::geodesic_distances(mesh, last[0], map, parameters::targets(vertices)), std::invalid_argument);

  geodesic.add_source_point(data.vertices[0]);
  geodesic.build(parameters::keep_windows(true));
  CHECK_THROWS(geodesic.distance_to_sources(vertex), std::invalid_argument);
  CHECK_THROWS(geodesic.distance_to_sources(l), std::invalid_argument);
  CHECK_THROWS(geodesic.error_bound(vertex), std::invalid_argument);
  CHECK_THROWS(geodesic.nearest_source(vertex), std::invalid_argument);
  CHECK_THROWS(geodesic.field().voronoi_diagram().source_at_face(face), std::invalid_argument);
  CHECK(geodesic.distance_to_sources(data.vertices[1]) > 0 && geodesic.distance_to_sources(last[0]) == infinity);
  const auto names = [](const auto& function, const std::string& text) {
    try
    {
      function();
    }
    catch (const std::invalid_argument& e)
    {
      return std::string(e.what()).find(text) != std::string::npos;
    }
    return false;
  };
  CHECK(names([&] { geodesic.distance_to_sources(vertex); }, "vertex " + std::to_string(vertex.idx()) + " "));
  CHECK(names([&] { geodesic.distance_to_sources(l); }, "face " + std::to_string(face.idx()) + " "));
}

// A face at one vertex, with lengths of a triangle.
void repeated_vertices()
{
  test::Surface_mesh mesh;
  const Vertex_index v = mesh.add_vertex(Point_3(0, 0, 0));
  const Face_index f = mesh.add_face();
  const auto h = std::array<test::Surface_mesh::Halfedge_index, 3>{{mesh.add_edge(), mesh.add_edge(), mesh.add_edge()}};
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto next = h[(k + 1) % 3];
    mesh.set_target(h[k], v);
    mesh.set_target(mesh.opposite(h[k]), v);
    mesh.set_face(h[k], f);
    mesh.set_next(h[k], next);
    mesh.set_next(mesh.opposite(next), mesh.opposite(h[k]));
  }
  mesh.set_halfedge(f, h[0]);
  mesh.set_halfedge(v, h[0]);
  const auto length = mesh.add_property_map<test::Surface_mesh::Edge_index, double>("e:length", 1).first;
  CHECK_THROWS(Geodesic(mesh, parameters::edge_length_map(length)), std::invalid_argument);
  CHECK_THROWS(Geodesic{mesh}, std::invalid_argument);
}

void null_face_of_polyhedron()
{
  typedef CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3> Polyhedron;
  typedef Geodesic_on<Polyhedron> Geodesic;
  const Generated_mesh<Polyhedron> data(planar_grid(3, 3));
  Geodesic geodesic(data.mesh);
  const Geodesic::Face_location none(boost::graph_traits<Polyhedron>::null_face(), {{0.3, 0.3, 0.4}});
  CHECK_THROWS(geodesic.add_source_point(none), std::invalid_argument);
  CHECK(geodesic.number_of_sources() == 0);
  geodesic.add_source_point(data.vertices[0]);
  geodesic.build(parameters::keep_windows(true));
  CHECK_THROWS(geodesic.distance_to_sources(none), std::invalid_argument);
}

void moved_from_diagrams()
{
  const Example e;
  Diagram gone = e.geodesic.field().voronoi_diagram();
  Diagram::Curve curve_gone = gone.curve(0);
  const Diagram kept(std::move(gone));
  const Diagram::Curve curve(std::move(curve_gone));
  CHECK(kept.number_of_curves() > 0 && curve.number_of_pieces() > 0);
  CHECK_THROWS(gone.number_of_curves(), std::logic_error);
  CHECK_THROWS(gone.curves(), std::logic_error);
  CHECK_THROWS(gone.number_of_vertices(), std::logic_error);
  CHECK_THROWS(gone.number_of_forced_cells(), std::logic_error);
  CHECK_THROWS(gone.source_at_face(e.data.faces[0]), std::logic_error);
  CHECK_THROWS(gone.source_at(Face_location(e.data.faces[0], {{1, 0, 0}})), std::logic_error);
  test::Surface_mesh mesh = e.data.mesh;
  CHECK_THROWS(CGAL::split_along_geodesic_voronoi_diagram(mesh, gone), std::logic_error);
  CHECK(mesh.number_of_vertices() == e.data.mesh.number_of_vertices());
  CHECK_THROWS(curve_gone.is_closed(), std::logic_error);
  CHECK_THROWS(curve_gone.number_of_pieces(), std::logic_error);
  CHECK_THROWS(curve_gone.source_on_left(), std::logic_error);
  CHECK_THROWS(curve_gone.point(curve.piece(0).start()), std::logic_error);
}

// Calls function(range) with ranges of vertices that throw at the k-th access of an element; there are n ranges that throw.
template <class Function>
std::size_t with_throwing_ranges(const std::vector<Vertex_index>& vertices, const Function& function)
{
  for (std::size_t n = 0;; ++n)
  {
    std::size_t accesses = 0;
    const auto access = [&](const Vertex_index& v) -> const Vertex_index& {
      if (accesses++ == n) throw std::out_of_range("test");
      return v;
    };
    const auto range = boost::make_iterator_range(boost::make_transform_iterator(vertices.begin(), access),
                                                  boost::make_transform_iterator(vertices.end(), access));
    try
    {
      function(range);
      return n;
    }
    catch (const std::out_of_range&)
    {
    }
  }
}

void throwing_ranges()
{
  const Generated_mesh<test::Surface_mesh> data(planar_grid(4, 4));
  const std::vector<Vertex_index> vertices(data.vertices.begin(), data.vertices.begin() + 5);
  Enclosure enclosure(data.mesh);
  Geodesic geodesic(data.mesh);
  const auto add_to = [&](auto& object) {
    return with_throwing_ranges(vertices, [&](const auto& range) {
      CHECK(object.number_of_sources() == 0);
      object.add_source_points(range);
    });
  };
  CHECK(add_to(enclosure) == vertices.size()); // each element is read once
  CHECK(enclosure.number_of_sources() == vertices.size());
  CHECK(add_to(geodesic) == vertices.size());
  CHECK(geodesic.number_of_sources() == vertices.size());
}

// The range of curves builds anew, and replaces the enclosure, while it is read.
void builds_inside_a_check()
{
  const Example e;
  Enclosure enclosure(e.data.mesh);
  enclosure.add_source_points(std::vector<Vertex_index>{e.data.vertices[3], e.data.vertices[70]});
  enclosure.build(parameters::keep_windows(true));
  const double tolerance = enclosure.certify_offset(0.2, e.curves).tolerance;
  CHECK(tolerance < 1e-11);
  const auto rebuild = [&](const Offset_curve& c) -> const Offset_curve& {
    enclosure.clear_sources();
    enclosure.build();
    return c;
  };
  const auto certificate =
    enclosure.certify_offset(0.2, boost::make_iterator_range(boost::make_transform_iterator(e.curves.begin(), rebuild),
                                                             boost::make_transform_iterator(e.curves.end(), rebuild)));
  CHECK(certificate.bounds_region && certificate.tolerance == tolerance);
}

void visitors_are_released()
{
  const Generated_mesh<test::Surface_mesh> data(planar_grid(3, 3));
  const auto state = std::make_shared<int>(0);
  Geodesic geodesic(data.mesh);
  geodesic.add_source_point(data.vertices[0]);
  geodesic.build(parameters::visitor([state](double) { return ++*state > 0; }));
  CHECK(*state > 0 && state.use_count() == 1);
}

void numbers_beyond_range()
{
  const Example e;
  typedef CGAL::Offset_levels<double> Levels;
  const double largest = (std::numeric_limits<double>::max)();
  CHECK_THROWS(Levels::equally_spaced(largest, 2), std::invalid_argument);
  CHECK(Levels::equally_spaced(largest / 2, 2).size() == 2);
  CHECK(Levels::equally_spaced(largest, 0).size() == 0);
  for (const double factor : {1e-3, 1e3})
  {
    Generated_mesh<test::Surface_mesh> data(planar_grid(2, 2));
    for (const Vertex_index v : data.vertices) data.mesh.point(v) = CGAL::ORIGIN + factor * (data.mesh.point(v) - CGAL::ORIGIN);
    Enclosure scaled(data.mesh);
    scaled.add_source_point(data.vertices[0], parameters::start_value(0.95 * largest));
    if (factor < 1)
    {
      CHECK_THROWS(scaled.build(), std::runtime_error);
      continue;
    }
    scaled.build();
    for (const Vertex_index v : data.vertices)
    {
      const auto bounds = scaled.distance_bounds(v);
      CHECK(bounds.first < 0.95 * largest && bounds.first > 0.949 * largest && bounds.second >= 0.95 * largest);
    }
  }
}

void meshes_without_faces()
{
  for (const int vertices : {0, 1})
  {
    test::Surface_mesh mesh;
    for (int i = 0; i < vertices; ++i) mesh.add_vertex(Point_3(1, 2, 3));
    Enclosure enclosure(mesh);
    enclosure.build(parameters::keep_windows(true));
    CHECK(enclosure.certify_offset(1, Offset_curves()).bounds_region);
    CGAL::split_along_offset_curves(mesh, Offset_curves());
    CHECK(mesh.number_of_vertices() == std::size_t(vertices) && mesh.number_of_faces() == 0);
  }
}

// They are no part of the surface: a split is the same with them.
void isolated_vertices()
{
  std::size_t number_of_faces = 0;
  for (const double x : {0., 1e9, infinity, std::numeric_limits<double>::quiet_NaN()})
  {
    Generated_mesh<test::Surface_mesh> data(rotated(torus(14, 9), 1));
    if (x != 0) data.mesh.add_vertex(Point_3(x, x, x));
    Geodesic geodesic(data.mesh);
    geodesic.add_source_point(data.vertices[3]);
    Offset_curves curves;
    geodesic.build_with_offset_curves(0.3, std::back_inserter(curves));
    CGAL::split_along_offset_curves(data.mesh, curves);
    CHECK(data.mesh.number_of_faces() > data.faces.size());
    if (x == 0) number_of_faces = data.mesh.number_of_faces();
    CHECK(data.mesh.number_of_faces() == number_of_faces);
  }
}

} // namespace test_misuse

GEODESIC_OFFSET_TEST(test_misuse)
{
  using namespace test_misuse;
  const std::pair<const char*, void (*)()> tests[] = {
    {"null and foreign faces", null_and_foreign_faces},
    {"removed elements", removed_elements},
    {"repeated vertices", repeated_vertices},
    {"null face of a Polyhedron_3", null_face_of_polyhedron},
    {"diagrams that were moved from", moved_from_diagrams},
    {"ranges that throw", throwing_ranges},
    {"builds inside a check", builds_inside_a_check},
    {"visitors are released", visitors_are_released},
    {"numbers beyond range", numbers_beyond_range},
    {"meshes without faces", meshes_without_faces},
    {"isolated vertices", isolated_vertices}};
  return run_tests("test_misuse", tests);
}
