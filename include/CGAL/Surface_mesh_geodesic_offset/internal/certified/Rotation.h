// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rotation of vectors of twice the digits of double, with both coordinates in one register.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_ROTATION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_ROTATION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_number_pair.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Double_double.h>

namespace CGAL::Geodesic_offset::internal {

// Transforms vectors to a frame whose x axis has a given unit direction. The error is at most 32 u^2 times the vector's
// length.
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
    const Sum p = two_product(m_x, Split<Pair>(a)), q = two_product(m_y, Split<Pair>(b));
    const Pair low = (m_x.value * a_low + m_x_low * a) + (m_y.value * b_low + m_y_low * b);
    const Sum s = two_sum(p.high, q.high), r = two_sum(s.high, s.low + ((p.low + q.low) + low));
    return {{r.high.first(), r.low.first()}, {r.high.second(), r.low.second()}};
  }

private:
  typedef Geodesic_number_pair<double> Pair;
  typedef Double_length<Pair> Sum;

  Split<Pair> m_x, m_y;
  Pair m_x_low, m_y_low;
};

inline Double_double_2 in_frame(const Double_double_2& axis, const Double_double_2& v) { return Rotation(axis)(v); }

} // namespace CGAL::Geodesic_offset::internal

#endif
