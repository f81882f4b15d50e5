// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Output of --version.

#ifndef GEODESIC_OFFSET_VERSION_H
#define GEODESIC_OFFSET_VERSION_H

#include <CGAL/version_macros.h>

#include <ostream>
#include <string>

namespace geodesic_offset {

// GEODESIC_OFFSET_VERSION: version of the CMake project. `more`: further components of the program.
inline void print_version(std::ostream& out, const std::string& program, const std::string& more = "")
{
  out << program << ' ' << GEODESIC_OFFSET_VERSION << " (CGAL " << CGAL_VERSION_STR << more << ")\n";
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_VERSION_H
