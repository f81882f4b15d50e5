// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Free functions, source sets and fields: the same results as those of the class, for each kind of sources; fields that outlive
// their object and later builds; locations and points of other kernels.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "offset_tools.h"
#include "test_check.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/construct_geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_voronoi_labels.h>
#include <CGAL/Surface_mesh_geodesic_offset/shortest_path_to_sources.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_free_functions {

using namespace test;

typedef test::Surface_mesh Mesh;
typedef Mesh::Edge_index Edge_index;
typedef Mesh::Face_index Face_index;
typedef Mesh::Vertex_index Vertex_index;
typedef Geodesic::Source_set Source_set;

static_assert(std::is_same<CGAL::Geodesic_mesh_type<Mesh>, Geodesic::Mesh>::value, "the types of calls are those of the class");
static_assert(std::is_same<CGAL::Geodesic_offset_curve_type<Mesh>, Offset_curve>::value, "");

const Mesh& mesh()
{
  static const Mesh result = Generated_mesh<Mesh>(rotated(torus(24, 14), 1)).mesh;
  return result;
}

Face_location location(std::size_t face, double x, double y)
{
  return Face_location(Face_index(Mesh::size_type(face)), {{x, y, 1 - x - y}});
}

/// Compares the free functions for sources with the class for a source set.
template <class Sources>
void compare(const std::string& name, const Sources& sources, const std::vector<Source>& expected_sources)
{
  Report::instance().set_context(name);
  const Face_location from = location(200, 0.2, 0.3);
  const Geodesic geodesic = built(mesh(), expected_sources);
  const Geodesic::Field field = geodesic.field();
  const std::size_t n = mesh().number_of_vertices();
  std::vector<double> distances(n), expected(n);
  CGAL::geodesic_distances(mesh(), sources, CGAL::make_property_map(distances));
  field.vertex_distances(CGAL::make_property_map(expected));
  for (std::size_t i = 0; i < n; ++i) CHECK(std::abs(distances[i] - expected[i]) <= 1e-14 && expected[i] < 1e3);

  std::vector<std::size_t> labels(n), expected_labels(n);
  CGAL::geodesic_voronoi_labels(mesh(), sources, CGAL::make_property_map(labels));
  field.source_labels(CGAL::make_property_map(expected_labels));
  CHECK(labels == expected_labels && *std::max_element(labels.begin(), labels.end()) + 1 == expected_sources.size());

  const std::vector<double> levels{0.1, 0.2};
  Offset_curves curves;
  CGAL::geodesic_offset_curves(mesh(), sources, levels, std::back_inserter(curves));
  const Offset_curves expected_curves = offsets(geodesic, levels);
  CHECK(!curves.empty() && curves.size() == expected_curves.size());
  CHECK(std::abs(total_length(curves) - total_length(expected_curves)) < 1e-12);

  std::vector<Face_location> path, expected_path;
  std::vector<Point_3> points, expected_points;
  CGAL::shortest_path_to_sources(mesh(), from, sources, std::back_inserter(path));
  CGAL::shortest_path_to_sources(mesh(), from, sources, std::back_inserter(points));
  field.shortest_path_to_sources(from, std::back_inserter(expected_path));
  field.shortest_path_points_to_sources(from, std::back_inserter(expected_points));
  CHECK(path.size() == expected_path.size() && points.size() == expected_points.size() && points.size() > 1);
  for (std::size_t i = 0; i < points.size(); ++i) CHECK(CGAL::squared_distance(points[i], expected_points[i]) < 1e-24);
}

