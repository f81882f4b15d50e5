// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Connected parts and border cycles of a mesh.

#ifndef GEODESIC_OFFSET_SURFACE_PARTS_H
#define GEODESIC_OFFSET_SURFACE_PARTS_H

#include "common.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace geodesic_offset {

// A part consists of the vertices that paths connect, also through vertices that fans of faces share.
class Surface_parts
{
  std::vector<Vertex> m_first; // of the part of a vertex
  std::size_t m_number = 0;
  std::size_t m_border_cycles = 0;

public:
  Surface_parts() = default;

  // Vertices without faces, as those that only copies in other fans replace, are no parts. Precondition: the mesh has no garbage.
  explicit Surface_parts(const Mesh& mesh) : m_first(mesh.vertices().begin(), mesh.vertices().end())
  {
    for(Edge e : mesh.edges())
    {
      const Vertex v = root(mesh.vertex(e, 0)), w = root(mesh.vertex(e, 1));
      m_first[std::max(v, w)] = std::min(v, w);
    }
    for(Vertex v : mesh.vertices())
    {
      m_first[v] = root(v);
      m_number += m_first[v] == v && !mesh.is_isolated(v) ? 1 : 0;
    }
    std::vector<bool> is_seen(mesh.number_of_halfedges(), false);
    for(Halfedge first : mesh.halfedges())
    {
      if(!mesh.is_border(first) || is_seen[first]) continue;
      ++m_border_cycles;
      for(Halfedge h = first; !is_seen[h]; h = mesh.next(h)) is_seen[h] = true;
    }
  }

  std::size_t number() const { return m_number; }
  std::size_t number_of_border_cycles() const { return m_border_cycles; }

  // The first vertex of the part of a vertex.
  Vertex first_vertex(Vertex v) const { return m_first[v]; }

  std::size_t number_of_vertices() const { return m_first.size(); }

private:
  Vertex root(Vertex v)
  {
    while(m_first[v] != v) v = m_first[v] = m_first[m_first[v]];
    return v;
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_SURFACE_PARTS_H
