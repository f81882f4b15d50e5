// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether the arithmetic of double is that on which Double_double.h is based.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_DOUBLE_ARITHMETIC_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_DOUBLE_ARITHMETIC_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Double_double.h>

#include <cfenv>
#include <cfloat>

// Excess precision: 0 is none; -1 is indeterminate, as with -mfpmath=both.
#if FLT_EVAL_METHOD != 0
#define CGAL_GEODESIC_OFFSET_EXCESS_PRECISION
#endif
// Reordered sums, quotients via reciprocals, and missing infinities, which denote unreachable vertices
#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||          \
  (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#define CGAL_GEODESIC_OFFSET_FAST_MATH
#endif

namespace CGAL::Geodesic_offset::internal {

inline bool rounds_to_nearest() { return std::fegetround() == FE_TONEAREST; }

// Run-time check of sums, products and quotients, for compilers that do not reveal their options.
inline bool rounds_correctly()
{
  // volatile: unknown to the compiler
  volatile const double one = 1, tiny = 0x1p-60, more = 1 + 0x1p-30, less = -(1 + 0x1p-29), divisor = 49;
  const Double_double sum = two_sum(double(one), double(tiny));
  // more^2 + less = 2^-60; with a fused multiplication and addition the result is twice as large
  const double factor = more;
  const Double_double product = two_product(factor, factor) + Double_double(double(less));
  // the quotients 1/49, 3/49 and 49/49 share a divisor; computed via its reciprocal, the last one is less than 1
  const double d = divisor, quotients[3] = {one / d, (one + one + one) / d, divisor / d};
  volatile const double third = quotients[2], first = quotients[0], second = quotients[1];
  return sum.high == 1 && sum.low == 0x1p-60 && product.high == 0x1p-60 && product.low == 0 && third == 1 && first == 1. / 49 &&
         second == 3. / 49;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
