// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Short run of benchmark/Surface_mesh_geodesic_offset/Robustness/corpus.cpp on generated meshes: each kind with each
// perturbation once. First the classification of outcomes: crash, endless loop and damaged result.

#include "corpus_run.h"
#include "test_check.h"

#include <csignal>
#include <cstdlib>
#include <string>

namespace test_corpus {

using namespace test;

void outcomes()
{
  Report::instance().set_context("outcomes");
  CHECK(run_isolated(5, [] { return std::string(100000, 'x'); }).text.size() == 100000);
  const Isolated_result crash = run_isolated(5, []() -> std::string {
    std::raise(SIGKILL);
    return "not reached";
  });
  CHECK(crash.signal == SIGKILL && crash.text.empty());
  const Isolated_result endless = run_isolated(1, []() -> std::string {
    for (volatile bool goes_on = true; goes_on;) {};
    return {};
  });
  CHECK(endless.signal == SIGALRM && endless.seconds > 0.5);
}

void search()
{
  Report::instance().set_context("");
  Corpus_options options;
  options.runs = Search_meshes::kinds().size() * Perturbations::all().size();
  Corpus_run corpus(options);
  corpus.run();
  corpus.print_tables();
  CHECK_DETAIL(corpus.failures() == 0, std::to_string(corpus.failures()) + " failures");
  CHECK(corpus.total()[RIGHT] > options.runs * 9 / 10);
  CHECK(corpus.worst_excess() < 1e-12);
}

} // namespace test_corpus

GEODESIC_OFFSET_TEST(test_corpus)
{
  test_corpus::outcomes();
  test_corpus::search();
  return Report::instance().finish("test_corpus");
}
