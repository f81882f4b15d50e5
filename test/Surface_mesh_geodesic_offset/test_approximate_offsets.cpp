// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offset curves of builds with a tolerance: certify_offset(), which shares no code with them, proves that the curves of each level
// bound a region within the tolerance. They are cut in one propagation, from kept windows, or in a second propagation.

#include "data_directory.h"
#include "data_meshes.h"
#include "geodesic_types.h"
#include "query_cases.h"
#include "test_check.h"

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_approximate_offsets {

using namespace test;
namespace parameters = CGAL::parameters;

typedef CGAL::Surface_mesh_geodesic_enclosure<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh>> Enclosure;
typedef std::vector<Geodesic::Offset_curve> Curves;

// Of the bounds of points, and of levels, which are cut slightly below themselves; relative to the size of the mesh.
constexpr double rounding = 1e-11;

std::size_t number_of_levels = 0, number_of_curves = 0, number_along_edges = 0;
double worst_share = 0; // of the tolerance

struct Case
{
  Case(const std::string& name, const test::Surface_mesh& m)
    : name(name), mesh(m), diagonal(bounding_box_diagonal(m)), exact(m), enclosure(m)
  {
  }

  void add(const Any_source& s)
  {
    sources.push_back(s);
    s.add_to(exact);
    if (s.locations.size() == 1) enclosure.add_source_point(s.locations.front());
    else enclosure.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
  }

  void build()
  {
    exact.build();
    enclosure.build(parameters::keep_windows(true));
  }

  Geodesic with_sources() const
  {
    Geodesic g(mesh);
    for (const Any_source& s : sources) s.add_to(g);
    return g;
  }

  std::string name;
  const test::Surface_mesh& mesh;
  double diagonal;
  std::vector<Any_source> sources;
  Geodesic exact;
  Enclosure enclosure;
};

// True if a piece lies on an edge of its face.
bool is_along_edge(const Geodesic::Offset_curve::Piece& p)
{
  if (!p.is_segment()) return false;
  const auto a = p.location(0).second, b = p.location(1).second;
  for (std::size_t k = 0; k < 3; ++k)
    if (a[k] == 0 && b[k] == 0) return true;
  return false;
}

// `tolerance`: that of curves at a distance.
template <class Function>
void check_level(const Case& c, double d, const Curves& curves, const Function& tolerance)
{
  ++number_of_levels;
  number_of_curves += curves.size();
  const auto certificate = c.enclosure.certify_offset(d, curves);
  const double slack = rounding * (c.diagonal + d);
  CHECK_DETAIL(certificate.bounds_region, values(d, c.diagonal));
  CHECK(certificate.number_of_reversed_curves == 0);
  CHECK_DETAIL(certificate.tolerance <= tolerance(d) + slack, values(certificate.tolerance, tolerance(d)));
  worst_share = (std::max)(worst_share, certificate.tolerance / (tolerance(d) + slack));
  for (const auto& curve : curves)
  {
    CHECK(curve.distance() == d);
    CHECK_DETAIL(std::abs(curve.tolerance() - tolerance(d)) <= 1e-13 * d, values(curve.tolerance(), tolerance(d)));
    for (const auto& p : curve.pieces())
    {
      number_along_edges += std::size_t(is_along_edge(p));
      if (const auto v = p.pseudo_source()) CHECK(std::size_t(*v) < num_vertices(c.mesh)); // none for merged windows
    }
  }
}

template <class Function>
void check_with_tolerance(const Case& c, const std::vector<double>& levels, double relative, double absolute,
                          const Function& tolerance)
{
  const auto within = parameters::relative_tolerance(relative).merging_tolerance(absolute);
  const std::string context = Report::instance().context();
  const auto check = [&](const char* how, const auto& cut) {
    Report::instance().set_context(context + ", tolerances " + values(relative, absolute) + ", " + how);
    std::size_t calls = 0;
    cut([&](double d, Curves&& curves) {
      CHECK(calls < levels.size() && d == levels[calls]);
      ++calls;
      check_level(c, d, curves, tolerance);
    });
    CHECK(calls == levels.size());
  };
  Geodesic g = c.with_sources();
  check("one propagation", [&](const auto& f) { g.build_with_offset_curves_by_distance(levels, f, within); });
  CHECK(g.statistics().forced_joints == 0);
  check("two threads", [&](const auto& f) {
    Geodesic other = c.with_sources();
    other.build_with_offset_curves_by_distance(levels, f, within.concurrency_tag(CGAL::Parallel_if_available_tag()));
  });
  check("a second propagation", [&](const auto& f) { g.offset_curves_by_distance(levels, f); });
  check("kept windows", [&](const auto& f) {
    g.build(within.keep_windows(true));
    g.offset_curves_by_distance(levels, f);
  });
  Report::instance().set_context(context);
}

// Between the least and the largest distance; at distances of vertices, exact ones and within the tolerance; near the sources; and
// several close to each other.
std::vector<double> levels_of(const Case& c, Random& random, double relative, double absolute)
{
  Geodesic g = c.with_sources();
  g.build(parameters::relative_tolerance(relative).merging_tolerance(absolute));
  const double largest = c.exact.largest_vertex_distance().value();
  std::vector<double> levels{1e-3 * largest};
  for (int i = 1; i <= 4; ++i) levels.push_back(largest * (i - 0.37) / 4);
  for (int i = 0; i < 2; ++i)
  {
    const Vertex_index v(unsigned(uniform_index(random, num_vertices(c.mesh))));
    for (const double d : {c.exact.distance_to_sources(v), g.distance_to_sources(v)})
      if (std::isfinite(d) && d > 1e-9 * largest) levels.insert(levels.end(), {d, d * (1 + 1e-12)});
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

void check_case(Case& c, Random& random)
{
  c.build();
  const double absolute = 1e-3 * c.exact.largest_vertex_distance().value();
  for (const double t : {1e-6, 1e-4, 1e-2, 0.3})
    check_with_tolerance(c, levels_of(c, random, t, 0), t, 0, [t](double d) { return t * d / (1 - t); });
  check_with_tolerance(c, levels_of(c, random, 0, absolute), 0, absolute, [absolute](double) { return absolute; });
  check_with_tolerance(c, levels_of(c, random, 1e-3, absolute), 1e-3, absolute, [absolute](double d) {
    return (1e-3 * d + absolute) / (1 - 1e-3);
  });
}

void generated_meshes()
{
  const std::pair<const char*, Soup> soups[] = {
    {"torus", torus(24, 15)},
    {"icosphere", icosphere(3)},
    {"genus 5", marching_genus_5(8)},
    {"cube", cube_grid(6)},
    {"tetrahedron", tetrahedron_sides().triangulated(0, 0, 1)},
    {"cone of 1.5 turns", Cone(8, 3 * CGAL_PI, 1).triangulated(60, 4, 5)},
    {"plane with noise", with_noise(jittered_grid(16, 16, 7), 1e-3, 3)},
    {"graded disc", graded_disc(300, 3, 0.3, 1)},
    {"needles", rotated(needle_fan(40), 3)},
    {"crumpled needles", crumpled_needles(1e-3, 0.3, 60, 1)},
    {"saddle", saddle_fan(5)}};
  Random random(5);
  for (const auto& soup : soups)
    for (int kind = 0; kind < number_of_cases(3, 20); ++kind)
    {
      const Query_case q(soup.first, soup.second);
      Case c(soup.first, q.mesh);
      Report::instance().set_context(c.name + ", sources of kind " + std::to_string(kind));
      if (kind == 0) c.add({{q.random_points(random, 1).front()}, false});
      else
        for (int i = 0; i < kind; ++i) c.add(q.random_source(random));
      check_case(c, random);
    }
  CHECK(number_along_edges > 0);
}

void data_meshes()
{
  const Names names = {"eight.off", "anchor.off", "elephant.off", "mask_cone.off",       "mesh_with_border.off",
                       "cow.off",   "bones.off",  "hand.off",     "mannequin-devil.off", "knot1.off",
                       "femur.off"};
  for_each_data_mesh(names, 12000, [](const std::string& name, const test::Surface_mesh& mesh) {
    Case c(name, mesh);
    Report::instance().set_context(c.name);
    c.add({{Face_location(*faces(mesh).begin(), {{0.3, 0.25, 0.45}})}, false});
    c.build();
    std::vector<double> levels;
    for (int i = 1; i <= 10; ++i) levels.push_back(c.exact.largest_vertex_distance().value() * (i - 0.37) / 10);
    for (const double t : {1e-5, 1e-3}) check_with_tolerance(c, levels, t, 0, [t](double d) { return t * d / (1 - t); });
  });
}

// Open curves end on the border; with many levels few are in memory; exact builds have no tolerance; a split needs exact curves.
void other_promises()
{
  Report::instance().set_context("other promises");
  const Generated_mesh<test::Surface_mesh> data(with_noise(jittered_grid(30, 30, 2), 1e-3, 4));
  Geodesic g(data.mesh);
  g.add_source_point(Vertex_index(17));
  Curves curves;
  g.build_with_offset_curves(0.3, std::back_inserter(curves));
  for (const auto& c : curves) CHECK(c.tolerance() == 0);
  curves.clear();
  std::vector<double> levels;
  for (int i = 1; i < 400; ++i) levels.push_back(i * 0.075);
  std::size_t open = 0;
  g.build_with_offset_curves_by_distance(
    levels,
    [&](double, Curves&& found) {
      for (const auto& c : found)
      {
        const auto on_border = [&](const Face_location& l) {
          for (std::size_t k = 0; k < 3; ++k)
          {
            auto h = halfedge(l.first, data.mesh);
            for (std::size_t i = 0; i < (k + 1) % 3; ++i) h = next(h, data.mesh);
            if (l.second[k] <= 1e-12 && is_border(opposite(h, data.mesh), data.mesh)) return true;
          }
          return false;
        };
        open += std::size_t(!c.is_closed());
        CHECK(c.is_closed() || (on_border(c.pieces().front().location(0)) && on_border(c.pieces().back().location(1))));
      }
      if (curves.empty()) curves = std::move(found);
    },
    parameters::relative_tolerance(1e-3));
  CHECK(open > 0 && !curves.empty());
  CHECK_DETAIL(g.statistics().pieces_peak < g.statistics().pieces / 20,
               values(g.statistics().pieces_peak, g.statistics().pieces));
  test::Surface_mesh split(data.mesh);
  CHECK_THROWS(CGAL::split_along_offset_curves(split, curves), std::invalid_argument);
  CHECK(num_faces(split) == num_faces(data.mesh));
  Curves from_function;
  CGAL::geodesic_offset_curves(data.mesh, Vertex_index(17), 0.3, std::back_inserter(from_function),
                               parameters::relative_tolerance(1e-3));
  CHECK(!from_function.empty() && from_function.front().tolerance() > 0);
}

} // namespace test_approximate_offsets

GEODESIC_OFFSET_TEST(test_approximate_offsets)
{
  using namespace test_approximate_offsets;
  const std::pair<const char*, void (*)()> tests[] = {
    {"generated meshes", generated_meshes}, {data_case, data_meshes}, {"other promises", other_promises}};
  const int result = run_tests("test_approximate_offsets", tests);
  std::cout << number_of_levels << " levels, " << number_of_curves << " curves, " << number_along_edges
            << " pieces along edges; proven tolerances are up to " << worst_share << " of those allowed" << std::endl;
  return result;
}
