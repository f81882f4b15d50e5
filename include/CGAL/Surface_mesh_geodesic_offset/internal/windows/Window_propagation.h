// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unfolds a window across a face: its children on the two other edges.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_PROPAGATION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_PROPAGATION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_number_pair.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

#include <boost/config.hpp>

#include <algorithm>
#include <optional>

namespace CGAL::Geodesic_offset::internal {

// The face of a halfedge p -> q with apex r, in the frame of the halfedge, and the frames of its exits p -> r and r -> q in the
// faces beyond.
//
// A ray through (b, 0) has the direction (bW - X, -Y). (c, s) is the direction of the exit; for the right exit everything is
// mirrored, with b counted from q. The ray meets the exit at distance  b (-Y) / D  from p, D = s (X - bW) - c Y, after the
// fraction s b / D  of its length so far (of the unit for W = 0).
template <class Traits>
class Window_propagation
{
public:
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  Window_propagation(const Unfolded_mesh<FT>& mesh, Index h, const Traits& traits)
    : m_traits(traits), m_change_frame(traits.change_frame_2_object()), m_exit(traits.construct_exit_2_object())
  {
    const auto& e = mesh[h];
    length = e.length;
    apex_x = e.apex_x;
    apex_y = e.apex_y;
    left_length = mesh[mesh.previous(h)].length;
    right_length = mesh[mesh.next(h)].length;
    (Geodesic_number_pair<FT>::of(e.apex_x, e.apex_y) / Geodesic_number_pair<FT>(left_length)).put(cl, sl);
    // The angle at q comes from the vectors at q: length - apex_x would lose all digits on a tiny edge.
    const auto& n = mesh[mesh.next(h)];
    (Geodesic_number_pair<FT>::of(n.apex_x, n.apex_y) / Geodesic_number_pair<FT>(length)).put(cr, sr);
    if constexpr (Number_policy<FT>::is_inexact)
    {
      m_reach = length + apex_y;
      m_clear_margin = closeness() * (m_reach + CGAL::abs(apex_x));
    }
  }

  // Distance at the apex, which must lie in the cone of the window.
  FT distance_at_apex(const Window& w) const { return distance_at(w, apex_x, apex_y); }

  // Entry of the ray to the apex.
  FT entry_of_apex(const Window& w) const
  {
    const FT slope = w.is_parallel() ? FT(-w.y) : FT(apex_y - w.y);
    const FT t = (w.x * apex_y - w.y * apex_x) / slope;
    if constexpr (Interval_filter<FT>::leaves_open) return t; // side tests are exact then
    return t < w.b0 ? w.b0 : t > w.b1 ? w.b1 : t;
  }

  // Side on which all rays of a window pass the apex: -1 left, 1 right, 0 if the window covers the apex. `is_clear` is false if
  // that is not certain by much more than rounding.
  template <bool is_parallel>
  BOOST_FORCEINLINE int clear_side(const Window& w, bool& is_clear) const
  {
    const FT slope = is_parallel ? FT(-w.y) : FT(apex_y - w.y), r = w.x * apex_y - w.y * apex_x;
    const FT margin = is_parallel ? m_clear_margin : FT(m_clear_margin * (w.d1 + m_reach));
    const FT left = r - w.b1 * slope, right = w.b0 * slope - r;
    is_clear = true;
    if (left > margin) return -1;
    if (right > margin) return 1;
    is_clear = left < -margin && right < -margin;
    return 0;
  }

  // True if the ray through (b, 0) passes the apex so closely that rounding may have moved it to the other side.
  bool passes_apex_closely(const Window& w, const FT& b) const
  {
    const FT slope = w.is_parallel() ? FT(-w.y) : FT(apex_y - w.y), r0 = w.x * apex_y, r1 = w.y * apex_x;
    return CGAL::abs(FT(b * slope - (r0 - r1))) <= closeness() * (length * slope + CGAL::abs(r0) + CGAL::abs(r1));
  }

  // True if a bounding ray of a window that covers the apex passes it by less than eight times the square root of 2^-46, the
  // tie tolerance; a path of another image may then tie at the apex.
  bool is_beside_end(const Window& w) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return false;
    const FT slope = w.is_parallel() ? FT(-w.y) : FT(apex_y - w.y), r = w.x * apex_y - w.y * apex_x;
    return (std::min)(FT(r - w.b0 * slope), FT(w.b1 * slope - r)) <= FT(1. / (1 << 20)) * length * slope;
  }

