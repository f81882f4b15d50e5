// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lower envelope of the windows of one halfedge. One sweep over the windows, ordered by their intervals, merges consecutive
// windows with the same image, and cuts overlapping windows at their bisectors. The image of a window is its source point in
// the frame of the halfedge, or the direction of its parallel rays. A strip is a window of parallel rays from a source segment. A
// window is propagated if its children exist; it keeps its extent, and a part that is added to it is a new window.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_LOWER_ENVELOPE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_LOWER_ENVELOPE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/memory/Inline_sequence.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Interval_filter.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/window_allowance.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/window_checks.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_order.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Certain_overlap_split.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_bisector.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class Traits>
class Lower_envelope
{
public:
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  // `source_of[primitive]`: windows merge only within one source. `longest_edge`: that a window may have crossed.
  Lower_envelope(const std::vector<Index>& source_of, const Traits& traits, const FT& longest_edge = FT(0))
    : m_source_of(&source_of), m_traits(traits), m_error_of_image(error_of_image(longest_edge))
  {
  }

  // Returns the lower envelope of the windows in the ranges [first, last) and [more, more_last), which need not be sorted, on a
  // halfedge of the given length. It is sorted and disjoint, and valid until the next call. If a
  // comparison of distances is undecided, as with exact numbers (Interval_filter), both windows keep the part in question, and
  // consecutive windows overlap there.
  const Inline_sequence<Window>& operator()(const Window* first, const Window* last, const FT& length,
                                            const Window* more = nullptr, const Window* more_last = nullptr)
  {
    m_envelope.clear();
    m_length = length;
    m_max_gap = max_gap(length);
    m_narrow = FT(Number_policy<FT>::root_of_rounding()) * length;
    m_rounding = Number_policy<FT>::rounding(1);
    m_order.start(first, last, more, more_last);
    const Window* const* i = m_order.begin();
    const Window* const* const end = m_order.end();
    Window later;
    for (;;)
    {
      const Window* w = &later;
      if (i != end && !m_order.has_later_before(**i)) w = *i++;
      else if (m_order.has_later()) later = m_order.pop_later();
      else break;
      m_touching = error_of_positions(length, w->d0);
      if constexpr (!Interval_filter<FT>::leaves_open)
      {
        if (adds_usual_case(*w, i, end)) continue;
      }
      add(*w);
    }
    CGAL_postcondition(are_in_order(m_envelope.data(), m_envelope.data() + m_envelope.size(), length));
    CGAL_expensive_postcondition(have_consistent_distances(m_envelope.data(), m_envelope.data() + m_envelope.size()));
    return m_envelope;
  }

  // True for a monotone list: no window begins or ends before its predecessor, and no two consecutive windows can merge. Its lower
  // envelope is rarely much shorter. The caller may keep it as it is: windows that are not nearest change no distance.
  static bool is_monotone_list(const Window* first, const Window* last)
  {
    if (first == last) return true;
    // Usually larger than the allowance of same_image(), so that may_merge() is called for all pairs that may merge.
    const FT rounding = Number_policy<FT>::rounding(1024);
    const FT allowance = rounding * (first->d0 + last[-1].d1 + last[-1].b1);
    const FT larger_allowance = (std::max)(allowance, rounding);
    for (; last - first > 1; ++first)
    { // without branches; these differences decide nearly all pairs
      const Window &a = first[0], &b = first[1];
      if (int(b.b0 < a.b0) | int(b.b1 < a.b1)) return false;
      if (BOOST_UNLIKELY(CGAL::abs(FT(a.x - b.x)) <= larger_allowance) && may_merge(a, b, rounding, allowance)) return false;
    }
    return true;
  }

  // Windows farther apart than this, at a distance of at most d, do not change one another: a gap, and an error of each.
  FT reach(const FT& length, const FT& d) const { return max_gap(length) + 2 * error_of_positions(length, d); }

private:
  // True if a reduction may merge the consecutive windows a and b. The arguments are variables of is_monotone_list().
  BOOST_NOINLINE static bool may_merge(const Window& a, const Window& b, const FT& rounding, const FT& allowance)
  {
    return have_same_kind(a, b) && CGAL::abs(FT(a.x - b.x)) <= (a.is_parallel() ? rounding : allowance) &&
           CGAL::abs(FT(a.sigma - b.sigma)) <= allowance;
  }

