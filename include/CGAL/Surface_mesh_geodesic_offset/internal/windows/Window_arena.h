// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Memory for lists of windows: blocks that are reused while they are in the cache.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_ARENA_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_ARENA_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Blocks of 4, 8, 16, ... windows. A freed block serves the next list of its size.
template <class Window>
class Window_arena
{
public:
  Window* allocate(Index size_class)
  {
    CGAL_precondition(size_class < number_of_size_classes);
    std::vector<Window*>& free_blocks = m_free[size_class];
    if (!free_blocks.empty())
    {
      Window* block = free_blocks.back();
      free_blocks.pop_back();
      return block;
    }
    return new_block(capacity(size_class));
  }

  void release(Window* block, Index size_class)
  {
    CGAL_precondition(block != nullptr && size_class < number_of_size_classes);
    m_free[size_class].push_back(block);
  }
  std::size_t number_of_free_blocks(Index size_class) const { return m_free[size_class].size(); }

  // Moves n free blocks to another arena.
  void give(Window_arena& other, Index size_class, std::size_t n)
  {
    CGAL_precondition(n <= number_of_free_blocks(size_class));
    std::vector<Window*>& from = m_free[size_class];
    const auto first = from.end() - std::ptrdiff_t(n);
    other.m_free[size_class].insert(other.m_free[size_class].end(), first, from.end());
    from.erase(first, from.end());
  }

  static constexpr Index number_of_size_classes = 28;
  static std::size_t capacity(Index size_class) { return std::size_t(4) << size_class; }
  static Index size_class(std::size_t n, Index least = 0)
  {
    // The smallest classes by the quarter of n; the table saves a loop with an unpredictable number of turns.
    static constexpr unsigned char of_quarter[] = {0, 0, 1, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4};
    if (const std::size_t quarter = (n + 3) / 4; quarter < sizeof(of_quarter))
    {
      const Index smallest = of_quarter[quarter];
      CGAL_assertion(n <= capacity(smallest) && (smallest == 0 || n > capacity(smallest - 1)));
      return (std::max)(least, smallest);
    }
    while (capacity(least) < n) ++least;
    return least;
  }

private:
  enum { page_size = 8192 };

  // Block of n windows from the current page or a new one.
  BOOST_NOINLINE Window* new_block(std::size_t n)
  {
    if (m_left < n)
    {
      const std::size_t page = (std::max)(n, std::size_t(page_size));
      std::unique_ptr<Window[]> fresh(new Window[page]);
      m_pages.push_back(std::move(fresh));
      m_top = m_pages.back().get();
      m_left = page;
    }
    CGAL_assertion(n <= m_left);
    Window* block = m_top;
    m_top += n;
    m_left -= n;
    return block;
  }

  std::vector<std::unique_ptr<Window[]>> m_pages;
  Window* m_top = nullptr;
  std::size_t m_left = 0;
  std::array<std::vector<Window*>, number_of_size_classes> m_free;
};

// Windows in a block of their own.
template <class Window>
struct Window_block
{
  Window* data = nullptr;
  Index size = 0, size_class = 0;

  const Window* begin() const { return data; }
  const Window* end() const { return data + size; }

  Window_block() = default;

  // Copies n > 0 windows into a block of an arena.
  Window_block(Window_arena<Window>& arena, const Window* first, std::size_t n)
    : size(Index(n)), size_class(Window_arena<Window>::size_class(n))
  {
    CGAL_precondition(n > 0);
    data = arena.allocate(size_class);
    std::copy(first, first + n, data);
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
