// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances of vertices far smaller than edges beside them, down to 1e-12 of an edge: their relative errors are below 1e-13, from
// sources of all kinds, after updates, with distance limits, start values and threads. Compared with the reference of
// reference_distances.h. The vertices that are computed with twice the digits, and the number type with these digits.
//
//   test_graded_distances [--meshes N]

#include "certified_cases.h"
#include "geodesic_types.h"
#include "locations.h"
#include "test_check.h"

#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Graded_distances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace test_graded_distances {

using namespace test;

typedef Reference_distances::Number Number;
typedef Reference_distances::Location Location;
typedef Reference_distances::Segment Segment;
typedef Geodesic::Face_location Face_location;
typedef CGAL::Geodesic_offset::internal::Extended_number Extended_number;

constexpr double tolerance = 1e-13; // relative

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

// Largest relative errors by the decades of the distances, in longest edges.
class Errors
{
public:
  void add(double distance, const Number& expected, double longest, const std::string& name)
  {
    const double d = double(expected);
    const double error = d == 0 ? (distance == 0 ? 0 : 1) : std::abs(double(Number(distance) - expected)) / d;
    // numbers with twice the digits are rounded relative to edges, too
    CHECK_DETAIL(error < tolerance + (d > 0 ? 0x1p-100 * longest / d : 0), name + ": " + values(distance, d));
    if (d > 0 && d < longest) ++m_counts[(std::min)(std::size_t(-std::log10(d / longest)), m_counts.size() - 1)];
  }

  // Distances at 10^-(i+1) to 10^-i of the longest edge; the last count includes smaller ones.
  const std::array<std::size_t, 13>& counts() const { return m_counts; }

private:
  std::array<std::size_t, 13> m_counts{};
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

  // Compares distances up to a limit. `start_value`: of all sources.
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
      const Number expected = reference.of_vertex(v) + Number(start_value);
      if (reference.of_vertex(v) < Reference_distances::infinity() && double(expected) < limit * (1 - tolerance))
        errors.add(d, expected, m_longest, name + ", vertex " + std::to_string(v));
    }
  }

private:
  Face_location location(const Location& l) const
  {
    return Locations<Surface_mesh>(mesh()).in_triangle(m_data, m_soup, l.triangle, l.weights);
  }

  const Soup m_soup;
  const Generated_mesh<Surface_mesh> m_data;
  const double m_longest;
};

// Graded clusters, graded needles, and sources beside saddles. The ratio of the edges is down to 1e-12, and points are as near to
// a vertex. Distances at each scale are compared: with a larger graded_ratio, those near it fail.
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
  for (const Errors& e : errors)
    CHECK(std::accumulate(e.counts().begin() + 9, e.counts().end(), std::size_t(0)) > number_of_meshes / 60);
}

// Meshes by lengths: the second propagation lays faces out by the same lengths. Compared with the package on extended numbers.
void lengths()
{
  typedef CGAL::Simple_cartesian<Extended_number> Extended_kernel;
  typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Extended_kernel, Surface_mesh>>
    Extended_geodesic;
  std::size_t compared = 0;
  for (unsigned seed = 1; seed <= 200; ++seed)
  {
    Random random(seed);
    for (int i = 0; i < 8; ++i) random();
    const Case mesh(nested_rings(random));
    Surface_mesh copy = mesh.mesh();
    const auto lengths = copy.add_property_map<Surface_mesh::Edge_index, double>("e:length", 0).first;
    const auto same = copy.add_property_map<Surface_mesh::Edge_index, Extended_number>("e:extended_length", 0).first;
    for (const auto e : copy.edges())
    {
      lengths[e] = std::sqrt(CGAL::squared_distance(copy.point(copy.vertex(e, 0)), copy.point(copy.vertex(e, 1))));
      same[e] = lengths[e];
    }
    Geodesic geodesic(copy, CGAL::parameters::edge_length_map(lengths));
    Extended_geodesic extended(copy, CGAL::parameters::edge_length_map(same));
    const Surface_mesh::Vertex_index source(static_cast<unsigned>(uniform_index(random, 4)));
    geodesic.add_source_point(source);
    extended.add_source_point(source);
    geodesic.build();
    extended.build();
    for (const auto v : copy.vertices())
    {
      const double d = extended.distance_to_sources(v).high(), e = geodesic.distance_to_sources(v);
      if (!(d < 1e-3 * mesh.longest())) continue;
      CHECK_DETAIL(std::abs(d - e) <= tolerance * d, values(e, d));
      ++compared;
    }
  }
  CHECK(compared > 500);
}

