// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Integral checks of offsets, which need no oracle: the derivative of the area of {D < d} with respect to d is the length
// of the offset at d, the integral of all lengths is the area of the surface, and both sides of polylines together are the
// whole offset.

#include "data_meshes.h"
#include "derivative_check.h"
#include "generated_meshes.h"
#include "locations.h"
#include "offset_integrals.h"
#include "plane_section.h"
#include "test_check.h"

#include <algorithm>
#include <functional>
#include <iostream>
#include <string>
#include <utility>

namespace test_offset_integrals {

using namespace test;

typedef std::function<void(Geodesic&)> Add_sources;

struct Totals
{
  Derivative_check derivatives;
  std::size_t sides = 0, levels = 0;
  double side = 0, integral = 0;
};
Totals totals;

// Calls f(name, add_sources, has_sides) for each kind of sources.
template <class Function>
void with_sources(const Surface_mesh& mesh, const Function& f)
{
  Random random(7);
  const auto vertex = *mesh.vertices().begin();
  const Face_location inside(Surface_mesh::Face_index(mesh.number_of_faces() / 2), random_barycentric(random));
  const auto sections = random_plane_section(mesh, 2);
  f(
    "vertex", [&](Geodesic& g) { g.add_source_point(vertex); }, false);
  f(
    "points",
    [&](Geodesic& g) {
      g.add_source_point(inside);
      g.add_source_point(vertex);
    },
    false);
  if (sections.empty() || sections[0].locations.size() < 3) return;
  f(
    "section",
    [&](Geodesic& g) {
      for (const auto& s : sections) g.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
    },
    true);
  f(
    "half a section",
    [&](Geodesic& g) {
      const auto& l = sections[0].locations;
      g.add_source_polyline(std::vector<Face_location>(l.begin(), l.begin() + std::ptrdiff_t(l.size() + 1) / 2));
    },
    true);
}

void derivatives_and_sides(const std::string& name, const Surface_mesh& mesh, std::size_t count)
{
  Random random(11);
  with_sources(mesh, [&](const std::string& sources, const Add_sources& add_sources, bool has_sides) {
    Report::instance().set_context(name + ", " + sources);
    Geodesic geodesic(mesh);
    add_sources(geodesic);
    geodesic.build(CGAL::parameters::keep_windows(true));
    Offset_integrals integrals(geodesic, mesh);
    for (std::size_t i = 0; i < count; ++i)
    {
      const double d = uniform(random, 0.02, 0.98) * integrals.largest_distance();
      totals.derivatives(integrals, d);
      if (!has_sides) continue;
      const Lengths_by_side lengths = lengths_by_side(geodesic, d);
      ++totals.sides;
      totals.side = (std::max)(totals.side, lengths.relative_difference());
      CHECK_DETAIL(lengths.relative_difference() <= 1e-12 && lengths.left >= 0 && lengths.right >= 0 &&
                     lengths.beyond >= -1e-12,
                   "at " + std::to_string(d) + ", " + values(lengths.left + lengths.right + lengths.beyond, lengths.whole));
    }
  });
}

// The tolerance is relative to the area.
void all_levels(const std::string& name, const Soup& soup, double tolerance)
{
  const Generated_mesh<Surface_mesh> data(soup);
  with_sources(data.mesh, [&](const std::string& sources, const Add_sources& add_sources, bool) {
    Report::instance().set_context(name + ", all levels, " + sources);
    Geodesic geodesic(data.mesh);
    add_sources(geodesic);
    geodesic.build(CGAL::parameters::keep_windows(true));
    Offset_integrals integrals(geodesic, data.mesh);
    double left_over;
    const Coarea sum = integrals.over_all_levels(tolerance / 4, left_over);
    const double total = integrals.total_area(), allowed = tolerance * total;
    totals.levels += integrals.number_of_levels();
    totals.integral = (std::max)(totals.integral, std::abs(sum.integral - total) / total);
    CHECK_DETAIL(std::abs(sum.area - total) <= allowed, values(sum.area, total));
    CHECK_DETAIL(std::abs(sum.integral - total) <= allowed, values(sum.integral, total));
    CHECK_DETAIL(left_over <= allowed, values(left_over, 0));
  });
}

// Wrong lengths and areas are detected.
void differences_are_seen()
{
  Report::instance().set_context("wrong lengths");
  const Generated_mesh<Surface_mesh> data(icosphere(1));
  Geodesic geodesic(data.mesh);
  geodesic.add_source_point(data.vertices[0]);
  geodesic.build(CGAL::parameters::keep_windows(true));
  Offset_integrals integrals(geodesic, data.mesh);
  Level_measure from = integrals.measure(0.4), to = integrals.measure(0.401);
  CHECK(from.fits && to.fits && from.areas.size() == data.mesh.number_of_faces());
  CHECK(integrals.between(from, to).relative_difference() <= 1e-9);
  from.areas[0] += 1e-9;
  CHECK(integrals.between(from, to).relative_difference() > 1e-9);
}

void generated_meshes()
{
  const std::pair<const char*, Soup> soups[] = {
    {"torus", torus(14, 10)},
    {"icosphere", icosphere(2)},
    {"cube", cube_grid(4)},
    {"needles", random_rectangle(1, 0.01, 60, 4, 3)},
    {"tiny faces", marching_sphere(6)},
    {"cone of 1.5 turns", Cone(8, 3 * CGAL_PI, 1).triangulated(25, 4, 5)},
    {"jittered grid", jittered_grid(12, 9, 7)}};
  for (const auto& soup : soups) derivatives_and_sides(soup.first, Generated_mesh<Surface_mesh>(soup.second).mesh, 15);
}

void data_meshes()
{
  for (const auto& file : data_files())
  {
    Surface_mesh mesh;
    if (read_data_mesh(file, 6000, mesh).empty()) derivatives_and_sides(file.filename().string(), mesh, 2);
  }
}

void integrals_over_all_levels()
{
  all_levels("jittered grid", jittered_grid(3, 3, 5), 1e-9);
  all_levels("icosahedron", icosphere(0), 1e-9);
  all_levels("tetrahedron", tetrahedron_sides().triangulated(2, 1, 1), 1e-9);
  all_levels("saddle", saddle_fan(), 1e-9);
}

// Only few distances are at events, where nothing is compared.
void few_events()
{
  CHECK_DETAIL(totals.derivatives.at_events * 20 <= totals.derivatives.distances,
               std::to_string(totals.derivatives.at_events) + " of " + std::to_string(totals.derivatives.distances));
}

} // namespace test_offset_integrals

GEODESIC_OFFSET_TEST(test_offset_integrals)
{
  const auto generated = [] {
    generated_meshes();
    few_events();
  };
  const auto data = [] {
    data_meshes();
    few_events();
  };
  const std::pair<const char*, void (*)()> tests[] = {{"generated meshes", generated},
                                                      {"all levels", integrals_over_all_levels},
                                                      {"wrong lengths", differences_are_seen},
                                                      {data_case, data}};
  const int result = run_tests("test_offset_integrals", tests);
  std::cout.precision(3);
  std::cout << totals.derivatives.distances << " distances, " << totals.derivatives.at_events
            << " of them at events; derivatives off by at most " << totals.derivatives.worst << "; " << totals.sides
            << " levels by sides, off by " << totals.side << "; " << totals.levels << " levels for integrals, off by "
            << totals.integral << " of the area" << std::endl;
  return result;
}
