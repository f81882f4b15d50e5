// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Directions around a vertex. A sector consists of the directions between two rays. The sectors behind a vertex contain the
// directions in which shortest paths through the vertex continue; a margin is a narrow sector beside one of them. Directions
// are turned from corner to corner, with unfolded vectors and side tests, without angles.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_VERTEX_SECTOR_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_VERTEX_SECTOR_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <algorithm>
#include <cstdint>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
inline FT cross(const FT& ax, const FT& ay, const FT& bx, const FT& by)
{
  return ax * by - ay * bx;
}

// Turns a vector from the frame of the halfedge `from` to that of `to`, which has the same source vertex. The faces between are
// unfolded: those counterclockwise of `to`, or those clockwise. Returns false if the border is between.
template <class FT>
bool turn_to_corner(const Unfolded_mesh<FT>& mesh, Index from, Index to, bool ccw, Point_in_face<FT>& u)
{
  Point_in_face<FT> turn{FT(1), FT(0)}; // from the frame of `at` to that of `to`, if counterclockwise, or back
  const auto add = [&](Index corner) {
    FT c, s;
    mesh.corner_direction(corner, c, s);
    turn = {turn.x * c - turn.y * s, turn.x * s + turn.y * c};
  };
  for (Index at = to; at != from;)
  {
    if (ccw) add(at);
    at = ccw ? mesh.corner_ccw(at) : mesh.corner_cw(at);
    if (at == no_index || at == to) return false;
    if (!ccw) add(at);
  }
  if (!ccw) turn.y = -turn.y;
  u = {turn.x * u.x - turn.y * u.y, turn.y * u.x + turn.x * u.y};
  return true;
}

template <class FT>
class Vertex_sector
{
public:
  typedef Ray_at_vertex<FT> Ray;

  explicit Vertex_sector(const Unfolded_mesh<FT>& mesh) : m_mesh(&mesh) {}

  // Turns `ray` counterclockwise by one or two quarter turns, minus an angle with tangent `less`. The result has no corner
  // if the border comes first.
  Ray turn_ccw(const Ray& ray, int quarter_turns, const FT& less = FT(0)) const
  {
    Ray r = ray;
    r.x = quarter_turns == 1 ? FT(less * ray.x - ray.y) : FT(-ray.x - less * ray.y);
    r.y = quarter_turns == 1 ? FT(ray.x + less * ray.y) : FT(less * ray.x - ray.y);
    // A corner is narrower than a half turn, so a half turn always leaves the first corner.
    bool may_be_inside = quarter_turns == 1 || !CGAL::is_zero(less);
    const Index limit = Index(m_mesh->number_of_halfedges());
    for (Index guard = 0; guard <= limit; ++guard)
    {
      const auto& h = (*m_mesh)[r.corner];
      if (may_be_inside && !CGAL::is_positive(cross(h.apex_x, h.apex_y, r.x, r.y))) return r;
      may_be_inside = true;
      FT c, s;
      m_mesh->corner_direction(r.corner, c, s);
      const FT t = c * r.x + s * r.y;
      r.y = c * r.y - s * r.x;
      r.x = t;
      r.corner = m_mesh->corner_ccw(r.corner);
      if (r.corner == no_index) return r;
    }
    return Ray();
  }

  Ray turn_cw(const Ray& ray, int quarter_turns, const FT& less = FT(0)) const
  {
    Ray r = ray;
    r.x = quarter_turns == 1 ? FT(ray.y + less * ray.x) : FT(less * ray.y - ray.x);
    r.y = quarter_turns == 1 ? FT(less * ray.y - ray.x) : FT(-ray.y - less * ray.x);
    bool may_be_inside = quarter_turns == 1 || !CGAL::is_zero(less);
    const Index limit = Index(m_mesh->number_of_halfedges());
    for (Index guard = 0; guard <= limit; ++guard)
    {
      if (may_be_inside && !CGAL::is_negative(r.y)) return r;
      may_be_inside = true;
      r.corner = m_mesh->corner_cw(r.corner);
      if (r.corner == no_index) return r;
      FT c, s;
      m_mesh->corner_direction(r.corner, c, s);
      const FT t = c * r.x - s * r.y;
      r.y = s * r.x + c * r.y;
      r.x = t;
    }
    return Ray();
  }

  // True if the border lies between a and b, counterclockwise from a.
  bool passes_border(const Ray& a, const Ray& b) const
  {
    if (same_corner_in_order(a, b)) return false;
    for (Index c = m_mesh->corner_ccw(a.corner); c != no_index; c = m_mesh->corner_ccw(c))
    {
      if (c == b.corner) return false;
      if (c == a.corner) return false;
    }
    return true;
  }

