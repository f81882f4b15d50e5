// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"

#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <exception>

namespace test {

std::string read_data_mesh(const std::filesystem::path& file, std::size_t maximum_faces,
                           CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  try
  {
    if (!CGAL::IO::read_polygon_mesh(file.string(), mesh)) return "not a manifold polygon mesh";
  }
  catch (const std::exception& e)
  {
    return std::string("reading it throws: ") + e.what();
  }
  if (num_faces(mesh) == 0) return "no faces";
  if (!CGAL::is_triangle_mesh(mesh)) return "not all faces are triangles";
  if (num_faces(mesh) > maximum_faces) return "more faces than the limit";
  std::size_t degenerate = 0;
  for (auto f : faces(mesh)) degenerate += PMP::is_degenerate_triangle_face(f, mesh) ? 1 : 0;
  if (degenerate > 0) return std::to_string(degenerate) + " degenerate faces";
  return "";
}

} // namespace test
