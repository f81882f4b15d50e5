// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_VTK_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_VTK_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/Curve_line.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/writing_parameters.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL::IO {
namespace Surface_mesh_geodesic_offset_internal {

// The number of points precedes the points.
template <class OffsetCurveRange>
bool write_vtk(std::ostream& os, const OffsetCurveRange& curves, const Point_options& options)
{
  check_numbers_of_points(curves, options); // before any output
  const Full_precision precision(os);
  const std::vector<Curve_line> lines = curve_lines(curves, options);
  std::size_t number_of_points = 0, number_of_indices = 0;
  for (const auto& line : lines)
  {
    number_of_points += line.points.size();
    number_of_indices += line.number_of_indices();
  }
  const auto write = [&](const auto& values) { write_values(os, lines, values); };

  os << "# vtk DataFile Version 3.0\ngeodesic offsets\nASCII\nDATASET POLYDATA\nPOINTS " << number_of_points << " double\n";
  write(&Line_point::point);
  if (lines.empty()) return os.good();

  os << "LINES " << lines.size() << ' ' << lines.size() + number_of_indices << '\n';
  std::size_t first = 0;
  for (const auto& line : lines)
  {
    os << line.number_of_indices();
    for (std::size_t i = 0; i < line.number_of_indices(); ++i) os << ' ' << first + line.index(i);
    os << '\n';
    first += line.points.size();
  }

  // readers load only the first of several scalars by default, but all fields
  os << "CELL_DATA " << lines.size() << "\nSCALARS distance double 1\nLOOKUP_TABLE default\n";
  for (const auto& line : lines) os << line.distance << '\n';
  os << "FIELD curves " << (options.places.empty() ? 3 : 5) << "\nclosed 1 " << lines.size() << " int\n";
  for (const auto& line : lines) os << (line.is_closed ? 1 : 0) << '\n';
  os << "source 1 " << lines.size() << " int\n";
  for (const auto& line : lines) os << line.common(&Line_point::source) << '\n';
  os << "side 1 " << lines.size() << " int\n";
  for (const auto& line : lines) os << line.common(&Line_point::side) << '\n';

  if (!options.places.empty())
  {
    os << "parent 1 " << lines.size() << " int\n";
    for (const auto& line : lines) os << line.place.parent << '\n';
    os << "inner_side 1 " << lines.size() << " int\n";
    for (const auto& line : lines) os << line.place.inner_side << '\n';
  }
  os << "POINT_DATA " << number_of_points << "\nFIELD points 5\nsource 1 " << number_of_points << " int\n";
  write(&Line_point::source);
  os << "side 1 " << number_of_points << " int\n";
  write(&Line_point::side);
  os << "face 1 " << number_of_points << " int\n";
  write(&Line_point::face);
  os << "barycentric 3 " << number_of_points << " double\n";
  write(&Line_point::weights);
  os << "tangent 3 " << number_of_points << " double\n";
  write(&Line_point::tangent);
  os << "NORMALS normal double\n";
  write(&Line_point::normal);
  return os.good();
}

} // namespace Surface_mesh_geodesic_offset_internal

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief writes offset curves as lines of a legacy VTK file (ASCII, polydata), for ParaView and other users of VTK.

Each curve is one line. A closed line ends with the index of its first point. The arrays are
- for lines: `distance`, `closed` (1 or 0), `source` (the id of the source), and `side` (0 none, 1 left, 2 right, 3 cap,
  as in `Source_side`). The last two are -1 if a curve belongs to several sources or sides; with `curve_nesting`, also `parent`
  and `inner_side`;
- for points: `source`, `side`, `normal` (the outer unit normal of the face, or the smooth normal), `tangent` (the unit vector in the
  direction of travel), `face` and `barycentric` (the index of the face, and the coordinates in it, as in `write_offset_CSV()`).
  A point between two pieces has the values of the first piece. Independent of the tolerance, but not with a spacing, all points
  where source or side change are points of the line, so each segment of a line belongs to one source and one side: those of its
  end point.

`distance` is the active array. The arrays for lines serve to select curves, for instance by a threshold, those for points
to colour the curves.

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
  \cgalParamNBegin{smooth_normals}
    \cgalParamDescription{as in `write_offset_curves()`}
  \cgalParamNEnd
  \cgalParamNBegin{curve_nesting}
    \cgalParamDescription{as in `write_offset_curves()`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return whether the stream is still good.
\throws std::invalid_argument unless `chord_tolerance` and `point_spacing` are positive; then nothing has been written
\throws std::length_error as `Geodesic_offset_curve::points()` and `points_at_spacing()`; then nothing has been written
*/
template <class OffsetCurveRange, class NamedParameters = parameters::Default_named_parameters>
bool write_offset_VTK(std::ostream& os, const OffsetCurveRange& curves,
                      const NamedParameters& np = parameters::default_values())
{
  namespace internal = Surface_mesh_geodesic_offset_internal;
  return internal::write_vtk(os, curves, internal::point_options_of<Geodesic_offset::internal::Table_parameters>(curves, np));
}

} // namespace CGAL::IO

#endif
