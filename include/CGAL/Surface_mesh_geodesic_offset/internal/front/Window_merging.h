// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Merging of neighbouring windows with different images within a tolerance, which makes builds of bounded error cheap.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_WINDOW_MERGING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_WINDOW_MERGING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/memory/Inline_sequence.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Merge_error_code.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Merging_tolerance.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/window_allowance.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

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

// Replaces two neighbours, whose lower envelope is F, on a halfedge by one window f with
//
//   (1)  f = F at both ends,   (2)  f <= F between them,   (3)  F - f <= what the tolerance leaves.
//
// Error. Distances become smaller, by at most the error stored with the window: a window of error e gives every point that its
// rays reach a distance at least the length of some path on the mesh minus e. On the edge, e = (larger error of the two) +
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
// Rounding is not part of the error: there are thousands of merges along a strip. An image of the two that satisfies (1) is
// kept, so that rounding does not move images repeatedly. A new image is as precise as the distances that determine it. Where
// rays graze the edge, as in needles, or the windows are narrow, distances do not determine directions, and no new image is made.
// Whether the rays at the ends enclose those of the two windows is tested directly, not by distances.
//
// Lists are merged from left to right, pair by pair. Longer runs at once would leave 2 to 15 % fewer windows for many more
// instructions. Windows of a list that is not reduced to its lower envelope overlap; then F is the smaller distance.
template <class FT>
class Window_merging
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  Window_merging(const Geodesic_field<FT>& field, const std::vector<Index>& source_of, const Merging_tolerance<FT>& tolerance)
    : m_field(field), m_source_of(source_of), m_tolerance(tolerance), m_is_on(!tolerance.is_zero()),
      m_share(tolerance.absolute > FT(0) ? 1 : share_of_relative_tolerance)
  {
    if (!m_is_on) return;
    m_least_size = 2;
    if (tolerance.absolute > FT(0)) return;
    const double size = least_length / std::cbrt(CGAL::to_double(tolerance.relative));
    m_least_size = std::size_t((std::max)(2., (std::min)(1e9, std::floor(size) + 1)));
    m_longest_always_merged = short_list;
  }

  bool is_on() const { return m_is_on; }
  const Merging_counts& counts() const { return m_counts; }

  // True if merging of the n windows of halfedge h is likely to save more time than it takes. The smaller a relative tolerance
  // t is, the more windows it leaves, so short lists cannot be merged much. A tolerance that is a length is for noise, which
  // may leave one window. Pairs that cannot be merged at one halfedge can rarely at the next one, so of longer lists some are
  // merged.
  bool pays_for(Index h, std::size_t n) const
  {
    if (n < m_least_size) return m_is_on && n > long_list && h % long_list_stride == 0;
    return n <= m_longest_always_merged || h % stride == 0;
  }

  // Merges neighbours among the windows of a halfedge, in one pass. They are sorted by both ends, and may overlap. Propagated
  // windows stay unchanged. The result is valid until the next call.
  const Inline_sequence<Window>& operator()(const Window* first, const Window* last)
  {
    m_windows.clear();
    Window longer;
    for (; first != last; ++first)
    {
      if (!m_windows.empty() && merge(m_windows.back(), *first, longer))
      {
        m_windows.back() = longer;
        count(longer);
      }
      else m_windows.push_back(*first);
    }
    return m_windows;
  }

