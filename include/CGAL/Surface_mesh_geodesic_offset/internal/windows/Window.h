// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window: a set of straight rays that enter a face through an interval of one of its halfedges.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Merge_error_code.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <utility>

namespace CGAL::Geodesic_offset::internal {

// Least distance of an image from an edge, as a fraction of its length L, at which rounding keeps the directions behind the
// image; 2^-30 in double. With u = Number_policy<FT>::rounding(1), ends of windows are rounded to 2 u L, and windows shorter
// than 8 u L are dropped; from an image at distance r, that is an angle of up to 8 u L / r. At this r the angle is 2^7 sqrt(u),
// 2e-6 in double, and a path that bends by it is too long by 2^13 u of its length.
template <class FT>
FT least_clear_distance()
{
  return FT(Number_policy<FT>::root_of_rounding() * 0x1p-4);
}

// Least distance of a vertex from its image, as a fraction of L, at which it does not hide the rays behind it; 2^-13 in double.
// At a smaller distance r there is a gap of the angle 8 u L / r, and paths to points of other vertices in the gap go around its
// ends. At this r the gap is 2^-10 sqrt(u) wide, 1e-11 in double. Binding test: test_field_regressions, tie with a near image.
template <class FT>
FT least_hiding_distance()
{
  return FT(Number_policy<FT>::root_of_rounding() * 0x1p13);
}

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

// A window on a halfedge, in the frame of the halfedge. The face to enter is above the x axis; the source image (x : y : w) is
// below it, or on it for a source on the edge.
//
//   w = 1, interval window (also behind a pseudo-source):  D(p) = sigma + |p - (x, y)|
//   w = 0, parallel-source window, (x, y) a unit vector:   D(p) = sigma - (x, y) . p
//
// All rays of a window are shortest among the paths with the same face sequence. [b0, b1] is the interval, and d0, d1 are the
// distances at its ends. A window of doubles fills one aligned cache line.
template <class FT>
struct alignas(sizeof(FT) == 8 ? 64 : alignof(FT)) Window
{
  FT x, y, sigma;
  FT b0, b1, d0, d1;
  Source_ref source_ref;
  Index bits; // bit 0: parallel; bit 1: already propagated; above: 1 + pseudo-source vertex, 0 if none; see Merge_error_code

  bool is_parallel() const { return bits & 1u; }
  bool is_propagated() const { return bits & 2u; }
  void set_propagated() { bits |= 2u; }
  void set_new() { bits &= ~Index(2); }                   // not propagated
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
};

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
