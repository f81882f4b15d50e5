// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removal of parts of windows on a halfedge that are certainly farther than another window.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_ENVELOPE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_ENVELOPE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_number_pair.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_bisector.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_overlap_split.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_order.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Sweep as in Lower_envelope, but two windows whose distances tie within their errors both remain, so neighbours overlap
// slightly.
class Certified_envelope
{
public:
  typedef Certified_window Window;

  // Returns the envelope sorted by b0, valid until the next call.
  const std::vector<Window>& operator()(const Window* first, const Window* last, double length)
  {
    m_length = length;
    m_envelope.clear();
    m_order.start(first, last, nullptr, nullptr);
    for (const Window* const* i = m_order.begin(); i != m_order.end(); ++i)
    {
      const Window& w = **i;
      while (m_order.has_later_before(w)) insert(m_order.pop_later(), w.b0);
      insert(w, i + 1 != m_order.end() ? i[1]->b0 : length);
    }
    while (m_order.has_later()) insert(m_order.pop_later(), length);
    CGAL_postcondition(std::is_sorted(m_envelope.begin(), m_envelope.end(), [](const Window& a, const Window& b) {
      return a.b0 < b.b0;
    }));
    return m_envelope;
  }

  // True if the list needs no sweep: intervals are monotone and no windows merge.
  bool is_monotone_list(const Window* first, const Window* last) const
  {
    for (; last - first > 1; ++first)
      if (!(first[0].b0 <= first[1].b0 && first[0].b1 <= first[1].b1) || may_merge(first[0], first[1])) return false;
    return true;
  }

private:
  // Processes a window; the next one begins at `next`.
  BOOST_FORCEINLINE void insert(const Window& w, double next)
  {
    if (m_envelope.empty() || !adds_usual_case(w, next)) add(w);
  }

  // Fast path for the usual relations of w to the last window of the envelope. Returns false without a change in other cases.
  BOOST_FORCEINLINE bool adds_usual_case(const Window& w, double next)
  {
    Window& a = m_envelope.back();
    const double overlap = a.b1 - w.b0;
    if (overlap < -gap())
    {
      m_envelope.push_back(w);
      return true;
    }
    if (may_merge(a, w)) return false;
    const bool a_ends_first = a.b1 < w.b1;
    if (overlap <= 0x1p-36 * m_length && a_ends_first)
    { // common rays except for outward rounding at each face
      m_envelope.push_back(w);
      return true;
    }
    const double high = a_ends_first ? a.b1 : w.b1;
    const Geodesic_number_pair<double> d = a_ends_first ? Window::distances_at(a, w.b0, w, high) : a.distances_at({w.b0, high});
    const double a_low = d.first(), a_high = a_ends_first ? a.d1 : d.second(), w_high = a_ends_first ? d.second() : w.d1;
    const Certified_bisector bisector(a, w, m_length);
    const double at_low = a_low - w.d0, at_high = a_high - w_high;
    if (a_ends_first && (std::max)(std::abs(at_low), std::abs(at_high)) <= 4 * bisector.margin() &&
        !bisector.may_turn(w.b0, high))
    { // already cut at their bisector
      m_envelope.push_back(w);
      return true;
    }
    if (!(at_low < -bisector.margin())) return false;
    if (at_high > bisector.margin())
    { // a single bisector point
      Certified_bisector::Cut of_a, of_w;
      if (!a_ends_first || !bisector.find(w.b0, high, of_a, of_w)) return false;
      a.b1 = of_a.t;
      a.d1 = of_a.distance;
      push_rest(w, of_w, next);
      return true;
    }
    if (at_high < -bisector.margin() && !bisector.may_turn_between(-1, w.b0, high))
    { // the window of the envelope is nearer
      if (a_ends_first) push_rest(w, {high, w_high}, next);
      return true;
    }
    return false;
  }

  // Adds the remaining part of a window behind the last one of the envelope.
  void push_rest(const Window& w, const Certified_bisector::Cut& from, double next)
  {
    if (from.t <= next && (!m_order.has_later() || from.t <= m_order.first_later().b0))
    {
      m_envelope.push_back(w);
      m_envelope.back().b0 = from.t;
      m_envelope.back().d0 = from.distance;
      return;
    }
    Window rest = w;
    rest.b0 = from.t;
    rest.d0 = from.distance;
    m_order.push_later(rest);
  }

  void add(const Window& w)
  {
    if (m_envelope.empty() || w.b0 > m_envelope.back().b1 + gap()) m_envelope.push_back(w);
    else if (const double difference = difference_of_images(m_envelope.back(), w); difference <= merging(w))
      unite(m_envelope.back(), w, difference + 2 * (std::max)(w.b0 - m_envelope.back().b1, 0.));
    else if (w.b0 >= m_envelope.back().b1) m_envelope.push_back(w);
    else resolve(w);
  }

