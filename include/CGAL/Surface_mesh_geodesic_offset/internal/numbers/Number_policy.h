// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Properties of a number type beyond its arithmetic.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_NUMBER_POLICY_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_NUMBER_POLICY_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#define CGAL_GEODESIC_OFFSET_HAS_SSE2
#endif

namespace CGAL::Geodesic_offset::internal {

typedef std::uint32_t Index;
constexpr Index no_index = 0xffffffffu;

// Distances need square roots.
template <class FT>
constexpr bool has_square_roots()
{
  return std::is_convertible<typename CGAL::Algebraic_structure_traits<FT>::Algebraic_category*,
                             CGAL::Field_with_sqrt_tag*>::value;
}

// Unit in the last place of 1, for number types without numeric_limits: CGAL::Gmpfr and similar types of run-time
// precision.
template <class FT>
struct Unit_roundoff
{
  FT operator()() const
  {
    FT unit(1);
    for (auto bits = FT::get_default_precision(); bits > 1; --bits) unit = unit / FT(2);
    return unit;
  }
};

// Rounding allowances are zero for exact number types.
template <class FT>
struct Number_policy
{
  static constexpr bool is_inexact =
    std::is_same<typename CGAL::Algebraic_structure_traits<FT>::Is_exact, CGAL::Tag_false>::value;

  // Exceeds every distance on a mesh.
  static FT infinity()
  {
    if constexpr (std::numeric_limits<FT>::has_infinity) return std::numeric_limits<FT>::infinity();
    else return FT(1e300);
  }

  static bool is_finite(const FT& x) { return x < infinity(); }

  // Relative rounding allowance of `factor` units in the last place.
  static FT rounding(double factor)
  {
    if constexpr (!is_inexact) return FT(0);
    else if constexpr (std::numeric_limits<FT>::is_specialized) return FT(factor) * std::numeric_limits<FT>::epsilon();
    else return FT(factor) * Unit_roundoff<FT>()();
  }

  // The square root of rounding(1).
  static double root_of_rounding()
  {
    if constexpr (std::is_same<FT, double>::value) return 0x1p-26;
    else
    {
      static const double root = std::sqrt(CGAL::to_double(rounding(1)));
      return root;
    }
  }
};

// Process-wide number of sign decisions, and of those that intervals did not make, for number types that count them.
template <class FT>
struct Sign_decisions
{
  static std::size_t all() { return 0; }
  static std::size_t exact() { return 0; }
};

template <class FT>
inline FT square_root(const FT& x)
{
  return CGAL::is_positive(x) ? FT(CGAL::sqrt(x)) : FT(0);
}

#ifdef CGAL_GEODESIC_OFFSET_HAS_SSE2
// Version without branches and without the library call for error reports.
template <>
inline double square_root<double>(const double& x)
{
  const __m128d y = _mm_max_sd(_mm_set_sd(x), _mm_setzero_pd());
  return _mm_cvtsd_f64(_mm_sqrt_sd(y, y));
}
#endif

} // namespace CGAL::Geodesic_offset::internal

#endif
