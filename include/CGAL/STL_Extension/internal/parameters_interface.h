// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extends the CGAL header of the same name, the list of named parameters, by those of this package. The folder of this
// header must come before that of CGAL in the include path. Within CGAL, the lines of the second header would stand in
// the first one.
//
// No include guard: CGAL/Named_function_parameters.h includes the list several times, each time with another macro.

#pragma GCC system_header // #include_next is an extension
#include_next <CGAL/STL_Extension/internal/parameters_interface.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/parameters_interface.h>