  // No other ray fits between neighbours of one image with a smaller gap.
  double gap() const { return 64 * unit_roundoff * m_length; }

  // Images that differ by at most this merge. The rays of a merged window belong to only one of the images, so the sum over
  // all faces of a path must be less than the error allowed for rays.
  double merging(const Window& w) const { return 0x1p-18 * image_error * (std::abs(w.x) + std::abs(w.y) + 1); }

  // Upper bound of any shortest path, in units of the longest edge.
  static constexpr double farthest = 0x1p34;

  // Tests first the coordinate most likely to differ.
  BOOST_FORCEINLINE bool may_merge(const Window& a, const Window& w) const
  {
    const double most = merging(w);
    return std::abs((a.x - w.x) + (a.x_low - w.x_low)) <= most && difference_of_images(a, w) <= most;
  }

  // Upper bound of the difference of two windows' distances anywhere; infinity for windows of different kinds.
  double difference_of_images(const Window& a, const Window& b) const
  {
    if ((a.bits ^ b.bits) & 1u) return infinity();
    const double x = std::abs((a.x - b.x) + (a.x_low - b.x_low)), y = std::abs((a.y - b.y) + (a.y_low - b.y_low));
    const double sigma = std::abs((a.sigma - b.sigma) + (a.sigma_low - b.sigma_low));
    return (x + y) * (a.is_parallel() ? farthest : 1.) + sigma;
  }

  static double infinity() { return Number_policy<double>::infinity(); }

  // Merges windows with one image.
  void unite(Window& a, const Window& w, double difference)
  {
    const double radius = (std::max)(a.radius, w.radius + difference);
    if (a.is_propagated() && !w.is_propagated() && (radius > a.radius || w.faces() > a.faces()) && w.b0 < a.b1)
    { // the rays of a have a larger radius now, or more faces
      m_envelope.push_back(w);
      return;
    }
    if (w.is_propagated() == a.is_propagated())
    {
      a.radius = radius;
      a.set_faces_of_both(w);
      if (w.b1 <= a.b1) return;
      a.b1 = w.b1;
      a.d1 = w.d1;
    }
    else if (a.is_propagated())
    {
      if (w.b1 <= a.b1) return;
      Window rest = w;
      rest.set_interval((std::max)(w.b0, a.b1 - gap()), w.b1);
      if (rest.b0 > w.b0) m_order.push_later(rest);
      else m_envelope.push_back(rest);
    }
    else if (a.radius + difference > w.radius) m_envelope.push_back(w);
    else
    { // keep the rays of the unpropagated window a that are not in w
      Window rest = a;
      cut(a, {a.b0, w.b0 + gap()});
      const bool goes_on = rest.b1 > w.b1;
      if (goes_on) rest.set_interval((std::max)(w.b1 - gap(), rest.b0), rest.b1);
      m_envelope.push_back(w);
      if (goes_on) m_order.push_later(rest);
    }
  }

  // Removes the parts that are certainly farther from overlapping windows with different images.
  void resolve(Window w)
  {
    Window& a = m_envelope.back();
    const Certified_overlap_split split(a, w, m_length);
    if (split.is_tie())
    {
      m_envelope.push_back(w);
      return;
    }
    Interval_set of_a, of_w = split.kept_of_second();
    if (a.b0 < split.low()) of_a.append({a.b0, split.low()});
    of_a.append_all(split.kept_of_first());
    if (a.b1 > split.high()) of_a.append({split.high(), a.b1});
    if (w.b1 > split.high()) of_w.append({split.high(), w.b1});
    // parts that begin later are queued
    const bool a_stays = of_a.size() > 0 && of_a[0].from <= a.b0, w_stays = of_w.size() > 0 && of_w[0].from <= w.b0;
    for (int i = a_stays ? 1 : 0; i < of_a.size(); ++i) push_part(a, of_a[i]);
    for (int i = w_stays ? 1 : 0; i < of_w.size(); ++i) push_part(w, of_w[i]);
    if (a_stays) cut(a, of_a[0]);
    else m_envelope.pop_back();
    if (!w_stays) return;
    cut(w, of_w[0]);
    if (a_stays) m_envelope.push_back(w);
    else add(w);
  }

  static void cut(Window& w, const Interval_set::Interval& part)
  {
    if (part.from > w.b0)
    {
      w.b0 = part.from;
      w.d0 = w.distance_at(part.from);
    }
    if (part.to < w.b1)
    {
      w.b1 = part.to;
      w.d1 = w.distance_at(part.to);
    }
  }

  void push_part(Window w, const Interval_set::Interval& part)
  {
    cut(w, part);
    m_order.push_later(w);
  }

  double m_length = 0;
  std::vector<Window> m_envelope;
  Window_order<double, Window> m_order;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
