// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Starts rays from sources and pseudo-sources: creates windows on the first edges that the rays cross, and updates vertices by
// paths along edges.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_RAY_SPREADING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_RAY_SPREADING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Vertex_sector.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <boost/config.hpp>

#include <algorithm>

namespace CGAL::Geodesic_offset::internal {

template <class Traits>
class Ray_spreading
{
public:
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef Ray_at_vertex<FT> Ray;

  Ray_spreading(Wavefront_state<FT>& state, const Initial_windows<FT>& initial, const Traits& traits)
    : m_state(state), m_mesh(state.mesh), m_initial(initial), m_traits(traits), m_sector(state.mesh)
  {
  }

  // Starts the rays of the source primitives with numbers of at least `first_primitive` and start values in (above, last].
  void start(Index first_primitive, const FT& above, const FT& last)
  {
    const auto starts = [&](const auto& item) {
      const FT& s = m_initial.start_values.of(item.source_ref);
      return item.source_ref.primitive() >= first_primitive && above < s && s <= last;
    };
    // Seeds of source vertices, whose `back` has no corner, come first: update_vertex() keeps the first of equal distances, and a
    // source beside the vertex may give it the same distance, for example 0.
    for (const bool is_source : {true, false})
      for (const auto& s : m_initial.seeds)
        if (starts(s) && (s.back.corner == no_index) == is_source)
          m_state.update_vertex(s.vertex, {s.distance, s.back, s.source_ref, no_index});
    for (const auto& f : m_initial.fans)
      // A source vertex that another source reaches before its own start value sends no rays.
      if (starts(f) && !(m_state.field.distance[f.vertex] < m_initial.start_values.of(f.source_ref)))
        spread(f.vertex, f.from, f.to, f.first, f.source_ref, no_index, m_state);
    for (const auto& e : m_initial.edges)
    {
      if (!starts(e)) continue;
      // parallel rays at a right angle to the edge, unless the start value varies
      const FT height = CGAL::is_zero(e.slope) ? FT(1) : square_root<FT>(FT((FT(1) - e.slope) * (FT(1) + e.slope)));
      Window w({FT(-e.slope), FT(-height), e.start - e.slope * e.b0, FT(0), FT(0), e.source_ref,
                Window::make_bits(true, no_index)},
               e.b0, e.b1);
      m_state.append(e.halfedge, w);
    }
    for (const auto& l : m_initial.local)
    {
      if (!starts(l.window)) continue;
      m_state.schedule(l.face);
      if (l.window.origin == STARTS_AT_CORNER) continue; // the loop over the fans has started its rays
      const Face_frame<FT> frame(m_mesh, l.face);
      for (int k = 0; k < 3; ++k)
        if (l.window.edge == 3 || l.window.edge == k) add_exit(l.face, frame, k, l.window, m_state); // 3: rays to all edges
    }
  }

