// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Directory of CGAL's meshes.

#ifndef GEODESIC_OFFSET_TEST_DATA_DIRECTORY_H
#define GEODESIC_OFFSET_TEST_DATA_DIRECTORY_H

#include "test_registry.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace test {

/// The directory in the environment variable GEODESIC_OFFSET_DATA_DIR, otherwise the one given at compile time; may be
/// empty. Always empty for a test that runs with generated meshes only.
inline std::string data_directory()
{
  if (!mesh_kinds().data) return "";
  const char* directory = std::getenv("GEODESIC_OFFSET_DATA_DIR");
  if (directory != nullptr) return directory;
#ifdef GEODESIC_OFFSET_DATA_DIR
  return GEODESIC_OFFSET_DATA_DIR;
#else
  return "";
#endif
}

/// All mesh files of the data directory, in alphabetical order.
inline std::vector<std::filesystem::path> data_files()
{
  std::vector<std::filesystem::path> result;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(data_directory(), error))
  {
    const std::string extension = entry.path().extension().string();
    if (extension == ".off" || extension == ".ply" || extension == ".stl" || extension == ".obj")
      result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_DATA_DIRECTORY_H
