// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Mutated files of all formats, see mutation_run.h:
//
//   mutated_files COUNT [SEED [PROGRAM]]
//   mutated_files --samples FOLDER
//
// The exit code is 1 if a file caused a fault; the file is then in the current folder. PROGRAM is geodesic_offset
// or validate_geodesic_offsets. The second form writes the unchanged files as a corpus for fuzz_readers.

#include "mutation_run.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

// The first byte of a corpus file is the format, see fuzz_readers.cpp.
void write_samples(const std::filesystem::path& folder)
{
  const std::string extensions[] = {".off", ".obj", ".ply", ".stl", ".polylines.txt", ".txt", ".table.ply"};
  std::filesystem::create_directories(folder);
  std::vector<test::Sample_file> samples = test::sample_meshes();
  for (const test::Sample_file& sample : test::other_samples()) samples.push_back(sample);
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t format = 0; format < 7; ++format)
      if (samples[i].extension == extensions[format])
        test::write_file(folder / ("sample_" + std::to_string(i)), static_cast<char>(format) + samples[i].bytes);
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc == 3 && argv[1] == std::string("--samples"))
  {
    write_samples(argv[2]);
    return 0;
  }
  if (argc < 2 || argc > 4)
  {
    std::cerr << "usage: mutated_files COUNT [SEED [PROGRAM]]\n       mutated_files --samples FOLDER\n";
    return 2;
  }
  const std::uint64_t count = std::strtoull(argv[1], nullptr, 10), seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const auto result = test::run_mutations(count, seed, argc > 3 ? argv[3] : "");
  for (const auto& entry : result.first)
    std::cout << entry.first << ": " << entry.second.accepted << " accepted, " << entry.second.rejected << " rejected, slowest "
              << entry.second.slowest << " s (seed " << entry.second.slowest_seed << ")\n";
  return result.second == 0 ? 0 : 1;
}
