// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_OFFSET_STATISTICS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_OFFSET_STATISTICS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <cstddef>

namespace CGAL {

/// \ingroup PkgSurfaceMeshGeodesicOffsetClasses
/// \brief holds counts and times of a propagation and of the offsets that were cut during it.
struct Geodesic_offset_statistics
{
  std::size_t windows_created = 0;    ///< windows put into the list of a halfedge
  std::size_t windows_propagated = 0; ///< windows unfolded across a face; some 0.1 % more if the build neither keeps windows
                                      ///< nor cuts offsets
  std::size_t windows_peak = 0;       ///< largest number of windows held at one time
  std::size_t kept_bytes = 0;         ///< memory of the windows that were kept
  std::size_t windows_merged = 0;     ///< with a tolerance: windows that were merged into others, and so not propagated
  double error_bound = 0;             ///< with a tolerance: bound of exact minus computed distance; excludes rounding error
  double relative_error_bound = 0;    ///< with a tolerance: bound of that difference divided by the computed distance
  std::size_t pieces = 0;             ///< pieces of offset curves, before a selection of sides
  std::size_t pieces_peak = 0;        ///< largest number of pieces held at one time, of offsets that are not passed on yet
  std::size_t forced_joints = 0;      ///< cells larger than rounding in which offset pieces were joined by straight segments
  std::size_t faces_searched = 0;     ///< faces in which the largest distance was searched, if the build computes it
  std::size_t sign_decisions = 0;     ///< with exact square roots: number of evaluated signs and comparisons
  std::size_t exact_decisions = 0;    ///< number of sign decisions that intervals of up to 256 bits left open
  double propagation_seconds = 0;     ///< time of the propagation alone
  double offset_seconds = 0;          ///< time of cutting offsets, without the time of the caller's output iterator or callback
};

} // namespace CGAL

#endif
