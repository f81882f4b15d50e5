// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_PIECE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_PIECE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/chord_tolerance.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Curve_context.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Merge_error_code.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents a piece of an offset curve: a circular arc or a straight segment inside one face.

The geometry is given in the isometric frame of the face `f`, in which distances are those in space: the origin is the source
of `halfedge(f, tm)`, the x-axis runs along this halfedge, and the face is above the x-axis. The coordinates of a
`Face_location` are those with respect to the source of this halfedge, its target, and the third vertex.

Arcs run counterclockwise around their center and are shorter than a half turn, so that every piece has the smaller distances
on its left. The center is the image of the nearest source point, or of the vertex where the shortest paths bend last,
unfolded into the plane of the face; it may lie outside the face. If the curve has a tolerance, distances differ on both sides of an
edge by less than it. Then some pieces are segments along edges, with nearer points on one side only, and the center of an arc may be
another point that gives the distances within the tolerance.

A piece is a view of its curve, and valid as long as the curve is.

\tparam Surface_ an implementation detail; `Geodesic_offset_curve::Piece` names the type
*/
template <class Surface_>
class Geodesic_offset_piece
{
public:
  /// \name Types
  /// @{

  /// the number type of distances and of coordinates
  typedef typename Surface_::FT FT;
  /// a point in the frame of the face
  typedef typename Surface_::Kernel::Point_2 Point_2;
  /// a line in the frame of the face
  typedef typename Surface_::Kernel::Line_2 Line_2;
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
  typedef Geodesic_offset::internal::Level_piece<Number> Level_piece;
  typedef Geodesic_offset::internal::Point_in_face<Number> Point_in_face;
  typedef Geodesic_offset::internal::Curve_context<Surface_> Context;

  template <class>
  friend class Geodesic_offset_curve;

  Geodesic_offset_piece(const Context& context, const Level_piece& piece) : m_context(&context), m_piece(&piece) {}

public:
  /// \name Geometry
  /// @{

  /// the face whose interior or boundary contains the piece.
  face_descriptor face() const { return m_context->surface->face_of[m_piece->face]; }

  /// the index of `face()`: its value in the map of face indices, for meshes of %CGAL its number in `faces(tm)`.
  std::size_t face_index() const { return m_context->surface->index_in_mesh(face()); }

  /// whether the piece is a straight segment.
  bool is_segment() const { return m_piece->is_straight; }
  /// whether the piece is an arc.
  bool is_arc() const { return !is_segment(); }

  /// the center of an arc. \pre `is_arc()`
  Point_2 center() const
  {
    CGAL_precondition(is_arc());
    return public_point(m_piece->center);
  }

  /// the radius of an arc. \pre `is_arc()`
  FT radius() const
  {
    CGAL_precondition(is_arc());
    return Surface_::exported(m_piece->radius);
  }

  /// the line of a segment, in the direction of travel; the smaller distances are on its positive side. \pre `is_segment()`
  Line_2 supporting_line() const
  {
    CGAL_precondition(is_segment());
    // center: unit direction away from the source
    return Line_2(-Surface_::exported(m_piece->center.x), -Surface_::exported(m_piece->center.y),
                  Surface_::exported(m_piece->radius));
  }

  /// the start of the piece in the frame of the face.
  Point_2 start_2() const { return public_point(m_piece->start); }
  /// the end of the piece in the frame of the face.
  Point_2 end_2() const { return public_point(m_piece->end); }
  /// the start of the piece as a location.
  Face_location start() const { return location_of(m_piece->start, m_piece->start_edge); }
  /// the end of the piece as a location.
  Face_location end() const { return location_of(m_piece->end, m_piece->end_edge); }

  /// the angle of an arc, counterclockwise, from 0 to pi up to rounding; 0 for a segment.
  FT angle() const
  {
    if (is_segment()) return FT(0);
    return FT(std::atan2(CGAL::to_double(m_piece->turn_sine()), CGAL::to_double(m_piece->turn_cosine())));
  }

  /// the length of the piece, with an arc as an arc.
  FT length() const
  {
    if (is_segment()) return Surface_::exported(Geodesic_offset::internal::length(m_piece->end - m_piece->start));
    return radius() * angle();
  }

  /// the point at the parameter `t` in the frame of the face; `t` runs from 0 at the start to 1 at the end, in proportion to
  /// length.
  Point_2 point_2(const FT& t) const { return public_point(at(t, angle())); }
  /// the point at the parameter `t` as a location; see `point_2()`.
  Face_location location(const FT& t) const
  {
    if (!(t > FT(0))) return start();
    if (!(t < FT(1))) return end();
    return location_of(at(t, angle()), 3);
  }
  /// the point at the parameter `t` as a point in space; see `point_2()`.
  Point_3 point(const FT& t) const { return m_context->surface->point(location(t)); }

