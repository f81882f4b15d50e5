// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Time of builds with a relative tolerance beside exact ones, from one vertex, on one thread.
//
//   tolerance_times [--rounds N] [--vertices N] [MESH ...]        default: 5 rounds, 262144 vertices
//
// A Markdown table for each mesh, the last of which is a generated wavy torus with about the given number of vertices (none for
// 0). Each round builds with every tolerance once, so that other work on the machine slows all of them down; the fastest build
// of each counts. The seconds are processor time.

#include "wavy_torus.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;

const std::vector<double> tolerances = {0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2};

void compare(const std::string& name, const Mesh& mesh, Mesh::Vertex_index source, std::size_t rounds)
{
  std::vector<double> seconds(tolerances.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> windows(tolerances.size());
  for (std::size_t round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < tolerances.size(); ++i)
    {
      Geodesic geodesic(mesh);
      geodesic.add_source_point(source);
      const std::clock_t start = std::clock();
      geodesic.build(CGAL::parameters::relative_tolerance(tolerances[i]));
      const double time = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      seconds[i] = (std::min)(seconds[i], time);
      windows[i] = geodesic.statistics().windows_propagated;
    }
  std::printf("\n%s, %zu vertices\n\n| tolerance | seconds | of exact | windows per vertex |\n|---|---|---|---|\n",
              name.c_str(), static_cast<std::size_t>(mesh.number_of_vertices()));
  for (std::size_t i = 0; i < tolerances.size(); ++i)
    std::printf("| %.0e | %.4f | %.3f | %.2f |\n", tolerances[i], seconds[i], seconds[i] / seconds[0],
                static_cast<double>(windows[i]) / static_cast<double>(mesh.number_of_vertices()));
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[])
{
  std::size_t rounds = 5, vertices = 262144;
  std::vector<std::string> files;
  try
  {
    for (int i = 1; i < argc; ++i)
      if (argv[i] == std::string("--rounds") && i + 1 < argc) rounds = std::stoul(argv[++i]);
      else if (argv[i] == std::string("--vertices") && i + 1 < argc) vertices = std::stoul(argv[++i]);
      else files.emplace_back(argv[i]);
    for (const std::string& file : files)
    {
      Mesh mesh;
      if (!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh) || is_empty(mesh))
      {
        std::cerr << "tolerance_times: " << file << " is not a manifold triangle mesh\n";
        return 1;
      }
      compare(file.substr(file.find_last_of('/') + 1), mesh, *mesh.vertices().begin(), rounds);
    }
    if (vertices > 0)
    {
      const benchmark::Wavy_torus<Mesh> torus(vertices);
      compare("wavy torus", torus.mesh, torus.spread_vertices(1)[0], rounds);
    }
  }
  catch (const std::exception& e)
  {
    std::cerr << "tolerance_times: " << e.what() << '\n';
    return 1;
  }
  return 0;
}
