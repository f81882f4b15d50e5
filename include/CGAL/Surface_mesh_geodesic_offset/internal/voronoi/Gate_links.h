// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fallback for a cell (Voronoi_cell.h) in which rounding makes the bisectors inconsistent: connects its gates by arcs, and verifies
// the arcs by distances. A gate is a point of the border of the cell where the nearest source changes; the label of a part is the
// nearest source.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_GATE_LINKS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_GATE_LINKS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_arc.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_cell.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_tolerances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_window.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Where rounding decides which windows are nearest, the intervals of bisectors may contradict each other. The distances
// themselves do not: from each source, the least path length through a window of the cell is a continuous function. So gates
// between the same sources are connected by a curve along which the functions of both sources are equal, and no other function is
// smaller.
template <class NT>
class Gate_links
{
public:
  typedef Point_in_face<NT> Point;

  // The tolerances may change between calls.
  Gate_links(const std::vector<Voronoi_window<NT>>& windows, const Voronoi_tolerances<NT>& tolerances,
             const Voronoi_cell<NT>& face)
    : m_windows(windows), m_tolerances(tolerances), m_face(face)
  {
  }

  // Connects the gates, and passes the arcs to out(arc). new_node(): the number of a new node, where several arcs meet. Returns
  // false, without output, if two sources do not tie along an arc, or if one of the arcs `found`, bisectors of pairs of
  // windows, coincides with none of the arcs. A cell without gates must have one nearest source, at its center and at six
  // points around the center.
  template <class New_node, class OutputFunction>
  bool connect(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates,
               const std::vector<Bisector_arc<NT>>& found, const New_node& new_node, const OutputFunction& out)
  {
    m_candidates = &candidates;
    m_arcs.clear();
    if (cell.gates.empty()) return is_of_one_source(cell) && coincide_with_links(found);
    for (const Pairing pairing : {ACROSS, FROM_FIRST, FROM_SECOND})
    {
      pair_up(cell, pairing);
      if (!std::all_of(m_arcs.begin(), m_arcs.end(), [&](Bisector_arc<NT>& a) {
            return this->make_conic(a) || this->is_bisector(a, m_tolerances.of_link());
          }))
        continue;
      if (!coincide_with_links(found)) continue;
      write(new_node, out);
      return true;
    }
    return false;
  }

  // Connects the gates with straight links, without testing distances.
  template <class New_node, class OutputFunction>
  void connect_straight(const Voronoi_cell<NT>& cell, const New_node& new_node, const OutputFunction& out)
  {
    pair_up(cell, ACROSS);
    write(new_node, out);
  }

  // True if the distances from both sources tie along an arc whose ends were moved to a common point with others, and no other
  // source is nearer. `is_wide`: the ends were farther apart than a joint, and were joined only because they may meet; the
  // tolerance is larger then. Otherwise an arc along a side of the face counts as true, as windows of the neighbouring face may
  // decide there.
  bool is_verified(const Bisector_arc<NT>& arc, const std::vector<unsigned>& candidates, bool is_wide)
  {
    m_candidates = &candidates;
    if (is_wide) return is_bisector(arc, m_tolerances.of_wide_joint());
    return is_on_side(arc) || is_bisector(arc, m_tolerances.of_loose_joint());
  }

  // The straight arc from a gate to another one.
  static Bisector_arc<NT> link(const Voronoi_gate<NT>& from, const Voronoi_gate<NT>& to)
  {
    Bisector_arc<NT> arc = Bisector_arc<NT>::link(from.point, to.point, from.from, from.to);
    arc.start_node = from.node;
    arc.end_node = to.node;
    return arc;
  }

private:
  // Matching of gates as of brackets, in counterclockwise order. ACROSS: only gates of different sides match, so that curves
  // beside each other stay so. FROM_FIRST, FROM_SECOND: neighbours match, beginning with the first or the second gate.
  enum Pairing { ACROSS, FROM_FIRST, FROM_SECOND };

