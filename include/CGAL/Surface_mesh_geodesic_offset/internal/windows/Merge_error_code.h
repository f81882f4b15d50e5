// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a window that was merged within a tolerance carries in the place of its pseudo-source: the bound of its error.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_MERGE_ERROR_CODE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_MERGE_ERROR_CODE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// The image of a merged window is no vertex and no source, so the number of a pseudo-source is free to say how large the
// error may be: a float without its sign and its last two bits, rounded upward. Numbers of vertices are smaller.
struct Merge_error_code
{
  static_assert(sizeof(float) == sizeof(Index) && std::numeric_limits<float>::is_iec559, "32 bits, without sign 31");

  static Index with_error(double error)
  {
    float e = float(error);
    if (double(e) < error) e = std::nextafter(e, std::numeric_limits<float>::infinity());
    Index bits;
    std::memcpy(&bits, &e, sizeof(bits));
    return flag + ((bits + 3) >> 2) - 1;
  }

  static bool is_merged(Index origin) { return origin + 1 >= flag; } // no_index + 1 is 0

  static double error(Index origin)
  {
    const Index bits = (origin + 1 - flag) << 2;
    float e;
    std::memcpy(&e, &bits, sizeof(e));
    return e;
  }

private:
  static constexpr Index flag = 1u << 29; // the origin has 30 bits in a window
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
