// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// All tolerances of the search, its judge, the integrals, and the levels with known curves. Most are powers of two:
// multiples of the package's tolerances (internal/offsets/Offset_tolerances.h), which are multiples of the unit in the last
// place, 2^-52. test_offset_search checks that those have the values given here. "Scale" is the level plus the diagonal of
// the bounding box: an upper bound of the level plus the longest edge, on which the tolerances of the package depend.

#ifndef GEODESIC_OFFSET_TEST_SEARCH_TOLERANCES_H
#define GEODESIC_OFFSET_TEST_SEARCH_TOLERANCES_H

#include <cmath>

namespace test {

/// \name Behaviour of the package, documented in the manual or in Offset_tolerances.h
/// @{

/// Relative shift of the cut below the level (manual, Special Levels).
constexpr double level_shift = 0x1p-42;

/// Error of one distance, in scales: Offset_tolerances::error.
constexpr double distance_error = 0x1p-47;

/// Size of cells that are crossed straight, and of pieces that may become part of a neighbour, in scales:
/// Offset_tolerances::smallest_cell and shortest_piece.
constexpr double smallest_cell = 0x1p-38;

/// A curve may be omitted if the distance inside rises by at most this, in scales (manual, Special Levels): two level
/// shifts if the rise is known, at a vertex or on an edge; three times as much inside a face, where a point in the middle
/// of the curve represents the highest one. See test_smallest_loops.
constexpr double unseen_rise = 6 * level_shift;

/// Maximum length of an omitted curve, in scales.
constexpr double longest_unseen_curve = 0x1p-26;

/// The distance at which a level is cut, and the level for a given cut.
inline double cut_of(double level) { return level * (1 - level_shift); }
inline double level_cut_at(double distance) { return distance / (1 - level_shift); }

/// @}

/// \name The judge: level_judge.h, edge_profile.h, field_features.h
/// @{
struct Judge_tolerances
{
  /// Gaps between pieces, points outside their face, and points off the level, in scales: 27 of the smallest cells. A chain
  /// moves by up to one cell in each of the two faces beside an edge, and a crossing by several cells along an edge that
  /// the level meets at a small angle.
  static constexpr double position = 1e-10;
  static_assert(position < 32 * smallest_cell, "some cells");

  /// A point whose distance differs from the cut by at most this is on either side, in scales: 2^7 errors of a distance,
  /// and twice the rise inside an omitted curve about a vertex or across an edge. (It is less than the rise inside an
  /// omitted curve in a face if the longest edge of the face exceeds two thirds of the diagonal of the mesh.)
  static constexpr double side = 4 * level_shift;

  /// Parts of edges shorter than twice this need not be separated, in scales: 4 gaps between the near intervals of
  /// neighbouring windows, Offset_tolerances::interval_gap, 2^-46 of an edge.
  static constexpr double part_of_edge = 0x1p-44;

  /// Maximum excess of the angle of an arc over a half turn, in radians: the error of an arc tangent is 2^-51.
  static constexpr double angle = 0x1p-48;

  /// A point on the left of a piece determines the side only if it is farther than this multiple of `position`: on the
  /// wrong side its distance deviates by twice the path, 8 times the tolerance.
  static constexpr double steps_to_left = 4;

  /// Cones of sources in a face exceed their bounding rays by this fraction of the diameter of the face: a source may lie
  /// along the edge, Offset_tolerances::ray_slack.
  static constexpr double source_ray = 0x1p-44;

  /// Widening of cones of windows on an edge: the rounding of a point on another edge, 4 u. A larger widening would be
  /// wrong: in a needle face, a point beside the cone may be behind the window, and the straight segment shorter than any
  /// path.
  static constexpr double bounding_ray = 0x1p-50;

  /// Tolerance for equal distances, in scales: 16 errors.
  static constexpr double same_distance = 16 * distance_error;

  /// Slack for the removal of windows that are farther than a vertex allows, in scales. Any number above the error of
  /// distances is correct; larger ones cost time.
  static constexpr double beyond = 0x1p-30;

