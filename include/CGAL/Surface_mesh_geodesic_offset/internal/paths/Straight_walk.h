// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight on through the unfolded faces, from a point towards another one: from edge to edge, always in the frame of the
// halfedge through which the way has entered the face.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_STRAIGHT_WALK_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_STRAIGHT_WALK_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>

#include <array>

namespace CGAL::Geodesic_offset::internal {

// Edges and corners of the face are counted from the halfedge of the frame: edge k goes from corner k to corner k + 1. The next
// edge is unpredictable, so data are read by index, without branches.
template <class FT>
class Straight_walk
{
public:
  typedef Point_in_face<FT> Point;

  // Exit of the path through an edge: the position on the edge, and the goal, in the frame of the twin.
  struct Crossing
  {
    FT t, length; // position on the edge, and length of the edge
    Point goal;
  };

  // Both points are in the frame of h; `from` lies in its face.
  Straight_walk(const Unfolded_mesh<FT>& mesh, Index h, const Point& from, const Point& goal)
    : Straight_walk(mesh, h, from, goal, goal - from)
  {
  }

  // Overload with the direction of the way, a vector of any length.
  Straight_walk(const Unfolded_mesh<FT>& mesh, Index h, const Point& from, const Point& goal, const Point& direction)
    : m_mesh(&mesh), m_position(from), m_goal(goal), m_direction_of_way(direction)
  {
    enter(h);
  }

  Index halfedge() const { return m_edge[0]; }
  Index face() const { return m_edge[0] / 3; }
  const Point& position() const { return m_position; }
  const Point& goal() const { return m_goal; }

  // The direction of the way, if numbers are inexact: the vector from the position to the goal loses its digits near the goal.
  const Point& direction() const { return m_direction_of_way; }

  Index edge(int k) const { return m_edge[k]; }
  Index vertex(int k) const { return (*m_mesh)[m_edge[k]].origin; }
  Index beyond(int k) const { return (*m_mesh)[m_edge[k]].twin; }
  const Point& corner(int k) const { return m_corner[k]; }

  // Upper bound of the longest edge of the face.
  FT extent() const { return m_length[0] + m_length[1]; }

  // Positive for a corner on the left of the path: its distance from the path times that of the goal.
  FT side(int k) const { return cross(m_goal - m_position, m_corner[k] - m_position); }

  // Exit edge of a path that entered through the frame's halfedge.
  int exit() const { return 2 - int(CGAL::is_positive(side(2))); }

  // Exit edge of a path that starts anywhere in the face.
  int exit_from_inside() const
  {
    for (int k = 0; k < 3; ++k)
      if (!CGAL::is_positive(side(k)) && CGAL::is_positive(side(after(k)))) return k;
    return 0;
  }

  Crossing crossing(int k) const
  {
    const FT first = side(k), last = side(after(k)), &length = m_length[k]; // right and left
    const Point &u = m_direction[k], g = m_goal - m_corner[after(k)];
    const FT t = !CGAL::is_positive(last) ? FT(0) : !CGAL::is_negative(first) ? length : FT(last / (last - first) * length);
    return {t, length, {dot(u, g), cross(u, g)}};
  }

  // Crosses edge k, which is not on the border.
  void cross_over(int k, const Crossing& c)
  {
    m_position = {c.t, FT(0)};
    m_goal = c.goal;
    if constexpr (Number_policy<FT>::is_inexact)
      m_direction_of_way = {dot(m_direction[k], m_direction_of_way), cross(m_direction[k], m_direction_of_way)};
    enter(beyond(k));
  }

private:
  static int after(int k) { return (k + 1) % 3; }

  void enter(Index h)
  {
    const Index first = h - h % 3;
    m_edge = {h, first + (h + 1) % 3, first + (h + 2) % 3};
    const auto &e = (*m_mesh)[h], &n = (*m_mesh)[m_edge[1]], &p = (*m_mesh)[m_edge[2]];
    m_length = {e.length, n.length, p.length};
    m_corner = {Point{FT(0), FT(0)}, Point{e.length, FT(0)}, Point{e.apex_x, e.apex_y}};
    // The angle at the target comes from the vectors there: differences of coordinates would lose all digits on a tiny edge.
    const FT to_unit = FT(1) / e.length, to_unit_left = FT(1) / p.length;
    m_direction = {Point{FT(-1), FT(0)}, Point{to_unit * n.apex_x, -to_unit * n.apex_y},
                   Point{to_unit_left * e.apex_x, to_unit_left * e.apex_y}};
  }

  const Unfolded_mesh<FT>* m_mesh;
  Point m_position, m_goal, m_direction_of_way;
  Per_corner<Index> m_edge;
  Per_corner<FT> m_length;
  Per_corner<Point> m_corner, m_direction; // m_direction: x axes of the frames of the twins
};

} // namespace CGAL::Geodesic_offset::internal

#endif