  // Makes straight links: between matched gates, and from all other gates to one common end.
  void pair_up(const Voronoi_cell<NT>& cell, Pairing pairing)
  {
    m_arcs.clear();
    std::vector<const Voronoi_gate<NT>*> open;
    for (std::size_t i = 0; i < cell.gates.size(); ++i)
    {
      const Voronoi_gate<NT>& g = cell.gates[(i + (pairing == FROM_SECOND ? 1 : 0)) % cell.gates.size()];
      if (!open.empty() && open.back()->from == g.to && (pairing != ACROSS || open.back()->side != g.side))
      {
        m_arcs.push_back(link(*open.back(), g));
        open.pop_back();
      }
      else open.push_back(&g);
    }
    std::size_t begin = 0; // the order is cyclic: the last open gates may match the first ones
    while (open.size() >= begin + 2 && open.back()->from == open[begin]->to && open.back()->to == open[begin]->from)
    {
      m_arcs.push_back(link(*open.back(), *open[begin++]));
      open.pop_back();
    }
    const Point common = common_end(open.data() + begin, open.data() + open.size());
    for (std::size_t i = begin; i < open.size(); ++i)
    {
      m_arcs.push_back(link(*open[i], *open[i]));
      m_arcs.back().end_node = no_index;
      m_arcs.back().end = common;
    }
  }

  // The common end of unmatched gates: a gate within a joint of another one, as at a corner of the cell; otherwise the mean of
  // the gates.
  Point common_end(const Voronoi_gate<NT>* const* first, const Voronoi_gate<NT>* const* last) const
  {
    Point sum{0, 0};
    for (auto i = first; i != last; ++i)
    {
      sum = sum + (*i)->point;
      for (auto j = first; j != i; ++j)
        if (length((*i)->point - (*j)->point) <= m_tolerances.joint) return (*i)->point;
    }
    return (1. / NT((std::max)(last - first, std::ptrdiff_t(1)))) * sum;
  }

  template <class New_node, class OutputFunction>
  void write(const New_node& new_node, const OutputFunction& out)
  {
    const bool has_common_end = !m_arcs.empty() && m_arcs.back().end_node == no_index;
    const Index node = has_common_end ? new_node() : no_index;
    for (Bisector_arc<NT>& a : m_arcs)
    {
      if (a.end_node == no_index) a.end_node = node;
      out(a);
    }
  }

  // Replaces a straight arc by a part of a conic: of the bisector of the windows of both labels that are nearest at its middle.
  // Returns false, and leaves the arc, if the conic does not pass through the ends, or is no bisector between them.
  bool make_conic(Bisector_arc<NT>& arc) const
  {
    const unsigned a = nearest(arc.left.label, arc.middle()).with_label, b = nearest(arc.right.label, arc.middle()).with_label;
    if (a == Nearest_windows<NT>::none || b == Nearest_windows<NT>::none) return false;
    const bool swaps = m_windows[a].is_parallel();
    Bisector_arc<NT> curve = arc;
    curve.is_link = false;
    if (!curve.conic.make(m_windows[swaps ? b : a], m_windows[swaps ? a : b], m_tolerances.tie, m_face.center())) return false;
    if (curve.conic.is_ray()) return false;
    curve.from = curve.conic.parameter_of(arc.start);
    curve.to = curve.conic.parameter_of(arc.end);
    if (length(curve.conic.at(curve.from).point() - arc.start) > m_tolerances.joint) return false;
    if (length(curve.conic.at(curve.to).point() - arc.end) > m_tolerances.joint) return false;
    if (!is_bisector(curve, m_tolerances.of_link())) return false;
    curve.left = Bisector_side::of(m_windows[a], a);
    curve.right = Bisector_side::of(m_windows[b], b);
    arc = curve;
    return true;
  }

  bool is_on_side(const Bisector_arc<NT>& arc) const
  {
    bool result = false;
    for (int k = 0; k < 3; ++k) result = result || arc.is_on(m_face.outside(k), m_tolerances.along_side());
    return result;
  }

