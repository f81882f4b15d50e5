// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds that stop early, against the full field: at targets, at a distance limit, by cancellation. Their known part is
// correct and its extent is reported; paths and offsets work.
//
//   test_stop_conditions [N]      N times as many cases

#include "query_cases.h"

namespace test_stop_conditions {

using namespace test;

struct Totals
{
  std::size_t near_windows = 0, far_windows = 0, all_windows = 0, cancelled = 0, calls = 0;
};

// The known part of a stopped field: the full field up to the covered distance, and nothing beyond it.
void check_covered(Query_case& c, const Geodesic& part, const Geodesic& full, bool keep, Random& random)
{
  const double covered = part.covered_distance();
  CHECK_DETAIL(covered > 0, std::to_string(covered));
  Worst_error worst(1e-13, c.checker.scale);
  const double rounding = 1e-13 * c.checker.scale;
  const auto check = [&](const auto& query) {
    const double d = part.distance_to_sources(query), all = full.distance_to_sources(query);
    if (d <= covered) CHECK_CLOSE(worst, d, all);
    else CHECK_DETAIL(std::isinf(d) && all >= covered - rounding, values(d, all));
    if (all <= covered - rounding) CHECK(std::isfinite(d));
  };
  std::size_t i = 0;
  for (Vertex_index v : vertices(c.mesh))
  {
    check(v);
    if (++i % 20 == 0) c.checker(part, v, false);
  }
  for (const Face_location& l : c.random_points(random, 90))
    if (keep || is_at_vertex(l))
    {
      check(l);
      c.checker(part, l, keep);
    }
  if (std::isfinite(covered) && covered > 1e-6 * c.checker.scale)
  {
    const Offset_curves p = offsets(part, 0.7 * covered), q = offsets(full, 0.7 * covered);
    const double m = total_length(p), n = total_length(q);
    CHECK_DETAIL(p.size() == q.size() && std::abs(m - n) <= 1e-10 * (n + c.checker.scale), values(m, n));
  }
}

void stops(Query_case& c, unsigned seed, bool keep, Totals& totals)
{
  Random random(seed);
  const auto step = [&](const std::string& what) {
    Report::instance().set_context(c.name + ", seed " + std::to_string(seed) +
                                   (keep ? ", with windows, " : ", without windows, ") + what);
  };
  step("the full field");
  std::vector<Any_source> sources(1 + seed % 2);
  for (Any_source& s : sources) s = c.random_source(random);
  Geodesic full(c.mesh);
  for (const Any_source& s : sources) s.add_to(full);
  std::vector<double> fractions;
  full.build(CGAL::parameters::keep_windows(true).visitor([&](double f) {
    fractions.push_back(f);
    return true;
  }));
  CHECK(!full.is_cancelled() && full.covered_distance() == infinity);
  CHECK(!fractions.empty() && fractions.front() >= 0 && fractions.back() == 1);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  totals.calls += fractions.size();
  const double largest = largest_vertex_distance(full, c.mesh);
  // lower envelopes, which kept windows need, have slightly fewer windows
  const auto windows_without_keeping = [&] {
    Geodesic whole(c.mesh);
    for (const Any_source& s : sources) s.add_to(whole);
    whole.build();
    return whole.statistics().windows_propagated;
  };
  const std::size_t all = keep ? full.statistics().windows_propagated : windows_without_keeping();

  // targets: the nearest and the farthest of some vertices
  std::vector<Vertex_index> some = used_vertices(c.mesh);
  for (Vertex_index& v : some) std::swap(v, some[uniform_index(random, some.size())]);
  some.resize((std::min)(some.size(), std::size_t(50)));
  std::sort(some.begin(), some.end(),
            [&](Vertex_index v, Vertex_index w) { return full.distance_to_sources(v) < full.distance_to_sources(w); });
  for (const bool near : {true, false})
  {
    step(near ? "a near target" : "a far target");
    Geodesic part(c.mesh);
    for (const Any_source& s : sources) s.add_to(part);
    const Vertex_index target = near ? some.front() : some.back();
    part.build(CGAL::parameters::targets(std::vector<Vertex_index>{target}).keep_windows(keep));
    CHECK(!part.is_cancelled());
    CHECK_DETAIL(part.distance_to_sources(target) <= part.covered_distance(),
                 values(part.distance_to_sources(target), part.covered_distance()));
    Worst_error worst(1e-13, c.checker.scale);
    CHECK_CLOSE(worst, part.distance_to_sources(target), full.distance_to_sources(target));
    c.checker(part, target, keep);
    check_covered(c, part, full, keep, random);
    const std::size_t windows = part.statistics().windows_propagated;
    CHECK_DETAIL(windows <= all, values(double(windows), double(all)));
    if (near && full.distance_to_sources(target) < 0.3 * largest)
      CHECK_DETAIL(windows < all, values(double(windows), double(all)));
    (near ? totals.near_windows : totals.far_windows) += windows;
    if (near) totals.all_windows += all;
  }
  // several targets of all kinds
  if (keep)
  {
    step("targets of all kinds");
    const Path_locations targets = c.random_points(random, 3);
    Geodesic part(c.mesh);
    for (const Any_source& s : sources) s.add_to(part);
    part.build(CGAL::parameters::keep_windows(true).targets(targets));
    Worst_error worst(1e-13, c.checker.scale);
    for (const Face_location& t : targets)
    {
      CHECK_CLOSE(worst, part.distance_to_sources(t), full.distance_to_sources(t));
      c.checker(part, t);
    }
    check_covered(c, part, full, keep, random);
  }
  // a distance limit, with paths
  step("a cut-off");
  Geodesic cut(c.mesh);
  for (const Any_source& s : sources) s.add_to(cut);
  const double maximum = uniform(random, 0.05, 0.9) * largest;
  cut.build(CGAL::parameters::keep_windows(keep).distance_limit(maximum));
  CHECK(cut.covered_distance() == maximum && !cut.is_cancelled());
  check_covered(c, cut, full, keep, random);
  // cancellation
  step("a cancel");
  const double until = uniform(random, 0.05, 0.9);
  bool refused = false;
  double last = 0;
  cut.build(CGAL::parameters::keep_windows(keep).visitor([&](double f) {
    CHECK(f >= last && f <= 1 && !refused);
    last = f;
    refused = f >= until;
    return !refused;
  }));
  CHECK(cut.is_built());
  CHECK(refused || !cut.is_cancelled());
  if (refused && last < 1) CHECK(cut.is_cancelled());
  if (cut.is_cancelled()) CHECK(std::isfinite(cut.covered_distance()));
  totals.cancelled += cut.is_cancelled() ? 1 : 0;
  check_covered(c, cut, full, keep, random);
}

} // namespace test_stop_conditions

GEODESIC_OFFSET_TEST(test_stop_conditions)
{
  const unsigned times = argc > 1 ? unsigned(std::stoul(argv[1])) : 1;
  std::cout.precision(3);
  Totals totals;
  for_each_query_case(6 * times, [&](Query_case& c, unsigned seed, bool keep) { stops(c, seed, keep, totals); });
  if (totals.all_windows > 0) CHECK(totals.cancelled > 0);
  const auto percent = [&](std::size_t part) { return 100 * double(part) / double(totals.all_windows); };
  std::cout << "windows for the nearest of 50 vertices " << percent(totals.near_windows) << " %, for the farthest "
            << percent(totals.far_windows) << " % of all; " << totals.cancelled << " cancelled, " << totals.calls
            << " calls of visitors that did not" << std::endl;
  return Report::instance().finish("test_stop_conditions");
}
