// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merging of neighbouring windows with different images within a tolerance, which makes builds of bounded error cheap.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_WINDOW_MERGING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_WINDOW_MERGING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Merge_error_code.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_sequence.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Largest error of distances; they may be too small.
template <class FT>
struct Merging_tolerance
{
  FT relative = FT(0); // fraction of the distance
  FT absolute = FT(0); // length

  bool is_zero() const { return !(relative > FT(0)) && !(absolute > FT(0)); }
};

struct Merging_counts
{
  std::size_t windows_merged = 0; // number of windows removed
  double error_bound = 0, relative_error_bound = 0;

  void add(const Merging_counts& other)
  {
    windows_merged += other.windows_merged;
    error_bound = (std::max)(error_bound, other.error_bound);
    relative_error_bound = (std::max)(relative_error_bound, other.relative_error_bound);
  }
};

// Replaces runs of neighbours F on a halfedge by one window f with
//
//   (1)  f = F at both ends of the run,   (2)  f <= F between them,   (3)  F - f <= what the tolerance leaves.
//
// Error. Distances become smaller, by at most the error stored with the window: a window of error e gives every point that its
// rays reach a distance at least the length of some path on the mesh minus e. On the edge, e = (largest error of the run) +
// (largest F - f) satisfies this, and so it does behind the edge, as both sides grow by the length of the ray. A vertex has the
// error of its window, and passes it on as a pseudo-source. Comparisons with other windows and vertices only remove rays, which
// changes no error.
//
// Completeness. Distances do not grow, and no point is lost. Follow a path over the halfedges that it crosses, each in the
// direction of the crossing. If the windows of one halfedge are at most the length of the path so far, so are those of the
// next, since a window gives a point that its rays reach the shortest of all paths through its interval. If a path leaves the
// rays of its window, say to the left, it enters those of a neighbour: by (1) and (2) the rays at the ends of f are not inside
// those of F, so no gap opens between neighbours that met. The shortest path through the window then goes around its left end,
// where the neighbour has the same distance, by (1). Without (1), distances would jump from neighbour to neighbour, and a path
// across many windows would add up jumps without a bound. A window is cut or dropped only where another window or a vertex is
// nearer, as in an exact build.
//
// Choice. The windows with (1) form a family with one parameter, the distance r0 of the image from the first end. Of two of
// them, the nearer image gives smaller distances everywhere between the ends. So each condition of (2) is a bound of r0 in
// closed form, and the largest r0 is best.
//
// Rounding is not part of the error: there are thousands of merges along a strip. An image of the run that satisfies (1) is
// kept, so that rounding does not move images repeatedly. A new image is as precise as the distances that determine it. Where
// rays graze the edge, as in needles, or the run is narrow, distances do not determine directions, and no new image is made.
// Whether the rays at the ends enclose those of the run is tested directly, not by distances.
template <class FT>
class Window_merging
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  Window_merging(const Geodesic_field<FT>& field, const std::vector<Index>& source_of,
                 const Merging_tolerance<FT>& tolerance)
    : m_field(field), m_source_of(source_of), m_tolerance(tolerance), m_is_on(!tolerance.is_zero())
  {
  }

  bool is_on() const { return m_is_on; }
  const Merging_counts& counts() const { return m_counts; }

  // Merges the windows of a halfedge, which are sorted and disjoint. Propagated windows stay unchanged. The result is valid
  // until the next call.
  const Window_sequence<FT>& operator()(const Window_sequence<FT>& windows)
  {
    if constexpr (Number_policy<FT>::is_inexact)
      if (m_is_on) return merged(windows);
    return windows;
  }

  // Error of the distance of a vertex or window with the given origin. If the distance of a pseudo-source has decreased since,
  // its new error is valid for the old distance too.
  double error_of_origin(Index origin) const
  {
    while (origin != no_index && !Merge_error_code::is_merged(origin)) origin = m_field.back[origin].pseudo_source;
    return origin == no_index ? 0 : Merge_error_code::error(origin);
  }

