// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outputs of paths: the elements that a path meets in order, or points in space. Suffixes are cached in the form of the output.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_OUTPUT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_OUTPUT_H

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

// Crossings of a straight part of a path, in order.
template <class FT>
struct Passed_crossings : boost::container::small_vector<Path_crossing<FT>, 128>
{
  static const Path_crossing<FT>& item(const Path_crossing<FT>& c) { return c; }
  void set_apart(std::size_t) {}
};

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

// Calls out(p) for the start p of the path, a surface point or a located point; out(surface point) for each vertex and for the
// source point at the end; out(crossing) for each crossed edge.
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

  // Receives the crossings of a straight part, which is complete with its end.
  Passed_crossings<FT>& passed() { return m_passed; }
  void end_leg(const Suffix_end<FT>&) {}

  // Appends the items of a straight part.
  void append(const Item* q, const Item* last, const Suffix_end<FT>& end)
  {
    for (; q != last; ++q)
      if (q->halfedge != no_index) m_out(*q);
      else m_out(Surface_point<FT>::at_vertex(q->source));
    m_out(end.point);
  }

private:
  Function& m_out;
  Passed_crossings<FT> m_passed;
};

// Ignores the path, if only its end is wanted.
template <class FT>
class No_path_output
{
public:
  typedef Path_crossing<FT> Item;

  template <class P>
  void start(const P&)
  {
  }
  Passed_crossings<FT>& passed() { return m_passed; }
  void end_leg(const Suffix_end<FT>&) {}
  void append(const Item*, const Item*, const Suffix_end<FT>&) {}

private:
  Passed_crossings<FT> m_passed;
};

// Passes the elements of a path to a visitor in the form of Surface_mesh_shortest_path.
template <class Surface, class Visitor>
class Path_visits
{
public:
  typedef typename Surface::Number FT;

  Path_visits(const Surface& surface, Visitor& visitor) : m_surface(surface), m_visitor(visitor) {}

  void operator()(const Path_crossing<FT>& p) const { m_visitor(m_surface.halfedge_of(p.halfedge), Surface::exported(p.part)); }

  // P: a surface point or a located point.
  template <class P>
  void operator()(const P& p) const
  {
    if (p.kind == P::VERTEX) m_visitor(m_surface.vertex_of[p.element]);
    else if (p.kind == P::EDGE)
      m_visitor(m_surface.halfedge_of(p.element), Surface::exported(FT(p.x / m_surface.unfolded[p.element].length)));
    else
    {
      const auto location = m_surface.location(p);
      m_visitor(location.first, location.second);
    }
  }

private:
  const Surface& m_surface;
  Visitor& m_visitor;
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
  void end_leg(const Suffix_end<FT>& end)
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
