// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The same headers in a second translation unit, and included first: detects functions that are not inline, and headers
// that depend on other includes.

#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

double distance_between_corners(
  const CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>& square)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;

  CGAL::Surface_mesh_geodesic_offset<Traits> geodesic_offset(square);
  geodesic_offset.add_source_point(Mesh::Vertex_index(0));
  geodesic_offset.build();
  return geodesic_offset.distance_to_sources(Mesh::Vertex_index(2));
}
