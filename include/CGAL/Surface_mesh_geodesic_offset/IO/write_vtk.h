// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_VTK_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_VTK_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace IO {

// Writes offset curves as lines of a legacy VTK file (ASCII, polydata) with two values a line: `distance`, and `closed`
// (1 or 0). A closed line ends at the point where it begins, which is there once.
//
// OffsetCurveRange: a range of Surface_mesh_geodesic_offset::Offset_curve.
// chord_tolerance: the largest distance of a chord from the arc that it stands for; positive.
// Returns whether the stream is still good.
template <class OffsetCurveRange, class FT>
bool write_offset_VTK(std::ostream& os, const OffsetCurveRange& curves, const FT& chord_tolerance)
{
  namespace internal = Surface_mesh_geodesic_offset_internal;
  const internal::Full_precision precision(os);

  // the number of all points stands before the first of them
  std::vector<std::vector<internal::Coordinates>> lines;
  std::size_t number_of_points = 0, number_of_indices = 0;
  for(const auto& curve : curves)
  {
    lines.push_back(internal::discretized(curve, chord_tolerance));
    number_of_indices += lines.back().size();
    if(curve.is_closed() && !lines.back().empty())
      lines.back().pop_back();
    number_of_points += lines.back().size();
  }

  os << "# vtk DataFile Version 3.0\ngeodesic offsets\nASCII\nDATASET POLYDATA\nPOINTS " << number_of_points << " double\n";
  for(const auto& line : lines)
    for(const auto& p : line)
    {
      internal::write_coordinates(os, p);
      os << '\n';
    }
  if(lines.empty())
    return os.good();

  os << "LINES " << lines.size() << ' ' << lines.size() + number_of_indices << '\n';
  std::size_t first = 0;
  auto line = lines.begin();
  for(const auto& curve : curves)
  {
    const std::size_t n = line->size();
    const bool closed = curve.is_closed() && n != 0;
    os << n + (closed ? 1 : 0);
    for(std::size_t i = 0; i < n; ++i)
      os << ' ' << first + i;
    if(closed)
      os << ' ' << first;
    os << '\n';
    first += n;
    ++line;
  }

  os << "CELL_DATA " << lines.size() << "\nSCALARS distance double 1\nLOOKUP_TABLE default\n";
  for(const auto& curve : curves)
    os << CGAL::to_double(curve.distance()) << '\n';
  os << "SCALARS closed int 1\nLOOKUP_TABLE default\n";
  for(const auto& curve : curves)
    os << (curve.is_closed() ? 1 : 0) << '\n';
  return os.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_VTK_H
