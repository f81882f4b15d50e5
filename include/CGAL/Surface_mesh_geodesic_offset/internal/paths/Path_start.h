// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance of a point and the first straight part of its shortest path.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_START_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_START_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

namespace CGAL::Geodesic_offset::internal {

// The first straight part of the shortest path from a point, by a window, a corner of the face, or the backtrace of a vertex.
// All query results derive from this choice. In the frame of `halfedge`, the path runs straight from `from` to `to`, the image
// of the pseudo-source, or of the end of the path if there is no pseudo-source. Path_tracing follows the path to its end.
template <class FT>
struct Path_start
{
  FT distance = Number_policy<FT>::infinity();
  FT start_value = FT(0); // of the source
  Source_ref source_ref;  // source and side of the window; the part of the source is known at the end of the path only
  bool is_below_start_value = false; // the distance is less than the start value by more than rounding: an error of merging
  Index pseudo_source = no_index;
  Index halfedge = no_index; // of the first face; no_index at infinite distance and at source vertices, see is_at_source()
  int exit = -1;             // edge through which the path leaves the face, counted from the halfedge; -1 if it does not leave
  Index edge = no_index;     // halfedge on which the point lies, for a point inside an edge
  Point_in_face<FT> from, to;
  Point_in_face<FT> direction;    // not normalized; near a source, `to` - `from` loses its digits
  bool is_measured = false;       // true if Near_path has replaced the distance by a more precise one
  FT distance_of_windows = FT(0); // if measured: the distance before, with which the path is traced

  bool is_reached() const { return Number_policy<FT>::is_finite(distance); }

  // Length of the path: the distance without the start value.
  FT length() const { return CGAL::is_zero(start_value) ? distance : FT(distance - start_value); }
  bool is_at_source() const { return !(start_value < distance) && !is_below_start_value; }

  // The start with the distance by windows. Precondition: is_measured.
  Path_start before_measurement() const
  {
    Path_start result = *this;
    result.is_measured = false;
    result.distance = distance_of_windows;
    return result;
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
