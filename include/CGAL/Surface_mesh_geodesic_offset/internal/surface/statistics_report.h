// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of builds with the named parameter verbose().

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_STATISTICS_REPORT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_STATISTICS_REPORT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_statistics.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <iostream>

namespace CGAL::Geodesic_offset::internal {

// Writes one line to std::clog if the parameters have verbose(true).
template <class NamedParameters>
void report(const Geodesic_offset_statistics& s, const NamedParameters& np)
{
  if constexpr (has_parameter<internal_np::verbose_t, NamedParameters>)
    if (parameters::get_parameter(np, internal_np::verbose))
      std::clog << "Surface_mesh_geodesic_offset: " << s.windows_propagated << " windows propagated, " << s.windows_peak
                << " at one time, " << s.pieces << " pieces of offset curves, " << s.propagation_seconds + s.offset_seconds
                << " s\n";
}

} // namespace CGAL::Geodesic_offset::internal

#endif
