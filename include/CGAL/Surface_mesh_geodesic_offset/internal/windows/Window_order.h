// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order of the windows of one halfedge in the sweep: by their begin.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_ORDER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_ORDER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT, class Window>
class Window_order
{
public:
  static bool begins_before(const Window& a, const Window& b) { return key(a) < key(b); }

  // Starts with the windows [first, last), then [more, more_last). Windows with equal begin keep their order.
  void start(const Window* first, const Window* last, const Window* more, const Window* more_last)
  {
    m_later.clear();
    m_size = std::size_t(last - first) + std::size_t(more_last - more);
    if (m_order.size() < m_size) m_order.resize(2 * m_size);
    const Window** end = m_order.data();
    int runs = Interval_filter<FT>::leaves_open ? most_runs : 0;
    const auto comes_before = [](const Window* a, const Window* b) { return begins_before(*a, *b); };
    if (!(merge_runs(first, last, end, runs) && merge_runs(more, more_last, end, runs)))
    {
      end = m_order.data();
      while (first != last) *end++ = first++;
      while (more != more_last) *end++ = more++;
      std::stable_sort(m_order.data(), end, comes_before);
    }
    CGAL_postcondition(end == m_order.data() + m_size);
    CGAL_postcondition(std::is_sorted(m_order.data(), m_order.data() + m_size, comes_before));
  }

  const Window* const* begin() const { return m_order.data(); }
  const Window* const* end() const { return m_order.data() + m_size; }

  // Adds a rest of a window, to be swept later: before those that begin at the same place. There are seldom more than two.
  void push_later(const Window& w)
  {
    m_later.push_back({w, m_pushed++});
    std::push_heap(m_later.begin(), m_later.end(), comes_after);
  }

  bool has_later() const { return !m_later.empty(); }
  bool has_later_before(const Window& w) const { return !m_later.empty() && begins_before(m_later.front().window, w); }
  const Window& first_later() const
  {
    CGAL_precondition(has_later());
    return m_later.front().window;
  }

  Window pop_later()
  {
    CGAL_precondition(has_later());
    std::pop_heap(m_later.begin(), m_later.end(), comes_after);
    const Window w = m_later.back().window;
    m_later.pop_back();
    return w;
  }

private:
  struct Later
  {
    Window window;
    std::size_t number; // in the order of push_later()
  };
  static bool comes_after(const Later& a, const Later& b)
  {
    return begins_before(b.window, a.window) || (a.number < b.number && !begins_before(a.window, b.window));
  }

  static decltype(auto) key(const Window& w) { return Interval_filter<FT>::key(w.b0); }

  // Merges sorted runs. Children of a batch are sorted, so there are mostly one or two runs; trimming may move a few windows.
  // Returns false if there are too many runs.
  bool merge_runs(const Window* first, const Window* last, const Window**& end, int& runs) const
  {
    for (; first != last; ++runs)
    {
      if (runs == most_runs) return false;
      if (end == m_order.data() || !(first->b0 < end[-1]->b0))
      {
        do *end++ = first++;
        while (first != last && !(first->b0 < first[-1].b0));
        continue;
      }
      const Window* const run = run_end(first, last);
      end = merge(end, first, run);
      first = run;
    }
    return true;
  }

  // Merges a run into the sorted ones, from the back.
  const Window** merge(const Window** end, const Window* first, const Window* last) const
  {
    const Window* const* const begin = m_order.data();
    const Window** const new_end = end + (last - first);
    const Window** out = new_end;
    while (first != last)
    {
      const FT& b = last[-1].b0;
      while (end != begin && b < end[-1]->b0) *--out = *--end;
      *--out = --last;
    }
    return new_end;
  }

  static const Window* run_end(const Window* first, const Window* last)
  {
    if (first == last) return last;
    while (++first != last)
      if (first->b0 < first[-1].b0) break;
    return first;
  }

  enum { most_runs = 8 };
  std::vector<const Window*> m_order;
  std::size_t m_size = 0;
  std::vector<Later> m_later; // a heap
  std::size_t m_pushed = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
