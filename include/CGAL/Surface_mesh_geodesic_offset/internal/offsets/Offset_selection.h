// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The requested part of an offset.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_SELECTION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_SELECTION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>

#include <cstddef>
#include <map>
#include <optional>

namespace CGAL::Geodesic_offset::internal {

struct Offset_selection
{
  Offset_side side = Offset_side::BOTH;
  std::optional<Offset_end> end = std::nullopt;
  std::map<std::size_t, Offset_side> side_of_source = {}; // by id; those of the other sources are `side`

  Offset_side side_of(std::size_t source) const
  {
    const auto it = side_of_source.find(source);
    return it == side_of_source.end() ? side : it->second;
  }

  Offset_end end_of(std::size_t source) const
  {
    return end.value_or(side_of(source) == Offset_side::BOTH ? Offset_end::ROUND : Offset_end::BUTT);
  }

  bool is_everything() const
  {
    return side == Offset_side::BOTH && side_of_source.empty() && end.value_or(Offset_end::ROUND) == Offset_end::ROUND;
  }

  // True if this is the inner or outer side of the source.
  bool needs_inside_of(std::size_t source) const
  {
    return side_of(source) == Offset_side::INSIDE || side_of(source) == Offset_side::OUTSIDE;
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
