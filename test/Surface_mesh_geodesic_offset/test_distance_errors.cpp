// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Rounding errors of distances of vertices: at most 512 u (d + L) for a distance d, with u = 2^-53 and L, the longest edge of the
// faces within d of the vertex, also beside edges that are 1e12 times longer. From sources of all kinds, after updates, with distance limits, start
// values and threads, on meshes by points and by lengths. Compared with the reference of reference_distances.h.
//
//   test_distance_errors [--meshes N]

#include "certified_cases.h"
#include "geodesic_types.h"
#include "locations.h"
#include "test_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace test_distance_errors {

using namespace test;

typedef Reference_distances::Number Number;
typedef Reference_distances::Location Location;
typedef Reference_distances::Segment Segment;
typedef Geodesic::Face_location Face_location;

std::size_t number_of_meshes = 6000;

std::pair<double, double> shortest_and_longest_edge(const Soup& soup)
{
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (const auto& t : soup.triangles)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double length = std::sqrt(CGAL::squared_distance(soup.points[t[k]], soup.points[t[(k + 1) % 3]]));
      shortest = (std::min)(shortest, length);
      longest = (std::max)(longest, length);
    }
  return {shortest, longest};
}

// Errors of distances d in units of u (d + L), with u = 2^-53 and L, the longest edge of the faces within d of the vertex: those
// that the shortest path passes are among them. Paths are taken for equally long within roundings_of_window, 256 units in the last
// place of d + L, or 512 u: this is also the limit here. A run with `--meshes 400000` finds errors up to 226 u (d + L).
class Errors
{
public:
  // The largest allowed error.
  static double limit(double distance, double longest_near) { return 512 * 0x1p-53 * (distance + longest_near); }

  // `longest_near`: L. `longest`: of all faces.
  void add(double distance, const Number& expected, double longest_near, double longest, const std::string& name)
  {
    const double d = double(expected), error = std::abs(double(Number(distance) - expected));
    CHECK_DETAIL(error <= limit(d, longest_near), name + ": " + values(distance, d));
    m_worst = (std::max)(m_worst, error / limit(d, longest_near));
    if (d > 0 && d < longest) ++m_counts[(std::min)(std::size_t(-std::log10(d / longest)), m_counts.size() - 1)];
  }

  // Distances at 10^-(i+1) to 10^-i of the longest edge; the last count includes smaller ones.
  const std::array<std::size_t, 13>& counts() const { return m_counts; }
  double worst() const { return 512 * m_worst; }

private:
  std::array<std::size_t, 13> m_counts{};
  double m_worst = 0;
};

// Sources of a case, in the terms of the reference.
struct Sources
{
  std::vector<std::size_t> vertices;
  std::vector<Location> points;
  std::vector<std::vector<Location>> polylines;  // consecutive points are in one triangle
  std::vector<std::array<std::size_t, 2>> edges; // triangle and side
};

// A mesh, and its reference distances.
class Case
{
public:
  explicit Case(const Soup& soup) : m_soup(soup), m_data(soup), m_longest(shortest_and_longest_edge(soup).second) {}

  const Surface_mesh& mesh() const { return m_data.mesh; }
  const Soup& soup() const { return m_soup; }
  double longest() const { return m_longest; }

  Reference_distances reference(const Sources& s) const
  {
    std::vector<Reference_distances::Point> points;
    for (const Point_3& p : m_soup.points) points.push_back({p.x(), p.y(), p.z()});
    std::vector<std::size_t> vertices = s.vertices;
    std::vector<Location> locations = s.points;
    std::vector<Segment> segments;
    for (const auto& polyline : s.polylines)
      for (std::size_t i = 0; i < polyline.size(); ++i)
      {
        locations.push_back(polyline[i]);
        if (i > 0) segments.push_back({polyline[i].triangle, polyline[i - 1].weights, polyline[i].weights});
      }
    for (const auto& [triangle, k] : s.edges)
    {
      std::array<double, 3> first{}, second{};
      first[k] = second[(k + 1) % 3] = 1;
      segments.push_back({triangle, first, second});
      vertices.push_back(m_soup.triangles[triangle][k]);
      vertices.push_back(m_soup.triangles[triangle][(k + 1) % 3]);
    }
    Reference_distances result(points, m_soup.triangles);
    result.solve(vertices, locations, {}, segments);
    return result;
  }

  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  void add(Geodesic& geodesic, const Sources& s, const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    for (const std::size_t v : s.vertices) geodesic.add_source_point(m_data.vertices[v], np);
    for (const Location& l : s.points) geodesic.add_source_point(location(l), np);
    for (const auto& polyline : s.polylines)
    {
      std::vector<Face_location> locations;
      for (const Location& l : polyline) locations.push_back(location(l));
      geodesic.add_source_polyline(locations, np);
    }
    std::vector<Surface_mesh::Edge_index> edges;
    for (const auto& [triangle, k] : s.edges)
      edges.push_back(mesh().edge(mesh().halfedge(m_data.vertices[m_soup.triangles[triangle][k]],
                                                  m_data.vertices[m_soup.triangles[triangle][(k + 1) % 3]])));
    if (!edges.empty()) geodesic.add_source_edges(edges, np);
  }

