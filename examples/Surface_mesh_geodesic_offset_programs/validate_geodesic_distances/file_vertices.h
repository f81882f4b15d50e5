// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A distance belongs to a vertex of the file, so the mesh must have exactly these vertices. Files that other programs may
// repair differently are rejected: their surface would differ.

#ifndef VALIDATE_GEODESIC_DISTANCES_FILE_VERTICES_H
#define VALIDATE_GEODESIC_DISTANCES_FILE_VERTICES_H

#include "common/common.h"
#include "common/mesh_input.h"
#include "distance_table.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace geodesic_offset {

// Throws Input_error.
inline void require_numbered_vertices(const std::string& path)
{
  if(has_extension(path, ".stl"))
    throw Input_error(quoted(path) + ": an .stl file has no numbered vertices; an .off, .obj or .ply file is needed");
}

// Throws Input_error if reading has merged or cut vertices, or has chosen diagonals of faces.
inline void require_unchanged_vertices(const Mesh_input& input, const std::string& path)
{
  const std::vector<Polygon>& polygons = input.soup().polygons;
  for(std::size_t i = 0; i < polygons.size(); ++i)
    if(polygons[i].size() > 3)
      throw Input_error(quoted(path) + ": face " + std::to_string(i) + " has " + std::to_string(polygons[i].size()) +
                        " vertices; distances depend on how it is divided into triangles, so triangles are needed");

  const std::size_t none = input.soup().points.size();
  std::vector<std::size_t> file_vertex(input.mesh().number_of_vertices(), none);
  for(std::size_t i = 0; i < none; ++i)
  {
    std::size_t number = 0;
    input.for_each_vertex_of(i, [&](Vertex v) {
      ++number;
      if(file_vertex[v] != none)
        throw Input_error(quoted(path) + ": vertices " + std::to_string(file_vertex[v]) + " and " + std::to_string(i) +
                          " are at the same place, as the ends of an edge of a face without area; it must be removed first");
      file_vertex[v] = i;
    });
    if(number > 1)
      throw Input_error(quoted(path) + ": the surface is not an orientable manifold at vertex " + std::to_string(i));
  }
}

inline std::size_t number_of_unused_vertices(const Mesh_input& input)
{
  std::size_t unused = 0;
  for(std::size_t i = 0; i < input.soup().points.size(); ++i) unused += input.has_vertex(i) ? 0 : 1;
  return unused;
}

// Throws Input_error if the table has vertices at other positions, because of another order or unit. Digits may be lost.
inline void require_same_points(const Distance_table& table, const Mesh_input& input, const std::string& path)
{
  const double most = 1e-4 * input.bounding_box_diagonal();
  for(std::size_t i = 0; i < table.points.size(); ++i)
    if(input.has_vertex(i) && !(std::sqrt(CGAL::squared_distance(table.points[i], input.soup().points[i])) <= most))
      throw Input_error(table.name + ": vertex " + std::to_string(i) + " is not where " + quoted(path) +
                        " has it; the order of the vertices must be the same");
}

} // namespace geodesic_offset

#endif // VALIDATE_GEODESIC_DISTANCES_FILE_VERTICES_H