  // Largest width of a gap or overlap between windows of one image that is due to rounding.
  static FT max_gap(const FT& length) { return Number_policy<FT>::rounding(4096) * length; }

  bool same_image(const Window& a, const Window& b) const
  {
    if (!have_same_kind(a, b)) return false;
    if constexpr (!Number_policy<FT>::is_inexact) return have_one_source(a, b) && same_distances(a, b);
    const FT rounding = Number_policy<FT>::rounding(64); // well below pruning_allowance()
    // The image of parallel rays is a unit vector. The sigma of point rays is the distance of a vertex, equal in all
    // windows of that vertex.
    const FT allowance = rounding * (a.d0 + b.d1 + (a.is_parallel() ? b.b1 : FT(CGAL::abs(a.x) + CGAL::abs(a.y))));
    const FT& of_image = a.is_parallel() ? rounding : allowance;
    if (!(CGAL::abs(a.x - b.x) <= of_image)) return false; // the usual case
    const FT of_sigma = a.is_parallel() ? allowance : FT(Number_policy<FT>::rounding(16) * (a.sigma + b.sigma));
    return CGAL::abs(a.y - b.y) <= of_image && CGAL::abs(a.sigma - b.sigma) <= of_sigma && have_one_source(a, b);
  }

  // True if both windows have point images or both have parallel rays, and the same pseudo-source or none.
  static bool have_same_kind(const Window& a, const Window& b) { return ((a.bits ^ b.bits) & ~2u) == 0; } // propagated or not

  bool have_one_source(const Window& a, const Window& b) const
  {
    return a.source_ref.side() == b.source_ref.side() &&
           (*m_source_of)[a.source_ref.primitive()] == (*m_source_of)[b.source_ref.primitive()];
  }

  static bool same_distances(const Window& a, const Window& b)
  {
    return a.is_parallel() == b.is_parallel() && a.x == b.x && a.y == b.y && a.sigma == b.sigma;
  }

  void add(const Window& w)
  {
    if (m_envelope.empty())
    {
      m_envelope.push_back(w);
      return;
    }
    Window& a = m_envelope.back();
    if constexpr (Interval_filter<FT>::leaves_open)
    {
      if (CGAL::possibly(estimate(w.b0) >= estimate(a.b1)))
      {
        if (a.is_propagated() == w.is_propagated() && same_image(a, w) && w.b0 <= a.b1) unite(a, w);
        else m_envelope.push_back(w);
      }
      else if (same_image(a, w)) unite(a, w);
      else resolve_estimated(a, w);
    }
    else if (w.b0 >= a.b1)
    {
      if (w.b0 - a.b1 <= m_max_gap && a.is_propagated() == w.is_propagated() && same_image(a, w) &&
          !a.leaves_gap_before(w, m_length))
        a.take_end(w);
      else m_envelope.push_back(w);
    }
    else if (same_image(a, w)) unite(a, w);
    else if (is_tie_with_propagated(a, w)) keep_propagated(a, w, false);
    else if (!adds_at_end(w)) resolve(a, w);
  }

  // True if a window is narrower than rounding, across its rays.
  bool is_narrow(const Window& w) const
  {
    const FT width = w.b1 - w.b0;
    return width <= (std::max)(m_narrow, m_touching) && (width <= m_touching || width <= m_touching * grazing(w));
  }

  // Factor by which the rounding of the place of a ray on the edge exceeds that across the ray.
  static FT grazing(const Window& w)
  {
    return (std::max)(FT(1), (std::min)(FT(CGAL::abs(w.begin_slope())), FT(CGAL::abs(w.end_slope()))));
  }

  // Adds a window that is narrower than rounding and as near as the last window of the envelope, at an end of this one: only its
  // rays tell which of the two is the left one. Returns false without a change for other windows.
  bool adds_at_end(const Window& w)
  {
    if (!Number_policy<FT>::is_inexact || !is_narrow(w) || !w.is_open()) return false;
    const Window& a = m_envelope.back();
    const FT touching = m_touching * grazing(w);
    const bool is_at_begin = !(w.b1 - a.b0 > touching);
    if (a.b1 < w.b1 || !(is_at_begin || a.b1 - w.b0 <= touching)) return false;
    if (CGAL::abs(FT(w.d0 - a.distance_at(w.b0))) > m_touching) return false;
    Window sliver = w;
    sliver.b0 = sliver.b1 = is_at_begin ? a.b0 : a.b1;
    sliver.d0 = sliver.d1 = is_at_begin ? a.d0 : a.d1;
    if (is_at_begin)
    {
      std::swap(sliver, m_envelope.back());
      m_envelope.push_back(sliver);
    }
    else m_order.push_later(sliver);
    return true;
  }

