// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Repairs that leave the surface unchanged, for requirements of the solver that files often violate.

#ifndef GEODESIC_OFFSET_MESH_REPAIR_H
#define GEODESIC_OFFSET_MESH_REPAIR_H

#include "common.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
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

// Whether the middle vertex of a face lies on its longest side in double precision: its height is below the rounding of the
// shorter sides. Rays from this vertex through that side have no width, so no window represents them. `longest` receives
// the halfedge of that side.
inline bool is_flat_cap(const Mesh& mesh, Face face, Halfedge& longest)
{
  constexpr double rounding = 0x1p-46; // 64 units in the last place, of sums of some products
  longest = mesh.halfedge(face);
  const auto square = [&](Halfedge h) {
    return CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  };
  for(Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face)))
    if(square(h) > square(longest)) longest = h;
  const Point& p = mesh.point(mesh.source(longest));
  const Point& middle = mesh.point(mesh.target(mesh.next(longest)));
  const Vector along = mesh.point(mesh.target(longest)) - p, to_middle = middle - p;
  const double height = std::sqrt(CGAL::cross_product(mesh.point(mesh.target(longest)) - middle, p - middle).squared_length() /
                                  along.squared_length());
  const double shorter = std::sqrt(std::min(to_middle.squared_length(), square(mesh.next(longest))));
  return height <= rounding * shorter;
}

// Flips the longest sides of flat caps, and removes caps whose longest side is on the border: the surface is unchanged up
// to rounding. Other caps remain. Returns the number of changes. Precondition: no shared vertices.
inline std::size_t flip_flat_caps(Mesh& mesh)
{
  std::vector<Face> caps;
  Halfedge longest;
  for(Face f : mesh.faces())
    if(is_flat_cap(mesh, f, longest)) caps.push_back(f);
  std::size_t changes = 0;
  // a flip can create another cap, along a row of collinear vertices
  for(const std::size_t most = 8 * caps.size(); !caps.empty() && changes < most;)
  {
    const Face f = caps.back();
    caps.pop_back();
    if(mesh.is_removed(f) || !is_flat_cap(mesh, f, longest)) continue;
    const Halfedge beyond = mesh.opposite(longest);
    const Vertex middle = mesh.target(mesh.next(longest));
    if(mesh.is_border(beyond))
    {
      if(mesh.is_border(middle) || mesh.number_of_faces() == 1) continue;
      CGAL::Euler::remove_face(longest, mesh);
      ++changes;
      continue;
    }
    const Vertex other = mesh.target(mesh.next(beyond));
    if(other == middle || mesh.halfedge(middle, other) != Mesh::null_halfedge()) continue;
    CGAL::Euler::flip_edge(longest, mesh);
    ++changes;
    caps.push_back(mesh.face(longest));
    caps.push_back(mesh.face(mesh.opposite(longest)));
  }
  return changes;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_MESH_REPAIR_H
