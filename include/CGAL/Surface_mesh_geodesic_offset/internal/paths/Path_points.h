// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Output of a path: its points in space. The cache of suffixes has points, too.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_POINTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_POINTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_suffix_cache.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Crossings as points in space, computed at once while the processor would wait for the next step of the walk.
template <class Surface>
struct Passed_points : boost::container::small_vector<typename Surface::Point_3, 128>
{
  explicit Passed_points(const Surface& s) : surface(s) {}

  // The first n points are known to be distinct, as a Strip_walk keeps away from vertices.
  void set_apart(std::size_t n) { m_apart = n; }

  void remove_repeated()
  {
    const auto first = this->begin() + std::ptrdiff_t(m_apart == 0 ? 0 : (std::min)(m_apart, this->size()) - 1);
    this->erase(std::unique(first, this->end()), this->end());
  }

  typename Surface::Point_3 item(const Path_crossing<typename Surface::Number>& c) const { return surface.point(c); }

  const Surface& surface;

private:
  std::size_t m_apart = 0;
};

// The vector of a back inserter; null for other output iterators.
template <class Item, class OutputIterator>
inline std::nullptr_t vector_behind(const OutputIterator&)
{
  return nullptr;
}

template <class Item, class Allocator>
inline std::vector<Item, Allocator>* vector_behind(const std::back_insert_iterator<std::vector<Item, Allocator>>& out)
{
  typedef std::back_insert_iterator<std::vector<Item, Allocator>> Iterator;
  struct Opened : Iterator
  {
    static std::vector<Item, Allocator>* container_of(const Iterator& i) { return i.*(&Opened::container); }
  };
  return Opened::container_of(out);
}

// Points in space, including the end of each straight part. Consecutive points equal up to rounding become one.
template <class Surface, class OutputIterator>
class Path_points
{
public:
  typedef typename Surface::Number FT;
  typedef typename Surface::Point_3 Item;

  Path_points(const Surface& surface, OutputIterator out) : m_surface(surface), m_out(out), m_passed(surface) {}

  template <class P>
  void start(const P& p)
  {
    m_last = m_surface.point(p);
    *m_out++ = m_last;
  }

  Passed_points<Surface>& passed() { return m_passed; }
  void end_part(const Suffix_end<FT>& end)
  {
    m_passed.push_back(m_surface.point(end.point));
    m_passed.remove_repeated();
  }

  void append(const Item* q, const Item* last, const Suffix_end<FT>&)
  {
    if (q != last && *q == m_last) ++q;
    if (q == last) return;
    m_last = *(last - 1);
    if constexpr (is_vector) std::copy(q, last, room_for(std::size_t(last - q)));
    else
      for (; q != last; ++q) *m_out++ = *q; // an output iterator that calls a lambda is not assignable
  }

  const OutputIterator& out() const { return m_out; }

private:
  static constexpr bool is_vector =
    !std::is_same<decltype(vector_behind<Item>(std::declval<const OutputIterator&>())), std::nullptr_t>::value;

  // Space at the end of the vector; filling it at once is faster than appending one by one.
  Item* room_for(std::size_t n)
  {
    auto& items = *vector_behind<Item>(m_out);
    const std::size_t size = items.size();
    items.resize(size + n);
    return items.data() + size;
  }

  const Surface& m_surface;
  OutputIterator m_out;
  Item m_last; // last written item
  Passed_points<Surface> m_passed;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
