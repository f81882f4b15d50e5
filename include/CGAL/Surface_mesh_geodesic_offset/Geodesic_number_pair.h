// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_NUMBER_PAIR_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_NUMBER_PAIR_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetTraitsClasses

\brief holds two numbers for the same operation, such as the two ends of a window.

For pairs `a` and `b`, there are the operations `a + b`, `a - b`, `a * b`, `a / b`, `square_root(a)`, and the comparisons `a < b`
and `a <= b`, which return a `Test`; for tests, there is the conjunction `s & t`. Each operation gives for both numbers the result
of the operation on single numbers; the square root of a negative number is 0.

Two `double`s share a register of SSE2, which every x86-64 processor has.

\tparam FT a model of `FieldWithSqrt` and `RealEmbeddable`

\sa `SurfaceMeshGeodesicOffsetTraitsWithPairs`
*/
template <class FT>
class Geodesic_number_pair
{
public:
  /// the result of a comparison of both numbers; comparisons with NaN are `false`.
  class Test
  {
  public:
    /// two results.
    Test(bool first, bool second) : m_bits(unsigned(first) | unsigned(second) << 1) {}
    /// bit 0: the first result; bit 1: the second result.
    unsigned bits() const { return m_bits; }
    friend Test operator&(Test a, Test b) { return Test(a.m_bits & b.m_bits); }

  private:
    explicit Test(unsigned bits) : m_bits(bits) {}
    unsigned m_bits;
  };

  /// uninitialized, for a floating point type.
  Geodesic_number_pair() = default;
  /// the same number twice.
  explicit Geodesic_number_pair(const FT& both) : m_first(both), m_second(both) {}
  /// two numbers.
  Geodesic_number_pair(const FT& first, const FT& second) : m_first(first), m_second(second) {}

  /// loads two members of an object; the second must directly follow the first in memory.
  static Geodesic_number_pair of(const FT& first, const FT& second) { return Geodesic_number_pair(first, second); }
  /// stores the numbers in two members of an object; the second must directly follow the first in memory.
  void put(FT& first, FT& second) const
  {
    first = m_first;
    second = m_second;
  }

  /// the first number.
  FT first() const { return m_first; }
  /// the second number.
  FT second() const { return m_second; }
  /// the pair in reverse order.
  Geodesic_number_pair swapped() const { return Geodesic_number_pair(m_second, m_first); }
  /// the first number twice.
  Geodesic_number_pair both_first() const { return Geodesic_number_pair(m_first); }
  /// the second number twice.
  Geodesic_number_pair both_second() const { return Geodesic_number_pair(m_second); }
  /// the pair with the second number negated.
  Geodesic_number_pair with_second_negated() const { return Geodesic_number_pair(m_first, FT(-m_second)); }

  friend Geodesic_number_pair operator+(const Geodesic_number_pair& a, const Geodesic_number_pair& b)
  {
    return Geodesic_number_pair(FT(a.m_first + b.m_first), FT(a.m_second + b.m_second));
  }
  friend Geodesic_number_pair operator-(const Geodesic_number_pair& a, const Geodesic_number_pair& b)
  {
    return Geodesic_number_pair(FT(a.m_first - b.m_first), FT(a.m_second - b.m_second));
  }
  friend Geodesic_number_pair operator*(const Geodesic_number_pair& a, const Geodesic_number_pair& b)
  {
    return Geodesic_number_pair(FT(a.m_first * b.m_first), FT(a.m_second * b.m_second));
  }
  friend Geodesic_number_pair operator/(const Geodesic_number_pair& a, const Geodesic_number_pair& b)
  {
    return Geodesic_number_pair(FT(a.m_first / b.m_first), FT(a.m_second / b.m_second));
  }
  friend Test operator<(const Geodesic_number_pair& a, const Geodesic_number_pair& b)
  {
    return Test(a.m_first < b.m_first, a.m_second < b.m_second);
  }
  friend Test operator<=(const Geodesic_number_pair& a, const Geodesic_number_pair& b)
  {
    return Test(a.m_first <= b.m_first, a.m_second <= b.m_second);
  }
  friend Geodesic_number_pair square_root(const Geodesic_number_pair& a)
  {
    return Geodesic_number_pair(Geodesic_offset::internal::square_root<FT>(a.m_first),
                                Geodesic_offset::internal::square_root<FT>(a.m_second));
  }

private:
  FT m_first, m_second;
};

