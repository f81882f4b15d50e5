// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piece of an offset curve.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_LEVEL_PIECE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_LEVEL_PIECE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/circle_points.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Face_window.h>

#include <algorithm>

namespace CGAL::Geodesic_offset::internal {

// A part of an offset curve in one face, in the frame of the face: an arc about `center`, counterclockwise, or a segment.
//
// The directions of its ends from the center delimit an arc. The tracer orders them by the side tests that end the piece, so
// the arc turns by 0 to a half turn. If rounding has moved an end behind the other one, the piece is a point.
template <class FT>
struct Level_piece
{
  Point_in_face<FT> center; // for a segment: unit direction from the source
  FT radius;                // for a segment: distance of its line from the origin along that direction
  Point_in_face<FT> start, end;
  Index face;
  Source_ref source_ref;
  Index pseudo_source; // no_index if none
  bool is_straight;
  unsigned char start_edge, end_edge; // halfedge of the face with the end, 3 if the end lies inside

  // Signed distance of a point from the circle or line: negative on the side of the source.
  FT rise(const Point_in_face<FT>& p) const { return (is_straight ? dot(center, p) : length(p - center)) - radius; }

  // Distance of a point from the circle or line.
  FT off(const Point_in_face<FT>& p) const { return CGAL::abs(rise(p)); }

  // Advance from start to end; negative if rounding has moved the end behind the start.
  FT advance() const
  {
    if (is_straight) return dot(quarter_turn(center), end - start);
    return advance_on_circle(center, radius, end - start, start, end);
  }

  // Middle between the ends.
  Point_in_face<FT> middle() const
  {
    if (!is_straight) return middle_on_circle(center, radius, start, end);
    return FT(0.5) * (start + end);
  }

  // Numerator and denominator of the tangent of the turn of an arc: twice the area of the triangle of the center and the ends,
  // and the dot product.
  FT turn_sine() const { return (std::max)(FT(0), FT(cross(start - center, end - center))); }
  FT turn_cosine() const { return dot(start - center, end - center); }
};

// A piece on the arc of a window with a radius, with both ends inside the face.
template <class FT>
inline Level_piece<FT> piece_through(const Face_window<FT>& w, const FT& radius, const Point_in_face<FT>& start,
                                     const Point_in_face<FT>& end, Index face)
{
  return {w.is_parallel() ? FT(-1) * w.image() : w.image(),
          radius,
          start,
          end,
          face,
          w.source_ref,
          w.pseudo_source(),
          w.is_parallel(),
          3,
          3};
}

} // namespace CGAL::Geodesic_offset::internal

#endif
