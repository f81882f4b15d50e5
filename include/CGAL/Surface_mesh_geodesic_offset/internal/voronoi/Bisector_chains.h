// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains of arcs of bisectors between the vertices of the diagram.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_BISECTOR_CHAINS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_BISECTOR_CHAINS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_arc.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_tolerances.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class NT>
class Bisector_chains
{
public:
  // `arcs`: those of all faces. Each node is the end of two arcs, of three or more (a vertex), or of one, on the border.
  Bisector_chains(std::vector<Bisector_arc<NT>>&& arcs, std::size_t number_of_nodes) : m_begin(number_of_nodes + 1, 0)
  {
    contract(arcs, number_of_nodes);
    for (const Bisector_arc<NT>& a : m_arcs)
    {
      ++m_begin[a.start_node];
      ++m_begin[a.end_node];
    }
    std::size_t sum = 0;
    for (std::size_t& b : m_begin) sum = (b += sum);
    m_incident.resize(sum);
    for (std::size_t i = m_arcs.size(); i-- > 0;)
    {
      m_incident[--m_begin[m_arcs[i].end_node]] = i;
      m_incident[--m_begin[m_arcs[i].start_node]] = i;
    }
    m_is_used.assign(m_arcs.size(), 0);
    m_vertex.assign(number_of_nodes, Bisector_chain<NT>::no_vertex);
  }

  void write(Bisector_diagram<NT>& out)
  {
    for (std::size_t n = 0; n + 1 < m_begin.size(); ++n)
      if (degree(n) > 1 && !is_inner(n))
      {
        m_vertex[n] = out.vertices.size();
        const Bisector_arc<NT>& a = m_arcs[m_incident[m_begin[n]]];
        const bool at_start = a.start_node == n;
        out.vertices.push_back({a.face, at_start ? a.start : a.end, at_start ? a.start_edge : a.end_edge});
      }
    for (std::size_t n = 0; n + 1 < m_begin.size(); ++n)
    {
      if (is_inner(n)) continue;
      for (std::size_t i = m_begin[n]; i < m_begin[n + 1]; ++i)
        if (!m_is_used[m_incident[i]]) follow(m_incident[i], Index(n), out);
    }
    for (std::size_t i = 0; i < m_arcs.size(); ++i)
      if (!m_is_used[i]) follow(i, m_arcs[i].start_node, out);
  }

private:
  // Copies the arcs without those that rounding does not tell from a point, which become one node, as around a vertex of the
  // mesh. Ends on the border remain what they are.
  void contract(const std::vector<Bisector_arc<NT>>& arcs, std::size_t number_of_nodes)
  {
    std::vector<std::size_t> number_at(number_of_nodes, 0);
    std::vector<Index> same(number_of_nodes);
    for (Index n = 0; n < number_of_nodes; ++n) same[n] = n;
    const auto representative = [&](Index n) {
      while (same[n] != n) n = same[n] = same[same[n]];
      return n;
    };
    for (const Bisector_arc<NT>& a : arcs)
    {
      ++number_at[a.start_node];
      ++number_at[a.end_node];
    }
    const auto is_contracted = [&](const Bisector_arc<NT>& a) {
      if (!a.is_negligible() || number_at[a.start_node] == 1 || number_at[a.end_node] == 1) return false;
      const Index from = representative(a.start_node), to = representative(a.end_node);
      same[from] = to;
      return true;
    };
    for (const Bisector_arc<NT>& a : arcs)
      if (!is_contracted(a)) m_arcs.push_back(a);
    for (Bisector_arc<NT>& a : m_arcs)
    {
      a.start_node = representative(a.start_node);
      a.end_node = representative(a.end_node);
    }
  }

  // True if a chain passes through a node: it has two ends of arcs, between the same cells.
  bool is_inner(std::size_t node) const
  {
    if (degree(node) != 2) return false;
    const std::size_t i = m_incident[m_begin[node]], j = m_incident[m_begin[node] + 1];
    if (i == j) return true;
    const Bisector_arc<NT>&a = m_arcs[i], &b = m_arcs[j];
    const bool is_same_direction = (a.start_node == node) != (b.start_node == node);
    return a.left.label == (is_same_direction ? b.left.label : b.right.label) &&
           a.right.label == (is_same_direction ? b.right.label : b.left.label);
  }

  std::size_t degree(std::size_t node) const { return m_begin[node + 1] - m_begin[node]; }

  // Follows a chain from an arc that starts at a node.
  void follow(std::size_t arc, Index node, Bisector_diagram<NT>& out)
  {
    Bisector_chain<NT> chain;
    const Index first = node;
    std::vector<Bisector_arc<NT>> arcs;
    for (;;)
    {
      m_is_used[arc] = 1;
      Bisector_arc<NT> a = m_arcs[arc];
      if (a.start_node != node) a.reverse();
      CGAL_assertion(a.start_node == node);
      CGAL_assertion(arcs.empty() || (arcs.back().left.label == a.left.label && arcs.back().right.label == a.right.label));
      arcs.push_back(a);
      node = a.end_node;
      if (!is_inner(node)) break;
      const std::size_t *const at = &m_incident[m_begin[node]], next = at[0] == arc ? at[1] : at[0];
      if (m_is_used[next]) break;
      arc = next;
    }
    chain.is_closed = is_inner(first);
    CGAL_assertion(!chain.is_closed || node == first);
    chain.start_vertex = chain.is_closed ? Bisector_chain<NT>::no_vertex : m_vertex[first];
    chain.end_vertex = chain.is_closed ? Bisector_chain<NT>::no_vertex : m_vertex[node];
    join(std::move(arcs), chain);
    if (chain.arcs.empty() || (chain.is_closed && has_no_area(chain.arcs, out.cells))) return;
    if (chain.start_vertex != Bisector_chain<NT>::no_vertex)
      out.vertices[chain.start_vertex].curves.push_back(out.chains.size());
    if (chain.end_vertex != Bisector_chain<NT>::no_vertex) out.vertices[chain.end_vertex].curves.push_back(out.chains.size());
    out.chains.push_back(std::move(chain));
  }

