// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Types for the tests.

#ifndef GEODESIC_OFFSET_TEST_GEODESIC_TYPES_H
#define GEODESIC_OFFSET_TEST_GEODESIC_TYPES_H

#include "generated_soup.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <limits>
#include <optional>
#include <vector>

namespace test {

typedef CGAL::Surface_mesh<Kernel::Point_3> Surface_mesh;

template <class TriangleMesh>
using Geodesic_on = CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, TriangleMesh>>;

typedef Geodesic_on<Surface_mesh> Geodesic;

/// With the traits of any kernel.
template <class AnyKernel, class Mesh>
using Geodesic_with = CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<AnyKernel, Mesh>>;

/// A source, which can be added to several objects.
typedef Geodesic::Source_set::Source Source;
typedef Geodesic::Source_set::Kind Source_kind;

inline Source point_source(const Geodesic::Face_location& l, double start = 0)
{
  return {Source_kind::LOCATION, Surface_mesh::null_vertex(), {l}, {}, start};
}
inline Source point_source(Surface_mesh::Vertex_index v, double start = 0) { return {Source_kind::VERTEX, v, {}, {}, start}; }
inline Source polyline_source(const std::vector<Geodesic::Face_location>& locations, bool is_closed = false, double start = 0)
{
  const Source_kind kind = is_closed ? Source_kind::CLOSED_POLYLINE : Source_kind::OPEN_POLYLINE;
  return {kind, Surface_mesh::null_vertex(), locations, {}, start};
}
inline Source edge_source(const std::vector<Surface_mesh::Edge_index>& edges, double start = 0)
{
  return {Source_kind::EDGES, Surface_mesh::null_vertex(), {}, edges, start};
}

/// The set of sources, with the ids 0, 1, ... A closed polyline may repeat its first point, as one that is added.
inline Geodesic::Source_set source_set(const std::vector<Source>& sources)
{
  Geodesic::Source_set result;
  for (Source s : sources)
  {
    auto& l = s.locations;
    if (s.kind == Source_kind::CLOSED_POLYLINE && l.size() > 3 && l.front() == l.back()) l.pop_back();
    result.add(std::move(s));
  }
  return result;
}

/// The field of sources.
inline Geodesic built(const Surface_mesh& mesh, const Geodesic::Source_set& sources, bool keep = true)
{
  Geodesic result(mesh);
  result.add_sources(sources);
  result.build(CGAL::parameters::keep_windows(keep));
  return result;
}
inline Geodesic built(const Surface_mesh& mesh, const std::vector<Source>& sources, bool keep = true)
{
  return built(mesh, source_set(sources), keep);
}

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A signed distance, or not a number if there is none.
inline double or_nan(const std::optional<double>& distance)
{
  return distance.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// Distances of all vertices from one vertex, in any kernel.
template <class AnyKernel>
std::vector<typename AnyKernel::FT> distances_from(const Surface_mesh& mesh, Surface_mesh::Vertex_index source)
{
  Geodesic_with<AnyKernel, Surface_mesh> geodesic(mesh);
  geodesic.add_source_point(source);
  geodesic.build();
  std::vector<typename AnyKernel::FT> out;
  for (auto v : vertices(mesh)) out.push_back(geodesic.distance_to_sources(v));
  return out;
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_GEODESIC_TYPES_H
