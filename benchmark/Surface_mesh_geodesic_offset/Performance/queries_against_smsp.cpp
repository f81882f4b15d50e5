// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// One vertex source, queries at random points inside faces: CGAL::Surface_mesh_shortest_path against
// Surface_mesh_geodesic_offset in one run, each in a separate process, as a Markdown table: queries per second, for the
// distance and for the whole path as points in space; memory per vertex, of the tree (growth of the peak) and of the kept
// windows (as reported, and growth of the peak).
//
//   queries_against_smsp [--queries N] [--vertex I] [--repeat N] MESH...
//
// default: 10000, 0, 1; the fastest of N runs counts. Recommended meshes of CGAL's data/meshes: bunny00.off,
// refined_elephant.off, armadillo.off.

#include "measured_run.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> Shortest_path;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;
typedef Geodesic::Face_location Face_location;
using benchmark::Measured_run;

struct Options
{
  std::size_t queries = 10000, vertex = 0, repetitions = 1;
};

std::vector<Face_location> random_points(const Mesh& mesh, std::size_t count)
{
  std::mt19937 random(1);
  const auto uniform = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
  std::vector<Face_location> result;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto face = static_cast<Mesh::size_type>(uniform() * static_cast<double>(num_faces(mesh)));
    std::array<double, 3> w;
    double sum = 0;
    for (double& x : w) sum += x = -std::log(uniform());
    for (double& x : w) x /= sum;
    result.emplace_back(Mesh::Face_index(face), w);
  }
  return result;
}

double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Figures before the distances in the output of a process: seconds of the build, of all distances and of all paths; bytes
// of kept windows; points of all paths.
enum { BUILD, DISTANCES, PATHS, KEPT_BYTES, PATH_POINTS, NUMBER_OF_FIGURES };

template <class Build, class Distance, class Path>
void measure(const std::vector<Face_location>& points, std::vector<double>& out, const Build& build, const Distance& distance,
             const Path& path)
{
  out.assign(NUMBER_OF_FIGURES, 0);
  out.reserve(NUMBER_OF_FIGURES + points.size());
  auto start = std::chrono::steady_clock::now();
  out[KEPT_BYTES] = static_cast<double>(build());
  out[BUILD] = seconds_since(start);
  start = std::chrono::steady_clock::now();
  for (const Face_location& p : points) out.push_back(distance(p));
  out[DISTANCES] = seconds_since(start);
  std::vector<Point_3> way;
  std::size_t count = 0;
  start = std::chrono::steady_clock::now();
  for (const Face_location& p : points)
  {
    way.clear();
    path(p, std::back_inserter(way));
    count += way.size();
  }
  out[PATHS] = seconds_since(start);
  out[PATH_POINTS] = static_cast<double>(count);
}

// The fastest times of several runs.
template <class Computation>
Measured_run fastest_run(std::size_t repetitions, const Computation& computation)
{
  Measured_run best = benchmark::measured_run(computation);
  for (std::size_t i = 1; i < repetitions; ++i)
  {
    const Measured_run run = benchmark::measured_run(computation);
    best.peak_bytes = (std::min)(best.peak_bytes, run.peak_bytes);
    for (int k : {BUILD, DISTANCES, PATHS})
      best.distances[std::size_t(k)] = (std::min)(best.distances[std::size_t(k)], run.distances[std::size_t(k)]);
  }
  return best;
}

bool compare(const std::string& file, const Options& options)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh) || options.vertex >= num_vertices(mesh))
  {
    std::cerr << file << " is not a manifold triangle mesh with a vertex " << options.vertex << '\n';
    return false;
  }
  const Mesh::Vertex_index source(static_cast<Mesh::size_type>(options.vertex));
  const std::vector<Face_location> points = random_points(mesh, options.queries);

  const Measured_run theirs = fastest_run(options.repetitions, [&](std::vector<double>& out, std::uint64_t&) {
    Shortest_path solver(mesh);
    measure(
      points, out,
      [&] {
        solver.add_source_point(source);
        solver.build_sequence_tree();
        return 0;
      },
      [&](const Face_location& p) {
        const double d = solver.shortest_distance_to_source_points(p.first, p.second).first;
        return d < 0 ? std::numeric_limits<double>::infinity() : d;
      },
      [&](const Face_location& p, auto way) { solver.shortest_path_points_to_source_points(p.first, p.second, way); });
  });
  const Measured_run ours = fastest_run(options.repetitions, [&](std::vector<double>& out, std::uint64_t&) {
    Geodesic solver(mesh);
    measure(
      points, out,
      [&] {
        solver.add_source_point(source);
        solver.build(CGAL::parameters::keep_windows(true));
        return solver.statistics().kept_bytes;
      },
      [&](const Face_location& p) { return solver.distance_to_sources(p); },
      [&](const Face_location& p, auto way) { solver.shortest_path_points_to_sources(p, way); });
  });

  double worst = 0;
  for (std::size_t i = NUMBER_OF_FIGURES; i < ours.distances.size(); ++i)
    if (ours.distances[i] != theirs.distances[i])
      worst = (std::max)(worst, std::abs(ours.distances[i] - theirs.distances[i]) / theirs.distances[i]);
  const double vertices = static_cast<double>(num_vertices(mesh));
  const double queries = static_cast<double>(points.size());
  const auto rates = [&](std::size_t figure) {
    const double a = queries / theirs.distances[figure], b = queries / ours.distances[figure];
    std::cout << std::setprecision(0) << a << " | " << b << " | " << std::setprecision(1) << b / a << " | ";
  };
  const double tree = static_cast<double>(theirs.peak_bytes) / vertices, kept = ours.distances[KEPT_BYTES] / vertices;
  std::cout << std::fixed << "| " << std::filesystem::path(file).stem().string() << " | " << num_vertices(mesh) << " | "
            << std::setprecision(3) << theirs.distances[BUILD] << " | " << ours.distances[BUILD] << " | ";
  rates(DISTANCES);
  rates(PATHS);
  std::cout << ours.distances[PATH_POINTS] / queries << " | " << std::setprecision(0) << tree << " | " << kept << " | "
            << std::setprecision(1) << tree / kept << " | " << std::setprecision(0)
            << static_cast<double>(ours.peak_bytes) / vertices << " | " << std::scientific << std::setprecision(1) << worst
            << " |" << std::endl;
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == "--queries" && i + 1 < argc) options.queries = std::stoul(argv[++i]);
    else if (word == "--vertex" && i + 1 < argc) options.vertex = std::stoul(argv[++i]);
    else if (word == "--repeat" && i + 1 < argc) options.repetitions = std::stoul(argv[++i]);
    else files.push_back(word);
  }
  if (files.empty() || options.queries == 0 || options.repetitions == 0)
  {
    std::cerr << "usage: queries_against_smsp [--queries N] [--vertex I] [--repeat N] MESH...\n";
    return 2;
  }
  std::cout << "| mesh | vertices | SMSP build s | ours build s | SMSP distances/s | ours "
               "distances/s | times more | SMSP paths/s | ours paths/s | times more | points a "
               "path | SMSP peak B/vertex | kept windows B/vertex | times less | ours peak "
               "B/vertex | worst relative difference |\n"
               "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  bool ok = true;
  for (const std::string& file : files) try
    {
      ok = compare(file, options) && ok;
    }
    catch (const std::exception& e)
    {
      std::cerr << file << ": " << e.what() << '\n';
      ok = false;
    }
  return ok ? 0 : 1;
}
