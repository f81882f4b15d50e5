// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Sources added to a built field, and `update()`, against a new build, on 100 random cases, with and without kept windows.
//
//   test_updates [N]      N times as many cases

#include "query_cases.h"

namespace test_updates {

using namespace test;

struct Totals
{
  std::size_t cases = 0, updates = 0, update_windows = 0, scratch_windows = 0;
  double curves = 0;
};

// All queries of two objects with the same sources agree up to rounding.
void check_same(Query_case& c, const Geodesic& a, const Geodesic& b, bool keep, Random& random, Worst_error& worst,
                double& worst_curves)
{
  const double scale = c.checker.scale;
  for (Vertex_index v : vertices(c.mesh)) CHECK_CLOSE(worst, a.distance_to_sources(v), b.distance_to_sources(v));
  CHECK(a.covered_distance() == b.covered_distance());
  CHECK(a.is_cancelled() == b.is_cancelled());
  const Path_locations points = c.random_points(random, 60);
  for (const Face_location& l : points)
  {
    if (!keep && !is_at_vertex(l)) continue;
    CHECK_CLOSE(worst, a.distance_to_sources(l), b.distance_to_sources(l));
    const Path_locations p = c.checker(a, l, keep), q = c.checker(b, l, keep);
    const double m = length_of(c.checker.locations, p), n = length_of(c.checker.locations, q);
    CHECK_DETAIL(std::abs(m - n) <= 1e-12 * scale, values(m, n));
  }
  const double largest = largest_vertex_distance(b, c.mesh);
  if (largest == 0) return;
  for (int i = 0; i < 2; ++i)
  {
    const double level = uniform(random, 0.02, 0.98) * largest;
    const Offset_curves p = offsets(a, level), q = offsets(b, level);
    CHECK_DETAIL(p.size() == q.size(), values(double(p.size()), double(q.size())));
    const double m = total_length(p), n = total_length(q);
    worst_curves = (std::max)(worst_curves, std::abs(m - n) / (n + scale));
    CHECK_DETAIL(std::abs(m - n) <= 1e-10 * (n + scale), values(m, n));
  }
}

Geodesic from_scratch(const Query_case& c, const std::vector<Any_source>& sources, bool keep)
{
  Geodesic result(c.mesh);
  for (const Any_source& s : sources) s.add_to(result);
  result.build(CGAL::parameters::keep_windows(keep));
  return result;
}

// One to three updates, each with one to three new sources; one after a removal; one after a cancelled build.
void updates(Query_case& c, unsigned seed, bool keep, Totals& totals)
{
  const auto step = [&](const std::string& what) {
    Report::instance().set_context(c.name + ", seed " + std::to_string(seed) +
                                   (keep ? ", with windows, " : ", without windows, ") + what);
  };
  Random random(seed);
  Worst_error worst(1e-13, c.checker.scale);
  std::vector<Any_source> sources;
  Geodesic geodesic(c.mesh);
  std::vector<std::size_t> ids;
  const auto add = [&] {
    for (std::size_t i = 0; i < 1 + uniform_index(random, 3); ++i)
    {
      sources.push_back(c.random_source(random));
      ids.push_back(sources.back().add_to(geodesic));
    }
  };
  if (seed % 10 != 0) add(); // sometimes initially empty
  geodesic.build(CGAL::parameters::keep_windows(keep));
  for (std::size_t round = 0; round < 1 + seed % 3; ++round)
  {
    step("update " + std::to_string(round + 1));
    if (seed % 7 != 0 || round > 0) add(); // sometimes without changes
    if (seed % 4 == 0)                     // sometimes with a visitor
    {
      double last = 0;
      geodesic.update(CGAL::parameters::visitor([&](double fraction) {
        CHECK(fraction >= last && fraction <= 1);
        last = fraction;
        return true;
      }));
      CHECK(last == 1);
    }
    else
    {
      if (seed % 4 == 1) // a cancelled update changes nothing
      {
        const double before = geodesic.distance_to_sources(*vertices(c.mesh).begin());
        geodesic.update(CGAL::parameters::visitor([](double) { return false; }));
        CHECK(!geodesic.is_cancelled() && geodesic.distance_to_sources(*vertices(c.mesh).begin()) == before);
      }
      geodesic.update();
    }
    const Geodesic scratch = from_scratch(c, sources, keep);
    totals.update_windows += geodesic.statistics().windows_propagated;
    totals.scratch_windows += scratch.statistics().windows_propagated;
    ++totals.updates;
    check_same(c, geodesic, scratch, keep, random, worst, totals.curves);
  }
  if (seed % 3 == 0 && sources.size() > 1) // after a removal
  {
    step("after a removal");
    const std::size_t gone = uniform_index(random, sources.size());
    geodesic.remove_source(ids[gone]);
    sources.erase(sources.begin() + std::ptrdiff_t(gone));
    ids.erase(ids.begin() + std::ptrdiff_t(gone));
    add();
    geodesic.update();
    check_same(c, geodesic, from_scratch(c, sources, keep), keep, random, worst, totals.curves);
  }
  if (seed % 3 == 1) // of a cancelled build
  {
    step("of a cancelled build");
    geodesic.build(CGAL::parameters::keep_windows(keep).visitor([](double f) { return f < 0.3; }));
    add();
    geodesic.update();
    check_same(c, geodesic, from_scratch(c, sources, keep), keep, random, worst, totals.curves);
  }
  if (seed % 5 == 0) // of a build that stopped at its target
  {
    step("of a build with a target");
    const std::vector<Vertex_index> target = {used_vertices(c.mesh).front()};
    geodesic.build(CGAL::parameters::targets(target).keep_windows(keep));
    add();
    geodesic.update();
    check_same(c, geodesic, from_scratch(c, sources, keep), keep, random, worst, totals.curves);
  }
  if (seed % 3 == 2) // of a build with a maximum distance: the same parameters again
  {
    step("of a cut-off");
    const double cut = uniform(random, 0.1, 0.6) * largest_vertex_distance(geodesic, c.mesh);
    geodesic.build(CGAL::parameters::distance_limit(cut).keep_windows(keep));
    add();
    geodesic.update();
    Geodesic scratch(c.mesh);
    for (const Any_source& s : sources) s.add_to(scratch);
    scratch.build(CGAL::parameters::distance_limit(cut).keep_windows(keep));
    check_same(c, geodesic, scratch, keep, random, worst, totals.curves);
  }
  ++totals.cases;
}

} // namespace test_updates

GEODESIC_OFFSET_TEST(test_updates)
{
  const unsigned times = argc > 1 ? unsigned(std::stoul(argv[1])) : 1;
  std::cout.precision(3);
  Totals totals;
  for_each_query_case(10 * times, [&](Query_case& c, unsigned seed, bool keep) { updates(c, seed, keep, totals); });
  std::cout << totals.cases << " cases, " << totals.updates << " updates, with "
            << 100 * double(totals.update_windows) / double(totals.scratch_windows)
            << " % of the windows from scratch; worst relative difference of offset lengths " << totals.curves << std::endl;
  return Report::instance().finish("test_updates");
}
