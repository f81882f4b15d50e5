// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One level inside one face: walks along the boundary of { D < level } from arc to arc.
//
// The walk follows an arc until its cone ends, until another window is nearer, or until it leaves the face at one of the
// crossings found on the edges. There, of all windows that give the level at this point, the one whose arc remains the
// nearest for longest goes on. A window takes over only once it is nearer by more than a rounding allowance, so windows
// that tie along a whole arc do not alternate.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_LEVEL_TRACER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_LEVEL_TRACER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Level_arc.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_extent.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Level_tracer
{
public:
  typedef Point_in_face<FT> Point;
  typedef Level_piece<FT> Piece;
  typedef Level_gate<FT> Gate;

  struct Chain
  {
    Index start, end; // gates; no_index for a loop
    std::vector<Piece> pieces;
  };

  // The face to be cut.
  void set_face(const Face_field<FT>& field)
  {
    m_field = &field;
    const Face_frame<FT>& frame = field.frame();
    for (int k = 0; k < 3; ++k)
    {
      const Point n = quarter_turn(frame.direction(k)); // inwards
      m_outside[k] = {n, dot(n, frame.corner(k))};
    }
    m_face_size = (std::max)({frame.edge_length(0), frame.edge_length(1), frame.edge_length(2)});
    m_extents.clear();
    for (const Face_window<FT>& w : field.windows()) m_extents.push_back(extent_of(w, frame, FT(1e-5) * m_face_size));
  }

  // Chains of pieces that connect all gates, and all loops. Appends to `chains`.
  //
  // Only windows that the level passes through take part: the distance is continuous, so a visible arc ends where another
  // window gives the level, too, never at one that is nearer all over.
  void operator()(const FT& level, const std::vector<Gate>& gates, bool search_loops,
                  std::vector<Chain>& chains)
  {
    m_level = level;
    m_arcs.clear();
    m_boxes.clear();
    const Face_field<FT>& field = *m_field;
    for (std::size_t i = 0; i < field.windows().size(); ++i)
      if (field.lowest(i) < level && m_extents[i].highest >= level)
      {
        m_arcs.emplace_back(field.windows()[i], level);
        m_boxes.push_back(m_extents[i].box);
      }
    const FT magnitude = m_face_size + level;
    m_cover_depth = Number_policy<FT>::rounding(256) * magnitude;
    m_tie = Number_policy<FT>::rounding(1 << 16) * magnitude;
    m_step = Number_policy<FT>::rounding(1 << 17) * m_face_size;
    m_refine = Number_policy<FT>::rounding(1 << 24) * magnitude;
    m_point = Number_policy<FT>::rounding(1 << 12) * magnitude;
    m_gates = gates;
    m_traversed.clear();
    for (std::size_t i = 0; i < m_gates.size(); ++i)
      if (m_gates[i].is_start) trace_from_gate(i, chains);
    if (search_loops) trace_loops(chains);
  }

  std::size_t number_of_forced_joints() const { return m_forced; }

private:
  struct Run
  {
    std::size_t arc = 0;
    FT from = FT(0), to = FT(0);
    Point end;
    std::size_t gate = std::size_t(-1); // reached
    bool valid = false;
    FT length = FT(0);
  };
  struct Traversed
  {
    std::size_t arc;
    FT from, to;
  };

  Point clamp_point(const Level_arc<FT>& a, const FT& t) const { return a.point(t < FT(0) ? FT(0) : t > FT(1) ? FT(1) : t); }

  // Is p nearer to window j than the level, by more than the allowance, and in its cone?
  bool covers(std::size_t j, const Point& p) const
  {
    const Level_arc<FT>& b = m_arcs[j];
    return b.excess(p) < -m_cover_depth && b.outside_cone(p) < FT(0);
  }

  // The first point after `from`, before run.to, where arc i is covered by window j: shortens the run.
  void cut_by(std::size_t j, Run& run) const
  {
    const Level_arc<FT>& a = m_arcs[run.arc];
    const Level_arc<FT>& b = m_arcs[j];
    const FT radius = b.radius() - m_cover_depth;
    Point p;
    if (b.is_straight())
    {
      const Half_plane<FT> near{b.forward(), radius};
      if (a.enter_half_plane(near, p)) consider(p, j, 0, run);
    }
    else
    {
      if (!CGAL::is_positive(radius)) return;
      if (!a.is_straight())
      { // circles that are apart
        const Point u = b.image() - a.image();
        const FT sum = a.radius() + radius;
        if (dot(u, u) >= sum * sum) return;
      }
      if (a.meet_disk(b.image(), radius, false, p)) consider(p, j, 0, run);
    }
    if (a.enter_half_plane(b.left(), p)) consider(p, j, 1, run);
    if (a.enter_half_plane(b.right(), p)) consider(p, j, 2, run);
  }

  // p: a point of the circle of run.arc that enters the disk (0), the side of the left ray (1) or of the right ray (2) of
  // window j. Just behind it, are the other conditions met, too?
  void consider(const Point& p, std::size_t j, int entered, Run& run) const
  {
    const Level_arc<FT>& a = m_arcs[run.arc];
    if (!a.is_ahead(p)) return;
    const FT t = a.parameter(p);
    if (!(t > run.from && t < run.to)) return;
    const Point q = p + m_step * a.tangent(p);
    const Level_arc<FT>& b = m_arcs[j];
    if (entered != 0 && !(b.excess(q) < -m_cover_depth)) return;
    if (entered != 1 && !(b.left().value(q) < FT(0))) return;
    if (entered != 2 && !(b.right().value(q) < FT(0))) return;
    if (b.is_straight() && !b.window().is_in_front(q)) return;
    run.to = t;
    run.end = p;
    run.gate = std::size_t(-1);
  }

  // How far arc i can be followed from parameter t.
  Run run_of(std::size_t i, const FT& t, const Point& start) const
  {
    const Level_arc<FT>& a = m_arcs[i];
    Run run;
    run.arc = i;
    run.from = t;
    run.to = FT(1);
    if (!(t < FT(1))) return run;
    if (is_covered(i, start + m_step * a.tangent(start))) return run;
    run.end = a.point(FT(1));
    for (int k = 0; k < 3; ++k)
    {
      Point p;
      if (!a.enter_half_plane(m_outside[k], p) || !a.is_ahead(p)) continue;
      const FT s = a.parameter(p);
      if (!(s < run.to)) continue;
      // an exit just behind the start belongs to an arc that only touches the edge
      if (!(s > t) && length(p - start) > m_step) continue;
      const std::size_t gate = gate_near(p, false, FT(1e-6) * m_face_size);
      if (gate == std::size_t(-1)) continue;
      run.to = (std::max)(s, t);
      run.end = m_gates[gate].point;
      run.gate = gate;
    }
    Box_in_face<FT> box(start);
    box.add(run.end);
    if (!a.is_straight()) box.widen(length(run.end - start)); // less than a half turn
    box.intersect(m_boxes[i]);
    for (std::size_t j = 0; j < m_arcs.size(); ++j)
      if (j != i && m_boxes[j].meets(box)) cut_by(j, run);
    run.length = length(run.end - start);
    run.valid = run.gate != std::size_t(-1) || run.length > m_step;
    // Another arc that touches this one at the start may have come out from under it, or go under it, so closely that
    // neither its entry nor the step ahead has shown it: further along it does.
    if (run.valid && (is_covered(i, a.point(run.from + (run.to - run.from) / 2)) ||
                      is_covered(i, a.point(run.from + (run.to - run.from) / 16))))
      run.valid = false;
    return run;
  }

  bool is_covered(std::size_t i, const Point& p) const
  {
    for (std::size_t j = 0; j < m_arcs.size(); ++j)
      if (j != i && m_boxes[j].contains(p) && covers(j, p)) return true;
    return false;
  }

  std::size_t gate_near(const Point& p, bool start, FT limit) const
  {
    std::size_t best = std::size_t(-1);
    for (std::size_t i = 0; i < m_gates.size(); ++i)
    {
      if (m_gates[i].is_start != start || m_gates[i].id == no_index) continue;
      const FT d = length(m_gates[i].point - p);
      if (d <= limit)
      {
        limit = d;
        best = i;
      }
    }
    return best;
  }

  // Of all windows that give the level at p, the one to be followed. A gate that is waiting for its arc may be served by
  // one that rounding has moved farther away.
  Run best_run(const Point& p, std::size_t without, bool to_gate) const
  {
    Run best;
    for (FT tie = m_tie; tie <= (to_gate ? FT(m_tie * FT(65536)) : m_tie); tie *= FT(256))
    {
      for (std::size_t i = 0; i < m_arcs.size(); ++i)
      {
        if (i == without || !m_boxes[i].contains(p)) continue;
        const Level_arc<FT>& a = m_arcs[i];
        if (CGAL::abs(a.excess(p)) > tie || a.outside_cone(p) > tie) continue;
        FT t = a.parameter(p);
        if (t < FT(0)) t = FT(0);
        const Run run = run_of(i, t, p);
        if (run.valid && (!best.valid || run.length > best.length)) best = run;
      }
      if (best.valid || Number_policy<FT>::rounding(1) == FT(0)) break;
    }
    return best;
  }

  // The joint of an arc and the next one, found where the next one was nearer by the allowance, moved to where both tie.
  void refine_joint(std::size_t last, std::size_t next, Point& p) const
  {
    const Level_arc<FT>&a = m_arcs[last], &b = m_arcs[next];
    Point q;
    const bool meets = b.is_straight() ? a.enter_half_plane(Half_plane<FT>{b.forward(), b.radius()}, q)
                                       : a.meet_disk(b.image(), b.radius(), false, q);
    if (meets && length(q - p) <= m_refine && a.outside_cone(q) <= m_tie && b.outside_cone(q) <= m_tie) p = q;
  }

  void add_piece(const Run& run, const Point& start, Chain& chain)
  {
    const Face_window<FT>& w = m_arcs[run.arc].window();
    m_traversed.push_back({run.arc, run.from, run.to});
    const Index pseudo_source = (w.bits >> 2) - 1;
    chain.pieces.push_back(Piece{m_field->face(), w.is_parallel(),
                                 w.is_parallel() ? m_arcs[run.arc].forward() : w.image(), m_arcs[run.arc].radius(), start,
                                 run.end, w.root, (w.bits >> 2) == 0 ? no_index : pseudo_source, 3, 3});
  }

  void trace_from_gate(std::size_t gate, std::vector<Chain>& chains)
  {
    Chain chain{m_gates[gate].id, no_index, {}};
    Point p = m_gates[gate].point;
    std::size_t arc = std::size_t(-1);
    for (std::size_t guard = 0; guard < 4 * m_arcs.size() + 16; ++guard)
    {
      const Run run = best_run(p, arc, true);
      if (!run.valid) break;
      if (!chain.pieces.empty())
      {
        refine_joint(arc, run.arc, p);
        chain.pieces.back().end = p;
      }
      add_piece(run, p, chain);
      p = run.end;
      arc = run.arc;
      if (run.gate != std::size_t(-1))
      {
        finish(chain, gate, run.gate, chains);
        return;
      }
    }
    force_end(chain, p, gate, chains);
  }

  // Pieces without extent go; their ends stay, with the neighbours.
  void drop_points(std::vector<Piece>& pieces) const
  {
    std::size_t n = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      if (length(pieces[i].end - pieces[i].start) > m_point || (n == 0 && i + 1 == pieces.size()))
        pieces[n++] = pieces[i];
      else if (n > 0)
        pieces[n - 1].end = pieces[i].end;
      else
        pieces[i + 1].start = pieces[i].start;
    }
    pieces.resize(n);
  }

  void finish(Chain& chain, std::size_t start, std::size_t end, std::vector<Chain>& chains)
  {
    drop_points(chain.pieces);
    chain.end = m_gates[end].id;
    m_gates[end].id = no_index; // used
    chain.pieces.front().start_edge = m_gates[start].edge;
    chain.pieces.back().end_edge = m_gates[end].edge;
    chains.push_back(chain);
  }

  // No arc could be followed up to a gate. The nearest gate left takes the chain; if it is farther than rounding
  // explains, this is counted.
  void force_end(Chain& chain, const Point& p, std::size_t start, std::vector<Chain>& chains)
  {
    const std::size_t gate = gate_near(p, false, Number_policy<FT>::infinity());
    if (gate == std::size_t(-1)) return;
    const Point end = m_gates[gate].point;
    const FT gap = length(end - p);
    if (gap > FT(1e-7) * m_face_size) ++m_forced;
    if (chain.pieces.empty())
    {
      std::size_t nearest = 0;
      m_field->distance(p, nearest);
      const Face_window<FT>& w = m_field->windows()[nearest];
      const FT norm = length(end - p);
      const Point u = CGAL::is_positive(norm) ? (FT(1) / norm) * (end - p) : Point{FT(1), FT(0)};
      const Point n = {u.y, -u.x};
      chain.pieces.push_back(Piece{m_field->face(), true, n, dot(n, p), p, end, w.root,
                                   (w.bits >> 2) == 0 ? no_index : Index((w.bits >> 2) - 1), 3, 3});
    }
    else
      chain.pieces.back().end = end;
    finish(chain, start, gate, chains);
  }

  // Loops that touch no edge. Each has a point where an arc comes out from under another window.
  void trace_loops(std::vector<Chain>& chains)
  {
    for (std::size_t i = 0; i < m_arcs.size(); ++i)
    {
      const Level_arc<FT>& a = m_arcs[i];
      try_loop(i, FT(0), a.point(FT(0)), chains);
      for (std::size_t j = 0; j < m_arcs.size(); ++j)
      {
        if (i == j || !m_boxes[i].meets(m_boxes[j])) continue;
        const Level_arc<FT>& b = m_arcs[j];
        Point p;
        const bool meets = b.is_straight()
                             ? a.enter_half_plane(Half_plane<FT>{b.forward(), b.radius()}.opposite(), p)
                             : a.meet_disk(b.image(), b.radius(), true, p);
        // the joint of two arcs of a loop lies on both
        if (meets && m_boxes[i].contains(p) && m_boxes[j].contains(p) && a.is_ahead(p) && a.outside_cone(p) <= m_tie &&
            b.outside_cone(p) <= m_tie)
          try_loop(i, a.parameter(p), p, chains);
      }
    }
  }

  bool is_traversed(std::size_t arc, const FT& t) const
  {
    for (const Traversed& v : m_traversed)
      if (v.arc == arc && v.from - FT(1e-7) <= t && t < v.to + FT(1e-7)) return true;
    return false;
  }

  void try_loop(std::size_t i, const FT& t, const Point& start, std::vector<Chain>& chains)
  {
    if (!(t >= FT(0) && t < FT(1)) || is_traversed(i, t)) return;
    for (int k = 0; k < 3; ++k)
      if (m_outside[k].value(start) < m_tie) return;
    // a loop may lie hidden under windows that the level does not pass through
    std::size_t nearest;
    if (m_field->distance(start, nearest) < m_level - m_tie) return;
    Run run = run_of(i, t, start);
    const std::size_t mark = m_traversed.size();
    Chain chain{no_index, no_index, {}};
    Point p = start;
    bool closed = false;
    std::size_t last_arc = i;
    for (std::size_t guard = 0; guard < 4 * m_arcs.size() + 16 && run.valid && run.gate == std::size_t(-1); ++guard)
    {
      if (guard > 0 && run.arc == i && run.from <= t && t <= run.to)
      { // back on the first arc
        run.end = start;
        closed = true;
      }
      if (!chain.pieces.empty() && last_arc != run.arc)
      {
        refine_joint(last_arc, run.arc, p);
        chain.pieces.back().end = p;
      }
      last_arc = run.arc;
      add_piece(run, p, chain);
      p = run.end;
      if (guard > 0 && length(p - start) <= m_tie) closed = true;
      if (closed || (std::min)({m_outside[0].value(p), m_outside[1].value(p), m_outside[2].value(p)}) < -m_tie) break;
      run = best_run(p, run.arc, false);
    }
    // what is left between a gate and an arc that rounding has moved off it is no loop
    FT sum(0);
    for (const Piece& q : chain.pieces) sum += length(q.end - q.start);
    if (closed && sum > FT(1e-6) * (std::min)(m_face_size, m_level))
    {
      chain.pieces.back().end = start;
      drop_points(chain.pieces);
      chains.push_back(chain);
    }
    else
      m_traversed.resize(mark);
  }

  const Face_field<FT>* m_field = nullptr;
  FT m_level, m_face_size, m_cover_depth, m_tie, m_step, m_refine, m_point;
  std::vector<Window_extent<FT>> m_extents; // of the face's windows
  std::vector<Level_arc<FT>> m_arcs;        // of the level
  std::vector<Box_in_face<FT>> m_boxes;
  Half_plane<FT> m_outside[3];
  std::vector<Gate> m_gates;
  std::vector<Traversed> m_traversed;
  std::size_t m_forced = 0;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
