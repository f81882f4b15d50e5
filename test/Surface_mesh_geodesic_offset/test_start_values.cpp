// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Start values of sources. The distance of a point is the minimum, over the sources, of the start value plus the distance from
// that source alone: distances, nearest sources, paths, gradients, and farthest points are compared with this minimum, also
// where a source lies in the region of another one. Offsets are checked by integrals, and against those of the same source
// without a start value. Distances within a tolerance are compared with a closed form.

#include "derivative_check.h"
#include "generated_meshes.h"
#include "offset_integrals.h"
#include "path_tools.h"
#include "plane_section.h"
#include "test_check.h"

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_start_values {

using namespace test;

typedef Geodesic::Source_set Source_set;
typedef Source_set::Kind Kind;

struct Totals
{
  std::size_t points = 0, ties = 0, dominated = 0, paths = 0;
  Derivative_check derivatives;
  double distance = 0, path = 0, width = 0, certified = 0;
};
Totals totals;

const std::pair<const char*, Soup>* all_soups(std::size_t& number)
{
  static const std::pair<const char*, Soup> soups[] = {
    {"torus", torus(14, 10)},
    {"icosphere", icosphere(2)},
    {"cube", cube_grid(4)},
    {"needles", random_rectangle(1, 0.01, 60, 4, 3)},
    {"tiny faces", marching_sphere(6)},
    {"cone of 1.5 turns", Cone(8, 3 * CGAL_PI, 1).triangulated(25, 4, 5)},
    {"jittered grid", jittered_grid(12, 9, 7)}};
  number = sizeof(soups) / sizeof(soups[0]);
  return soups;
}

// Sources of random kinds on a mesh.
class Random_sources
{
public:
  Random_sources(const Surface_mesh& mesh, unsigned seed) : mesh_(mesh), locations_(mesh), random_(seed) {}

  Source_set::Source operator()()
  {
    Source_set::Source s{Kind::LOCATION, Surface_mesh::null_vertex(), {}, {}};
    switch (uniform_index(random_, 5))
    {
    case 0:
      s.kind = Kind::VERTEX;
      s.vertex = target(halfedge(random_face(mesh_, random_), mesh_), mesh_);
      break;
    case 1: s.locations = {random_location(locations_, mesh_, random_, uniform_index(random_, 2))}; break;
    case 2:
    {
      s.kind = Kind::EDGES;
      auto h = halfedge(random_face(mesh_, random_), mesh_);
      for (int i = 0; i < 3 && !is_border(h, mesh_); ++i)
      {
        s.edges.push_back(edge(h, mesh_));
        h = next(opposite(next(h, mesh_), mesh_), mesh_);
      }
      break;
    }
    default:
    {
      const auto sections = random_plane_section(mesh_, unsigned(uniform_index(random_, 1000)));
      if (sections.empty()) return (*this)();
      const auto& section = sections[uniform_index(random_, sections.size())];
      const std::size_t n = section.locations.size();
      s.kind = section.closed && random_() % 2 ? Kind::CLOSED_POLYLINE : Kind::OPEN_POLYLINE;
      const std::size_t first = s.kind == Kind::CLOSED_POLYLINE ? 0 : uniform_index(random_, n);
      const std::size_t last = s.kind == Kind::CLOSED_POLYLINE ? n : (std::min)(n, first + 1 + uniform_index(random_, n));
      s.locations.assign(section.locations.begin() + std::ptrdiff_t(first), section.locations.begin() + std::ptrdiff_t(last));
    }
    }
    return s;
  }

  Random& random() { return random_; }

private:
  const Surface_mesh& mesh_;
  const Mesh_locations locations_;
  Random random_;
};

// The distances from single sources, with start values.
class Brute_force
{
public:
  Brute_force(const Surface_mesh& mesh, const Source_set& set)
  {
    for (const auto& [id, source] : set.sources())
    {
      (void)id;
      Source_set one;
      start_.push_back(source.start_value);
      one.add(source);
      single_.emplace_back(mesh);
      auto alone = one.sources().begin()->second;
      alone.start_value = 0;
      one.clear();
      one.add(alone);
      single_.back().add_sources(one);
      single_.back().build(CGAL::parameters::keep_windows(true));
    }
  }

  template <class Query>
  double distance(std::size_t i, const Query& query) const
  {
    return start_[i] + single_[i].distance_to_sources(query);
  }

  template <class Query>
  double distance(const Query& query, std::size_t& nearest) const
  {
    double least = infinity;
    for (std::size_t i = 0; i < single_.size(); ++i)
      if (const double d = distance(i, query); d < least)
      {
        least = d;
        nearest = i;
      }
    return least;
  }

  const std::vector<double>& start_values() const { return start_; }

private:
  std::vector<double> start_;
  std::vector<Geodesic> single_;
};

// Tolerance of distances: those of both builds, each relative to the distance and the longest edge, which the needles need.
double tolerance(double d, double size) { return 1e-12 * (std::max)(d, size); }

class Case
{
public:
  Case(const Surface_mesh& mesh, const Source_set& set)
    : mesh_(mesh), locations_(mesh), size_(bounding_box_diagonal(mesh)), brute_(mesh, set), geodesic_(mesh)
  {
    geodesic_.add_sources(set);
    geodesic_.build(CGAL::parameters::keep_windows(true).compute_largest_distance(true));
  }

  void check(Random& random)
  {
    std::vector<std::size_t> label(mesh_.number_of_vertices());
    std::size_t nearest = 0;
    for (const auto v : used_vertices(mesh_)) check_at(v);
    for (int i = 0; i < 60; ++i) check_at(random_location(locations_, mesh_, random, std::size_t(i % 3)));
    const auto farthest = geodesic_.farthest_point().value();
    const double d = brute_.distance(farthest.first, nearest);
    CHECK_DETAIL(std::abs(farthest.second - d) <= tolerance(d, size_), values(farthest.second, d));
    check_dominated();
    const Geodesic again = updated();
    for (const auto v : used_vertices(mesh_))
    {
      const double a = again.distance_to_sources(v), b = geodesic_.distance_to_sources(v);
      CHECK_DETAIL(std::abs(a - b) <= tolerance(b, size_), values(a, b));
    }
    check_offsets(random);
    check_bounds(random);
  }

private:
  typedef CGAL::Surface_mesh_geodesic_enclosure<Geodesic::Traits> Enclosure;

  // Certified bounds contain the distance, and certify an offset.
  void check_bounds(Random& random)
  {
    Enclosure enclosure(mesh_);
    enclosure.add_sources(geodesic_.sources());
    enclosure.build(CGAL::parameters::keep_windows(true));
    const auto check = [&](const auto& query) {
      std::size_t nearest = 0;
      const double expected = brute_.distance(query, nearest), allowed = tolerance(expected, size_);
      const auto bounds = enclosure.distance_bounds(query);
      CHECK_DETAIL(bounds.first <= expected + allowed && expected <= bounds.second + allowed, values(bounds.first, expected));
      totals.width = (std::max)(totals.width, (bounds.second - bounds.first) / (std::max)(expected, size_));
    };
    for (const auto v : used_vertices(mesh_)) check(v);
    for (int i = 0; i < 20; ++i) check(random_location(locations_, mesh_, random, std::size_t(i % 3)));
    const double d = uniform(random, 0.1, 0.9) * geodesic_.largest_distance().value();
    const auto certificate = enclosure.certify_offset(d, offsets(geodesic_, d));
    totals.certified = (std::max)(totals.certified, certificate.tolerance / (std::max)(d, size_));
    CHECK(certificate.bounds_region);
    CHECK_DETAIL(certificate.tolerance <= 1e-9 * (std::max)(d, size_), std::to_string(certificate.tolerance));
  }

  template <class Query>
  void check_at(const Query& query)
  {
    std::size_t nearest = 0;
    const double expected = brute_.distance(query, nearest), d = geodesic_.distance_to_sources(query);
    ++totals.points;
    totals.distance = (std::max)(totals.distance, std::abs(d - expected) / (std::max)(expected, size_));
    CHECK_DETAIL(std::abs(d - expected) <= tolerance(expected, size_), values(d, expected));
    const auto found = geodesic_.nearest_source(query);
    CHECK(found.has_value());
    if (!found) return;
    CHECK(found->distance == d);
    const double by_found = brute_.distance(found->source, query);
    totals.ties += found->source != nearest;
    CHECK_DETAIL(by_found <= expected + tolerance(expected, size_), values(by_found, expected));
    const double s = brute_.start_values()[found->source];
    Path_locations path;
    geodesic_.shortest_path_to_sources(query, std::back_inserter(path));
    ++totals.paths;
    const double length = length_of(locations_, path), error = std::abs(s + length - d) / (std::max)(d, size_);
    totals.path = (std::max)(totals.path, error);
    CHECK_DETAIL(error <= 1e-12, values(s + length, d));
    CHECK_DETAIL(path.empty() ||
                   test::distance(locations_.point(path.back()), locations_.point(found->location)) <= 1e-12 * size_,
                 std::to_string(path.size()));
    const double at_end = brute_.distance(found->source, found->location);
    CHECK_DETAIL(std::abs(at_end - s) <= tolerance(s, size_), values(at_end, s));
    CHECK((!geodesic_.gradient(query)) == (path.size() == 1 || length <= 1e-13 * size_));
  }

  // Sources in the region of another one.
  void check_dominated()
  {
    std::size_t i = 0;
    for (const auto& s : geodesic_.sources().sources())
    {
      std::size_t nearest = 0;
      if (s.second.kind == Kind::VERTEX && brute_.distance(s.second.vertex, nearest) < brute_.start_values()[i] && nearest != i)
        ++totals.dominated;
      ++i;
    }
  }

  // The same sources, the last ones of which are added by an update.
  Geodesic updated() const
  {
    Geodesic result(mesh_);
    std::size_t i = 0;
    for (const auto& s : geodesic_.sources().sources())
    {
      if (i++ == (brute_.start_values().size() + 1) / 2) result.build(CGAL::parameters::keep_windows(true));
      Source_set one;
      one.add(s.second);
      result.add_sources(one);
    }
    if (result.is_built()) result.update();
    else result.build();
    return result;
  }

  void check_offsets(Random& random)
  {
    Offset_integrals integrals(geodesic_, mesh_);
    double least = infinity;
    for (const double s : brute_.start_values()) least = (std::min)(least, s);
    if (least > 0) CHECK(offsets(geodesic_, least).empty() && offsets(geodesic_, least / 2).empty());
    for (int i = 0; i < 4; ++i)
    {
      const double d = least + uniform(random, 0.02, 0.98) * (integrals.largest_distance() - least);
      totals.derivatives(integrals, d);
    }
  }

  const Surface_mesh& mesh_;
  const Mesh_locations locations_;
  const double size_;
  const Brute_force brute_;
  Geodesic geodesic_;
};

void several_sources()
{
  std::size_t number;
  const auto* const soups = all_soups(number);
  const unsigned seeds = number_of_cases(2u, 40u);
  for (std::size_t k = 0; k < number; ++k)
  {
    const Generated_mesh<Surface_mesh> data(soups[k].second);
    for (unsigned seed = 1; seed <= seeds; ++seed)
    {
      Report::instance().set_context(std::string(soups[k].first) + ", seed " + std::to_string(seed));
      Random_sources sources(data.mesh, seed);
      const double size = bounding_box_diagonal(data.mesh);
      Source_set set;
      for (std::size_t i = 0, n = 2 + seed % 4; i < n; ++i)
      {
        auto s = sources();
        s.start_value = sources.random()() % 3 == 0 ? 0 : uniform(sources.random(), 0, 0.5) * size;
        set.add(s);
      }
      Case(data.mesh, set).check(sources.random());
    }
  }
}

// A restart: each vertex of one region is a source with its distance as start value, so that all sources tie.
void restarts()
{
  std::size_t number;
  const auto* const soups = all_soups(number);
  for (std::size_t k = 0; k < number; ++k)
  {
    Report::instance().set_context(std::string("restart, ") + soups[k].first);
    const Generated_mesh<Surface_mesh> data(soups[k].second);
    Geodesic first(data.mesh), second(data.mesh);
    first.add_source_point(data.vertices[0]);
    first.build();
    const double limit = 0.4 * first.field().largest_vertex_distance().value(), size = bounding_box_diagonal(data.mesh);
    for (const auto v : used_vertices(data.mesh))
      if (const double d = first.distance_to_sources(v); d <= limit)
        second.add_source_point(v, CGAL::parameters::start_value(d));
    second.build(CGAL::parameters::keep_windows(true));
    // no path is shorter, and the vertices of the region keep their distances
    for (const auto v : used_vertices(data.mesh))
    {
      const double a = second.distance_to_sources(v), b = first.distance_to_sources(v);
      CHECK_DETAIL(a >= b - tolerance(b, size), values(a, b));
      if (b <= limit) CHECK_DETAIL(std::abs(a - b) <= tolerance(b, size), values(a, b));
    }
    Offset_integrals integrals(second, data.mesh);
    for (const double part : {0.3, 0.5, 0.7}) totals.derivatives(integrals, part * integrals.largest_distance());
  }
}

// A second source at a vertex, with the distance from the first one as start value, up to rounding: no distance changes.
void equal_distances()
{
  std::size_t number;
  const auto* const soups = all_soups(number);
  for (std::size_t k = 0; k < number; ++k)
  {
    const Generated_mesh<Surface_mesh> data(soups[k].second);
    const Mesh_locations locations(data.mesh);
    const double size = bounding_box_diagonal(data.mesh), unit = std::numeric_limits<double>::epsilon();
    Random random(k + 1);
    for (unsigned seed = 1; seed <= number_of_cases(3u, 60u); ++seed)
    {
      const Face_location source = random_location(locations, data.mesh, random, 0);
      Geodesic alone(data.mesh);
      alone.add_source_point(source);
      alone.build(CGAL::parameters::keep_windows(true));
      auto h = halfedge(source.first, data.mesh);
      for (int corner = 0; corner < 4; ++corner) // those of its face, and of the next one
      {
        const auto v = target(h, data.mesh);
        h = corner == 2 && !is_border(opposite(h, data.mesh), data.mesh)
            ? next(opposite(h, data.mesh), data.mesh)
            : next(h, data.mesh);
        for (const int units : {-40, -3, -1, 0, 1, 3, 40})
        {
          Report::instance().set_context(std::string("equal distances, ") + soups[k].first + ", seed " + std::to_string(seed) +
                                         ", corner " + std::to_string(corner) + ", units " + std::to_string(units));
          Geodesic both(data.mesh);
          both.add_source_point(source);
          both.add_source_point(v, CGAL::parameters::start_value((1 + units * unit) * alone.distance_to_sources(v)));
          both.build(CGAL::parameters::keep_windows(true));
          const auto check = [&](const auto& query) {
            const double a = both.distance_to_sources(query), b = alone.distance_to_sources(query);
            CHECK_DETAIL(std::abs(a - b) <= tolerance(b, size), values(a, b));
          };
          for (const auto w : used_vertices(data.mesh)) check(w);
          for (int i = 0; i < 10; ++i) check(random_location(locations, data.mesh, random, 0));
        }
      }
    }
  }
}

// One source: all distances and offsets are shifted.
void one_source()
{
  std::size_t number;
  const auto* const soups = all_soups(number);
  for (std::size_t k = 0; k < number; ++k)
  {
    const Generated_mesh<Surface_mesh> data(soups[k].second);
    for (unsigned seed = 1; seed <= 4; ++seed)
    {
      Report::instance().set_context(std::string("one source, ") + soups[k].first + ", seed " + std::to_string(seed));
      Random_sources sources(data.mesh, 100 + seed);
      auto source = sources();
      Geodesic plain(data.mesh), delayed(data.mesh);
      Source_set set;
      set.add(source);
      plain.add_sources(set);
      set.clear();
      source.start_value = 0.75;
      set.add(source);
      delayed.add_sources(set);
      plain.build(CGAL::parameters::keep_windows(true));
      delayed.build(CGAL::parameters::keep_windows(true));
      const double largest = plain.largest_distance().value(), size = bounding_box_diagonal(data.mesh);
      CHECK_DETAIL(std::abs(delayed.largest_distance().value() - (0.75 + largest)) <= tolerance(0.75 + largest, size),
                   values(delayed.largest_distance().value(), 0.75 + largest));
      for (const double part : {0.11, 0.37, 0.63, 0.88})
      {
        const double d = part * largest, shift = 0x1p-42 * 0.75; // levels are cut below themselves
        double a = 0, b = 0;
        for (const auto& c : offsets(plain, d)) a += c.length();
        for (const auto& c : offsets(delayed, 0.75 + d + shift)) b += c.length();
        CHECK_DETAIL(std::abs(a - b) <= 1e-9 * (a + size), values(a, b));
      }
      const auto v = *used_vertices(data.mesh).begin();
      const double a = or_nan(plain.field().signed_distance_to_sources(v)),
                   b = or_nan(delayed.field().signed_distance_to_sources(v));
      CHECK_DETAIL(std::isnan(a) ? std::isnan(b)
                   : a == 0      ? b == 0.75
                                 : std::abs(b - (a + std::copysign(0.75, a))) <= tolerance(b, size),
                   values(a, b));
    }
  }
}

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

} // namespace test_start_values

GEODESIC_OFFSET_TEST(test_start_values)
{
  const std::pair<const char*, void (*)()> tests[] = {
    {"several sources", test_start_values::several_sources},
    {"one source", test_start_values::one_source},
    {"restarts", test_start_values::restarts},
    {"equal distances", test_start_values::equal_distances},
    {"far apart", test_start_values::far_apart},
    {"tolerances", test_start_values::tolerances},
    {"found sources", test_start_values::found_sources},
    {"other number types", test_start_values::other_number_types},
    {"bad values", test_start_values::bad_values}};
  const int result = run_tests("test_start_values", tests);
  const auto& t = test_start_values::totals;
  std::cout.precision(3);
  std::cout << t.points << " points, distances off by " << t.distance << ", " << t.ties << " ties, " << t.dominated
            << " sources inside the region of another one, " << t.paths << " paths off by " << t.path << ", "
            << t.derivatives.distances << " levels, " << t.derivatives.at_events << " of them at events, derivatives off by "
            << t.derivatives.worst << ", certified bounds apart by " << t.width << ", offsets certified within " << t.certified
            << std::endl;
  return result;
}