  // True if one of two overlapping windows is propagated, and the other one is somewhere nearer, but by no more than rounding. The
  // propagated one stays: otherwise rays that wind around a vertex would replace shorter ones, round by round.
  bool is_tie_with_propagated(const Window& a, const Window& w) const
  {
    if (a.is_propagated() == w.is_propagated() || !have_one_pseudo_source(a, w)) return false;
    const Window &old = a.is_propagated() ? a : w, &fresh = a.is_propagated() ? w : a;
    const FT high = (std::min)(a.b1, w.b1), width = high - w.b0;
    if (!(old.b0 <= fresh.b0 && fresh.b1 <= old.b1 && width > m_touching)) return false;
    const auto gain = [&](const FT& t) { return old.distance_at(t) - fresh.distance_at(t); };
    const FT at_low = gain(w.b0), at_high = gain(high);
    FT c;
    return at_low <= m_touching && at_high <= m_touching && (at_low > FT(0) || at_high > FT(0)) &&
           !(Bisector_crossing<Traits>(m_traits, a, w).collinear_point(c) && w.b0 < c && c < high && gain(c) > m_touching);
  }

  bool have_one_pseudo_source(const Window& a, const Window& w) const
  {
    return have_same_kind(a, w) && !a.is_parallel() && a.sigma == w.sigma && have_one_source(a, w);
  }

  // Adds the next window w of the sweep if it relates to the last window of the envelope in a usual way. Returns false without
  // a change for other cases, which are left to add(). [next, end): the windows after w in the sweep.
  BOOST_FORCEINLINE bool adds_usual_case(const Window& w, const Window* const* next, const Window* const* end)
  {
    if (m_envelope.empty()) return false;
    Window& a = m_envelope.back();
    const FT overlap = a.b1 - w.b0;
    if (overlap < -m_max_gap)
    {
      m_envelope.push_back(w);
      return true;
    }
    if (same_image(a, w)) return false;
    if (BOOST_UNLIKELY(is_narrow(w) || is_tie_with_propagated(a, w))) return false;
    const bool a_ends_first = a.b1 < w.b1;
    // Two windows that share a bounding ray, as at the border of a pseudo-source's sector, overlap by the rounding of its two
    // computations. Their rays stay.
    if (overlap <= m_touching && a_ends_first)
    {
      if (BOOST_UNLIKELY(overlap > m_rounding * a.d1)) a.d1 = a.distance_at(w.b0);
      a.b1 = lesser(a.b1, w.b0);
      m_envelope.push_back(w);
      return true;
    }
    const Bisector_crossing<Traits> crossing(m_traits, a, w);
    const FT low = w.b0, high = a_ends_first ? a.b1 : w.b1;
    FT t;
    if (crossing.has_straight_bisector(t))
    {
      if (t > low && t < high) return a_ends_first && cut_at(a, w, t, crossing.at(a, t), next, end);
      if (t <= low) return a_ends_first && begin_at(w, crossing.at(a, low));
      if (t >= high)
      {
        if (a_ends_first) push_rest(w, high, crossing.at(w, high), w.ray_at(high), a.end_slope(), next, end);
        return true;
      }
      return false; // t is NaN
    }
    FT a_low, a_high = a.d1, w_high = w.d1;
    if (BOOST_LIKELY(a_ends_first)) crossing.at(low, high, a_low, w_high);
    else
    {
      a_low = crossing.at(a, low);
      a_high = crossing.at(a, high);
    }
    const Comparison_result at_low = crossing.compare(a_low, w.d0), at_high = crossing.compare(w_high, a_high);
    if (at_low == SMALLER && at_high == SMALLER)
    { // one bisector
      if (!a_ends_first) return false;
      const auto place = crossing.find(low, a_low - w.d0, high, a_high - w_high);
      return cut_at(a, w, place.t, place.d, next, end);
    }
    if (at_low == LARGER && at_high == SMALLER && a_ends_first && !crossing.may_cross_twice(low, high))
      return begin_at(w, a_low); // the last window of the envelope is farther
    if (at_low == SMALLER && at_high == LARGER && !crossing.may_cross_twice(low, high))
    { // the last window of the envelope is nearer
      if (a_ends_first) push_rest(w, high, w_high, w.ray_at(high), a.end_slope(), next, end);
      return true;
    }
    return false;
  }

