// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Propagates all windows of a halfedge across its face at once. Writes its own result only, so several batches may run at the
// same time.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_BATCH_PROPAGATION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_BATCH_PROPAGATION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/memory/Inline_sequence.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Simd_edge_exit.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/window_checks.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_order.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_propagation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_pruning.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Writes the children of windows that leave a face through one of the two other edges, after pruning.
template <class Traits, bool is_left_>
struct Child_window_writer
{
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  static constexpr bool is_left = is_left_;

  // Adds the rays of a window on one side of `bound`. at_apex: the rays up to the apex, where the distance is d_apex.
  template <bool is_parallel>
  BOOST_FORCEINLINE void take(const Window_propagation<Traits>& face, const Window& w, const FT& bound, bool at_apex,
                              const FT& d_apex)
  {
    Window& child = output.next();
    if constexpr (is_left)
    {
      if (!face.template left_child<is_parallel>(w, bound, at_apex, d_apex, child)) return;
      if (pruning.is_filtered(child.b0, child.d0)) return;
    }
    else
    {
      if (!face.template right_child<is_parallel>(w, bound, at_apex, d_apex, child)) return;
      if (pruning.is_filtered(child.b1, child.d1)) return;
    }
    if (pruning.trim(child)) Wavefront_state<FT>::keep(output, maximum);
  }

  // Adds a window with all its rays.
  template <bool is_parallel>
  BOOST_FORCEINLINE void take_whole(const Window_propagation<Traits>& face, const Simd_edge_exit<Traits, is_left>& edge,
                                    const Window& w)
  {
    if constexpr (Has_pair_children<Traits>::value)
    {
      Window_pairs<FT> p(w);
      if (BOOST_LIKELY(edge.template child<is_parallel>(p))) take_child<is_parallel>(w, p);
      else take_by_parts<is_parallel>(face, w);
    }
    else take_by_parts<is_parallel>(face, w);
  }

  Window_pruning<FT> pruning;
  typename Wavefront_state<FT>::Output::Cursor output;
  const FT maximum;

private:
  template <bool is_parallel>
  BOOST_FORCEINLINE void take_child(const Window& w, const Window_pairs<FT>& p)
  {
    const FT b0 = p.b.first(), b1 = p.b.second(), d0 = p.d.first(), d1 = p.d.second();
    if (pruning.is_filtered(is_left ? b0 : b1, is_left ? d0 : d1)) return;
    Window& child = output.next();
    if (BOOST_UNLIKELY(!pruning.leaves_all(p.b, p.d) || !pruning.is_wide(b0, b1)))
    {
      p.put(child);
      take_origin(w, child);
      if (pruning.trim(child)) Wavefront_state<FT>::keep(output, maximum);
      return;
    }
    const FT nearest = minimum(is_parallel, b0, b1, FT(p.image.first()), FT(p.sigma - p.image.second()), d0, d1);
    if (certainly_less(maximum, nearest)) return;
    p.put(child);
    take_origin(w, child);
    output.keep(nearest);
  }

  // Copies the origin by one load and one store.
  static void take_origin(const Window& w, Window& child)
  {
    const Source_ref source_ref = w.source_ref;
    const Index bits = w.bits;
    child.source_ref = source_ref;
    child.bits = bits;
  }

  // Adds a window with all rays, one end after the other.
  template <bool is_parallel>
  BOOST_NOINLINE void take_by_parts(const Window_propagation<Traits>& face, const Window& w)
  {
    if constexpr (is_left) take<is_parallel>(face, w, w.b1, false, w.d1);
    else take<is_parallel>(face, w, w.b0, false, w.d0);
  }
};

template <class Traits>
class Batch_propagation
{
public:
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef typename Wavefront_state<FT>::Output Output;
  typedef Vertex_update<FT> Update;

  Batch_propagation(const Wavefront_state<FT>& state, const Traits& traits)
    : m_state(state), m_mesh(state.mesh), m_traits(traits)
  {
  }

