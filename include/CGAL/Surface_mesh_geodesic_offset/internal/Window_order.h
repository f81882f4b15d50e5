// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order in which the windows of one halfedge are swept: by where they begin.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOW_ORDER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOW_ORDER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Estimation.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT, class Window>
class Window_order
{
public:
  // The windows [first, taken) are sorted, those in [taken, last) are in any order.
  void start(const Window* first, const Window* taken, const Window* last)
  {
    m_later.clear();
    m_size = std::size_t(last - first);
    if (m_order.size() < m_size) m_order.resize(2 * m_size);
    sort(first, taken, last);
  }

  const Window* const* begin() const { return m_order.data(); }
  const Window* const* end() const { return m_order.data() + m_size; }

  // What is left of windows and waits for its turn, the first one at the back. Seldom more than two.
  void push_later(const Window& w)
  {
    auto it = m_later.end();
    while (it != m_later.begin() && key(*(it - 1)) < key(w)) --it;
    m_later.insert(it, w);
  }

  bool has_later() const { return !m_later.empty(); }
  bool has_later_before(const Window& w) const { return !m_later.empty() && key(m_later.back()) < key(w); }
  const Window& first_later() const { return m_later.back(); }

  Window pop_later()
  {
    const Window w = m_later.back();
    m_later.pop_back();
    return w;
  }

private:
  typedef typename Estimation<FT>::Key Key;

  static decltype(auto) key(const Window& w) { return Estimation<FT>::key(w.b0); }

  static bool comes_first(const Window* a, const Window* b)
  {
    const Key ka = key(*a), kb = key(*b);
    return ka < kb || (!(kb < ka) && a < b);
  }

  // Children of a batch come in order, so the list is mostly one run or two; trimming may have moved some of them.
  void sort(const Window* first, const Window* taken, const Window* last)
  {
    const Window* second = taken == first ? run_end(first, last) : taken;
    if (Estimation<FT>::leaves_open || (second != last && run_end(second, last) != last))
    {
      const Window** const order = m_order.data();
      for (std::size_t i = 0; i < m_size; ++i) order[i] = first + i;
      if (Estimation<FT>::leaves_open || m_size > 48)
        std::sort(order, order + m_size, comes_first);
      else
        insertion_sort(order, order + m_size);
      return;
    }
    const Window **out = m_order.data(), *i = first, *j = second;
    while (i != second && j != last)
    {
      const bool takes_second = j->b0 < i->b0; // without a branch, which could not be foreseen
      *out++ = takes_second ? j : i;
      j += takes_second;
      i += !takes_second;
    }
    while (i != second) *out++ = i++;
    while (j != last) *out++ = j++;
  }

  // For a short list of a few sorted runs.
  static void insertion_sort(const Window** first, const Window** last)
  {
    for (const Window** i = first + 1; i < last; ++i)
    {
      const Window* const w = *i;
      const Window** j = i;
      for (; j != first && w->b0 < j[-1]->b0; --j) *j = j[-1];
      *j = w;
    }
  }

  static const Window* run_end(const Window* first, const Window* last)
  {
    if (first == last) return last;
    while (++first != last)
      if (first->b0 < first[-1].b0) break;
    return first;
  }

  std::vector<const Window*> m_order;
  std::size_t m_size = 0;
  std::vector<Window> m_later;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
