// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_CONSTRUCT_GEODESIC_VORONOI_DIAGRAM_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_CONSTRUCT_GEODESIC_VORONOI_DIAGRAM_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/functions/One_call.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief is the type of the diagram that `construct_geodesic_voronoi_diagram()` returns.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParameters the type of the named parameters of the call
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
using Geodesic_voronoi_diagram_type = unspecified_type;
#else
using Geodesic_voronoi_diagram_type =
  Geodesic_voronoi_diagram<Geodesic_offset::internal::Surface_of<Geodesic_mesh_type<TriangleMesh, NamedParameters>>>;
#endif

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief computes the exact geodesic Voronoi diagram of sources.

The time is that of `geodesic_distances()` with kept windows, and of `Geodesic_distance_field::voronoi_diagram()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Sources the type of the sources, see `sources`
\tparam NamedParameters a sequence of named parameters
\param tm the mesh, which must outlive the diagram
\param sources the sources, in each form that `geodesic_distances()` accepts; the cells have the ids of the sources
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map, geom_traits, edge_length_map, edge_is_constrained_map, vertex_index_map, face_index_map}
    \cgalParamDescription{as in `Geodesic_mesh::Geodesic_mesh()`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor, concurrency_tag, verbose}
    \cgalParamDescription{as in `Surface_mesh_geodesic_offset::build()`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws std::logic_error if the visitor cancels the computation
\throws std::invalid_argument and other exceptions as `geodesic_distances()`
*/
template <class TriangleMesh, class Sources, class NamedParameters = parameters::Default_named_parameters>
Geodesic_voronoi_diagram_type<TriangleMesh, NamedParameters> construct_geodesic_voronoi_diagram(
  const TriangleMesh& tm, const Sources& sources, const NamedParameters& np = parameters::default_values())
{
  namespace internal = Geodesic_offset::internal;
  internal::check_named_parameters<internal::Voronoi_call_parameters, NamedParameters>();
  const internal::One_call<TriangleMesh, Sources, NamedParameters> call(tm, sources, np);
  auto request = call.request();
  request.keeps_windows = true;
  const auto build = call.template propagated<internal::KEPT_WINDOWS>(request);
  return Geodesic_voronoi_diagram_type<TriangleMesh, NamedParameters>(call.data(), *build);
}

} // namespace CGAL

#endif
