// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What does not depend on the type of the mesh, compiled once for a program. To be included in one file of the program, which is
// compiled, as all others, with the macro CGAL_GEODESIC_OFFSET_SEPARATE_COMPILATION.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_SEPARATE_COMPILATION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_SEPARATE_COMPILATION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#ifndef CGAL_GEODESIC_OFFSET_SEPARATE_COMPILATION
#error "separate_compilation.h needs the macro CGAL_GEODESIC_OFFSET_SEPARATE_COMPILATION in all files of the program"
#endif

#include <CGAL/Surface_mesh_geodesic_offset/internal/compilation/separate_functions.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

CGAL_GEODESIC_OFFSET_SEPARATE_FUNCTIONS(template)

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
