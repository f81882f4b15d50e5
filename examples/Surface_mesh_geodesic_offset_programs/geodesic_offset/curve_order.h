// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Order of the offsets in files, with starts of closed curves such that curves and those around them can be linked.

#ifndef GEODESIC_OFFSET_CURVE_ORDER_H
#define GEODESIC_OFFSET_CURVE_ORDER_H

#include "common/common.h"

#include <CGAL/Surface_mesh_geodesic_offset/nest_offset_curves.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace geodesic_offset {

enum class Curve_order {
  as_cut, // by increasing distance
  by_distance, // the same, with starts
  by_nesting // each curve before those that it surrounds, which follow it before any other curve
};

namespace internal {

// The closed curve with its start at the point nearest to q.
inline Offset_curve starting_near(const Offset_curve& curve, const Point& q)
{
  std::size_t nearest = 0;
  double parameter = 0, least = infinity;
  for(std::size_t i = 0; i < curve.number_of_pieces(); ++i)
  {
    const auto approach = [&](double t) {
      const auto p = curve.oriented_point(i, t);
      return (q - p.point) * p.tangent;
    };
    // On at most a half turn, the distance has one minimum between two points if it falls at the first and rises at the second.
    // Otherwise an end of the piece is nearest.
    double t = 0;
    if(approach(0) > 0 && approach(1) < 0)
      for(double step = 0.5; step > 1e-17; step /= 2)
        if(approach(t + step) > 0) t += step;
    for(const double s : {0., t})
    {
      const double distance = CGAL::squared_distance(curve.piece(i).point(s), q);
      if(!(distance < least)) continue;
      least = distance;
      nearest = i;
      parameter = s;
    }
  }
  return curve.starting_at(nearest, parameter);
}

// Indices of the curves: each parent first, then its children one after the other, each with its own children.
inline std::vector<std::size_t> outer_to_inner(const std::vector<CGAL::Offset_curve_nesting>& places)
{
  const std::size_t n = places.size();
  std::vector<std::vector<std::size_t>> children(n + 1); // the last ones have no parent
  for(std::size_t i = n; i-- > 0;) children[std::min(places[i].parent, n)].push_back(i);
  std::vector<std::size_t> sequence, stack = children[n];
  while(!stack.empty())
  {
    sequence.push_back(stack.back());
    stack.pop_back();
    stack.insert(stack.end(), children[sequence.back()].begin(), children[sequence.back()].end());
  }
  return sequence;
}

} // namespace internal

// Sorts curves that come by increasing distance, and starts each closed curve that has a parent at its point nearest to the start of
// its parent, and others at the end of an element, a corner if there is one. Returns the places in the tree of nesting, in the new order.
inline std::vector<CGAL::Offset_curve_nesting> order_curves(std::vector<Offset_curve>& curves, Curve_order order)
{
  const std::vector<CGAL::Offset_curve_nesting> places = CGAL::nest_offset_curves(curves);
  const std::size_t n = curves.size();
  std::vector<std::size_t> sequence = internal::outer_to_inner(places);
  for(const std::size_t i : sequence)
    if(curves[i].is_closed())
      curves[i] = places[i].parent < n ? internal::starting_near(curves[i], curves[places[i].parent].piece(0).point(0))
                                       : curves[i].starting_at(curves[i].elements(0).front().first_piece(), 0);
  if(order == Curve_order::by_distance) std::iota(sequence.begin(), sequence.end(), std::size_t(0));
  std::vector<std::size_t> position(n);
  for(std::size_t k = 0; k < n; ++k) position[sequence[k]] = k;
  std::vector<Offset_curve> sorted;
  std::vector<CGAL::Offset_curve_nesting> result;
  for(const std::size_t i : sequence)
  {
    sorted.push_back(std::move(curves[i]));
    result.push_back(places[i]);
    if(places[i].parent < n) result.back().parent = position[places[i].parent];
  }
  curves = std::move(sorted);
  return result;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_CURVE_ORDER_H
