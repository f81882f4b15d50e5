// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unevaluated sums of two doubles. With them, images remain accurate over any number of faces.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_DOUBLE_DOUBLE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_DOUBLE_DOUBLE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <cmath>

namespace CGAL::Geodesic_offset::internal {

// With rounding to nearest and u = 2^-53, products, quotients and roots have relative errors of at most 8 u^2, sums 8 u^2
// relative to the larger operand (Dekker 1971; Joldes, Muller and Popescu 2017). |low| <= u |high|.
//
// `Number`: double, or a Geodesic_number_pair<double>.
template <class Number>
struct Double_length
{
  Number high = Number(0.), low = Number(0.);

  Double_length() = default;
  Double_length(const Number& h) : high(h) {}
  Double_length(const Number& h, const Number& l) : high(h), low(l) {}
};

typedef Double_length<double> Double_double;

// Exact sum a + b.
template <class Number>
inline Double_length<Number> two_sum(const Number& a, const Number& b)
{
  const Number s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

// Exact sum for |a| >= |b|, or a = 0.
inline Double_double quick_two_sum(double a, double b)
{
  const double s = a + b;
  return {s, b - (s - a)};
}

// A number as a sum of two halves of 26 digits; products of halves are exact.
template <class Number>
struct Split
{
  Number value;
#ifdef FP_FAST_FMA
  explicit Split(const Number& x) : value(x) {}
#else
  Number high, low;
  explicit Split(const Number& x) : value(x)
  {
    const Number t = Number(134217729.) * x; // 2^27 + 1
    high = t - (t - x);
    low = x - high;
  }
#endif
};

#ifdef FP_FAST_FMA
// a b - c with a single rounding.
inline double fused(double a, double b, double c) { return std::fma(a, b, -c); }
// Overload for pairs.
template <class Pair>
inline Pair fused(const Pair& a, const Pair& b, const Pair& c)
{
  return Pair(fused(a.first(), b.first(), c.first()), fused(a.second(), b.second(), c.second()));
}
#endif

// Exact product a b, except for underflow.
template <class Number>
inline Double_length<Number> two_product(const Split<Number>& a, const Split<Number>& b)
{
  const Number p = a.value * b.value;
#ifdef FP_FAST_FMA
  return {p, fused(a.value, b.value, p)};
#else
  return {p, ((a.high * b.high - p) + a.high * b.low + a.low * b.high) + a.low * b.low};
#endif
}

template <class Number>
inline Double_length<Number> two_product(const Number& a, const Number& b)
{
  return two_product(Split<Number>(a), Split<Number>(b));
}

inline Double_double operator-(const Double_double& a) { return {-a.high, -a.low}; }

inline Double_double operator+(const Double_double& a, const Double_double& b)
{
  const Double_double s = two_sum(a.high, b.high);
  return quick_two_sum(s.high, s.low + (a.low + b.low));
}

inline Double_double operator-(const Double_double& a, const Double_double& b) { return a + (-b); }

inline Double_double operator*(const Double_double& a, const Double_double& b)
{
  const Double_double p = two_product(a.high, b.high);
  return quick_two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

inline Double_double operator/(const Double_double& a, const Double_double& b)
{
  const double q = a.high / b.high;
  const Double_double rest = a - b * q;
  return quick_two_sum(q, rest.high / b.high);
}

inline Double_double square_root(const Double_double& a)
{
  if (!(a.high > 0)) return 0.;
  const double r = std::sqrt(a.high);
  const Double_double rest = a - two_product(r, r);
  return quick_two_sum(r, rest.high / (2 * r));
}

// A unit vector or an image.
struct Double_double_2
{
  Double_double x, y;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
