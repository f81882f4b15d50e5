// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times of the statistics.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SECONDS_SINCE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SECONDS_SINCE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <chrono>

namespace CGAL::Geodesic_offset::internal {

inline double seconds_since(std::chrono::steady_clock::time_point t)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - t).count();
}

} // namespace CGAL::Geodesic_offset::internal

#endif
