// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance of a point, and how the shortest path begins there: at a vertex as the propagation has left it, elsewhere
// by the windows of the faces around.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATH_START_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATH_START_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Straight_walk.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Surface_point.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A shortest path goes from `from` straight to `to`, in the frame of a halfedge of the face where it starts: up to the
// pseudo-source, or to the source if there is none.
template <class FT>
struct Path_start
{
  FT distance = Number_policy<FT>::infinity();
  Root root;
  Index pseudo_source = no_index;
  Index halfedge = no_index; // none at a source and where the distance is infinite
  int exit = -1;             // the edge, counted from that halfedge, that the path leaves through, if it leaves the face
  Point_in_face<FT> from, to;

  bool is_reached() const { return Number_policy<FT>::is_finite(distance); }
};

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
    start.halfedge = back.corner;
    start.exit = 1;
    const Point u{back.x, back.y};
    start.from = {FT(0), FT(0)};
    if constexpr (!Number_policy<FT>::is_inexact)
      if (dot(u, u) != FT(1))
      {
        start.to = u; // the way itself: only directions of parallel rays and of edges are unit vectors
        return start;
      }
    FT way = start.distance;
    if (back.pseudo_source != no_index) way -= m_field.distance[back.pseudo_source];
    start.to = (way / length(u)) * u;
    return start;
  }

  FT distance(const Surface_point<FT>& p) const
  {
    if (p.kind == Surface_point<FT>::VERTEX) return m_field.distance[p.element];
    FT result = Number_policy<FT>::infinity();
    for_each_face(p, [&](Index f, const Point& q) { result = (std::min)(result, distance_in(f, q)); });
    return result;
  }

private:
  template <class Function>
  void for_each_face(const Surface_point<FT>& p, const Function& f) const
  {
    if (p.kind == Surface_point<FT>::FACE) return f(p.element, Point{p.x, p.y});
    for (const Index h : {p.element, m_mesh.twin(p.element)})
      if (h != no_index)
        f(m_mesh.face(h), Face_frame<FT>(m_mesh, m_mesh.face(h))
                            .on_edge(int(h % 3), h == p.element ? p.x : FT(m_mesh[h].length - p.x)));
  }

  // From kept windows, without making them.
  FT distance_in(Index face, const Point& p) const
  {
    m_field.kept.prefetch(face);
    const Face_frame<FT> frame(m_mesh, face);
    FT best = Number_policy<FT>::infinity();
    for (int k = 0; k < 3; ++k)
      best = (std::min)(best, FT(m_field.distance[m_mesh.source(3 * face + Index(k))] + length(p - frame.corner(k))));
    const auto local = local_windows(m_initial, face);
    for (auto i = local.first; i != local.second; ++i) best = (std::min)(best, i->window.path_length(p));
    for (int k = 0; k < 3; ++k)
    {
      const Point q = frame.vector_to_halfedge(k, p - frame.corner(k));
      best = m_field.kept.nearest(3 * face + Index(k), m_field.distance, q.x, q.y, best);
    }
    // on the source
    return best <= Number_policy<FT>::rounding(16) * frame.longest_edge() ? FT(0) : best;
  }

  Path_start<FT> at_point(const Surface_point<FT>& p) const
  {
    Path_start<FT> start;
    start.distance = distance(p);
    if (!start.is_reached()) return start;
    int liking = -1;
    FT shortest;
    Face_field<FT> field(m_mesh, m_initial, m_field);
    for_each_face(p, [&](Index f, const Point& q) {
      field.set_face_at(f, q, start.distance);
      for (std::size_t i = 0; i < field.windows().size(); ++i)
      {
        const FT d = field.windows()[i].path_length(q);
        const int preference = field.tie(d, start.distance) ? field.preference(i, q) : -1;
        if (preference > liking || (preference == liking && preference >= 0 && d < shortest))
        {
          liking = preference;
          shortest = d;
          set(start, f, q, field.windows()[i]);
        }
      }
    });
    // through the edge that the point is on: the path starts on the other side
    if (start.exit != -1 && p.kind == Surface_point<FT>::EDGE)
    {
      Straight_walk<FT> walk(m_mesh, start.halfedge, start.from, start.to);
      const Index h = walk.edge(start.exit), beyond = m_mesh.twin(h);
      if (beyond != no_index && (h == p.element || beyond == p.element))
      {
        walk.cross_over(start.exit, walk.crossing(start.exit));
        start.halfedge = beyond;
        start.from = walk.position();
        start.to = walk.goal();
        start.exit = walk.exit();
      }
    }
    return start;
  }

  static void set(Path_start<FT>& start, Index face, const Point& p, const Face_window<FT>& w)
  {
    start.root = w.root;
    start.pseudo_source = w.pseudo_source();
    start.halfedge = 3 * face;
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
