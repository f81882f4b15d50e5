// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arcs of one level in a face, and their visible parts, which form the boundary of { D < level }.
//
// Each window has at most one arc of a level: the points of its cone at which the distance of the window equals the level. A
// window covers a part of another arc if the part lies in its cone and its distances there are less than the level by more than
// rounding. So windows that tie along a whole arc do not cover each other. As distances are continuous, visibility changes only
// where arcs meet, so an arc is tested only against the arcs that may meet it.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_ARCS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_ARCS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Box_in_face.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_arc.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_candidates.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_cell.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Window_cone.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Level_arcs
{
public:
  typedef Point_in_face<FT> Point;
  typedef Level_arc<FT> Arc;
  typedef Box_in_face<FT> Box;

  static constexpr std::size_t none = std::size_t(-1);

  explicit Level_arcs(const Offset_sources<FT>& sources) : m_sources(sources) {}

  // Sets the face, and bounds of the levels for the next calls of set_level(). `reach`: the longest edge of the faces around
  // the corners of the face, for the tolerances (Offset_tolerances).
  void set_face(const Face_field<FT>& field, const FT& reach, const FT& lowest_level, const FT& highest_level)
  {
    m_field = &field;
    m_reach = reach;
    m_margin = Offset_tolerances<FT>(m_reach + highest_level).smallest_cell;
    m_cones.clear();
    m_fans.clear();
    m_fan_cones.clear();
    for (std::size_t i = 0; i < field.windows().size(); ++i)
    {
      const Face_window<FT>& w = field.windows()[i];
      if (w.is_empty()) continue;
      const FT bound = (std::max)(w.distance_at(w.left), w.distance_at(w.right)) + field.size() + m_margin;
      if (field.lowest(i) < highest_level + m_margin && bound >= lowest_level)
        m_cones.emplace_back(w, Index(i), field.lowest(i), field.frame(), m_margin);
    }
  }

  void set_level(const FT& level)
  {
    m_level = level;
    m_tolerances = Offset_tolerances<FT>(m_reach + level);
    m_has_fans = false;
    m_arcs.clear();
    m_boxes.clear();
    m_arc_of.assign(m_field->windows().size(), none);
    for (const Cone& c : m_cones) add_arc(c);
    m_candidates.clear();
    for (Index i = 0; i < m_arc_of.size(); ++i)
      if (m_field->lowest(i) < m_level + slack() && has_offset(m_field->windows()[i])) m_candidates.push_back(i);
    find_candidates();
  }

  // Adds fans: windows of the paths that bend at a corner, in all directions. They close gaps between the cone of the corner and
  // the windows beside it: of two paths to the corner that tie within rounding, the cone continues one, and a window the other;
  // their directions differ by up to the root of rounding. As fans are rarely needed, they are added on demand.
  void add_fans()
  {
    if (m_fans.empty()) make_fans();
    m_has_fans = true;
    m_first_fan = m_arcs.size();
    m_arc_of.resize(m_field->windows().size() + m_fans.size(), none);
    for (const Cone& c : m_fan_cones) add_arc(c);
    for (Index i = Index(m_field->windows().size()); i < m_arc_of.size(); ++i)
      if (m_arc_of[i] != none) m_candidates.push_back(i);
    find_candidates();
  }
  bool has_fans() const { return m_has_fans; }
  bool is_fan(std::size_t i) const { return m_has_fans && i >= m_first_fan; }

  // Selects tie tolerance i of Offset_tolerances.
  void use_tie(int factor) { m_tolerances.use_tie(factor); }

  // The smallest difference between the level and the start value of a source whose window has an arc.
  FT narrowest_offset() const
  {
    FT result = m_level;
    for (const Arc& a : m_arcs) result = (std::min)(result, m_sources.offset(a.window().source_ref, m_level));
    return result;
  }

  // Calls f(window) for all windows of the face whose sources have an offset, including those of add_fans().
  template <class Function>
  void for_each_window(const Function& f) const
  {
    for (const Face_window<FT>& w : m_field->windows())
      if (has_offset(w)) f(w);
    if (m_has_fans)
      for (const Face_window<FT>& w : m_fans)
        if (has_offset(w)) f(w);
  }

  // Distance of p to the sources that have an offset, and a window that attains it. Of a point farther than the level and the slack,
  // the result may be farther still, or infinite.
  FT distance(const Point& p, std::size_t& nearest) const
  {
    const auto at_p = m_candidates.at(p);
    return m_field->distance(p, nearest, at_p.empty() ? m_candidates.all() : at_p);
  }

  // True if the distance of p, up to `error`, is less than the level by more than the tolerance `tie`.
  bool is_near(const Point& p, const FT& error) const
  {
    std::size_t nearest;
    return m_candidates.is_near(p) || distance(p, nearest) + error < m_level - m_tolerances.tie;
  }

  const Face_field<FT>& field() const { return *m_field; }
  const FT& level() const { return m_level; }
  const FT& reach() const { return m_reach; }
  const Offset_tolerances<FT>& tolerances() const { return m_tolerances; }
  std::size_t size() const { return m_arcs.size(); }
  const Arc& operator[](std::size_t i) const
  {
    CGAL_precondition(i < m_arcs.size());
    return m_arcs[i];
  }

  // True if arc i passes through p, up to the tolerance `tie`.
  bool passes(std::size_t i, const Point& p) const
  {
    const Arc& a = m_arcs[i];
    if constexpr (!Number_policy<FT>::is_inexact) return a.window().contains(p) && CGAL::is_zero(a.excess(p));
    return a.outside_cone(p) <= m_tolerances.tie && CGAL::abs(a.excess(p)) <= m_tolerances.tie;
  }

  // Calls f(i) for each arc through p except arc `without`.
  template <class Function>
  void for_each_through(const Point& p, std::size_t without, const Function& f) const
  {
    const Box box(p);
    for (const Index w : m_candidates.at(p))
      if (const std::size_t i = m_arc_of[w]; i != none && i != without && m_boxes[i].meets(box) && passes(i, p)) f(i);
  }

  // Calls f(j) for the arcs other than i that may meet it.
  template <class Function>
  void for_each_near(std::size_t i, const Function& f) const
  {
    find_near(i, m_boxes[i]);
    for (const std::size_t j : m_near) f(j);
  }

  // Sets `arcs` to those that may have visible parts in a cell.
  void find_arcs(const Level_cell<FT>& cell, std::vector<std::size_t>& arcs) const
  {
    Box box(cell.corner[0]);
    box.add(cell.corner[1]);
    box.add(cell.corner[2]);
    find_near(box, none, [](const Point&, const FT&) { return true; });
    arcs = m_near;
  }

  // Moves `to` to the first covered point of arc i between `from` and `to`. Returns false if there is none. Most covered points
  // are next to `from`, so parts that grow from there are searched one after the other.
  bool find_covered(std::size_t i, const Point& from, Point& to) const
  {
    const Arc& a = m_arcs[i];
    m_ends.assign(1, to);
    if (!m_candidates.is_whole())
      for (const FT shortest = FT(2) * m_candidates.radius_at(from); length(m_ends.back() - from) > shortest;)
        m_ends.push_back(a.middle(from, m_ends.back()));
    bool found = false;
    while (!m_ends.empty())
    {
      const Point end = found && CGAL::is_positive(a.advance(to, m_ends.back())) ? to : m_ends.back();
      m_ends.pop_back();
      Box box(from);
      box.add(end);
      box.widen(a.rise(from, end));
      box.intersect(m_boxes[i]);
      find_near(i, box);
      for (const std::size_t j : m_near) found = find_covered_by(a, m_arcs[j], from, to) || found;
      if (found && !CGAL::is_positive(a.advance(end, to))) return true;
    }
    return found;
  }

private:
  struct Cone
  {
    const Face_window<FT>* window;
    Index index; // of the window; those of fans come after those of the field
    FT lowest;   // distance
    Window_cone<FT> cone;

    Cone(const Face_window<FT>& w, Index i, const FT& lowest_distance, const Face_frame<FT>& frame, const FT& margin)
      : window(&w), index(i), lowest(lowest_distance), cone(w, frame, margin)
    {
    }
  };

  bool has_offset(const Face_window<FT>& w) const { return m_sources.reach(w.source_ref, m_level); }

  void add_arc(const Cone& c)
  {
    // Include a window that only touches the level: the arc may run along the edge of the window.
    if (!(c.lowest < m_level + m_margin && c.cone.reaches(m_level))) return;
    if (!has_offset(*c.window) || (!c.window->is_parallel() && !(c.window->sigma < m_level))) return;
    const Arc arc(*c.window, c.cone, m_level);
    const Box box = arc.box(m_margin);
    if (box.is_empty()) return;
    m_arc_of[c.index] = m_arcs.size();
    m_arcs.push_back(arc);
    m_boxes.push_back(box);
  }

  void make_fans()
  {
    for (const Face_window<FT>& w : m_field->windows())
    {
      if (w.origin != STARTS_AT_CORNER) continue;
      const Point along = m_field->size() * m_field->frame().direction(int(w.edge));
      Face_window<FT> fan = w;
      fan.left = w.image() - along;
      fan.right = w.image() + along;
      m_fans.push_back(fan);
    }
    for (const Face_window<FT>& w : m_fans)
      m_fan_cones.emplace_back(w, Index(m_field->windows().size() + m_fan_cones.size()), w.sigma, m_field->frame(), m_margin);
  }

  // Differences of distances of windows whose arcs pass one point, up to the largest tie, are less than this.
  FT slack() const { return FT(2) * m_margin; }

  void find_candidates()
  {
    const std::size_t n = m_field->windows().size();
    m_is_near.assign(m_arcs.size(), 0);
    m_candidates.build(m_field->frame(), m_level, slack(), [this, n](Index i) -> const Face_window<FT>& {
      return i < n ? this->m_field->windows()[i] : this->m_fans[i - n];
    });
  }

  // Sets m_near to the arcs other than i that may meet its part in a box.
  void find_near(std::size_t i, const Box& box) const
  {
    find_near(box, i, [&](const Point& center, const FT& radius) { return CGAL::abs(m_arcs[i].excess(center)) <= radius; });
  }

  // Overload for the arcs other than `without` near a set, in a box: meets(center, radius) is true for circles that may meet it.
  template <class Meets>
  void find_near(const Box& box, std::size_t without, const Meets& meets) const
  {
    m_near.clear();
    std::size_t parts = 0;
    const auto meets_in_box = [&](const Point& center, const FT& radius) {
      Box around(center);
      around.widen(radius);
      return around.meets(box) && meets(center, radius);
    };
    m_candidates.for_each_part(meets_in_box, [&](const auto& windows) {
      ++parts;
      for (const Index w : windows)
        if (const std::size_t j = m_arc_of[w]; j != none && j != without && !m_is_near[j] && m_boxes[j].meets(box))
        {
          m_near.push_back(j);
          m_is_near[j] = 1;
        }
    });
    for (const std::size_t j : m_near) m_is_near[j] = 0;
    if (parts > 1) std::sort(m_near.begin(), m_near.end());
  }

  // True if p is covered by the window of b. If the image is a point of the face, straight paths from it to all points of the
  // face are on the surface, so the cone is not tested: an arc may run along its bounding ray.
  bool covers(const Arc& b, const Point& p) const
  {
    return (b.starts_at_point_of_face() || b.is_in_cone(p)) && b.excess(p) < -m_tolerances.cover;
  }

  // Variant of covers() for p beside a bounding ray of b, up to `error`. An arc along a ray that two windows share may lie
  // outside both cones. The allowance is doubled for the position of p and for the difference between the distances of p and of
  // its foot on the ray: one `error` each, which is one `cover` together.
  bool covers_beside(const Arc& b, const Point& p) const
  {
    return !(b.outside_cone(p) > m_tolerances.error) && b.excess(p) < -FT(2) * m_tolerances.cover;
  }

  // True if arc a between two points lies beside the cone of b. `is_beside`: it lies outside a bounding ray of b, up to the
  // tolerance `error`; this tolerance is needed where the windows of two arcs share the ray. Such an arc is not beside the cone
  // if it runs along the ray, up to `error`, and is longer than the smallest cell.
  bool lies_beside(const Arc& b, const Arc& a, const Point& from, const Point& to, bool& is_beside) const
  {
    const FT& error = m_tolerances.error;
    const auto left = a.values(b.left(), from, to);
    is_beside = !(-left.least > error);
    if (is_beside && left.largest > error) return true;
    const auto right = a.values(b.right(), from, to);
    is_beside = is_beside || !(-right.least > error);
    return is_beside && (left.largest > error || right.largest > error || !(a.advance(from, to) > m_tolerances.smallest_cell));
  }

  // Overload for the window of one other arc b. The points where arc a meets b and the bounding rays of b divide a into parts
  // that are covered wholly or not at all. The middle point of each part decides.
  bool find_covered_by(const Arc& a, const Arc& b, const Point& from, Point& to) const
  {
    bool is_beside = false;
    if (!b.starts_at_point_of_face() && lies_beside(b, a, from, to, is_beside)) return false;
    Point end[10];
    int n = 0;
    const auto add = [&](const Point& p) {
      if (!a.is_between(from, p, to)) return;
      CGAL_assertion(n < 10);
      int k = n++;
      for (; k > 0 && CGAL::is_negative(a.advance(end[k - 1], p)); --k) end[k] = end[k - 1];
      end[k] = p;
    };
    Point enter, leave;
    if (a.meet(b, m_tolerances.cover, enter, leave))
    {
      add(enter);
      add(leave);
    }
    if (n == 0 && !(b.excess(a.middle(from, to)) < -m_tolerances.cover)) return false;
    const auto add_side = [&](const Half_plane<FT>& side) {
      if (!a.meet(side, enter, leave)) return;
      add(enter);
      add(leave);
    };
    if (!b.starts_at_point_of_face())
    {
      add_side(b.left());
      add_side(b.right());
    }
    if (b.window().is_parallel() && b.window().origin == STARTS_IN_FACE)
      add_side({b.forward(), b.radius() - (m_level - b.window().start_value)}); // line of the source
    Point p = from;
    for (int k = 0; k <= n; ++k)
    {
      const Point& q = k < n ? end[k] : to;
      // Parts no longer than `tie` are due to rounding of the rays.
      const bool is_part = a.advance(p, q) > m_tolerances.tie || !Number_policy<FT>::is_inexact;
      if (is_part && (covers(b, a.middle(p, q)) || (is_beside && covers_beside(b, a.middle(p, q)))))
      {
        to = p;
        return true;
      }
      p = q;
    }
    return false;
  }

  const Offset_sources<FT>& m_sources;
  const Face_field<FT>* m_field = nullptr;
  FT m_level, m_margin, m_reach;
  Offset_tolerances<FT> m_tolerances;
  std::vector<Cone> m_cones; // of the windows that may have an arc of one of the levels
  std::vector<Face_window<FT>> m_fans;
  std::vector<Cone> m_fan_cones;
  bool m_has_fans = false;
  std::size_t m_first_fan = 0;       // first arc of a fan
  std::vector<Arc> m_arcs;           // of the level
  std::vector<Box> m_boxes;          // of the arcs
  std::vector<std::size_t> m_arc_of; // per window
  Level_candidates<FT> m_candidates;
  // Of one call:
  mutable std::vector<std::size_t> m_near;
  mutable std::vector<char> m_is_near; // per arc; not set between calls
  mutable std::vector<Point> m_ends;   // of parts of an arc, the longest first
};

} // namespace CGAL::Geodesic_offset::internal

#endif
