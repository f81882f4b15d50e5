// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks of the tolerance of functions that replace arcs by chords, and of the spacing of points.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_CHORD_TOLERANCE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_CHORD_TOLERANCE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL::Geodesic_offset::internal {

// The default, as a part of the diagonal of a bounding box: not visible in pictures of the whole.
constexpr double default_chord_tolerance = 1e-4;

// Least angle of a chord, in radians. The height of the arc over this chord is 1.25e-15 = 11 u of the radius, for the rounding
// unit u; points of the arc are rotated about its center with errors of this order.
constexpr double least_chord_angle = 1e-7;

// Largest number of chords of a curve for a polyline. Candidates of Curve_thinning need 200 bytes per chord: 4 GB.
constexpr std::size_t most_chords_of_curve = 20000000;

template <class FT>
void check_chord_tolerance(const FT& tolerance)
{
  if (!(tolerance > FT(0))) throw std::invalid_argument("Surface_mesh_geodesic_offset: a chord tolerance must be positive");
}

template <class FT>
void check_point_spacing(const FT& spacing)
{
  if (!(spacing > FT(0))) throw std::invalid_argument("Surface_mesh_geodesic_offset: a spacing of points must be positive");
}

template <class Curve>
std::size_t number_of_chords(const Curve& curve, const typename Curve::FT& tolerance)
{
  std::size_t chords = 0;
  for (const auto& piece : curve.pieces()) chords += piece.number_of_chords(tolerance);
  return chords;
}

template <class Curve>
void check_number_of_chords(const Curve& curve, const typename Curve::FT& tolerance)
{
  check_chord_tolerance(tolerance);
  if (number_of_chords(curve, tolerance) > most_chords_of_curve)
    throw std::length_error("Surface_mesh_geodesic_offset: a curve has more than " + std::to_string(most_chords_of_curve) +
                            " chords within the chord tolerance");
}

// Number of equal parts of a curve, each of at most the given length; three at least if the curve is closed.
template <class Curve>
std::size_t number_of_parts(const Curve& curve, const typename Curve::FT& spacing)
{
  check_point_spacing(spacing);
  // a length that is a multiple of the spacing up to rounding is divided into as many parts
  const double parts = std::ceil(CGAL::to_double(curve.length()) / CGAL::to_double(spacing) * (1 - 1e-12));
  if (parts > double(most_chords_of_curve))
    throw std::length_error("Surface_mesh_geodesic_offset: a curve has more than " + std::to_string(most_chords_of_curve) +
                            " points at the spacing");
  return (std::max)(std::size_t(parts), std::size_t(curve.is_closed() ? 3 : 1));
}

} // namespace CGAL::Geodesic_offset::internal

#endif
