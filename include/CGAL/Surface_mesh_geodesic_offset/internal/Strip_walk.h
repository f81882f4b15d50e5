// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight on through the unfolded faces as quickly as can be, as long as nothing is in the way.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_STRIP_WALK_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_STRIP_WALK_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Straight_walk.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Surface_point.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// What ends the quick walk: the goal in sight, or a vertex so near to the way that it may be on it.
template <class FT>
struct Strip_limits
{
  Index vertex, face, other_face; // of the goal; no_index if none
  FT nearby;                      // how near to the way, as part of the edges and of `reach`
  FT reach;                       // added to the edges
  FT beside;                      // so high the goal must be over an edge that is crossed on the way to it
};

// The strip of faces lies in the plane such that the way goes from the origin along the x axis: which edge comes next is
// told by the height of one vertex. Nothing branches on it, since it can't be foreseen, and of what is computed only this
// height and the direction of the next edge are waited for.
template <class FT>
class Strip_walk
{
public:
  typedef Point_in_face<FT> Point;

  // The way leaves the face where it is through the edge k.
  Strip_walk(const Unfolded_mesh<FT>& mesh, const Straight_walk<FT>& first, int k) : m_mesh(mesh)
  {
    const Point way = first.goal() - first.position();
    m_length = length(way);
    const Point d = (FT(1) / m_length) * way;
    const auto lay = [&](const Point& v) { return Point{dot(d, v), cross(d, v)}; };
    const int after = (k + 1) % 3;
    m_halfedge = first.beyond(k);
    m_source = first.vertex(after);
    m_target = first.vertex(k);
    m_at_source = lay(first.corner(after) - first.position());
    m_at_target = lay(first.corner(k) - first.position());
    m_direction = lay(first.direction_beyond(k));
    m_extent = first.extent();
  }

  // Walks on and appends the edges that are crossed. It ends in a face with the goal or with something in its way: then the
  // face has been entered through `halfedge()`. Tells whether it has entered any.
  template <class Passed>
  bool operator()(const Strip_limits<FT>& limits, Passed& passed)
  {
    Index h = m_halfedge, source = m_source, target = m_target;
    Point s = m_at_source, t = m_at_target, e = m_direction;
    if (h == no_index || is_obstructed(limits, s, t, e, m_extent) ||
        (std::min)(s.y, FT(-t.y)) <= limits.nearby * (m_extent + limits.reach))
      return false;
    for (;;)
    {
      passed.push_back({h, source, target, FT(s.y / (s.y - t.y))});
      const Index next = Unfolded_mesh<FT>::next(h), previous = Unfolded_mesh<FT>::previous(h);
      const auto &a = m_mesh[h], &b = m_mesh[next], &c = m_mesh[previous];
      const Point apex{s.x + (e.x * a.apex_x - e.y * a.apex_y), s.y + (e.x * a.apex_y + e.y * a.apex_x)};
      const int is_left = CGAL::is_positive(apex.y); // of the way, which then leaves between it and the target
      // directions of the next edges from their own ends, not from differences of coordinates: edges may be tiny
      const FT unit = FT(1) / c.length, unit_right = FT(1) / a.length;
      const Point turns[2] = {{unit * a.apex_x, unit * a.apex_y}, {unit_right * b.apex_x, -unit_right * b.apex_y}};
      const Point directions[2] = {{e.x * turns[0].x - e.y * turns[0].y, e.x * turns[0].y + e.y * turns[0].x},
                                   {e.x * turns[1].x - e.y * turns[1].y, e.x * turns[1].y + e.y * turns[1].x}};
      const Point sources[2] = {s, apex}, targets[2] = {apex, t};
      const Index exits[2] = {c.twin, b.twin};
      const FT extent = b.length + c.length;
      const Index beyond = exits[is_left];
      if (int(c.origin == limits.vertex) | int(h / 3 == limits.face) | int(h / 3 == limits.other_face) |
          int(beyond == no_index) | int(CGAL::abs(apex.y) <= limits.nearby * (extent + limits.reach)) |
          int(is_obstructed(limits, sources[is_left], targets[is_left], directions[is_left], extent)))
      {
        m_halfedge = h;
        m_at_source = s;
        m_at_target = t;
        m_direction = e;
        m_apex = apex;
        m_extent = a.length + extent;
        return true;
      }
      source = is_left ? c.origin : source;
      target = is_left ? target : c.origin;
      s = sources[is_left];
      t = targets[is_left];
      e = directions[is_left];
      h = beyond;
    }
  }

  Index halfedge() const { return m_halfedge; }

  // In the frame of the halfedge: where it is crossed, and the goal.
  Point position() const { return {part() * m_mesh[m_halfedge].length, FT(0)}; }
  Point goal() const
  {
    const Point v = Point{m_length, FT(0)} - m_at_source;
    return {dot(m_direction, v), cross(m_direction, v)};
  }

  FT way_left() const { return m_length - x(); }
  FT way_to_apex() const { return length(m_apex - Point{x(), FT(0)}); }
  FT extent() const { return m_extent; } // no smaller than the longest edge of the face

private:
  FT part() const { return m_at_source.y / (m_at_source.y - m_at_target.y); }
  FT x() const { return m_at_source.x + part() * (m_at_target.x - m_at_source.x); }

  // Whether the way passes near to an end of an edge, or the goal is not clearly beyond it.
  bool is_obstructed(const Strip_limits<FT>& limits, const Point& s, const Point& t, const Point& e, const FT& extent) const
  {
    const FT height = s.y - t.y, of_goal = e.y * (s.x - m_length) - e.x * s.y;
    return int((std::min)(s.y, FT(-t.y)) <= limits.nearby * height) |
           int(of_goal <= limits.beside + Number_policy<FT>::rounding(1 << 12) * extent);
  }

  const Unfolded_mesh<FT>& m_mesh;
  FT m_length;                 // of the way
  Index m_halfedge;            // that has been crossed
  Index m_source, m_target;    // its vertices
  Point m_at_source, m_at_target, m_direction, m_apex;
  FT m_extent;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
