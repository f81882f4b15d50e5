// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_VTP_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_VTP_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/Curve_line.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/writing_parameters.h>

#include <cstddef>
#include <ostream>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace IO {
namespace Surface_mesh_geodesic_offset_internal {

// Writes ranges of curves one after the other into one file: each is a `Piece` of it, which begins with its number of points.
class Vtp_lines
{
public:
  static void begin(std::ostream& os, const Point_options&)
  {
    os << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n";
  }

  template <class OffsetCurveRange>
  static void add(std::ostream& os, const OffsetCurveRange& curves, const Point_options& options)
  {
    const Full_precision precision(os);
    const std::vector<Curve_line> lines = curve_lines(curves, options);
    std::size_t number_of_points = 0;
    for (const Curve_line& line : lines) number_of_points += line.points.size();
    const auto write_points = [&](const char* attributes, auto value) {
      constexpr bool is_vector = std::is_same<decltype(value), Coordinates Line_point::*>::value;
      begin_array(os, is_vector ? "Float64" : "Int64", attributes);
      write_values(os, lines, value);
      end_array(os);
    };

    os << "<Piece NumberOfPoints=\"" << number_of_points << "\" NumberOfVerts=\"0\" NumberOfLines=\"" << lines.size()
       << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData Normals=\"normal\">\n";
    write_points("Name=\"source\"", &Line_point::source);
    write_points("Name=\"side\"", &Line_point::side);
    write_points("Name=\"face\"", &Line_point::face);
    write_points("Name=\"barycentric\" NumberOfComponents=\"3\"", &Line_point::weights);
    write_points("Name=\"tangent\" NumberOfComponents=\"3\"", &Line_point::tangent);
    write_points("Name=\"normal\" NumberOfComponents=\"3\"", &Line_point::normal);
    os << "</PointData>\n<CellData Scalars=\"distance\">\n";
    write_array(os, lines, "Float64", "Name=\"distance\"", [&](const Curve_line& l) { os << l.distance << '\n'; });
    write_array(os, lines, "Int64", "Name=\"closed\"", [&](const Curve_line& l) { os << (l.is_closed ? 1 : 0) << '\n'; });
    write_array(os, lines, "Int64", "Name=\"source\"",
                [&](const Curve_line& l) { os << l.common(&Line_point::source) << '\n'; });
    write_array(os, lines, "Int64", "Name=\"side\"", [&](const Curve_line& l) { os << l.common(&Line_point::side) << '\n'; });
    if (!options.places.empty())
    {
      write_array(os, lines, "Int64", "Name=\"parent\"", [&](const Curve_line& l) { os << l.place.parent << '\n'; });
      write_array(os, lines, "Int64", "Name=\"inner_side\"", [&](const Curve_line& l) { os << l.place.inner_side << '\n'; });
    }
    os << "</CellData>\n<Points>\n";
    write_points("NumberOfComponents=\"3\"", &Line_point::point);
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
  static void begin_array(std::ostream& os, const char* type, const char* attributes)
  {
    os << "<DataArray type=\"" << type << "\" " << attributes << " format=\"ascii\">\n";
  }

  static void end_array(std::ostream& os) { os << "</DataArray>\n"; }

  template <class Write>
  static void write_array(std::ostream& os, const std::vector<Curve_line>& lines, const char* type, const char* attributes,
                          const Write& write)
  {
    begin_array(os, type, attributes);
    for (const Curve_line& line : lines) write(line);
    end_array(os);
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
bool write_offset_VTP(std::ostream& os, const OffsetCurveRange& curves,
                      const NamedParameters& np = parameters::default_values())
{
  return Surface_mesh_geodesic_offset_internal::write_lines<Surface_mesh_geodesic_offset_internal::Vtp_lines>(
    os, curves,
    Surface_mesh_geodesic_offset_internal::point_options_of<Geodesic_offset::internal::Table_parameters>(curves, np));
}

} // namespace IO
} // namespace CGAL

#endif
