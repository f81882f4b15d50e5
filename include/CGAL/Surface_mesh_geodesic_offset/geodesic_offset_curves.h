// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_OFFSET_CURVES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_OFFSET_CURVES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_curve.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/functions/One_call.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/functions/cut_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <algorithm>
#include <initializer_list>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief is the type of the curves that `geodesic_offset_curves()` writes.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParameters the type of the named parameters of the call
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
using Geodesic_offset_curve_type = unspecified_type;
#else
using Geodesic_offset_curve_type =
  Geodesic_offset_curve<Geodesic_offset::internal::Surface_of<Geodesic_mesh_type<TriangleMesh, NamedParameters>>>;
#endif

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief computes the offset curves of sources at one or several distances, exact unless there is a tolerance.

Curves come by increasing distance. Nothing is computed beyond the largest level, or beyond a distance limit that is less, or
beyond the first level larger than all start values at which the selected sides have no curves.
The time is that of setting up the mesh, linear in its size, and of
`Surface_mesh_geodesic_offset::build_with_offset_curves()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Sources the type of the sources, see `sources`
\tparam Levels a number type, a model of `ConstRange` with numbers as values, or an instance of `Offset_levels`
\tparam OutputIterator an output iterator for `Geodesic_offset_curve_type<TriangleMesh, NamedParameters>`
\tparam NamedParameters a sequence of named parameters
\param tm the mesh, which must outlive the curves
\param sources the sources, in each form that `geodesic_distances()` accepts
\param levels a distance, a range of distances such as `{1., 2.}`, or an `Offset_levels` object
\param out the output iterator
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map, geom_traits, edge_length_map, edge_is_constrained_map, vertex_index_map, face_index_map}
    \cgalParamDescription{as in `Geodesic_mesh::Geodesic_mesh()`}
  \cgalParamNEnd
  \cgalParamNBegin{distance_limit, visitor, relative_tolerance, merging_tolerance, concurrency_tag, verbose}
    \cgalParamDescription{as in `Surface_mesh_geodesic_offset::build()`}
  \cgalParamNEnd
  \cgalParamNBegin{offset_side, end_style}
    \cgalParamDescription{as in `Surface_mesh_geodesic_offset::build_with_offset_curves()`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws std::invalid_argument and other exceptions as `geodesic_distances()` and
        `Surface_mesh_geodesic_offset::build_with_offset_curves()`
*/
template <class TriangleMesh, class Sources, class Levels = std::initializer_list<double>, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
OutputIterator geodesic_offset_curves(const TriangleMesh& tm, const Sources& sources, const Levels& levels, OutputIterator out,
                                      const NamedParameters& np = parameters::default_values())
{
  namespace internal = Geodesic_offset::internal;
  typedef internal::One_call<TriangleMesh, Sources, NamedParameters> Call;
  internal::check_named_parameters<internal::Offset_call_parameters, NamedParameters>();
  const auto wanted = internal::offset_levels<typename Call::Surface>(levels);
  const Call call(tm, sources, np);
  auto request = call.request();
  if (!wanted.is_unlimited() && wanted.size() > 0) request.maximum = (std::min)(request.maximum, wanted[wanted.size() - 1]);
  auto build = call.build(request);
  const auto write = internal::curve_writer<Geodesic_offset_curve_type<TriangleMesh, NamedParameters>>(out);
  internal::propagate_and_cut<typename Call::Concurrency_tag, Call::parts>(call.data(), build, wanted,
                                                                           internal::offset_selection(np), true, write);
  internal::report(build.statistics, np);
  return out;
}

} // namespace CGAL

#endif
