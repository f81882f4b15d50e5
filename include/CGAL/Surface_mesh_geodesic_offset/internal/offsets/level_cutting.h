// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts a build into the offset curves of levels.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_CUTTING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_CUTTING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_selection.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
struct Level_curve
{
  bool is_closed;
  std::vector<Level_piece<FT>> pieces;
};

// Receives the curves of a level, which is given by its index.
template <class FT>
using Level_output = std::function<void(std::size_t, std::vector<Level_curve<FT>>&&)>;

// What is cut; the levels must outlive the cutting.
template <class FT>
struct Level_request
{
  const Offset_levels<FT>& levels;
  Offset_selection selection;
  bool only_curves = false; // propagation ends with the last curve of the selection
};

// Cuts all faces at all levels. Levels without curves may be left out. Precondition: build.kept.
// \throws std::invalid_argument if a side is selected that a polyline does not have, or if unlimited levels are too close
template <class Concurrency_tag, class Traits>
void cut_all_faces(const Unfolded_mesh<typename Traits::FT>& mesh, const Geodesic_build<Traits>& build,
                   const Level_request<typename Traits::FT>& request, const Level_output<typename Traits::FT>& out);

// Propagates, and cuts the finalized faces at all levels. `parts` as in Geodesic_build::propagate().
template <class Concurrency_tag, unsigned parts, class Traits>
void cut_finalized_faces(const Unfolded_mesh<typename Traits::FT>& mesh, Geodesic_build<Traits>& build, const Traits& traits,
                         const Level_request<typename Traits::FT>& request, const Level_output<typename Traits::FT>& out);

} // namespace CGAL::Geodesic_offset::internal

#ifndef CGAL_GEODESIC_OFFSET_COMPILED
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/level_cutting_impl.h>
#endif

#endif
