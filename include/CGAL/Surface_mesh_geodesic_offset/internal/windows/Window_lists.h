// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of windows of each halfedge that the front has reached.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_LISTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_LISTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/memory/prefetch.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Front_parts.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_arena.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// The windows of a halfedge. A propagated window is stored by its rays; a pending one has its positions until its batch.
template <class FT, class Window = Window<FT>, class Stored = Stored_window<FT>>
struct alignas(sizeof(FT) == 8 ? 64 : (std::max)(alignof(FT), alignof(std::size_t))) Window_list
{
  static constexpr std::size_t not_queued = ~std::size_t(0);

  Window_block<Stored> propagated; // sorted and disjoint if envelopes are required
  Window_block<Window> pending;
  std::size_t bucket = not_queued;
  FT split_distance = Number_policy<FT>::infinity(); // "one angle, one split": smallest distance of the
  FT split_entry = FT(0);                            // apex through this halfedge, and the entry of its ray
  bool is_reduced = false;                           // set by Halfedge_batch: the propagated windows are a lower envelope
  Index halfedge = no_index;                         // the last one with this list

  bool has_new() const { return pending.data; }
};

// Each part of the front has its own lists, so several threads may work on different parts. Blocks come from arenas, one per
// thread. `longest`: the length of lists that is always allowed, see reserve().
template <class FT, class Window_ = Window<FT>, class Stored = Stored_window<FT>, std::size_t longest = std::size_t(1) << 12>
class Window_lists
{
public:
  typedef Window_ Window;
  typedef Window_list<FT, Window, Stored> List;
  struct Arena
  {
    Window_arena<Stored> propagated;
    Window_arena<Window> pending;
  };

  Window_lists() = default;
  explicit Window_lists(std::size_t number_of_halfedges, const Front_parts& parts = Front_parts())
    : m_parts(parts), m_place(number_of_halfedges, no_index), m_part(parts.number())
  {
  }

  // Makes the lists empty for a front. One of one part has the memory of the front before it on the same mesh.
  void reset(std::size_t number_of_halfedges, const Front_parts& parts)
  {
    if (m_place.size() != number_of_halfedges || m_part.size() != 1 || parts.number() != 1)
    {
      *this = Window_lists(number_of_halfedges, parts);
      return;
    }
    Part& part = m_part.front();
    for (List& list : part.lists)
    {
      if (list.halfedge != no_index) m_place[list.halfedge] = no_index;
      drop(list.pending, m_arenas.front().pending);
      drop(list.propagated, m_arenas.front().propagated);
    }
    part = Part();
  }

  // The number of source primitives, each of which may have own windows on every edge.
  void set_number_of_primitives(std::size_t n) { m_number_of_primitives = n; }

  bool has(Index h) const { return h < m_place.size() && m_place[h] != no_index; }
  const List& get(Index h) const
  {
    static const List empty;
    return has(h) ? part_of(h).lists[m_place[h]] : empty;
  }

  // The list of a halfedge; null if there is none.
  List* find(Index h) { return m_place[h] == no_index ? nullptr : &part_of(h).lists[m_place[h]]; }

  List& get_or_create(Index h)
  {
    List* const list = find(h);
    return list ? *list : create(h);
  }

  List& create(Index h)
  {
    CGAL_precondition(!has(h));
    Part& part = part_of(h);
    if (part.free.empty()) add_list(part);
    m_place[h] = part.free.back();
    part.free.pop_back();
    List& list = part.lists[m_place[h]] = List();
    list.halfedge = h;
    return list;
  }

  // Appends n pending windows to the list of a halfedge.
  void append(Index h, List& list, const Window* first, std::size_t n, Arena& arena)
  {
    write(list.pending, first, n, arena.pending);
    count(h, std::ptrdiff_t(n));
  }

  // Appends a block of pending windows to the list of a halfedge.
  void append(Index h, List& list, const Window_block<Window>& block, Arena& arena)
  {
    CGAL_precondition(block.data != nullptr && block.size > 0 && block.size <= arena.pending.capacity(block.size_class));
    if (!list.pending.data) list.pending = block;
    else
    {
      write(list.pending, block.data, block.size, arena.pending);
      arena.pending.release(block.data, block.size_class);
    }
    count(h, std::ptrdiff_t(block.size));
  }

