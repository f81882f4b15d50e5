// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Order of points along a Morton curve, so that consecutive points are mostly close. Unlike a Hilbert curve, it has jumps,
// but the computation takes a fraction of the time of the median searches in CGAL::hilbert_sort().

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SPATIAL_ORDER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SPATIAL_ORDER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/assertions.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

class Spatial_order
{
public:
  typedef Per_corner<double> Point; // three coordinates

  // Order of n points; point(i) has finite coordinates.
  template <class Function, class Team>
  Spatial_order(std::size_t n, const Function& point, Team& team) : m_items(n)
  {
    const Blocks blocks(n, team.size());
    std::vector<Box> boxes(blocks.number());
    blocks.for_each(team, [&](Index block, std::size_t begin, std::size_t end) {
      Box box;
      for (std::size_t i = begin; i < end; ++i)
      {
        const Point p = point(i);
        box.add(p, p);
      }
      boxes[block] = box;
    });
    Box all;
    for (const Box& b : boxes) all.add(b.low, b.high);
    const double extent = all.extent();
    const double scale = double(largest) / extent; // infinite for a single point, or on overflow: then no order
    const bool has_order = std::isfinite(scale) && std::isfinite(extent);
    blocks.for_each(team, [&](Index, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Point p = point(i);
        std::uint64_t key = 0;
        if (has_order)
          for (int k = 0; k < 3; ++k) key |= spread(std::uint64_t((p[k] - all.low[k]) * scale)) << k;
        m_items[i] = {key, Index(i)};
      }
    });
    boost::sort::spreadsort::integer_sort(
      m_items.begin(), m_items.end(), [](const Item& i, unsigned shift) { return i.key >> shift; },
      [](const Item& i, const Item& j) { return i.key < j.key; });
  }

  // Index of the i-th point on the curve.
  Index operator[](std::size_t i) const { return m_items[i].index; }

private:
  static constexpr std::uint64_t largest = (std::uint64_t(1) << 21) - 1;

  struct Box
  {
    Point low, high;

    Box()
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      low = Point(infinity, infinity, infinity);
      high = Point(-infinity, -infinity, -infinity);
    }
    void add(const Point& p, const Point& q)
    {
      for (int k = 0; k < 3; ++k)
      {
        low[k] = (std::min)(low[k], p[k]);
        high[k] = (std::max)(high[k], q[k]);
      }
    }
    double extent() const { return (std::max)({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }
  };

  struct Item
  {
    std::uint64_t key;
    Index index;
  };

  // Inserts two zero bits between adjacent bits of a 21-bit number.
  static std::uint64_t spread(std::uint64_t i)
  {
    CGAL_precondition(i <= largest);
    i = (i | i << 32) & 0x001f00000000ffff;
    i = (i | i << 16) & 0x001f0000ff0000ff;
    i = (i | i << 8) & 0x100f00f00f00f00f;
    i = (i | i << 4) & 0x10c30c30c30c30c3;
    return (i | i << 2) & 0x1249249249249249;
  }

  std::vector<Item> m_items;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
