// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight walk through unfolded faces at the highest speed, as long as no vertex is close.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_STRIP_WALK_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_STRIP_WALK_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/memory/prefetch.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>
#include <boost/container/container_fwd.hpp>

#include <algorithm>
#include <cstddef>

namespace CGAL::Geodesic_offset::internal {

// The strip of faces is unfolded such that the path runs from the origin along the x axis. The height of one vertex determines
// the next edge, so the walk waits only for the direction of this edge.
template <class FT>
class Strip_walk
{
public:
  typedef Point_in_face<FT> Point;

  // The path starts at `from`, in the frame of the halfedge h and in its face, leaves the face through edge k, counted from h,
  // and goes to `to`, at the distance `length`.
  Strip_walk(const Unfolded_mesh<FT>& mesh, Index h, const Point& from, const Point& to, const FT& length, int k)
    : m_mesh(mesh), m_length(length)
  {
    CGAL_precondition(0 <= k && k < 3 && CGAL::is_positive(length));
    const Point d = (FT(1) / length) * (to - from);
    const auto lay = [&](const Point& v) { return Point{dot(d, v), cross(d, v)}; };
    const Index n = m_mesh.next(h), p = m_mesh.previous(h);
    const Point corner{FT(0), FT(0)}, corner_1{mesh[h].length, FT(0)}, corner_2{mesh[h].apex_x, mesh[h].apex_y};
    // With the unit vector along the twin of the edge.
    const auto start = [&](Index edge, Index after, const Point& left, const Point& right, const Point& back) {
      m_halfedge = mesh[edge].twin;
      m_vertex[0] = mesh[after].origin;
      m_vertex[1] = mesh[edge].origin;
      m_end[0] = lay(left - from);
      m_end[1] = lay(right - from);
      m_direction = lay(back);
    };
    if (k == 0) start(h, n, corner_1, corner, {FT(-1), FT(0)});
    else
    {
      const FT unit = FT(1) / mesh[k == 1 ? h : p].length;
      if (k == 1) start(n, p, corner_2, corner_1, {unit * mesh[n].apex_x, -unit * mesh[n].apex_y});
      else start(p, h, corner, corner_2, {unit * corner_2.x, unit * corner_2.y});
    }
  }

  // Walks and appends the crossed edges, up to a vertex within `beside` of the path, to a next edge over which the goal is at
  // most `ahead` high, or to the border. The last face was entered through `halfedge()`. Returns true if a face was entered.
  template <class Passed>
  bool operator()(const FT& beside, const FT& ahead, Passed& passed)
  {
    Index h = m_halfedge;
    Point e = m_direction;
    // Written such that NaN ends the walk.
    if (h == no_index || !((std::min)(m_end[0].y, FT(-m_end[1].y)) > beside) || !(height_of_goal(m_end[0], e) > ahead))
      return false;
    Index left = m_vertex[0], right = m_vertex[1];
    Point l = m_end[0], r = m_end[1], apex;
    const Unfolded_halfedge<FT>* const mesh = &m_mesh[0];
    typename Passed::value_type *out = nullptr, *last = nullptr;
    // Crosses an edge of the face with the direction d. Returns false if a vertex is close.
    const auto goes_on = [&](Index beyond, const Point& d) {
      return beyond != no_index && CGAL::abs(apex.y) > beside && height_of_goal(apex, d) > ahead;
    };
    FT unit = FT(1) / mesh[h].length; // both halfedges have the same length
    for (;;)
    {
      if (out == last && !make_room(passed, out, last)) return false;
      *out++ = passed.item({h, left, right, FT(l.y / (l.y - r.y))});
      const auto &a = mesh[h], &c = mesh[m_mesh.previous(h)], &b = mesh[m_mesh.next(h)];
      prefetch_element(mesh, b.twin);
      prefetch_element(mesh, c.twin);
      apex = {l.x + (e.x * a.apex_x - e.y * a.apex_y), l.y + (e.x * a.apex_y + e.y * a.apex_x)};
      // The unit vector along the twin of the next edge is not computed from coordinates, as edges may be tiny. A branch
      // predicted half of the time is faster than waiting for each turn.
      if (CGAL::is_positive(apex.y))
      {
        const Point d = turned(e, {unit * b.apex_x, -unit * b.apex_y});
        if (!goes_on(b.twin, d)) break;
        unit = FT(1) / b.length;
        e = d;
        left = c.origin;
        l = apex;
        h = b.twin;
      }
      else
      {
        unit = FT(1) / c.length;
        const Point d = turned(e, {unit * a.apex_x, unit * a.apex_y});
        if (!goes_on(c.twin, d)) break;
        e = d;
        right = c.origin;
        r = apex;
        h = c.twin;
      }
    }
    m_halfedge = h;
    m_end[0] = l;
    m_end[1] = r;
    m_direction = e;
    m_apex = apex;
    passed.resize(std::size_t(out - passed.data()));
    return true;
  }

  Index halfedge() const { return m_halfedge; }

  // In the frame of the halfedge: the crossing, the goal, and the direction of the way.
  Point position() const { return {part() * m_mesh[m_halfedge].length, FT(0)}; }
  Point goal() const
  {
    const Point v = Point{m_length, FT(0)} - m_end[0];
    return {dot(m_direction, v), cross(m_direction, v)};
  }
  Point direction() const { return {m_direction.x, -m_direction.y}; }

  FT way_left() const { return m_length - x(); }
  FT way_to_apex() const { return length(m_apex - Point{x(), FT(0)}); }

private:
  // Makes room for more crossings at once; a call for each would cost more than the crossing. No walk crosses more edges than
  // exist.
  template <class Passed>
  BOOST_NOINLINE bool make_room(Passed& passed, typename Passed::value_type*& out, typename Passed::value_type*& last) const
  {
    const std::size_t size = passed.size(), more = 64;
    if (size > m_mesh.number_of_halfedges())
    {
      passed.clear();
      return false;
    }
    passed.resize(size + more, boost::container::default_init);
    out = passed.data() + size;
    last = out + more;
    return true;
  }

  FT part() const { return m_end[0].y / (m_end[0].y - m_end[1].y); }
  FT x() const { return m_end[0].x + part() * (m_end[1].x - m_end[0].x); }

  static Point turned(const Point& e, const Point& turn) { return {e.x * turn.x - e.y * turn.y, e.x * turn.y + e.y * turn.x}; }

  // Height over an edge with the direction e and the end p.
  FT height_of_goal(const Point& p, const Point& e) const { return e.y * (p.x - m_length) - e.x * p.y; }

  const Unfolded_mesh<FT>& m_mesh;
  FT m_length;       // of the path
  Index m_halfedge;  // next or last crossed halfedge
  Index m_vertex[2]; // its left and right end
  Point m_end[2], m_direction, m_apex;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
