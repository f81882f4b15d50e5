// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets and their files.

#ifndef GEODESIC_OFFSET_CURVE_FILES_H
#define GEODESIC_OFFSET_CURVE_FILES_H

#include "common/common.h"
#include "common/output_file.h"
#include "level_files.h"
#include "output_options.h"

#include <CGAL/Surface_mesh_geodesic_offset/IO/write_offset_curves.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace geodesic_offset {

// Figures of one distance.
struct Level_figures
{
  double distance = 0;
  std::size_t number = 0;
  std::size_t closed = 0;
  double length = 0;
};

struct Offsets
{
  std::vector<Level_figures> levels; // distances with curves, in increasing order
  std::vector<Offset_curve> curves; // in the same order; empty if no output needs all of them
  std::vector<CGAL::Offset_curve_nesting> places; // of the curves, with --order
  std::size_t points = 0; // of polylines within the chord tolerance

  std::size_t number_of_curves() const
  {
    return std::accumulate(levels.begin(), levels.end(), std::size_t(0), [](std::size_t sum, const Level_figures& level) {
      return sum + level.number;
    });
  }
};

namespace internal {

// Measured on files of curved meshes, for the progress bar; 0: unknown. Files with arcs need fewer bytes for planar curves.
inline std::uintmax_t bytes_per_point(const std::string& file)
{
  switch(CGAL::IO::offset_file_format(file))
  {
  case CGAL::IO::Offset_file_format::VTK: return 134;
  case CGAL::IO::Offset_file_format::DXF: return 172;
  default: return 0;
  }
}

} // namespace internal

// Adds the files that are not written level by level. Omits a file whose format cannot represent the curves, and returns the
// reason.
inline std::string add_curve_files(Output_files& files, const Output_options& options, const Offsets& offsets, double tolerance)
{
  std::string problem;
  for(const std::string& file : options.outputs)
  {
    if(Level_files::is_written_by_level(options, file)) continue;
    const auto write = [&](std::ostream& out) {
      with_point_parameters(options, tolerance, [&](const auto& parameters) {
        return CGAL::IO::write_offset_curves(out, CGAL::IO::offset_file_format(file), offsets.curves,
                                             parameters.curve_nesting(offsets.places).length_unit(options.unit));
      });
    };
    try
    {
      files.add(file, write, offsets.points * internal::bytes_per_point(file));
    }
    catch(const std::invalid_argument& error)
    {
      problem = "cannot write " + quoted(file) + ": " + error.what();
    }
  }
  return problem;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_CURVE_FILES_H
