// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of the surface in space.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_POINTS_IN_SPACE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_POINTS_IN_SPACE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_points.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/weighted_points.h>

namespace CGAL::Geodesic_offset::internal {

// Numbers of the unfolded mesh are those of the kernel.
template <class Kernel>
class Points_in_space
{
public:
  typedef typename Kernel::FT FT;
  typedef typename Kernel::Point_3 Point_3;

  Points_in_space(const Unfolded_mesh<FT>& mesh, const Surface_points<Kernel>& points) : m_mesh(mesh), m_points(points) {}

  Point_3 point(const Path_crossing<FT>& c) const { return between(c.source, c.target, c.part); }

  Point_3 point(const Surface_point<FT>& p) const
  {
    if (p.kind == Surface_point<FT>::VERTEX) return m_points.point_of_vertex(p.element);
    if (p.kind == Surface_point<FT>::EDGE)
      return between(m_mesh.source(p.element), m_mesh.target(p.element), FT(p.x / m_mesh[p.element].length));
    return weighted(p.element, Face_frame<FT>(m_mesh, p.element).barycentric({p.x, p.y}));
  }

  Point_3 point(const Located_point<FT>& p) const
  {
    if (p.kind != Surface_point<FT>::FACE) return point(static_cast<const Surface_point<FT>&>(p));
    return weighted(p.element, p.weights);
  }

private:
  Point_3 between(Index a, Index b, const FT& t) const
  {
    return point_between<Point_3, FT>(m_points.point_of_vertex(a), m_points.point_of_vertex(b), t);
  }

  Point_3 weighted(Index face, const Per_corner<FT>& weights) const
  {
    const auto corner = [&](Index k) { return m_points.point_of_vertex(m_mesh.source(3 * face + k)); };
    return weighted_point<Point_3, FT>(weights, {corner(0), corner(1), corner(2)});
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Surface_points<Kernel>& m_points;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
