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
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/window_allowance.h>

#include <boost/config.hpp>

#include <algorithm>

namespace CGAL::Geodesic_offset::internal {

// The face of a halfedge p -> q with apex r, in the frame of the halfedge, and the frames of its exits p -> r and r -> q in the
// faces beyond.
//
// A ray through (b, 0) has the direction (bW - X, -Y). (c, s) is the direction of the exit; for the right exit everything is
// mirrored, with b counted from q. The ray meets the exit at distance  b (-Y) / D  from p, D = s (X - bW) - c Y.
template <class Traits>
class Window_propagation
{
public:
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  Window_propagation(const Unfolded_mesh<FT>& mesh, Index h, const Traits& traits)
    : m_traits(traits), m_change_frame(traits.change_frame_2_object())
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
      m_beside = error_of_image(mesh.longest_edge());
      m_reach = m_beside + closeness() * (length + apex_y + CGAL::abs(apex_x));
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
    return t < FT(0) ? FT(0) : t > length ? length : t;
  }

  // On which sides of the apex the rays of a window pass: all on the left if `left` is positive, all on the right if `right` is
  // positive. Returns the rounding error of these numbers.
  template <bool is_parallel>
  BOOST_FORCEINLINE FT sides_of_apex(const Window& w, FT& left, FT& right) const
  {
    if constexpr (is_parallel)
    {
      const FT offset = w.y * apex_x - w.x * apex_y;
      left = w.t1 - offset;
      right = offset - w.t0;
      return m_reach;
    }
    const FT along = apex_x - w.x, height = apex_y - w.y;
    left = along - w.t1 * height;
    right = w.t0 * height - along;
    return m_beside + closeness() * (height + 2 * CGAL::abs(along));
  }

  // Child on p -> r of the rays that enter from b0 to `end`; if to_apex, up to the apex, at distance apex_distance. Returns
  // false if nothing remains.
  template <bool is_parallel>
  BOOST_FORCEINLINE bool left_child(const Window& w, const FT& end, bool to_apex, const FT& apex_distance, Window& child) const
  {
    take_origin(w, child);
    set_image(child, m_change_frame(w.x, w.y, w.sigma, is_parallel, FT(0), FT(0), cl, sl));
    if (!CGAL::is_negative(child.y) && !put_before_edge<is_parallel>(child)) return false;
    if constexpr (Number_policy<FT>::is_inexact)
    {
      turn<is_parallel>(cl, sl, w.t0, left_length, child, child.t0, child.b0, child.d0);
      turn<is_parallel>(cl, sl,
                        to_apex       ? apex_ray<is_parallel>(w)
                        : end == w.b1 ? w.t1
                                      : w.ray_at(end),
                        left_length, child, child.t1, child.b1, child.d1);
      if (to_apex)
      {
        child.b1 = left_length;
        child.d1 = apex_distance;
      }
      return has_rays(child);
    }
    if (!meets<is_parallel>(w.x, w.y, w.b0, cl, sl, child.b0)) return false;
    child.d0 = distance_at(child, child.b0, FT(0));
    if (to_apex)
    {
      child.b1 = left_length;
      child.d1 = apex_distance;
    }
    else
    {
      if (!meets<is_parallel>(w.x, w.y, end, cl, sl, child.b1)) return false;
      child.d1 = distance_at(child, child.b1, FT(0));
    }
    return CGAL::possibly(estimate(child.b0) < estimate(child.b1));
  }

