// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A triangle in which bisectors are found: a face, or a part of it. Bisectors cross the sides of a cell at gates, where the
// nearest source changes. The gates of a side are decided once for both cells, so what cells yield always fits together.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_VORONOI_CELL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_VORONOI_CELL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Window_cone.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// A change of the nearest source on the side of a cell, counterclockwise from label `from` to label `to`.
template <class NT>
struct Voronoi_gate
{
  Point_in_face<NT> point;
  unsigned char side; // of the cell; for a face, its halfedge
  Index from, to;
  Index node;
};

template <class NT>
struct Voronoi_cell
{
  typedef Point_in_face<NT> Point;

  Per_corner<Point> corner;            // counterclockwise
  Per_corner<Point> direction;         // unit vector along side k, from corner k to the next one
  Per_corner<Index> label;             // of the corners
  std::vector<Voronoi_gate<NT>> gates; // counterclockwise from corner 0

  Half_plane<NT> outside(int k) const
  {
    const Point n = -1. * quarter_turn(direction[k]);
    return {n, dot(n, corner[k])};
  }

  NT side_length(int k) const { return length(corner[(k + 1) % 3] - corner[k]); }
  NT diameter() const { return (std::max)({side_length(0), side_length(1), side_length(2)}); }
  NT least_height() const { return CGAL::abs(cross(corner[1] - corner[0], corner[2] - corner[0])) / diameter(); }
  Point center() const { return (1. / 3) * (corner[0] + corner[1] + corner[2]); }

  // Largest distance of a corner from the center.
  NT radius() const
  {
    const Point c = center();
    return (std::max)({length(corner[0] - c), length(corner[1] - c), length(corner[2] - c)});
  }

  // True if the labels at the gates follow from those of the corners.
  bool is_consistent() const
  {
    Index at = label[0];
    std::size_t i = 0;
    for (int k = 0; k < 3; ++k)
    {
      if (at != label[k]) return false;
      for (; i < gates.size() && gates[i].side == k; at = gates[i++].to)
        if (gates[i].from != at || gates[i].to == at) return false;
    }
    return i == gates.size() && at == label[0];
  }

  // Divides the cell from the middle of its longest side to the opposite corner. changes(o, u, size, label at o, label at the end,
  // out) calls out(change) for the changes on the segment from o; new_node() is the number of a new gate.
  template <class Changes, class New_node>
  std::pair<Voronoi_cell<NT>, Voronoi_cell<NT>> divided(const Changes& changes, const New_node& new_node) const
  {
    CGAL_precondition(is_consistent());
    int k = side_length(1) > side_length(0) ? 1 : 0;
    if (side_length(2) > side_length(k)) k = 2;
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    const NT middle = side_length(k) / 2;
    const Point p = corner[k] + middle * direction[k], to_apex = corner[m] - p;
    const NT height = length(to_apex);
    const Point u = (1 / height) * to_apex;

    Voronoi_cell<NT> first, second;
    first.corner = {corner[k], p, corner[m]};
    first.direction = {direction[k], u, direction[m]};
    second.corner = {p, corner[l], corner[m]};
    second.direction = {direction[k], direction[l], -1. * u};

    // The gates before the middle decide its label.
    Index at = label[k];
    std::vector<Voronoi_gate<NT>> beyond[2]; // on the other two sides: l, m
    for (const Voronoi_gate<NT>& g : gates)
    {
      if (g.side != k)
      {
        beyond[g.side == l ? 0 : 1].push_back(g);
        continue;
      }
      const bool is_before = second.gates.empty() && dot(g.point - corner[k], direction[k]) < middle;
      if (is_before) at = g.to;
      (is_before ? first : second).gates.push_back({g.point, 0, g.from, g.to, g.node});
    }
    first.label = {label[k], at, label[m]};
    second.label = {at, label[l], label[m]};

    for (const Voronoi_gate<NT>& g : beyond[0]) second.gates.push_back({g.point, 1, g.from, g.to, g.node});
    const std::ptrdiff_t before_segment = std::ptrdiff_t(second.gates.size());
    changes(p, u, height, at, label[m], [&](const auto& change) {
      const Voronoi_gate<NT> g{p + change.t * u, 1, change.from, change.to, new_node()};
      first.gates.push_back(g);
      second.gates.push_back({g.point, 2, change.to, change.from, g.node});
    });
    std::reverse(second.gates.begin() + before_segment, second.gates.end());
    for (const Voronoi_gate<NT>& g : beyond[1]) first.gates.push_back({g.point, 2, g.from, g.to, g.node});
    CGAL_postcondition(first.is_consistent() && second.is_consistent());
    return {std::move(first), std::move(second)};
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
