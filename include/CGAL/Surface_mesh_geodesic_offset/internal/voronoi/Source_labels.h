// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The labels of cells: ids of sources, of which those that coincide, or have a point or a segment in common, count as that with
// the smallest id there.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_SOURCE_LABELS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_SOURCE_LABELS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Source_labels
{
public:
  Source_labels(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_field(field)
  {
    std::map<std::tuple<Place, Place, FT>, Index> smallest;
    std::vector<decltype(smallest.begin())> at;
    for (std::size_t i = 0; i < initial.primitives.size(); ++i)
    {
      Place first = place(initial.places[i].first), second = place(initial.places[i].second);
      if (!initial.primitives[i].is_segment) second = first;
      if (second < first) std::swap(first, second);
      const FT start = initial.start_values.of(Source_ref(Index(i), Source_side::NONE));
      const auto entry = smallest.emplace(std::make_tuple(first, second, start), initial.source_of[i]).first;
      entry->second = (std::min)(entry->second, initial.source_of[i]);
      at.push_back(entry);
    }
    for (const auto& entry : at) m_label.push_back(entry->second);
  }

  // no_index for a vertex without a distance.
  Index of_vertex(Index v) const
  {
    return m_field.source_ref[v].is_valid() ? m_label[m_field.source_ref[v].primitive()] : no_index;
  }

  // A window behind a pseudo-source has the label of this vertex, also if several sources are equally near to it.
  Index of_window(const Face_window<FT>& w) const
  {
    const Index v = w.pseudo_source();
    return v == no_index || Merge_error_code::is_merged(v) ? m_label[w.source_ref.primitive()] : of_vertex(v);
  }

private:
  typedef std::tuple<int, Index, FT, FT> Place;

  Place place(const Surface_point<FT>& p) const
  {
    if (p.kind == Surface_point<FT>::VERTEX) return Place(p.kind, p.element, FT(0), FT(0));
    if (p.kind == Surface_point<FT>::FACE) return Place(p.kind, p.element, p.x, p.y);
    const Index twin = m_mesh.twin(p.element);
    if (twin == no_index || p.element < twin) return Place(p.kind, p.element, p.x, FT(0));
    return Place(p.kind, twin, FT(m_mesh[twin].length - p.x), FT(0));
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Geodesic_field<FT>& m_field;
  std::vector<Index> m_label; // per primitive
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
