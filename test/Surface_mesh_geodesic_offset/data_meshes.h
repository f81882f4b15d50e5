// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The meshes of the data directory: which can be used, and why the others cannot.

#ifndef GEODESIC_OFFSET_TEST_DATA_MESHES_H
#define GEODESIC_OFFSET_TEST_DATA_MESHES_H

#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace test {

/// The directory in the environment variable GEODESIC_OFFSET_DATA_DIR, else the one given at
/// compile time; may be empty.
inline std::string data_directory()
{
  const char* directory = std::getenv("GEODESIC_OFFSET_DATA_DIR");
  if (directory != nullptr) return directory;
#ifdef GEODESIC_OFFSET_DATA_DIR
  return GEODESIC_OFFSET_DATA_DIR;
#else
  return "";
#endif
}

/// All mesh files of the data directory, in alphabetical order.
inline std::vector<std::filesystem::path> data_files()
{
  std::vector<std::filesystem::path> result;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(data_directory(), error))
  {
    const std::string extension = entry.path().extension().string();
    if (extension == ".off" || extension == ".ply" || extension == ".stl" || extension == ".obj")
      result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Reads a mesh; the return value says why it cannot be used, and is empty if it can.
template <class TriangleMesh>
std::string read_data_mesh(const std::filesystem::path& file, std::size_t maximum_faces,
                           TriangleMesh& mesh)
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

#endif // GEODESIC_OFFSET_TEST_DATA_MESHES_H
