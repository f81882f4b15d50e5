// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traces a shortest path back to the source: straight through the unfolded faces, from pseudo-source to pseudo-source. Windows
// are read at the start of the path only, and not at all if it starts at a vertex.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_TRACING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_TRACING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Vertex_sector.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_goals.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_suffix_cache.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_elements.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_start_query.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Strip_walk.h>

#include <algorithm>
#include <optional>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Path_tracing
{
public:
  typedef Point_in_face<FT> Point;
  typedef Surface_point<FT> Surface_point_;

  Path_tracing(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_field(field), m_start(mesh, initial, field), m_goals(mesh, initial, field)
  {
  }

  typedef Suffix_end<FT> End;

  // Writes the path from p to `out`, see Path_elements.h and Path_points.h, and returns its end: p itself for a point of a source,
  // an empty end if p is not reached. `first`: the start of the path. `suffixes`: the cache of path suffixes of this field, which
  // must be final.
  // `bypass`: receives a corrected start, see find_bypass().
  template <class Point_, class Suffix_cache, class Output>
  End operator()(const Point_& p, const Path_start<FT>& first, Suffix_cache& suffixes, Output& out,
                 Path_start<FT>* bypass = nullptr) const
  {
    if (!first.is_reached()) return End();
    if (first.is_measured && !first.is_at_source()) return (*this)(p, first.before_measurement(), suffixes, out, bypass);
    out.start(p);
    if (first.is_at_source() || first.halfedge == no_index) return end_at_source(p, first);
    const Index limit = Index(m_mesh.number_of_vertices());
    Path_start<FT> further;
    auto& passed = out.passed();
    Index v = p.kind == Surface_point_::VERTEX ? p.element : no_index;
    for (Index guard = 0; guard <= limit; ++guard)
    {
      if (const typename Suffix_cache::Suffix* const suffix = known_suffix(suffixes, v))
      {
        out.append(suffix->first_item(), suffix->last_item(), suffix->end());
        if (suffix->end().is_at_source()) return suffix->end();
        v = suffix->end().point.element;
        continue;
      }
      if (guard != 0) further = m_start.at_vertex(v);
      const Path_start<FT>& start = guard == 0 ? first : further;
      if (start.halfedge == no_index || start.is_at_source()) break;
      if constexpr (Suffix_cache::keeps)
        if (start.pseudo_source != no_index) suffixes.prefetch(start.pseudo_source);
      passed.clear();
      const End end = follow(start, passed, guard == 0 ? bypass : nullptr);
      out.end_part(end);
      if constexpr (Suffix_cache::keeps)
        if (v != no_index) suffixes.keep(v, passed, end, guard == 0);
      out.append(passed.data(), passed.data() + passed.size(), end);
      if (end.is_at_source()) return end;
      v = end.point.element;
    }
    return {Surface_point_::at_vertex(v), m_field.source_ref[v]};
  }

private:
  // End of the path from a point of a source: the point itself.
  End end_at_source(const Surface_point_& p, const Path_start<FT>& start) const
  {
    const Source_ref source_ref = m_goals.source_ref_at(p, start);
    return {p, source_ref.is_valid() ? source_ref : start.source_ref};
  }

  // The passed vertex through which the path is shortest, and the number of points passed before it.
  struct Detour
  {
    FT length = Number_policy<FT>::infinity();
    Index vertex = no_index;
    std::size_t passed = 0;
    Index halfedge = no_index; // of a face with the vertex; the walk in its frame:
    Point position{FT(0), FT(0)}, direction{FT(0), FT(0)}, goal{FT(0), FT(0)};
    int corner = 0; // number of the vertex, counted from the halfedge
  };

  static constexpr double nearby = Path_goals<FT>::nearby;

  template <class Suffix_cache>
  static const typename Suffix_cache::Suffix* known_suffix(const Suffix_cache& suffixes, Index v)
  {
    if constexpr (Suffix_cache::keeps) return v == no_index ? nullptr : suffixes.find(v);
    else return (void)suffixes, (void)v, nullptr;
  }

  // Follows a straight part of the path to the source, to the pseudo-source, or to a vertex that is on the path up to rounding
  // and whose shortest path has the same source and side. A part that misses its goal ends at the best vertex that it passes,
  // of any source.
  template <class Passed>
  End follow(const Path_start<FT>& start, Passed& passed, Path_start<FT>* bypass = nullptr) const
  {
    Last_passed last;
    Path_start<FT> other;
    End end = follow(start, passed, false, last, bypass != nullptr ? bypass : &other);
    const bool is_at_vertex = last.vertex != no_index && m_goals.is_at(end.point, last.vertex);
    const bool is_on_edge = last.halfedge != no_index && m_goals.is_at(end.point, last.halfedge, last.position);
    if (is_at_vertex) end.point = Surface_point_::at_vertex(last.vertex);
    else if (is_on_edge && end.point.kind == Surface_point_::FACE)
      end.point = Surface_point_::on_edge(last.halfedge, last.position);
    if (is_at_vertex || is_on_edge)
    {
      CGAL_assertion(!passed.empty());
      passed.pop_back();
    }
    return end;
  }

  // The last point passed: a vertex, or a position on a halfedge.
  struct Last_passed
  {
    Index vertex = no_index, halfedge = no_index;
    FT position = FT(0);
  };

  typedef typename Path_goals<FT>::Goal Goal;

  // Where a walk starts: both points are in the frame of the halfedge, whose face has `from`.
  struct Entry
  {
    Index halfedge;
    Point from, to, direction;
    bool is_under_way = false; // not in the first face
  };

  // `has_missed`: true for the second attempt, after the first one has missed the goal. `bypass`: null, or receives the start
  // that find_bypass() has found, if the path was traced from it.
  template <class Passed>
  End follow(const Path_start<FT>& start, Passed& passed, bool has_missed, Last_passed& last_passed,
             Path_start<FT>* bypass) const
  {
    const Goal goal = m_goals.of(start);
    const FT reach = length(start.to - start.from);
    const bool has_virtual_start = m_goals.has_virtual_start(start);
    Entry entry{start.halfedge, start.from, start.to, start.direction};
    passed.set_apart(0);
    if (!has_missed && !has_virtual_start)
      if (const std::optional<End> end = walk_through_strip(start, goal, reach, passed, last_passed, entry)) return *end;
    Straight_walk<FT> walk(m_mesh, entry.halfedge, entry.from, entry.to, entry.direction);
    int exit = entry.is_under_way ? walk.exit() : start.exit == -1 ? walk.exit_from_inside() : start.exit;
    Detour detour;
    const auto end_at_goal = [&] {
      return m_goals.end_at_goal(goal, walk.halfedge(), walk.position(), walk.direction(), start);
    };
    const auto end_at_corner = [&](int k) {
      return m_goals.end_at_vertex(walk.vertex(k), walk.halfedge(), walk.position(), walk.direction(), start);
    };
    // Longest edge of the crossed faces, which determines the rounding. The walk through the strip does not measure its faces;
    // the first face may be the largest.
    FT extent = walk.extent();
    if (entry.is_under_way)
      extent = (std::max)(extent, FT(m_mesh[start.halfedge].length + m_mesh[m_mesh.next(start.halfedge)].length));
    const Index limit = Index(m_mesh.number_of_halfedges());
    for (Index guard = 0; guard <= limit; ++guard)
    {
      const bool is_first = guard == 0 && !entry.is_under_way;
      if (has_missed) look_for_detour(walk, is_first, start, reach, passed.size(), detour);
      FT last;
      if (m_goals.is_in_sight(goal, walk, is_first, last))
      {
        if constexpr (!Number_policy<FT>::is_inexact) return end_at_goal();
        const FT left = length(walk.goal() - walk.position());
        const FT rounding = window_allowance<FT>(start.distance) + Number_policy<FT>::rounding(16) * extent;
        if (last <= left + rounding || (has_missed && reach - left + last + m_goals.distance_of(goal) <= detour.length))
          return end_at_goal();
        break;
      }
      if (!is_first) exit = walk.exit(); // not earlier: a goal in sight may lie exactly on the path
      auto crossing = walk.crossing(exit);
      if (has_virtual_start)
      {
        End end;
        const FT left = length(crossing.goal - Point{crossing.t, FT(0)}), t = crossing.length - crossing.t;
        if (m_goals.ends_on_varying_segment(walk.edge(exit), t, left, start, extent, end)) return end;
      }
      const FT beside = m_goals.miss(reach, start, extent);
      if (crossing.goal.y <= beside)
      {
        if (End end; goal.is_segment() && m_goals.ends_on_segment(walk, start, reach, extent, has_missed, end))
          return has_missed && bypass != nullptr ? aimed_end(end, walk, start, passed, last_passed, bypass) : end;
        if (crossing.goal.y < -beside) break;
        // The goal may lie before the edge, up to rounding; the crossing is next to the goal then.
        if (CGAL::is_negative(crossing.goal.y)) crossing.t = (std::max)(FT(0), (std::min)(crossing.goal.x, crossing.length));
      }
      // The corners that were not examined yet.
      if (is_first)
      {
        const int source = exit, target = (exit + 1) % 3;
        const bool ahead = CGAL::is_positive(dot(walk.goal() - walk.position(), walk.corner(target) - walk.corner(source)));
        for (int k : {ahead ? target : source, ahead ? source : target})
          if (passes(walk, k, exit, crossing, start, goal, has_missed)) return end_at_corner(k);
      }
      else if (passes(walk, 2, exit, crossing, start, goal, has_missed)) return end_at_corner(2);
      if (walk.beyond(exit) == no_index) break;
      if (is_first && is_one_edge(walk.beyond(exit), start.edge))
        last_passed = {}; // through rounding, the path crosses the edge on which it starts
      else record(walk, exit, crossing, passed, last_passed);
      walk.cross_over(exit, crossing);
      extent = (std::max)(extent, walk.extent());
    }
    return end_after_miss(start, goal, detour, passed, has_missed, last_passed, bypass);
  }

  // Walks through a strip of faces to where the goal may be near. Not for exact numbers, for which strips build long expressions.
  // Returns the end if the path reaches it in the strip; otherwise `entry` receives where the walk is.
  template <class Passed>
  std::optional<End> walk_through_strip(const Path_start<FT>& start, const Goal& goal, const FT& reach, Passed& passed,
                                        Last_passed& last_passed, Entry& entry) const
  {
    if (!Number_policy<FT>::is_inexact || start.exit == -1 || is_one_edge(exit_of(start), start.edge) ||
        m_goals.is_in_face(goal, m_mesh.face(start.halfedge)))
      return std::nullopt;
    Strip_walk<FT> strip(m_mesh, start.halfedge, start.from, start.to, reach, start.exit);
    const FT extent = m_mesh.longest_edge() + FT(1. / (1 << 15)) * start.length();
    if (!strip(FT(FT(2 * nearby) * extent), m_goals.miss(reach, start, extent), passed)) return std::nullopt;
    passed.set_apart(passed.size());
    if (goal.vertex != no_index && m_mesh.apex(strip.halfedge()) == goal.vertex &&
        strip.way_to_apex() <= strip.way_left() + window_allowance<FT>(start.distance))
      return m_goals.end_at_goal(goal, strip.halfedge(), strip.position(), strip.direction(), start);
    entry = {strip.halfedge(), strip.position(), strip.goal(), strip.direction(), true};
    last_passed = {no_index, entry.halfedge, entry.from.x};
    return std::nullopt;
  }

  // The end of the path aimed at an end that a second attempt has found in the face of the walk; the same end if the walk cannot be
  // aimed at it.
  template <class Passed>
  End aimed_end(const End& end, const Straight_walk<FT>& walk, const Path_start<FT>& start, Passed& passed,
                Last_passed& last_passed, Path_start<FT>* bypass) const
  {
    Point position;
    unsigned edges;
    if (!CGAL::is_positive(length(walk.direction())) || !position_in_face(m_mesh, end.point, walk.face(), position, edges))
      return end;
    const Face_frame<FT> frame(m_mesh, walk.face());
    const int k = int(walk.halfedge() % 3);
    const Point goal_there = frame.vector_to_halfedge(k, position - frame.corner(k));
    const Path_start<FT> other = aimed_at(goal_there, start, walk.goal(), walk.direction());
    const End other_end = follow_instead(other, passed, last_passed, bypass);
    return other_end.is_at_source() ? other_end : follow(start, passed, true, last_passed, nullptr);
  }

  // Adds a crossing to what the path has passed: as a vertex if one is there, which the path does not use as a new start.
  template <class Passed>
  void record(const Straight_walk<FT>& walk, int exit, const typename Straight_walk<FT>::Crossing& crossing, Passed& passed,
              Last_passed& last_passed) const
  {
    const Index beyond = walk.beyond(exit), first = walk.vertex((exit + 1) % 3), second = walk.vertex(exit);
    const FT rounding = Number_policy<FT>::rounding(Path_goals<FT>::roundings_of_position) * crossing.length;
    const Index v = crossing.t <= rounding ? first : crossing.t >= crossing.length - rounding ? second : no_index;
    if (v == no_index) passed.push_back(passed.item({beyond, first, second, FT(crossing.t / crossing.length)}));
    else if (v != last_passed.vertex) passed.push_back(passed.item({no_index, v, v, FT(0)}));
    last_passed = {v, v == no_index ? beyond : no_index, crossing.t};
  }

  // The end of a path that has missed its goal: by a second attempt, then by the detour.
  template <class Passed>
  End end_after_miss(const Path_start<FT>& start, const Goal& goal, const Detour& detour, Passed& passed, bool has_missed,
                     Last_passed& last_passed, Path_start<FT>* bypass) const
  {
    if (!has_missed)
    {
      passed.clear();
      last_passed = {};
      return follow(start, passed, true, last_passed, bypass);
    }
    if (detour.vertex != no_index)
    {
      if (Path_start<FT> other = start; bypass != nullptr && find_bypass(start, detour, other))
      {
        const End end = follow_instead(other, passed, last_passed, bypass);
        return end.is_at_source() ? end : follow(start, passed, true, last_passed, nullptr);
      }
      passed.resize(detour.passed);
      last_passed = {};
      return m_goals.end_at_vertex(detour.vertex, detour.halfedge, detour.position, detour.direction, start);
    }
    if (goal.vertex != no_index && !goal.end.is_at_source() && m_goals.is_source(goal.vertex))
      return m_goals.end_at_source_vertex(goal.vertex, start);
    return goal.end;
  }

  // Follows the path from another start. If it ends at a source, *bypass receives the start; otherwise no point is passed.
  template <class Passed>
  End follow_instead(const Path_start<FT>& other, Passed& passed, Last_passed& last_passed, Path_start<FT>* bypass) const
  {
    passed.clear();
    last_passed = {};
    const End end = follow(other, passed, false, last_passed, nullptr);
    if (end.is_at_source())
    {
      *bypass = other;
      return end;
    }
    passed.clear();
    last_passed = {};
    return End();
  }

  // Start of the path to another goal. `goal`, `old_goal` and `direction`: both goals and the direction of the walk, in the
  // frame that the walk has reached.
  static Path_start<FT> aimed_at(const Point& goal, const Path_start<FT>& start, const Point& old_goal, const Point& direction)
  {
    const Point along = (FT(1) / length(direction)) * direction, off = goal - old_goal;
    const Point turned{dot(along, off), cross(along, off)}; // in a frame with the x axis along the path
    const Point there = (FT(1) / length(start.direction)) * start.direction;
    Path_start<FT> other = start;
    other.to = start.to + Point{there.x * turned.x - there.y * turned.y, there.y * turned.x + there.x * turned.y};
    other.direction = other.to - other.from;
    return other;
  }

  // Next to a source, the direction of the path may be so imprecise that the path passes a vertex on the wrong side. The path
  // of the vertex to the source is precise. If the straight path to the end of the vertex's path is shorter than the path
  // through the vertex, `other` receives its start, and the result is true.
  bool find_bypass(const Path_start<FT>& start, const Detour& detour, Path_start<FT>& other) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return (void)start, (void)detour, (void)other, false;
    const Path_start<FT> rest = m_start.at_vertex(detour.vertex);
    const FT size = length(detour.direction), reach = length(start.to - start.from);
    if (m_goals.is_source(detour.vertex) || rest.halfedge == no_index || rest.pseudo_source != no_index ||
        !CGAL::is_positive(size))
      return false;
    const Point along = (FT(1) / size) * detour.direction, begin = detour.goal - reach * along;
    const Face_frame<FT> frame(m_mesh, m_mesh.face(detour.halfedge));
    const int edge = int(detour.halfedge % 3), corner = (edge + detour.corner) % 3;
    const auto from_corner = [&](const Point& u) { // from the frame of the vertex's halfedge to that of the detour's
      return frame.vector_to_halfedge(edge, frame.vector_from_halfedge(corner, u));
    };
    const Point vertex = frame.vector_to_halfedge(edge, frame.corner(corner) - frame.corner(edge));
    FT shortest = detour.length - Number_policy<FT>::rounding(4) * detour.length;
    bool is_found = false;
    for (const bool ccw : {false, true})
    {
      Point u = rest.to;
      if (!turn_to_corner(m_mesh, rest.halfedge, 3 * m_mesh.face(detour.halfedge) + Index(corner), ccw, u)) continue;
      const Point goal = vertex + from_corner(u), way = goal - begin;
      // A path that passes the vertex counterclockwise has the vertex on its left.
      const FT side = cross(way, vertex - begin), l = length(way) + rest.start_value;
      if ((ccw ? CGAL::is_negative(side) : CGAL::is_positive(side)) || !(l < shortest)) continue;
      shortest = l;
      is_found = true;
      other = aimed_at(goal, start, detour.goal, detour.direction);
    }
    return is_found;
  }

  Index exit_of(const Path_start<FT>& start) const
  {
    return m_mesh.face(start.halfedge) * 3 + (start.halfedge % 3 + Index(start.exit)) % 3;
  }

  bool is_one_edge(Index g, Index h) const { return h != no_index && (g == h || m_mesh.twin(h) == g); }

  // True if the walk passes corner k, an end of its exit edge, so closely that the path through the corner is as short as the
  // straight one; with exact numbers, if the walk meets the corner. The corner must have the same source and side, unless the
  // walk has missed its goal.
  bool passes(const Straight_walk<FT>& walk, int k, int exit, const typename Straight_walk<FT>::Crossing& crossing,
              const Path_start<FT>& start, const Goal& goal, bool has_missed) const
  {
    const Point to_goal = walk.goal() - walk.position(), to_vertex = walk.corner(k) - walk.position();
    const FT off = walk.side(k);
    const Index v = walk.vertex(k);
    if constexpr (!Number_policy<FT>::is_inexact)
      return CGAL::is_zero(off) && CGAL::is_positive(dot(to_goal, to_vertex)) &&
             dot(to_vertex, to_vertex) <= dot(to_goal, to_goal) &&
             (v == goal.vertex || has_missed || m_goals.may_pass_through(v, start.source_ref));
    const FT near = FT(nearby) * FT(nearby) * dot(to_goal, to_goal);
    CGAL_assertion(k == exit || k == (exit + 1) % 3);
    const FT beside = k == exit ? FT(crossing.length - crossing.t) : crossing.t;
    if (beside > FT(nearby) * crossing.length &&
        off * off > near * (dot(to_vertex, to_vertex) + start.length() * start.length() * FT(nearby)))
      return false;
    const FT& d = m_field.distance[v];
    const FT straight_on = length(to_goal);
    const FT rest = straight_on + (start.pseudo_source == no_index ? start.start_value : m_field.distance[start.pseudo_source]);
    return d < start.distance && d + length(to_vertex) <= rest + window_allowance<FT>(start.distance) &&
           (v == goal.vertex || has_missed || m_goals.may_pass_through(v, start.source_ref));
  }

  void look_for_detour(const Straight_walk<FT>& walk, bool is_first, const Path_start<FT>& start, const FT& reach,
                       std::size_t passed, Detour& detour) const
  {
    const FT so_far = reach - length(walk.goal() - walk.position());
    for (int k = is_first ? 0 : 2; k < 3; ++k)
    {
      const FT to_vertex = length(walk.corner(k) - walk.position());
      const FT& d = m_field.distance[walk.vertex(k)];
      const FT way = so_far + to_vertex + d;
      if (way < detour.length && d < start.distance)
        detour = {way, walk.vertex(k), passed, walk.halfedge(), walk.position(), walk.direction(), walk.goal(), k};
    }
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Geodesic_field<FT>& m_field;
  const Path_start_query<FT> m_start;
  const Path_goals<FT> m_goals;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
