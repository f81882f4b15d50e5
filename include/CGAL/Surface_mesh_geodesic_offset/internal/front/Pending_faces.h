// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bucket in which the front reached each pending face. Every face with a point nearer than the oldest of these buckets is
// finalized.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_PENDING_FACES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_PENDING_FACES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Front_parts.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <limits>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

class Pending_faces
{
public:
  // `reached_in`: memory per face, whose values do not matter. Zero faces: no query will follow.
  Pending_faces(std::size_t number_of_faces, const Front_parts& parts, std::vector<Index>& reached_in)
    : m_parts(parts), m_is_used(number_of_faces > 0), m_reached_in(reached_in), m_counts(parts.number())
  {
    m_reached_in.resize((std::max)(m_reached_in.size(), number_of_faces));
  }

  // Records that the front reaches face f in this bucket; buckets do not decrease.
  void add(Index f, std::size_t bucket)
  {
    if (!m_is_used) return;
    // Saturates at the range of an index; an earlier bucket is always valid.
    const Index b = Index((std::min)(bucket, std::size_t((std::numeric_limits<Index>::max)() - 1)));
    Counts& counts = m_counts[m_parts.of_face(f)];
    if (counts.numbers.empty()) counts.first = b;
    CGAL_precondition(b >= counts.first);
    while (b >= counts.first + counts.numbers.size()) counts.numbers.push_back(0);
    ++counts.numbers[b - counts.first];
    ++counts.sum;
    m_reached_in[f] = b;
  }

  void remove(Index f)
  {
    if (!m_is_used) return;
    Counts& counts = m_counts[m_parts.of_face(f)];
    CGAL_precondition(m_reached_in[f] >= counts.first && m_reached_in[f] - counts.first < counts.numbers.size());
    CGAL_precondition(counts.numbers[m_reached_in[f] - counts.first] > 0);
    --counts.numbers[m_reached_in[f] - counts.first];
    --counts.sum;
  }

  // Number of pending faces.
  std::size_t number() const
  {
    std::size_t n = 0;
    for (const Counts& counts : m_counts) n += counts.sum;
    return n;
  }

  // Bucket of the oldest pending face; `otherwise` if there is none.
  std::size_t oldest(std::size_t otherwise)
  {
    for (Counts& counts : m_counts)
    {
      while (!counts.numbers.empty() && counts.numbers.front() == 0)
      {
        counts.numbers.pop_front();
        ++counts.first;
      }
      if (!counts.numbers.empty()) otherwise = (std::min)(otherwise, counts.first);
    }
    return otherwise;
  }

private:
  // Counts of a part of the front.
  struct alignas(64) Counts
  {
    std::deque<Index> numbers; // of pending faces, per bucket
    std::size_t first = 0;     // bucket of the first number
    std::size_t sum = 0;       // of the numbers
  };

  const Front_parts m_parts;
  const bool m_is_used;
  std::vector<Index>& m_reached_in; // per face
  std::vector<Counts> m_counts;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
