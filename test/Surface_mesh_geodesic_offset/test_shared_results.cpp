// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// User functions that start builds while a query, a build or an update calls them; copies; moved-from objects and curves;
// edges of other meshes. Built with and without AddressSanitizer, which detects uses of freed memory.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "offset_tools.h"
#include "path_tools.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/property_map.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <functional>
#include <initializer_list>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_shared_results {

using namespace test;

const std::vector<double> levels = {0.2, 0.35, 0.5};

typedef std::vector<double> Answers;
typedef std::function<void(double)> Record;

// Compared values of curves.
void record_curves(const Offset_curves& curves, const Record& record)
{
  for (const Offset_curve& curve : curves)
  {
    record(curve.distance());
    record(double(curve.number_of_pieces()));
    record(curve.length());
  }
}

Answers answers_of(const Offset_curves& curves)
{
  Answers answers;
  record_curves(curves, [&](double x) { answers.push_back(x); });
  return answers;
}

// Property map that calls a function for each value.
template <class Value>
struct Recording_map
{
  typedef Vertex_index key_type;
  typedef Value value_type;
  typedef Value reference;
  typedef boost::writable_property_map_tag category;
  const Record* record;
  friend void put(const Recording_map& map, Vertex_index, Value value) { (*map.record)(double(value)); }
};

struct Recording_visitor
{
  const Record& record;
  void operator()(Halfedge_index, double t) { record(t); }
  void operator()(Vertex_index v) { record(double(std::size_t(v))); }
  void operator()(Face_index, const Geodesic::Barycentric_coordinates& w) { record(w[0]); }
};

// Queries that call user functions: here `record`, for each number of the result.
typedef std::function<void(const Geodesic&, const Record&)> Query;

std::vector<std::pair<const char*, Query>> queries_with_callbacks()
{
  const Vertex_index far(77);
  const auto curves = [](const Record& record) {
    return [&record](double level, Offset_curves&& some) {
      record(level);
      record_curves(some, record);
    };
  };
  const auto put_location = [](const Record& record) {
    return boost::make_function_output_iterator([&record](const Face_location& l) { record(l.second[1]); });
  };
  const auto put_point = [](const Record& record) {
    return boost::make_function_output_iterator([&record](const Point_3& p) { record(p.x() + p.y() + p.z()); });
  };
  return {
    {"offset curves", [=](const Geodesic& g, const Record& r) { g.offset_curves_by_distance(levels, curves(r)); }},
    {"offset curves, parallel",
     [=](const Geodesic& g, const Record& r) {
       g.offset_curves_by_distance(levels, curves(r), CGAL::parameters::concurrency_tag(CGAL::Parallel_if_available_tag()));
     }},
    {"vertex distances", [](const Geodesic& g, const Record& r) { g.vertex_distances(Recording_map<double>{&r}); }},
    {"source labels", [](const Geodesic& g, const Record& r) { g.source_labels(Recording_map<std::size_t>{&r}); }},
    {"path sequence",
     [=](const Geodesic& g, const Record& r) {
       Recording_visitor visitor{r};
       g.shortest_path_sequence_to_sources(far, visitor);
     }},
    {"path", [=](const Geodesic& g, const Record& r) { g.shortest_path_to_sources(far, put_location(r)); }},
    {"path from the cache",
     [=](const Geodesic& g, const Record& r) {
       Path_locations path;
       g.shortest_path_to_sources(far, std::back_inserter(path));
       g.shortest_path_to_sources(far, put_location(r));
     }},
    {"path as points", [=](const Geodesic& g, const Record& r) { g.shortest_path_points_to_sources(far, put_point(r)); }},
    {"path as points from the cache", [=](const Geodesic& g, const Record& r) {
       std::vector<Point_3> path;
       g.shortest_path_points_to_sources(far, std::back_inserter(path));
       g.shortest_path_points_to_sources(far, put_point(r));
     }}};
}

