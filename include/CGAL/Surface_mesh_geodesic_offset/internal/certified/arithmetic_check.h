// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks of the arithmetic that the error analysis of certified bounds assumes: at compile time as far as macros reveal it,
// otherwise when bounds are computed.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_ARITHMETIC_CHECK_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_ARITHMETIC_CHECK_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/double_arithmetic.h>

#include <limits>
#include <stdexcept>

#ifdef CGAL_GEODESIC_OFFSET_EXCESS_PRECISION
#error "Surface_mesh_geodesic_enclosure: every operation must round to double (FLT_EVAL_METHOD is not 0)"
#endif
#ifdef CGAL_GEODESIC_OFFSET_FAST_MATH
#error "Surface_mesh_geodesic_enclosure: every operation must round as IEEE 754 says (no -ffast-math, nor parts of it)"
#endif

namespace CGAL::Geodesic_offset::internal {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53,
              "Surface_mesh_geodesic_enclosure: double must be the 64-bit type of IEEE 754");

inline void check_rounding_mode()
{
  if (!rounds_to_nearest()) throw std::logic_error("Surface_mesh_geodesic_enclosure: the rounding mode must be to nearest");
}

inline void check_arithmetic()
{
  if (!rounds_correctly())
    throw std::logic_error("Surface_mesh_geodesic_enclosure: the compiler has rearranged floating point operations");
}

} // namespace CGAL::Geodesic_offset::internal

#endif
