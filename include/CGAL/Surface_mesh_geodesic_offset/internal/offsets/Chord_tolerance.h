// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Check of the tolerance of functions that replace arcs by chords.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CHORD_TOLERANCE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CHORD_TOLERANCE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <stdexcept>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// The default, as a part of the diagonal of a bounding box: not visible in pictures of the whole.
constexpr double default_chord_tolerance = 1e-4;

template <class FT>
void check_chord_tolerance(const FT& tolerance)
{
  if (!(tolerance > FT(0)))
    throw std::invalid_argument("Surface_mesh_geodesic_offset: a chord tolerance must be positive");
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
