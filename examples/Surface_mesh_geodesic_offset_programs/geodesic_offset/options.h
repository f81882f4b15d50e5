// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Options of the user, with all checks that need no file.

#ifndef GEODESIC_OFFSET_OPTIONS_H
#define GEODESIC_OFFSET_OPTIONS_H

#include "common/command_line.h"
#include "common/common.h"
#include "common/file_identity.h"
#include "common/polyline_file.h"
#include "common/source_options.h"
#include "level_options.h"
#include "output_options.h"
#include "query_options.h"
#include "threads.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {

struct Barrier_options
{
  std::vector<std::string> barriers, regions; // files of polylines
  std::vector<double> barrier_sharp_edges; // in degrees

  bool have_effect() const { return !barriers.empty() || !regions.empty() || !barrier_sharp_edges.empty(); }
};

struct Options : Source_options, Level_options, Query_options, Output_options
{
  Barrier_options barriers;
  std::optional<std::size_t> threads;
  Border_joining borders;
  bool quiet = false;
  bool help = false;
  bool version = false;

  std::vector<std::string> files_read() const
  {
    std::vector<std::string> result = Source_options::files_read();
    for(const auto* files : {&barriers.barriers, &barriers.regions}) result.insert(result.end(), files->begin(), files->end());
    return result;
  }

  std::vector<std::string> files_written() const
  {
    std::vector<std::string> result = Output_options::files_written();
    result.insert(result.end(), path_outputs.begin(), path_outputs.end());
    return result;
  }

  // Whether offsets are written on both sides of all sources, with round ends.
  bool takes_everything() const
  {
    const auto is_both = [](const std::optional<CGAL::Offset_side>& side) {
      return side.value_or(CGAL::Offset_side::BOTH) == CGAL::Offset_side::BOTH;
    };
    return selected_side == CGAL::Offset_side::BOTH &&
           selected_end.value_or(CGAL::Offset_end::ROUND) == CGAL::Offset_end::ROUND &&
           std::all_of(polyline_sides.begin(), polyline_sides.end(), is_both);
  }

  // Whether distances are needed on the whole surface.
  bool needs_field() const { return shows_field() || has_paths() || farthest_point; }

  // Whether answers are needed for points inside faces.
  bool needs_windows() const
  {
    return has_split_mesh() || !voronoi.empty() || picture_details.boundaries || !path_points.empty();
  }
};

namespace internal {

inline po::options_description barrier_options_description()
{
  const auto words = [](const char* name) { return po::value<Words>()->value_name(name); };
  po::options_description barriers("Barriers (repeatable)");
  barriers.add_options()("barrier", words("FILE"), "no path crosses these polylines, put on the surface as those of sources")(
    "barrier-sharp-edges", words("DEG"),
    "no path crosses the edges where the normals of the two faces differ by more than DEG degrees")(
    "region", words("FILE"), "only the part of the surface inside of an odd number of these closed polylines is kept");
  return barriers;
}

inline Barrier_options barrier_options(const po::variables_map& map)
{
  return {option_words(map, "barrier"), option_words(map, "region"), angles(map, "barrier-sharp-edges")};
}

inline po::options_description options_description()
{
  po::options_description all("geodesic_offset MESH [sources] [levels] [queries] [outputs]\n\n"
                              "Exact geodesic distances on a triangle mesh and exact geodesic offsets of curves.\n"
                              "MESH is an .off, .obj, .ply or .stl file");
  po::options_description others("Others");
  add_border_options(others);
  others.add_options()("threads", po::value<std::string>()->value_name("N"),
                       "work with at most N threads (default: those of the machine)")(
    "quiet", po::bool_switch(), "print only warnings and errors")("version", po::bool_switch(),
                                                                  "print the version")("help", po::bool_switch(), "print this");
  all.add(source_options_description())
    .add(barrier_options_description())
    .add(level_options_description())
    .add(query_options_description())
    .add(output_options_description())
    .add(others);
  return all;
}

// Throws Usage_error if distances within a tolerance are requested together with something that needs exact ones.
inline void check_tolerances(const po::variables_map& map, const Options& options)
{
  const std::pair<const char*, bool> exact[] = {
    {"split", !options.split.empty()},
    {"bands", !options.bands.empty()},
    {"path-from", map.count("path-from") != 0},
    {"path-from-vertex", map.count("path-from-vertex") != 0},
    {"farthest-point", options.farthest_point},
    {"voronoi", !options.voronoi.empty()},
    {"picture-with voronoi", options.picture_details.boundaries},
    {"field-details", options.field_details}};
  for(const char* tolerance : {"relative-tolerance", "merging-tolerance"})
    for(const auto& [option, is_given] : exact)
      if(map.count(tolerance) && is_given)
        throw Usage_error("--" + std::string(tolerance) + " cannot be used with --" + option + ", which needs exact distances");
}

// Takes the sides off names such as FILE:left, unless there is a file with the whole name.
inline void read_polyline_sides(Options& options)
{
  for(std::string& file : options.source_polylines)
  {
    const std::size_t colon = file.rfind(':');
    std::optional<CGAL::Offset_side> side;
    if(colon != std::string::npos && colon > 0 && !std::filesystem::exists(file)) side = offset_side(file.substr(colon + 1));
    if(side && !options.has_levels())
      throw Usage_error("--source-polyline " + quoted(file) + ": a side needs --distance or --spacing");
    if(side) file.resize(colon);
    options.polyline_sides.push_back(side);
  }
}

inline Options checked_options(const po::variables_map& map)
{
  Options options;
  read_source_options(map, options);
  options.barriers = barrier_options(map);
  options.have_start_values = true;
  read_level_options(map, options);
  read_polyline_sides(options);
  read_query_options(map, options);
  read_output_options(map, options);
  options.threads = number_of_threads(map);
  options.borders = border_joining(map);
  options.quiet = map["quiet"].as<bool>();
  if(options.has_split_mesh() && !options.takes_everything())
    throw Usage_error(std::string(options.split.empty() ? "--bands" : "--split") +
                      " needs the offsets on both sides with round ends, without --side and --end");
  check_tolerances(map, options);
  check_different_files(options.files_read(), options.files_written());
  return options;
}

} // namespace internal

inline void print_help(std::ostream& out) { out << internal::options_description() << '\n' << polyline_format_help(); }

// Throws Usage_error.
inline Options parse_options(int argc, const char* const* argv)
{
  const boost::program_options::variables_map map = internal::parsed_command_line(argc, argv, internal::options_description());
  Options options;
  options.help = map["help"].as<bool>();
  options.version = map["version"].as<bool>();
  return options.help || options.version ? options : internal::checked_options(map);
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_OPTIONS_H
