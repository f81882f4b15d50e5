// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Connects polygons along their edges to a mesh, in time O(n log n). Surface_mesh::add_face() searches all neighbours of a
// vertex for each edge, so vertices with many faces take quadratic time.

#ifndef GEODESIC_OFFSET_POLYGON_LINKS_H
#define GEODESIC_OFFSET_POLYGON_LINKS_H

#include "common.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace geodesic_offset {
namespace internal {

// A side of a polygon. Sides of all polygons are numbered consecutively.
struct Polygon_side
{
  std::uint32_t low, high; // the ends, sorted
  std::uint32_t number;
  bool is_reversed; // from high to low

  bool operator<(const Polygon_side& s) const { return std::tie(low, high, number) < std::tie(s.low, s.high, s.number); }
  bool has_edge_of(const Polygon_side& s) const { return low == s.low && high == s.high; }
};

constexpr std::uint32_t no_side = std::numeric_limits<std::uint32_t>::max();

// Sorts the sides: into one range per low end, as most ends have few sides, then each range.
inline void sort_sides(std::vector<Polygon_side>& sides, std::size_t number_of_vertices)
{
  std::vector<std::size_t> end_of(number_of_vertices + 1, 0); // of the range before that of a vertex; later of its own range
  for(const Polygon_side& side : sides) ++end_of[side.low + 1];
  std::partial_sum(end_of.begin(), end_of.end(), end_of.begin());
  std::vector<Polygon_side> sorted(sides.size());
  for(const Polygon_side& side : sides) sorted[end_of[side.low]++] = side;
  std::size_t first = 0;
  for(std::size_t v = 0; v < number_of_vertices; first = end_of[v++])
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(first), sorted.begin() + static_cast<std::ptrdiff_t>(end_of[v]));
  sides = std::move(sorted);
}

// For each side the side of another polygon with the opposite direction; no_side: none. Returns false if an edge has more than
// two sides, or two of the same direction.
inline bool find_opposite_sides(std::vector<Polygon_side>& sides, std::size_t number_of_vertices,
                                std::vector<std::uint32_t>& opposite)
{
  opposite.assign(sides.size(), no_side);
  sort_sides(sides, number_of_vertices);
  for(std::size_t i = 1; i < sides.size(); ++i)
  {
    const Polygon_side &a = sides[i - 1], &b = sides[i];
    if(!a.has_edge_of(b)) continue;
    if(a.is_reversed == b.is_reversed || opposite[a.number] != no_side) return false;
    opposite[a.number] = b.number;
    opposite[b.number] = a.number;
  }
  return true;
}

} // namespace internal

// Adds polygons with the indices of vertices, at[i] for index i, to a mesh without faces. Around a vertex, each fan of faces has
// a border of its own. Returns false if an edge has more than two faces, or two that are not oriented alike; faces may be
// missing then. Precondition: the vertices of a polygon are different.
inline bool link_polygons(Mesh& mesh, const std::vector<Polygon>& polygons, const std::vector<Vertex>& at)
{
  std::vector<internal::Polygon_side> sides;
  for(const Polygon& polygon : polygons)
    for(std::size_t k = 0; k < polygon.size(); ++k)
    {
      const std::uint32_t a = polygon[k], b = polygon[(k + 1) % polygon.size()];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(sides.size()), b < a});
    }
  std::vector<std::uint32_t> opposite;
  if(!internal::find_opposite_sides(sides, at.size(), opposite)) return false;

  std::vector<Halfedge> halfedges(sides.size(), Mesh::null_halfedge());
  std::size_t first = 0; // side of the polygon
  for(const Polygon& polygon : polygons)
  {
    const std::size_t n = polygon.size();
    const Face face = mesh.add_face();
    for(std::size_t k = 0; k < n; ++k)
    {
      const std::uint32_t other = opposite[first + k];
      const bool is_known = other != internal::no_side && halfedges[other] != Mesh::null_halfedge();
      halfedges[first + k] =
        is_known ? mesh.opposite(halfedges[other]) : mesh.add_edge(at[polygon[k]], at[polygon[(k + 1) % n]]);
      mesh.set_face(halfedges[first + k], face);
      mesh.set_halfedge(at[polygon[(k + 1) % n]], halfedges[first + k]);
    }
    for(std::size_t k = 0; k < n; ++k) mesh.set_next(halfedges[first + k], halfedges[first + (k + 1) % n]);
    mesh.set_halfedge(face, halfedges[first + n - 1]);
    first += n;
  }
  for(Halfedge h : mesh.halfedges())
    if(mesh.is_border(h))
    {
      Halfedge next = mesh.opposite(h); // turned around the target of h until it has no face
      while(!mesh.is_border(next)) next = mesh.opposite(mesh.prev(next));
      mesh.set_next(h, next);
      mesh.set_halfedge(mesh.target(h), h); // as Surface_mesh requires of vertices on the border
    }
  return true;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_POLYGON_LINKS_H
