// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks of the arithmetic that the error analysis of certified bounds assumes: at compile time as far as macros reveal it,
// otherwise when bounds are computed.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_ARITHMETIC_CHECK_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_ARITHMETIC_CHECK_H

#include <cfloat>

// Excess precision: 0 is none; -1 is indeterminate, as with -mfpmath=both.
#if FLT_EVAL_METHOD != 0
#error "Surface_mesh_geodesic_enclosure: every operation must round to double (FLT_EVAL_METHOD is not 0)"
#endif
// Reordered sums, quotients via reciprocals, and missing infinities, which denote unreachable vertices
#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||              \
  (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "Surface_mesh_geodesic_enclosure: every operation must round as IEEE 754 says (no -ffast-math, nor parts of it)"
#endif

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Double_double.h>

#include <cfenv>
#include <limits>
#include <stdexcept>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53,
              "Surface_mesh_geodesic_enclosure: double must be the 64-bit type of IEEE 754");

inline void check_rounding_mode()
{
  if (std::fegetround() != FE_TONEAREST)
    throw std::logic_error("Surface_mesh_geodesic_enclosure: the rounding mode must be to nearest");
}

// Run-time check of sums, products and quotients, for compilers that do not reveal their options.
inline void check_arithmetic()
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
  const bool is_right = sum.high == 1 && sum.low == 0x1p-60 && product.high == 0x1p-60 && product.low == 0 && third == 1 &&
                        first == 1. / 49 && second == 3. / 49;
  if (!is_right)
    throw std::logic_error("Surface_mesh_geodesic_enclosure: the compiler has rearranged floating point operations");
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
