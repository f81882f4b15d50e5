// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distance along an edge as the minimum of the functions of the windows that reach the edge.

#ifndef GEODESIC_OFFSET_TEST_EDGE_PROFILE_H
#define GEODESIC_OFFSET_TEST_EDGE_PROFILE_H

#include "level_layout.h"

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace test {

typedef CGAL::Geodesic_offset::internal::Face_field<double> Face_field;
typedef CGAL::Geodesic_offset::internal::Face_window<double> Face_window;

struct Interval
{
  double from, to;
  double length() const { return to - from; }
  double middle() const { return (from + to) / 2; }
};

/// Distance of one window on a part of an edge: `sigma + |(t - x, y)|`, or `sigma + x t` for parallel rays, for t between
/// `from` and `to`.
struct Edge_span
{
  bool is_parallel;
  double x, y, sigma;
  double from, to;

  double distance(double t) const { return is_parallel ? sigma + x * t : sigma + std::hypot(t - x, y); }

  /// Position of the smallest distance.
  double lowest() const
  {
    if (is_parallel) return x > 0 ? from : to;
    return (std::max)(from, (std::min)(x, to));
  }

  /// The part nearer than `d`: one interval, since a window's distance is convex.
  bool nearer_than(double d, Interval& part) const
  {
    part = {from, to};
    if (is_parallel)
    {
      if (x > 0) part.to = (std::min)(to, (d - sigma) / x);
      if (x < 0) part.from = (std::max)(from, (d - sigma) / x);
      return x == 0 ? sigma < d : part.from < part.to;
    }
    const double r = d - sigma, h = std::abs(y);
    if (!(r > h)) return false;
    const double half = std::sqrt((r - h) * (r + h));
    part = {(std::max)(from, x - half), (std::min)(to, x + half)};
    return part.from < part.to;
  }
};

/// Distance along an edge of length `length`, by the arc length from one end.
class Edge_profile
{
public:
  double length = 0;
  std::vector<Edge_span> spans;

  /// Adds the windows in a face on its halfedge k. `reversed`: the profile runs from the target of the halfedge to its
  /// source.
  ///
  /// Rounding leaves gaps between the cones of neighbouring windows. As in the field, paths around the ends of a window's
  /// chord fill them; these paths are valid everywhere in the face.
  void add_windows(const Face_field& field, int k, bool reversed)
  {
    length = field.frame().edge_length(k);
    const Point_in_face a = field.frame().corner(k), u = field.frame().direction(k);
    for (const Face_window& w : field.windows())
    {
      Edge_span span;
      if (span_of(w, field, k, span)) add(span, reversed);
      if (w.origin >= CGAL::Geodesic_offset::internal::STARTS_IN_FACE) continue;
      for (const Point_in_face& p : {w.left, w.right})
        add(Edge_span{false, dot(p - a, u), cross(u, p - a), w.distance_at(p), 0, length}, reversed);
    }
  }

  /// Removes spans that are nowhere nearer than `d`.
  void leave_out_beyond(double d)
  {
    spans.erase(std::remove_if(spans.begin(), spans.end(), [d](const Edge_span& s) { return s.distance(s.lowest()) > d; }),
                spans.end());
  }

  double distance(double t) const
  {
    std::size_t nearest;
    return distance(t, nearest);
  }

  /// Distance at t; `nearest` is its span, or `spans.size()` if none reaches t.
  double distance(double t, std::size_t& nearest) const
  {
    double best = std::numeric_limits<double>::infinity();
    nearest = spans.size();
    for (std::size_t i = 0; i < spans.size(); ++i)
    {
      if (t < spans[i].from || spans[i].to < t) continue;
      const double d = spans[i].distance(t);
      if (d < best) nearest = i;
      best = (std::min)(best, d);
    }
    return best;
  }

  double lowest() const
  {
    double best = std::numeric_limits<double>::infinity();
    for (const Edge_span& s : spans) best = (std::min)(best, s.distance(s.lowest()));
    return best;
  }

  /// The parts of the edge nearer than `d`, in order; gaps of up to `gap` between windows are closed.
  void nearer_than(double d, double gap, std::vector<Interval>& result) const
  {
    result.clear();
    Interval part;
    for (const Edge_span& s : spans)
      if (s.nearer_than(d, part)) result.push_back(part);
    std::sort(result.begin(), result.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < result.size(); ++i)
      if (result[i].from <= result[last].to + gap) result[last].to = (std::max)(result[last].to, result[i].to);
      else result[++last] = result[i];
    if (!result.empty()) result.resize(last + 1);
  }

private:
  void add(Edge_span span, bool reversed)
  {
    if (reversed)
    {
      std::swap(span.from, span.to);
      span.from = length - span.from;
      span.to = length - span.to;
      if (span.is_parallel)
      {
        span.sigma += span.x * length;
        span.x = -span.x;
      }
      else span.x = length - span.x;
    }
    spans.push_back(span);
  }

  // The part of the halfedge where the straight path of the window is a path in the face.
  static bool span_of(const Face_window& w, const Face_field& field, int k, Edge_span& span)
  {
    const auto& frame = field.frame();
    const Point_in_face a = frame.corner(k), u = frame.direction(k);
    const double length = frame.edge_length(k);
    span.is_parallel = w.is_parallel();
    span.from = 0;
    span.to = length;
    if (span.is_parallel)
    {
      span.sigma = w.sigma - dot(w.image(), a);
      span.x = -dot(w.image(), u);
      span.y = 0;
    }
    else
    {
      span.sigma = w.sigma;
      span.x = dot(w.image() - a, u);
      span.y = cross(u, w.image() - a);
    }
    if (w.origin == k)
    {
      span.from = dot(w.left - a, u);
      span.to = dot(w.right - a, u);
      if (span.to < span.from) std::swap(span.from, span.to);
      return true;
    }
    // straight paths lead from a point of the face to every other
    if (w.origin >= CGAL::Geodesic_offset::internal::STARTS_IN_FACE && !w.is_parallel()) return true;
    const Point_in_face b = frame.on_edge(k, length);
    const bool starts_in_face = w.origin == CGAL::Geodesic_offset::internal::STARTS_IN_FACE;
    const double beyond = (starts_in_face ? Judge_tolerances::source_ray : Judge_tolerances::bounding_ray) * field.size();
    const double left = beyond * CGAL::Geodesic_offset::internal::length(w.ray_direction(w.left)),
                 right = beyond * CGAL::Geodesic_offset::internal::length(w.ray_direction(w.right));
    clip(left - w.left_side(a), left - w.left_side(b), length, span);
    clip(right + w.right_side(a), right + w.right_side(b), length, span);
    // in front of the source, or of the chord: rays along the chord pass points behind it, too
    const double nearest = starts_in_face ? 0 : (std::min)(w.distance_at(w.left), w.distance_at(w.right));
    if (starts_in_face || w.is_parallel())
      clip(beyond + w.distance_at(a) - nearest, beyond + w.distance_at(b) - nearest, length, span);
    return span.from <= span.to;
  }

  // Clips to the part where a linear function with values f0 and f1 at the ends is not negative.
  static void clip(double f0, double f1, double length, Edge_span& span)
  {
    if (f0 >= 0 && f1 >= 0) return;
    if (f0 < 0 && f1 < 0)
    {
      span.to = -1;
      return;
    }
    const double t = length * (f0 / (f0 - f1));
    if (f0 < 0) span.from = (std::max)(span.from, t);
    else span.to = (std::min)(span.to, t);
  }
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_EDGE_PROFILE_H
