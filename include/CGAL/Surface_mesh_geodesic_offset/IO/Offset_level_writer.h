// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_OFFSET_LEVEL_WRITER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_OFFSET_LEVEL_WRITER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/Offset_file_format.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/writing_parameters.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_csv.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_obj.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_polylines.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_vtp.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/chord_tolerance.h>

#include <CGAL/assertions.h>

#include <boost/core/noncopyable.hpp>

#include <ostream>
#include <stdexcept>
#include <variant>

namespace CGAL::IO {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief writes offset curves to a stream in parts, for families of offsets that need not be in memory all at once.

The parts together are the file that `write_offset_curves()` writes for the curves of all parts, except that a `.vtp` file has one
piece per part. With `Surface_mesh_geodesic_offset::build_with_offset_curves_by_distance()`, for example:

\code
std::ofstream file("offsets.vtp", std::ios::binary);
CGAL::IO::Offset_level_writer writer(file, CGAL::IO::Offset_file_format::VTP, CGAL::parameters::chord_tolerance(tolerance));
geodesic.build_with_offset_curves_by_distance(distances, [&](double, auto&& curves) { writer.write(curves); });
const bool is_written = writer.finish();
\endcode

Not copyable. Memory is that for the points of one part.
*/
class Offset_level_writer : boost::noncopyable
{
public:
  /// returns whether a format can be written in parts: `POLYLINES`, `VTP`, `OBJ` and `CSV`.
  static bool supports(Offset_file_format format)
  {
    return format == Offset_file_format::POLYLINES || format == Offset_file_format::VTP || format == Offset_file_format::OBJ ||
           format == Offset_file_format::CSV;
  }

  /// writes the begin of the file.
  /// \param os the stream, which must outlive the writer
  /// \param format the format
  /// \tparam NamedParameters a sequence of named parameters
  /// \param np a sequence of named parameters among those listed below
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{chord_tolerance}
  ///     \cgalParamDescription{the largest distance of polylines in the file from their curves, in the units of the mesh's
  ///                           points}
  ///     \cgalParamType{a number type, convertible to `double`; positive}
  ///     \cgalParamDefault{none: the curves are not known yet, so the parameter is required}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{point_spacing}
  ///     \cgalParamDescription{as in `write_offset_curves()`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{smooth_normals}
  ///     \cgalParamDescription{as in `write_offset_curves()`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \throws std::invalid_argument unless `supports(format)`, and `chord_tolerance` and `point_spacing` are positive; then nothing
  ///         has been written
  template <class NamedParameters>
  Offset_level_writer(std::ostream& os, Offset_file_format format, const NamedParameters& np)
    : m_os(os), m_options(Surface_mesh_geodesic_offset_internal::required_point_options(np))
  {
    using namespace Surface_mesh_geodesic_offset_internal;
    if (!supports(format)) throw std::invalid_argument("Surface_mesh_geodesic_offset: the format cannot be written in parts");
    check_point_options(m_options);
    if (format == Offset_file_format::VTP) m_lines = Vtp_lines();
    else if (format == Offset_file_format::OBJ) m_lines = Obj_lines();
    else if (format == Offset_file_format::CSV) m_lines = Csv_lines();
    std::visit([&](auto& lines) { lines.begin(m_os, m_options); }, m_lines);
  }

  /// writes further curves.
  /// \tparam OffsetCurveRange a model of `ConstRange` with `Surface_mesh_geodesic_offset::Offset_curve` as value type
  /// \return whether the stream is still good.
  /// \pre `finish()` has not been called
  /// \throws std::length_error as `Geodesic_offset_curve::points()`; then nothing has been written of this part
  template <class OffsetCurveRange>
  bool write(const OffsetCurveRange& curves)
  {
    CGAL_precondition(!m_is_finished);
    Surface_mesh_geodesic_offset_internal::check_numbers_of_points(curves, m_options); // before any output
    std::visit([&](auto& lines) { lines.add(m_os, curves, m_options); }, m_lines);
    return m_os.good();
  }

  /// writes the end of the file.
  /// \return whether the stream is still good.
  /// \pre `finish()` has not been called
  bool finish()
  {
    CGAL_precondition(!m_is_finished);
    m_is_finished = true;
    std::visit([&](auto& lines) { lines.end(m_os); }, m_lines);
    return m_os.good();
  }

private:
  std::ostream& m_os;
  const Surface_mesh_geodesic_offset_internal::Point_options m_options;
  std::variant<Surface_mesh_geodesic_offset_internal::Polyline_lines, Surface_mesh_geodesic_offset_internal::Vtp_lines,
               Surface_mesh_geodesic_offset_internal::Obj_lines, Surface_mesh_geodesic_offset_internal::Csv_lines>
    m_lines;
  bool m_is_finished = false;
};

} // namespace CGAL::IO

#endif
