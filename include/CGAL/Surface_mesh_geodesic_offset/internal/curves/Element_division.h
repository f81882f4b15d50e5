// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Division of an offset curve into maximal segments and arcs in space.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_ELEMENT_DIVISION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_ELEMENT_DIVISION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

typedef Simple_cartesian<double>::Vector_3 Space_vector;

inline double length(const Space_vector& v) { return std::hypot(v.x(), v.y(), v.z()); }

inline double largest_coordinate(const Space_vector& v)
{
  return (std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
}

// Numbers and points of the user in double. The sum with 0 makes -0 positive.
template <class Point_3>
Space_vector space_vector(const Point_3& p)
{
  return Space_vector(CGAL::to_double(p.x()) + 0., CGAL::to_double(p.y()) + 0., CGAL::to_double(p.z()) + 0.);
}

// A vector of length 1, or 0.
inline Space_vector unit_vector(const Space_vector& v)
{
  const double l = length(v);
  return l > 0 ? space_vector(v / l) : Space_vector(NULL_VECTOR);
}

// Corners of a face in space, and the frame of the face, see Geodesic_offset_piece.
struct Face_in_space
{
  template <class Curve>
  Face_in_space(const Curve& curve, const typename Curve::Piece& piece)
  {
    typedef typename Curve::FT FT;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = space_vector(curve.point(typename Curve::Face_location(piece.face(), {FT(i == 0), FT(i == 1), FT(i == 2)})));
    x = corners[1] - corners[0];
    x = x / length(x);
    normal = area_vector(corners);
    area = length(normal);
    normal = unit_vector(normal);
    y = cross_product(normal, x);
  }

  static Space_vector area_vector(const std::array<Space_vector, 3>& c) { return cross_product(c[1] - c[0], c[2] - c[0]); }

  template <class Vector_2>
  Space_vector vector(const Vector_2& v) const
  {
    return CGAL::to_double(v.x()) * x + CGAL::to_double(v.y()) * y;
  }

  std::array<Space_vector, 3> corners;
  Space_vector x, y, normal; // normal: outer unit normal; 0 if the corners lie on one line
  double area;               // twice the area
};

// A piece of a curve in space. `center` is the unit direction for a segment.
struct Piece_in_space : Face_in_space
{
  // start, end: points between pieces, which the faces of both pieces round differently
  template <class Curve>
  Piece_in_space(const Curve& curve, const typename Curve::Piece& piece, const Space_vector& start, const Space_vector& end)
    : Face_in_space(curve, piece), start(start), middle(end), end(end), angle(CGAL::to_double(piece.angle())),
      is_arc(piece.is_arc() && area > 0)
  {
    is_point = length(end - start) <= same_point * (std::max)(largest_coordinate(start), largest_coordinate(end)) ||
               (is_arc && angle == 0);
    if (is_arc)
    {
      middle = space_vector(piece.point(typename Curve::FT(0.5)));
      center = corners[0] + vector(piece.center() - ORIGIN);
      radius = CGAL::to_double(piece.radius());
    }
    else if (piece.is_segment() && area > 0) center = vector(piece.supporting_line().to_vector());
    else if (!is_point) center = (end - start) / length(end - start);
  }

  // Unit direction of travel at a point of the piece; 0 if the piece is a point.
  Space_vector tangent(const Space_vector& p) const { return unit_vector(is_arc ? cross_product(normal, p - center) : center); }

  // Tolerances for pieces on one circle or line: `same_point` is relative to the coordinates, which have rounding errors of
  // some units in the last place, 1e-16 each; `same_curve` is relative to the radius and the lengths. Windows that crossed k
  // faces have image errors of some k units; the latter tolerance allows for 1e6 faces and is far below the precision of a
  // drawing or a machine.
  static constexpr double same_point = 1e-12, same_curve = 1e-9;

  Space_vector start, middle, end, center = NULL_VECTOR;
  double radius = 0, angle;
  bool is_arc, is_point; // is_point: no longer than rounding errors
};

// Consecutive pieces on one line or circle, cyclically for a closed curve. The line or circle is that of the reference, the piece
// in the largest face, since thin and small faces have rounded frames. The plane is that of all faces, weighted by area, so that
// rounded coordinates of points average out. Both are updated when the sum of areas has doubled.
struct Element_range
{
  std::size_t first, count;
  std::size_t largest, reference; // piece in the largest face, now and at the last update
  double area = 0, area_of_update = 0;
  Space_vector areas = NULL_VECTOR, moments = NULL_VECTOR; // sums of area vectors, and of centroids weighted by areas
  Space_vector normal = NULL_VECTOR, point = NULL_VECTOR;  // the plane
  Space_vector center = NULL_VECTOR;                       // of the arc, in the plane; unit direction for a segment
};

// Pieces of a curve in space, and their maximal ranges on one line or circle each.
//
// Time O(n log a) for n pieces, if the sum of the areas of their faces is a times the smallest one.
class Element_division
{
public:
  template <class Curve>
  Element_division(const Curve& curve, double tolerance) : m_tolerance(tolerance)
  {
    const std::size_t n = curve.number_of_pieces();
    m_pieces.reserve(n);
    Space_vector start = n > 0 ? space_vector(curve.point(curve.piece(0).start())) : Space_vector(NULL_VECTOR);
    for (std::size_t i = 0; i < n; ++i)
    {
      const auto piece = curve.piece(i);
      const bool is_last = i > 0 && i + 1 == n && curve.is_closed();
      const Space_vector end = is_last ? m_pieces[0].start : space_vector(curve.point(piece.end()));
      m_pieces.emplace_back(curve, piece, start, end);
      start = end;
    }
    for (std::size_t i = 0; i < n; ++i)
      if (m_ranges.empty() || !extend(m_ranges.back(), i)) m_ranges.push_back(range_of(i));
    if (curve.is_closed() && !curve.has_chosen_start() && m_ranges.size() > 1) join_ends();
  }

  const std::vector<Element_range>& ranges() const { return m_ranges; }
  const Piece_in_space& piece(std::size_t i) const { return m_pieces[i % m_pieces.size()]; }

  // Angle of an arc about its center, up to a whole turn; 0 for a segment.
  double sweep(const Element_range& r) const
  {
    const Piece_in_space& p = m_pieces[r.reference];
    if (!p.is_arc || p.is_point) return 0;
    double sum = 0;
    for (std::size_t k = 0; k < r.count; ++k) sum += piece(r.first + k).angle;
    if (r.count == 1) return sum;
    const Space_vector v = piece(r.first).start - r.center, w = piece(r.first + r.count - 1).end - r.center;
    const double angle = std::atan2(cross_product(v, w) * r.normal, v * w);
    return angle + 2 * CGAL_PI * std::round((sum - angle) / (2 * CGAL_PI));
  }

private:
  Element_range range_of(std::size_t i) const
  {
    Element_range r;
    r.first = r.largest = i;
    r.count = 0;
    add(r, i);
    update(r);
    return r;
  }

  void add(Element_range& r, std::size_t i) const
  {
    const Piece_in_space& p = m_pieces[i];
    ++r.count;
    if (p.is_point && r.count > 1) return;
    if (p.area > m_pieces[r.largest].area) r.largest = i;
    r.area += p.area;
    r.areas = r.areas + p.area * p.normal;
    r.moments = r.moments + (p.area / 3) * (p.corners[0] + p.corners[1] + p.corners[2]);
  }

  void update(Element_range& r) const
  {
    const Piece_in_space& p = m_pieces[r.reference = r.largest];
    r.area_of_update = r.area;
    r.normal = unit_vector(r.areas);
    r.point = length(r.areas) > 0 ? r.moments / r.area : p.start;
    r.center = p.center - (p.is_arc ? (p.center - r.point) * r.normal : p.center * r.normal) * r.normal;
  }

  // Appends piece i if it is along the range.
  bool extend(Element_range& r, std::size_t i) const
  {
    if (m_pieces[r.reference].is_point && !m_pieces[i].is_point) // only points so far
    {
      const Element_range points = r;
      r = range_of(i);
      r.first = points.first;
      r.count += points.count;
      return true;
    }
    Element_range longer = r;
    add(longer, i);
    if (longer.area > 2 * r.area_of_update)
    {
      update(longer);
      bool are_along = true;
      for (std::size_t k = 0; are_along && k < longer.count; ++k) are_along = is_along(longer, piece(longer.first + k));
      if (are_along)
      {
        r = longer;
        return true;
      }
    }
    if (!is_along(r, m_pieces[i])) return false;
    add(r, i);
    if (longer.area_of_update > r.area_of_update) r.area_of_update = longer.area_of_update; // later again
    return true;
  }

  // True if a piece runs along the line or circle of a range, in its plane and its direction, or is a point.
  bool is_along(const Element_range& r, const Piece_in_space& q) const
  {
    if (q.is_point) return true;
    const Piece_in_space& p = m_pieces[r.reference];
    if (p.is_arc != q.is_arc) return false;
    const auto is_near = [&](double off, const Space_vector& v, double size) {
      return std::abs(off) <=
             m_tolerance + Piece_in_space::same_point * (p.radius + largest_coordinate(v)) + Piece_in_space::same_curve * size;
    };
    for (const Space_vector& v : q.corners)
      if (!is_near((v - r.point) * r.normal, v, p.radius + length(v - p.start))) return false;
    const auto off = [&](const Space_vector& v) {
      return p.is_arc ? length(v - r.center) - p.radius : length(cross_product(v - p.start, r.center));
    };
    for (const Space_vector& v : {q.start, q.middle, q.end})
      // A short piece has the same direction, too.
      if (!is_near(off(v), v, p.radius + length(v - p.start)) || !is_near(off(v) - off(q.start), v, length(v - q.start)))
        return false;
    if (!p.is_arc) return (q.end - q.start) * r.center > 0;
    return cross_product(q.start - r.center, q.middle - r.center) * r.normal > 0;
  }

  // A closed curve may start inside an element.
  void join_ends()
  {
    Element_range joined = m_ranges.back();
    for (std::size_t k = 0; k < m_ranges.front().count; ++k)
      if (!extend(joined, m_ranges.front().first + k)) return;
    m_ranges.front() = joined;
    m_ranges.pop_back();
  }

  double m_tolerance;
  std::vector<Piece_in_space> m_pieces;
  std::vector<Element_range> m_ranges;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
