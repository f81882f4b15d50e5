// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The curves of one level, sorted by what they pass: arcs by face, crossings by edge. From both and the sides of the vertices,
// the area that lies nearer than the level follows by Green's theorem.

#ifndef GEODESIC_OFFSET_TEST_LEVEL_LAYOUT_H
#define GEODESIC_OFFSET_TEST_LEVEL_LAYOUT_H

#include "geodesic_types.h"
#include "search_tolerances.h"
#include "validation/Validation_surface.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace test {

typedef CGAL::Geodesic_offset::internal::Validation_surface<Geodesic> Judged_surface;
typedef CGAL::Geodesic_offset::internal::Point_in_face<double> Point_in_face;

template <class Point>
Point_in_face plain(const Point& p)
{
  return {p.x(), p.y()};
}

/// A piece of an offset curve as plane geometry, in the frame of its face: counterclockwise round `center`, or straight with
/// the unit normal `center` away from the smaller distances at `radius` from the origin.
struct Curve_arc
{
  bool is_straight;
  Point_in_face start, end, center;
  double radius, angle;

  /// `piece`: a `Geodesic_offset_piece`, or a type with the same functions
  template <class Piece>
  explicit Curve_arc(const Piece& piece)
    : is_straight(piece.is_segment()), start(plain(piece.start_2())), end(plain(piece.end_2())),
      angle(piece.angle())
  {
    if (is_straight)
    {
      const auto line = piece.supporting_line();
      const double norm = std::hypot(line.a(), line.b());
      center = {-line.a() / norm, -line.b() / norm};
      radius = line.c() / norm;
    }
    else
    {
      center = plain(piece.center());
      radius = piece.radius();
    }
  }

  /// The distance of a point from the whole circle or line.
  double off(const Point_in_face& p) const
  {
    return std::abs((is_straight ? dot(center, p) : length(p - center)) - radius);
  }

  /// Whether the segment from p to q crosses the arc an odd number of times: its chord separates them, or one of them lies
  /// between the chord and the arc. The height of an arc over its chord is at most r s^2 / 8.
  bool separates(const Point_in_face& p, const Point_in_face& q) const
  {
    const bool p_left = is_left(start, end, p), q_left = is_left(start, end, q);
    const bool crosses_chord = p_left != q_left && is_left(p, q, start) != is_left(p, q, end);
    return (crosses_chord != is_under(p, p_left)) != is_under(q, q_left);
  }

  /// Twice the area that the arc sweeps, seen from o.
  double twice_area_from(const Point_in_face& o) const
  {
    const double triangle = cross(start - o, end - o);
    return is_straight ? triangle : triangle + radius * radius * minus_sine(angle);
  }

private:
  /// In radians: the height of an arc with a smaller angle over its chord is less than 2^-48 radii, which is rounding.
  static constexpr double flat_arc = 0x1p-23;

  static bool is_left(const Point_in_face& a, const Point_in_face& b, const Point_in_face& p)
  {
    return cross(b - a, p - a) > 0;
  }
  bool is_under(const Point_in_face& p, bool is_left_of_chord) const
  {
    return !is_straight && angle > flat_arc && !is_left_of_chord && length(p - center) < radius;
  }
  static double minus_sine(double s)
  {
    return s < 0.1 ? s * s * s / 6 * (1 - s * s / 20 * (1 - s * s / 42 * (1 - s * s / 72)))
                   : s - std::sin(s);
  }
};

/// Where a curve crosses an edge: `t` from the source of the smaller one of its halfedges, `step` 1 where the near region
/// begins along this halfedge, -1 where it ends.
struct Edge_crossing
{
  double t;
  int step;
};

class Level_layout
{
public:
  typedef CGAL::Geodesic_offset::internal::Index Index;
  typedef Judged_surface::Face Face;

  explicit Level_layout(const Judged_surface& surface)
    : surface_(surface), arcs_(surface.number_of_faces()), crossings_(3 * surface.number_of_faces())
  {}

  void clear()
  {
    for (const Index f : faces_) arcs_[f].clear();
    for (const Index e : edges_) crossings_[e].clear();
    faces_.clear();
    edges_.clear();
  }

  /// \name Curves
  /// @{
  void add_arc(Index face, const Curve_arc& arc)
  {
    if (arcs_[face].empty()) faces_.push_back(face);
    arcs_[face].push_back(arc);
  }

