// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_CURVE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_CURVE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_element.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Curve_thinning.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/enum.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents an offset curve: an ordered, oriented chain of circular arcs and straight segments, each inside one face.

The curve is closed, or its ends lie on the border of the mesh; a curve of one side of the sources is cut where it leaves this
side, and may end inside the surface. The smaller distances are on the left of the direction of travel, seen from the outside
of the surface. No curve meets itself or another one of the same distance.

The curve is exact up to the rounding of its number type, unless the build had a tolerance; it becomes a polyline only on
output. Points on arcs, angles and lengths of arcs are rounded to `double` whatever the number type. The mesh must outlive the curve; the
`Surface_mesh_geodesic_offset` need not. Copies of the curve share the unfolded mesh, which is immutable. All member functions
are const and, with floating point numbers, may be called from several threads. A curve that was moved from has no pieces and
no elements: its length is 0, `discretize()` and the functions that write points write none, and those that return a point throw
`std::logic_error`.

\tparam Surface_ an implementation detail; `Surface_mesh_geodesic_offset::Offset_curve` names the type
*/
template <class Surface_>
class Geodesic_offset_curve
{
  typedef Geodesic_offset::internal::Level_piece<typename Surface_::Number> Level_piece;
  typedef Geodesic_offset::internal::Curve_context<Surface_> Context;

  friend Context; // makes and reads curves

  Geodesic_offset_curve(std::shared_ptr<const Context> context, const typename Surface_::FT& distance,
                        const typename Surface_::FT& tolerance, bool closed, std::vector<Level_piece> pieces)
    : m_context(std::move(context)), m_distance(distance), m_tolerance(tolerance), m_closed(closed), m_pieces(std::move(pieces))
  {
  }

public:
  /// \name Types
  /// @{

  /// the number type of distances and of coordinates
  typedef typename Surface_::FT FT;
  /// a point in space
  typedef typename Surface_::Point_3 Point_3;
  /// a point of the surface, see `Geodesic_mesh::Face_location`
  typedef typename Surface_::Face_location Face_location;
  /// a piece of the curve
  typedef Geodesic_offset_piece<Surface_> Piece;
  /// a segment or an arc of the curve in space
  typedef Geodesic_offset_element<Surface_> Element;
  /// a vector in space
  typedef typename Surface_::Vector_3 Vector_3;

  /// a point of the curve with its directions
  struct Oriented_point
  {
    std::size_t piece;      ///< the index of the piece
    Face_location location; ///< the point in the face of the piece
    Point_3 point;          ///< the point in space
    Vector_3 tangent;       ///< unit vector in the direction of travel; the null vector if the piece has no length
    Vector_3 normal;        ///< outer unit normal of the face; the null vector if the face has no area
  };
  /// @}

  /// the requested distance from the sources. With an inexact number type, all points of the curve are nearer by 1024 units
  /// in the last place: with `double`, at \f$1 - 2^{-42}\f$ times this distance.
  const FT& distance() const { return m_distance; }

  /// an upper bound of the largest exact distance in the region that the curves of this distance enclose, minus `distance()`: 0 if
  /// the build had no tolerance. See \ref SurfaceMeshGeodesicOffsetTolerance.
  const FT& tolerance() const { return m_tolerance; }

  /// whether the curve is closed.
  bool is_closed() const { return m_closed; }

  /// the side of the points that are nearer to the sources than the curve: always the left side.
  Orientation enclosed_side() const { return LEFT_TURN; }

  /// the side of the sources on which the whole curve lies; empty if it lies on several. Takes time linear in the number of pieces.
  std::optional<Source_side> side() const
  {
    for (const Piece& p : pieces())
      if (p.side() != piece(0).side()) return std::nullopt;
    if (m_pieces.empty()) return std::nullopt;
    return piece(0).side();
  }

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

  /// the curve as maximal segments and arcs in space, across faces that are flat together.
  ///
  /// Consecutive pieces are one element if they are parts of one line or of one circle, and if their faces lie in one plane: their
  /// ends and their middle are within the tolerance of the line or circle, and the corners of their faces within the tolerance of
  /// the plane. Rounding is allowed in addition, 1e-12 of the coordinates and 1e-9 of the length of the element and of its radius.
  /// So a tolerance of 0 is right for meshes whose flat parts are flat up to the rounding of `double`. For other meshes, for
  /// instance with coordinates of seven digits, the tolerance is some errors of the points. Pieces shorter than rounding, where the
  /// curve passes a vertex, belong to the element before.
  ///
  /// Each element ends where the next one starts. The elements cover the curve; an element of a closed curve may contain the start
  /// of `piece(0)`, and is then the first element, unless the start was chosen. A closed curve that is a circle is one element.
  ///
  /// Takes time \f$ O(n \log a) \f$ for \f$ n \f$ pieces, if the sum of the areas of their faces is \f$ a \f$ times the smallest.
  /// \param tolerance a length; not negative
  /// \throws std::invalid_argument unless `tolerance >= 0`
  /// \throws std::logic_error if the mesh has lengths instead of points
  std::vector<Element> elements(const FT& tolerance) const
  {
    if (!(tolerance >= FT(0))) throw std::invalid_argument("Surface_mesh_geodesic_offset: a tolerance must not be negative");
    const Geodesic_offset::internal::Element_division division(*this, CGAL::to_double(tolerance));
    std::vector<Element> result;
    for (const auto& range : division.ranges()) result.push_back(Element(*this, division, range));
    return result;
  }
  /// @}

