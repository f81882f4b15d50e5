// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Options for the distances of the offsets, and for sides and ends.

#ifndef GEODESIC_OFFSET_LEVEL_OPTIONS_H
#define GEODESIC_OFFSET_LEVEL_OPTIONS_H

#include "common/command_line.h"
#include "common/common.h"
#include "common/numbers.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace geodesic_offset {

struct Level_options
{
  std::vector<double> distances;
  std::optional<double> spacing;
  std::optional<double> start; // of the spacing
  std::optional<std::size_t> count; // of the spacing
  std::optional<double> maximum_distance;
  double relative_tolerance = 0; // of distances
  double merging_tolerance = 0;
  std::string side; // empty: not given
  std::string end; // empty: not given
  CGAL::Offset_side selected_side = CGAL::Offset_side::BOTH; // of polylines without their own side
  std::optional<CGAL::Offset_end> selected_end;

  bool has_levels() const { return !distances.empty() || spacing; }

  // Whether distances may be smaller than the exact ones.
  bool has_tolerance() const { return relative_tolerance > 0 || merging_tolerance > 0; }

  // Whether the number of levels depends on the extent of the surface.
  bool is_open_ended() const { return spacing && !count; }
};

namespace internal {

inline po::options_description level_options_description()
{
  const auto words = [](const char* name) { return po::value<Words>()->value_name(name); };
  const auto word = [](const char* name) { return po::value<std::string>()->value_name(name); };
  po::options_description levels("Levels");
  levels.add_options()("distance", words("D,..."),
                       "offset at distance D, or at several, separated by commas (repeatable, also together with --spacing)")(
    "spacing", word("S"), "offsets at S, 2 S, 3 S, ... until the whole surface is covered")(
    "start", word("D"),
    "with --spacing: offsets at D, D + S, D + 2 S, ... instead")("count", word("N"), "with --spacing: at most N of them")(
    "maximum-distance", word("D"), "do not compute points farther than D")(
    "relative-tolerance", word("T"),
    "distances may be smaller than the exact ones by a fraction T of them, which saves time on fine "
    "smooth meshes; --stats has the bound that was reached")("merging-tolerance", word("L"),
                                                             "distances may be smaller than the exact ones by a length L")(
    "side", word("SIDE"),
    "side of polylines and sections: both (default), left, right, or of closed ones inside, which is the side without border of "
    "the surface or else of smaller area, outside")(
    "end", word("END"),
    "offsets beyond the ends of open polylines: round (default of both sides) or butt, which means "
    "none (default of one side)");
  return levels;
}

// Empty if the word is no side.
inline std::optional<CGAL::Offset_side> offset_side(const std::string& word)
{
  using CGAL::Offset_side;
  if(word == "both") return Offset_side::BOTH;
  if(word == "left") return Offset_side::LEFT;
  if(word == "right") return Offset_side::RIGHT;
  if(word == "inside") return Offset_side::INSIDE;
  if(word == "outside") return Offset_side::OUTSIDE;
  return std::nullopt;
}

inline std::optional<CGAL::Offset_end> offset_end(const std::string& word)
{
  if(word.empty()) return std::nullopt;
  if(word != "round" && word != "butt") throw Usage_error("--end must be round or butt, not " + quoted(word));
  return word == "round" ? CGAL::Offset_end::ROUND : CGAL::Offset_end::BUTT;
}

inline void read_level_options(const po::variables_map& map, Level_options& options)
{
  for(const std::string& words : option_words(map, "distance"))
    for(std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1)
    {
      end = words.find(',', begin);
      options.distances.push_back(positive_number("distance", words.substr(begin, end - begin)));
    }
  options.spacing = optional_positive_number(map, "spacing");
  options.start = optional_positive_number(map, "start");
  options.count = optional_whole_number(map, "count");
  options.maximum_distance = optional_positive_number(map, "maximum-distance");
  options.relative_tolerance = optional_positive_number(map, "relative-tolerance").value_or(0);
  if(options.relative_tolerance > 0.5)
    throw Usage_error("--relative-tolerance must be at most 0.5, not " + short_number(options.relative_tolerance));
  options.merging_tolerance = optional_positive_number(map, "merging-tolerance").value_or(0);
  options.side = option_word(map, "side");
  options.end = option_word(map, "end");
  if(!options.side.empty())
  {
    const std::optional<CGAL::Offset_side> side = offset_side(options.side);
    if(!side) throw Usage_error("--side must be left, right, both, inside or outside, not " + quoted(options.side));
    options.selected_side = *side;
  }
  options.selected_end = offset_end(options.end);

  for(const char* option : {"start", "count"})
    if(map.count(option) && !options.spacing) throw Usage_error("--" + std::string(option) + " needs --spacing");
  for(const char* option : {"side", "end"})
    if(map.count(option) && !options.has_levels())
      throw Usage_error("--" + std::string(option) + " needs --distance or --spacing");
}

} // namespace internal
} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_LEVEL_OPTIONS_H
