// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The start values of sources: the distances at their points, before paths from other sources are considered.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_START_VALUES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_START_VALUES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CGAL::Geodesic_offset::internal {

// One value per source primitive. Values are stored only if one of them is positive.
template <class FT>
class Start_values
{
public:
  void push_back(const FT& value)
  {
    CGAL_precondition(!CGAL::is_negative(value));
    ++m_size;
    if (m_values.empty() && CGAL::is_zero(value)) return;
    m_values.resize(m_size, FT(0));
    m_values.back() = value;
    if (m_largest < value) m_largest = value;
  }

  // Zero for an invalid reference.
  const FT& of(Source_ref source_ref) const
  {
    if (m_values.empty() || !source_ref.is_valid()) return m_zero;
    CGAL_precondition(source_ref.primitive() < m_values.size());
    return m_values[source_ref.primitive()];
  }

  const FT& largest() const { return m_largest; }

  // The smallest value of a primitive from `first` on that is larger than x; infinity if there is none.
  FT next(Index first, const FT& x) const
  {
    if (m_values.empty()) return first < m_size && x < FT(0) ? FT(0) : Number_policy<FT>::infinity();
    FT result = Number_policy<FT>::infinity();
    for (std::size_t i = first; i < m_values.size(); ++i)
      if (x < m_values[i] && m_values[i] < result) result = m_values[i];
    return result;
  }

private:
  std::vector<FT> m_values;
  std::size_t m_size = 0;
  FT m_largest = FT(0), m_zero = FT(0);
};

} // namespace CGAL::Geodesic_offset::internal

#endif
