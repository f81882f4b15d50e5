// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One level inside one face: chains of pieces from gate to gate, and loops.
//
// The result of a walk along the arcs is accepted if every gate has its chain. Otherwise the cell is divided; both parts share
// the gates on the dividing segment. A cell of the size of rounding, or a sliver along the level, is crossed straight from gate
// to gate. So chains always fit together, and rounding affects only such cells.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_TRACER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_TRACER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_arcs.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_cell.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_walk.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Near_intervals.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Level_tracer
{
public:
  typedef Point_in_face<FT> Point;
  typedef Level_piece<FT> Piece;
  typedef Level_gate<FT> Gate;
  typedef Level_cell<FT> Cell;

  // `longest_edge`: of the mesh.
  Level_tracer(const FT& longest_edge, const Offset_sources<FT>& sources)
    : m_farther_rounding(Offset_tolerances<FT>::farther_rounding(longest_edge)), m_arcs(sources)
  {
  }
  Level_tracer(const Level_tracer&) = delete; // the walk refers to the arcs

  // Sets the face, the longest edge of the faces around it, and bounds of the levels.
  void set_face(const Face_field<FT>& field, const FT& reach, const FT& lowest, const FT& highest)
  {
    m_arcs.set_face(field, reach, lowest, highest);
  }

  // Calls out(start gate, end gate, pieces) for the chains that connect all gates, and with no_index for all loops. `face`: the
  // face as a cell, with its gates.
  template <class Function>
  void operator()(const FT& level, const Cell& face, bool search_loops, const Function& out)
  {
    CGAL_precondition(face.is_consistent());
    m_arcs.set_level(level);
    m_chains.clear();
    m_inner_gates = 0;
    m_divisions = 0;
    m_face = face;
    for (std::size_t i = 0; i < m_face.gates.size(); ++i) m_face.gates[i].id = Index(i);
    trace(m_face, search_loops);
    const auto give_out = [&](Index start, Index end) {
      drop_points();
      CGAL_assertion(!m_chain.empty() && are_joined());
      CGAL_assertion((start == no_index) == (end == no_index));
      if (start != no_index)
      {
        CGAL_assertion(face.gates[start].is_start && !face.gates[end].is_start);
        CGAL_assertion(is_same(m_chain.front().start, face.gates[start].point));
        CGAL_assertion(is_same(m_chain.back().end, face.gates[end].point));
        m_chain.front().start_edge = face.gates[start].side;
        m_chain.back().end_edge = face.gates[end].side;
        start = face.gates[start].id;
        end = face.gates[end].id;
      }
      out(start, end, m_chain);
    };
    if (m_inner_gates == 0)
      for (const Chain& c : m_chains.chains)
      {
        m_chain.assign(pieces_at(c.first), pieces_at(c.last));
        give_out(c.start, c.end);
      }
    else link(give_out);
  }

  // Number of cells that were crossed straight although they are larger than rounding: 0 unless a window is missing.
  std::size_t number_of_forced_joints() const { return m_forced; }
  // Number of cells of the size of rounding that were crossed straight.
  std::size_t number_of_crossed_cells() const { return m_crossed; }

private:
  typedef Level_arc<FT> Arc;
  typedef typename Level_chains<FT>::Chain Chain;

  static constexpr std::size_t none = std::size_t(-1);
  static constexpr Index inner_gate = Index(1) << 31; // flag of gates between cells

  void trace(const Cell& cell, bool search_loops)
  {
    if (cell.gates.empty() && !search_loops) return;
    if (walk_with_some_tie(cell, search_loops)) return;
    if (!m_arcs.has_fans())
    {
      m_arcs.add_fans();
      if (walk_with_some_tie(cell, search_loops)) return;
    }
    const bool is_point = cell.diameter() <= (std::max)(m_arcs.tolerances().smallest_cell, m_farther_rounding);
    const bool is_last = m_divisions == Offset_tolerances<FT>::most_divisions;
    const bool may_have_loops = search_loops && cell.height() > m_arcs.tolerances().error;
    if (is_point || is_last || (!may_have_loops && is_sliver(cell)))
    {
      ++(is_last && !is_point ? m_forced : m_crossed);
      cross_straight(cell);
      return;
    }
    const auto crossings =
      [this](const Point& o, const Point& u, const FT& length, bool near_at_o, bool near_at_end, const auto& out) {
        m_near.start(length, m_arcs.reach(), m_arcs.level());
        m_arcs.for_each_window([&](const Face_window<FT>& w) { this->m_near.add_window(w, o, u, false); });
        m_near.for_each_end(near_at_o, near_at_end, out);
      };
    const std::pair<Cell, Cell> parts = cell.divided(crossings, [this] { return inner_gate | m_inner_gates++; });
    ++m_divisions;
    trace(parts.first, search_loops);
    trace(parts.second, search_loops);
  }

  // Cuts off the far intervals of the boundary one by one: joins every start with the end that follows it.
  void cross_straight(const Cell& cell)
  {
    const std::size_t n = cell.gates.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const Gate &s = cell.gates[i], &e = cell.gates[(i + 1) % n];
      CGAL_assertion(s.is_start != e.is_start);
      if (!s.is_start) continue;
      const std::size_t first = m_chains.pieces.size();
      m_chains.chains.push_back({s.id, e.id, first, first + 1});
      m_chains.pieces.push_back(straight_piece(s, e));
    }
  }

  // True if sides of the cell run along the level, so that only rounding decides where it crosses them: the segments that cut
  // off the far intervals of the boundary are on the level.
  bool is_sliver(const Cell& cell) const
  {
    const std::size_t n = cell.gates.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      if (!cell.gates[i].is_start) continue;
      const Point &p = cell.gates[i].point, &q = cell.gates[(i + 1) % n].point;
      if (!(length(q - p) <= m_arcs.tolerances().longest_sliver)) return false;
      std::size_t nearest;
      const FT d = m_arcs.distance(FT(0.5) * (p + q), nearest);
      if (!(CGAL::abs(FT(d - m_arcs.level())) <= m_arcs.tolerances().error)) return false;
    }
    return n > 0;
  }

  // A piece between two gates within rounding of each other, or of a sliver, on the arc nearest to the first gate if that arc
  // leads to the second one.
  Piece straight_piece(const Gate& s, const Gate& e) const
  {
    const auto leads_on = [&](const Arc& a) { return !(a.advance(s.point, e.point) < -m_arcs.tolerances().error); };
    std::size_t nearest = none;
    FT least = Number_policy<FT>::infinity();
    for (std::size_t i = 0; i < m_arcs.size(); ++i)
    {
      const FT off = (std::max)(CGAL::abs(m_arcs[i].excess(s.point)), m_arcs[i].outside_cone(s.point));
      if (!(off < least)) continue;
      least = off;
      nearest = i;
    }
    if (nearest != none && least <= m_arcs.tolerances().smallest_cell && leads_on(m_arcs[nearest]))
      return piece_through(m_arcs[nearest].window(), m_arcs[nearest].radius(), s.point, e.point, m_arcs.field().face());
    // Without an arc, a segment with the smaller distances on the left.
    m_arcs.distance(s.point, nearest);
    Piece p = piece_through(m_arcs.field().windows()[nearest], FT(0), s.point, e.point, m_arcs.field().face());
    const Point v = e.point - s.point;
    const FT l = length(v);
    p.is_straight = true;
    p.center = CGAL::is_positive(l) ? (FT(1) / l) * Point{v.y, -v.x} : Point{FT(1), FT(0)};
    p.radius = dot(p.center, s.point);
    return p;
  }

  bool walk_with_some_tie(const Cell& cell, bool search_loops)
  {
    const std::size_t chains = m_chains.chains.size(), pieces = m_chains.pieces.size();
    for (const int factor : Offset_tolerances<FT>::tie_factors)
    {
      m_arcs.use_tie(factor);
      if (factor > 1 && m_arcs.tolerances().tie > Offset_tolerances<FT>::largest_tie(m_arcs.narrowest_offset())) break;
      if (m_walk(cell, search_loops)) return true;
      m_chains.resize(chains, pieces);
      if (CGAL::is_zero(m_arcs.tolerances().tie)) break; // exact numbers
    }
    return false;
  }

  auto pieces_at(std::size_t i) const { return m_chains.pieces.begin() + std::ptrdiff_t(i); }

  // Joins the chains of cells at the gates between them. Calls out(start, end) for each, with its pieces in m_chain.
  template <class Function>
  void link(const Function& out)
  {
    const std::vector<Chain>& chains = m_chains.chains;
    std::map<Index, std::size_t> chain_at; // by start gate
    for (std::size_t i = 0; i < chains.size(); ++i)
      if (is_inner(chains[i].start)) chain_at.emplace(chains[i].start, i);
    std::vector<char> done(chains.size(), 0);
    for (const bool is_loop : {false, true}) // first the chains from gates of the face
      for (std::size_t i = 0; i < chains.size(); ++i)
      {
        if (done[i] || (!is_loop && is_inner(chains[i].start))) continue;
        m_chain.clear();
        Index end = no_index;
        for (std::size_t j = i; !done[j]; j = chain_at.at(end))
        {
          done[j] = 1;
          m_chain.insert(m_chain.end(), pieces_at(chains[j].first), pieces_at(chains[j].last));
          end = chains[j].end;
          if (!is_inner(end)) break;
        }
        if (is_loop) out(no_index, no_index);
        else out(chains[i].start, end);
      }
  }

  static bool is_same(const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; }

  // True if each piece of m_chain ends where its successor starts.
  bool are_joined() const
  {
    for (std::size_t i = 1; i < m_chain.size(); ++i)
      if (!is_same(m_chain[i - 1].end, m_chain[i].start)) return false;
    return true;
  }

  static bool is_inner(Index gate) { return gate != no_index && (gate & inner_gate) != 0; }

  // Merges short pieces into a neighbour that passes through both of their ends, and removes pieces without extent.
  void drop_points()
  {
    const Offset_tolerances<FT>& t = m_arcs.tolerances();
    std::size_t n = 0;
    for (std::size_t i = 0; i < m_chain.size(); ++i)
    {
      const FT l = length(m_chain[i].end - m_chain[i].start);
      const bool is_short = l <= t.shortest_piece, is_last = i + 1 == m_chain.size();
      if (is_short && n > 0 && (l <= t.cover || m_chain[n - 1].off(m_chain[i].end) <= t.tie))
        m_chain[n - 1].end = m_chain[i].end;
      else if (is_short && n == 0 && !is_last && (l <= t.cover || m_chain[i + 1].off(m_chain[i].start) <= t.tie))
        m_chain[i + 1].start = m_chain[i].start;
      else m_chain[n++] = m_chain[i];
    }
    m_chain.resize(n);
  }

  const FT m_farther_rounding;
  Level_arcs<FT> m_arcs;
  Near_intervals<FT> m_near; // on segments between cells
  Cell m_face;               // its gates are numbered in their order
  Level_chains<FT> m_chains;
  Level_walk<FT> m_walk{m_arcs, m_chains};
  std::vector<Piece> m_chain; // of the chain in output
  Index m_inner_gates = 0;
  int m_divisions = 0; // of the face
  std::size_t m_forced = 0, m_crossed = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
