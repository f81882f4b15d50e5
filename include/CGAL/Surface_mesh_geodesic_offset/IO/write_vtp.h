// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_VTP_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_VTP_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/Curve_line.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/writing_parameters.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace IO {
namespace Surface_mesh_geodesic_offset_internal {

// Writes ranges of curves one after the other into one file: each is a `Piece` of it, which begins with its number of points.
class Vtp_lines
{
public:
  static void begin(std::ostream& os)
  {
    os << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n";
  }

  template <class OffsetCurveRange, class FT>
  static void add(std::ostream& os, const OffsetCurveRange& curves, const FT& chord_tolerance)
  {
    const Full_precision precision(os);
    const std::vector<Curve_line> lines = curve_lines(curves, chord_tolerance);
    std::size_t number_of_points = 0;
    for (const Curve_line& line : lines) number_of_points += line.points.size();

    os << "<Piece NumberOfPoints=\"" << number_of_points << "\" NumberOfVerts=\"0\" NumberOfLines=\"" << lines.size()
       << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData Normals=\"normal\">\n";
    write_array(os, lines, "Int64", "Name=\"source\"", [&](const Curve_line& l) { write_numbers(os, l.sources); });
    write_array(os, lines, "Int64", "Name=\"side\"", [&](const Curve_line& l) { write_numbers(os, l.sides); });
    write_array(os, lines, "Float64", "Name=\"normal\" NumberOfComponents=\"3\"",
                [&](const Curve_line& l) { write_points(os, l.normals); });
    os << "</PointData>\n<CellData Scalars=\"distance\">\n";
    write_array(os, lines, "Float64", "Name=\"distance\"", [&](const Curve_line& l) { os << l.distance << '\n'; });
    write_array(os, lines, "Int64", "Name=\"closed\"", [&](const Curve_line& l) { os << (l.is_closed ? 1 : 0) << '\n'; });
    write_array(os, lines, "Int64", "Name=\"source\"", [&](const Curve_line& l) { os << common_value(l.sources) << '\n'; });
    write_array(os, lines, "Int64", "Name=\"side\"", [&](const Curve_line& l) { os << common_value(l.sides) << '\n'; });
    os << "</CellData>\n<Points>\n";
    write_array(os, lines, "Float64", "NumberOfComponents=\"3\"", [&](const Curve_line& l) { write_points(os, l.points); });
    os << "</Points>\n<Lines>\n";
    std::size_t first = 0, end = 0;
    write_array(os, lines, "Int64", "Name=\"connectivity\"", [&](const Curve_line& l) {
      for (std::size_t i = 0; i < l.number_of_indices(); ++i) os << first + l.index(i) << '\n';
      first += l.points.size();
    });
    write_array(os, lines, "Int64", "Name=\"offsets\"",
                [&](const Curve_line& l) { os << (end += l.number_of_indices()) << '\n'; });
    os << "</Lines>\n</Piece>\n";
  }

  static void end(std::ostream& os) { os << "</PolyData>\n</VTKFile>\n"; }

private:
  template <class Write>
  static void write_array(std::ostream& os, const std::vector<Curve_line>& lines, const char* type, const char* attributes,
                          const Write& write)
  {
    os << "<DataArray type=\"" << type << "\" " << attributes << " format=\"ascii\">\n";
    for (const Curve_line& line : lines) write(line);
    os << "</DataArray>\n";
  }

  template <class Number>
  static void write_numbers(std::ostream& os, const std::vector<Number>& numbers)
  {
    for (const Number& x : numbers) os << x << '\n';
  }

  static void write_points(std::ostream& os, const std::vector<Coordinates>& points)
  {
    for (const Coordinates& p : points)
    {
      write_coordinates(os, p);
      os << '\n';
    }
  }
};

} // namespace Surface_mesh_geodesic_offset_internal

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief writes offset curves as lines of an XML file of VTK (ASCII, polydata), for ParaView and other users of VTK.

Lines and arrays are those of `write_offset_VTK()`. Unlike the format of that function, this one can be written level by level,
see `Offset_level_writer`; each level is then a piece of the file, which readers of VTK join.

\tparam OffsetCurveRange a model of `ConstRange` with `Surface_mesh_geodesic_offset::Offset_curve` as value type
\param os the stream
\param curves the curves
\param np an optional named parameter

\cgalNamedParamsBegin
  \cgalParamNBegin{chord_tolerance}
    \cgalParamDescription{the largest distance of a line from its curve, in the units of the mesh's points}
    \cgalParamType{a number type, convertible to `double`; positive}
    \cgalParamDefault{that of `write_offset_curves()`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return whether the stream is still good.
\throws std::invalid_argument unless `chord_tolerance > 0`; then nothing has been written
\throws std::length_error as `Geodesic_offset_curve::points()`; then nothing has been written
*/
template <class OffsetCurveRange, class NamedParameters = parameters::Default_named_parameters>
bool write_offset_VTP(std::ostream& os, const OffsetCurveRange& curves,
                      const NamedParameters& np = parameters::default_values())
{
  return Surface_mesh_geodesic_offset_internal::write_lines<Surface_mesh_geodesic_offset_internal::Vtp_lines>(
    os, curves, Surface_mesh_geodesic_offset_internal::chord_tolerance_of(curves, np));
}

} // namespace IO
} // namespace CGAL

#endif
