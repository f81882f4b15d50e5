// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A point, a segment, a triangle or a circular arc in a face, and the range of distances from an image to it.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_FACE_PIECE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_FACE_PIECE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Rotation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_offset::internal {

inline Double_double_2 middle_of(const Double_double_2& p, const Double_double_2& q)
{
  const Double_double x = p.x + q.x, y = p.y + q.y;
  return {{0.5 * x.high, 0.5 * x.low}, {0.5 * y.high, 0.5 * y.low}};
}

inline Point_in_face<double> difference(const Double_double_2& p, const Double_double_2& q)
{
  return {(p.x.high - q.x.high) + (p.x.low - q.x.low), (p.y.high - q.y.high) + (p.y.low - q.y.low)};
}

// The frame is that of a halfedge of the face. The convex hull of `hull` contains the piece: a point (one), a segment (two) or
// a triangle (three). An arc has its ends and the intersection of the tangents there; it runs counterclockwise and is shorter
// than a half turn.
struct Face_piece
{
  typedef Point_in_face<double> Point;

  int size;
  Double_double_2 hull[3];
  bool is_arc;
  Double_double_2 center;
  double radius;
  double clamped; // how far a point of the hull was moved to bring it above the x axis

  static Face_piece point(const Double_double_2& p) { return {1, {p, p, p}, false, {}, 0., 0.}; }
  static Face_piece segment(const Double_double_2& p, const Double_double_2& q) { return {2, {p, q, q}, false, {}, 0., 0.}; }
  static Face_piece triangle(const Double_double_2& p, const Double_double_2& q, const Double_double_2& r)
  {
    return {3, {p, q, r}, false, {}, 0., 0.};
  }
  // Arcs that turn backwards, by rounding, are segments.
  static Face_piece arc(const Double_double_2& p, const Double_double_2& q, const Double_double_2& center, double radius)
  {
    const Point a = difference(p, center), b = difference(q, center);
    if (!(cross(a, b) > 0)) return segment(p, q);
    Face_piece result{3, {p, q, q}, true, center, radius, 0.};
    const Point u = result.bisector();
    result.hull[2] = result.on_ray(u, radius / (std::max)(dot(u, a) / length(a), 0x1p-20));
    return result;
  }

  // True if the tangents of an arc meet near it.
  bool is_short() const
  {
    return !is_arc || dot(difference(hull[0], center), difference(hull[1], center)) > 0.5 * radius * radius;
  }

  // How far the ends of an arc are off its circle.
  double off_circle() const
  {
    if (!is_arc) return 0;
    const double a = std::abs(length(difference(hull[0], center)) - radius);
    return (std::max)(a, std::abs(length(difference(hull[1], center)) - radius));
  }

  // How far rounding may have put the points that divide an arc, and the intersection of its tangents, from where they are.
  double rounding() const { return is_arc ? 64 * unit_roundoff * (radius + length(Point{center.x.high, center.y.high})) : 0.; }

