// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether two names denote one file: names may be absolute, or contain links and dots.

#ifndef GEODESIC_OFFSET_FILE_IDENTITY_H
#define GEODESIC_OFFSET_FILE_IDENTITY_H

#include "messages.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace geodesic_offset {

// The name without links and dots, also of a new file in an existing folder. Symbolic links are followed, also those to a file
// that does not exist.
inline std::filesystem::path canonical_path(const std::string& name)
{
  constexpr int most_links = 40; // as Linux allows
  std::error_code error;
  std::filesystem::path path = std::filesystem::absolute(name, error);
  for(int i = 0; i < most_links && std::filesystem::is_symlink(path, error); ++i)
    path = path.parent_path() / std::filesystem::read_symlink(path, error);
  path = std::filesystem::weakly_canonical(path, error);
  return error ? std::filesystem::path(name) : path;
}

// Compares device and inode if both files exist, otherwise canonical names.
inline bool is_same_file(const std::string& a, const std::string& b)
{
  std::error_code error;
  if(std::filesystem::equivalent(a, b, error) && !error) return true;
  return canonical_path(a) == canonical_path(b);
}

// Throws Usage_error if an output is an input, or is written twice. Inputs are read before any output is written, but their
// contents would be lost.
inline void check_different_files(const std::vector<std::string>& read, const std::vector<std::string>& written)
{
  for(std::size_t i = 0; i < written.size(); ++i)
    for(std::size_t k = 0; k < read.size() + i; ++k)
    {
      const std::string& other = k < read.size() ? read[k] : written[k - read.size()];
      if(written[i] == other) throw Usage_error("the file " + quoted(other) + " is named twice");
      if(is_same_file(written[i], other))
        throw Usage_error("the file " + quoted(other) + " is named twice, also as " + quoted(written[i]));
    }
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_FILE_IDENTITY_H
