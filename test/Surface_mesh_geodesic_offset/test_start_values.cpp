// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Start values of sources: far apart, with tolerances, of functions that find their sources, of other number types, bad ones.
// test_properties compares fields with start values with the fields of single sources.

#include "data_meshes.h"
#include "generated_meshes.h"
#include "path_tools.h"
#include "test_check.h"

#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_start_values {

using namespace test;

// Tolerance of distances: those of both builds, each relative to the distance and the longest edge, which the needles need.
double tolerance(double d, double size) { return 1e-12 * (std::max)(d, size); }

// Start values far apart on two spheres, one of which only the sources with the large values reach.
void far_apart()
{
  Soup soup = icosphere(1);
  const std::size_t n = soup.points.size(), m = soup.triangles.size();
  for (std::size_t i = 0; i < n; ++i) soup.points.push_back(soup.points[i] + Kernel::Vector_3(5, 0, 0));
  for (std::size_t i = 0; i < m; ++i)
  {
    const auto t = soup.triangles[i];
    soup.add_triangle({{t[0] + n, t[1] + n, t[2] + n}});
  }
  const Generated_mesh<Surface_mesh> data(soup);
  for (const double s : {3., 1e4, 1e9, 1e200})
  {
    Report::instance().set_context("start value " + std::to_string(s));
    Geodesic geodesic(data.mesh);
    geodesic.add_source_point(data.vertices[3]);
    geodesic.add_source_point(data.vertices[4], CGAL::parameters::start_value(s));
    geodesic.add_source_point(data.vertices[3 + n], CGAL::parameters::start_value(s));
    geodesic.build(CGAL::parameters::keep_windows(true).compute_largest_distance(true));
    for (std::size_t i = 0; i < n; ++i)
    {
      const double d = geodesic.distance_to_sources(data.vertices[i]), e = geodesic.distance_to_sources(data.vertices[i + n]);
      CHECK_DETAIL(d <= CGAL_PI && std::abs(e - (s + d)) <= 1e-13 * e, values(d, e));
    }
    CHECK(std::abs(geodesic.largest_distance().value() - (s + 3)) <= 1);
    const double d = s + 1, limit = s + 1.5;
    const Offset_curves kept = offsets(geodesic, d);
    Offset_curves passed;
    geodesic.build_with_offset_curves(d, std::back_inserter(passed), CGAL::parameters::distance_limit(limit));
    CHECK(kept.size() == passed.size() && kept.size() == (s < 1e15 ? 1u : 0u));
    if (kept.size() == 1 && s < 1e5)
      CHECK_DETAIL(std::abs(kept[0].length() - 2 * CGAL_PI * std::sin(1.)) <= 0.5, std::to_string(kept[0].length()));
    geodesic.build(CGAL::parameters::distance_limit(s / 2));
    CHECK(std::isinf(geodesic.distance_to_sources(data.vertices[3 + n])));
  }
}

