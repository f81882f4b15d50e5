// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Plane sections through vertices, edges and faces, and in general position: are all segments there, with the positive side of the
// plane on their left?
//
//   section_search [--seed N] [--meshes N] [--planes N] [--printed N]
//
// Case i has the seed N + i, which determines its mesh and its planes (--planes per mesh); so `--seed N --meshes 1` repeats a case.
//
// Wrong planes, then a table by kind on stdout. The exit code is 1 if a plane is wrong, and 2 for options that are wrong.

#include "search_options.h"
#include "section_search.h"

#include <cstdio>
#include <iostream>

namespace {

int run(const test::Seed_range_options& options)
{
  test::Section_search search(std::cout, options.printed, options.per_mesh);
  for (std::size_t i = 0; i < options.meshes; ++i) search.run(options.seed + static_cast<unsigned>(i));
  std::printf("| kind | meshes | planes | segments | touched edges | faces in planes | signs | wrong planes |\n"
              "|---|---|---|---|---|---|---|---|\n");
  std::size_t wrong = 0;
  for (const auto& c : search.counts())
  {
    const test::Section_counts& n = c.second;
    std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %zu | %zu |\n", c.first.c_str(), n.meshes, n.planes, n.segments,
                n.touched_edges, n.faces_in_plane, n.signs, n.wrong);
    wrong += n.wrong;
  }
  return wrong == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) { return test::run_search("section_search", "--planes", 10, argc, argv, run); }
