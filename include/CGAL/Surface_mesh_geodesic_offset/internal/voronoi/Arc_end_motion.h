// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ends of arcs in a cell, and how far they may move: arcs that meet at a small angle, or between sources that nearly
// coincide, end apart by rounding.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_ARC_END_MOTION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_ARC_END_MOTION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_arc.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_cell.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_tolerances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_window.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// An end of an arc, or a gate.
template <class NT>
struct Arc_end
{
  Point_in_face<NT> point;
  std::size_t arc; // or gate
  bool is_gate, is_end;
  Index left, right; // labels, seen from the end along the arc, or through the gate out of the cell
};

template <class NT>
class Arc_end_motion
{
public:
  typedef Point_in_face<NT> Point;

  Arc_end_motion(const std::vector<Voronoi_window<NT>>& windows, const Voronoi_tolerances<NT>& tolerances,
                 const std::vector<Bisector_arc<NT>>& arcs, const std::vector<Arc_end<NT>>& ends)
    : m_windows(windows), m_tolerances(tolerances), m_arcs(arcs), m_ends(ends)
  {
  }

  // Sets the cell, and its windows.
  void set_cell(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates)
  {
    m_cell = &cell;
    m_candidates = &candidates;
  }

  bool has_conic(const Arc_end<NT>& end) const { return !end.is_gate && !m_arcs[end.arc].is_link; }

  // Moves that end to the front at which all others may be, nearest to the conics of their arcs. Returns false if there is none.
  bool put_common_end_first(std::vector<std::size_t>& members) const
  {
    auto best = members.end();
    NT least = std::numeric_limits<NT>::infinity();
    for (auto i = members.begin(); i != members.end(); ++i)
    {
      const NT gap = largest_gap(members, m_ends[*i].point);
      if (!(gap < least)) continue;
      least = gap;
      best = i;
    }
    if (best == members.end()) return false;
    std::iter_swap(members.begin(), best);
    return true;
  }

  // The parameter of the point of an arc, in the cell, to which its end moves towards another point.
  NT parameter_towards(const Arc_end<NT>& end, const Point& p) const
  {
    const Bisector_arc<NT>& a = m_arcs[end.arc];
    const NT before = end.is_end ? a.to : a.from, after = a.conic.parameter_near(p, before);
    const Point q = a.conic.at(after).point();
    for (int k = 0; k < 3; ++k)
      if (m_cell->outside(k).value(q) > m_tolerances.joint) return before;
    return after;
  }

private:
  // The largest distance of the ends of a cluster from a point when they have moved towards it; infinite if not all their
  // sources tie there, or if one of the ends may not.
  NT largest_gap(const std::vector<std::size_t>& members, const Point& p) const
  {
    if (!all_tie_at(p, members)) return std::numeric_limits<NT>::infinity();
    NT result = 0;
    for (const std::size_t e : members)
    {
      const std::optional<Point> q = moved_to(m_ends[e], p);
      if (!q) return std::numeric_limits<NT>::infinity();
      result = (std::max)(result, length(*q - p));
    }
    return result;
  }

  // Where an end is when it moves along its arc as near to a point as this goes in the cell. Empty unless it stays between its two
  // sources up to rounding on its way, along the arc and straight from there to the point.
  std::optional<Point> moved_to(const Arc_end<NT>& end, const Point& p) const
  {
    Point q = end.point;
    if (has_conic(end))
    {
      const Bisector_arc<NT>& a = m_arcs[end.arc];
      const NT other = end.is_end ? a.from : a.to, before = end.is_end ? a.to : a.from, after = parameter_towards(end, p);
      if ((other < before) != (other < after) || !(after > a.conic.lowest_parameter())) return std::nullopt;
      q = a.conic.at(after).point();
      const Point middle = a.conic.at(a.conic.between(before, after, 0.5)).point();
      if (!(length(middle - q) <= length(end.point - q) + m_tolerances.joint)) return std::nullopt; // around a bend
      for (const Bisector_side* const s : {&a.left, &a.right}) // beyond its cone, the function of a window is no distance
        if (!m_windows[s->window].contains(q, m_tolerances.joint)) return std::nullopt;
      if (!is_between_sources(middle, end) || !is_between_sources(q, end)) return std::nullopt;
    }
    if (!is_between_sources(0.5 * (q + p), end)) return std::nullopt;
    return q;
  }

  // The distances of a point through the windows on both sides of an end; without an arc, through those of its sources, if these
  // windows explain the end, else infinite.
  std::array<NT, 2> distances_beside(const Arc_end<NT>& end, const Point& p) const
  {
    if (has_conic(end))
    {
      const Bisector_arc<NT>& a = m_arcs[end.arc];
      return {m_windows[a.left.window].distance_at(p), m_windows[a.right.window].distance_at(p)};
    }
    const NT off = distance_from(end.left, end.point) - distance_from(end.right, end.point);
    if (!(CGAL::abs(off) <= m_tolerances.loose_tie))
      return {std::numeric_limits<NT>::infinity(), std::numeric_limits<NT>::infinity()};
    return {distance_from(end.left, p), distance_from(end.right, p)};
  }

  // Infinite if no window of the cell has the source.
  NT distance_from(Index label, const Point& p) const { return least_path_length_from(label, m_windows, *m_candidates, p); }

  // False if the windows of the cell do not explain an end.
  bool all_tie_at(const Point& p, const std::vector<std::size_t>& members) const
  {
    NT least = std::numeric_limits<NT>::infinity(), most = -least;
    for (const std::size_t e : members)
      for (const NT d : distances_beside(m_ends[e], p))
      {
        least = (std::min)(least, d);
        most = (std::max)(most, d);
      }
    return most - least <= m_tolerances.loose_tie;
  }

  // True if the sources of an end tie at a point, and no other source is nearer.
  bool is_between_sources(const Point& p, const Arc_end<NT>& end) const
  {
    const std::array<NT, 2> own = distances_beside(end, p);
    return CGAL::abs(own[0] - own[1]) <= m_tolerances.loose_tie &&
           least_path_length(m_windows, *m_candidates, p) >= (std::min)(own[0], own[1]) - m_tolerances.loose_tie;
  }

  const std::vector<Voronoi_window<NT>>& m_windows;
  const Voronoi_tolerances<NT>& m_tolerances;
  const std::vector<Bisector_arc<NT>>& m_arcs;
  const std::vector<Arc_end<NT>>& m_ends;
  const Voronoi_cell<NT>* m_cell = nullptr;
  const std::vector<unsigned>* m_candidates = nullptr;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