// A flat convex quadrilateral of two faces, where distances have a closed form. A build with a tolerance merges the strip of
// the edge with the rays around the end of the edge. In the second face, the merged window gives less than the start value of
// the edge. Where the vertex is the nearest source, the distance may be less than that from the vertex, but not more.
void tolerances()
{
  Soup soup;
  soup.points = {Point_3(0, 0, 0), Point_3(2, 0, 0), Point_3(4, 1, 0), Point_3(1, 1, 0)};
  soup.add_triangle({{0, 1, 2}});
  soup.add_triangle({{0, 2, 3}});
  const Generated_mesh<Surface_mesh> data(soup);
  const Mesh_locations locations(data.mesh);
  const double of_vertex = 3, of_edge = 3.8;
  const std::vector<Surface_mesh::Edge_index> edges = {edge(data.mesh.halfedge(data.vertices[0], data.vertices[1]), data.mesh)};
  Geodesic geodesic(data.mesh);
  geodesic.add_source_edges(edges, CGAL::parameters::start_value(of_edge));
  geodesic.add_source_point(data.vertices[3], CGAL::parameters::start_value(of_vertex));
  Random random(1);
  Path_locations points = {locations.in_triangle(data, soup, 1, {{0.6, 0.2, 0.2}})}; // exact distance: 3.6
  for (std::size_t i = 0; i < 300; ++i) points.push_back(random_location(locations, data.mesh, random, i % 3));
  for (const auto& [relative, length] : {std::pair(0., 0.), std::pair(0.5, 0.), std::pair(0., 1.), std::pair(0.1, 0.5)})
  {
    Report::instance().set_context("tolerances " + std::to_string(relative) + ", " + std::to_string(length));
    geodesic.build(CGAL::parameters::relative_tolerance(relative).merging_tolerance(length).keep_windows(true));
    const auto& s = geodesic.statistics();
    CHECK((s.windows_merged > 0) == (relative + length > 0)); // without merged windows, the test has no effect
    for (const Face_location& l : points)
    {
      const Point_3 p = locations.point(l);
      const double by_edge = of_edge + std::hypot((std::max)(0., p.x() - 2), p.y()),
                   by_vertex = of_vertex + std::hypot(p.x() - 1, p.y() - 1), expected = (std::min)(by_edge, by_vertex),
                   allowed = tolerance(expected, 4), d = geodesic.distance_to_sources(l);
      CHECK_DETAIL(d <= expected + allowed, values(d, expected));
      CHECK_DETAIL(d >= expected - s.error_bound - allowed, values(d, expected));
      CHECK_DETAIL(d >= expected - relative * expected - length - allowed, values(d, expected));
    }
  }
  // The edge alone. It has no sides, and points nearer than its start value are not on it.
  Report::instance().set_context("tolerances, one source");
  Geodesic alone(data.mesh);
  alone.add_source_edges(edges, CGAL::parameters::start_value(of_edge));
  alone.build(CGAL::parameters::merging_tolerance(1).keep_windows(true));
  std::size_t nearer = 0;
  for (const Face_location& l : points)
  {
    const Point_3 p = locations.point(l);
    const bool is_on_edge = std::hypot((std::max)(0., p.x() - 2), p.y()) <= tolerance(of_edge, 4);
    if (!is_on_edge && alone.distance_to_sources(l) < of_edge) ++nearer;
    CHECK(alone.signed_distance_to_sources(l).has_value() == is_on_edge);
    CHECK(alone.gradient(l).has_value() == !is_on_edge);
  }
  CHECK(nearer > 0);
}

// The functions that find their sources themselves add the start value to the distances of all of them.
void found_sources()
{
  Report::instance().set_context("start values of found sources");
  const Generated_mesh<Surface_mesh> data(cube_grid(3)), open(planar_grid(4, 3, Diagonals::alternating));
  const Surface_mesh::Halfedge_index border =
    halfedge(*std::find_if(open.mesh.edges().begin(), open.mesh.edges().end(),
                           [&](Surface_mesh::Edge_index e) { return is_border(e, open.mesh); }),
             open.mesh);
  const auto start = CGAL::parameters::start_value(1.5);
  typedef std::function<void(Geodesic&, bool)> Add;
  const std::pair<const Surface_mesh*, Add> cases[] = {
    {&data.mesh, [&](Geodesic& g, bool s) { s ? g.add_source_sharp_edges(60, start) : g.add_source_sharp_edges(60); }},
    {&data.mesh,
     [&](Geodesic& g, bool s) {
       const Geodesic::Plane_3 plane(0.25, 1, 0.5, -0.6);
       s ? g.add_source_plane_section(plane, start) : g.add_source_plane_section(plane);
     }},
    {&data.mesh,
     [&](Geodesic& g, bool s) { // touches vertices and edges
       const Geodesic::Plane_3 plane(0, 0, 1, 0);
       s ? g.add_source_plane_section(plane, start) : g.add_source_plane_section(plane);
     }},
    {&open.mesh, [&](Geodesic& g, bool s) { s ? g.add_source_boundary(start) : g.add_source_boundary(); }},
    {&open.mesh, [&](Geodesic& g, bool s) {
       const auto h = is_border(border, open.mesh) ? border : opposite(border, open.mesh);
       s ? g.add_source_boundary(h, start) : g.add_source_boundary(h);
     }}};
  for (const auto& [mesh, add] : cases)
  {
    Geodesic with(*mesh), without(*mesh);
    add(with, true);
    add(without, false);
    CHECK(with.number_of_sources() > 0);
    with.build();
    without.build();
    for (const auto v : mesh->vertices())
    {
      const double d = with.distance_to_sources(v), expected = 1.5 + without.distance_to_sources(v);
      CHECK_DETAIL(std::abs(d - expected) <= tolerance(expected, 1), values(d, expected));
    }
  }
}