void kinds_of_sources()
{
  const auto point = [](std::size_t i) { return mesh().point(Vertex_index(Mesh::size_type(i))); };
  const std::vector<Face_location> locations{location(10, 0.2, 0.3), location(100, 0, 0.5)};
  const std::vector<Vertex_index> vertices{Vertex_index(3), Vertex_index(50), Vertex_index(170)};
  const std::vector<Edge_index> edges{Edge_index(7), Edge_index(8), Edge_index(90)};
  const std::vector<Point_3> points{point(0), CGAL::midpoint(point(1), point(2)), point(33)};
  const Geodesic::Mesh located(mesh());
  compare("vertex", vertices[0], {point_source(vertices[0])});
  compare("vertices", vertices, {point_source(vertices[0]), point_source(vertices[1]), point_source(vertices[2])});
  compare("location", locations[0], {point_source(locations[0])});
  compare("locations", locations, {point_source(locations[0]), point_source(locations[1])});
  compare("point in space", points[1], {point_source(located.locate(points[1]))});

  const Geodesic::Polyline line = located.locate_polyline(points);
  const Source polyline = polyline_source(line.locations);
  compare("polyline in space", points, {polyline});
  compare("polyline", line, {polyline});
  const std::vector<Point_3> other{point(90), point(95)};
  compare("polylines in space", std::vector<std::vector<Point_3>>{points, other},
          {polyline, polyline_source(located.locate_polyline(other).locations)});

  // closed: the last point is the first one
  const std::vector<Point_3> ring{point(40), point(47), point(61), point(40)};
  const Geodesic::Polyline closed = located.locate_polyline(ring, CGAL::parameters::is_closed(true));
  CHECK(closed.is_closed);
  compare("closed polyline in space", ring, {polyline_source(closed.locations, true)});

  compare("edges", edges, {edge_source(edges)});
  compare("edge", edges[0], {edge_source({edges[0]})});
  const std::vector<Source> all{edge_source(edges), point_source(vertices[0]), point_source(locations[0]), polyline};
  compare("source set", source_set(all), all);
  std::vector<double> distances(mesh().number_of_vertices());
  CHECK_THROWS(CGAL::geodesic_distances(mesh(), std::vector<Edge_index>(), CGAL::make_property_map(distances)),
               std::invalid_argument);
}

// A list of levels in braces, in all functions that have levels.
void lists_of_levels()
{
  Report::instance().set_context("lists of levels");
  const std::vector<Vertex_index> points{Vertex_index(0), Vertex_index(170)};
  Geodesic geodesic(mesh());
  for (const Vertex_index v : points) geodesic.add_source_point(v);
  geodesic.build(CGAL::parameters::keep_windows(true));
  const Offset_curves expected = offsets(geodesic, std::vector<double>{0.1, 0.2});
  CHECK(expected.size() >= 4);
  const auto check = [&](const Offset_curves& curves) {
    CHECK(curves.size() == expected.size() && curves.front().distance() == 0.1 && curves.back().distance() == 0.2);
    CHECK(std::abs(total_length(curves) - total_length(expected)) < 1e-12);
  };
  const auto check_written = [&](const auto& write) {
    Offset_curves curves;
    write(std::back_inserter(curves));
    check(curves);
  };
  check_written([&](auto out) { geodesic.offset_curves({0.2, 0.1}, out); });
  check_written([&](auto out) { geodesic.build().offset_curves({0.1, 0.2}, out); });
  check_written([&](auto out) { geodesic.build_with_offset_curves({0.1, 0.2}, out); });
  check_written([&](auto out) { CGAL::geodesic_offset_curves(mesh(), points, {0.1, 0.2}, out); });
  const auto check_received = [&](const auto& call) {
    Offset_curves curves;
    std::size_t levels = 0;
    call([&](double, Offset_curves&& some) {
      ++levels;
      curves.insert(curves.end(), some.begin(), some.end());
    });
    check(curves);
    CHECK(levels == 2);
  };
  check_received([&](auto f) { geodesic.offset_curves_by_distance({0.1, 0.2}, f); });
  check_received([&](auto f) { geodesic.build().offset_curves_by_distance({0.1, 0.2}, f); });
  check_received([&](auto f) { geodesic.build_with_offset_curves_by_distance({0.1, 0.2}, f); });
}

// The propagation for a side ends with its last curve, but not before all sources have started.
void last_curves()
{
  const Generated_mesh<Mesh> data(planar_grid(60, 6, Diagonals::alternating));
  const Geodesic::Mesh located(data.mesh);
  const auto line =
    located.locate_polyline(std::vector<Point_3>{Point_3(3, 0, 0), Point_3(3, 6, 0)}).locations; // 3 on its left
  const auto levels = CGAL::Offset_levels<double>::equally_spaced(0.4);
  for (const double start : {0., 25.})
    for (const CGAL::Offset_side side : {CGAL::Offset_side::LEFT, CGAL::Offset_side::RIGHT})
    {
      Report::instance().set_context("last curves, start value " + std::to_string(start));
      Source_set set;
      set.add_polyline(line);
      if (start > 0) set.add_location(located.locate(Point_3(59, 3, 0)), CGAL::parameters::start_value(start));
      Geodesic geodesic(located);
      geodesic.add_sources(set);
      const auto np = CGAL::parameters::offset_side(side);
      Offset_curves curves, expected;
      geodesic.build_with_offset_curves(levels, std::back_inserter(expected), np);
      double passed = 0;
      CGAL::geodesic_offset_curves(data.mesh, set, levels, std::back_inserter(curves), np.visitor([&](double part) {
        if (part < 1) passed = part;
        return true;
      }));
      CHECK_DETAIL(!curves.empty() && curves.size() == expected.size(), values(double(curves.size()), double(expected.size())));
      CHECK(std::abs(total_length(curves) - total_length(expected)) < 1e-9);
      if (start > 0) CHECK(curves.back().distance() > start);
      if (start > 0 || side == CGAL::Offset_side::RIGHT) CHECK_DETAIL(passed > 0.6, std::to_string(passed));
      else CHECK_DETAIL(0 < passed && passed < 0.2, std::to_string(passed)); // 3 of 60 on each side, and the front
    }
}

