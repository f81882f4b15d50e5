// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walks along the arcs of a level in one cell. A chain follows an arc while it is visible, continues with the arc that covers it
// or that begins where its cone ends, and ends at the first gate on its arc. Where an arc meets a side of the cell without a
// gate, another arc ties with it, and the chain turns back along that arc. The walk succeeds if every gate has a chain and
// every loop closes.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_WALK_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_WALK_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_arcs.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_cell.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Level_piece.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Chains of pieces between gates, and loops.
template <class FT>
struct Level_chains
{
  struct Chain
  {
    Index start, end;        // gates; no_index for a loop
    std::size_t first, last; // pieces
  };

  std::vector<Chain> chains;
  std::vector<Level_piece<FT>> pieces; // of all chains

  void clear() { resize(0, 0); }
  void resize(std::size_t number_of_chains, std::size_t number_of_pieces)
  {
    chains.resize(number_of_chains);
    pieces.resize(number_of_pieces);
  }
};

template <class FT>
class Level_walk
{
public:
  typedef Point_in_face<FT> Point;
  typedef Level_piece<FT> Piece;
  typedef Level_gate<FT> Gate;
  typedef Level_cell<FT> Cell;
  typedef Level_chains<FT> Chains;

  // Walks along `arcs` and appends to `chains`.
  Level_walk(const Level_arcs<FT>& arcs, Chains& chains) : m_arcs(arcs), m_chains(chains.chains), m_pieces(chains.pieces) {}

  // Traces chains through all gates of a cell, and loops. Returns false if the walk fails; some chains are appended in this
  // case, too.
  bool operator()(const Cell& cell, bool search_loops)
  {
    m_cell = &cell;
    find_gates();
    forget_followed(0);
    if (m_followed_of.size() < m_arcs.size()) m_followed_of.resize(m_arcs.size());
    for (std::size_t i = 0; i < cell.gates.size(); ++i)
      if (cell.gates[i].is_start && !walk_from_gate(i)) return false;
    return !search_loops || walk_loops();
  }

private:
  typedef Level_arc<FT> Arc;

  static constexpr std::size_t none = std::size_t(-1);

  // A part of an arc. It ends where the arc is covered, at the end of the window's cone, at a gate, or at a side of the cell.
  struct Run
  {
    std::size_t arc = none, gate = none;
    Point start{FT(0), FT(0)}, end{FT(0), FT(0)};
    FT length = FT(0);
    bool is_covered = false;
    bool leaves = false; // the run ends at a side of the cell without a gate
    bool is_valid() const { return arc != none; }
  };

  // Sets m_gates to the arcs that pass the gates where chains end.
  void find_gates()
  {
    m_is_used.assign(m_cell->gates.size(), 0);
    m_gates.clear();
    for (std::size_t g = 0; g < m_cell->gates.size(); ++g)
      if (const Gate& gate = m_cell->gates[g]; !gate.is_start)
        m_arcs.for_each_through(gate.point, none, [&](std::size_t i) { m_gates.emplace_back(i, g); });
    std::sort(m_gates.begin(), m_gates.end());
  }

  bool walk_from_gate(std::size_t gate)
  {
    const std::size_t first = m_pieces.size();
    const Gate& s = m_cell->gates[gate];
    Run last;
    for (std::size_t guard = 0; guard < 4 * m_arcs.size() + 16; ++guard)
    {
      const Run run = best_run(last, last.is_valid() ? last.end : s.point);
      if (!run.is_valid() || followed_by(run) != none) return false; // a part of an arc belongs to one chain
      add_piece(run, first);
      if (run.gate != none)
      {
        CGAL_assertion(!m_is_used[run.gate]);
        m_is_used[run.gate] = 1;
        m_chains.push_back({s.id, m_cell->gates[run.gate].id, first, m_pieces.size()});
        return true;
      }
      last = run;
    }
    return false;
  }

