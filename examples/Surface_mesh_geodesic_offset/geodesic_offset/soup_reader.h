// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// From a file to points and polygons, with everything checked that the file alone can tell.

#ifndef GEODESIC_OFFSET_SOUP_READER_H
#define GEODESIC_OFFSET_SOUP_READER_H

#include "common.h"
#include "file_diagnosis.h"
#include "memory_guard.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace geodesic_offset {

using Polygon = std::vector<std::uint32_t>;

// Vertices and faces in the order of the file
struct Soup
{
  std::vector<Point>   points;
  std::vector<Polygon> polygons;
};

namespace internal {

enum class Format { off, obj, ply, stl };

inline Format format_of(const std::string& path)
{
  if(has_extension(path, ".off")) return Format::off;
  if(has_extension(path, ".obj")) return Format::obj;
  if(has_extension(path, ".ply")) return Format::ply;
  if(has_extension(path, ".stl")) return Format::stl;
  throw Input_error(quoted(path) + " must end in .off, .obj, .ply or .stl");
}

inline std::ifstream open_input(const std::string& path)
{
  std::error_code error;
  if(std::filesystem::is_directory(path, error))
    throw Input_error("cannot read " + quoted(path) + ": it is a directory");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if(!stream)
    throw Input_error("cannot read " + quoted(path) + ": " + (errno ? std::strerror(errno) : "unknown error"));
  if(stream.peek() == std::ifstream::traits_type::eof())
    throw Input_error(quoted(path) + " is empty");
  return stream;
}

inline bool read_format(Format format, std::istream& in, Soup& soup)
{
  const auto silent = CGAL::parameters::verbose(false);
  switch(format)
  {
  case Format::off: return CGAL::IO::read_OFF(in, soup.points, soup.polygons, silent);
  case Format::obj: return CGAL::IO::read_OBJ(in, soup.points, soup.polygons, silent);
  case Format::ply: return CGAL::IO::read_PLY(in, soup.points, soup.polygons, silent);
  case Format::stl: return CGAL::IO::read_STL(in, soup.points, soup.polygons, silent);
  }
  return false;
}

inline std::string diagnose(Format format, std::istream& in)
{
  switch(format)
  {
  case Format::off: return diagnose_off(in);
  case Format::obj: return diagnose_obj(in);
  case Format::ply: return diagnose_ply(in);
  case Format::stl: return diagnose_stl(in);
  }
  return std::string();
}

[[noreturn]] inline void fail_to_read(const std::string& path, Format format)
{
  std::ifstream stream = open_input(path);
  const std::string reason = diagnose(format, stream);
  throw Input_error("cannot read " + quoted(path) + ": " +
                    (reason.empty() ? "the file is truncated or malformed" : reason));
}

inline void check_soup(const std::string& path, Format format, const Soup& soup)
{
  if(soup.points.empty() || soup.polygons.empty())
    fail_to_read(path, format);
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    for(int c = 0; c < 3; ++c)
      if(!std::isfinite(soup.points[i][c]))
        throw Input_error(quoted(path) + ": vertex " + std::to_string(i) + " has a coordinate that is not finite");
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    const Polygon& polygon = soup.polygons[i];
    if(polygon.size() < 3)
      throw Input_error(quoted(path) + ": face " + std::to_string(i) + " has only " +
                        counted(polygon.size(), "vertex", "vertices"));
    for(std::uint32_t v : polygon)
      if(v >= soup.points.size())
      {
        // the formats count differently, so they have the better words for it
        std::ifstream stream = open_input(path);
        const std::string reason = diagnose(format, stream);
        throw Input_error(quoted(path) + ": " +
                          (reason.empty() ? "face " + std::to_string(i) + " has the vertex index " +
                                              std::to_string(static_cast<std::int32_t>(v)) + ", but there are " +
                                              std::to_string(soup.points.size()) + " vertices"
                                          : reason));
      }
  }
}

} // namespace internal

// Throws Input_error.
inline Soup read_soup(const std::string& path)
{
  const internal::Format format = internal::format_of(path);
  Soup soup;
  bool read = false;
  {
    if(format == internal::Format::ply)
    {
      std::ifstream stream = internal::open_input(path);
      const std::string reason = internal::diagnose_ply_header(stream);
      if(!reason.empty())
        throw Input_error("cannot read " + quoted(path) + ": " + reason);
    }
    std::ifstream stream = internal::open_input(path);
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    try
    {
      // without a size (a pipe), there is no measure for what is too much
      if(error)
        read = internal::read_format(format, stream, soup);
      else
      {
        const Memory_guard guard(size);
        read = internal::read_format(format, stream, soup);
      }
    }
    catch(const std::bad_alloc&) { read = false; }
    catch(const std::length_error&) { read = false; }
    if(stream.bad() && soup.polygons.empty())
      read = false;
  }
  if(!read)
  {
    soup = Soup();
    internal::fail_to_read(path, format);
  }
  internal::check_soup(path, format, soup);
  return soup;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_SOUP_READER_H
