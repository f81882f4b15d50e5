// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Upper bound of the largest distance of the surface, computed before the main computation.

#ifndef GEODESIC_OFFSET_REACH_H
#define GEODESIC_OFFSET_REACH_H

#include "common/common.h"
#include "common/sources.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace geodesic_offset {
namespace internal {

inline double edge_length(const Mesh& mesh, Halfedge h)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
}

// Halfedges with their targets at each vertex, in all of its fans.
class Incoming_halfedges
{
  std::vector<std::size_t> m_begin;
  std::vector<Halfedge> m_halfedges;

public:
  explicit Incoming_halfedges(const Mesh& mesh)
    : m_begin(mesh.number_of_vertices() + 1, 0), m_halfedges(mesh.number_of_halfedges())
  {
    for(Halfedge h : mesh.halfedges()) ++m_begin[mesh.target(h) + 1];
    for(std::size_t v = 1; v < m_begin.size(); ++v) m_begin[v] += m_begin[v - 1];
    std::vector<std::size_t> end(m_begin.begin(), m_begin.end() - 1);
    for(Halfedge h : mesh.halfedges()) m_halfedges[end[mesh.target(h)]++] = h;
  }

  template <class Function>
  void for_each(Vertex v, const Function& f) const
  {
    for(std::size_t i = m_begin[v]; i < m_begin[v + 1]; ++i) f(m_halfedges[i]);
  }
};

// For each vertex, the length of the shortest path to a source along edges, by Dijkstra's algorithm.
inline std::vector<double> distances_along_edges(const Mesh& mesh, const Sources& sources)
{
  using Entry = std::pair<double, Vertex>;
  std::vector<double> distances(mesh.number_of_vertices(), infinity);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto reach = [&](Vertex v, double distance) {
    if(!(distance < distances[v])) return;
    distances[v] = distance;
    queue.emplace(distance, v);
  };
  sources.for_each_start(reach);
  const Incoming_halfedges incoming(mesh);
  while(!queue.empty())
  {
    const Entry nearest = queue.top();
    queue.pop();
    if(nearest.first > distances[nearest.second]) continue;
    incoming.for_each(nearest.second, [&](Halfedge h) { reach(mesh.source(h), nearest.first + edge_length(mesh, h)); });
  }
  return distances;
}

} // namespace internal

// Upper bound of the largest finite distance of the surface. In a face no distance exceeds the sum of a corner's distance
// and the longer of the two edges there. Takes a small fraction of the time of a build.
inline double bound_of_reach(const Mesh& mesh, const Sources& sources)
{
  const std::vector<double> distances = internal::distances_along_edges(mesh, sources);
  double reach = 0;
  for(Face f : mesh.faces())
  {
    double bound = infinity;
    for(Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
    {
      const double longer = std::max(internal::edge_length(mesh, h), internal::edge_length(mesh, mesh.next(h)));
      bound = std::min(bound, distances[mesh.target(h)] + longer);
    }
    if(bound < infinity) reach = std::max(reach, bound);
  }
  return reach;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_REACH_H
