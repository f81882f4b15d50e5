// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversion of integers and rationals to and from CORE, whose own numbers CGAL 6 replaced by those of Boost.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_CORE_NUMBERS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_CORE_NUMBERS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_sum.h>

#include <CGAL/CORE_Expr.h>

#include <type_traits>

namespace CGAL::Geodesic_offset::internal {

// Core_number is CORE::BigInt for an integer of Boost, CORE::BigRat for a rational.
template <class Core_number, class Number>
CORE::Expr core_expression(const Number& n)
{
  if constexpr (std::is_constructible<Core_number, const Number&>::value) return CORE::Expr(Core_number(n));
  else return CORE::Expr(Core_number(n.backend().data()));
}

// Core_rational is CORE::BigRat.
template <class Core_rational>
Big_rational rational_of_core(const Core_rational& q)
{
  if constexpr (std::is_constructible<Big_rational, const Core_rational&>::value) return Big_rational(q);
  else
  {
    Big_rational r;
    mpq_set(r.backend().data(), q.get_mp());
    return r;
  }
}

} // namespace CGAL::Geodesic_offset::internal

#endif
