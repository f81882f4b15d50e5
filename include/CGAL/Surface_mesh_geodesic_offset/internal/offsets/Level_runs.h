// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One level inside one face: the arcs of its windows, and how far each can be followed along the boundary of
// { D < level }.
//
// A run follows an arc until its cone ends, until another window is nearer, or until it leaves the face through a gate.
// Another window takes over only once it is nearer by more than a rounding allowance, so windows that tie along a whole
// arc do not alternate. As the distance is continuous, a visible arc is left only where another arc passes: windows
// whose arcs are elsewhere need not be looked at.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_RUNS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_RUNS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Box_in_face.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_arc.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Window_cone.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A part of an arc.
template <class FT>
struct Level_run
{
  std::size_t arc = 0;
  FT from = FT(0), to = FT(0);
  Point_in_face<FT> start{FT(0), FT(0)}, end{FT(0), FT(0)};
  std::size_t gate = std::size_t(-1); // the one it ends at, if any
  bool valid = false;
  FT length = FT(0);
};

template <class FT>
class Level_runs
{
public:
  typedef Point_in_face<FT> Point;
  typedef Level_gate<FT> Gate;
  typedef Level_run<FT> Run;
  typedef Box_in_face<FT> Box;

  static constexpr std::size_t none = std::size_t(-1);

  // Levels between these two will be followed in the face of `field`.
  void set_face(const Face_field<FT>& field, const FT& lowest_level, const FT& highest_level)
  {
    m_field = &field;
    const Face_frame<FT>& frame = field.frame();
    for (int k = 0; k < 3; ++k)
    {
      const Point n = quarter_turn(frame.direction(k)); // inwards
      m_outside[k] = {n, dot(n, frame.corner(k))};
    }
    m_face_size = field.size();
    m_margin = FT(1e-5) * m_face_size;
    m_cones.clear();
    for (std::size_t i = 0; i < field.windows().size(); ++i)
    {
      const Face_window<FT>& w = field.windows()[i];
      if (w.is_empty()) continue;
      const FT bound = (std::max)(w.distance_at(w.left), w.distance_at(w.right)) + m_face_size + m_margin;
      if (field.lowest(i) < highest_level && bound >= lowest_level) m_cones.push_back({i, {w, frame, m_margin}});
    }
  }

  // `gates` must stay until the next call.
  void set_level(const FT& level, std::vector<Gate>& gates)
  {
    m_level = level;
    m_gates = &gates;
    const FT magnitude = m_face_size + level;
    m_cover_depth = Number_policy<FT>::rounding(256) * magnitude;
    m_tie = Number_policy<FT>::rounding(1 << 16) * magnitude;
    m_step = Number_policy<FT>::rounding(1 << 17) * m_face_size;
    m_refine = Number_policy<FT>::rounding(1 << 24) * magnitude;
    m_touch = FT(1e-6) * magnitude;
    m_arcs.clear();
    m_boxes.clear();
    for (const Cone& c : m_cones)
    {
      if (!(m_field->lowest(c.window) < level && c.cone.highest() >= level)) continue;
      const Level_arc<FT> arc(m_field->windows()[c.window], c.cone, level);
      const Box box = arc.box(m_margin);
      if (box.is_empty()) continue;
      m_arcs.push_back(arc);
      m_boxes.push_back(box);
    }
    m_boxes.build();
  }

  const Face_field<FT>& field() const { return *m_field; }
  const std::vector<Level_arc<FT>>& arcs() const { return m_arcs; }
  const Box_tree<FT>& boxes() const { return m_boxes; }
  const FT& level() const { return m_level; }
  const FT& face_size() const { return m_face_size; }
  // Distances up to which a point is on an arc.
  const FT& tie() const { return m_tie; }

  // Into the face, from its halfedge k.
  const Point& inwards(int k) const { return m_outside[k].n; }

  // How far inside the face p is.
  FT depth(const Point& p) const
  {
    return (std::min)({m_outside[0].value(p), m_outside[1].value(p), m_outside[2].value(p)});
  }