  // Propagates the new ones of the n windows w of a halfedge, a lower envelope or a monotone list, across the face. `split`:
  // the smallest distance of the apex through this halfedge so far, and the entry of its ray.
  void operator()(Index h, const Window* w, std::size_t n, FT& split_distance, FT& split_entry)
  {
    const Index beyond_left = m_mesh.twin(m_mesh.previous(h)), beyond_right = m_mesh.twin(m_mesh.next(h));
    m_state.field.lists.prefetch_place(beyond_left); // destination of the children
    m_state.field.lists.prefetch_place(beyond_right);
    CGAL_precondition(std::is_sorted(w, w + n, Window_order<FT, Window>::begins_before));
    CGAL_expensive_precondition(std::all_of(w, w + n, [&](const Window& a) { return has_interval(a, m_mesh[h].length); }));
    const Window_propagation<Traits> face(m_mesh, h, m_traits);
    m_updates.clear();
    m_apex = m_mesh.apex(h);
    m_best = split_distance;
    m_entry = split_entry;
    m_known = m_state.field.distance[m_apex];
    const FT dp = m_state.field.distance[m_mesh.source(h)], dq = m_state.field.distance[m_mesh.target(h)];
    const FT along_edge = (std::min)(FT(dp + face.left_length), FT(dq + face.right_length));
    find_exits(h, face, w, n, along_edge);
    split_distance = m_best;
    split_entry = m_entry;
    const FT dr = m_known;
    const Estimate across = estimate(face.left_length) + estimate(face.right_length) + estimate(face.length);
    const Estimate allowance = pruning_allowance<FT>(estimate(m_farthest) + across, m_mesh.longest_edge());
    m_left.clear();
    m_right.clear();
    if (m_left_end != 0 && m_state.takes_windows(beyond_left)) leave<true>(face, w, n, beyond_left, dp, dr, dq, allowance);
    if (m_right_begin != n && m_state.takes_windows(beyond_right))
      leave<false>(face, w, n, beyond_right, dr, dq, dp, allowance);
  }

  // Result: updates for the apex, and windows on the twins of the two other halfedges.
  Index apex() const { return m_apex; }
  const Inline_sequence<Update>& updates() const { return m_updates; }
  const Output& left() const { return m_left; }
  const Output& right() const { return m_right; }
  std::size_t number_of_windows() const { return m_number; }

private:
  typedef typename Interval_filter<FT>::Estimate Estimate;

  // The sides of the apex that the rays of a window pass. Windows with the apex on a bounding ray are distinguished only if
  // side tests are exact for all rays.
  enum Exit : int { NONE, LEFT, UP_TO_APEX, BOTH, FROM_APEX, RIGHT };
  static constexpr bool is_exact = !Number_policy<FT>::is_inexact;

  // Ray of a window to the apex: the distance of the apex along it, and its entry into the face.
  struct Apex_ray
  {
    FT distance, entry;
  };

  // Propagates all windows through the left or the right edge, the halfedge `beyond` of the next face, as far as they leave
  // through it. Distances: ds and dt of the ends of the edge, d_far of the far vertex.
  template <bool is_left>
  BOOST_NOINLINE void leave(const Window_propagation<Traits>& face, const Window* w, std::size_t n, Index beyond, const FT& ds,
                            const FT& dt, const FT& d_far, const Estimate& allowance)
  {
    const Exit whole = is_left ? LEFT : RIGHT;
    Output& output = is_left ? m_left : m_right;
    const std::size_t end = is_left ? m_left_end : n;
    Child_window_writer<Traits, is_left> way{
      Window_pruning<FT>(is_left ? face.left_length : face.right_length, ds, dt, allowance), output.start(beyond, true, n),
      m_state.maximum};
    // The far vertex in the frame of the exit: q seen from p -> r, or p seen from r -> q.
    if constexpr (is_left) way.pruning.set_far_vertex(face.cl * face.length, -face.sl * face.length, d_far, allowance);
    else way.pruning.set_far_vertex(face.right_length - face.cr * face.length, -face.sr * face.length, d_far, allowance);
    const Simd_edge_exit<Traits, is_left> edge(face, m_traits);
    const Exit* const exit = m_exit.data();
    for (std::size_t i = is_left ? 0 : m_right_begin; i < end; ++i)
    {
      if (exit[i] == whole)
      {
        if (w[i].is_parallel()) way.template take_whole<true>(face, edge, w[i]);
        else way.template take_whole<false>(face, edge, w[i]);
      }
      else if (exit[i] == BOTH || exit[i] == (is_left ? UP_TO_APEX : FROM_APEX))
      {
        if (w[i].is_parallel()) split<true>(face, w[i], m_apex_ray[i], way);
        else split<false>(face, w[i], m_apex_ray[i], way);
      }
    }
    output.finish(way.output);
  }