// A query completes with the result with which it started, whatever its callbacks build.
void queries()
{
  const Generated_mesh<test::Surface_mesh> data(rotated(torus(14, 9), 1));
  for (const auto& query : queries_with_callbacks())
    for (const bool keeps : {true, false})
    {
      Report::instance().set_context(query.first + std::string(keeps ? ", with windows" : ", without windows"));
      // Each object has a new build, so that it alone shares its result.
      const auto answers = [&](bool is_disturbed) {
        Answers result;
        Geodesic geodesic(data.mesh);
        const auto build_from = [&](unsigned source) {
          geodesic.clear_sources();
          geodesic.add_source_point(Vertex_index(source));
          geodesic.build(CGAL::parameters::keep_windows(keeps));
        };
        build_from(3);
        query.second(geodesic, [&](double value) {
          if (is_disturbed) build_from(60);
          result.push_back(value);
        });
        CHECK((geodesic.distance_to_sources(Vertex_index(60)) == 0) == is_disturbed);
        return result;
      };
      const Answers expected = answers(false);
      CHECK(expected.size() > 2);
      CHECK(answers(true) == expected);
    }
}

// Nested builds and updates: each has the sources of its start, and the one that ends last remains.
template <class Tag>
void builds()
{
  const Generated_mesh<test::Surface_mesh> data(rotated(torus(30, 20), 1));
  const Vertex_index a(3), b(200), c(411);
  const auto distances_from = [&](std::initializer_list<Vertex_index> sources) {
    Geodesic geodesic(data.mesh);
    for (const Vertex_index v : sources) geodesic.add_source_point(v);
    geodesic.build(CGAL::parameters::concurrency_tag(Tag()));
    Answers result;
    for (const Vertex_index v : vertices(data.mesh)) result.push_back(geodesic.distance_to_sources(v));
    return result;
  };
  const auto distances_of = [&](const Geodesic& geodesic) {
    Answers result;
    for (const Vertex_index v : vertices(data.mesh)) result.push_back(geodesic.distance_to_sources(v));
    return result;
  };
  const Answers from_a = distances_from({a}), from_b = distances_from({b}), from_c = distances_from({c});

  Geodesic geodesic(data.mesh);
  geodesic.add_source_point(a);
  std::size_t calls = 0;
  const auto disturb = [&] {
    if (++calls != 2) return;
    geodesic.clear_sources();
    geodesic.add_source_point(b);
    geodesic.build(CGAL::parameters::keep_windows(true).concurrency_tag(Tag()));
    CHECK(distances_of(geodesic) == from_b);
  };
  const auto visitor = [&](double) {
    disturb();
    return true;
  };
  geodesic.build(CGAL::parameters::visitor(visitor).concurrency_tag(Tag()));
  CHECK(calls > 2);
  CHECK(distances_of(geodesic) == from_a);

  // with offset curves, in the callback and in the visitor
  calls = 0;
  geodesic.clear_sources();
  geodesic.add_source_point(c);
  std::size_t received = 0;
  Offset_curves curves;
  geodesic.build_with_offset_curves_by_distance(
    levels,
    [&](double, Offset_curves&& some) {
      ++received;
      disturb();
      std::move(some.begin(), some.end(), std::back_inserter(curves));
    },
    CGAL::parameters::visitor(visitor).concurrency_tag(Tag()));
  CHECK(calls > 2 && received == levels.size());
  CHECK(distances_of(geodesic) == from_c);
  Geodesic alone(data.mesh);
  alone.add_source_point(c);
  Offset_curves expected;
  alone.build_with_offset_curves(levels, std::back_inserter(expected), CGAL::parameters::concurrency_tag(Tag()));
  CHECK(answers_of(curves) == answers_of(expected));

  // an update, which starts from the last build
  for (const bool keeps : {true, false})
  {
    geodesic.clear_sources();
    geodesic.add_source_point(a);
    geodesic.build(CGAL::parameters::keep_windows(keeps).concurrency_tag(Tag()));
    geodesic.add_source_point(c);
    calls = 0;
    geodesic.update(CGAL::parameters::visitor(visitor).concurrency_tag(Tag()));
    CHECK(calls > 2);
    const Answers from_both = distances_from({a, c});
    Worst_error worst(1e-13, 1);
    std::size_t i = 0;
    for (const Vertex_index v : vertices(data.mesh)) CHECK_CLOSE(worst, geodesic.distance_to_sources(v), from_both[i++]);
  }

  // if the visitor throws after a build of its own, that build remains
  geodesic.clear_sources();
  geodesic.add_source_point(a);
  calls = 0;
  const auto throwing = [&](double) -> bool {
    disturb();
    if (calls > 2) throw std::domain_error("enough");
    return true;
  };
  CHECK_THROWS(geodesic.build(CGAL::parameters::visitor(throwing).concurrency_tag(Tag())), std::domain_error);
  CHECK(distances_of(geodesic) == from_b);
}

