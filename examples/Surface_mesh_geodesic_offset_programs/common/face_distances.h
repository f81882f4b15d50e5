// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances inside faces, as accurate as colours can show.

#ifndef GEODESIC_OFFSET_FACE_DISTANCES_H
#define GEODESIC_OFFSET_FACE_DISTANCES_H

#include "common.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace geodesic_offset {

// The distance is Lipschitz continuous with constant 1. So linear interpolation between the corners c_i of a face, with
// weights w_i and edges no longer than h, has an error of at most h / sqrt(3): the error is at most the sum of w_i |p -
// c_i|, whose square is at most the sum of w_i |p - c_i|^2, which equals the sum of w_i w_j |c_i - c_j|^2 over the three
// pairs, and the sum of w_i w_j is at most 1/3. If this error is less than a colour step, distances are interpolated. In
// faces with longer edges they are computed from the kept windows, as in faces at barriers: a vertex there has several distances.
class Face_distances
{
  static constexpr double color_steps = 255; // in the largest distance: the resolution of an image channel

  const Mesh& m_mesh;
  const Geodesic& m_geodesic;
  double m_largest;
  std::vector<double> m_at_vertices;
  std::vector<bool> m_is_exact; // by face: with distances from the kept windows; empty: none

public:
  // Uses the last build. `largest`: the largest distance of the surface.
  Face_distances(const Mesh& mesh, const Geodesic& geodesic, double largest, const std::vector<Edge>& barriers = {})
    : m_mesh(mesh), m_geodesic(geodesic), m_largest(largest), m_at_vertices(m_mesh.number_of_vertices())
  {
    for(Vertex v : m_mesh.vertices()) m_at_vertices[v] = geodesic.distance_to_sources(v);
    find_exact_faces(barriers);
  }

  double largest() const { return m_largest; }

  // Whether distances in some faces need kept windows.
  bool need_windows() const { return !m_is_exact.empty(); }

  // Switches to interpolation in all faces.
  void interpolate_everywhere() { m_is_exact.clear(); }

  // u and v: barycentric coordinates of the second and the third corner. Infinite for unknown distances.
  double operator()(Face f, double u, double v) const
  {
    u = std::max(u, 0.0);
    v = std::max(v, 0.0);
    const double t = std::max(1 - u - v, 0.0);
    if(!m_is_exact.empty() && m_is_exact[f]) return m_geodesic.distance_to_sources(Face_location(f, {t, u, v}));
    const Halfedge h = m_mesh.halfedge(f);
    const double a = m_at_vertices[m_mesh.source(h)], b = m_at_vertices[m_mesh.target(h)],
                 c = m_at_vertices[m_mesh.target(m_mesh.next(h))];
    return std::max({a, b, c}) < infinity ? t * a + u * b + v * c : infinity;
  }

private:
  void find_exact_faces(const std::vector<Edge>& barriers)
  {
    const double longest = std::sqrt(3.0) * m_largest / color_steps;
    std::vector<bool> is_exact(m_mesh.number_of_faces(), false), is_on_barrier(m_mesh.number_of_vertices(), false);
    bool has_exact = false;
    for(Edge e : barriers) is_on_barrier[m_mesh.vertex(e, 0)] = is_on_barrier[m_mesh.vertex(e, 1)] = true;
    for(Face f : m_mesh.faces())
      for(Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
        if(is_on_barrier[m_mesh.target(h)] ||
           CGAL::squared_distance(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h))) > longest * longest)
          is_exact[f] = has_exact = true;
    if(has_exact) m_is_exact = std::move(is_exact);
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_FACE_DISTANCES_H
