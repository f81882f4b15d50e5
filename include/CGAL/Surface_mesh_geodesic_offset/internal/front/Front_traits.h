// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of a propagation that a program can do without, so that what is never used is not compiled.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FRONT_TRAITS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FRONT_TRAITS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

namespace CGAL::Geodesic_offset::internal {

// Parts of a propagation, as bits: the search for the farthest point, merging within a tolerance, and windows that are kept.
enum Build_part : unsigned { NO_PARTS = 0, SEARCH = 1, MERGING = 2, KEPT_WINDOWS = 4, ALL_PARTS = 7 };

// Traits of a front with some parts.
template <class Traits, unsigned parts>
struct Front_traits : Traits
{
  static constexpr bool may_merge = (parts & MERGING) != 0, may_keep_windows = (parts & KEPT_WINDOWS) != 0;

  explicit Front_traits(const Traits& traits) : Traits(traits) {}
};

} // namespace CGAL::Geodesic_offset::internal

#endif
