// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The headers of the package, with the instantiations of some tests, for the target strict_warnings: -Wall -Wextra
// -pedantic -Wconversion -Wsign-conversion -Wshadow -Werror. The tests themselves are compiled without the last three.

#include "validation/Offset_validation.h"

#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/Radical_numbers.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/construct_geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_farthest_points.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_voronoi_labels.h>
#include <CGAL/Surface_mesh_geodesic_offset/nest_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/shortest_path_to_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_polylines.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/window_checks.h>

#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wfloat-conversion"
#endif
#endif

#include "test_against_shortest_path.cpp"
#include "test_certified_bounds.cpp"
#include "test_distance_matrix.cpp"
#include "test_exact_kernel.cpp"
#include "test_free_functions.cpp"
#include "test_graph_types.cpp"
#include "test_kernels.cpp"
#include "test_long_numbers.cpp"
#include "test_offset_curves.cpp"
#include "test_offset_files.cpp"
#include "test_offset_validation.cpp"
#include "test_plane_section.cpp"
#include "test_shared_results.cpp"
#include "test_traits_concept.cpp"