  // Adds a piece to the chain whose pieces begin at `first`.
  void add_piece(const Run& run, std::size_t first)
  {
    follow(run);
    if (m_pieces.size() > first) m_pieces.back().end = run.start;
    m_pieces.push_back(piece_through(m_arcs[run.arc].window(), m_arcs[run.arc].radius(), run.start, run.end,
                                     m_arcs.field().face()));
  }

  // The longest run along arc i in the cell from a point on it. `is_first`: the point is a gate.
  Run run_of(std::size_t i, const Point& start, bool is_first) const
  {
    const Arc& a = m_arcs[i];
    const Offset_tolerances<FT>& tolerance = m_arcs.tolerances();
    Run run;
    run.start = start;
    run.end = a.end();
    FT farthest = a.advance(start, run.end);
    // A gate up to `nearest` is at the start of the run: another chain leaves the cell through it.
    FT nearest = -(is_first ? tolerance.error : tolerance.tie);
    for (auto it = std::lower_bound(m_gates.begin(), m_gates.end(), std::make_pair(i, std::size_t(0)));
         it != m_gates.end() && it->first == i; ++it)
    {
      const std::size_t g = it->second;
      const Gate& gate = m_cell->gates[g];
      if (m_is_used[g]) continue;
      const FT way = a.advance(start, gate.point);
      if (way < nearest || (run.gate != none && !(way < farthest))) continue;
      if (run.gate == none && !a.is_between(start, gate.point, run.end) && farthest + tolerance.tie < way) continue;
      run.gate = g;
      run.end = gate.point;
      farthest = way;
    }
    Point end = run.end;
    if (CGAL::is_positive(farthest) && m_arcs.find_covered(i, start, end))
    {
      // A covered point next to the gate does not count: another arc may cross at the gate.
      if (run.gate == none || a.advance(end, run.end) > tolerance.tie)
      {
        run.gate = none;
        run.is_covered = true;
        run.end = end;
        farthest = a.advance(start, end);
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      const Half_plane<FT> side = m_cell->outside(k).opposite();
      Point enter, leave;
      if (!(a.values(side, start, run.end).largest > tolerance.tie) || !a.meet(side, enter, leave)) continue;
      run.leaves = true;
      run.is_covered = false;
      run.gate = none;
      run.end = leave;
      farthest = a.advance(start, leave);
    }
    if (run.gate == none && !(farthest > tolerance.error)) return run;
    run.length = farthest;
    run.arc = i;
    return run;
  }

  // The next run of a chain, from the end of the last run or from the starting gate. Of all arcs through that point, it is the
  // run of least rank, and of these the longest. The rank is the sum of:
  //   1  a fan (Level_arcs::add_fans()): it ties with the windows beside its gap;
  //   2  a run that turns back: where two arcs are within `tie` of each other, each passes through all points of the other;
  //   4  the end of a part that a chain has followed: where three arcs meet up to rounding, a chain might go back and forth;
  //   8  a run that meets a side without a gate: the next arc is within rounding there, and the chain has to turn back.
  Run best_run(const Run& last, const Point& p) const
  {
    Run best;
    int best_rank = 0;
    const Point heading = last.is_valid() ? m_arcs[last.arc].tangent(p) : Point{FT(0), FT(0)};
    m_arcs.for_each_through(p, last.arc, [&](std::size_t i) {
      const Point start = last.is_covered ? joint(last, i) : p;
      const bool turns_back = last.is_valid() && CGAL::is_negative(dot(m_arcs[i].tangent(p), heading));
      int rank = 2 * int(turns_back) + int(m_arcs.is_fan(i));
      if ((last.leaves && !turns_back) || (best.is_valid() && rank > best_rank)) return;
      const Run run = run_of(i, start, !last.is_valid());
      if (!run.is_valid() || repeats(last, run)) return;
      rank += 4 * int(is_known_end(run)) + 8 * int(run.leaves);
      if (best.is_valid() && (rank > best_rank || (rank == best_rank && !(run.length > best.length)))) return;
      best = run;
      best_rank = rank;
    });
    return best;
  }

  // True if a run ends at its own beginning, the end of the last run, after going back along the last run. The arcs of
  // coincident source segments tie in this way.
  bool repeats(const Run& last, const Run& run) const
  {
    return last.is_covered && run.gate == none && length(run.end - last.end) <= m_arcs.tolerances().tie &&
           length(run.start - last.end) > m_arcs.tolerances().tie;
  }

  // The point where the chain of a covered run changes to arc i. The run ends where the window of arc i is nearer by the
  // tolerance `cover`. The arcs meet before that point, and arc i is visible from there on. If the run starts beyond the
  // meeting point, the chain changes at its start.
  Point joint(const Run& run, std::size_t i) const
  {
    const Arc& a = m_arcs[run.arc];
    Point enter, leave;
    if (!a.meet(m_arcs[i], FT(0), enter, leave) || !m_arcs.passes(i, enter)) return run.end;
    if (a.is_between(run.start, enter, run.end)) return enter;
    return !CGAL::is_negative(a.advance(enter, run.start)) && m_arcs.passes(i, run.start) ? run.start : run.end;
  }

  // Traces loops that touch no side of the cell, around a source or a maximum. Each visible part of an arc in the cell belongs
  // to a chain or a loop. Visibility changes only where other arcs and sides of the cell meet the arc, so one point between
  // consecutive such points is tested.
  bool walk_loops()
  {
    m_arcs.find_arcs(*m_cell, m_arcs_of_cell);
    for (const std::size_t i : m_arcs_of_cell)
    {
      const Arc& a = m_arcs[i];
      m_events.clear();
      const auto add = [&](const Point& p) {
        if (a.is_between(a.start(), p, a.end())) m_events.push_back(p);
      };
      Point enter, leave;
      m_arcs.for_each_near(i, [&](std::size_t j) {
        if (!a.meet(m_arcs[j], FT(0), enter, leave)) return;
        add(enter);
        add(leave);
      });
      for (int k = 0; k < 3; ++k)
        if (a.meet(m_cell->outside(k), enter, leave))
        {
          add(enter);
          add(leave);
        }
      std::sort(m_events.begin(), m_events.end(),
                [&](const Point& p, const Point& q) { return CGAL::is_positive(a.advance(p, q)); });
      Point from = a.start();
      m_events.push_back(a.end());
      for (std::size_t e = 0; e < m_events.size(); ++e)
      {
        const Point to = m_events[e];
        if (a.advance(from, to) > m_arcs.tolerances().tie && !walk_loop(i, a.middle(from, to))) return false;
        from = to;
      }
    }
    return true;
  }

  // Traces the loop through a point of an arc, if there is one. Returns false if it cannot be closed. An arc that meets a side
  // without a gate may belong to a loop that turns back there. If no such loop closes, the arc is ignored.
  bool walk_loop(std::size_t i, const Point& start)
  {
    const FT& tie = m_arcs.tolerances().tie;
    // A loop may have all corners on the sides up to rounding, but must lie inside somewhere.
    FT deepest = m_cell->depth(start);
    if (deepest < -tie) return true;
    bool is_known = false;
    m_arcs.for_each_through(start, none, [&](std::size_t j) { is_known = is_known || this->is_followed(j, start); });
    if (is_known) return true;
    if (is_covered_in_cell(start)) return true;
    const std::size_t first = m_pieces.size(), first_followed = m_followed.size();
    Run run = run_of(i, start, false);
    if (!run.is_valid() || run.gate != none) return true;
    const bool starts_at_side = run.leaves;
    // Removes the pieces of the walk, and returns true, if the arc may be ignored.
    const auto drop_walk = [&] {
      if (!starts_at_side && !(deepest < tie)) return false;
      m_pieces.resize(first);
      if (starts_at_side) forget_followed(first_followed);
      return true;
    };
    for (std::size_t guard = 0; guard < 4 * m_arcs.size() + 16; ++guard)
    {
      const std::size_t known = followed_by(run);
      if (known != none)
      {
        // Another chain continues here, or the whole walk is outside the cell.
        if (known < first_followed || deepest < tie) return drop_walk();
        // The loop closes, possibly at a later piece than the first one; then the pieces before it are removed.
        const std::size_t begin = first + (known - first_followed);
        m_pieces.back().end = run.start;
        m_pieces.erase(pieces_at(first), pieces_at(begin));
        m_pieces[first].start = run.start;
        const bool is_point = is_within_tie(first);
        if (is_point || encloses_nothing(first))
        {
          m_pieces.resize(first);
          // A walk that started on another arc may end in a loop of no extent, at the joint of three arcs.
          return !(is_point && begin > first) || drop_walk();
        }
        m_chains.push_back({no_index, no_index, first, m_pieces.size()});
        return true;
      }
      deepest = (std::max)(deepest, m_cell->depth(m_arcs[run.arc].middle(run.start, run.end)));
      add_piece(run, first);
      run = best_run(run, run.end);
      if (!run.is_valid() || run.gate != none) return drop_walk();
    }
    return drop_walk();
  }

  // True if the distance at p is less than the level by more than `tie`. Rounding may put p outside the cell, behind a source
  // on a side of the cell, from which it has no path. So the distance is evaluated at a point inside; distances are
  // 1-Lipschitz.
  bool is_covered_in_cell(const Point& p) const
  {
    const FT& error = m_arcs.tolerances().error;
    Point inside = p;
    for (int k = 0; k < 3; ++k)
    {
      const FT missing = error - m_cell->height(k, inside);
      if (CGAL::is_positive(missing)) inside = inside + missing * m_cell->inwards(k);
    }
    return m_arcs.is_near(inside, length(inside - p));
  }

  void forget_followed(std::size_t first)
  {
    for (; m_followed.size() > first; m_followed.pop_back())
    {
      std::vector<std::size_t>& parts = m_followed_of[m_followed.back().arc];
      parts.erase(std::find(parts.begin(), parts.end(), m_followed.size() - 1));
    }
  }

  // True if all pieces of the loop start within a tie of the first one.
  bool is_within_tie(std::size_t first) const
  {
    return std::all_of(pieces_at(first), m_pieces.end(),
                       [&](const Piece& p) { return length(p.start - m_pieces[first].start) <= m_arcs.tolerances().tie; });
  }

  // True if the loop whose pieces begin at `first` runs forward and backward along one arc, up to the tolerance `tie`.
  bool encloses_nothing(std::size_t first) const
  {
    const auto begin = m_pieces.begin() + std::ptrdiff_t(first);
    const auto is_shorter = [](const Piece& p, const Piece& q) { return length(p.end - p.start) < length(q.end - q.start); };
    const Piece& longest = *std::max_element(begin, m_pieces.end(), is_shorter);
    const FT& tie = m_arcs.tolerances().tie;
    return std::any_of(begin, m_pieces.end(), [&](const Piece& p) { return p.advance() < -tie; }) &&
           std::all_of(begin, m_pieces.end(),
                       [&](const Piece& p) { return longest.off(p.start) <= tie && longest.off(p.middle()) <= tie; });
  }

  // A part of an arc that a chain of the cell follows.
  struct Followed
  {
    Point start, end;
    FT from, to; // advance of start and end from the start of the arc
    std::size_t arc;
  };

  void follow(const Run& run)
  {
    const Arc& a = m_arcs[run.arc];
    m_followed.push_back({run.start, run.end, a.advance(a.start(), run.start), a.advance(a.start(), run.end), run.arc});
    std::vector<std::size_t>& parts = m_followed_of[run.arc];
    parts.insert(first_beyond(parts, m_followed.back().from), m_followed.size() - 1);
  }

  // The first of the followed parts of an arc that starts beyond an advance.
  std::vector<std::size_t>::const_iterator first_beyond(const std::vector<std::size_t>& parts, const FT& advance) const
  {
    return std::upper_bound(parts.begin(), parts.end(), advance, [&](const FT& at, std::size_t f) {
      return at < m_followed[f].from;
    });
  }

  // Calls f(index) for the followed parts of arc i that may overlap the part from p to q, up to `tie`. Followed parts overlap
  // each other by at most `tie`, except those up to `error`.
  template <class Function>
  void for_each_followed(std::size_t i, const Point& p, const Point& q, const Function& f) const
  {
    const Arc& a = m_arcs[i];
    const std::vector<std::size_t>& parts = m_followed_of[i];
    if (parts.empty()) return;
    const FT margin = FT(2) * m_arcs.tolerances().tie, from = a.advance(a.start(), p) - margin;
    for (auto it = first_beyond(parts, FT(a.advance(a.start(), q) + margin)); it != parts.begin();)
    {
      const Followed& part = m_followed[*--it];
      f(*it);
      if (part.to < from && part.to - part.from > m_arcs.tolerances().error) return;
    }
  }

  bool is_followed(std::size_t i, const Point& p) const
  {
    const FT& tie = m_arcs.tolerances().tie;
    bool result = false;
    for_each_followed(i, p, p, [&](std::size_t f) {
      result =
        result || (!(m_arcs[i].advance(m_followed[f].start, p) < -tie) && !(m_arcs[i].advance(p, m_followed[f].end) < -tie));
    });
    return result;
  }

  // Index of the last followed part that the run overlaps, `none` if there is none. Where a chain changes arcs, it may go back
  // and forth by up to `tie`, so a run that starts this near to the end of a longer part does not count. A part of no extent,
  // where a chain starts and ends at one point, does not count.
  std::size_t followed_by(const Run& run) const
  {
    const Arc& a = m_arcs[run.arc];
    const FT &tie = m_arcs.tolerances().tie, &error = m_arcs.tolerances().error;
    std::size_t result = none;
    for_each_followed(run.arc, run.start, run.end, [&](std::size_t f) {
      const Point &start = m_followed[f].start, &end = m_followed[f].end;
      if (!(a.advance(start, end) > error) || (result != none && f < result)) return;
      const FT rest = a.advance(run.start, end);
      if (CGAL::is_positive(rest) && CGAL::is_positive(a.advance(start, run.end)) &&
          (rest > tie || !(a.advance(start, end) > FT(2) * tie)))
        result = f;
    });
    return result;
  }

  // True if the run lies in the second half of a part that chains of the cell follow. A loop that closes reaches the first half
  // of its first part.
  bool is_known_end(const Run& run) const
  {
    const Arc& a = m_arcs[run.arc];
    bool result = false;
    for_each_followed(run.arc, run.end, run.end, [&](std::size_t f) {
      const Point &start = m_followed[f].start, &end = m_followed[f].end;
      result =
        result || (a.advance(start, end) > FT(2) * run.length && CGAL::abs(a.advance(run.end, end)) <= m_arcs.tolerances().tie);
    });
    return result;
  }

  auto pieces_at(std::size_t i) const { return m_pieces.begin() + std::ptrdiff_t(i); }

  const Level_arcs<FT>& m_arcs;
  std::vector<typename Chains::Chain>& m_chains;
  std::vector<Piece>& m_pieces;
  const Cell* m_cell = nullptr;
  std::vector<char> m_is_used;                              // per gate of the cell: true if a chain ends there
  std::vector<std::pair<std::size_t, std::size_t>> m_gates; // arcs, each with a gate where chains end
  std::vector<std::size_t> m_arcs_of_cell;
  std::vector<Point> m_events; // on an arc
  std::vector<Followed> m_followed;
  std::vector<std::vector<std::size_t>> m_followed_of; // per arc, along the arc
};

} // namespace CGAL::Geodesic_offset::internal

#endif