  // True if the counterclockwise angle from a to b (a full turn if they are equal) is at least pi, minus an angle with
  // tangent `less`. Precondition: no border lies between.
  bool is_reflex(const Ray& a, const Ray& b, const FT& less = FT(0)) const
  {
    const Ray half = turn_ccw(a, 2, less);
    if (half.corner == no_index) return false;
    const auto is_behind_half = [&] { return !CGAL::is_negative(cross(half.x, half.y, b.x, b.y)); };
    if (half.corner == a.corner && corner_contains_half_turn(a, less)) return !same_corner_in_order(a, b) || is_behind_half();
    if (same_corner_in_order(a, b)) return false;
    for (Index c = m_mesh->corner_ccw(a.corner); c != no_index; c = m_mesh->corner_ccw(c))
    {
      if (c == half.corner) return c != b.corner || is_behind_half();
      if (c == b.corner || c == a.corner) return false;
    }
    return false;
  }

  // True if `from` precedes `to`, counterclockwise from a. Here `from` is a turned by a quarter turn, and `to` is a quarter
  // turn before a second ray b. If the angle from a to b is a half turn, `from` and `to` are equal, and rounding may reverse
  // them.
  bool come_in_order(const Ray& a, const Ray& from, const Ray& to) const
  {
    if (from.corner == to.corner) return true; // for_each_corner() decides
    if (to.corner == a.corner) return !same_corner_in_order(a, to);
    return !comes_first(to.corner, a.corner, from.corner);
  }

  // Calls f(corner, lower, upper) for each corner that the sector from `from` counterclockwise to `to` meets. `lower` and
  // `upper` point to the bounding rays of the sector in this corner; null stands for an edge of the corner. If `from` has no
  // corner, the sector begins at the border edge of `first`; if `to` has none, it ends at the other border edge.
  template <class Function>
  void for_each_corner(const Ray& from, const Ray& to, Index first, const Function& f) const
  {
    Index c = from.corner != no_index ? from.corner : first;
    const Index start = c;
    if (from.corner != no_index && from.corner == to.corner)
    {
      // a narrow sector inside one corner, or nothing: a sector never closes on itself
      if (CGAL::is_positive(cross(from.x, from.y, to.x, to.y))) f(c, &from, &to);
      return;
    }
    const Ray* lower = from.corner != no_index ? &from : nullptr;
    do {
      const bool last = c == to.corner;
      f(c, lower, last ? &to : nullptr);
      lower = nullptr;
      if (last) return;
      c = m_mesh->corner_ccw(c);
    } while (c != no_index && c != start);
  }

  // Shortest paths that arrive at a vertex from direction `back` continue at angles of at least pi to it on either side.
  // Calls f(from, to, first), with arguments for for_each_corner(), for each sector of these directions. `angle`, the error
  // of `back`, widens sectors at both ends.
  template <class Function>
  void for_each_sector_behind(const Ray& back, const Function& f, const FT& angle = FT(0)) const
  {
    const Ray from = half_turn_ccw(back, angle), to = half_turn_cw(back, angle);
    const Index first = m_mesh->first_on_border(back.corner);
    if (first != no_index)
    {
      if (from.corner != no_index) f(from, Ray(), first);
      if (to.corner != no_index) f(Ray(), to, first);
    }
    // If the total angle is 2 pi up to rounding, the two limits may be reversed: then there is no sector.
    else if (exist(from, to) && !comes_first(back.corner, from.corner, to.corner)) f(from, to, from.corner);
  }

  // If two directions differ by a narrow angle, calls f(from, to, first), as above, for the sector between the ends of the sectors
  // behind each, on the side of `other`: directions behind `other` alone, and those between the two sectors. Returns false without
  // a call if the angle is not narrow.
  template <class Function>
  bool for_sector_behind_other(const Ray& known, const Ray& other, const Function& f) const
  {
    const FT angle = narrow_angle(known, other);
    if (CGAL::is_zero(angle) || m_mesh->first_on_border(known.corner) != no_index) return false;
    const bool is_left = CGAL::is_positive(angle);
    const Ray from = is_left ? turn_cw(known, 2) : turn_ccw(other, 2), to = is_left ? turn_cw(other, 2) : turn_ccw(known, 2);
    // Rounding may reverse directions that are nearly equal; then no corner lies between.
    if (!exist(from, to) || !CGAL::is_positive(narrow_angle(from, to))) return false;
    if (to.corner != from.corner && to.corner != m_mesh->corner_ccw(from.corner)) return false;
    f(from, to, from.corner);
    return true;
  }

  // Intersection of the sector [from, to] with the corner at the source of h: its bounding rays, null for the edges of the
  // corner. False if empty.
  bool part_in_corner(const Ray& from, const Ray& to, Index first, Index h, const Ray*& lower, const Ray*& upper) const
  {
    bool found = false;
    for_each_corner(from, to, first, [&](Index c, const Ray* l, const Ray* u) {
      if (c != h) return;
      found = true;
      lower = l;
      upper = u;
    });
    return found;
  }

