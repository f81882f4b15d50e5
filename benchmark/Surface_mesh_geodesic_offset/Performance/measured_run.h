// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs a computation in a separate process and measures its time and additional memory (POSIX).

#ifndef GEODESIC_OFFSET_BENCHMARK_MEASURED_RUN_H
#define GEODESIC_OFFSET_BENCHMARK_MEASURED_RUN_H

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace benchmark {

struct Measured_run
{
  double seconds = 0;
  std::size_t peak_bytes = 0; // beyond the memory in use at the start
  std::uint64_t windows = 0;  // reported by the computation
  std::vector<double> distances;
};

inline std::size_t peak_resident_bytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<std::size_t>(usage.ru_maxrss);
#else
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
#endif
}

inline void write_all(int file, const void* data, std::size_t size)
{
  for (const char* at = static_cast<const char*>(data); size > 0;)
  {
    const ssize_t written = write(file, at, size);
    if (written <= 0) _exit(1);
    at += written;
    size -= static_cast<std::size_t>(written);
  }
}

inline bool read_all(int file, void* data, std::size_t size)
{
  for (char* at = static_cast<char*>(data); size > 0;)
  {
    const ssize_t count = read(file, at, size);
    if (count <= 0) return false;
    at += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

/// `computation(distances, windows)` fills its arguments; all other effects in the process are lost. Throws
/// `std::runtime_error` if it fails.
template <class Computation>
Measured_run measured_run(const Computation& computation)
{
#ifdef __GLIBC__
  malloc_trim(0); // freed memory must not hide the demand of the computation
#endif
  int channel[2];
  if (pipe(channel) != 0) throw std::runtime_error("pipe failed");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0)
  {
    try
    {
      close(channel[0]);
      Measured_run run;
      const std::size_t before = peak_resident_bytes();
      const auto start = std::chrono::steady_clock::now();
      computation(run.distances, run.windows);
      run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      run.peak_bytes = peak_resident_bytes() - before;
      const std::uint64_t count = run.distances.size();
      write_all(channel[1], &run.seconds, sizeof(run.seconds));
      write_all(channel[1], &run.peak_bytes, sizeof(run.peak_bytes));
      write_all(channel[1], &run.windows, sizeof(run.windows));
      write_all(channel[1], &count, sizeof(count));
      write_all(channel[1], run.distances.data(), count * sizeof(double));
      _exit(0);
    }
    catch (...)
    {
      _exit(1);
    }
  }
  close(channel[1]);
  Measured_run run;
  std::uint64_t count = 0;
  bool complete =
    read_all(channel[0], &run.seconds, sizeof(run.seconds)) && read_all(channel[0], &run.peak_bytes, sizeof(run.peak_bytes)) &&
    read_all(channel[0], &run.windows, sizeof(run.windows)) && read_all(channel[0], &count, sizeof(count));
  if (complete)
  {
    run.distances.resize(count);
    complete = read_all(channel[0], run.distances.data(), count * sizeof(double));
  }
  close(channel[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!complete || !WIFEXITED(status) || WEXITSTATUS(status) != 0) throw std::runtime_error("the computation failed");
  return run;
}

} // namespace benchmark

#endif // GEODESIC_OFFSET_BENCHMARK_MEASURED_RUN_H
