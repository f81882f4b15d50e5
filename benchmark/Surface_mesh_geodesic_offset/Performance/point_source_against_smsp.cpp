// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// One vertex source, all vertex distances: CGAL::Surface_mesh_shortest_path against Surface_mesh_geodesic_offset in one
// run, each in a separate process, as a Markdown table. Times include construction, build and all queries. With TBB, the
// column "several threads" is for Parallel_tag; the others are for one thread.
//
//   point_source_against_smsp [--vertex I] [--repeat N] MESH...
//
// The medians of N runs each; default: 0, 1. Recommended meshes of CGAL's data/meshes: bunny00.off, refined_elephant.off,
// armadillo.off.

#include "measured_run.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> Shortest_path;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;
using benchmark::Measured_run;

template <class Computation>
Measured_run median_run(std::size_t repetitions, const Computation& computation)
{
  std::vector<Measured_run> runs;
  for (std::size_t i = 0; i < repetitions; ++i) runs.push_back(benchmark::measured_run(computation));
  std::sort(runs.begin(), runs.end(), [](const Measured_run& a, const Measured_run& b) { return a.seconds < b.seconds; });
  return runs[runs.size() / 2];
}

template <class Concurrency_tag>
Measured_run our_run(const Mesh& mesh, Mesh::Vertex_index source, std::size_t repetitions)
{
  return median_run(repetitions, [&](std::vector<double>& distances, std::uint64_t& windows) {
    Geodesic geodesic(mesh, CGAL::parameters::concurrency_tag(Concurrency_tag()));
    geodesic.add_source_point(source);
    geodesic.build(CGAL::parameters::concurrency_tag(Concurrency_tag()));
    for (Mesh::Vertex_index v : vertices(mesh)) distances.push_back(geodesic.distance_to_sources(v));
    windows = geodesic.statistics().windows_propagated;
  });
}

bool compare(const std::string& file, std::size_t source, std::size_t repetitions)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh) || source >= num_vertices(mesh))
  {
    std::cerr << file << " is not a manifold triangle mesh with a vertex " << source << '\n';
    return false;
  }
  const Mesh::Vertex_index s(static_cast<Mesh::size_type>(source));
  const Measured_run theirs = median_run(repetitions, [&](std::vector<double>& distances, std::uint64_t&) {
    Shortest_path shortest_path(mesh);
    shortest_path.add_source_point(s);
    shortest_path.build_sequence_tree();
    for (Mesh::Vertex_index v : vertices(mesh))
    {
      const double d = mesh.is_isolated(v) ? -1 : shortest_path.shortest_distance_to_source_points(v).first;
      distances.push_back(d < 0 ? std::numeric_limits<double>::infinity() : d);
    }
  });
  const Measured_run ours = our_run<CGAL::Sequential_tag>(mesh, s, repetitions);
  const Measured_run parallel = our_run<CGAL::Parallel_if_available_tag>(mesh, s, repetitions);

  double worst = 0;
  for (const Measured_run* run : {&ours, &parallel})
    for (std::size_t i = 0; i < theirs.distances.size(); ++i)
    {
      const double d = run->distances[i], e = theirs.distances[i];
      if (d != e) worst = (std::max)(worst, std::abs(d - e) / e);
    }
  const auto megabytes = [](const Measured_run& run) { return static_cast<double>(run.peak_bytes) / 1e6; };
  std::cout << std::fixed << "| " << std::filesystem::path(file).stem().string() << " | " << num_vertices(mesh) << " | "
            << num_faces(mesh) << " | " << std::setprecision(3) << theirs.seconds << " | " << ours.seconds << " | "
            << std::setprecision(1) << theirs.seconds / ours.seconds << " | ";
  if (std::is_same<CGAL::Parallel_if_available_tag, CGAL::Parallel_tag>::value)
    std::cout << std::setprecision(3) << parallel.seconds << " | " << std::setprecision(1) << theirs.seconds / parallel.seconds
              << " | ";
  else std::cout << "- | - | ";
  std::cout << megabytes(theirs) << " | " << megabytes(ours) << " | " << megabytes(theirs) / megabytes(ours) << " | "
            << ours.windows << " | " << std::setprecision(2)
            << static_cast<double>(ours.windows) / static_cast<double>(num_vertices(mesh)) << " | " << std::scientific
            << std::setprecision(1) << worst << " |" << std::endl;
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  std::size_t source = 0, repetitions = 1;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if ((word == "--vertex" || word == "--repeat") && i + 1 < argc)
      (word == "--vertex" ? source : repetitions) = std::stoul(argv[++i]);
    else files.push_back(word);
  }
  if (files.empty() || repetitions == 0)
  {
    std::cerr << "usage: point_source_against_smsp [--vertex I] [--repeat N] MESH...\n";
    return 2;
  }
  std::cout << "| mesh | vertices | faces | SMSP s | ours s | times faster | several threads s | "
               "times faster | SMSP MB | ours MB | times less | windows propagated | per vertex | "
               "worst relative difference |\n"
               "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  bool ok = true;
  for (const std::string& file : files) try
    {
      ok = compare(file, source, repetitions) && ok;
    }
    catch (const std::exception& e)
    {
      std::cerr << file << ": " << e.what() << '\n';
      ok = false;
    }
  return ok ? 0 : 1;
}
