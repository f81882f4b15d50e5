// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Integral checks of offsets, which need no oracle: the derivative of the area of {D < d} with respect to d is the length
// of the offset at d, the integral of all lengths is the area of the surface, and both sides of polylines together are the
// whole offset.

#include "derivative_check.h"
#include "query_cases.h"

#include <algorithm>
#include <iostream>
#include <string>
#include <utility>

namespace test_offset_integrals {

using namespace test;

struct Totals
{
  Derivative_check derivatives;
  std::size_t sides = 0, levels = 0;
  double side = 0, integral = 0;
};
Totals totals;

// Calls f(name, sources, has_sides) for each kind of sources.
template <class Function>
void with_sources(const Surface_mesh& mesh, const Function& f)
{
  Random random(7);
  const Source vertex = point_source(*vertices(mesh).begin()),
               inside = point_source({Surface_mesh::Face_index(mesh.number_of_faces() / 2), random_barycentric(random)});
  f("vertex", std::vector<Source>{vertex}, false);
  f("points", std::vector<Source>{inside, vertex}, false);
  std::vector<Source> sections;
  for (const auto& s : random_plane_section(mesh, 2)) sections.push_back(polyline_source(s.locations, s.closed));
  if (sections.empty() || sections[0].locations.size() < 3) return;
  f("section", sections, true);
  const auto& l = sections[0].locations;
  f("half a section", std::vector<Source>{polyline_source({l.begin(), l.begin() + std::ptrdiff_t(l.size() + 1) / 2})}, true);
}

void derivatives_and_sides(const Query_case& c, std::size_t count)
{
  Random random(11);
  with_sources(c.mesh, [&](const std::string& name, const std::vector<Source>& sources, bool has_sides) {
    c.set_context(name);
    const Geodesic geodesic = built(c.mesh, sources);
    Offset_integrals integrals(geodesic, c.mesh);
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
  with_sources(data.mesh, [&](const std::string& kind, const std::vector<Source>& sources, bool) {
    Report::instance().set_context(name + ", all levels, " + kind);
    const Geodesic geodesic = built(data.mesh, sources);
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
  const Geodesic geodesic = built(data.mesh, {point_source(data.vertices[0])});
  Offset_integrals integrals(geodesic, data.mesh);
  Level_measure from = integrals.measure(0.4), to = integrals.measure(0.401);
  CHECK(from.fits && to.fits && from.areas.size() == data.mesh.number_of_faces());
  CHECK(integrals.between(from, to).relative_difference() <= 1e-9);
  from.areas[0] += 1e-9;
  CHECK(integrals.between(from, to).relative_difference() > 1e-9);
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
    for_each_mesh(all_mesh_names(), {}, [](const Query_case& c) { derivatives_and_sides(c, 15); });
    few_events();
  };
  const auto data = [] {
    for_each_mesh(
      {}, data_mesh_names(), [](const Query_case& c) { derivatives_and_sides(c, 2); }, 6000);
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
