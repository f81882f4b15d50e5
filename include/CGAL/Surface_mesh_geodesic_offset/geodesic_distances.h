// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_DISTANCES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_DISTANCES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/functions/One_call.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/vertex_results.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief computes the exact geodesic distances of all vertices from the nearest source.

Vertices that no path reaches have the distance `Geodesic_distance_field::infinity()`. The time is that of setting up the mesh,
linear in its size, and of `Surface_mesh_geodesic_offset::build()`; for several calls with the same mesh, an object of this class
sets it up once.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Sources the type of the sources, see `sources`
\tparam VertexDistanceMap a model of `WritablePropertyMap` with the vertex descriptor as key and the number type of the traits as
        value
\tparam NamedParameters a sequence of named parameters
\param tm the mesh
\param sources the sources:
       a vertex; a location in a face; a point in space, which is located on the mesh; a `Geodesic_polyline`; a range of points in
       space, the vertices of one polyline, which is closed if its last point is the first one, see `polyline_closing()`; an
       edge; a range of edges, which are one source; a `Geodesic_source_set`; or a range of these, such as a range of vertices, each of which is a source of its
       own. Types that convert to a vertex descriptor, as the smart vertex handles of OpenMesh do, stand for it. Locations may
       have the coordinates of another kernel. Sources have the ids 0, 1, 2, ... in their order; those of a source set keep the
       ids that they have in the set.
\param distances the map that receives the distances
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map, geom_traits, edge_length_map, edge_is_constrained_map, vertex_index_map, face_index_map}
    \cgalParamDescription{as in `Geodesic_mesh::Geodesic_mesh()`; `Geodesic_mesh_type` has the default of the traits}
  \cgalParamNEnd
  \cgalParamNBegin{distance_limit, targets, visitor, relative_tolerance, merging_tolerance, concurrency_tag, verbose}
    \cgalParamDescription{as in `Surface_mesh_geodesic_offset::build()`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws std::invalid_argument and other exceptions as `Geodesic_mesh::Geodesic_mesh()`,
        `Surface_mesh_geodesic_offset::build()` and the functions of `Surface_mesh_geodesic_offset` that add sources
*/
template <class TriangleMesh, class Sources, class VertexDistanceMap,
          class NamedParameters = parameters::Default_named_parameters>
void geodesic_distances(const TriangleMesh& tm, const Sources& sources, VertexDistanceMap distances,
                        const NamedParameters& np = parameters::default_values())
{
  namespace internal = Geodesic_offset::internal;
  internal::check_named_parameters<internal::Distance_call_parameters, NamedParameters>();
  const internal::One_call<TriangleMesh, Sources, NamedParameters> call(tm, sources, np);
  const auto build = call.propagated(call.request());
  internal::write_vertex_distances(call.data(), *build, distances);
}

} // namespace CGAL

#endif
