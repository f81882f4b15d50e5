// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the user asked for. Everything that can be judged without opening a file is judged here.

#ifndef GEODESIC_OFFSET_OPTIONS_H
#define GEODESIC_OFFSET_OPTIONS_H

#include "command_line.h"
#include "common.h"
#include "numbers.h"
#include "source_options.h"
#include "threads.h"

#include <array>
#include <cstddef>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace geodesic_offset {

struct Options : Source_options
{
  std::vector<double>        distances;
  std::optional<double>      spacing;
  std::optional<std::size_t> count;
  std::optional<double>      maximum_distance;
  std::optional<double>      tolerance;
  std::optional<std::size_t> threads;
  CGAL::Offset_selection     selection;

  std::vector<std::string>             outputs;
  std::string                          field;
  std::string                          picture;
  std::string                          stats;
  std::optional<std::array<double, 3>> view;
  std::optional<std::array<double, 3>> up;
  bool                                 stitch = true;
  bool                                 quiet = false;
  bool                                 help = false;

  bool has_levels() const { return !distances.empty() || spacing; }
};

namespace internal {

inline po::options_description options_description()
{
  po::options_description all("geodesic_offset MESH [sources] [levels] [outputs]\n\n"
                              "Exact geodesic distances on a triangle mesh and exact geodesic offsets of curves.\n"
                              "MESH is an .off, .obj, .ply or .stl file");
  const auto words = [](const char* name) { return po::value<Words>()->value_name(name); };
  const auto word = [](const char* name) { return po::value<std::string>()->value_name(name); };

  po::options_description levels("Levels");
  levels.add_options()
    ("distance", words("D"), "offset at distance D (repeatable)")
    ("spacing", word("S"), "offsets at S, 2 S, 3 S, ... until the whole surface is covered")
    ("count", word("N"), "no more than N of them")
    ("maximum-distance", word("D"), "compute nothing farther than D")
    ("side", word("SIDE"), "side of polylines and sections: both (default), left, right, or of closed ones inside, outside")
    ("end", word("END"), "offsets beyond the ends of open polylines: round (default with both sides) or butt, which means "
                         "none (default with one side)")
    ("tolerance", word("T"), "chord tolerance of the written polylines (default: 1e-4 of the bounding-box diagonal)");

  po::options_description outputs("Outputs and others");
  outputs.add_options()
    ("output", words("FILE"), "offsets as .polylines.txt, .vtk, .obj, .dxf or, if they lie in one plane, .svg "
                              "(repeatable)")
    ("field", word("FILE.ply"), "the input's vertices with their distances, signed ones too if there are polylines, "
                              "and its faces")
    ("picture", word("FILE.png"), "the mesh coloured by distance, with sources and offsets drawn on it")
    ("view", word("X,Y,Z"), "direction from the mesh to the viewer of the picture")
    ("up", word("X,Y,Z"), "direction that points up in the picture (default: 0,1,0)")
    ("stats", word("FILE.json"), "sizes, times, windows, memory, curves")
    ("no-stitch", po::bool_switch(), "leave border edges of the mesh apart that lie at the same place")
    ("threads", word("N"), "work with no more than N threads (default: as many as there are)")
    ("quiet", po::bool_switch(), "print nothing but errors")
    ("help", po::bool_switch(), "print this");

  all.add(source_options_description()).add(levels).add(outputs);
  return all;
}

inline std::array<double, 3> direction(const std::string& option, const std::string& word)
{
  const std::array<double, 3> d = numbers<3>(option, word);
  if(d[0] == 0 && d[1] == 0 && d[2] == 0)
    throw Usage_error("--" + option + " must not be the zero vector");
  return d;
}

inline CGAL::Offset_selection selection(const std::string& side, const std::string& end)
{
  using CGAL::Offset_end;
  using CGAL::Offset_side;
  CGAL::Offset_selection result;
  if(side == "left")
    result.side = Offset_side::LEFT;
  else if(side == "right")
    result.side = Offset_side::RIGHT;
  else if(side == "inside")
    result.side = Offset_side::INSIDE;
  else if(side == "outside")
    result.side = Offset_side::OUTSIDE;
  else if(!side.empty() && side != "both")
    throw Usage_error("--side must be left, right, both, inside or outside, not " + quoted(side));

  // what lies beyond an end is on neither side
  result.end = (result.side == Offset_side::BOTH) ? Offset_end::ROUND : Offset_end::BUTT;
  if(end == "round")
    result.end = Offset_end::ROUND;
  else if(end == "butt")
    result.end = Offset_end::BUTT;
  else if(!end.empty())
    throw Usage_error("--end must be round or butt, not " + quoted(end));
  return result;
}

inline void check_outputs(const Options& options)
{
  for(const std::string& output : options.outputs)
  {
    bool known = false;
    for(const char* extension : {".polylines.txt", ".vtk", ".obj", ".dxf", ".svg"})
      known = known || has_extension(output, extension);
    if(!known)
      throw Usage_error("--output " + quoted(output) + " must end in .polylines.txt, .vtk, .obj, .dxf or .svg");
  }
  if(!options.field.empty() && !has_extension(options.field, ".ply"))
    throw Usage_error("--field " + quoted(options.field) + " must end in .ply");
  if(!options.picture.empty() && !has_extension(options.picture, ".png"))
    throw Usage_error("--picture " + quoted(options.picture) + " must end in .png");
  if(!options.stats.empty() && !has_extension(options.stats, ".json"))
    throw Usage_error("--stats " + quoted(options.stats) + " must end in .json");
  if(!options.outputs.empty() && !options.has_levels())
    throw Usage_error("--output needs --distance or --spacing");
  if(options.view && options.picture.empty())
    throw Usage_error("--view needs --picture");
  if(options.up && options.picture.empty())
    throw Usage_error("--up needs --picture");

  // the mesh and the curves are read before anything is written: writing over them would still lose them
  const Words read = options.files();
  std::set<std::string> files(read.begin(), read.end());
  Words written = options.outputs;
  for(const std::string& file : {options.field, options.picture, options.stats})
    if(!file.empty())
      written.push_back(file);
  for(const std::string& file : written)
    if(!files.insert(file).second)
      throw Usage_error("the file " + quoted(file) + " is named twice");
}

inline std::optional<std::size_t> whole_number(const po::variables_map& map, const char* name)
{
  if(map.count(name) == 0)
    return std::nullopt;
  std::size_t number = 0;
  if(!parse_index(map[name].as<std::string>(), number) || number == 0)
    throw Usage_error("--" + std::string(name) + " must be a positive whole number, not " +
                      quoted(map[name].as<std::string>()));
  return number;
}

inline Options checked_options(const po::variables_map& map)
{
  Options options;
  const auto word = [&](const char* name) { return option_word(map, name); };
  read_source_options(map, options);

  for(const std::string& w : option_words(map, "distance"))
    options.distances.push_back(positive_number("distance", w));
  if(map.count("spacing"))
    options.spacing = positive_number("spacing", map["spacing"].as<std::string>());
  options.count = whole_number(map, "count");
  if(map.count("maximum-distance"))
    options.maximum_distance = positive_number("maximum-distance", map["maximum-distance"].as<std::string>());
  if(map.count("tolerance"))
    options.tolerance = positive_number("tolerance", map["tolerance"].as<std::string>());

  options.threads = whole_number(map, "threads");
  if(!has_threads && options.threads.value_or(1) > 1)
    throw Usage_error("--threads " + std::to_string(*options.threads) + ": the program was built without TBB");

  options.selection = selection(word("side"), word("end"));

  options.outputs = option_words(map, "output");
  options.field   = word("field");
  options.picture = word("picture");
  options.stats   = word("stats");
  if(map.count("view"))
    options.view = direction("view", map["view"].as<std::string>());
  if(map.count("up"))
    options.up = direction("up", map["up"].as<std::string>());
  options.stitch = !map["no-stitch"].as<bool>();
  options.quiet = map["quiet"].as<bool>();

  if(!options.distances.empty() && options.spacing)
    throw Usage_error("--distance and --spacing exclude each other");
  if(options.count && !options.spacing)
    throw Usage_error("--count needs --spacing");
  for(const char* option : {"side", "end"})
    if(map.count(option) && !options.has_levels())
      throw Usage_error("--" + std::string(option) + " needs --distance or --spacing");
  check_outputs(options);
  return options;
}

} // namespace internal

inline void print_help(std::ostream& out) { out << internal::options_description() << '\n'; }

// Throws Usage_error.
inline Options parse_options(int argc, const char* const* argv)
{
  const boost::program_options::variables_map map =
    internal::parsed_command_line(argc, argv, internal::options_description());
  if(map["help"].as<bool>())
  {
    Options options;
    options.help = true;
    return options;
  }
  return internal::checked_options(map);
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_OPTIONS_H