  // One angle, one split: only the window nearest to the apex keeps all its rays. The others keep, on the side of the nearest
  // ray's entry, the rays that enter before it.
  template <bool is_parallel, class Way>
  BOOST_NOINLINE void split(const Window_propagation<Traits>& face, const Window& w, const Apex_ray& ray, Way& way) const
  {
    const Estimate at_split = estimate(ray.entry), at_entry = estimate(m_entry);
    const bool may_be_best = CGAL::possibly(estimate(ray.distance) <= estimate(m_best));
    const bool at_apex = may_be_best || CGAL::possibly(Way::is_left ? at_split <= at_entry : at_split >= at_entry);
    const FT bound = at_apex      ? ray.entry
                   : Way::is_left ? FT(Interval_filter<FT>::upper_cut(at_entry))
                                  : FT(Interval_filter<FT>::lower_cut(at_entry));
    if ((!is_exact && at_apex) ||
        CGAL::possibly(Way::is_left ? estimate(bound) > estimate(w.b0) : estimate(bound) < estimate(w.b1)))
      way.template take<is_parallel>(face, w, bound, at_apex, ray.distance);
  }

  // Finds the exits of the windows, and updates the apex by the nearest window that covers it. With inexact numbers, rounding may
  // leave the apex between two windows, so a window that misses it by rounding updates it, too. Also finds the smallest distance of
  // the apex through h so far, and the entry of its ray.
  BOOST_FORCEINLINE void find_exits(Index h, const Window_propagation<Traits>& face, const Window* windows, std::size_t n,
                                    const FT& along_edge)
  {
    if (m_exit.size() < n)
    {
      m_exit.resize(n);
      m_apex_ray.resize(n);
    }
    const Window* nearest = nullptr;
    std::size_t left_end = 0, right_begin = n;
    Exit* const exits = m_exit.data();
    std::size_t number = n, number_at_apex = 0;
    FT farthest(0);
    for (std::size_t i = 0; i < n; ++i)
    {
      const Window& w = windows[i];
      if (w.is_propagated())
      {
        exits[i] = NONE;
        --number;
        continue;
      }
      if constexpr (!is_exact) farthest = (std::max)(farthest, w.d1);
      const Exit exit = exits[i] = exit_of(h, face, w);
      if (exit != RIGHT) left_end = i + 1;
      if (exit != LEFT && right_begin == n) right_begin = i;
      if (exit != LEFT && exit != RIGHT)
      {
        ++number_at_apex;
        const Apex_ray& ray = m_apex_ray[i] = {face.distance_at_apex(w), face.entry_of_apex(w)};
        if (ray.distance < m_best)
        {
          m_best = ray.distance;
          m_entry = ray.entry;
          nearest = &w;
        }
      }
    }
    m_number = number;
    m_left_end = left_end;
    m_right_begin = right_begin;
    m_farthest = farthest;
    if (nearest) update_apex(h, face, m_best, *nearest);
    if (is_exact) return;
    if (nearest && number_at_apex > 1 &&
        (m_mesh.can_be_pseudo_source(m_apex) || nearest->source_ref.side() == Source_side::CAP))
      for (std::size_t i = right_begin; i < left_end; ++i)
        if (exits[i] == BOTH && &windows[i] != nearest && m_state.tie(m_apex_ray[i].distance, m_best))
          update_apex(h, face, m_apex_ray[i].distance, windows[i]);
    // The path to the apex along an edge of the face is shorter only in needles, where windows have the rounding error of much
    // longer edges, and beside the border: a ray that passes a vertex of the border next to its image may miss the next one.
    if (!m_state.is_shorter(along_edge, m_known)) return;
    const bool is_reached = Number_policy<FT>::is_finite(m_known);
    if (!is_reached && m_mesh.twin(m_mesh.previous(h)) != no_index && m_mesh.twin(m_mesh.next(h)) != no_index) return;
    const Source_ref source_ref = m_updates.empty() ? m_state.field.source_ref[m_apex] : m_updates.back().source_ref;
    // no other batch may reach it again
    const Update update =
      is_reached ? m_state.along_edge(m_mesh.previous(h), source_ref) : m_state.along_edges(m_apex, source_ref);
    m_known = update.distance;
    m_updates.push_back(update);
  }