private:
  // Least length of lists that are merged, times t^(1/3). Of those longer than `short_list`, every second is merged, and of
  // shorter ones than the least, if they are longer than `long_list`, every eighth. Measured by benchmark/.../tolerance_times.cpp:
  // times change by 5 % between 0.15 and 0.25, and by 2 % between 12 and 20; with shorter lists, a tolerance of 1e-6 is slower than
  // an exact build on rough meshes. Without the stride, times are the same on smooth meshes, and 2 to 6 % longer on rough ones.
  static constexpr double least_length = 0.2;
  static constexpr std::size_t short_list = 4, long_list = 16;
  static constexpr Index stride = 2, long_list_stride = 8;

  // Units of rounding of the distances within which a new image gives those at the ends: some eight operations determine it.
  static constexpr double roundings_of_image = 16;

  // Part of what a relative tolerance leaves that one merge may use, so that later merges have the rest.
  static constexpr double share_of_relative_tolerance = 0.5;

  FT allowed_at(const FT& distance) const
  {
    return (std::min)(FT(m_tolerance.absolute + m_tolerance.relative * distance), FT(distance / 2));
  }

  void count(const Window& merged)
  {
    ++m_counts.windows_merged;
    const double e = m_field.error_of_origin(merged.pseudo_source());
    m_counts.error_bound = (std::max)(m_counts.error_bound, e);
    const double least = CGAL::to_double(minimum(merged));
    if (e > m_counts.relative_error_bound * least)
      m_counts.relative_error_bound = (std::max)(m_counts.relative_error_bound, e / least);
  }

  bool have_same_source(const Window& a, const Window& b) const
  {
    return a.source_ref.side() == b.source_ref.side() &&
           (a.source_ref.primitive() == b.source_ref.primitive() ||
            m_source_of[a.source_ref.primitive()] == m_source_of[b.source_ref.primitive()]);
  }

  // Merges two neighbours into one window m. Returns false if the tolerance does not allow it.
  bool merge(const Window& a, const Window& b, Window& m) const
  {
    return BOOST_UNLIKELY(!exceeds_share(a, b)) && merge_within(a, b, m);
  }

  // What a merge of windows with the given error may add to it.
  FT share(const Window& a, const Window& b, const FT& error) const
  {
    return m_share * (allowed_at((std::min)(a.d0, b.d1)) - error);
  }

  // True for most pairs that cannot be merged. It does not read the errors of pseudo-sources, which
  // are not in the cache.
  bool exceeds_share(const Window& a, const Window& b) const
  {
    const FT error = FT(Merge_error_code::largest_error(a.pseudo_source(), b.pseudo_source()));
    return exceeds(share(a, b, error), a, b);
  }

  // Let l be the length of both intervals, c = (d1 - d0) / l, n = l^2 - (d1 - d0)^2, and k the height of F over the chord of the
  // distances at the ends, at q behind b0. f is convex, so F - f is at least k there. If the image of f is at r0 from b0, f is
  // below the chord at q by the sag
  //
  //   r0 + c q - sqrt((r0 + c q)^2 - n q (l - q) / l^2)  >=  n q (l - q) / (2 l^2 (r0 + c q))
  //
  // and the slopes of F at both ends bound r0 from above, see farthest_image(). True if k and the lower bound of the sag exceed
  // the given limit. Most pairs end here, so this has one division, no root and no branch.
  static bool exceeds(const FT& limit, const Window& a, const Window& b)
  {
    const FT l = b.b1 - a.b0, rise = b.d1 - a.d0, q = b.b0 - a.b0;
    const FT left = l * (limit - height_at_joint(a, b)) + rise * q; // l (limit - k)
    const FT n = (l - rise) * (l + rise), deepest = n * q * (l - q);
    const FT ra = a.is_parallel() ? FT(1) : FT(a.d0 - a.sigma), rb = b.is_parallel() ? FT(1) : FT(b.d1 - b.sigma);
    // r0 <= n ra / 2 u if u > 0, and r1 <= n rb / 2 v if v > 0; less the rounding of u and v.
    const FT noise = Number_policy<FT>::rounding(16) * (a.d0 + b.d1 + l);
    const FT u = rise * ra - l * (a.is_parallel() ? FT(-a.x) : FT(a.b0 - a.x)) - noise * ra;
    const FT v = l * (b.is_parallel() ? FT(-b.x) : FT(b.b1 - b.x)) - rise * rb - noise * rb;
    const int by_u = int(u > FT(0)) & int(deepest * u > left * (l * n * ra + 2 * u * rise * q));
    const int by_v = int(v > FT(0)) & int(deepest * v > left * (l * n * rb - 2 * v * rise * (l - q)));
    return int(left < FT(0)) | by_u | by_v;
  }

  // F at the begin of b minus F at the begin of a. If a reaches beyond, its tangent at its end is used, which is below it.
  static FT height_at_joint(const Window& a, const Window& b)
  {
    if (BOOST_LIKELY(a.b1 == b.b0)) return (std::min)(b.d0, a.d1) - a.d0; // saves a division
    return (std::min)(b.d0, FT(a.d1 - (a.b1 - b.b0) * slope(a, a.b1, a.d1))) - a.d0;
  }

  // Merges two neighbours with the image of one of them, or else with a new one.
  bool merge_within(const Window& a, const Window& b, Window& m) const
  {
    const FT most = share(a, b, FT(0));
    if (a.is_propagated() || b.is_propagated() || b.b0 - a.b1 > most || !have_same_source(a, b)) return false;
    const FT rounding = Number_policy<FT>::rounding(1) * (a.d0 + b.d1 + b.b1 - a.b0), unit = FT(roundings_of_image) * rounding;
    const bool is_like_b = a.b1 - a.b0 < b.b1 - b.b0; // the wider one has the more precise image
    m = is_like_b ? b : a;
    take_ends(a, b, m);
    if (const FT u = FT(roundings_of_ray) * rounding;
        passes(m, !is_like_b, u) && passes(m, is_like_b, u) && accept(a, b, u, false, m))
      return true;
    const FT l = m.b1 - m.b0, rise = m.d1 - m.d0, n = (l - rise) * (l + rise), c = rise / l;
    // The error of rays is the rounding of the distances over the width of the run across them. If it is a large part of the
    // width, as in needles, the image is noise.
    if (n < Number_policy<FT>::rounding(1 << 14) * CGAL::square(m.d0 + m.d1)) return false;
    const FT r0 = farthest_image(a, b, n, c, unit);
    if (!(r0 > FT(0)) || !(r0 + rise > FT(0))) return false;
    // As in exceeds(), with r0.
    const FT q = b.b0 - a.b0, k = height_at_joint(a, b) - c * q;
    if (n * q * (l - q) > (most - k) * (2 * l * l * (r0 + c * q))) return false;
    if (!place_image(n, c, r0, m)) return false;
    take_ends(a, b, m);
    return passes(m, false, unit) && passes(m, true, unit) && accept(a, b, unit, true, m);
  }

  // Sets the interval and the rays of m, which has an image. A ray through a position has the rounding of the position over its
  // distance from the image, so it may lie inside the ray of the first or the last window; then this one bounds m.
  static void take_ends(const Window& a, const Window& b, Window& m)
  {
    m.set_begin(a.b0, a.d0);
    m.set_end(b.b1, b.d1);
    if (m.is_parallel()) return;
    m.t0 = (std::min)(m.t0, a.slope(a.t0));
    m.t1 = (std::max)(m.t1, b.slope(b.t1));
  }

  // Tests the conditions with the image of m, and sets its origin. The origin of a new image is a code of its error, even if
  // that is zero: Kept_windows takes sigma from the pseudo-source otherwise. Binding test: test_bounded_error, kept windows of
  // new images.
  bool accept(const Window& a, const Window& b, const FT& unit, bool has_new_image, Window& m) const
  {
    if (!encloses(a, b, m)) return false;
    const FT rounding = unit + Number_policy<FT>::rounding(16) * CGAL::abs(m.sigma);
    // m is not above a window by more than rounding if it is not at its end inside m: both are equal at the other end, with slopes
    // that differ in favour of m, and their difference has one extremum.
    const FT at_a = m.distance_at(a.b1), at_b = a.b1 == b.b0 ? at_a : m.distance_at(b.b0);
    if (at_a > a.d1 + rounding || at_b > b.d0 + rounding) return false;
    FT added = a.b1 > b.b0 ? deviation_in_overlap(a, b, m) : deviation_in_gap(a, b, m, a.d1 - at_a, b.d0 - at_b);
    added = (std::max)({added, deviation_inside(a, m), deviation_inside(b, m)});
    const FT before = FT((std::max)(m_field.error_of_origin(a.pseudo_source()), m_field.error_of_origin(b.pseudo_source())));
    if (added > share(a, b, before)) return false;
    const bool is_rounding = 4 * added <= rounding;
    if (is_rounding && !has_new_image && a.pseudo_source() == b.pseudo_source())
    {
      m.bits = Window::make_bits(m.is_parallel(), a.pseudo_source());
      return true;
    }
    const Index origin = Merge_error_code::with_error(CGAL::to_double(is_rounding ? before : FT(before + added)));
    m.bits = Window::make_bits(m.is_parallel(), origin);
    return FT(Merge_error_code::error(origin)) <= allowed_at(minimum(m));
  }

  // Condition (1) at one end, up to rounding.
  static bool passes(const Window& m, bool at_b1, const FT& unit)
  {
    return CGAL::abs(FT(m.distance_at(at_b1 ? m.b1 : m.b0) - (at_b1 ? m.d1 : m.d0))) <= unit;
  }

  // Largest F - f from the end of a to the begin of b, where F is the shorter path around either. f grows more slowly than these
  // paths, so the maximum in between is where both are equal. `at_first`, `at_last`: F - f at both ends.
  static FT deviation_in_gap(const Window& a, const Window& b, const Window& m, const FT& at_first, const FT& at_last)
  {
    const FT gap = b.b0 - a.b1, rise = b.d0 - a.d1, at_ends = (std::max)(at_first, at_last);
    if (!(gap > CGAL::abs(rise))) return (std::max)(at_ends, gap);
    return (std::max)(at_ends, FT((a.d1 + b.d0 + gap) / 2 - m.distance_at(FT(a.b1 + (gap + rise) / 2))));
  }

  // Bound of the largest F - f where a and b overlap: a is used up to a point near their intersection, b behind it.
  static FT deviation_in_overlap(const Window& a, const Window& b, const Window& m)
  {
    const FT first = b.d0 - a.distance_at(b.b0), last = b.distance_at(a.b1) - a.d1; // b - a
    FT joint = !(first > FT(0)) ? b.b0 : a.b1;
    if (first > FT(0) && last < FT(0)) joint = b.b0 + (a.b1 - b.b0) * (first / (first - last));
    return (std::max)(a.distance_at(joint), b.distance_at(joint)) - m.distance_at(joint);
  }

  // True if the rays at the ends of m are not inside those of the first and last window, up to rounding. For rays that graze
  // the edge, derivatives do not decide this.
  static bool encloses(const Window& first, const Window& last, const Window& m)
  {
    return !turns_right(first, m, m.b0, m.d0) && !turns_right(m, last, m.b1, m.d1);
  }

  // True if the ray of v through (b, 0), at distance d, turns right of that of u by more than rounding. The allowance falls with
  // the slope of the rays.
  static bool turns_right(const Window& u, const Window& v, const FT& b, const FT& d)
  {
    const FT ux = u.is_parallel() ? FT(-u.x) : FT(b - u.x), vx = v.is_parallel() ? FT(-v.x) : FT(b - v.x);
    const FT length_u = u.is_parallel() ? FT(1) : FT(d - u.sigma), length_v = v.is_parallel() ? FT(1) : FT(d - v.sigma);
    const FT allowance = Number_policy<FT>::rounding(64) * length_u - Number_policy<FT>::rounding(2048) * u.y;
    return u.y * vx - ux * v.y < -allowance * length_v;
  }

  // The distance r0 of the farthest image from the end b0 of two merged windows that satisfies (2) at their ends:
  //
  //   x - b0 = n / 2l - c r0    as  r0^2 - (x - b0)^2 = r1^2 - (l - (x - b0))^2  and  r1 = r0 + c l
  //
  // The derivative of f at b0 is -(x - b0) / r0; it must be at most that of F, and likewise at b1. At a point at q
  // behind b0 where F is above the chord by k, f <= F is
  //
  //   r0 <= ((1 - c^2) q (l - q) + 2 q c k + k^2) / -2k
  //
  // if k < 0, and no condition otherwise. Without any bound f is linear: the result is more than farthest().
  static FT farthest_image(const Window& a, const Window& b, const FT& n, const FT& c, const FT& unit)
  {
    const FT l = b.b1 - a.b0, rise = b.d1 - a.d0;
    FT r0 = 2 * farthest(a.d0, b.d1, l);
    const auto limit = [&r0](const FT& r) {
      if (r < r0) r0 = r;
    };
    if (const FT k = rise - l * slope(a, a.b0, a.d0); k > unit) limit(n / (2 * k));
    if (const FT k = l * slope(b, b.b1, b.d1) - rise; k > unit) limit(n / (2 * k) - rise);
    const auto stay_below = [&](const FT& at, const FT& d) {
      const FT q = at - a.b0, k = d + unit - (a.d0 + c * q);
      if (k < FT(0)) limit((n / (l * l) * q * (l - q) + (2 * q * c + k) * k) / (-2 * k));
    };
    stay_below(a.b1, a.d1);
    if (a.b1 != b.b0 || a.d1 != b.d0) stay_below(b.b0, b.d0);
    return r0;
  }

  // Beyond this distance of an image, rounding exceeds the gain.
  static FT farthest(const FT& d0, const FT& d1, const FT& length) { return FT(1 << 8) * (d0 + d1 + length); }

  // Sets the image of m, whose interval and distances at the ends are given, at r0 from b0, or at infinity.
  static bool place_image(const FT& n, const FT& c, FT r0, Window& m)
  {
    const FT l = m.b1 - m.b0, most = farthest(m.d0, m.d1, l);
    if (r0 >= 2 * most)
    {
      m.bits = Window::make_bits(true, no_index);
      m.x = -c;
      m.y = -square_root<FT>(n) / l;
      m.sigma = m.d0 + m.x * m.b0;
      return m.y < FT(0);
    }
    r0 = (std::min)(r0, most);
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

  // Largest w - m inside the interval of w: at the point that is collinear with both images.
  static FT deviation_inside(const Window& w, const Window& m)
  {
    const FT y = (w.is_parallel() ? FT(0) : m.y) - (m.is_parallel() ? FT(0) : w.y);
    if (CGAL::is_zero(y) || (w.is_parallel() && m.is_parallel())) return FT(0);
    const FT b = (w.x * m.y - m.x * w.y) / y;
    return int(w.b0 < b) & int(b < w.b1) ? FT(w.distance_at(b) - m.distance_at(b)) : FT(0);
  }

  const Geodesic_field<FT>& m_field;
  const std::vector<Index>& m_source_of;
  const Merging_tolerance<FT> m_tolerance;
  const bool m_is_on;
  const FT m_share;                                                     // of what the tolerance leaves, for one merge
  std::size_t m_least_size = (std::numeric_limits<std::size_t>::max)(); // of lists that are merged
  std::size_t m_longest_always_merged = (std::numeric_limits<std::size_t>::max)();
  Merging_counts m_counts;
  Inline_sequence<Window> m_windows;
};

// In the place of Window_merging where windows are never merged.
struct No_merging
{
  template <class... Arguments>
  explicit No_merging(const Arguments&...)
  {
  }
  bool is_on() const { return false; }
  Merging_counts counts() const { return Merging_counts(); }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
