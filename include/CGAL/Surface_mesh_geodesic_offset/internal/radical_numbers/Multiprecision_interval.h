// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Interval arithmetic with multiprecision bounds.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_MULTIPRECISION_INTERVAL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_MULTIPRECISION_INTERVAL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_sum.h>

#include <mpfr.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace CGAL::Geodesic_offset::internal {

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

} // namespace CGAL::Geodesic_offset::internal

#endif
