// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A shortest path back to the source, from kept windows: in each face, the window that gives the point its distance
// tells where the path came in; at a vertex, the windows of the faces around tell.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATH_TRACING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATH_TRACING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Surface_point.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Path_tracing
{
public:
  typedef Point_in_face<FT> Point;

  Path_tracing(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_initial(initial), m_field(field)
  {
  }

  // Distance of a point, by the fields of the faces around it, and where the shortest path ends.
  FT distance(const Surface_point<FT>& p, Root& root) const
  {
    if (p.kind == Surface_point<FT>::VERTEX)
    {
      root = m_field.root[p.element];
      return m_field.distance[p.element];
    }
    FT best = Number_policy<FT>::infinity();
    int preference = 0;
    for (Index f : faces_of(m_mesh, p))
    {
      Point q;
      unsigned edges;
      position_in_face(m_mesh, p, f, q, edges);
      std::size_t i;
      const Face_field<FT> field(m_mesh, m_initial, m_field, f);
      const FT d = field.distance(q, i);
      if (!Number_policy<FT>::is_finite(d)) continue;
      if (field.tie(d, best) ? field.preference(i, q) > preference : d < best)
      {
        preference = field.preference(i, q);
        root = field.windows()[i].root;
      }
      best = (std::min)(best, d);
    }
    return best;
  }

  // Calls out(face, point in the face's frame, halfedge of the face it lies on, or 3) for the points of the path from p to its source, one for each edge crossed
  // and each vertex passed. Nothing if p is unreachable.
  template <class Function>
  void operator()(const Surface_point<FT>& p, const Function& out) const
  {
    Step step{};
    if (!first_step(p, step)) return;
    out(step.face, step.from, edge_of(p, step.face));
    for (std::size_t guard = 0; guard <= 4 * m_mesh.number_of_faces() + 16; ++guard)
    {
      Surface_point<FT> next;
      Index came_through = no_index;
      bool done = false;
      advance(step, out, next, came_through, done);
      if (done || !next_step(next, came_through, step)) return;
    }
  }

private:
  struct Step // in the face, from a point, towards the image of a window
  {
    Index face;
    Point from;
    Face_window<FT> window;
  };

  int edge_of(const Surface_point<FT>& p, Index face) const
  {
    Point q;
    unsigned edges;
    position_in_face(m_mesh, p, face, q, edges);
    return edges & 1u ? 0 : edges & 2u ? 1 : edges & 4u ? 2 : 3;
  }

  bool first_step(const Surface_point<FT>& p, Step& step) const { return next_step(p, no_index, step); }

  // The window to follow from p: the one that gives it the smallest distance, but not back through the halfedge by which
  // the path has come.
  bool next_step(const Surface_point<FT>& p, Index came_through, Step& step) const
  {
    FT best = Number_policy<FT>::infinity();
    const std::vector<Index> faces =
      came_through == no_index ? faces_of(m_mesh, p) : std::vector<Index>(1, m_mesh.face(came_through));
    for (Index f : faces)
    {
      const Face_field<FT> field(m_mesh, m_initial, m_field, f);
      Point q;
      unsigned edges;
      position_in_face(m_mesh, p, f, q, edges);
      for (const Face_window<FT>& w : field.windows())
      {
        if (p.kind == Surface_point<FT>::VERTEX)
        {
          if (w.origin == STARTS_AT_CORNER && m_mesh.source(3 * f + w.edge) == p.element) continue;
          // rays that enter along an edge at the vertex itself belong to the face on its other side
          if (w.origin <= ENTERS_HALFEDGE_2 && (edges & (1u << w.edge)) && !CGAL::is_zero(w.distance_at(q))) continue;
        }
        else if (came_through != no_index && w.origin <= ENTERS_HALFEDGE_2 && 3 * f + w.edge == came_through)
          continue;
        const FT d = w.path_length(q);
        if (d < best)
        {
          best = d;
          step = Step{f, q, w};
        }
      }
    }
    return Number_policy<FT>::is_finite(best);
  }

  // Follows the step's window to where it entered the face; `done` if that is the source.
  template <class Function>
  void advance(const Step& step, const Function& out, Surface_point<FT>& next, Index& came_through, bool& done) const
  {
    const Face_window<FT>& w = step.window;
    if (w.origin == STARTS_AT_CORNER)
    {
      const Index v = m_mesh.source(3 * step.face + w.edge);
      out(step.face, w.image(), w.edge);
      done = CGAL::is_zero(m_field.distance[v]);
      next = Surface_point<FT>::at_vertex(v);
      return;
    }
    const Point entry = entry_of(w, step.from);
    if (w.origin == STARTS_IN_FACE)
    {
      out(step.face, w.is_parallel() ? entry : w.image(), 3);
      done = true;
      return;
    }
    out(step.face, entry, w.edge);
    const Index h = 3 * step.face + w.edge;
    done = !CGAL::is_positive(w.distance_at(entry));
    next.kind = Surface_point<FT>::EDGE;
    next.element = m_mesh.twin(h) == no_index ? h : m_mesh.twin(h);
    const FT t = Face_frame<FT>(m_mesh, step.face).along(w.edge, entry);
    const FT length = m_mesh[h].length, end = Number_policy<FT>::rounding(256) * length;
    if (t <= end) next = Surface_point<FT>::at_vertex(m_mesh.source(h));
    else if (t >= length - end) next = Surface_point<FT>::at_vertex(m_mesh.target(h));
    else
    {
      next.x = next.element == h ? t : FT(length - t);
      came_through = next.element;
      if (m_mesh.twin(h) == no_index) done = true;
    }
  }

  static Point entry_of(const Face_window<FT>& w, const Point& p)
  {
    if (CGAL::is_positive(w.left_side(p))) return w.left;
    if (CGAL::is_negative(w.right_side(p))) return w.right;
    const Point u = w.is_parallel() ? FT(-1) * w.image() : p - w.image();
    const Point o = w.is_parallel() ? p : w.image();
    const FT r = cross(u, w.right - o), l = cross(u, w.left - o);
    if (CGAL::is_zero(FT(r - l))) return w.right;
    return w.right + (r / (r - l)) * (w.left - w.right);
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
