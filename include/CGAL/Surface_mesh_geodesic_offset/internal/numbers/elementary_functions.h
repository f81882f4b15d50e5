// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Functions of numbers beyond those of CGAL.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_ELEMENTARY_FUNCTIONS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_ELEMENTARY_FUNCTIONS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <type_traits>

namespace CGAL::Geodesic_offset::internal {

// A number of another type, rounded to double if the types differ.
template <class To, class From>
To number_cast(const From& x)
{
  if constexpr (std::is_same<To, From>::value) return x;
  else return To(CGAL::to_double(x));
}

template <class NT>
bool is_finite(const NT& x)
{
  return std::isfinite(CGAL::to_double(x));
}

// Without overflow in double
template <class NT>
NT hypotenuse(const NT& x, const NT& y)
{
  if constexpr (std::is_same<NT, double>::value) return std::hypot(x, y);
  else return square_root<NT>(x * x + y * y);
}

template <class NT>
NT hypotenuse(const NT& x, const NT& y, const NT& z)
{
  if constexpr (std::is_same<NT, double>::value) return std::hypot(x, y, z);
  else return square_root<NT>(x * x + y * y + z * z);
}

// A number that grows with the angle of the direction (x, y) from -pi to pi.
template <class NT>
NT order_of_angle(const NT& x, const NT& y)
{
  const NT size = CGAL::abs(x) + CGAL::abs(y);
  if (!CGAL::is_positive(size)) return NT(0);
  const NT height = y / size;
  if (!CGAL::is_negative(x)) return height;
  return CGAL::is_negative(y) ? NT(-2) - height : NT(2) - height;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
