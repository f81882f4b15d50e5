// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A limit on memory while a file is read.
// The header of a damaged file may announce billions of elements, and the readers believe it. No honest file needs more
// than a small multiple of its own size, so everything beyond that becomes a std::bad_alloc, long before the machine suffers.

#ifndef GEODESIC_OFFSET_MEMORY_GUARD_H
#define GEODESIC_OFFSET_MEMORY_GUARD_H

#if defined(__linux__)
#include <sys/resource.h>
#include <unistd.h>
#endif

#include <cstdint>
#include <fstream>

namespace geodesic_offset {

class Memory_guard
{
#if defined(__linux__)
  rlimit m_old{};
  bool   m_active = false;

public:
  explicit Memory_guard(std::uintmax_t file_size)
  {
    std::uintmax_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    if(pages == 0 || getrlimit(RLIMIT_AS, &m_old) != 0)
      return;
    const std::uintmax_t used = pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE));
    const std::uintmax_t limit = used + 64 * file_size + (std::uintmax_t(256) << 20);
    if(m_old.rlim_cur != RLIM_INFINITY && limit >= m_old.rlim_cur)
      return;
    rlimit guarded = m_old;
    guarded.rlim_cur = static_cast<rlim_t>(limit);
    m_active = (setrlimit(RLIMIT_AS, &guarded) == 0);
  }

  ~Memory_guard()
  {
    if(m_active)
      setrlimit(RLIMIT_AS, &m_old);
  }
#else
public:
  explicit Memory_guard(std::uintmax_t) {}
#endif

  Memory_guard(const Memory_guard&) = delete;
  Memory_guard& operator=(const Memory_guard&) = delete;
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_MEMORY_GUARD_H
