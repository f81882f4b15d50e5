// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two numbers for the same operation, such as the two ends of a window. Two doubles share a register of SSE2, which every
// x86-64 processor has. Each operation rounds as the operation on single numbers does.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_NUMBER_PAIR_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_NUMBER_PAIR_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Number_pair
{
public:
  // Result of a comparison of both numbers; comparisons with NaN are false.
  class Test
  {
  public:
    Test(bool first, bool second) : m_bits(unsigned(first) | unsigned(second) << 1) {}
    unsigned bits() const { return m_bits; } // bit 0: first; bit 1: second
    friend Test operator&(Test a, Test b) { return Test(a.m_bits & b.m_bits); }

  private:
    explicit Test(unsigned bits) : m_bits(bits) {}
    unsigned m_bits;
  };

  Number_pair() = default;
  explicit Number_pair(const FT& both) : m_first(both), m_second(both) {}
  Number_pair(const FT& first, const FT& second) : m_first(first), m_second(second) {}

  // Loads two members of an object; the second must directly follow the first in memory.
  static Number_pair of(const FT& first, const FT& second) { return Number_pair(first, second); }
  void put(FT& first, FT& second) const
  {
    first = m_first;
    second = m_second;
  }

  FT first() const { return m_first; }
  FT second() const { return m_second; }
  Number_pair swapped() const { return Number_pair(m_second, m_first); }
  Number_pair both_first() const { return Number_pair(m_first); }
  Number_pair both_second() const { return Number_pair(m_second); }
  Number_pair with_second_negated() const { return Number_pair(m_first, FT(-m_second)); }

  friend Number_pair operator+(const Number_pair& a, const Number_pair& b)
  {
    return Number_pair(FT(a.m_first + b.m_first), FT(a.m_second + b.m_second));
  }
  friend Number_pair operator-(const Number_pair& a, const Number_pair& b)
  {
    return Number_pair(FT(a.m_first - b.m_first), FT(a.m_second - b.m_second));
  }
  friend Number_pair operator*(const Number_pair& a, const Number_pair& b)
  {
    return Number_pair(FT(a.m_first * b.m_first), FT(a.m_second * b.m_second));
  }
  friend Number_pair operator/(const Number_pair& a, const Number_pair& b)
  {
    return Number_pair(FT(a.m_first / b.m_first), FT(a.m_second / b.m_second));
  }
  friend Test operator<(const Number_pair& a, const Number_pair& b)
  {
    return Test(a.m_first < b.m_first, a.m_second < b.m_second);
  }
  friend Test operator<=(const Number_pair& a, const Number_pair& b)
  {
    return Test(a.m_first <= b.m_first, a.m_second <= b.m_second);
  }
  friend Number_pair square_root(const Number_pair& a)
  {
    return Number_pair(internal::square_root<FT>(a.m_first), internal::square_root<FT>(a.m_second));
  }

private:
  FT m_first, m_second;
};

#ifdef CGAL_GEODESIC_OFFSET_HAS_SSE2
template <>
class Number_pair<double>
{
public:
  class Test
  {
  public:
    explicit Test(__m128d lanes) : m_lanes(lanes) {}
    unsigned bits() const { return unsigned(_mm_movemask_pd(m_lanes)); }
    friend Test operator&(Test a, Test b) { return Test(_mm_and_pd(a.m_lanes, b.m_lanes)); }

  private:
    __m128d m_lanes;
  };

  Number_pair() = default;
  explicit Number_pair(double both) : m_lanes(_mm_set1_pd(both)) {}
  Number_pair(double first, double second) : m_lanes(_mm_set_pd(second, first)) {}

  static Number_pair of(const double& first, const double&) { return Number_pair(_mm_loadu_pd(&first)); }
  void put(double& first, double&) const { _mm_storeu_pd(&first, m_lanes); }

  double first() const { return _mm_cvtsd_f64(m_lanes); }
  double second() const { return _mm_cvtsd_f64(_mm_unpackhi_pd(m_lanes, m_lanes)); }
  Number_pair swapped() const { return Number_pair(_mm_shuffle_pd(m_lanes, m_lanes, 1)); }
  Number_pair both_first() const { return Number_pair(_mm_unpacklo_pd(m_lanes, m_lanes)); }
  Number_pair both_second() const { return Number_pair(_mm_unpackhi_pd(m_lanes, m_lanes)); }
  Number_pair with_second_negated() const { return Number_pair(_mm_xor_pd(m_lanes, _mm_set_pd(-0., 0.))); }

  friend Number_pair operator+(Number_pair a, Number_pair b) { return Number_pair(_mm_add_pd(a.m_lanes, b.m_lanes)); }
  friend Number_pair operator-(Number_pair a, Number_pair b) { return Number_pair(_mm_sub_pd(a.m_lanes, b.m_lanes)); }
  friend Number_pair operator*(Number_pair a, Number_pair b) { return Number_pair(_mm_mul_pd(a.m_lanes, b.m_lanes)); }
  friend Number_pair operator/(Number_pair a, Number_pair b) { return Number_pair(_mm_div_pd(a.m_lanes, b.m_lanes)); }
  friend Test operator<(Number_pair a, Number_pair b) { return Test(_mm_cmplt_pd(a.m_lanes, b.m_lanes)); }
  friend Test operator<=(Number_pair a, Number_pair b) { return Test(_mm_cmple_pd(a.m_lanes, b.m_lanes)); }
  friend Number_pair square_root(Number_pair a) { return Number_pair(_mm_sqrt_pd(_mm_max_pd(a.m_lanes, _mm_setzero_pd()))); }

private:
  explicit Number_pair(__m128d lanes) : m_lanes(lanes) {}
  __m128d m_lanes;
};
#endif

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