  // Starts the rays behind a pending vertex, in its sectors; at a pinched vertex, also in all other fans. Behind a vertex that was
  // hidden, rays start in all directions. `front` receives the windows: the state, or messages of the parallel front.
  template <class Front>
  void spread_from_pseudo_source(Index v, Front& front) const
  {
    typedef Wavefront_state<FT> State;
    char& state = m_state.vertex_state[v];
    if (!(state & (State::IS_PENDING | State::IS_TIED))) return;
    const bool was_hidden = state & State::WAS_HIDDEN, is_pending = state & State::IS_PENDING;
    const std::vector<Ray> tied = state & State::IS_TIED ? m_state.take_tied(v) : std::vector<Ray>();
    state = State::HAS_SPREAD | State::REACHED;
    const Source_ref source_ref = m_state.field.source_ref[v];
    if (was_hidden) m_mesh.for_each_fan(v, [&](Index first) { spread(v, Ray(), Ray(), first, source_ref, v, front); });
    else if (is_pending) spread_behind(v, m_state.field.back[v].ray(), source_ref, front);
    if (!was_hidden)
      for (const Ray& back : tied) spread_behind_tied(v, back, source_ref, front);
  }

private:
  // Adds the window on the twin of halfedge k of a face: the rays of `local` that leave the face through the halfedge.
  template <class Front>
  void add_exit(Index face, const Face_frame<FT>& frame, int k, const Face_window<FT>& local, Front& front) const
  {
    const Index g = m_mesh.twin(3 * face + Index(k));
    if (g == no_index) return;
    Window w;
    static_cast<typename Window::Rays&>(w) = {local.x, local.y, local.sigma, FT(0), FT(0), local.source_ref, local.bits};
    w.b0 = FT(0);
    w.b1 = m_mesh[g].length;
    const Point_in_face<FT>&origin = frame.corner((k + 1) % 3), &direction = frame.direction(k);
    change_frame(m_traits, w, origin.x, origin.y, FT(-direction.x), FT(-direction.y)); // to the frame of the twin
    // Parallel rays within rounding of the direction of the edge do not cross it.
    if (w.is_parallel() ? !(w.y < -Number_policy<FT>::rounding(roundings_of_direction)) : !put_before_edge(frame, w)) return;
    const Point_in_face<FT> left = frame.to_twin(k, local.left), right = frame.to_twin(k, local.right);
    const auto towards = [&](const Point_in_face<FT>& c) {
      return w.is_parallel() ? Point_in_face<FT>{-w.x, -w.y} : Point_in_face<FT>{c.x - w.x, c.y - w.y};
    };
    if (local.edge == k)
    {
      w.b0 = left.x;
      w.b1 = right.x;
    }
    else if (!clip(left, towards(left), FT(-1), w) || !clip(right, towards(right), FT(1), w)) return;
    w.b0 = (std::max)(w.b0, FT(0));
    w.b1 = (std::min)(w.b1, m_mesh[g].length);
    w.set_begin(w.b0, w.distance_at(w.b0));
    w.set_end(w.b1, w.distance_at(w.b1));
    if (local.edge == k)
    {
      take_ray(frame, k, local.to, w.t0);
      take_ray(frame, k, local.from, w.t1);
    }
    if (!(w.b0 < w.b1) && !w.is_open()) return;
    // the terms of the distances, in the frame of the face and in that of the edge
    const FT size = (std::max)({m_mesh[g].length, FT(CGAL::abs(local.sigma)), FT(CGAL::abs(w.sigma))});
    if (cut_behind_source(local.start_value, size, w)) front.add_apart(g, w);
  }

  // Sets a ray of a window on the twin of halfedge k to the direction u, unless rounding has turned this direction away.
  static void take_ray(const Face_frame<FT>& frame, int k, const Point_in_face<FT>& u, FT& t)
  {
    if constexpr (!Number_policy<FT>::is_inexact) return;
    const Point_in_face<FT> v = frame.vector_to_halfedge(k, u);
    if (v.y < FT(0)) t = v.x / v.y;
  }

  // Ensures that the image of w lies on the near side of the edge that its rays cross (see Initial_windows). If rounding has
  // put the image on the edge or beyond it, moves the image to the near side, by the rounding error of its height. With exact
  // numbers, returns false for such an image.
  static bool put_before_edge(const Face_frame<FT>& frame, Window& w)
  {
    if constexpr (Number_policy<FT>::is_inexact)
      if (!(w.y < FT(0))) w.y = -rounding_of_height(frame.longest_edge());
    return w.y < FT(0);
  }

  // Rounding error of the direction of parallel rays in the frame of an edge, in units of rounding: two differences of coordinates
  // and two changes of the frame, each some 2^4 units.
  static constexpr double roundings_of_direction = 64;

  // Units of rounding of a distance by parallel rays: two products and two sums, in the frame of the face and in that of the edge.
  static constexpr double roundings_of_distance = 4;

  // Cuts off the part of a window behind its source segment, where its distance is less than the start value s. Returns false
  // if nothing remains. `size`: magnitude of the terms of the distances. A distance that equals s up to rounding is set to s:
  // on an edge nearly parallel to the segment, a rounding error would cut off a long part of the window.
  static bool cut_behind_source(const FT& s, const FT& size, Window& w)
  {
    if (w.d0 >= s && w.d1 >= s) return true;
    if (!w.is_parallel()) return false;
    const FT rounding = Number_policy<FT>::rounding(roundings_of_distance) * size;
    for (FT* const d : {&w.d0, &w.d1})
      if (*d < s && s - *d <= rounding) *d = s;
    if (w.d0 >= s && w.d1 >= s) return true; // also for a segment along the edge up to rounding
    if (w.d0 <= s && w.d1 <= s) return false;
    const FT b = w.b0 + ((w.d0 - s) / (w.d0 - w.d1)) * (w.b1 - w.b0);
    if (w.d0 < s) w.set_begin(b, s);
    else w.set_end(b, s);
    return w.b0 < w.b1;
  }

