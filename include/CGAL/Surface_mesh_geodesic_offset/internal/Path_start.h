// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance of a point, and how the shortest path begins there: at a vertex as the propagation has left it, elsewhere
// by the windows of the faces around.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATH_START_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATH_START_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Surface_point.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A shortest path goes from `from` straight to `to`, in the frame of the face where it starts: up to the pseudo-source,
// or to the source if there is none.
template <class FT>
struct Path_start
{
  FT distance = Number_policy<FT>::infinity();
  Root root;
  Index pseudo_source = no_index;
  Index face = no_index; // none at a source and where the distance is infinite
  int exit = -1;         // the halfedge of the face that the path leaves through, if it leaves the face
  Point_in_face<FT> from, to;

  bool is_reached() const { return Number_policy<FT>::is_finite(distance); }
};

// Goes from p straight on towards q, over to the face beyond an edge that p lies on; the points change frames. Returns through
// which of its edges the way goes on.
template <class FT>
int cross_edge(const Unfolded_mesh<FT>& mesh, Index& face, Face_frame<FT>& frame, int edge, Point_in_face<FT>& p,
               Point_in_face<FT>& q)
{
  const Index g = mesh.twin(3 * face + Index(edge));
  const Point_in_face<FT> a = frame.to_twin(edge, p), b = frame.to_twin(edge, q);
  face = mesh.face(g);
  frame = Face_frame<FT>(mesh, face);
  const int k = int(g % 3);
  p = frame.on_edge(k, a.x);
  q = frame.from_halfedge(k, b);
  // seen across the edge, its source is on the left
  const int apex = (k + 2) % 3;
  return CGAL::is_negative(cross(q - p, frame.corner(apex) - p)) ? apex : (k + 1) % 3;
}

template <class FT>
class Path_starts
{
public:
  typedef Point_in_face<FT> Point;

  Path_starts(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_initial(initial), m_field(field)
  {
  }

  // Other points than vertices need kept windows.
  Path_start<FT> operator()(const Surface_point<FT>& p) const
  {
    return p.kind == Surface_point<FT>::VERTEX ? at_vertex(p.element) : at_point(p);
  }

  Path_start<FT> at_vertex(Index v) const
  {
    Path_start<FT> start;
    start.distance = m_field.distance[v];
    start.root = m_field.root[v];
    const Way_back<FT>& back = m_field.back[v];
    if (!start.is_reached() || CGAL::is_zero(start.distance) || back.corner == no_index) return start;
    start.pseudo_source = back.pseudo_source;
    start.face = m_mesh.face(back.corner);
    const int k = int(back.corner % 3);
    start.exit = (k + 1) % 3;
    const Face_frame<FT> frame(m_mesh, start.face);
    const Point u = frame.vector_from_halfedge(k, {back.x, back.y});
    FT way = start.distance;
    if (back.pseudo_source != no_index) way -= m_field.distance[back.pseudo_source];
    start.from = frame.corner(k);
    start.to = start.from + (way / length(u)) * u;
    return start;
  }

private:
  Path_start<FT> at_point(const Surface_point<FT>& p) const
  {
    Path_start<FT> start;
    int preference = 0;
    Face_field<FT> field(m_mesh, m_initial, m_field);
    const bool is_on_edge = p.kind == Surface_point<FT>::EDGE;
    for (const Index f : {is_on_edge ? m_mesh.face(p.element) : p.element,
                          is_on_edge && m_mesh.twin(p.element) != no_index ? m_mesh.face(m_mesh.twin(p.element)) : no_index})
    {
      if (f == no_index) continue;
      Point q;
      unsigned edges;
      position_in_face(m_mesh, p, f, q, edges);
      std::size_t i;
      field.set_face_at(f, q);
      const FT d = field.distance(q, i);
      if (!Number_policy<FT>::is_finite(d)) continue;
      const int liking = field.preference(i, q);
      if (field.tie(d, start.distance) ? liking > preference : d < start.distance)
      {
        preference = liking;
        set(start, f, q, field.windows()[i]);
      }
      start.distance = (std::min)(start.distance, d);
      // on the source
      if (start.distance <= Number_policy<FT>::rounding(16) * field.size()) start.distance = FT(0);
    }
    // through the edge that the point is on: the path starts on the other side
    if (start.exit != -1 && p.kind == Surface_point<FT>::EDGE)
      for (const Index h : {p.element, m_mesh.twin(p.element)})
        if (h == 3 * start.face + Index(start.exit) && m_mesh.twin(h) != no_index)
        {
          Face_frame<FT> frame(m_mesh, start.face);
          start.exit = cross_edge(m_mesh, start.face, frame, start.exit, start.from, start.to);
          break;
        }
    return start;
  }

  static void set(Path_start<FT>& start, Index face, const Point& p, const Face_window<FT>& w)
  {
    start.root = w.root;
    start.pseudo_source = w.pseudo_source();
    start.face = face;
    start.exit = w.origin <= ENTERS_HALFEDGE_2 ? int(w.edge) : -1;
    start.from = p;
    start.to = w.is_parallel() ? p + w.distance_at(p) * w.image() : w.image();
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