  // Compares the distances of vertices up to a limit. `start_value`: of all sources.
  void compare(const Geodesic& geodesic, const Reference_distances& reference, const std::string& name, Errors& errors,
               double limit = std::numeric_limits<double>::infinity(), double start_value = 0) const
  {
    std::vector<double> distances(m_soup.points.size(), -1);
    geodesic.vertex_distances(CGAL::make_property_map(distances));
    for (std::size_t v = 0; v < m_soup.points.size(); ++v)
    {
      const double d = geodesic.distance_to_sources(m_data.vertices[v]);
      CHECK(d == distances[m_data.vertices[v]]);
      CHECK(d <= limit || std::isinf(d));
      CHECK(reference.of_vertex(v) != Number(0) || d == start_value);
      if (!(reference.of_vertex(v) < Reference_distances::infinity())) continue;
      const Number expected = reference.of_vertex(v) + Number(start_value);
      const double longest_near = longest_edge_near(m_soup.points[v], double(expected));
      if (double(expected) + Errors::limit(double(expected), longest_near) < limit)
        errors.add(d, expected, longest_near, m_longest, name + ", vertex " + std::to_string(v));
    }
  }

private:
  // The longest edge of the triangles of which an edge is within a distance of a vertex.
  double longest_edge_near(const Point_3& p, double distance) const
  {
    double result = 0;
    for (const auto& t : m_soup.triangles)
    {
      bool is_near = false;
      double longest = 0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Point_3 &a = m_soup.points[t[k]], &b = m_soup.points[t[(k + 1) % 3]];
        longest = (std::max)(longest, std::sqrt(CGAL::squared_distance(a, b)));
        // the factor is for rounding
        is_near = is_near || std::sqrt(CGAL::squared_distance(p, Kernel::Segment_3(a, b))) <= 1.001 * distance;
      }
      if (is_near) result = (std::max)(result, longest);
    }
    return result;
  }

  Face_location location(const Location& l) const
  {
    return Locations<Surface_mesh>(mesh()).in_triangle(m_data, m_soup, l.triangle, l.weights);
  }

  const Soup m_soup;
  const Generated_mesh<Surface_mesh> m_data;
  const double m_longest;
};

// Graded clusters, graded needles, and sources beside saddles. The ratio of the edges is down to 1e-12, and points are as near to
// a vertex. Distances at each scale are compared.
void adversarial_meshes()
{
  Errors errors;
  std::size_t extreme = 0; // meshes with a ratio below 1e-11
  for (unsigned seed = 1; seed <= 4 * number_of_meshes; ++seed)
  {
    if (seed % 8 != 1 && seed % 8 != 5 && seed % 8 != 7) continue;
    const Certified_case c = Certified_cases::adversarial(seed);
    const Soup soup = soup_of(c);
    const Case mesh(soup);
    const auto [shortest, longest] = shortest_and_longest_edge(soup);
    extreme += shortest < 1e-11 * longest;
    const Sources sources{c.source_vertices, c.sources, {}, {}};
    Geodesic geodesic(mesh.mesh());
    mesh.add(geodesic, sources);
    geodesic.build();
    mesh.compare(geodesic, mesh.reference(sources), c.kind + " " + std::to_string(seed), errors);
  }
  CHECK(extreme > number_of_meshes / 60);
  for (const std::size_t n : errors.counts()) CHECK(n > number_of_meshes / 60);
  std::cout << "adversarial meshes: errors up to " << errors.worst() << " u (d + L)" << std::endl;
}

