// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Options of the user, with all checks that need no file.

#ifndef VALIDATE_GEODESIC_DISTANCES_OPTIONS_H
#define VALIDATE_GEODESIC_DISTANCES_OPTIONS_H

#include "common/command_line.h"
#include "common/common.h"
#include "common/file_identity.h"
#include "common/numbers.h"
#include "common/polyline_file.h"
#include "common/source_options.h"

#include <ostream>
#include <string>

namespace geodesic_offset {

struct Validation_options : Source_options
{
  std::string distances;
  std::string property;
  std::string per_vertex;
  double tolerance = 0;
  bool help = false;
  bool version = false;
};

namespace internal {

inline po::options_description validation_options_description()
{
  po::options_description all(
    "validate_geodesic_distances MESH [sources] --distances FILE [others]\n\n"
    "Compares the distances of any program with certified bounds of the geodesic distances.\n"
    "MESH is an .off, .obj or .ply file of triangles; it is not repaired. Border edges at the same place are not joined,\n"
    "and a vertex without faces is unreachable.\n"
    "Exit code: 0 if all distances are within the bounds or the tolerance, 3 if some are not; 1 if something\n"
    "that the command line names is wrong, 2 if the command line is wrong");
  const auto word = [](const char* name) { return po::value<std::string>()->value_name(name); };

  po::options_description others("Distances and others");
  others.add_options()("distances", word("FILE"),
                       "one distance per line in the order of the vertices, or lines of a vertex and its "
                       "distance, where '#' begins a comment; or, if it ends in .ply, a property of the "
                       "vertices. 'inf' for unreachable vertices")(
    "property", word("NAME"),
    "the property of the .ply file (default: the first existing one of distance, quality, scalar, "
    "geodesic_distance, geodesic, value)")("tolerance", word("REL"),
                                           "distances may be outside the bounds by this, relative to the bound (default: 0)")(
    "per-vertex", word("FILE"),
    "a table of all vertices: vertex, lower and upper bound, distance, and distance "
    "from the bounds, negative if too short")("version", po::bool_switch(),
                                              "print the version")("help", po::bool_switch(), "print this");

  all.add(source_options_description()).add(others);
  return all;
}

inline void check_files(const Validation_options& options)
{
  if(options.distances.empty()) throw Usage_error("no --distances given");
  if(!options.property.empty() && !has_extension(options.distances, ".ply"))
    throw Usage_error("--property needs --distances in a file that ends in .ply, not " + quoted(options.distances));
  Words read = options.files_read();
  read.push_back(options.distances);
  if(!options.per_vertex.empty()) check_different_files(read, {options.per_vertex});
}

inline Validation_options checked_validation_options(const po::variables_map& map)
{
  Validation_options options;
  read_source_options(map, options);
  options.distances = option_word(map, "distances");
  options.property = option_word(map, "property");
  options.per_vertex = option_word(map, "per-vertex");
  check_files(options);
  if(map.count("tolerance"))
  {
    const std::string w = map["tolerance"].as<std::string>();
    if(!parse_number(w, options.tolerance) || options.tolerance < 0)
      throw Usage_error("--tolerance must be zero or a positive finite number, not " + quoted(w));
  }
  return options;
}

} // namespace internal

inline void print_validation_help(std::ostream& out)
{
  out << internal::validation_options_description() << '\n' << polyline_format_help();
}

// Throws Usage_error.
inline Validation_options parse_validation_options(int argc, const char* const* argv)
{
  const boost::program_options::variables_map map =
    internal::parsed_command_line(argc, argv, internal::validation_options_description());
  Validation_options options;
  options.help = map["help"].as<bool>();
  options.version = map["version"].as<bool>();
  return options.help || options.version ? options : internal::checked_validation_options(map);
}

} // namespace geodesic_offset

#endif // VALIDATE_GEODESIC_DISTANCES_OPTIONS_H
