// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// When the front has passed a face: then all distances in it are final.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FACE_PASSING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FACE_PASSING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Face_passing
{
  typedef Wavefront_state<FT> State;

public:
  explicit Face_passing(State& state) : m_state(state) {}

  // Looks at the faces of a part that wait in the bucket. Those that the front has passed are added to `passed`, the others
  // wait on.
  void look(Index part, std::vector<Index>& passed) const
  {
    Bucket_queue& queue = m_state.part(part).queue;
    Index f;
    while (queue.pop_face(f))
      if (!is_finished(f) && !waits_on(f, queue)) finish(f, passed);
  }

  bool is_finished(Index f) const { return m_state.face_state[f] & State::FINISHED; }

  void finish(Index f, std::vector<Index>& passed) const
  {
    if (m_state.face_state[f] & State::SCHEDULED) m_state.unfinished.remove(f);
    m_state.face_state[f] |= State::FINISHED;
    passed.push_back(f);
  }

  // No point of the face is farther than this: a corner's distance and the way from there.
  FT largest_distance(Index f) const
  {
    const Unfolded_mesh<FT>& mesh = m_state.mesh;
    FT bound = Number_policy<FT>::infinity();
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const FT &a = mesh[h].length, &b = mesh[mesh.previous(h)].length;
      bound = lesser(bound, FT(m_state.field.distance[mesh.source(h)] + (certainly_less(a, b) ? b : a)));
    }
    return bound;
  }

private:
  // Buckets ahead. A face with a much longer edge than most is looked at again there, so that no bucket is made for each
  // step along that edge.
  static constexpr std::size_t farthest = 1 << 12;

  // Puts the face into a later bucket, if it must wait.
  bool waits_on(Index f, Bucket_queue& queue) const
  {
    char& state = m_state.face_state[f];
    if (state & State::BOUNDED) return false; // the bound never grows
    const FT bound = largest_distance(f);
    const bool is_bounded = Number_policy<FT>::is_finite(bound);
    const std::size_t done = is_bounded ? queue.bucket_of(bound) + 1 : queue.current() + 2;
    if (done <= queue.current()) return false;
    const std::size_t next = (std::min)(done, queue.current() + farthest);
    if (is_bounded && next == done) state |= State::BOUNDED;
    queue.push_face(next, f);
    return true;
  }

  State& m_state;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
