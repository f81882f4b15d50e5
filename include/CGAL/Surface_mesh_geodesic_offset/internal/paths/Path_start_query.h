// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the distance of a point and the start of its path: at a vertex by the backtrace of the propagation, elsewhere by the windows
// of the adjacent faces.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_START_QUERY_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_PATH_START_QUERY_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_start.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Straight_walk.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/window_allowance.h>

namespace CGAL::Geodesic_offset::internal {

// Finds the Path_start of a point. The distances of the field must be final.
template <class FT>
class Path_start_query
{
public:
  typedef Point_in_face<FT> Point;

  Path_start_query(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_initial(initial), m_field(field)
  {
  }

  // Precondition: windows are kept, or p is a vertex.
  Path_start<FT> operator()(const Located_point<FT>& p) const
  {
    if (p.kind == Surface_point<FT>::VERTEX) return at_vertex(p.element);
    if (p.kind == Surface_point<FT>::EDGE) return at_point(p, distance(p));
    const Nearest nearest = nearest_in(p.element, p.weights);
    Path_start<FT> start;
    if (!find_clear_start(p, nearest, start)) start = at_point(p, nearest.distance);
    return start;
  }

  Path_start<FT> at_vertex(Index v) const
  {
    Path_start<FT> start;
    start.distance = m_field.distance[v];
    set_source(m_field.source_ref[v], start);
    const Backtrace<FT>& back = m_field.back[v];
    if (!start.is_reached() || start.is_at_source() || back.corner == no_index) return start;
    start.pseudo_source = back.pseudo_source;
    start.halfedge = back.corner;
    start.exit = 1;
    const Point u{back.x, back.y};
    start.from = {FT(0), FT(0)};
    start.direction = u;
    if constexpr (!Number_policy<FT>::is_inexact)
      if (dot(u, u) != FT(1))
      {
        start.to = u; // the vector to the image; unit vectors are those of parallel rays and edges
        return start;
      }
    FT way = start.length();
    if (back.pseudo_source != no_index) way = start.distance - m_field.distance[back.pseudo_source];
    start.to = (way / length(u)) * u;
    return start;
  }

  FT distance(const Located_point<FT>& p) const
  {
    if (p.kind == Surface_point<FT>::VERTEX) return m_field.distance[p.element];
    if (p.kind == Surface_point<FT>::FACE) return nearest_in(p.element, p.weights).distance;
    FT result = Number_policy<FT>::infinity();
    for (const Index h : {p.element, m_mesh.twin(p.element)})
    {
      if (h == no_index) continue;
      const FT t = p.x / m_mesh[h].length;
      Per_corner<FT> w;
      w[h % 3] = h == p.element ? FT(FT(1) - t) : t;
      w[(h + 1) % 3] = h == p.element ? t : FT(FT(1) - t);
      w[(h + 2) % 3] = FT(0);
      result = (std::min)(result, nearest_in(m_mesh.face(h), w).distance);
    }
    return result;
  }

private:
  struct Nearest : Nearest_kept_window<FT>
  {
    FT distance = Number_policy<FT>::infinity();
    FT bent = Number_policy<FT>::infinity();      // path around the end of a source in the face
    FT by_corner = Number_policy<FT>::infinity(); // smallest distance by way of a corner
    int corner = 0;
    bool has_local_windows = false; // of sources in the face or at its corners; evaluated only if corner 0 is near enough
    FT start_value = FT(0);         // of the source in the face with the shortest straight path
    Per_corner<Point> q;            // the point in the frames of the face's halfedges
  };

  // The nearest window and corner for the point of a face with barycentric coordinates w, and its distance. Of paths that tie,
  // a straight path has the most precise distance.
  Nearest nearest_in(Index face, const Per_corner<FT>& w) const
  {
    Nearest n;
    const Index h = 3 * face;
    const Per_corner<FT> d = {m_field.distance[m_mesh.source(h)], m_field.distance[m_mesh.source(h + 1)],
                              m_field.distance[m_mesh.source(h + 2)]};
    const bool is_reached = Number_policy<FT>::is_finite(d[0]);
    if (!is_reached && !Number_policy<FT>::is_finite(m_field.maximum)) return n;
    m_field.kept.prefetch(face);
    for (int k = 0; k < 3; ++k)
    {
      n.q[k] = position_in_frame(m_mesh, h + Index(k), w[(k + 1) % 3], w[(k + 2) % 3]);
      const FT way = d[k] + length(n.q[k]);
      if (way < n.by_corner)
      {
        n.by_corner = way;
        n.corner = k;
      }
    }
    const FT extent = m_mesh[h].length + m_mesh[h + 1].length + m_mesh[h + 2].length;
    // Upper bound of the distances of the corners of a face that contains a source.
    if (!is_reached || d[0] <= extent + m_field.start_values.largest()) add_local_windows(face, n);
    m_field.kept.find_nearest(face, n.q, error_of_rays(m_mesh, FT((std::min)(n.by_corner, m_field.maximum) + extent)),
                              m_field.distance, n);
    const FT shortest = (std::min)({n.straight, n.bent, n.by_corner});
    const FT tie = shortest + Number_policy<FT>::rounding(16) * shortest;
    n.distance = n.straight <= tie ? n.straight : n.by_corner <= tie ? n.by_corner : shortest;
    const FT s = start_value(face, n);
    // A point on the source has the start value. Merged windows may give less by more than rounding; this distance stays.
    const FT size = size_of_point(m_mesh, face), least = s - size - window_allowance<FT>(s + m_mesh.longest_edge());
    if (n.distance <= s + size && n.distance >= least) n.distance = s;
    return n;
  }

  // Start value of the source at the end of the shortest path, unless the path bends at the end of a window.
  FT start_value(Index face, const Nearest& n) const
  {
    const Start_values<FT>& starts = m_field.start_values;
    if (CGAL::is_zero(starts.largest())) return FT(0);
    if (n.distance == n.by_corner) return starts.of(m_field.source_ref[m_mesh.source(3 * face + Index(n.corner))]);
    if (n.distance != n.straight) return FT(0);
    return n.window == no_index
           ? n.start_value
           : starts.of(m_field.kept.rays_of_window(n.window, m_field.distance, m_field.source_ref).source_ref);
  }

  // Adds the paths from sources in the face and at its corners. A point of a source segment may lie behind both of its sides,
  // since the ends of the segment are rounded.
  void add_local_windows(Index face, Nearest& n) const
  {
    const auto local = local_windows(m_initial, face);
    n.has_local_windows = local.first != local.second;
    for (auto i = local.first; i != local.second; ++i)
    {
      bool is_straight;
      FT d = i->window.path_length(n.q[0], is_straight);
      if (!Number_policy<FT>::is_finite(d) && i->window.contains(n.q[0], size_of_point(m_mesh, face)))
      {
        d = i->window.start_value;
        is_straight = true;
      }
      if (is_straight && d < n.straight) n.start_value = i->window.start_value;
      FT& best = is_straight ? n.straight : n.bent;
      best = (std::min)(best, d);
    }
  }

  // Sets the start if it needs no rule for ties: a straight path of the smallest distance that is not of a cap, or a path to a
  // corner if all windows are farther by more than rounding. Returns true if so, and for a point that is not reached. Returns
  // false otherwise, and if the face has local windows.
  bool find_clear_start(const Located_point<FT>& p, const Nearest& n, Path_start<FT>& start) const
  {
    if (!Number_policy<FT>::is_finite(n.distance)) return true;
    if (n.has_local_windows) return false;
    start.distance = n.distance;
    if (n.window != no_index && n.distance == n.straight)
    {
      const auto w = m_field.kept.rays_of_window(n.window, m_field.distance, m_field.source_ref);
      if (w.source_ref.side() == Source_side::CAP) return false; // the side of a segment may tie
      set_source(w.source_ref, start);
      start.pseudo_source = w.is_parallel() ? no_index : w.pseudo_source();
      start.halfedge = 3 * p.element + Index(n.halfedge);
      start.exit = 0;
      start.from = n.q[n.halfedge];
      set_goal(start, {w.x, w.y}, w.is_parallel());
      if (start.pseudo_source != no_index)
        for (int k = 0; k < 3; ++k)
          if (m_mesh.source(3 * p.element + Index(k)) == start.pseudo_source)
            set_path_to_corner(3 * p.element + Index(k), n.q[k], start);
    }
    else
    {
      const Index h = 3 * p.element + Index(n.corner), v = m_mesh.source(h);
      const FT extent = m_mesh[h].length + m_mesh[h + 1 - 3 * Index(n.corner == 2)].length;
      const FT tied = n.distance + window_allowance<FT>(n.distance + extent);
      if (n.distance != n.by_corner || m_field.is_source(v) || (std::min)(n.straight, n.bent) <= tied) return false;
      set_path_to_corner(h, n.q[n.corner], start);
    }
    return true;
  }

  // Calls f(face, position in its frame, number of the edge that p is on or -1). Precondition: p is not a vertex.
  template <class Function>
  void for_each_face(const Surface_point<FT>& p, const Function& f) const
  {
    if (p.kind == Surface_point<FT>::FACE) return f(p.element, Point{p.x, p.y}, -1);
    for (const Index h : {p.element, m_mesh.twin(p.element)})
      if (h != no_index)
      {
        const Face_frame<FT> frame(m_mesh, m_mesh.face(h));
        const int k = int(h % 3);
        f(m_mesh.face(h), frame.on_edge(k, h == p.element ? p.x : FT(m_mesh[h].length - p.x)), k);
      }
  }

  // `distance`: of p, which is not a vertex.
  Path_start<FT> at_point(const Surface_point<FT>& p, const FT& distance) const
  {
    Path_start<FT> start;
    start.distance = distance;
    if (p.kind == Surface_point<FT>::EDGE) start.edge = p.element;
    if (!start.is_reached()) return start;
    Face_field<FT> field(m_mesh, m_initial, m_field);
    Choice choice;
    for_each_face(p, [&](Index f, const Point& q, int edge) {
      field.set_face_at(f, q, distance);
      choose(field, q, edge, start, choice);
    });
    // Without a tie, all windows count: the image of a merged window may be so far away that the rounding of the distance
    // exceeds that of ties.
    if (choice.preference < 0)
      for_each_face(p, [&](Index f, const Point& q, int edge) {
        field.set_face(f);
        choose(field, q, edge, start, choice);
      });
    if (p.kind == Surface_point<FT>::EDGE && is_on_varying_segment(p, start)) start.start_value = start.distance;
    // In a face with the pseudo-source as a corner, the path leads straight to the corner; in needles, images are less precise.
    if (start.pseudo_source != no_index)
      for (int k = 0; k < 3; ++k)
        if (const Index h = start.halfedge + Index(k); m_mesh.source(h) == start.pseudo_source)
        {
          const Face_frame<FT> frame(m_mesh, m_mesh.face(h));
          set_path_to_corner(h, frame.vector_to_halfedge(k, start.from - frame.corner(k)), start);
          return start;
        }
    // A path that leaves the face through the edge of the point starts in the face beyond this edge.
    if (start.exit != -1 && p.kind == Surface_point<FT>::EDGE && !redirect_along_edge(start))
    {
      Straight_walk<FT> walk(m_mesh, start.halfedge, start.from, start.to);
      const Index h = walk.edge(start.exit), beyond = m_mesh.twin(h);
      if (beyond != no_index && (h == p.element || beyond == p.element))
      {
        const Face_frame<FT> frame(m_mesh, m_mesh.face(h));
        walk.cross_over(start.exit, walk.crossing(start.exit));
        start.halfedge = beyond;
        start.from = walk.position();
        start.to = walk.goal();
        start.direction = FT(-1) * frame.vector_to_halfedge(int(h % 3), start.direction);
        start.exit = walk.exit();
      }
    }
    return start;
  }

  // True for a point on the segment of its window, if the start value varies along it.
  bool is_on_varying_segment(const Surface_point<FT>& p, const Path_start<FT>& start) const
  {
    if (start.pseudo_source != no_index || !m_initial.primitives[start.source_ref.primitive()].varies) return false;
    bool result = false;
    m_initial.for_each_edge_window(p.element, [&](const auto& w) {
      result |= w.source_ref.primitive() == start.source_ref.primitive() && p.x >= w.b0 && p.x <= w.b1;
    });
    return result;
  }

  struct Choice
  {
    int preference = -1;
    FT distance = Number_policy<FT>::infinity();
  };

  // Chooses the window of a face by which the path from q starts. `edge`: number of the edge that contains q, or -1.
  void choose(const Face_field<FT>& field, const Point& q, int edge, Path_start<FT>& start, Choice& best) const
  {
    for (std::size_t i = 0; i < field.windows().size(); ++i)
    {
      const Face_window<FT>& w = field.windows()[i];
      const FT d = w.path_length(q);
      // A path that leaves through the edge of q belongs to the other face, which may be smaller and have less rounding.
      const bool stays = edge == -1 || int(w.edge) != edge || w.origin > ENTERS_HALFEDGE_2;
      const bool ties = field.tie(d, start.distance), is_straight = field.contains(i, q);
      // A straight path of a side is preferred to one of the cap. A path around the end of a strip leads to the end of the
      // segment, as the rays of the cap do, so these are preferred.
      const bool is_preferred_kind = is_straight ? !field.is_cap(i) : !w.is_parallel();
      // In this order, see "Consistent results" in the manual: a straight path, a path of the preferred kind, a path that
      // stays in the face.
      const int preference = ties ? 4 * int(is_straight) + 2 * int(is_preferred_kind) + int(stays) : -1;
      if (preference < best.preference || (preference == best.preference && !(d < best.distance))) continue;
      best = {preference, d};
      set(start, field.face(), q, w, is_straight);
    }
  }

  // Replaces a path that runs along an edge, up to rounding, by the path through the vertex at the end of the edge, if both
  // have the same length. Returns true if it does so. Precondition: the path leaves the face.
  bool redirect_along_edge(Path_start<FT>& start) const
  {
    const Index h = 3 * m_mesh.face(start.halfedge) + Index(start.exit), n = m_mesh.next(h);
    const Face_frame<FT> frame(m_mesh, m_mesh.face(h));
    const FT& edge = m_mesh[h].length;
    const FT along_from = frame.along(start.exit, start.from), along_to = frame.along(start.exit, start.to);
    const FT allowance = window_allowance<FT>(start.distance + edge);
    if (CGAL::abs(frame.height(start.exit, start.from)) > allowance) return false; // a point of another edge
    if (CGAL::abs(frame.height(start.exit, start.to)) > allowance) return false;
    const bool ahead = along_to > along_from;
    const FT way = ahead ? FT(edge - along_from) : along_from;
    const Index v = ahead ? m_mesh.target(h) : m_mesh.source(h);
    // A vertex that is a source has windows of its own.
    const FT& d = m_field.distance[v];
    if (m_field.is_source(v) || CGAL::abs(FT(d + way - start.distance)) > allowance) return false;
    if (ahead) set_path_to_corner(n, (way / edge) * Point{m_mesh[n].apex_x, m_mesh[n].apex_y}, start);
    else set_path_to_corner(h, {way, FT(0)}, start);
    return true;
  }

  // Sets the path from a point, in the frame of h, straight to the vertex at which h starts. The distance must be set.
  void set_path_to_corner(Index h, const Point& from, Path_start<FT>& start) const
  {
    const Index v = m_mesh.source(h);
    set_source(m_field.source_ref[v], start);
    start.pseudo_source = v;
    start.halfedge = h;
    start.exit = -1;
    start.from = from;
    set_goal(start, {FT(0), FT(0)}, false);
  }

  // The distance must be set.
  void set_source(Source_ref source_ref, Path_start<FT>& start) const
  {
    start.source_ref = source_ref;
    start.start_value = m_field.start_values.of(source_ref);
    start.is_below_start_value =
      start.distance < start.start_value - window_allowance<FT>(start.start_value + m_mesh.longest_edge());
  }

  // Sets the goal, the image of the window; for parallel rays, from their unit vector towards the source. `from`, the distance
  // and the start value must be set.
  static void set_goal(Path_start<FT>& start, const Point& image_or_direction, bool is_parallel)
  {
    start.direction = is_parallel ? image_or_direction : image_or_direction - start.from;
    start.to = is_parallel ? start.from + start.length() * image_or_direction : image_or_direction;
  }

  // Sets the path from p by window w. `is_straight`: false for a path around the end of the window. Such a path is aimed at the
  // image of the window, which is more precise than the end; for a strip, at the source point whose ray leads to the end. With
  // exact numbers, a path by a strip has the direction of its rays.
  void set(Path_start<FT>& start, Index face, const Point& p, const Face_window<FT>& w, bool is_straight) const
  {
    set_source(w.source_ref, start);
    start.pseudo_source = w.pseudo_source();
    start.halfedge = 3 * face;
    start.exit = w.origin <= ENTERS_HALFEDGE_2 ? int(w.edge) : -1;
    start.from = p;
    if (!Number_policy<FT>::is_inexact || is_straight || !w.is_parallel()) return set_goal(start, w.image(), w.is_parallel());
    const Point end = w.end_around(p);
    set_goal(start, end + (w.distance_at(end) - start.start_value) * w.image(), false);
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
