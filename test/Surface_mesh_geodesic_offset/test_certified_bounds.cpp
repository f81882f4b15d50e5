// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Certified bounds contain the distances of a run with 200 bits, and are close together: 150 random meshes, planar,
// symmetric, rotated and with needles, with points, polylines and edges as sources. Rays pass vertices closely, sources are
// very near to saddle vertices, and windows are swept in several rounds.

#include "geodesic_types.h"
#include "query_cases.h"
#include "test_check.h"

#include <CGAL/Gmpfr.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_envelope.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_certified_bounds {

using namespace test;

typedef CGAL::Surface_mesh_geodesic_offset_traits<CGAL::Simple_cartesian<CGAL::Gmpfr>, test::Surface_mesh> Long_traits;
typedef CGAL::Surface_mesh_geodesic_offset<Long_traits> Long_distance;
typedef CGAL::Surface_mesh_geodesic_enclosure<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh>> Enclosure;

Soup random_mesh(unsigned seed)
{
  const std::size_t k = seed / 12;
  const double thin = std::pow(10., -1. - double(k % 6));
  switch (seed % 12)
  {
  case 0: return random_rectangle(2, 1, 10 + 3 * k % 60, 4, seed);
  case 1: return rotated(random_rectangle(2, thin, 10 + 2 * k % 40, 6, seed), seed);
  case 2: return planar_grid(3 + k % 5, 2 + k % 7, k % 2 ? Diagonals::alternating : Diagonals::forward);
  case 3: return cube_grid(1 + k % 4);
  case 4: return rotated(box_sides(1, 0.7, thin).triangulated(10 + k % 20, 2, seed), seed);
  case 5: return torus(5 + k % 5, 4 + k % 4);
  case 6: return rotated(torus(6 + k % 3, 5 + k % 4, 1, 0.2 + 0.02 * double(k)), seed);
  case 7: return icosphere(1);
  case 8: return marching_sphere(4 + k % 3);
  case 9: return rotated(Cone(6 + k % 5, (0.5 + 0.25 * double(k % 11)) * CGAL_PI, 1).triangulated(12, 2, seed), seed);
  case 10: return l_shape(6 + k % 8, 2 + k % 3, seed);
  default: return rotated(needle_fan(20 + 7 * k), seed);
  }
}

CGAL::Gmpfr as_long(double x) { return CGAL::Gmpfr(x); }

Long_distance::Face_location as_long(const Face_location& l)
{
  return {l.first, {{as_long(l.second[0]), as_long(l.second[1]), as_long(l.second[2])}}};
}

struct Widths
{
  std::vector<double> all;
  void add(double lower, double upper)
  {
    if (upper > 0 && std::isfinite(upper)) all.push_back((upper - lower) / upper);
  }
  double median()
  {
    if (all.empty()) return 0;
    std::nth_element(all.begin(), all.begin() + std::ptrdiff_t(all.size() / 2), all.end());
    return all[all.size() / 2];
  }
  double largest() const { return all.empty() ? 0 : *std::max_element(all.begin(), all.end()); }
};

void check(const std::pair<double, double>& bounds, const CGAL::Gmpfr& distance)
{
  CHECK(bounds.first <= bounds.second);
  const bool is_reached = distance < CGAL::Gmpfr(1e299);
  CHECK(is_reached == std::isfinite(bounds.second));
  CHECK(is_reached == std::isfinite(bounds.first));
  if (!is_reached) return;
  CHECK_DETAIL(CGAL::Gmpfr(bounds.first) <= distance, values(bounds.first, CGAL::to_double(distance)));
  CHECK_DETAIL(distance <= CGAL::Gmpfr(bounds.second), values(bounds.second, CGAL::to_double(distance)));
}

