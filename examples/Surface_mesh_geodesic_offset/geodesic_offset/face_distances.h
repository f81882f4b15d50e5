// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The distances inside the faces, as exactly as colours can show them.

#ifndef GEODESIC_OFFSET_FACE_DISTANCES_H
#define GEODESIC_OFFSET_FACE_DISTANCES_H

#include "common.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace geodesic_offset {

// Distances change by no more than the way, so interpolation between the corners of a face with edges up to h is wrong by no
// more than h / sqrt(3): with weights w it is wrong by a sum of w_i |p - c_i| at most, whose square is at most the sum of
// w_i |p - c_i|^2, that is of w_i w_j |c_i - c_j|^2 over the three pairs, and that of w_i w_j is 1/3 at most. Where this is
// less than a step of colours the corners are enough; in longer faces each distance is that of the kept windows.
class Face_distances
{
  static constexpr double color_steps = 255; // in the largest distance: as many as a channel of an image can tell apart

  const Mesh&         m_mesh;
  const Geodesic&     m_geodesic;
  double              m_largest;
  std::vector<double> m_at_vertices;
  std::vector<bool>   m_is_long; // of faces; empty: there are none

public:
  // Reads the last build. `largest`: the largest distance of the surface.
  Face_distances(const Mesh& mesh, const Geodesic& geodesic, double largest)
    : m_mesh(mesh), m_geodesic(geodesic), m_largest(largest), m_at_vertices(mesh.number_of_vertices())
  {
    for(Vertex v : mesh.vertices())
      m_at_vertices[v] = geodesic.distance_to_sources(v);
    find_long_faces();
  }

  double largest() const { return m_largest; }

  // Whether the windows of the build must have been kept
  bool need_windows() const { return !m_is_long.empty(); }

  // Interpolates in all faces, for what it is worth.
  void do_without_windows() { m_is_long.clear(); }

  // u and v: barycentric coordinates of the second and the third corner. Infinite where the distance is not known.
  double operator()(Face f, double u, double v) const
  {
    u = std::max(u, 0.0);
    v = std::max(v, 0.0);
    const double t = std::max(1 - u - v, 0.0);
    if(!m_is_long.empty() && m_is_long[f])
      return m_geodesic.distance_to_sources(Face_location(f, {t, u, v}));
    const Halfedge h = m_mesh.halfedge(f);
    const double a = m_at_vertices[m_mesh.source(h)], b = m_at_vertices[m_mesh.target(h)],
                 c = m_at_vertices[m_mesh.target(m_mesh.next(h))];
    return std::max({a, b, c}) < infinity ? t * a + u * b + v * c : infinity;
  }

private:
  void find_long_faces()
  {
    const double longest = std::sqrt(3.0) * m_largest / color_steps;
    std::vector<bool> is_long(m_mesh.number_of_faces(), false);
    bool some = false;
    for(Face f : m_mesh.faces())
      for(Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
        if(CGAL::squared_distance(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h))) > longest * longest)
          is_long[f] = some = true;
    if(some)
      m_is_long = std::move(is_long);
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_FACE_DISTANCES_H
