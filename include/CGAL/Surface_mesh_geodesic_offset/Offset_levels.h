// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_LEVELS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_LEVELS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief holds the distances at which offset curves are requested: any finite set, or equally spaced ones.

\tparam FT a number type, model of `FieldNumberType` and `RealEmbeddable`, constructible from `double`: the `FT` of the
        traits, or a type that is convertible to it
*/
template <class FT>
class Offset_levels
{
public:
  /// the count of levels that stands for as many levels as the surface has.
  static constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

  /// the distances of a range, in any order; repeated distances count once.
  /// \throws std::invalid_argument if a distance is not a positive finite number.
  template <class Range>
  explicit Offset_levels(const Range& distances)
  {
    for (const auto& d : distances) m_distances.push_back(checked(FT(d), "an offset distance"));
    std::sort(m_distances.begin(), m_distances.end());
    m_distances.erase(std::unique(m_distances.begin(), m_distances.end()), m_distances.end());
  }

  /// the distances `spacing`, `2 * spacing`, ..., `count * spacing`.
  /// \throws std::invalid_argument if `spacing`, or `count * spacing` with a limited count, is not a positive finite number.
  static Offset_levels equally_spaced(const FT& spacing, std::size_t count = unlimited)
  {
    return equally_spaced(spacing, count, spacing);
  }

  /// the distances `start`, `start + spacing`, ..., `start + (count - 1) * spacing`.
  /// \throws std::invalid_argument if `spacing`, `start`, or the largest distance with a limited count, is not a positive finite
  ///         number.
  static Offset_levels equally_spaced(const FT& spacing, std::size_t count, const FT& start)
  {
    Offset_levels levels;
    levels.m_spacing = checked(spacing, "the spacing of offsets");
    levels.m_start = checked(start, "the first offset distance");
    levels.m_count = count;
    if (count != 0 && count != unlimited) checked(levels[count - 1], "the largest offset distance");
    return levels;
  }

  /// whether the number of levels depends on the extent of the surface.
  bool is_unlimited() const { return m_count == unlimited; }

  /// the number of levels; `unlimited` if `is_unlimited()`.
  std::size_t size() const { return m_count == 0 ? m_distances.size() : m_count; }

  /// the i-th smallest level.
  FT operator[](std::size_t i) const
  {
    if (m_count == 0) return m_distances[i];
    // as a product, the levels that start with the spacing are its multiples, rounded once
    return m_start == m_spacing ? FT(m_spacing * FT(double(i + 1))) : FT(m_start + m_spacing * FT(double(i)));
  }

  /// the distance between equally spaced levels; 0 if the levels are those of a range.
  const FT& spacing() const { return m_spacing; }

  /// the index of the first level that is larger than `d`; `size()` if there is none. Takes logarithmic time at most.
  std::size_t first_above(const FT& d) const
  {
    if (m_count == 0) return std::size_t(std::upper_bound(m_distances.begin(), m_distances.end(), d) - m_distances.begin());
    if (d < m_start) return 0;
    const double q = (CGAL::to_double(d) - CGAL::to_double(m_start)) / CGAL::to_double(m_spacing);
    if (!(q < 1e15)) return m_count;
    std::size_t i = q > 1 ? std::size_t(q) - 1 : 0;
    while (i < m_count && !((*this)[i] > d)) ++i;
    return (std::min)(i, m_count);
  }

#ifndef DOXYGEN_RUNNING
  template <class Number, class Conversion>
  Offset_levels<Number> converted(const Conversion& convert) const
  {
    Offset_levels<Number> result;
    result.m_count = m_count;
    result.m_spacing = convert(m_spacing);
    result.m_start = convert(m_start);
    for (const FT& d : m_distances) result.m_distances.push_back(convert(d));
    return result;
  }
#endif

private:
  template <class>
  friend class Offset_levels;

  Offset_levels() = default;

  static FT checked(const FT& d, const char* what)
  {
    const double x = CGAL::to_double(d);
    if (!(x > 0) || !(x <= (std::numeric_limits<double>::max)()))
      throw std::invalid_argument(std::string("Surface_mesh_geodesic_offset: ") + what +
                                  " must be a positive finite number, not " + std::to_string(x));
    return d;
  }

  std::vector<FT> m_distances;
  FT m_spacing = FT(0);
  FT m_start = FT(0);      // of the spacing
  std::size_t m_count = 0; // 0: m_distances holds the levels
};

} // namespace CGAL

#endif