// Builds both with the same sources; the distances of all vertices, and of arbitrary points, must be within the bounds.
void contains_200_bits(Query_case& c, unsigned seed, Widths& at_vertices, Widths& elsewhere, std::size_t& windows,
                       std::size_t& certified_windows)
{
  Random random(seed);
  Long_distance exact(c.mesh);
  Enclosure enclosure(c.mesh);
  const std::size_t sources = 1 + (seed % 5 == 0);
  for (std::size_t i = 0; i < sources; ++i)
  {
    if (seed % 7 == 6)
    {
      std::vector<boost::graph_traits<test::Surface_mesh>::edge_descriptor> some;
      for (auto e : edges(c.mesh))
        if (uniform_index(random, num_edges(c.mesh)) < 2) some.push_back(e);
      if (some.empty()) some.push_back(*edges(c.mesh).begin());
      exact.add_source_edges(some);
      enclosure.add_source_edges(some);
      continue;
    }
    const Any_source s = seed % 3 == 0 ? Any_source{c.random_points(random, 1), false} : c.random_source(random);
    std::vector<Long_distance::Face_location> locations;
    for (const auto& l : s.locations) locations.push_back(as_long(l));
    if (s.locations.size() == 1)
    {
      exact.add_source_point(locations.front());
      enclosure.add_source_point(s.locations.front());
    }
    else
    {
      exact.add_source_polyline(locations, CGAL::parameters::is_closed(s.closed));
      enclosure.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
    }
  }
  exact.build(CGAL::parameters::keep_windows(true));
  // without kept windows, monotone lists are not swept
  enclosure.build();
  std::vector<std::pair<double, double>> without;
  for (Vertex_index v : vertices(c.mesh))
  {
    without.push_back(enclosure.distance_bounds(v));
    check(without.back(), exact.distance_to_sources(v));
  }
  enclosure.build(CGAL::parameters::keep_windows(true));
  windows += exact.statistics().windows_propagated;
  certified_windows += enclosure.number_of_windows();
  auto others = without.begin();
  for (Vertex_index v : vertices(c.mesh))
  {
    const auto bounds = enclosure.distance_bounds(v);
    check(bounds, exact.distance_to_sources(v));
    at_vertices.add(bounds.first, bounds.second);
    CHECK(others->first <= bounds.second && bounds.first <= others->second);
    CHECK(others->second - others->first <= 4 * (bounds.second - bounds.first));
    ++others;
  }
  for (const auto& p : c.random_points(random, 20))
  {
    const auto bounds = enclosure.distance_bounds(p);
    check(bounds, exact.distance_to_sources(as_long(p)));
    elsewhere.add(bounds.first, bounds.second);
  }
}

void random_meshes()
{
  CGAL::Gmpfr::set_default_precision(200);
  Widths at_vertices, elsewhere;
  std::size_t windows = 0, certified_windows = 0;
  for (unsigned seed = 0; seed < number_of_cases(42u, 150u); ++seed)
  {
    Report::instance().set_context("random mesh " + std::to_string(seed));
    Query_case c("random", random_mesh(seed));
    contains_200_bits(c, seed, at_vertices, elsewhere, windows, certified_windows);
  }
  std::cout << at_vertices.all.size() << " vertices: relative width " << at_vertices.median() << " in the median, at most "
            << at_vertices.largest() << "\n"
            << elsewhere.all.size() << " other points: " << elsewhere.median() << " and " << elsewhere.largest() << "\n"
            << certified_windows << " windows propagated, with 200 bits " << windows << std::endl;
  CHECK(at_vertices.median() <= 1e-13);
  CHECK(elsewhere.median() <= 1e-13);
}

