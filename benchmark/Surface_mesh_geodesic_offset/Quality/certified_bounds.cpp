// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Cost of certified bounds relative to distances, and their widths, as a Markdown table: one line per mesh, with the first
// vertex as source.
//
//   certified_bounds [--repeat N] [--bits B] MESH...
//
// Times are the shortest of N alternating runs: rounded side tests, exact side tests, bounds. With --bits, the distances of
// a run with numbers of B bits must be within the bounds; it takes some 50 microseconds per window. The exit code is 1 if
// they are not, if distances of doubles are outside by more than 1e-12 relative, or if no mesh could be read.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpfr.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_enclosure<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Enclosure;
template <class K>
using Distance = CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<K, Mesh>>;

// Builds, and updates the shortest time.
template <class Solver>
void build(Solver& solver, double& seconds)
{
  const auto start = std::chrono::steady_clock::now();
  solver.build();
  seconds = (std::min)(seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

struct Result
{
  double rounded = infinity(), filtered = infinity(), certified = infinity(); // seconds
  std::size_t windows = 0, certified_windows = 0, outside = 0, outside_of_bits = 0;
  std::vector<double> widths;
  static double infinity() { return std::numeric_limits<double>::infinity(); }
};

Result run(const Mesh& mesh, int repeat, int bits)
{
  Result r;
  const Mesh::Vertex_index source = *mesh.vertices().begin();
  Distance<CGAL::Simple_cartesian<double>> rounded(mesh);
  Distance<Kernel> filtered(mesh);
  Enclosure certified(mesh);
  rounded.add_source_point(source);
  filtered.add_source_point(source);
  certified.add_source_point(source);
  for (int i = 0; i < repeat; ++i)
  {
    build(rounded, r.rounded);
    build(filtered, r.filtered);
    build(certified, r.certified);
  }
  r.windows = filtered.statistics().windows_propagated;
  r.certified_windows = certified.number_of_windows();
  for (Mesh::Vertex_index v : mesh.vertices())
  {
    const double d = filtered.distance_to_sources(v);
    const std::pair<double, double> bounds = certified.distance_bounds(v);
    const bool is_reached = std::isfinite(d);
    if (is_reached != std::isfinite(bounds.first) || is_reached != std::isfinite(bounds.second)) ++r.outside;
    if (!is_reached || d == 0) continue;
    if (d < bounds.first * (1 - 1e-12) || d > bounds.second * (1 + 1e-12)) ++r.outside;
    r.widths.push_back((bounds.second - bounds.first) / bounds.second);
  }
  std::sort(r.widths.begin(), r.widths.end());
  if (bits == 0) return r;
  CGAL::Gmpfr::set_default_precision(static_cast<mpfr_prec_t>(bits));
  Distance<CGAL::Simple_cartesian<CGAL::Gmpfr>> precise(mesh);
  precise.add_source_point(source);
  precise.build();
  for (Mesh::Vertex_index v : mesh.vertices())
  {
    const CGAL::Gmpfr d = precise.distance_to_sources(v);
    const std::pair<double, double> bounds = certified.distance_bounds(v);
    const bool is_within =
      std::isfinite(bounds.second) ? CGAL::Gmpfr(bounds.first) <= d && d <= CGAL::Gmpfr(bounds.second) : d > CGAL::Gmpfr(1e299);
    if (!is_within) ++r.outside_of_bits;
  }
  return r;
}

} // namespace

int main(int argc, char* argv[])
{
  int repeat = 1, bits = 0;
  bool is_right = true;
  std::size_t meshes = 0;
  std::cout << "| mesh | faces | windows | certified | time, exact side tests / rounded | certified / rounded "
               "| median width | largest width | outside |\n|---|---|---|---|---|---|---|---|---|\n";
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if ((argument == "--repeat" || argument == "--bits") && i + 1 < argc)
    {
      (argument == "--bits" ? bits : repeat) = (std::max)(1, std::atoi(argv[++i]));
      continue;
    }
    try
    {
      Mesh mesh;
      if (!CGAL::IO::read_polygon_mesh(argument, mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.number_of_faces() == 0)
        throw std::invalid_argument("not a triangle mesh");
      const Result r = run(mesh, repeat, bits);
      ++meshes;
      is_right = is_right && r.outside == 0 && r.outside_of_bits == 0;
      std::printf("| %s | %zu | %zu | %zu | %.2f | %.2f | %.1e | %.1e | %zu%s |\n",
                  argument.substr(argument.find_last_of('/') + 1).c_str(), std::size_t(mesh.number_of_faces()), r.windows,
                  r.certified_windows, r.filtered / r.rounded, r.certified / r.rounded,
                  r.widths.empty() ? 0. : r.widths[r.widths.size() / 2], r.widths.empty() ? 0. : r.widths.back(), r.outside,
                  bits == 0 ? "" : (", of " + std::to_string(bits) + " bits " + std::to_string(r.outside_of_bits)).c_str());
      std::fflush(stdout);
    }
    catch (const std::exception& e)
    {
      std::cerr << argument << ": skipped, " << e.what() << '\n';
    }
  }
  return is_right && meshes > 0 ? 0 : 1;
}
