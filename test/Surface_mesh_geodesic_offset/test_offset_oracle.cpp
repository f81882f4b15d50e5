// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The tracer against exact arrangements of the same windows, face by face: cases with former errors, and a bounded run of
// benchmark/Surface_mesh_geodesic_offset/Robustness/offset_oracle.cpp. First the oracle itself: it detects each kind of
// damage.

#include "oracle_run.h"
#include "test_check.h"

#include <functional>
#include <string>

namespace test_offset_oracle {

using namespace test;

typedef Offset_oracle::Chains Chains;

// Verdict of the oracle on the chains of a random face changed by the function; `none` if there are too few chains.
enum Verdict { none, right, topology, apart };

Verdict verdict(unsigned seed, const std::function<bool(Chains&)>& change)
{
  Random random(seed);
  Random_windows windows(random);
  Face_tracing tracing(windows.mesh(), windows.initial(), windows.field());
  const double level = windows.level();
  Chains chains = tracing(windows.face(), level);
  if (!change(chains)) return none;
  Offset_oracle oracle;
  const double unit = level + tracing.size_about(windows.face());
  oracle.compare(tracing.windows_of(windows.face()), cut_of(level), unit, chains, [](const std::string&) {});
  return oracle.counts.topology > 0 ? topology : oracle.counts.apart > 0 ? apart : right;
}

// A chain of a size far above rounding, less than a half turn from end to end.
bool is_large(const Level_chain& chain)
{
  return length(chain.arcs.back().end - chain.arcs[0].start) > 0.01;
}

void oracle_finds_damage()
{
  std::size_t found[4] = {0, 0, 0, 0};
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    Report::instance().set_context("seed " + std::to_string(seed));
    CHECK(verdict(seed, [](Chains&) { return true; }) == right);
    const auto expect = [&](std::size_t kind, Verdict expected, const std::function<bool(Chains&)>& change) {
      const Verdict v = verdict(seed, change);
      if (v == none) return;
      CHECK_DETAIL(v == expected, std::to_string(kind));
      ++found[kind];
    };
    expect(0, topology, [](Chains& c) { // a missing chain or loop
      if (c.size() != 1 || !(is_large(c[0]) || c[0].is_closed)) return false;
      c.clear();
      return true;
    });
    expect(1, topology, [](Chains& c) { // wrong connections of gates
      if (c.size() != 2 || c[0].is_closed || c[1].is_closed || !is_large(c[0]) || !is_large(c[1])) return false;
      std::swap(c[0].to, c[1].to);
      return true;
    });
    expect(2, topology, [](Chains& c) { // an additional loop
      if (c.empty() || c[0].is_closed || !is_large(c[0])) return false;
      c[0].is_closed = true;
      return true;
    });
    expect(3, apart, [](Chains& c) { // a displaced end
      if (c.empty() || c[0].is_closed || !is_large(c[0])) return false;
      Chain_arc& a = c[0].arcs.back();
      const Point_in_face v = a.end - a.start;
      a = Chain_arc(a.start, a.end + (1e-3 / length(v)) * v);
      return true;
    });
  }
  for (const std::size_t n : found) CHECK(n > 0);
}

void check(const Oracle_run& run)
{
  const Oracle_counts& c = run.counts();
  CHECK_DETAIL(c.topology == 0, std::to_string(c.topology) + " faces with other topology");
  CHECK_DETAIL(c.apart == 0, std::to_string(c.apart) + " faces whose chains are too far apart");
  CHECK_DETAIL(c.forced == 0, std::to_string(c.forced) + " faces with forced joints");
  CHECK_DETAIL(c.thrown == 0, std::to_string(c.thrown) + " exceptions");
}

// Seeds of random windows with former errors: gates of needles displaced by the rays allowed beside a cone; a loop that was
// closed at the transition of two arcs; loops along the sides of the face; gates displaced by straight paths beside a cone;
// gaps of the size of rounding of a large level; loops lost where three arcs meet, or beside a chain without extent. Also a
// level along an edge, which the oracle formerly judged by its shape.
//
// Seeds of real faces: a loop of two half turns around a source in a strip was lost; the oracle rounded the ends of chains to 1e-5
// of their terms; and the faces around a small one determine its rounding.
void earlier_faults()
{
  const auto check_seed = [](unsigned seed, std::size_t faces, void (Oracle_run::*run_faces)()) {
    Report::instance().set_context("seed " + std::to_string(seed));
    Oracle_options options;
    options.seed = seed;
    options.faces = faces;
    Oracle_run run(options);
    (run.*run_faces)();
    check(run);
  };
  for (const unsigned seed : {1137u, 5531u, 7436u, 119924u, 207048u, 207440u, 216710u, 225631u, 547908u, 580820u})
    check_seed(seed, 1, &Oracle_run::random_windows);
  for (const unsigned seed : {8000029u, 5000311u, 7002747u, 5000407u, 7000559u})
    check_seed(seed, 20, &Oracle_run::real_faces);
}

void search()
{
  Report::instance().set_context("");
  Oracle_options options;
  options.faces = 250;
  Oracle_run random(options), real(options);
  Oracle_run::print_head();
  random.random_windows();
  random.print("random windows");
  check(random);
  CHECK(random.counts().chains > 250 && random.counts().loops > 15 && random.counts().arcs > 1000);
  real.real_faces();
  real.print("real faces");
  check(real);
  CHECK(real.counts().chains > 100 && real.counts().faces == 250);
}

} // namespace test_offset_oracle

GEODESIC_OFFSET_TEST(test_offset_oracle)
{
  oracle_finds_damage();
  earlier_faults();
  search();
  return Report::instance().finish("test_offset_oracle");
}
