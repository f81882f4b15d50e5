// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One level inside one face: chains of runs from gate to gate, and loops.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_TRACER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_TRACER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_runs.h>

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

  // The face to be cut, and bounds of the levels.
  void set_face(const Face_field<FT>& field, const FT& lowest, const FT& highest)
  {
    m_runs.set_face(field, lowest, highest);
  }

  // Calls out(start gate, end gate, pieces) for the chains of pieces that connect all gates, and with no_index for all
  // loops.
  template <class Function>
  void operator()(const FT& level, std::vector<Gate>& gates, bool search_loops, const Function& out)
  {
    m_gates = &gates;
    m_runs.set_level(level, gates);
    m_point = Number_policy<FT>::rounding(1 << 12) * (m_runs.face_size() + level);
    m_traversed.clear();
    m_last_traversed.assign(m_runs.arcs().size(), none);
    for (std::size_t i = 0; i < gates.size(); ++i)
      if (gates[i].is_start) trace_from_gate(i, out);
    if (search_loops) trace_loops(out);
  }

  std::size_t number_of_forced_joints() const { return m_forced; }

private:
  typedef Level_run<FT> Run;

  static constexpr std::size_t none = std::size_t(-1);

  struct Traversed
  {
    FT from, to;
    std::size_t previous; // of the same arc
  };

  void add_piece(const Run& run, const Point& start)
  {
    m_traversed.push_back({run.from, run.to, m_last_traversed[run.arc]});
    m_last_traversed[run.arc] = m_traversed.size() - 1;
    const Level_arc<FT>& a = m_runs.arcs()[run.arc];
    const Face_window<FT>& w = a.window();
    m_chain.push_back(Piece{w.is_parallel() ? a.forward() : w.image(), a.radius(), start, run.end,
                            m_runs.field().face(), w.root, w.pseudo_source(), w.is_parallel(), 3, 3});
  }

  bool is_traversed(std::size_t arc, const FT& t) const
  {
    for (std::size_t i = m_last_traversed[arc]; i != none; i = m_traversed[i].previous)
      if (m_traversed[i].from - FT(1e-7) <= t && t < m_traversed[i].to + FT(1e-7)) return true;
    return false;
  }

  // The number of the part of the run's arc that was followed before and that the run goes along; none if there is none.
  std::size_t traversed_by(const Run& run) const
  {
    const FT slack(1e-7);
    for (std::size_t i = m_last_traversed[run.arc]; i != none; i = m_traversed[i].previous)
      if (run.from + slack < m_traversed[i].to && m_traversed[i].from + slack < run.to) return i;
    return none;
  }

  template <class Function>
  void trace_from_gate(std::size_t gate, const Function& out)
  {
    m_chain.clear();
    Point p = (*m_gates)[gate].point;
    std::size_t arc = none;
    for (std::size_t guard = 0; guard < 4 * m_runs.arcs().size() + 16; ++guard)
    {
      const Point heading = arc == none ? m_runs.inwards((*m_gates)[gate].edge) : m_runs.arcs()[arc].tangent(p);
      const Run run = m_runs.best_run(p, arc, true, heading);
      if (!run.valid) break;
      p = run.start;
      if (!m_chain.empty())
      {
        m_runs.refine_joint(arc, run.arc, p);
        m_chain.back().end = p;
      }
      add_piece(run, p);
      p = run.end;
      arc = run.arc;
      // where two arcs tie right at a gate, the run ends at their joint
      const std::size_t end = run.gate != none ? run.gate : m_runs.gate_near(p, m_runs.tie());
      if (end != none)
      {
        m_chain.back().end = (*m_gates)[end].point;
        finish(gate, end, out);
        return;
      }
    }
    force_end(p, gate, out);
  }

  // Pieces without extent go; their ends stay, with the neighbours.
  void drop_points()
  {
    std::size_t n = 0;
    for (std::size_t i = 0; i < m_chain.size(); ++i)
    {
      if (length(m_chain[i].end - m_chain[i].start) > m_point || (n == 0 && i + 1 == m_chain.size()))
        m_chain[n++] = m_chain[i];
      else if (n > 0)
        m_chain[n - 1].end = m_chain[i].end;
      else
        m_chain[i + 1].start = m_chain[i].start;
    }
    m_chain.resize(n);
  }

  template <class Function>
  void finish(std::size_t start, std::size_t end, const Function& out)
  {
    drop_points();
    Gate& last = (*m_gates)[end];
    m_chain.front().start_edge = (*m_gates)[start].edge;
    m_chain.back().end_edge = last.edge;
    out((*m_gates)[start].id, last.id, m_chain);
    last.id = no_index; // used
  }

  // No arc could be followed up to a gate. The nearest gate left takes the chain; if it is farther than rounding
  // explains, this is counted.
  template <class Function>
  void force_end(const Point& p, std::size_t start, const Function& out)
  {
    const std::size_t gate = m_runs.gate_near(p, Number_policy<FT>::infinity());
    if (gate == none) return;
    const Point end = (*m_gates)[gate].point;
    const FT gap = length(end - p);
    if (gap > FT(1e-7) * m_runs.face_size()) ++m_forced;
    if (m_chain.empty())
    {
      std::size_t nearest = 0;
      m_runs.field().distance(p, nearest);
      const Face_window<FT>& w = m_runs.field().windows()[nearest];
      m_chain.push_back(Piece{w.is_parallel() ? FT(-1) * w.image() : w.image(), m_runs.level() - w.sigma, p, end,
                              m_runs.field().face(), w.root, w.pseudo_source(), w.is_parallel(), 3, 3});
    }
    else
      m_chain.back().end = end;
    finish(start, gate, out);
  }

  // Loops that touch no edge lie round a source inside the face, or round a place where the distance is largest. In the
  // latter case all arcs bulge inwards, so the loop has corners, where one arc comes out from under another.
  template <class Function>
  void trace_loops(const Function& out)
  {
    for (std::size_t i = 0; i < m_runs.arcs().size(); ++i)
    {
      const Level_arc<FT>& a = m_runs.arcs()[i];
      if (a.window().origin == STARTS_IN_FACE) try_loop(i, FT(0), a.start(), out);
      m_runs.boxes().any_of(m_runs.boxes()[i], [&](std::size_t j) {
        const Level_arc<FT>& b = m_runs.arcs()[j];
        Point p;
        if (i != j && m_runs.meet(a, b, true, p) && a.is_ahead(p) && a.outside_cone(p) <= m_runs.tie() &&
            b.outside_cone(p) <= m_runs.tie() && cross(b.tangent(p), a.tangent(p)) < FT(-1e-7))
          try_loop(i, a.parameter(p), p, out);
        return false;
      });
    }
  }

  template <class Function>
  void try_loop(std::size_t i, const FT& t, const Point& start, const Function& out)
  {
    if (!(t >= FT(0) && t < FT(1)) || is_traversed(i, t) || m_runs.depth(start) < m_runs.tie()) return;
    // a loop may lie hidden under windows that the level does not pass through
    std::size_t nearest;
    if (m_runs.field().distance(start, nearest) < m_runs.level() - m_runs.tie()) return;
    Run run = m_runs.run_of(i, t, start);
    const std::size_t own = m_traversed.size();
    m_chain.clear();
    Point p = start;
    bool closed = false;
    std::size_t last_arc = i;
    while (run.valid && run.gate == none)
    {
      const std::size_t known = traversed_by(run);
      // what another chain, or an attempt in vain, has followed leads to no other end
      if (known != none && known < own) break;
      p = run.start;
      if (!m_chain.empty() && last_arc != run.arc) m_runs.refine_joint(last_arc, run.arc, p);
      if (!m_chain.empty()) m_chain.back().end = p;
      if (known != none)
      { // back on this chain, maybe behind where it started
        m_chain.erase(m_chain.begin(), m_chain.begin() + std::ptrdiff_t(known - own));
        m_chain.front().start = p;
        closed = true;
        break;
      }
      last_arc = run.arc;
      add_piece(run, p);
      p = run.end;
      if (m_chain.size() > 1 && length(p - start) <= m_runs.tie())
      {
        m_chain.back().end = start;
        closed = true;
      }
      if (closed || m_runs.depth(p) < -m_runs.tie()) break;
      run = m_runs.best_run(p, run.arc, false, m_runs.arcs()[run.arc].tangent(p));
    }
    // what is left between a gate and an arc that rounding has moved off it is no loop
    FT sum(0);
    for (const Piece& q : m_chain) sum += length(q.end - q.start);
    if (!closed || !(sum > FT(1e-6) * (std::min)(m_runs.face_size(), m_runs.level()))) return;
    drop_points();
    out(no_index, no_index, m_chain);
  }

  Level_runs<FT> m_runs;
  std::vector<Gate>* m_gates = nullptr;
  FT m_point;                 // pieces up to this length are points
  std::vector<Piece> m_chain; // being traced
  std::vector<Traversed> m_traversed;
  std::vector<std::size_t> m_last_traversed; // of each arc
  std::size_t m_forced = 0;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
