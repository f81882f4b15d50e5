// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Border edges at the same place, exactly or within a tolerance, in time O(n log n).

#ifndef GEODESIC_OFFSET_BORDER_STITCHING_H
#define GEODESIC_OFFSET_BORDER_STITCHING_H

#include "soup.h"

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace geodesic_offset {

// Which border edges become one edge.
struct Border_joining
{
  bool is_on = true; // those at the same place
  double tolerance = 0; // largest distance of points at the same place
};

// Two border edges are at the same place if their ends are, in either order. Edges of length zero, or whose ends are connected by
// border vertices within the tolerance of each other, have no place.
class Border_stitching
{
  using Border_edge = std::array<std::uint32_t, 2>;

  const std::vector<Point>& m_points;
  double m_tolerance;
  std::function<bool(std::uint32_t, std::uint32_t)> m_has_edge;
  std::vector<std::uint32_t> m_root; // a forest of points, whose roots have the smallest indices
  bool m_is_needed = false; // whether points become one vertex
  std::size_t m_pairs = 0;
  double m_largest_gap = 0;

public:
  // edges: pairs of points; tolerance: the largest distance between points at the same place; has_edge(i, j) for i < j:
  // whether an edge connects two points at different places, so that faces would vanish if they became one.
  Border_stitching(const std::vector<Point>& points, std::vector<Border_edge> edges, double tolerance,
                   std::function<bool(std::uint32_t, std::uint32_t)> has_edge)
    : m_points(points), m_tolerance(tolerance), m_has_edge(std::move(has_edge)), m_root(identity())
  {
    const std::vector<std::uint32_t> place = places(edges);
    const auto key = [&](const Border_edge& e) { return std::make_pair(place[e[0]], place[e[1]]); };
    const auto has_no_place = [&](const Border_edge& e) { return place[e[0]] == place[e[1]]; };
    edges.erase(std::remove_if(edges.begin(), edges.end(), has_no_place), edges.end());
    for(Border_edge& e : edges)
      if(place[e[1]] < place[e[0]]) std::swap(e[0], e[1]);
    std::sort(edges.begin(), edges.end(), [&](const Border_edge& e, const Border_edge& f) {
      return key(e) != key(f) ? key(e) < key(f) : points[e[0]].x() < points[f[0]].x();
    });
    for(std::size_t i = 0, end = 0; i < edges.size(); i = end)
    {
      while(end < edges.size() && key(edges[end]) == key(edges[i])) ++end;
      join(edges, i, end);
    }
  }

  bool is_needed() const { return m_is_needed; }

  // Number of pairs of edges at the same place. Of three such edges, two are a pair.
  std::size_t number_of_pairs() const { return m_pairs; }

  // Largest distance between ends of edges at the same place.
  double largest_gap() const { return m_largest_gap; }

  // The first one of the points that become one vertex with the point i.
  std::uint32_t operator()(std::uint32_t i) { return root(m_root, i); }

private:
  std::vector<std::uint32_t> identity() const
  {
    std::vector<std::uint32_t> indices(m_points.size());
    std::iota(indices.begin(), indices.end(), std::uint32_t(0));
    return indices;
  }

  static std::uint32_t root(std::vector<std::uint32_t>& forest, std::uint32_t i)
  {
    while(forest[i] != i) i = forest[i] = forest[forest[i]];
    return i;
  }

  static void unite(std::vector<std::uint32_t>& forest, std::uint32_t i, std::uint32_t j)
  {
    i = root(forest, i);
    j = root(forest, j);
    forest[std::max(i, j)] = std::min(i, j);
  }

  double distance(std::uint32_t i, std::uint32_t j) const
  {
    return std::sqrt(CGAL::squared_distance(m_points[i], m_points[j]));
  }

  bool is_near(std::uint32_t i, std::uint32_t j) const { return distance(i, j) <= m_tolerance; }

  bool may_join(std::uint32_t i, std::uint32_t j) const
  {
    return is_near(i, j) && (m_points[i] == m_points[j] || !m_has_edge(std::min(i, j), std::max(i, j)));
  }

  // For each end of an edge, a point that stands for all those connected with it by steps within the tolerance.
  std::vector<std::uint32_t> places(const std::vector<Border_edge>& edges) const
  {
    std::vector<std::uint32_t> ends, place = identity();
    for(const Border_edge& e : edges) ends.insert(ends.end(), e.begin(), e.end());
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    if(m_tolerance == 0)
    {
      std::map<Point, std::uint32_t> at;
      for(std::uint32_t i : ends) place[i] = at.emplace(m_points[i], i).first->second;
      return place;
    }
    // cells of a grid: points within the tolerance are in the same cell or in neighbouring ones
    using Cell = std::array<double, 3>;
    std::map<Cell, std::vector<std::uint32_t>> cells;
    const auto cell_of = [&](const Point& p) {
      return Cell{std::floor(p.x() / m_tolerance), std::floor(p.y() / m_tolerance), std::floor(p.z() / m_tolerance)};
    };
    for(std::uint32_t i : ends)
    {
      const Cell cell = cell_of(m_points[i]);
      for(int n = 0; n < 27; ++n)
      {
        const auto neighbour = cells.find({cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1});
        if(neighbour == cells.end()) continue;
        for(std::uint32_t j : neighbour->second)
          if(is_near(i, j)) unite(place, i, j);
      }
      cells[cell].push_back(i);
    }
    for(std::uint32_t i : ends) place[i] = root(place, i);
    return place;
  }

  // Joins the edges [begin, end) at two places, which are sorted by x of their first ends.
  void join(const std::vector<Border_edge>& edges, std::size_t begin, std::size_t end)
  {
    std::vector<bool> is_joined(end - begin, false);
    for(std::size_t i = begin; i < end; ++i)
      for(std::size_t j = i + 1; j < end && m_points[edges[j][0]].x() - m_points[edges[i][0]].x() <= m_tolerance; ++j)
      {
        if(!may_join(edges[i][0], edges[j][0]) || !may_join(edges[i][1], edges[j][1])) continue;
        is_joined[i - begin] = is_joined[j - begin] = true;
        for(std::size_t k : {0, 1})
        {
          m_largest_gap = std::max(m_largest_gap, distance(edges[i][k], edges[j][k]));
          unite(m_root, edges[i][k], edges[j][k]);
        }
        if(m_tolerance == 0) break; // the next edge joins the others
      }
    const auto joined = std::count(is_joined.begin(), is_joined.end(), true);
    m_is_needed = m_is_needed || joined != 0;
    m_pairs += static_cast<std::size_t>(joined) / 2;
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_BORDER_STITCHING_H
