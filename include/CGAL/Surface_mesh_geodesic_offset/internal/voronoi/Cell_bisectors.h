// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bisectors in one cell: connects its arcs with each other and with its gates.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_CELL_BISECTORS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_CELL_BISECTORS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Arc_end_motion.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_arc.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Cell_arcs.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Gate_links.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_cell.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_tolerances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Arcs are connected by the proximity of their ends and of the gates. The result counts only if every gate and every end of an
// arc has a partner between the same sources, or is one of several around a point of as many sources. Otherwise the caller
// divides the cell.
template <class NT>
class Cell_bisectors
{
public:
  typedef Point_in_face<NT> Point;

  Cell_bisectors(const Cell_bisectors<NT>&) = delete; // members refer to others
  Cell_bisectors<NT>& operator=(const Cell_bisectors<NT>&) = delete;

  Cell_bisectors(const std::vector<Voronoi_window<NT>>& windows, const Voronoi_tolerances<NT>& tolerances,
                 const Voronoi_cell<NT>& face)
    : m_tolerances(tolerances), m_aspect(face.diameter() / face.least_height()),
      m_find_arcs(windows, m_tolerances, face.center(), face.radius()), m_along_sides(windows, m_tolerances),
      m_motion(windows, m_tolerances, m_arcs, m_ends)
  {
  }

  // Finds the arcs, and passes them to out(arc) with the nodes of the gates, and new_node() for others. Returns false, without
  // output, if they do not fit together.
  template <class New_node, class OutputFunction>
  bool connect(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates, const New_node& new_node,
               const OutputFunction& out)
  {
    // With rounding, a bisector along a side lies on both sides of it or on none; the gates may need either. Windows that come over
    // many edges may differ by more than a tie.
    for (const bool joins_loose_ends : {false, true})
      for (const NT factor : Voronoi_tolerances<NT>::tie_factors)
        if (connect(cell, candidates, factor, 1, joins_loose_ends, new_node, out)) return true;
    for (const NT joint_factor : Voronoi_tolerances<NT>::joint_factors)
    {
      const bool is_explained = joint_factor <= (std::max)(NT(Voronoi_tolerances<NT>::usual_joint_factor), m_aspect);
      if (is_explained && connect(cell, candidates, 1, joint_factor, false, new_node, out)) return true;
    }
    return false;
  }

  // As connect(), but only with the usual tolerances: for cells with many windows, which the caller can divide.
  template <class New_node, class OutputFunction>
  bool connect_at_once(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates, const New_node& new_node,
                       const OutputFunction& out)
  {
    m_tolerances.use_tie(1);
    m_joint = m_tolerances.joint;
    m_has_loose_joints = false;
    return connect(cell, candidates, m_tolerances.slack, false, new_node, out);
  }

  // Adds the arcs of all pairs of windows in a cell, whether they fit together or not.
  void find_arcs(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates, std::vector<Bisector_arc<NT>>& arcs)
  {
    m_tolerances.use_tie(1);
    m_find_arcs(cell, candidates, -m_tolerances.slack, arcs);
  }

  // True if ends farther apart than a joint have met in the last cell: loose ones, or all.
  bool has_loose_joints() const { return m_has_loose_joints; }
  bool has_wide_joints() const { return m_joint > m_tolerances.joint; }

private:
  template <class New_node, class OutputFunction>
  bool connect(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates, NT tie_factor, NT joint_factor,
               bool joins_loose_ends, const New_node& new_node, const OutputFunction& out)
  {
    m_tolerances.use_tie(tie_factor);
    m_joint = joint_factor * m_tolerances.joint;
    m_has_loose_joints = joins_loose_ends || joint_factor > 1;
    return connect(cell, candidates, m_tolerances.slack, joins_loose_ends, new_node, out) ||
           connect(cell, candidates, -m_tolerances.slack, joins_loose_ends, new_node, out);
  }

