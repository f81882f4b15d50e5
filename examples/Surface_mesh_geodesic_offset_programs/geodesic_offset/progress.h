// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Progress messages: lines with times on standard output, warnings on standard error, and, if that is a terminal, a
// progress bar in its last line.

#ifndef GEODESIC_OFFSET_PROGRESS_H
#define GEODESIC_OFFSET_PROGRESS_H

#include "common/common.h"
#include "common/program_main.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <string>

namespace geodesic_offset {

class Stopwatch
{
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();

public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count(); }
};

class Progress
{
  static constexpr double interval = 0.1; // seconds between updates of the bar
  static constexpr std::size_t columns = 79; // fits into a terminal of 80; a wrapped line could not be erased
  static constexpr std::size_t bar_columns = 25;

  bool m_quiet;
  bool m_has_bar; // standard error is a terminal, and not --quiet
  std::size_t m_shown = 0; // characters of the bar on the terminal
  std::string m_step;
  Stopwatch m_since_shown;

public:
  // Quiet: only warnings.
  explicit Progress(bool quiet) : m_quiet(quiet), m_has_bar(!quiet && ::isatty(STDERR_FILENO) == 1) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  ~Progress() { erase(); }

  // Flushed, since the next step may take long. Throws Input_error if standard output is full or closed.
  void line(const std::string& text)
  {
    erase();
    if(m_quiet) return;
    std::cout << text << '\n';
    check_standard_output();
  }

  void line(const std::string& text, double seconds)
  {
    char time[48];
    std::snprintf(time, sizeof(time), " (%.2f s)", seconds);
    line(text + time);
  }

  // Also with --quiet.
  void warning(const std::string& text)
  {
    erase();
    print_warning("geodesic_offset", text);
  }

  // Step of unknown length.
  void show(const std::string& step, const std::string& detail = "")
  {
    if(is_time_for(step)) put(step + (detail.empty() ? " ..." : "  " + detail));
  }

  // `done`: completed fraction of the step.
  void show(const std::string& step, double done, const std::string& detail = "")
  {
    if(!is_time_for(step)) return;
    const double part = std::min(std::max(done, 0.0), 1.0);
    const std::size_t filled = static_cast<std::size_t>(part * bar_columns);
    char percent[16];
    std::snprintf(percent, sizeof(percent), "] %3d %%", static_cast<int>(100 * part));
    put(step + " [" + std::string(filled, '#') + std::string(bar_columns - filled, '.') + percent +
        (detail.empty() ? "" : "  " + detail));
  }

private:
  // A new step is shown immediately.
  bool is_time_for(const std::string& step)
  {
    if(!m_has_bar || (step == m_step && m_shown != 0 && m_since_shown.seconds() < interval)) return false;
    m_step = step;
    m_since_shown = Stopwatch();
    return true;
  }

  void put(std::string text)
  {
    text.resize(std::min(text.size(), columns));
    const std::size_t size = text.size();
    text.resize(std::max(size, m_shown), ' ');
    std::cerr << '\r' << text << std::flush;
    m_shown = size;
  }

  void erase()
  {
    if(m_shown != 0) std::cerr << '\r' << std::string(m_shown, ' ') << '\r' << std::flush;
    m_shown = 0;
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_PROGRESS_H
