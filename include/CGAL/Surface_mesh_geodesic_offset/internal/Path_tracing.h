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

  // Calls out(surface point) for p, for each edge that the path crosses and each vertex that it passes, and for the source
  // point where it ends. Nothing if p is farther than the maximum.
  template <class Function>
  void operator()(const Surface_point_& p, const FT& maximum, const Function& out) const
  {
    Path_start<FT> start = m_start(p);
    if (!start.is_reached() || start.distance > maximum) return;
    out(p);
    const Index limit = Index(m_mesh.number_of_vertices());
    for (Index guard = 0; start.face != no_index && CGAL::is_positive(start.distance) && guard <= limit; ++guard)
    {
      bool is_source = false;
      const Surface_point_ end = follow(start, p, is_source, out);
      out(end);
      if (is_source) return;
      start = m_start.at_vertex(end.element);
    }
  }

private:
  static constexpr double nearby = 1. / (1 << 30); // part of an edge: a path so near to a vertex may be meant to pass it

  // Goes straight on to the source, the pseudo-source, or a vertex that is on the way up to rounding: from there its own
  // shortest path is as short as any.
  template <class Function>
  Surface_point_ follow(const Path_start<FT>& start, const Surface_point_& origin, bool& is_source,
                        const Function& out) const
  {
    Index face = start.face;
    Point p = start.from, q = start.to;
    int exit = start.exit;
    // a window that enters through the edge that the point is on: the path starts on the other side
    if (exit != -1 && lies_on(origin, 3 * face + Index(exit)) && m_mesh.twin(3 * face + Index(exit)) != no_index)
      exit = cross_edge(face, exit, p, q);
    const Index limit = Index(m_mesh.number_of_halfedges());
    for (Index guard = 0; guard <= limit; ++guard)
    {
      if (Surface_point_ end; ends_in(face, p, start, end, is_source)) return end;
      const Face_frame<FT> frame(m_mesh, face);
      if (exit == -1) exit = exit_from_inside(frame, p, q);
      const Index h = 3 * face + Index(exit);
      const FT t = position_of_exit(frame, exit, p, q), size = m_mesh[h].length;
      const bool is_border = m_mesh.twin(h) == no_index;
      const bool ahead = CGAL::is_positive(dot(q - p, frame.direction(exit)));
      for (const bool at_target : {ahead, !ahead})
        if (is_border || (at_target ? size - t : t) <= FT(nearby) * size)
        {
          const Index v = at_target ? m_mesh.target(h) : m_mesh.source(h);
          const Point corner = frame.corner(at_target ? (exit + 1) % 3 : exit);
          if (!is_way_by(v, length(corner - p), length(q - p), start)) continue;
          is_source = CGAL::is_zero(m_field.distance[v]);
          return Surface_point_::at_vertex(v);
        }
      if (is_border) break;
      out(on_edge(h, t));
      p = frame.on_edge(exit, t);
      exit = cross_edge(face, exit, p, q);
    }
    // rounding at the border, and nothing better to say
    is_source = start.pseudo_source == no_index;
    return is_source ? m_initial.places[start.root.primitive()].first : Surface_point_::at_vertex(start.pseudo_source);
  }

  // Whether the way by a vertex is as short as the rest of the path, straight on.
  bool is_way_by(Index v, const FT& to_vertex, const FT& straight_on, const Path_start<FT>& start) const
  {
    const FT& d = m_field.distance[v];
    const FT rest = start.pseudo_source == no_index ? straight_on : FT(straight_on + m_field.distance[start.pseudo_source]);
    return d < start.distance && d + to_vertex <= rest + Number_policy<FT>::rounding(256) * start.distance;
  }

  bool lies_on(const Surface_point_& p, Index h) const
  {
    return p.kind == Surface_point_::EDGE && (p.element == h || m_mesh.twin(p.element) == h);
  }

  static Surface_point_ on_edge(Index h, const FT& t)
  {
    Surface_point_ p;
    p.kind = Surface_point_::EDGE;
    p.element = h;
    p.x = t;
    return p;
  }

  // Goes over to the face beyond the edge; returns through which of its edges the way to q goes on.
  int cross_edge(Index& face, int exit, Point& p, Point& q) const
  {
    const Face_frame<FT> before(m_mesh, face);
    const Index g = m_mesh.twin(3 * face + Index(exit));
    face = m_mesh.face(g);
    const int k = int(g % 3);
    const Face_frame<FT> frame(m_mesh, face);
    p = frame.on_edge(k, before.to_twin(exit, p).x);
    q = frame.from_halfedge(k, before.to_twin(exit, q));
    // seen across the edge, its source is on the left
    const int apex = (k + 2) % 3;
    return CGAL::is_negative(cross(q - p, frame.corner(apex) - p)) ? apex : (k + 1) % 3;
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

  // In a face that the end lies in too, the straight way to it is the shortest, as it is the shortest in space.
  bool ends_in(Index face, const Point& p, const Path_start<FT>& start, Surface_point_& end, bool& is_source) const
  {
    is_source = start.pseudo_source == no_index;
    if (!is_source)
    {
      end = Surface_point_::at_vertex(start.pseudo_source);
      return is_in_face(end, face);
    }
    const Source_place<FT>& place = m_initial.places[start.root.primitive()];
    if (!is_in_face(place.first, face) || !is_in_face(place.second, face)) return false;
    end = m_initial.primitives[start.root.primitive()].is_segment ? foot_in(face, p, place) : place.first;
    return true;
  }

  // The nearest point of a segment in the face.
  Surface_point_ foot_in(Index face, const Point& p, const Source_place<FT>& place) const
  {
    Point a, b;
    unsigned edges_of_a, edges_of_b;
    position_in_face(m_mesh, place.first, face, a, edges_of_a);
    position_in_face(m_mesh, place.second, face, b, edges_of_b);
    const Point u = b - a;
    const FT t = dot(p - a, u) / dot(u, u);
    if (!CGAL::is_positive(t)) return place.first;
    if (!(t < FT(1))) return place.second;
    const Point foot = a + t * u;
    const unsigned edge = edges_of_a & edges_of_b;
    if (edge)
    {
      const int k = edge == 1 ? 0 : edge == 2 ? 1 : 2;
      return on_edge(3 * face + Index(k), Face_frame<FT>(m_mesh, face).along(k, foot));
    }
    Surface_point_ end;
    end.kind = Surface_point_::FACE;
    end.element = face;
    end.x = foot.x;
    end.y = foot.y;
    return end;
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