  // Intersection of a ray from the source of h with the opposite edge, in the frame of that edge's twin.
  FT exit_of_ray(Index h, const Ray& r) const
  {
    const FT length = (*m_mesh)[m_mesh->next(h)].length;
    const FT b = cross(r.x, r.y, (*m_mesh)[h].apex_x, (*m_mesh)[h].apex_y), a = cross(r.x, r.y, (*m_mesh)[h].length, FT(0));
    if (!CGAL::is_positive(b)) return FT(0);
    if (!CGAL::is_negative(a)) return length;
    return (b / (b - a)) * length;
  }

private:
  // The tangent of the counterclockwise angle from a to b, if it is narrow; zero if not.
  FT narrow_angle(const Ray& a, const Ray& b) const
  {
    Point_in_face<FT> u{b.x, b.y};
    if (b.corner != a.corner)
    {
      const bool is_ccw = b.corner == m_mesh->corner_ccw(a.corner);
      if (!is_ccw && a.corner != m_mesh->corner_ccw(b.corner)) return FT(0);
      turn_to_corner(*m_mesh, b.corner, a.corner, is_ccw, u);
    }
    const FT sine = cross(a.x, a.y, u.x, u.y), along = a.x * u.x + a.y * u.y;
    return along > FT(0) && CGAL::abs(sine) <= FT(widest_narrow_angle) * along ? FT(sine / along) : FT(0);
  }

  // Widest angle between two paths to a vertex for which the rays between those behind each are started: a path that bends by this
  // angle is longer by less than rounding, 2^-53 of its length.
  static constexpr double widest_narrow_angle = 0x1p-26;

  // False if turns around an interior vertex have failed: the total angle is so small that a half turn passes more corners than
  // the mesh has halfedges. (At a border vertex, a ray without a corner stands for the border.)
  static bool exist(const Ray& a, const Ray& b) { return a.corner != no_index && b.corner != no_index; }

  // Turns `back` by a half turn minus an angle. The angle is subtracted after the first quarter turn: `back` may lie on the
  // border, and cannot be turned beyond it.
  Ray half_turn_ccw(const Ray& back, const FT& angle) const
  {
    if (CGAL::is_zero(angle)) return turn_ccw(back, 2);
    const Ray quarter = turn_ccw(back, 1);
    return quarter.corner == no_index ? quarter : turn_ccw(turned(quarter, FT(-angle)), 1);
  }

  Ray half_turn_cw(const Ray& back, const FT& angle) const
  {
    if (CGAL::is_zero(angle)) return turn_cw(back, 2);
    const Ray quarter = turn_cw(back, 1);
    return quarter.corner == no_index ? quarter : turn_cw(turned(quarter, angle), 1);
  }

  // Turns the ray counterclockwise by a small angle, at most to the border. The angle may span several corners.
  Ray turned(const Ray& ray, const FT& angle) const
  {
    Ray r{ray.corner, ray.x - angle * ray.y, ray.y + angle * ray.x};
    FT c, s;
    for (Index limit = Index(m_mesh->number_of_halfedges()); limit != 0; --limit)
    {
      if (CGAL::is_positive(angle))
      {
        const auto& h = (*m_mesh)[r.corner];
        if (!CGAL::is_positive(cross(h.apex_x, h.apex_y, r.x, r.y))) return r;
        const Index after = m_mesh->corner_ccw(r.corner);
        if (after == no_index) return {r.corner, h.apex_x, h.apex_y};
        m_mesh->corner_direction(r.corner, c, s);
        r = {after, c * r.x + s * r.y, c * r.y - s * r.x};
      }
      else
      {
        if (!CGAL::is_negative(r.y)) return r;
        const Index before = m_mesh->corner_cw(r.corner);
        if (before == no_index) return {r.corner, FT(1), FT(0)};
        m_mesh->corner_direction(before, c, s);
        r = {before, c * r.x - s * r.y, s * r.x + c * r.y};
      }
    }
    return ray;
  }

  // True if a half turn from a, minus an angle with tangent `less`, ends in the corner of a.
  bool corner_contains_half_turn(const Ray& a, const FT& less) const
  {
    const auto& h = (*m_mesh)[a.corner];
    return !CGAL::is_zero(less) && !CGAL::is_positive(cross<FT>(h.apex_x, h.apex_y, -a.x - less * a.y, less * a.x - a.y));
  }

  bool comes_first(Index c, Index from, Index to) const
  {
    for (Index i = from; i != no_index && i != to; i = m_mesh->corner_ccw(i))
      if (i == c) return true;
    return false;
  }

  bool same_corner_in_order(const Ray& a, const Ray& b) const
  {
    return a.corner == b.corner && CGAL::is_positive(cross(a.x, a.y, b.x, b.y));
  }

  const Unfolded_mesh<FT>* m_mesh;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
