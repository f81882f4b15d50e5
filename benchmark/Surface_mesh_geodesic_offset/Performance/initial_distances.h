// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GEODESIC_OFFSET_BENCHMARK_INITIAL_DISTANCES_H
#define GEODESIC_OFFSET_BENCHMARK_INITIAL_DISTANCES_H

#include <utility>
#include <vector>

namespace benchmark {

/// Start vertices of a method on vertices, with their distances.
template <class Mesh>
using Initial_distances = std::vector<std::pair<typename Mesh::Vertex_index, double>>;

} // namespace benchmark

#endif // GEODESIC_OFFSET_BENCHMARK_INITIAL_DISTANCES_H
