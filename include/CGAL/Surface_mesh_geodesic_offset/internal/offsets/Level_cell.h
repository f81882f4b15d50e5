// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A triangle in which a level is traced: a face, or a part of it. The level crosses the sides of a cell at gates. Gates are
// ordered, and alternate between starts and ends of chains, so the chains of neighbouring cells always fit together.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_CELL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_CELL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Window_cone.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// A crossing of the level with a side of a cell. A chain starts at a gate where the distance rises above the level,
// counterclockwise along the boundary.
template <class FT>
struct Level_gate
{
  Point_in_face<FT> point;
  unsigned char side; // of the cell; for a face, its halfedge
  bool is_start;
  Index id;
};

template <class FT>
struct Level_cell
{
  typedef Point_in_face<FT> Point;
  typedef Level_gate<FT> Gate;

  Per_corner<Point> corner;    // counterclockwise
  Per_corner<Point> direction; // unit vector along side k, from corner k to the next one
  Per_corner<bool> is_near;    // per corner
  std::vector<Gate> gates;     // counterclockwise from corner 0

  Half_plane<FT> outside(int k) const
  {
    const Point n = quarter_turn(direction[k]);
    return {n, dot(n, corner[k])};
  }

  // Normal of side k, into the cell.
  Point inwards(int k) const { return quarter_turn(direction[k]); }

  // Depth of p inside the cell.
  FT depth(const Point& p) const { return (std::min)({height(0, p), height(1, p), height(2, p)}); }

  FT height(int k, const Point& p) const { return cross(direction[k], p - corner[k]); }

  FT side_length(int k) const { return length(corner[(k + 1) % 3] - corner[k]); }

  FT diameter() const { return (std::max)({side_length(0), side_length(1), side_length(2)}); }

  // The least distance of a corner from the opposite side.
  FT height() const
  {
    const FT d = diameter();
    return CGAL::is_positive(d) ? FT(CGAL::abs(cross(corner[1] - corner[0], corner[2] - corner[0])) / d) : d;
  }

  int longest_side() const
  {
    int k = side_length(1) > side_length(0) ? 1 : 0;
    return side_length(2) > side_length(k) ? 2 : k;
  }

  // True if gates alternate and a side has an odd number of them exactly if its ends differ.
  bool is_consistent() const
  {
    bool near = is_near[0];
    std::size_t i = 0;
    for (int k = 0; k < 3; ++k)
    {
      if (near != is_near[k]) return false;
      for (; i < gates.size() && gates[i].side == k; ++i, near = !near)
        if (gates[i].is_start != near) return false;
    }
    return i == gates.size() && near == is_near[0];
  }

  // Divides the cell from the middle of its longest side to the opposite corner. `crossings(o, u, length, near at o, near at
  // the end, out)` calls out(t, falling) for the gates on the segment from o; new_id() returns the number of a new gate.
  template <class Crossings, class New_id>
  std::pair<Level_cell, Level_cell> divided(const Crossings& crossings, const New_id& new_id) const
  {
    CGAL_precondition(is_consistent());
    const int k = longest_side(), l = (k + 1) % 3, m = (k + 2) % 3;
    const FT middle = side_length(k) / FT(2);
    const Point p = corner[k] + middle * direction[k];

    Level_cell first, second;
    const Point to_apex = corner[m] - p;
    const FT height = length(to_apex);
    const Point u = (FT(1) / height) * to_apex;
    first.corner = {corner[k], p, corner[m]};
    first.direction = {direction[k], u, direction[m]};
    second.corner = {p, corner[l], corner[m]};
    second.direction = {direction[k], direction[l], FT(-1) * u};

    // The preceding gates decide whether the middle of the side is near.
    bool near = is_near[k];
    std::vector<Gate> beyond[2]; // on the other two sides: l, m
    for (const Gate& g : gates)
    {
      if (g.side == k)
      {
        const bool before = second.gates.empty() && dot(g.point - corner[k], direction[k]) < middle;
        if (before) near = !near;
        (before ? first : second).gates.push_back({g.point, 0, g.is_start, g.id});
      }
      else beyond[g.side == l ? 0 : 1].push_back(g);
    }
    first.is_near = {is_near[k], near, is_near[m]};
    second.is_near = {near, is_near[l], is_near[m]};

    for (const Gate& g : beyond[0]) second.gates.push_back({g.point, 1, g.is_start, g.id});
    const std::size_t before_segment = second.gates.size();
    crossings(p, u, height, near, is_near[m], [&](const FT& t, bool falling) {
      const Gate g{p + t * u, 1, !falling, new_id()};
      first.gates.push_back(g);
      second.gates.push_back({g.point, 2, falling, g.id});
    });
    std::reverse(second.gates.begin() + std::ptrdiff_t(before_segment), second.gates.end());
    for (const Gate& g : beyond[1]) first.gates.push_back({g.point, 2, g.is_start, g.id});
    CGAL_postcondition(first.is_consistent() && second.is_consistent());
    return {std::move(first), std::move(second)};
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
