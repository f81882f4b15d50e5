// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_LENGTH_UNIT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_LENGTH_UNIT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

namespace CGAL::IO {

/// \ingroup PkgSurfaceMeshGeodesicOffsetEnums
/// \brief The unit of the coordinates of a mesh, for the file formats with a unit: DXF and SVG. No coordinate is converted.
enum class Length_unit {
  NONE,       ///< unknown: the file has no unit
  MILLIMETER, ///< mm
  CENTIMETER, ///< cm
  METER,      ///< m
  INCH        ///< in
};

} // namespace CGAL::IO

#endif
