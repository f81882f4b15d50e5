// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads the bytes of a file as the programs do, and checks the guarantees of the readers.

#ifndef GEODESIC_OFFSET_TEST_READ_INPUT_H
#define GEODESIC_OFFSET_TEST_READ_INPUT_H

#include "common/polyline_file.h"
#include "common/soup_reader.h"
#include "validate_geodesic_distances/ply_table.h"
#include "validate_geodesic_distances/text_table.h"

#include <cmath>
#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

namespace test {

inline void require(bool condition, const char* what)
{
  if (!condition) throw std::logic_error(what);
}

inline void check_soup(const geodesic_offset::Soup& soup)
{
  require(!soup.points.empty() && !soup.polygons.empty(), "an empty mesh");
  for (const auto& p : soup.points)
    for (int c = 0; c < 3; ++c) require(std::isfinite(p[c]), "a coordinate that is not finite");
  for (const auto& polygon : soup.polygons)
  {
    require(polygon.size() >= 3, "a face of two vertices");
    for (std::uint32_t v : polygon) require(v < soup.points.size(), "a vertex index out of range");
  }
}

inline void check_table(const geodesic_offset::Distance_table& table, std::size_t vertices)
{
  require(table.distances.size() == vertices, "a wrong number of distances");
  for (double d : table.distances) require(d >= 0, "a negative distance");
  require(table.points.empty() || table.points.size() == vertices, "a wrong number of points");
}

/// Returns whether the file is accepted. Throws std::logic_error on any exception except an Input_error with one line that
/// names the file, and on results out of range.
inline bool read_input(const std::string& path, std::string_view bytes)
{
  using namespace geodesic_offset;
  constexpr std::size_t vertices = 5; // of the table
  const std::string mesh = "mesh.off";
  try
  {
    if (has_extension(path, ".polylines.txt"))
      for (const File_polyline& polyline : parse_polylines(path, bytes)) require(!polyline.points.empty(), "an empty polyline");
    else if (has_extension(path, ".table.ply")) check_table(Ply_table_reader(path, mesh, vertices)(bytes, ""), vertices);
    else if (has_extension(path, ".txt")) check_table(Text_table_reader(path, mesh, vertices)(bytes), vertices);
    else check_soup(parse_soup(mesh_format(path), path, bytes));
    return true;
  }
  catch (const Input_error& error)
  {
    const std::string text = error.what();
    require(text.find(quoted(path)) != std::string::npos, "an error that does not name the file");
    require(text.find('\n') == std::string::npos || one_line(text).find('\n') == std::string::npos,
            "an error of several lines");
    require(text.size() < 1000, "a long error");
    return false;
  }
  catch (const std::logic_error&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw std::logic_error(std::string("another exception: ") + error.what());
  }
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_READ_INPUT_H
