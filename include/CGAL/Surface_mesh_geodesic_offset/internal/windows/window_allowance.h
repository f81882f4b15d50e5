// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Allowance for the rounding of distances along windows.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_ALLOWANCE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_ALLOWANCE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

namespace CGAL::Geodesic_offset::internal {

// Units of rounding, of a distance and the edges beside it, within which paths are taken for equally long: windows are pruned
// (pruning_allowance()) and gaps between them closed (Lower_envelope) only up to this difference, so distances by windows may
// differ by as much.
constexpr double roundings_of_window = 256;

// `scale`: the distance, plus the edges if it may be short. Zero for exact numbers.
template <class FT>
inline FT window_allowance(const FT& scale)
{
  return Number_policy<FT>::rounding(roundings_of_window) * scale;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
