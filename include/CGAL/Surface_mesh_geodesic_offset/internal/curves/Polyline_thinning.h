// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Selection of vertices of a polyline such that the polyline through them is within a tolerance of a curve.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_POLYLINE_THINNING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_POLYLINE_THINNING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Vertex of a polyline whose vertices lie on a curve.
struct Thinning_vertex
{
  std::array<double, 3> point;
  double height = 0;          // Frechet distance of the curve from the segment that ends here, or an upper bound
  bool is_kept = false;       // no chord may pass this vertex
  std::size_t free_steps = 1; // number of steps that a chord may span without a check
};

// Greedy selection: from each selected vertex, the longest chord found by doubling and bisection.
//
// A chord is accepted if its Frechet distance from the curve is within the tolerance, that is, if there are points on the
// chord, in the order of the passed vertices, such that the distance of each from its vertex is at most the tolerance minus
// the heights of the curve over the two adjacent segments. So chord and curve are within the tolerance of each other, and
// the chord does not skip a reversal of the curve larger than the tolerance.
//
// Time O(n log k) for n vertices, if a chord passes at most k of them.
class Polyline_thinning
{
public:
  // `vertices` must outlive this object.
  Polyline_thinning(const std::vector<Thinning_vertex>& vertices, double tolerance)
    : m_vertices(vertices), m_tolerance(tolerance)
  {
  }

  // Indices of the selected vertices, including the first and the last.
  std::vector<std::size_t> operator()() const
  {
    return walk([](std::size_t, std::size_t) { return true; }, true);
  }

  // Selects at least three vertices, if available, of a closed polyline, whose last vertex equals the first: three where
  // one or two chords would be within the tolerance.
  std::vector<std::size_t> triangle_at_least() const
  {
    std::vector<std::size_t> selected = (*this)();
    if (selected.size() >= 4 || m_vertices.size() < 4) return selected;
    std::vector<double> way(m_vertices.size(), 0);
    for (std::size_t i = 1; i < way.size(); ++i)
      way[i] = way[i - 1] + length(difference(m_vertices[i].point, m_vertices[i - 1].point));
    // The vertex strictly between two others whose arc length is nearest to w. A curve may pass a point several times, so
    // selected points are excluded if there are others.
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
    // Fraction of the length per chord: two chords cannot cover the polyline, three can, and the rest of 1 / 2 allows for
    // chords that end early. A single segment may be longer, but not longer than the others together.
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
    std::size_t stop = 0; // the next kept vertex
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
    // the end points of a segment differ, unless it is the whole closed polyline
    if (l == 0 && j > i + 1 && j - i + 1 < m_vertices.size()) return false;
    const Vector direction = l > 0 ? Vector{chord[0] / l, chord[1] / l, chord[2] / l} : Vector{0, 0, 0};
    double way = 0; // arc length along the chord of the nearest feasible point for the vertices up to k
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

} // namespace CGAL::Geodesic_offset::internal

#endif
