// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GEODESIC_OFFSET_TEST_SCRATCH_DIRECTORY_H
#define GEODESIC_OFFSET_TEST_SCRATCH_DIRECTORY_H

#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace test {

/// Temporary directory, removed with its contents at the end (POSIX).
class Scratch_directory
{
public:
  Scratch_directory()
  {
    std::string name = (std::filesystem::temp_directory_path() / "geodesic_offset_test.XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    path_ = name;
  }
  ~Scratch_directory()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Scratch_directory(const Scratch_directory&) = delete;
  Scratch_directory& operator=(const Scratch_directory&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
  std::filesystem::path path_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_SCRATCH_DIRECTORY_H
