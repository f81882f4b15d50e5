// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds of vertex distances, and the paths that arrive at vertices where paths may bend.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_DISTANCE_BOUNDS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_DISTANCE_BOUNDS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

class Distance_bounds
{
public:
  Distance_bounds() = default;
  explicit Distance_bounds(std::size_t number_of_vertices)
    : m_lower(number_of_vertices, Number_policy<double>::infinity()), m_upper(m_lower)
  {
  }

  double lower(Index v) const { return m_lower[v]; }
  double upper(Index v) const { return m_upper[v]; }

  // Processes a path of this length, with an error of at most the radius.
  void update(Index v, double distance, double radius)
  {
    CGAL_precondition(distance >= 0 && radius >= 0);
    m_lower[v] = (std::min)(m_lower[v], (std::max)(distance - radius, 0.));
    m_upper[v] = (std::min)(m_upper[v], distance + radius);
  }

private:
  std::vector<double> m_lower, m_upper;
};

// Candidate for the shortest path to a vertex, with the direction to its start, known up to an angle.
struct Arrival
{
  Ray_at_vertex<double> back;
  double angle;
  double distance, radius;
  bool has_spread;
  Index next; // next arrival at the same vertex

  double lower() const { return distance - radius; }

  // Merges a path with the same direction and length, up to rounding. Returns false for other paths.
  bool unite(const Arrival& o)
  {
    if (o.back.corner != back.corner || std::abs(o.distance - distance) > o.radius + radius) return false;
    const double cross = back.x * o.back.y - back.y * o.back.x, dot = back.x * o.back.x + back.y * o.back.y;
    if (!(std::abs(cross) <= same_direction * dot)) return false;
    const double from = (std::min)(lower(), o.lower()), to = (std::max)(distance + radius, o.distance + o.radius);
    if (from >= lower() && to <= distance + radius && o.angle + std::abs(cross) / dot <= angle) return true;
    if (has_spread) return false;
    distance = 0.5 * (from + to);
    // allows for the roundings of `from`, `to` and their mean
    radius = 0.5 * (to - from) * (1 + 0x1p-50) + 0x1p-51 * distance;
    angle = (std::max)(angle, 2 * std::abs(cross) / dot + o.angle);
    return true;
  }

  static constexpr double same_direction = 0x1p-40;
};

class Arrivals
{
public:
  // Lists of arrivals at a vertex, and of windows, that are allowed whatever the size of the mesh. In faces so thin that no path is
  // certainly shorter, they are reduced again and again without getting shorter, so the time of a build grows with the square of
  // their length: 512 take less than a second on a small mesh.
  static constexpr std::size_t longest_list = 512;

  Arrivals() = default;
  explicit Arrivals(std::size_t number_of_vertices) : m_first(number_of_vertices, no_index) {}

  // The number of source primitives, each of which may have own arrivals.
  void set_number_of_primitives(std::size_t n) { m_number_of_primitives = n; }

  // Returns false if the arrival is already covered.
  bool add(Index v, Arrival arrival)
  {
    std::size_t n = 0;
    for (Index i = m_first[v]; i != no_index; i = m_arrivals[i].next, ++n)
      if (m_arrivals[i].unite(arrival)) return !m_arrivals[i].has_spread;
    if (n >= longest_list + 4 * (m_first.size() + m_number_of_primitives))
      throw std::runtime_error("Surface_mesh_geodesic_enclosure: " + std::to_string(n) +
                               " paths to a vertex that may be shortest: faces are so thin that rounding does not let paths be "
                               "told apart");
    arrival.next = m_first[v];
    m_first[v] = Index(m_arrivals.size());
    m_arrivals.push_back(arrival);
    return true;
  }

  // Calls f(arrival) for arrivals that have not spread yet, and marks them. From then on, arrivals within a few roundings
  // of them count as covered.
  template <class Function>
  void spread(Index v, const Function& f)
  {
    for (Index i = m_first[v]; i != no_index; i = m_arrivals[i].next)
    {
      Arrival& a = m_arrivals[i];
      if (a.has_spread) continue;
      a.has_spread = true;
      a.radius += 0x1p-51 * a.distance;
      a.angle *= 4;
      f(Arrival(a));
    }
  }

private:
  std::vector<Index> m_first; // by vertex
  std::vector<Arrival> m_arrivals;
  std::size_t m_number_of_primitives = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
