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
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Start_values.h>
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

  // An end vertex of the halfedge: its distance, negative if unknown, and the source primitive of this distance.
  struct End
  {
    FT distance = FT(-1);
    Source_ref source_ref = Source_ref();
  };

  // `source_of[primitive]`: windows merge only within one source. `start_values`: of the primitives; by default 0.
  Lower_envelope(const std::vector<Index>& source_of, const Traits& traits, const Start_values<FT>* start_values = nullptr)
    : m_source_of(&source_of), m_start_values(start_values), m_traits(traits)
  {
  }

  // Returns the lower envelope of the windows in the ranges [first, last) and [more, more_last), which need not be sorted, on a
  // halfedge of the given length. It is sorted and disjoint, and valid until the next call. If a
  // comparison of distances is undecided, as with exact numbers (Interval_filter), both windows keep the part in question, and
  // consecutive windows overlap there.
  //
  // Rounding may leave narrow gaps between windows. A gap is closed if the distances beside it agree and are less than
  // `passed`, the distance that the front has passed: up to it all windows have arrived. Beyond it, a window that fills the gap may
  // still arrive.
  const Inline_sequence<Window>& operator()(
    const Window* first, const Window* last, const FT& length, const Window* more = nullptr, const Window* more_last = nullptr,
    const End& at_begin = End(), const End& at_end = End(), const FT& passed = Number_policy<FT>::infinity())
  {
    m_envelope.clear();
    m_occupants.clear();
    m_has_closed_gaps = false;
    m_passed = passed;
    m_nearest_gap = Number_policy<FT>::infinity();
    m_length = length;
    m_min_width = Number_policy<FT>::rounding(8) * length;
    m_max_gap = max_gap(length);
    m_least_overlap = -m_max_gap;
    if constexpr (Number_policy<FT>::is_inexact) m_widest_gap = first != last ? widest_gap(*first, length) : FT(0);
    m_wide = (std::max)(m_min_width, m_widest_gap);
    m_rounding = Number_policy<FT>::rounding(1);
    m_gap_rounding = Number_policy<FT>::rounding(roundings_of_window); // closes gaps left by pruning
    m_certain_difference = Number_policy<FT>::rounding(roundings_of_certain_difference);
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
      if constexpr (!Interval_filter<FT>::leaves_open)
      {
        if (adds_usual_case(*w, i, end)) continue;
      }
      add(*w);
    }
    if constexpr (Number_policy<FT>::is_inexact)
    {
      close_occupied_gaps();
      close_gaps_at_ends(at_begin, at_end);
    }
    CGAL_postcondition(are_in_order(m_envelope.data(), m_envelope.data() + m_envelope.size(), length));
    CGAL_expensive_postcondition(have_consistent_distances(m_envelope.data(), m_envelope.data() + m_envelope.size()));
    return m_envelope;
  }

  // Distance of the nearest gap that the last call left open because the front had not passed it; infinite if there is none. A
  // later call, with the front beyond this distance, closes it.
  const FT& nearest_gap() const { return m_nearest_gap; }

  // True if the last call closed gaps. The envelope then extends beyond the given windows.
  bool has_closed_gaps() const { return m_has_closed_gaps; }

  // True for a monotone list: no window begins or ends before its predecessor, no two consecutive windows can merge, and no gap
  // has to be closed. Its lower envelope is rarely much shorter. The caller may keep it as it is: windows that are not
  // nearest change no distance.
  static bool is_monotone_list(const Window* first, const Window* last, const FT& length)
  {
    if (first == last) return true;
    const FT largest_rounding = max_gap(length), widest = widest_gap(*first, length);
    const auto may_be_closed = [&](const FT& gap) { return int(gap > largest_rounding) & int(gap < widest); };
    if (may_be_closed(first->b0) | may_be_closed(FT(length - last[-1].b1))) return false;
    // Usually larger than the allowance of same_image(), so that may_change() is called for all pairs that may merge.
    const FT rounding = Number_policy<FT>::rounding(1024);
    const FT allowance = rounding * (first->d0 + last[-1].d1 + last[-1].b1);
    const FT larger_allowance = (std::max)(allowance, rounding);
    for (; last - first > 1; ++first)
    { // without branches; these differences decide nearly all pairs
      const Window &a = first[0], &b = first[1];
      if (int(b.b0 < a.b0) | int(b.b1 < a.b1)) return false;
      const int is_rare = int(CGAL::abs(FT(a.x - b.x)) <= larger_allowance) | int(b.b0 - a.b1 > largest_rounding) |
                          (int(b.b1 - b.b0 < widest) & int(is_farther_at_begin(a, b, length)));
      if (BOOST_UNLIKELY(is_rare) && may_change(a, b, rounding, allowance, length, widest)) return false;
    }
    return true;
  }