  template <class New_node, class OutputFunction>
  bool connect(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates, NT margin, bool joins_loose_ends,
               const New_node& new_node, const OutputFunction& out)
  {
    m_motion.set_cell(cell, candidates);
    m_arcs.clear();
    m_find_arcs(cell, candidates, margin, m_arcs);
    if (margin > 0) m_along_sides.keep_own(cell, m_arcs);
    if (m_arcs.empty() && cell.gates.empty()) return true;
    if (!fit_together(cell, joins_loose_ends))
    {
      const std::size_t found = m_arcs.size();
      m_along_sides.add_links(cell, candidates, m_arcs);
      if (m_arcs.size() == found || !fit_together(cell, joins_loose_ends)) return false;
    }
    for (const auto& members : m_clusters) set_nodes(cell, members, new_node);
    for (const Bisector_arc<NT>& arc : m_arcs)
      if (arc.start_node != no_index) out(arc);
    for (const Bisector_arc<NT>& l : m_links) out(l);
    return true;
  }

  // Sorts the ends of the arcs and the gates into clusters. Returns false if these do not fit together.
  bool fit_together(const Voronoi_cell<NT>& cell, bool joins_loose_ends)
  {
    m_ends.clear();
    for (std::size_t i = 0; i < m_arcs.size(); ++i)
    {
      const Bisector_arc<NT>& a = m_arcs[i];
      m_ends.push_back({a.start, i, false, false, a.left.label, a.right.label});
      m_ends.push_back({a.end, i, false, true, a.right.label, a.left.label});
    }
    for (std::size_t i = 0; i < cell.gates.size(); ++i)
      m_ends.push_back({cell.gates[i].point, i, true, false, cell.gates[i].to, cell.gates[i].from});
    find_clusters();
    if (joins_loose_ends) join_loose_ends(cell);
    m_links.clear();
    for (auto& members : m_clusters)
      if (!fits(cell, members) && !(link_neighbours(cell, members) && fits(cell, members))) return false;
    return true;
  }

  // Sorts the ends into clusters.
  void find_clusters()
  {
    const std::size_t n = m_ends.size();
    m_cluster.assign(n, n);
    m_clusters.clear();
    for (std::size_t i = 0; i < n; ++i)
    {
      if (m_cluster[i] != n) continue;
      const std::size_t c = m_clusters.size();
      m_clusters.emplace_back();
      std::vector<std::size_t>& members = m_clusters.back();
      members.push_back(i);
      m_cluster[i] = c;
      for (std::size_t j = 0; j < members.size(); ++j)
        for (std::size_t k = i + 1; k < n; ++k)
          if (m_cluster[k] == n && are_near(m_ends[members[j]].point, m_ends[k].point, m_joint))
          {
            m_cluster[k] = c;
            members.push_back(k);
          }
    }
    // Arcs within a cluster do not count, nor arcs that lie on earlier ones: along a common bound of the cones of two windows with
    // one image.
    for (auto& members : m_clusters)
      members.erase(std::remove_if(members.begin(), members.end(),
                                   [&](std::size_t e) {
                                     return !m_ends[e].is_gate &&
                                            (this->is_within_cluster(m_ends[e].arc) || this->repeats_another(m_ends[e].arc));
                                   }),
                    members.end());
  }

