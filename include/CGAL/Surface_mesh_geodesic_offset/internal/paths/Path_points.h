// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Output of a path: its points in space. The cache of suffixes has points, too.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_POINTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_POINTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Points_in_space.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_suffix_cache.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Crossings as points in space, computed at once while the processor would wait for the next step of the walk.
template <class Kernel>
struct Passed_points : boost::container::small_vector<typename Kernel::Point_3, 128>
{
  explicit Passed_points(const Points_in_space<Kernel>& s) : space(s) {}

  // The first n points are known to be distinct, as a Strip_walk keeps away from vertices.
  void set_apart(std::size_t n) { m_apart = n; }

  void remove_repeated()
  {
    const auto first = this->begin() + std::ptrdiff_t(m_apart == 0 ? 0 : (std::min)(m_apart, this->size()) - 1);
    this->erase(std::unique(first, this->end()), this->end());
  }

  typename Kernel::Point_3 item(const Path_crossing<typename Kernel::FT>& c) const { return space.point(c); }

  const Points_in_space<Kernel>& space;

private:
  std::size_t m_apart = 0;
};

// Appends the points in space, including the end of each straight part, to a vector. Consecutive points equal up to rounding
// become one.
template <class Kernel>
class Path_points
{
public:
  typedef typename Kernel::FT FT;
  typedef typename Kernel::Point_3 Item;

  Path_points(const Points_in_space<Kernel>& space, std::vector<Item>& out) : m_space(space), m_out(out), m_passed(space) {}

  template <class P>
  void start(const P& p)
  {
    m_last = m_space.point(p);
    m_out.push_back(m_last);
  }
  Passed_points<Kernel>& passed() { return m_passed; }
  void end_part(const Suffix_end<FT>& end)
  {
    m_passed.push_back(m_space.point(end.point));
    m_passed.remove_repeated();
  }
  void append(const Item* q, const Item* last, const Suffix_end<FT>&)
  {
    if (q != last && *q == m_last) ++q;
    if (q == last) return;
    m_last = *(last - 1);
    m_out.insert(m_out.end(), q, last);
  }

private:
  const Points_in_space<Kernel>& m_space;
  std::vector<Item>& m_out;
  Item m_last; // last written item
  Passed_points<Kernel> m_passed;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
