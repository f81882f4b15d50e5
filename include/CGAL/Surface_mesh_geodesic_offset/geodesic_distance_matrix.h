// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_DISTANCE_MATRIX_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_DISTANCE_MATRIX_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/functions/Build_series.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief computes the exact geodesic distances of many targets from many sources, and hands a row per source to a function object.

A row takes the time of a build that stops when the distances of all targets are final. With a distance limit, this is the time of
what is within the limit, whatever the size of the mesh. Memory is that of a front and of a row per thread. A `Geodesic_mesh` keeps
the memory of the fronts, some 100 bytes per vertex and thread, for later calls of this function and of `geodesic_distance()`;
another mesh is set up in linear time. The result does not depend on the number of threads.

\tparam Mesh a model of `FaceListGraph`, or an instance of `Geodesic_mesh`, with the number type `FT`
\tparam Sources a range of sources
\tparam Targets a range of vertex descriptors, of locations in faces, or of points in space
\tparam Output a function object `void(std::size_t, const std::vector<FT>&)` or
        `void(std::size_t, const std::vector<FT>&, const std::vector<std::size_t>&)`
\tparam NamedParameters a sequence of named parameters
\param mesh the mesh
\param sources the sources of the rows, each in one of the forms that `geodesic_distances()` accepts, mostly a vertex
\param targets the targets of the columns. Points in space are located on the mesh. For targets that are no vertices a front keeps
       its windows, some 40 bytes each.
\param output receives the index of the source; the distances of the targets, infinity where they are not reached; and the indices
       of the targets that are, in increasing order, which are few within a small distance limit. There is one call at a time.
\param np an optional sequence of named parameters: with a `FaceListGraph`, those of `Geodesic_mesh::Geodesic_mesh()`; and

\cgalNamedParamsBegin
  \cgalParamNBegin{distance_limit, visitor, concurrency_tag}
    \cgalParamDescription{as in `Surface_mesh_geodesic_offset::build()`: targets farther away are at infinity; the visitor receives
                          the fraction of finished rows, from one thread at a time, and rows that it cancels are left out; each of
                          several threads computes rows by itself}
  \cgalParamNEnd
  \cgalParamNBegin{upper_half}
    \cgalParamDescription{whether row i is computed from column i on only, and has infinity before, as for a symmetric matrix: the
                          targets are the sources, in the same order}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{rows_in_order}
    \cgalParamDescription{whether the rows come in the order of the sources: those that other threads finish earlier wait in memory.
                          Otherwise they come as they are finished.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of rows that `output` has received, which is less than that of the sources only after a cancellation
\throws std::invalid_argument before the first row if a source or a target is not valid, if the distance limit is negative or not a
        number, or if half of a matrix has not as many targets as sources; and other exceptions as `geodesic_distances()`.
        After an exception, also of `output` or of the visitor, there are no more rows.
*/
template <class Mesh, class Sources, class Targets, class Output, class NamedParameters = parameters::Default_named_parameters>
std::size_t geodesic_distance_matrix(const Mesh& mesh, const Sources& sources, const Targets& targets, Output&& output,
                                     const NamedParameters& np = parameters::default_values())
{
  namespace internal = Geodesic_offset::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  internal::check_named_parameters<internal::Matrix_call_parameters<internal::is_geodesic_mesh<Mesh>>, NamedParameters>();
  const auto& prepared = internal::mesh_of_call(mesh, np);
  typedef std::decay_t<decltype(prepared)> Prepared_mesh;
  typedef internal::Distance_matrix<internal::Surface_of<Prepared_mesh>> Matrix;
  typedef typename Matrix::Number Number;
  const auto& data = internal::Mesh_access::data(prepared);
  const auto request = internal::read_build_request<Number>(np, [](const auto&) { return internal::Surface_point<Number>(); });
  std::vector<internal::Located_point<Number>> columns;
  for (const auto& target : targets) columns.push_back(internal::classified_start(prepared, target));
  Matrix matrix(data, std::move(columns));
  for (const auto& source : sources)
  {
    typename Prepared_mesh::Source_set set;
    internal::Source_argument<Prepared_mesh>(prepared, set).read(source);
    for (const auto& s : set.sources()) internal::check_source(data, s.second);
    matrix.sources.push_back(internal::classified_sources(data, set));
  }
  matrix.maximum = request.maximum;
  matrix.visitor = request.goes_on;
  matrix.is_half = choose_parameter(get_parameter(np, internal_np::geodesic_upper_half), false);
  matrix.is_in_order = choose_parameter(get_parameter(np, internal_np::geodesic_rows_in_order), true);
  if (matrix.is_half && matrix.sources.size() != matrix.number_of_targets())
    throw std::invalid_argument("Surface_mesh_geodesic_offset: half of a matrix whose targets are not its sources");
  auto&& team = internal::Concurrency<internal::Concurrency_tag_of<NamedParameters>, Number>::Team::make();
  return matrix.compute_all(team, [&](std::size_t i, const typename Matrix::Row& row) {
    if constexpr (std::is_invocable<Output&, std::size_t, const decltype(row.distances)&, const decltype(row.reached)&>::value)
      output(i, row.distances, row.reached);
    else output(i, row.distances);
  });
}

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief computes the exact geodesic distance between two points: one entry of `geodesic_distance_matrix()`.

With a `Geodesic_mesh` and after the first call, the time is that of the disc around one point up to the other one.

\tparam Mesh a model of `FaceListGraph`, or an instance of `Geodesic_mesh`
\tparam From, To a vertex descriptor, a location in a face, or a point in space
\tparam NamedParameters a sequence of named parameters
\param mesh the mesh
\param from, to the points
\param np an optional sequence of named parameters: with a `FaceListGraph`, those of `Geodesic_mesh::Geodesic_mesh()`; and
       `distance_limit`
\return the distance, in the number type of the mesh; infinity if no path joins the points, or if it is longer than the limit
\throws std::invalid_argument and other exceptions as `geodesic_distance_matrix()`
*/
template <class Mesh, class From, class To, class NamedParameters = parameters::Default_named_parameters>
auto geodesic_distance(const Mesh& mesh, const From& from, const To& to,
                       const NamedParameters& np = parameters::default_values())
{
  namespace internal = Geodesic_offset::internal;
  internal::check_named_parameters<internal::Pair_call_parameters<internal::is_geodesic_mesh<Mesh>>, NamedParameters>();
  typedef typename std::decay_t<decltype(internal::mesh_of_call(mesh, np))>::FT FT;
  FT distance(0);
  const auto output = [&](std::size_t, const std::vector<FT>& row) { distance = row.front(); };
  const std::array<From, 1> first{{from}};
  const std::array<To, 1> second{{to}};
  if constexpr (internal::needs_windows<To>) geodesic_distance_matrix(mesh, second, first, output, np);
  else geodesic_distance_matrix(mesh, first, second, output, np);
  return distance;
}

} // namespace CGAL

#endif