// Levels, sides, limits.
void parameters()
{
  Report::instance().set_context("parameters");
  const Geodesic::Mesh located(mesh());
  const std::vector<Point_3> points{mesh().point(Vertex_index(0)), mesh().point(Vertex_index(31))};
  Geodesic geodesic(located);
  geodesic.add_source_polyline(located.locate_polyline(points).locations);
  const auto np = CGAL::parameters::offset_side(CGAL::Offset_side::LEFT).end_style(CGAL::Offset_end::BUTT);
  Offset_curves curves, expected;
  geodesic.build_with_offset_curves(0.1, std::back_inserter(expected), np);
  CGAL::geodesic_offset_curves(mesh(), points, 0.1, std::back_inserter(curves), np);
  CHECK(curves.size() == expected.size() && curves.size() == 1 && !curves[0].is_closed());
  CHECK(std::abs(total_length(curves) - total_length(expected)) < 1e-13);
  curves.clear();
  CGAL::geodesic_offset_curves(mesh(), points, CGAL::Offset_levels<double>::equally_spaced(0.05), std::back_inserter(curves),
                               CGAL::parameters::distance_limit(0.22));
  CHECK(!curves.empty() && curves.back().distance() == 4 * 0.05);
  curves.clear();
  CHECK_THROWS(CGAL::geodesic_offset_curves(mesh(), points, -1., std::back_inserter(curves)), std::invalid_argument);
  CHECK_THROWS(CGAL::geodesic_offset_curves(mesh(), points, 0.1, std::back_inserter(curves),
                                            CGAL::parameters::offset_side(CGAL::Offset_side::INSIDE)),
               std::invalid_argument);
  CHECK(curves.empty());

  // paths: none from beyond a limit, one point on a source
  std::vector<Point_3> path;
  CGAL::shortest_path_to_sources(mesh(), Vertex_index(170), Vertex_index(3), std::back_inserter(path),
                                 CGAL::parameters::distance_limit(0.1));
  CHECK(path.empty());
  CGAL::shortest_path_to_sources(mesh(), mesh().point(Vertex_index(3)), Vertex_index(3), std::back_inserter(path));
  CHECK(path.size() == 1);
}

/// Whether a field has the distances of a build from a vertex alone.
bool is_from(const Geodesic::Field& field, Vertex_index v)
{
  return field.is_built() && field.distance_to_sources(v) == 0 && field.distance_to_sources(location(200, 0.2, 0.3)) > 0;
}

void fields()
{
  Report::instance().set_context("fields");
  const Vertex_index a(3), b(170);
  Geodesic::Field first, second;
  CHECK(!first.is_built());
  CHECK_THROWS(first.distance_to_sources(a), std::logic_error);
  CHECK_THROWS(first.mesh(), std::logic_error);
  CHECK_THROWS(first.statistics(), std::logic_error);
  CHECK_THROWS(first.gradient(a), std::logic_error);
  {
    Geodesic geodesic(mesh());
    CHECK_THROWS(geodesic.field(), std::logic_error);
    geodesic.add_source_point(a);
    first = geodesic.build(CGAL::parameters::keep_windows(true));
    geodesic.clear_sources();
    CHECK(is_from(geodesic.field(), a));
    geodesic.add_source_point(b);
    second = geodesic.build(CGAL::parameters::keep_windows(true));
    CHECK(is_from(first, a) && is_from(second, b) && is_from(geodesic.field(), b));
    CHECK(&geodesic.field().statistics() == &second.statistics());
    const Geodesic::Field last = geodesic.update();
    CHECK(is_from(last, b));
  }
  CHECK(is_from(first, a) && is_from(second, b)); // the object is gone
  const double between = first.distance_to_sources(b);
  CHECK(std::abs(between - second.distance_to_sources(a)) < 1e-13);

  std::vector<double> lengths(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < lengths.size(); ++i)
    threads.emplace_back([&, i, field = i % 2 ? first : second] {
      Offset_curves curves;
      field.offset_curves(0.3, std::back_inserter(curves));
      lengths[i] = total_length(curves);
    });
  for (std::thread& t : threads) t.join();
  CHECK(lengths[0] == lengths[2] && lengths[1] == lengths[3] && lengths[0] > 0);

  Geodesic::Field moved(std::move(first));
  CHECK(is_from(moved, a) && !first.is_built());
  CHECK_THROWS(first.distance_to_sources(a), std::logic_error);
  first = second;
  CHECK(is_from(first, b));

  // a callback that builds while a query goes on
  Geodesic geodesic = built(mesh(), {point_source(a)});
  std::size_t calls = 0;
  geodesic.offset_curves_by_distance(std::vector<double>{0.1, 0.2, 0.3}, [&](double, Offset_curves&& curves) {
    ++calls;
    CHECK(!curves.empty());
    geodesic.clear_sources();
    geodesic.build();
  });
  CHECK(calls == 3 && geodesic.distance_to_sources(a) == infinity);
}

