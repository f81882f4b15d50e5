// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which windows may become one: those of one source, unless another source shares a segment with it.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_MERGING_GROUPS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_MERGING_GROUPS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Coinciding_places.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// The windows of two segments in line have the same distances, but where one of them is a segment of another source, too, or a
// point of it up to rounding, they may be of different cells of the Voronoi diagram, so such segments are groups of their own.
//
// Segments coincide here if their ends are no farther apart than 2^-43 of the longest edge times the number of faces plus the
// latest start value: more than Voronoi_tolerances::same_source(), since no distance is larger than this. More groups only keep
// more windows. Binding test: test_voronoi_diagram, shared segments.
template <class FT>
std::vector<Index> merging_groups(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial)
{
  std::vector<Index> group(initial.source_of);
  const std::size_t n = group.size();
  const bool has_two_sources =
    std::adjacent_find(group.begin(), group.end(), [](Index a, Index b) { return a != b; }) != group.end();
  const bool has_segments =
    std::any_of(initial.primitives.begin(), initial.primitives.end(), [](const auto& p) { return p.is_segment; });
  if (!has_two_sources || !has_segments) return group;
  const double longest = CGAL::to_double(mesh.longest_edge()) * double(mesh.number_of_faces() + 1);
  double latest = 0;
  for (std::size_t i = 0; i < n; ++i)
    latest = (std::max)(latest, CGAL::to_double(initial.start_values.of(Source_ref(Index(i), Source_side::NONE))));
  constexpr double tolerance = double(1 << 9) * std::numeric_limits<double>::epsilon();
  Coinciding_places<FT> places(mesh, tolerance * (longest + latest));
  std::map<std::pair<Index, Index>, Index> source_at; // by the numbers of the ends; no_index: several
  std::vector<std::pair<Index, Index>> ends(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const Index first = places.number_of(initial.places[i].first),
                second = initial.primitives[i].is_segment ? places.number_of(initial.places[i].second) : first;
    ends[i] = std::minmax({first, second});
    const auto known = source_at.emplace(ends[i], group[i]).first;
    if (known->second != group[i]) known->second = no_index;
  }
  const Index sources = *std::max_element(group.begin(), group.end()) + 1;
  for (std::size_t i = 0; i < n; ++i)
    if (initial.primitives[i].is_segment && source_at[ends[i]] == no_index) group[i] = sources + Index(i);
  return group;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
