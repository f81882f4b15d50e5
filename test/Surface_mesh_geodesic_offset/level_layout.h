// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The curves of one level: arcs by face, crossings by edge. Together with the sides of the vertices they determine the area
// of the near region by Green's theorem.

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

/// Plane geometry of a piece of an offset curve in the face frame: counterclockwise around `center`, or straight with unit
/// normal `center` away from the smaller distances, at distance `radius` from the origin.
struct Curve_arc
{
  bool is_straight;
  Point_in_face start, end, center;
  double radius, angle;

  /// `piece`: a `Geodesic_offset_piece`, or a type with the same functions
  template <class Piece>
  explicit Curve_arc(const Piece& piece)
    : is_straight(piece.is_segment()), start(plain(piece.start_2())), end(plain(piece.end_2())), angle(piece.angle())
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

  /// Distance of a point from the whole circle or line.
  double off(const Point_in_face& p) const { return std::abs((is_straight ? dot(center, p) : length(p - center)) - radius); }

  /// Whether the segment from p to q crosses the arc an odd number of times: its chord separates them, or one of them lies
  /// between the chord and the arc. The height of an arc over its chord is at most r s^2 / 8.
  bool separates(const Point_in_face& p, const Point_in_face& q) const
  {
    const bool p_left = is_left(start, end, p), q_left = is_left(start, end, q);
    const bool crosses_chord = p_left != q_left && is_left(p, q, start) != is_left(p, q, end);
    return (crosses_chord != is_under(p, p_left)) != is_under(q, q_left);
  }

  /// Twice the area swept by the ray from o to the arc.
  double twice_area_from(const Point_in_face& o) const
  {
    const double triangle = cross(start - o, end - o);
    return is_straight ? triangle : triangle + radius * radius * minus_sine(angle);
  }

private:
  /// In radians: the height over its chord of an arc with a smaller angle is less than 2^-48 radii, below rounding.
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
    return s < 0.1 ? s * s * s / 6 * (1 - s * s / 20 * (1 - s * s / 42 * (1 - s * s / 72))) : s - std::sin(s);
  }
};

/// Crossing of a curve with an edge: `t` from the source of the smaller of its halfedges; `step` is 1 if the near region
/// begins along this halfedge, -1 if it ends.
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
  {
  }

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

  /// Records the transition of a curve between two faces; returns false if the pieces are in different faces and do not
  /// meet on a common edge.
  template <class Piece>
  bool add_joint(const Piece& a, const Piece& b)
  {
    const auto end = a.end(), start = b.start();
    const Index f = surface_.index_of(end.first), g = surface_.index_of(start.first);
    if (f == g) return true;
    for (Index k = 0; k < 3; ++k)
    { // coordinate k + 2 is zero on halfedge k
      const Index twin = surface_.twin(3 * f + k);
      if (end.second[(k + 2) % 3] != 0 || twin == none || twin / 3 != g || start.second[(twin % 3 + 2) % 3] != 0) continue;
      add_crossing(3 * f + k, end.second[(k + 1) % 3], 1);
      return true;
    }
    return false;
  }

  /// Records the start or end of an open curve; returns false if it is not on the border.
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

  /// Records a whole curve; returns false if its pieces do not fit together.
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
    if (fits && !curve.is_closed()) fits = add_end(curve.piece(0), true) && add_end(curve.piece(n - 1), false);
    return fits;
  }
  /// @}

  const std::vector<Curve_arc>& arcs(Index face) const { return arcs_[face]; }
  const std::vector<Index>& crossed_faces() const { return faces_; } // in the order of curves

  /// `edge`: the smaller of its halfedges
  std::vector<Edge_crossing>& crossings(Index edge) { return crossings_[edge]; }

  /// Area of the near part of a face. `is_near(v)`: side of a vertex.
  template <class Sides>
  double near_area(const Face& face, const Sides& is_near) const
  {
    const Point_in_face o = (1. / 3) * (face.corner[0] + (face.corner[1] + face.corner[2]));
    double twice_area = 0;
    for (const Curve_arc& arc : arcs_[face.face]) twice_area += arc.twice_area_from(o);
    // a third of the height over an edge is the height of the centroid
    for (int k = 0; k < 3; ++k)
      twice_area += face.height((k + 2) % 3) / 3 * near_length(3 * face.face + Index(k), face.edge_length(k), is_near);
    return twice_area / 2;
  }

private:
  static constexpr Index none = CGAL::Geodesic_offset::internal::no_index;

  // `part`: parameter on the halfedge. The near region is on the left of a curve, so it begins at an exit from the face.
  void add_crossing(Index halfedge, double part, int step)
  {
    const Index twin = surface_.twin(halfedge), e = (std::min)(halfedge, twin);
    const double length = surface_.edge_length(e), t = part * length;
    if (crossings_[e].empty()) edges_.push_back(e);
    if (e == halfedge) crossings_[e].push_back({t, step});
    else crossings_[e].push_back({length - t, -step});
  }

  // Length of the near part of a halfedge.
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
  std::vector<Index> faces_, edges_;                  // with at least one arc, or crossing
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_LEVEL_LAYOUT_H
