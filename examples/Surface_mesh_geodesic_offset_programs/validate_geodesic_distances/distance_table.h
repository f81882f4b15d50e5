// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Table of vertex distances, one number per vertex.

#ifndef VALIDATE_GEODESIC_DISTANCES_DISTANCE_TABLE_H
#define VALIDATE_GEODESIC_DISTANCES_DISTANCE_TABLE_H

#include "common/messages.h"
#include "common/numbers.h"
#include "common/soup.h"

#include <cctype>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace geodesic_offset {

struct Distance_table
{
  std::string name; // for messages
  std::vector<double> distances;
  std::vector<Point> points; // positions of the vertices in the table; empty if it has none
};

namespace internal {

inline bool spells_infinity(std::string word)
{
  for(char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if(word[0] == '+') word.erase(0, 1);
  return word == "inf" || word == "infinity" || word == "1.#inf";
}

// Throws Input_error that begins with `where`.
inline double parsed_distance(const std::string& where, std::size_t vertex, std::string_view word)
{
  if(!word.empty() && spells_infinity(std::string(word))) return std::numeric_limits<double>::infinity();
  double value = 0;
  const std::string what = where + "vertex " + std::to_string(vertex) + " has the distance " + quoted_word(word);
  if(!parse_number(word, value)) throw Input_error(what + ", which is neither a finite number nor inf");
  if(value < 0) throw Input_error(what + ", which is negative");
  return value;
}

} // namespace internal
} // namespace geodesic_offset

#endif // VALIDATE_GEODESIC_DISTANCES_DISTANCE_TABLE_H
