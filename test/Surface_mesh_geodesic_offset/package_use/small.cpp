// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The headers are found, with the standard of C++ that they need.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <cstdlib>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic_offset;
typedef CGAL::Offset_levels<Geodesic_offset::FT> Levels;

// the offsets at 0.5, 1, 1.5 and 2
int main()
{
  const Levels levels = Levels::equally_spaced(0.5, 4);
  return levels.size() == 4 && levels.first_above(1.25) == 2 ? EXIT_SUCCESS : EXIT_FAILURE;
}
