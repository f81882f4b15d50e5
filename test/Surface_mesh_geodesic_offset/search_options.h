// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command line of search programs whose cases are numbered by seeds.

#ifndef GEODESIC_OFFSET_TEST_SEARCH_OPTIONS_H
#define GEODESIC_OFFSET_TEST_SEARCH_OPTIONS_H

#include <cstddef>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace test {

struct Seed_range_options
{
  unsigned seed = 1;         // of the first case; the next ones follow
  std::size_t meshes = 1000; // cases
  std::size_t per_mesh = 0;  // planes, queries or paths of each case
  std::size_t printed = 50;  // faults that are printed, at most
  bool describes = false;    // whether they are printed with all that led to them
};

/// The exit code of a search program: that of run(options), or 2 for options that are wrong and for other exceptions. `per_mesh`
/// is the name of the option for the number of checks per mesh, with its default value.
template <class Run>
int run_search(const char* program, const std::string& per_mesh, std::size_t default_per_mesh, int argc, char** argv,
               const Run& run)
{
  try
  {
    Seed_range_options options;
    options.per_mesh = default_per_mesh;
    for (int i = 1; i < argc; i += 2)
    {
      const std::string name = argv[i];
      if (i + 1 == argc) throw std::invalid_argument(name + " needs a value, or is unknown");
      const unsigned long value = std::stoul(argv[i + 1]);
      if (name == "--seed") options.seed = static_cast<unsigned>(value);
      else if (name == "--meshes") options.meshes = value;
      else if (name == per_mesh) options.per_mesh = value;
      else if (name == "--printed") options.printed = value;
      else if (name == "--describe") options.describes = value != 0;
      else throw std::invalid_argument("unknown option " + name);
    }
    return run(options);
  }
  catch (const std::exception& e)
  {
    std::cerr << program << ": " << e.what() << '\n';
    return 2;
  }
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_SEARCH_OPTIONS_H