  // Replaces the propagated windows [first, last) and all pending ones of the list of a halfedge by the windows [begin, end), which
  // may be the pending ones.
  void replace(Index h, List& list, std::size_t first, std::size_t last, const Window* begin, const Window* end, Arena& arena)
  {
    Window_block<Stored>& block = list.propagated;
    CGAL_precondition(first <= last && last <= block.size);
    const std::size_t middle = first + std::size_t(end - begin), size = middle + (block.size - last);
    reserve(block, size, arena.propagated);
    count(h, std::ptrdiff_t(size) - std::ptrdiff_t(block.size + list.pending.size));
    Stored *const behind = block.data + last, *const behind_end = block.data + block.size;
    if (middle > last) std::move_backward(behind, behind_end, block.data + size);
    else if (middle < last) std::move(behind, behind_end, block.data + middle);
    std::copy(begin, end, block.data + first);
    block.size = Index(size);
    drop(list.pending, arena.pending);
  }

  // Releases the lists of all halfedges of faces. They are no longer in the cache, so they are prefetched together.
  void release_faces(const std::vector<Index>& faces, Arena& arena)
  {
    for (Index f : faces)
    {
      const List* const lists = m_part[m_parts.of_face(f)].lists.data();
      for (Index k = 0; k < 3; ++k) // without a branch, which would be unpredictable
        internal::prefetch(lists + m_place[3 * f + k] * std::size_t(m_place[3 * f + k] != no_index));
    }
    for (Index f : faces) release_face(f, m_part[m_parts.of_face(f)], arena);
  }

  void set_number_of_arenas(std::size_t n) { m_arenas.resize(n); }
  Arena& arena(std::size_t i)
  {
    CGAL_precondition(i < m_arenas.size());
    return m_arenas[i];
  }

  // Distributes free blocks evenly: some threads free more blocks than they need.
  void balance_arenas()
  {
    if (m_arenas.size() < 2) return;
    balance(&Arena::propagated);
    balance(&Arena::pending);
  }

  std::ptrdiff_t number_of_windows(Index part) const { return m_part[part].live; }

  // Peak of the number of windows; with several parts, of the recorded numbers.
  std::size_t peak() const { return m_part.size() == 1 ? std::size_t(m_part.front().peak) : m_peak; }
  void note_number(std::size_t n) { m_peak = (std::max)(m_peak, n); }

  // Software prefetch of the lists of the next halfedges of a queue; prefetch_face(h) prefetches the face of h.
  template <class Queue, class Prefetch_face>
  BOOST_FORCEINLINE void prefetch_next(const Queue& queue, const Prefetch_face& prefetch_face) const
  {
    prefetch(queue.next_halfedge());
    prefetch_list(queue.next_halfedge(1));
    if (const Index h = queue.next_halfedge(2); h != no_index) prefetch_face(h);
    prefetch_place(queue.next_halfedge(3));
  }

  BOOST_FORCEINLINE void prefetch_place(Index h) const
  {
    if (h != no_index) internal::prefetch(&m_place[h]);
  }

private:
  struct alignas(64) Part
  {
    std::vector<List> lists;
    std::vector<Index> free;
    std::ptrdiff_t live = 0, peak = 0;
  };

  // Adds a free list.
  BOOST_NOINLINE static void add_list(Part& part)
  {
    part.free.push_back(Index(part.lists.size()));
    part.lists.emplace_back();
  }

  template <class Windows>
  void balance(Window_arena<Windows> Arena::*arena)
  {
    typedef Window_arena<Windows> Blocks;
    for (Index c = 0; c < Blocks::number_of_size_classes; ++c)
    {
      const auto has_less = [c, arena](const Arena& a, const Arena& b) {
        return (a.*arena).number_of_free_blocks(c) < (b.*arena).number_of_free_blocks(c);
      };
      for (std::size_t i = 1; i < m_arenas.size(); ++i)
      {
        const auto ends = std::minmax_element(m_arenas.begin(), m_arenas.end(), has_less);
        Blocks &least = (*ends.first).*arena, &most = (*ends.second).*arena;
        const std::size_t more = most.number_of_free_blocks(c) - least.number_of_free_blocks(c);
        if (more < 16) break;
        most.give(least, c, more / 2);
      }
    }
  }