  // Clips the interval to the side of the ray from c with direction u where the cross product has the given sign.
  static bool clip(const Point_in_face<FT>& c, const Point_in_face<FT>& u, const FT& sign, Window& w)
  {
    const FT g0 = sign * (u.x * (FT(0) - c.y) - u.y * (w.b0 - c.x));
    const FT g1 = sign * (u.x * (FT(0) - c.y) - u.y * (w.b1 - c.x));
    if (!CGAL::is_positive(g0) && !CGAL::is_positive(g1)) return false;
    const FT b0 = w.b0, b1 = w.b1;
    if (CGAL::is_negative(g0)) w.b0 = b0 + (g0 / (g0 - g1)) * (b1 - b0);
    if (CGAL::is_negative(g1)) w.b1 = b1 + (g1 / (g1 - g0)) * (b0 - b1);
    return true;
  }

  bool in_fan(Index c, Index first) const
  {
    return m_mesh.any_corner(first, [c](Index i) { return i == c; });
  }

  // Starts the rays behind a pseudo-source that is reached from a direction. `excess` is added to the distances: rays from another
  // direction that ties fill what the others leave, and replace none of them.
  template <class Front>
  void spread_behind(Index v, const Ray& back, Source_ref source_ref, Front& front, const FT& excess = FT(0)) const
  {
    m_sector.for_each_sector_behind(back, [&](const Ray& from, const Ray& to, Index first) {
      spread(v, from, to, first, source_ref, v, front, excess);
    });
    if (m_mesh.has_several_fans(v))
      m_mesh.for_each_fan(v, [&](Index first) {
        if (!in_fan(back.corner, first)) spread(v, Ray(), Ray(), first, source_ref, v, front);
      });
  }

  // Starts the rays behind a direction that ties with the known one. Each of the two paths may have removed the other's rays before
  // the vertex. If the sectors behind them are apart, by a narrow angle, the rays between them are started, too.
  template <class Front>
  void spread_behind_tied(Index v, const Ray& back, Source_ref source_ref, Front& front) const
  {
    const FT excess = m_state.rounding_at_vertex(m_state.field.distance[v]);
    const auto spread_between = [&](const Ray& from, const Ray& to, Index first) {
      spread(v, from, to, first, source_ref, v, front, excess);
    };
    if (!m_sector.for_sector_behind_other(m_state.field.back[v].ray(), back, spread_between))
      spread_behind(v, back, source_ref, front, excess);
  }

  // Starts the rays from v in a sector: windows on the edges opposite to v, and updates of vertices along the edges.
  template <class Front>
  void spread(Index v, const Ray& from, const Ray& to, Index first, Source_ref source_ref, Index pseudo_source, Front& front,
              const FT& excess = FT(0)) const
  {
    const FT sigma =
      pseudo_source == no_index ? m_state.field.start_values.of(source_ref) : FT(m_state.field.distance[v] + excess);
    m_sector.for_each_corner(from, to, first, [&](Index h, const Ray* lower, const Ray* upper) {
      const Index e = m_mesh.next(h), p = m_mesh.previous(h);
      front.schedule(m_mesh.face(h));
      front.update_vertex(m_mesh.source(e),
                          {sigma + m_mesh[h].length, Ray{e, m_mesh[e].apex_x, m_mesh[e].apex_y}, source_ref, pseudo_source});
      front.update_vertex(m_mesh.source(p), {sigma + m_mesh[p].length, Ray{p, FT(1), FT(0)}, source_ref, pseudo_source});
      const Index g = m_mesh.twin(e);
      if (g == no_index) return;
      const FT length = m_mesh[e].length;
      // the frame of the twin runs backwards: the lower ray ends the interval
      Window w({length - m_mesh[e].apex_x, -m_mesh[e].apex_y, sigma, FT(0), FT(0), source_ref,
                Window::make_bits(false, pseudo_source)},
               upper ? m_sector.exit_of_ray(h, *upper) : FT(0), lower ? m_sector.exit_of_ray(h, *lower) : length);
      if constexpr (Number_policy<FT>::is_inexact)
      {
        const FT ux = m_mesh[e].apex_x / m_mesh[h].length, uy = m_mesh[e].apex_y / m_mesh[h].length; // backwards: x of h
        const auto ray = [&](const Ray& r) { return FT((r.x * ux - r.y * uy) / (r.x * uy + r.y * ux)); };
        // a ray through a vertex is the same on both sides of it: in a needle the image is less precise than its directions
        w.t1 = lower && w.b1 < length ? ray(*lower) : ray(Ray{h, FT(1), FT(0)});
        w.t0 = upper && w.b0 > FT(0) ? ray(*upper) : ray(Ray{h, m_mesh[h].apex_x, m_mesh[h].apex_y});
      }
      if (w.b0 < w.b1 || w.is_open()) front.add(g, w);
    });
  }

  Wavefront_state<FT>& m_state;
  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Traits& m_traits;
  Vertex_sector<FT> m_sector;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
