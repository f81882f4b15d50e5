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
      const FT& s = m_initial.start_values.of(e.source_ref);
      // parallel rays at a right angle to the edge
      Window w{FT(0), FT(-1), s, e.b0, e.b1, s, s, e.source_ref, Window::make_bits(true, no_index)};
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
    for (const auto& l : m_initial.beyond_edges)
      if (starts(l.window)) add_exit(l.face, Face_frame<FT>(m_mesh, l.face), int(l.window.edge), l.window, m_state);
  }

  // Starts the rays behind a vertex: in its sectors if it is pending, and in its margins if paths tie there (Vertex_sector). If
  // the vertex was hidden, or its image is too near, rays start in all directions; at a pinched vertex, also in all other fans.
  // `front` receives the windows: the state, or messages of the parallel front.
  template <class Front>
  void spread_from_pseudo_source(Index v, Front& front) const
  {
    typedef Wavefront_state<FT> State;
    char& state = m_state.vertex_state[v];
    const bool is_pending = state & State::IS_PENDING;
    if (!is_pending && !m_state.lacks_margins(v)) return;
    const bool in_all_directions =
      is_pending && ((state & State::WAS_HIDDEN) || m_state.is_beside_image(v, m_state.field.back[v].pseudo_source));
    const bool ties = state & State::TIES;
    state = char(State::HAS_SPREAD | (ties ? State::TIES | State::HAS_MARGINS : 0));
    m_state.field.has_margins[v] = ties;
    const Ray back = m_state.field.back[v].ray();
    const Source_ref source_ref = m_state.field.source_ref[v];
    if (in_all_directions)
      return m_mesh.for_each_fan(v, [&](Index first) { spread(v, Ray(), Ray(), first, source_ref, v, front); });
    if (is_pending && m_mesh.can_be_pseudo_source(v))
      m_sector.for_each_sector_behind(back, [&](const Ray& from, const Ray& to, Index first) {
        spread(v, from, to, first, source_ref, v, front);
      });
    m_sector.for_each_margin_behind(back, ties, m_state.hidden_angle(v), [&](const Ray& from, const Ray& to, Index first) {
      spread(v, from, to, first, source_ref, v, front, true);
    });
    if (is_pending && m_mesh.has_several_fans(v))
      m_mesh.for_each_fan(v, [&](Index first) {
        if (!in_fan(back.corner, first)) spread(v, Ray(), Ray(), first, source_ref, v, front);
      });
  }

