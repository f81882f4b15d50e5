// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_OBJ_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_OBJ_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace IO {

// Writes offset curves as line elements of an .obj file. All curves of one distance are in one group, named
// `offset_` and the distance, if the range has them in sequence. A closed line ends with the index of its first point.
//
// OffsetCurveRange: a range of Surface_mesh_geodesic_offset::Offset_curve.
// chord_tolerance: the largest distance of a chord from the arc that it stands for; positive.
// Returns whether the stream is still good.
template <class OffsetCurveRange, class FT>
bool write_offset_OBJ(std::ostream& os, const OffsetCurveRange& curves, const FT& chord_tolerance)
{
  namespace internal = Surface_mesh_geodesic_offset_internal;
  const internal::Full_precision precision(os);
  os << "# geodesic offsets\n";
  std::size_t first = 1; // counted from 1 in this format
  bool has_group = false;
  double group = 0;
  for(const auto& curve : curves)
  {
    const double distance = CGAL::to_double(curve.distance());
    if(!has_group || distance != group)
    {
      os << "g offset_" << distance << '\n';
      has_group = true;
      group = distance;
    }
    auto points = internal::discretized(curve, chord_tolerance);
    const bool closed = curve.is_closed() && !points.empty();
    if(closed)
      points.pop_back();
    for(const auto& p : points)
    {
      os << "v ";
      internal::write_coordinates(os, p);
      os << '\n';
    }
    os << 'l';
    for(std::size_t i = 0; i < points.size(); ++i)
      os << ' ' << first + i;
    if(closed)
      os << ' ' << first;
    os << '\n';
    first += points.size();
  }
  return os.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_OBJ_H