// Sets and start values of other number types are converted.
void other_number_types()
{
  Report::instance().set_context("start values of other number types");
  const Generated_mesh<Surface_mesh> data(icosphere(1));
  typedef CGAL::Exact_predicates_exact_constructions_kernel::FT Exact;
  CGAL::Geodesic_source_set<Surface_mesh, Exact> set;
  set.add_vertex(data.vertices[3], CGAL::parameters::start_value(Exact(1) / Exact(3)));
  Geodesic geodesic(data.mesh);
  CHECK(geodesic.add_sources(set).size() == 1);
  geodesic.add_source_point(data.vertices[5], CGAL::parameters::start_value(Exact(0.25)));
  geodesic.build();
  CHECK(std::abs(geodesic.distance_to_sources(data.vertices[3]) - 1. / 3) <= 1e-16);
  CHECK(geodesic.distance_to_sources(data.vertices[5]) == 0.25);
}

void bad_values()
{
  Report::instance().set_context("bad start values");
  const Generated_mesh<Surface_mesh> data(icosphere(0));
  Geodesic geodesic(data.mesh);
  for (const double s : {-1e-300, -1., infinity, std::numeric_limits<double>::quiet_NaN()})
  {
    bool thrown = false;
    try
    {
      geodesic.add_source_point(data.vertices[0], CGAL::parameters::start_value(s));
    }
    catch (const std::invalid_argument&)
    {
      thrown = true;
    }
    CHECK_DETAIL(thrown && geodesic.number_of_sources() == 0, std::to_string(s));
  }
  geodesic.add_source_point(data.vertices[0], CGAL::parameters::start_value(2)); // an integer
  geodesic.add_source_point(data.vertices[1], CGAL::parameters::start_value(1.75));
  geodesic.build(CGAL::parameters::distance_limit(1));
  CHECK(geodesic.distance_to_sources(data.vertices[0]) == infinity &&
        geodesic.distance_to_sources(data.vertices[1]) == infinity);
  geodesic.build(CGAL::parameters::distance_limit(1.8));
  CHECK(geodesic.distance_to_sources(data.vertices[0]) == infinity && geodesic.distance_to_sources(data.vertices[1]) == 1.75);
  // the free functions read them from a set
  std::vector<double> distance(data.mesh.number_of_vertices());
  CGAL::geodesic_distances(data.mesh, geodesic.sources(), CGAL::make_property_map(distance));
  CHECK(distance[data.vertices[1].idx()] == 1.75);
}

// A polyline along edges of a plane, with a start value at each of its points, linear between them.
struct Varying_polyline
{
  std::vector<Point_3> points;
  std::vector<double> starts;
  bool is_closed;

  std::size_t number_of_segments() const { return points.size() - (is_closed ? 0 : 1); }

  // The least of s(t) + |p - q(t)| on segment i, and the parameter where it is attained.
  std::pair<double, double> distance(const Point_3& p, std::size_t i) const
  {
    const std::size_t j = (i + 1) % points.size();
    const Vector_3 u = points[j] - points[i], w = p - points[i];
    const double l = std::sqrt(u.squared_length()), m = (starts[j] - starts[i]) / l, x = (w * u) / l;
    const double y = std::sqrt(CGAL::cross_product(u, w).squared_length()) / l;
    double t = m >= 1 ? 0 : m <= -1 ? l : x - y * m / std::sqrt((1 - m) * (1 + m));
    t = (std::max)(0., (std::min)(l, t));
    return {starts[i] + m * t + std::hypot(x - t, y), t / l};
  }

  double distance(const Point_3& p) const
  {
    double least = infinity;
    for (std::size_t i = 0; i < number_of_segments(); ++i) least = (std::min)(least, distance(p, i).first);
    return least;
  }

  // The start value at a point of the polyline, and its distance from it.
  std::pair<double, double> start_at(const Point_3& p) const
  {
    std::pair<double, double> result(0, infinity);
    for (std::size_t i = 0; i < number_of_segments(); ++i)
    {
      const std::size_t j = (i + 1) % points.size();
      const Vector_3 u = points[j] - points[i];
      const double t = (std::max)(0., (std::min)(1., ((p - points[i]) * u) / u.squared_length()));
      const double d = test::distance(p, points[i] + t * u), s = starts[i] + t * (starts[j] - starts[i]);
      if (d < result.second - 1e-12 || (d < result.second + 1e-12 && s < result.first)) result = {s, d};
    }
    return result;
  }
};

