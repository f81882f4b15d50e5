// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The requested part of an offset.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_SELECTION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_SELECTION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

struct Offset_selection
{
  Offset_side side = Offset_side::BOTH;
  Offset_end end = Offset_end::ROUND;

  bool is_everything() const { return side == Offset_side::BOTH && end == Offset_end::ROUND; }

  // True if the inner sides of closed polylines are needed.
  bool needs_inner_sides() const { return side == Offset_side::INSIDE || side == Offset_side::OUTSIDE; }
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
