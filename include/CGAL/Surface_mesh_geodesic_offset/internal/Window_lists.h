// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of windows of each halfedge that the front has reached, in an arena with reuse.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOW_LISTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOW_LISTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Prefetch.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Blocks of 4, 8, 16, ... windows. A freed block is used again for the next list of its size.
template <class Window>
class Window_arena
{
public:
  Window* allocate(Index size_class)
  {
    std::vector<Window*>& free_blocks = m_free[size_class];
    if (!free_blocks.empty())
    {
      Window* block = free_blocks.back();
      free_blocks.pop_back();
      return block;
    }
    const std::size_t n = capacity(size_class);
    if (m_left < n)
    {
      const std::size_t page = (std::max)(n, std::size_t(page_size));
      m_pages.emplace_back(new Window[page]);
      m_top = m_pages.back().get();
      m_left = page;
    }
    Window* block = m_top;
    m_top += n;
    m_left -= n;
    return block;
  }

  void release(Window* block, Index size_class) { m_free[size_class].push_back(block); }
  std::size_t number_of_free_blocks(Index size_class) const { return m_free[size_class].size(); }

  // Gives n free blocks to another arena.
  void give(Window_arena& other, Index size_class, std::size_t n)
  {
    std::vector<Window*>& from = m_free[size_class];
    const auto first = from.end() - std::ptrdiff_t(n);
    other.m_free[size_class].insert(other.m_free[size_class].end(), first, from.end());
    from.erase(first, from.end());
  }

  static constexpr Index number_of_size_classes = 28;
  static std::size_t capacity(Index size_class) { return std::size_t(4) << size_class; }
  static Index size_class(std::size_t n, Index least = 0)
  {
    while (capacity(least) < n) ++least;
    return least;
  }

private:
  enum { page_size = 8192 };
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

  // A copy of n > 0 windows in a block of an arena.
  static Window_block copy(Window_arena<Window>& arena, const Window* first, std::size_t n)
  {
    Window_block block;
    block.size = Index(n);
    block.size_class = Window_arena<Window>::size_class(n);
    block.data = arena.allocate(block.size_class);
    std::copy(first, first + n, block.data);
    return block;
  }
};

// The first `taken` windows are sorted, disjoint and already propagated; the others wait.
template <class FT, class Window_ = CGAL::Geodesic_offset::internal::Window<FT>>
struct Window_list
{
  typedef Window_ Window;
  static constexpr std::size_t not_queued = ~std::size_t(0);

  Window* data = nullptr;
  Index size = 0;
  Index taken = 0;
  Index size_class = 0;
  std::size_t bucket = not_queued;
  FT split_distance = Number_policy<FT>::infinity(); // "one angle, one split": the best distance given to the
  FT split_entry = FT(0);                            // apex through this halfedge, and where its ray enters

  const Window* begin() const { return data; }
  const Window* end() const { return data + size; }
};

template <class FT, class Window_ = CGAL::Geodesic_offset::internal::Window<FT>>
class Window_lists
{
public:
  typedef Window_ Window;
  typedef Window_list<FT, Window> List;

  Window_lists() = default;
  explicit Window_lists(std::size_t number_of_halfedges) : m_list_of(number_of_halfedges, no_index) {}

  // The place of the list of a halfedge among all lists.
  Index place(Index h) const { return m_list_of[h]; }

  bool has(Index h) const { return h < m_list_of.size() && m_list_of[h] != no_index; }
  const List& get(Index h) const
  {
    static const List empty;
    return has(h) ? m_lists[m_list_of[h]] : empty;
  }
  List& get(Index h) { return m_lists[m_list_of[h]]; }

  List& get_or_create(Index h)
  {
    if (m_list_of[h] == no_index)
    {
      if (m_free_lists.empty())
      {
        m_list_of[h] = Index(m_lists.size());
        m_lists.emplace_back();
      }
      else
      {
        m_list_of[h] = m_free_lists.back();
        m_free_lists.pop_back();
        m_lists[m_list_of[h]] = List();
      }
    }
    return m_lists[m_list_of[h]];
  }

  // Writes n windows behind the last one.
  void append(List& list, const Window* first, std::size_t n)
  {
    reserve(list, list.size + n);
    std::copy(first, first + n, list.data + list.size);
    list.size += Index(n);
    count(std::ptrdiff_t(n));
  }

