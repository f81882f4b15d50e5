// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The same headers in a second translation unit, and included first: detects functions that are not inline, and headers
// that depend on other includes. Templates, which link together, are instantiated for the sources only: quicker to compile.

#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>

std::size_t number_of_sources(
  const CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<
    CGAL::Exact_predicates_inexact_constructions_kernel,
    CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>>>& geodesic_offset)
{
  return geodesic_offset.number_of_sources();
}
