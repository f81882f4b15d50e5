// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Cost of families of offsets: equally spaced distances from a plane section of a mesh, in one propagation, as a Markdown
// table. Curves are dropped on arrival, so the memory is that of the solver alone.
//
//   offset_families MESH [number of distances ...] [--validate]        default: 1 20 200
//
// Without a file of the name MESH, `torus` is the wavy torus of some 131,000 vertices. With TBB, there is a second table for
// all threads. With --validate, the oracle of the tests checks all curves of the last family; the exit code is 1 if it finds a
// fault.

#include "measured_run.h"
#include "plane_section.h"
#include "wavy_torus.h"
#include "validation/Offset_validation.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace test;

typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;

// Plane through the center of the bounding box, across its longest side, tilted against the axes.
std::vector<Section<Mesh>> section(const Mesh& mesh, const CGAL::Bbox_3& box)
{
  const double size[3] = {box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()};
  double normal[3] = {0.07, 0.13, 0.1};
  normal[std::max_element(size, size + 3) - size] = 1;
  return plane_section(
    mesh, Kernel::Point_3((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2),
    Kernel::Vector_3(normal[0], normal[1], normal[2]));
}

template <class Concurrency_tag>
void run(const Mesh& mesh, const std::vector<Section<Mesh>>& sections, double farthest, std::size_t number)
{
  std::size_t pieces = 0, curves = 0;
  double seconds[2] = {0, 0};
  const benchmark::Measured_run result = benchmark::measured_run([&](std::vector<double>& figures, std::uint64_t& windows) {
    Geodesic geodesic(mesh);
    for (const auto& s : sections) geodesic.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
    double count = 0;
    geodesic.build_with_offset_curves_by_distance(
      CGAL::Offset_levels<double>::equally_spaced(farthest / static_cast<double>(number + 1), number),
      [&](double, std::vector<Geodesic::Offset_curve>&& some) { count += static_cast<double>(some.size()); },
      CGAL::parameters::concurrency_tag(Concurrency_tag()));
    const auto& s = geodesic.statistics();
    figures = {s.propagation_seconds, s.offset_seconds, static_cast<double>(s.pieces), count};
    windows = s.windows_propagated;
  });
  seconds[0] = result.distances[0];
  seconds[1] = result.distances[1];
  pieces = static_cast<std::size_t>(result.distances[2]);
  curves = static_cast<std::size_t>(result.distances[3]);
  std::cout << "| " << number << " | " << curves << " | " << pieces << " | " << std::fixed << std::setprecision(3) << seconds[0]
            << " | " << seconds[1] << " | " << std::setprecision(2) << 1e6 * seconds[1] / static_cast<double>(pieces) << " | "
            << std::setprecision(1) << static_cast<double>(result.peak_bytes) / 1e6 << " |" << std::endl;
}

bool validate(const Mesh& mesh, const std::vector<Section<Mesh>>& sections, double farthest, std::size_t number)
{
  Geodesic geodesic(mesh);
  for (const auto& s : sections) geodesic.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
  const auto levels = CGAL::Offset_levels<double>::equally_spaced(farthest / static_cast<double>(number + 1), number);
  std::vector<Geodesic::Offset_curve> curves;
  geodesic.build_with_offset_curves(levels, std::back_inserter(curves), CGAL::parameters::keep_windows(true));
  std::vector<double> distances;
  for (std::size_t i = 0; i < number; ++i) distances.push_back(levels[i]);
  const auto report = CGAL::Geodesic_offset::internal::Offset_validation<Geodesic>(geodesic, mesh)(distances, curves);
  std::cout << "\n"
            << number << " distances validated: " << report.checks() << " checks, " << report.failures()
            << " failures, points off their level by at most " << std::scientific << report.worst_off_level << " diagonals, "
            << geodesic.statistics().forced_joints << " joints forced" << std::endl;
  for (const std::string& text : report.texts()) std::cout << text << std::endl;
  return report.is_valid();
}

double farthest_vertex(const Mesh& mesh, const std::vector<Section<Mesh>>& sections)
{
  Geodesic geodesic(mesh);
  for (const auto& s : sections) geodesic.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
  geodesic.build();
  double farthest = 0;
  for (auto v : vertices(mesh))
  {
    const double d = geodesic.distance_to_sources(v);
    if (std::isfinite(d)) farthest = (std::max)(farthest, d);
  }
  return farthest;
}

template <class Concurrency_tag>
void print_table(const Mesh& mesh, const std::vector<Section<Mesh>>& sections, double farthest,
                 const std::vector<std::size_t>& numbers)
{
  std::cout << "\n| distances | curves | pieces | propagation s | offsets s | us per piece | MB |\n"
               "|---|---|---|---|---|---|---|\n";
  for (std::size_t number : numbers) run<Concurrency_tag>(mesh, sections, farthest, number);
}

bool get_mesh(const std::string& name, Mesh& mesh)
{
  if (CGAL::IO::read_polygon_mesh(name, mesh)) return CGAL::is_triangle_mesh(mesh);
  if (name != "torus") return false;
  mesh = benchmark::Wavy_torus<Mesh>(1 << 17).mesh;
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (argc < 2 || !get_mesh(argv[1], mesh))
  {
    std::cerr << "offset_families: " << (argc < 2 ? "no mesh" : argv[1])
              << (argc < 2 ? " is given" : " is not a manifold triangle mesh") << std::endl;
    return 1;
  }
  const std::vector<Section<Mesh>> sections = section(mesh, CGAL::Polygon_mesh_processing::bbox(mesh));
  const double farthest = farthest_vertex(mesh, sections);
  std::cout << argv[1] << ": " << num_vertices(mesh) << " vertices, " << sections.size() << " polylines" << std::endl;
  std::vector<std::size_t> numbers;
  bool wants_validation = false;
  for (int i = 2; i < argc; ++i)
    if (argv[i] == std::string("--validate")) wants_validation = true;
    else numbers.push_back(std::stoul(argv[i]));
  if (numbers.empty()) numbers = {1, 20, 200};
  print_table<CGAL::Sequential_tag>(mesh, sections, farthest, numbers);
#ifdef CGAL_LINKED_WITH_TBB
  print_table<CGAL::Parallel_tag>(mesh, sections, farthest, numbers);
#endif
  return !wants_validation || validate(mesh, sections, farthest, numbers.back()) ? 0 : 1;
}
