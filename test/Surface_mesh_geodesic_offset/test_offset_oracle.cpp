// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The tracer against exact arrangements of the same windows, face by face: cases with former errors, and a bounded run of
// benchmark/Surface_mesh_geodesic_offset/Robustness/offset_oracle.cpp. First the oracle itself: it detects each kind of
// damage.

#include "locations.h"
#include "oracle_run.h"
#include "test_check.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

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
bool is_large(const Level_chain& chain) { return length(chain.arcs.back().end - chain.arcs[0].start) > 0.01; }

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
// of their terms; the faces around a small one determine its rounding; and points were counted beside the chord of
// an arc of the size of rounding, whose direction is rounding.
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
  for (const unsigned seed : {1137u, 5531u, 7436u, 119924u, 207048u, 207440u, 216710u, 225631u, 547908u, 580820u, 6200885u})
    check_seed(seed, 1, &Oracle_run::random_windows);
  for (const unsigned seed : {8000029u, 5000311u, 7002747u, 5000407u, 7000559u, 80000419u})
    check_seed(seed, 20, &Oracle_run::real_faces);
}

// Of fuzz_offsets: in some orders of addresses, CGAL's union of a range of regions started the common part of three boundaries
// at a wrong event, which an assertion of CGAL detects in the presets with assertions.
void overlapping_boundaries()
{
  Soup soup;
  soup.points = {{0.125, -0.53125009999999995, 0.65625},
                 {0.03125, -0.1875, -0.96875},
                 {-0.718749999999999, 0.59375, 0.46875},
                 {-0.8125, -0.3125, 0},
                 {0.156250000000001, 0.21875, 0.03125}};
  for (const auto& t : {std::array<std::size_t, 3>{0, 1, 2}, {1, 0, 3}, {0, 2, 4}}) soup.add_triangle(t);
  const Generated_mesh<Surface_mesh> data(soup);
  Cut_geodesic geodesic(data.mesh);
  geodesic.add_source_point(data.vertices[0]);
  geodesic.add_source_polyline(std::vector<Geodesic::Face_location>{
    {data.faces[0], {0.375, 0.625, 0}},
    {data.faces[0], {0, 1.0000000050247593e-08, 0.99999998999999995}},
    {data.faces[1], {0.125, 0.875, 0}}});
  geodesic.build(CGAL::parameters::keep_windows(true));
  Face_tracing tracing(geodesic.mesh(), geodesic.initial(), geodesic.field());
  Offset_oracle oracle;
  Random random(1);
  std::vector<std::unique_ptr<char[]>> blocks;
  for (int i = 0; i < 40; ++i)
  {
    // blocks of all small sizes, freed in random order: the next ones have addresses in this order
    for (std::size_t size = 16; size <= 400; size += 16)
      for (int k = 0; k < 100; ++k) blocks.push_back(std::make_unique<char[]>(size));
    std::shuffle(blocks.begin(), blocks.end(), random);
    blocks.resize(blocks.size() / 8); // the others stay, so that the free ones are apart
    oracle.compare(tracing, geodesic.field_index(data.faces[0]), 0.88666230165914273,
                   [](const std::string& text) { std::printf("%s\n", text.c_str()); });
  }
  CHECK(oracle.counts.faces == 40 && oracle.counts.differences() == 0);
}

// Of fuzz_offsets: a source in a flat face is nearer to an edge than the rounding of its image in the next face, and small circles
// around it cross the edge.
void sources_beside_edges()
{
  Random random(1);
  Offset_oracle oracle;
  const auto number = [&] { return uniform(random, -1, 1); };
  for (int i = 0; i < 100; ++i)
  {
    Soup soup;
    for (int k = 0; k < 4; ++k) soup.points.push_back({number(), number(), number()});
    const CGAL::Vector_3<Kernel> up(number(), number(), number());
    soup.points[2] = CGAL::midpoint(soup.points[0], soup.points[1]) + 1e-4 * up;
    soup.add_triangle(std::array<std::size_t, 3>{0, 1, 2});
    soup.add_triangle(std::array<std::size_t, 3>{1, 0, 3});
    const Generated_mesh<Surface_mesh> data(soup);
    Cut_geodesic geodesic(data.mesh);
    const double t = uniform(random, 0.1, 0.9);
    geodesic.add_source_point(Locations<Surface_mesh>(data.mesh).in_triangle(data, soup, 0, {1 - t, t, 1e-12}));
    geodesic.build(CGAL::parameters::keep_windows(true));
    Face_tracing tracing(geodesic.mesh(), geodesic.initial(), geodesic.field());
    for (const auto f : data.faces)
      oracle.compare(tracing, geodesic.field_index(f), 1e-8 + uniform(random, 0, 1e-6),
                     [](const std::string& text) { std::printf("%s\n", text.c_str()); });
  }
  CHECK_DETAIL(oracle.counts.chains == 200 && oracle.counts.differences() == 0, std::to_string(oracle.counts.differences()));
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
  overlapping_boundaries();
  sources_beside_edges();
  search();
  return Report::instance().finish("test_offset_oracle");
}
