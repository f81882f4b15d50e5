// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vectors of twice the digits of double, turned: both coordinates at once.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_ROTATION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_ROTATION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Number_pair.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Double_double.h>

#include <cmath>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Brings vectors into a frame whose x axis has a given unit direction. The error is at most 32 u^2 of the vector's length.
class Rotation
{
public:
  explicit Rotation(const Double_double_2& axis)
    : m_x(Pair(axis.x.high)), m_y(Pair(axis.y.high)), m_x_low(axis.x.low), m_y_low(axis.y.low)
  {
  }

  Double_double_2 operator()(const Double_double_2& v) const
  {
    // (x, y) = m_x (v.x, v.y) + m_y (v.y, -v.x)
    const Pair a(v.x.high, v.y.high), a_low(v.x.low, v.y.low);
    const Pair b = a.swapped().with_second_negated(), b_low = a_low.swapped().with_second_negated();
    const Sum p = product(m_x, a), q = product(m_y, b);
    const Pair low = (m_x.value * a_low + m_x_low * a) + (m_y.value * b_low + m_y_low * b);
    const Sum s = two_sum(p.high, q.high), r = two_sum(s.high, s.low + ((p.low + q.low) + low));
    return {{r.high.first(), r.low.first()}, {r.high.second(), r.low.second()}};
  }

private:
  typedef Number_pair<double> Pair;

  // As Double_double, Split_double, and their functions.
  struct Sum
  {
    Pair high, low;
  };

  struct Split
  {
    Pair value;
#ifdef FP_FAST_FMA
    explicit Split(const Pair& x) : value(x) {}
#else
    Pair high, low;
    explicit Split(const Pair& x) : value(x)
    {
      const Pair t = Pair(134217729.) * x; // 2^27 + 1
      high = t - (t - x);
      low = x - high;
    }
#endif
  };

  static Sum two_sum(const Pair& a, const Pair& b)
  {
    const Pair s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
  }

  static Sum product(const Split& a, const Pair& x)
  {
    const Split b(x);
    const Pair p = a.value * b.value;
#ifdef FP_FAST_FMA
    return {p, Pair(std::fma(a.value.first(), x.first(), -p.first()), std::fma(a.value.second(), x.second(), -p.second()))};
#else
    return {p, ((a.high * b.high - p) + a.high * b.low + a.low * b.high) + a.low * b.low};
#endif
  }

  Split m_x, m_y;
  Pair m_x_low, m_y_low;
};

inline Double_double_2 in_frame(const Double_double_2& axis, const Double_double_2& v) { return Rotation(axis)(v); }

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
