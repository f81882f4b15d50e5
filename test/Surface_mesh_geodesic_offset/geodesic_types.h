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
