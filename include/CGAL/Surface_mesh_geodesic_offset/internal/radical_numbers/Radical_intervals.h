// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Interval arithmetic, with double bounds for the filter and with multiprecision bounds.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_INTERVALS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_INTERVALS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_sum.h>

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Interval with double bounds. Each rounded result is widened by one unit in the last place. In every rounding mode,
// the rounded result is one of the two neighbours of the exact one, so the arithmetic neither depends on the mode nor
// changes it.
struct Double_interval
{
  double low = 0, high = 0;

  static Double_interval everything()
  {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }

  bool is_point() const { return low == high; }
  bool has_sign() const { return low > 0 || high < 0 || (low == 0 && high == 0); }
  int sign() const { return low > 0 ? 1 : high < 0 ? -1 : 0; }

  // True if all doubles in the interval are within a few units in the last place of the number.
  bool is_tight() const
  {
    if (above(low) >= high) return true; // also numbers beyond the range of doubles
    return std::isfinite(low) && std::isfinite(high) &&
           high - low <= 4 * std::numeric_limits<double>::epsilon() * (std::min)(std::abs(low), std::abs(high));
  }
  double middle() const
  {
    if (!std::isfinite(low) || !std::isfinite(high)) return std::isfinite(low) ? high : low;
    const double half = low / 2 + high / 2; // cannot overflow, but may leave the interval among subnormal numbers
    return (std::min)((std::max)(half, low), high);
  }
  void intersect(const Double_interval& o)
  {
    low = (std::max)(low, o.low);
    high = (std::min)(high, o.high);
  }

  static double above(double x)
  {
    if (!(x < std::numeric_limits<double>::infinity())) return x;
    if (x == 0) return std::numeric_limits<double>::denorm_min();
    std::int64_t bits;
    std::memcpy(&bits, &x, sizeof(x));
    bits += x > 0 ? 1 : -1;
    std::memcpy(&x, &bits, sizeof(x));
    return x;
  }
  static double below(double x) { return -above(-x); }

  friend Double_interval operator-(const Double_interval& a) { return {-a.high, -a.low}; }
  friend Double_interval operator+(const Double_interval& a, const Double_interval& b)
  {
    return {below(a.low + b.low), above(a.high + b.high)};
  }
  friend Double_interval operator-(const Double_interval& a, const Double_interval& b)
  {
    return {below(a.low - b.high), above(a.high - b.low)};
  }
  friend Double_interval operator*(const Double_interval& a, const Double_interval& b)
  {
    const double p[] = {product(a.low, b.low), product(a.low, b.high), product(a.high, b.low), product(a.high, b.high)};
    return around(p);
  }
  friend Double_interval operator/(const Double_interval& a, const Double_interval& b)
  {
    const bool finite = std::isfinite(a.low) && std::isfinite(a.high) && std::isfinite(b.low) && std::isfinite(b.high);
    if (!finite || (b.low <= 0 && b.high >= 0)) return everything();
    const double q[] = {a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high};
    return around(q);
  }
  friend Double_interval sqrt(const Double_interval& a)
  {
    return {(std::max)(0., below(std::sqrt((std::max)(0., a.low)))), above(std::sqrt((std::max)(0., a.high)))};
  }

private:
  // A zero bound belongs to a finite number, so its product is 0 even if the other bound is infinite.
  static double product(double x, double y) { return x == 0 || y == 0 ? 0 : x * y; }

  static Double_interval around(const double (&x)[4])
  {
    return {below((std::min)((std::min)(x[0], x[1]), (std::min)(x[2], x[3]))),
            above((std::max)((std::max)(x[0], x[1]), (std::max)(x[2], x[3])))};
  }
};

// Interval with bounds of a chosen precision, rounded outwards by MPFR. Each operation writes its result into *this,
// which must not be an operand.
class Multiprecision_interval
{
public:
  explicit Multiprecision_interval(mpfr_prec_t precision)
  {
    mpfr_init2(m_low, precision);
    mpfr_init2(m_high, precision);
    mpfr_set_zero(m_low, 1);
    mpfr_set_zero(m_high, 1);
  }
  Multiprecision_interval(Multiprecision_interval&& o) : Multiprecision_interval(mpfr_prec_t(MPFR_PREC_MIN)) { swap(o); }
  Multiprecision_interval& operator=(Multiprecision_interval&& o)
  {
    swap(o);
    return *this;
  }
  ~Multiprecision_interval()
  {
    mpfr_clear(m_low);
    mpfr_clear(m_high);
  }
  void swap(Multiprecision_interval& o)
  {
    mpfr_swap(m_low, o.m_low);
    mpfr_swap(m_high, o.m_high);
  }

  mpfr_prec_t precision() const { return mpfr_get_prec(m_low); }
  bool has_sign() const { return mpfr_sgn(m_low) > 0 || mpfr_sgn(m_high) < 0 || is_zero(); }
  int sign() const { return mpfr_sgn(m_low) > 0 ? 1 : mpfr_sgn(m_high) < 0 ? -1 : 0; }

  double low_to_nearest() const { return mpfr_get_d(m_low, MPFR_RNDN); }
  // True if all numbers in the interval are less than 2^-bits in absolute value.
  bool is_below(std::size_t bits) const
  {
    for (mpfr_srcptr x : {&m_low[0], &m_high[0]})
      if (!mpfr_zero_p(x) && !(mpfr_regular_p(x) && mpfr_get_exp(x) <= -mpfr_exp_t(bits))) return false;
    return true;
  }

