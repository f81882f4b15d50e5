// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Interval arithmetic with double bounds, for the filter.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_DOUBLE_INTERVAL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_DOUBLE_INTERVAL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_sum.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace CGAL::Geodesic_offset::internal {

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

} // namespace CGAL::Geodesic_offset::internal

#endif
