// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_OFFSET_CURVES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_OFFSET_CURVES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/Length_unit.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/Offset_file_format.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/Plane_of_faces.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/writing_parameters.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_csv.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_dxf.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_obj.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_polylines.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_svg.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_vtk.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_vtp.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <fstream>
#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

namespace Surface_mesh_geodesic_offset_internal {

// The arguments of write_offset_curves(), checked before a file is opened.
template <class CurveRange>
class Offset_curves_writer
{
public:
  // \throws std::invalid_argument if the curves cannot be written in this format, or if the tolerance or the spacing is not positive
  // \throws std::length_error if it is so small that a curve has too many points
  template <class NamedParameters>
  Offset_curves_writer(Offset_file_format format, const CurveRange& curves, const NamedParameters& np)
    : m_curves(curves), m_format(format),
      m_options(point_options_of<Geodesic_offset::internal::Writing_parameters>(curves, np)),
      m_unit(length_unit_of<Geodesic_offset::internal::Writing_parameters>(np))
  {
    check_point_options(m_options);
    if (format == Offset_file_format::SVG) plane_of_curves(curves);
    else if (format == Offset_file_format::DXF) check_numbers_of_points(curves, m_options.chord_tolerance);
    else check_numbers_of_points(curves, m_options);
  }

  bool write(std::ostream& os) const
  {
    const auto unit = parameters::length_unit(m_unit);
    switch (m_format)
    {
    case Offset_file_format::VTK: return write_vtk(os, m_curves, m_options);
    case Offset_file_format::VTP: return write_lines<Vtp_lines>(os, m_curves, m_options);
    case Offset_file_format::CSV: return write_lines<Csv_lines>(os, m_curves, m_options);
    case Offset_file_format::OBJ: return write_lines<Obj_lines>(os, m_curves, m_options);
    case Offset_file_format::DXF: return write_offset_DXF(os, m_curves, unit.chord_tolerance(m_options.chord_tolerance));
    case Offset_file_format::SVG: return write_offset_SVG(os, m_curves, unit);
    default: return write_lines<Polyline_lines>(os, m_curves, m_options);
    }
  }

private:
  const CurveRange& m_curves;
  const Offset_file_format m_format;
  const Point_options m_options;
  const Length_unit m_unit;
};

} // namespace Surface_mesh_geodesic_offset_internal

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief writes offset curves to a stream, in a given format.

\tparam OffsetCurveRange a model of `ConstRange` with `Surface_mesh_geodesic_offset::Offset_curve` as value type
\tparam NamedParameters a sequence of named parameters
\param os the stream
\param format the format
\param curves the curves
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{chord_tolerance}
    \cgalParamDescription{the largest distance of polylines in the file from their curves, in the units of the mesh's points.
                          The polylines have few points, see `Geodesic_offset_curve::points()`. The parameter does not affect
                          arcs, which SVG files have everywhere and DXF files for curves in a plane.}
    \cgalParamType{a number type, convertible to `double`; positive}
    \cgalParamDefault{1e-4 of the diagonal of the bounding box of the end points of all pieces}
  \cgalParamNEnd
  \cgalParamNBegin{point_spacing}
    \cgalParamDescription{the largest distance between consecutive points along the curve: the points are those of
                          `Geodesic_offset_curve::points_at_spacing()`, evenly spaced, whatever the chord tolerance. The parameter
                          does not affect DXF and SVG files.}
    \cgalParamType{a number type, convertible to `double`; positive}
    \cgalParamDefault{none: the points depend on the chord tolerance}
  \cgalParamNEnd
  \cgalParamNBegin{smooth_normals}
    \cgalParamDescription{whether normals are those of `Geodesic_offset_curve::smooth_normal()`, interpolated between vertices,
                          instead of those of faces; for the formats with normals: VTK, VTP and CSV}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{curve_nesting}
    \cgalParamDescription{the places of the curves in the tree of nesting, which VTK, VTP and CSV files then have per curve:
                          `parent` (the index of the curve, -1 without one) and `inner_side` (0 none, 1 left, 2 right)}
    \cgalParamType{a range of `Offset_curve_nesting`, copied, as `nest_offset_curves()` returns it}
    \cgalParamDefault{none}
    \cgalParamExtra{Throws `std::invalid_argument` if it has another size than the curves.}
  \cgalParamNEnd
  \cgalParamNBegin{length_unit}
    \cgalParamDescription{the unit of the mesh, for DXF and SVG; other formats have no unit}
    \cgalParamType{`IO::Length_unit`}
    \cgalParamDefault{`IO::Length_unit::NONE`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return whether the stream is still good.
\throws std::invalid_argument if the chord tolerance or the spacing is not positive, or if the format is SVG and the curves do not lie in one
        plane; then nothing has been written
\throws std::length_error as `Geodesic_offset_curve::points()` and `points_at_spacing()`, unless the format is SVG; then nothing has been written
*/
template <class OffsetCurveRange, class NamedParameters = parameters::Default_named_parameters>
bool write_offset_curves(std::ostream& os, Offset_file_format format, const OffsetCurveRange& curves,
                         const NamedParameters& np = parameters::default_values())
{
  return Surface_mesh_geodesic_offset_internal::Offset_curves_writer<OffsetCurveRange>(format, curves, np).write(os);
}

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief writes offset curves to a file, in the format of its extension, see `Offset_file_format`.

\tparam OffsetCurveRange a model of `ConstRange` with `Surface_mesh_geodesic_offset::Offset_curve` as value type
\tparam NamedParameters a sequence of named parameters
\param file_name the name of the file, which is overwritten
\param curves the curves
\param np an optional sequence of named parameters, those of the overload for streams

\return `false` if the file cannot be opened, or if writing fails.
\throws std::invalid_argument as `offset_file_format()` and the overload for streams; then the file is unchanged
\throws std::length_error as the overload for streams; then the file is unchanged
*/
template <class OffsetCurveRange, class NamedParameters = parameters::Default_named_parameters>
bool write_offset_curves(const std::string& file_name, const OffsetCurveRange& curves,
                         const NamedParameters& np = parameters::default_values())
{
  const Surface_mesh_geodesic_offset_internal::Offset_curves_writer<OffsetCurveRange> writer(offset_file_format(file_name),
                                                                                             curves, np);
  std::ofstream os(file_name, std::ios::binary);
  if (!os || !writer.write(os)) return false;
  os.close(); // flushes
  return os.good();
}

} // namespace IO
} // namespace CGAL

#endif
