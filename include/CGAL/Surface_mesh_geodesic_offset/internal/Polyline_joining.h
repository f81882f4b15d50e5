// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joins points of the surface by shortest paths. Consecutive points of a polyline are mostly near each other, so each path is
// computed on a small mesh of the faces that it may pass, whatever the size of the whole mesh.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_POLYLINE_JOINING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_POLYLINE_JOINING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_points.h>

#include <vector>

namespace CGAL::Geodesic_offset::internal {

// `Kernel`: that of the points in space.
template <class Traits, class Kernel>
class Polyline_joining
{
public:
  typedef typename Traits::FT Number;

  // The arguments must outlive this object.
  Polyline_joining(const Unfolded_mesh<Number>& mesh, const Surface_points<Kernel>& points, const Traits& traits)
    : m_mesh(mesh), m_points(points), m_traits(traits)
  {
  }

  // Appends the crossings and vertices of the shortest path, without its ends. Returns false if there is no path.
  bool join(const Located_point<Number>& from, const Located_point<Number>& to, std::vector<Path_crossing<Number>>& path) const;

private:
  class Patch;
  class Bound;

  const Unfolded_mesh<Number>& m_mesh;
  const Surface_points<Kernel>& m_points;
  const Traits& m_traits;
};

} // namespace CGAL::Geodesic_offset::internal

#ifndef CGAL_GEODESIC_OFFSET_COMPILED
#include <CGAL/Surface_mesh_geodesic_offset/internal/Polyline_joining_impl.h>
#endif

#endif
