// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tolerance of builds whose distances may be smaller than the exact ones.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_MERGING_TOLERANCE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_MERGING_TOLERANCE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

namespace CGAL::Geodesic_offset::internal {

// Largest error of distances; they may be too small.
template <class FT>
struct Merging_tolerance
{
  FT relative = FT(0); // fraction of the distance
  FT absolute = FT(0); // length

  bool is_zero() const { return !(relative > FT(0)) && !(absolute > FT(0)); }

  // The least distance that the build may have where the exact one is d.
  FT least_of(const FT& d) const { return is_zero() ? d : FT((FT(1) - relative) * d - absolute); }

  // How much farther a point may be whose distance in the build is d.
  FT error_at(const FT& d) const { return is_zero() ? FT(0) : FT((relative * d + absolute) / (FT(1) - relative)); }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