  Double_interval rounded() const { return {mpfr_get_d(m_low, MPFR_RNDD), mpfr_get_d(m_high, MPFR_RNDU)}; }

  void set(const Big_rational& q)
  {
    mpfr_set_q(m_low, q.backend().data(), MPFR_RNDD);
    mpfr_set_q(m_high, q.backend().data(), MPFR_RNDU);
  }
  void set(const Big_rational& low, const Big_rational& high)
  {
    mpfr_set_q(m_low, low.backend().data(), MPFR_RNDD);
    mpfr_set_q(m_high, high.backend().data(), MPFR_RNDU);
  }
  void set_root_of(const Big_integer& n)
  {
    Multiprecision_interval x(precision());
    mpfr_set_z(x.m_low, n.backend().data(), MPFR_RNDD);
    mpfr_set_z(x.m_high, n.backend().data(), MPFR_RNDU);
    set_root(x);
  }
  void set_negative(const Multiprecision_interval& a)
  {
    mpfr_neg(m_low, a.m_high, MPFR_RNDD);
    mpfr_neg(m_high, a.m_low, MPFR_RNDU);
  }
  void set_sum(const Multiprecision_interval& a, const Multiprecision_interval& b)
  {
    mpfr_add(m_low, a.m_low, b.m_low, MPFR_RNDD);
    mpfr_add(m_high, a.m_high, b.m_high, MPFR_RNDU);
    repair();
  }
  void set_difference(const Multiprecision_interval& a, const Multiprecision_interval& b)
  {
    mpfr_sub(m_low, a.m_low, b.m_high, MPFR_RNDD);
    mpfr_sub(m_high, a.m_high, b.m_low, MPFR_RNDU);
    repair();
  }
  void set_product(const Multiprecision_interval& a, const Multiprecision_interval& b)
  {
    if (b.is_mixed() && !a.is_mixed()) return set_product(b, a);
    if (b.is_mixed())
    {
      Multiprecision_interval other(precision());
      mpfr_mul(m_low, a.m_low, b.m_high, MPFR_RNDD);
      mpfr_mul(other.m_low, a.m_high, b.m_low, MPFR_RNDD);
      mpfr_mul(m_high, a.m_low, b.m_low, MPFR_RNDU);
      mpfr_mul(other.m_high, a.m_high, b.m_high, MPFR_RNDU);
      mpfr_min(m_low, m_low, other.m_low, MPFR_RNDD);
      mpfr_max(m_high, m_high, other.m_high, MPFR_RNDU);
    }
    else
    {
      // b has one sign. It determines which bound of a gives the smallest product, and that bound determines which of b
      const bool up = mpfr_sgn(b.m_low) >= 0;
      const mpfr_srcptr smallest = up ? a.m_low : a.m_high, largest = up ? a.m_high : a.m_low;
      mpfr_mul(m_low, smallest, mpfr_sgn(smallest) >= 0 ? b.m_low : b.m_high, MPFR_RNDD);
      mpfr_mul(m_high, largest, mpfr_sgn(largest) >= 0 ? b.m_high : b.m_low, MPFR_RNDU);
    }
    repair();
  }
  void set_quotient(const Multiprecision_interval& a, const Multiprecision_interval& b)
  {
    const bool up = mpfr_sgn(b.m_low) > 0;
    if (!up && mpfr_sgn(b.m_high) >= 0) return set_everything();
    const mpfr_srcptr smallest = up ? a.m_low : a.m_high, largest = up ? a.m_high : a.m_low;
    mpfr_div(m_low, smallest, mpfr_sgn(smallest) >= 0 ? b.m_high : b.m_low, MPFR_RNDD);
    mpfr_div(m_high, largest, mpfr_sgn(largest) >= 0 ? b.m_low : b.m_high, MPFR_RNDU);
    repair();
  }
  void set_root(const Multiprecision_interval& a)
  {
    if (mpfr_sgn(a.m_high) < 0) throw std::domain_error("square root of a negative number");
    if (mpfr_sgn(a.m_low) < 0) mpfr_set_zero(m_low, 1);
    else mpfr_sqrt(m_low, a.m_low, MPFR_RNDD);
    mpfr_sqrt(m_high, a.m_high, MPFR_RNDU);
  }

private:
  bool is_zero() const { return mpfr_zero_p(m_low) && mpfr_zero_p(m_high); }
  bool is_mixed() const { return mpfr_sgn(m_low) < 0 && mpfr_sgn(m_high) > 0; }

  void set_everything()
  {
    mpfr_set_inf(m_low, -1);
    mpfr_set_inf(m_high, 1);
  }
  // Unbounded operands may give inf - inf or 0 * inf.
  void repair()
  {
    if (mpfr_nan_p(m_low) || mpfr_nan_p(m_high)) set_everything();
  }

  mpfr_t m_low, m_high;
};

// Interval of a sum of roots; `symbol(i)` is the interval of symbol i.
template <class Symbol_interval>
Multiprecision_interval interval_of(const Radical_sum& a, mpfr_prec_t bits, const Symbol_interval& symbol)
{
  Multiprecision_interval sum(bits), term(bits), root(bits), next(bits);
  for (const Radical_term& t : a.terms())
  {
    term.set(t.factor);
    root.set_root_of(t.radicand);
    next.set_product(term, root);
    term.swap(next);
    for (std::uint64_t left = t.symbols, i = 0; left != 0; left >>= 1, ++i)
      if (left & 1)
      {
        next.set_product(term, symbol(i));
        term.swap(next);
      }
    next.set_sum(sum, term);
    sum.swap(next);
  }
  return sum;
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
