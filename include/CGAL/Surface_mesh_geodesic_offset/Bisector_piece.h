// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_BISECTOR_PIECE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_BISECTOR_PIECE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/chord_tolerance.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Curve_context.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_arc.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {

/// \ingroup PkgSurfaceMeshGeodesicOffsetEnums
/// the curves of which pieces of bisectors are parts.
enum class Geodesic_bisector_kind {
  SEGMENT,  ///< a straight line: between equally weighted points, or two segments
  PARABOLA, ///< between a point and a segment
  HYPERBOLA ///< between two points with different distances from their sources
};

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents a piece of a bisector: a segment, or an arc of a parabola or hyperbola, inside one face.

All points of a piece are equally far from the sources on its two sides, and no source is nearer. On each side the shortest
paths start at one image, a point or a line, unfolded into the plane of the face. The frame of the face is that of
`Geodesic_offset_piece`.

A piece is a view of its curve, and valid as long as the curve is.

\tparam Surface_ an implementation detail; `Geodesic_bisector::Piece` names the type
*/
template <class Surface_>
class Geodesic_bisector_piece
{
public:
  /// \name Types
  /// @{

  /// the number type of distances and of coordinates
  typedef typename Surface_::FT FT;
  /// a point in the frame of the face
  typedef typename Surface_::Kernel::Point_2 Point_2;
  /// a point in space
  typedef typename Surface_::Point_3 Point_3;
  /// a point of the surface, see `Geodesic_mesh::Face_location`
  typedef typename Surface_::Face_location Face_location;
  /// the mesh
  typedef typename Surface_::Triangle_mesh Triangle_mesh;
  /// a vertex of the mesh
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor vertex_descriptor;
  /// a face of the mesh
  typedef typename boost::graph_traits<Triangle_mesh>::face_descriptor face_descriptor;
  /// @}

private:
  typedef typename Surface_::Number Number;
  typedef Geodesic_offset::internal::Bisector_arc<double> Arc;
  typedef Geodesic_offset::internal::Bisector_side Side;
  typedef Geodesic_offset::internal::Point_in_face<double> Point_in_face;
  typedef Geodesic_offset::internal::Curve_context<Surface_> Context;

  template <class>
  friend class Geodesic_bisector;

  Geodesic_bisector_piece(const Context& context, const Arc& arc) : m_context(&context), m_arc(&arc) {}

public:
  /// \name Geometry
  /// @{

  /// the face whose interior or boundary contains the piece.
  face_descriptor face() const { return m_context->surface->face_of[m_arc->face]; }

  /// the kind of the curve.
  Geodesic_bisector_kind kind() const
  {
    if (m_arc->is_straight()) return Geodesic_bisector_kind::SEGMENT;
    return m_arc->conic.kind() == Geodesic_offset::internal::Bisector_conic<double>::PARABOLA
           ? Geodesic_bisector_kind::PARABOLA
           : Geodesic_bisector_kind::HYPERBOLA;
  }

  /// whether the piece is a straight segment.
  bool is_segment() const { return m_arc->is_straight(); }
  /// whether the piece is an arc of a parabola or hyperbola.
  bool is_arc() const { return !is_segment(); }

  /// the start of the piece in the frame of the face.
  Point_2 start_2() const { return public_point(m_arc->start); }
  /// the end of the piece in the frame of the face.
  Point_2 end_2() const { return public_point(m_arc->end); }
  /// the start of the piece as a location.
  Face_location start() const { return location_of(m_arc->start, m_arc->start_edge); }
  /// the end of the piece as a location.
  Face_location end() const { return location_of(m_arc->end, m_arc->end_edge); }

  /// the point at the parameter `t` in the frame of the face; `t` runs from 0 at the start to 1 at the end. It is not in
  /// proportion to length.
  Point_2 point_2(const FT& t) const { return public_point(at(CGAL::to_double(t))); }
  /// the point at the parameter `t` as a location; see `point_2()`.
  Face_location location(const FT& t) const
  {
    if (!(t > FT(0))) return start();
    if (!(t < FT(1))) return end();
    return location_of(at(CGAL::to_double(t)), 3);
  }
  /// the point at the parameter `t` as a point in space; see `point_2()`.
  Point_3 point(const FT& t) const { return m_context->surface->point(location(t)); }

  /// the number of chords between equidistant parameters that are nowhere farther than `tolerance` from the piece, at most
  /// 10,000,000.
  /// \throws std::invalid_argument unless `tolerance > 0`
  std::size_t number_of_chords(const FT& tolerance) const
  {
    Geodesic_offset::internal::check_chord_tolerance(tolerance);
    if (is_segment()) return 1;
    const double n = m_arc->conic.number_of_chords(m_arc->from, m_arc->to, CGAL::to_double(tolerance));
    return n > 1 ? std::size_t((std::min)(n, 1e7)) : 1;
  }

  /// calls `f(location)` for the end points of the `number_of_chords()` chords that are strictly between the start and the
  /// end of the piece.
  /// \throws std::invalid_argument unless `tolerance > 0`
  template <class Function>
  void for_each_inner_location(const FT& tolerance, const Function& f) const
  {
    const std::size_t n = number_of_chords(tolerance);
    for (std::size_t j = 1; j < n; ++j) f(location_of(at(double(j) / double(n)), 3));
  }
  /// @}

  /// \name Sources
  /// @{

  /// the id of the source whose cell is on the left of the piece.
  std::size_t source_on_left() const { return m_arc->left.label; }
  /// the id of the source whose cell is on the right of the piece.
  std::size_t source_on_right() const { return m_arc->right.label; }

  /// the vertex where the shortest paths to the source on the left bend first, seen from the piece, if they bend.
  std::optional<vertex_descriptor> pseudo_source_on_left() const { return pseudo_source(m_arc->left); }
  /// the vertex where the shortest paths to the source on the right bend first, seen from the piece, if they bend.
  std::optional<vertex_descriptor> pseudo_source_on_right() const { return pseudo_source(m_arc->right); }
  /// @}

private:
  static Point_2 public_point(const Point_in_face& p)
  {
    return Point_2(Surface_::exported(Number(p.x)), Surface_::exported(Number(p.y)));
  }

  Face_location location_of(const Point_in_face& p, int edge) const
  {
    return m_context->surface->location_inside(m_arc->face, {Number(p.x), Number(p.y)}, edge);
  }

  Point_in_face at(double t) const
  {
    if (m_arc->is_link) return m_arc->start + t * (m_arc->end - m_arc->start);
    return m_arc->conic.at(m_arc->conic.between(m_arc->from, m_arc->to, t)).point();
  }

  std::optional<vertex_descriptor> pseudo_source(const Side& side) const
  {
    if (side.pseudo_source == Geodesic_offset::internal::no_index) return std::nullopt;
    return m_context->surface->vertex_of[side.pseudo_source];
  }

  const Context* m_context;
  const Arc* m_arc;
};

} // namespace CGAL

#endif