  // Child on r -> q of the rays that enter from `begin` to b1.
  template <bool is_parallel>
  BOOST_FORCEINLINE bool right_child(const Window& w, const FT& begin, bool from_apex, const FT& apex_distance,
                                     Window& child) const
  {
    take_origin(w, child);
    set_image(child, m_change_frame(w.x, w.y, w.sigma, is_parallel, apex_x, apex_y, cr, FT(-sr)));
    if (!CGAL::is_negative(child.y) && !put_before_edge<is_parallel>(child)) return false;
    if constexpr (Number_policy<FT>::is_inexact)
    {
      const FT shift = is_parallel ? FT(w.x * apex_y - w.y * apex_x) : FT(0), s = -sr;
      turn<is_parallel>(cr, s, w.t1 + shift, right_length, child, child.t1, child.b1, child.d1);
      if (from_apex)
      {
        turn<is_parallel>(cr, s, is_parallel ? FT(0) : apex_ray<is_parallel>(w), right_length, child, child.t0, child.b0,
                          child.d0);
        child.b0 = FT(0);
        child.d0 = apex_distance;
      }
      else
        turn<is_parallel>(cr, s, (begin == w.b0 ? w.t0 : w.ray_at(begin)) + shift, right_length, child, child.t0, child.b0,
                          child.d0);
      return has_rays(child);
    }
    const FT mirrored = is_parallel ? FT(-w.x) : FT(length - w.x);
    if (!meets<is_parallel>(mirrored, w.y, FT(length - w.b1), cr, sr, child.b1)) return false;
    child.b1 = right_length - child.b1;
    child.d1 = distance_at(child, child.b1, FT(0));
    if (from_apex)
    {
      child.b0 = FT(0);
      child.d0 = apex_distance;
    }
    else
    {
      if (!meets<is_parallel>(mirrored, w.y, FT(length - begin), cr, sr, child.b0)) return false;
      child.b0 = right_length - child.b0;
      child.d0 = distance_at(child, child.b0, FT(0));
    }
    return CGAL::possibly(estimate(child.b0) < estimate(child.b1));
  }

  // Rounding may move an image onto the line of an edge that its rays cross.
  template <bool is_parallel>
  bool put_before_edge(Window& w) const
  {
    if (is_parallel || !Number_policy<FT>::is_inexact) return false;
    w.y = -rounding_of_height(length);
    return true;
  }

  // Rounding may reverse the ends of a narrow window on the edge, but not its rays.
  static bool has_rays(Window& w)
  {
    if (w.b0 < w.b1) return true;
    if (!(w.is_parallel() ? w.t0 > w.t1 : w.t1 > w.t0)) return false;
    w.b1 = w.b0;
    w.d1 = w.d0;
    return true;
  }

  // The ray to the apex.
  template <bool is_parallel>
  FT apex_ray(const Window& w) const
  {
    return is_parallel ? FT(w.y * apex_x - w.x * apex_y) : FT((apex_x - w.x) / (apex_y - w.y));
  }

  // Turns the ray t into the frame with the x axis (c, s), in which the image is that of `child`.
  template <bool is_parallel>
  BOOST_FORCEINLINE static void turn(const FT& c, const FT& s, const FT& t, const FT& length, const Window& child, FT& turned,
                                     FT& b, FT& d)
  {
    if constexpr (is_parallel)
    {
      turned = t;
      child.meet(t, length, b, d);
    }
    else
    {
      const FT x = c * t + s, r = square_root<FT>(1 + t * t);
      FT y = c - s * t;
      if (y < Number_policy<FT>::rounding(roundings_across_edge) * r) y = FT(grazing_across) * r;
      const FT inverse = 1 / y;
      turned = x * inverse;
      b = child.x - child.y * turned;
      d = child.sigma - child.y * (r * inverse);
      child.put_on_edge(length, b, d);
    }
  }

  // Two bounding rays differ from their common direction by some rounding errors per edge that they have crossed.
  static FT closeness() { return Number_policy<FT>::rounding(1 << 10); }

  FT length, apex_x, apex_y, left_length, right_length;
  FT cl, sl; // direction of p -> r
  FT cr, sr; // direction of q -> r, mirrored

private:
  FT m_beside, m_reach; // error_of_image(), and with closeness() of the size of the face

  FT distance_at(const Window& w, const FT& px, const FT& py) const
  {
    return m_traits.compute_distance_2_object()(w.x, w.y, w.sigma, w.is_parallel(), px, py);
  }

  static void take_origin(const Window& w, Window& child)
  {
    child.source_ref = w.source_ref;
    child.bits = w.bits;
  }

  // Whether, and at which distance t, the ray through (b, 0) meets the edge from the origin in the direction (c, s). Distances
  // from the sources come from the image: one square root costs less than exact nested roots, which grow with each face.
  template <bool is_parallel>
  static bool meets(const FT& x, const FT& y, const FT& b, const FT& c, const FT& s, FT& t)
  {
    const FT den = is_parallel ? FT(s * x - c * y) : FT(s * (x - b) - c * y);
    if (!CGAL::is_positive(den)) return false;
    t = -(b * y) / den;
    return true;
  }

  const Traits& m_traits;
  const typename Traits::Change_frame_2 m_change_frame;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
