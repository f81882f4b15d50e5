// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// From a mesh file to points and polygons: every polygon has at least three corners, and every corner is a point with finite
// coordinates. Each format has a reader, which checks every count, type and index before it uses it.

#ifndef GEODESIC_OFFSET_SOUP_READER_H
#define GEODESIC_OFFSET_SOUP_READER_H

#include "file_bytes.h"
#include "messages.h"
#include "obj_reader.h"
#include "off_reader.h"
#include "ply_reader.h"
#include "soup.h"
#include "stl_reader.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace geodesic_offset {

enum class Mesh_format { off, obj, ply, stl };

namespace internal {

// Surface_mesh numbers halfedges with 32 bits. Polygons with n corners become triangles with less than 3 n corners in
// total, and every triangle may have three edges of its own.
constexpr std::size_t most_corners = (std::size_t(1) << 32) / 6;

// Checks common to all formats.
inline void check_soup(const std::string& path, const Soup& soup)
{
  std::size_t corners = 0;
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    const std::size_t size = soup.polygons[i].size();
    if(size < 3)
      throw Input_error(quoted(path) + ": face " + std::to_string(i) + " has only " + counted(size, "vertex", "vertices"));
    corners += size;
  }
  if(soup.points.size() > most_corners || corners > most_corners)
    throw Input_error(quoted(path) + " has " + counted(soup.points.size(), "vertex", "vertices") + " and " +
                      counted(corners, "corner") + " of faces; the largest number of each is " + std::to_string(most_corners));
  for(const Polygon& polygon : soup.polygons)
    for(std::uint32_t v : polygon)
    {
      const Point& p = soup.points[v];
      if(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())) continue;
      for(const auto& [vertex, message] : soup.not_finite)
        if(vertex == v) throw Input_error(message);
      throw Input_error(quoted(path) + ": vertex " + std::to_string(v) + " has a coordinate that is not finite");
    }
}

} // namespace internal

// Throws Input_error.
inline Mesh_format mesh_format(const std::string& path)
{
  if(has_extension(path, ".off")) return Mesh_format::off;
  if(has_extension(path, ".obj")) return Mesh_format::obj;
  if(has_extension(path, ".ply")) return Mesh_format::ply;
  if(has_extension(path, ".stl")) return Mesh_format::stl;
  throw Input_error(quoted(path) + " must end in .off, .obj, .ply or .stl");
}

// Reads a mesh from the bytes of a file in linear time and memory. `path` is for messages. Throws Input_error.
inline Soup parse_soup(Mesh_format format, const std::string& path, std::string_view bytes)
{
  Soup soup;
  switch(format)
  {
  case Mesh_format::off: internal::Off_reader(path, bytes, soup)(); break;
  case Mesh_format::obj: internal::Obj_reader(path, bytes, soup)(); break;
  case Mesh_format::ply: internal::Ply_reader(path, bytes, soup)(); break;
  case Mesh_format::stl: internal::Stl_reader(path, bytes, soup)(); break;
  }
  internal::check_soup(path, soup);
  return soup;
}

// Throws Input_error.
inline Soup read_soup(const std::string& path)
{
  const Mesh_format format = mesh_format(path);
  const File_bytes bytes(path);
  return parse_soup(format, path, bytes.view());
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_SOUP_READER_H
