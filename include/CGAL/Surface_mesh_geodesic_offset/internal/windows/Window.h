// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window: a set of straight rays that enter a face through an interval of one of its halfedges.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_number_pair.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Merge_error_code.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/window_allowance.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace CGAL::Geodesic_offset::internal {

// End of a shortest path: a primitive of the source set, and its side.
struct Source_ref
{
  Index value = no_index;

  Source_ref() = default;
  Source_ref(Index primitive, Source_side side) : value(primitive << 2 | Index(side))
  {
    CGAL_precondition(primitive < no_index >> 2);
  }
  Index primitive() const { return value >> 2; }
  Source_side side() const { return Source_side(value & 3u); }
  bool is_valid() const { return value != no_index; }
  bool is_lateral() const { return side() == Source_side::LEFT || side() == Source_side::RIGHT; }

  friend bool operator==(Source_ref a, Source_ref b) { return a.value == b.value; }
};

// The rays of a window on a halfedge, in the frame of the halfedge. The face to enter is above the x axis; the source image
// (x : y : w) is below it, or on it for a source on the edge.
//
//   w = 1, interval window (also behind a pseudo-source):  D(p) = sigma + |p - (x, y)|
//   w = 0, parallel-source window, (x, y) a unit vector:   D(p) = sigma - (x, y) . p
//
// All rays of a window are shortest among the paths with the same face sequence. The bounding rays are directions: a position on
// an edge next to the image would determine its ray only up to the rounding of the edge over its distance from the image.
//
//   w = 1:  the slope dx / dy of the ray, which meets the halfedge at x - y t
//   w = 0:  its signed distance from the origin, y b for the ray through (b, 0)
template <class FT>
struct Window_rays
{
  FT x, y, sigma;
  FT t0, t1; // bounding rays, from left to right seen along them
  Source_ref source_ref;
  Index bits; // bit 0: parallel; bit 1: already propagated; above: 1 + pseudo-source vertex, 0 if none; see Merge_error_code

  bool is_parallel() const { return bits & 1u; }
  bool is_propagated() const { return bits & 2u; }
  void set_propagated() { bits |= 2u; }
  Index pseudo_source() const { return (bits >> 2) - 1; } // no_index if none
  bool is_merged() const { return Merge_error_code::is_merged(pseudo_source()); }
  static Index make_bits(bool parallel, Index pseudo_source)
  {
    CGAL_precondition(pseudo_source == no_index || pseudo_source < no_index >> 2);
    return Index(parallel) | (pseudo_source == no_index ? 0u : (pseudo_source + 1) << 2);
  }

  // Distance at the point (t, 0) of the halfedge.
  FT distance_at(const FT& t) const
  {
    if (is_parallel()) return sigma - x * t;
    const FT u = t - x;
    return sigma + square_root<FT>(u * u + y * y);
  }

  // Distance at the point (px, py), which must lie in the cone of the window.
  FT distance_at(const FT& px, const FT& py) const
  {
    if (is_parallel()) return sigma - (x * px + y * py);
    const FT u = px - x, v = py - y;
    return sigma + square_root<FT>(u * u + v * v);
  }

  // True if the cone is wider than the rounding of its bounding rays, even if its interval is narrower than rounding.
  bool is_open() const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return false;
    else if (is_parallel()) return t0 > t1;
    // the sine of the angle, and its cosine for an angle of nearly a half turn
    const FT width = t1 - t0;
    return width > FT(0) &&
           (width > Number_policy<FT>::rounding(roundings_of_cone) * square_root<FT>((1 + t0 * t0) * (1 + t1 * t1)) ||
            1 + t0 * t1 < FT(0));
  }

  // The ray through (b, 0).
  FT ray_at(const FT& b) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return FT(0);
    else return is_parallel() ? FT(y * b) : FT((x - b) / (std::min)(y, FT(-least_height)));
  }

  // The slopes dx / dy of the ray t, of the ray through (b, 0), and of the bounding rays; zero for exact numbers.
  FT slope(const FT& t) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return FT(0);
    else return is_parallel() ? FT(x / y) : t;
  }
  FT slope_at(const FT& b) const { return slope(ray_at(b)); }
  FT begin_slope() const { return slope(t0); }
  FT end_slope() const { return slope(t1); }

  // Where the ray t meets the line of the halfedge.
  FT position(const FT& t) const { return is_parallel() ? FT(t / y) : FT(x - y * t); }

  // Where the ray t meets a halfedge of the given length, and the distance there.
  void meet(const FT& t, const FT& length, FT& b, FT& d) const
  {
    b = position(t);
    d = is_parallel() ? FT(sigma - x * b) : FT(sigma - y * square_root<FT>(1 + t * t));
    put_on_edge(length, b, d);
  }

  // Puts a position b at distance d that is beyond an end of the halfedge, by rounding, on this end.
  void put_on_edge(const FT& length, FT& b, FT& d) const
  {
    if (BOOST_LIKELY(b >= FT(0) && b <= length)) return;
    b = b > FT(0) ? length : FT(0);
    d = distance_at(b);
  }
};

