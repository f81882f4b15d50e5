// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long ago the front reached the faces that it has not passed yet: every face with a point nearer than the oldest of
// them is finished.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_UNFINISHED_FACES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_UNFINISHED_FACES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Number_policy.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <limits>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

class Unfinished_faces
{
public:
  explicit Unfinished_faces(std::size_t number_of_faces) : m_reached_in(number_of_faces, 0) {}

  // The front has reached face f in this bucket; buckets never decrease.
  void add(Index f, std::size_t bucket)
  {
    // beyond the range of an index: early is always right
    const Index b = Index((std::min)(bucket, std::size_t((std::numeric_limits<Index>::max)() - 1)));
    if (m_numbers.empty()) m_first = b;
    if (b >= m_first + m_numbers.size()) m_numbers.resize(b - m_first + 1, 0);
    ++m_numbers[b - m_first];
    m_reached_in[f] = b;
  }

  void remove(Index f) { --m_numbers[m_reached_in[f] - m_first]; }

  // The bucket in which the oldest of them was reached; `otherwise` if there is none.
  std::size_t oldest(std::size_t otherwise)
  {
    while (!m_numbers.empty() && m_numbers.front() == 0)
    {
      m_numbers.pop_front();
      ++m_first;
    }
    return m_numbers.empty() ? otherwise : (std::min)(otherwise, m_first);
  }

private:
  std::vector<Index> m_reached_in; // per face
  std::deque<Index> m_numbers;     // of unfinished faces, by bucket
  std::size_t m_first = 0;         // bucket of the first number
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
