// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// All outputs or none: every output is first written to a new file in the folder of its target; when all are complete they
// are renamed. A failure or a signal leaves neither partial files nor a mix of old and new files: old files keep another
// name until all new ones are in place. An output that fails can be left out.

#ifndef GEODESIC_OFFSET_OUTPUT_FILE_H
#define GEODESIC_OFFSET_OUTPUT_FILE_H

#include "file_identity.h"
#include "messages.h"
#include "stop_signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ios>
#include <memory>
#include <mutex>
#include <ostream>
#include <random>
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
  std::streambuf& m_target;
  const std::function<void(std::uintmax_t)>& m_report;
  std::uintmax_t m_bytes = 0;
  int m_error = 0;
  std::array<char, 1 << 16> m_block;

public:
  Reporting_buffer(std::streambuf& target, const std::function<void(std::uintmax_t)>& report)
    : m_target(target), m_report(report)
  {
    setp(m_block.data(), m_block.data() + m_block.size());
  }

  // Error number of the first failure, 0 if there was none.
  int error() const { return m_error; }

protected:
  int_type overflow(int_type c) override
  {
    if(!hand_on()) return traits_type::eof();
    return traits_type::eq_int_type(c, traits_type::eof()) ? traits_type::not_eof(c) : sputc(traits_type::to_char_type(c));
  }

  int sync() override
  {
    if(!hand_on()) return -1;
    errno = 0;
    if(m_target.pubsync() == 0) return 0;
    m_error = errno != 0 ? errno : EIO;
    return -1;
  }