private:
  const Window_sequence<FT>& merged(const Window_sequence<FT>& windows)
  {
    m_windows.clear();
    for (std::size_t i = 0, end = 0; i < windows.size(); i = add_longest_run(windows, i, end))
    {
      if (end <= i) end = i + 1;
      while (end < windows.size() && may_merge(windows[end - 1], windows[end])) ++end;
    }
    return m_windows;
  }

  // Adds window i, merged with as many of its successors before `end` as possible. Returns the first unmerged one.
  std::size_t add_longest_run(const Window_sequence<FT>& windows, std::size_t i, std::size_t end)
  {
    // Doubles the step after each success, then halves it.
    Window run = windows[i], longer;
    std::size_t good = i + 1;
    bool grows = true;
    for (std::size_t step = 1; step > 0 && good < end;)
    {
      const std::size_t next = (std::min)(end, good + step);
      if (merge(windows.data() + i, windows.data() + next, longer))
      {
        run = longer;
        good = next;
      }
      else grows = false;
      step = grows ? 2 * step : step / 2;
    }
    m_windows.push_back(run);
    if (good > i + 1) count(run, good - i - 1);
    return good;
  }

  void count(const Window& run, std::size_t merged)
  {
    m_counts.windows_merged += merged;
    const double e = error_of_origin(run.pseudo_source());
    m_counts.error_bound = (std::max)(m_counts.error_bound, e);
    m_counts.relative_error_bound = (std::max)(m_counts.relative_error_bound, e / CGAL::to_double(minimum(run)));
  }

  bool may_merge(const Window& a, const Window& b) const
  {
    return !a.is_propagated() && !b.is_propagated() && b.b0 - a.b1 <= allowed_at((std::min)(a.d1, b.d0)) &&
           a.source_ref.side() == b.source_ref.side() && m_source_of[a.source_ref.primitive()] == m_source_of[b.source_ref.primitive()];
  }

  FT allowed_at(const FT& distance) const
  {
    return (std::min)(FT(m_tolerance.absolute + m_tolerance.relative * distance), FT(distance / 2));
  }

  // Merges [first, end) into one window m. Returns false if the tolerance does not allow it.
  bool merge(const Window* first, const Window* end, Window& m) const
  {
    return merge_with(first, end, m, false) || merge_with(first, end, m, true);
  }

  // Merges with an image of the run, or with a new image.
  bool merge_with(const Window* first, const Window* end, Window& m, bool is_new) const
  {
    const Window& last = *(end - 1);
    m = is_new ? *first : widest(first, end);
    m.b0 = first->b0;
    m.d0 = first->d0;
    m.b1 = last.b1;
    m.d1 = last.d1;
    const FT unit = Number_policy<FT>::rounding(16) * (m.d0 + m.d1 + m.b1 - m.b0);
    if (is_new ? !place_image(first, end, unit, m) : !passes_ends(m, unit)) return false;
    if (!encloses(*first, last, m)) return false;
    const FT rounding = unit + Number_policy<FT>::rounding(16) * CGAL::abs(m.sigma);
    // Most runs fail between the windows, so this test comes first.
    const FT at_ends = allowed_at((std::min)(m.d0, m.d1)) + rounding;
    for (const Window* w = first; w != &last; ++w)
      if (!(w->d1 - m.distance_at(w->b1) + FT(error_of_origin(w->pseudo_source())) <= at_ends)) return false;
    const FT allowed = allowed_at(minimum(m));
    const auto is_rounding = [&](const FT& error) { return 4 * error <= rounding; };
    FT largest(0), previous(0);
    bool is_same = !is_new;
    for (const Window* w = first; w != end; ++w)
    {
      FT added;
      if (!deviation(*w, m, rounding, added)) return false;
      const FT before = FT(error_of_origin(w->pseudo_source()));
      is_same = is_same && w->pseudo_source() == first->pseudo_source() && is_rounding(added);
      largest = (std::max)(largest, FT(is_rounding(added) ? before : before + added));
      if (w != first)
      {
        const FT in_gap = deviation_in_gap(*(w - 1), *w, m), at_gap = (std::max)(before, previous);
        is_same = is_same && is_rounding(in_gap);
        largest = (std::max)(largest, FT(is_rounding(in_gap) ? at_gap : at_gap + in_gap));
      }
      if (!(largest <= allowed)) return false;
      previous = before;
    }
    if (is_same) return true;
    const Index origin = Merge_error_code::with_error(CGAL::to_double(largest));
    m.bits = Window::make_bits(m.is_parallel(), origin);
    return FT(Merge_error_code::error(origin)) <= allowed;
  }

  static const Window& widest(const Window* first, const Window* end)
  {
    return *std::max_element(first, end, [](const Window& a, const Window& b) { return a.b1 - a.b0 < b.b1 - b.b0; });
  }

  // Condition (1), up to rounding.
  static bool passes_ends(const Window& m, const FT& unit)
  {
    return CGAL::abs(FT(m.distance_at(m.b0) - m.d0)) <= unit && CGAL::abs(FT(m.distance_at(m.b1) - m.d1)) <= unit;
  }

  // Largest F - f in the gap between two windows, where F is the shorter path around an end. f grows more slowly than these
  // paths, so the maximum is where both are equal.
  static FT deviation_in_gap(const Window& a, const Window& b, const Window& m)
  {
    const FT gap = b.b0 - a.b1, rise = b.d0 - a.d1;
    if (!(gap > CGAL::abs(rise))) return FT((std::max)(gap, FT(0)));
    return (a.d1 + b.d0 + gap) / 2 - m.distance_at(FT(a.b1 + (gap + rise) / 2));
  }

  // True if the rays at the ends of m are not inside those of the first and last window, up to rounding. For rays that graze
  // the edge, derivatives do not decide this.
  static bool encloses(const Window& first, const Window& last, const Window& m)
  {
    return !turns_right(first, m, m.b0) && !turns_right(m, last, m.b1);
  }

  // True if the ray of v through (b, 0) turns right of that of u by more than rounding. The allowance falls with the slope of
  // the rays.
  static bool turns_right(const Window& u, const Window& v, const FT& b)
  {
    const FT ux = u.is_parallel() ? FT(-u.x) : FT(b - u.x), vx = v.is_parallel() ? FT(-v.x) : FT(b - v.x);
    const FT length_u = square_root<FT>(ux * ux + u.y * u.y), length_v = square_root<FT>(vx * vx + v.y * v.y);
    const FT allowance = Number_policy<FT>::rounding(64) * length_u - Number_policy<FT>::rounding(2048) * u.y;
    return u.y * vx - ux * v.y < -allowance * length_v;
  }

  // Sets the image of m, whose interval and distances at the ends are given, as far away as (2) allows at the ends of the
  // windows [first, end). Let l be the length of the interval, c = (d1 - d0) / l, n = l^2 - (d1 - d0)^2. Then
  //
  //   x - b0 = n / 2l - c r0    as  r0^2 - (x - b0)^2 = r1^2 - (l - (x - b0))^2  and  r1 = r0 + c l
  //
  // The derivative of f at b0 is -(x - b0) / r0; it must be at most that of F, and likewise at b1. At a point at q
  // behind b0 where F is above the chord of the two distances by k, f <= F is
  //
  //   r0 <= ((1 - c^2) q (l - q) + 2 q c k + k^2) / -2k
  //
  // if k < 0, and no condition otherwise. Without any bound f is linear: rays are parallel.
  bool place_image(const Window* first, const Window* end, const FT& unit, Window& m) const
  {
    const FT l = m.b1 - m.b0, rise = m.d1 - m.d0;
    if (!(CGAL::abs(rise) < l)) return false;
    const FT n = (l - rise) * (l + rise), c = rise / l;
    const FT farthest = FT(1 << 8) * (m.d0 + m.d1 + l); // beyond, rounding exceeds the gain
    const FT unlimited = 2 * farthest;
    FT r0 = unlimited;
    const auto limit = [&r0](const FT& r)
    {
      if (r < r0) r0 = r;
    };
    const Window& last = *(end - 1);
    const FT at_b0 = slope(*first, first->b0, first->d0), at_b1 = slope(last, last.b1, last.d1);
    if (const FT k = rise - l * at_b0; k > unit) limit(n / (2 * k));
    if (const FT k = l * at_b1 - rise; k > unit) limit(n / (2 * k) - rise);
    const auto stay_below = [&](const FT& b, const FT& d)
    {
      const FT q = b - m.b0, k = d + unit - (m.d0 + c * q);
      if (k < FT(0)) limit((n / (l * l) * q * (l - q) + (2 * q * c + k) * k) / (-2 * k));
    };
    for (const Window* w = first; w != &last; ++w)
    {
      stay_below(w->b1, w->d1);
      stay_below((w + 1)->b0, (w + 1)->d0);
    }
    if (!(r0 > FT(0)) || !(r0 + rise > FT(0))) return false;
    // The error of rays is the rounding of the distances over the width of the run across them. If it is a large part of the
    // width, as in needles, the image is noise.
    if (n < Number_policy<FT>::rounding(1 << 14) * (m.d0 + m.d1) * (m.d0 + m.d1)) return false;
    if (r0 == unlimited)
    {
      m.bits = Window::make_bits(true, no_index);
      m.x = -c;
      m.y = -square_root<FT>(n) / l;
      m.sigma = m.d0 + m.x * m.b0;
      return m.y < FT(0);
    }
    limit(farthest);
    m.bits = Window::make_bits(false, no_index);
    const FT x = n / (2 * l) - c * r0;
    m.x = m.b0 + x;
    m.y = -square_root<FT>((r0 - x) * (r0 + x));
    m.sigma = m.d0 - r0;
    return m.y < FT(0);
  }

  // Derivative of the distance.
  static FT slope(const Window& w, const FT& b, const FT& d)
  {
    return w.is_parallel() ? FT(-w.x) : FT((b - w.x) / (d - w.sigma));
  }

  // Largest w - m on the interval of w. Returns false if m is larger somewhere by more than rounding. The difference is
  // monotone on either side of the point collinear with both images.
  static bool deviation(const Window& w, const Window& m, const FT& rounding, FT& largest)
  {
    const FT g0 = w.d0 - m.distance_at(w.b0), g1 = w.d1 - m.distance_at(w.b1);
    largest = (std::max)(g0, g1);
    FT smallest = (std::min)(g0, g1);
    const FT y = (w.is_parallel() ? FT(0) : m.y) - (m.is_parallel() ? FT(0) : w.y);
    if (!CGAL::is_zero(y) && !(w.is_parallel() && m.is_parallel()))
    {
      const FT b = (w.x * m.y - m.x * w.y) / y;
      if (w.b0 < b && b < w.b1)
      {
        const FT g = w.distance_at(b) - m.distance_at(b);
        largest = (std::max)(largest, g);
        smallest = (std::min)(smallest, g);
      }
    }
    if (largest < FT(0)) largest = FT(0);
    return !(smallest < -rounding);
  }

  const Geodesic_field<FT>& m_field;
  const std::vector<Index>& m_source_of;
  const Merging_tolerance<FT> m_tolerance;
  const bool m_is_on;
  Merging_counts m_counts;
  Window_sequence<FT> m_windows;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