// A ray that passes a flat vertex so closely that rounding of an edge's length could leave it between two windows: a source
// just before the vertex, exactly opposite to another source.
void past_flat_vertex()
{
  Random random(1);
  for (const double before : {1e-3, 1e-6, 1e-8, 1e-10, 1e-12})
    for (int i = 0; i < 600; ++i)
    {
      // around vertex 0: two vertices above, three below
      Soup soup;
      soup.points.push_back(Point_3(uniform(random, 0.3, 1), uniform(random, 0.3, 1), 0));
      const Point_3 o = soup.points.front();
      const double corners[5][2] = {{-uniform(random, 0.3, 1), 0.3 * uniform(random)},
                                    {-0.8 * uniform(random, 0.3, 1), -uniform(random, 0.3, 1)},
                                    {0.05 * uniform(random), -1 - uniform(random)},
                                    {0.8 * uniform(random, 0.3, 1), -uniform(random, 0.3, 1)},
                                    {uniform(random, 0.3, 1), 0.3 * uniform(random)}};
      for (const auto& c : corners) soup.points.push_back(Point_3(o.x() + c[0], o.y() + c[1], 0));
      for (std::size_t k = 1; k <= 5; ++k)
      {
        const std::size_t next = k % 5 + 1;
        const auto uv = [&](std::size_t j) { return Point_2(soup.points[j].x(), soup.points[j].y()); };
        soup.add_triangle({{0, k, next}}, 0, {{uv(0), uv(k), uv(next)}});
      }
      const Generated_mesh<test::Surface_mesh> data(soup);
      // opposite to vertex 3, in the face of 0, 5 and 1
      const Vector_3 a = soup.points[5] - o, b = soup.points[1] - o, way = soup.points[3] - o;
      const double x = -before * way.x(), y = -before * way.y(), area = a.x() * b.y() - a.y() * b.x();
      const double of_a = (x * b.y() - y * b.x()) / area, of_b = (a.x() * y - a.y() * x) / area;
      if (of_a < 1e-12 || of_b < 1e-12) continue; // would be moved to an edge
      Face_location source(data.faces[4], {{0, 0, 0}});
      const Mesh_locations locations(data.mesh);
      const auto order = locations.corners(data.faces[4]);
      for (std::size_t k = 0; k < 3; ++k)
        source.second[k] = order[k] == data.vertices[5] ? of_a : order[k] == data.vertices[1] ? of_b : 1 - of_a - of_b;
      Enclosure enclosure(data.mesh);
      enclosure.add_source_point(source);
      enclosure.build();
      const double distance = std::sqrt(way.squared_length()) * (1 + before);
      const auto bounds = enclosure.distance_bounds(data.vertices[3]);
      CHECK_DETAIL(bounds.first <= distance * (1 + 1e-12) && bounds.second >= distance * (1 - 1e-12),
                   values(bounds.first, distance));
    }
}

// Sources at a saddle vertex, near and very near, and short segments there: distances behind it do not exceed those via the
// vertex.
void near_saddle()
{
  Random random(2);
  for (const double total : {2.2, 2.5, 3., 4.2})
    for (const double near : {1e-2, 1e-5, 1e-8, 1e-11})
      for (std::size_t i = 0; i < 8; ++i)
      {
        const Soup cone = Cone(8, total * CGAL_PI, 1).triangulated(0, 0, 1);
        const Generated_mesh<test::Surface_mesh> data(rotated(cone, static_cast<unsigned>(i)));
        const Mesh_locations locations(data.mesh);
        const auto& face = data.faces[uniform_index(random, data.faces.size())];
        const Vertex_index apex = data.vertices[0];
        const auto order = locations.corners(face);
        const auto place = [&](double x, double y) { // from the apex along both edges
          Face_location l(face, {{0, 0, 0}});
          bool is_first = true;
          for (std::size_t k = 0; k < 3; ++k)
          {
            l.second[k] = order[k] == apex ? 1 - x - y : is_first ? x : y;
            is_first = is_first && order[k] == apex;
          }
          return l;
        };
        Enclosure enclosure(data.mesh);
        if (i % 2 == 0)
        {
          const double x = near * uniform(random, 0.1, 1), y = near * uniform(random, 0.1, 1);
          enclosure.add_source_point(place(x, i % 4 == 0 ? 0 : y));
        }
        else enclosure.add_source_polyline(std::vector<Face_location>{place(near, 0), place(near * 0.9, near * 0.2)});
        enclosure.build();
        const double to_apex = enclosure.distance_bounds(apex).second;
        CHECK(to_apex > 0 && to_apex <= 2 * near);
        for (Vertex_index v : vertices(data.mesh))
        {
          const double way = to_apex + distance(data.mesh.point(apex), data.mesh.point(v));
          const auto bounds = enclosure.distance_bounds(v);
          CHECK_DETAIL(bounds.first <= way * (1 + 1e-15), values(bounds.first, way));
          CHECK(bounds.second <= way * (1 + 1e-12));
        }
      }
}

