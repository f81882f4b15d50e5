// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The labels of cells: ids of sources, of which those that coincide up to rounding, or have a point or a segment in common,
// count as that with the smallest id there.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_SOURCE_LABELS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_SOURCE_LABELS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Coinciding_places.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Source_labels
{
public:
  Source_labels(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_field(field)
  {
    const double tolerance = Voronoi_tolerances<double>::same_source(size());
    Coinciding_places<FT> places(mesh, tolerance);
    struct Entry
    {
      double start_value;
      Index smallest; // id
    };
    std::map<std::pair<Index, Index>, std::vector<Entry>> entries; // by the numbers of the ends
    std::vector<std::pair<std::vector<Entry>*, std::size_t>> entry_of;
    for (std::size_t i = 0; i < initial.primitives.size(); ++i)
    {
      const Index first = places.number_of(initial.places[i].first),
                  second = initial.primitives[i].is_segment ? places.number_of(initial.places[i].second) : first;
      std::vector<Entry>& known = entries[std::minmax(first, second)];
      const double start = CGAL::to_double(initial.start_values.of(Source_ref(Index(i), Source_side::NONE)));
      auto entry =
        std::find_if(known.begin(), known.end(), [&](const Entry& e) { return CGAL::abs(e.start_value - start) <= tolerance; });
      if (entry == known.end()) entry = known.insert(entry, {start, initial.source_of[i]});
      entry->smallest = (std::min)(entry->smallest, initial.source_of[i]);
      entry_of.emplace_back(&known, std::size_t(entry - known.begin()));
    }
    for (const auto& [known, i] : entry_of) m_label.push_back((*known)[i].smallest);
  }

  // no_index for a vertex without a distance.
  Index of_vertex(Index v) const
  {
    return m_field.source_ref[v].is_valid() ? m_label[m_field.source_ref[v].primitive()] : no_index;
  }

  // A window behind a pseudo-source has the label of this vertex, also if several sources are equally near to it.
  template <class Window>
  Index of_window(const Window& w) const
  {
    const Index v = w.pseudo_source();
    return v == no_index || Merge_error_code::is_merged(v) ? m_label[w.source_ref.primitive()] : of_vertex(v);
  }

private:
  // The longest edge and the largest distance of a vertex.
  double size() const
  {
    double largest = 0;
    for (const FT& d : m_field.distance)
      if (Number_policy<FT>::is_finite(d)) largest = (std::max)(largest, CGAL::to_double(d));
    return CGAL::to_double(m_mesh.longest_edge()) + largest;
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Geodesic_field<FT>& m_field;
  std::vector<Index> m_label; // per primitive
};

} // namespace CGAL::Geodesic_offset::internal

#endif
