// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The bytes of an input file. Readers get the whole file: they compare its size with the numbers in it before they use
// these, and are several times as fast as with a stream. The file is copied, not mapped: if another program shortened a
// mapped file, a signal would end this program.

#ifndef GEODESIC_OFFSET_FILE_BYTES_H
#define GEODESIC_OFFSET_FILE_BYTES_H

#include "memory_budget.h"
#include "messages.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

namespace geodesic_offset {

class File_bytes
{
  std::unique_ptr<char[]> m_bytes;
  std::size_t m_size = 0;

  [[noreturn]] static void fail(const std::string& path, const std::string& why)
  {
    throw Input_error("cannot read " + quoted(path) + ": " + why);
  }

  static std::string reason() { return errno == 0 ? std::string("unknown error") : std::string(std::strerror(errno)); }

public:
  // Throws Input_error, also for an empty file, unless it may be empty. Pipes and devices are read to their end.
  explicit File_bytes(const std::string& path, bool may_be_empty = false)
  {
    std::error_code error;
    if(std::filesystem::is_directory(path, error)) fail(path, "it is a directory");
    errno = 0;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if(!file) fail(path, reason());
    const std::uintmax_t expected = std::filesystem::file_size(path, error);
    if(!error) require_memory(quoted(path), expected);
    try
    {
      // one byte more than expected, to detect the end of the file without another block
      constexpr std::size_t block = 1 << 16;
      read(*file, error || expected == 0 ? block : static_cast<std::size_t>(expected) + 1);
    }
    catch(const std::bad_alloc&)
    {
      fail(path, "it does not fit into memory");
    }
    if(std::ferror(file.get())) fail(path, reason());
    if(m_size == 0 && !may_be_empty) throw Input_error(quoted(path) + " is empty");
  }

  std::string_view view() const { return {m_bytes.get(), m_size}; }

private:
  void read(std::FILE& file, std::size_t capacity)
  {
    m_bytes.reset(new char[capacity]);
    for(;;)
    {
      errno = 0;
      m_size += std::fread(m_bytes.get() + m_size, 1, capacity - m_size, &file);
      if(m_size < capacity) return;
      capacity *= 2;
      std::unique_ptr<char[]> larger(new char[capacity]);
      std::memcpy(larger.get(), m_bytes.get(), m_size);
      m_bytes = std::move(larger);
    }
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_FILE_BYTES_H
