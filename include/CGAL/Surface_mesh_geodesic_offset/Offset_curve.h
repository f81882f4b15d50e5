// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_CURVE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_CURVE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_piece.h>

#include <CGAL/enum.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/range/iterator_range.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief An offset curve: an ordered, oriented chain of circular arcs and straight segments, each inside one face.

The curve is closed, or its ends lie on the border of the mesh; one that was cut where an `Offset_selection` ends may end
inside the surface. The smaller distances are on the left of the direction of travel, seen from the outside of the
surface. No curve meets itself or another one of the same distance.

The curve is exact, but for its number type; polylines are made of it only on output. Points on arcs, angles and lengths of
arcs are rounded to `double` whatever the number type. It refers to the mesh, which must outlive it, and shares the unfolded
mesh, which nothing changes, with its copies; the `Surface_mesh_geodesic_offset` need not outlive it. All member functions
are const and, with floating point numbers, may be called from several threads.

\tparam Surface_ internal
*/
template <class Surface_>
class Geodesic_offset_curve
{
  typedef Geodesic_offset::internal::Level_piece<typename Surface_::Number> Level_piece;
  typedef Geodesic_offset::internal::Curve_context<Surface_> Context;

  friend Context; // makes curves

  Geodesic_offset_curve(std::shared_ptr<const Context> context, const typename Surface_::FT& distance, bool closed,
                        std::vector<Level_piece> pieces)
    : m_context(std::move(context)), m_distance(distance), m_closed(closed), m_pieces(std::move(pieces))
  {
  }

public:
  typedef typename Surface_::FT FT;
  typedef typename Surface_::Point_3 Point_3;
  typedef typename Surface_::Face_location Face_location;

  /// a piece of the curve
  typedef Geodesic_offset_piece<Surface_> Piece;

  /// the distance from the sources that was asked for. With an inexact number type all points of the curve are at 1024
  /// units in the last place less: \f$1 - 2^{-42}\f$ times that with `double`.
  const FT& distance() const { return m_distance; }

  /// whether the curve is closed.
  bool is_closed() const { return m_closed; }

  /// the side on which the points lie that are nearer to the sources than the curve: always the left one.
  Orientation enclosed_side() const { return LEFT_TURN; }

  /// \name Pieces
  /// Each piece ends where the next one starts.
  /// @{

  /// the number of arcs and segments.
  std::size_t number_of_pieces() const { return m_pieces.size(); }

  /// the i-th piece. \pre `i < number_of_pieces()`
  Piece piece(std::size_t i) const
  {
    CGAL_precondition(i < m_pieces.size());
    return Piece(*m_context, m_pieces[i]);
  }

  /// all pieces, in order.
  auto pieces() const
  {
    const auto view = [context = m_context.get()](const Level_piece& p) { return Piece(*context, p); };
    return boost::make_iterator_range(boost::make_transform_iterator(m_pieces.begin(), view),
                                      boost::make_transform_iterator(m_pieces.end(), view));
  }
  /// @}

  /// \name Measure and Points
  /// `length()`, and points at a way along the curve, take time linear in the number of pieces; the others in that of the
  /// points that they write, which grows without a bound as the tolerance goes to 0.
  /// @{

  /// the length: of arcs as arcs, not of a polyline.
  FT length() const
  {
    FT sum(0);
    for (const Piece& p : pieces()) sum += p.length();
    return sum;
  }

  /// the point at a way along the curve from its start; 0 and less is the start, `length()` and more the end.
  Face_location location(const FT& way) const
  {
    FT rest = way;
    for (const Piece& p : pieces())
    {
      const FT l = p.length();
      if (rest < l) return p.location(rest / l);
      rest -= l;
    }
    return piece(m_pieces.size() - 1).end();
  }

  /// the same as a point in space.
  Point_3 point(const FT& way) const { return m_context->surface->point(location(way)); }

  /// calls `f(location, i)` for points along the curve, where `i` is the number of the piece that the point is taken from.
  /// The polyline through the points is nowhere farther from the curve than `chord_tolerance`: an arc of radius
  /// \f$ r \f$ is divided into equal parts of angle \f$ s \f$ with \f$ 2 r \sin^2 (s/4) \f$, the height of the arc over the
  /// chord, at most the tolerance, and both lie in the plane of one face. All points are on the curve. A closed curve
  /// repeats its first point at the end.
  /// \throws std::invalid_argument unless `chord_tolerance > 0`
  template <class Function>
  void discretize(const FT& chord_tolerance, const Function& f) const
  {
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
    {
      const Piece p = piece(i);
      if (i == 0) f(p.start(), i);
      p.for_each_inner_location(chord_tolerance, [&](const Face_location& l) { f(l, i); });
      // of the two faces beside an edge, the first and last points name the same
      f(m_closed && i + 1 == m_pieces.size() ? piece(0).start() : p.end(), i);
    }
  }

  /// writes points as by `discretize()`.
  /// \throws std::invalid_argument unless `chord_tolerance > 0`
  /// \param out an output iterator for `Face_location`
  template <class OutputIterator>
  OutputIterator face_locations(const FT& chord_tolerance, OutputIterator out) const
  {
    discretize(chord_tolerance, [&](const Face_location& l, std::size_t) { *out++ = l; });
    return out;
  }

  /// the same as points in space.
  /// \throws std::invalid_argument unless `chord_tolerance > 0`
  /// \param out an output iterator for `Point_3`
  template <class OutputIterator>
  OutputIterator points(const FT& chord_tolerance, OutputIterator out) const
  {
    discretize(chord_tolerance, [&](const Face_location& l, std::size_t) { *out++ = m_context->surface->point(l); });
    return out;
  }

  /// a location as a point in space.
  Point_3 point(const Face_location& location) const { return m_context->surface->point(location); }
  /// @}

private:
  std::shared_ptr<const Context> m_context;
  FT m_distance;
  bool m_closed;
  std::vector<Level_piece> m_pieces;
};

} // namespace CGAL

#endif
