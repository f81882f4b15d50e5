// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs along the sides of a cell: to which of the two cells they belong, and those that only the neighbour explains.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_ARCS_ALONG_SIDES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_ARCS_ALONG_SIDES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_arc.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Label_changes.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_cell.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_tolerances.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Where a bisector runs along a side, the label of the side is that of one of the two cells, or a third one that ties there; it
// is the same for both cells. So the arc belongs to the cell whose label is not that of the side.
template <class NT>
class Arcs_along_sides
{
public:
  typedef Point_in_face<NT> Point;

  // The tolerances may change between calls.
  Arcs_along_sides(const std::vector<Voronoi_window<NT>>& windows, const Voronoi_tolerances<NT>& tolerances)
    : m_windows(windows), m_tolerances(tolerances)
  {
  }

  // Divides arcs along sides at the gates, and removes the parts that belong to the neighbour.
  void keep_own(const Voronoi_cell<NT>& cell, std::vector<Bisector_arc<NT>>& arcs) const
  {
    std::vector<Bisector_arc<NT>> own;
    for (const Bisector_arc<NT>& a : arcs)
    {
      int k = 0;
      while (k < 3 && !is_along(cell, k, a)) ++k;
      if (k == 3) own.push_back(a);
      else add_own_parts(cell, k, a, own);
    }
    arcs.swap(own);
  }

  // A side may have a label that no window of the cell has there, but one beyond the side: adds links along it, between this
  // label and that of the cell.
  void add_links(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates, std::vector<Bisector_arc<NT>>& arcs)
  {
    for (int k = 0; k < 3; ++k)
    {
      NT begin = 0;
      Index label = cell.label[k];
      for (const Voronoi_gate<NT>& g : cell.gates)
      {
        if (g.side != k) continue;
        const NT end = dot(g.point - cell.corner[k], cell.direction[k]);
        add_links(cell, candidates, k, begin, end, label, arcs);
        begin = end;
        label = g.to;
      }
      add_links(cell, candidates, k, begin, cell.side_length(k), label, arcs);
    }
  }

private:
  bool is_along(const Voronoi_cell<NT>& cell, int k, const Bisector_arc<NT>& a) const
  {
    return a.is_on(cell.outside(k), m_tolerances.along_side());
  }

  static void add_own_parts(const Voronoi_cell<NT>& cell, int k, const Bisector_arc<NT>& a, std::vector<Bisector_arc<NT>>& own)
  {
    const auto position = [&](const Point& p) { return dot(p - cell.corner[k], cell.direction[k]); };
    const bool is_forward = position(a.end) > position(a.start);
    const Index inner = is_forward ? a.left.label : a.right.label;
    std::vector<NT> ends{a.from, a.to};
    for (const Voronoi_gate<NT>& g : cell.gates)
    {
      const NT t = g.side == k ? a.conic.parameter_near(g.point, a.conic.between(a.from, a.to, 0.5)) : a.from;
      if (a.from < t && t < a.to) ends.push_back(t);
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      Bisector_arc<NT> part(a);
      part.from = ends[i];
      part.to = ends[i + 1];
      part.start = part.conic.at(part.from).point();
      part.end = part.conic.at(part.to).point();
      Index label = cell.label[k]; // of the side
      for (const Voronoi_gate<NT>& g : cell.gates)
        if (g.side == k && position(g.point) <= position(part.middle())) label = g.to;
      if (label == inner) continue;
      Bisector_side& beyond = is_forward ? part.right : part.left;
      if (label != beyond.label)
      {
        part.is_link = true;
        part.left.window = part.right.window = no_index;
        beyond = Bisector_side();
        beyond.label = label;
      }
      own.push_back(part);
    }
  }

  // For the part of side k from `begin` to `end`, with a label.
  void add_links(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates, int k, NT begin, NT end, Index label,
                 std::vector<Bisector_arc<NT>>& arcs)
  {
    const auto at = [&](NT t) { return cell.corner[k] + t * cell.direction[k]; };
    const auto is_of_neighbour = [&](NT t) {
      const Point p = at(t);
      const NT most = least_path_length(m_windows, candidates, p) + m_tolerances.of_neighbour();
      return std::none_of(candidates.begin(), candidates.end(), [&](unsigned c) {
        const Voronoi_window<NT>& w = m_windows[c];
        return w.label == label && w.distance_at(p) <= most && w.contains(p, m_tolerances.slack);
      });
    };
    if (end - begin <= m_tolerances.joint) return;
    if (candidates.empty())
    { // the face has the label of its first corner
      if (label != cell.label[0]) arcs.push_back(Bisector_arc<NT>::link(at(begin), at(end), cell.label[0], label));
      return;
    }
    if (!is_of_neighbour(begin) && !is_of_neighbour((begin + end) / 2) && !is_of_neighbour(end)) return;
    std::vector<Label_change<NT>> changes;
    m_changes(at(begin), cell.direction[k], end - begin, label, label, m_windows, candidates, candidates, m_tolerances,
              std::nullopt, [&](const Label_change<NT>& c) { changes.push_back(c); });
    for (std::size_t i = 0; i + 1 < changes.size(); ++i)
    {
      const Index inner = changes[i].to;
      const NT from = begin + changes[i].t, to = begin + changes[i + 1].t;
      if (inner == label || to - from <= m_tolerances.joint || !is_of_neighbour((from + to) / 2)) continue;
      const Point p = at((from + to) / 2);
      const bool is_known = std::any_of(arcs.begin(), arcs.end(), [&](const Bisector_arc<NT>& a) {
        return is_along(cell, k, a) && dot(p - a.start, cell.direction[k]) * dot(p - a.end, cell.direction[k]) <= 0;
      });
      if (!is_known) arcs.push_back(Bisector_arc<NT>::link(at(from), at(to), inner, label));
    }
  }

  const std::vector<Voronoi_window<NT>>& m_windows;
  const Voronoi_tolerances<NT>& m_tolerances;
  Label_changes<NT> m_changes;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