// Labels are the ids of a source set, also if it has gaps; the sources of several sets in a range are numbered anew.
void ids_of_source_sets()
{
  Report::instance().set_context("ids of source sets");
  Source_set set;
  for (const unsigned v : {3u, 50u, 170u}) set.add_vertex(Vertex_index(v));
  set.remove(0);
  const auto labels = [](const auto& sources) {
    std::vector<std::size_t> result(mesh().number_of_vertices());
    CGAL::geodesic_voronoi_labels(mesh(), sources, CGAL::make_property_map(result));
    return result;
  };
  const std::vector<std::size_t> of_set = labels(set), of_sets = labels(std::vector<Source_set>{set});
  CHECK(of_set[50] == 1 && of_set[170] == 2);
  for (std::size_t i = 0; i < of_set.size(); ++i) CHECK(of_sets[i] + 1 == of_set[i] && (of_set[i] == 1 || of_set[i] == 2));
  CHECK(labels(CGAL::Geodesic_source_set<Mesh, float>(set)) == of_set); // with numbers of another type
  const auto diagram = CGAL::construct_geodesic_voronoi_diagram(mesh(), set);
  const Face_index of_first = mesh().face(mesh().halfedge(Vertex_index(50)));
  CHECK(diagram.source_at(Face_location(of_first, {{1. / 3, 1. / 3, 1. / 3}})) == 1u);

  // the next id of a converted set is that of the set
  CGAL::Geodesic_source_set<Mesh, float> converted(set);
  CHECK(converted.add_vertex(Vertex_index(0)) == 3 && converted.size() == 3);
}

void source_sets()
{
  Report::instance().set_context("source sets");
  Source_set set;
  CHECK(set.empty());
  CHECK(set.add_vertex(Vertex_index(3)) == 0 && set.add_location(location(10, 0.2, 0.3)) == 1 &&
        set.add_edges(std::vector<Edge_index>{Edge_index(4)}) == 2);
  set.remove(1);
  CHECK(set.add_polyline(std::vector<Face_location>{location(10, 0.2, 0.3), location(10, 0.3, 0.2)},
                         CGAL::parameters::is_closed(true)) == 3);
  CHECK(set.size() == 3 && set.sources().at(3).kind == Source_set::Kind::CLOSED_POLYLINE);
  CHECK_THROWS(set.remove(1), std::invalid_argument);

  // a set that does not fit the mesh adds nothing
  Geodesic geodesic(mesh());
  Source_set bad = set;
  bad.add_vertex(Vertex_index(100000));
  CHECK_THROWS(geodesic.add_sources(bad), std::invalid_argument);
  CHECK(geodesic.number_of_sources() == 0);
  std::vector<double> distances(mesh().number_of_vertices());
  CHECK_THROWS(CGAL::geodesic_distances(mesh(), bad, CGAL::make_property_map(distances)), std::invalid_argument);
  CHECK((geodesic.add_sources(set) == std::vector<std::size_t>{0, 1, 2}));
  CHECK((geodesic.add_sources(set) == std::vector<std::size_t>{3, 4, 5}));
  geodesic.remove_source(4);
  CHECK(geodesic.number_of_sources() == 5 && geodesic.sources().size() == 5);

  // a set may be that of the object itself
  Geodesic twice(geodesic.mesh());
  twice.add_sources(set);
  CHECK((twice.add_sources(twice.sources()) == std::vector<std::size_t>{3, 4, 5}));

  // the mesh is shared, also with certified bounds
  Geodesic other(geodesic.mesh());
  CGAL::Surface_mesh_geodesic_enclosure<Geodesic::Traits> bounds(geodesic.mesh());
  other.add_sources(set);
  bounds.add_sources(set);
  other.build();
  bounds.build();
  for (Vertex_index v : mesh().vertices())
  {
    const std::pair<double, double> d = bounds.distance_bounds(v);
    CHECK(d.first - 1e-14 <= other.distance_to_sources(v) && other.distance_to_sources(v) <= d.second + 1e-14);
  }
  set.clear();
  CHECK(set.empty() && set.add_vertex(Vertex_index(0)) == 4);
}

