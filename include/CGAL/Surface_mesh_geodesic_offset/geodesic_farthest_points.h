// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_FARTHEST_POINTS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_FARTHEST_POINTS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/functions/Build_series.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/vertex_results.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <cstddef>
#include <queue>
#include <stdexcept>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief selects vertices that cover the surface evenly: each is a vertex that is farthest from all selected before it.

A connected part without a selected vertex is infinitely far. Vertices without faces are left out. There is one field, in which each
vertex changes only the distances in its own cell, in the time of the front there.

\tparam Mesh a model of `FaceListGraph`, or an instance of `Geodesic_mesh`, with the number type `FT`
\tparam OutputIterator an output iterator for vertex descriptors
\tparam NamedParameters a sequence of named parameters
\param mesh the mesh
\param n the number of vertices to select; fewer are selected if all vertices are, or by `covering_radius` or a visitor
\param out receives the selected vertices in their order
\param np an optional sequence of named parameters: with a `FaceListGraph`, those of `Geodesic_mesh::Geodesic_mesh()`; and

\cgalNamedParamsBegin
  \cgalParamNBegin{start_set}
    \cgalParamDescription{sources that count as selected before the first vertex, but are not written to `out`; one vertex is the
                          seed of the selection}
    \cgalParamType{the sources of `geodesic_distances()`, or a `std::reference_wrapper` of them}
    \cgalParamDefault{none: the first vertex is any}
  \cgalParamNEnd
  \cgalParamNBegin{covering_radius}
    \cgalParamDescription{no more vertices are selected when all are within this distance of selected ones}
    \cgalParamType{convertible to `FT`, not negative}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_distance_map, vertex_source_map}
    \cgalParamDescription{receive the distances and the labels of the vertices, as from `geodesic_distances()` and
                          `geodesic_voronoi_labels()` with the start set and, with the ids after it, the selected vertices}
    \cgalParamType{models of `WritablePropertyMap` with the vertex descriptor as key and `FT` and `std::size_t` as value}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{called before each selection with the fraction of selected vertices; `false` ends the selection}
    \cgalParamType{a function object `bool(double)`, or a `std::reference_wrapper` of one}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the covering radius: the largest distance of a vertex with a face from the nearest selected vertex or source. It is infinite
        if no path leads to one, and 0 if there are no faces.
\throws std::invalid_argument if the covering radius is negative or not a number, and other exceptions as `geodesic_distances()`
*/
template <class Mesh, class OutputIterator, class NamedParameters = parameters::Default_named_parameters>
auto geodesic_farthest_points(const Mesh& mesh, std::size_t n, OutputIterator out,
                              const NamedParameters& np = parameters::default_values())
{
  namespace internal = Geodesic_offset::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  internal::check_named_parameters<internal::Farthest_call_parameters<internal::is_geodesic_mesh<Mesh>>, NamedParameters>();
  const auto& prepared = internal::mesh_of_call(mesh, np);
  typedef std::decay_t<decltype(prepared)> Prepared_mesh;
  typedef internal::Surface_of<Prepared_mesh> Surface;
  typedef typename Surface::Number Number;
  const auto& data = internal::Mesh_access::data(prepared);
  const Surface& surface = data.surface();
  const auto request = internal::read_build_request<Number>(np, [](const auto&) { return internal::Surface_point<Number>(); });
  const Number radius(surface.imported(
    typename Surface::FT(choose_parameter(get_parameter(np, internal_np::geodesic_covering_radius), typename Surface::FT(0)))));
  if (!(radius >= 0))
    throw std::invalid_argument("Surface_mesh_geodesic_offset: the covering radius is negative or not a number");
  typename Prepared_mesh::Source_set start;
  if constexpr (internal::has_parameter<internal_np::geodesic_start_set_t, NamedParameters>)
  {
    const auto sources = get_parameter(np, internal_np::geodesic_start_set); // maybe a reference wrapper
    internal::Source_argument<Prepared_mesh>(prepared, start).read(internal_np::get_reference(sources));
  }
  std::size_t next_id = start.size() == 0 ? 0 : start.sources().rbegin()->first + 1;
  internal::Build_series<Surface> series(data);
  series.build(internal::classified_sources(data, start), {});
  const auto& field = series.last().field;
  const auto distance = [&](internal::Index v) { return field.distance[internal::nearest_copy(data.unfolded(), field, v)]; };
  // Distances only decrease, so the top is a farthest vertex when its distance is up to date.
  std::priority_queue<std::pair<Number, internal::Index>> heap;
  for (const auto v : vertices(surface.tm))
    if (halfedge(v, surface.tm) != Surface::Graph_traits::null_halfedge())
      heap.emplace(distance(surface.index_of(v)), surface.index_of(v));
  for (std::size_t i = 0;; ++i)
  {
    while (!heap.empty() && distance(heap.top().second) < heap.top().first)
    {
      const internal::Index v = heap.top().second;
      heap.pop();
      heap.emplace(distance(v), v);
    }
    if (heap.empty() || i == n || !(radius < heap.top().first) || (request.goes_on && !request.goes_on(double(i) / double(n))))
      break;
    series.add_source(internal::Index(next_id++), internal::Surface_point<Number>::at_vertex(heap.top().second));
    *out++ = surface.vertex_of[heap.top().second];
  }
  if constexpr (internal::has_parameter<internal_np::geodesic_vertex_distance_t, NamedParameters>)
    internal::write_vertex_distances(data, series.last(), get_parameter(np, internal_np::geodesic_vertex_distance));
  if constexpr (internal::has_parameter<internal_np::geodesic_vertex_source_t, NamedParameters>)
    internal::write_source_labels(data, series.last(), get_parameter(np, internal_np::geodesic_vertex_source));
  return typename Surface::FT(heap.empty() ? Surface::exported(Number(0)) : Surface::exported(heap.top().first));
}

} // namespace CGAL

#endif