// Random windows on one edge, swept in several rounds: the nearest window remains everywhere, and the list remains sorted.
void sweeps()
{
  using namespace CGAL::Geodesic_offset::internal;
  Random random(3);
  Certified_envelope sweep;
  for (int list = 0; list < 20000; ++list)
  {
    std::vector<Certified_window> all, swept;
    for (int round = 0; round < 3; ++round)
    {
      for (std::size_t i = 0, n = 1 + uniform_index(random, 3); i < n; ++i)
      {
        Certified_window w{};
        w.bits = uniform_index(random, 4) == 0;
        const double angle = uniform(random, 0.2, CGAL_PI - 0.2);
        w.set_image(w.is_parallel() ? Double_double_2{std::cos(angle), -std::sin(angle)}
                                    : Double_double_2{uniform(random, -0.5, 1.5), -uniform(random, 0.1, 1)});
        w.sigma = w.is_parallel() ? uniform(random, 0.8, 1.6) : uniform(random, 0, 0.6);
        const double from = uniform_index(random, 2) ? 0. : uniform(random, 0, 0.8);
        w.set_interval(from, uniform_index(random, 2) ? 1. : uniform(random, from + 0.05, 1));
        all.push_back(w);
        swept.push_back(w);
      }
      const auto& result = sweep(swept.data(), swept.data() + swept.size(), 1.);
      swept.assign(result.begin(), result.end());
      for (Certified_window& w : swept) w.set_propagated();
      CHECK(std::is_sorted(swept.begin(), swept.end(), [](const Certified_window& a, const Certified_window& b) {
        return a.b0 < b.b0;
      }));
    }
    const auto nearest = [](const std::vector<Certified_window>& windows, double t) {
      double result = infinity;
      for (const Certified_window& w : windows)
        if (w.b0 <= t && t <= w.b1) result = (std::min)(result, w.distance_at(t));
      return result;
    };
    for (int i = 0; i < 50; ++i)
    {
      const double t = (i + 0.5) / 50, d = nearest(all, t);
      if (std::isfinite(d)) CHECK(nearest(swept, t) <= d + 1e-13);
    }
  }
}

template <class Exception, class Function>
bool throws(const Function& f)
{
  try
  {
    f();
  }
  catch (const Exception&)
  {
    return true;
  }
  return false;
}

// Documented use and misuse.
void use()
{
  const Generated_mesh<test::Surface_mesh> data(planar_grid(4, 4));
  const Face_location inside(data.faces[5], {{0.25, 0.25, 0.5}});
  Enclosure enclosure(data.mesh);
  CHECK(!enclosure.is_built());
  CHECK(throws<std::logic_error>([&] { enclosure.distance_bounds(data.vertices[0]); }));
  enclosure.build();
  CHECK(enclosure.is_built());
  CHECK(enclosure.distance_bounds(data.vertices[0]).first == infinity); // no source
  CHECK(throws<std::logic_error>([&] { enclosure.distance_bounds(inside); }));
  enclosure.add_source_point(data.vertices[0]);
  CHECK(enclosure.distance_bounds(data.vertices[0]).first == infinity); // until the next build
  std::fesetround(FE_UPWARD);
  CHECK(throws<std::logic_error>([&] { enclosure.build(); }));
  std::fesetround(FE_TONEAREST);
  enclosure.build(CGAL::parameters::keep_windows(true));
  CHECK(enclosure.distance_bounds(data.vertices[0]).second == 0);
  CHECK(enclosure.number_of_windows() > 0);
  CHECK(throws<std::invalid_argument>([&] { enclosure.distance_bounds(Face_location(data.faces[5], {{2, -1, 0}})); }));
  // squared distances in a plane are exact for small integer coordinates
  for (Vertex_index v : vertices(data.mesh))
  {
    const Point_3 &p = data.mesh.point(data.vertices[0]), &q = data.mesh.point(v);
    check(enclosure.distance_bounds(v), CGAL::sqrt(CGAL::Gmpfr(CGAL::squared_distance(p, q))));
  }
  // found by fuzz_offsets: a polyline that repeats a vertex
  const Face_location corner(data.faces[5], {{1, 0, 0}});
  enclosure.clear_sources();
  enclosure.add_source_polyline(std::vector<Face_location>{corner, corner, inside});
  enclosure.build(CGAL::parameters::keep_windows(true));
  CHECK(enclosure.distance_bounds(corner).second == 0);
}

