// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plane that curves lie in, with the coordinates of a drawing.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_PLANE_OF_CURVES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_PLANE_OF_CURVES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/plane_pieces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace IO {
namespace Surface_mesh_geodesic_offset_internal {

inline double dot(const Coordinates& p, const Coordinates& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

inline Coordinates difference(const Coordinates& p, const Coordinates& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

inline Coordinates cross(const Coordinates& p, const Coordinates& q)
{
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

inline Coordinates scaled(double s, const Coordinates& p) { return {s * p[0], s * p[1], s * p[2]}; }

// A plane that rises by less than half a right angle is drawn as a map: seen from above, with the y axis, or as much of it
// as lies in the plane, pointing up. So coordinates in a horizontal plane are x and y. Others are drawn as a view from the
// outside of the surface, with the z axis pointing up.
class Plane_of_curves
{
public:
  // Throws std::invalid_argument if the faces that the curves cross do not lie in one plane.
  template <class CurveRange>
  explicit Plane_of_curves(const CurveRange& curves)
  {
    find_normal(curves);
    const bool is_map = m_normal[2] * m_normal[2] > 0.5;
    if (is_map && m_normal[2] < 0) m_normal = scaled(-1, m_normal);
    const Coordinates up = is_map ? Coordinates{0, 1, 0} : Coordinates{0, 0, 1};
    m_y = difference(up, scaled(dot(up, m_normal), m_normal));
    m_y = scaled(1 / std::sqrt(dot(m_y, m_y)), m_y);
    m_x = cross(m_y, m_normal);
    check(curves);
  }

  Plane_point operator()(const Coordinates& p) const { return {dot(m_x, p), dot(m_y, p)}; }

private:
  template <class CurveRange, class Function>
  static void for_each_face(const CurveRange& curves, const Function& f)
  {
    std::size_t number = 0;
    for (const auto& curve : curves)
    {
      for (std::size_t i = 0; i < curve.number_of_pieces(); ++i) f(corners(curve, curve.piece(i)), curve, number);
      ++number;
    }
  }

  // From the face with the largest area, whose normal is rounded least.
  template <class CurveRange>
  void find_normal(const CurveRange& curves)
  {
    double largest = 0;
    for_each_face(curves, [&](const std::array<Coordinates, 3>& c, const auto&, std::size_t) {
      const Coordinates n = cross(difference(c[1], c[0]), difference(c[2], c[0]));
      const double length = std::sqrt(dot(n, n));
      if (!(length > largest)) return;
      largest = length;
      m_normal = scaled(1 / length, n);
      m_point = c[0];
    });
  }

  template <class CurveRange>
  void check(const CurveRange& curves) const
  {
    Bbox_3 box = bbox(m_point);
    for_each_face(curves, [&](const std::array<Coordinates, 3>& c, const auto&, std::size_t) {
      for (const Coordinates& p : c) box += bbox(p);
    });
    // coordinates of six digits, as files have them, are in one plane
    const Coordinates diagonal{box.x_span(), box.y_span(), box.z_span()};
    const double tolerance = 1e-6 * std::sqrt(dot(diagonal, diagonal));
    for_each_face(curves, [&](const std::array<Coordinates, 3>& c, const auto& curve, std::size_t number) {
      for (const Coordinates& p : c)
        if (!(std::abs(dot(m_normal, difference(p, m_point))) <= tolerance))
          throw std::invalid_argument("the curves do not lie in one plane: curve " + std::to_string(number) +
                                      ", at distance " + short_number(CGAL::to_double(curve.distance())) +
                                      ", crosses a face with the vertex (" + short_number(p[0]) + ", " + short_number(p[1]) +
                                      ", " + short_number(p[2]) + ") outside of the plane");
    });
  }

  Coordinates m_normal{0, 0, 1}, m_point{0, 0, 0}, m_x{}, m_y{};
};

} // namespace Surface_mesh_geodesic_offset_internal
} // namespace IO
} // namespace CGAL

#endif
