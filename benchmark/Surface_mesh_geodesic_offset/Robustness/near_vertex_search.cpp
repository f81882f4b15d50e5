// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Search for wrong distances from sources within 1e-16 to 1e-6 edge lengths of vertices and edges (beside), also in needles
// (needles), from polylines around vertices of graded meshes (around), or from segments beside vertices, perpendicular to an edge
// (perpendicular), that is, wrong by more than 1e-11 of the distance plus the longest edge.
//
//   near_vertex_search [beside|needles|around|perpendicular] [--seed N] [--meshes N] [--queries N] [--printed N]
//
// Case i has seed N + i, which determines its mesh, sources and queries; so `--seed N --meshes 1` repeats a case.
//
// Output: wrong distances, then a table by kind: meshes, queries, wrong ones, meshes with wrong ones, the largest error
// relative to the distance plus the longest edge, and to the distance plus the longest edge near by, and the widest gap between
// windows, relative to the distance plus the longest edge. The exit code is 1 if a distance is wrong, and 2 for wrong options.

#include "near_vertex_search.h"
#include "search_options.h"

#include <cstdio>
#include <iostream>
#include <map>
#include <string>

namespace {

int run(const test::Seed_range_options& options, test::Near_vertex_search::Sources sources)
{
  test::Near_vertex_search search(std::cout, options.printed, options.per_mesh, sources);
  for (std::size_t i = 0; i < options.meshes; ++i) search.run(options.seed + static_cast<unsigned>(i));
  std::printf("| kind | meshes | queries | wrong | in meshes | worst | near | gap |\n|---|---|---|---|---|---|---|---|\n");
  std::size_t wrong = 0;
  for (const auto& c : search.counts())
  {
    const test::Near_vertex_counts& n = c.second;
    std::printf("| %s | %zu | %zu | %zu | %zu | %.2g | %.2g | %.2g |\n", c.first.c_str(), n.meshes, n.queries, n.wrong,
                n.wrong_meshes, n.worst, n.worst_near, n.widest_gap);
    wrong += n.wrong;
  }
  return wrong == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  typedef test::Near_vertex_search Search;
  static const std::map<std::string, Search::Sources> kinds = {
    {"beside", Search::BESIDE},
    {"needles", Search::IN_NEEDLES},
    {"around", Search::AROUND},
    {"perpendicular", Search::PERPENDICULAR}};
  const auto kind = kinds.find(argc > 1 ? argv[1] : "");
  const int named = kind != kinds.end() ? 1 : 0; // without a kind: beside
  return test::run_search("near_vertex_search", "--queries", 200, argc - named, argv + named,
                          [&](const test::Seed_range_options& options) {
                            return run(options, named ? kind->second : Search::BESIDE);
                          });
}
