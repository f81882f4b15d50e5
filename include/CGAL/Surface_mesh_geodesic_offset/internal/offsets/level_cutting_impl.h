// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for level_cutting.h.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_CUTTING_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_CUTTING_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Curve_selection.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_cutter.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_extraction.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/level_cutting.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class Concurrency_tag, class Traits>
void cut_all_faces(const Unfolded_mesh<typename Traits::FT>& mesh, const Geodesic_build<Traits>& build,
                   const Level_request<typename Traits::FT>& request, const Level_output<typename Traits::FT>& out)
{
  typedef typename Traits::FT FT;
  const Curve_selection<FT> select(mesh, build, request, out); // also without levels: checks the selection
  if (request.levels.size() == 0) return;
  constexpr std::size_t at_once = 1 << 12; // faces per call of cut(), which lists them with their levels
  Offset_extraction<FT> extraction(mesh, build.initial, build.field, request.levels, build.maximum, build.request().tolerance);
  {
    auto&& team = Concurrency<Concurrency_tag, FT>::Team::make();
    std::vector<Index> faces;
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
    {
      if (mesh.source(3 * f) != no_index) faces.push_back(f);
      if (faces.size() < at_once && f + 1 < mesh.number_of_faces()) continue;
      extraction.cut(faces, team);
      faces.clear();
    }
  }
  extraction.release_all(build.maximum, select);
}

template <class Concurrency_tag, unsigned parts, class Traits>
void cut_finalized_faces(const Unfolded_mesh<typename Traits::FT>& mesh, Geodesic_build<Traits>& build, const Traits& traits,
                         const Level_request<typename Traits::FT>& request, const Level_output<typename Traits::FT>& out)
{
  typedef typename Traits::FT FT;
  const Curve_selection<FT> select(mesh, build, request, out);
  Level_cutter<FT, typename Concurrency<Concurrency_tag, FT>::Team::Type> cutter(mesh, build, request, select);
  build.template run<Concurrency_tag, parts>(traits, cutter);
  cutter.finish(build.maximum, build.statistics);
}

} // namespace CGAL::Geodesic_offset::internal

#endif
