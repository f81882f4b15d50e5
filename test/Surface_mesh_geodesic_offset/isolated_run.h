// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls a function in a child process, so that a crash or an endless loop ends only that run (POSIX).

#ifndef GEODESIC_OFFSET_TEST_ISOLATED_RUN_H
#define GEODESIC_OFFSET_TEST_ISOLATED_RUN_H

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace test {

struct Isolated_result
{
  std::string text; // result of the function; empty if a signal ended the run
  int signal = 0;   // SIGALRM if the run took too long
  double seconds = 0;
};

/// Returns the result of f(), called in a child process that ends after `most_seconds`. f must not throw.
template <class Function>
Isolated_result run_isolated(unsigned most_seconds, const Function& f)
{
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("pipe failed");
  std::fflush(nullptr);
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0)
  {
    close(ends[0]);
    alarm(most_seconds);
    const std::string text = f();
    const char* p = text.data();
    for (std::size_t rest = text.size(); rest > 0;)
    {
      const ssize_t n = write(ends[1], p, rest);
      if (n < 0) _exit(1);
      p += n;
      rest -= std::size_t(n);
    }
    _exit(0);
  }
  close(ends[1]);
  Isolated_result result;
  char block[4096];
  for (ssize_t n; (n = read(ends[0], block, sizeof(block))) > 0;) result.text.append(block, std::size_t(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
  {
    result.signal = WTERMSIG(status);
    result.text.clear();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_ISOLATED_RUN_H
