// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lays faces out in the plane, from the points of their vertices.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_LAYOUT_BY_POINTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_LAYOUT_BY_POINTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <vector>

namespace CGAL::Geodesic_offset::internal {

// A layout has a function functor(), whose result is called with a face and its vertices, and returns an array of lengths and
// apices; see SurfaceMeshGeodesicOffsetTraits::Construct_apices_2.
template <class Traits>
class Layout_by_points
{
public:
  typedef typename Traits::FT FT;

  // points: of the vertices
  Layout_by_points(const std::vector<typename Traits::Point_3>& points, const Traits& traits)
    : m_points(points), m_traits(traits)
  {
  }

  auto functor() const
  {
    return [&points = m_points, construct_apices = m_traits.construct_apices_2_object()](Index, const Index(&v)[3]) {
      return construct_apices(points[v[0]], points[v[1]], points[v[2]]);
    };
  }

private:
  const std::vector<typename Traits::Point_3>& m_points;
  const Traits& m_traits;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