  // Joins clusters that do not fit alone, nearest first, if their arcs may end in one point: they meet at a small angle, or some
  // of the sources nearly coincide, and rounding moves their ends along them.
  void join_loose_ends(const Voronoi_cell<NT>& cell)
  {
    struct Pair
    {
      NT gap;
      std::size_t first, second;
    };
    std::vector<std::size_t> loose;
    for (std::size_t c = 0; c < m_clusters.size(); ++c)
      if (!fits(cell, m_clusters[c])) loose.push_back(c);
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < loose.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
      {
        if (!are_near(point_of(loose[i]), point_of(loose[j]), m_tolerances.loose_joint)) continue;
        pairs.push_back({length(point_of(loose[i]) - point_of(loose[j])), loose[j], loose[i]});
      }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.gap < b.gap; });
    for (const Pair& p : pairs)
    {
      auto &members = m_clusters[p.first], &others = m_clusters[p.second];
      if (members.empty() || others.empty() || fits(cell, members) || fits(cell, others)) continue;
      std::vector<std::size_t> joined = members;
      joined.insert(joined.end(), others.begin(), others.end());
      if (!m_motion.put_common_end_first(joined)) continue;
      members.swap(joined);
      others.clear();
    }
  }

  // The first test saves the root for most pairs of ends.
  static bool are_near(const Point& p, const Point& q, NT distance)
  {
    return CGAL::abs(p.x - q.x) <= distance && length(p - q) <= distance;
  }

  Point point_of(std::size_t cluster) const { return m_ends[m_clusters[cluster].front()].point; }

  bool repeats_another(std::size_t arc) const
  {
    const Bisector_arc<NT>& a = m_arcs[arc];
    for (std::size_t i = 0; i < arc; ++i)
    {
      const bool same = m_cluster[2 * i] == m_cluster[2 * arc] && m_cluster[2 * i + 1] == m_cluster[2 * arc + 1];
      const bool reverse = m_cluster[2 * i] == m_cluster[2 * arc + 1] && m_cluster[2 * i + 1] == m_cluster[2 * arc];
      const Bisector_arc<NT>& b = m_arcs[i];
      if (!(same || reverse) || !are_near(a.middle(), b.middle(), m_joint)) continue;
      if ((same ? a.left.label : a.right.label) == b.left.label && (same ? a.right.label : a.left.label) == b.right.label)
        return true;
    }
    return false;
  }

  bool is_within_cluster(std::size_t arc) const
  {
    if (m_cluster[2 * arc] != m_cluster[2 * arc + 1]) return false;
    const Bisector_arc<NT>& a = m_arcs[arc];
    return length(a.middle() - a.start) <= 2 * m_joint;
  }

  // True if the ends of a cluster are in one point: of two sources with two ends, or of n sources with n ends; or the sectors
  // between the ends, in the order of their directions, have one source each, as where two polylines cross.
  bool fits(const Voronoi_cell<NT>& cell, const std::vector<std::size_t>& members) const
  {
    if (members.empty()) return true;
    if (members.size() == 1) return false;
    std::vector<Index> left, right;
    for (const std::size_t e : members)
    {
      left.push_back(m_ends[e].left);
      right.push_back(m_ends[e].right);
    }
    std::sort(left.begin(), left.end());
    std::sort(right.begin(), right.end());
    if (left != right) return false;
    if (std::adjacent_find(left.begin(), left.end()) == left.end()) return true;
    std::vector<std::pair<NT, std::size_t>> around; // gates of a side have one direction, and come in order
    for (const std::size_t e : members)
    {
      const Point u = direction_of(cell, m_ends[e]);
      around.emplace_back(order_of_angle(u.x, u.y), e);
    }
    std::sort(around.begin(), around.end());
    for (std::size_t i = 0; i < around.size(); ++i)
      if (m_ends[around[i].second].left != m_ends[around[(i + 1) % around.size()].second].right) return false;
    return true;
  }

  // Direction from an end along its arc, or through the gate out of the cell.
  Point direction_of(const Voronoi_cell<NT>& cell, const Arc_end<NT>& end) const
  {
    if (end.is_gate) return cell.outside(cell.gates[end.arc].side).n;
    const Bisector_arc<NT>& a = m_arcs[end.arc];
    const NT forward = end.is_end ? -1 : 1;
    return forward * (a.is_link ? a.end - a.start : a.conic.tangent(end.is_end ? a.to : a.from));
  }

  // Links neighbouring gates of a cluster between the same two sources, and removes them from it. Returns false if there are none.
  bool link_neighbours(const Voronoi_cell<NT>& cell, std::vector<std::size_t>& members)
  {
    bool has_links = false;
    const std::size_t n = cell.gates.size();
    const auto place_of = [&](std::size_t gate) {
      return std::find_if(members.begin(), members.end(), [&](std::size_t e) {
        return m_ends[e].is_gate && m_ends[e].arc == gate;
      });
    };
    for (std::size_t i = 0; i < n && members.size() > 2; ++i)
    {
      const std::size_t j = (i + 1) % n;
      const auto at_i = place_of(i);
      if (at_i == members.end() || place_of(j) == members.end()) continue;
      if (cell.gates[i].from != cell.gates[j].to || cell.gates[i].to != cell.gates[j].from) continue;
      members.erase(at_i);
      members.erase(place_of(j));
      m_links.push_back(Gate_links<NT>::link(cell.gates[i], cell.gates[j]));
      has_links = true;
    }
    return has_links;
  }

  // Sets the nodes of the arcs of a cluster: the gate, or a new node. Adds links between gates.
  template <class New_node>
  void set_nodes(const Voronoi_cell<NT>& cell, const std::vector<std::size_t>& members, const New_node& new_node)
  {
    if (members.empty()) return;
    std::vector<std::size_t> gates;
    for (const std::size_t e : members)
      if (m_ends[e].is_gate) gates.push_back(m_ends[e].arc);
    if (members.size() == 2 && gates.size() == 2)
    {
      m_links.push_back(Gate_links<NT>::link(cell.gates[gates[0]], cell.gates[gates[1]]));
      return;
    }
    // the common end of loose ends may be that of the arc
    const bool is_gate = members.size() == 2 && gates.size() == 1 &&
                         length(m_ends[members[0]].point - cell.gates[gates[0]].point) <= m_tolerances.joint;
    const Index node = is_gate ? cell.gates[gates[0]].node : new_node();
    const Point point = is_gate ? cell.gates[gates[0]].point : m_ends[members[0]].point;
    for (const std::size_t e : members)
    {
      const Arc_end<NT>& end = m_ends[e];
      if (end.is_gate)
      {
        if (is_gate) continue;
        Bisector_arc<NT> l = Gate_links<NT>::link(cell.gates[end.arc], cell.gates[end.arc]);
        l.end_node = node;
        l.end = point;
        m_links.push_back(l);
        continue;
      }
      move_end(end, point, node, new_node);
    }
  }

  // Ends an arc in a node: farther than a joint from its end, along its conic as far as this goes, and from there straight.
  template <class New_node>
  void move_end(const Arc_end<NT>& end, const Point& point, Index node, const New_node& new_node)
  {
    Bisector_arc<NT>& arc = m_arcs[end.arc];
    Index& end_node = end.is_end ? arc.end_node : arc.start_node;
    Point& end_point = end.is_end ? arc.end : arc.start;
    end_node = node;
    if (m_motion.has_conic(end) && length(end.point - point) > m_tolerances.joint)
    {
      const NT after = m_motion.parameter_towards(end, point);
      (end.is_end ? arc.to : arc.from) = after;
      const Point q = arc.conic.at(after).point();
      if (length(q - point) > m_tolerances.joint)
      {
        end_node = new_node();
        end_point = q;
        Bisector_arc<NT> l = arc;
        l.is_link = true;
        l.left.window = l.right.window = no_index;
        l.start = end.is_end ? q : point;
        l.end = end.is_end ? point : q;
        l.start_node = end.is_end ? end_node : node;
        l.end_node = end.is_end ? node : end_node;
        m_links.push_back(l);
        return;
      }
    }
    end_point = point;
  }

  Voronoi_tolerances<NT> m_tolerances;
  const NT m_aspect; // of the face
  bool m_has_loose_joints = false;
  NT m_joint = 0; // ends no farther apart meet
  const Cell_arcs<NT> m_find_arcs;
  Arcs_along_sides<NT> m_along_sides;
  std::vector<Bisector_arc<NT>> m_arcs, m_links;
  std::vector<Arc_end<NT>> m_ends;                  // two of each arc, then the gates
  std::vector<std::size_t> m_cluster;               // per end
  std::vector<std::vector<std::size_t>> m_clusters; // ends that meet
  Arc_end_motion<NT> m_motion;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
