// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversion of mesh points to the kernel of the traits.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_POINT_CONVERSION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_POINT_CONVERSION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/NT_converter.h>

#include <type_traits>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// P: any type with x(), y() and z(). Returns p itself if no conversion is needed.
template <class Point_3, class FT, class P>
decltype(auto) converted_point(const P& p)
{
  if constexpr (std::is_same<P, Point_3>::value) return (p);
  else
  {
    typedef std::decay_t<decltype(p.x())> From;
    const CGAL::NT_converter<From, FT> convert{};
    return Point_3(convert(p.x()), convert(p.y()), convert(p.z()));
  }
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
