// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_POLYLINES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_POLYLINES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>

#include <ostream>

namespace CGAL {
namespace IO {

// Writes offset curves in CGAL's .polylines.txt format: one line a curve, "n x1 y1 z1 ... xn yn zn".
// A closed curve repeats its first point.
//
// OffsetCurveRange: a range of Surface_mesh_geodesic_offset::Offset_curve.
// chord_tolerance: the largest distance of a chord from the arc that it stands for; positive.
// Returns whether the stream is still good.
template <class OffsetCurveRange, class FT>
bool write_offset_polylines(std::ostream& os, const OffsetCurveRange& curves, const FT& chord_tolerance)
{
  const Surface_mesh_geodesic_offset_internal::Full_precision precision(os);
  for(const auto& curve : curves)
  {
    const auto points = Surface_mesh_geodesic_offset_internal::discretized(curve, chord_tolerance);
    os << points.size();
    for(const auto& p : points)
    {
      os << ' ';
      Surface_mesh_geodesic_offset_internal::write_coordinates(os, p);
    }
    os << '\n';
  }
  return os.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_POLYLINES_H