  // Cuts the last window of the envelope at t, and appends w from t on. Returns false without a change if nothing remains of one.
  BOOST_FORCEINLINE bool cut_at(Window& a, const Window& w, const FT& t, const FT& d, const Window* const* next,
                                const Window* const* end)
  {
    if (!(t - a.b0 > m_touching && w.b1 - t > m_touching)) return false;
    const FT ray_of_a = a.ray_at(t), ray = w.ray_at(t);
    a.cut_end(t, d, m_touching, ray_of_a, w.slope(ray));
    push_rest(w, t, d, ray, a.slope(ray_of_a), next, end);
    return true;
  }

  // Cuts the last window of the envelope, at distance d there, where w begins, and appends w.
  BOOST_FORCEINLINE bool begin_at(const Window& w, const FT& d)
  {
    cut_back(w.b0, d, w.begin_slope());
    m_envelope.push_back(w);
    return true;
  }

  // Appends the rest of a window behind the last window of the envelope, or keeps it for later if another window begins before.
  BOOST_FORCEINLINE void push_rest(const Window& w, const FT& t, const FT& d, const FT& ray, const FT& slope_on_left,
                                   const Window* const* next, const Window* const* end)
  {
    CGAL_precondition(w.b0 <= t && t < w.b1);
    CGAL_precondition(m_envelope.empty() || !(t < m_envelope.back().b1));
    if ((next == end || t <= (*next)->b0) && (!m_order.has_later() || t <= m_order.first_later().b0))
    {
      m_envelope.push_back(w);
      m_envelope.back().cut_begin(FT(t), FT(d), m_touching, ray, slope_on_left);
    }
    else m_order.push_later(rest(w, t, d, ray, slope_on_left));
  }

  // Merges two overlapping windows with one image. If one of them is propagated, the other keeps only its new part.
  void unite(Window& a, const Window& w)
  {
    if (a.is_propagated() == w.is_propagated())
    {
      if (w.b1 > a.b1) a.take_end(w);
    }
    else if (w.b0 < w.b1) keep_propagated(a, w, true);
  }

  // Of two overlapping windows, one of which is propagated, the other one keeps what is beside the overlap. From one image, it takes
  // the bounding rays of the propagated one: a position would give them only up to the rounding of the image.
  void keep_propagated(const Window& a, const Window& w, bool have_one_image)
  {
    const bool is_rest = a.is_propagated();
    const Window old = is_rest ? a : w;
    Window fresh = is_rest ? w : a;
    if (!is_rest)
    {
      cut_back(old.b0, fresh.distance_at(old.b0), old.begin_slope());
      if (have_one_image && fresh.b0 < old.b0) m_envelope.back().t1 = old.t0;
      m_order.push_later(old);
    }
    if (!is_before(old.b1, fresh.b1)) return;
    fresh.cut_begin(old.b1, fresh.distance_at(old.b1), m_touching, fresh.ray_at(old.b1), old.end_slope());
    if (have_one_image) fresh.t0 = old.t1;
    m_order.push_later(fresh);
  }