  // True if a closed chain is around a part of the mesh that is larger than the chain, as a needle: on both sides, the source
  // of the side is nearer at a corner than a point within the chain allows.
  static bool is_around_needle(const std::vector<Bisector_arc<NT>>& arcs, NT length,
                               const std::unordered_map<Index, Face_cells<NT>>& cells)
  {
    NT lead_of_left = 0, lead_of_right = 0;
    for (const Bisector_arc<NT>& a : arcs)
    {
      const auto found = cells.find(a.face);
      if (found == cells.end()) continue;
      lead_of_left = (std::max)(lead_of_left, found->second.largest_lead(a.left.label, a.right.label));
      lead_of_right = (std::max)(lead_of_right, found->second.largest_lead(a.right.label, a.left.label));
    }
    return (std::min)(lead_of_left, lead_of_right) > 2 * length;
  }

  // True if a closed chain is a point or, in a face, a line up to rounding, or follows only edges, each of them in both
  // directions: a tie along edges.
  static bool has_no_area(const std::vector<Bisector_arc<NT>>& arcs, const std::unordered_map<Index, Face_cells<NT>>& cells)
  {
    std::map<Index, NT> along;
    NT negligible = 0, length = 0, longest = 0, area = 0, widest = 0;
    bool is_in_face = true;
    const Point_in_face<NT> origin = arcs.front().start;
    for (const Bisector_arc<NT>& a : arcs)
    {
      const auto start = a.start - origin, middle = a.middle() - origin, end = a.end - origin;
      length += a.chord_length();
      area += (cross(start, middle) + cross(middle, end)) / 2;
      is_in_face = is_in_face && a.face == arcs.front().face;
      longest = (std::max)(longest, a.smallest_loop);
      widest = (std::max)(widest, a.negligible);
    }
    if (is_in_face && (length <= longest || CGAL::abs(area) <= widest * length)) return true;
    if (length <= longest && !is_around_needle(arcs, length, cells)) return true;
    for (const Bisector_arc<NT>& a : arcs)
    {
      if (a.edge == no_index) return false;
      along[a.edge] += a.along_edge;
      negligible += a.negligible;
    }
    return std::all_of(along.begin(), along.end(), [&](const auto& a) { return CGAL::abs(a.second) <= negligible; });
  }

  // Drops arcs that are points up to rounding, and joins the parts of one arc. A chain of such arcs only, closed or from border to
  // border, is dropped, too.
  static void join(std::vector<Bisector_arc<NT>>&& arcs, Bisector_chain<NT>& chain)
  {
    std::size_t longest = 0;
    for (std::size_t i = 0; i < arcs.size(); ++i)
      if (!arcs[i].is_negligible()) longest = i;
    if (arcs[longest].is_negligible())
    {
      const bool has_vertex =
        chain.start_vertex != Bisector_chain<NT>::no_vertex || chain.end_vertex != Bisector_chain<NT>::no_vertex;
      if (has_vertex) chain.arcs.push_back(arcs[longest]);
      return;
    }
    // but an end on the border remains there, and arcs that are left out in a row are not longer than one of them
    NT left_out = 0;
    const auto is_left_out = [&](std::size_t i) {
      const bool ends_at_border = (i == 0 && chain.start_vertex == Bisector_chain<NT>::no_vertex) ||
                                  (i + 1 == arcs.size() && chain.end_vertex == Bisector_chain<NT>::no_vertex);
      return arcs[i].is_negligible() && !(ends_at_border && !chain.is_closed) &&
             left_out + arcs[i].chord_length() <= arcs[i].negligible;
    };
    for (std::size_t i = 0; i < arcs.size(); ++i)
    {
      const Bisector_arc<NT>& a = arcs[i];
      if (is_left_out(i))
      {
        left_out += a.chord_length();
        continue;
      }
      left_out = 0;
      if (!chain.arcs.empty() && chain.arcs.back().continues_in(a)) chain.arcs.back().append(a);
      else chain.arcs.push_back(a);
    }
    if (chain.is_closed && chain.arcs.size() > 1 && chain.arcs.back().continues_in(chain.arcs.front()))
    {
      chain.arcs.back().append(chain.arcs.front());
      chain.arcs.front() = chain.arcs.back();
      chain.arcs.pop_back();
    }
  }

  std::vector<Bisector_arc<NT>> m_arcs;
  std::vector<std::size_t> m_begin, m_incident; // per node, its arcs
  std::vector<char> m_is_used;                  // per arc
  std::vector<std::size_t> m_vertex;            // per node, of the diagram
};

} // namespace CGAL::Geodesic_offset::internal

#endif
