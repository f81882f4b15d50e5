// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Interval arithmetic with bounds of any precision, and what intervals of doubles have beyond CGAL::Interval_nt.

#ifndef CGAL_RADICAL_NUMBER_INTERNAL_MULTIPRECISION_INTERVAL_H
#define CGAL_RADICAL_NUMBER_INTERNAL_MULTIPRECISION_INTERVAL_H

#include <CGAL/license/Radical_number.h>

#include <CGAL/Radical_number/internal/Radical_sum.h>

#include <CGAL/Interval_nt.h>

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace CGAL::Radical_numbers::internal {

typedef Interval_nt<> Double_interval;

// 0 if the interval contains 0.
inline int sign_of(const Double_interval& x) { return x.inf() > 0 ? 1 : x.sup() < 0 ? -1 : 0; }
inline bool has_sign(const Double_interval& x) { return sign_of(x) != 0 || (x.inf() == 0 && x.sup() == 0); }

// True if all doubles in the interval are within a few units in the last place of the number, which may be beyond the range
// of doubles.
inline bool is_tight(const Double_interval& x)
{
  if (std::nextafter(x.inf(), std::numeric_limits<double>::infinity()) >= x.sup()) return true;
  return std::isfinite(x.inf()) && std::isfinite(x.sup()) &&
         x.sup() - x.inf() <= 4 * std::numeric_limits<double>::epsilon() * (std::min)(std::abs(x.inf()), std::abs(x.sup()));
}

inline double middle_of(const Double_interval& x)
{
  if (!std::isfinite(x.inf()) || !std::isfinite(x.sup())) return std::isfinite(x.inf()) ? x.sup() : x.inf();
  const double half = x.inf() / 2 + x.sup() / 2; // cannot overflow, but may leave the interval among subnormal numbers
  return (std::min)((std::max)(half, x.inf()), x.sup());
}

inline Double_interval intersection_of(const Double_interval& a, const Double_interval& b)
{
  return Double_interval((std::max)(a.inf(), b.inf()), (std::min)(a.sup(), b.sup()));
}

class Multiprecision_interval
{
public:
  // The interval of zero alone.
  explicit Multiprecision_interval(mpfr_prec_t precision)
  {
    for (mpfr_ptr x : {&m_low[0], &m_high[0]})
    {
      mpfr_init2(x, precision);
      mpfr_set_zero(x, 1);
    }
  }
  Multiprecision_interval(Multiprecision_interval&& o) : Multiprecision_interval(mpfr_prec_t(MPFR_PREC_MIN))
  {
    *this = std::move(o);
  }
  Multiprecision_interval& operator=(Multiprecision_interval&& o)
  {
    mpfr_swap(m_low, o.m_low);
    mpfr_swap(m_high, o.m_high);
    return *this;
  }
  ~Multiprecision_interval() { mpfr_clears(m_low, m_high, mpfr_ptr(nullptr)); }

  std::size_t precision() const { return std::size_t(mpfr_get_prec(m_low)); }
  bool has_sign() const { return sign() != 0 || (mpfr_zero_p(m_low) && mpfr_zero_p(m_high)); }
  int sign() const { return mpfr_sgn(m_low) > 0 ? 1 : mpfr_sgn(m_high) < 0 ? -1 : 0; }

  double low_to_nearest() const { return mpfr_get_d(m_low, MPFR_RNDN); }
  Double_interval rounded() const { return Double_interval(mpfr_get_d(m_low, MPFR_RNDD), mpfr_get_d(m_high, MPFR_RNDU)); }

  // True if all numbers in the interval are less than 2^-bits in absolute value.
  bool is_below(std::size_t bits) const
  {
    for (mpfr_srcptr x : {&m_low[0], &m_high[0]})
      if (!mpfr_zero_p(x) && !(mpfr_regular_p(x) && mpfr_get_exp(x) <= -mpfr_exp_t(bits))) return false;
    return true;
  }

private:
  friend class Multiprecision_arithmetic;

  bool is_mixed() const { return mpfr_sgn(m_low) < 0 && mpfr_sgn(m_high) > 0; }

  mpfr_t m_low, m_high;
};

// Interval arithmetic; the bounds of results have a chosen precision, and are rounded outwards by MPFR.
class Multiprecision_arithmetic
{
public:
  typedef Multiprecision_interval Interval;

  explicit Multiprecision_arithmetic(std::size_t bits) : m_precision(mpfr_prec_t(bits)) {}
  std::size_t precision() const { return std::size_t(m_precision); }

  Interval enclosure(const Big_rational& low, const Big_rational& high) const
  {
    Interval r(m_precision);
    mpfr_set_q(r.m_low, low.backend().data(), MPFR_RNDD);
    mpfr_set_q(r.m_high, high.backend().data(), MPFR_RNDU);
    return r;
  }
  Interval enclosure(const Big_rational& q) const { return enclosure(q, q); }

  Interval negative(const Interval& a) const
  {
    Interval r(m_precision);
    mpfr_neg(r.m_low, a.m_high, MPFR_RNDD);
    mpfr_neg(r.m_high, a.m_low, MPFR_RNDU);
    return r;
  }
  Interval sum(const Interval& a, const Interval& b) const { return result(mpfr_add, a.m_low, b.m_low, a.m_high, b.m_high); }
  Interval difference(const Interval& a, const Interval& b) const
  {
    return result(mpfr_sub, a.m_low, b.m_high, a.m_high, b.m_low);
  }
  Interval product(const Interval& a, const Interval& b) const
  {
    if (!b.is_mixed())
    {
      // The sign of b determines which bound of a gives the smallest product, and that bound determines which of b.
      const bool up = mpfr_sgn(b.m_low) >= 0;
      const mpfr_srcptr smallest = up ? a.m_low : a.m_high, largest = up ? a.m_high : a.m_low;
      return result(mpfr_mul, smallest, mpfr_sgn(smallest) >= 0 ? b.m_low : b.m_high, largest,
                    mpfr_sgn(largest) >= 0 ? b.m_high : b.m_low);
    }
    if (!a.is_mixed()) return product(b, a);
    Interval r = result(mpfr_mul, a.m_low, b.m_high, a.m_low, b.m_low);
    const Interval other = result(mpfr_mul, a.m_high, b.m_low, a.m_high, b.m_high);
    mpfr_min(r.m_low, r.m_low, other.m_low, MPFR_RNDD);
    mpfr_max(r.m_high, r.m_high, other.m_high, MPFR_RNDU);
    return r;
  }
  Interval quotient(const Interval& a, const Interval& b) const
  {
    const bool up = mpfr_sgn(b.m_low) > 0;
    if (!up && mpfr_sgn(b.m_high) >= 0) return everything();
    const mpfr_srcptr smallest = up ? a.m_low : a.m_high, largest = up ? a.m_high : a.m_low;
    return result(mpfr_div, smallest, mpfr_sgn(smallest) >= 0 ? b.m_high : b.m_low, largest,
                  mpfr_sgn(largest) >= 0 ? b.m_low : b.m_high);
  }
  Interval square_root(const Interval& a) const
  {
    if (mpfr_sgn(a.m_high) < 0) throw std::domain_error("square root of a negative number");
    Interval r(m_precision);
    if (mpfr_sgn(a.m_low) > 0) mpfr_sqrt(r.m_low, a.m_low, MPFR_RNDD);
    mpfr_sqrt(r.m_high, a.m_high, MPFR_RNDU);
    return r;
  }

  // Interval of a sum of roots; `symbol(i)` is the interval of symbol i.
  template <class Symbol_interval>
  Interval enclosure(const Radical_sum& a, const Symbol_interval& symbol) const
  {
    Interval result(m_precision);
    for (const Radical_term& t : a.terms())
    {
      Interval term = product(enclosure(t.factor), square_root(enclosure(Big_rational(t.radicand))));
      for (std::uint64_t left = t.symbols, i = 0; left != 0; left >>= 1, ++i)
        if (left & 1) term = product(term, symbol(i));
      result = sum(result, term);
    }
    return result;
  }

private:
  typedef int (*Operation)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

  // The lower bound is that of a and b, the upper one that of c and d.
  Interval result(Operation operation, mpfr_srcptr a, mpfr_srcptr b, mpfr_srcptr c, mpfr_srcptr d) const
  {
    Interval r(m_precision);
    operation(r.m_low, a, b, MPFR_RNDD);
    operation(r.m_high, c, d, MPFR_RNDU);
    if (mpfr_nan_p(r.m_low) || mpfr_nan_p(r.m_high)) return everything(); // inf - inf or 0 * inf
    return r;
  }
  Interval everything() const
  {
    Interval r(m_precision);
    mpfr_set_inf(r.m_low, -1);
    mpfr_set_inf(r.m_high, 1);
    return r;
  }

  mpfr_prec_t m_precision;
};

} // namespace CGAL::Radical_numbers::internal

#endif