private:
  // True if a reduction may merge the consecutive windows a and b, close the gap between them, or remove b as the occupant of a
  // gap (see close_occupied_gaps()). The arguments are variables of is_monotone_list().
  BOOST_NOINLINE static bool may_change(const Window& a, const Window& b, const FT& rounding, const FT& allowance,
                                        const FT& length, const FT& widest)
  {
    const FT gap = b.b0 - a.b1;
    if (gap > max_gap(length) && gap < widest) return true;
    if (gap >= FT(0) && b.b1 - b.b0 < widest && is_farther_at_begin(a, b, length)) return true;
    return have_same_kind(a, b) && CGAL::abs(FT(a.x - b.x)) <= (a.is_parallel() ? rounding : allowance) &&
           CGAL::abs(FT(a.sigma - b.sigma)) <= allowance;
  }

  // Largest width of a gap or overlap between windows of one image that is due to rounding.
  static FT max_gap(const FT& length) { return Number_policy<FT>::rounding(4096) * length; }

  // Least difference of two distances that is not due to rounding, in units of rounding of the distance: more than the error of
  // two distances, and less than the surcharge on rays beside a sector, Vertex_sector::margin_surcharge().
  static constexpr double roundings_of_certain_difference = 16;

  // Largest difference of the directions, unit vectors, of two windows of one strip: 2^-33, far above their rounding.
  static constexpr double strip_turn = 1. / (1ull << 33);

  // Largest length of a short edge, as a fraction of the distance: 2^-24. Distances along such an edge are equal up to rounding
  // over much of its length.
  static constexpr double short_edge = 1. / (1 << 24);

  // Largest gap to be closed between windows of different images: 2^-8 of the length of the halfedge. On a short edge, as
  // between the sides of a narrow strip of faces, it may be the whole edge.
  static FT widest_gap(const Window& w, const FT& length)
  {
    const FT by_distance = (std::min)(length, FT(short_edge) * w.d0);
    return (std::max)(FT(FT(1. / (1 << 8)) * length), by_distance);
  }

  bool same_image(const Window& a, const Window& b) const
  {
    if (!have_same_kind(a, b)) return false;
    if constexpr (!Number_policy<FT>::is_inexact) return have_one_source(a, b) && same_distances(a, b);
    const FT rounding = Number_policy<FT>::rounding(64); // well below pruning_allowance()
    // The image of parallel rays is a unit vector. The sigma of point rays is the distance of a vertex, equal in all
    // windows of that vertex, and larger by Vertex_sector::margin_surcharge() in windows of its margins.
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
      if (w.b0 - a.b1 <= m_max_gap && a.is_propagated() == w.is_propagated() && same_image(a, w))
      {
        a.b1 = w.b1;
        a.d1 = w.d1;
      }
      else push_behind(a, w);
    }
    else if (same_image(a, w)) unite(a, w);
    else resolve(a, w);
  }

  // Appends w, which begins behind the last window a of the envelope, and closes the gap between them if possible.
  BOOST_FORCEINLINE void push_behind(Window& a, const Window& w)
  {
    const FT gap = w.b0 - a.b1;
    if (gap > m_max_gap && gap < m_widest_gap) close_gap(a, w);
    else append(w);
  }

  // Appends a window. The width of the last window before it is final now, except that a part of another window that was kept
  // for later may still cut it.
  BOOST_FORCEINLINE void append(const Window& w)
  {
    if (!m_envelope.empty()) check_width(m_envelope.back(), w.b0);
    m_envelope.push_back(w);
  }

  // Returns true if m, the last window of the envelope, is wider than rounding when the next window begins at t. Records m as
  // an occupant if it may occupy a gap between the windows beside it.
  BOOST_FORCEINLINE bool check_width(const Window& m, const FT& t)
  {
    const FT width = t - m.b0;
    if (BOOST_LIKELY(width > m_wide)) return true;
    const std::size_t n = m_envelope.size();
    if (BOOST_UNLIKELY(n > 1 && is_farther_at_begin(m_envelope[n - 2], m, m_length))) add_occupant();
    return width > m_min_width;
  }

  BOOST_NOINLINE void add_occupant()
  {
    const std::size_t last = m_envelope.size() - 1;
    while (!m_occupants.empty() && m_occupants.back() >= last) m_occupants.pop_back(); // windows that were removed since
    m_occupants.push_back(last);
  }

  BOOST_NOINLINE void close_gap(const Window& a, const Window& w)
  {
    const Gap gap = gap_between(a, w);
    if (gap.filled_by == Gap::SECOND) return append_extended(FT(a.b1), gap.distance, w);
    if (gap.filled_by == Gap::FIRST) extend_last(w.b0, gap.distance);
    append(w);
  }

  // Extends the last window of the envelope to b1. A propagated window keeps its extent; its new part is separate.
  void extend_last(const FT& b1, const FT& d1)
  {
    m_has_closed_gaps = true;
    Window& w = m_envelope.back();
    if (w.is_propagated()) return append(new_part(w, w.b1, w.d1, b1, d1));
    w.b1 = b1;
    w.d1 = d1;
  }

  // Appends w, extended back to b0.
  void append_extended(const FT& b0, const FT& d0, const Window& w)
  {
    m_has_closed_gaps = true;
    if (w.is_propagated())
    {
      append(new_part(w, b0, d0, w.b0, w.d0));
      append(w);
      return;
    }
    append(part(w, b0, d0, w.b1, w.d1));
  }

  // Handles occupants: narrow windows in a gap between two windows a and w, through which no shortest path leads. At each end of an
  // occupant, its distance exceeds that of the adjacent window by more than the length between them along the halfedge. (The
  // narrow window of a corner between two strips is no occupant: its distances are not that much larger.) An occupant is removed
  // if the gap is as narrow as rounding, and replaced by an extension of a or w if this closes the gap.
  void close_occupied_gaps()
  {
    std::size_t removed = 0;
    for (const std::size_t place : m_occupants)
      for (std::size_t i = place - removed;
           i > 0 && i + 1 < m_envelope.size();) // i stays after an erase: the next window may be an occupant, too
      {
        const Window &a = m_envelope[i - 1], &m = m_envelope[i], &w = m_envelope[i + 1];
        if (!(w.b0 - a.b1 < m_widest_gap) || !is_farther_at_begin(a, m, m_length) || !is_farther_at_end(m, w)) break;
        if (w.b0 - a.b1 <= m_max_gap)
        {
          m_envelope.erase(i);
          ++removed;
        }
        else
        {
          const Gap gap = gap_between(a, w);
          if (gap.filled_by == Gap::NONE) break;
          m_envelope[i] = gap.filled_by == Gap::FIRST ? new_part(a, a.b1, a.d1, w.b0, gap.distance)
                                                      : new_part(w, a.b1, gap.distance, w.b0, w.d0);
          ++i;
        }
        m_has_closed_gaps = true;
      }
  }

  static bool is_farther_at_begin(const Window& a, const Window& m, const FT& length)
  {
    return m.d0 - a.d1 > m.b0 - a.b1 + Number_policy<FT>::rounding(roundings_of_certain_difference) * (m.d0 + length);
  }

  bool is_farther_at_end(const Window& m, const Window& w) const
  {
    return m.d1 - w.d0 > w.b0 - m.b1 + m_certain_difference * (m.d0 + m_length);
  }

  // Closes the gaps from the begin of the halfedge to the first window, and from the last window to the end.
  void close_gaps_at_ends(const End& at_begin, const End& at_end)
  {
    if (m_envelope.empty()) return;
    FT d;
    const Window& last = m_envelope.back();
    if (may_fill_to_end(last, m_length - last.b1, m_length, at_end, d)) extend_last(m_length, d);
    Window& first = m_envelope.front();
    if (!may_fill_to_end(first, first.b0, FT(0), at_begin, d)) return;
    m_has_closed_gaps = true;
    if (first.is_propagated())
    {
      m_envelope.push_front(new_part(first, FT(0), d, first.b0, first.d0));
      return;
    }
    first.b0 = FT(0);
    first.d0 = d;
  }

  // True if a window may be extended over a gap to the end b of the halfedge. `d` receives its distance there.
  bool may_fill_to_end(const Window& w, const FT& gap, const FT& b, const End& end, FT& d)
  {
    if (!(gap > m_max_gap && gap < m_widest_gap)) return false;
    d = w.distance_at(b);
    if (!(CGAL::abs(FT(d - end.distance)) <= m_gap_rounding * (d + m_length))) return false;
    const bool is_short_edge = w.source_ref == end.source_ref && m_length <= FT(short_edge) * length_of_path(w, d);
    return (is_short_edge || may_fill(w, gap, (std::min)({d, w.d0, w.d1}), d + m_length)) && check_passed(d);
  }

  // True if a window may be extended over a gap. `d`: the least distance in the gap; `size`: magnitude of the distances, for
  // their rounding. Rays of a strip that is extended over a gap start on the line of the source segment, beyond its end by g =
  // -w.y gap. Their distances are too small by g^2 / (2 l), with the length l of the rays, which must be within rounding.
  // Binding test: test_degenerate_sources, gap between sources with start values.
  bool may_fill(const Window& w, const FT& gap, const FT& d, const FT& size) const
  {
    if (!w.is_parallel()) return true;
    const FT beyond = -w.y * gap;
    return beyond * beyond <= FT(2) * m_gap_rounding * size * length_of_path(w, d);
  }

  // Length of the path from the source of window w with the distance d: without the start value.
  FT length_of_path(const Window& w, const FT& d) const
  {
    return m_start_values ? FT(d - m_start_values->of(w.source_ref)) : d;
  }

  struct Gap
  {
    enum Neighbour { NONE, FIRST, SECOND } filled_by;
    FT distance; // of the window that fills the gap, at the other end of the gap
  };

  // Finds the window that fills the gap between a and w: an extension to the other end of the gap agrees up to rounding with the
  // distance of the other window there. Such a gap results from the rounding of a bounding ray, or from a narrow window that was
  // dropped. An open gap widens with the distance from its image. The shortest paths to points in the gap bend at a vertex, by an
  // angle of at most the square root of the relative rounding error of their length.
  Gap gap_between(const Window& a, const Window& w)
  {
    const FT size = a.d1 + w.d0 + m_length, allowance = m_gap_rounding * size, gap = w.b0 - a.b1;
    const bool is_of_one_strip =
      a.is_parallel() && w.is_parallel() && a.source_ref == w.source_ref && CGAL::abs(FT(a.x - w.x)) <= FT(strip_turn);
    const auto fills = [&](const Window& x, const FT& d, const FT& other) {
      return (is_of_one_strip || may_fill(x, gap, (std::min)({d, a.d1, w.d0}), size)) && CGAL::abs(FT(d - other)) <= allowance;
    };
    Gap result{Gap::FIRST, a.distance_at(w.b0)};
    if (!fills(a, result.distance, w.d0))
    {
      result = {Gap::SECOND, w.distance_at(a.b1)};
      if (!fills(w, result.distance, a.d1)) return {Gap::NONE, FT(0)};
    }
    if (!check_passed((std::max)(a.d1, w.d0))) return {Gap::NONE, FT(0)};
    return result;
  }

  // Returns true if the front has passed a gap at distance d. Otherwise, a window that fills the gap may still arrive; records
  // the gap for nearest_gap().
  bool check_passed(const FT& d)
  {
    if (d < m_passed) return true;
    m_nearest_gap = (std::min)(m_nearest_gap, d);
    return false;
  }

  // Adds the next window w of the sweep if it relates to the last window of the envelope in a usual way. Returns false without
  // a change for other cases, which are left to add(). [next, end): the windows after w in the sweep.
  BOOST_FORCEINLINE bool adds_usual_case(const Window& w, const Window* const* next, const Window* const* end)
  {
    if (m_envelope.empty()) return false;
    Window& a = m_envelope.back();
    const FT overlap = a.b1 - w.b0;
    if (overlap < m_least_overlap)
    {
      push_behind(a, w);
      return true;
    }
    if (same_image(a, w)) return false;
    const bool a_ends_first = a.b1 < w.b1;
    // Two windows that share a bounding ray, as at the border of a pseudo-source's sector, overlap by the rounding of its two
    // computations.
    if (overlap <= m_min_width && a_ends_first)
    {
      // The distance of a ray in the margin of a sector has a surcharge, so the other window keeps the overlap.
      if (BOOST_UNLIKELY(CGAL::is_positive(overlap) && w.d0 - a.d1 > m_certain_difference * a.d1))
      {
        begin_behind(w, a.b1, next, end);
        return true;
      }
      if (!cut_end(a, w.b0, overlap)) return false;
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
        if (a_ends_first && w.b1 - high > m_min_width) append_rest(w, high, crossing.at(w, high), next, end);
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
      if (a_ends_first && w.b1 - high > m_min_width) append_rest(w, high, w_high, next, end);
      return true;
    }
    return false;
  }

  // Cuts the last window of the envelope at t, and appends w from t on. Returns false without a change if either is too narrow.
  BOOST_FORCEINLINE bool cut_at(Window& a, const Window& w, const FT& t, const FT& d, const Window* const* next,
                                const Window* const* end)
  {
    if (!check_width(a, t) || !(w.b1 - t > m_min_width)) return false;
    a.b1 = t;
    a.d1 = d;
    push_rest(w, t, d, next, end);
    return true;
  }

  // Cuts the last window of the envelope, at distance d there, where w begins, and appends w.
  BOOST_FORCEINLINE bool begin_at(const Window& w, const FT& d)
  {
    cut_back(w.b0, d);
    append(w);
    return true;
  }

  // Appends the rest of a window behind the last window of the envelope, which is not cut.
  BOOST_FORCEINLINE void append_rest(const Window& w, const FT& t, const FT& d, const Window* const* next,
                                     const Window* const* end)
  {
    check_width(m_envelope.back(), t);
    push_rest(w, t, d, next, end);
  }

  // Appends the rest of a window behind the last window of the envelope, or keeps it for later if another window begins before.
  BOOST_FORCEINLINE void push_rest(const Window& w, const FT& t, const FT& d, const Window* const* next,
                                   const Window* const* end)
  {
    CGAL_precondition(w.b0 <= t && t < w.b1);
    CGAL_precondition(m_envelope.empty() || !(t < m_envelope.back().b1));
    if ((next == end || t <= (*next)->b0) && (!m_order.has_later() || t <= m_order.first_later().b0))
    {
      m_envelope.push_back(w);
      m_envelope.back().b0 = t;
      m_envelope.back().d0 = d;
    }
    else m_order.push_later(part(w, t, d, w.b1, w.d1));
  }

  // Appends the part of w behind t, the end of the last window of the envelope. `t` is passed by value, since that window may
  // be reallocated.
  BOOST_NOINLINE void begin_behind(const Window& w, FT t, const Window* const* next, const Window* const* end)
  {
    if (w.b1 - t > m_min_width) append_rest(w, t, w.distance_at(t), next, end);
  }

  // Cuts off the overlap, at most rounding, with a window that begins at t. Returns false without a change if too little
  // remains. The distance at the end changes by less than the overlap, and stays where that is within its rounding.
  BOOST_FORCEINLINE bool cut_end(Window& a, const FT& t, const FT& overlap)
  {
    if (!check_width(a, t)) return !CGAL::is_positive(overlap);
    if (BOOST_UNLIKELY(overlap > m_rounding * a.d1)) a.d1 = a.distance_at(t);
    a.b1 = lesser(a.b1, t);
    return true;
  }

  // Merges two overlapping windows with one image. If one of them is propagated, the other keeps only its new part.
  void unite(Window& a, const Window& w)
  {
    if (a.is_propagated() == w.is_propagated())
    {
      if (w.b1 > a.b1)
      {
        a.b1 = w.b1;
        a.d1 = w.d1;
      }
    }
    else if (a.is_propagated()) keep_later(w, a.b1, w.distance_at(a.b1), w.b1, w.d1);
    else
    {
      const Window fresh = a;
      cut_back(w.b0, fresh.distance_at(w.b0));
      m_order.push_later(w);
      keep_later(fresh, w.b1, fresh.distance_at(w.b1), fresh.b1, fresh.d1);
    }
  }

  // Splits overlapping windows with different images: between consecutive bisectors, the nearer window keeps the overlap. The
  // longer window keeps its part beyond the overlap.
  void resolve(const Window& last, const Window& w)
  {
    const Window a = last;
    const Window_bisector<Traits> bisector(m_traits, a, w);
    const int n = bisector.number();
    bool a_owns = bisector.first_is_nearer();
    for (int i = 0; i <= n; ++i, a_owns = !a_owns)
    {
      const Window& owner = a_owns ? a : w;
      const FT& from = i == 0 ? bisector.low() : bisector[i - 1];
      const FT& d_from = i == 0 ? bisector.distance_at_low(a_owns) : bisector.distance(i - 1);
      const FT& to = i == n ? owner.b1 : bisector[i];
      const FT& d_to = i == n ? owner.d1 : bisector.distance(i);
      if (i > 0) keep_later(owner, from, d_from, to, d_to);
      else if (a_owns) cut_back(to, d_to);
      else
      {
        cut_back(bisector.low(), bisector.distance_at_low(true));
        if (to - from > m_min_width) append(part(w, from, d_from, to, d_to));
      }
    }
    const Window& other = a_owns ? a : w; // a_owns was toggled once more
    keep_later(other, bisector.high(), bisector.distance_at_high(a_owns), other.b1, other.d1);
  }

  // Variant of resolve() for estimated distances: each window keeps all parts except those where the other is certainly
  // nearer. If both have equal distance functions, the first window keeps the overlap.
  void resolve_estimated(const Window& last, const Window& w)
  {
    const Window a = last;
    if (same_distances(a, w))
    {
      keep_later(w, a.b1, w.distance_at(a.b1), w.b1, w.d1);
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
  void cut_back(const FT& t, const FT& d)
  {
    CGAL_precondition(!m_envelope.empty());
    Window& a = m_envelope.back();
    CGAL_precondition(CGAL::possibly(estimate(t) <= estimate(a.b1)));
    if (t - a.b0 <= m_min_width) m_envelope.pop_back();
    else
    {
      a.b1 = t;
      a.d1 = d;
    }
  }

  void keep_later(const Window& w, const FT& from, const FT& d_from, const FT& to, const FT& d_to)
  {
    if constexpr (Interval_filter<FT>::leaves_open)
    {
      if (!CGAL::possibly(compare_bounds(from, to) == SMALLER)) return;
    }
    else if (!(to - from > m_min_width)) return;
    m_order.push_later(part(w, from, d_from, to, d_to));
  }

  static Window part(const Window& whole, const FT& from, const FT& d_from, const FT& to, const FT& d_to)
  {
    Window w = whole;
    w.b0 = from;
    w.d0 = d_from;
    w.b1 = to;
    w.d1 = d_to;
    return w;
  }

  // A part of a window, not propagated.
  static Window new_part(const Window& whole, const FT& from, const FT& d_from, const FT& to, const FT& d_to)
  {
    Window w = part(whole, from, d_from, to, d_to);
    w.set_new();
    return w;
  }

  const std::vector<Index>* m_source_of;
  const Start_values<FT>* m_start_values;
  const Traits& m_traits;
  Inline_sequence<Window> m_envelope;
  Window_order<FT, Window> m_order;
  std::vector<std::size_t> m_occupants; // places in the envelope, in order, of windows that may occupy a gap
  FT m_length, m_min_width, m_max_gap, m_least_overlap, m_widest_gap, m_wide, m_rounding, m_gap_rounding, m_certain_difference,
    m_passed, m_nearest_gap;
  bool m_has_closed_gaps = false;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
