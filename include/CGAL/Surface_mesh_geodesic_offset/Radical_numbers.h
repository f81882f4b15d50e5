// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_RADICAL_NUMBERS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_RADICAL_NUMBERS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/core_definitions.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Computation_number.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>

#include <CGAL/Radical_number.h>

#include <CGAL/CORE_Expr.h>

#include <cstddef>
#include <utility>

// Include this header to compute with a kernel that has exact square roots, such as
// Exact_predicates_exact_constructions_kernel_with_sqrt. Internal computations use Radical_number, whose comparisons
// are fast also for equal numbers; results are numbers of the kernel.

namespace CGAL::Geodesic_offset::internal {

template <>
struct Computation_number<CORE::Expr>
{
  typedef Radical_number type;
};

template <>
struct Number_conversion<CORE::Expr, Radical_number>
{
  static CORE::Expr convert(const Radical_number& x) { return x.core_expression(); }
};

template <>
inline std::pair<double, double> bounds_of(const Radical_number& x)
{
  return x.bounds();
}

template <>
inline Uncertain<Comparison_result> compare_bounds(const Radical_number& a, const Radical_number& b)
{
  return a.compare_by_intervals(b);
}

template <>
struct Sign_decisions<Radical_number>
{
  static std::size_t all() { return Radical_number::number_of_decisions(); }
  static std::size_t exact() { return Radical_number::number_of_exact_decisions(); }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
