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
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

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
    return [&lengths = m_lengths](Index f, const Index(&)[3]) {
      std::array<Apex, 3> result;
      for (std::size_t k = 0; k < 3; ++k)
      {
        result[k].length = lengths[3 * f + k];
        if (!CGAL::is_positive(result[k].length)) return result;
      }
      const FT area = twice_the_area(result[0].length, result[1].length, result[2].length);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const FT &a = result[k].length, &b = result[(k + 1) % 3].length, &c = result[(k + 2) % 3].length;
        // (a^2 - b^2 + c^2) / 2a. With c much shorter than a, the second form would cancel and lose the direction of the apex; with
        // a much shorter than c, the first one. Binding test: test_distance_errors, lengths.
        if (c < a) result[k].x = FT(FT(FT(a - b) * FT(a + b)) + FT(c * c)) / FT(a + a);
        else result[k].x = FT(FT(FT(c - b) * FT(c + b)) / a + a) / FT(2);
        result[k].y = area / a;
      }
      return result;
    };
  }

private:
  struct Apex
  {
    FT length = FT(0), x = FT(0), y = FT(0);
  };

  // Heron's formula in the form of Kahan, whose differences are exact or harmless. 0 if the strict triangle inequality fails.
  static FT twice_the_area(FT a, FT b, FT c)
  {
    if (a < b) std::swap(a, b);
    if (b < c) std::swap(b, c);
    if (a < b) std::swap(a, b);
    const FT least = c - FT(a - b);
    if (!CGAL::is_positive(least)) return FT(0);
    return square_root<FT>(FT(FT(a + FT(b + c)) * least) * FT(FT(c + FT(a - b)) * FT(a + FT(b - c)))) / FT(2);
  }

  const std::vector<FT>& m_lengths;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