  // True if both sources of an arc tie, and no other one is nearer. On a side of the face, one of both sources may be nearest
  // only by windows of the neighbouring face; then its distance is not tested. This requires that both ends are gates, and that
  // the source is nearest at neither end by the windows of this face.
  bool is_bisector(const Bisector_arc<NT>& arc, NT tie) const
  {
    const bool ends_at_gate = arc.end_node != no_index || arc.chord_length() <= m_tolerances.joint;
    const bool may_be_of_neighbour = ends_at_gate && is_on_side(arc);
    const auto is_of_neighbour = [&](Index label) {
      return may_be_of_neighbour && !is_nearest(label, arc.start, tie) && !is_nearest(label, arc.end, tie);
    };
    const bool tests_left = !is_of_neighbour(arc.left.label), tests_right = !is_of_neighbour(arc.right.label);
    if (!tests_left && !tests_right) return false;
    const auto is_between = [&](NT part) {
      const Point p = arc.at(part);
      return (!tests_left || is_nearest(arc.left.label, p, tie)) && (!tests_right || is_nearest(arc.right.label, p, tie));
    };
    // evenly, and more densely towards the ends, where several bisectors may meet
    for (int i = 1; i < Voronoi_tolerances<NT>::samples_of_link; ++i)
      if (!is_between(NT(i) / Voronoi_tolerances<NT>::samples_of_link)) return false;
    const NT length = arc.chord_length();
    NT part = 1. / Voronoi_tolerances<NT>::samples_of_link;
    for (; part * length > m_tolerances.joint; part *= Voronoi_tolerances<NT>::step_of_samples)
      if (!is_between(part) || !is_between(1 - part)) return false;
    return true;
  }

  // True if each arc that was found coincides, up to rounding, with a link or with another such arc: its two sources tie on the
  // segment from its middle to that arc, which may be between other sources that tie there, too. Otherwise the arc is part of a
  // curve that passes no gate. Binding test: test_voronoi_diagram, curves without gates.
  bool coincide_with_links(const std::vector<Bisector_arc<NT>>& found) const
  {
    return std::all_of(found.begin(), found.end(), [&](const Bisector_arc<NT>& a) {
      const auto is_same = [&](const Bisector_arc<NT>& b) { return &a != &b && this->tie_between(a, b); };
      return a.chord_length() <= m_tolerances.smallest_loop || std::any_of(m_arcs.begin(), m_arcs.end(), is_same) ||
             std::any_of(found.begin(), found.end(), is_same);
    });
  }

  // True if the sources of arc a tie, and no other one is nearer, from the middle of a to the nearest sample of arc b. False if
  // this sample is an end of b, and the middle of a is beyond the end.
  bool tie_between(const Bisector_arc<NT>& a, const Bisector_arc<NT>& b) const
  {
    constexpr int samples = Voronoi_tolerances<NT>::samples_of_link;
    const auto sample = [&](int i) { return b.at(NT(i) / samples); };
    const Point from = a.middle();
    int nearest = 0;
    for (int i = 1; i <= samples; ++i)
      if (length(sample(i) - from) < length(sample(nearest) - from)) nearest = i;
    const Point to = sample(nearest);
    if (nearest == 0 && dot(from - to, sample(1) - to) < 0) return false;
    if (nearest == samples && dot(from - to, sample(samples - 1) - to) < 0) return false;
    return is_bisector(Bisector_arc<NT>::link(from, to, a.left.label, a.right.label), m_tolerances.of_link());
  }

  bool is_of_one_source(const Voronoi_cell<NT>& cell) const
  {
    const Point c = cell.center();
    const auto is_at = [&](const Point& p) { return is_nearest(cell.label[0], p, m_tolerances.of_link()); };
    bool result = is_at(c);
    for (int k = 0; k < 3; ++k)
    {
      const Point middle = 0.5 * (cell.corner[k] + cell.corner[(k + 1) % 3]);
      result = result && is_at(0.5 * (c + cell.corner[k])) && is_at(0.5 * (c + middle));
    }
    return result;
  }

  Nearest_windows<NT> nearest(Index label, const Point& p) const
  {
    return {label, m_windows, *m_candidates, p, m_tolerances.slack};
  }

  bool is_nearest(Index label, const Point& p, NT tie) const { return nearest(label, p).label_is_nearest(tie); }

  const std::vector<Voronoi_window<NT>>& m_windows;
  const Voronoi_tolerances<NT>& m_tolerances;
  const Voronoi_cell<NT>& m_face;
  const std::vector<unsigned>* m_candidates = nullptr;
  std::vector<Bisector_arc<NT>> m_arcs;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