  /// the number of chords of equal length that are nowhere farther than `tolerance` from the piece. A chord spans an angle of
  /// 1e-7 at least, where the height of the arc is 1.25e-15 of the radius, its rounding. So the number is bounded by 31415927.
  /// \throws std::invalid_argument unless `tolerance > 0`
  std::size_t number_of_chords(const FT& tolerance) const { return number_of_chords(tolerance, angle()); }

  /// calls `f(location)` for the end points of the `number_of_chords()` chords that are strictly between the start and the
  /// end of the piece.
  /// \throws std::invalid_argument unless `tolerance > 0`
  template <class Function>
  void for_each_inner_location(const FT& tolerance, const Function& f) const
  {
    const FT all = angle();
    const std::size_t n = number_of_chords(tolerance, all);
    for (std::size_t j = 1; j < n; ++j) f(location_of(at(FT(double(j)) / FT(double(n)), all), 3));
  }
  /// @}

  /// \name Source
  /// @{

  /// the id of the source that all points of the piece are nearest to.
  std::size_t source() const { return primitive().source; }

  /// whether the nearest source points are inside a segment; otherwise all points of the piece have one nearest point.
  bool is_nearest_to_segment() const { return primitive().is_segment; }

  /// the part of the source that the piece is nearest to.
  /// - For a polyline: the index of the segment or of the point, from 0 in the order of the polyline. Segment i begins at point
  ///   i. Consecutive segments that are collinear after unfolding count as one; the index is that of one of them.
  /// - For a set of edges: the index of the edge in the range; if `!is_nearest_to_segment()`, the index of the vertex.
  /// - For a point: 0.
  std::size_t source_part() const { return primitive().part; }

  /// the side of the polyline on which the piece lies; `Source_side::NONE` for points and sets of edges,
  /// `Source_side::CAP` beyond an end of an open polyline.
  Source_side side() const { return m_piece->source_ref.side(); }

  /// the vertex where the shortest paths from the source to the points of the piece bend last, if they bend. With a tolerance, a
  /// piece may have the distances of several merged windows, and none is returned.
  std::optional<vertex_descriptor> pseudo_source() const
  {
    const Geodesic_offset::internal::Index vertex = m_piece->pseudo_source;
    if (vertex == Geodesic_offset::internal::no_index || Geodesic_offset::internal::Merge_error_code::is_merged(vertex))
      return std::nullopt;
    return m_context->surface->vertex_of[vertex];
  }
  /// @}

private:
  static Point_2 public_point(const Point_in_face& p) { return Point_2(Surface_::exported(p.x), Surface_::exported(p.y)); }

  Face_location location_of(const Point_in_face& p, int edge) const
  {
    return m_context->surface->location_inside(m_piece->face, p, edge);
  }

  const Geodesic_offset::internal::Source_primitive& primitive() const
  {
    return m_context->primitives[m_piece->source_ref.primitive()];
  }

  std::size_t number_of_chords(const FT& tolerance, const FT& angle) const
  {
    Geodesic_offset::internal::check_chord_tolerance(tolerance);
    if (is_segment()) return 1;
    // The height of an arc of radius r and angle s over its chord is r (1 - cos(s / 2)) = 2 r sin^2(s / 4).
    const double sine = std::sqrt(CGAL::to_double(tolerance) / (2 * CGAL::to_double(m_piece->radius)));
    const double largest = 4 * std::asin((std::min)(sine, 1.));
    const double n = std::ceil(CGAL::to_double(angle) / (std::max)(largest, Geodesic_offset::internal::least_chord_angle));
    return n > 1 ? std::size_t(n) : 1;
  }

  // `angle`: that of the piece.
  Point_in_face at(const FT& t, const FT& angle) const
  {
    if (is_segment()) return m_piece->start + Surface_::imported(t) * (m_piece->end - m_piece->start);
    const Point_in_face a = m_piece->start - m_piece->center;
    const double x = CGAL::to_double(t) * CGAL::to_double(angle);
    const Number c(std::cos(x)), s(std::sin(x));
    return m_piece->center + Point_in_face{c * a.x - s * a.y, s * a.x + c * a.y};
  }

  const Context* m_context;
  const Level_piece* m_piece;
};

} // namespace CGAL

#endif