  // Makes a block the list's own, if it has none; false if it has.
  bool adopt(List& list, const Window_block<Window>& block)
  {
    if (list.data) return false;
    list.data = block.data;
    list.size = block.size;
    list.size_class = block.size_class;
    return true;
  }

  // Replaces all windows of a list.
  void assign(List& list, const std::vector<Window>& windows)
  {
    count(-std::ptrdiff_t(list.size));
    list.size = 0;
    append(list, windows.data(), windows.size());
  }

  void release(Index h)
  {
    if (!has(h)) return;
    List& list = get(h);
    count(-std::ptrdiff_t(list.size));
    if (list.data) release(Window_block<Window>{list.data, list.size, list.size_class});
    m_free_lists.push_back(m_list_of[h]);
    m_list_of[h] = no_index;
  }

  // The same in two steps, of which the second one needs no halfedge.
  Index detach(Index h)
  {
    const Index place = m_list_of[h];
    m_list_of[h] = no_index;
    return place;
  }
  void release_places(const std::vector<Index>& places)
  {
    m_free_lists.insert(m_free_lists.end(), places.begin(), places.end());
  }
  List& at(Index place) { return m_lists[place]; }

  // Gives a block to the arena that has the fewest free ones of its size.
  void release(const Window_block<Window>& block)
  {
    Window_arena<Window>* poorest = &m_arenas.front();
    for (Window_arena<Window>& a : m_arenas)
      if (a.number_of_free_blocks(block.size_class) < poorest->number_of_free_blocks(block.size_class)) poorest = &a;
    poorest->release(block.data, block.size_class);
  }

  // Several threads may allocate blocks at one time if each has an arena of its own. The first one is that of the functions
  // of this class. Blocks may go from one to another.
  void set_number_of_arenas(std::size_t n) { m_arenas.resize(n); }
  Window_arena<Window>& arena(std::size_t i) { return m_arenas[i]; }

  // Threads that free more blocks than they need would leave the others without: the free ones are shared out again.
  void balance_arenas()
  {
    if (m_arenas.size() < 2) return;
    typedef Window_arena<Window> Arena;
    for (Index c = 0; c < Arena::number_of_size_classes; ++c)
    {
      const auto has_less = [c](const Arena& a, const Arena& b) {
        return a.number_of_free_blocks(c) < b.number_of_free_blocks(c);
      };
      for (std::size_t i = 1; i < m_arenas.size(); ++i)
      {
        const auto ends = std::minmax_element(m_arenas.begin(), m_arenas.end(), has_less);
        const std::size_t more = ends.second->number_of_free_blocks(c) - ends.first->number_of_free_blocks(c);
        if (more < 16) break;
        ends.second->give(*ends.first, c, more / 2);
      }
    }
  }

  // Says that there are more windows, or less.
  void count(std::ptrdiff_t change)
  {
    m_live += change;
    if (m_live > m_peak) m_peak = m_live;
  }

  // Says that a list will be asked for soon.
  BOOST_FORCEINLINE void prefetch(Index h) const
  {
    if (h == no_index || m_list_of[h] == no_index) return;
    const List& list = m_lists[m_list_of[h]];
    prefetch(list.data, list.size);
  }
  BOOST_FORCEINLINE static void prefetch(const Window* data, Index size)
  {
    internal::prefetch(data, (std::min)(size, Index(8)) * sizeof(Window));
  }

  // The same for what says where the lists are, and for what is said of them.
  BOOST_FORCEINLINE void prefetch_place(Index h) const { internal::prefetch(&m_list_of[h]); }
  BOOST_FORCEINLINE void prefetch_head(Index h) const
  {
    if (m_list_of[h] != no_index) internal::prefetch(&m_lists[m_list_of[h]]);
  }

  std::size_t number_of_windows() const { return m_live; }
  std::size_t peak() const { return m_peak; }

private:
  void reserve(List& list, std::size_t n)
  {
    if (list.data && n <= Window_arena<Window>::capacity(list.size_class)) return;
    const Index c = Window_arena<Window>::size_class(n, list.size_class);
    Window* data = m_arenas.front().allocate(c);
    std::copy(list.data, list.data + list.size, data);
    if (list.data) m_arenas.front().release(list.data, list.size_class);
    list.data = data;
    list.size_class = c;
  }

  std::vector<Index> m_list_of; // per halfedge
  std::vector<List> m_lists;
  std::vector<Index> m_free_lists;
  std::vector<Window_arena<Window>> m_arenas = std::vector<Window_arena<Window>>(1);
  std::size_t m_live = 0, m_peak = 0;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
