// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A range of level indices.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_RANGE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_RANGE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <cstddef>

namespace CGAL::Geodesic_offset::internal {

struct Level_range
{
  std::size_t first, last; // `last` is excluded
  bool is_empty() const { return first >= last; }
  std::size_t size() const { return is_empty() ? 0 : last - first; }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
