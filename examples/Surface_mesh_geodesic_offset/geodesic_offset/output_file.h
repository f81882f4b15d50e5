// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// All outputs or none. Every output is first written to a new file next to its target; when all of them are complete
// they are renamed. A program that fails on the way leaves neither parts of files nor a mix of old and new ones.

#ifndef GEODESIC_OFFSET_OUTPUT_FILE_H
#define GEODESIC_OFFSET_OUTPUT_FILE_H

#include "common.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace geodesic_offset {

class Output_files
{
  struct Entry
  {
    std::string target;
    std::string temporary;
  };

  std::vector<Entry> m_entries;
  bool               m_committed = false;

  static std::string reason()
  {
    return errno == 0 ? std::string("unknown error") : std::string(std::strerror(errno));
  }

  [[noreturn]] static void fail(const std::string& target, const std::string& why)
  {
    throw Input_error("cannot write " + quoted(target) + ": " + why);
  }

public:
  Output_files() = default;
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;

  ~Output_files()
  {
    if(!m_committed)
      for(const Entry& entry : m_entries)
        ::unlink(entry.temporary.c_str());
  }

  // To be called before the long work: nobody wants to wait for it and then hear that the folder does not exist.
  static void check(const std::string& target)
  {
    std::error_code error;
    const std::filesystem::path path(target);
    if(std::filesystem::is_directory(path, error))
      fail(target, "it is a directory");
    if(std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
      fail(target, "it exists and is not a regular file");
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    if(!std::filesystem::is_directory(folder, error))
      fail(target, "there is no directory " + quoted(folder.string()));
    errno = 0;
    if(::access(folder.c_str(), W_OK) != 0)
      fail(target, reason());
  }

  // write is called with a stream
  template <class Write>
  void add(const std::string& target, const Write& write)
  {
    m_entries.push_back({target, target + ".part-" + std::to_string(::getpid())});
    errno = 0;
    std::ofstream stream(m_entries.back().temporary, std::ios::binary | std::ios::trunc);
    if(!stream)
      fail(target, reason());
    errno = 0;
    write(static_cast<std::ostream&>(stream));
    stream.flush();
    if(!stream)
      fail(target, reason());
    stream.close();
    if(!stream)
      fail(target, reason());
  }

  void commit()
  {
    for(std::size_t i = 0; i < m_entries.size(); ++i)
    {
      errno = 0;
      if(std::rename(m_entries[i].temporary.c_str(), m_entries[i].target.c_str()) != 0)
      {
        const std::string why = reason();
        for(std::size_t j = 0; j < i; ++j)
          ::unlink(m_entries[j].target.c_str());
        fail(m_entries[i].target, why);
      }
    }
    m_committed = true;
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_OUTPUT_FILE_H