// Points of a mesh without any use of distances in space.
struct No_points
{
  static double between(std::size_t, std::size_t, std::size_t) { return 0; }
};

// The graded vertices of a build from the first vertex of a mesh.
struct Graded
{
  std::vector<double> distances;
  std::size_t faces = 0;

  explicit Graded(const Soup& soup)
  {
    const Generated_mesh<Surface_mesh> data(soup);
    Geodesic geodesic(data.mesh);
    geodesic.add_source_point(data.vertices[0]);
    const auto& unfolded = CGAL::Geodesic_offset::internal::Mesh_access::data(geodesic.mesh()).unfolded();
    const auto field = geodesic.build();
    const auto& build = *CGAL::Geodesic_offset::internal::Field_access::shared_build(field);
    const CGAL::Geodesic_offset::internal::Graded_places<No_points> places(unfolded, build.field, build.maximum, No_points());
    for (const auto v : places.vertices()) distances.push_back(build.field.distance[v]);
    faces = places.faces().size();
  }
};

// Vertices are graded up to 1/64 of an edge in reach, the value of graded_ratio, and only these.
void graded_vertices()
{
  for (const double factor : {0.5, 0.99, 1.01, 2.})
    for (const bool is_far : {false, true})
    {
      // a strip of quads: the first one has sides of length 1, or the seventh one
      const double size = factor / 64;
      Soup soup;
      for (int i = 0; i < 8; ++i)
      {
        const double x = size * i + (i > (is_far ? 6 : 0) ? 1 - size : 0);
        soup.points.push_back(Point_3(x, 0, 0));
        soup.points.push_back(Point_3(x, size, 0));
      }
      for (std::size_t i = 0; i + 2 < 16; i += 2)
      {
        soup.add_triangle({i, i + 2, i + 3});
        soup.add_triangle({i, i + 3, i + 1});
      }
      const Graded graded(soup);
      const bool expected = factor < 1 && !is_far;
      CHECK(graded.distances == (expected ? std::vector<double>{size} : std::vector<double>()));
      CHECK((graded.faces > 0) == expected);
    }
}

// A fine grid beside a long edge: the second propagation takes a bounded number of faces, those nearest to the source.
void large_places()
{
  for (const std::size_t n : {80, 160})
  {
    Soup soup;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) soup.points.push_back(Point_3(double(i), double(j), 0));
    for (std::size_t i = 0; i + 1 < n; ++i)
      for (std::size_t j = 0; j + 1 < n; ++j)
      {
        soup.add_triangle({i * n + j, (i + 1) * n + j, (i + 1) * n + j + 1});
        soup.add_triangle({i * n + j, (i + 1) * n + j + 1, i * n + j + 1});
      }
    soup.points.push_back(Point_3(-1e5, 0, 0));
    soup.add_triangle({1, n * n, 0});
    const Graded graded(soup);
    const std::size_t all = 2 * (n - 1) * (n - 1) + 1, most = 1 << 15;
    if (all <= most) CHECK_DETAIL(graded.distances.size() == n * n - 1, std::to_string(graded.distances.size()));
    else
    { // the limit of distances, 1/64 of the longest edge, is quartered until there are few enough
      CHECK(graded.faces > most / 16 && graded.faces <= most && graded.distances.size() > most / 32);
      for (const double d : graded.distances) CHECK(d < 1e5 / 64 / 16 * (1 + 1e-6));
    }
  }
}

// Columns of points with a border at their end, in a planar mesh with far longer edges beside them. Each point is next to its
// image, measured by these edges: if it starts rays for that reason, the windows on an edge double from row to row.
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
      errors.add(geodesic.distance_to_sources(data.vertices[v]), Reference_distances::root(x * x + y * y), 1,
                 values(spacing, double(v)));
    }
  }
}

