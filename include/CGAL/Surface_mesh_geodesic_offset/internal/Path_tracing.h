// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A shortest path back to the source: straight on through the unfolded faces, from pseudo-source to pseudo-source. It takes
// windows only where it starts, and none at all at a vertex.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATH_TRACING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATH_TRACING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Path_start.h>

#include <algorithm>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Path_tracing
{
public:
  typedef Point_in_face<FT> Point;
  typedef Surface_point<FT> Surface_point_;

  Path_tracing(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_initial(initial), m_field(field), m_start(mesh, initial, field)
  {
  }

  // Calls out(surface point) for p, where the path starts as told, for each edge that it crosses and each vertex that it
  // passes, and for the source point where it ends. Returns the primitive where it ends. Nothing if p is not reached.
  template <class Function>
  Index operator()(const Surface_point_& p, Path_start<FT> start, const Function& out) const
  {
    if (!start.is_reached()) return no_index;
    out(p);
    const Index limit = Index(m_mesh.number_of_vertices());
    for (Index guard = 0; start.face != no_index && CGAL::is_positive(start.distance) && guard <= limit; ++guard)
    {
      const End end = follow(start, out);
      out(end.point);
      if (end.primitive != no_index) return end.primitive;
      start = m_start.at_vertex(end.point.element);
    }
    return start.root.primitive();
  }

private:
  struct End
  {
    Surface_point_ point;
    Index primitive; // no_index at a vertex on the way
  };

  static constexpr double nearby = 1. / (1 << 30); // part of an edge: a path so near to a vertex may be meant to pass it

  // Goes straight on to the source, the pseudo-source, or a vertex that is on the way up to rounding: from there its own
  // shortest path is as short as any.
  template <class Function>
  End follow(const Path_start<FT>& start, const Function& out) const
  {
    Index face = start.face;
    Point p = start.from, q = start.to;
    int exit = start.exit;
    const Index limit = Index(m_mesh.number_of_halfedges());
    Face_frame<FT> frame(m_mesh, face);
    Index last_vertex = no_index;
    for (Index guard = 0; guard <= limit; ++guard)
    {
      if (End end; ends_in(face, frame, p, q, start, end)) return end;
      if (exit == -1) exit = exit_from_inside(frame, p, q);
      const Index h = 3 * face + Index(exit);
      const FT t = position_of_exit(frame, exit, p, q), size = m_mesh[h].length;
      const bool is_border = m_mesh.twin(h) == no_index;
      const bool ahead = CGAL::is_positive(dot(q - p, frame.direction(exit)));
      for (const bool at_target : {ahead, !ahead})
      {
        const Index v = at_target ? m_mesh.target(h) : m_mesh.source(h);
        const Point to_vertex = frame.corner(at_target ? (exit + 1) % 3 : exit) - p;
        const FT off = cross(q - p, to_vertex), near = FT(nearby) * FT(nearby) * dot(q - p, q - p);
        const bool passes = off * off <= near * (dot(to_vertex, to_vertex) + start.distance * start.distance * FT(nearby)) ||
                            (at_target ? size - t : t) <= FT(nearby) * size;
        if ((passes && is_way_by(v, length(to_vertex), length(q - p), start)) ||
            (is_border && m_field.distance[v] < start.distance))
          return at_vertex(v);
      }
      if (is_border) break;
      // vertices in the way that the path passes by, but not as closely as to start from there anew
      const FT rounding = Number_policy<FT>::rounding(4) * size;
      const Index v = t <= rounding ? m_mesh.source(h) : t >= size - rounding ? m_mesh.target(h) : no_index;
      if (v == no_index)
        out(Surface_point_::on_edge(h, t));
      else if (v != last_vertex)
        out(Surface_point_::at_vertex(v));
      last_vertex = v;
      p = frame.on_edge(exit, t);
      exit = cross_edge(m_mesh, face, frame, exit, p, q);
    }
    // rounding at the border, and nothing better to say
    if (start.pseudo_source != no_index) return at_vertex(start.pseudo_source);
    return {m_initial.places[start.root.primitive()].first, start.root.primitive()};
  }

  End at_vertex(Index v) const
  {
    return {Surface_point_::at_vertex(v), CGAL::is_zero(m_field.distance[v]) ? m_field.root[v].primitive() : no_index};
  }

  // Whether the way by a vertex is as short as the rest of the path, straight on.
  bool is_way_by(Index v, const FT& to_vertex, const FT& straight_on, const Path_start<FT>& start) const
  {
    const FT& d = m_field.distance[v];
    const FT rest = start.pseudo_source == no_index ? straight_on : FT(straight_on + m_field.distance[start.pseudo_source]);
    return d < start.distance && d + to_vertex <= rest + Number_policy<FT>::rounding(256) * start.distance;
  }

  // The edge that the way from a point inside the face leaves through.
  static int exit_from_inside(const Face_frame<FT>& frame, const Point& p, const Point& q)
  {
    const auto is_on_left = [&](int k) { return CGAL::is_positive(cross(q - p, frame.corner(k % 3) - p)); };
    for (int k = 0; k < 3; ++k)
      if (!is_on_left(k) && is_on_left(k + 1)) return k;
    return 0;
  }

  static FT position_of_exit(const Face_frame<FT>& frame, int k, const Point& p, const Point& q)
  {
    const FT a = cross(q - p, frame.corner(k) - p), b = cross(q - p, frame.corner((k + 1) % 3) - p);
    if (!CGAL::is_negative(a)) return FT(0);
    if (!CGAL::is_positive(b)) return frame.edge_length(k);
    return (a / (a - b)) * frame.edge_length(k);
  }

  bool is_in_face(const Surface_point_& p, Index face) const
  {
    if (p.kind == Surface_point_::FACE) return p.element == face;
    if (p.kind == Surface_point_::EDGE)
      return m_mesh.face(p.element) == face ||
             (m_mesh.twin(p.element) != no_index && m_mesh.face(m_mesh.twin(p.element)) == face);
    const Index h = 3 * face;
    return m_mesh.source(h) == p.element || m_mesh.source(h + 1) == p.element || m_mesh.source(h + 2) == p.element;
  }

  // In a face that the end lies in too, the straight way to it is the shortest, as it is the shortest in space. A path to
  // one segment may end at another one of the source: windows of segments in one line have become one.
  bool ends_in(Index face, const Face_frame<FT>& frame, const Point& p, const Point& q, const Path_start<FT>& start,
               End& end) const
  {
    if (start.pseudo_source != no_index)
    {
      end = at_vertex(start.pseudo_source);
      return is_in_face(end.point, face);
    }
    if (!m_initial.primitives[start.root.primitive()].is_segment)
    {
      end = {m_initial.places[start.root.primitive()].first, start.root.primitive()};
      return is_in_face(end.point, face);
    }
    end.primitive = no_index;
    const FT extent = frame.longest_edge();
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
      const FT miss = length(foot - q);
      if (length(foot - p) > longest || !(miss < nearest)) return;
      nearest = miss;
      end = {point, primitive};
    };
    consider(start.root.primitive());
    const auto local = local_windows(m_initial, face);
    for (auto i = local.first; i != local.second; ++i) consider(i->window.root.primitive());
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      m_initial.for_each_edge_window(h, [&](const auto& w) { consider(w.root.primitive()); });
    return end.primitive != no_index;
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
  const Path_starts<FT> m_start;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
