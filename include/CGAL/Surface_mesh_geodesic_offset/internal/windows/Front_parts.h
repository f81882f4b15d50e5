// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of the front: each element of the mesh belongs to one. In a round, only the thread that works on a part writes the
// front's data there; shared vertices are written at the end of the round. So threads need no locks.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_FRONT_PARTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_FRONT_PARTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <cstdint>
#include <limits>

namespace CGAL::Geodesic_offset::internal {

// Maps elements to parts: one part, or those of a Front_partition, which must outlive this object.
class Front_parts
{
public:
  // Flag beside the owner of a vertex: faces of other parts meet there.
  static constexpr std::uint8_t is_shared = 0x80;

  Front_parts() = default;

  // Parts of 2^bits faces.
  Front_parts(Index number, int bits, const std::uint8_t* vertex) : m_number(number), m_bits(bits), m_vertex(vertex) {}

  Index number() const { return m_number; }
  Index of_face(Index f) const { return f >> m_bits; }
  Index of_halfedge(Index h) const { return h / 3 >> m_bits; }
  Index of_vertex(Index v) const { return m_vertex ? m_vertex[v] & Index(is_shared - 1) : 0; }

  // True if all faces around a vertex belong to its part.
  bool has_alone(Index v) const { return !m_vertex || !(m_vertex[v] & is_shared); }

private:
  Index m_number = 1;
  int m_bits = std::numeric_limits<Index>::digits - 1; // there are fewer faces
  const std::uint8_t* m_vertex = nullptr;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
