// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the program says while it works, and how long the steps take.

#ifndef GEODESIC_OFFSET_PROGRESS_H
#define GEODESIC_OFFSET_PROGRESS_H

#include <chrono>
#include <cstdio>
#include <iostream>
#include <string>

namespace geodesic_offset {

class Stopwatch
{
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();

public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
  }
};

class Progress
{
  bool m_quiet;

public:
  explicit Progress(bool quiet) : m_quiet(quiet) {}

  // flushed, because the next step may take long
  void line(const std::string& text) const
  {
    if(!m_quiet)
      std::cout << text << std::endl;
  }

  void line(const std::string& text, double seconds) const
  {
    char time[48];
    std::snprintf(time, sizeof(time), " (%.2f s)", seconds);
    line(text + time);
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_PROGRESS_H
