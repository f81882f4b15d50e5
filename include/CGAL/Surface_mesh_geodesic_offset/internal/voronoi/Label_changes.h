// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points of a segment in a face where the nearest source changes, in order.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_LABEL_CHANGES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_LABEL_CHANGES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_conic.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Parameter_intervals.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_tolerances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_bisector.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class NT>
struct Label_change
{
  NT t;           // from the start of the segment
  Index from, to; // labels before and behind
};

// The lower envelope of windows along a segment. Windows are inserted one by one; where two of them tie up to rounding, that with
// the smaller label is nearest.
template <class NT>
class Label_changes
{
public:
  typedef Point_in_face<NT> Point;

  // Calls out(change) for the changes along the segment from o in the direction of the unit vector u, in order. The labels of
  // its ends are given: where the distances say otherwise, up to rounding, there is a change at the end. `candidates`: windows
  // whose order along the segment counts; `all`: those that may be nearest at the ends, too, as those along a side of a cell.
  // `center`: of the face, for segments in it, where changes are on bisectors; none on edges, where they are where windows tie,
  // as chords end there.
  template <class OutputFunction>
  void operator()(const Point& o, const Point& u, NT size, Index first, Index last,
                  const std::vector<Voronoi_window<NT>>& windows, const std::vector<unsigned>& candidates,
                  const std::vector<unsigned>& all, const Voronoi_tolerances<NT>& tolerances,
                  const std::optional<Point>& center, const OutputFunction& out)
  {
    m_pieces.clear();
    for (const unsigned i : candidates) insert(o, u, size, windows[i], i, tolerances);
    const Segment segment{o, u, windows, all, tolerances};
    sample(segment);
    m_changes.clear();
    const auto add = [&](const Change& c) { m_changes.push_back(c); };
    Index label = first;
    NT at = 0; // of the last sample with this label
    for (std::size_t i = 0, j; i < m_samples.size(); i = j)
    {
      for (j = i + 1; j < m_samples.size() && m_samples[j].label == m_samples[i].label;) ++j;
      const Sample &s = m_samples[i], &t = m_samples[j - 1];
      if (s.label != label)
      {
        const NT after = j < m_samples.size() ? m_samples[j].t : size, before = i > 0 ? m_samples[i - 1].t : 0;
        if (after - before <= tolerances.shortest_interval) continue;
        if (i > 0 && at == s.t) add({{at, label, s.label}, m_samples[i - 1].window, s.window});
        else write_changes(segment, at, s.t, label, s.label, Voronoi_tolerances<NT>::most_changes_between, add);
        label = s.label;
      }
      at = t.t;
    }
    if (label != last) add({{size, label, last}, none, none});
    for (std::size_t i = 0; i < m_changes.size(); ++i)
    {
      const Change& c = m_changes[i];
      const bool may_move = center && 0 < c.t && c.t < size;
      const NT low = i > 0 ? (m_changes[i - 1].t + c.t) / 2 : 0;
      const NT high = i + 1 < m_changes.size() ? (c.t + m_changes[i + 1].t) / 2 : size;
      out(Label_change<NT>{may_move ? crossing(segment, c, low, high, *center) : c.t, c.from, c.to});
    }
  }

private:
  struct Segment
  {
    Point o, u;
    const std::vector<Voronoi_window<NT>>& windows;
    const std::vector<unsigned>& all;
    const Voronoi_tolerances<NT>& tolerances;

    NT distance_from(Index label, NT t) const { return least_distance_from(label, windows, all, o + t * u, tolerances.slack); }

    // True only if the source of a window is nearest up to `tie`; distances without cones suffice for most other windows.
    bool is_certainly_nearest(unsigned window, NT t, NT tie) const
    {
      const Point p = o + t * u;
      bool is_straight;
      const NT d = distance_through(windows[window], p, tolerances.slack, is_straight);
      return std::all_of(all.begin(), all.end(), [&](unsigned i) {
        const Voronoi_window<NT>& w = windows[i];
        return w.label == windows[window].label || d <= w.distance_at(p) + tie / 2 || // rounding is less than half a tie
               d <= distance_through(w, p, tolerances.slack, is_straight) + tie;
      });
    }

    bool is_nearest(unsigned window, NT t, NT tie) const
    {
      return is_certainly_nearest(window, t, tie) ||
             Nearest_windows<NT>(windows[window].label, windows, all, o + t * u, tolerances.slack).label_is_nearest(tie);
    }

    // The label of the nearest source; of several that tie, the preferred one.
    Index label_at(NT t, Index preferred) const
    {
      const Nearest_windows<NT> nearest(preferred, windows, all, o + t * u, tolerances.slack);
      return nearest.label_is_nearest(tolerances.loose_tie) ? preferred : windows[nearest.any].label;
    }
  };