  /// \name Measure and Points
  /// `length()`, and points at a given arc length, take time linear in the number of pieces. `discretize()` and
  /// `face_locations()` divide the curve piece by piece, for callers who need to know where the curve is on the surface; they
  /// take time linear in the number of points, which is bounded by `Piece::number_of_chords()` for each piece as the tolerance
  /// goes to 0. `points()` writes as few points as the tolerance allows, for all other purposes; it takes time
  /// \f$ O(n \log n) \f$ for \f$ n \f$ points of `discretize()`.
  /// @{

  /// the length of the curve itself, with arcs as arcs, not of a polyline.
  FT length() const
  {
    FT sum(0);
    for (const Piece& p : pieces()) sum += p.length();
    return sum;
  }

  /// the point at a given arc length from the start, as a location. 0 and less is the start, `length()` and more is the end.
  Face_location location(const FT& way) const
  {
    context(); // or an exception
    FT rest = way;
    for (const Piece& p : pieces())
    {
      const FT l = p.length();
      if (rest < l) return p.location(rest / l);
      rest -= l;
    }
    return piece(m_pieces.size() - 1).end();
  }

  /// the point at a given arc length from the start, as a point in space.
  Point_3 point(const FT& way) const { return context().surface->point(location(way)); }

  /// the point of the i-th piece at the parameter `t`, with its directions; see `Piece::point_2()`.
  /// \pre `i < number_of_pieces()`
  Oriented_point oriented_point(std::size_t i, const FT& t) const
  {
    using namespace Geodesic_offset::internal;
    const Piece p = piece(i);
    const Piece_in_space in_space(*this, p, space_vector(point(p.start())), space_vector(point(p.end())));
    const Face_location l = p.location(t);
    const Point_3 q = point(l);
    return {i, l, q, exported(in_space.tangent(space_vector(q))), exported(in_space.normal)};
  }

