// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The levels of a split. Where levels are so near to each other that their points count as one, the curves of the smallest level
// stand for those of all of them.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_SPLIT_LEVELS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_SPLIT_LEVELS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Split_lengths.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Split_levels
{
public:
  // `distances`: of all curves, in any order.
  Split_levels(std::vector<FT> distances, double diagonal)
    : m_distances(std::move(distances)), m_least_gap(Split_lengths::least_gap_part * diagonal)
  {
    std::sort(m_distances.begin(), m_distances.end());
    m_distances.erase(std::unique(m_distances.begin(), m_distances.end()), m_distances.end());
    FT last(0); // the sources
    for (std::size_t i = 0; i < m_distances.size(); ++i)
    {
      if (!(m_distances[i] - last > m_least_gap)) continue;
      last = m_distances[i];
      m_first.push_back(i);
    }
    m_first.push_back(m_distances.size());
  }

  // Index of a distance among those whose curves split the mesh, by increasing distance; none for other distances.
  std::optional<std::size_t> index_of(const FT& distance) const
  {
    const auto i = std::size_t(std::lower_bound(m_distances.begin(), m_distances.end(), distance) - m_distances.begin());
    const auto first = std::lower_bound(m_first.begin(), m_first.end(), i);
    if (*first != i) return std::nullopt;
    return std::size_t(first - m_first.begin());
  }

  // The number of distances that points beyond `splitting` of the curves that split are not nearer than.
  std::size_t band_behind(std::size_t splitting) const { return m_first[splitting]; }

  // The number of distances that are not greater than that of a region; curves within the least gap of the sources are points.
  template <class T>
  std::size_t band_at(const T& d) const
  {
    const auto number = [&](const auto& distance) {
      return std::size_t(std::upper_bound(m_distances.begin(), m_distances.end(), distance) - m_distances.begin());
    };
    return d < m_least_gap ? number(m_least_gap) : number(d);
  }

private:
  std::vector<FT> m_distances; // by increasing distance
  const FT m_least_gap;
  std::vector<std::size_t> m_first; // indices of the distances whose curves split; at the end, their number
};

} // namespace CGAL::Geodesic_offset::internal

#endif