// Rings of faces around a vertex, each ring up to some ten times larger or smaller than the one before.
Soup nested_rings(Random& random)
{
  const std::size_t k = 3 + uniform_index(random, 3), rings = 2 + uniform_index(random, 3);
  const double x = uniform_index(random, 2) ? 0 : uniform(random, -3, 3), bending = std::pow(10, uniform(random, -5, 0));
  double size = std::pow(10, uniform(random, -12.5, -2));
  Soup soup;
  soup.points.push_back(Point_3(x, 0, 0));
  for (std::size_t i = 0; i < rings; ++i, size *= std::pow(10, uniform(random, 0, 6 * uniform(random))))
    for (std::size_t j = 0; j < k; ++j)
    {
      const double angle = 2 * CGAL_PI * (double(j) + uniform(random, -0.2, 0.2)) / double(k),
                   r = size * uniform(random, 0.6, 1.4);
      soup.points.push_back(Point_3(x + r * std::cos(angle), r * std::sin(angle), bending * size * uniform(random, -1, 1)));
      const std::size_t n = soup.points.size() - 1, next = j + 1 == k ? n + 1 - k : n + 1;
      if (i == 0) soup.add_triangle({0, n, next});
      else
      {
        soup.add_triangle({n - k, n, next - k});
        soup.add_triangle({next - k, n, next});
      }
    }
  return soup;
}

// Weights at 1e-11 to 1e-1 from a corner.
std::array<double, 3> beside_corner(Random& random)
{
  const std::size_t k = uniform_index(random, 3);
  const double size = std::pow(10, uniform(random, -11, -1));
  std::array<double, 3> w;
  w[(k + 1) % 3] = size * uniform(random, 0.1, 1);
  w[(k + 2) % 3] = uniform_index(random, 3) ? size * uniform(random, 0.1, 1) : 0;
  w[k] = 1 - (w[(k + 1) % 3] + w[(k + 2) % 3]);
  return w;
}

Sources random_sources(const Soup& soup, std::size_t kind, Random& random)
{
  Sources s;
  const auto triangle = [&] { return uniform_index(random, soup.triangles.size()); };
  for (std::size_t i = 1 + uniform_index(random, 2); i > 0; --i)
    if (kind == 0) s.vertices.push_back(uniform_index(random, soup.points.size()));
    else if (kind == 1) s.points.push_back({triangle(), beside_corner(random)});
    else if (kind == 2) s.edges.push_back({triangle(), uniform_index(random, 3)});
    else
    {
      const std::size_t f = triangle();
      std::vector<Location> polyline;
      for (std::size_t j = 1 + uniform_index(random, 3); j > 0; --j) polyline.push_back({f, beside_corner(random)});
      s.polylines.push_back(polyline);
    }
  return s;
}

// All kinds of sources, builds and updates.
void nested_meshes()
{
  static const char* const names[4] = {"vertices", "points", "edges", "polylines"};
  std::array<Errors, 4> errors;
  for (unsigned seed = 1; seed <= number_of_meshes / 4; ++seed)
  {
    Random random(seed);
    for (int i = 0; i < 8; ++i) random();
    const Case mesh(nested_rings(random));
    const std::size_t kind = seed % 4;
    const std::string name = names[kind] + (" " + std::to_string(seed));
    const Sources sources = random_sources(mesh.soup(), kind, random);
    const Reference_distances reference = mesh.reference(sources);
    Geodesic geodesic(mesh.mesh());
    mesh.add(geodesic, sources);
    geodesic.build(CGAL::parameters::keep_windows(seed % 3 == 0));
    mesh.compare(geodesic, reference, name, errors[kind]);
    const double limit = mesh.longest() * std::pow(10, uniform(random, -12, 0));
    geodesic.build(CGAL::parameters::distance_limit(limit).keep_windows(seed % 3 == 0));
    mesh.compare(geodesic, reference, name + " with a limit", errors[kind], limit);
    geodesic.build(CGAL::parameters::concurrency_tag(CGAL::Parallel_if_available_tag()));
    mesh.compare(geodesic, reference, name + " with threads", errors[kind]);

    Geodesic started(mesh.mesh());
    const double start_value = mesh.longest() * std::pow(10, uniform(random, -12, 0));
    mesh.add(started, sources, CGAL::parameters::start_value(start_value));
    started.build();
    mesh.compare(started, reference, name + " with a start value", errors[kind], std::numeric_limits<double>::infinity(),
                 start_value);

    Geodesic updated(mesh.mesh());
    updated.add_source_point(*mesh.mesh().vertices_begin());
    updated.build(CGAL::parameters::keep_windows(true));
    mesh.add(updated, sources);
    updated.update();
    Sources all = sources;
    all.vertices.push_back(0);
    mesh.compare(updated, mesh.reference(all), name + " after an update", errors[kind]);
    updated.remove_source(0);
    updated.update();
    mesh.compare(updated, reference, name + " without the first source", errors[kind]);
  }
  const auto small = [](const Errors& e) { return std::accumulate(e.counts().begin() + 9, e.counts().end(), std::size_t(0)); };
  for (const Errors& e : errors) CHECK(small(e) > number_of_meshes / 60);
  for (std::size_t i = 0; i < 4; ++i)
    std::cout << "nested meshes, from " << names[i] << ": errors up to " << errors[i].worst() << " u (d + L)" << std::endl;
}

