// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pieces of offset curves in a common plane, as arcs and segments in its coordinates. An arc that edges of the mesh divide
// is joined again.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_PLANE_PIECES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_INTERNAL_PLANE_PIECES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::IO::Surface_mesh_geodesic_offset_internal {

typedef std::array<double, 2> Plane_point;

inline Plane_point moved(const Plane_point& p, double s, const Plane_point& v) { return {p[0] + s * v[0], p[1] + s * v[1]}; }

// A segment, or an arc with a center.
struct Plane_piece
{
  Plane_point start{}, end{};
  Plane_point center{}; // unit direction for a segment
  double radius = 0;
  double sweep = 0; // angle of an arc, positive if counterclockwise; 0: a segment

  bool is_arc() const { return sweep != 0; }

  // Point of an arc at parameter `part`, from 0 to 1.
  Plane_point at(double part) const
  {
    const double c = std::cos(part * sweep), s = std::sin(part * sweep);
    const double x = start[0] - center[0], y = start[1] - center[1];
    return {center[0] + c * x - s * y, center[1] + s * x + c * y};
  }
};

// Corners of the face of a piece: source and target of its halfedge, and the third corner.
template <class Curve>
std::array<Coordinates, 3> corners(const Curve& curve, const typename Curve::Piece& piece)
{
  typedef typename Curve::FT FT;
  typedef typename Curve::Face_location Face_location;
  const auto corner = [&](int i) {
    return coordinates(curve.point(Face_location(piece.face(), {FT(i == 0), FT(i == 1), FT(i == 2)})));
  };
  return {corner(0), corner(1), corner(2)};
}

// The point between the pieces i - 1 and i. The faces of the two pieces round it differently, so both pieces use this
// function.
template <class Curve>
Coordinates joint(const Curve& curve, std::size_t i)
{
  const std::size_t n = curve.number_of_pieces();
  if (i == 0 || (i == n && curve.is_closed())) return coordinates(curve.point(curve.piece(0).start()));
  return coordinates(curve.point(curve.piece(i - 1).end()));
}

// Frame of a face in the plane, given by the images of its corners.
class Frame_in_plane
{
public:
  Frame_in_plane(const Plane_point& a, const Plane_point& b, const Plane_point& c) : m_origin(a)
  {
    const double x = b[0] - a[0], y = b[1] - a[1], length = std::hypot(x, y);
    m_x = {x / length, y / length};
    m_turn = x * (c[1] - a[1]) - y * (c[0] - a[0]) < 0 ? -1 : 1;
    m_y = {-m_turn * m_x[1], m_turn * m_x[0]};
  }

  template <class Vector_2>
  Plane_point vector(const Vector_2& v) const
  {
    return moved(moved({0, 0}, CGAL::to_double(v.x()), m_x), CGAL::to_double(v.y()), m_y);
  }

  template <class Point_2>
  Plane_point point(const Point_2& p) const
  {
    return moved(vector(p), 1, m_origin);
  }

  // -1 if the face is seen from behind, where orientations are reversed.
  int turn() const { return m_turn; }

private:
  Plane_point m_origin, m_x, m_y;
  int m_turn;
};

// Tolerances for pieces on one circle or line: `same_point` is relative to the coordinates, which have rounding errors of
// some units in the last place, 1e-16 each; `same_curve` is relative to the radius and the lengths. Windows that crossed k
// faces have image errors of some k units; the latter tolerance allows for 1e6 faces and is far below the precision of a
// drawing.
constexpr double same_point = 1e-12, same_curve = 1e-9;

inline double plane_distance(const Plane_point& p, const Plane_point& q) { return std::hypot(p[0] - q[0], p[1] - q[1]); }

inline double largest_coordinate(const Plane_point& p, const Plane_point& q)
{
  return (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(q[0]), std::abs(q[1])});
}

// Angle of an arc seen from another center; the sweep of the arc, up to less than a half turn.
inline double sweep_about(const Plane_point& center, const Plane_piece& arc)
{
  const double x = arc.start[0] - center[0], y = arc.start[1] - center[1];
  const double z = arc.end[0] - center[0], w = arc.end[1] - center[1];
  const double angle = std::atan2(x * w - y * z, x * z + y * w);
  return angle + 2 * CGAL_PI * std::round((arc.sweep - angle) / (2 * CGAL_PI));
}

