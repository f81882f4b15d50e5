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
// Output: wrong distances, then a table by kind: meshes, queries, wrong ones, meshes with wrong ones, the largest error relative
// to the distance plus the longest edge, and to the distance plus the longest edge near by. The exit code is 1 if a distance is wrong, and 2 for wrong options.

#include "near_vertex_search.h"

#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

int run(int argc, char** argv)
{
  unsigned seed = 1;
  std::size_t meshes = 1000, queries = 200, printed = 50;
  const std::string kind = argc > 1 ? argv[1] : "";
  typedef test::Near_vertex_search Search;
  const Search::Sources sources = kind == "around"          ? Search::AROUND
                                  : kind == "needles"       ? Search::IN_NEEDLES
                                  : kind == "perpendicular" ? Search::PERPENDICULAR
                                                            : Search::BESIDE;
  for (int i = sources != Search::BESIDE || kind == "beside" ? 2 : 1; i < argc; i += 2)
  {
    const std::string name = argv[i];
    if (i + 1 == argc) throw std::invalid_argument(name + " needs a value, or is unknown");
    const unsigned long value = std::stoul(argv[i + 1]);
    if (name == "--seed") seed = static_cast<unsigned>(value);
    else if (name == "--meshes") meshes = value;
    else if (name == "--queries") queries = value;
    else if (name == "--printed") printed = value;
    else throw std::invalid_argument("unknown option " + name);
  }
  Search search(std::cout, printed, queries, sources);
  for (std::size_t i = 0; i < meshes; ++i) search.run(seed + static_cast<unsigned>(i));
  std::printf("| kind | meshes | queries | wrong | in meshes | worst | near |\n|---|---|---|---|---|---|---|\n");
  std::size_t wrong = 0;
  for (const auto& c : search.counts())
  {
    const test::Near_vertex_counts& n = c.second;
    std::printf("| %s | %zu | %zu | %zu | %zu | %.2g | %.2g |\n", c.first.c_str(), n.meshes, n.queries, n.wrong, n.wrong_meshes,
                n.worst, n.worst_near);
    wrong += n.wrong;
  }
  return wrong == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(argc, argv);
  }
  catch (const std::exception& e)
  {
    std::cerr << "near_vertex_search: " << e.what() << '\n';
    return 2;
  }
}