// Locations and points of a mesh with an exact kernel.
void other_kernels()
{
  Report::instance().set_context("other kernels");
  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact;
  typedef CGAL::Surface_mesh<Exact::Point_3> Exact_mesh;
  namespace PMP = CGAL::Polygon_mesh_processing;
  const Soup soup = rotated(torus(14, 9), 1);
  Exact_mesh exact;
  std::vector<Exact_mesh::Vertex_index> vertices;
  for (const Point_3& p : soup.points) vertices.push_back(exact.add_vertex(Exact::Point_3(p.x(), p.y(), p.z())));
  for (const auto& t : soup.triangles) exact.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  const auto c = [&](std::size_t i) { return exact.point(vertices[i]); };
  const Exact::Point_3 p = CGAL::centroid(c(soup.triangles[7][0]), c(soup.triangles[7][1]), c(soup.triangles[7][2]));
  const auto exact_location = PMP::locate(p, exact);

  typedef Geodesic_on<Exact_mesh> Geodesic_here;
  Geodesic_here geodesic(exact);
  geodesic.add_source_point(exact_location);
  geodesic.add_source_points(std::vector<std::decay_t<decltype(exact_location)>>{exact_location});
  const std::vector<std::decay_t<decltype(exact_location)>> exact_locations{exact_location};
  geodesic.add_source_polyline(exact_locations);
  geodesic.build(CGAL::parameters::keep_windows(true));
  CHECK(geodesic.distance_to_sources(exact_location) < 1e-15);
  std::vector<double> expected(exact.number_of_vertices()), found(expected);
  geodesic.vertex_distances(CGAL::make_property_map(expected));
  CGAL::geodesic_distances(exact, exact_location, CGAL::make_property_map(found));
  CHECK(found == expected);
  CGAL::geodesic_distances(exact, p, CGAL::make_property_map(found));
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(std::abs(found[i] - expected[i]) < 1e-14);
  std::vector<Geodesic_here::Face_location> path;
  geodesic.shortest_path_to_sources(exact_location, std::back_inserter(path));
  CHECK(path.size() == 1);

  Geodesic_here::Source_set set;
  CHECK(set.add_location(exact_location) == 0 && set.add_polyline(exact_locations) == 1);
  CGAL::geodesic_distances(exact, set, CGAL::make_property_map(found));
  CHECK(found == expected);

  CGAL::Surface_mesh_geodesic_enclosure<Geodesic_here::Traits> bounds(geodesic.mesh());
  CHECK(bounds.add_source_point(exact_location) == 0 && bounds.add_source_points(exact_locations).front() == 1 &&
        bounds.add_source_polyline(exact_locations) == 2);
  bounds.build();
  for (std::size_t i = 0; i < expected.size(); ++i)
    CHECK(std::abs(bounds.distance_bounds(vertices[i]).second - expected[i]) < 1e-13);

  // points in space and locations, for polylines
  const Exact::Point_3 q = c(soup.triangles[40][0]);
  const std::vector<Exact::Point_3> exact_points{p, q};
  const auto converted = [](const Exact::Point_3& x) {
    return Point_3(CGAL::to_double(x.x()), CGAL::to_double(x.y()), CGAL::to_double(x.z()));
  };
  const std::vector<Point_3> points{converted(p), converted(q)};
  CHECK(geodesic.locate(p) == geodesic.locate(points[0]) && geodesic.mesh().locate(p) == geodesic.locate(points[0]));
  CHECK(geodesic.locate_with_distance(p) == geodesic.locate_with_distance(points[0]));
  const auto line = geodesic.locate_polyline(points);
  CHECK(line.locations.size() > 2 && geodesic.locate_polyline(exact_points).locations == line.locations);
  const auto joined =
    geodesic.join_polyline(std::vector<std::decay_t<decltype(exact_location)>>{exact_location, PMP::locate(q, exact)});
  CHECK(joined.locations.size() == line.locations.size());
}

} // namespace test_free_functions

GEODESIC_OFFSET_TEST(test_free_functions)
{
  kinds_of_sources();
  lists_of_levels();
  last_curves();
  parameters();
  fields();
  ids_of_source_sets();
  source_sets();
  other_kernels();
  return Report::instance().finish("test_free_functions");
}
