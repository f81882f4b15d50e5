// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// All outputs or none. Every output is first written to a new file next to its target; when all of them are complete
// they are renamed. A program that fails on the way leaves neither parts of files nor a mix of old and new ones. An output
// that fails can be left out.

#ifndef GEODESIC_OFFSET_OUTPUT_FILE_H
#define GEODESIC_OFFSET_OUTPUT_FILE_H

#include "common.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ios>
#include <ostream>
#include <streambuf>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace geodesic_offset {
namespace internal {

// Passes bytes on in blocks, and reports their number after each block.
class Reporting_buffer : public std::streambuf
{
  std::streambuf&                            m_target;
  const std::function<void(std::uintmax_t)>& m_report;
  std::uintmax_t                             m_bytes = 0;
  std::array<char, 1 << 16>                  m_block;

public:
  Reporting_buffer(std::streambuf& target, const std::function<void(std::uintmax_t)>& report)
    : m_target(target), m_report(report)
  {
    setp(m_block.data(), m_block.data() + m_block.size());
  }

protected:
  int_type overflow(int_type c) override
  {
    if(!hand_on())
      return traits_type::eof();
    return traits_type::eq_int_type(c, traits_type::eof()) ? traits_type::not_eof(c) : sputc(traits_type::to_char_type(c));
  }

  int sync() override { return hand_on() && m_target.pubsync() == 0 ? 0 : -1; }

private:
  bool hand_on()
  {
    const std::streamsize size = pptr() - pbase();
    if(m_target.sputn(pbase(), size) != size)
      return false;
    setp(m_block.data(), m_block.data() + m_block.size());
    m_bytes += static_cast<std::uintmax_t>(size);
    m_report(m_bytes);
    return true;
  }
};

} // namespace internal

class Output_files
{
public:
  // Called periodically with the number of bytes of a file that have been written, and with the expected number of all, or 0.
  using Report = std::function<void(const std::string& target, std::uintmax_t bytes, std::uintmax_t expected)>;

private:
  struct Entry
  {
    std::string target;
    std::string temporary;
  };

  Report             m_report;
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
  explicit Output_files(Report report = [](const std::string&, std::uintmax_t, std::uintmax_t) {}) : m_report(std::move(report)) {}
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

  // Calls write(stream). After an exception the file is left out. `expected`: number of bytes, for the report
  template <class Write>
  void add(const std::string& target, const Write& write, std::uintmax_t expected = 0)
  {
    m_entries.push_back({target, target + ".part-" + std::to_string(::getpid())});
    try
    {
      write_to(m_entries.back(), write, expected);
    }
    catch(...)
    {
      ::unlink(m_entries.back().temporary.c_str());
      m_entries.pop_back();
      throw;
    }
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

  // The files that have been added
  std::vector<std::string> targets() const
  {
    std::vector<std::string> targets;
    for(const Entry& entry : m_entries)
      targets.push_back(entry.target);
    return targets;
  }

private:
  template <class Write>
  void write_to(const Entry& entry, const Write& write, std::uintmax_t expected) const
  {
    errno = 0;
    std::filebuf file;
    if(file.open(entry.temporary, std::ios::out | std::ios::binary | std::ios::trunc) == nullptr)
      fail(entry.target, reason());
    const std::function<void(std::uintmax_t)> report = [&](std::uintmax_t bytes) {
      m_report(entry.target, bytes, expected);
    };
    internal::Reporting_buffer buffer(file, report);
    std::ostream stream(&buffer);
    errno = 0;
    write(stream);
    stream.flush();
    if(!stream || file.close() == nullptr)
      fail(entry.target, reason());
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_OUTPUT_FILE_H