// Meshes by lengths: the reference unfolds triangles with the same lengths.
void lengths()
{
  Errors errors;
  for (unsigned seed = 1; seed <= number_of_meshes / 12; ++seed)
  {
    Random random(seed);
    for (int i = 0; i < 8; ++i) random();
    const Case mesh(nested_rings(random));
    Surface_mesh copy = mesh.mesh();
    const auto lengths = copy.add_property_map<Surface_mesh::Edge_index, double>("e:length", 0).first;
    for (const auto e : copy.edges())
      lengths[e] = std::sqrt(CGAL::squared_distance(copy.point(copy.vertex(e, 0)), copy.point(copy.vertex(e, 1))));
    std::vector<std::array<double, 3>> sides;
    for (const auto& t : mesh.soup().triangles)
    {
      sides.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        sides.back()[k] = std::sqrt(CGAL::squared_distance(mesh.soup().points[t[k]], mesh.soup().points[t[(k + 1) % 3]]));
    }
    Reference_distances reference(mesh.soup().points.size(), mesh.soup().triangles, sides);
    const std::size_t source = uniform_index(random, 4);
    reference.solve({source}, {}, {});
    Geodesic geodesic(copy, CGAL::parameters::edge_length_map(lengths));
    mesh.add(geodesic, {{source}, {}, {}, {}});
    geodesic.build();
    mesh.compare(geodesic, reference, "lengths " + std::to_string(seed), errors);
  }
  CHECK(std::accumulate(errors.counts().begin() + 3, errors.counts().end(), std::size_t(0)) > number_of_meshes / 6);
  std::cout << "lengths: errors up to " << errors.worst() << " u (d + L)" << std::endl;
}

// Columns of points with a border at their end, in a planar mesh with far longer edges beside them. Each point is next to its
// image, measured by these edges.
void columns_of_points()
{
  Random random(7);
  const std::size_t rows = 250;
  for (const double spacing : {4.4e-10, 1e-12})
  {
    std::vector<Point_2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const double column : {7, 0, 6})
      for (std::size_t i = 0; i < rows; ++i)
        if (i == rows / 2 || uniform_index(random, 20))
          points.push_back(Point_2(0.2354 + spacing * column, spacing * double(i)));
    for (int i = 0; i < 30; ++i) points.push_back(Point_2(uniform(random, 0, 1), uniform(random, 0, 1)));
    Soup soup;
    for (const Point_2& p : points) soup.points.push_back(Point_3(p.x(), p.y(), 0));
    for (const auto& t : delaunay_triangles(points)) soup.add_triangle(t);
    const Generated_mesh<Surface_mesh> data(soup);
    std::size_t source = 4; // in the first column
    while (points[source].y() < spacing * double(rows) * 0.44) ++source;
    Geodesic geodesic(data.mesh);
    geodesic.add_source_point(data.vertices[source]);
    geodesic.build();
    Errors errors;
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      const Number x = Number(points[v].x()) - Number(points[source].x()),
                   y = Number(points[v].y()) - Number(points[source].y());
      errors.add(geodesic.distance_to_sources(data.vertices[v]), Reference_distances::root(x * x + y * y), 1, 1,
                 values(spacing, double(v)));
    }
  }
}

