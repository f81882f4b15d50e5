// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the named parameters of a build.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_BUILD_PARAMETERS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_BUILD_PARAMETERS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Build_request.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Front_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL::Geodesic_offset::internal {

// Reads the named parameters; locate(target) is the location of a target on the surface.
// \throws std::invalid_argument if a number is out of range
template <class FT, class NamedParameters, class Locate>
Build_request<FT> read_build_request(const NamedParameters& np, const Locate& locate)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto require = [](bool condition, const char* what) {
    if (!condition) throw std::invalid_argument(std::string("Surface_mesh_geodesic_offset: ") + what);
  };
  Build_request<FT> r;
  r.maximum = FT(choose_parameter(get_parameter(np, internal_np::geodesic_distance_limit), Number_policy<FT>::infinity()));
  require(r.maximum >= FT(0), "the distance limit is negative or not a number");
  r.keeps_windows = choose_parameter(get_parameter(np, internal_np::geodesic_keep_windows), false);
  r.finds_farthest = choose_parameter(get_parameter(np, internal_np::geodesic_compute_largest_distance), false);
  typedef std::decay_t<decltype(get_parameter(np, internal_np::visitor))> Visitor;
  static_assert(std::is_same<Visitor, internal_np::Param_not_found>::value ||
                  std::is_invocable_r<bool, Visitor&, double>::value,
                "the visitor of a geodesic build must be a function object bool(double)");
  r.goes_on = choose_parameter(get_parameter(np, internal_np::visitor), std::function<bool(double)>());
  if constexpr (has_parameter<internal_np::geodesic_targets_t, NamedParameters>)
  {
    const auto targets = get_parameter(np, internal_np::geodesic_targets); // maybe a reference wrapper
    for (const auto& t : internal_np::get_reference(targets)) r.targets.push_back(locate(t));
  }
  r.tolerance.relative = FT(choose_parameter(get_parameter(np, internal_np::geodesic_relative_tolerance), FT(0)));
  r.tolerance.absolute = FT(choose_parameter(get_parameter(np, internal_np::geodesic_merging_tolerance), FT(0)));
  require(r.tolerance.relative >= FT(0) && r.tolerance.relative <= FT(0.5),
          "the relative tolerance is not a number from 0 to 0.5");
  require(r.tolerance.absolute >= FT(0) && Number_policy<FT>::is_finite(r.tolerance.absolute),
          "the merging tolerance is negative or not a finite number");
  require(Number_policy<FT>::is_inexact || r.tolerance.is_zero(), "a tolerance needs a floating point number type");
  return r;
}

// The parts that a propagation with these parameters may need, see Build_part.
template <class NamedParameters>
constexpr unsigned build_parts_of =
  (has_parameter<internal_np::geodesic_compute_largest_distance_t, NamedParameters> ? SEARCH : NO_PARTS) |
  (has_parameter<internal_np::geodesic_relative_tolerance_t, NamedParameters> ||
       has_parameter<internal_np::geodesic_merging_tolerance_t, NamedParameters>
     ? MERGING
     : NO_PARTS) |
  (has_parameter<internal_np::geodesic_keep_windows_t, NamedParameters> ? KEPT_WINDOWS : NO_PARTS);

} // namespace CGAL::Geodesic_offset::internal

#endif
