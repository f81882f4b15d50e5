// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Crossings of levels with an edge by the distances in one of its faces, for distances that are continuous in each face only
// (see Edge_joining).

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_FACE_CROSSINGS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_FACE_CROSSINGS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Near_intervals.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Vertex_reach.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Face_crossings
{
public:
  Face_crossings(const Unfolded_mesh<FT>& mesh, const Geodesic_field<FT>& field, const Vertex_reach<FT>& reach,
                 const Offset_sources<FT>& sources)
    : m_mesh(mesh), m_field(field), m_reach(reach), m_sources(sources)
  {
  }

  // Calls out(t, falling) as Edge_crossings does, for the edge of h, a halfedge of the face of `field`.
  template <class OutputFunction>
  void operator()(Index h, const Face_field<FT>& field, const FT& level, const OutputFunction& out)
  {
    const Index p = m_mesh.source(h), q = m_mesh.target(h);
    const bool p_is_near = m_sources.is_near(p, level), q_is_near = m_sources.is_near(q, level);
    const FT length = m_mesh[h].length;
    const int k = int(h % 3);
    m_near.start(length, m_reach.of_face(field.face()), level);
    if (p_is_near) m_near.add_end(true, level - m_field.distance[p]);
    if (q_is_near) m_near.add_end(false, level - m_field.distance[q]);
    for (std::size_t i = 0; i < field.windows().size(); ++i)
      if (const Face_window<FT>& w = field.windows()[i]; field.lowest(i) < level && m_sources.reach(w.source_ref, level))
        m_near.add_window(w, field.frame().corner(k), field.frame().direction(k), false);
    if (!(m_mesh.twin(h) < h)) return m_near.for_each_end(p_is_near, q_is_near, out);
    m_ends.clear();
    m_near.for_each_end(p_is_near, q_is_near, [&](const FT& t, bool falling) { this->m_ends.push_back({t, falling}); });
    for (std::size_t i = m_ends.size(); i-- > 0;) out(FT(length - m_ends[i].first), !m_ends[i].second);
  }

private:
  const Unfolded_mesh<FT>& m_mesh;
  const Geodesic_field<FT>& m_field;
  const Vertex_reach<FT>& m_reach;
  const Offset_sources<FT>& m_sources;
  Near_intervals<FT> m_near;
  std::vector<std::pair<FT, bool>> m_ends;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
