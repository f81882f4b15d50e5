// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Connects polygons along their edges to a mesh, in time O(n log n). Surface_mesh::add_face() searches all neighbours of a
// vertex for each edge, so vertices with many faces take quadratic time.

#ifndef GEODESIC_OFFSET_POLYGON_LINKS_H
#define GEODESIC_OFFSET_POLYGON_LINKS_H

#include "common.h"

#include <algorithm>
#include <array>
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

} // namespace internal

// Sides of polygons, and which of them are the same edge. Polygons are neighbours at an edge if it has exactly two sides, with
// opposite directions.
class Polygon_links
{
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::vector<internal::Polygon_side> m_sides; // sorted
  std::vector<std::uint32_t> m_opposite; // by the number of the side
  bool m_is_manifold = true;

public:
  Polygon_links(const std::vector<Polygon>& polygons, std::size_t number_of_vertices)
  {
    for(const Polygon& polygon : polygons)
      for(std::size_t k = 0; k < polygon.size(); ++k)
      {
        const std::uint32_t a = polygon[k], b = polygon[(k + 1) % polygon.size()];
        m_sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(m_sides.size()), b < a});
      }
    internal::sort_sides(m_sides, number_of_vertices);
    m_opposite.assign(m_sides.size(), none);
    for(std::size_t i = 1; i < m_sides.size(); ++i)
    {
      const internal::Polygon_side &a = m_sides[i - 1], &b = m_sides[i];
      if(!a.has_edge_of(b)) continue;
      m_is_manifold = m_is_manifold && a.is_reversed != b.is_reversed && m_opposite[a.number] == none;
      m_opposite[a.number] = b.number;
      m_opposite[b.number] = a.number;
    }
  }

  // Whether no edge has more than two sides, or two of the same direction.
  bool is_manifold() const { return m_is_manifold; }

  // Whether there is an edge between two vertices; low < high.
  bool has_edge(std::uint32_t low, std::uint32_t high) const
  {
    const auto it = std::lower_bound(m_sides.begin(), m_sides.end(), internal::Polygon_side{low, high, 0, false});
    return it != m_sides.end() && it->low == low && it->high == high;
  }

  // Edges with one side, sorted by their ends, which are sorted, too.
  std::vector<std::array<std::uint32_t, 2>> border_edges() const
  {
    std::vector<std::array<std::uint32_t, 2>> edges;
    for(const internal::Polygon_side& side : m_sides)
      if(m_opposite[side.number] == none) edges.push_back({side.low, side.high});
    return edges;
  }

  // Adds the polygons to a mesh without faces, with the vertex at[i] for the index i. Around a vertex, each fan of faces has a
  // border of its own. Preconditions: is_manifold(); the vertices of a polygon are different.
  void link(Mesh& mesh, const std::vector<Polygon>& polygons, const std::vector<Vertex>& at) const
  {
    std::vector<Halfedge> halfedges(m_sides.size(), Mesh::null_halfedge());
    std::size_t first = 0; // side of the polygon
    for(const Polygon& polygon : polygons)
    {
      const std::size_t n = polygon.size();
      const Face face = mesh.add_face();
      for(std::size_t k = 0; k < n; ++k)
      {
        const std::uint32_t other = m_opposite[first + k];
        const bool is_known = other != none && halfedges[other] != Mesh::null_halfedge();
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
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_POLYGON_LINKS_H
