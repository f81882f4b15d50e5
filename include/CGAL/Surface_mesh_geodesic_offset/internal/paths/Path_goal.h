// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a straight way leads that a shortest path begins with, and whether it has got there.

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

  // Where a straight way leads: to a vertex, a point in a face or on the edge between two, or to a segment.
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
      goal.end = {place, primitive};
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
      goal.end = at_vertex(goal.vertex);
    return goal;
  }

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
    return goal.end.primitive == no_index ? m_field.distance[goal.vertex] : FT(0);
  }

  End at_vertex(Index v) const
  {
    return {Surface_point_::at_vertex(v), CGAL::is_zero(m_field.distance[v]) ? m_field.root[v].primitive() : no_index};
  }

  // A path to one segment may end at another one of the source: windows of segments in one line have become one.
  // `extent`: of the largest face that was passed.
  bool ends_on_segment(const Straight_walk<FT>& walk, const Path_start<FT>& start, const FT& extent, End& end) const
  {
    const Index face = walk.face();
    const Face_frame<FT> frame(m_mesh, face);
    const Point p = frame.from_halfedge(int(walk.halfedge() % 3), walk.position());
    const Point q = frame.from_halfedge(int(walk.halfedge() % 3), walk.goal());
    const FT longest = length(q - p) + Number_policy<FT>::rounding(256) * (start.distance + extent);
    // as near to q as the direction is exact: the next segment, in the next face, may be meant
    FT nearest = FT(nearby) * length(q - p) + Number_policy<FT>::rounding(1 << 12) * (start.distance + extent);
    const auto consider = [&](Index primitive) {
      const Source_place<FT>& place = m_initial.places[primitive];
      if (m_initial.source_of[primitive] != m_initial.source_of[start.root.primitive()] ||
          !is_in_face(place.first, face) || !is_in_face(place.second, face))
        return;
      Surface_point_ point = place.first;
      const Point foot = foot_in(face, frame, p, primitive, point);
      if constexpr (Estimation<FT>::leaves_open)
      {
        const auto way = foot - p, straight = q - p, miss = foot - q;
        const auto missed = estimate(dot(miss, miss));
        if (CGAL::certainly(estimate(dot(way, way)) > estimate(dot(straight, straight))) ||
            !CGAL::possibly(missed < CGAL::square(estimate(nearest))))
          return;
        nearest = Estimation<FT>::upper_cut(CGAL::sqrt(missed));
      }
      else
      {
        const FT miss = length(foot - q);
        if (length(foot - p) > longest || !(miss < nearest)) return;
        nearest = miss;
      }
      end = {point, primitive};
    };
    consider(start.root.primitive());
    const auto local = local_windows(m_initial, face);
    for (auto i = local.first; i != local.second; ++i) consider(i->window.root.primitive());
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      m_initial.for_each_edge_window(h, [&](const auto& w) { consider(w.root.primitive()); });
    return end.primitive != no_index;
  }

private:
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

  // The nearest point of a point or segment that lies in the face; p lies there, too.
  Point foot_in(Index face, const Face_frame<FT>& frame, const Point& p, Index primitive, Surface_point_& nearest) const
  {
    const Source_place<FT>& place = m_initial.places[primitive];
    Point a, b;
    unsigned edges_of_a, edges_of_b;
    position_in_face(m_mesh, place.first, face, a, edges_of_a);
    nearest = place.first;
    if (!m_initial.primitives[primitive].is_segment) return a;
    position_in_face(m_mesh, place.second, face, b, edges_of_b);
    const Point u = b - a;
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