// A window on a halfedge: rays, and the interval [b0, b1] in which they meet it, with the distances d0, d1 at its ends. Exact
// numbers have no bounding rays, as their intervals have no error.
template <class FT>
struct Window : Window_rays<FT>
{
  typedef Window_rays<FT> Rays;

  FT b0, b1, d0, d1;

  Window() = default;
  Window(const Rays& rays, const FT& begin, const FT& end) : Rays(rays)
  {
    set_begin(begin, this->distance_at(begin));
    set_end(end, this->distance_at(end));
  }
  // The window of rays on a halfedge of the given length.
  BOOST_FORCEINLINE Window(const Rays& rays, const FT& length) : Rays(rays)
  {
    typedef Geodesic_number_pair<FT> Pair;
    if (BOOST_LIKELY(!rays.is_parallel()))
    {
      const Pair t(rays.t0, rays.t1), y(rays.y), b = Pair(rays.x) - y * t, zero(FT(0)), last(length);
      if (BOOST_LIKELY(((zero <= b) & (b <= last)).bits() == 3 && b.first() <= b.second()))
      {
        const Pair d = Pair(rays.sigma) - y * square_root(Pair(FT(1)) + t * t);
        b.put(b0, b1);
        d.put(d0, d1);
        return;
      }
    }
    this->meet(this->t0, length, b0, d0);
    this->meet(this->t1, length, b1, d1);
    if (BOOST_UNLIKELY(b1 < b0))
    { // by rounding
      b1 = b0;
      d1 = d0;
    }
  }

  void set_begin(const FT& b, const FT& d)
  {
    b0 = b;
    d0 = d;
    this->t0 = this->ray_at(b);
  }
  void set_end(const FT& b, const FT& d)
  {
    b1 = b;
    d1 = d;
    this->t1 = this->ray_at(b);
  }
  // Cuts off the begin or the end. Within `rounding` of the former end, the bounding ray stays: from an image next to the halfedge, a
  // position has less precision than the ray. `ray`: the ray through (b, 0). `slope`: of the ray of a neighbour that is as near at b. If
  // the two rays diverge, the bounding ray becomes that of the neighbour, so that no gap opens.
  BOOST_FORCEINLINE void cut_begin(const FT& b, const FT& d, const FT& rounding, const FT& ray, const FT& slope)
  {
    if constexpr (Number_policy<FT>::is_inexact)
      if (b - b0 > rounding)
      {
        if (BOOST_LIKELY(!open_gap(slope, this->slope(ray)))) this->t0 = ray;
        else if (!this->is_parallel()) this->t0 = (std::max)(this->t0, slope);
      }
    b0 = b;
    d0 = d;
  }
  BOOST_FORCEINLINE void cut_end(const FT& b, const FT& d, const FT& rounding, const FT& ray, const FT& slope)
  {
    if constexpr (Number_policy<FT>::is_inexact)
      if (b1 - b > rounding)
      {
        if (BOOST_LIKELY(!open_gap(this->slope(ray), slope))) this->t1 = ray;
        else if (!this->is_parallel()) this->t1 = (std::min)(this->t1, slope);
      }
    b1 = b;
    d1 = d;
  }
  // True if rays are missing between this window and the next one with the same image: the narrow sector behind a pseudo-source.
  bool leaves_gap_before(const Window& w, const FT& length) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return false;
    else
      return this->is_parallel() ? this->t1 - w.t0 > Number_policy<FT>::rounding(roundings_of_turn) * length
                                 : open_gap(this->t1, w.t0);
  }
  void take_end(const Window& w)
  {
    b1 = w.b1;
    d1 = w.d1;
    this->t1 = w.t1;
  }

private:
  // True if two rays from one point of the halfedge, with slopes from left to right, diverge by more than rounding.
  static bool open_gap(const FT& left, const FT& right)
  {
    return right - left > Number_policy<FT>::rounding(roundings_of_turn) * (1 + right * right) && right > left;
  }
};

// A window as it is stored in lists: of 48 bytes with numbers of type double.
template <class FT>
using Stored_window = std::conditional_t<Number_policy<FT>::is_inexact, Window_rays<FT>, Window<FT>>;

// The window that is stored for a halfedge of the given length.
template <class FT>
BOOST_FORCEINLINE Window<FT> restored(const Window_rays<FT>& rays, const FT& length)
{
  return Window<FT>(rays, length);
}
template <class FT>
const Window<FT>& restored(const Window<FT>& w, const FT&)
{
  return w;
}

// Sets the image of a window to the result of SurfaceMeshGeodesicOffsetTraits::Change_frame_2.
template <class FT, class Image>
BOOST_FORCEINLINE void set_image(Window<FT>& w, Image&& image)
{
  w.x = std::forward<Image>(image).x;
  w.y = std::forward<Image>(image).y;
  w.sigma = std::forward<Image>(image).sigma;
}

// Transforms the image of a window to another frame with the origin (ox, oy) and the x axis (c, s) in the present one.
template <class Traits, class FT>
inline void change_frame(const Traits& traits, Window<FT>& w, const FT& ox, const FT& oy, const FT& c, const FT& s)
{
  set_image(w, traits.change_frame_2_object()(w.x, w.y, w.sigma, w.is_parallel(), ox, oy, c, s));
}

} // namespace CGAL::Geodesic_offset::internal

#endif
