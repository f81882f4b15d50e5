// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices whose distances are far smaller than edges within that distance. The coordinates of windows and all tolerances are
// relative to edges, so such distances lose digits.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_GRADED_PLACES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_GRADED_PLACES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Edges this many times longer than a distance make it graded. The error of a distance is up to some 12 units of rounding of
// the edges within that distance (measured), so distances that are not graded have relative errors up to 64 * 12 * 2^-53 <
// 1e-13. Binding test: test_graded_distances, graded vertices.
constexpr double graded_ratio = 64;

// Part of the longest edge that exceeds the rounding errors of all distances: 2^-42 is 2048 units of rounding, eight times the
// allowance of windows.
constexpr double rounding_of_reach = 1. / (1ull << 42);

// `Points`: has_points(), and between(v, a, b), the distance in space of vertex v from the edge of a and b.
template <class Points>
class Graded_places
{
public:
  // `maximum`: distances up to this value are final.
  Graded_places(const Unfolded_mesh<double>& mesh, const Geodesic_field<double>& field, double maximum, const Points& points)
    : m_mesh(mesh), m_distance(field.distance), m_maximum(maximum), m_rounding(rounding_of_reach * mesh.longest_edge()),
      m_most_faces((std::max)(std::size_t(least_most_faces), mesh.number_of_faces() / part_of_faces)), m_points(points)
  {
    double limit = (std::min)(maximum, mesh.longest_edge() / graded_ratio);
    for (Index v = 0; v < m_distance.size(); ++v)
      if (m_distance[v] <= limit && m_distance[v] > 0) m_candidates.push_back(v);
    std::sort(m_candidates.begin(), m_candidates.end(),
              [this](Index v, Index w) { return m_distance[v] > m_distance[w] || (m_distance[v] == m_distance[w] && v < w); });
    while (!select(limit)) limit /= 4;
  }

  // The graded vertices, and the faces within their distances around them: their shortest paths cross no other. Where these are
  // too many faces, only the vertices nearest to the sources, whose errors are the largest.
  const std::vector<Index>& vertices() const { return m_vertices; }
  const std::vector<Index>& faces() const { return m_faces; }

private:
  // Finds graded vertices up to a distance. Returns false if there are too many faces.
  bool select(double limit)
  {
    const auto is_beyond = [this](Index v, double d) { return m_distance[v] > d; };
    auto v = std::lower_bound(m_candidates.begin(), m_candidates.end(), limit, is_beyond);
    m_vertices.clear();
    m_faces.clear();
    if (v == m_candidates.end()) return true;
    m_is_settled.assign(m_mesh.number_of_vertices(), 0);
    m_is_chosen.assign(m_mesh.number_of_faces(), 0);
    m_seen_from.assign(m_mesh.number_of_faces(), no_index);
    for (; v != m_candidates.end(); ++v)
      if (!m_is_settled[*v] && !explore(*v)) return false;
    return true;
  }

  // Visits the faces around w up to three times its distance, and up to its distance from the sources. They contain all such
  // faces up to the distance of v around each vertex v up to twice the distance of w away from w, unless v is farther from the
  // sources: v needs no visit of its own, except if w is not graded and v may be. Returns false if there are too many faces.
  bool explore(Index w)
  {
    const double distance = m_distance[w] + m_rounding, radius = 3 * distance;
    std::vector<Index> faces;
    double longest = 0;
    const auto visit = [&](Index f) {
      if (m_seen_from[f] == w) return;
      m_seen_from[f] = w;
      faces.push_back(f);
    };
    const auto visit_all_at = [&](Index v) {
      m_mesh.for_each_fan(v, [&](Index first) {
        m_mesh.any_corner(first, [&](Index c) { return visit(m_mesh.face(c)), false; });
      });
    };
    visit_all_at(w);
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (Index h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h)
      {
        longest = (std::max)(longest, m_mesh[h].length);
        if (m_mesh.twin(h) != no_index && is_within(w, h, distance, radius)) visit(m_mesh.face(m_mesh.twin(h)));
        if (const Index v = m_mesh.source(h); m_mesh.has_several_fans(v) && m_points.between(w, v, v) <= radius + m_rounding)
          visit_all_at(v);
        if (faces.size() > m_most_faces) return false;
      }
    const bool is_graded = longest >= graded_ratio * m_distance[w];
    for (const Index f : faces)
    {
      if (is_graded && !m_is_chosen[f])
      {
        m_is_chosen[f] = 1;
        m_faces.push_back(f);
      }
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Index v = m_mesh.source(h);
        if (m_is_settled[v] || !(m_distance[v] <= m_distance[w]) || !(m_distance[v] > 0)) continue;
        if (v != w && !(m_points.between(w, v, v) + m_distance[v] + m_rounding <= radius)) continue;
        if (!is_graded && longest >= graded_ratio * m_distance[v]) continue;
        m_is_settled[v] = 1;
        if (is_graded) m_vertices.push_back(v);
      }
    }
    return m_faces.size() <= m_most_faces;
  }

  // False if no point of the edge of h is both up to `distance` from the sources and up to `radius` from w.
  bool is_within(Index w, Index h, double distance, double radius) const
  {
    const Index a = m_mesh.source(h), b = m_mesh.target(h);
    // distances along the edge grow by its length at most; vertices without a distance are beyond the maximum
    const double ends = (std::min)(m_distance[a], m_maximum) + (std::min)(m_distance[b], m_maximum);
    return (ends - m_mesh[h].length) / 2 <= distance + m_rounding && m_points.between(w, a, b) <= radius + m_rounding;
  }

  // The second propagation takes some ten times longer per face than the first. So it has no more than 1/32 of the faces, or as
  // many as take some half a second. Binding test: test_graded_distances, large places.
  static constexpr std::size_t least_most_faces = 1 << 15, part_of_faces = 32;

  const Unfolded_mesh<double>& m_mesh;
  const std::vector<double>& m_distance;
  const double m_maximum, m_rounding;
  const std::size_t m_most_faces;
  const Points& m_points;
  std::vector<Index> m_candidates; // by falling distance
  std::vector<char> m_is_settled;  // vertices
  std::vector<char> m_is_chosen;   // faces
  std::vector<Index> m_seen_from;  // per face, the last vertex from which it was visited
  std::vector<Index> m_vertices, m_faces;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
