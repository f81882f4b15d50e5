// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds faces that the front has passed, whose distances are final, and vertices that every window missed through rounding.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FACE_FINALIZER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FACE_FINALIZER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Window_merging.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Finalized faces, and halfedges whose sources rounding has hidden from all windows.
struct Passed_faces
{
  std::vector<Index> faces, hidden;

  void append(Passed_faces& other)
  {
    faces.insert(faces.end(), other.faces.begin(), other.faces.end());
    hidden.insert(hidden.end(), other.hidden.begin(), other.hidden.end());
    other.faces.clear();
    other.hidden.clear();
  }
};

template <class FT>
class Face_finalizer
{
  typedef Wavefront_state<FT> State;

public:
  // `tolerance`: bound of the error of distances beyond rounding.
  Face_finalizer(State& state, const Merging_tolerance<FT>& tolerance) : m_state(state), m_tolerance(tolerance) {}

  // Examines the faces of a part in the current bucket. Appends finalized faces to `passed`; other faces stay pending.
  void look(Index part, Passed_faces& passed) const
  {
    Bucket_queue& queue = m_state.part(part).queue;
    Index f;
    while (queue.pop_face(f))
    {
      if (is_finished(f) || waits_on(f, queue)) continue;
      if (finds_hidden(f, passed.hidden)) queue.push_face(queue.current() + 2, f);
      else finish(f, passed.faces);
    }
  }

  // Finds corners of a finalized face that are farther than a path along an edge. In needles all paths may be equal up to
  // rounding, and each of two windows may leave a vertex to the other.
  bool finds_hidden(Index f, std::vector<Index>& hidden) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return false;
    const Unfolded_mesh<FT>& mesh = m_state.mesh;
    const std::vector<FT>& distance = m_state.field.distance;
    const auto *const edge = &mesh[3 * f];
    const FT &d0 = distance[edge[0].origin], &d1 = distance[edge[1].origin], &d2 = distance[edge[2].origin];
    if (!(CGAL::abs(FT(d1 - d0)) > edge[0].length) && !(CGAL::abs(FT(d2 - d1)) > edge[1].length) &&
        !(CGAL::abs(FT(d0 - d2)) > edge[2].length))
      return false;
    return finds_hidden_certainly(f, hidden);
  }

  bool is_finished(Index f) const { return m_state.is_finished[f]; }

  void finish(Index f, std::vector<Index>& passed) const
  {
    CGAL_precondition(!is_finished(f));
    if (m_state.face_state[f] & State::SCHEDULED) m_state.unfinished.remove(f);
    m_state.is_finished[f] = true;
    passed.push_back(f);
  }

  // Upper bound of the distances in a face: a corner's distance plus the longer edge there.
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
  // Largest number of buckets ahead. A face with a much longer edge than most is examined again there, so that the number of
  // buckets stays bounded.
  static constexpr std::size_t farthest = 1 << 12;

  BOOST_NOINLINE bool finds_hidden_certainly(Index f, std::vector<Index>& hidden) const
  {
    const std::size_t before = hidden.size();
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const FT along_edge = m_state.along_edge(h, Source_ref()).distance;
      const FT allowed = along_edge + (m_tolerance.relative * along_edge + m_tolerance.absolute);
      if (along_edge <= m_state.maximum && m_state.is_shorter(allowed, m_state.field.distance[m_state.mesh.source(h)]))
        hidden.push_back(h);
    }
    return hidden.size() > before;
  }

  // Puts the face into a later bucket if it is still pending, at most the bucket after the one that closes its last gaps.
  bool waits_on(Index f, Bucket_queue& queue) const
  {
    char& state = m_state.face_state[f];
    if (state & State::BOUNDED) return false; // the bound does not grow
    const FT bound = largest_distance(f);
    const bool is_bounded = Number_policy<FT>::is_finite(bound);
    const std::size_t done = (is_bounded ? queue.bucket_of(bound) : queue.current()) + 2;
    if (done <= queue.current()) return false;
    const std::size_t next = (std::min)(done, queue.current() + farthest);
    if (is_bounded && next == done) state |= State::BOUNDED;
    queue.push_face(next, f);
    return true;
  }

  State& m_state;
  const Merging_tolerance<FT> m_tolerance;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
