// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All windows of a halfedge, unfolded across its face at once.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_BATCH_PROPAGATION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_BATCH_PROPAGATION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Wavefront_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_propagation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_pruning.h>

#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class Traits>
class Batch_propagation
{
public:
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  Batch_propagation(Wavefront_state<FT>& state, const Traits& traits)
    : m_state(state), m_mesh(state.mesh), m_traits(traits)
  {
  }

  // Propagates the fresh ones of the windows of a halfedge, which are its lower envelope, across the face.
  void operator()(Index h, const std::vector<Window>& windows)
  {
    const Window_propagation<Traits> face(m_mesh, h, m_traits);
    const std::size_t n = windows.size();
    FT best, entry;
    sort_by_exit(h, face, windows, best, entry);

    const Index apex = m_mesh.apex(h), p = m_mesh.source(h), q = m_mesh.target(h);
    const FT dp = m_state.field.distance[p], dq = m_state.field.distance[q], dr = m_state.field.distance[apex];
    const Index left = m_mesh.twin(m_mesh.previous(h)), right = m_mesh.twin(m_mesh.next(h));
    // the far vertices in the frames of the exits: q seen from p -> r, p seen from r -> q
    const FT qx = face.cl * face.length, qy = -face.sl * face.length;
    const FT px = face.right_length - face.cr * face.length, py = -face.sr * face.length;
    const FT left_width = Number_policy<FT>::rounding(8) * face.left_length;
    const FT right_width = Number_policy<FT>::rounding(8) * face.right_length;
    typename Wavefront_state<FT>::Output to_left(m_state, left, n), to_right(m_state, right, n);
    for (std::size_t i = 0; i < n; ++i)
    {
      const Exit exit = m_exit[i];
      if (exit == NONE) continue;
      const Window& w = windows[i];
      ++m_state.counts.windows_propagated;
      FT split, d_apex, left_end, right_begin;
      FT d_left = w.d1, d_right = w.d0;
      bool left_to_apex = false, right_from_apex = false, goes_left = exit != RIGHT, goes_right = exit != LEFT;
      left_end = w.b1;
      right_begin = w.b0;
      if (covers_apex(exit))
      {
        // One angle, one split: only the window that is best at the apex keeps all its rays. Another one keeps, on the
        // side of the best ray's entry, the rays that enter before it.
        split = face.entry_of_apex(w);
        d_apex = m_apex_distance[i];
        const Estimate at_split = estimate(split), at_entry = estimate(entry);
        const bool may_be_best = CGAL::possibly(estimate(d_apex) <= estimate(best));
        left_to_apex = may_be_best || CGAL::possibly(at_split <= at_entry);
        right_from_apex = may_be_best || CGAL::possibly(at_split >= at_entry);
        left_end = left_to_apex ? split : FT(Estimation<FT>::upper_cut(at_entry));
        right_begin = right_from_apex ? split : FT(Estimation<FT>::lower_cut(at_entry));
        goes_left = exit != FROM_APEX && CGAL::possibly(estimate(left_end) > estimate(w.b0));
        goes_right = exit != UP_TO_APEX && CGAL::possibly(estimate(right_begin) < estimate(w.b1));
        if (!left_to_apex && goes_left) d_left = w.distance_at(left_end);
        if (!right_from_apex && goes_right) d_right = w.distance_at(right_begin);
      }
      if (goes_left && to_left.is_open())
      {
        Window& child = to_left.next();
        if (face.left_child(w, left_end, d_left, left_to_apex, d_apex, child) &&
            !filtered_by_far_vertex<FT>(child.b0, child.d0, dq, qx, qy) &&
            trim_by_ends<FT>(child, face.left_length, dp, dr, left_width))
          to_left.keep();
      }
      if (goes_right && to_right.is_open())
      {
        Window& child = to_right.next();
        if (face.right_child(w, right_begin, d_right, right_from_apex, d_apex, child) &&
            !filtered_by_far_vertex<FT>(child.b1, child.d1, dp, px, py) &&
            trim_by_ends<FT>(child, face.right_length, dr, dq, right_width))
          to_right.keep();
      }
    }
    to_left.close();
    to_right.close();
  }

private:
  typedef typename Estimation<FT>::Estimate Estimate;

  // The sides of the apex on which rays pass. Those that hit it at an end of the window are told apart only if side tests
  // are exact for all rays.
  enum Exit : char { NONE, LEFT, UP_TO_APEX, BOTH, FROM_APEX, RIGHT };
  static constexpr bool is_exact = !Number_policy<FT>::is_inexact;

  static bool covers_apex(Exit exit)
  {
    if constexpr (is_exact) return exit >= UP_TO_APEX && exit <= FROM_APEX;
    else return exit == BOTH;
  }

