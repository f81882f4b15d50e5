// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_POLYLINE_CLOSING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_POLYLINE_CLOSING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {

/// \ingroup PkgSurfaceMeshGeodesicOffsetEnums
/// how the ends of a polyline in space meet.
enum class Polyline_closing : unsigned char {
  OPEN,          ///< the ends are apart, or there are at most three points
  NEARLY_CLOSED, ///< the ends are apart by at most 1e-4 of the length of the polyline: an open polyline, probably by mistake
  CLOSED         ///< the last point stands for the first one
};

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief is the rule by which all functions that read a polyline without the named parameter `is_closed` find whether it is closed.

A polyline of more than three points is closed if its ends are apart by at most 1e-9 of its length, which is well above the rounding
of coordinates with 15 digits, and far below what is drawn. It is nearly closed up to 1e-4, more than coordinates with 6 digits
need.

\tparam PointRange a model of `ConstRange` with 3D points as values
\param points the points
*/
template <class PointRange>
Polyline_closing polyline_closing(const PointRange& points)
{
  constexpr double closed = 1e-9, nearly_closed = 1e-4; // of the length
  typedef std::array<double, 3> Coordinates;
  const auto distance = [](const Coordinates& p, const Coordinates& q) {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  std::size_t number = 0;
  double length = 0;
  Coordinates first{}, last{};
  for (const auto& p : points)
  {
    const Coordinates c{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
    if (number++ == 0) first = c;
    else length += distance(last, c);
    last = c;
  }
  if (number <= 3) return Polyline_closing::OPEN;
  const double between = distance(first, last);
  if (between <= closed * length) return Polyline_closing::CLOSED;
  return between <= nearly_closed * length ? Polyline_closing::NEARLY_CLOSED : Polyline_closing::OPEN;
}

} // namespace CGAL

#endif
