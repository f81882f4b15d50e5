// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for Index_renumbering.h.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_INDEX_RENUMBERING_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_INDEX_RENUMBERING_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Index_renumbering.h>
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

// Order of points along a Morton curve, so that consecutive points are mostly close. Unlike a Hilbert curve, it has jumps, but the
// computation takes a fraction of the time of the median searches in CGAL::hilbert_sort().
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

// True if the indices of neighbours are often far apart, from a sample of faces.
inline bool Index_renumbering::is_scattered(const All_face_links& links)
{
  constexpr std::size_t worthwhile = 1 << 14; // faces: smaller meshes fit in the caches
  constexpr std::size_t near = 1 << 10;       // index distance of neighbours that are likely to be cached together
  constexpr std::size_t sample = 1 << 12;     // faces
  if (links.size() < worthwhile) return false;
  const auto are_far = [](std::size_t i, std::size_t j) { return (i < j ? j - i : i - j) >= near; };
  const std::size_t step = (std::max)(std::size_t(1), links.size() / sample);
  std::size_t pairs = 0, far = 0;
  for (std::size_t f = 0; f < links.size(); f += step)
  {
    const Face_links& l = links[f];
    if (!l.is_face()) continue;
    for (std::size_t k = 0; k < 3; ++k)
    {
      far += l.beyond[k] != no_index && are_far(f, l.beyond[k]);
      far += are_far(l.source[k], l.source[(k + 1) % 3]);
    }
    pairs += 6;
  }
  return 4 * far > pairs;
}

template <class Team>
void Index_renumbering::renumber_if_scattered(const All_face_links& links, const std::vector<Index>& vertices,
                                              const Coordinates& coordinates, Team& team)
{
  if (!is_scattered(links)) return;
  m_vertex.assign(m_vertices_end, no_index);
  const Spatial_order order(vertices.size(), coordinates, team);
  for (std::size_t i = 0; i < vertices.size(); ++i) m_vertex[vertices[order[i]]] = Index(i);
  m_vertices_end = vertices.size();

  // order faces by the lowest index of their vertices
  std::vector<Index> first(m_vertices_end + 1, 0);
  m_face.assign(m_faces_end, no_index);
  for (std::size_t f = 0; f < links.size(); ++f)
  {
    const auto& v = links[f].source;
    if (links[f].is_face()) ++first[(m_face[f] = (std::min)({m_vertex[v[0]], m_vertex[v[1]], m_vertex[v[2]]})) + 1];
  }
  for (std::size_t i = 1; i <= m_vertices_end; ++i) first[i] += first[i - 1];
  m_faces_end = first.back();
  for (Index& f : m_face)
    if (f != no_index) f = first[f]++;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