  // How far arc i can be followed from parameter t, at the point `start`.
  Run run_of(std::size_t i, const FT& t, const Point& start) const
  {
    const Level_arc<FT>& a = m_arcs[i];
    Run run;
    run.arc = i;
    run.start = start;
    run.from = t;
    run.to = FT(1);
    if (!(t < FT(1))) return run;
    // from the arc itself: where the last run was cut, the start lies inside by the allowance
    const Point foot = a.point(t);
    if (is_covered(i, foot + m_step * a.tangent(foot))) return run;
    run.end = a.end();
    for (int k = 0; k < 3; ++k)
    {
      Point p;
      if (!a.enter_half_plane(m_outside[k], p) || !a.is_ahead(p)) continue;
      const FT s = a.parameter(p);
      if (!(s < run.to)) continue;
      // an exit just behind the start belongs to an arc that only touches the edge
      if (!(s > t) && length(p - start) > m_step) continue;
      const std::size_t gate = gate_near(p, FT(1e-6) * m_face_size);
      if (gate == none) continue;
      run.to = (std::max)(s, t);
      run.end = (*m_gates)[gate].point;
      run.gate = gate;
    }
    Box box(start);
    box.add(run.end);
    if (!a.is_straight()) box.widen(length(run.end - start)); // less than a half turn
    box.intersect(m_boxes[i]);
    m_near.clear();
    m_boxes.any_of(box, [&](std::size_t j) {
      if (j == i) return false;
      cut_by(j, run);
      m_near.push_back(j);
      return false;
    });
    run.length = length(run.end - start);
    run.valid = (run.gate != none || run.length > m_step) && !goes_under_near_arcs(run);
    return run;
  }

  // Of all arcs that pass p, the one that can be followed farthest; one that goes back only if there is no other: where both
  // sides of a narrow strip are as near to each other as rounding, each of them passes all points of the other one.
  // `heading`, a unit vector, is where the chain comes from the last arc, or into the face. A gate that is waiting for its
  // arc may be served by one that rounding has moved farther away, and the end of a narrow strip may be too short to be
  // followed.
  Run best_run(const Point& p, std::size_t without, bool to_gate, const Point& heading) const
  {
    Run best;
    bool best_goes_back = false;
    const FT last_tie = to_gate ? FT(m_tie * FT(65536)) : (std::max)(m_tie, FT(m_step * FT(4)));
    for (FT tie = m_tie;; tie = (std::min)(FT(tie * FT(256)), last_tie))
    {
      m_boxes.any_of(Box(p), [&](std::size_t i) {
        if (i == without) return false;
        const Level_arc<FT>& a = m_arcs[i];
        if (CGAL::abs(a.excess(p)) > tie || a.outside_cone(p) > tie || !a.is_ahead(p)) return false;
        const bool goes_back = dot(a.tangent(p), heading) < (without == none ? FT(-1e-6) : FT(-0.5));
        const Point start = goes_back && without != none ? cusp(without, i, p) : p;
        const Run run = run_of(i, (std::max)(FT(0), a.parameter(start)), start);
        if (!run.valid) return false;
        if (!best.valid || (goes_back == best_goes_back ? run.length > best.length : best_goes_back))
        {
          best = run;
          best_goes_back = goes_back;
        }
        return false;
      });
      if (best.valid || !(tie < last_tie)) return best;
    }
  }

  // The joint of an arc and the next one, found where the next one was nearer by the allowance, moved to where both tie.
  // Arcs that touch tie to rounding over a long way: there the end of a cone, where the joint is, says more.
  void refine_joint(std::size_t last, std::size_t next, Point& p) const
  {
    const Level_arc<FT>&a = m_arcs[last], &b = m_arcs[next];
    if (CGAL::abs(cross(a.tangent(p), b.tangent(p))) < FT(1e-4)) return;
    Point q;
    if (!meet(a, b, false, q)) return;
    if (length(q - p) <= m_refine && a.outside_cone(q) <= m_tie && b.outside_cone(q) <= m_tie) p = q;
  }

