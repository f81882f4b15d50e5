// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fans of faces that share a vertex.

#ifndef GEODESIC_OFFSET_VERTEX_FANS_H
#define GEODESIC_OFFSET_VERTEX_FANS_H

#include "common.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace geodesic_offset {

// Whether fans of faces share a vertex. A fan is a maximal set of faces around a vertex that are connected by edges at the
// vertex; it is open if two of these edges are on the border, otherwise closed. Precondition: the mesh has no garbage.
inline bool has_shared_vertex(const Mesh& mesh)
{
  // a closed fan has as many inner edges as corners, an open fan one less
  std::vector<std::uint32_t> halfedges(mesh.number_of_vertices(), 0), borders(mesh.number_of_vertices(), 0);
  for(Halfedge h : mesh.halfedges())
  {
    ++halfedges[mesh.target(h)];
    if(mesh.is_border(h)) ++borders[mesh.target(h)];
  }
  for(Vertex v : mesh.vertices())
  {
    if(mesh.is_isolated(v)) continue;
    if(borders[v] > 1) // open fans
      return true;
    const Halfedge first = mesh.halfedge(v);
    Halfedge h = first;
    do {
      --halfedges[v];
      h = mesh.opposite(mesh.next(h));
    } while(h != first);
    if(halfedges[v] != 0) // a closed fan not connected with the others
      return true;
  }
  return false;
}

// Merges vertices that are connected by pairs; fans keep their faces and borders. Afterwards the mesh must not be changed
// by flips and collapses, since rotations around a vertex reach only one of its fans. new_vertex[v] is the new vertex of v.
// Returns the vertices with several fans.
inline std::vector<Vertex> join_vertices(Mesh& mesh, const std::vector<std::pair<Vertex, Vertex>>& pairs,
                                         std::vector<Vertex>& new_vertex)
{
  std::vector<Vertex> joined(mesh.number_of_vertices()); // a forest, whose roots have the smallest indices
  for(Vertex v : mesh.vertices()) joined[v] = v;
  const auto root = [&](Vertex v) {
    while(joined[v] != v) v = joined[v] = joined[joined[v]];
    return v;
  };
  for(const std::pair<Vertex, Vertex>& pair : pairs)
  {
    const Vertex a = root(pair.first), b = root(pair.second);
    joined[std::max(a, b)] = std::min(a, b);
  }
  auto old_vertex = mesh.add_property_map<Vertex, Vertex>("v:old").first;
  for(Vertex v : mesh.vertices()) old_vertex[v] = v;
  for(Halfedge h : mesh.halfedges()) mesh.set_target(h, root(mesh.target(h)));
  std::vector<bool> is_shared(joined.size(), false);
  for(std::size_t i = 0; i < joined.size(); ++i)
  {
    const Vertex v(static_cast<Mesh::size_type>(i));
    if(joined[v] == v) continue;
    is_shared[root(v)] = true;
    mesh.remove_vertex(v);
  }
  mesh.collect_garbage();
  std::vector<Vertex> at(joined.size(), Mesh::null_vertex()), shared;
  for(Vertex v : mesh.vertices())
  {
    at[old_vertex[v]] = v;
    if(is_shared[old_vertex[v]]) shared.push_back(v);
  }
  mesh.remove_property_map(old_vertex);
  new_vertex.resize(joined.size());
  for(std::size_t i = 0; i < joined.size(); ++i) new_vertex[i] = at[root(Vertex(static_cast<Mesh::size_type>(i)))];
  return shared;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_VERTEX_FANS_H
