// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All tolerances of the Voronoi step: multiples of the unit in the last place u of the number type (2^-52 of double), or of its
// root. Examples in the comments are for double.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_VORONOI_TOLERANCES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_VORONOI_TOLERANCES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/elementary_functions.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Geodesic_offset::internal {

// All values are lengths. The magnitude of a face is its longest edge plus the largest distance at the ends of the chords of its
// windows, which bounds the coordinates of their images. Binding test: test_voronoi_diagram.
template <class NT>
struct Voronoi_tolerances
{
  // Distances that differ by less are equal: 2^6 u times the magnitude, two errors of a distance (see Offset_tolerances::error). If
  // the arcs of a cell do not fit together, they are found again with the next of `tie_factors`: larger ones, as errors of windows
  // that come over many edges; and smaller ones, for sources a few ties apart, whose bisectors a tie moves far. Binding test:
  // test_voronoi_diagram, end beside a source.
  NT tie;
  // Cones and cells reach this far beyond their bounds, so that rounding leaves no gaps between neighbours: two ties.
  NT slack;
  NT usual_tie;
  // Between a window and the ray at which it ends: eight ties, as both may come over many edges. Binding test:
  // test_voronoi_diagram, vertex and edge, and rotor_small.
  NT tie_of_rays;
  // Intervals of an edge up to this length are nowhere certainly nearest to their source: 2^8 u, two slacks.
  NT shortest_interval;
  // Ends of arcs no farther apart than this meet: 2^14 u, 3.6e-12 of the magnitude. Arcs that cross at the angle s end with an
  // error of one tie over sin(s), so this allows for angles down to 2^-8; of cells with smaller angles, the smallest divide.
  NT joint;
  // Last resort: ends no farther apart than these multiples meet, as of segments that cross at angles down to 2^-8 over the
  // factor: up to the usual one, and in thin faces up to the longest edge over the height. Whether the arcs hold is found from the
  // distances along them. Binding test: test_voronoi_diagram, thin faces.
  static constexpr double joint_factors[] = {1 << 6, 1 << 12, 1 << 18, 1 << 24}, usual_joint_factor = 1 << 12;
  // Arcs that meet at smaller angles may end farther apart, up to 2^-8 of the magnitude, if all distances are equal up to eight
  // ties at both ends and between them: each of these points is the common end up to rounding. Without this, cells around such
  // ends are divided to the smallest.
  NT loose_joint, loose_tie;
  // Closed curves up to this length are left out: 2^29 u, 1.2e-7, eight times the square root of u: arcs
  // that touch at a point tie up to eight ties within this distance of it, and rounding may let them enclose a region.
  NT smallest_loop;
  // Cells up to this diameter are not divided: 2^15 u, two joints. A bisector crosses such a cell straight from gate to gate.
  NT smallest_cell;
  // Arcs up to this length are points: two such cells.
  NT negligible;

  // An arc is along a side of a cell if its ends and its middle are this near to it; and a window is only along a side if the
  // corners of the cell are no farther inside its cone. Two slacks, as arcs and cones reach one slack beyond their bounds.
  // Binding test: test_voronoi_diagram, parts of edges at a vertex.
  NT along_side() const { return 2 * slack; }
  // A side of a cell has the label of a neighbour where all windows of the cell with this label are farther than the nearest one by
  // more than this: two ties, one for each of the two distances. Binding test: as before.
  NT of_neighbour() const { return 2 * usual_tie; }

  // On a curve from gate to gate where bisectors do not fit together, the two least path lengths differ by no more than this,
  // nor is another one less by more: two loose ties, as that of a whole corner has one of them.
  NT of_link() const { return 2 * loose_tie; }
  // On an arc that ends in a wide joint: four times that; where loose ends tie by the windows of both arcs: four joints, as
  // windows that come over many edges may end that far from where their sources tie. Binding test: test_voronoi_diagram, cases
  // of a file.
  NT of_wide_joint() const { return 4 * of_link(); }
  NT of_loose_joint() const { return 4 * joint; }
  // Intervals between the points at which an arc is examined; and further points towards its ends, since several bisectors may
  // meet there, or the end may have been moved: each at this part of the distance from the end, down to a joint.
  static constexpr int samples_of_link = 16;
  static constexpr double step_of_samples = 1. / 4;
  // Depth of the search for further sources between two samples of a segment; each of them has an interval of its own.
  static constexpr int most_changes_between = 8;

  static constexpr double tie_factors[] = {1, 8, 64, 1. / 8, 1. / 64};
  void use_tie(NT factor)
  {
    tie = factor * usual_tie;
    slack = 2 * (std::max)(tie, usual_tie);
  }

  // Sources this near to each other are one: 2^9 u times the longest edge plus the largest distance of a vertex, eight ties. The
  // curves between them would have no certain direction. Binding test: test_voronoi_diagram, coinciding sources.
  static NT same_source(NT magnitude) { return unit(9) * magnitude; }

  explicit Voronoi_tolerances(NT magnitude = 0)
    : tie(unit(6) * magnitude), slack(unit(7) * magnitude), usual_tie(tie), tie_of_rays(NT(8) * tie),
      shortest_interval(unit(8) * magnitude), joint(unit(14) * magnitude), loose_joint(magnitude / NT(1 << 8)),
      loose_tie(unit(9) * magnitude), smallest_loop(NT(8 * Number_policy<NT>::root_of_rounding()) * magnitude),
      smallest_cell(unit(15) * magnitude), negligible(2 * smallest_cell)
  {
  }

  // Sine of the smallest angle of a chord to parallel rays at which it is extended to a common ray. Rounding moves the end of
  // the extended chord, and with it the start of the rays, by its error over this.
  static constexpr double least_slope = 1. / (1 << 10);
  // How far from a ray the distance through a point on it is equal, up to `tie` and errors of the windows, to that from a line
  // through the point across the ray, at this distance from the point: the square of the result, over twice the distance, is
  // four ties.
  static NT tied_width(NT along_ray, NT tie) { return tie + square_root<NT>(8 * tie * along_ray); }
  // Sine of the angle between two rays that are one: 2^-24. A path along a ray that is off by this angle is too short by 2^-49 of
  // its length.
  static NT same_ray() { return NT(4 * Number_policy<NT>::root_of_rounding()); }
  // The same where distances tie up to `width` from the ray at this distance from its start.
  static NT tied_turn(NT along_ray, NT width) { return same_ray() + (along_ray > width ? width / along_ray : NT(0)); }
  // A cell with more windows than this is divided, unless its arcs fit together with the usual tolerances: all pairs of windows
  // in a cell are examined, again for each tolerance.
  static constexpr unsigned most_windows = 12;
  // A cell with more windows than this is divided in any case. Pairs grow as the square of the windows; of 20, 40 and all
  // windows, 40 took the least time on smooth meshes of 50,000 and 200,000 vertices.
  static constexpr unsigned most_windows_at_once = 40;
  // After this many divisions of a face per window of the face, the number of windows is no reason to divide a cell: many
  // windows may meet at a vertex.
  static constexpr std::size_t most_divisions_for_windows = 1 << 8;
  // Likewise after this many successive divisions of a cell, to an eighth of its diameter, that removed no window.
  static constexpr int most_divisions_in_vain = 6;
  // Limit of the other divisions of a face, for each of its windows. A bisector that rounding leaves without its ends costs at
  // most this.
  static constexpr std::size_t most_divisions = 1 << 7;

private:
  static NT unit(int bits) { return NT(1 << bits) * std::numeric_limits<NT>::epsilon(); }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
