// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the user asked for. Everything that can be judged without opening a file is judged here.

#ifndef VALIDATE_GEODESIC_OFFSETS_OPTIONS_H
#define VALIDATE_GEODESIC_OFFSETS_OPTIONS_H

#include "common/command_line.h"
#include "common/common.h"
#include "common/numbers.h"
#include "common/polyline_file.h"
#include "common/source_options.h"

#include <optional>
#include <ostream>
#include <string>

namespace geodesic_offset {

struct Offset_validation_options : Source_options
{
  std::string curves;
  double distance = 0;
  std::optional<double> tolerance;
  std::optional<double> surface_tolerance;
  Border_joining borders;
  bool help = false;
  bool version = false;
};

namespace internal {

inline po::options_description offset_validation_options_description()
{
  po::options_description all(
    "validate_geodesic_offsets MESH [sources] --distance D --curves FILE [others]\n\n"
    "Whether the curves of any program are a geodesic offset: the smallest EPS for which it is proven that the curves bound\n"
    "a region of the surface that contains all points nearer to the sources than D - EPS, and no point farther away than\n"
    "D + EPS. MESH is an .off, .obj, .ply or .stl file, which is read as by geodesic_offset.\n"
    "Exit code: 0 if there is such an EPS, at most that of --tolerance; 3 if there is none, or only larger ones; 1 if\n"
    "something that the command line names is wrong, 2 if the command line is");
  const auto word = [](const char* name) { return po::value<std::string>()->value_name(name); };

  po::options_description others("Offset and others");
  others.add_options()("distance", word("D"), "the distance of the offset")(
    "curves", word("FILE"),
    "the curves, as polylines in a .polylines.txt file (see below); each point goes to the nearest "
    "point of the surface, consecutive points are joined by the shortest path on the surface. Open "
    "curves may go on from each other, where they have the same end")(
    "tolerance", word("EPS"), "the largest EPS that is accepted, in the units of the mesh (default: any)")(
    "surface-tolerance", word("T"),
    "points may be so far from the surface, in the units of the mesh (default: 1e-5 of the "
    "diagonal of the bounding box)")("version", po::bool_switch(),
                                     "print the version")("help", po::bool_switch(), "print this");
  add_border_options(others);

  all.add(source_options_description()).add(others);
  return all;
}

inline Offset_validation_options checked_offset_validation_options(const po::variables_map& map)
{
  Offset_validation_options options;
  read_source_options(map, options);
  options.curves = option_word(map, "curves");
  if(options.curves.empty()) throw Usage_error("no --curves given");
  if(map.count("distance") == 0) throw Usage_error("no --distance given");
  options.distance = positive_number("distance", map["distance"].as<std::string>());
  options.tolerance = optional_positive_number(map, "tolerance");
  options.surface_tolerance = optional_positive_number(map, "surface-tolerance");
  options.borders = border_joining(map);
  return options;
}

} // namespace internal

inline void print_offset_validation_help(std::ostream& out)
{
  out << internal::offset_validation_options_description() << '\n' << polyline_format_help();
}

// Throws Usage_error.
inline Offset_validation_options parse_offset_validation_options(int argc, const char* const* argv)
{
  const boost::program_options::variables_map map =
    internal::parsed_command_line(argc, argv, internal::offset_validation_options_description());
  Offset_validation_options options;
  options.help = map["help"].as<bool>();
  options.version = map["version"].as<bool>();
  return options.help || options.version ? options : internal::checked_offset_validation_options(map);
}

} // namespace geodesic_offset

#endif // VALIDATE_GEODESIC_OFFSETS_OPTIONS_H
