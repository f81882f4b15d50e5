// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// First-order fast marching on a triangle mesh: approximate vertex distances.

#ifndef GEODESIC_OFFSET_BENCHMARK_FAST_MARCHING_H
#define GEODESIC_OFFSET_BENCHMARK_FAST_MARCHING_H

#include "initial_distances.h"

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace benchmark {

/// Vertices are accepted in the order of their distances. An accepted vertex updates the others of its faces. If a face has
/// two accepted vertices, the update uses the linear function on the face with their values and a gradient of length one,
/// provided that its front reaches the third vertex through the face and after both others; otherwise the update is along
/// the edges. Faces with an obtuse angle are not split: if the front comes from outside such a face, its vertex gets the
/// value along an edge.
template <class Mesh>
class Fast_marching
{
  typedef typename Mesh::Vertex_index Vertex_index;
  typedef typename Mesh::Point Point;

public:
  explicit Fast_marching(const Mesh& mesh) : m_mesh(mesh) {}

  std::vector<double> operator()(const Initial_distances<Mesh>& start)
  {
    m_distances.assign(m_mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
    m_accepted.assign(m_mesh.number_of_vertices(), false);
    for (const auto& s : start) improve(s.first, s.second);
    while (!m_queue.empty())
    {
      const Vertex_index v = m_queue.top().second;
      m_queue.pop();
      if (m_accepted[v]) continue; // an outdated, larger value
      m_accepted[v] = true;
      for (auto h : CGAL::halfedges_around_target(v, m_mesh))
      {
        const Vertex_index a = m_mesh.source(h), b = m_mesh.target(m_mesh.next(h));
        if (!m_accepted[a]) update_along_edge(a, v);
        if (m_mesh.is_border(h)) continue;
        if (!m_accepted[a] && m_accepted[b]) update_across_face(a, b, v);
        if (!m_accepted[b] && m_accepted[a]) update_across_face(b, a, v);
      }
    }
    return std::move(m_distances);
  }

private:
  void improve(Vertex_index v, double distance)
  {
    if (!(distance < m_distances[v])) return;
    m_distances[v] = distance;
    m_queue.push({distance, v});
  }

  void update_along_edge(Vertex_index v, Vertex_index from)
  {
    improve(v, m_distances[from] + std::sqrt(CGAL::squared_distance(m_mesh.point(v), m_mesh.point(from))));
  }

  // With the edges p and q from `v` to the accepted vertices as a basis, and their matrix of scalar products G, the linear
  // function with values s and t there and d at v has a gradient with coordinates w = G^-1 (s - d, t - d) and squared
  // length (s - d, t - d) w. Setting it to one gives a quadratic equation for d. The front comes through the face if both
  // coordinates are negative.
  void update_across_face(Vertex_index v, Vertex_index first, Vertex_index second)
  {
    const Point& origin = m_mesh.point(v);
    const auto p = m_mesh.point(first) - origin, q = m_mesh.point(second) - origin;
    const double pp = p * p, pq = p * q, qq = q * q, determinant = pp * qq - pq * pq;
    if (!(determinant > 0)) return;
    const double s = m_distances[first], t = m_distances[second];
    // times the determinant: a d^2 - 2 b d + c = 0, with values relative to s
    const double u = t - s;
    const double a = pp - 2 * pq + qq, b = u * (pp - pq), c = u * u * pp - determinant;
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return;
    const double d = (b + std::sqrt(discriminant)) / a;
    const bool through = qq * d + pq * (u - d) > 0 && pp * (d - u) - pq * d > 0;
    if (through && d >= (std::max)(0., u)) improve(v, s + d);
  }

  const Mesh& m_mesh;
  std::vector<double> m_distances;
  std::vector<bool> m_accepted;
  std::priority_queue<std::pair<double, Vertex_index>, std::vector<std::pair<double, Vertex_index>>, std::greater<>> m_queue;
};

} // namespace benchmark

#endif // GEODESIC_OFFSET_BENCHMARK_FAST_MARCHING_H
