// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// All numbers by which the search, its judge, the integrals and the levels with known curves decide what is right. Most are
// powers of two: multiples of the tolerances of the package (internal/offsets/Offset_tolerances.h), which are multiples of the
// unit in the last place, 2^-52. test_offset_search checks that these have the values given here. "Scale" is the level plus the diagonal of the bounding box: an upper bound of the
// level plus the longest edge, on which the tolerances of the package depend.

#ifndef GEODESIC_OFFSET_TEST_SEARCH_TOLERANCES_H
#define GEODESIC_OFFSET_TEST_SEARCH_TOLERANCES_H

#include <cmath>

namespace test {

/// \name What the package does, as the manual says or Offset_tolerances.h
/// @{

/// A level is cut this part of itself below itself (manual, Special Levels).
constexpr double level_shift = 0x1p-42;

/// Error of one distance, in scales: Offset_tolerances::error.
constexpr double distance_error = 0x1p-47;

/// Cells that are crossed straight, and pieces that may become part of a neighbour, in scales:
/// Offset_tolerances::smallest_cell and shortest_piece.
constexpr double smallest_cell = 0x1p-38;

/// A curve may be left out if the distance inside rises by no more than this, in scales (manual, Special Levels): two level
/// shifts where the rise is known, at a vertex or on an edge; three times that inside a face, where a point in the middle of
/// the curve stands for the highest one. test_smallest_loops.
constexpr double unseen_rise = 6 * level_shift;

/// The length up to which such a curve may be left out, in scales.
constexpr double longest_unseen_curve = 0x1p-26;

/// The distance at which a level is cut, and the level that is cut at a distance.
inline double cut_of(double level) { return level * (1 - level_shift); }
inline double level_cut_at(double distance) { return distance / (1 - level_shift); }

/// @}

/// \name The judge: level_judge.h, edge_profile.h, field_features.h
/// @{
struct Judge_tolerances
{
  /// Gaps between pieces, points outside of their face, points off the level, in scales: 27 of the smallest cells. A chain
  /// moves by up to one cell in each of the two faces beside an edge, and a crossing by some of them along an edge that the
  /// level meets at a small angle.
  static constexpr double position = 1e-10;
  static_assert(position < 32 * smallest_cell, "some cells");

  /// A point whose distance differs from the cut by no more than this is on either side, in scales: 2^7 errors of a distance,
  /// and twice the rise inside of a curve about a vertex or across an edge that may be left out. (It is less than that of a
  /// curve inside a face if the longest edge of the face is more than two thirds of the diagonal of the mesh.)
  static constexpr double side = 4 * level_shift;

  /// Parts of edges shorter than twice this need not be separated, in scales: 4 gaps between the near intervals of
  /// neighbouring windows, Offset_tolerances::interval_gap, 2^-46 of an edge.
  static constexpr double part_of_edge = 0x1p-44;

  /// Angles of arcs exceed a half turn by no more than this, in radians: the error of an arc tangent is 2^-51.
  static constexpr double angle = 0x1p-48;

  /// A point on the left of a piece tells the side only if it is farther away than this number of `position`: on the wrong
  /// side its distance is off by twice the way, 8 times what is allowed.
  static constexpr double steps_to_left = 4;

  /// Cones of sources in a face are wider than their bounding rays by this part of the diameter of the face: a source may lie
  /// along the edge, Offset_tolerances::ray_slack.
  static constexpr double source_ray = 0x1p-44;

  /// Cones of windows on an edge are wider by this: the rounding of a point on another edge, 4 u. Not more, since in a needle face
  /// a point beside the cone may be behind the window, and the straight path shorter than any path.
  static constexpr double bounding_ray = 0x1p-50;

  /// Two distances are the same, in scales: 16 errors.
  static constexpr double same_distance = 16 * distance_error;

  /// Windows that are farther than a vertex allows are left out, with this slack in scales. Any number above the error of
  /// distances is right; a larger one costs time.
  static constexpr double beyond = 0x1p-30;

