// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// When sources start: those with start values start shortly before the front reaches these, so that their windows do not wait
// in lists.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_SOURCE_PACING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_SOURCE_PACING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Source_pacing
{
public:
  // Sources with start values up to this have started.
  const FT& last() const { return m_last; }

  // Sets the least start value above last(); infinity, if none is left.
  void set_next(const FT& start_value) { m_next = start_value; }
  const FT& next() const { return m_next; }
  bool has_next(const FT& maximum) const { return m_next <= maximum && Number_policy<FT>::is_finite(m_next); }

  // If the next sources are to start, passes on to them: last() becomes larger, and set_next() is to be called. Buckets: a
  // Bucket_queue or a Wavefront_state. The front moves by less than the buckets ahead until the next call.
  template <class Buckets>
  bool advance(const Buckets& buckets, const FT& longest_edge)
  {
    const std::size_t last = buckets.current() + least_buckets_ahead + 2 * buckets.bucket_of(longest_edge);
    if (buckets.bucket_of(m_next) > last) return false;
    m_last = (std::max)(m_next, FT(double(last) * buckets.bucket_width()));
    return true;
  }

private:
  static constexpr std::size_t least_buckets_ahead = 1 << 12; // limit of memory and time only

  FT m_last = FT(-1), m_next = FT(0);
};

} // namespace CGAL::Geodesic_offset::internal

#endif
