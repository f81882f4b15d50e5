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

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// A point is on the side of a part of the face's border, or on the other side if the segment to the middle of the part crosses
// an odd number of pieces. Parts of arcs count as their chords if their hulls contain no end of the segment, and all coordinates
// are rounded. Deforming a closed curve in the face without passing an end of the segment does not change the number modulo 2,
// nor does it for a curve that ends on the border, if the segment is not near its end there. So the number is right if both
// ends of the segment are away from all hulls by more than rounding, and so is the segment from those ends of pieces. If this holds
// for the middle of no part, the side is unknown.
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
    return search(face, p);
  }

  // Where a part of a halfedge begins, in the frame of its face.
  Double_double_2 begin_of_part(Index h, std::size_t i) const
  {
    Double_double_2 place{};
    unsigned edges;
    m_sources.place_in_face(m_region.begin_of_part(h, i), h / 3, place, edges);
    return place;
  }

  // True if the region is on the right of a piece inside a face; false if this is unknown. The point tested is as near to the
  // piece as rounding allows: another piece may be next to it.
  bool is_right_of(const Curve_piece& piece)
  {
    const Double_double_2 m = piece.geometry.inner_point();
    const Point along = difference(piece.end, piece.start);
    for (double step = least_step; step <= largest_step; step *= 4)
    {
      const Point left = step * quarter_turn(along);
      const Side side = (*this)(piece.face, {m.x + Double_double(left.x), m.y + Double_double(left.y)});
      if (side.is_known) return m_region.is_inside(side.part) == side.differs;
    }
    return false;
  }

private:
  typedef Point_in_face<double> Point;

  Side search(Index face, const Point& p)
  {
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      for (std::size_t i = 0; i < m_region.number_of_parts(h); ++i)
      {
        const Double_double_2 m = middle_of(begin_of_part(h, i), begin_of_part(h, i + 1));
        const Point q = {m.x.high, m.y.high};
        if (!find_chords(face, p, q)) continue;
        bool differs = false;
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

  // The pieces of a face as chords, for a segment from p to q. False if p or q is too near to a piece, or an end of a piece to
  // the segment.
  bool find_chords(Index face, const Point& p, const Point& q)
  {
    m_chords.clear();
    const double size = m_mesh.length(3 * face) + m_mesh.length(3 * face + 1) + m_mesh.length(3 * face + 2);
    const auto range = m_region.pieces_of_face(face);
    for (auto i = range.first; i != range.second; ++i)
    {
      const Curve_piece& piece = m_pieces[i->second];
      const double clearance = piece.moved + rounding * size + piece.geometry.rounding();
      const Point start = rounded(piece.start), end = rounded(piece.end);
      const auto is_near = [&](const Point& x) { return !(Face_piece::near_segment(p - x, q - x) > clearance); };
      if (piece.from.kind != Surface_point<double>::FACE && is_near(start)) return false;
      if (piece.to.kind != Surface_point<double>::FACE && is_near(end)) return false;
      m_last = start;
      if (!add_chords(piece.geometry, p, q, clearance, 0)) return false;
      m_chords.push_back({m_last, end});
    }
    return true;
  }

  // The points inside a piece.
  bool add_chords(const Face_piece& part, const Point& p, const Point& q, double clearance, int depth)
  {
    Face_piece hull = part;
    hull.is_arc = false;
    const auto is_clear = [&](const Point& x) {
      return hull.distances_from({Double_double(x.x), Double_double(x.y)}).first > clearance;
    };
    if (part.is_short() && is_clear(p) && is_clear(q)) return true;
    if (!part.is_arc || depth == most_halvings) return false;
    const auto halves = part.halves();
    const Point m = rounded(part.inner_point());
    if (!add_chords(halves.first, p, q, clearance, depth + 1)) return false;
    m_chords.push_back({m_last, m});
    m_last = m;
    return add_chords(halves.second, p, q, clearance, depth + 1);
  }

  static Point rounded(const Double_double_2& p) { return {p.x.high, p.y.high}; }

  static constexpr int most_halvings = 40;    // hulls become narrower than rounding before
  static constexpr double rounding = 0x1p-46; // of coordinates and products, as a part of the face's size
  // Distances of points from a piece, as parts of its chord: from that of rounding to one at which an arc is still straight.
  // Binding test: test_certified_offsets, thin strips.
  static constexpr double least_step = rounding, largest_step = 0x1p-10;

  const Certified_mesh& m_mesh;
  const Certified_sources& m_sources;
  const Curve_region& m_region;
  const std::vector<Curve_piece>& m_pieces;
  std::vector<std::pair<Point, Point>> m_chords;
  Point m_last{0, 0};
};

} // namespace CGAL::Geodesic_offset::internal

#endif
