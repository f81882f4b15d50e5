// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounding boxes in the frame of a face, and a tree over a sequence of them. Boxes of consecutive windows are neighbours, as
// windows of one edge are ordered, so the tree needs no sorting. The boxes of exact numbers have bounds of type double, rounded
// outward, so no exact number is compared.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_BOX_IN_FACE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_BOX_IN_FACE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
struct Box_in_face
{
  typedef Interval_filter<FT> Estimates;
  typedef typename Estimates::Estimate Estimate;
  typedef Point_in_face<typename Estimates::Bound> Corner;

  Corner low, high;

  explicit Box_in_face(const Point_in_face<FT>& p) : Box_in_face(estimate(p.x), estimate(p.y)) {}
  Box_in_face(const Estimate& x, const Estimate& y)
    : low{Estimates::lower_bound(x), Estimates::lower_bound(y)}, high{Estimates::upper_bound(x), Estimates::upper_bound(y)}
  {
  }

  void add(const Point_in_face<FT>& p) { add(Box_in_face(p)); }
  void add(const Box_in_face& o)
  {
    low = {(std::min)(low.x, o.low.x), (std::min)(low.y, o.low.y)};
    high = {(std::max)(high.x, o.high.x), (std::max)(high.y, o.high.y)};
  }
  void widen(const FT& d)
  {
    const Estimate e = estimate(d);
    low = {Estimates::lower_bound(low.x - e), Estimates::lower_bound(low.y - e)};
    high = {Estimates::upper_bound(high.x + e), Estimates::upper_bound(high.y + e)};
  }
  void intersect(const Box_in_face& o)
  {
    low = {(std::max)(low.x, o.low.x), (std::max)(low.y, o.low.y)};
    high = {(std::min)(high.x, o.high.x), (std::min)(high.y, o.high.y)};
  }
  bool is_empty() const { return high.x < low.x || high.y < low.y; }
  bool meets(const Box_in_face& o) const
  {
    return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y;
  }
};

template <class FT>
class Box_tree
{
public:
  typedef Box_in_face<FT> Box;

  // Call build() after the last box.
  void clear() { m_boxes.clear(); }
  void push_back(const Box& b) { m_boxes.push_back(b); }
  // Keeps the first n boxes, for other ones behind them.
  void pop_tree(std::size_t n) { m_boxes.erase(m_boxes.begin() + std::ptrdiff_t(n), m_boxes.end()); }

  void build()
  {
    m_levels.clear();
    std::size_t first = 0, n = m_boxes.size();
    while (n > fan)
    {
      m_levels.push_back({first, n});
      const std::size_t next = m_boxes.size();
      for (std::size_t i = 0; i < n; i += fan)
      {
        Box b = m_boxes[first + i];
        for (std::size_t j = i + 1; j < (std::min)(i + fan, n); ++j) b.add(m_boxes[first + j]);
        m_boxes.push_back(b);
      }
      first = next;
      n = m_boxes.size() - next;
    }
    m_levels.push_back({first, n});
  }

  const Box& operator[](std::size_t i) const { return m_boxes[i]; }

  // Calls f(i) for the boxes that meet b, in order, until f returns true. Returns true if f did.
  template <class Function>
  bool any_of(const Box& b, const Function& f) const
  {
    return any_of(m_levels.size() - 1, 0, m_levels.back().second, b, f);
  }

private:
  static constexpr std::size_t fan = 8;

  template <class Function>
  bool any_of(std::size_t level, std::size_t begin, std::size_t end, const Box& b, const Function& f) const
  {
    const Box* const boxes = m_boxes.data() + m_levels[level].first;
    for (const Box *box = boxes + begin, *last = boxes + end; box != last; ++box)
    {
      if (!box->meets(b)) continue;
      const std::size_t i = std::size_t(box - boxes);
      if (level == 0 ? f(i) : any_of(level - 1, fan * i, (std::min)(fan * i + fan, m_levels[level - 1].second), b, f))
        return true;
    }
    return false;
  }

  std::vector<Box> m_boxes;                                  // the given boxes, then bounds of eight each, and so on
  std::vector<std::pair<std::size_t, std::size_t>> m_levels; // first index and number
};

} // namespace CGAL::Geodesic_offset::internal

#endif
