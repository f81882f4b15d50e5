// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Windows saved by a tolerance, from one vertex of a smooth shape at 1K, 4K, 16K, ... vertices, with exact builds and
// relative tolerances, and from a corner of noisy planar grids, with a merging tolerance. The figures are counts, not
// times, so the tables are the same on any machine.
//
//   bounded_error [--limit N] [--first N]          default: 1024 to 262144 vertices
//
// Two Markdown tables. In the first, the last line per tolerance is the exponent e of the best fit c n^e. The largest error
// is that of all vertices relative to the exact build. The exit code is 1 if an error exceeds its bound, or a distance
// exceeds the exact one by more than rounding.

#include "generated_flat_meshes.h"
#include "growth_exponent.h"
#include "ladder_sizes.h"
#include "wavy_torus.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;
typedef benchmark::Wavy_torus<Mesh> Shape;

const std::vector<double> tolerances = {0, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3};

struct Largest_error
{
  double absolute = 0, relative = 0;
  bool is_sound = true;
};

// Error of a build relative to an exact one.
Largest_error largest_error(const Mesh& mesh, const Geodesic& geodesic, const std::vector<double>& exact)
{
  Largest_error result;
  std::size_t i = 0;
  for (Mesh::Vertex_index v : mesh.vertices())
  {
    const double expected = exact[i++], error = expected - geodesic.distance_to_sources(v), rounding = 1e-12 * expected;
    result.is_sound = result.is_sound && error >= -rounding && error <= geodesic.error_bound(v) + rounding;
    result.absolute = (std::max)(result.absolute, error);
    if (expected > 0) result.relative = (std::max)(result.relative, error / expected);
  }
  return result;
}

std::vector<double> distances(const Mesh& mesh, const Geodesic& geodesic)
{
  std::vector<double> result;
  for (Mesh::Vertex_index v : mesh.vertices()) result.push_back(geodesic.distance_to_sources(v));
  return result;
}

bool smooth_shape(std::size_t first, std::size_t limit)
{
  std::printf("| relative tolerance | vertices | windows propagated | per vertex | of the exact ones | relative error bound | "
              "largest relative error |\n|---|---|---|---|---|---|---|\n");
  bool ok = true;
  std::vector<double> sizes;
  std::vector<std::vector<double>> windows(tolerances.size());
  for (std::size_t n = first; n <= limit; n *= 4)
  {
    const Shape shape(n);
    std::vector<double> exact;
    sizes.push_back(static_cast<double>(shape.mesh.number_of_vertices()));
    for (std::size_t i = 0; i < tolerances.size(); ++i)
    {
      Geodesic geodesic(shape.mesh);
      geodesic.add_source_point(shape.spread_vertices(1)[0]);
      geodesic.build(CGAL::parameters::relative_tolerance(tolerances[i]));
      if (i == 0) exact = distances(shape.mesh, geodesic);
      const auto& s = geodesic.statistics();
      windows[i].push_back(static_cast<double>(s.windows_propagated));
      const Largest_error error = largest_error(shape.mesh, geodesic, exact);
      ok = ok && error.is_sound;
      std::printf("| %.0e | %.0f | %zu | %.2f | %.1f %% | %.2e | %.2e |\n", tolerances[i], sizes.back(), s.windows_propagated,
                  windows[i].back() / sizes.back(), 100 * windows[i].back() / windows[0].back(), s.relative_error_bound,
                  error.relative);
      std::fflush(stdout);
    }
  }
  for (std::size_t i = 0; i < tolerances.size(); ++i)
    std::printf("| %.0e | exponent | %.3f | | | | |\n", tolerances[i], benchmark::growth_exponent(sizes, windows[i]));
  return ok;
}

bool noisy_grids()
{
  const double tolerance = 1e-9;
  std::printf("\n| grid 100 x 100, noise in z | windows per vertex, exactly | with merging tolerance %.0e | error bound | "
              "largest error |\n|---|---|---|---|---|\n",
              tolerance);
  bool ok = true;
  for (const double noise : {1e-8, 1e-7, 1e-6, 1e-5})
  {
    test::Soup soup = test::jittered_grid(100, 100, 1);
    test::Random random(1);
    for (test::Point_3& p : soup.points) p = test::Point_3(p.x(), p.y(), test::uniform(random, -noise, noise));
    const test::Generated_mesh<Mesh> data(soup);
    Geodesic exact(data.mesh), merged(data.mesh);
    exact.add_source_point(data.vertices[0]);
    merged.add_source_point(data.vertices[0]);
    exact.build();
    merged.build(CGAL::parameters::merging_tolerance(tolerance));
    const Largest_error error = largest_error(data.mesh, merged, distances(data.mesh, exact));
    ok = ok && error.is_sound;
    const double n = static_cast<double>(data.vertices.size());
    std::printf("| %.0e | %.2f | %.2f | %.2e | %.2e |\n", noise, static_cast<double>(exact.statistics().windows_propagated) / n,
                static_cast<double>(merged.statistics().windows_propagated) / n, merged.statistics().error_bound,
                error.absolute);
  }
  return ok;
}

} // namespace

int main(int argc, char* argv[])
{
  benchmark::Ladder_sizes sizes;
  if (!sizes.read(argc, argv, "bounded_error")) return 2;
  try
  {
    const bool shape = smooth_shape(sizes.first, sizes.limit), grids = noisy_grids();
    return shape && grids ? 0 : 1;
  }
  catch (const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