  /// The step along an edge for the slopes of two windows where they meet, as part of the edge. The error of the slopes is
  /// that of the distances divided by the step, 2^-27.
  static constexpr double slope_step = 0x1p-20;
};

/// How densely a field is sampled for features and witnesses. More samples find more, none makes a right curve wrong.
struct Sampling
{
  static constexpr int points_per_edge = 12;
  static constexpr int rows_per_face = 4;
  /// Barycentric coordinates of samples are at least this, so that rounding leaves the samples inside.
  static constexpr double from_sides = 0.01;
  /// Samples of a face lie on a grid, each moved by up to this part of its cell.
  static constexpr double jitter = 0.1;
  /// Windows per face of which all triples are searched for maxima: 220 triples.
  static constexpr std::size_t windows_per_face = 12;
  /// Halvings of an interval until it is shorter than rounding: more than the 53 bits of a double.
  static constexpr int halvings = 60;
  /// Steps of Newton's method, which doubles the right digits each time but where the three fronts nearly agree.
  static constexpr int newton_steps = 30;
  /// Newton's method ends at steps of this part of the longest edge: some units in the last place.
  static constexpr double last_newton_step = 0x1p-50;
  /// Three fronts whose directions span less than this, as sine of an angle, do not meet in one point.
  static constexpr double smallest_determinant = 0x1p-40;
  /// Quarters of pieces are examined rather than halves from this length, in scales.
  static constexpr double long_piece = 0x1p-10;
};
/// @}

/// \name The comparisons of the search: offset_search.h
/// @{
struct Search_tolerances
{
  /// Lengths of one level that is cut twice, relative to the length plus the scale. A curve of some thousand pieces, each
  /// end moved by one smallest cell: 2^8 cells.
  static constexpr double length = 0x1p-30;

  /// Where lengths differ by more, the level may be within rounding of a change of topology: then the lengths of levels that
  /// are off by these, in scales, enclose both. Up to the shift of the level.
  static constexpr double level_steps[] = {0x1p-50, 0x1p-48, 0x1p-46, level_shift};

  /// The area between two levels is no smaller than zero by more than this, in scales times length: 2^4 smallest cells.
  static constexpr double area = 16 * smallest_cell;
  /// The length of a level between two others is at most this number of times both of them and the diagonal together. On
  /// meshes with 10^3 faces.
  static constexpr double longest_between = 10;
  /// The growth of the area is compared with lengths for steps of the level up to this, in scales: behind, curves of
  /// other topology may be longer.
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
  /// Distances at which the levels are no farther from a distance of a vertex than this, in largest distances plus mean
  /// edges, are stepped over: twice the rise that cannot be seen, since a curve round a vertex may be left out there.
  static constexpr double beside_vertex = 2 * unseen_rise;

  /// Intervals of levels shorter than this part of the largest distance are not halved, as at jumps of the length: what is
  /// left over at a jump is the interval times the jump, which is far below 1e-9 of the area for some ten jumps.
  static constexpr double shortest_interval = 0x1p-33;

  /// Rounding of the area between two levels, as part of the area of the surface: 4 units in the last place. Without it, all
  /// intervals beside a jump are halved up to the shortest one.
  static constexpr double area_error = 0x1p-50;

  /// The window for a derivative is at least this wide, in diagonals. Areas have an error of about 2^-52 of a squared
  /// diagonal, so the derivative has one of 2^-30 of a diagonal, 1e-9 of a length that is as long.
  static constexpr double narrowest_window = 0x1p-23;
  /// The window ends before the next vertex, at this part of the way, and a fourth of it is tried next.
  static constexpr double part_to_vertex = 0.9;
  static constexpr double shrink = 0.25;

  /// The length is smooth in a window if the rules of Simpson and Gauss, of orders 4 and 10, differ by no more than this,
  /// relative: a tenth of what the derivative has to reach.
  static constexpr double smooth = 1e-10;

  /// The last level exceeds the largest distance by this part.
  static constexpr double above_largest = 0x1p-30;
};
/// @}

/// \name Levels with known curves: level_check.h
/// @{
struct Known_level_tolerances
{
  /// Relative error of a length.
  static constexpr double length = 1e-11;
  /// The part of the level by which the length changes at its rate of growth: the shift of the level, and a tenth of it for
  /// the error of distances.
  static constexpr double level = 1.1 * level_shift;
};
/// @}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_SEARCH_TOLERANCES_H
