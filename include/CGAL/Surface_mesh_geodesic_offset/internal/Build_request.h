// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The request of a build: what it computes, and when it stops.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_BUILD_REQUEST_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_BUILD_REQUEST_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Merging_tolerance.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
struct Build_request
{
  FT maximum = Number_policy<FT>::infinity();
  bool keeps_windows = false;
  std::vector<Surface_point<FT>> targets;   // stop when all of them are final; empty: no such condition
  std::function<bool(double)> goes_on = {}; // called with the completed fraction; false stops the build
  Merging_tolerance<FT> tolerance = {};
  bool finds_farthest = false; // also compute the largest distance, including face interiors
  bool keeps_memory = false;   // for the next build on this mesh; by one thread and without a tolerance
  const std::vector<Located_point<FT>>* shared_targets = nullptr; // instead of `targets`, which are copied: the caller's,
  std::size_t first_target = 0;                                   // from this one on

  // Drops what only the propagation needs, so that a field does not keep the visitor of its build alive.
  void release_inputs()
  {
    goes_on = nullptr;
    targets = {};
    shared_targets = nullptr;
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