  BOOST_FORCEINLINE Exit exit_of(Index h, const Window_propagation<Traits>& face, const Window& w)
  {
    if constexpr (is_exact) return exact_exit_of(face, w);
    FT left, right; // positive: all rays pass the apex on this side
    const FT margin =
      w.is_parallel() ? face.template sides_of_apex<true>(w, left, right) : face.template sides_of_apex<false>(w, left, right);
    if (left > margin) return LEFT;
    if (right > margin) return RIGHT;
    if (BOOST_LIKELY(!(left > FT(0) || right > FT(0)))) return BOTH;
    update_apex_beside(h, face, w, left > right ? w.d1 : w.d0);
    return left > right ? LEFT : RIGHT;
  }

  BOOST_NOINLINE Exit exact_exit_of(const Window_propagation<Traits>& face, const Window& w)
  {
    const auto compare = m_traits.compare_entry_with_apex_2_object();
    const auto side = [&](const FT& b) { return compare(w.x, w.y, w.is_parallel(), b, face.apex_x, face.apex_y); };
    const Sign at_b0 = side(w.b0);
    if (at_b0 == POSITIVE) return RIGHT;
    const Sign at_b1 = side(w.b1);
    return at_b1 == NEGATIVE ? LEFT : at_b0 == ZERO ? FROM_APEX : at_b1 == ZERO ? UP_TO_APEX : BOTH;
  }

  // Updates the apex by a window whose bounding ray, which enters the face at distance d_entry, misses it by rounding. An apex at a
  // smaller distance lies beside the ray before it enters.
  BOOST_NOINLINE void update_apex_beside(Index h, const Window_propagation<Traits>& face, const Window& w, const FT& d_entry)
  {
    const FT d = face.distance_at_apex(w);
    if (!(d < m_known || m_state.tie(d, m_known)) || d < d_entry) return;
    FT x = w.is_parallel() ? w.x : FT(w.x - face.apex_x), y = w.is_parallel() ? w.y : FT(w.y - face.apex_y);
    if (CGAL::is_positive(FT(y * face.apex_x - x * face.apex_y)) ||
        CGAL::is_negative(FT(y * (face.apex_x - face.length) - x * face.apex_y)))
    { // not in the corner of the apex
      x = face.entry_of_apex(w) - face.apex_x;
      y = -face.apex_y;
    }
    update_apex(h, face, d, x, y, w, true);
  }

  void update_apex(Index h, const Window_propagation<Traits>& face, const FT& d, const Window& w)
  {
    const FT bx = w.is_parallel() ? w.x : FT(w.x - face.apex_x), by = w.is_parallel() ? w.y : FT(w.y - face.apex_y);
    update_apex(h, face, d, bx, by, w);
  }

  // (bx, by): vector from the apex toward the source, in the frame of h.
  void update_apex(Index h, const Window_propagation<Traits>& face, const FT& d, const FT& bx, const FT& by, const Window& w,
                   bool is_beside = false)
  {
    const Ray_at_vertex<FT> back{m_mesh.previous(h), -(face.cl * bx + face.sl * by), face.sl * bx - face.cl * by};
    m_updates.push_back({d, back, w.source_ref, w.pseudo_source(), is_beside});
    if (d < m_known) m_known = d;
  }

  const Wavefront_state<FT>& m_state;
  const Unfolded_mesh<FT>& m_mesh;
  const Traits& m_traits;
  Output m_left, m_right;
  Inline_sequence<Update> m_updates;
  std::size_t m_number = 0;
  std::size_t m_left_end, m_right_begin; // end of the windows that leave to the left, begin of those to the right
  Index m_apex;
  FT m_known, m_best, m_entry, m_farthest; // of the apex: its distance, the smallest through the halfedge, its entry
  std::vector<Exit> m_exit;
  std::vector<Apex_ray> m_apex_ray; // of windows that cover the apex
};

} // namespace CGAL::Geodesic_offset::internal

#endif
