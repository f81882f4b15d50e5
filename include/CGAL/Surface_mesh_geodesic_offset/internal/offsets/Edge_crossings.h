// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Crossings of levels with an edge. They are computed once per edge, so that both faces agree, and always from the same side,
// so that they do not depend on the order of faces.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_EDGE_CROSSINGS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_EDGE_CROSSINGS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Near_intervals.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Vertex_reach.h>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Edge_crossings
{
public:
  Edge_crossings(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field,
                 const Vertex_reach<FT>& reach, const Offset_sources<FT>& sources)
    : m_mesh(mesh), m_initial(initial), m_field(field), m_reach(reach), m_sources(sources)
  {
  }

  // Calls out(t, falling) for the crossings of a level with the edge of h, like Near_intervals::for_each_end(). t is the
  // distance from the source of the halfedge with the smaller index. A vertex is near exactly if Offset_sources::is_near() is
  // true. `field`: that of the face of h; used on the border only.
  template <class OutputFunction>
  void operator()(Index h, const Face_field<FT>& field, const FT& level, const OutputFunction& out)
  {
    const Index g = m_mesh.twin(h);
    CGAL_precondition(g == no_index || h < g);
    const FT length = m_mesh[h].length;
    m_near.start(length, m_reach.of_edge(h), level);
    const FT d0 = m_field.distance[m_mesh.source(h)], d1 = m_field.distance[m_mesh.target(h)];
    const bool source_is_near = m_sources.is_near(m_mesh.source(h), level);
    const bool target_is_near = m_sources.is_near(m_mesh.target(h), level);
    if (source_is_near) m_near.add_end(true, level - d0);
    if (target_is_near) m_near.add_end(false, level - d1);
    add_side(h, false);
    if (g != no_index) add_side(g, true);
    else
    { // no list beyond the border; windows that leave the face here
      const Face_frame<FT>& frame = field.frame();
      const int k = int(h % 3);
      for (const Face_window<FT>& w : field.windows())
        if (w.origin != STARTS_IN_FACE && w.origin != Face_window_origin(k) && has_offset(w))
          m_near.add_window(w, frame.corner(k), frame.direction(k), false);
    }
    m_near.for_each_end(source_is_near, target_is_near, out);
  }

private:
  template <class Window_>
  bool has_offset(const Window_& w) const
  {
    return m_sources.reach(w.source_ref, m_near.level());
  }

  // Adds the windows of a halfedge's list, and those that start inside its face.
  void add_side(Index h, bool reversed)
  {
    m_field.for_each_window(m_mesh, h, [&](const Window<FT>& w) {
      if (this->has_offset(w)) m_near.add_window(w, reversed);
    });
    const auto range = local_windows(m_initial, m_mesh.face(h));
    if (range.first == range.second) return;
    const Face_frame<FT> frame(m_mesh, m_mesh.face(h));
    const int k = int(h % 3);
    for (auto it = range.first; it != range.second; ++it)
      if (has_offset(it->window)) m_near.add_window(it->window, frame.corner(k), frame.direction(k), reversed);
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
  const Vertex_reach<FT>& m_reach;
  const Offset_sources<FT>& m_sources;
  Near_intervals<FT> m_near;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
