// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Certified bounds contain the distances of a run with 200 bits, and are close together: 150 random meshes, planar,
// symmetric, rotated and with needles, with points, polylines and edges as sources.

#include "geodesic_types.h"
#include "query_cases.h"
#include "test_check.h"

#include <CGAL/Gmpfr.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace test;

typedef CGAL::Surface_mesh_geodesic_offset_traits<CGAL::Simple_cartesian<CGAL::Gmpfr>, test::Surface_mesh> Long_traits;
typedef CGAL::Surface_mesh_geodesic_distance<Long_traits> Long_distance;
typedef CGAL::Surface_mesh_geodesic_enclosure<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh>>
  Enclosure;

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

// The same sources in both; the distances of all vertices, and of points anywhere, lie within the bounds.
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
      exact.add_source_polyline(locations, s.closed);
      enclosure.add_source_polyline(s.locations, s.closed);
    }
  }
  exact.build(CGAL::parameters::keep_windows(true));
  enclosure.build(CGAL::parameters::keep_windows(true));
  windows += exact.statistics().windows_propagated;
  certified_windows += enclosure.number_of_windows();
  for (Vertex_index v : vertices(c.mesh))
  {
    const auto bounds = enclosure.distance_bounds(v);
    check(bounds, exact.distance_to_sources(v));
    at_vertices.add(bounds.first, bounds.second);
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
  for (unsigned seed = 0; seed < 150; ++seed)
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

// What the documentation says of use and misuse.
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
  CHECK(enclosure.distance_bounds(data.vertices[0]).first == infinity); // until it is built again
  std::fesetround(FE_UPWARD);
  CHECK(throws<std::logic_error>([&] { enclosure.build(); }));
  std::fesetround(FE_TONEAREST);
  enclosure.build(CGAL::parameters::keep_windows(true));
  CHECK(enclosure.distance_bounds(data.vertices[0]).second == 0);
  CHECK(enclosure.number_of_windows() > 0);
  CHECK(throws<std::invalid_argument>([&] { enclosure.distance_bounds(Face_location(data.faces[5], {{2, -1, 0}})); }));
  // squared distances in a plane are exact where coordinates are small integers
  for (Vertex_index v : vertices(data.mesh))
  {
    const Point_3 &p = data.mesh.point(data.vertices[0]), &q = data.mesh.point(v);
    check(enclosure.distance_bounds(v), CGAL::sqrt(CGAL::Gmpfr(CGAL::squared_distance(p, q))));
  }
}

} // namespace

int main()
{
  const std::pair<const char*, void (*)()> tests[] = {{"use", use}, {"random meshes", random_meshes}};
  for (const auto& test : tests)
  {
    Report::instance().set_context(test.first);
    try
    {
      test.second();
    }
    catch (const std::exception& e)
    {
      CHECK_DETAIL(!"an exception was thrown", e.what());
    }
  }
  return Report::instance().finish("test_certified_bounds");
}
