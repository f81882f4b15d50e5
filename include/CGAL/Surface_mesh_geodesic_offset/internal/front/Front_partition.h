// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The division of a mesh into parts for several threads: faces that follow each other in memory, and so mostly are
// neighbours.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FRONT_PARTITION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FRONT_PARTITION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Front_parts.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <cstdint>
#include <vector>

// A part, but for the last one, has two to this power faces at least: smaller ones have too many windows on their borders.
// Tests want many parts of small meshes.
#ifndef CGAL_GEODESIC_OFFSET_BITS_OF_A_PART
#define CGAL_GEODESIC_OFFSET_BITS_OF_A_PART 11
#endif

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

class Front_partition
{
public:
  static constexpr Index largest_number = 64;

  // `shares_all`: whether what is known of any vertex may be read from anywhere.
  template <class FT>
  Front_partition(const Unfolded_mesh<FT>& mesh, bool shares_all) : m_vertex(mesh.number_of_vertices(), no_part)
  {
    const Index faces = Index(mesh.number_of_faces());
    if (faces > 0)
    {
      while ((faces - 1) >> m_bits >= largest_number) ++m_bits;
      m_number = ((faces - 1) >> m_bits) + 1;
    }
    for (Index f = 0; f < faces; ++f)
    {
      if (mesh.source(3 * f) == no_index) continue; // no face
      const std::uint8_t part = std::uint8_t(f >> m_bits);
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (std::uint8_t& v = m_vertex[mesh.source(h)]; v == no_part) v = part;
        else if (v != part) v |= Front_parts::is_shared;
    }
    for (std::uint8_t& v : m_vertex)
      if (v == no_part) v = 0; // isolated
      else if (shares_all) v |= Front_parts::is_shared;
  }

  Front_parts parts() const { return Front_parts(m_number, m_bits, m_vertex.data()); }

private:
  static constexpr std::uint8_t no_part = 0xff;

  Index m_number = 1;
  int m_bits = CGAL_GEODESIC_OFFSET_BITS_OF_A_PART;
  std::vector<std::uint8_t> m_vertex; // parts, and bits
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