  // Splits overlapping windows with different images: between consecutive bisectors, the nearer window keeps the overlap. The
  // longer window keeps its part beyond the overlap.
  void resolve(const Window& last, const Window& w)
  {
    const Window a = last;
    const Window_bisector<Traits> bisector(m_traits, a, w);
    int n = bisector.number();
    bool a_owns = bisector.first_is_nearer();
    if constexpr (Number_policy<FT>::is_inexact)
    { // Within rounding of an end or of each other, bisectors are noise.
      if (n == 2 && !(bisector[1] - bisector[0] > m_touching)) n = 0;
      if (n == 1 && !(bisector[0] - bisector.low() > m_touching))
      {
        n = 0;
        a_owns = !a_owns;
      }
      if (n == 1 && !(bisector.high() - bisector[0] > m_touching)) n = 0;
    }
    FT slope_on_left(0);
    for (int i = 0; i <= n; ++i, a_owns = !a_owns)
    {
      const Window &owner = a_owns ? a : w, &other = a_owns ? w : a;
      const FT& from = i == 0 ? bisector.low() : bisector[i - 1];
      const bool is_cut = i < n;
      if (i == 0 && a_owns)
      {
        if (is_cut) cut_back(bisector[0], bisector.distance(0), other.slope_at(bisector[0]));
      }
      else if (is_cut ? from < bisector[i] : from < owner.b1)
      {
        Window p = owner;
        if (i > 0) p.cut_begin(from, bisector.distance(i - 1), m_touching, p.ray_at(from), slope_on_left);
        else cut_back(from, bisector.distance_at_low(true), owner.begin_slope());
        if (is_cut)
          p.cut_end(bisector[i], bisector.distance(i), m_touching, p.ray_at(bisector[i]), other.slope_at(bisector[i]));
        if (i > 0) m_order.push_later(p);
        else m_envelope.push_back(p);
      }
      if (is_cut) slope_on_left = owner.slope_at(bisector[i]);
    }
    a_owns = !a_owns;
    const Window& other = a_owns ? w : a;
    keep_rest(other, bisector.high(), bisector.distance_at_high(!a_owns), (a_owns ? a : w).end_slope());
  }

  // Variant of resolve() for estimated distances: each window keeps all parts except those where the other is certainly
  // nearer. If both have equal distance functions, the first window keeps the overlap.
  void resolve_estimated(const Window& last, const Window& w)
  {
    const Window a = last;
    if (same_distances(a, w))
    {
      keep_rest(w, a.b1, w.distance_at(a.b1), a.end_slope());
      return;
    }
    const Certain_overlap_split<FT> split(a, w, m_length);
    if (split.is_open())
    {
      m_envelope.push_back(w);
      return;
    }
    m_envelope.pop_back();
    bool is_first = true;
    split.for_each_part_of_first([&](const Window& p) {
      if (is_first && p.b0 == a.b0) m_envelope.push_back(p);
      else m_order.push_later(p);
      is_first = false;
    });
    split.for_each_part_of_second([&](const Window& p) { m_order.push_later(p); });
  }

  // Shortens the last window of the envelope to end at t, with distance d; removes it if nothing remains.
  void cut_back(const FT& t, const FT& d, const FT& slope_on_right)
  {
    CGAL_precondition(!m_envelope.empty());
    Window& a = m_envelope.back();
    CGAL_precondition(CGAL::possibly(estimate(t) <= estimate(a.b1)));
    if (!(a.b0 < t)) m_envelope.pop_back();
    else if (t != a.b1) a.cut_end(FT(t), FT(d), m_touching, a.ray_at(t), slope_on_right);
  }

  // Keeps the part of w from t on for later, if there is one.
  void keep_rest(const Window& w, const FT& t, const FT& d, const FT& slope_on_left)
  {
    if (!is_before(t, w.b1)) return;
    m_order.push_later(rest(w, t, d, w.ray_at(t), slope_on_left));
  }

  static bool is_before(const FT& b, const FT& end)
  {
    if constexpr (Interval_filter<FT>::leaves_open) return CGAL::possibly(compare_bounds(b, end) == SMALLER);
    else return b < end;
  }

  Window rest(const Window& whole, const FT& t, const FT& d, const FT& ray, const FT& slope_on_left) const
  {
    Window w = whole;
    w.cut_begin(t, d, m_touching, ray, slope_on_left);
    return w;
  }

  // Rounding error of a position where windows touch: images have the rounding of their distance and of the edges that they crossed.
  FT error_of_positions(const FT& length, const FT& distance) const
  {
    return Number_policy<FT>::is_inexact
           ? FT(Number_policy<FT>::rounding(roundings_of_ray) * (length + distance) + m_error_of_image)
           : FT(0);
  }

  const std::vector<Index>* m_source_of;
  const Traits& m_traits;
  Inline_sequence<Window> m_envelope;
  Window_order<FT, Window> m_order;
  FT m_error_of_image;
  FT m_length, m_touching, m_max_gap, m_rounding;
  FT m_narrow; // width of windows that may be narrower than rounding across their rays
};

} // namespace CGAL::Geodesic_offset::internal

#endif
