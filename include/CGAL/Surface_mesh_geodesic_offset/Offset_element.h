// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_ELEMENT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_ELEMENT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Element_division.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/point_conversion.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents an element of an offset curve: a straight segment or a circular arc in space, across any number of faces that
are flat together.

Elements are what a drawing or a machine needs: the offset of a line over a plate is one segment, a rounded corner is one arc,
however many faces they cross. `Geodesic_offset_curve::elements()` makes them.

The start and the end of an element are points of the curve, and those of the next element. The normal is that of all its faces,
weighted by area; radius and center are those of the piece in its largest face, up to a factor of two of the sum of areas. All
numbers are rounded to `double` whatever the number type. An element is independent of its curve, which need not outlive it.

\tparam Surface_ an implementation detail; `Geodesic_offset_curve::Element` names the type
*/
template <class Surface_>
class Geodesic_offset_element
{
public:
  /// \name Types
  /// @{

  /// the number type of lengths and of coordinates
  typedef typename Surface_::FT FT;
  /// a point in space
  typedef typename Surface_::Point_3 Point_3;
  /// a vector in space
  typedef typename Surface_::Vector_3 Vector_3;
  /// a face of the mesh
  typedef typename Surface_::face_descriptor face_descriptor;
  /// @}

private:
  template <class>
  friend class Geodesic_offset_curve;

  template <class Curve>
  Geodesic_offset_element(const Curve& curve, const Geodesic_offset::internal::Element_division& division,
                          const Geodesic_offset::internal::Element_range& range)
    : m_start(division.piece(range.first).start), m_end(division.piece(range.first + range.count - 1).end),
      m_normal(range.normal), m_first(range.first), m_count(range.count), m_sweep(division.sweep(range)),
      m_source(curve.piece(range.first).source()), m_side(curve.piece(range.first).side())
  {
    if (is_arc())
    {
      m_center = range.center;
      m_radius = division.piece(range.reference).radius;
    }
    for (std::size_t k = 0; k < m_count; ++k)
    {
      const auto piece = curve.piece((m_first + k) % curve.number_of_pieces());
      if (m_source != piece.source()) m_source.reset();
      if (m_side != piece.side()) m_side.reset();
      if (m_faces.empty() || m_faces.back() != piece.face()) m_faces.push_back(piece.face());
    }
  }

public:
  /// \name Geometry
  /// @{

  /// whether the element is a straight segment.
  bool is_segment() const { return m_sweep == 0; }
  /// whether the element is an arc.
  bool is_arc() const { return !is_segment(); }

  /// the start of the element.
  Point_3 start() const { return exported(m_start); }
  /// the end of the element; the start if it is a whole circle.
  Point_3 end() const { return exported(m_end); }

  /// the outer unit normal of the plane of the element; the null vector if its faces have no area.
  Vector_3 normal() const { return exported(m_normal) - exported(NULL_VECTOR); }

  /// the center of an arc. \pre `is_arc()`
  Point_3 center() const
  {
    CGAL_precondition(is_arc());
    return exported(m_center);
  }

  /// the radius of an arc. \pre `is_arc()`
  FT radius() const
  {
    CGAL_precondition(is_arc());
    return FT(m_radius);
  }

  /// the angle of an arc in radians, from start to end, counterclockwise seen from the tip of `normal()`: positive, and
  /// \f$ 2 \pi \f$ for a whole circle up to rounding; 0 for a segment.
  FT sweep() const { return FT(m_sweep); }

  /// the length of the element, with an arc as an arc.
  FT length() const { return FT(is_arc() ? m_radius * m_sweep : Geodesic_offset::internal::length(m_end - m_start)); }

  /// the point at the parameter `t`, which runs from 0 at the start to 1 at the end, in proportion to length.
  Point_3 point(const FT& t) const
  {
    const double part = CGAL::to_double(t);
    if (is_segment()) return exported(m_start + part * (m_end - m_start));
    const Geodesic_offset::internal::Space_vector v = m_start - m_center;
    return exported(m_center + std::cos(part * m_sweep) * v + std::sin(part * m_sweep) * cross_product(m_normal, v));
  }
  /// @}

  /// \name Origin
  /// @{

  /// the id of the source that all points of the element are nearest to; empty if it passes from one source to another.
  std::optional<std::size_t> source() const { return m_source; }

  /// the side of the sources on which the element lies; empty if it lies on several. See `Geodesic_offset_piece::side()`.
  std::optional<Source_side> side() const { return m_side; }

  /// the faces that the element passes, in order.
  const std::vector<face_descriptor>& faces() const { return m_faces; }

  /// the index of the first piece. An element of a closed curve may contain its last piece and its first one: the pieces have
  /// the indices `first_piece()`, `first_piece() + 1`, ..., modulo `Geodesic_offset_curve::number_of_pieces()`.
  std::size_t first_piece() const { return m_first; }
  /// the number of pieces.
  std::size_t number_of_pieces() const { return m_count; }
  /// @}

private:
  static Point_3 exported(const Geodesic_offset::internal::Space_vector& v)
  {
    return Geodesic_offset::internal::converted_point<Point_3, FT>(v);
  }

  Geodesic_offset::internal::Space_vector m_start, m_end, m_normal, m_center = NULL_VECTOR;
  std::size_t m_first, m_count;
  double m_radius = 0, m_sweep;
  std::optional<std::size_t> m_source;
  std::optional<Source_side> m_side;
  std::vector<face_descriptor> m_faces;
};

} // namespace CGAL

#endif
