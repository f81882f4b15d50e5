// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures heap memory by its own operators new and delete; for one source file of a program.

#ifndef GEODESIC_OFFSET_BENCHMARK_COUNTED_HEAP_H
#define GEODESIC_OFFSET_BENCHMARK_COUNTED_HEAP_H

#include <boost/config.hpp>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace benchmark {

struct Heap_count
{
  static inline std::size_t now = 0, peak = 0;
};

// Bytes allocated on the heap since the construction, as requested.
class Counted_heap
{
public:
  Counted_heap() : m_before(Heap_count::now) { Heap_count::peak = m_before; }
  std::size_t bytes() const { return Heap_count::now - m_before; }
  std::size_t peak_bytes() const { return Heap_count::peak - m_before; }

private:
  const std::size_t m_before;
};

// The size precedes each block, in as many bytes as the alignment of the block.
constexpr std::size_t heap_header = alignof(std::max_align_t);

inline void* counted(void* block, std::size_t n, std::size_t header)
{
  if (!block) throw std::bad_alloc();
  *static_cast<std::size_t*>(block) = n;
  Heap_count::now += n;
  if (Heap_count::now > Heap_count::peak) Heap_count::peak = Heap_count::now;
  return static_cast<char*>(block) + header;
}

inline void free_counted(void* p, std::size_t header)
{
  if (!p) return;
  char* const block = static_cast<char*>(p) - header;
  Heap_count::now -= *reinterpret_cast<std::size_t*>(block);
  std::free(block);
}

} // namespace benchmark

// Not inlined: compilers match new and delete only as functions.
BOOST_NOINLINE void* operator new(std::size_t n)
{
  return benchmark::counted(std::malloc(n + benchmark::heap_header), n, benchmark::heap_header);
}

BOOST_NOINLINE void operator delete(void* p) noexcept { benchmark::free_counted(p, benchmark::heap_header); }
BOOST_NOINLINE void operator delete(void* p, std::size_t) noexcept { operator delete(p); }

// For over-aligned types such as windows. The size must be a multiple of the alignment.
BOOST_NOINLINE void* operator new(std::size_t n, std::align_val_t alignment)
{
  const std::size_t a = static_cast<std::size_t>(alignment);
  return benchmark::counted(std::aligned_alloc(a, (n + 2 * a - 1) / a * a), n, a);
}

BOOST_NOINLINE void operator delete(void* p, std::align_val_t alignment) noexcept
{
  benchmark::free_counted(p, static_cast<std::size_t>(alignment));
}
BOOST_NOINLINE void operator delete(void* p, std::size_t, std::align_val_t alignment) noexcept
{
  operator delete(p, alignment);
}

#endif // GEODESIC_OFFSET_BENCHMARK_COUNTED_HEAP_H
