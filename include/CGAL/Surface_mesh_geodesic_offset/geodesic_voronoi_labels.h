// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_VORONOI_LABELS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_VORONOI_LABELS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/functions/One_call.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/vertex_results.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief computes the nearest source of each vertex. The cells of sources also divide faces, see
`construct_geodesic_voronoi_diagram()`.

The label of a vertex is the id of its nearest source. Vertices that no path reaches have the label
`Geodesic_distance_field::no_source()`. The time is that of `geodesic_distances()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Sources the type of the sources, see `sources`
\tparam VertexLabelMap a model of `WritablePropertyMap` with the vertex descriptor as key and `std::size_t` as value
\tparam NamedParameters a sequence of named parameters
\param tm the mesh
\param sources the sources, in each form that `geodesic_distances()` accepts
\param labels the map that receives the labels
\param np an optional sequence of named parameters, those of `geodesic_distances()`
\throws std::invalid_argument and other exceptions as `geodesic_distances()`
*/
template <class TriangleMesh, class Sources, class VertexLabelMap, class NamedParameters = parameters::Default_named_parameters>
void geodesic_voronoi_labels(const TriangleMesh& tm, const Sources& sources, VertexLabelMap labels,
                             const NamedParameters& np = parameters::default_values())
{
  namespace internal = Geodesic_offset::internal;
  internal::check_named_parameters<internal::Distance_call_parameters, NamedParameters>();
  const internal::One_call<TriangleMesh, Sources, NamedParameters> call(tm, sources, np);
  const auto build = call.propagated(call.request());
  internal::write_source_labels(call.data(), *build, labels);
}

} // namespace CGAL

#endif