  /// Records where a curve goes from one face to the next; false if the pieces are in different faces and do not meet on an
  /// edge of both.
  template <class Piece>
  bool add_joint(const Piece& a, const Piece& b)
  {
    const auto end = a.end(), start = b.start();
    const Index f = surface_.index_of(end.first), g = surface_.index_of(start.first);
    if (f == g) return true;
    for (Index k = 0; k < 3; ++k)
    { // coordinate k + 2 is zero on halfedge k
      const Index twin = surface_.twin(3 * f + k);
      if (end.second[(k + 2) % 3] != 0 || twin == none || twin / 3 != g ||
          start.second[(twin % 3 + 2) % 3] != 0)
        continue;
      add_crossing(3 * f + k, end.second[(k + 1) % 3], 1);
      return true;
    }
    return false;
  }

  /// Records where an open curve starts or ends; false if that is not on the border.
  template <class Piece>
  bool add_end(const Piece& piece, bool is_start)
  {
    const auto l = is_start ? piece.start() : piece.end();
    const Index f = surface_.index_of(l.first);
    for (Index k = 0; k < 3; ++k)
      if (l.second[(k + 2) % 3] == 0 && surface_.twin(3 * f + k) == none)
      {
        add_crossing(3 * f + k, l.second[(k + 1) % 3], is_start ? -1 : 1);
        return true;
      }
    return false;
  }

  /// All of a curve; false if its pieces do not fit together.
  template <class Curve>
  bool add(const Curve& curve)
  {
    const std::size_t n = curve.number_of_pieces();
    bool fits = n > 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      const auto piece = curve.piece(i);
      add_arc(surface_.index_of(piece.face()), Curve_arc(piece));
      if (i + 1 < n || curve.is_closed()) fits = add_joint(piece, curve.piece((i + 1) % n)) && fits;
    }
    if (fits && !curve.is_closed())
      fits = add_end(curve.piece(0), true) && add_end(curve.piece(n - 1), false);
    return fits;
  }
  /// @}

  const std::vector<Curve_arc>& arcs(Index face) const { return arcs_[face]; }
  const std::vector<Index>& crossed_faces() const { return faces_; } // in the order of curves

  /// `edge`: the smaller one of its halfedges
  std::vector<Edge_crossing>& crossings(Index edge) { return crossings_[edge]; }

  /// The area of the near part of a face. `is_near(v)`: the side of a vertex.
  template <class Sides>
  double near_area(const Face& face, const Sides& is_near) const
  {
    const Point_in_face o = (1. / 3) * (face.corner[0] + (face.corner[1] + face.corner[2]));
    double twice_area = 0;
    for (const Curve_arc& arc : arcs_[face.face]) twice_area += arc.twice_area_from(o);
    // the third of the height over an edge is that of the centroid
    for (int k = 0; k < 3; ++k)
      twice_area += face.height((k + 2) % 3) / 3 *
                    near_length(3 * face.face + Index(k), face.edge_length(k), is_near);
    return twice_area / 2;
  }

private:
  static constexpr Index none = CGAL::Geodesic_offset::internal::no_index;

  // `part`: along the halfedge. The near region is on the left of a curve, so it begins where a curve leaves the face.
  void add_crossing(Index halfedge, double part, int step)
  {
    const Index twin = surface_.twin(halfedge), e = (std::min)(halfedge, twin);
    const double length = surface_.edge_length(e), t = part * length;
    if (crossings_[e].empty()) edges_.push_back(e);
    if (e == halfedge) crossings_[e].push_back({t, step});
    else crossings_[e].push_back({length - t, -step});
  }

  // The length of the near part of a halfedge.
  template <class Sides>
  double near_length(Index h, double length, const Sides& is_near) const
  {
    const Index e = (std::min)(h, surface_.twin(h));
    double result = is_near(surface_.origin(e)) ? length : 0;
    for (const Edge_crossing& c : crossings_[e]) result += c.step * (length - c.t);
    return result;
  }

  const Judged_surface& surface_;
  std::vector<std::vector<Curve_arc>> arcs_;          // by face
  std::vector<std::vector<Edge_crossing>> crossings_; // by edge
  std::vector<Index> faces_, edges_;                  // of which these are not empty
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_LEVEL_LAYOUT_H
