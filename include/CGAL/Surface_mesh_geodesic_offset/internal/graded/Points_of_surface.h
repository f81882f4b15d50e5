// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points of a surface for Graded_places and Extended_mesh.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_POINTS_OF_SURFACE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_POINTS_OF_SURFACE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// The coordinates of a vertex; empty for a mesh without points.
typedef std::function<std::array<double, 3>(Index)> Point_of_vertex;

template <class Surface>
class Points_of_surface
{
public:
  explicit Points_of_surface(const Surface& surface) : m_surface(surface) {}

  bool has_points() const { return m_surface.has_points; }

  std::array<double, 3> operator()(Index v) const
  {
    const auto p = m_surface.position(m_surface.vertex_of[v]);
    return {p.x(), p.y(), p.z()};
  }

  // Empty without points. It refers to the surface.
  Point_of_vertex point_of_vertex() const
  {
    if (!has_points()) return {};
    return [points = *this](Index v) { return points(v); };
  }

  // The distance in space of vertex v from the edge of a and b, a lower bound of that on the surface. Zero without points.
  double between(Index v, Index a, Index b) const
  {
    if (!has_points()) return 0;
    const std::array<double, 3> p = (*this)(v), q = (*this)(a);
    const std::array<double, 3> to_p = difference(p, q), along = difference(a == b ? q : (*this)(b), q);
    const double square = dot(along, along);
    const double t = square > 0 ? (std::max)(0., (std::min)(1., dot(to_p, along) / square)) : 0.;
    return std::hypot(to_p[0] - t * along[0], to_p[1] - t * along[1], to_p[2] - t * along[2]);
  }

private:
  static std::array<double, 3> difference(const std::array<double, 3>& p, const std::array<double, 3>& q)
  {
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
  }
  static double dot(const std::array<double, 3>& u, const std::array<double, 3>& v)
  {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  }

  const Surface& m_surface;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
