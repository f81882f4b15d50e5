// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Words and numbers of the command line. All errors are Usage_errors.

#ifndef GEODESIC_OFFSET_COMMAND_LINE_H
#define GEODESIC_OFFSET_COMMAND_LINE_H

#include "common.h"
#include "numbers.h"

#include <boost/program_options.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace geodesic_offset::internal {

namespace po = boost::program_options;
using Words = std::vector<std::string>;

inline double positive_number(const std::string& option, const std::string& word)
{
  double value = 0;
  if(!parse_number(word, value) || !(value > 0))
    throw Usage_error("--" + option + " must be a positive finite number, not " + quoted(word));
  return value;
}

// Numbers such as "0,0,1,0".
template <std::size_t N>
std::array<double, N> numbers(const std::string& option, const std::string& word)
{
  std::array<double, N> values{};
  if(!parse_numbers(word, values))
    throw Usage_error("--" + option + " must be " + std::to_string(N) +
                      " finite numbers separated by commas without blanks, not " + quoted(word));
  return values;
}

inline std::optional<std::array<double, 3>> optional_point(const po::variables_map& map, const char* name)
{
  if(map.count(name) == 0) return std::nullopt;
  return numbers<3>(name, map[name].as<std::string>());
}

inline std::optional<std::array<double, 3>> direction(const po::variables_map& map, const char* name)
{
  const std::optional<std::array<double, 3>> d = optional_point(map, name);
  if(d && (*d)[0] == 0 && (*d)[1] == 0 && (*d)[2] == 0)
    throw Usage_error("--" + std::string(name) + " must not be the zero vector");
  return d;
}

// All values of an option, possibly none.
inline Words option_words(const po::variables_map& map, const char* name)
{
  return map.count(name) ? map[name].as<Words>() : Words();
}

// Empty if the option was not given.
inline std::string option_word(const po::variables_map& map, const char* name)
{
  if(map.count(name) == 0) return std::string();
  if(map[name].as<std::string>().empty()) throw Usage_error("--" + std::string(name) + " is empty");
  return map[name].as<std::string>();
}

inline std::optional<double> optional_positive_number(const po::variables_map& map, const char* name)
{
  if(map.count(name) == 0) return std::nullopt;
  return positive_number(name, map[name].as<std::string>());
}

inline std::optional<std::size_t> optional_whole_number(const po::variables_map& map, const char* name)
{
  if(map.count(name) == 0) return std::nullopt;
  const std::string& word = map[name].as<std::string>();
  std::size_t number = 0;
  if(!parse_index(word, number) || number == 0)
    throw Usage_error("--" + std::string(name) + " must be a positive whole number, not " + quoted(word));
  return number;
}

// Indices of vertices.
inline std::vector<std::size_t> indices(const po::variables_map& map, const char* name)
{
  std::vector<std::size_t> result;
  for(const std::string& w : option_words(map, name))
  {
    result.emplace_back();
    if(!parse_index(w, result.back()))
      throw Usage_error("--" + std::string(name) + " must be a vertex index, not " + quoted(w));
  }
  return result;
}

// Angles between the normals of faces, in degrees.
inline std::vector<double> angles(const po::variables_map& map, const char* name)
{
  std::vector<double> result;
  for(const std::string& w : option_words(map, name))
  {
    result.emplace_back();
    if(!parse_number(w, result.back()) || result.back() < 0 || result.back() >= 180)
      throw Usage_error("--" + std::string(name) + " must be an angle in degrees from 0 to less than 180, not " + quoted(w));
  }
  return result;
}

// Parses the options of the description, and words without an option as "mesh".
inline po::variables_map parsed_command_line(int argc, const char* const* argv, const po::options_description& description)
{
  po::options_description all = description;
  all.add_options()("mesh", po::value<Words>());
  po::positional_options_description positional;
  positional.add("mesh", -1);

  po::variables_map map;
  if(argc > 1 && *argv[1] == '\0') throw Usage_error("the name of MESH is empty");
  try
  {
    // no abbreviations: a misspelt option must not be taken for another one
    using Style = po::command_line_style::style_t;
    const int style = Style::allow_long | Style::long_allow_adjacent | Style::long_allow_next;
    const po::parsed_options parsed =
      po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run();
    for(const po::option& option : parsed.options)
      for(const std::string& value : option.value)
        if(option.position_key < 0 && value.compare(0, 2, "--") == 0)
          throw Usage_error("--" + option.string_key + " needs a value");
    po::store(parsed, map);
    po::notify(map);
  }
  catch(const po::invalid_command_line_syntax& error)
  {
    // nothing follows the option or its equal sign
    if(error.kind() == error.missing_parameter || error.kind() == error.empty_adjacent_parameter)
      throw Usage_error(error.get_option_name() + " needs a value");
    throw Usage_error(error.what());
  }
  catch(const po::error& error)
  {
    throw Usage_error(error.what());
  }
  return map;
}

} // namespace geodesic_offset::internal

#endif // GEODESIC_OFFSET_COMMAND_LINE_H
