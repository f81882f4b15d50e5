// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_OFFSET_FILE_FORMAT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_OFFSET_FILE_FORMAT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::IO {

/// \ingroup PkgSurfaceMeshGeodesicOffsetEnums
/// \brief The formats of `write_offset_curves()`.
enum class Offset_file_format {
  POLYLINES, ///< `write_offset_polylines()`, file names end with `.polylines.txt`
  VTK,       ///< `write_offset_VTK()`, `.vtk`
  VTP,       ///< `write_offset_VTP()`, `.vtp`
  OBJ,       ///< `write_offset_OBJ()`, `.obj`
  CSV,       ///< `write_offset_CSV()`, `.csv`
  DXF,       ///< `write_offset_DXF()`, `.dxf`
  SVG        ///< `write_offset_SVG()`, `.svg`
};

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief returns the format for the extension of a file name, in upper or lower case.

\throws std::invalid_argument if the name has none of the extensions of `Offset_file_format`
*/
inline Offset_file_format offset_file_format(const std::string& file_name)
{
  const std::pair<const char*, Offset_file_format> formats[] = {
    {".polylines.txt", Offset_file_format::POLYLINES},
    {".vtk", Offset_file_format::VTK},
    {".vtp", Offset_file_format::VTP},
    {".obj", Offset_file_format::OBJ},
    {".csv", Offset_file_format::CSV},
    {".dxf", Offset_file_format::DXF},
    {".svg", Offset_file_format::SVG}};
  const auto is_same = [](char a, char b) { return a == char(std::tolower((unsigned char)(b))); };
  std::string extensions;
  for (const auto& [extension, format] : formats)
  {
    const std::string e(extension);
    if (file_name.size() > e.size() && std::equal(e.rbegin(), e.rend(), file_name.rbegin(), is_same)) return format;
    extensions += extensions.empty() ? e : ", " + e;
  }
  throw std::invalid_argument("Surface_mesh_geodesic_offset: the extension of \"" + file_name + "\" is none of " + extensions);
}

} // namespace CGAL::IO

#endif