  double diameter() const
  {
    double d = 0;
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < i; ++j) d = (std::max)(d, length(difference(hull[i], hull[j])));
    return d;
  }

  // A point of the piece.
  Double_double_2 inner_point() const
  {
    if (size == 1) return hull[0];
    if (is_arc) return on_ray(bisector(), radius);
    const Double_double_2 m = middle_of(hull[0], hull[1]);
    return size == 2 ? m : middle_of(m, hull[2]);
  }

  // Two parts whose union is the piece.
  std::pair<Face_piece, Face_piece> halves() const
  {
    if (is_arc)
    {
      const Double_double_2 m = on_ray(bisector(), radius);
      return {arc(hull[0], m, center, radius), arc(m, hull[1], center, radius)};
    }
    if (size == 2)
    {
      const Double_double_2 m = middle_of(hull[0], hull[1]);
      return {segment(hull[0], m), segment(m, hull[1])};
    }
    int longest = 0;
    double most = -1;
    for (int k = 0; k < 3; ++k)
      if (const double d = length(difference(hull[k], hull[(k + 1) % 3])); d > most)
      {
        most = d;
        longest = k;
      }
    const Double_double_2 &p = hull[longest], &q = hull[(longest + 1) % 3], &r = hull[(longest + 2) % 3];
    const Double_double_2 m = middle_of(p, q);
    return {triangle(p, m, r), triangle(m, q, r)};
  }

  // In the frame of the next halfedge of its face.
  Face_piece in_next_frame(const Certified_mesh& mesh, Index h) const
  {
    const Double_double_2& c = mesh[mesh.unfolded().next(h)].corner;
    const Rotation rotate({-c.x, c.y});
    Face_piece result(*this);
    for (int i = 0; i < size; ++i) result.hull[i] = rotate({hull[i].x - mesh[h].length, hull[i].y});
    if (is_arc) result.center = rotate({center.x - mesh[h].length, center.y});
    return result;
  }

  // With a hull above the x axis. The piece is in the closed face, but the tangents of its ends may meet beyond an edge.
  Face_piece above_axis() const
  {
    Face_piece result(*this);
    for (int i = 0; i < size; ++i)
      if (hull[i].y.high < 0)
      {
        result.clamped = (std::max)(result.clamped, -hull[i].y.high);
        result.hull[i].y = Double_double(0.);
      }
    return result;
  }

  // The range of the distances from a point to the points of the piece.
  Bounds distances_from(const Double_double_2& a) const
  {
    Point v[3];
    for (int i = 0; i < size; ++i) v[i] = difference(hull[i], a);
    if (is_arc)
    {
      const Point c = difference(center, a);
      const double d = length(c), first = length(v[0]), second = length(v[1]);
      Bounds result((std::min)(first, second), (std::max)(first, second));
      const Point to_image = d > 0 ? (-1 / d) * c : Point{1, 0};
      if (d == 0 || has_direction(to_image)) result.first = (std::min)(result.first, std::abs(d - radius));
      if (d == 0 || has_direction(-1. * to_image)) result.second = (std::max)(result.second, d + radius);
      return result;
    }
    double most = 0;
    for (int i = 0; i < size; ++i) most = (std::max)(most, length(v[i]));
    if (size == 1) return {most, most};
    double least = near_segment(v[0], v[1]);
    if (size == 3)
    {
      const double a0 = cross(v[0], v[1]), a1 = cross(v[1], v[2]), a2 = cross(v[2], v[0]);
      // Far from a small triangle, all signs may be those of rounding. A point inside is no farther from a corner than the
      // longest side; twice as far is outside.
      const bool is_inside = ((a0 >= 0 && a1 >= 0 && a2 >= 0) || (a0 <= 0 && a1 <= 0 && a2 <= 0)) && most <= 2 * diameter();
      least = is_inside ? 0. : (std::min)({least, near_segment(v[1], v[2]), near_segment(v[2], v[0])});
    }
    return {least, most};
  }

  // The range of the scalar product with a unit vector.
  Bounds products_with(const Point& n) const
  {
    const int ends = is_arc ? 2 : size;
    Bounds result(infinite(), -infinite());
    for (int i = 0; i < ends; ++i)
    {
      const double d = n.x * hull[i].x.high + n.y * hull[i].y.high;
      result.first = (std::min)(result.first, d);
      result.second = (std::max)(result.second, d);
    }
    if (is_arc)
    {
      const double c = n.x * center.x.high + n.y * center.y.high;
      if (has_direction(n)) result.second = (std::max)(result.second, c + radius);
      if (has_direction(-1. * n)) result.first = (std::min)(result.first, c - radius);
    }
    return result;
  }

  static double near_segment(const Point& u, const Point& v)
  {
    const Point w = v - u;
    const double square = dot(w, w), t = square > 0 ? -dot(u, w) / square : 0.;
    return t <= 0 ? length(u) : t >= 1 ? length(v) : length(u + t * w);
  }

  // True if an arc may contain the point in the direction of a unit vector from its center.
  bool has_direction(const Point& u) const
  {
    const Point a = difference(hull[0], center), b = difference(hull[1], center);
    const double slack = 0x1p-46 * radius; // rounding of the products
    return cross(a, u) >= -slack && cross(u, b) >= -slack && dot(a + b, u) >= 0;
  }

private:
  static double infinite() { return Number_policy<double>::infinity(); }

  // From the center to the middle of the arc.
  Point bisector() const
  {
    const Point a = difference(hull[0], center), b = difference(hull[1], center);
    const Point sum = a + b, u = dot(a, b) > 0 ? sum : Point{b.y - a.y, a.x - b.x};
    return (1 / length(u)) * u;
  }

  Double_double_2 on_ray(const Point& u, double t) const
  {
    return {center.x + Double_double(t * u.x), center.y + Double_double(t * u.y)};
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