  // Where the circle or line of a enters, or leaves, what is nearer in b.
  static bool meet(const Level_arc<FT>& a, const Level_arc<FT>& b, bool leave, Point& p)
  {
    if (!b.is_straight()) return a.meet_disk(b.image(), b.radius(), leave, p);
    const Half_plane<FT> nearer{b.forward(), b.radius()};
    return a.enter_half_plane(leave ? nearer.opposite() : nearer, p);
  }

  // The nearest gate that still waits for the end of a chain.
  std::size_t gate_near(const Point& p, FT limit) const
  {
    std::size_t best = none;
    for (std::size_t i = 0; i < m_gates->size(); ++i)
    {
      const Gate& g = (*m_gates)[i];
      if (g.is_start || g.id == no_index) continue;
      const FT d = length(g.point - p);
      if (d <= limit)
      {
        limit = d;
        best = i;
      }
    }
    return best;
  }

private:
  struct Cone
  {
    std::size_t window;
    Window_cone<FT> cone;
  };

  // Where the level turns back from an arc to the next one, found at p, where the next one was nearer by the allowance. If
  // they touch, that is so far behind the point where they tie that the next one is hidden there.
  Point cusp(std::size_t last, std::size_t next, const Point& p) const
  {
    Point q;
    const bool meets = meet(m_arcs[last], m_arcs[next], false, q) && length(q - p) <= m_touch &&
                       m_arcs[last].outside_cone(q) <= m_tie && m_arcs[next].outside_cone(q) <= m_tie;
    return meets ? q : p;
  }

  // Is p nearer to window j than the level, by more than the allowance, and in its cone?
  bool covers(std::size_t j, const Point& p) const
  {
    const Level_arc<FT>& b = m_arcs[j];
    return b.excess(p) < -m_cover_depth && b.outside_cone(p) < FT(0);
  }

  bool is_covered(std::size_t i, const Point& p) const
  {
    return m_boxes.any_of(Box(p), [&](std::size_t j) { return j != i && covers(j, p); });
  }

  // Another arc that touches the run's may go under it so closely that neither its entry nor the step ahead has shown it:
  // further along it does.
  bool goes_under_near_arcs(const Run& run) const
  {
    if (m_near.empty()) return false;
    const Level_arc<FT>& a = m_arcs[run.arc];
    const Point middle = a.point(run.from + (run.to - run.from) / 2), early = a.point(run.from + (run.to - run.from) / 16);
    return std::any_of(m_near.begin(), m_near.end(), [&](std::size_t j) { return covers(j, middle) || covers(j, early); });
  }

  // The first point after `from`, before run.to, where the run's arc is covered by window j: shortens the run.
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
    Point q = p + m_step * a.tangent(p);
    const Level_arc<FT>& b = m_arcs[j];
    if constexpr (!Number_policy<FT>::is_inexact) // where they touch, only farther along is it seen which one is nearer
      if (CGAL::is_zero(b.excess(p)) && entered != 0) q = a.point(FT(t + (FT(1) - t) / FT(1 << 16)));
    if (entered != 0 && !(b.excess(q) < -m_cover_depth)) return;
    if (entered != 1 && !(b.left().value(q) < FT(0))) return;
    if (entered != 2 && !(b.right().value(q) < FT(0))) return;
    if (b.is_straight() && !b.window().is_in_front(q)) return;
    run.to = t;
    run.end = p;
    run.gate = none;
  }

  const Face_field<FT>* m_field = nullptr;
  FT m_level, m_face_size, m_margin;
  FT m_cover_depth, m_tie, m_step, m_refine, m_touch;
  std::vector<Cone> m_cones;         // of the windows that can have a level
  std::vector<Level_arc<FT>> m_arcs; // of the level
  Box_tree<FT> m_boxes;              // theirs
  Half_plane<FT> m_outside[3];       // positive inside
  mutable std::vector<std::size_t> m_near; // the arcs whose boxes the last run meets
  std::vector<Gate>* m_gates = nullptr;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
