// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Different descriptions of one source give the same distances; removal, distance limits, unreachable parts, invalid
// arguments.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "locations.h"
#include "test_check.h"

#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_source_kinds {

using namespace test;

typedef Geodesic::Face_location Face_location;
typedef test::Surface_mesh::Vertex_index Vertex_index;
typedef test::Surface_mesh::Halfedge_index Halfedge_index;
typedef test::Surface_mesh::Edge_index Edge_index;
typedef test::Locations<test::Surface_mesh> Locations;
typedef Generated_mesh<test::Surface_mesh> Data;

std::vector<double> vertex_distances(const Geodesic& geodesic, const test::Surface_mesh& mesh)
{
  std::vector<double> result;
  for (Vertex_index v : vertices(mesh)) result.push_back(geodesic.distance_to_sources(v));
  return result;
}
std::vector<double> distances(const test::Surface_mesh& mesh, const std::vector<Source>& sources)
{
  return vertex_distances(built(mesh, sources, false), mesh);
}

void check_same(const std::string& what, const test::Surface_mesh& mesh, const std::vector<double>& a,
                const std::vector<double>& b)
{
  Report::instance().set_context(what);
  Worst_error worst(1e-12, bounding_box_diagonal(mesh));
  CHECK(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK_CLOSE(worst, a[i], b[i]);
}

std::vector<double> minimum(const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back((std::min)(a[i], b[i]));
  return result;
}

Face_location opposite_description(const Locations& locations, const Face_location& location)
{
  for (auto f : locations.incident_faces(location))
    if (f != location.first)
    {
      Face_location result(f, {{0, 0, 0}});
      locations.express(location, f, result.second);
      return result;
    }
  return location;
}

// Inner and boundary halfedges that are not border halfedges.
std::vector<Halfedge_index> some_halfedges(const test::Surface_mesh& mesh, Random& random)
{
  std::vector<Halfedge_index> result;
  while (result.size() < 6)
  {
    const Halfedge_index h(static_cast<Halfedge_index::size_type>(uniform_index(random, num_halfedges(mesh))));
    if (!is_border(h, mesh)) result.push_back(h);
  }
  for (Halfedge_index h : halfedges(mesh))
    if (is_border(h, mesh) && result.size() < 9) result.push_back(opposite(h, mesh));
  return result;
}

// Different descriptions of the same sources around some halfedges.
void descriptions(const std::string& name, const test::Surface_mesh& mesh, unsigned seed)
{
  typedef std::vector<Face_location> Points;
  Random random(seed);
  const Locations locations(mesh);
  const auto of = [&](const std::vector<Source>& sources) { return distances(mesh, sources); };
  const auto same = [&](const char* what, const std::vector<double>& expected, const std::vector<Source>& sources) {
    check_same(name + ": " + what, mesh, of(sources), expected);
  };
  for (Halfedge_index h : some_halfedges(mesh, random))
  {
    const Vertex_index v = target(h, mesh), u = source(h, mesh);
    const Source at_v = point_source(v), at_u = point_source(u);
    const std::vector<double> from_v = of({at_v}), from_u = of({at_u});
    for (std::size_t turn = 0; turn < 3; ++turn)
      same("a vertex as a face location", from_v, {point_source(locations.at_vertex(v, turn))});
    same("duplicate vertices", from_v, {at_v, at_v, point_source(locations.at_vertex(v, 1))});
    same("adjacent vertices", minimum(from_u, from_v), {at_u, at_v});
    same("a polyline of one vertex", from_v, {polyline_source({locations.at_vertex(v)})});
    for (double t : {0.3, 0.5, 1e-9})
    {
      const Source on_edge = point_source(locations.on_edge(h, t)),
                   other = point_source(opposite_description(locations, on_edge.locations[0]));
      same("a point on an edge, from both faces", of({on_edge}), {other});
      same("a point on an edge, twice", of({on_edge}), {on_edge, other});
    }
    const Source inside = point_source(Face_location(face(h, mesh), random_barycentric(random)));
    same("duplicate points in a face", of({inside}), {inside, inside});
    same("a point in a face and a vertex of the face", minimum(of({inside}), from_v), {inside, at_v});

    // A path through the face of h with all kinds of places, from a vertex to an edge.
    const Points way = {locations.at_vertex(u, 2), Face_location(face(h, mesh), random_barycentric(random)),
                        locations.on_edge(h, 0.4), locations.on_edge(next(h, mesh), 0.7)};
    const std::vector<double> expected = of({polyline_source(way)});
    Points repeated, described, there_and_back = way;
    std::vector<Source> segments, and_points;
    for (std::size_t i = 0; i < way.size(); ++i)
    {
      repeated.insert(repeated.end(), 3, way[i]);
      described.push_back(opposite_description(locations, way[i]));
      and_points.push_back(point_source(way[i]));
      if (i > 0) segments.push_back(polyline_source({way[i - 1], way[i]}));
    }
    there_and_back.insert(there_and_back.end(), way.rbegin(), way.rend());
    and_points.push_back(polyline_source(there_and_back));
    same("repeated points", expected, {polyline_source(repeated)});
    same("points described from the other faces", expected, {polyline_source(described)});
    same("reversed", expected, {polyline_source(Points(way.rbegin(), way.rend()))});
    same("segment by segment", expected, segments);
    same("there and back, with its points added", expected, and_points);
    Points loop(way.begin() + 1, way.end());
    const std::vector<double> closed = of({polyline_source(loop, true)});
    loop.push_back(loop.front());
    same("closed, or with the first point repeated", closed, {polyline_source(loop)});
    Geodesic both(mesh); // closed and with the first point repeated
    both.add_source_polyline(loop, CGAL::parameters::is_closed(true));
    both.build();
    check_same(name + ": closed and with the first point repeated", mesh, vertex_distances(both, mesh), closed);

    // A walk along edges, turning left and right.
    std::vector<Edge_index> edges;
    std::vector<Source> twice;
    Points along = {locations.at_vertex(u)};
    Halfedge_index g = h;
    for (int i = 0; i < 6; ++i)
    {
      edges.push_back(edge(g, mesh));
      twice.push_back(edge_source({edges.back(), edges.back()}));
      along.push_back(locations.at_vertex(target(g, mesh), 3));
      g = next(g, mesh);
      if (i % 2 != 0 && !is_border(opposite(g, mesh), mesh)) g = next(opposite(g, mesh), mesh);
    }
    const std::vector<double> from_edges = of({edge_source(edges)});
    same("edges and the polyline along them", from_edges, {polyline_source(along)});
    same("edges twice, one source each", from_edges, twice);
    for (Edge_index e : edges) CHECK(from_edges[mesh.vertex(e, 0)] == 0 && from_edges[mesh.vertex(e, 1)] == 0);
  }
}

// The whole boundary of a rectangle as a source: the distance is that from the nearest side.
void boundary_sources()
{
  for (unsigned seed : {1u, 2u, 3u})
  {
    const Soup soup = random_rectangle(2, 1, 200, 8, seed);
    const Data data(rotated(soup, seed));
    std::vector<Edge_index> border;
    for (Edge_index e : edges(data.mesh))
      if (is_border(e, data.mesh)) border.push_back(e);
    const std::vector<double> actual = distances(data.mesh, {edge_source(border)});
    Report::instance().set_context("all boundary edges, seed " + std::to_string(seed));
    Worst_error worst(1e-12, 2);
    for (std::size_t i = 0; i < actual.size(); ++i)
    {
      const double x = soup.points[i].x(), y = soup.points[i].y();
      CHECK_CLOSE(worst, actual[i], (std::max)(0., (std::min)((std::min)(x, 2 - x), (std::min)(y, 1 - y))));
    }
  }
}

void removal()
{
  const Data data(rotated(random_rectangle(2, 1, 150, 8, 5), 5));
  const Vertex_index u = data.vertices[10], v = data.vertices[100];
  const std::vector<double> from_u = distances(data.mesh, {point_source(u)});
  const std::vector<double> from_v = distances(data.mesh, {point_source(v)});

  Geodesic geodesic(data.mesh);
  CHECK(geodesic.number_of_sources() == 0 && !geodesic.is_built());
  const std::size_t first = geodesic.add_source_point(u);
  const std::size_t second = geodesic.add_source_point(v);
  CHECK(first != second && geodesic.number_of_sources() == 2);
  const auto all = [&]() {
    geodesic.build();
    return vertex_distances(geodesic, data.mesh);
  };
  check_same("both sources", data.mesh, all(), minimum(from_u, from_v));
  CHECK(geodesic.is_built());
  check_same("built again", data.mesh, all(), minimum(from_u, from_v));
  geodesic.remove_source(first);
  CHECK(geodesic.number_of_sources() == 1);
  check_same("after removal of the first", data.mesh, all(), from_v);
  const std::size_t third = geodesic.add_source_point(u);
  CHECK(third != first && third != second);
  check_same("after addition", data.mesh, all(), minimum(from_u, from_v));
  geodesic.remove_source(second);
  check_same("after removal of the second", data.mesh, all(), from_u);
  geodesic.clear_sources();
  CHECK(geodesic.number_of_sources() == 0);
  geodesic.add_source_point(v);
  check_same("after clearing", data.mesh, all(), from_v);

  std::vector<double> in_map(num_vertices(data.mesh), -1);
  geodesic.vertex_distances(CGAL::make_property_map(in_map));
  check_same("through a property map", data.mesh, in_map, from_v);
}

// Distances are correct up to the maximum distance, inclusive, and infinite beyond it.
void distance_limit()
{
  const std::size_t n = 20;
  const Data data(planar_grid(n, n, Diagonals::alternating));
  for (double maximum : {5., 1., 0.3, 13.0000001, 100.})
  {
    Report::instance().set_context("maximum distance " + std::to_string(maximum));
    Geodesic geodesic(data.mesh);
    geodesic.add_source_point(data.vertices[0]);
    geodesic.build(CGAL::parameters::distance_limit(maximum));
    Worst_error worst(1e-12, 0);
    std::size_t reached = 0, at_maximum = 0;
    for (std::size_t i = 0; i < data.vertices.size(); ++i)
    {
      const double x = static_cast<double>(i % (n + 1)), y = static_cast<double>(i / (n + 1));
      const double exact = std::hypot(x, y);
      if ((x == 0 || y == 0) && exact == maximum) ++at_maximum;
      // Distances that equal the maximum up to rounding may be on either side, except along the edges of the grid, where
      // nothing is rounded.
      const bool is_near = std::abs(exact - maximum) < 1e-12 * maximum && x != 0 && y != 0;
      const double actual = geodesic.distance_to_sources(data.vertices[i]);
      if (is_near && std::isinf(actual)) continue;
      reached += exact <= maximum ? 1 : 0;
      CHECK_CLOSE(worst, actual, (exact <= maximum || is_near) ? exact : infinity);
    }
    CHECK(reached > 0);
    if (maximum == 5 || maximum == 1) CHECK(at_maximum == 2);
    geodesic.build();
    CHECK(std::isfinite(geodesic.distance_to_sources(data.vertices.back())));
  }
  Report::instance().set_context("maximum distance with kept windows");
  Geodesic geodesic(data.mesh);
  geodesic.add_source_point(data.vertices[0]);
  geodesic.build(CGAL::parameters::distance_limit(5.).keep_windows(true));
  const Locations locations(data.mesh);
  Random random(3);
  for (auto f : faces(data.mesh))
  {
    const Face_location l(f, random_barycentric(random));
    const double exact = std::sqrt(CGAL::squared_distance(locations.point(l), Point_3(0, 0, 0)));
    const double actual = geodesic.distance_to_sources(l);
    CHECK_DETAIL(exact <= 5 ? std::abs(actual - exact) < 1e-12 * exact : std::isinf(actual), values(actual, exact));
  }
}

// Invalid arguments are rejected, and leave the object usable.
void bad_arguments()
{
  Report::instance().set_context("bad arguments");
  const Data data(planar_grid(6, 6));
  const Locations locations(data.mesh);
  Geodesic geodesic(data.mesh);
  const std::vector<Face_location> jump = {Face_location(data.faces.front(), {{0.2, 0.3, 0.5}}),
                                           Face_location(data.faces.back(), {{0.2, 0.3, 0.5}})};
  CHECK_THROWS(geodesic.add_source_polyline(jump), std::invalid_argument);
  CHECK(geodesic.number_of_sources() == 0);
  geodesic.add_source_point(data.vertices[0]);
  geodesic.build();
  std::vector<Geodesic::Offset_curve> curves;
  for (double bad : {0., -1., std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS(geodesic.offset_curves(bad, std::back_inserter(curves)), std::invalid_argument);
  CHECK(curves.empty());
  CHECK(std::abs(geodesic.distance_to_sources(data.vertices.back()) - std::hypot(6., 6.)) < 1e-12);

  // vertices of another mesh
  typedef test::Surface_mesh::Vertex_index Vertex_index;
  geodesic.build(CGAL::parameters::relative_tolerance(1e-6));
  for (const Vertex_index bad : {test::Surface_mesh::null_vertex(), Vertex_index(100000)})
  {
    CHECK_THROWS(geodesic.add_source_point(bad), std::invalid_argument);
    CHECK_THROWS(geodesic.distance_to_sources(bad), std::invalid_argument);
    CHECK_THROWS(geodesic.gradient(bad), std::invalid_argument);
    CHECK_THROWS(geodesic.error_bound(bad), std::invalid_argument);
    CHECK_THROWS(geodesic.build(CGAL::parameters::targets(std::vector<Vertex_index>{bad})), std::invalid_argument);
  }

  // an edge without a face
  test::Surface_mesh more = data.mesh;
  const auto alone = more.edge(more.add_edge(more.add_vertex(Point_3(9, 9, 9)), more.add_vertex(Point_3(8, 9, 9))));
  Geodesic on_more(more);
  CHECK_THROWS(on_more.add_source_edges(std::vector<test::Surface_mesh::Edge_index>{alone}), std::invalid_argument);
  CHECK(on_more.number_of_sources() == 0);
}

// A point of a polyline on an edge, repeated as a location in the adjacent face, is no corner.
void points_with_two_names()
{
  Report::instance().set_context("points with two names");
  test::Surface_mesh mesh;
  const auto a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(2, 0, 0)),
             c = mesh.add_vertex(Point_3(1, 1, 0)), d = mesh.add_vertex(Point_3(1, -1, 0)),
             e = mesh.add_vertex(Point_3(2, 1, 0));
  const auto upper = mesh.add_face(a, b, c), lower = mesh.add_face(b, a, d);
  mesh.add_face(c, b, e);
  const auto at = [&](auto face, std::array<double, 4> weights) // of a, b, c, d
  {
    Face_location l(face, {{0, 0, 0}});
    auto h = mesh.halfedge(face);
    for (int k = 0; k < 3; ++k, h = mesh.next(h)) l.second[k] = weights[std::size_t(mesh.source(h))];
    return l;
  };
  // (0.5, 0), (1, 0), (0.5, -0.5)
  const Face_location first = at(lower, {{0.75, 0.25, 0, 0}}), middle = at(lower, {{0.5, 0.5, 0, 0}}),
                      same = at(upper, {{0.5, 0.5, 0, 0}}), last = at(lower, {{0.5, 0, 0, 0.5}});
  for (std::vector<Face_location> line :
       {std::vector<Face_location>{first, middle, last},
        {first, middle, middle, last},
        {first, middle, same, last},
        {first, same, middle, same, last}})
    for (const bool reversed : {false, true})
    {
      if (reversed) std::reverse(line.begin(), line.end());
      Geodesic geodesic(mesh);
      geodesic.add_source_polyline(line);
      geodesic.build();
      CHECK(std::abs(geodesic.distance_to_sources(c) - 1) < 1e-14);
      CHECK(std::abs(geodesic.distance_to_sources(e) - std::sqrt(2.)) < 1e-14);
    }
}

// Meshes of any size within the range of the number type; others are rejected.
void scales()
{
  Report::instance().set_context("scales");
  const Data data(rotated(random_rectangle(2, 1, 60, 5, 3), 3));
  const Source edges = edge_source({Edge_index(5), Edge_index(22), Edge_index(39)});
  const std::vector<double> expected = distances(data.mesh, {edges});
  for (const int exponent : {-250, -100, 48, 60, 100, 250})
  {
    test::Surface_mesh scaled = data.mesh;
    const double scale = std::ldexp(1., exponent);
    for (const auto v : scaled.vertices()) scaled.point(v) = CGAL::ORIGIN + scale * (scaled.point(v) - CGAL::ORIGIN);
    const std::vector<double> actual = distances(scaled, {edges});
    for (std::size_t i = 0; i < expected.size(); ++i) CHECK(actual[i] == scale * expected[i]);
  }
  for (const int exponent : {-500, -270, 270, 400})
  {
    test::Surface_mesh scaled = data.mesh;
    for (const auto v : scaled.vertices())
      scaled.point(v) = CGAL::ORIGIN + std::ldexp(1., exponent) * (scaled.point(v) - CGAL::ORIGIN);
    std::string message = "nothing was thrown";
    try
    {
      Geodesic geodesic(scaled);
    }
    catch (const std::invalid_argument& e)
    {
      message = e.what();
    }
    CHECK_DETAIL(message.find("must be scaled") != std::string::npos, message);
  }
}

// Several points in one call: each is a separate source.
void sets_of_points()
{
  Report::instance().set_context("sets of points");
  const Data data(rotated(random_rectangle(2, 1, 60, 5, 3), 3));
  Random random(1);
  const std::vector<Vertex_index> some = {data.vertices[3], data.vertices[7], data.vertices[3]};
  std::vector<Face_location> locations;
  for (int i = 0; i < 4; ++i)
    locations.push_back(Face_location(data.faces[uniform_index(random, data.faces.size())], random_barycentric(random)));

  Geodesic at_once(data.mesh), one_by_one(data.mesh);
  CHECK((at_once.add_source_points(some) == std::vector<std::size_t>{0, 1, 2}));
  CHECK(at_once.add_source_points(std::vector<Face_location>()).empty());
  CHECK((at_once.add_source_points(locations) == std::vector<std::size_t>{3, 4, 5, 6}));
  for (Vertex_index v : some) one_by_one.add_source_point(v);
  for (const Face_location& l : locations) one_by_one.add_source_point(l);
  CHECK(at_once.number_of_sources() == 7);
  at_once.build();
  one_by_one.build();
  for (Vertex_index v : data.vertices)
    CHECK(at_once.distance_to_sources(v) == one_by_one.distance_to_sources(v) &&
          at_once.nearest_source(v)->source == one_by_one.nearest_source(v)->source);

  // all or none
  CHECK_THROWS(at_once.add_source_points(std::vector<Vertex_index>{some[0], Vertex_index(100000)}), std::invalid_argument);
  locations.push_back(Face_location(data.faces[0], {{2, -0.5, -0.5}}));
  CHECK_THROWS(at_once.add_source_points(locations), std::invalid_argument);
  CHECK(at_once.number_of_sources() == 7);
}

// A square ring, and separate from it a square and a tetrahedron; with edges without faces.
void boundaries()
{
  Report::instance().set_context("boundaries");
  test::Surface_mesh mesh;
  const auto square = [&mesh](double x, double low, double high) {
    std::vector<Vertex_index> v;
    for (const auto& p : {Point_2(low, low), Point_2(high, low), Point_2(high, high), Point_2(low, high)})
      v.push_back(mesh.add_vertex(Point_3(x + p.x(), p.y(), 0)));
    return v;
  };
  const std::vector<Vertex_index> outer = square(0, -4, 4), inner = square(0, -1, 1), apart = square(20, -1, 1);
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t j = (i + 1) % 4;
    mesh.add_face(outer[i], outer[j], inner[i]);
    mesh.add_face(outer[j], inner[j], inner[i]);
  }
  mesh.add_face(apart[0], apart[1], apart[2]);
  mesh.add_face(apart[0], apart[2], apart[3]);
  CGAL::make_tetrahedron(Point_3(40, 0, 0), Point_3(41, 0, 0), Point_3(40, 1, 0), Point_3(40, 0, 1), mesh);
  const auto border_at = [&](Vertex_index v) {
    for (Halfedge_index h : CGAL::halfedges_around_target(v, mesh))
      if (is_border(h, mesh)) return h;
    return Halfedge_index();
  };
  const auto zeros = [&](const Geodesic& g) {
    std::vector<Vertex_index> result;
    for (Vertex_index v : mesh.vertices())
      if (g.distance_to_sources(v) == 0) result.push_back(v);
    return result;
  };
  const auto check = [&] {
    Geodesic geodesic(mesh);
    const std::vector<std::size_t> ids = geodesic.add_source_boundary();
    CHECK((ids == std::vector<std::size_t>{0, 1, 2}) && geodesic.number_of_sources() == 3);
    geodesic.build(CGAL::parameters::keep_windows(true));
    CHECK(zeros(geodesic).size() == 12);
    std::set<std::size_t> sources;
    for (const auto& cycle : {outer, inner, apart})
    {
      const std::size_t source = geodesic.nearest_source(cycle[0])->source;
      sources.insert(source);
      for (Vertex_index v : cycle) CHECK(geodesic.nearest_source(v)->source == source);
    }
    CHECK(sources.size() == 3);
    // as far from two sides of the ring as from an inner corner
    CHECK(std::abs(geodesic.largest_distance().value() - (6 - std::sqrt(18.))) < 1e-14);

    Geodesic one(mesh);
    CHECK(one.add_source_boundary(border_at(inner[2])) == 0);
    one.build();
    CHECK((zeros(one) == inner));
    CHECK(std::isinf(one.distance_to_sources(apart[0])));
    CHECK_THROWS(one.add_source_boundary(opposite(border_at(inner[2]), mesh)), std::invalid_argument);
    CHECK(one.number_of_sources() == 1);
  };
  check();

  // an edge attached to the ring, and an isolated one
  const auto add_edge = [&mesh](Vertex_index a, Vertex_index b) {
    const Halfedge_index h = mesh.add_edge(a, b), g = mesh.opposite(h);
    mesh.set_next(h, g);
    mesh.set_next(g, h);
    mesh.set_halfedge(b, h);
    return h;
  };
  const Vertex_index end = mesh.add_vertex(Point_3(-9, -9, 0)), a = mesh.add_vertex(Point_3(-9, 9, 0)),
                     b = mesh.add_vertex(Point_3(-9, 10, 0));
  const Halfedge_index before = border_at(outer[0]), after = mesh.next(before), hanging = add_edge(outer[0], end);
  mesh.set_next(before, hanging);
  mesh.set_next(mesh.opposite(hanging), after);
  const Halfedge_index alone = add_edge(a, b);
  mesh.set_halfedge(a, mesh.opposite(alone));
  CHECK(mesh.is_valid());
  check();
  Geodesic geodesic(mesh);
  CHECK_THROWS(geodesic.add_source_boundary(alone), std::invalid_argument);

  const Data closed(icosphere(1));
  Geodesic on_closed(closed.mesh);
  CHECK(on_closed.add_source_boundary().empty() && on_closed.number_of_sources() == 0);
}

void sharp_edges()
{
  Report::instance().set_context("sharp edges");
  const auto edges_of = [](const test::Surface_mesh& mesh, double angle) {
    std::vector<Edge_index> edges;
    Geodesic(mesh).sharp_edges(angle, std::back_inserter(edges));
    return edges;
  };
  const auto number = [&](const Soup& soup, double angle) { return edges_of(Data(soup).mesh, angle).size(); };

  // closed forms
  CHECK(number(cube_grid(3), 90) == 0 && number(cube_grid(3), 0) == 36);
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    const double margin = 1e-11;
    CHECK(number(rotated(cube_grid(3), seed), 90 + margin) == 0);
    CHECK(number(rotated(cube_grid(3), seed), 90 - margin) == 36);
    CHECK(number(rotated(cube_grid(3), seed), margin) == 36);
    CHECK(number(rotated(icosphere(0), seed), 41.810314895778598 - margin) == 30);
    CHECK(number(rotated(icosphere(0), seed), 41.810314895778598 + margin) == 0);
    CHECK(number(rotated(planar_grid(5, 4), seed), margin) == 0); // borders are not sharp
  }
  for (const double angle : {1e-9, 1e-5, 0.1, 30., 89., 91., 179.9999, 180 - 1e-9})
    for (const double height : {1., 1e-6, 1e3})
    {
      // two faces with the common edge from (0, 0, 0) to (1, 0, 0)
      const double a = angle * CGAL_PI / 180;
      Soup soup;
      soup.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.3, -height, 0),
                     Point_3(0.6, height * std::cos(a), height * std::sin(a))};
      soup.add_triangle({{1, 0, 2}});
      soup.add_triangle({{0, 1, 3}});
      CHECK(number(soup, angle * (1 - 1e-4)) == 1);
      CHECK(number(soup, (std::min)(angle * (1 + 1e-4), (180 + angle) / 2)) == 0);
    }

  // as sources
  const Data box(rotated(cube_grid(4), 2));
  Geodesic geodesic(box.mesh);
  CHECK(!geodesic.add_source_sharp_edges(91) && geodesic.number_of_sources() == 0);
  CHECK(geodesic.add_source_sharp_edges(60) == std::size_t(0) && geodesic.number_of_sources() == 1);
  geodesic.build(CGAL::parameters::keep_windows(true));
  const Geodesic by_edges = built(box.mesh, {edge_source(edges_of(box.mesh, 60))}, false);
  for (Vertex_index v : box.vertices) CHECK(geodesic.distance_to_sources(v) == by_edges.distance_to_sources(v));
  CHECK(std::abs(geodesic.largest_distance().value() - 0.5) < 1e-14);

  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double angle : {-1e-9, 180., 1e9, nan, infinity, -infinity})
  {
    CHECK_THROWS(geodesic.add_source_sharp_edges(angle), std::invalid_argument);
    CHECK_THROWS(edges_of(box.mesh, angle), std::invalid_argument);
  }
  CHECK(geodesic.number_of_sources() == 1);
}

} // namespace test_source_kinds