void copies()
{
  const Generated_mesh<test::Surface_mesh> data(rotated(torus(14, 9), 1));
  const Vertex_index a(3), b(60);
  Geodesic first(data.mesh);
  first.add_source_point(a);
  first.build(CGAL::parameters::keep_windows(true));
  Geodesic second(first);
  CHECK(second.is_built() && second.number_of_sources() == 1 && second.distance_to_sources(a) == 0);
  second.add_source_point(b);
  second.update();
  CHECK(second.distance_to_sources(b) == 0 && first.distance_to_sources(b) > 0);
  CHECK(first.number_of_sources() == 1 && second.number_of_sources() == 2);
  {
    Geodesic third(second);
    second = first;
    CHECK(third.distance_to_sources(b) == 0);
  }
  CHECK(second.distance_to_sources(b) == first.distance_to_sources(b));
}

// Functions of a mesh, or of an object with a mesh, that need it throw.
template <class Object>
void check_moved_mesh(const Object& object, Geodesic::halfedge_descriptor h)
{
  const Point_3 p(0, 0, 0);
  const std::vector<Point_3> points{p};
  const std::vector<Face_location> locations{Face_location(Face_index(0), {{0.2, 0.3, 0.5}})};
  const Geodesic::Plane_3 plane(1, 0, 0, 0);
  std::vector<Geodesic::edge_descriptor> sharp;
  CHECK_THROWS(object.sharp_edges(30, std::back_inserter(sharp)), std::logic_error);
  CHECK_THROWS(object.plane_section(plane), std::logic_error);
  CHECK_THROWS(object.locate(p), std::logic_error);
  CHECK_THROWS(object.locate(p, CGAL::parameters::snapping_tolerance(1e-3)), std::logic_error);
  CHECK_THROWS(object.locate(Geodesic::Ray_3(p, Point_3(1, 0, 0))), std::logic_error);
  CHECK_THROWS(object.locate_with_distance(p), std::logic_error);
  CHECK_THROWS(object.locate_polyline(points), std::logic_error);
  CHECK_THROWS(object.join_polyline(locations), std::logic_error);
  if constexpr (std::is_same<Object, Geodesic::Mesh>::value)
  {
    CHECK_THROWS(object.boundary_edges(), std::logic_error);
    CHECK_THROWS(object.boundary_edges(h), std::logic_error);
    CHECK_THROWS(object.triangle_mesh(), std::logic_error);
  }
}

// Functions that need a mesh or a result throw; the object can be assigned.
template <class Object>
void check_moved_from(Object& object, const test::Surface_mesh& mesh, const Vertex_index v)
{
  const Face_location l(Face_index(0), {{0.2, 0.3, 0.5}});
  const std::vector<Vertex_index> no_vertices{v};
  const std::vector<Face_location> locations{l};
  const std::vector<typename Object::edge_descriptor> some_edges{*edges(mesh).begin()};
  CHECK(!object.is_built());
  CHECK(object.number_of_sources() == 0);
  CHECK_THROWS(object.build(), std::logic_error);
  CHECK_THROWS(object.add_source_point(v), std::logic_error);
  CHECK_THROWS(object.add_source_point(l), std::logic_error);
  CHECK_THROWS(object.add_source_points(no_vertices), std::logic_error);
  CHECK_THROWS(object.add_source_polyline(locations), std::logic_error);
  CHECK_THROWS(object.add_source_edges(some_edges), std::logic_error);
  check_moved_mesh(object.mesh(), halfedge(some_edges[0], mesh));
  CHECK_THROWS(object.remove_source(0), std::logic_error);
  object.clear_sources();
}

