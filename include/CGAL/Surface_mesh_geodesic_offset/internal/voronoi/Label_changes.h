// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points of a segment in a face where the nearest source changes, in order.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_LABEL_CHANGES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_LABEL_CHANGES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_tolerances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_bisector.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

struct Label_change
{
  double t;       // from the start of the segment
  Index from, to; // labels before and behind
};

// The lower envelope of windows along a segment. Windows are inserted one by one; where two of them tie up to rounding, that with
// the smaller label is nearest.
class Label_changes
{
public:
  typedef Point_in_face<double> Point;

  // Calls out(change) for the changes along the segment from o in the direction of the unit vector u, in order. The labels of its
  // ends are given: where the distances say otherwise, up to rounding, there is a change at the end.
  template <class OutputFunction>
  void operator()(const Point& o, const Point& u, double size, Index first, Index last,
                  const std::vector<Voronoi_window>& windows, const std::vector<unsigned>& candidates,
                  const Voronoi_tolerances& tolerances, const OutputFunction& out)
  {
    m_pieces.clear();
    for (const unsigned i : candidates) insert(o, u, size, windows[i], tolerances);
    Index label = first;
    double end = 0, inside = 0; // of the interval with this label: its end, and a point of it
    for (std::size_t i = 0; i < m_pieces.size();)
    {
      const Index next = m_pieces[i].label;
      const Piece *begins = nullptr, *ends = nullptr;
      for (; i < m_pieces.size() && m_pieces[i].label == next; ++i)
      {
        // In a gap between cones that rounding has left, only the function of a corner, or of a farther window, is known.
        const Piece& p = m_pieces[i];
        if (p.window.distance_at(p.middle()) >
            least_path_length(windows, candidates, o + p.middle() * u) + tolerances.loose_tie)
          continue;
        if (!begins) begins = &p;
        ends = &p;
      }
      if (!begins) continue;
      if (next != label)
      {
        if (ends->end - begins->begin <= tolerances.shortest_interval) continue;
        const auto excess = [&](double t) { return excess_of_first(label, next, o + t * u, windows, candidates, tolerances); };
        double t = begins->begin - end <= tolerances.shortest_interval
                   ? (end + begins->begin) / 2
                   : change_between(end, begins->begin, excess);
        if (std::abs(excess(t)) > tolerances.of_link()) t = change_between(inside, begins->middle(), excess);
        out(Label_change{t <= tolerances.shortest_interval ? 0 : t, label, next});
        label = next;
      }
      end = ends->end;
      inside = ends->middle();
    }
    if (label != last) out(Label_change{size, label, last});
  }

private:
  // The difference of the least distances of a point from two sources.
  static double excess_of_first(Index first, Index second, const Point& p, const std::vector<Voronoi_window>& windows,
                                const std::vector<unsigned>& candidates, const Voronoi_tolerances& tolerances)
  {
    return least_distance_from(first, windows, candidates, p, tolerances.slack) -
           least_distance_from(second, windows, candidates, p, tolerances.slack);
  }

  // A change of the sign of a function between two points.
  template <class Function>
  static double change_between(double low, double high, const Function& excess)
  {
    for (double middle = (low + high) / 2; low < middle && middle < high; middle = (low + high) / 2)
      (excess(middle) <= 0 ? low : high) = middle;
    return low;
  }

  struct Distances // traits of Window_bisector
  {
    typedef double FT;
    struct Compare_distance_2
    {
      Comparison_result operator()(double d, double e, double) const
      {
        return std::abs(d - e) <= tie ? EQUAL : d < e ? SMALLER : LARGER;
      }
      double tie;
    };
    struct Compute_distance_2
    {
      double operator()(double x, double y, double sigma, bool is_parallel, double px, double py) const
      {
        return is_parallel ? sigma - (x * px + y * py) : sigma + std::hypot(px - x, py - y);
      }
    };
    Compare_distance_2 compare_distance_2_object() const { return {tie}; }
    Compute_distance_2 compute_distance_2_object() const { return {}; }
    double tie;
  };

  struct Piece
  {
    double begin, end;
    Index label;
    Window<double> window; // in the frame of the segment

    double middle() const { return (begin + end) / 2; }
  };

  void insert(const Point& o, const Point& u, double size, const Voronoi_window& w, const Voronoi_tolerances& tolerances)
  {
    double begin = 0, end = size;
    for (int k = 0; k < w.number_of_bounds; ++k)
    {
      const Half_plane<double>& h = w.bound[std::size_t(k)];
      const double slope = dot(h.n, u), value = h.value(o) - tolerances.slack; // value + t slope <= 0
      if (slope > 0) end = (std::min)(end, -value / slope);
      else if (slope < 0) begin = (std::max)(begin, -value / slope);
      else if (value > 0) return;
    }
    if (!(begin < end)) return;
    Window<double> in_segment{};
    const Point image = w.is_parallel() ? w.image() : w.image() - o;
    in_segment.x = dot(u, image);
    in_segment.y = -std::abs(cross(u, image)); // below the segment, as Window_bisector needs it
    in_segment.sigma = w.is_parallel() ? w.distance_at(o) : w.sigma();
    in_segment.bits = Window<double>::make_bits(w.is_parallel(), no_index);
    m_new.clear();
    double at = begin;
    for (const Piece& p : m_pieces)
    {
      const double low = (std::max)(p.begin, begin), high = (std::min)(p.end, end);
      if (!(low < high))
      {
        if (p.begin >= end) put(at, end, w.label, in_segment); // fills a gap before p
        if (p.begin >= end) at = end;
        put(p.begin, p.end, p.label, p.window);
        continue;
      }
      put(at, low, w.label, in_segment);
      put(p.begin, low, p.label, p.window);
      compare(low, high, p, w.label, in_segment, tolerances.tie);
      put(high, p.end, p.label, p.window);
      at = high;
    }
    put(at, end, w.label, in_segment);
    m_pieces.swap(m_new);
  }

  // Puts the parts of two windows on a common interval.
  void compare(double low, double high, const Piece& p, Index label, const Window<double>& window, double tie)
  {
    const bool is_first = p.label <= label;
    Piece a = p, b = p;
    (is_first ? b : a).window = window;
    (is_first ? b : a).label = label;
    for (Window<double>* w : {&a.window, &b.window})
    {
      w->b0 = low;
      w->b1 = high;
      w->d0 = w->distance_at(low);
      w->d1 = w->distance_at(high);
    }
    const Distances traits{tie};
    const Window_bisector<Distances> bisector(traits, a.window, b.window);
    bool a_is_nearer = bisector.first_is_nearer();
    double at = low;
    for (int i = 0; i <= bisector.number(); ++i, a_is_nearer = !a_is_nearer)
    {
      const double to = i < bisector.number() ? bisector[i] : high;
      const Piece& nearer = a_is_nearer ? a : b;
      put(at, to, nearer.label, nearer.window);
      at = to;
    }
  }

  void put(double begin, double end, Index label, const Window<double>& window)
  {
    if (begin < end) m_new.push_back({begin, end, label, window});
  }

  std::vector<Piece> m_pieces, m_new; // by increasing position
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
