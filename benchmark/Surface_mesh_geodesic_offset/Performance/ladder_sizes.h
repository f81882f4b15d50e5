// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Sizes of a ladder of meshes on the command line: [--limit N] [--first N]

#ifndef GEODESIC_OFFSET_BENCHMARK_LADDER_SIZES_H
#define GEODESIC_OFFSET_BENCHMARK_LADDER_SIZES_H

#include <cstddef>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace benchmark {

/// Numbers of vertices.
struct Ladder_sizes
{
  std::size_t first = 1024, limit = 262144;

  /// Returns false after printing the usage on `std::cerr` if the arguments are invalid.
  bool read(int argc, char* argv[], const char* program)
  {
    try
    {
      for (int i = 1; i < argc; ++i)
      {
        const std::string word = argv[i];
        if ((word != "--limit" && word != "--first") || i + 1 == argc) throw std::invalid_argument(word);
        (word == "--limit" ? limit : first) = std::stoul(argv[++i]);
      }
      if (first < 100 || first > limit) throw std::invalid_argument("sizes");
      return true;
    }
    catch (const std::exception&)
    {
      std::cerr << "usage: " << program << " [--limit N] [--first N]        100 vertices at least\n";
      return false;
    }
  }
};

} // namespace benchmark

#endif // GEODESIC_OFFSET_BENCHMARK_LADDER_SIZES_H
