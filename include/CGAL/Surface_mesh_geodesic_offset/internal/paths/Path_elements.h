// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Output of a path: the elements that it meets, in order; and an output that ignores the path.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_ELEMENTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_ELEMENTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_suffix_cache.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>

namespace CGAL::Geodesic_offset::internal {

// Crossings of a straight part of a path, in order.
template <class FT>
struct Passed_crossings : boost::container::small_vector<Path_crossing<FT>, 128>
{
  static const Path_crossing<FT>& item(const Path_crossing<FT>& c) { return c; }
  void set_apart(std::size_t) {}
};

// Appends the elements of a path after its start to a vector: each vertex, the source point at the end, and the crossing of each
// crossed edge.
template <class FT>
class Path_elements
{
public:
  typedef Path_crossing<FT> Item;

  explicit Path_elements(std::vector<Path_element<FT>>& out) : m_out(out) {}

  template <class P>
  void start(const P&)
  {
  }
  // Receives the crossings of a straight part, which is complete with its end.
  Passed_crossings<FT>& passed() { return m_passed; }
  void end_part(const Suffix_end<FT>&) {}
  // Appends the items of a straight part.
  void append(const Item* q, const Item* last, const Suffix_end<FT>& end)
  {
    for (; q != last; ++q)
      if (q->halfedge != no_index) m_out.push_back(*q);
      else m_out.push_back(Surface_point<FT>::at_vertex(q->source));
    m_out.push_back(end.point);
  }

private:
  std::vector<Path_element<FT>>& m_out;
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
  void end_part(const Suffix_end<FT>&) {}
  void append(const Item*, const Item*, const Suffix_end<FT>&) {}

private:
  Passed_crossings<FT> m_passed;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