  struct Sample
  {
    NT t;
    Index label;
    unsigned window; // of the label; none, if it is not that of the interval
  };

  struct Change : Label_change<NT>
  {
    unsigned before, after; // windows; none, if they are not known
  };
  static constexpr unsigned none = Nearest_windows<NT>::none;

  // Labels at the ends of intervals with one label, and in the middle of their pieces: that of the interval, unless rounding
  // has left a gap between cones there, in which the windows of the interval are farther than the path around the end of a
  // cone.
  void sample(const Segment& segment)
  {
    m_samples.clear();
    const auto add = [&](NT t, const Piece& p) {
      const bool is_certain = segment.is_certainly_nearest(p.number, t, segment.tolerances.loose_tie);
      const Index label = is_certain ? p.label : segment.label_at(t, p.label);
      m_samples.push_back({t, label, label == p.label ? p.number : none});
    };
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
    {
      const Piece& p = m_pieces[i];
      if (i == 0 || m_pieces[i - 1].label != p.label) add(p.begin, p);
      add((p.begin + p.end) / 2, p);
      if (i + 1 == m_pieces.size() || m_pieces[i + 1].label != p.label) add(p.end, p);
    }
  }

  // Writes the changes between two samples: one, where the distances agree, or several, if a third source is nearer there.
  template <class OutputFunction>
  static void write_changes(const Segment& segment, NT low, NT high, Index first, Index second, int most_between,
                            const OutputFunction& out)
  {
    NT t = (low + high) / 2;
    if (high - low > segment.tolerances.shortest_interval)
    {
      NT from = low, to = high;
      for (; from < t && t < to; t = (from + to) / 2)
        (segment.distance_from(first, t) <= segment.distance_from(second, t) ? from : to) = t;
      const Index third = segment.label_at(t, first);
      if (third != first && third != second && most_between > 0)
      {
        write_changes(segment, low, t, first, third, most_between - 1, out);
        write_changes(segment, t, high, third, second, most_between - 1, out);
        return;
      }
    }
    out({{t <= segment.tolerances.shortest_interval ? 0 : t, first, second}, none, none});
  }

  // The parameter between `low` and `high` at which the bisector of the nearest windows crosses the segment near a change,
  // where both sources tie from there to the change; that of the change if there is none. So arcs pass through the gates, also
  // where the angle between the rays is so small that rounding moves the bisector far.
  NT crossing(const Segment& segment, const Change& change, NT low, NT high, const Point& center) const
  {
    const Point at = segment.o + change.t * segment.u, n = quarter_turn(segment.u);
    const NT slack = segment.tolerances.slack, tie = segment.tolerances.tie;
    const auto nearest_of = [&](Index label) {
      return Nearest_windows<NT>(label, segment.windows, segment.all, at, slack).with_label;
    };
    const unsigned a = change.before != none ? change.before : nearest_of(change.from),
                   b = change.after != none ? change.after : nearest_of(change.to);
    if (a == none || b == none) return change.t;
    const Voronoi_window<NT>&v = segment.windows[a], &w = segment.windows[b];
    Bisector_conic<NT> conic;
    if (!conic.make(v.is_parallel() ? w : v, v.is_parallel() ? v : w, tie, center)) return change.t;
    NT result = change.t, nearest = std::numeric_limits<NT>::infinity();
    Parameter_intervals<NT> below(-nearest, nearest);
    below.keep_not_positive(conic.along(Linear_form<NT>{n.x, n.y, 0, dot(n, segment.o)}));
    for (const auto& i : below)
      for (const NT parameter : {i.begin, i.end})
      {
        if (!is_finite(parameter) || !(parameter > conic.lowest_parameter())) continue;
        const Point p = conic.at(parameter).point();
        const NT t = dot(p - segment.o, segment.u), gap = CGAL::abs(t - change.t);
        if (!(low < t && t < high && gap < nearest) || !v.holds_at(p, slack) || !w.holds_at(p, slack)) continue;
        const auto tie_at = [&](NT s) { return segment.is_nearest(a, s, tie) && segment.is_nearest(b, s, tie); };
        const bool tie_between = std::all_of(m_samples.begin(), m_samples.end(), [&](const Sample& s) {
          return (s.t <= t) == (s.t <= change.t) || tie_at(s.t);
        });
        if (!tie_between || !tie_at(t) || !tie_at((t + change.t) / 2)) continue;
        nearest = gap;
        result = t;
      }
    return result;
  }

