// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_NAMED_PARAMETERS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_NAMED_PARAMETERS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace internal_np {

enum geodesic_maximum_distance_t { geodesic_maximum_distance };
enum geodesic_keep_windows_t { geodesic_keep_windows };

} // namespace internal_np

namespace parameters {

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// the largest distance that is computed, inclusive. Points farther away are at infinity.
/// Default: infinity.
template <class FT>
Named_function_parameters<FT, internal_np::geodesic_maximum_distance_t> maximum_distance(const FT& d)
{
  return Named_function_parameters<FT, internal_np::geodesic_maximum_distance_t>(d);
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// whether the windows are kept after the propagation, which queries at points other than vertices need.
/// Default: `false`.
inline Named_function_parameters<bool, internal_np::geodesic_keep_windows_t> keep_windows(bool keep)
{
  return Named_function_parameters<bool, internal_np::geodesic_keep_windows_t>(keep);
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// both parameters at once.
template <class FT>
auto geodesic(const FT& maximum, bool keep)
{
  typedef Named_function_parameters<FT, internal_np::geodesic_maximum_distance_t> Base;
  return Named_function_parameters<bool, internal_np::geodesic_keep_windows_t, Base>(keep, Base(maximum));
}

} // namespace parameters
} // namespace CGAL

#endif