  // Tells through which edges the windows leave the face, and updates the distance of the apex by the best of the windows
  // that cover it. Unless numbers are exact, rounding may leave the apex between two windows. So a window that just misses
  // it gives it the length of the path round its end, which is always valid, and if none covers it, so do its neighbours
  // on either side. Returns the best distance given to the apex through h so far, and where its ray enters.
  void sort_by_exit(Index h, const Window_propagation<Traits>& face, const std::vector<Window>& windows, FT& best, FT& entry)
  {
    const auto compare = m_traits.compare_entry_with_apex_2_object();
    auto& list = m_state.field.lists.get(h);
    best = list.split_distance;
    entry = list.split_entry;
    m_exit.resize(windows.size());
    m_apex_distance.resize(windows.size());
    const Window *nearest = nullptr, *last_left = nullptr, *first_right = nullptr;
    bool covered = false;
    for (std::size_t i = 0; i < windows.size(); ++i)
    {
      const Window& w = windows[i];
      if (w.is_propagated())
      {
        m_exit[i] = NONE;
        continue;
      }
      Sign at_b0, at_b1 = ZERO;
      if ((at_b0 = compare(w.x, w.y, w.is_parallel(), w.b0, face.apex_x, face.apex_y)) == POSITIVE)
      {
        m_exit[i] = RIGHT;
        if (is_exact) continue;
        if (!first_right) first_right = &w;
        else if (face.passes_apex_closely(w, w.b0)) round_the_end(h, face, w, w.b0, w.d0);
      }
      else if ((at_b1 = compare(w.x, w.y, w.is_parallel(), w.b1, face.apex_x, face.apex_y)) == NEGATIVE)
      {
        m_exit[i] = LEFT;
        if (is_exact) continue;
        last_left = &w;
        if (face.passes_apex_closely(w, w.b1)) round_the_end(h, face, w, w.b1, w.d1);
      }
      else
      {
        m_exit[i] = !is_exact ? BOTH : at_b0 == ZERO ? FROM_APEX : at_b1 == ZERO ? UP_TO_APEX : BOTH;
        covered = true;
        const FT& d = m_apex_distance[i] = face.distance_at_apex(w);
        if (d < best)
        {
          best = d;
          nearest = &w;
        }
      }
    }
    if (nearest)
    {
      const Window& w = *nearest;
      entry = face.entry_of_apex(w);
      list.split_distance = best;
      list.split_entry = entry;
      const FT bx = w.is_parallel() ? w.x : FT(w.x - face.apex_x), by = w.is_parallel() ? w.y : FT(w.y - face.apex_y);
      update_apex(h, face, best, bx, by, w);
    }
    if (last_left && !covered) round_the_end(h, face, *last_left, last_left->b1, last_left->d1);
    if (first_right && (!covered || face.passes_apex_closely(*first_right, first_right->b0)))
      round_the_end(h, face, *first_right, first_right->b0, first_right->d0);
  }

  // The path that leaves the window at its end b, at distance d.
  void round_the_end(Index h, const Window_propagation<Traits>& face, const Window& w, const FT& b, const FT& d)
  {
    if (!(d < m_state.field.distance[m_mesh.apex(h)])) return;
    const FT bx = b - face.apex_x, by = -face.apex_y;
    const FT length = square_root<FT>(bx * bx + by * by);
    // if the window misses the apex by rounding only, the way to the image tells the direction better, also in tiny faces
    const FT ix = w.is_parallel() ? w.x : FT(w.x - face.apex_x), iy = w.is_parallel() ? w.y : FT(w.y - face.apex_y);
    const FT off = CGAL::abs(FT(ix * by - iy * bx)), away = w.is_parallel() ? FT(1) : square_root<FT>(ix * ix + iy * iy);
    const bool is_bent = off > away * (length * Number_policy<FT>::rounding(1 << 20) + d * Number_policy<FT>::rounding(64));
    const bool is_in_corner = !CGAL::is_positive(FT(iy * face.apex_x - ix * face.apex_y)) &&
                              !CGAL::is_negative(FT(iy * (face.apex_x - face.length) - ix * face.apex_y));
    update_apex(h, face, d + length, is_in_corner ? ix : bx, is_in_corner ? iy : by, w, is_bent);
  }

  // (bx, by): from the apex back towards the source, in the frame of h.
  void update_apex(Index h, const Window_propagation<Traits>& face, const FT& d, const FT& bx, const FT& by,
                   const Window& w, bool is_bent = false)
  {
    const Ray_at_vertex<FT> back{m_mesh.previous(h), -(face.cl * bx + face.sl * by), face.sl * bx - face.cl * by};
    m_state.update_vertex(m_mesh.apex(h), d, back, w.root, w.pseudo_source(), is_bent);
  }

  Wavefront_state<FT>& m_state;
  const Unfolded_mesh<FT>& m_mesh;
  const Traits& m_traits;
  std::vector<Exit> m_exit;
  std::vector<FT> m_apex_distance; // of those that leave through both edges
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
