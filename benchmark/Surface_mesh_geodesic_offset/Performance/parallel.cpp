// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds with Parallel_tag on one thread, two and all cores, against Sequential_tag, as a Markdown table: the wavy torus at
// three sizes, from one vertex and from 64, and given meshes, refined by Loop's subdivision to at least 100,000 vertices.
//
//   parallel [--runs N] [mesh files]          default: 7
//
// Times are those of `build()`; further columns are the speed-ups of the mesh set-up and of cutting offset curves at 20
// levels. The variants alternate, N times, and the fastest run of each counts: other work on the machine can only slow a
// run down, and two threads more than one. For two threads and more, as many independent sequential builds run concurrently
// in the same turns: their throughput relative to one build is what the cores and their memory can provide. The exit code
// is 1 if a distance differs from the sequential one by more than 1e-13 relative, or at all between numbers of threads, or
// if memory grows by half.

#include "measured_run.h"
#include "wavy_torus.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;
typedef std::vector<Mesh::Vertex_index> Vertices;

// The timed steps, and the number of levels of offset curves.
enum Step { SETTING_UP, BUILD, CUTTING, number_of_steps };
constexpr std::size_t number_of_levels = 20;

template <class Tag>
void run_steps(const Mesh& mesh, const Vertices& sources, std::vector<double>& figures, std::uint64_t& windows)
{
  auto seconds = [start = std::chrono::steady_clock::now()]() mutable {
    const auto last = std::exchange(start, std::chrono::steady_clock::now());
    return std::chrono::duration<double>(start - last).count();
  };
  double step[number_of_steps];
  Geodesic geodesic(mesh, CGAL::parameters::concurrency_tag(Tag()));
  step[SETTING_UP] = seconds();
  for (Mesh::Vertex_index v : sources) geodesic.add_source_point(v);
  seconds();
  geodesic.build(CGAL::parameters::concurrency_tag(Tag()));
  step[BUILD] = seconds();
  for (Mesh::Vertex_index v : mesh.vertices()) figures.push_back(geodesic.distance_to_sources(v));
  windows = geodesic.statistics().windows_propagated;
  double largest = 0;
  for (const double d : figures)
    if (std::isfinite(d)) largest = (std::max)(largest, d);
  const auto levels = CGAL::Offset_levels<double>::equally_spaced(largest / (number_of_levels + 1.), number_of_levels);
  geodesic.build_with_offset_curves_by_distance(
    levels, [](double, std::vector<Geodesic::Offset_curve>&&) {}, CGAL::parameters::concurrency_tag(Tag()));
  step[CUTTING] = geodesic.statistics().offset_seconds;
  figures.insert(figures.end(), step, step + number_of_steps);
}

// `threads`: 0 for Sequential_tag. The last figures are the times of the steps.
benchmark::Measured_run run(const Mesh& mesh, const Vertices& sources, int threads)
{
  return benchmark::measured_run([&](std::vector<double>& figures, std::uint64_t& windows) {
    if (threads == 0) return run_steps<CGAL::Sequential_tag>(mesh, sources, figures, windows);
    const auto size = static_cast<std::size_t>(threads);
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, size);
    tbb::task_arena arena(threads);
    arena.execute([&] { run_steps<CGAL::Parallel_tag>(mesh, sources, figures, windows); });
  });
}

// Concurrent sequential builds. The only figure is the time of the slowest one.
double seconds_side_by_side(const Mesh& mesh, const Vertices& sources, int number)
{
  const auto run = [&](std::vector<double>& figures, std::uint64_t&) {
    std::atomic<int> waiting(number);
    std::vector<double> seconds(static_cast<std::size_t>(number));
    std::vector<std::thread> threads;
    for (double& result : seconds)
      threads.emplace_back([&] {
        Geodesic geodesic(mesh);
        for (Mesh::Vertex_index v : sources) geodesic.add_source_point(v);
        for (--waiting; waiting > 0;) std::this_thread::yield();
        const auto start = std::chrono::steady_clock::now();
        geodesic.build();
        result = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      });
    for (std::thread& t : threads) t.join();
    figures.push_back(*std::max_element(seconds.begin(), seconds.end()));
  };
  return benchmark::measured_run(run).distances.back();
}

struct Way
{
  explicit Way(int threads) : threads(threads) {}

