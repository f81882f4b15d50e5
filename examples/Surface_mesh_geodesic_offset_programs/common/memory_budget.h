// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Checks of available memory before large allocations: a machine that runs out of memory becomes slow, and ends programs
// without a message.

#ifndef GEODESIC_OFFSET_MEMORY_BUDGET_H
#define GEODESIC_OFFSET_MEMORY_BUDGET_H

#include "messages.h"

#if defined(__linux__)
#include <sys/resource.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>

namespace geodesic_offset {

// Bytes that the program can still allocate, according to the machine, its control group, and the limits of the process. A
// large number if the system provides no information.
inline std::uintmax_t available_memory()
{
  std::uintmax_t available = std::numeric_limits<std::uintmax_t>::max();
#if defined(__linux__)
  const auto limit_to = [&](std::uintmax_t limit, std::uintmax_t used) {
    available = std::min(available, limit - std::min(used, limit));
  };
  std::uintmax_t kilobytes = 0;
  std::ifstream machine("/proc/meminfo");
  for(std::string word; machine >> word;)
    if(word == "MemAvailable:" && machine >> kilobytes) limit_to(kilobytes * 1024, 0);
  std::uintmax_t limit = 0, used = 0;
  std::ifstream group_limit("/sys/fs/cgroup/memory.max"), group_used("/sys/fs/cgroup/memory.current");
  if(group_limit >> limit && group_used >> used) // the limit may also be the word "max"
    limit_to(limit, used);
  std::uintmax_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit address_space;
  if(getrlimit(RLIMIT_AS, &address_space) == 0 && address_space.rlim_cur != RLIM_INFINITY)
    limit_to(address_space.rlim_cur, pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE)));
#endif
  return available;
}

// For example "1.5 GB".
inline std::string memory_size(std::uintmax_t bytes)
{
  char text[48];
  const double megabytes = static_cast<double>(bytes) / 1e6;
  std::snprintf(text, sizeof(text), megabytes < 1000 ? "%.0f MB" : "%.1f GB", megabytes < 1000 ? megabytes : megabytes / 1000);
  return text;
}

// Throws Input_error if `needed` exceeds the available memory.
inline void require_memory(const std::string& what, std::uintmax_t needed)
{
  const std::uintmax_t available = available_memory();
  if(needed > available)
    throw Input_error(what + " needs at least " + memory_size(needed) + " of memory, and " + memory_size(available) +
                      " are available");
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_MEMORY_BUDGET_H
