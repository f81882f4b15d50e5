// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points and polygons, the common content of all mesh files.

#ifndef GEODESIC_OFFSET_SOUP_H
#define GEODESIC_OFFSET_SOUP_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Polygon = std::vector<std::uint32_t>;

// Vertices and faces in the order of the file.
struct Soup
{
  std::vector<Point> points;
  std::vector<Polygon> polygons;
  std::vector<std::string> remarks; // parts of the file that were left out, one line each

  // Vertices with a coordinate that is not finite, and a message for each: an error only if a face has the vertex.
  std::vector<std::pair<std::size_t, std::string>> not_finite;
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_SOUP_H
