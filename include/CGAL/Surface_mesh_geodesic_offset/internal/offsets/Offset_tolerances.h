// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All tolerances of the offset step, in one table. Each is a multiple of the unit in the last place u of the number type;
// with exact numbers u is zero, and so is every tolerance.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_TOLERANCES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_TOLERANCES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Lengths. The magnitude of a level in a face is the level plus the longest edge of the faces round its corners
// (Vertex_reach): an upper bound of the coordinates of the images whose arcs cross the face, there and in the faces that their
// windows came through last. Binding tests: test_smallest_loops, test_offset_oracle, offset_search.
template <class FT>
struct Offset_tolerances
{
  // A level is cut below itself by this, so that points at exactly the level count as farther: 2^10 u times the level,
  // which is above the error of distances (2^5 u, measured on scans) by 2^5.
  static FT level_shift(const FT& level) { return unit(10) * level; }

  // Two faces beside an edge bound the distances on it with rounding of their own; a level this near to a bound is
  // looked for in both: 2^14 u times the largest distance of the face, far above the rounding of the bounds (2^4 u).
  static FT bound_slack(const FT& largest_distance) { return unit(14) * largest_distance; }

  // Near intervals of a segment, and gaps between them, up to this are left out: two errors of a distance, 2^6 u times the
  // magnitude. In an interval, or gap, of the width w the distance differs from the level by at
  // most w / 2, since it is 1-Lipschitz: by no more than its error.
  static FT interval_gap(const FT& magnitude) { return unit(6) * magnitude; }

  // At a small angle to a front, a near interval is longer than its distances are below the level. Up to this length, one whose
  // distances are the level up to their error is left out: 2^26 u times the magnitude, the square root of u. A longer one may be
  // an edge along a front.
  static FT longest_shallow_interval(const FT& magnitude) { return unit(26) * magnitude; }

  // A source may lie on an edge; the bounding rays of its windows are then within 2^8 u times the edge's length of it.
  static FT ray_slack(const FT& edge_length) { return unit(8) * edge_length; }

  // A curve up to this length may be a loop about a largest distance that is the level up to rounding (Shallow_loop):
  // 2^26 u times the level and the mean edge, the square root of u. Where distances fall off from their largest one as
  // slowly as that, the length of the loop is the level shift divided by the slope.
  static FT longest_shallow_loop(const FT& magnitude) { return unit(26) * magnitude; }

  // It is left out if the distance inside rises above the level by no more than this: four level shifts, since the upper
  // bound of the rise is up to three times the rise (in a triangle, height and radius of the inscribed circle).
  static FT shallow_rise(const FT& magnitude) { return unit(12) * magnitude; }

  // A selection by sides divides curves into parts; rounding leaves parts up to this length: the smallest cell of a face
  // as large as the mean edge.
  static FT shortest_part(const FT& magnitude) { return unit(14) * magnitude; }

  // Error of one distance that is evaluated in a face: 2^5 u times the magnitude.
  FT error;
  // A window covers the arc of another where it is nearer by more than this: two errors, since two distances are compared.
  FT cover;
  // Two windows tie, and a point lies on an arc, up to this: two covers, so that an arc passes the point from which on it
  // covers another one. Where a walk does not fit together, it is repeated
  // with the next of `number_of_ties`, eight times larger each: windows of needle faces jump by more than error across the
  // bounding ray that they share, while fronts that touch are as near to each other as the level shift.
  FT tie;
  // Pieces up to this length become part of a neighbour that passes both of their ends: of the size of the smallest cells.
  FT shortest_piece;
  // Cells of this diameter are not divided: two of the largest ties. A level crosses such a cell straight from gate to
  // gate.
  FT smallest_cell;

  // Divisions of one face at one level, at most: gaps of windows wider than rounding, which there should not be, do not
  // take more time than a face with some hundred pieces.
  static constexpr int most_divisions = 1 << 10;

  static constexpr int number_of_ties = 3;
  void use_tie(int i) { tie = FT(double(2 << 3 * i)) * cover; }

  Offset_tolerances() = default;
  explicit Offset_tolerances(const FT& magnitude)
    : error(unit(5) * magnitude), cover(unit(6) * magnitude), tie(unit(7) * magnitude),
      shortest_piece(unit(14) * magnitude), smallest_cell(unit(14) * magnitude)
  {
  }

private:
  static FT unit(int bits) { return Number_policy<FT>::rounding(double(1 << bits)); }
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