#if defined(CGAL_GEODESIC_OFFSET_HAS_SSE2) && !defined(DOXYGEN_RUNNING)
template <>
class Geodesic_number_pair<double>
{
public:
  class Test
  {
  public:
    Test(bool first, bool second) : m_lanes(_mm_castsi128_pd(_mm_set_epi64x(-(long long)second, -(long long)first))) {}
    explicit Test(__m128d lanes) : m_lanes(lanes) {}
    unsigned bits() const { return unsigned(_mm_movemask_pd(m_lanes)); }
    friend Test operator&(Test a, Test b) { return Test(_mm_and_pd(a.m_lanes, b.m_lanes)); }

  private:
    __m128d m_lanes;
  };

  Geodesic_number_pair() = default;
  explicit Geodesic_number_pair(double both) : m_lanes(_mm_set1_pd(both)) {}
  Geodesic_number_pair(double first, double second) : m_lanes(_mm_set_pd(second, first)) {}

  static Geodesic_number_pair of(const double& first, const double&) { return Geodesic_number_pair(_mm_loadu_pd(&first)); }
  void put(double& first, double&) const { _mm_storeu_pd(&first, m_lanes); }

  double first() const { return _mm_cvtsd_f64(m_lanes); }
  double second() const { return _mm_cvtsd_f64(_mm_unpackhi_pd(m_lanes, m_lanes)); }
  Geodesic_number_pair swapped() const { return Geodesic_number_pair(_mm_shuffle_pd(m_lanes, m_lanes, 1)); }
  Geodesic_number_pair both_first() const { return Geodesic_number_pair(_mm_unpacklo_pd(m_lanes, m_lanes)); }
  Geodesic_number_pair both_second() const { return Geodesic_number_pair(_mm_unpackhi_pd(m_lanes, m_lanes)); }
  Geodesic_number_pair with_second_negated() const { return Geodesic_number_pair(_mm_xor_pd(m_lanes, _mm_set_pd(-0., 0.))); }

  friend Geodesic_number_pair operator+(Geodesic_number_pair a, Geodesic_number_pair b)
  {
    return Geodesic_number_pair(_mm_add_pd(a.m_lanes, b.m_lanes));
  }
  friend Geodesic_number_pair operator-(Geodesic_number_pair a, Geodesic_number_pair b)
  {
    return Geodesic_number_pair(_mm_sub_pd(a.m_lanes, b.m_lanes));
  }
  friend Geodesic_number_pair operator*(Geodesic_number_pair a, Geodesic_number_pair b)
  {
    return Geodesic_number_pair(_mm_mul_pd(a.m_lanes, b.m_lanes));
  }
  friend Geodesic_number_pair operator/(Geodesic_number_pair a, Geodesic_number_pair b)
  {
    return Geodesic_number_pair(_mm_div_pd(a.m_lanes, b.m_lanes));
  }
  friend Test operator<(Geodesic_number_pair a, Geodesic_number_pair b) { return Test(_mm_cmplt_pd(a.m_lanes, b.m_lanes)); }
  friend Test operator<=(Geodesic_number_pair a, Geodesic_number_pair b) { return Test(_mm_cmple_pd(a.m_lanes, b.m_lanes)); }
  friend Geodesic_number_pair square_root(Geodesic_number_pair a)
  {
    return Geodesic_number_pair(_mm_sqrt_pd(_mm_max_pd(a.m_lanes, _mm_setzero_pd())));
  }

private:
  explicit Geodesic_number_pair(__m128d lanes) : m_lanes(lanes) {}
  __m128d m_lanes;
};
#endif

} // namespace CGAL

#endif
