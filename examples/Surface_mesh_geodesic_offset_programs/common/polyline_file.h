// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves in CGAL's .polylines.txt format: one curve per line, "n x1 y1 z1 ... xn yn zn". A source may have a start value behind the
// coordinates of each point.

#ifndef GEODESIC_OFFSET_POLYLINE_FILE_H
#define GEODESIC_OFFSET_POLYLINE_FILE_H

#include "file_bytes.h"
#include "messages.h"
#include "soup.h"
#include "text_scanner.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace geodesic_offset {

struct File_polyline
{
  std::size_t line = 0;
  std::vector<Point> points;
  std::vector<double> start_values; // of the points; empty: none
};

inline std::string polyline_format_help()
{
  return "A .polylines.txt file has one polyline per line: the number of its points, then their coordinates. A polyline\n"
         "that ends with its first point is closed, and '#' begins a comment. A segment and a triangle:\n"
         "  2  0 0 0  1 0 0.5\n"
         "  4  0 0 0  1 0 0  0 1 0  0 0 0\n";
}

namespace internal {

// Hint for lines in a wrong format.
inline std::string polyline_format_hint()
{
  return " (a line is a whole polyline: the number of its points, then their coordinates, as in '2  0 0 0  1 0 0.5')";
}

} // namespace internal

// Reads polylines from the bytes of a file, perhaps none. `path` is for messages. has_start_values: points may have a fourth number.
// Throws Input_error.
inline std::vector<File_polyline> parse_polylines(const std::string& path, std::string_view bytes, bool has_start_values = false)
{
  Text_scanner text(path, bytes, Text_style::with_comments);
  std::vector<File_polyline> polylines;
  for(; text.find_word(); text.next_line())
  {
    const std::string where = quoted(path) + ", line " + std::to_string(text.line()) + ": ";
    const std::string announced(text.word());
    std::size_t n = 0;
    if(!parse_index(announced, n) || n == 0)
      throw Input_error(where + quoted_word(announced) + " is not a number of points" + internal::polyline_format_hint());
    std::vector<std::string_view> words;
    while(!text.is_at_line_end()) words.push_back(text.word());
    const std::size_t size = has_start_values && words.size() / 4 == n && words.size() % 4 == 0 ? 4 : 3; // of a point
    if(words.size() / size != n || words.size() % size != 0)
      throw Input_error(where + announced.substr(0, 40) + " points need three coordinates each, there are " +
                        counted(words.size(), "number") + internal::polyline_format_hint());
    polylines.push_back({text.line(), {}, {}});
    polylines.back().points.reserve(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      double c[3] = {0, 0, 0};
      for(std::size_t k = 0; k < 3; ++k)
        if(!parse_number(words[size * i + k], c[k]))
          throw Input_error(where + "point " + std::to_string(i) + " has the coordinate " + quoted_word(words[size * i + k]) +
                            ", which is not a finite number");
      polylines.back().points.emplace_back(c[0], c[1], c[2]);
      double start = 0;
      if(size == 4 && (!parse_number(words[size * i + 3], start) || start < 0))
        throw Input_error(where + "point " + std::to_string(i) + " has the start value " + quoted_word(words[size * i + 3]) +
                          ", which is not a finite number or is negative");
      if(size == 4) polylines.back().start_values.push_back(start);
    }
  }
  return polylines;
}

// Throws Input_error.
inline std::vector<File_polyline> read_polylines(const std::string& path, bool may_be_empty = false,
                                                 bool has_start_values = false)
{
  const File_bytes bytes(path, may_be_empty);
  std::vector<File_polyline> polylines = parse_polylines(path, bytes.view(), has_start_values);
  if(polylines.empty() && !may_be_empty) throw Input_error(quoted(path) + " has no polylines");
  return polylines;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_POLYLINE_FILE_H
