// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets within relative tolerances, as a Markdown table: one line for each mesh and tolerance, with the first vertex as
// source, at levels that divide the largest distance of a vertex into equal parts. certify_offset() proves how far the regions
// that the curves bound are off the exact ones, as a part of the tolerance of the curves. Times are medians of interleaved
// runs, of propagation and cutting in one pass, relative to the exact offsets.
//
//   tolerance_offsets [--levels N] [--repeat N] MESH...
//
// The exit code is 1 if an offset bounds no region, or one that is off by more than the tolerance, or if no mesh could be read.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;
typedef CGAL::Surface_mesh_geodesic_enclosure<Traits> Enclosure;
typedef std::vector<Geodesic::Offset_curve> Curves;

const std::vector<double> tolerances = {0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2};

struct Result
{
  std::size_t curves = 0, pieces = 0, failures = 0;
  double worst = 0; // proven tolerance, as a part of that of the curves; of exact offsets, of the distance
  std::vector<double> seconds;
};

double median(std::vector<double> x)
{
  std::nth_element(x.begin(), x.begin() + std::ptrdiff_t(x.size() / 2), x.end());
  return x[x.size() / 2];
}

// One result per tolerance.
std::vector<Result> run(const Mesh& mesh, int levels, int repeat)
{
  Geodesic geodesic(mesh);
  geodesic.add_source_point(*mesh.vertices().begin());
  geodesic.build();
  const double spacing = geodesic.largest_vertex_distance().value() / (levels + 1);
  const auto family = CGAL::Offset_levels<double>::equally_spaced(spacing, std::size_t(levels));
  std::vector<Result> results(tolerances.size());
  for (int i = 0; i < repeat; ++i)
    for (std::size_t k = 0; k < tolerances.size(); ++k)
    {
      Result& r = results[k];
      r.curves = 0;
      const auto start = std::chrono::steady_clock::now();
      geodesic.build_with_offset_curves_by_distance(
        family, [&r](double, Curves&& curves) { r.curves += curves.size(); },
        CGAL::parameters::relative_tolerance(tolerances[k]));
      r.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      r.pieces = geodesic.statistics().pieces;
    }
  Enclosure enclosure(mesh);
  enclosure.add_source_point(*mesh.vertices().begin());
  enclosure.build(CGAL::parameters::keep_windows(true));
  for (std::size_t k = 0; k < tolerances.size(); ++k)
    geodesic.build_with_offset_curves_by_distance(
      family,
      [&](double d, Curves&& curves) {
        const auto c = enclosure.certify_offset(d, curves);
        const double allowed = curves.empty() || tolerances[k] == 0 ? d : curves.front().tolerance();
        results[k].worst = (std::max)(results[k].worst, c.tolerance / allowed);
        results[k].failures += std::size_t(!c.bounds_region || c.number_of_reversed_curves > 0);
      },
      CGAL::parameters::relative_tolerance(tolerances[k]));
  return results;
}

} // namespace

int main(int argc, char* argv[])
{
  int levels = 10, repeat = 5;
  std::size_t meshes = 0;
  bool is_right = true;
  std::printf(
    "| mesh | faces | tolerance | curves | pieces | no region, or reversed | proven, as a part of the tolerance | time, of the "
    "exact one |\n|---|---|---|---|---|---|---|---|\n");
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if ((argument == "--levels" || argument == "--repeat") && i + 1 < argc)
    {
      (argument == "--levels" ? levels : repeat) = (std::max)(1, std::atoi(argv[++i]));
      continue;
    }
    try
    {
      Mesh mesh;
      if (!CGAL::IO::read_polygon_mesh(argument, mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.number_of_faces() == 0)
        throw std::invalid_argument("not a triangle mesh");
      const std::vector<Result> results = run(mesh, levels, repeat);
      ++meshes;
      for (std::size_t k = 0; k < tolerances.size(); ++k)
      {
        const Result& r = results[k];
        is_right = is_right && r.failures == 0 && r.worst <= 1;
        std::printf("| %s | %u | %g | %zu | %zu | %zu | %.2g%s | %.2f |\n",
                    argument.substr(argument.find_last_of('/') + 1).c_str(), unsigned(mesh.number_of_faces()), tolerances[k],
                    r.curves, r.pieces, r.failures, r.worst, tolerances[k] == 0 ? " of the distance" : "",
                    median(r.seconds) / median(results[0].seconds));
      }
      std::fflush(stdout);
    }
    catch (const std::exception& e)
    {
      std::cerr << argument << ": skipped, " << e.what() << '\n';
    }
  }
  return is_right && meshes > 0 ? 0 : 1;
}