// True if q, which starts at the end of p, continues p on the same circle or line.
inline bool is_continued(const Plane_piece& p, const Plane_piece& q)
{
  if (p.is_arc() != q.is_arc()) return false;
  const double tolerance =
    same_point * (p.radius + (std::max)(largest_coordinate(p.start, p.end), largest_coordinate(q.start, q.end))) +
    same_curve * (p.radius + plane_distance(p.start, p.end) + plane_distance(q.start, q.end));
  const auto is_on_curve = [&](const Plane_point& x) {
    if (p.is_arc()) return std::abs(plane_distance(x, p.center) - p.radius) <= tolerance;
    return std::abs((x[0] - p.start[0]) * p.center[1] - (x[1] - p.start[1]) * p.center[0]) <= tolerance;
  };
  if (!is_on_curve(q.end)) return false;
  if (!p.is_arc()) return p.center[0] * q.center[0] + p.center[1] * q.center[1] > 0;
  return p.sweep * q.sweep > 0 && is_on_curve(q.at(0.5)) && p.sweep * sweep_about(p.center, q) > 0;
}

// Appends the continuation q to p.
inline void add_continuation(Plane_piece& p, const Plane_piece& q)
{
  if (p.is_arc()) p.sweep += sweep_about(p.center, q);
  p.end = q.end;
}

// Pieces `first`, ..., `first + count - 1` of a curve, cyclically if it is closed. `project` maps coordinates isometrically
// to a plane that contains these pieces.
template <class Curve, class Project>
std::vector<Plane_piece> plane_pieces(const Curve& curve, std::size_t first, std::size_t count, const Project& project)
{
  const std::size_t n = curve.number_of_pieces();
  std::vector<Plane_piece> pieces;
  Plane_piece p;
  p.start = project(joint(curve, first));
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::size_t i = (first + k) % n;
    const typename Curve::Piece piece = curve.piece(i);
    const std::array<Coordinates, 3> face = corners(curve, piece);
    const Frame_in_plane frame(project(face[0]), project(face[1]), project(face[2]));
    p.end = project(joint(curve, i + 1));
    p.sweep = frame.turn() * CGAL::to_double(piece.angle());
    // no longer than rounding errors
    if (plane_distance(p.start, p.end) <= same_point * largest_coordinate(p.start, p.end)) continue;
    if (piece.is_arc() && p.sweep == 0) continue;
    if (piece.is_arc())
    {
      p.center = frame.point(piece.center());
      p.radius = CGAL::to_double(piece.radius());
    }
    else
    {
      p.center = frame.vector(piece.supporting_line().to_vector());
      p.radius = 0;
    }
    if (!pieces.empty() && is_continued(pieces.back(), p)) add_continuation(pieces.back(), p);
    else pieces.push_back(p);
    p.start = p.end;
  }
  if (pieces.empty())
  {
    p.sweep = 0;
    pieces.push_back(p);
  }
  pieces.back().end = p.end;
  return pieces;
}

// All pieces of a curve.
template <class Curve, class Project>
std::vector<Plane_piece> plane_pieces(const Curve& curve, const Project& project)
{
  std::vector<Plane_piece> pieces = plane_pieces(curve, 0, curve.number_of_pieces(), project);
  if (curve.is_closed() && pieces.size() > 1 && is_continued(pieces.back(), pieces.front()))
  {
    add_continuation(pieces.back(), pieces.front());
    pieces.front() = pieces.back();
    pieces.pop_back();
  }
  return pieces;
}

// Divides an arc into equal parts of at most the given angle; calls f(piece) for each part, or for a segment.
template <class Function>
void for_each_part(const Plane_piece& piece, double largest_sweep, const Function& f)
{
  const int n = (std::max)(1, int(std::ceil(std::abs(piece.sweep) / largest_sweep)));
  Plane_piece part = piece;
  part.sweep = piece.sweep / n;
  for (int i = 1; i <= n; ++i)
  {
    part.end = i == n ? piece.end : piece.at(double(i) / n);
    f(part);
    part.start = part.end;
  }
}

} // namespace CGAL::IO::Surface_mesh_geodesic_offset_internal

#endif