void moved_from()
{
  const Generated_mesh<test::Surface_mesh> data(rotated(torus(14, 9), 1));
  const Vertex_index a(3), b(60);
  const Face_location l(Face_index(0), {{0.2, 0.3, 0.5}});
  Geodesic first(data.mesh);
  first.add_source_point(a);
  first.build(CGAL::parameters::keep_windows(true));
  const double distance = first.distance_to_sources(b);
  Geodesic second(std::move(first));
  CHECK(second.distance_to_sources(b) == distance && second.number_of_sources() == 1);
  const auto check_queries = [&](Geodesic& g) {
    check_moved_from(g, data.mesh, a);
    const auto h = halfedge(*edges(data.mesh).begin(), data.mesh);
    check_moved_mesh(g, h);
    CHECK_THROWS(g.add_source_boundary(), std::logic_error);
    CHECK_THROWS(g.add_source_boundary(h), std::logic_error);
    CHECK_THROWS(g.add_source_sharp_edges(30), std::logic_error);
    CHECK_THROWS(g.add_source_plane_section(Geodesic::Plane_3(1, 0, 0, 0)), std::logic_error);
    CHECK_THROWS(g.field(), std::logic_error);
    Offset_curves curves;
    std::vector<Point_3> points;
    std::map<Vertex_index, double> distances;
    std::map<Vertex_index, std::size_t> labels;
    CHECK_THROWS(g.update(), std::logic_error);
    CHECK_THROWS(g.distance_to_sources(a), std::logic_error);
    CHECK_THROWS(g.distance_to_sources(l), std::logic_error);
    CHECK_THROWS(g.signed_distance_to_sources(l), std::logic_error);
    CHECK_THROWS(g.error_bound(a), std::logic_error);
    CHECK_THROWS(g.nearest_source(a), std::logic_error);
    CHECK_THROWS(g.gradient(l), std::logic_error);
    CHECK_THROWS(g.vertex_distances(boost::make_assoc_property_map(distances)), std::logic_error);
    CHECK_THROWS(g.source_labels(boost::make_assoc_property_map(labels)), std::logic_error);
    CHECK_THROWS(g.largest_vertex_distance(), std::logic_error);
    CHECK_THROWS(g.largest_distance(), std::logic_error);
    CHECK_THROWS(g.farthest_point(), std::logic_error);
    CHECK_THROWS(g.covered_distance(), std::logic_error);
    CHECK_THROWS(g.is_cancelled(), std::logic_error);
    CHECK_THROWS(g.statistics(), std::logic_error);
    CHECK_THROWS(g.shortest_path_points_to_sources(a, std::back_inserter(points)), std::logic_error);
    CHECK_THROWS(g.offset_curves(0.3, std::back_inserter(curves)), std::logic_error);
    CHECK_THROWS(g.build_with_offset_curves(0.3, std::back_inserter(curves)), std::logic_error);
    CHECK_THROWS(g.build_with_offset_curves(CGAL::Offset_levels<double>::equally_spaced(0.3), std::back_inserter(curves)),
                 std::logic_error);
    CHECK(curves.empty() && points.empty() && distances.empty() && labels.empty());
  };
  check_queries(first);
  first = second;
  CHECK(first.distance_to_sources(b) == distance);
  Geodesic third(data.mesh);
  third = std::move(first);
  CHECK(third.distance_to_sources(b) == distance);
  check_queries(first);
  first = Geodesic(data.mesh);
  first.add_source_point(b);
  first.build();
  CHECK(first.distance_to_sources(b) == 0);

  typedef CGAL::Surface_mesh_geodesic_enclosure<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh>> Enclosure;
  Enclosure enclosure(data.mesh);
  enclosure.add_source_point(a);
  enclosure.build();
  const auto bounds = enclosure.distance_bounds(b);
  Enclosure moved(std::move(enclosure));
  CHECK(moved.distance_bounds(b) == bounds);
  check_moved_from(enclosure, data.mesh, a);
  CHECK_THROWS(enclosure.distance_bounds(b), std::logic_error);
  CHECK_THROWS(enclosure.number_of_windows(), std::logic_error);
}

