// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_POLYLINES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_POLYLINES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/writing_parameters.h>

#include <ostream>

namespace CGAL {
namespace IO {

namespace Surface_mesh_geodesic_offset_internal {

// Writes ranges of curves one after the other into one file.
struct Polyline_lines
{
  static void begin(std::ostream&, const Point_options&) {}

  template <class OffsetCurveRange>
  static void add(std::ostream& os, const OffsetCurveRange& curves, const Point_options& options)
  {
    const Full_precision precision(os);
    for (const auto& curve : curves)
    {
      const auto points = points_of(curve, options);
      os << points.size();
      for (const auto& p : points)
      {
        os << ' ';
        write_coordinates(os, p);
      }
      os << '\n';
    }
  }

  static void end(std::ostream&) {}
};

} // namespace Surface_mesh_geodesic_offset_internal

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief writes offset curves in %CGAL's `.polylines.txt` format: one line per curve, `n x1 y1 z1 ... xn yn zn`.

A closed curve repeats its first point.

\tparam OffsetCurveRange a model of `ConstRange` with `Surface_mesh_geodesic_offset::Offset_curve` as value type
\param os the stream
\param curves the curves
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{chord_tolerance}
    \cgalParamDescription{the largest distance of a line from its curve, in the units of the mesh's points}
    \cgalParamType{a number type, convertible to `double`; positive}
    \cgalParamDefault{that of `write_offset_curves()`}
  \cgalParamNEnd
  \cgalParamNBegin{point_spacing}
    \cgalParamDescription{as in `write_offset_curves()`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return whether the stream is still good.
\throws std::invalid_argument unless `chord_tolerance` and `point_spacing` are positive; then nothing has been written
\throws std::length_error as `Geodesic_offset_curve::points()` and `points_at_spacing()`; then nothing has been written
*/
template <class OffsetCurveRange, class NamedParameters = parameters::Default_named_parameters>
bool write_offset_polylines(std::ostream& os, const OffsetCurveRange& curves,
                            const NamedParameters& np = parameters::default_values())
{
  return Surface_mesh_geodesic_offset_internal::write_lines<Surface_mesh_geodesic_offset_internal::Polyline_lines>(
    os, curves,
    Surface_mesh_geodesic_offset_internal::point_options_of<Geodesic_offset::internal::Line_parameters>(curves, np));
}

} // namespace IO
} // namespace CGAL

#endif