// Faces around a vertex with angles of 4e-7 in all. Rays from beside this vertex wind around it until rounding ends them. From an
// attack.
void winding_rays()
{
  Soup soup;
  soup.points = {{-5.9877570123883796e-15, 7.7631149719901931e-16, 5.20586907693099e-15},
                 {0, 0, 0},
                 {-8.4403772351807584e-09, -3.8409645882588155e-08, -5.4419584567287057e-09},
                 {8.4403772351807617e-09, 3.8409645882588155e-08, 5.4419584567287024e-09},
                 {5.5811723926132449e-09, 2.5398251246370614e-08, 3.5984762992854225e-09},
                 {3.0029843111654385e-08, -2.9433820904718348e-09, -2.5801178289017211e-08},
                 {4.0253533601328316e-12, 1.8317803726741124e-11, 2.5954021827056019e-12},
                 {7.7322292399611557e-17, -3.0230578519524205e-17, 9.3443656959614284e-17},
                 {4.3443413960580711e-09, 3.4633447977115063e-08, 7.6096629337999614e-09},
                 {-3.0029843111654385e-08, 2.9433820904718398e-09, 2.5801178289017211e-08},
                 {1.1600590483860546e-10, 1.449493328549823e-08, 4.5933602161355177e-09}};
  const std::vector<std::array<std::size_t, 3>> triangles = {
    {0, 1, 2}, {1, 3, 4}, {1, 5, 6}, {0, 2, 7}, {7, 6, 8}, {3, 6, 5},  {6, 2, 1},  {7, 9, 0},  {3, 9, 8},
    {9, 7, 8}, {3, 5, 4}, {5, 1, 4}, {6, 3, 8}, {6, 7, 2}, {9, 3, 10}, {1, 0, 10}, {10, 3, 1}, {0, 9, 10}};
  for (const auto& t : triangles) soup.add_triangle(t);
  Sources sources;
  sources.polylines.push_back({Location{6, {7.27345186853529e-05, 0.99992724917319853, 1.6308116044054012e-08}},
                               Location{6, {0, 0.5, 0.5}}});
  const Case c(soup);
  Geodesic geodesic(c.mesh());
  c.add(geodesic, sources);
  geodesic.build();
  Errors errors;
  c.compare(geodesic, c.reference(sources), "winding rays", errors);
}

// Two fans touch at a vertex, each with a source; the nearer one is not in the fan of the other. From an attack.
void touching_fans()
{
  test::Surface_mesh mesh;
  std::vector<test::Surface_mesh::Vertex_index> v;
  for (const auto& p :
       {Point_3(0, 0, 0), Point_3(-1, -1, 0), Point_3(0, -1, 0), Point_3(1e-3, 0, 0), Point_3(2e-3, 1e-3, 0), Point_3(0, 1, 0)})
    v.push_back(mesh.add_vertex(p));
  const auto f = mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[0], v[3], v[4]);
  mesh.add_face(v[0], v[4], v[5]);
  const auto h = mesh.halfedge(f);
  const test::Surface_mesh::Vertex_index corner[] = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
  Face_location at(f, {{0, 0, 0}});
  for (std::size_t k = 0; k < 3; ++k) at.second[k] = corner[k] == v[0] ? 1 - 0x1p-12 : corner[k] == v[2] ? 0x1p-12 : 0;
  Geodesic geodesic(mesh);
  geodesic.add_source_point(at);
  geodesic.add_source_point(v[3]);
  geodesic.build();
  CHECK_DETAIL(std::abs(geodesic.distance_to_sources(v[0]) - 0x1p-12) <= 1e-16,
               values(geodesic.distance_to_sources(v[0]), 0x1p-12));
}

// The start value of a source vertex is next to its distance from another source, whose distance in double may be rounded below.
// From an attack.
void start_value_next_to_distance()
{
  for (int i = 1; i < 200; ++i)
    for (const double part : {1e-6, 1e-7, 1e-8})
    {
      const double w = 1e-10 * (1 + 0.013 * i), start = w / (1 + w) * (1 - part);
      test::Surface_mesh mesh;
      const auto a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(1, 0, 0));
      const auto f = mesh.add_face(a, b, mesh.add_vertex(Point_3(0, 1, 0)));
      const auto h = mesh.halfedge(f);
      const test::Surface_mesh::Vertex_index corner[] = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
      Face_location at(f, {{0, 0, 0}});
      for (std::size_t k = 0; k < 3; ++k) at.second[k] = corner[k] == a ? w : corner[k] == b ? 1 : 0;
      Geodesic geodesic(mesh);
      geodesic.add_source_point(at);
      geodesic.add_source_point(b, CGAL::parameters::start_value(start));
      geodesic.build();
      CHECK_DETAIL(std::abs(geodesic.distance_to_sources(b) - start) <= Errors::limit(start, std::sqrt(2.)),
                   values(geodesic.distance_to_sources(b), start));
    }
}

} // namespace test_distance_errors

GEODESIC_OFFSET_TEST(test_distance_errors)
{
  for (int i = 1; i + 1 < argc; ++i)
    if (std::string(argv[i]) == "--meshes") number_of_meshes = std::size_t(std::atol(argv[i + 1]));
  const std::pair<const char*, void (*)()> tests[] = {
    {"adversarial meshes", adversarial_meshes},
    {"nested meshes", nested_meshes},
    {"lengths", lengths},
    {"columns of points", columns_of_points},
    {"winding rays", winding_rays},
    {"touching fans", touching_fans},
    {"start value next to a distance", start_value_next_to_distance}};
  return run_tests("test_distance_errors", tests);
}
