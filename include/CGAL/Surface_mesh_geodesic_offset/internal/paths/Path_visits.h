// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Visits of the elements of a path, from Path_elements.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_VISITS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_VISITS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_suffix_cache.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Passes the elements of a path to a visitor in the form of Surface_mesh_shortest_path.
template <class Surface, class Visitor>
class Path_visits
{
public:
  typedef typename Surface::Number FT;

  Path_visits(const Surface& surface, Visitor& visitor) : m_surface(surface), m_visitor(visitor) {}

  void operator()(const Path_crossing<FT>& p) const { m_visitor(m_surface.halfedge_of(p.halfedge), Surface::exported(p.part)); }

  // P: a surface point or a located point.
  template <class P>
  void operator()(const P& p) const
  {
    if (p.kind == P::VERTEX) m_visitor(m_surface.vertex_of[p.element]);
    else if (p.kind == P::EDGE)
      m_visitor(m_surface.halfedge_of(p.element), Surface::exported(FT(p.x / m_surface.unfolded[p.element].length)));
    else
    {
      const auto location = m_surface.location(p);
      m_visitor(location.first, location.second);
    }
  }

private:
  const Surface& m_surface;
  Visitor& m_visitor;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
