// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lays faces out in the plane, from the lengths of their edges.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_LAYOUT_BY_LENGTHS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_LAYOUT_BY_LENGTHS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Has a function functor(), as Layout_by_points.
template <class FT_>
class Layout_by_lengths
{
public:
  typedef FT_ FT;

  // lengths: of the halfedges
  explicit Layout_by_lengths(const std::vector<FT>& lengths) : m_lengths(lengths) {}

  auto functor() const
  {
    return [&lengths = m_lengths](Index f, const Index(&)[3], FT(&length)[3], FT(&x)[3], FT(&y)[3]) {
      for (std::size_t k = 0; k < 3; ++k)
      {
        length[k] = lengths[3 * f + k];
        if (!CGAL::is_positive(length[k])) return;
      }
      const FT area = twice_the_area(length);
      for (int k = 0; k < 3; ++k)
      {
        const FT &a = length[k], &b = length[(k + 1) % 3], &c = length[(k + 2) % 3];
        x[k] = FT(FT(FT(c - b) * FT(c + b)) / a + a) / FT(2);
        y[k] = area / a;
      }
    };
  }

private:
  // Heron's formula in the form of Kahan, whose differences are exact or harmless. 0 if the strict triangle inequality fails.
  static FT twice_the_area(const FT (&length)[3])
  {
    FT a = length[0], b = length[1], c = length[2];
    if (a < b) std::swap(a, b);
    if (b < c) std::swap(b, c);
    if (a < b) std::swap(a, b);
    const FT least = c - FT(a - b);
    if (!CGAL::is_positive(least)) return FT(0);
    return square_root<FT>(FT(FT(a + FT(b + c)) * least) * FT(FT(c + FT(a - b)) * FT(a + FT(b - c)))) / FT(2);
  }

  const std::vector<FT>& m_lengths;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
