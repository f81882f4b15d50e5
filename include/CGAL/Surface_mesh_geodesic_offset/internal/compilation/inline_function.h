// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How functions that are no templates are defined in the `_impl.h` files: `inline`, except in the compiled library.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_COMPILATION_INLINE_FUNCTION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_COMPILATION_INLINE_FUNCTION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#ifdef CGAL_GEODESIC_OFFSET_BUILDS_LIBRARY
#define CGAL_GEODESIC_OFFSET_INLINE
#else
#define CGAL_GEODESIC_OFFSET_INLINE inline
#endif

#endif
