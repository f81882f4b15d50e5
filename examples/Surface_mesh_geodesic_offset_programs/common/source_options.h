// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Options for the mesh and the sources, shared by all programs.

#ifndef GEODESIC_OFFSET_SOURCE_OPTIONS_H
#define GEODESIC_OFFSET_SOURCE_OPTIONS_H

#include "border_stitching.h"
#include "command_line.h"
#include "common.h"
#include "numbers.h"

#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {

struct Source_options
{
  std::string mesh;

  std::vector<std::size_t> source_vertices;
  std::vector<std::array<double, 3>> source_points;
  std::vector<std::string> source_polylines;
  std::vector<std::optional<CGAL::Offset_side>> polyline_sides; // of the files; empty: none has its own
  std::vector<std::array<double, 4>> source_planes;
  std::vector<double> source_sharp_edges;
  bool source_boundary = false;
  bool have_start_values = false; // whether points of polylines may have a start value
  double close_gap = 0; // polylines with ends not farther apart are closed
  std::optional<std::array<double, 3>> projection; // direction in which points are put on the surface
  std::optional<std::array<double, 3>> boundary_near; // only the nearest boundary cycle
  std::optional<std::array<double, 3>> section_near; // only the nearest curve of each section
  std::optional<std::array<double, 3>> sharp_edges_near; // only the nearest chain of sharp edges

  std::vector<std::pair<std::size_t, double>> start_values; // with the number of the source

  std::vector<std::string> files_read() const
  {
    std::vector<std::string> result{mesh};
    result.insert(result.end(), source_polylines.begin(), source_polylines.end());
    return result;
  }
};

namespace internal {

inline po::options_description source_options_description()
{
  const auto words = [](const char* name) { return po::value<Words>()->value_name(name); };
  const auto word = [](const char* name) { return po::value<std::string>()->value_name(name); };
  po::options_description sources("Sources (repeatable, in any mix)");
  sources.add_options()("source-vertex", words("I"), "vertex of the mesh, counted from 0 in the order of the file")(
    "source-point", words("X,Y,Z"),
    "nearest point of the surface")("source-polyline", words("FILE"),
                                    "polylines in a .polylines.txt file (see below); each point goes to the nearest point "
                                    "of the surface, consecutive points are joined by the shortest path on the surface")(
    "source-plane", words("A,B,C,D"), "section of the mesh by the plane A x + B y + C z + D = 0")(
    "section-near", word("X,Y,Z"), "with --source-plane: only the curve of each section that is nearest to this point")(
    "source-boundary", po::bool_switch(),
    "all boundary edges")("boundary-near", word("X,Y,Z"),
                          "with --source-boundary: only the boundary cycle that is nearest to this point")(
    "source-sharp-edges", words("DEG"), "all edges where the normals of the two faces differ by more than DEG degrees")(
    "sharp-edges-near", word("X,Y,Z"),
    "with --source-sharp-edges: only the chain of these edges that is nearest to this point; "
    "it ends where other than two of the edges meet")(
    "start-value", words("I,S"), "distances from source I, numbered as in .vtk files of offsets, begin at S instead of 0")(
    "close-gap", word("L"), "also polylines whose ends are not farther apart than L are closed")(
    "project", word("X,Y,Z"),
    "put points on the surface along this direction, forwards or backwards, instead of to the nearest "
    "point; all points of a polyline on faces to the same side of this direction, if possible");
  return sources;
}

inline void add_border_options(po::options_description& others)
{
  others.add_options()("no-stitch", po::bool_switch(), "keep border edges at the same place apart")(
    "stitch-tolerance", po::value<std::string>()->value_name("T"),
    "join border edges whose ends are at most T apart, in the units of the mesh (default: 0)");
}

inline Border_joining border_joining(const po::variables_map& map)
{
  const bool is_off = map["no-stitch"].as<bool>();
  if(is_off && map.count("stitch-tolerance")) throw Usage_error("--stitch-tolerance cannot be used with --no-stitch");
  return {!is_off, optional_positive_number(map, "stitch-tolerance").value_or(0)};
}

// The word without an option.
inline std::string mesh_option(const po::variables_map& map)
{
  const Words meshes = option_words(map, "mesh");
  double number = 0;
  for(const std::string& mesh : meshes)
    if(parse_number(mesh, number))
      throw Usage_error("the number " + quoted(mesh) +
                        " belongs to no option; the numbers of one option are separated by "
                        "commas without blanks, as in --source-plane 0,0,1,0");
  for(const std::string& mesh : meshes)
    if(mesh.empty() || mesh[0] == '-') throw Usage_error("unknown option " + quoted(mesh));
  if(meshes.empty()) throw Usage_error("no MESH given (--help lists the options)");
  if(meshes.size() > 1) throw Usage_error("more than one MESH given: " + quoted(meshes[0]) + " and " + quoted(meshes[1]));
  return meshes[0];
}

inline void read_source_options(const po::variables_map& map, Source_options& options)
{
  options.mesh = mesh_option(map);

  options.source_vertices = indices(map, "source-vertex");
  for(const std::string& w : option_words(map, "source-point")) options.source_points.push_back(numbers<3>("source-point", w));
  options.source_polylines = option_words(map, "source-polyline");
  for(const std::string& w : option_words(map, "source-plane"))
  {
    options.source_planes.push_back(numbers<4>("source-plane", w));
    const std::array<double, 4>& plane = options.source_planes.back();
    if(plane[0] == 0 && plane[1] == 0 && plane[2] == 0)
      throw Usage_error("--source-plane " + quoted(w) + " is not a plane: its normal is zero");
  }
  options.source_sharp_edges = angles(map, "source-sharp-edges");
  options.source_boundary = map["source-boundary"].as<bool>();
  options.section_near = optional_point(map, "section-near");
  if(options.section_near && options.source_planes.empty()) throw Usage_error("--section-near needs --source-plane");
  options.boundary_near = optional_point(map, "boundary-near");
  if(options.boundary_near && !options.source_boundary) throw Usage_error("--boundary-near needs --source-boundary");
  options.sharp_edges_near = optional_point(map, "sharp-edges-near");
  if(options.sharp_edges_near && options.source_sharp_edges.empty())
    throw Usage_error("--sharp-edges-near needs --source-sharp-edges");
  options.projection = direction(map, "project");
  options.close_gap = optional_positive_number(map, "close-gap").value_or(0);
  if(options.close_gap > 0 && options.source_polylines.empty() && map.count("barrier") == 0 && map.count("region") == 0)
    throw Usage_error("--close-gap needs --source-polyline");
  for(const std::string& w : option_words(map, "start-value"))
  {
    const std::size_t comma = w.find(',');
    options.start_values.emplace_back();
    auto& [source, value] = options.start_values.back();
    if(comma == std::string::npos || !parse_index(w.substr(0, comma), source) || !parse_number(w.substr(comma + 1), value) ||
       value < 0)
      throw Usage_error("--start-value must be the number of a source, a comma, and a number that is not negative, not " +
                        quoted(w));
    for(std::size_t i = 0; i + 1 < options.start_values.size(); ++i)
      if(options.start_values[i].first == source)
        throw Usage_error("--start-value: two values for source " + std::to_string(source));
  }

  if(options.source_vertices.empty() && options.source_points.empty() && options.source_polylines.empty() &&
     options.source_planes.empty() && options.source_sharp_edges.empty() && !options.source_boundary)
    throw Usage_error("no source given (--source-vertex, --source-point, --source-polyline, --source-plane, "
                      "--source-boundary or --source-sharp-edges)");
}

} // namespace internal
} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_SOURCE_OPTIONS_H
