// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A crossing of a level with an edge.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CROSSING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CROSSING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <cstddef>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
struct Crossing
{
  std::size_t level;
  FT position; // along the halfedge with the smaller index
  bool falling;
  Index gate;

  // True if a chain of pieces starts here in a face whose halfedge runs in the direction of `position` or, `reversed`, against
  // it; otherwise one ends here.
  bool starts_chain(bool reversed) const { return falling == reversed; }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
