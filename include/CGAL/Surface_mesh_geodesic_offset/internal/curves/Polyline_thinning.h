// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Selects vertices of a polyline such that the polyline through them is within a tolerance of a curve.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_POLYLINE_THINNING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_POLYLINE_THINNING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A vertex of a polyline whose vertices are points of a curve.
struct Thinning_vertex
{
  std::array<double, 3> point;
  double height = 0;          // Frechet distance of the curve from the segment that ends here, or an upper bound
  bool is_kept = false;       // no chord passes this vertex
  std::size_t free_steps = 1; // the chord to the vertex so many places further is within the tolerance without a check
};

// A greedy walk: from each selected vertex the longest chord that is found by doubling and bisection.
//
// A chord is accepted if its Frechet distance from the curve is within the tolerance: if there are points of the chord, in the
// order of the vertices that it passes, such that the point of a vertex is no farther from it than the tolerance less the
// heights of the curve over the two segments beside the vertex. So the chord is within the tolerance of the curve, the curve
// is within the tolerance of the chord, and the chord runs over no turn back that is larger than the tolerance.
//
// Takes time O(n log k) for n vertices, of which a chord passes k at most.
class Polyline_thinning
{
public:
  // `vertices` must outlive this object.
  Polyline_thinning(const std::vector<Thinning_vertex>& vertices, double tolerance)
    : m_vertices(vertices), m_tolerance(tolerance)
  {
  }

  // Indices of the selected vertices, with the first and the last one.
  std::vector<std::size_t> operator()() const { return walk([](std::size_t, std::size_t) { return true; }, true); }

  // Selects three vertices at least of a closed polyline, which ends with its first vertex, if it has as many: three where
  // the least number of chords is one or two.
  std::vector<std::size_t> triangle_at_least() const
  {
    std::vector<std::size_t> selected = (*this)();
    if (selected.size() >= 4 || m_vertices.size() < 4) return selected;
    std::vector<double> way(m_vertices.size(), 0);
    for (std::size_t i = 1; i < way.size(); ++i)
      way[i] = way[i - 1] + length(difference(m_vertices[i].point, m_vertices[i - 1].point));
    // Of the vertices between others, the one that is nearest to a way. A curve may pass a point several times, so points that
    // are selected are left out, if there are others.
    const auto nearest = [&](double w, std::size_t after, std::size_t before) {
      std::size_t best = after + 1;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = after + 1; k < before; ++k)
      {
        const double off = std::abs(way[k] - w);
        const auto is_equal = [&](std::size_t l) { return m_vertices[l].point == m_vertices[k].point; };
        if (off >= least || std::any_of(selected.begin(), selected.end(), is_equal)) continue;
        best = k;
        least = off;
      }
      return best;
    };
    const std::size_t last = way.size() - 1;
    if (selected.size() == 2)
    {
      selected.insert(selected.begin() + 1, nearest(way[last] / 3, 0, last - 1));
      selected.insert(selected.begin() + 2, nearest(way[last] * 2 / 3, selected[1], last));
    }
    else
    {
      const std::size_t k = selected[1];
      const bool is_first = last - k == 1 || (k > 1 && way[k] > way[last] - way[k]);
      selected.insert(selected.begin() + (is_first ? 1 : 2),
                      is_first ? nearest(way[k] / 2, 0, k) : nearest((way[k] + way[last]) / 2, k, last));
    }
    bool are_chords = true;
    for (std::size_t k = 1; k < selected.size(); ++k) are_chords = are_chords && is_chord(selected[k - 1], selected[k]);
    if (are_chords) return selected;
    // A part of the length: two chords do not replace all, three do, and the rest allows for segments that end before the
    // part does. A single segment may be longer, but not longer than all others together.
    constexpr double longest = 0.45;
    return walk([&](std::size_t i, std::size_t j) { return way[j] - way[i] <= longest * way.back(); }, false);
  }

private:
  typedef std::array<double, 3> Vector;

  template <class Condition>
  std::vector<std::size_t> walk(const Condition& is_allowed, bool with_free_steps) const
  {
    std::vector<std::size_t> selected;
    if (m_vertices.empty()) return selected;
    selected.push_back(0);
    const std::size_t last = m_vertices.size() - 1;
    std::size_t stop = 0; // the next vertex that is kept
    for (std::size_t i = 0; i < last; i = selected.back())
    {
      if (stop <= i)
        for (stop = i + 1; stop < last && !m_vertices[stop].is_kept;) ++stop;
      std::size_t reached = (std::min)(stop, i + (with_free_steps ? m_vertices[i].free_steps : 1)), failed = stop + 1;
      const auto joins = [&](std::size_t j) { return is_allowed(i, j) && is_chord(i, j); };
      while (reached < stop)
      {
        const std::size_t j = (std::min)(stop, i + 2 * (reached - i));
        if (!joins(j))
        {
          failed = j;
          break;
        }
        reached = j;
      }
      while (failed - reached > 1)
      {
        const std::size_t j = reached + (failed - reached) / 2;
        (joins(j) ? reached : failed) = j;
      }
      selected.push_back(reached);
    }
    return selected;
  }

  bool is_chord(std::size_t i, std::size_t j) const
  {
    const Vector chord = difference(m_vertices[j].point, m_vertices[i].point);
    const double l = length(chord);
    // the ends of a segment differ, unless the segment is all of a closed polyline
    if (l == 0 && j > i + 1 && j - i + 1 < m_vertices.size()) return false;
    const Vector direction = l > 0 ? Vector{chord[0] / l, chord[1] / l, chord[2] / l} : Vector{0, 0, 0};
    double way = 0; // along the chord, to the nearest point that the vertices up to k admit
    for (std::size_t k = i + 1; k < j; ++k)
    {
      const double allowed = m_tolerance - (std::max)(m_vertices[k].height, m_vertices[k + 1].height);
      if (!(allowed > 0)) return false;
      const Vector v = difference(m_vertices[k].point, m_vertices[i].point);
      const double along = dot(v, direction);
      const double off = length({v[0] - along * direction[0], v[1] - along * direction[1], v[2] - along * direction[2]});
      if (off > allowed) return false;
      const double half = std::sqrt((allowed - off) * (allowed + off));
      way = (std::max)(way, along - half);
      if (way > (std::min)(l, along + half)) return false;
    }
    return true;
  }

  static Vector difference(const Vector& p, const Vector& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
  static double dot(const Vector& v, const Vector& w) { return v[0] * w[0] + v[1] * w[1] + v[2] * w[2]; }
  static double length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

  const std::vector<Thinning_vertex>& m_vertices;
  double m_tolerance;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
