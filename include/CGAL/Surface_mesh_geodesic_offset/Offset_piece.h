// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_PIECE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_PIECE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Chord_tolerance.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Curve_context.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_piece.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief A piece of an offset curve: a circular arc or a straight segment inside one face.

Its geometry is given in the face's own isometric frame: a point of the plane of the face is the same distance from others
there as in space; the origin is the source of `halfedge(f, tm)`, the x-axis runs along this halfedge, and the face is above
it. `Face_location`s have their coordinates with respect to the source of that halfedge, its target, and the third vertex.

Arcs run counterclockwise round their center and are shorter than a half turn; so every piece has the smaller distances on
its left. The center is the image of the nearest source point, or of the vertex where the shortest paths bend last, unfolded
into the plane of the face; it may lie outside of the face.

A piece is a view: it is valid as long as the curve that it comes from.

\tparam Surface_ internal
*/
template <class Surface_>
class Geodesic_offset_piece
{
public:
  typedef typename Surface_::FT FT;
  typedef typename Surface_::Kernel::Point_2 Point_2;
  typedef typename Surface_::Kernel::Line_2 Line_2;
  typedef typename Surface_::Point_3 Point_3;
  typedef typename Surface_::Face_location Face_location;
  typedef typename Surface_::Triangle_mesh Triangle_mesh;
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Triangle_mesh>::face_descriptor face_descriptor;

private:
  typedef typename Surface_::Number Number;
  typedef Geodesic_offset::internal::Level_piece<Number> Level_piece;
  typedef Geodesic_offset::internal::Point_in_face<Number> Point_in_face;
  typedef Geodesic_offset::internal::Curve_context<Surface_> Context;

public:
  Geodesic_offset_piece(const Context& context, const Level_piece& piece) : m_context(&context), m_piece(&piece) {}

  /// \name Geometry
  /// @{

  /// the face that the piece lies in, or on whose edge.
  face_descriptor face() const { return m_context->surface->face_of[m_piece->face]; }

  /// whether it is a straight segment, or else an arc.
  bool is_segment() const { return m_piece->is_straight; }
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

  /// where the piece starts and ends, in the frame of the face, and as locations.
  Point_2 start_2() const { return public_point(m_piece->start); }
  Point_2 end_2() const { return public_point(m_piece->end); }
  Face_location start() const { return location_of(m_piece->start, m_piece->start_edge); }
  Face_location end() const { return location_of(m_piece->end, m_piece->end_edge); }

  /// the angle that an arc turns by, counterclockwise, from 0 to pi, but for rounding; 0 for a segment.
  FT angle() const
  {
    if (is_segment()) return FT(0);
    return FT(std::atan2(CGAL::to_double(m_piece->turn_sine()), CGAL::to_double(m_piece->turn_cosine())));
  }

  /// the length: of an arc as an arc.
  FT length() const
  {
    if (is_segment()) return Surface_::exported(Geodesic_offset::internal::length(m_piece->end - m_piece->start));
    return radius() * angle();
  }

  /// the point at a parameter that runs from 0 at the start to 1 at the end, in proportion to length.
  Point_2 point_2(const FT& t) const { return public_point(at(t, angle())); }
  Face_location location(const FT& t) const
  {
    if (!(t > FT(0))) return start();
    if (!(t < FT(1))) return end();
    return location_of(at(t, angle()), 3);
  }
  Point_3 point(const FT& t) const { return m_context->surface->point(location(t)); }

  /// the number of chords of equal length that stay nowhere farther than `tolerance` from the piece.
  /// \throws std::invalid_argument unless `tolerance > 0`
  std::size_t number_of_chords(const FT& tolerance) const { return number_of_chords(tolerance, angle()); }

  /// calls `f(location)` for the ends of these chords between the start and the end of the piece.
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

  /// whether the nearest source points are those of a segment; otherwise they are one point.
  bool is_nearest_to_segment() const { return primitive().is_segment; }

  /// of a polyline: the number of the nearest segment, or of the nearest point, in the order given, from 0. Segment i
  /// begins at point i. Segments that follow each other in a straight line, unfolded, act as one: then it is the number of
  /// one of them. Of a set of edges: the number of the edge; if `!is_nearest_to_segment()`, the index of the vertex.
  /// 0 for a source point.
  std::size_t source_part() const { return primitive().part; }

  /// the side of the polyline.
  Source_side side() const { return m_piece->root.side(); }

  /// the vertex where the shortest paths to all points of the piece bend last; `null_vertex()` if they are straight.
  vertex_descriptor pseudo_source() const
  {
    if (m_piece->pseudo_source == Geodesic_offset::internal::no_index)
      return boost::graph_traits<Triangle_mesh>::null_vertex();
    return m_context->surface->vertex_of[m_piece->pseudo_source];
  }
  /// @}

private:
  static Point_2 public_point(const Point_in_face& p) { return Point_2(Surface_::exported(p.x), Surface_::exported(p.y)); }

  Face_location location_of(const Point_in_face& p, int edge) const
  {
    return m_context->surface->location(m_piece->face, p, edge);
  }

  const Geodesic_offset::internal::Source_primitive& primitive() const
  {
    return m_context->primitives[m_piece->root.primitive()];
  }

  std::size_t number_of_chords(const FT& tolerance, const FT& angle) const
  {
    Geodesic_offset::internal::check_chord_tolerance(tolerance);
    if (is_segment()) return 1;
    // The height of an arc of radius r and angle s over its chord is r (1 - cos(s / 2)) = 2 r sin^2(s / 4).
    const double sine = std::sqrt(CGAL::to_double(tolerance) / (2 * CGAL::to_double(m_piece->radius)));
    const double largest = 4 * std::asin((std::min)(sine, 1.));
    const double n = std::ceil(CGAL::to_double(angle) / (std::max)(largest, 1e-7));
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
