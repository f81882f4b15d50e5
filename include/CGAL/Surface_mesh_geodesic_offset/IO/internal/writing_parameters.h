// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of the named parameters of the functions that write offset curves.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_WRITING_PARAMETERS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_WRITING_PARAMETERS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/Length_unit.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/chord_tolerance.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>

namespace CGAL::IO::Surface_mesh_geodesic_offset_internal {

// The default is relative to the box of the points between pieces, which has at least half the extent of the curves, since no
// piece exceeds a half turn.
template <class CurveRange>
double default_chord_tolerance(const CurveRange& curves)
{
  Bbox_3 box;
  for (const auto& curve : curves)
    for (std::size_t i = 0; i < curve.number_of_pieces(); ++i)
      box += bbox(coordinates(curve.point(curve.piece(i).start()))) + bbox(coordinates(curve.point(curve.piece(i).end())));
  const double size = std::hypot(box.x_span(), box.y_span(), box.z_span());
  return std::isfinite(size) && size > 0 ? Geodesic_offset::internal::default_chord_tolerance * size : 1;
}

// Without chord_tolerance().
template <class NamedParameters>
Point_options other_point_options(const NamedParameters& np)
{
  Point_options options;
  if constexpr (Geodesic_offset::internal::has_parameter<internal_np::geodesic_point_spacing_t, NamedParameters>)
    options.spacing = CGAL::to_double(parameters::get_parameter(np, internal_np::geodesic_point_spacing));
  options.has_smooth_normals =
    parameters::choose_parameter(parameters::get_parameter(np, internal_np::geodesic_smooth_normals), false);
  if constexpr (Geodesic_offset::internal::has_parameter<internal_np::geodesic_curve_nesting_t, NamedParameters>)
    for (const auto& place : parameters::get_parameter(np, internal_np::geodesic_curve_nesting))
      options.places.push_back({place.depth > 0 ? static_cast<long long>(place.parent) : -1,
                                place.inner_side == LEFT_TURN    ? 1
                                : place.inner_side == RIGHT_TURN ? 2
                                                                 : 0});
  return options;
}

// For functions that do not know the curves yet.
template <class NamedParameters>
Point_options required_point_options(const NamedParameters& np)
{
  namespace internal = Geodesic_offset::internal;
  internal::check_named_parameters<internal::Point_parameters, NamedParameters>();
  constexpr bool is_given = internal::has_parameter<internal_np::geodesic_chord_tolerance_t, NamedParameters>;
  static_assert(is_given, "Surface_mesh_geodesic_offset: this function needs the named parameter chord_tolerance()");
  Point_options options = other_point_options(np);
  if constexpr (is_given)
    options.chord_tolerance = CGAL::to_double(parameters::get_parameter(np, internal_np::geodesic_chord_tolerance));
  return options;
}

// Tags: the parameters that the caller reads.
template <class Tags, class CurveRange, class NamedParameters>
double chord_tolerance_of(const CurveRange& curves, const NamedParameters& np)
{
  Geodesic_offset::internal::check_named_parameters<Tags, NamedParameters>();
  if constexpr (Geodesic_offset::internal::has_parameter<internal_np::geodesic_chord_tolerance_t, NamedParameters>)
    return (void)curves, CGAL::to_double(parameters::get_parameter(np, internal_np::geodesic_chord_tolerance));
  else return (void)np, default_chord_tolerance(curves);
}

template <class Tags, class CurveRange, class NamedParameters>
Point_options point_options_of(const CurveRange& curves, const NamedParameters& np)
{
  Point_options options = other_point_options(np);
  options.chord_tolerance = chord_tolerance_of<Tags>(curves, np);
  return options;
}

template <class Tags = Geodesic_offset::internal::Unit_parameters, class NamedParameters>
Length_unit length_unit_of(const NamedParameters& np)
{
  Geodesic_offset::internal::check_named_parameters<Tags, NamedParameters>();
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::geodesic_length_unit), Length_unit::NONE);
}

} // namespace CGAL::IO::Surface_mesh_geodesic_offset_internal

#endif
