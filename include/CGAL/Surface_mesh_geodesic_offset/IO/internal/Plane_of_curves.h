// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common plane of faces, with the coordinates of a drawing.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_PLANE_OF_CURVES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_PLANE_OF_CURVES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/plane_pieces.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL::IO::Surface_mesh_geodesic_offset_internal {

inline double dot(const Coordinates& p, const Coordinates& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

inline Coordinates difference(const Coordinates& p, const Coordinates& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

inline Coordinates cross(const Coordinates& p, const Coordinates& q)
{
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

inline Coordinates scaled(double s, const Coordinates& p) { return {s * p[0], s * p[1], s * p[2]}; }

// A plane with a slope of less than 45 degrees is drawn as a map: from above, with the projection of the y axis pointing
// up. So coordinates in a horizontal plane are x and y. Other planes are drawn from the outside of the surface, with the z
// axis pointing up.
class Plane_of_faces
{
public:
  // for_each_face(f) calls f(corners) for each face.
  template <class Faces>
  explicit Plane_of_faces(const Faces& for_each_face)
  {
    find_normal(for_each_face);
    const bool is_map = m_normal[2] * m_normal[2] > 0.5;
    if (is_map && m_normal[2] < 0) m_normal = scaled(-1, m_normal);
    const Coordinates up = is_map ? Coordinates{0, 1, 0} : Coordinates{0, 0, 1};
    m_y = difference(up, scaled(dot(up, m_normal), m_normal));
    m_y = scaled(1 / std::sqrt(dot(m_y, m_y)), m_y);
    m_x = cross(m_y, m_normal);
  }

  // True if a corner of one of the faces lies in the plane.
  bool contains(const Coordinates& p) const { return std::abs(dot(m_normal, difference(p, m_point))) <= m_tolerance; }

  Plane_point operator()(const Coordinates& p) const { return {dot(m_x, p), dot(m_y, p)}; }

private:
  // Sum of all area vectors, oriented like the largest one, so that the rounding errors of small faces average out.
  template <class Faces>
  void find_normal(const Faces& for_each_face)
  {
    double largest = 0;
    Bbox_3 box;
    for_each_face([&](const std::array<Coordinates, 3>& c) {
      for (const Coordinates& p : c) box += bbox(p);
      const Coordinates n = area_vector(c);
      if (!(dot(n, n) > largest)) return;
      largest = dot(n, n);
      m_normal = n;
      m_point = c[0];
    });
    if (largest == 0) return;
    // accepts coordinates rounded to seven digits
    m_tolerance = 1e-6 * std::hypot(box.x_span(), box.y_span(), box.z_span());
    Coordinates sum{};
    for_each_face([&](const std::array<Coordinates, 3>& c) {
      const Coordinates n = area_vector(c);
      sum = difference(sum, dot(n, m_normal) < 0 ? n : scaled(-1, n));
    });
    m_normal = scaled(1 / std::hypot(sum[0], sum[1], sum[2]), sum);
  }

  static Coordinates area_vector(const std::array<Coordinates, 3>& c)
  {
    return cross(difference(c[1], c[0]), difference(c[2], c[0]));
  }

  Coordinates m_normal{0, 0, 1}, m_point{0, 0, 0}, m_x{}, m_y{};
  double m_tolerance = 0;
};

// Common plane of the faces that curves cross.
template <class CurveRange>
class Plane_of_curves : public Plane_of_faces
{
public:
  // Throws std::invalid_argument if the faces do not lie in one plane.
  explicit Plane_of_curves(const CurveRange& curves)
    : Plane_of_faces([&curves](const auto& f) {
        for_each_face(curves, [&f](const auto& corners, const auto&, std::size_t) { f(corners); });
      })
  {
    for_each_face(curves, [this](const std::array<Coordinates, 3>& c, const auto& curve, std::size_t number) {
      for (const Coordinates& p : c)
        if (!this->contains(p))
          throw std::invalid_argument("the curves do not lie in one plane: curve " + std::to_string(number) + ", at distance " +
                                      short_number(CGAL::to_double(curve.distance())) + ", crosses a face with the vertex (" +
                                      short_number(p[0]) + ", " + short_number(p[1]) + ", " + short_number(p[2]) +
                                      ") outside of the plane");
    });
  }

private:
  template <class Function>
  static void for_each_face(const CurveRange& curves, const Function& f)
  {
    std::size_t number = 0;
    for (const auto& curve : curves)
    {
      for (std::size_t i = 0; i < curve.number_of_pieces(); ++i) f(corners(curve, curve.piece(i)), curve, number);
      ++number;
    }
  }
};

} // namespace CGAL::IO::Surface_mesh_geodesic_offset_internal

#endif
