// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a straight way leads that a shortest path begins with, whether it has got there, and on which part of the source it ends.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_GOAL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_GOAL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_legs.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_start.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Estimation.h>

#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Path_goals
{
public:
  typedef Point_in_face<FT> Point;
  typedef Surface_point<FT> Surface_point_;
  typedef Leg_end<FT> End;

  static constexpr double nearby = 1. / (1 << 30); // part of an edge: a path so near to a vertex may be meant to pass it

  // Where a straight way leads: to a vertex, a point in a face or on the edge between two, or to a segment. `end` has the
  // point, and the root if that is known already.
  struct Goal
  {
    Index vertex = no_index, face = no_index, other_face = no_index;
    End end;

    bool is_segment() const { return vertex == no_index && face == no_index; }
  };

  Path_goals(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_initial(initial), m_field(field)
  {
  }

  Goal of(const Path_start<FT>& start) const
  {
    Goal goal;
    goal.vertex = start.pseudo_source;
    const Index primitive = start.root.primitive();
    const Surface_point_& place = m_initial.places[primitive].first;
    if (goal.vertex == no_index)
    {
      goal.end = {place, start.root};
      if (m_initial.primitives[primitive].is_segment) return goal;
      if (place.kind == Surface_point_::VERTEX)
        goal.vertex = place.element;
      else if (place.kind == Surface_point_::FACE)
        goal.face = goal.other_face = place.element;
      else
      {
        goal.face = m_mesh.face(place.element);
        goal.other_face = m_mesh.twin(place.element) == no_index ? goal.face : m_mesh.face(m_mesh.twin(place.element));
      }
    }
    else
      goal.end = {Surface_point_::at_vertex(goal.vertex), Root()};
    return goal;
  }

  // Whether a path with the given root may go by a vertex: if the vertex's own path has the same source and side. Where several
  // sources tie at the vertex, the path goes on to its own.
  bool is_of_one_root(Index v, Root root) const
  {
    const Root other = m_field.root[v];
    return other.is_valid() && other.side() == root.side() && source_of(other) == source_of(root);
  }

  bool is_source(Index v) const { return CGAL::is_zero(m_field.distance[v]); }

  // Whether the goal is a point of the face.
  bool is_in_face(const Goal& goal, Index face) const
  {
    if (goal.vertex != no_index) return has_corner(face, goal.vertex);
    return goal.face != no_index && (face == goal.face || face == goal.other_face);
  }

  // From a face that the goal lies in, the straight way to it is the shortest, as it is the shortest in space; tells how
  // long it is. Not for segments.
  bool is_in_sight(const Goal& goal, const Straight_walk<FT>& walk, bool is_first, FT& distance) const
  {
    if (goal.vertex != no_index)
    {
      for (int k = 2; k >= (is_first ? 0 : 2); --k)
        if (walk.vertex(k) == goal.vertex)
        {
          distance = length(walk.corner(k) - walk.position());
          return true;
        }
      return false;
    }
    if (goal.face == no_index || (walk.face() != goal.face && walk.face() != goal.other_face)) return false;
    Point place;
    unsigned edges;
    CGAL_assertion_code(const bool is_there =)
    position_in_face(m_mesh, goal.end.point, walk.face(), place, edges);
    CGAL_assertion(is_there);
    const Face_frame<FT> frame(m_mesh, walk.face());
    distance = length(place - frame.from_halfedge(int(walk.halfedge() % 3), walk.position()));
    return true;
  }

  FT distance_of(const Goal& goal) const
  {
    return goal.end.is_at_source() ? FT(0) : m_field.distance[goal.vertex];
  }

  // The end of a way that has reached its goal in the face of h, which it has entered at p or has started in at p; p in the frame
  // of h.
  End end_at_goal(const Goal& goal, Index h, const Point& p, const Path_start<FT>& start) const
  {
    return goal.vertex == no_index || goal.end.is_at_source() ? goal.end : end_at_vertex(goal.vertex, h, p, start);
  }

  // The end of a way to a corner of the face of h. The path ends there or goes on from there.
  End end_at_vertex(Index v, Index h, const Point& p, const Path_start<FT>& start) const
  {
    if (!is_source(v)) return {Surface_point_::at_vertex(v), Root()};
    const Index face = m_mesh.face(h);
    const Face_frame<FT> frame(m_mesh, face);
    const FT allowance = Number_policy<FT>::rounding(1 << 12) * (start.distance + frame.longest_edge());
    for (int k = 0; k < 3; ++k)
    {
      End end;
      if (m_mesh.source(3 * face + Index(k)) == v &&
          find_end(frame, face, frame.from_halfedge(int(h % 3), p), frame.corner(k), start.root,
                   Number_policy<FT>::infinity(), allowance, false, end))
        return {Surface_point_::at_vertex(v), end.root};
    }
    return end_at_source_vertex(v, start);
  }

  // The same if no face is known through which the way arrives.
  End end_at_source_vertex(Index v, const Path_start<FT>& start) const
  {
    return {Surface_point_::at_vertex(v), is_at_vertex(start.root, v) ? start.root : m_field.root[v]};
  }

  // The end of the path from a point of a source: the point itself, and a part of the source that contains it.
  End end_at_source(const Surface_point_& p, const Path_start<FT>& start) const
  {
    if (p.kind == Surface_point_::VERTEX) return {p, m_field.root[p.element]};
    End end{p, start.root};
    for (const Index face : faces_of(m_mesh, p))
    {
      Point position;
      unsigned edges;
      position_in_face(m_mesh, p, face, position, edges);
      const Face_frame<FT> frame(m_mesh, face);
      const FT allowance = Number_policy<FT>::rounding(64) * frame.longest_edge();
      End found;
      if (!find_end(frame, face, position, position, start.root, allowance, allowance, false, found)) continue;
      end.root = found.root;
      return end;
    }
    return end;
  }

  // Whether a way to a segment ends in the face that it has entered, and where. `extent`: of the largest face that was passed.
  bool ends_on_segment(const Straight_walk<FT>& walk, const Path_start<FT>& start, const FT& extent, End& end) const
  {
    const Index face = walk.face();
    const Face_frame<FT> frame(m_mesh, face);
    const Point p = frame.from_halfedge(int(walk.halfedge() % 3), walk.position());
    const Point q = frame.from_halfedge(int(walk.halfedge() % 3), walk.goal());
    const FT longest = length(q - p) + Number_policy<FT>::rounding(256) * (start.distance + extent);
    // as near to q as the direction is exact: the next segment, in the next face, may be meant
    const FT nearest = FT(nearby) * length(q - p) + Number_policy<FT>::rounding(1 << 12) * (start.distance + extent);
    return find_end(frame, face, p, q, start.root, longest, nearest, true, end);
  }

private:
  // The end of a straight way from p to q in a face: the source point that is nearest to q, no farther from q than `nearest` and
  // from p than `longest`. Windows of segments in one line become one, and sources may coincide, so that several parts of sources
  // may be there: the part whose rays reach p comes first, then one of the same source, and of the same side, as the root of the
  // way. `only_known_source`: parts of other sources do not count.
  bool find_end(const Face_frame<FT>& frame, Index face, const Point& p, const Point& q, Root known, const FT& longest,
                const FT& nearest, bool only_known_source, End& end) const
  {
    typedef typename Estimation<FT>::Bound Bound;
    const Bound limit = Estimation<FT>::upper_bound(estimate(nearest));
    const FT allowance = Number_policy<FT>::rounding(64) * frame.longest_edge();
    Bound least = limit;
    int best = -1;
    // Calls f(root, foot, its distance from q, whether rays of the root reach p).
    const auto for_each_candidate = [&](const auto& f) {
      const auto consider = [&](Root root, const Face_window<FT>* window) {
        const Source_place<FT>& place = m_initial.places[root.primitive()];
        if ((only_known_source && source_of(root) != source_of(known)) || !is_in_face(place.first, face) ||
            !is_in_face(place.second, face))
          return;
        Surface_point_ point = place.first;
        bool is_left = true, is_right = true;
        const Point foot = foot_in(face, frame, p, root.primitive(), point, is_left, is_right);
        const Point way = foot - p, miss = foot - q;
        const auto missed = estimate(dot(miss, miss));
        if (CGAL::certainly(estimate(dot(way, way)) > CGAL::square(estimate(longest)))) return;
        const Bound off = Estimation<FT>::upper_bound(CGAL::sqrt(missed));
        if (!(off <= limit)) return;
        const bool reaches = window ? window->contains(p, allowance)
                             : root.side() == Source_side::LEFT  ? is_left
                             : root.side() == Source_side::RIGHT ? is_right
                                                                 : true;
        f(root, point, off, reaches);
      };
      const auto local = local_windows(m_initial, face);
      for (auto i = local.first; i != local.second; ++i) consider(i->window.root, &i->window);
      for (Index h = 3 * face; h < 3 * face + 3; ++h)
        m_initial.for_each_edge_window(h, [&](const auto& w) { consider(w.root, nullptr); });
    };
    for_each_candidate([&](Root, const Surface_point_&, const Bound& off, bool) { least = (std::min)(least, off); });
    const Bound tied = least + Estimation<FT>::upper_bound(estimate(allowance));
    for_each_candidate([&](Root root, const Surface_point_& point, const Bound& off, bool reaches) {
      const int preference = 8 * int(reaches) + 4 * int(source_of(root) == source_of(known)) + 2 * int(root.side() == known.side()) +
                             int(root.primitive() == known.primitive());
      if (!(off <= tied) || preference <= best) return;
      best = preference;
      end = {point, root};
    });
    return best >= 0;
  }

  Index source_of(Root root) const { return m_initial.source_of[root.primitive()]; }

  // Whether a root is a point at a vertex, or a segment with an end there.
  bool is_at_vertex(Root root, Index v) const
  {
    const Source_place<FT>& place = m_initial.places[root.primitive()];
    const auto is_there = [v](const Surface_point_& p) { return p.kind == Surface_point_::VERTEX && p.element == v; };
    return is_there(place.first) || is_there(place.second);
  }

  bool is_in_face(const Surface_point_& p, Index face) const
  {
    if (p.kind == Surface_point_::FACE) return p.element == face;
    if (p.kind == Surface_point_::EDGE)
      return m_mesh.face(p.element) == face ||
             (m_mesh.twin(p.element) != no_index && m_mesh.face(m_mesh.twin(p.element)) == face);
    return has_corner(face, p.element);
  }

  bool has_corner(Index face, Index v) const
  {
    const Index h = 3 * face;
    return m_mesh.source(h) == v || m_mesh.source(h + 1) == v || m_mesh.source(h + 2) == v;
  }

  // The nearest point of a point or segment that lies in the face, to a point p of the face; and whether p may be on the left and
  // on the right of the segment.
  Point foot_in(Index face, const Face_frame<FT>& frame, const Point& p, Index primitive, Surface_point_& nearest, bool& is_left,
                bool& is_right) const
  {
    const Source_place<FT>& place = m_initial.places[primitive];
    Point a, b;
    unsigned edges_of_a, edges_of_b;
    position_in_face(m_mesh, place.first, face, a, edges_of_a);
    nearest = place.first;
    if (!m_initial.primitives[primitive].is_segment) return a;
    position_in_face(m_mesh, place.second, face, b, edges_of_b);
    const Point u = b - a;
    const auto side = estimate(cross(u, p - a));
    is_left = CGAL::possibly(side >= 0);
    is_right = CGAL::possibly(side <= 0);
    const FT t = dot(p - a, u) / dot(u, u);
    if (!CGAL::is_positive(t)) return a;
    nearest = place.second;
    if (!(t < FT(1))) return b;
    const Point foot = a + t * u;
    if (const unsigned edge = edges_of_a & edges_of_b)
    {
      const int k = edge_of_bit(edge);
      nearest = Surface_point_::on_edge(3 * face + Index(k), frame.along(k, foot));
    }
    else
      nearest = Surface_point_::in_face(face, foot);
    return foot;
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
