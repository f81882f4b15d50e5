// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Options for paths and for the farthest point.

#ifndef GEODESIC_OFFSET_QUERY_OPTIONS_H
#define GEODESIC_OFFSET_QUERY_OPTIONS_H

#include "common/command_line.h"
#include "common/common.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace geodesic_offset {

struct Query_options
{
  std::vector<std::size_t> path_vertices;
  std::vector<std::array<double, 3>> path_points;
  std::vector<std::string> path_outputs;
  bool farthest_point = false;

  bool has_paths() const { return !path_vertices.empty() || !path_points.empty(); }
};

namespace internal {

inline po::options_description query_options_description()
{
  const auto words = [](const char* name) { return po::value<Words>()->value_name(name); };
  po::options_description queries("Queries");
  queries.add_options()("path-from", words("X,Y,Z"),
                        "the shortest path from the nearest point of the surface to the nearest source (repeatable)")(
    "path-from-vertex", words("I"), "the same from a vertex of the mesh, counted from 0 (repeatable)")(
    "path-output", words("FILE"), "the paths as .polylines.txt or .vtk (repeatable); --picture shows them, too")(
    "farthest-point", po::bool_switch(), "print the farthest point and its distance, and write them to --stats");
  return queries;
}

inline void read_query_options(const po::variables_map& map, Query_options& options)
{
  for(const std::string& w : option_words(map, "path-from")) options.path_points.push_back(numbers<3>("path-from", w));
  options.path_vertices = indices(map, "path-from-vertex");
  options.path_outputs = option_words(map, "path-output");
  options.farthest_point = map["farthest-point"].as<bool>();

  for(const std::string& file : options.path_outputs)
    if(!has_extension(file, ".polylines.txt") && !has_extension(file, ".vtk"))
      throw Usage_error("--path-output " + quoted(file) + " must end in .polylines.txt or .vtk");
  if(!options.path_outputs.empty() && !options.has_paths())
    throw Usage_error("--path-output needs --path-from or --path-from-vertex");
  if(options.has_paths() && options.path_outputs.empty() && map.count("picture") == 0)
    throw Usage_error("--path-from and --path-from-vertex need --path-output or --picture");
  if(options.farthest_point && map.count("maximum-distance"))
    throw Usage_error("--farthest-point needs all distances, without --maximum-distance");
}

} // namespace internal
} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_QUERY_OPTIONS_H