  struct Distances // traits of Window_bisector
  {
    typedef NT FT;
    struct Compare_distance_2
    {
      Comparison_result operator()(NT d, NT e, NT) const { return CGAL::abs(d - e) <= tie ? EQUAL : d < e ? SMALLER : LARGER; }
      NT tie;
    };
    struct Compute_distance_2
    {
      NT operator()(NT x, NT y, NT sigma, bool is_parallel, NT px, NT py) const
      {
        return is_parallel ? sigma - (x * px + y * py) : sigma + hypotenuse(px - x, py - y);
      }
    };
    Compare_distance_2 compare_distance_2_object() const { return {tie}; }
    Compute_distance_2 compute_distance_2_object() const { return {}; }
    NT tie;
  };

  struct Piece
  {
    NT begin, end;
    Index label;
    unsigned number;   // of the window in the face
    Window<NT> window; // in the frame of the segment
  };

  void insert(const Point& o, const Point& u, NT size, const Voronoi_window<NT>& w, unsigned number,
              const Voronoi_tolerances<NT>& tolerances)
  {
    NT begin = 0, end = size;
    for (int k = 0; k < w.number_of_bounds; ++k)
    {
      const Half_plane<NT>& h = w.bound[std::size_t(k)];
      const NT slope = dot(h.n, u), value = h.value(o) - tolerances.slack; // value + t slope <= 0
      if (slope > 0) end = (std::min)(end, -value / slope);
      else if (slope < 0) begin = (std::max)(begin, -value / slope);
      else if (value > 0) return;
    }
    if (!(begin < end)) return;
    Window<NT> in_segment{};
    const Point image = w.is_parallel() ? w.image() : w.image() - o;
    in_segment.x = dot(u, image);
    in_segment.y = -CGAL::abs(cross(u, image)); // below the segment, as Window_bisector needs it
    in_segment.sigma = w.is_parallel() ? w.distance_at(o) : w.sigma();
    in_segment.bits = Window<NT>::make_bits(w.is_parallel(), no_index);
    m_new.clear();
    const auto first = std::partition_point(m_pieces.begin(), m_pieces.end(), [&](const Piece& p) { return p.end <= begin; });
    NT at = begin;
    auto last = first;
    for (; last != m_pieces.end() && last->begin < end; ++last)
    {
      const Piece& p = *last;
      const NT low = (std::max)(p.begin, begin), high = (std::min)(p.end, end);
      put(at, low, w.label, number, in_segment);
      put(p.begin, low, p.label, p.number, p.window);
      compare(low, high, p, w.label, number, in_segment, tolerances.tie);
      put(high, p.end, p.label, p.number, p.window);
      at = high;
    }
    put(at, end, w.label, number, in_segment);
    m_pieces.insert(m_pieces.erase(first, last), m_new.begin(), m_new.end());
  }

  // Puts the parts of two windows on a common interval.
  void compare(NT low, NT high, const Piece& p, Index label, unsigned number, const Window<NT>& window, NT tie)
  {
    const Distances traits{tie};
    const Bisector_crossing<Distances> crossing(traits, p.window, window);
    const auto lead = [&](NT t) { return crossing.at(window, t) - crossing.at(p.window, t); }; // of p; 2-Lipschitz
    const NT at_low = lead(low);
    const auto has_sign_of_low = [&](NT at_high) { return CGAL::abs(at_high) > tie && (at_high > 0) == (at_low > 0); };
    if (CGAL::abs(at_low) > tie + 2 * (high - low) ||
        (CGAL::abs(at_low) > tie && has_sign_of_low(lead(high)) && !crossing.may_cross_twice(low, high)))
    {
      if (at_low > 0) put(low, high, p.label, p.number, p.window);
      else put(low, high, label, number, window);
      return;
    }
    const bool is_first = p.label <= label;
    Piece a = p, b = p;
    (is_first ? b : a).window = window;
    (is_first ? b : a).label = label;
    (is_first ? b : a).number = number;
    for (Window<NT>* w : {&a.window, &b.window})
    {
      w->b0 = low;
      w->b1 = high;
      w->d0 = w->distance_at(low);
      w->d1 = w->distance_at(high);
    }
    const Window_bisector<Distances> bisector(traits, a.window, b.window);
    bool a_is_nearer = bisector.first_is_nearer();
    NT at = low;
    for (int i = 0; i <= bisector.number(); ++i, a_is_nearer = !a_is_nearer)
    {
      const NT to = i < bisector.number() ? bisector[i] : high;
      const Piece& nearer = a_is_nearer ? a : b;
      put(at, to, nearer.label, nearer.number, nearer.window);
      at = to;
    }
  }

  void put(NT begin, NT end, Index label, unsigned number, const Window<NT>& window)
  {
    if (begin < end) m_new.push_back({begin, end, label, number, window});
  }

  std::vector<Piece> m_pieces, m_new; // by increasing position; new pieces in the interval of a window
  std::vector<Sample> m_samples;
  std::vector<Change> m_changes;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
