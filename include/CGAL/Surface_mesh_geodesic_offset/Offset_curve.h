// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_CURVE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_CURVE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_surface.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Level_piece.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief An offset curve: an ordered chain of circular arcs and straight segments, each inside one face, closed or from
border to border, with the smaller distances on its left seen from the outside of the surface.

The curve is exact; polylines are made of it only on output. It refers to the mesh, which must outlive it. All member
functions are const and may be called from several threads.

\tparam Surface_ internal
*/
template <class Surface_>
class Geodesic_offset_curve
{
  typedef Geodesic_offset::internal::Level_piece<typename Surface_::FT> Level_piece;
  typedef Geodesic_offset::internal::Point_in_face<typename Surface_::FT> Point_2;

public:
  typedef typename Surface_::FT FT;
  typedef typename Surface_::Point_3 Point_3;
  typedef typename Surface_::Face_location Face_location;

  Geodesic_offset_curve(std::shared_ptr<const Surface_> surface, const FT& distance, bool closed,
                        std::vector<Level_piece> pieces)
    : m_surface(std::move(surface)), m_distance(distance), m_closed(closed), m_pieces(std::move(pieces))
  {
  }

  /// the distance of all points of the curve from the sources.
  const FT& distance() const { return m_distance; }

  /// whether the curve is closed; otherwise both its ends lie on the border of the mesh.
  bool is_closed() const { return m_closed; }

  /// the number of arcs and segments.
  std::size_t number_of_pieces() const { return m_pieces.size(); }

  /// the length: of arcs as arcs, not of a polyline. Linear in the number of pieces.
  FT length() const
  {
    FT sum(0);
    for (const Level_piece& p : m_pieces) sum += length(p);
    return sum;
  }

  /// writes points along the curve, as `Face_location`s, such that the polyline through them is nowhere farther
  /// from the curve than `chord_tolerance`. All points are on the curve. A closed curve repeats its first point at the end.
  /// \pre `chord_tolerance > 0`
  template <class OutputIterator>
  OutputIterator face_locations(const FT& chord_tolerance, OutputIterator out) const
  {
    CGAL_precondition(chord_tolerance > FT(0));
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
    {
      const Level_piece& p = m_pieces[i];
      if (i == 0) *out++ = m_surface->location(p.face, p.start, p.start_edge);
      const int n = number_of_chords(p, chord_tolerance);
      const FT angle = n > 1 ? turn(p) : FT(0);
      for (int j = 1; j < n; ++j) *out++ = m_surface->location(p.face, rotated(p, angle * FT(double(j)) / FT(double(n))));
      if (m_closed && i + 1 == m_pieces.size())
        *out++ = m_surface->location(m_pieces[0].face, m_pieces[0].start, m_pieces[0].start_edge);
      else
        *out++ = m_surface->location(p.face, p.end, p.end_edge);
    }
    return out;
  }

  /// the same as points in space.
  template <class OutputIterator>
  OutputIterator points(const FT& chord_tolerance, OutputIterator out) const
  {
    std::vector<Face_location> locations;
    face_locations(chord_tolerance, std::back_inserter(locations));
    for (const Face_location& l : locations) *out++ = m_surface->point(l);
    return out;
  }

private:
  static FT length(const Level_piece& p)
  {
    if (p.is_straight) return Geodesic_offset::internal::length(p.end - p.start);
    return p.radius * turn(p);
  }

  // The angle of an arc, counterclockwise.
  static FT turn(const Level_piece& p)
  {
    const Point_2 a = p.start - p.center, b = p.end - p.center;
    const double s = CGAL::to_double(Geodesic_offset::internal::cross(a, b));
    const double c = CGAL::to_double(Geodesic_offset::internal::dot(a, b));
    const double angle = std::atan2(s, c);
    // arcs are shorter than a half turn, so a negative angle is rounding of zero ... unless it is a wide one
    if (angle >= 0) return FT(angle);
    return angle > -1e-3 ? FT(0) : FT(angle + 2 * CGAL_PI);
  }

  static int number_of_chords(const Level_piece& p, const FT& tolerance)
  {
    if (p.is_straight) return 1;
    const double r = CGAL::to_double(p.radius), t = CGAL::to_double(tolerance), a = CGAL::to_double(turn(p));
    // sagitta of a chord over the angle s: r (1 - cos(s / 2))
    const double s = t < r ? 2 * std::acos(1 - t / r) : CGAL_PI;
    const double n = std::ceil(a / (std::min)(s > 1e-7 ? s : 1e-7, CGAL_PI / 2));
    return n > 1 ? int((std::min)(n, 1e6)) : 1;
  }

  static Point_2 rotated(const Level_piece& p, const FT& angle)
  {
    const Point_2 a = p.start - p.center;
    const double x = CGAL::to_double(angle);
    const FT c(std::cos(x)), s(std::sin(x));
    return p.center + Point_2{c * a.x - s * a.y, s * a.x + c * a.y};
  }

  std::shared_ptr<const Surface_> m_surface;
  FT m_distance;
  bool m_closed;
  std::vector<Level_piece> m_pieces;
};

} // namespace CGAL

#endif