// A walk along the edges of a grid with n squares a side, which may cross itself, or around a rectangle; slopes up to `steepest`.
Varying_polyline random_walk(const Soup& grid, std::size_t n, double steepest, bool may_cross, bool is_closed, Random& random)
{
  std::vector<std::size_t> vertices;
  std::size_t x = 1 + uniform_index(random, n - 1), y = 1 + uniform_index(random, n - 1);
  const auto add = [&] { vertices.push_back(y * (n + 1) + x); };
  if (is_closed)
  {
    const std::size_t right = x + 1 + uniform_index(random, n - x), top = y + 1 + uniform_index(random, n - y), left = x,
                      bottom = y;
    for (; x < right; ++x) add();
    for (; y < top; ++y) add();
    for (; x > left; --x) add();
    for (; y > bottom; --y) add();
  }
  else
    for (std::size_t steps = 2 + uniform_index(random, 9); steps > 0; --steps)
    {
      const std::size_t v = y * (n + 1) + x;
      const bool is_known = std::find(vertices.begin(), vertices.end(), v) != vertices.end();
      if (is_known && !may_cross) break;
      if (vertices.empty() || vertices.back() != v) add();
      if (uniform_index(random, 2) == 0) x = uniform_index(random, 2) == 0 && x > 0 ? x - 1 : (std::min)(x + 1, n);
      else y = uniform_index(random, 2) == 0 && y > 0 ? y - 1 : (std::min)(y + 1, n);
    }
  Varying_polyline result{{}, {}, is_closed};
  double s = uniform(random, 0, 2);
  for (const std::size_t v : vertices)
  {
    if (!result.points.empty())
      s += uniform(random, -steepest, steepest) * test::distance(result.points.back(), grid.points[v]);
    s = (std::max)(0., s);
    result.points.push_back(grid.points[v]);
    result.starts.push_back(s);
  }
  return result;
}

bool on_border(const Point_3& p, std::size_t n)
{
  const auto is_end = [n](double x) { return x <= 1e-9 || x >= double(n) - 1e-9; };
  return is_end(p.x()) || is_end(p.y());
}

// Length of the isoline of the distance in a square of side `size`, interpolated linearly in small triangles: `cells` a side of the part
// that the isoline may reach.
double length_of_isoline(const Varying_polyline& polyline, double level, double size, std::size_t cells)
{
  const double reach = 1.03 * (level - *std::min_element(polyline.starts.begin(), polyline.starts.end()));
  if (!(reach > 0)) return 0;
  double low[2] = {size, size}, high[2] = {0, 0};
  for (const Point_3& p : polyline.points)
    for (int k = 0; k < 2; ++k)
    {
      low[k] = (std::max)(0., (std::min)(low[k], p[k] - reach));
      high[k] = (std::min)(size, (std::max)(high[k], p[k] + reach));
    }
  const double hx = (high[0] - low[0]) / double(cells), hy = (high[1] - low[1]) / double(cells);
  const auto at = [&](std::size_t v) {
    return Point_3(low[0] + double(v % (cells + 1)) * hx, low[1] + double(v / (cells + 1)) * hy, 0);
  };
  std::vector<double> d;
  for (std::size_t v = 0; v < (cells + 1) * (cells + 1); ++v) d.push_back(polyline.distance(at(v)) - level);
  double length = 0;
  for (std::size_t j = 0; j < cells; ++j)
    for (std::size_t i = 0; i < cells; ++i)
      for (const bool upper : {false, true})
      {
        const std::size_t a = j * (cells + 1) + i, c = a + cells + 2;
        const std::array<std::size_t, 3> corner = {a, upper ? c : a + 1, upper ? a + cells + 1 : c};
        std::vector<Point_3> ends;
        for (std::size_t k = 0; k < 3; ++k)
        {
          const std::size_t p = corner[k], q = corner[(k + 1) % 3];
          if ((d[p] < 0) != (d[q] < 0)) ends.push_back(at(p) + d[p] / (d[p] - d[q]) * (at(q) - at(p)));
        }
        if (ends.size() == 2) length += test::distance(ends[0], ends[1]);
      }
  return length;
}

