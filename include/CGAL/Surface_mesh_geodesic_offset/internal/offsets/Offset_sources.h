// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sources that have an offset at a level: those whose start value is less by more than rounding. Otherwise rounding would
// decide where distances are less than the level, in different ways for vertices, crossings with edges, and arcs. So the
// decision is made here, once for each source and level, and the windows of all other sources are left out everywhere.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_SOURCES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_SOURCES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Vertex_reach.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// All parts of a source have the same bound, so that its offset is found as a whole.
template <class FT>
class Offset_sources
{
public:
  Offset_sources(const Initial_windows<FT>& initial, const Geodesic_field<FT>& field, const Vertex_reach<FT>& reach)
    : m_field(field)
  {
    const std::vector<Index>& source_of = initial.source_of;
    std::vector<FT> reach_of_source;
    const auto add = [&](Source_ref source_ref, const FT& length) {
      const Index source = source_of[source_ref.primitive()];
      if (!(source < reach_of_source.size())) reach_of_source.resize(source + 1, FT(0));
      reach_of_source[source] = (std::max)(reach_of_source[source], length);
    };
    // Only segments need a margin: the windows of a point have its start value exactly.
    for (const auto& w : initial.local)
      if (w.window.is_parallel()) add(w.window.source_ref, reach.of_face(w.face));
    for (const auto& w : initial.edges) add(w.source_ref, reach.of_edge(w.halfedge));
    m_bound.reserve(source_of.size());
    for (Index i = 0; i < source_of.size(); ++i)
    {
      const FT& start_value = field.start_values.of(Source_ref(i, Source_side::NONE));
      const FT length = source_of[i] < reach_of_source.size() ? reach_of_source[source_of[i]] : FT(0);
      const bool has_margin = CGAL::is_positive(length);
      m_bound.push_back(has_margin ? FT(start_value + Offset_tolerances<FT>::least_offset(length + start_value)) : start_value);
      m_largest_bound = (std::max)(m_largest_bound, m_bound.back());
    }
  }

  // True if the source has an offset at a level. Mostly all sources have, which one comparison tells.
  bool reach(Source_ref source_ref, const FT& level) const
  {
    CGAL_precondition(source_ref.is_valid() && source_ref.primitive() < m_bound.size());
    return m_largest_bound < level || m_bound[source_ref.primitive()] < level;
  }

  // True if the distance of vertex v is less than a level.
  bool is_near(Index v, const FT& level) const { return m_field.distance[v] < level && reach(m_field.source_ref[v], level); }

  // The difference between a level and the start value of a source: its distance from the source without the start value.
  FT offset(Source_ref source_ref, const FT& level) const { return level - m_field.start_values.of(source_ref); }

private:
  const Geodesic_field<FT>& m_field;
  std::vector<FT> m_bound; // per primitive: levels up to this are no offsets
  FT m_largest_bound = FT(0);
};

} // namespace CGAL::Geodesic_offset::internal

#endif
