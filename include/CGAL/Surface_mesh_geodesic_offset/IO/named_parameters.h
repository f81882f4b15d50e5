// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_NAMED_PARAMETERS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_NAMED_PARAMETERS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/Length_unit.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace internal_np {

enum geodesic_chord_tolerance_t { geodesic_chord_tolerance };
enum geodesic_length_unit_t { geodesic_length_unit };

} // namespace internal_np

namespace parameters {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetParameters

\brief holds the named parameters of `IO::write_offset_curves()`: any number of the functions below, in any order, joined by
dots, as in `parameters::chord_tolerance(0.01).unit(IO::Length_unit::MILLIMETER)`.
*/
template <class T, class Tag, class Base = internal_np::No_property>
struct Offset_writing_parameters : Named_function_parameters<T, Tag, Base>
{
#ifndef DOXYGEN_RUNNING
  typedef Named_function_parameters<T, Tag, Base> Named_parameters;
  using Named_parameters::Named_parameters;
#endif

  /// the largest distance of polylines in the file from their curves: positive, in the units of the mesh's points. The
  /// polylines have few points, see `Geodesic_offset_curve::points()`. The parameter does not affect arcs, which SVG files have
  /// everywhere and DXF files in horizontal planes.
  /// %Default: 1e-4 of the diagonal of the bounding box of the end points of all pieces.
  template <class FT>
  auto chord_tolerance(const FT& d) const
  {
    return Offset_writing_parameters<FT, internal_np::geodesic_chord_tolerance_t, Offset_writing_parameters>(d, *this);
  }

  /// the unit of the mesh, for DXF and SVG; other formats have no unit. %Default: `IO::Length_unit::NONE`.
  auto unit(IO::Length_unit u) const
  {
    return Offset_writing_parameters<IO::Length_unit, internal_np::geodesic_length_unit_t, Offset_writing_parameters>(u,
                                                                                                                      *this);
  }
};

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// sets the largest distance of polylines from the curves, see `Offset_writing_parameters::chord_tolerance()`.
/// \param d a length, positive
template <class FT>
auto chord_tolerance(const FT& d)
{
  return Offset_writing_parameters<FT, internal_np::geodesic_chord_tolerance_t>(d);
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// sets the unit of the mesh, see `Offset_writing_parameters::unit()`.
/// \param u the unit
inline auto unit(IO::Length_unit u)
{
  return Offset_writing_parameters<IO::Length_unit, internal_np::geodesic_length_unit_t>(u);
}

} // namespace parameters
} // namespace CGAL

#endif