  /// writes points of the curve that are evenly spaced by arc length, with their directions.
  ///
  /// The curve is divided into equal parts that are as long as possible but no longer than `spacing`; a closed curve has three
  /// parts at least. The points are the ends of the parts: the first and last points of an open curve are its ends, a closed curve
  /// starts at the start of `piece(0)` and repeats this point at the end. Lengths are rounded to `double`. Takes time linear in
  /// the numbers of pieces and points.
  /// \param spacing a length
  /// \param out an output iterator for `Oriented_point`
  /// \throws std::invalid_argument unless `spacing > 0`
  /// \throws std::length_error if there are more than 20,000,000 points, before any output
  template <class OutputIterator>
  OutputIterator points_at_spacing(const FT& spacing, OutputIterator out) const
  {
    const std::size_t parts = Geodesic_offset::internal::number_of_parts(*this, spacing), n = m_pieces.size();
    if (n == 0) return out;
    const double step = CGAL::to_double(length()) / double(parts);
    double before = 0; // arc length at the start of the piece
    std::size_t j = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      const double l = CGAL::to_double(piece(i).length());
      for (; j < parts && (double(j) * step < before + l || i + 1 == n); ++j)
        *out++ = oriented_point(i, FT(l > 0 ? (double(j) * step - before) / l : 0.));
      before += l;
    }
    *out++ = m_closed ? oriented_point(0, FT(0)) : oriented_point(n - 1, FT(1));
    return out;
  }

  /// the normal of the surface at a location as if the surface were smooth: the unit vector of the normals of the corners,
  /// interpolated with the coordinates of the location. The normal of a vertex is the sum of the outer unit normals of its faces,
  /// weighted by their angles; faces without area do not count. For machines with five axes and for shading, where normals of
  /// faces would jump at edges. The null vector if the sum is 0.
  /// \throws std::invalid_argument if the face of the location is null, removed or of another mesh
  Vector_3 smooth_normal(const Face_location& location) const
  {
    using namespace Geodesic_offset::internal;
    context().surface->checked_index_of(location.first);
    const auto& tm = m_context->surface->tm;
    const auto at = [&](auto v) { return space_vector(m_context->surface->position(v)); };
    Space_vector sum = NULL_VECTOR;
    auto h = prev(halfedge(location.first, tm), tm);
    for (const FT& weight : location.second)
    {
      Space_vector normal = NULL_VECTOR; // of the target of h
      for (const auto g : halfedges_around_target(h, tm))
      {
        if (is_border(g, tm)) continue;
        const Space_vector v = at(target(g, tm)), a = at(source(g, tm)) - v, b = at(target(next(g, tm), tm)) - v;
        const Space_vector area = cross_product(b, a);
        const double l = Geodesic_offset::internal::length(area);
        if (l > 0) normal = normal + (std::atan2(l, a * b) / l) * area;
      }
      const double l = Geodesic_offset::internal::length(normal);
      if (l > 0) sum = sum + (CGAL::to_double(weight) / l) * normal;
      h = next(h, tm);
    }
    const double l = Geodesic_offset::internal::length(sum);
    return exported(l > 0 ? Space_vector(sum / l) : sum);
  }

  /// the closed curve with another start: the point of the i-th piece at the parameter `t` from 0 to 1, see `Piece::point_2()`.
  ///
  /// Inside a piece, the start divides it in two. `points()`, `elements()` and the files then begin there, too. Takes time linear
  /// in the number of pieces.
  /// \pre `is_closed()` and `i < number_of_pieces()`
  Geodesic_offset_curve starting_at(std::size_t i, const FT& t) const
  {
    CGAL_precondition(m_closed && i < m_pieces.size());
    Geodesic_offset_curve result = *this;
    std::vector<Level_piece>& pieces = result.m_pieces;
    if (t > FT(0) && t < FT(1))
    {
      pieces.insert(pieces.begin() + std::ptrdiff_t(i), pieces[i]);
      pieces[i].end = pieces[i + 1].start = piece(i).at(t, piece(i).angle());
      pieces[i].end_edge = pieces[i + 1].start_edge = 3;
    }
    std::rotate(pieces.begin(), pieces.begin() + std::ptrdiff_t(t > FT(0) ? i + 1 : i), pieces.end());
    result.m_has_chosen_start = true;
    return result;
  }

  /// whether the start was chosen with `starting_at()`.
  bool has_chosen_start() const { return m_has_chosen_start; }

  /// calls `f(location, i)` for points along the curve, where `i` is the index of the piece that contains the point.
  ///
  /// Both ends of each piece are among the points, so two consecutive points share the face of a piece.
  /// The polyline through the points is nowhere farther from the curve than `chord_tolerance`: an arc of radius
  /// \f$ r \f$ is divided into equal parts of an angle \f$ s \f$ such that the height of the arc over its chord,
  /// \f$ 2 r \sin^2 (s/4) \f$, is at most the tolerance; an arc and its chords lie in the plane of one face. All points are on
  /// the curve. A closed curve repeats its first point at the end.
  ///
  /// Rounding limits the tolerance: it has no effect below 1.25e-15 of the radius, see `Piece::number_of_chords()`.
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

  /// writes the points of `discretize()` as locations.
  /// \throws std::invalid_argument unless `chord_tolerance > 0`
  /// \param out an output iterator for `Face_location`
  template <class OutputIterator>
  OutputIterator face_locations(const FT& chord_tolerance, OutputIterator out) const
  {
    discretize(chord_tolerance, [&](const Face_location& l, std::size_t) { *out++ = l; });
    return out;
  }

  /// writes points of the curve for a polyline within a tolerance, as points in space.
  ///
  /// The Frechet distance of the polyline from the curve is at most `chord_tolerance`, up to rounding: nowhere is the
  /// polyline farther from the curve, or the curve from the polyline. Chords pass the edges of the mesh: where the curve is
  /// straight within the tolerance across several faces, there is one segment. There are no more points than those of
  /// `discretize()`, except that a closed curve has four points at least, the last one being the first.
  ///
  /// All points are on the curve. The first and last points of an open curve are its ends. A closed curve repeats its first
  /// point at the end, which need not be the start of `piece(0)`, unless that was chosen: it is the end of a piece, at the sharpest
  /// turn. The polyline of a closed curve has three different vertices at least, however large the tolerance. Where a level is the
  /// distance of a ridge up to rounding, a closed curve may lie on one line: then there are two or three points.
  /// \throws std::invalid_argument unless `chord_tolerance > 0`
  /// \throws std::length_error if the curve has more than 20,000,000 chords in `discretize()`, before any output. The points
  ///         need up to 200 bytes of memory per chord.
  /// \param chord_tolerance a length
  /// \param out an output iterator for `Point_3`
  template <class OutputIterator>
  OutputIterator points(const FT& chord_tolerance, OutputIterator out) const
  {
    for (const Geodesic_offset::internal::Curve_point& p : Geodesic_offset::internal::thinned_points(*this, chord_tolerance))
      *out++ = point(p.location(*this));
    return out;
  }

  /// the point in space of a location.
  /// \throws std::invalid_argument if the face of the location is null, removed or of another mesh
  Point_3 point(const Face_location& location) const
  {
    context().surface->checked_index_of(location.first);
    return m_context->surface->point(location);
  }
  /// @}

private:
  static Vector_3 exported(const Geodesic_offset::internal::Space_vector& v)
  {
    return Element::exported(v) - Element::exported(NULL_VECTOR);
  }

  const Context& context() const
  {
    if (!m_context) throw std::logic_error("Surface_mesh_geodesic_offset: an offset curve that was moved from has no points");
    return *m_context;
  }

  std::shared_ptr<const Context> m_context;
  FT m_distance, m_tolerance;
  bool m_closed, m_has_chosen_start = false;
  std::vector<Level_piece> m_pieces;
};

} // namespace CGAL

#endif
