// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts into which the front is divided: each element of the mesh belongs to one, and what is known of the front there
// is written by none but the thread that works on this part. So threads need no locks.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FRONT_PARTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FRONT_PARTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

class Front_parts
{
public:
  // One part, or a power of two.
  explicit Front_parts(Index number = 1) : m_mask(number - 1) {}

  Index number() const { return m_mask + 1; }
  Index of_face(Index f) const { return f / block & m_mask; }
  Index of_halfedge(Index h) const { return h / (3 * block) & m_mask; }
  Index of_vertex(Index v) const { return v / block & m_mask; }

private:
  // Neighbours in memory belong together, so that threads seldom write into the same line of it; but few, so that any front
  // crosses all parts about equally often.
  static constexpr Index block = 16;
  Index m_mask;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
