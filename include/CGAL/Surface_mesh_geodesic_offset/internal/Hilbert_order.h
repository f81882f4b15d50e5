// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order of points along a Hilbert curve: points that are near in it are near in space. Only roughly, but much faster
// than by CGAL::hilbert_sort(), which looks for medians: by the cells of a grid, and of a finer one where these are crowded.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_HILBERT_ORDER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_HILBERT_ORDER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Number_policy.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// The curve in a cube of eight: in which order it passes them, and how it lies in each.
class Hilbert_curve
{
public:
  static constexpr int levels = 8;

  // Where the curve comes to the cell (x, y, z) of a grid with 2^levels cells a side.
  static std::uint32_t place(std::uint32_t x, std::uint32_t y, std::uint32_t z)
  {
    const std::uint32_t corners = spread[x] | spread[y] << 1 | spread[z] << 2;
    std::uint32_t place = 0;
    unsigned state = 0;
    for (int bit = 3 * levels; bit > 0;)
    {
      bit -= 3;
      const Step step = steps[state + (corners >> bit & 7)];
      place = place << 3 | step.place;
      state = step.state;
    }
    return place;
  }

private:
  struct Step
  {
    unsigned char place = 0, state = 0;
  };

  // Of the curve that starts at the corner `start` and ends at that which differs from it along an axis.
  static constexpr unsigned state(unsigned start, unsigned axis) { return 8 * (8 * axis + start); }

  static constexpr unsigned turned(unsigned corner, unsigned axis) { return (corner << axis | corner >> (3 - axis)) & 7; }

  // The cells follow each other by the Gray code.
  static constexpr std::array<Step, 192> make_steps()
  {
    constexpr unsigned start_in[8] = {0, 0, 0, 3, 3, 6, 6, 5}, axis_in[8] = {0, 1, 1, 2, 2, 1, 1, 0};
    std::array<Step, 192> steps{};
    for (unsigned axis = 0; axis < 3; ++axis)
      for (unsigned start = 0; start < 8; ++start)
        for (unsigned i = 0; i < 8; ++i)
        {
          const unsigned turn = (axis + 1) % 3;
          Step& step = steps[state(start, axis) + (turned(i ^ i >> 1, turn) ^ start)];
          step.place = static_cast<unsigned char>(i);
          step.state = static_cast<unsigned char>(state(turned(start_in[i], turn) ^ start, (axis + axis_in[i] + 1) % 3));
        }
    return steps;
  }

  // Numbers with two zeros between each two bits.
  static constexpr std::array<std::uint32_t, (1 << levels)> make_spread()
  {
    std::array<std::uint32_t, (1 << levels)> spread{};
    for (std::uint32_t i = 0; i < spread.size(); ++i)
      for (int bit = 0; bit < levels; ++bit) spread[i] |= (i >> bit & 1) << 3 * bit;
    return spread;
  }

  static const std::array<Step, 192> steps;
  static const std::array<std::uint32_t, (1 << levels)> spread;
};

inline constexpr std::array<Hilbert_curve::Step, 192> Hilbert_curve::steps = Hilbert_curve::make_steps();
inline constexpr std::array<std::uint32_t, (1 << Hilbert_curve::levels)> Hilbert_curve::spread =
  Hilbert_curve::make_spread();

class Hilbert_order
{
public:
  typedef std::array<double, 3> Point;

  // Finite coordinates.
  explicit Hilbert_order(const std::vector<Point>& points)
    : m_points(points), m_items(points.size()), m_buffer(points.size())
  {
    for (std::size_t i = 0; i < points.size(); ++i) m_items[i] = i;
    sort(0, points.size());
  }

  // Of the i-th point on the curve, the index.
  std::size_t operator[](std::size_t i) const { return std::size_t(index_of(m_items[i])); }

private:
  enum
  {
    levels = Hilbert_curve::levels, // most cells of a mesh with a million vertices are not crowded then
    crowd = 64,                     // points in a cell
    digit = 3 * levels / 2          // bits to sort by at once
  };

  typedef std::uint64_t Item; // place on the curve and index

  static Item index_of(Item item) { return item & 0xffffffffu; }
  static Item place_of(Item item) { return item >> 32; }

  void sort(std::size_t first, std::size_t last)
  {
    if (!find_places(first, last)) return;
    if (last - first < std::size_t(1) << digit) std::sort(m_items.begin() + first, m_items.begin() + last);
    else
    {
      sort_by_digit(m_items, m_buffer, first, last, 32);
      sort_by_digit(m_buffer, m_items, first, last, 32 + digit);
    }
    for (std::size_t i = first; i < last;)
    {
      std::size_t end = i + 1;
      while (end < last && place_of(m_items[end]) == place_of(m_items[i])) ++end;
      if (end - i > crowd) sort(i, end);
      i = end;
    }
  }

  // Returns whether there is more than one place.
  bool find_places(std::size_t first, std::size_t last)
  {
    if (first == last) return false;
    Point low = m_points[index_of(m_items[first])], high = low;
    for (std::size_t i = first; i < last; ++i)
    {
      const Point& p = m_points[index_of(m_items[i])];
      for (int k = 0; k < 3; ++k)
      {
        low[k] = (std::min)(low[k], p[k]);
        high[k] = (std::max)(high[k], p[k]);
      }
    }
    const double extent = (std::max)({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    if (!(extent > 1e-300) || !std::isfinite(extent)) return false;
    const double scale = ((1 << levels) - 0.5) / extent;
    for (std::size_t i = first; i < last; ++i)
    {
      const Item index = index_of(m_items[i]);
      const auto cell = [&](int k) { return std::uint32_t(std::int32_t((m_points[index][k] - low[k]) * scale)); };
      m_items[i] = Item(Hilbert_curve::place(cell(0), cell(1), cell(2))) << 32 | index;
    }
    return true;
  }

  // Leaves in order what has the same digit.
  static void sort_by_digit(const std::vector<Item>& from, std::vector<Item>& to, std::size_t first, std::size_t last,
                            int shift)
  {
    constexpr Item mask = (Item(1) << digit) - 1;
    std::array<Index, (std::size_t(1) << digit)> next{};
    for (std::size_t i = first; i < last; ++i) ++next[from[i] >> shift & mask];
    Index sum = Index(first);
    for (Index& n : next)
    {
      const Index count = n;
      n = sum;
      sum += count;
    }
    for (std::size_t i = first; i < last; ++i) to[next[from[i] >> shift & mask]++] = from[i];
  }

  const std::vector<Point>& m_points;
  std::vector<Item> m_items, m_buffer;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