GEODESIC_OFFSET_TEST(test_source_kinds)
{
  std::vector<std::pair<std::string, std::function<void()>>> tests = {
    {"boundary sources", boundary_sources},
    {"removal", removal},
    {"distance limit", distance_limit},
    {"bad arguments", bad_arguments},
    {"two names", points_with_two_names},
    {"scales", scales},
    {"sets of points", sets_of_points},
    {"boundaries", boundaries},
    {"sharp edges", sharp_edges}};
  const std::pair<const char*, Soup> meshes[] = {
    {"rectangle", rotated(random_rectangle(2, 1, 120, 8, 1), 1)},
    {"grid", planar_grid(10, 8, Diagonals::alternating)},
    {"box", rotated(box_sides(1, 0.7, 0.4).triangulated(25, 3, 2), 2)},
    {"saddle", Cone(8, 3 * CGAL_PI, 1).triangulated(20, 3, 3)},
    {"icosphere", icosphere(2)},
    {"genus 5", marching_genus_5(8)},
    {"L", l_shape(50, 4, 4)}};
  for (const auto& mesh : meshes)
    tests.emplace_back(mesh.first, [&mesh] { descriptions(mesh.first, Data(mesh.second).mesh, 17); });
  return run_tests("test_source_kinds", tests);
}
