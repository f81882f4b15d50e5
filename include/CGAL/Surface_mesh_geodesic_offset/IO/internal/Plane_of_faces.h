// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common plane of faces, with the coordinates of a drawing.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_PLANE_OF_FACES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_PLANE_OF_FACES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/plane_pieces.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL::IO::Surface_mesh_geodesic_offset_internal {

// Plane of faces, oriented like the largest one.
class Plane_of_faces
{
public:
  // for_each_face(f) calls f(corners) for each face.
  template <class Faces>
  explicit Plane_of_faces(const Faces& for_each_face)
  {
    using namespace Geodesic_offset::internal;
    double largest = 0;
    Bbox_3 box;
    for_each_face([&](const std::array<Space_vector, 3>& c) {
      for (const Space_vector& p : c) box += Bbox_3(p.x(), p.y(), p.z(), p.x(), p.y(), p.z());
      const Space_vector n = Face_in_space::area_vector(c);
      if (!(n * n > largest)) return;
      largest = n * n;
      m_normal = n;
      m_point = c[0];
    });
    if (largest > 0)
    {
      m_extent = std::hypot(box.x_span(), box.y_span(), box.z_span());
      for (int i = 0; i < 3; ++i) m_largest = (std::max)({m_largest, std::abs((box.min)(i)), std::abs((box.max)(i))});
      // sum of all area vectors, so that the rounding errors of small faces average out
      Space_vector sum = NULL_VECTOR;
      for_each_face([&](const std::array<Space_vector, 3>& c) {
        const Space_vector n = Face_in_space::area_vector(c);
        sum = n * m_normal < 0 ? sum - n : sum + n;
      });
      m_normal = sum / length(sum);
    }
    for_each_face([&](const std::array<Space_vector, 3>& c) {
      for (const Space_vector& p : c) m_deviation = (std::max)(m_deviation, deviation(p));
    });
  }

  const Space_vector& normal() const { return m_normal; }
  const Space_vector& point() const { return m_point; }
  double deviation(const Space_vector& p) const { return std::abs(m_normal * (p - m_point)); }

  // Tolerance for elements of curves. The plane of the faces of an element has a deviation, too, which grows beyond these faces:
  // by a factor of up to three until the sum of their areas has doubled.
  double tolerance() const { return 4 * m_deviation; }

  // True if the faces lie in the plane up to the rounding of double.
  bool is_exact() const
  {
    typedef Geodesic_offset::internal::Piece_in_space Tolerances;
    return m_deviation <= Tolerances::same_point * m_largest + Tolerances::same_curve * m_extent;
  }

  // True if the corner of a face, or all corners, lie in the plane: accepts coordinates rounded to seven digits.
  bool contains(const Space_vector& p) const { return deviation(p) <= 1e-6 * m_extent; }
  bool contains_all() const { return m_deviation <= 1e-6 * m_extent; }

  // A plane with a slope of less than 45 degrees is drawn as a map: from above, with the projection of the y axis pointing
  // up. So coordinates in a horizontal plane are x and y. Other planes are drawn from the outside of the surface, with the z
  // axis pointing up.
  Plane_axes axes_of_drawing() const
  {
    const bool is_map = m_normal.z() * m_normal.z() > 0.5;
    Plane_axes axes;
    axes.normal = is_map && m_normal.z() < 0 ? -m_normal : m_normal;
    const Space_vector up = is_map ? Space_vector(0, 1, 0) : Space_vector(0, 0, 1);
    axes.y = up - (up * axes.normal) * axes.normal;
    axes.y = axes.y / Geodesic_offset::internal::length(axes.y);
    axes.x = cross_product(axes.y, axes.normal);
    return axes;
  }

private:
  Space_vector m_normal{0, 0, 1}, m_point = NULL_VECTOR;
  double m_extent = 0, m_largest = 0, m_deviation = 0; // extent: diagonal of the bounding box
};

// Calls f(corners) for each face that a curve crosses.
template <class Curve, class Function>
void for_each_face(const Curve& curve, const Function& f)
{
  for (const auto& piece : curve.pieces()) f(Geodesic_offset::internal::Face_in_space(curve, piece).corners);
}

// Common plane of the faces that curves cross.
// Throws std::invalid_argument if the faces do not lie in one plane.
template <class CurveRange>
Plane_of_faces plane_of_curves(const CurveRange& curves)
{
  const Plane_of_faces plane([&curves](const auto& f) {
    for (const auto& curve : curves) for_each_face(curve, f);
  });
  std::size_t number = 0;
  for (const auto& curve : curves)
  {
    for_each_face(curve, [&](const std::array<Space_vector, 3>& corners) {
      for (const Space_vector& p : corners)
        if (!plane.contains(p))
          throw std::invalid_argument("the curves do not lie in one plane: curve " + std::to_string(number) + ", at distance " +
                                      short_number(CGAL::to_double(curve.distance())) + ", crosses a face with the vertex (" +
                                      short_number(p.x()) + ", " + short_number(p.y()) + ", " + short_number(p.z()) +
                                      ") outside of the plane");
    });
    ++number;
  }
  return plane;
}

} // namespace CGAL::IO::Surface_mesh_geodesic_offset_internal

#endif
