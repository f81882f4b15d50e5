// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All tolerances of the offset step. Each but border_strip() and largest_tie() is a multiple of the unit in the last place u of the
// number type. With exact numbers u is zero, and so are these tolerances.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_TOLERANCES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_TOLERANCES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

namespace CGAL::Geodesic_offset::internal {

// All values are lengths. The magnitude of a level in a face is the level plus the longest edge of the faces around its corners
// (Vertex_reach). It bounds the coordinates of the images whose arcs cross the face, there and in the last faces of their
// windows. Binding tests: test_smallest_loops, test_offset_oracle, offset_search.
template <class FT>
struct Offset_tolerances
{
  // A level is cut this much below itself, so that points at exactly the level count as farther: 2^10 u times the level. This
  // exceeds the error of distances (2^5 u, measured on scans) by 2^5.
  static FT level_shift(const FT& level) { return unit(10) * level; }

  // A source with segments has an offset at a level only if the level, cut as above, exceeds its start value by more than this:
  // 2^10 u times the start value plus the longest edge around the source. This is eight of the smallest ties (below). The two
  // sides of an offset of one or two ties are one curve up to rounding, which would leave parts of it; from four ties on, no
  // fault is known. Binding test: test_degenerate_levels.
  static FT least_offset(const FT& magnitude) { return unit(10) * magnitude; }

  // Two faces of an edge bound its distances with different rounding. A level this near to a bound is searched in both: 2^14 u
  // times the largest distance of the face, far above the rounding of the bounds (2^4 u).
  static FT bound_slack(const FT& largest_distance) { return unit(14) * largest_distance; }

  // Rounding of the longest edge of a face in the bound of its nearest distance: 2^4 u, some differences of two coordinates.
  static FT edge_rounding(const FT& edge_length) { return unit(4) * edge_length; }

  // Equally spaced levels without an end must be this far apart: 2^10 u times the longest edge of the mesh, the level shift at the
  // distance of an edge, so that distances distinguish them there. Binding test: test_degenerate_levels.
  static FT least_spacing(const FT& longest_edge) { return unit(10) * longest_edge; }

  // Near intervals of a segment, and gaps between them, up to this length are dropped: two errors of a distance, 2^6 u times
  // the magnitude. In an interval or gap of width w the distance differs from the level by at most w / 2, as it is 1-Lipschitz:
  // by no more than its error.
  static FT interval_gap(const FT& magnitude) { return unit(6) * magnitude; }

  // At a small angle to a front, a near interval is longer than its depth. An interval up to this length is dropped if its
  // depth is within the error: 2^26 u times the magnitude, the square root of u. A longer one may be an edge along a front; it is
  // dropped only at an end of the edge that is on the level up to rounding, but not nearer.
  static FT longest_shallow_interval(const FT& magnitude) { return unit(26) * magnitude; }

  // A source or chord along a segment is in front of its points up to this: 2^8 u times the length of the segment, some
  // coordinates in the frames of two faces.
  static FT ray_slack(const FT& edge_length) { return unit(8) * edge_length; }

  // A curve up to this length may be a loop around a maximum that equals the level up to rounding (Shallow_loop): 2^26 u times
  // the level and the mean edge, the square root of u. Where distances fall from the maximum at this slope, the length of the
  // loop is the level shift divided by the slope.
  static FT longest_shallow_loop(const FT& magnitude) { return unit(26) * magnitude; }

  // A shallow loop is dropped if the distance inside rises above the level by at most four level shifts, since the upper bound
  // of the rise is up to three times the rise (in a triangle, height and radius of the inscribed circle).
  static FT shallow_rise(const FT& magnitude) { return unit(12) * magnitude; }

  // Rounding leaves parts up to this length when a selection by sides divides curves: the smallest cell of a face as large as
  // the mean edge.
  static FT shortest_part(const FT& magnitude) { return unit(14) * magnitude; }

  // A part of a curve up to this length has the side of the parts around it: 2^-17 of the level. Behind segments as short as the
  // rounding of coordinates with eight digits, the side of an arc is that of rounding. Binding test: test_program_sides, digits.
  static FT part_of_rounded_side(const FT& level) { return FT(1. / (1 << 17)) * level; }

  // The windows of small faces may come from a large face farther away, where coordinates had this rounding: 2^5 u times the
  // longest edge of the mesh, as for the error below. A cell up to this diameter whose gates no arcs connect is not divided.
  static FT farther_rounding(const FT& longest_edge) { return unit(5) * longest_edge; }

  // Neighbouring pieces are one arc if their images and radii differ by at most this: 2^6 u times the coordinates of the image
  // and the radius, two errors of an image that was unfolded on two ways; for the directions of straight pieces, of their length 1.
  // A larger value would move curves, a smaller one divides arcs. Binding test: test_offset_search, scaled meshes.
  static FT same_image(const FT& magnitude) { return unit(6) * magnitude; }

  // A polyline runs along the border if it is this near to it: 1e-5 of its length, ten times the rounding of coordinates written
  // with six digits; a strip of this width is not meant as a side. Also for exact numbers. Binding test: test_inner_sides.
  static FT border_strip(const FT& length) { return FT(1e-5) * length; }

  // Error of a distance evaluated in a face: 2^5 u times the magnitude.
  FT error;
  // A window covers the arc of another one where it is nearer by more than this: two errors, as two distances are compared.
  FT cover;
  // Two windows tie, and a point lies on an arc, up to this: two covers, so that an arc passes the point where it begins to
  // cover another arc. If a walk does not fit together, it is repeated with the next of `tie_factors`: windows of
  // needles jump by more than the error across their common bounding ray, while fronts that touch are within the level shift.
  FT tie;
  // Pieces up to this length, the size of the smallest cells, are merged into a neighbour that passes through both ends.
  FT shortest_piece;
  // Cells of this diameter, two of the largest ties, are not divided. A level crosses such a cell straight from gate to gate.
  FT smallest_cell;

  // Largest distance between the two gates of a sliver, a longer cell that a level crosses straight (Level_tracer::is_sliver):
  // 2^26 u times the magnitude, the square root of u.
  FT longest_sliver;

  // Limit of the divisions of one face at one level. Unexpected gaps between windows then cost no more than a face with some
  // hundred pieces.
  static constexpr int most_divisions = 1 << 10;

  // Ties larger than the first one are tried up to an eighth of the distance between the level and a source, as the first tie is
  // an eighth of least_offset(). A larger tie would take the two sides of the offset for one curve. Binding test:
  // test_degenerate_levels.
  static FT largest_tie(const FT& offset) { return offset / FT(8); }

  static constexpr int tie_factors[] = {1, 8, 64};
  void use_tie(int factor) { tie = FT(2 * factor) * cover; }

  Offset_tolerances() = default;
  explicit Offset_tolerances(const FT& magnitude)
    : error(unit(5) * magnitude), cover(unit(6) * magnitude), tie(unit(7) * magnitude), shortest_piece(unit(14) * magnitude),
      smallest_cell(unit(14) * magnitude), longest_sliver(unit(26) * magnitude)
  {
  }

private:
  static FT unit(int bits) { return Number_policy<FT>::rounding(double(1 << bits)); }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
