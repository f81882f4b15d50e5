// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Correctness of distances and number of windows on meshes that are hard for methods with windows: flat ones, where paths
// tie and nothing ends a window; needles; tiny faces; saddles.
//
//   hard_meshes [--faces LIMIT] [MESH or FOLDER]...
//
// Generated meshes, then the given ones, up to 200000 faces; from the first vertex, and from a plane section. Distances of
// doubles must be within the certified bounds up to 1e-12 relative, and the same points must be unreachable for both;
// otherwise the exit code is 1. Given meshes that are unusable are named on stderr.
//
// A tab-separated table on stdout. `seconds` and `bounds_seconds` are those of the builds, `width` is the largest relative
// difference of two bounds, `outside` the number of vertices with wrong distances, and `excess` the largest relative
// distance of a vertex distance from its bounds, wrong or not; `excess_of_size` is the largest one in diagonals of the
// bounding box.

#include "data_meshes.h"
#include "generated_meshes.h"
#include "plane_section.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using test::Kernel;
using test::Soup;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Distance;
typedef CGAL::Surface_mesh_geodesic_enclosure<Traits> Enclosure;
typedef test::Section<Mesh> Section;

const double tolerance = 1e-12;

template <class Solver>
double seconds_of_build(Solver& solver)
{
  const auto start = std::chrono::steady_clock::now();
  solver.build();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Comparison of vertex distances with their bounds.
struct Agreement
{
  std::size_t unreachable = 0, outside = 0;
  double width = 0, excess = 0, absolute_excess = 0;

  void add(double distance, const std::pair<double, double>& bounds)
  {
    const bool is_reached = std::isfinite(distance);
    unreachable += is_reached ? 0 : 1;
    if (std::isnan(distance) || is_reached != std::isfinite(bounds.first) || is_reached != std::isfinite(bounds.second))
      ++outside;
    else if (is_reached && bounds.second > 0)
    {
      width = (std::max)(width, (bounds.second - bounds.first) / bounds.second);
      const double e = (std::max)(bounds.first - distance, distance - bounds.second);
      absolute_excess = (std::max)(absolute_excess, e);
      excess = (std::max)(excess, e / bounds.second);
      outside += e > tolerance * bounds.second ? 1 : 0;
    }
    else outside += distance != 0 && is_reached ? 1 : 0;
  }
};

class Run
{
public:
  // Prints the lines of a mesh.
  void operator()(const std::string& name, const Mesh& mesh)
  {
    for (Mesh::Vertex_index v : mesh.vertices())
      if (!mesh.is_isolated(v))
      {
        compare(name, "vertex", mesh, [&](auto& solver) { solver.add_source_point(v); });
        break;
      }
    const std::vector<Section> curves = test::random_plane_section(mesh, 1);
    if (!curves.empty())
      compare(name, "curve", mesh, [&](auto& solver) {
        for (const Section& s : curves) solver.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
      });
  }

  void operator()(const std::string& name, const Soup& soup)
  {
    const test::Generated_mesh<Mesh> generated(soup);
    (*this)(name, generated.mesh);
  }

  bool is_right() const { return m_is_right; }

private:
  template <class AddSources>
  void compare(const std::string& name, const std::string& source, const Mesh& mesh, const AddSources& add_sources)
  {
    try
    {
      Distance distance(mesh);
      Enclosure enclosure(mesh);
      add_sources(distance);
      add_sources(enclosure);
      const double seconds = seconds_of_build(distance), bounds_seconds = seconds_of_build(enclosure);
      Agreement agreement;
      for (Mesh::Vertex_index v : mesh.vertices()) agreement.add(distance.distance_to_sources(v), enclosure.distance_bounds(v));
      m_is_right = m_is_right && agreement.outside == 0;
      const std::size_t n = mesh.number_of_vertices(), windows = distance.statistics().windows_propagated;
      const double windows_a_vertex = static_cast<double>(windows) / static_cast<double>(n);
      std::printf("%s\t%s\t%zu\t%zu\t%.4f\t%zu\t%.2f\t%.4f\t%zu\t%.1e\t%zu\t%.1e\t%.1e\n", name.c_str(), source.c_str(), n,
                  std::size_t(mesh.number_of_faces()), seconds, windows, windows_a_vertex, bounds_seconds,
                  agreement.unreachable, agreement.width, agreement.outside, agreement.excess,
                  agreement.absolute_excess / test::bounding_box_diagonal(mesh));
    }
    catch (const std::exception& e)
    {
      std::cerr << name << ", " << source << ": " << e.what() << '\n';
      m_is_right = false;
    }
    std::fflush(stdout);
  }

  bool m_is_right = true;
};

void run_flat_meshes(Run& run)
{
  const std::size_t n = 100;
  run("grid, regular", test::planar_grid(n, n));
  run("grid, alternating diagonals", test::planar_grid(n, n, test::Diagonals::alternating));
  run("grid, regular, rotated", test::rotated(test::planar_grid(n, n), 1));
  run("grid, jittered", test::jittered_grid(n, n, 1));
  run("grid, jittered, rotated", test::rotated(test::jittered_grid(n, n, 1), 2));
  run("strip, 4 x 2500, rotated", test::rotated(test::planar_grid(4, 2500), 3));
  run("cube, grid", test::cube_grid(40));
  run("cube, grid, rotated", test::rotated(test::cube_grid(40), 4));
  run("cube, random", test::box_sides(1, 1, 1).triangulated(1500, 30, 1));
  run("prism, random", test::Prism(12, 1, 4).triangulated(700, 20, 1));
}

// The thinnest needles, rotated, show the limits of doubles: a distance far below the length of the faces has the round-off
// of that length.
void run_needles(Run& run)
{
  for (const double height : {1e-2, 1e-4, 1e-6, 1e-8})
  {
    char name[40];
    std::snprintf(name, sizeof(name), "needles, 1 : %.0e", height);
    run(name, test::random_rectangle(1, height, 2000, 60, 1));
    run(std::string(name) + ", rotated", test::rotated(test::random_rectangle(1, height, 2000, 60, 1), 5));
  }
  // from the curve, the number of windows grows quadratically: each segment is a source, and all edges are visible from all
  // sources
  for (const std::size_t count : {500, 1000, 2000})
    run("disc of " + std::to_string(count) + " needles", test::needle_fan(count));
}

void run_tiny_faces(Run& run)
{
  run("marching tetrahedra, sphere", test::marching_sphere(24));
  run("marching tetrahedra, sphere, rotated", test::rotated(test::marching_sphere(24), 6));
  run("marching tetrahedra, genus 5", test::marching_genus_5(24));
}

void run_saddles(Run& run)
{
  for (const double turns : {1.05, 1.5, 4.})
  {
    char name[40];
    std::snprintf(name, sizeof(name), "saddle of %.2f turns", turns);
    const std::size_t sectors = turns < 2 ? 8 : 16;
    run(name, test::Cone(sectors, turns * 2 * CGAL_PI, 1).triangulated(500, 20, 1));
  }
  run("saddle fan, 8 faces", test::saddle_fan());
  run("saddle fan, 2000 faces", test::saddle_fan(1000));
  run("cone of half a turn", test::Cone(6, CGAL_PI, 1).triangulated(800, 20, 1));
}

void run_file(Run& run, const std::filesystem::path& file, std::size_t limit)
{
  Mesh mesh;
  const std::string failure = test::read_data_mesh(file, limit, mesh);
  if (failure.empty()) run(file.filename().string(), mesh);
  else std::cerr << file.filename().string() << ": skipped, " << failure << '\n';
}

} // namespace

