// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The processes that mpirun starts, or one process: values from the first one for all, work on demand, and a file in which each
// writes at its place. Without Boost.MPI there is one process.

#ifndef GEODESIC_DISTANCE_MATRIX_PROCESSES_H
#define GEODESIC_DISTANCE_MATRIX_PROCESSES_H

#include "common/messages.h"

#ifdef GEODESIC_OFFSET_HAS_MPI
#include <boost/mpi.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>
#else
#include <fcntl.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace geodesic_offset {

#ifdef GEODESIC_OFFSET_HAS_MPI
class Processes
{
  boost::mpi::environment m_environment{boost::mpi::threading::multiple, false};
  boost::mpi::communicator m_world;

public:
  bool is_first() const { return m_world.rank() == 0; }
  int number() const { return m_world.size(); }
  const boost::mpi::communicator& world() const { return m_world; }

  // The value of the first process, in all.
  template <class T>
  void broadcast(T& value) const
  {
    boost::mpi::broadcast(m_world, value, 0);
  }

  void wait_for_all() const { m_world.barrier(); }

  // Ends all processes.
  void abort() const
  {
    if(number() > 1) m_environment.abort(1);
  }
};
#else
class Processes
{
public:
  bool is_first() const { return true; }
  int number() const { return 1; }
  template <class T>
  void broadcast(T&) const
  {
  }
  void wait_for_all() const {}
  void abort() const {}
};
#endif

// Hands out ranges of the numbers from 0 to `size`, to each process when it has nothing left. Large ranges come first: there are
// few messages, and all processes end at nearly the same time.
class Work_ranges
{
  using Range = std::pair<std::size_t, std::size_t>; // first, and behind the last
  static constexpr std::size_t parts = 8; // of what is left, per process

  const Processes& m_processes;
  std::size_t m_size, m_least;
  std::atomic<std::size_t> m_next{0}; // in the first process
  std::mutex m_mutex;
  std::thread m_answers;

public:
  // `least`: size of a range, except for the last one
  Work_ranges(const Processes& processes, std::size_t size, std::size_t least)
    : m_processes(processes), m_size(size), m_least(processes.number() == 1 ? size : least)
  {
    if(processes.is_first() && processes.number() > 1) m_answers = std::thread([this] { answer(); });
  }
  Work_ranges(const Work_ranges&) = delete;
  Work_ranges& operator=(const Work_ranges&) = delete;
  ~Work_ranges()
  {
    if(m_answers.joinable()) m_answers.join();
  }

  // Empty at the end.
  Range next()
  {
    if(m_processes.is_first()) return take();
    Range range(0, 0);
#ifdef GEODESIC_OFFSET_HAS_MPI
    m_processes.world().send(0, request_tag);
    m_processes.world().recv(0, answer_tag, range);
#endif
    return range;
  }

  // How many numbers have been handed out; in the first process.
  std::size_t begun() const { return m_next; }

private:
  static constexpr int request_tag = 1, answer_tag = 2;

  Range take()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    const std::size_t left = m_size - m_next;
    const std::size_t shared = left / (parts * static_cast<std::size_t>(m_processes.number()));
    const std::size_t first = m_next, count = std::min(left, std::max(m_least, shared));
    m_next = first + count;
    return {first, first + count};
  }

  // Answers the other processes until each has got an empty range. Between questions the thread sleeps: MPI would wait busily.
  void answer()
  {
#ifdef GEODESIC_OFFSET_HAS_MPI
    for(int active = m_processes.number() - 1; active > 0;)
    {
      const auto question = m_processes.world().iprobe(boost::mpi::any_source, request_tag);
      if(!question)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        continue;
      }
      m_processes.world().recv(question->source(), request_tag);
      const Range range = take();
      m_processes.world().send(question->source(), answer_tag, range);
      if(range.first == range.second) --active;
    }
#endif
  }
};

// A file that exists, in which all processes write at different places.
class Shared_file
{
  std::string m_path;
#ifdef GEODESIC_OFFSET_HAS_MPI
  MPI_File m_file = MPI_FILE_NULL;
#else
  int m_file = -1;
#endif

  [[noreturn]] void fail(const std::string& reason) const
  {
    throw Input_error("cannot write " + quoted(m_path) + ": " + reason);
  }

public:
  // All processes call this and the destructor.
  Shared_file([[maybe_unused]] const Processes& processes, const std::string& path) : m_path(path)
  {
#ifdef GEODESIC_OFFSET_HAS_MPI
    check(MPI_File_open(processes.world(), path.c_str(), MPI_MODE_WRONLY, MPI_INFO_NULL, &m_file));
#else
    m_file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if(m_file < 0) fail(std::strerror(errno));
#endif
  }
  Shared_file(const Shared_file&) = delete;
  Shared_file& operator=(const Shared_file&) = delete;

  void write(std::size_t place, const char* bytes, std::size_t size)
  {
#ifdef GEODESIC_OFFSET_HAS_MPI
    constexpr std::size_t most = 1 << 30; // MPI counts with int
    for(std::size_t done = 0, n = 0; done < size; done += n)
    {
      n = std::min(most, size - done);
      check(MPI_File_write_at(m_file, static_cast<MPI_Offset>(place + done), bytes + done, static_cast<int>(n), MPI_BYTE,
                              MPI_STATUS_IGNORE));
    }
#else
    for(std::size_t done = 0; done < size;)
    {
      const ssize_t n = ::pwrite(m_file, bytes + done, size - done, static_cast<off_t>(place + done));
      if(n < 0 && errno != EINTR) fail(std::strerror(errno));
      if(n > 0) done += static_cast<std::size_t>(n);
    }
#endif
  }

  // Throws Input_error if the last bytes cannot be written.
  void close()
  {
#ifdef GEODESIC_OFFSET_HAS_MPI
    check(MPI_File_close(&m_file));
#else
    const int file = std::exchange(m_file, -1);
    if(::close(file) != 0) fail(std::strerror(errno));
#endif
  }

private:
#ifdef GEODESIC_OFFSET_HAS_MPI
  void check(int code) const
  {
    if(code == MPI_SUCCESS) return;
    char text[MPI_MAX_ERROR_STRING];
    int length = 0;
    MPI_Error_string(code, text, &length);
    fail(std::string(text, static_cast<std::size_t>(length)));
  }
#endif
};

} // namespace geodesic_offset

#endif // GEODESIC_DISTANCE_MATRIX_PROCESSES_H
