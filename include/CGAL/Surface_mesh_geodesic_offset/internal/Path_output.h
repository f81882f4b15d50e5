// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a path is handed out as: what it meets, one after the other, or points in space. Its legs are remembered as that.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATH_OUTPUT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATH_OUTPUT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Path_legs.h>

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

// Calls out(p), p a surface point or a located one, where the path starts as told; out(surface point) for each vertex that
// it passes, and where a leg ends; out(crossing) for each edge that it crosses.
template <class FT, class Function>
class Path_elements
{
public:
  typedef Path_crossing<FT> Item;

  explicit Path_elements(Function& out) : m_out(out) {}

  template <class P>
  void start(const P& p)
  {
    m_out(p);
  }

  // The items of a leg.
  template <class Passed>
  const Passed& items(const Passed& passed, const Leg_end<FT>&)
  {
    return passed;
  }

  void append(const Item* q, const Item* last, const Leg_end<FT>& end)
  {
    for (; q != last; ++q)
      if (q->halfedge != no_index) m_out(*q);
      else m_out(Surface_point<FT>::at_vertex(q->source));
    m_out(end.point);
  }

  // The same from what a leg that is not to be kept has passed.
  template <class Passed>
  void append(const Passed& passed, const Leg_end<FT>& end)
  {
    append(passed.data(), passed.data() + passed.size(), end);
  }

private:
  Function& m_out;
};

// The vector that an output iterator appends to, if it does; else null.
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

// Points in space, the end of each leg among the items.
template <class Surface, class OutputIterator>
class Path_points
{
public:
  typedef typename Surface::Number FT;
  typedef typename Surface::Point_3 Item;

  Path_points(const Surface& surface, OutputIterator out) : m_surface(surface), m_out(out) {}

  template <class P>
  void start(const P& p)
  {
    const Item q = m_surface.point(p); // appending what has a name to a vector is not a call
    *m_out++ = q;
  }

  template <class Passed>
  const auto& items(const Passed& passed, const Leg_end<FT>& end)
  {
    m_items.resize(passed.size() + 1, boost::container::default_init);
    write(passed, end, m_items.data());
    return m_items;
  }

  void append(const Item* q, const Item* last, const Leg_end<FT>&)
  {
    if constexpr (is_vector) std::copy(q, last, room_for(std::size_t(last - q)));
    else
      for (; q != last; ++q) *m_out++ = *q; // an output iterator that calls a lambda can't be assigned
  }

  // The same from what a leg that is not to be kept has passed.
  template <class Passed>
  void append(const Passed& passed, const Leg_end<FT>& end)
  {
    if constexpr (is_vector) write(passed, end, room_for(passed.size() + 1));
    else write(passed, end, m_out);
  }

  const OutputIterator& out() const { return m_out; }

private:
  static constexpr bool is_vector =
    !std::is_same<decltype(vector_behind<Item>(std::declval<const OutputIterator&>())), std::nullptr_t>::value;

  // At the end of the vector: to fill it at once is faster than to append one by one.
  Item* room_for(std::size_t n)
  {
    auto& items = *vector_behind<Item>(m_out);
    const std::size_t size = items.size();
    items.resize(size + n);
    return items.data() + size;
  }

  template <class Passed, class Iterator>
  void write(const Passed& passed, const Leg_end<FT>& end, Iterator&& out)
  {
    for (const Path_crossing<FT>& p : passed) *out++ = m_surface.point(p);
    *out++ = m_surface.point(end.point);
  }

  const Surface& m_surface;
  OutputIterator m_out;
  boost::container::small_vector<Item, 128> m_items;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