private:
  bool hand_on()
  {
    const std::streamsize size = pptr() - pbase();
    errno = 0;
    if(m_error != 0 || m_target.sputn(pbase(), size) != size)
    {
      m_error = m_error != 0 ? m_error : errno != 0 ? errno : EIO;
      return false;
    }
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
  // Called periodically with the number of bytes written to a file, and the expected total, or 0.
  using Report = std::function<void(const std::string& target, std::uintmax_t bytes, std::uintmax_t expected)>;

private:
  // A file that is open
  struct Open_file
  {
    std::filebuf file;
    std::function<void(std::uintmax_t)> report;
    internal::Reporting_buffer buffer;
    std::ostream stream;

    explicit Open_file(std::function<void(std::uintmax_t)> r) : report(std::move(r)), buffer(file, report), stream(&buffer) {}
  };

  struct Entry
  {
    std::string target; // as given
    std::string file; // the target with symbolic links resolved, so that the links remain
    std::string temporary;
    std::string old; // temporary name of the previous file at the target; empty: none
    std::unique_ptr<Open_file> open; // null: complete
  };

  Report m_report;
  std::vector<Entry> m_entries;

  static std::string reason() { return errno == 0 ? std::string("unknown error") : std::string(std::strerror(errno)); }

  [[noreturn]] static void fail(const std::string& target, const std::string& why)
  {
    throw Input_error("cannot write " + quoted(target) + ": " + why);
  }

public:
  explicit Output_files(Report report = [](const std::string&, std::uintmax_t, std::uintmax_t) {}) : m_report(std::move(report))
  {
  }
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;

  ~Output_files()
  {
    for(const Entry& entry : m_entries) remove(entry.temporary);
  }

  // Checks a target before the long computation.
  static void check(const std::string& target)
  {
    std::error_code error;
    const std::filesystem::path path(target);
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if(status.type() == std::filesystem::file_type::none) // for example links in a circle
      fail(target, error.message());
    if(std::filesystem::is_directory(status)) fail(target, "it is a directory");
    if(std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
      fail(target, "it exists and is not a regular file");
    const std::filesystem::path folder = canonical_path(target).parent_path();
    if(!std::filesystem::is_directory(folder, error))
      fail(target, "there is no directory " + quoted(path.has_parent_path() ? path.parent_path().string() : folder.string()));
    errno = 0;
    if(::access(folder.c_str(), W_OK) != 0) fail(target, reason());
  }

  // Opens a file that is written in parts, and returns its stream, which is valid until close() of the same target. Progress is
  // not reported.
  std::ostream& open(const std::string& target)
  {
    return open(target, [](std::uintmax_t) {});
  }

  // Throws Input_error if a part could not be written.
  void check_stream(const std::string& target)
  {
    const Open_file& open = *entry_of(target).open;
    errno = open.buffer.error();
    if(!open.stream) fail(target, reason());
  }

  void close(const std::string& target)
  {
    Entry& entry = entry_of(target);
    entry.open->stream.flush();
    check_stream(target);
    if(entry.open->file.close() == nullptr) fail(target, reason());
    entry.open.reset();
  }

  // Calls write(stream). If it throws, the file is left out. `expected`: number of bytes, for the report.
  template <class Write>
  void add(const std::string& target, const Write& write, std::uintmax_t expected = 0)
  {
    std::ostream& stream = open(target, [&](std::uintmax_t bytes) { m_report(target, bytes, expected); });
    try
    {
      write(stream);
      close(target);
    }
    catch(...)
    {
      leave_out(target);
      throw;
    }
  }

  // Renames the files, all of which are closed, to their targets. If it throws, all targets are unchanged.
  void commit()
  {
    Temporary_files& temporaries = Temporary_files::instance();
    const std::unique_lock<std::mutex> lock = temporaries.lock(); // signals wait
    for(std::size_t i = 0; i < m_entries.size(); ++i)
    {
      Entry& entry = m_entries[i];
      errno = 0;
      if(keep_old(entry) && std::rename(entry.temporary.c_str(), entry.file.c_str()) == 0) continue;
      const std::string why = reason();
      for(std::size_t k = i + 1; k-- > 0;) bring_back(m_entries[k], k < i);
      fail(entry.target, why);
    }
    for(Entry& entry : m_entries)
    {
      temporaries.forget(entry.temporary);
      entry.temporary.clear();
      if(!entry.old.empty()) ::unlink(entry.old.c_str());
    }
  }

  // Targets of the added files.
  std::vector<std::string> targets() const
  {
    std::vector<std::string> targets;
    for(const Entry& entry : m_entries) targets.push_back(entry.target);
    return targets;
  }

private:
  // Short, since a target may have the longest name that its folder allows; random, since other runs of the program may use
  // the folder.
  static std::string unused_name_beside(const std::string& file)
  {
    static std::random_device random;
    static const char digits[] = "0123456789abcdefghijklmnopqrstuvwxyz";
    std::string name = ".part-";
    for(int i = 0; i < 10; ++i) name += digits[random() % 36];
    return (std::filesystem::path(file).parent_path() / name).string();
  }

  // Creates an empty file with the permissions for new files under the user's mask. Precondition: the caller has the lock of
  // the temporary files.
  static std::string new_file_beside(const Entry& entry)
  {
    for(;;)
    {
      std::string name = unused_name_beside(entry.file);
      errno = 0;
      const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if(descriptor >= 0)
      {
        ::close(descriptor);
        Temporary_files::instance().add(name);
        return name;
      }
      if(errno != EEXIST) fail(entry.target, reason());
    }
  }

  static void remove(const std::string& temporary)
  {
    if(temporary.empty()) return;
    Temporary_files& temporaries = Temporary_files::instance();
    const std::unique_lock<std::mutex> lock = temporaries.lock();
    ::unlink(temporary.c_str());
    temporaries.forget(temporary);
  }

  // Gives the target's file a second name. File systems without links rename it.
  static bool keep_old(Entry& entry)
  {
    std::error_code error;
    if(std::filesystem::is_directory(entry.file, error)) // created since the check
    {
      errno = EISDIR;
      return false;
    }
    for(;;)
    {
      const std::string name = unused_name_beside(entry.file);
      errno = 0;
      const bool is_linked = ::link(entry.file.c_str(), name.c_str()) == 0;
      if(!is_linked && errno == ENOENT) // a new file
        return true;
      if(!is_linked && errno == EEXIST) continue;
      errno = 0;
      if(!is_linked && std::rename(entry.file.c_str(), name.c_str()) != 0) return false;
      entry.old = name;
      return true;
    }
  }

  static void bring_back(Entry& entry, bool is_renamed)
  {
    if(!entry.old.empty())
    {
      std::rename(entry.old.c_str(), entry.file.c_str());
      ::unlink(entry.old.c_str()); // if both names denote one file, rename does nothing
      entry.old.clear();
    }
    else if(is_renamed)
      ::unlink(entry.file.c_str());
  }

  std::ostream& open(const std::string& target, std::function<void(std::uintmax_t)> report)
  {
    m_entries.push_back({target, canonical_path(target).string(), "", "", nullptr});
    Entry& entry = m_entries.back();
    try
    {
      entry.open = std::make_unique<Open_file>(std::move(report));
      // Locked until the file is open: opening a file that a signal has removed would create it again.
      const std::unique_lock<std::mutex> lock = Temporary_files::instance().lock();
      entry.temporary = new_file_beside(entry);
      errno = 0;
      if(entry.open->file.open(entry.temporary, std::ios::out | std::ios::binary | std::ios::trunc) == nullptr)
        fail(target, reason());
    }
    catch(...)
    {
      leave_out(target);
      throw;
    }
    return entry.open->stream;
  }

  Entry& entry_of(const std::string& target)
  {
    return *std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& entry) { return entry.target == target; });
  }

  void leave_out(const std::string& target)
  {
    Entry& entry = entry_of(target);
    entry.open.reset();
    remove(entry.temporary);
    m_entries.erase(m_entries.begin() + (&entry - m_entries.data()));
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_OUTPUT_FILE_H
