// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for Source_set.h.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_SOURCE_SET_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_SOURCE_SET_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Segment_seeding.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_set.h>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
void Source_set<FT>::start(const Unfolded_mesh<FT>& mesh, const Source& s, Index id, Initial_windows<FT>& initial)
{
  initial.set_start_value(s.start_value);
  switch (s.kind)
  {
  case POINT: initial.add_point(id, s.points.front()); break;
  case OPEN_POLYLINE: Segment_seeding<FT>(mesh, initial).add_polyline(id, s.points, s.start_values, false); break;
  case CLOSED_POLYLINE: Segment_seeding<FT>(mesh, initial).add_polyline(id, s.points, s.start_values, true); break;
  case EDGES: Segment_seeding<FT>(mesh, initial).add_edges(id, s.halfedges); break;
  }
}

template <class FT>
void Source_set<FT>::check(const Unfolded_mesh<FT>& mesh, const Source& source)
{
  Initial_windows<FT> trial(mesh);
  start(mesh, source, 0, trial);
}

template <class FT>
Initial_windows<FT> Source_set<FT>::initial_windows(const Unfolded_mesh<FT>& mesh) const
{
  Initial_windows<FT> initial(mesh);
  for (const auto& s : m_sources) start(mesh, s.second, Index(s.first), initial);
  initial.finish();
  return initial;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
