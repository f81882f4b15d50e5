// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Tolerances that are proven for offsets, relative to the diagonal of the bounding box, as a Markdown table: one line for each
// mesh, with the first vertex as source, at levels that divide the largest distance of a vertex into equal parts. Beside the
// offsets of the package, those of linear interpolation between exact distances of the vertices.
//
//   certified_offsets [--levels N] MESH...
//
// The exit code is 1 if an offset of the package has a tolerance above 1e-11 of the diagonal, or if no mesh could be read.

#include "interpolated_offset.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
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
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;
typedef CGAL::Surface_mesh_geodesic_enclosure<Traits> Enclosure;

struct Result
{
  std::size_t faces = 0, curves = 0, failures = 0, reversed = 0, interpolated_failures = 0;
  std::vector<double> ours, interpolated; // relative to the diagonal
  double enclosure_seconds = 0, certification_seconds = 0;
};

double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Result run(const Mesh& mesh, int levels)
{
  Result result;
  result.faces = mesh.number_of_faces();
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double diagonal = std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
  Geodesic geodesic(mesh);
  geodesic.add_source_point(*mesh.vertices().begin());
  geodesic.build();
  const double spacing = geodesic.largest_vertex_distance().value() / (levels + 1);
  std::vector<Geodesic::Offset_curve> all;
  geodesic.build_with_offset_curves(CGAL::Offset_levels<double>::equally_spaced(spacing, std::size_t(levels)),
                                    std::back_inserter(all));
  Enclosure enclosure(mesh);
  enclosure.add_source_point(*mesh.vertices().begin());
  auto start = std::chrono::steady_clock::now();
  enclosure.build(CGAL::parameters::keep_windows(true));
  result.enclosure_seconds = seconds_since(start);
  const auto by_distance = [](const Geodesic::Offset_curve& a, const Geodesic::Offset_curve& b) {
    return a.distance() < b.distance();
  };
  std::stable_sort(all.begin(), all.end(), by_distance);
  for (std::size_t i = 0, next; i < all.size(); i = next)
  {
    for (next = i; next < all.size() && all[next].distance() == all[i].distance();) ++next;
    const double d = all[i].distance();
    const std::vector<Geodesic::Offset_curve> curves(all.begin() + std::ptrdiff_t(i), all.begin() + std::ptrdiff_t(next));
    start = std::chrono::steady_clock::now();
    const auto c = enclosure.certify_offset(d, curves);
    result.certification_seconds += seconds_since(start);
    result.curves += curves.size();
    result.failures += std::size_t(!c.bounds_region);
    result.reversed += c.number_of_reversed_curves;
    result.ours.push_back(c.tolerance / diagonal);
    const auto interpolated = interpolated_offset(
      mesh, [&](Mesh::Vertex_index v) { return geodesic.distance_to_sources(v); }, d);
    const auto other = enclosure.certify_offset(d, interpolated);
    result.interpolated_failures += std::size_t(!other.bounds_region);
    result.interpolated.push_back(other.tolerance / diagonal);
  }
  return result;
}

void print(const std::vector<double>& sorted)
{
  if (sorted.empty()) std::printf(" - | - | - |");
  else std::printf(" %.1e | %.1e | %.1e |", sorted.front(), sorted[sorted.size() / 2], sorted.back());
}

} // namespace

int main(int argc, char* argv[])
{
  int levels = 10;
  bool is_right = true;
  std::size_t meshes = 0;
  std::printf("| mesh | faces | levels | curves | no region | reversed | smallest | median | largest | interpolated: no region "
              "| smallest | median | largest | bounds, s | certificates, s |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "--levels" && i + 1 < argc)
    {
      levels = (std::max)(1, std::atoi(argv[++i]));
      continue;
    }
    try
    {
      Mesh mesh;
      if (!CGAL::IO::read_polygon_mesh(argument, mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.number_of_faces() == 0)
        throw std::invalid_argument("not a triangle mesh");
      Result r = run(mesh, levels);
      ++meshes;
      std::sort(r.ours.begin(), r.ours.end());
      std::sort(r.interpolated.begin(), r.interpolated.end());
      is_right = is_right && r.failures == 0 && r.reversed == 0 && (r.ours.empty() || r.ours.back() <= 1e-11);
      std::printf("| %s | %zu | %zu | %zu | %zu | %zu |", argument.substr(argument.find_last_of('/') + 1).c_str(), r.faces,
                  r.ours.size(), r.curves, r.failures, r.reversed);
      print(r.ours);
      std::printf(" %zu |", r.interpolated_failures);
      print(r.interpolated);
      std::printf(" %.2f | %.2f |\n", r.enclosure_seconds, r.certification_seconds);
      std::fflush(stdout);
    }
    catch (const std::exception& e)
    {
      std::cerr << argument << ": skipped, " << e.what() << '\n';
    }
  }
  return is_right && meshes > 0 ? 0 : 1;
}
