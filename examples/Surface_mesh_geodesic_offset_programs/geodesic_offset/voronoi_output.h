// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Voronoi diagram of the sources: the curves between their cells, and the mesh split along them.

#ifndef GEODESIC_OFFSET_VORONOI_OUTPUT_H
#define GEODESIC_OFFSET_VORONOI_OUTPUT_H

#include "common/common.h"
#include "common/output_file.h"
#include "polyline_output.h"
#include "progress.h"
#include "split_output.h"

#include <cstddef>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace geodesic_offset {
namespace internal {

struct Cell_boundary
{
  std::vector<Point> points;
  std::size_t left, right; // sources
};

inline void write_boundaries(std::ostream& out, const std::string& file, const std::vector<Cell_boundary>& boundaries)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  if(!has_extension(file, ".vtk")) return write_polylines(out, boundaries);
  write_vtk_lines(out, "geodesic Voronoi diagram", boundaries);
  if(boundaries.empty()) return;
  out << "CELL_DATA " << boundaries.size() << "\nFIELD cells 2\n";
  write_vtk_integers(out, "left", boundaries, [](const Cell_boundary& b) { return b.left; });
  write_vtk_integers(out, "right", boundaries, [](const Cell_boundary& b) { return b.right; });
}

} // namespace internal

// Adds files of the diagram of the last build, which must have kept windows and computed all distances.
inline void add_voronoi_files(Output_files& files, const std::vector<std::string>& names, const Mesh& mesh,
                              const Geodesic& geodesic, double chord_tolerance, Progress& progress)
{
  progress.show("Voronoi diagram");
  const Stopwatch time;
  const auto diagram = geodesic.field().voronoi_diagram();
  std::vector<internal::Cell_boundary> boundaries;
  for(const auto& curve : diagram.curves())
  {
    boundaries.push_back({{}, curve.source_on_left(), curve.source_on_right()});
    curve.points(chord_tolerance, std::back_inserter(boundaries.back().points));
  }
  progress.line("Voronoi diagram: " + counted(diagram.number_of_curves(), "curve") + ", " +
                  counted(diagram.number_of_vertices(), "vertex", "vertices"),
                time.seconds());
  if(diagram.number_of_forced_cells() != 0)
    progress.warning("rounding left curves of the Voronoi diagram that do not fit together in " +
                     counted(diagram.number_of_forced_cells(), "place") + "; they are crossed straight");
  for(const std::string& name : names)
    if(has_extension(name, ".ply"))
    {
      const Split_mesh split(mesh, diagram, geodesic.number_of_sources(), chord_tolerance);
      files.add(
        name, [&](std::ostream& out) { split.write(out); }, split.number_of_bytes());
    }
    else
      files.add(name, [&](std::ostream& out) { internal::write_boundaries(out, name, boundaries); });
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_VORONOI_OUTPUT_H
