// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Visits of the elements of a path, from Path_elements.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_PATH_VISITS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_PATH_VISITS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_start.h>

#include <variant>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Calls out(p) for the start p of a path, and out(crossing) or out(surface point) for the elements that it meets; nothing if p is
// not reached.
template <class Build, class FT, class Function>
void visit_path(const Build& build, const Located_point<FT>& p, const Path_start<FT>& start, const Function& out)
{
  if (!start.is_reached()) return;
  std::vector<Path_element<FT>> path;
  build.trace_path(p, start, path);
  out(p);
  for (const Path_element<FT>& e : path) std::visit(out, e);
}

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

} // namespace CGAL::Geodesic_offset::internal

#endif
