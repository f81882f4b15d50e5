// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reader of the meshes of the data directory; reports why a mesh is unusable.

#ifndef GEODESIC_OFFSET_TEST_DATA_MESHES_H
#define GEODESIC_OFFSET_TEST_DATA_MESHES_H

#include "data_directory.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <filesystem>
#include <string>

namespace test {

/// Reads a mesh; returns an empty string, or why the mesh is unusable.
std::string read_data_mesh(const std::filesystem::path& file, std::size_t maximum_faces,
                           CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>& mesh);

} // namespace test

#endif // GEODESIC_OFFSET_TEST_DATA_MESHES_H