// Faces around a vertex with angles of 4e-7 in all. Rays from beside this vertex wind around it thousands of times before numbers
// with twice the digits let their order be told, and each of them is compared with all. From an attack: the build took minutes.
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
  const Reference_distances expected = c.reference(sources);
  Geodesic geodesic(c.mesh());
  c.add(geodesic, sources);
  geodesic.build();
  for (std::size_t v = 0; v < soup.points.size(); ++v)
  {
    const double d = geodesic.distance_to_sources(Surface_mesh::Vertex_index(Surface_mesh::size_type(v)));
    CHECK_DETAIL(std::abs(d - double(expected.of_vertex(v))) < 1e-12 * c.longest(), values(d, double(expected.of_vertex(v))));
  }
}

// Operations have relative errors of at most 2^-103 and respect infinity.
void extended_numbers()
{
  Random random(1);
  const auto exact = [](const Extended_number& x) { return Number(x.high()) + Number(x.low()); };
  const Number unit = Number(0x1p-103);
  const auto is_close = [&](const Extended_number& x, const Number& y, const Number& scale) {
    const Number error = exact(x) - y;
    return (error < Number(0) ? -error : error) <= unit * scale;
  };
  for (int i = 0; i < 2000; ++i)
  {
    const auto number = [&] {
      const double high = std::pow(10, uniform(random, -30, 30));
      return Extended_number(uniform_index(random, 2) ? high : -high) +
             Extended_number(high * 0x1p-54 * uniform(random, -1, 1));
    };
    const Extended_number a = number(), b = uniform_index(random, 4) ? number() : -a * Extended_number(1 + 0x1p-70);
    const Number x = exact(a), y = exact(b), size_of_x = x < Number(0) ? -x : x, size_of_y = y < Number(0) ? -y : y;
    const Number larger = size_of_x < size_of_y ? size_of_y : size_of_x;
    CHECK(is_close(a + b, x + y, larger) && is_close(a - b, x - y, larger));
    CHECK(is_close(a * b, x * y, size_of_x * size_of_y));
    CHECK(is_close(a / b, x / y, size_of_x / size_of_y));
    const Extended_number root = CGAL::sqrt(CGAL::abs(a));
    CHECK(is_close(root * root, size_of_x, Number(4) * size_of_x));
    CHECK((a < b) == (x < y) && (a <= b) == (x <= y) && (a == b) == (x == y));
    CHECK(CGAL::compare(a, b) == (x < y ? CGAL::SMALLER : x > y ? CGAL::LARGER : CGAL::EQUAL));
    CHECK(CGAL::sign(a) == (x < Number(0) ? CGAL::NEGATIVE : CGAL::POSITIVE));
    const std::pair<double, double> bounds = CGAL::to_interval(a);
    CHECK(Number(bounds.first) <= x && x <= Number(bounds.second));
  }
  typedef CGAL::Geodesic_offset::internal::Number_policy<Extended_number> Policy;
  const Extended_number infinity = Policy::infinity(), one(1);
  CHECK(infinity + one == infinity && infinity - one == infinity && infinity * Extended_number(2) == infinity);
  CHECK(one / infinity == Extended_number(0) && CGAL::sqrt(infinity) == infinity && one < infinity && -infinity < one);
  CHECK(!Policy::is_finite(infinity) && Policy::is_finite(one) && Policy::rounding(1) == Extended_number(0x1p-103));
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

// The start value of a source vertex is next to its distance from another source, whose distance in double is rounded below.
// From an attack.
void start_value_of_graded_vertex()
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
      CHECK_DETAIL(std::abs(geodesic.distance_to_sources(b) - start) <= 1e-13 * start,
                   values(geodesic.distance_to_sources(b), start));
    }
}

} // namespace test_graded_distances

GEODESIC_OFFSET_TEST(test_graded_distances)
{
  for (int i = 1; i + 1 < argc; ++i)
    if (std::string(argv[i]) == "--meshes") number_of_meshes = std::size_t(std::atol(argv[i + 1]));
  const std::pair<const char*, void (*)()> tests[] = {
    {"adversarial meshes", adversarial_meshes},
    {"nested meshes", nested_meshes},
    {"lengths", lengths},
    {"graded vertices", graded_vertices},
    {"large places", large_places},
    {"columns of points", columns_of_points},
    {"winding rays", winding_rays},
    {"extended numbers", extended_numbers},
    {"touching fans", touching_fans},
    {"start value of a graded vertex", start_value_of_graded_vertex}};
  return run_tests("test_graded_distances", tests);
}
