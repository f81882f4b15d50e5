// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results of a build at all vertices, written to property maps.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_VERTEX_RESULTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_VERTEX_RESULTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Geodesic_mesh_data.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <cstddef>
#include <limits>

namespace CGAL::Geodesic_offset::internal {

// Label of vertices without a distance.
constexpr std::size_t no_source_label = (std::numeric_limits<std::size_t>::max)();

// The copy of a vertex with the least distance: the vertex itself unless it is on a barrier.
template <class FT, class Field>
Index nearest_copy(const Unfolded_mesh<FT>& mesh, const Field& field, Index v)
{
  Index nearest = v;
  mesh.for_each_copy(v, [&](Index w) {
    if (field.distance[w] < field.distance[nearest]) nearest = w;
  });
  return nearest;
}

template <class Surface, class Build, class VertexDistanceMap>
void write_vertex_distances(const Geodesic_mesh_data<Surface>& mesh, const Build& build, VertexDistanceMap map)
{
  const Surface& surface = mesh.surface();
  for (const auto v : vertices(surface.tm))
    put(map, v,
        typename Surface::FT(
          Surface::exported(build.field.distance_of_path(nearest_copy(surface.unfolded, build.field, surface.index_of(v))))));
}

template <class Surface, class Build, class VertexLabelMap>
void write_source_labels(const Geodesic_mesh_data<Surface>& mesh, const Build& build, VertexLabelMap map)
{
  const Surface& surface = mesh.surface();
  for (const auto v : vertices(surface.tm))
  {
    const Index i = nearest_copy(surface.unfolded, build.field, surface.index_of(v));
    const bool has_distance = Number_policy<typename Surface::Number>::is_finite(build.field.distance[i]);
    put(map, v, has_distance ? std::size_t(build.initial.source_of[build.field.source_ref[i].primitive()]) : no_source_label);
  }
}

} // namespace CGAL::Geodesic_offset::internal

#endif