  // Longer lists on small meshes come from faces so thin that no window is certainly nearer than another; then the number of
  // windows doubles in every face.
  template <class Windows>
  void reserve(Window_block<Windows>& block, std::size_t n, Window_arena<Windows>& arena) const
  {
    if (block.data && n <= arena.capacity(block.size_class)) return;
    if (BOOST_UNLIKELY(n > longest) && n > longest + 4 * (m_place.size() + m_number_of_primitives))
      throw std::runtime_error("Surface_mesh_geodesic_offset: " + std::to_string(n) +
                               " windows on an edge: faces are so thin that rounding does not let windows be told apart");
    const Index c = arena.size_class(n, block.size_class);
    Windows* const data = arena.allocate(c);
    std::copy(block.begin(), block.end(), data);
    if (block.data) arena.release(block.data, block.size_class);
    block.data = data;
    block.size_class = c;
  }

  // Appends windows without counting.
  void write(Window_block<Window>& block, const Window* first, std::size_t n, Window_arena<Window>& arena) const
  {
    reserve(block, block.size + n, arena);
    std::copy(first, first + n, block.data + block.size);
    block.size += Index(n);
  }

  // `part`: that of the face.
  void release_face(Index f, Part& part, Arena& arena)
  {
    for (Index k = 0; k < 3; ++k) release_list(3 * f + k, part, arena);
    CGAL_assertion(part.free.size() <= part.lists.size());
    if (part.free.size() < part.lists.size()) return;
    CGAL_assertion(part.live == 0);
    part.lists = std::vector<List>(); // no lists are left in the part
    part.free = std::vector<Index>();
  }

  BOOST_FORCEINLINE void release_list(Index h, Part& part, Arena& arena)
  {
    if (m_place[h] == no_index) return;
    List& list = part.lists[m_place[h]];
    part.live -= list.propagated.size + list.pending.size;
    CGAL_assertion(part.live >= 0);
    drop(list.pending, arena.pending);
    drop(list.propagated, arena.propagated);
    part.free.push_back(m_place[h]);
    m_place[h] = no_index;
  }

  // Changes the number of windows in the part of a halfedge.
  void count(Index h, std::ptrdiff_t change)
  {
    Part& part = part_of(h);
    part.live += change;
    if (part.live > part.peak) part.peak = part.live;
  }

  // Software prefetch of a list in three steps, from last to first: its windows, the list, and its place.
  BOOST_FORCEINLINE void prefetch(Index h) const
  {
    if (h == no_index || m_place[h] == no_index) return;
    const List& list = part_of(h).lists[m_place[h]];
    // One branch instead of a loop, whose number of turns is unpredictable.
    internal::prefetch(list.pending.data, 4 * sizeof(Window));
    if (list.pending.size > 4) internal::prefetch(list.pending.data + 4, 4 * sizeof(Window));
    if (list.propagated.data) internal::prefetch(list.propagated.data, 4 * sizeof(Stored));
  }

  BOOST_FORCEINLINE void prefetch_list(Index h) const
  {
    if (h != no_index && m_place[h] != no_index) internal::prefetch(&part_of(h).lists[m_place[h]]);
  }

  template <class Windows>
  static void drop(Window_block<Windows>& block, Window_arena<Windows>& arena)
  {
    if (!block.data) return;
    arena.release(block.data, block.size_class);
    block = Window_block<Windows>();
  }

  Part& part_of(Index h) { return m_part[m_parts.of_halfedge(h)]; }
  const Part& part_of(Index h) const { return m_part[m_parts.of_halfedge(h)]; }

  Front_parts m_parts;
  std::vector<Index> m_place; // per halfedge
  std::vector<Part> m_part = std::vector<Part>(1);
  std::vector<Arena> m_arenas = std::vector<Arena>(1);
  std::size_t m_peak = 0;
  std::size_t m_number_of_primitives = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