int main(int argc, char* argv[])
{
  std::size_t limit = 200000;
  std::vector<std::filesystem::path> files;
  try
  {
    for (int i = 1; i < argc; ++i)
    {
      const std::filesystem::path path = argv[i];
      if (path == "--faces" && i + 1 < argc) limit = std::stoul(argv[++i]);
      else if (std::filesystem::is_directory(path))
        for (const auto& entry : std::filesystem::directory_iterator(path)) files.push_back(entry.path());
      else if (std::filesystem::exists(path)) files.push_back(path);
      else throw std::invalid_argument(path.string() + " does not exist");
    }
  }
  catch (const std::exception& e)
  {
    std::cerr << "hard_meshes: " << e.what() << "\nusage: hard_meshes [--faces LIMIT] [MESH or FOLDER]...\n";
    return 2;
  }
  std::sort(files.begin(), files.end());
  std::printf("mesh\tsource\tvertices\tfaces\tseconds\twindows\twindows_a_vertex\tbounds_seconds\tunreachable\twidth\t"
              "outside\texcess\texcess_of_size\n");
  Run run;
  try
  {
    run_flat_meshes(run);
    run_needles(run);
    run_tiny_faces(run);
    run_saddles(run);
  }
  catch (const std::exception& e)
  {
    std::cerr << "hard_meshes: " << e.what() << '\n';
    return 1;
  }
  for (const std::filesystem::path& file : files) run_file(run, file, limit);
  return run.is_right() ? 0 : 1;
}