void varying_values()
{
  const std::size_t n = 6;
  for (unsigned seed = 1; seed <= number_of_cases(60u, 1000u); ++seed)
  {
    Random random(seed);
    Report::instance().set_context("varying start values, seed " + std::to_string(seed));
    const Soup grid = planar_grid(n, n, Diagonals::random, 1, seed % 2 ? 0 : 0.2, seed);
    const Generated_mesh<Surface_mesh> data(grid);
    const Mesh_locations locations(data.mesh);
    const Varying_polyline polyline =
      random_walk(grid, n,
                  seed % 5 == 0   ? 1.5
                  : seed % 5 == 1 ? 0.1
                                  : 0.9,
                  seed % 4 == 1, seed % 4 == 3, random);
    if (polyline.points.size() < 2) continue;
    Geodesic geodesic(data.mesh);
    const auto np = CGAL::parameters::is_closed(polyline.is_closed).start_values(std::cref(polyline.starts));
    geodesic.add_source_polyline(geodesic.locate_polyline(polyline.points, np));
    geodesic.build(CGAL::parameters::keep_windows(true));
    const auto check = [&](const Point_3& p, double d) {
      const double e = polyline.distance(p);
      CHECK_DETAIL(std::abs(d - e) <= 1e-12 * (1 + e), values(d, e));
    };
    for (const auto v : data.vertices) check(data.mesh.point(v), geodesic.distance_to_sources(v));
    for (std::size_t i = 0; i < 60; ++i)
    {
      const auto l = random_location(locations, data.mesh, random, i % 3);
      const double d = geodesic.distance_to_sources(l);
      check(locations.point(l), d);
      Path_locations path;
      geodesic.shortest_path_to_sources(l, std::back_inserter(path));
      if (!CHECK(!path.empty())) continue;
      const auto start = polyline.start_at(locations.point(path.back()));
      const double sum = start.first + length_of(locations, path);
      CHECK_DETAIL(start.second <= 1e-9 && std::abs(sum - d) <= 1e-9 * (1 + d), values(sum, d));
    }
    for (const double level : {0.7, 1.9, 3.1})
    {
      const Offset_curves curves = offsets(geodesic, level);
      for (const Offset_curve& c : curves)
      {
        std::vector<Point_3> points;
        c.points(1e-4, std::back_inserter(points));
        for (const Point_3& p : points)
          CHECK_DETAIL(std::abs(polyline.distance(p) - level) <= 1e-9, values(polyline.distance(p), level));
        CHECK(c.is_closed() || on_border(points.front(), n));
      }
      const double length = total_length(curves);
      double of_samples = length_of_isoline(polyline, level, double(n), 200);
      if (std::abs(length - of_samples) > 0.01 * (1 + length))
        of_samples = length_of_isoline(polyline, level, double(n), 3000); // thin
      CHECK_DETAIL(std::abs(length - of_samples) <= 0.01 * (1 + length), values(length, of_samples));
    }
  }
}

// The least of s + |p - q| over the points q of polylines on which the start value s is linear; points may be repeated.
double least_over(const Varying_polyline& polyline, const Point_3& p)
{
  double least = infinity;
  for (std::size_t i = 0; i < polyline.points.size(); ++i)
    least = (std::min)(least, polyline.starts[i] + test::distance(polyline.points[i], p));
  for (std::size_t i = 0; i < polyline.number_of_segments(); ++i)
    if (polyline.points[i] != polyline.points[(i + 1) % polyline.points.size()])
      least = (std::min)(least, polyline.distance(p, i).first);
  return least;
}

