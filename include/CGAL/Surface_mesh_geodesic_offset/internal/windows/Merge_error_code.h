// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Code of a merged window in the field of the pseudo-source: the bound of its error.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_MERGE_ERROR_CODE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_MERGE_ERROR_CODE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace CGAL::Geodesic_offset::internal {

// The image of a merged window is neither a vertex nor a source, so the field of the pseudo-source encodes the error: a float
// without sign and last two bits, rounded up. Indices of vertices are smaller.
struct Merge_error_code
{
  static_assert(sizeof(float) == sizeof(Index) && std::numeric_limits<float>::is_iec559, "32 bits, without sign 31");

  static Index with_error(double error)
  {
    const float e = float(error);
    Index bits;
    std::memcpy(&bits, &e, sizeof(bits));
    if (double(e) < error) ++bits; // the next float
    return flag + ((bits + 3) >> 2) - 1;
  }

  static bool is_merged(Index origin) { return origin + 1 >= flag; } // no_index + 1 is 0

  static double error(Index origin) { return decoded(origin + 1); }

  // The larger error of two origins, 0 for other origins: codes grow with the error, so this has no branch.
  static double largest_error(Index a, Index b) { return decoded((std::max)({flag, a + 1, b + 1})); }

private:
  static double decoded(Index code)
  {
    const Index bits = (code - flag) << 2;
    float e;
    std::memcpy(&e, &bits, sizeof(e));
    return e;
  }

  static constexpr Index flag = 1u << 29; // a window has 30 bits for the origin
};

} // namespace CGAL::Geodesic_offset::internal

#endif
