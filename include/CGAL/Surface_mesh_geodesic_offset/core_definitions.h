// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of all functions of the core, for programs that link the compiled library and use another number type than
// `double` or traits of their own: these are not in the library. Other programs do not need this header.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_CORE_DEFINITIONS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_CORE_DEFINITIONS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/compilation/compiled_functions.h>

#ifdef CGAL_GEODESIC_OFFSET_COMPILED

#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build_impl.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Index_renumbering_impl.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_locator_impl.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh_impl.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Inner_sides_impl.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/level_cutting_impl.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Polyline_joining_impl.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_set_impl.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_diagram_impl.h>

namespace CGAL::Geodesic_offset::internal {

template <class>
struct Core_definitions
{
};

// Those for `double` are in the library.
CGAL_GEODESIC_OFFSET_MESH_FUNCTIONS(extern template)
CGAL_GEODESIC_OFFSET_LOCATOR_FUNCTIONS(extern template)
CGAL_GEODESIC_OFFSET_SOURCE_FUNCTIONS(extern template)
CGAL_GEODESIC_OFFSET_FRONT_FUNCTIONS(extern template)
CGAL_GEODESIC_OFFSET_PARALLEL_FRONT_FUNCTIONS(extern template)
CGAL_GEODESIC_OFFSET_PATH_FUNCTIONS(extern template)
CGAL_GEODESIC_OFFSET_CUTTING_FUNCTIONS(extern template)
CGAL_GEODESIC_OFFSET_VORONOI_FUNCTIONS(extern template)

} // namespace CGAL::Geodesic_offset::internal

#endif

#endif