  int threads;
  std::vector<double> seconds = std::vector<double>(number_of_steps, std::numeric_limits<double>::infinity());
  std::uint64_t windows = 0;
  double peak_bytes = 0;
  std::vector<double> distances;
  double seconds_side_by_side = std::numeric_limits<double>::infinity();

  void add(benchmark::Measured_run result)
  {
    const std::size_t number = result.distances.size() - number_of_steps;
    for (std::size_t i = 0; i < number_of_steps; ++i) seconds[i] = (std::min)(seconds[i], result.distances[number + i]);
    result.distances.resize(number);
    distances = std::move(result.distances);
    windows = result.windows;
    peak_bytes = static_cast<double>(result.peak_bytes);
  }
};

bool compare(const std::string& name, const Mesh& mesh, const Vertices& sources, int runs)
{
  std::vector<Way> ways;
  for (const int threads : {0, 1, 2}) ways.emplace_back(threads);
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  if (cores > 2) ways.emplace_back(cores);
  bool same = true;
  for (int i = 0; i < runs; ++i)
    for (Way& way : ways)
    {
      way.add(run(mesh, sources, way.threads));
      if (way.threads < 1) continue;
      same = same && way.distances == ways[1].distances;
      if (way.threads < 2) continue;
      way.seconds_side_by_side = (std::min)(way.seconds_side_by_side, seconds_side_by_side(mesh, sources, way.threads));
    }
  double worst = 0;
  for (std::size_t i = 0; i < ways[0].distances.size(); ++i)
  {
    const double expected = ways[0].distances[i], d = ways[1].distances[i];
    if (d != expected) worst = (std::max)(worst, std::abs(d - expected) / expected);
  }
  for (std::size_t i = 1; i < ways.size(); ++i)
  {
    char side_by_side[32] = "";
    if (ways[i].threads > 1)
      std::snprintf(side_by_side, sizeof side_by_side, "%.2f",
                    ways[i].threads * ways[0].seconds[BUILD] / ways[i].seconds_side_by_side);
    const auto faster = [&](Step step) { return ways[0].seconds[step] / ways[i].seconds[step]; };
    std::printf("| %s | %zu | %zu | %.3f | %d | %.3f | %.2f | %s | %.2f | %.2f | %.4f | %.1f | %.1f | %.1e |\n", name.c_str(),
                static_cast<std::size_t>(mesh.number_of_vertices()), sources.size(), ways[0].seconds[BUILD], ways[i].threads,
                ways[i].seconds[BUILD], faster(BUILD), side_by_side, faster(SETTING_UP), faster(CUTTING),
                static_cast<double>(ways[i].windows) / static_cast<double>(ways[0].windows), ways[0].peak_bytes / 1e6,
                ways[i].peak_bytes / 1e6, worst);
    std::fflush(stdout);
  }
  if (!same) std::cerr << name << ": distances depend on the number of threads" << std::endl;
  bool fits = true;
  for (const Way& way : ways) fits = fits && way.peak_bytes <= 1.5 * ways[0].peak_bytes;
  if (!fits) std::cerr << name << ": several threads take more memory than one" << std::endl;
  return same && worst <= 1e-13 && fits;
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    int runs = 7;
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i)
      if (std::string(argv[i]) == "--runs" && i + 1 < argc) runs = (std::max)(1, std::stoi(argv[++i]));
      else files.push_back(argv[i]);
    std::printf("| mesh | vertices | sources | sequential s | threads | s | times faster | builds side by side | "
                "setting up | cutting | windows, ratio | sequential MB | MB | worst relative difference |\n"
                "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    bool ok = true;
    for (const std::size_t n : {100000, 200000, 400000})
    {
      const benchmark::Wavy_torus<Mesh> torus(n);
      for (const std::size_t sources : {1, 64})
        ok = compare("wavy torus", torus.mesh, torus.spread_vertices(sources), runs) && ok;
    }
    for (const std::string& file : files)
    {
      Mesh mesh;
      if (!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh))
      {
        std::cerr << file << " is not a triangle mesh" << std::endl;
        return 1;
      }
      while (mesh.number_of_vertices() < 100000)
        CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
      ok = compare(file.substr(file.find_last_of('/') + 1), mesh, {Mesh::Vertex_index(0)}, runs) && ok;
    }
    return ok ? 0 : 1;
  }
  catch (const std::exception& e)
  {
    std::cerr << e.what() << std::endl;
    return 1;
  }
}

#else

int main() { std::cout << "TBB was not found." << std::endl; }

#endif
