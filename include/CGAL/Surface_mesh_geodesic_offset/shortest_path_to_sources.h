// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_SHORTEST_PATH_TO_SOURCES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_SHORTEST_PATH_TO_SOURCES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/functions/One_call.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Path_visits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief computes a shortest path on the surface from a point to the nearest source.

The path consists of the point itself, a point on each edge that the path crosses, the vertices through which it passes, and
the source point. It is empty if no path reaches the point, and only the point if the point lies on a source. The propagation
stops once the distance of the point is final; otherwise the time is that of `geodesic_distances()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Sources the type of the sources, see `sources`
\tparam From a vertex descriptor, a location in a face, or a point in space
\tparam OutputIterator an output iterator for locations (`Geodesic_mesh::Face_location`), or for points in space
        (`Geodesic_mesh::Point_3`)
\tparam NamedParameters a sequence of named parameters
\param tm the mesh
\param from the start of the path; a point in space is located on the mesh
\param sources the sources, in each form that `geodesic_distances()` accepts
\param out the output iterator
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map, geom_traits, edge_length_map, edge_is_constrained_map, vertex_index_map, face_index_map}
    \cgalParamDescription{as in `Geodesic_mesh::Geodesic_mesh()`}
  \cgalParamNEnd
  \cgalParamNBegin{distance_limit, visitor, concurrency_tag, verbose}
    \cgalParamDescription{as in `Surface_mesh_geodesic_offset::build()`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws std::invalid_argument and other exceptions as `geodesic_distances()`; std::invalid_argument also if `from` is not valid
*/
template <class TriangleMesh, class From, class Sources, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
OutputIterator shortest_path_to_sources(const TriangleMesh& tm, const From& from, const Sources& sources, OutputIterator out,
                                        const NamedParameters& np = parameters::default_values())
{
  namespace internal = Geodesic_offset::internal;
  typedef internal::One_call<TriangleMesh, Sources, NamedParameters> Call;
  typedef typename Call::Number Number;
  internal::check_named_parameters<internal::Path_call_parameters, NamedParameters>();
  const Call call(tm, sources, np);
  const auto start = internal::classified_start(call.mesh(), from);
  auto request = call.request();
  request.keeps_windows = start.kind != internal::Surface_point<Number>::VERTEX;
  request.targets.push_back(start);
  const auto build = call.template propagated<internal::KEPT_WINDOWS>(request);
  const auto& surface = call.data().surface();
  const auto write = [&](const auto& p) {
    if constexpr (std::is_assignable<decltype(*out++), typename Call::Mesh::Face_location>::value) *out++ = surface.location(p);
    else *out++ = surface.point(p);
  };
  internal::visit_path(*build, start, build->path_start(start), write);
  return out;
}

} // namespace CGAL

#endif
