// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Division of a mesh into parts for several threads. A part consists of faces that are consecutive in memory, mostly
// neighbours.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FRONT_PARTITION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FRONT_PARTITION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Front_parts.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

class Front_partition
{
public:
  static constexpr Index largest_number = 64;

  // `shares_all`: true if every thread may read every vertex.
  template <class FT>
  Front_partition(const Unfolded_mesh<FT>& mesh, bool shares_all) : m_vertex(mesh.number_of_vertices(), no_part)
  {
    const Index faces = Index(mesh.number_of_faces());
    m_bits = bits_of_a_part(faces);
    if (faces > 0) m_number = ((faces - 1) >> m_bits) + 1;
    std::vector<std::uint8_t> last(m_vertex.size(), no_part); // last part around each vertex; `m_vertex`: first part
    for (Index f = 0; f < faces; ++f)
    {
      if (mesh.source(3 * f) == no_index) continue; // no face
      const std::uint8_t part = std::uint8_t(f >> m_bits);
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      { // without branches
        const Index v = mesh.source(h);
        m_vertex[v] = (std::min)(m_vertex[v], part);
        last[v] = part;
      }
    }
    for (std::size_t v = 0; v < m_vertex.size(); ++v)
      if (m_vertex[v] == no_part) m_vertex[v] = 0; // isolated
      else if (shares_all || m_vertex[v] != last[v]) m_vertex[v] |= Front_parts::is_shared;
  }

  Front_parts parts() const { return Front_parts(m_number, m_bits, m_vertex.data()); }

private:
  static constexpr std::uint8_t no_part = 0xff;

  // The length of a front, the work per round and the number of parts for balanced rounds grow with the square root of the
  // number of faces. Smaller parts have too many windows on their borders and too many turns.
  static int bits_of_a_part(Index faces)
  {
#ifdef CGAL_GEODESIC_OFFSET_BITS_OF_A_PART // for tests, which divide small meshes into many parts
    int bits = CGAL_GEODESIC_OFFSET_BITS_OF_A_PART;
#else
    constexpr double least = 12; // square roots
    int bits = 11;
    while (double(Index(1) << bits) < least * std::sqrt(double(faces))) ++bits;
#endif
    while (faces > 0 && (faces - 1) >> bits >= largest_number) ++bits;
    return bits;
  }

  Index m_number = 1;
  int m_bits;
  std::vector<std::uint8_t> m_vertex; // parts, and bits
};

} // namespace CGAL::Geodesic_offset::internal

#endif
