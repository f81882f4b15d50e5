// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Counts what is on the heap, by operators new and delete of its own: for one source file of a program.

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

// What has come onto the heap since it was made, in bytes as asked for.
class Counted_heap
{
public:
  Counted_heap() : m_before(Heap_count::now) { Heap_count::peak = m_before; }
  std::size_t bytes() const { return Heap_count::now - m_before; }
  std::size_t peak_bytes() const { return Heap_count::peak - m_before; }

private:
  const std::size_t m_before;
};

// The size stands before each block, which stays aligned for all types but over-aligned ones.
constexpr std::size_t heap_header = alignof(std::max_align_t);

} // namespace benchmark

// Not inlined: compilers pair them with each other only as functions.
BOOST_NOINLINE void* operator new(std::size_t n)
{
  char* const block = static_cast<char*>(std::malloc(n + benchmark::heap_header));
  if (!block) throw std::bad_alloc();
  *reinterpret_cast<std::size_t*>(block) = n;
  benchmark::Heap_count::now += n;
  if (benchmark::Heap_count::now > benchmark::Heap_count::peak) benchmark::Heap_count::peak = benchmark::Heap_count::now;
  return block + benchmark::heap_header;
}

BOOST_NOINLINE void operator delete(void* p) noexcept
{
  if (!p) return;
  char* const block = static_cast<char*>(p) - benchmark::heap_header;
  benchmark::Heap_count::now -= *reinterpret_cast<std::size_t*>(block);
  std::free(block);
}

BOOST_NOINLINE void operator delete(void* p, std::size_t) noexcept { operator delete(p); }

#endif // GEODESIC_OFFSET_BENCHMARK_COUNTED_HEAP_H
