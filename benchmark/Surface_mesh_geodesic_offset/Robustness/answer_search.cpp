// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Do distance, nearest source, signed distance, gradient and path of a point agree? On meshes of 17 kinds, with points, joined
// polylines, runs of collinear segments and edges as sources; or with sources that overlap and coincide,
// or with polylines in faces, beside their edges.
//
//   answer_search spread|coinciding|beside|in_faces [--seed N] [--meshes N] [--queries N] [--printed N] [--describe 1]
//
// Case i has the seed N + i, which determines its mesh, its sources and its queries (--queries per mesh); so `--seed N --meshes 1`
// repeats a case.
//
// Faults, then a table by kind on stdout: queries, points of paths, queries with a fault, by kind of fault, exceptions, joined
// polylines with a fault, and the largest errors: of path lengths relative to the distance; of those of near points, in
// roundings of the largest coordinate; of distances in the plane, relative to the distance plus the longest edge. The exit code
// is 1 if there is a fault, and 2 for options that are wrong.

#include "answer_search.h"
#include "search_options.h"

#include <cstdio>
#include <iostream>
#include <map>
#include <string>

namespace {

int run(const test::Seed_range_options& options, test::Answer_search::Sources sources)
{
  test::Answer_search search(std::cout, options.printed, options.per_mesh, sources, options.describes);
  for (std::size_t i = 0; i < options.meshes; ++i) search.run(options.seed + static_cast<unsigned>(i));
  std::printf("| kind | meshes | queries | points | wrong |");
  for (int k = 0; k < test::NUMBER_OF_ANSWER_FAULTS; ++k) std::printf(" %s |", test::name_of(test::Answer_fault(k)));
  std::printf(" exceptions | polylines | length | near | plane |\n|");
  for (int k = 0; k < test::NUMBER_OF_ANSWER_FAULTS + 10; ++k) std::printf("---|");
  std::printf("\n");
  std::size_t wrong = 0;
  for (const auto& c : search.counts())
  {
    const test::Answer_counts& n = c.second;
    std::printf("| %s | %zu | %zu | %zu | %zu |", c.first.c_str(), n.meshes, n.queries, n.points, n.wrong);
    for (std::size_t faults : n.faults) std::printf(" %zu |", faults);
    std::printf(" %zu | %zu | %.2g | %.2g | %.2g |\n", n.exceptions, n.wrong_polylines, n.worst_length, n.worst_near_length,
                n.worst_distance);
    wrong += n.total_wrong();
  }
  return wrong == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  static const std::map<std::string, test::Answer_search::Sources> kinds = {
    {"spread", test::Answer_search::SPREAD},
    {"coinciding", test::Answer_search::COINCIDING},
    {"beside", test::Answer_search::BESIDE},
    {"in_faces", test::Answer_search::IN_FACES}};
  const auto kind = kinds.find(argc > 1 ? argv[1] : "");
  if (kind == kinds.end())
  {
    std::cerr << "answer_search: the first argument is spread, coinciding, beside or in_faces\n";
    return 2;
  }
  return test::run_search("answer_search", "--queries", 33, argc - 1, argv + 1, [&](const test::Seed_range_options& options) {
    return run(options, kind->second);
  });
}
