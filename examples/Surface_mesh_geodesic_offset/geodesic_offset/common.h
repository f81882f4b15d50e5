// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The types and the two kinds of failure that all parts of the programs share.

#ifndef GEODESIC_OFFSET_COMMON_H
#define GEODESIC_OFFSET_COMMON_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace geodesic_offset {

using Kernel   = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point    = Kernel::Point_3;
using Vector   = Kernel::Vector_3;
using Mesh     = CGAL::Surface_mesh<Point>;
using Traits   = CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>;
using Geodesic = CGAL::Surface_mesh_geodesic_offset<Traits>;

// what takes sources and locates points, whatever it computes from them
using Geodesic_sources = CGAL::Surface_mesh_geodesic_sources<Traits>;

using Vertex        = Mesh::Vertex_index;
using Halfedge      = Mesh::Halfedge_index;
using Edge          = Mesh::Edge_index;
using Face          = Mesh::Face_index;
using Face_location = Geodesic::Face_location;
using Offset_curve  = Geodesic::Offset_curve;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The command line is wrong: exit code 2.
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// The command line is right, but something that it names is not: exit code 1.
struct Input_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

inline bool has_extension(const std::string& path, const std::string& extension)
{
  return path.size() > extension.size() &&
         std::equal(extension.rbegin(), extension.rend(), path.rbegin(), [](char a, char b) {
           return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
         });
}

// Messages may hold parts of damaged files.
inline std::string one_line(std::string text)
{
  for(char& c : text)
    if(static_cast<unsigned char>(c) < 32 || c == 127)
      c = ' ';
  constexpr std::size_t longest = 500;
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

inline std::string quoted(const std::string& s) { return "'" + s + "'"; }

// "1 face", "2 faces"
inline std::string counted(std::size_t n, const std::string& singular, const std::string& plural = "")
{
  return std::to_string(n) + ' ' + (n == 1 ? singular : plural.empty() ? singular + 's' : plural);
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_COMMON_H
