// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Windows on flat and developable meshes, on which the number of windows explodes in solvers that do not merge windows:
// time, windows per vertex, and error against closed forms, as a Markdown table. The exit code is 1 if a jittered grid
// needs more than 4 windows per vertex, or if a distance has an error above 1e-12.

#include "closed_forms.h"
#include "generated_flat_meshes.h"
#include "locations.h"
#include "measured_run.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace test;

typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;

template <class ClosedForm>
bool run(const std::string& name, const Soup& soup, const ClosedForm& closed_form, std::size_t source, double limit)
{
  // A patch of each vertex, and the vertex's coordinates in it.
  std::vector<Leg> places(soup.points.size());
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) places[soup.triangles[i][k]] = Leg{soup.patches[i], soup.uv[i][k], soup.uv[i][k]};

  const Generated_mesh<Mesh> data(soup);
  const benchmark::Measured_run result = benchmark::measured_run([&](std::vector<double>& distances, std::uint64_t& windows) {
    Geodesic geodesic(data.mesh);
    geodesic.add_source_point(data.vertices[source]);
    geodesic.build();
    for (auto v : data.vertices) distances.push_back(geodesic.distance_to_sources(v));
    windows = geodesic.statistics().windows_propagated;
  });
  double worst = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double expected = closed_form(places[i].patch, places[i].a, places[source]);
    if (i != source) worst = (std::max)(worst, std::abs(result.distances[i] - expected) / expected);
  }
  const double windows_a_vertex = static_cast<double>(result.windows) / static_cast<double>(places.size());
  std::cout << "| " << name << " | " << places.size() << " | " << source << " | " << std::fixed << std::setprecision(3)
            << result.seconds << " | " << std::setprecision(1) << static_cast<double>(result.peak_bytes) / 1e6 << " | "
            << result.windows << " | " << std::setprecision(2) << windows_a_vertex << " | " << std::scientific
            << std::setprecision(1) << worst << " |" << std::endl;
  return worst <= 1e-12 && windows_a_vertex <= limit;
}

} // namespace

int main()
{
  const double no_limit = std::numeric_limits<double>::infinity();
  std::cout << "| mesh | vertices | source | seconds | MB | windows propagated | per vertex | worst "
               "relative error |\n"
               "|---|---|---|---|---|---|---|---|\n";
  bool ok = true;
  for (unsigned seed : {1u, 2u, 3u})
  {
    const Soup soup = jittered_grid(200, 200, seed);
    for (std::size_t source : {std::size_t(0), soup.points.size() / 2})
      ok = run("jittered grid 200 x 200, seed " + std::to_string(seed), soup, Plane_distance(), source, 4) && ok;
  }
  const Soup grid = planar_grid(200, 200, Diagonals::alternating);
  ok = run("regular grid 200 x 200", grid, Plane_distance(), 0, no_limit) && ok;

  const Polyhedron_sides cube = box_sides(1, 1, 1);
  const Soup cube_grid = test::cube_grid(58);
  for (std::size_t source : {std::size_t(0), cube_grid.points.size() / 3})
    ok = run("cube of 6 x 58 x 58 squares", cube_grid, Polyhedron_distance(cube), source, no_limit) && ok;
  const Soup random_cube = cube.triangulated(3300, 40, 1);
  ok = run("cube, random", random_cube, Polyhedron_distance(cube), 0, no_limit) && ok;
  const Prism prism(12, 1, 4);
  ok = run("prism of 12 sides, random", prism.triangulated(1700, 30, 1), Prism_distance(prism), 0, no_limit) && ok;
  return ok ? 0 : 1;
}