void moved_from_curves()
{
  const Generated_mesh<test::Surface_mesh> data(rotated(torus(14, 9), 1));
  Offset_curves curves;
  {
    Geodesic geodesic(data.mesh);
    geodesic.add_source_point(Vertex_index(3));
    geodesic.build_with_offset_curves(0.3, std::back_inserter(curves));
  }
  CHECK(curves.size() == 1);
  const double length = curves[0].length();
  const Point_3 p = curves[0].point(0.1);
  const Face_location l = curves[0].location(0.1);
  const Offset_curve kept(std::move(curves[0])); // needs no geodesic object
  CHECK(kept.length() == length && kept.point(0.1) == p);
  const Offset_curve& gone = curves[0];
  std::vector<Point_3> points;
  std::vector<Face_location> locations;
  std::size_t pieces = 0;
  CHECK(gone.number_of_pieces() == 0 && gone.length() == 0);
  for (const auto& piece : gone.pieces()) pieces += piece.is_arc() ? 1 : 1;
  gone.points(0.01, std::back_inserter(points));
  gone.face_locations(0.01, std::back_inserter(locations));
  CHECK(points.empty() && locations.empty() && pieces == 0);
  CHECK_THROWS(gone.location(0.1), std::logic_error);
  CHECK_THROWS(gone.point(0.1), std::logic_error);
  CHECK_THROWS(gone.point(l), std::logic_error);
  curves[0] = kept;
  CHECK(curves[0].length() == length);
}

template <class Mesh>
void foreign_edges(const bool has_indices)
{
  typedef Geodesic_on<Mesh> Geodesic;
  typedef typename Geodesic::edge_descriptor Edge;
  const Generated_mesh<Mesh> data(planar_grid(2, 2)), larger(planar_grid(9, 9));
  Geodesic geodesic(data.mesh);
  const Edge first = *edges(data.mesh).begin();
  std::vector<Edge> all(edges(larger.mesh).begin(), edges(larger.mesh).end());
  const std::vector<Edge> nulls{Edge()}, late_null{first, Edge()}, foreign{first, all.back()};
  CHECK_THROWS(geodesic.add_source_edges(nulls), std::invalid_argument);
  CHECK_THROWS(geodesic.add_source_edges(late_null), std::invalid_argument);
  CHECK_THROWS(geodesic.add_source_edges(foreign), std::invalid_argument);
  CHECK_THROWS(geodesic.add_source_edges(std::vector<Edge>()), std::invalid_argument);
  CHECK_THROWS(geodesic.add_source_boundary(boost::graph_traits<Mesh>::null_halfedge()), std::invalid_argument);
  CHECK(geodesic.number_of_sources() == 0);
  // by its face, or by an index that both meshes have
  const std::vector<Edge> similar{all.front()};
  if (has_indices) geodesic.add_source_edges(similar);
  else CHECK_THROWS(geodesic.add_source_edges(similar), std::invalid_argument);
  geodesic.clear_sources();
  geodesic.add_source_edges(edges(data.mesh));
  geodesic.build();
  for (const auto v : data.vertices) CHECK(geodesic.distance_to_sources(v) == 0);
}

void removed_edge()
{
  const Generated_mesh<test::Surface_mesh> data(planar_grid(3, 3));
  test::Surface_mesh mesh = data.mesh;
  CGAL::Euler::remove_face(halfedge(*faces(mesh).begin(), mesh), mesh);
  CHECK(mesh.has_garbage());
  Geodesic geodesic(mesh);
  std::size_t removed = 0;
  for (unsigned i = 0; i < mesh.num_edges(); ++i)
  {
    const Geodesic::edge_descriptor e(i);
    const std::vector<Geodesic::edge_descriptor> one{e};
    if (!mesh.is_removed(e)) continue;
    ++removed;
    CHECK_THROWS(geodesic.add_source_edges(one), std::invalid_argument);
  }
  CHECK(removed > 0);
}

} // namespace test_shared_results

GEODESIC_OFFSET_TEST(test_shared_results)
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  const std::pair<const char*, void (*)()> tests[] = {
    {"queries", queries},
    {"builds", builds<CGAL::Sequential_tag>},
    {"parallel builds", builds<CGAL::Parallel_if_available_tag>},
    {"copies", copies},
    {"objects that were moved from", moved_from},
    {"curves that were moved from", moved_from_curves},
    {"edges of another Surface_mesh", [] { foreign_edges<test::Surface_mesh>(true); }},
    {"edges of another Polyhedron_3", [] { foreign_edges<Polyhedron>(false); }},
    {"removed edges", removed_edge}};
  return run_tests("test_shared_results", tests);
}
