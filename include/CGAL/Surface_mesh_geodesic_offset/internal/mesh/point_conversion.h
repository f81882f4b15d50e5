// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversion of points in space and of locations to the kernel of the traits.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_POINT_CONVERSION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_POINT_CONVERSION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/NT_converter.h>

#include <array>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL::Geodesic_offset::internal {

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

// The location with coordinates of type FT; the given object if it has these already.
template <class FT, class Face, class Coordinate>
decltype(auto) converted_location(const std::pair<Face, std::array<Coordinate, 3>>& l)
{
  if constexpr (std::is_same<FT, Coordinate>::value) return (l);
  else
  {
    const CGAL::NT_converter<Coordinate, FT> convert{};
    return std::pair<Face, std::array<FT, 3>>(l.first, {convert(l.second[0]), convert(l.second[1]), convert(l.second[2])});
  }
}

// The message for a point in space where a location is needed.
#define CGAL_GEODESIC_OFFSET_NEEDS_LOCATION                                                                                    \
  "Surface_mesh_geodesic_offset: a point in space is no location on the surface; locate() finds the nearest location"

// True for points of any kernel: types with x() and z().
template <class T, class = void>
constexpr bool is_point_in_space = false;
template <class T>
constexpr bool is_point_in_space<T, std::void_t<decltype(std::declval<const T&>().x(), std::declval<const T&>().z())>> = true;

// True for a range of points in space, and for a range of such ranges.
template <class T, class = void>
constexpr bool has_points_in_space = false;
template <class T>
constexpr bool has_points_in_space<T, std::void_t<decltype(*std::begin(std::declval<const T&>()))>> =
  is_point_in_space<std::decay_t<decltype(*std::begin(std::declval<const T&>()))>> ||
  (!std::is_same<std::decay_t<decltype(*std::begin(std::declval<const T&>()))>, T>::value &&
   has_points_in_space<std::decay_t<decltype(*std::begin(std::declval<const T&>()))>>);

} // namespace CGAL::Geodesic_offset::internal

#endif
