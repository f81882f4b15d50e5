// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Search for files with faces without area that the reader of the programs refuses, or with which distances differ from those
// of the mesh without these faces by more than 1e-12 of the diagonal of the bounding box.
//
//   degenerate_search [--seed N] [--meshes N] [--clusters N] [--printed N] [--describe 1]
//
// Case i has seed N + i, which determines its mesh, the degenerate faces that are added, the format and the sources; so
// `--seed N --meshes 1` repeats a case, and `--describe 1` prints its file.
//
// Output: faults, then a table by kind of file: files, faces without area, files that are refused, with wrong distances, and
// without a vertex that should be there, and the largest error; and the numbers of clusters by kind. The exit code is 1 if there
// is a fault, and 2 for wrong options.

#include "degenerate_search.h"
#include "search_options.h"

#include <cstdio>
#include <iostream>

namespace {

int run(const test::Seed_range_options& options)
{
  test::Degenerate_search search(std::cout, options.printed, options.per_mesh, options.describes);
  for (std::size_t i = 0; i < options.meshes; ++i) search.run(options.seed + static_cast<unsigned>(i));
  std::printf("| kind | files | faces without area | refused | wrong | missing | worst |\n|---|---|---|---|---|---|---|\n");
  std::size_t faults = 0;
  for (const auto& c : search.counts())
  {
    const test::Degenerate_counts& n = c.second;
    std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %.2g |\n", c.first.c_str(), n.files, n.flat_faces, n.refused, n.wrong,
                n.missing, n.worst);
    faults += n.refused + n.wrong + n.missing;
  }
  for (const auto& entry : search.added()) std::printf("%s: %zu\n", entry.first.c_str(), entry.second);
  return faults == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) { return test::run_search("degenerate_search", "--clusters", 0, argc, argv, run); }