// Values that jump at a repeated point, polylines as short as a point, and folds inside an edge; also within a tolerance.
void jumps_and_folds()
{
  const std::size_t n = 4;
  const Generated_mesh<Surface_mesh> data(planar_grid(n, n));
  const Mesh_locations locations(data.mesh);
  const auto on_edge = [&](double t) { // from (1, 2) to (2, 2)
    return locations.on_edge(data.mesh.halfedge(data.vertices[2 * (n + 1) + 1], data.vertices[2 * (n + 1) + 2]), t);
  };
  const std::vector<std::pair<std::vector<double>, std::vector<double>>> cases = {
    {{0}, {5}},
    {{0, 0}, {5, 1}},
    {{0, 0}, {1, 5}},
    {{0, 0, 1}, {0, 4, 4.5}},
    {{0, 0, 1}, {4, 0, 0.5}},
    {{0, 1, 1}, {4, 4.5, 2}},
    {{0, 1, 1, 0.5}, {1, 1.5, 0, 0.2}},
    {{0.2, 0.8, 0.3}, {0.5, 0, 0.4}},
    {{0.2, 0.8, 0.3}, {0.5, 0.1, 0.1}},
    {{0.2, 0.8, 0.3}, {0.1, 0.1, 0.5}},
    {{0, 0.4, 0.7, 1}, {1, 1.1, 1.2, 1.1}}};
  Random random(1);
  for (const auto& [places, starts] : cases)
    for (const double tolerance : {0., 1e-4, 1e-2})
    {
      Report::instance().set_context("jumps and folds, case " + std::to_string(&places - &cases[0].first) + ", tolerance " +
                                     std::to_string(tolerance));
      Varying_polyline polyline{{}, starts, false};
      Path_locations path;
      for (const double t : places)
      {
        path.push_back(on_edge(t));
        polyline.points.push_back(locations.point(path.back()));
      }
      Geodesic geodesic(data.mesh);
      geodesic.add_source_polyline(path, CGAL::parameters::is_closed(false).start_values(starts));
      geodesic.build(CGAL::parameters::keep_windows(true).relative_tolerance(tolerance));
      for (std::size_t i = 0; i < 60; ++i)
      {
        const Face_location l = i < 20 ? on_edge(uniform(random)) : random_location(locations, data.mesh, random, i % 3);
        const double d = geodesic.distance_to_sources(l), e = least_over(polyline, locations.point(l));
        CHECK_DETAIL(d <= e + 1e-12 * (1 + e) && d >= e * (1 - tolerance) - 1e-12, values(d, e));
      }
    }
}

// Sources on the same segment whose values vary differently have cells of their own.
void cells_of_varying_values()
{
  const std::size_t n = 4;
  const Generated_mesh<Surface_mesh> data(planar_grid(n, n));
  const Mesh_locations locations(data.mesh);
  const Vertex_index a = data.vertices[2 * (n + 1) + 2], b = data.vertices[n + 2 + 1];
  const std::vector<Face_location> there = {locations.at_vertex(a, 0), locations.at_vertex(b, 0)};
  for (const auto& other : {std::vector<double>{0.2, 0.2}, std::vector<double>{0.5, 0}})
  {
    const std::vector<double> starts = {0, 0.5};
    Geodesic geodesic(data.mesh);
    geodesic.add_source_polyline(there, CGAL::parameters::is_closed(false).start_values(starts));
    geodesic.add_source_polyline(there, CGAL::parameters::is_closed(false).start_values(other));
    const auto field = geodesic.build(CGAL::parameters::keep_windows(true));
    const auto diagram = field.voronoi_diagram();
    const std::vector<Point_3> points = {data.mesh.point(a), data.mesh.point(b)};
    const Varying_polyline first{points, starts, false}, second{points, other, false};
    Random random(2);
    for (std::size_t i = 0; i < 200; ++i)
    {
      const Face_location l = random_location(locations, data.mesh, random, 0);
      const double d = first.distance(locations.point(l)), e = second.distance(locations.point(l));
      if (std::abs(d - e) > 1e-6) CHECK(diagram.source_at(l) == (d < e ? 0u : 1u));
    }
  }
}

void bad_varying_values()
{
  const Generated_mesh<Surface_mesh> data(planar_grid(2, 2));
  const Mesh_locations locations(data.mesh);
  const std::vector<Face_location> edge = {locations.at_vertex(data.vertices[0], 0), locations.at_vertex(data.vertices[1], 0)};
  const std::vector<Face_location> diagonal = {locations.at_vertex(data.vertices[1], 0),
                                               locations.on_edge(data.mesh.halfedge(data.vertices[0], data.vertices[4]), 0.5)};
  Geodesic geodesic(data.mesh);
  const auto np = CGAL::parameters::is_closed(false);
  CHECK_THROWS(geodesic.add_source_polyline(edge, np.start_values(std::vector<double>{1})), std::invalid_argument);
  CHECK_THROWS(geodesic.add_source_polyline(edge, np.start_values(std::vector<double>{1, -1})), std::invalid_argument);
  CHECK_THROWS(geodesic.add_source_polyline(edge, np.start_values(std::vector<double>{1, infinity})), std::invalid_argument);
  CHECK_THROWS(geodesic.add_source_polyline(edge, np.start_value(1).start_values(std::vector<double>{1, 1})),
               std::invalid_argument);
  CHECK_THROWS(geodesic.add_source_polyline(diagonal, np.start_values(std::vector<double>{1, 1.1})), std::invalid_argument);
  geodesic.add_source_polyline(diagonal, np.start_values(std::vector<double>{1, 1})); // the same values anywhere
  const std::vector<Point_3> triangle = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 0, 0)};
  CHECK_THROWS(geodesic.locate_polyline(triangle, CGAL::parameters::start_values(std::vector<double>{1, 1, 1, 2})),
               std::invalid_argument);
  CHECK(geodesic.locate_polyline(triangle, CGAL::parameters::start_values(std::vector<double>{1, 2, 1, 1})).is_closed);
  const std::vector<Point_3> repeated = {Point_3(0, 0, 0), Point_3(0, 0, 0), Point_3(1, 0, 0)};
  const auto line = geodesic.locate_polyline(repeated, np.start_values(std::vector<double>{4, 0, 0.5}));
  CHECK(line.start_values.size() == line.locations.size() && line.start_values[0] == 4 && line.start_values[1] == 0);
}

