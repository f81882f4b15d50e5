// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// On which side of the curves a point inside a face lies.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_FACE_SIDE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_FACE_SIDE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Curve_region.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Face_piece.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A point is on the side of a part of the face's border, or on the other side if the segment to the middle of the part crosses
// an odd number of pieces. Arcs count as polylines within `chord_tolerance`, and all coordinates are rounded. Deforming a
// closed curve in the face by less than its distance from both ends of the segment does not change the number modulo 2, nor does
// it for a curve that ends on the border, if the segment is not near its end there. So if both ends of the segment, and those
// ends of pieces, are clear of all that, the number is right; if the middle of no part is so, the side is not known.
class Face_side
{
public:
  struct Side
  {
    std::size_t part;
    bool differs, is_known;
  };

  Face_side(const Certified_mesh& mesh, const Certified_sources& sources, const Curve_region& region,
            const std::vector<Curve_piece>& pieces)
    : m_mesh(mesh), m_sources(sources), m_region(region), m_pieces(pieces)
  {
  }

  Side operator()(Index face, const Double_double_2& place)
  {
    if (!m_region.is_crossed(face)) return {m_region.part(3 * face, 0), false, true};
    const Point p = {place.x.high, place.y.high};
    for (const double tolerance : {0x1p-12, 0x1p-20, 0x1p-28})
      if (const Side side = search(face, p, tolerance); side.is_known) return side;
    return {0, false, false};
  }

  // Where a part of a halfedge begins, in the frame of its face.
  Double_double_2 begin_of_part(Index h, std::size_t i) const
  {
    Double_double_2 place{};
    unsigned edges;
    m_sources.place_in_face(m_region.begin_of_part(h, i), h / 3, place, edges);
    return place;
  }

  // Whether the region is on the right of a piece inside a face, as far as can be told.
  bool is_right_of(const Curve_piece& piece)
  {
    const Double_double_2 m = piece.geometry.inner_point();
    const Point along = difference(piece.end, piece.start);
    const Point left = 0x1p-10 * quarter_turn(along);
    const Side side =
      (*this)(piece.face, {m.x + Double_double(left.x), m.y + Double_double(left.y)});
    return side.is_known && m_region.is_inside(side.part) == side.differs;
  }

private:
  typedef Point_in_face<double> Point;

  // `chord_tolerance`: as a part of the face's size.
  Side search(Index face, const Point& p, double chord_tolerance)
  {
    const double size = m_mesh.length(3 * face) + m_mesh.length(3 * face + 1) + m_mesh.length(3 * face + 2);
    find_chords(face, chord_tolerance * size);
    const double clearance = 2 * chord_tolerance * size + m_moved + rounding * size;
    if (!is_clear(p, clearance)) return {0, false, false};
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      for (std::size_t i = 0; i < m_region.number_of_parts(h); ++i)
      {
        const Double_double_2 m = middle_of(begin_of_part(h, i), begin_of_part(h, i + 1));
        const Point q = {m.x.high, m.y.high};
        if (!is_clear(q, clearance)) continue;
        bool fits = true, differs = false;
        for (const Point& end : m_ends) fits = fits && Face_piece::near_segment(p - end, q - end) > clearance;
        if (!fits) continue;
        for (const auto& [a, b] : m_chords) differs ^= cross_each_other(p, q, a, b);
        return {m_region.part(h, i), differs, true};
      }
    return {0, false, false};
  }

  // Points of the polylines that are on the line through p and q count as left of it; as the polylines are connected, the parity
  // is that of lines a little to the right.
  static bool cross_each_other(const Point& p, const Point& q, const Point& a, const Point& b)
  {
    const double at_a = cross(q - p, a - p), at_b = cross(q - p, b - p);
    if ((at_a >= 0) == (at_b >= 0)) return false;
    return (cross(b - a, p - a) >= 0) != (cross(b - a, q - a) >= 0);
  }

  bool is_clear(const Point& p, double clearance) const
  {
    for (const auto& [a, b] : m_chords)
      if (!(Face_piece::near_segment(a - p, b - p) > clearance)) return false;
    return true;
  }

  void find_chords(Index face, double tolerance)
  {
    m_chords.clear();
    m_ends.clear();
    m_moved = 0;
    const auto range = m_region.pieces_of_face(face);
    for (auto i = range.first; i != range.second; ++i)
    {
      const Curve_piece& piece = m_pieces[i->second];
      m_moved = (std::max)(m_moved, piece.moved);
      m_last = rounded(piece.start);
      add_chords(piece.geometry, tolerance, 0);
      m_chords.push_back({m_last, rounded(piece.end)});
      if (piece.from.kind != Surface_point<double>::FACE) m_ends.push_back(rounded(piece.start));
      if (piece.to.kind != Surface_point<double>::FACE) m_ends.push_back(rounded(piece.end));
    }
  }

  // The points inside a piece.
  void add_chords(const Face_piece& part, double tolerance, int depth)
  {
    if (!part.is_arc || depth == most_halvings) return;
    const Double_double_2 m = part.inner_point();
    if (part.is_short() && length(difference(m, middle_of(part.hull[0], part.hull[1]))) <= tolerance) return;
    const auto halves = part.halves();
    add_chords(halves.first, tolerance, depth + 1);
    m_chords.push_back({m_last, rounded(m)});
    m_last = rounded(m);
    add_chords(halves.second, tolerance, depth + 1);
  }

  static Point rounded(const Double_double_2& p) { return {p.x.high, p.y.high}; }

  static constexpr int most_halvings = 20;     // more than an arc needs for the smallest tolerance
  static constexpr double rounding = 0x1p-40;  // of coordinates and products, as a part of the face's size

  const Certified_mesh& m_mesh;
  const Certified_sources& m_sources;
  const Curve_region& m_region;
  const std::vector<Curve_piece>& m_pieces;
  std::vector<std::pair<Point, Point>> m_chords;
  std::vector<Point> m_ends; // of pieces, on the border of the face
  double m_moved = 0;
  Point m_last{0, 0};
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