private:
  // Adds the window on the twin of halfedge k of a face: the rays of `local` that leave the face through the halfedge.
  template <class Front>
  void add_exit(Index face, const Face_frame<FT>& frame, int k, const Face_window<FT>& local, Front& front) const
  {
    const Index g = m_mesh.twin(3 * face + Index(k));
    if (g == no_index) return;
    Window w{local.x, local.y, local.sigma, FT(0), m_mesh[g].length, FT(0), FT(0), local.source_ref, local.bits};
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
    if (w.b0 < FT(0)) w.b0 = FT(0);
    if (w.b1 > m_mesh[g].length) w.b1 = m_mesh[g].length;
    if (!(w.b0 < w.b1)) return;
    w.d0 = w.distance_at(w.b0);
    w.d1 = w.distance_at(w.b1);
    // the terms of the distances, in the frame of the face and in that of the edge
    const FT size = (std::max)({m_mesh[g].length, FT(CGAL::abs(local.sigma)), FT(CGAL::abs(w.sigma))});
    if (cut_behind_source(local.start_value, size, w)) front.add_apart(g, w);
  }

  // Ensures that the image of w lies on the near side of the edge that its rays cross (see Initial_windows). If rounding has
  // put the image on the edge or beyond it, moves the image to the near side, by the rounding error of its height. With exact
  // numbers, returns false for such an image.
  static bool put_before_edge(const Face_frame<FT>& frame, Window& w)
  {
    if constexpr (Number_policy<FT>::is_inexact)
      if (!(w.y < FT(0))) w.y = -Initial_windows<FT>::rounding_of_height(frame);
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
    (w.d0 < s ? w.b0 : w.b1) = b;
    (w.d0 < s ? w.d0 : w.d1) = s;
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

  // Starts the rays from v in a sector, or in its margin with the surcharge of Vertex_sector: windows on the edges opposite to
  // v, and updates of vertices along the edges.
  template <class Front>
  void spread(Index v, const Ray& from, const Ray& to, Index first, Source_ref source_ref, Index pseudo_source, Front& front,
              bool is_margin = false) const
  {
    const FT sigma = pseudo_source == no_index ? m_state.field.start_values.of(source_ref) : m_state.field.distance[v];
    m_sector.for_each_corner(from, to, first, [&](Index h, const Ray* lower, const Ray* upper) {
      const Index e = m_mesh.next(h), p = m_mesh.previous(h);
      front.schedule(m_mesh.face(h));
      front.update_vertex(m_mesh.source(e),
                          {sigma + m_mesh[h].length, Ray{e, m_mesh[e].apex_x, m_mesh[e].apex_y}, source_ref, pseudo_source});
      front.update_vertex(m_mesh.source(p), {sigma + m_mesh[p].length, Ray{p, FT(1), FT(0)}, source_ref, pseudo_source});
      const Index g = m_mesh.twin(e);
      if (g == no_index) return;
      const FT length = m_mesh[e].length;
      Window w{length - m_mesh[e].apex_x,
               -m_mesh[e].apex_y,
               sigma,
               FT(0),
               length,
               FT(0),
               FT(0),
               source_ref,
               Window::make_bits(false, pseudo_source)};
      // the frame of the twin runs backwards: the lower ray ends the interval
      if (lower) w.b1 = m_sector.exit_of_ray(h, *lower);
      if (upper) w.b0 = m_sector.exit_of_ray(h, *upper);
      if (w.b0 < w.b1)
      {
        if (is_margin) w.sigma += m_sector.margin_surcharge((std::max)(w.distance_at(w.b0), w.distance_at(w.b1)));
        w.d0 = w.distance_at(w.b0);
        w.d1 = w.distance_at(w.b1);
        front.add(g, w); // before spread_beyond(), which updates vertices that are not ends of g
      }
      if (Number_policy<FT>::is_inexact && pseudo_source != no_index && m_mesh[e].apex_y < least_clear_distance<FT>() * length)
        spread_beyond(h, lower, upper, sigma, source_ref, pseudo_source, front, is_margin);
    });
  }

  // For a vertex very close to the edge opposite to h: starts the rays of this corner again, as windows of the face beyond that
  // edge, since intervals on the edge have too few directions through rounding (Initial_windows::add_rays_beyond()).
  template <class Front>
  BOOST_NOINLINE void spread_beyond(Index h, const Ray* lower, const Ray* upper, const FT& sigma, Source_ref source_ref,
                                    Index pseudo_source, Front& front, bool is_margin) const
  {
    Initial_windows<FT> rays(m_mesh);
    rays.add_rays_beyond(h, lower, upper, source_ref);
    const auto surcharge = [&](const FT& d) { return is_margin ? m_sector.margin_surcharge(d) : FT(0); };
    for (const auto& s : rays.seeds)
    {
      const FT d = sigma + s.distance;
      front.update_vertex(s.vertex, {d + surcharge(d), s.back, source_ref, pseudo_source});
    }
    for (auto& l : rays.beyond_edges)
    {
      const Face_frame<FT> frame(m_mesh, l.face);
      front.schedule(l.face);
      l.window.sigma =
        sigma +
        surcharge(sigma + (std::max)(length(l.window.left - l.window.image()), length(l.window.right - l.window.image())));
      l.window.bits = Window::make_bits(false, pseudo_source);
      add_exit(l.face, frame, int(l.window.edge), l.window, front);
    }
  }

  Wavefront_state<FT>& m_state;
  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Traits& m_traits;
  Vertex_sector<FT> m_sector;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
