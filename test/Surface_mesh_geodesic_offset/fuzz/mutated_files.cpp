// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Mutated files of all formats, see mutation_run.h:
//
//   mutated_files COUNT [SEED [PROGRAM]]
//
// The exit code is 1 if a file did harm; it is then in the current folder. PROGRAM is geodesic_offset.

#include "mutation_run.h"

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

int main(int argc, char* argv[])
{
  if (argc < 2 || argc > 4)
  {
    std::cerr << "usage: mutated_files COUNT [SEED [PROGRAM]]\n";
    return 2;
  }
  const std::uint64_t count = std::strtoull(argv[1], nullptr, 10), seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const auto result = test::run_mutations(count, seed, argc > 3 ? argv[3] : "");
  for (const auto& entry : result.first)
    std::cout << entry.first << ": " << entry.second.accepted << " accepted, " << entry.second.rejected << " rejected, slowest "
              << entry.second.slowest << " s\n";
  return result.second == 0 ? 0 : 1;
}
