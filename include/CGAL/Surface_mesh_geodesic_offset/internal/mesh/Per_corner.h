// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Three values of a face: one per corner or per halfedge.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_PER_CORNER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_PER_CORNER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>

namespace CGAL::Geodesic_offset::internal {

// std::array<T, 3>, the type of barycentric coordinates in the interface, with an index of any integer type: corners are
// numbered by `int`.
template <class T>
class Per_corner
{
public:
  Per_corner() = default;
  Per_corner(const T& a, const T& b, const T& c) : m_value{a, b, c} {}
  Per_corner(const std::array<T, 3>& a) : m_value{a[0], a[1], a[2]} {}
  operator std::array<T, 3>() const { return {m_value[0], m_value[1], m_value[2]}; }

  template <class I>
  T& operator[](I k)
  {
    CGAL_precondition(k == 0 || k == 1 || k == 2);
    return m_value[k];
  }
  template <class I>
  const T& operator[](I k) const
  {
    CGAL_precondition(k == 0 || k == 1 || k == 2);
    return m_value[k];
  }

  static constexpr std::size_t size() { return 3; }
  T* begin() { return m_value; }
  T* end() { return m_value + 3; }
  const T* begin() const { return m_value; }
  const T* end() const { return m_value + 3; }

private:
  T m_value[3];
};

} // namespace CGAL::Geodesic_offset::internal

#endif