// Three right triangles of a rotated grid: rounding increased the border angle at the second of the three border vertices
// beyond a half turn, by about 5e-17. The path along the border continues there.
void straight_border()
{
  const Point_3 points[] = {{-0.89038339860091908, 0.34313008280605106, 0.29913065668598604},
                            {-1.131291247141164, 0.54549966234975411, -0.65008478871459074},
                            {-1.7807667972018382, 0.68626016561210212, 0.59826131337197208},
                            {-2.0216746457420829, 0.88862974515580517, -0.3509541320286047},
                            {-2.671150195802757, 1.0293902484181532, 0.89739197005795812}};
  const int triangles[3][3] = {{2, 0, 1}, {2, 1, 3}, {4, 2, 3}};
  for (const bool mirrored : {false, true})
    for (const std::pair<int, int>& ends : {std::make_pair(0, 4), std::make_pair(4, 0)})
    {
      test::Surface_mesh strip;
      for (const Point_3& p : points) strip.add_vertex(p);
      for (const auto& t : triangles)
        strip.add_face(Vertex_index(t[0]), Vertex_index(t[mirrored ? 2 : 1]), Vertex_index(t[mirrored ? 1 : 2]));
      Enclosure enclosure(strip);
      enclosure.add_source_point(Vertex_index(ends.first));
      enclosure.build();
      const std::pair<double, double> bounds = enclosure.distance_bounds(Vertex_index(ends.second));
      CHECK_DETAIL(bounds.first <= 2 && bounds.second >= 2 && bounds.second - bounds.first < 1e-13,
                   values(bounds.first, bounds.second));
    }
}

// Removed elements leave gaps, and the geometry of the others does not depend on them.
void removed_elements()
{
  Generated_mesh<test::Surface_mesh> data(planar_grid(5, 5));
  for (const int f : {0, 7, 30}) CGAL::Euler::remove_face(data.mesh.halfedge(data.faces[f]), data.mesh);
  CHECK(data.mesh.has_garbage());
  const auto check_all = [](const test::Surface_mesh& mesh, std::vector<std::pair<double, double>>& bounds) {
    Enclosure enclosure(mesh);
    enclosure.add_source_point(*std::next(mesh.vertices().begin(), 9));
    enclosure.build();
    for (const Vertex_index v : mesh.vertices()) bounds.push_back(enclosure.distance_bounds(v));
  };
  std::vector<std::pair<double, double>> with_gaps, without;
  check_all(data.mesh, with_gaps);
  data.mesh.collect_garbage();
  check_all(data.mesh, without);
  CHECK(with_gaps == without && with_gaps.size() > 30);
}

// On needles no window may be certainly nearer than another, and the number of windows doubles in every face: the result is
// bounds that contain the distances of 200 bits, or an exception, but not an endless build.
void needles_without_an_end()
{
  std::size_t refused = 0, bounded = 0;
  for (const unsigned seed : {1, 3, 4, 5, 6, 7})
  {
    Random random(seed);
    Soup soup = planar_grid(4, 4);
    const double thickness = seed % 2 ? 1e-2 : 1e-5;
    for (Point_3& p : soup.points)
      p = Point_3(thickness * uniform(random, 0, 1), thickness * uniform(random, 0, 1), uniform(random, 0, 1));
    const Generated_mesh<test::Surface_mesh> data(rotated(soup, seed));
    Enclosure enclosure(data.mesh);
    enclosure.add_source_point(data.vertices[0]);
    try
    {
      enclosure.build();
    }
    catch (const std::runtime_error&)
    {
      CHECK(!enclosure.is_built());
      ++refused;
      continue;
    }
    ++bounded;
    Long_distance exact(data.mesh);
    exact.add_source_point(data.vertices[0]);
    exact.build();
    for (const Vertex_index v : data.vertices) check(enclosure.distance_bounds(v), exact.distance_to_sources(v));
  }
  CHECK(refused > 0 && bounded > 0);
  std::cout << "needles: " << bounded << " bounded, " << refused << " refused" << std::endl;
}

} // namespace test_certified_bounds

GEODESIC_OFFSET_TEST(test_certified_bounds)
{
  const std::pair<const char*, void (*)()> tests[] = {
    {"use", use},
    {"a straight border", straight_border},
    {"removed elements", removed_elements},
    {"needles without an end", needles_without_an_end},
    {"past a flat vertex", past_flat_vertex},
    {"near a saddle vertex", near_saddle},
    {"sweeps", sweeps},
    {"random meshes", random_meshes}};
  return run_tests("test_certified_bounds", tests);
}
