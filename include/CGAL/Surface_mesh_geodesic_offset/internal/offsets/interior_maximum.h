// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides whether the distance may have a local maximum inside a face: only if rays reach its points from all around.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_INTERIOR_MAXIMUM_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_INTERIOR_MAXIMUM_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// False only if the directions of all rays in the face lie in an open half-plane, as the distance then grows along their middle
// direction. (Corner functions count only where shortest paths continue behind the corner; elsewhere they are never below the
// other windows.)
template <class FT>
bool may_have_interior_maximum(const Face_field<FT>& field)
{
  typedef Point_in_face<FT> Point;
  // The directions of a window reach counterclockwise from its right to its left ray, by less than a half turn. [from, to] is
  // the cone of all directions, counterclockwise, as long as it is narrower than a half turn.
  bool empty = true;
  Point from{FT(1), FT(0)}, to{FT(1), FT(0)};
  for (const Face_window<FT>& w : field.windows())
  {
    if (w.origin == STARTS_IN_FACE) return true;
    if (w.is_empty()) continue;
    const Point r = w.right_ray(), l = w.left_ray();
    if (empty)
    {
      from = r;
      to = l;
      empty = false;
      continue;
    }
    for (const Point& u : {r, l})
    {
      const bool after_from = !CGAL::is_negative(cross(from, u)), before_to = !CGAL::is_negative(cross(u, to));
      if (after_from && before_to && CGAL::is_positive(dot(u, from + to))) continue;
      if (after_from && CGAL::is_positive(cross(from, u)) && !before_to) to = u;
      else if (before_to && CGAL::is_positive(cross(u, to)) && !after_from) from = u;
      else return true;
    }
  }
  return false;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
