// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Growth of time, memory and windows with the size of the mesh: one smooth shape at 1K, 2K, 4K, ... vertices, from one
// vertex, from 64 vertices, and from a closed curve; without offsets, with one, and with 100 equally spaced ones.
//
//   size_ladder [--limit N] [--first N]          default: 1024 to 262144 vertices
//
// A tab-separated table on stdout. `seconds` include the construction, the build, and reading all distances; `levels` is
// the number of offset distances, whose curves are dropped on arrival. Lines that start with # are the exponents e of the
// best fits c n^e over all sizes.

#include "fastest_run.h"
#include "growth_exponent.h"
#include "ladder_sizes.h"
#include "plane_section.h"
#include "wavy_torus.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;
typedef benchmark::Wavy_torus<Mesh> Shape;

struct Row
{
  std::string source;
  std::size_t levels, vertices;
  double seconds, propagation_seconds, offset_seconds;
  double peak_bytes, windows, pieces, curves;
  double farthest;
};

struct Source
{
  std::string name;
  std::vector<Mesh::Vertex_index> vertices;
  std::vector<Geodesic::Face_location> curve; // closed

  void add_to(Geodesic& geodesic) const
  {
    for (Mesh::Vertex_index v : vertices) geodesic.add_source_point(v);
    if (!curve.empty()) geodesic.add_source_polyline(curve, CGAL::parameters::is_closed(true));
  }
};

std::vector<Source> sources(const Shape& shape)
{
  // across the tube, in general position
  const auto sections = test::plane_section(shape.mesh, Kernel::Point_3(0.02, -0.05, 0), Kernel::Vector_3(1, 0.31, 0.17));
  for (const auto& section : sections)
    if (section.closed)
      return {{"vertex", shape.spread_vertices(1), {}},
              {"64 vertices", shape.spread_vertices(64), {}},
              {"curve", {}, section.locations}};
  throw std::runtime_error("the plane section has no closed curve");
}

// `farthest`: largest vertex distance, the range of the offsets
Row run(const Mesh& mesh, const Source& source, std::size_t levels, double farthest)
{
  const benchmark::Measured_run result = benchmark::fastest_run([&](std::vector<double>& figures, std::uint64_t& windows) {
    Geodesic geodesic(mesh);
    source.add_to(geodesic);
    double curves = 0;
    if (levels == 0) geodesic.build();
    else
      geodesic.build_with_offset_curves_by_distance(
        CGAL::Offset_levels<double>::equally_spaced(farthest / static_cast<double>(levels + 1), levels),
        [&](double, std::vector<Geodesic::Offset_curve>&& some) { curves += static_cast<double>(some.size()); });
    double largest = 0;
    for (Mesh::Vertex_index v : mesh.vertices()) largest = (std::max)(largest, geodesic.distance_to_sources(v));
    const auto& s = geodesic.statistics();
    figures = {s.propagation_seconds, s.offset_seconds, static_cast<double>(s.pieces), curves, largest};
    windows = s.windows_propagated;
  });
  const std::vector<double>& figures = result.distances;
  return {source.name,
          levels,
          std::size_t(mesh.number_of_vertices()),
          result.seconds,
          figures[0],
          figures[1],
          static_cast<double>(result.peak_bytes),
          static_cast<double>(result.windows),
          figures[2],
          figures[3],
          figures[4]};
}

void print(const Row& r)
{
  const double n = static_cast<double>(r.vertices);
  std::printf("%s\t%zu\t%zu\t%.5f\t%.5f\t%.5f\t%.0f\t%.1f\t%.0f\t%.3f\t%.1f\t%.0f\t%.0f\n", r.source.c_str(), r.levels,
              r.vertices, r.seconds, r.propagation_seconds, r.offset_seconds, r.peak_bytes, r.peak_bytes / n, r.windows,
              r.windows / n, 1e9 * r.propagation_seconds / r.windows, r.pieces, r.curves);
  std::fflush(stdout);
}

// Prints the exponents for each source and number of levels.
void print_exponents(const std::vector<Row>& rows)
{
  struct Series
  {
    std::vector<double> vertices, seconds, windows, bytes, offset_seconds;
  };
  std::map<std::pair<std::string, std::size_t>, Series> all;
  for (const Row& r : rows)
  {
    Series& s = all[{r.source, r.levels}];
    s.vertices.push_back(static_cast<double>(r.vertices));
    s.seconds.push_back(r.seconds);
    s.windows.push_back(r.windows);
    s.bytes.push_back(r.peak_bytes);
    s.offset_seconds.push_back(r.offset_seconds);
  }
  for (const auto& item : all)
  {
    const Series& s = item.second;
    const auto print_one = [&](const char* what, const std::vector<double>& y) {
      std::printf("# exponent\t%s\t%zu\t%s\t%.3f\n", item.first.first.c_str(), item.first.second, what,
                  benchmark::growth_exponent(s.vertices, y));
    };
    print_one("seconds", s.seconds);
    print_one("windows", s.windows);
    print_one("peak_bytes", s.bytes);
    if (item.first.second > 0) print_one("offset_seconds", s.offset_seconds);
  }
}

} // namespace

int main(int argc, char* argv[])
{
  benchmark::Ladder_sizes sizes;
  if (!sizes.read(argc, argv, "size_ladder")) return 2;
  std::printf("source\tlevels\tvertices\tseconds\tpropagation_seconds\toffset_seconds\tpeak_bytes\tpeak_bytes_a_vertex\t"
              "windows\twindows_a_vertex\tns_a_window\tpieces\tcurves\n");
  try
  {
    std::vector<Row> rows;
    for (std::size_t n = sizes.first; n <= sizes.limit; n *= 2)
    {
      const Shape shape(n);
      for (const Source& source : sources(shape))
      {
        double farthest = 0;
        for (std::size_t levels : {0, 1, 100})
        {
          rows.push_back(run(shape.mesh, source, levels, farthest));
          farthest = rows.back().farthest;
          print(rows.back());
        }
      }
    }
    print_exponents(rows);
  }
  catch (const std::exception& e)
  {
    std::cerr << "size_ladder: " << e.what() << '\n';
    return 1;
  }
  return 0;
}
