// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves in CGAL's .polylines.txt format: one curve per line, "n x1 y1 z1 ... xn yn zn".

#ifndef GEODESIC_OFFSET_POLYLINE_FILE_H
#define GEODESIC_OFFSET_POLYLINE_FILE_H

#include "common.h"
#include "numbers.h"
#include "soup_reader.h"

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace geodesic_offset {

struct File_polyline
{
  std::size_t        line = 0;
  std::vector<Point> points;
};

inline std::string polyline_format_help()
{
  return "A .polylines.txt file has one polyline per line: the number of its points, then their coordinates. A polyline\n"
         "that ends with its first point is closed, and '#' begins a comment. A segment and a triangle:\n"
         "  2  0 0 0  1 0 0.5\n"
         "  4  0 0 0  1 0 0  0 1 0  0 0 0\n";
}

namespace internal {

// What to do about a line that does not have the format
inline std::string polyline_format_hint()
{
  return " (a line is a whole polyline: the number of its points, then their coordinates, as in '2  0 0 0  1 0 0.5')";
}

} // namespace internal

// Throws Input_error.
inline std::vector<File_polyline> read_polylines(const std::string& path)
{
  std::ifstream stream = internal::open_input(path);
  std::vector<File_polyline> polylines;
  std::size_t number = 0;
  for(std::string line; std::getline(stream, line);)
  {
    ++number;
    const std::vector<std::string> words = words_of(line.substr(0, line.find('#')));
    if(words.empty())
      continue;
    const std::string where = quoted(path) + ", line " + std::to_string(number) + ": ";
    std::size_t n = 0;
    if(!parse_index(words[0], n) || n == 0)
      throw Input_error(where + quoted(words[0].substr(0, 40)) + " is not a number of points" +
                        internal::polyline_format_hint());
    if((words.size() - 1) / 3 != n || (words.size() - 1) % 3 != 0)
      throw Input_error(where + words[0].substr(0, 40) + " points need three coordinates each, there are " +
                        counted(words.size() - 1, "number") + internal::polyline_format_hint());
    polylines.push_back({number, {}});
    for(std::size_t i = 0; i < n; ++i)
    {
      double c[3] = {0, 0, 0};
      for(std::size_t k = 0; k < 3; ++k)
        if(!parse_number(words[1 + 3 * i + k], c[k]))
          throw Input_error(where + "point " + std::to_string(i) + " has the coordinate " +
                            quoted(words[1 + 3 * i + k].substr(0, 40)) + ", which is not a finite number");
      polylines.back().points.emplace_back(c[0], c[1], c[2]);
    }
  }
  if(stream.bad())
    throw Input_error("cannot read " + quoted(path));
  if(polylines.empty())
    throw Input_error(quoted(path) + " has no polylines");
  return polylines;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_POLYLINE_FILE_H
