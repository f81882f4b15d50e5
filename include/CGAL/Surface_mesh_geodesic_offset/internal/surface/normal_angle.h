// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Angle between the normals of two adjacent faces.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_NORMAL_ANGLE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_NORMAL_ANGLE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL::Geodesic_offset::internal {

// Angle in degrees, from 0 to 180, rounded. It is computed from the heights of the two faces over the common edge, which
// are orthogonal to the edge, so the error is about 1e-14 also near 0 and 180, where a cosine is ill-conditioned, and in
// needle faces with a short common edge. h: a halfedge with a face on either side. Surface: a Geodesic_surface.
template <class Surface>
double angle_of_normals(const Surface& surface, typename Surface::halfedge_descriptor h)
{
  typedef typename Surface::FT FT;
  typedef typename Surface::Point_3 Point_3;
  typedef typename Surface::Vector_3 Vector_3;
  const auto& tm = surface.tm;
  const Point_3 a = surface.position(source(h, tm));
  const Vector_3 e = surface.position(target(h, tm)) - a;
  const auto height = [&](typename Surface::halfedge_descriptor g) {
    const Vector_3 v = surface.position(target(next(g, tm), tm)) - a;
    return Vector_3(v - FT((v * e) / e.squared_length()) * e);
  };
  const Vector_3 n = height(h), m = -height(opposite(h, tm)), c = CGAL::cross_product(n, m);
  const double sine = std::hypot(CGAL::to_double(c.x()), CGAL::to_double(c.y()), CGAL::to_double(c.z()));
  return std::atan2(sine, CGAL::to_double(n * m)) * 180 / CGAL_PI;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