// On meshes in space: exact distances are never larger than those of points sampled on the segments, whose error falls with the square
// of their spacing once that is below the distance of the next vertex: 1/4096 from 50 to 3,200, where first order gives 1/64.
void data_meshes()
{
  std::size_t number = 0;
  for (const auto& file : data_files())
  {
    Surface_mesh mesh;
    if (number == 10 || !read_data_mesh(file, 12000, mesh).empty() || mesh.number_of_faces() < 500) continue;
    Report::instance().set_context("varying start values, " + file.filename().string());
    ++number;
    Random random(static_cast<unsigned>(number));
    // a walk along edges
    std::vector<Face_location> walk;
    std::vector<double> starts;
    Halfedge_index h = mesh.halfedge(random_face(mesh, random));
    const double size = mean_edge_length(mesh);
    double start = 2 * size;
    const Mesh_locations locations(mesh);
    std::vector<std::pair<Halfedge_index, double>> segments; // and the start values at their begin
    for (std::size_t i = 0; i < 5; ++i)
    {
      segments.emplace_back(h, start);
      if (i == 0)
      {
        walk.push_back(locations.at_vertex(mesh.source(h), 0));
        starts.push_back(start);
      }
      start += uniform(random, -0.8, 0.8) * test::distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
      start = (std::max)(0., start);
      walk.push_back(locations.at_vertex(mesh.target(h), 0));
      starts.push_back(start);
      h = mesh.next(h);
      if (!mesh.is_border(mesh.opposite(h))) h = mesh.next(mesh.opposite(h));
    }
    Geodesic geodesic(mesh);
    geodesic.add_source_polyline(walk, CGAL::parameters::is_closed(false).start_values(starts));
    geodesic.build();
    double largest[2] = {0, 0};
    for (const int k : {0, 1})
    {
      const std::size_t samples = k == 0 ? 50 : 3200;
      Geodesic sampled(mesh);
      for (std::size_t i = 0; i < segments.size(); ++i)
        for (std::size_t j = 0; j <= samples; ++j)
        {
          const double t = double(j) / double(samples);
          sampled.add_source_point(locations.on_edge(segments[i].first, t),
                                   CGAL::parameters::start_value(starts[i] + t * (starts[i + 1] - starts[i])));
        }
      sampled.build();
      for (const Vertex_index v : used_vertices(mesh))
      {
        const double d = geodesic.distance_to_sources(v), e = sampled.distance_to_sources(v);
        if (d == e) continue; // infinite, too
        CHECK_DETAIL(d <= e + 1e-11 * (size + e), values(d, e));
        largest[k] = (std::max)(largest[k], e - d);
      }
    }
    CHECK_DETAIL(largest[0] <= 1e-2 * size && largest[1] <= 0.004 * largest[0] + 1e-11 * size, values(largest[0], largest[1]));
  }
}

} // namespace test_start_values

GEODESIC_OFFSET_TEST(test_start_values)
{
  const std::pair<const char*, void (*)()> tests[] = {
    {"far apart", test_start_values::far_apart},
    {"tolerances", test_start_values::tolerances},
    {"found sources", test_start_values::found_sources},
    {"other number types", test_start_values::other_number_types},
    {"bad values", test_start_values::bad_values},
    {"varying values", test_start_values::varying_values},
    {"jumps and folds", test_start_values::jumps_and_folds},
    {"cells of varying values", test_start_values::cells_of_varying_values},
    {"bad varying values", test_start_values::bad_varying_values},
    {data_case, test_start_values::data_meshes}};
  return run_tests("test_start_values", tests);
}