  /// Step along an edge for the slopes of two windows at their joint, as a fraction of the edge. The error of the slopes is
  /// that of the distances divided by the step, 2^-27.
  static constexpr double slope_step = 0x1p-20;
};

/// Sampling density for features and witnesses. More samples find more faults; none makes a correct curve wrong.
struct Sampling
{
  static constexpr int points_per_edge = 12;
  static constexpr int rows_per_face = 4;
  /// Minimum of barycentric coordinates of samples, so that rounding leaves the samples inside.
  static constexpr double from_sides = 0.01;
  /// Samples of a face lie on a grid, displaced by up to this fraction of a cell.
  static constexpr double jitter = 0.1;
  /// Windows per face of which all triples are searched for maxima: 220 triples.
  static constexpr std::size_t windows_per_face = 12;
  /// Bisections of an interval until it is shorter than rounding: more than the 53 bits of a double.
  static constexpr int halvings = 60;
  /// Steps of Newton's method, which converges quadratically except where the three fronts nearly agree.
  static constexpr int newton_steps = 30;
  /// Newton's method ends at steps below this fraction of the longest edge: some units in the last place.
  static constexpr double last_newton_step = 0x1p-50;
  /// Three fronts whose directions span less than this, as sine of an angle, do not meet in one point.
  static constexpr double smallest_determinant = 0x1p-40;
  /// From this length, in scales, quarters of pieces are examined rather than halves.
  static constexpr double long_piece = 0x1p-10;
};
/// @}

/// \name The comparisons of the search: offset_search.h
/// @{
struct Search_tolerances
{
  /// Lengths of one level from two cuts, relative to the length plus the scale: for a curve of some thousand pieces, each
  /// end displaced by one smallest cell, 2^8 cells.
  static constexpr double length = 0x1p-30;

  /// Parts of a curve on one side up to this length may count to the other side, in levels.
  static constexpr double part_of_rounded_side = 0x1p-17;

  /// If lengths differ by more, the level may be within rounding of an event: then the lengths of levels displaced by
  /// these, in scales, enclose both. Up to the shift of the level.
  static constexpr double level_steps[] = {0x1p-50, 0x1p-48, 0x1p-46, level_shift};

  /// The area between two levels may be negative by at most this, in scales times length: 2^4 smallest cells.
  static constexpr double area = 16 * smallest_cell;
  /// The length of a level between two others is at most this multiple of the sum of both and the diagonal. For meshes with
  /// 10^3 faces.
  static constexpr double longest_between = 10;
  /// The growth of the area is compared with lengths for steps of the level up to this, in scales: for larger steps, curves
  /// of another topology may be longer.
  static constexpr double longest_step = 0x1p-20;

  /// Probes of the second validator per mesh, and faces in which it integrates.
  static constexpr std::size_t validator_probes = 100;
  static constexpr std::size_t validator_faces = 1;
};
/// @}

/// \name Integrals: offset_integrals.h
/// @{
struct Integral_tolerances
{
  /// The integration skips levels within this distance of a vertex distance, in largest distances plus mean edges: twice
  /// the unseen rise, since a curve around a vertex may be omitted there.
  static constexpr double beside_vertex = 2 * unseen_rise;

  /// Intervals of levels shorter than this fraction of the largest distance are not halved, as at jumps of the length. The
  /// error at a jump is the interval times the jump, far below 1e-9 of the area for some ten jumps.
  static constexpr double shortest_interval = 0x1p-33;

  /// Rounding error of the area between two levels, relative to the area of the surface: 4 units in the last place. Without
  /// it, all intervals beside a jump would be halved down to the shortest one.
  static constexpr double area_error = 0x1p-50;

  /// Minimum width of the window for a derivative, in diagonals. Areas have an error of about 2^-52 of a squared diagonal,
  /// so the derivative has one of 2^-30 of a diagonal, 1e-9 of a length of one diagonal.
  static constexpr double narrowest_window = 0x1p-23;
  /// The window ends before the next vertex, at this fraction of the distance; the next attempt uses a fourth of it.
  static constexpr double part_to_vertex = 0.9;
  static constexpr double shrink = 0.25;

  /// The length is smooth in a window if the rules of Simpson and Gauss, of orders 4 and 10, differ by at most this,
  /// relative: a tenth of the required accuracy of the derivative.
  static constexpr double smooth = 1e-10;

  /// The last level exceeds the largest distance by this fraction.
  static constexpr double above_largest = 0x1p-30;
};
/// @}

/// \name Levels with known curves: level_check.h
/// @{
struct Known_level_tolerances
{
  /// Relative error of a length.
  static constexpr double length = 1e-11;
  /// Fraction of the level by which the length changes at its rate of growth: the shift of the level, and a tenth of it for
  /// the error of distances.
  static constexpr double level = 1.1 * level_shift;
};
/// @}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_SEARCH_TOLERANCES_H