  // Child on p -> r of the rays that enter from b0 to `end`; if to_apex, up to the apex, at distance apex_distance. Returns
  // false if nothing remains.
  template <bool is_parallel>
  BOOST_FORCEINLINE bool left_child(const Window& w, const FT& end, const FT& d_end, bool to_apex, const FT& apex_distance,
                                    Window& child) const
  {
    take_origin(w, child);
    set_image(child, m_change_frame(w.x, w.y, w.sigma, is_parallel, FT(0), FT(0), cl, sl));
    if (!CGAL::is_negative(child.y)) return false;
    const auto first = m_exit(w.x, w.y, w.sigma, is_parallel, w.b0, w.d0, cl, sl, left_length);
    if (!first) return false;
    child.b0 = first->t;
    child.d0 = distance_of(first->distance, child, child.b0);
    if (to_apex)
    {
      child.b1 = left_length;
      child.d1 = apex_distance;
    }
    else
    {
      const auto last = m_exit(w.x, w.y, w.sigma, is_parallel, end, d_end, cl, sl, left_length);
      if (!last) return false;
      child.b1 = last->t;
      child.d1 = distance_of(last->distance, child, child.b1);
    }
    return CGAL::possibly(estimate(child.b0) < estimate(child.b1));
  }

  // Child on r -> q of the rays that enter from `begin` to b1.
  template <bool is_parallel>
  BOOST_FORCEINLINE bool right_child(const Window& w, const FT& begin, const FT& d_begin, bool from_apex,
                                     const FT& apex_distance, Window& child) const
  {
    take_origin(w, child);
    set_image(child, m_change_frame(w.x, w.y, w.sigma, is_parallel, apex_x, apex_y, cr, FT(-sr)));
    if (!CGAL::is_negative(child.y)) return false;
    const FT mirrored = is_parallel ? FT(-w.x) : FT(length - w.x);
    const auto last = m_exit(mirrored, w.y, w.sigma, is_parallel, FT(length - w.b1), w.d1, cr, sr, right_length);
    if (!last) return false;
    child.b1 = right_length - last->t;
    child.d1 = distance_of(last->distance, child, child.b1);
    if (from_apex)
    {
      child.b0 = FT(0);
      child.d0 = apex_distance;
    }
    else
    {
      const auto first = m_exit(mirrored, w.y, w.sigma, is_parallel, FT(length - begin), d_begin, cr, sr, right_length);
      if (!first) return false;
      child.b0 = right_length - first->t;
      child.d0 = distance_of(first->distance, child, child.b0);
    }
    return CGAL::possibly(estimate(child.b0) < estimate(child.b1));
  }

  static FT closeness() { return Number_policy<FT>::rounding(1 << 16); }

  FT length, apex_x, apex_y, left_length, right_length;
  FT cl, sl; // direction of p -> r
  FT cr, sr; // direction of q -> r, mirrored

private:
  // Margin of clear_side(): `closeness` times a bound of the terms of a side test. With L = length and (a, b) the apex, they are
  // at most L + |a| + b for parallel rays. A point image has |x| <= L + d1 and |y| <= d1, so they are at most
  // L (b + |y|) + |x| b + |y| |a| <= (L + |a| + b) (d1 + L + b).
  FT m_reach, m_clear_margin;

  FT distance_at(const Window& w, const FT& px, const FT& py) const
  {
    return m_traits.compute_distance_2_object()(w.x, w.y, w.sigma, w.is_parallel(), px, py);
  }

  static void take_origin(const Window& w, Window& child)
  {
    child.source_ref = w.source_ref;
    child.bits = w.bits;
  }

  // The distance of an exit at (t, 0) in the frame of the child.
  BOOST_FORCEINLINE FT distance_of(const std::optional<FT>& distance, const Window& child, const FT& t) const
  {
    return BOOST_LIKELY(bool(distance)) ? *distance : distance_at(child, t, FT(0));
  }

  const Traits& m_traits;
  const typename Traits::Change_frame_2 m_change_frame;
  const typename Traits::Construct_exit_2 m_exit;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
