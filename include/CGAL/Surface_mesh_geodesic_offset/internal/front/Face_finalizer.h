// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finalizes faces that the front has passed: their distances are final. Before, it looks for hidden vertices: vertices that every
// window missed through rounding.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FACE_FINALIZER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_FACE_FINALIZER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Finalized faces, and hidden vertices. A hidden vertex is given by the halfedge that starts at it, in the face in which it was
// found.
struct Finalized_faces
{
  std::vector<Index> faces, hidden;

  void append(Finalized_faces& other)
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
  explicit Face_finalizer(State& state) : m_state(state) {}

  // Examines the faces in the current bucket of a part of the front. Appends finalized faces and hidden vertices to `finalized`;
  // other faces stay pending.
  void examine_bucket(Index part, Finalized_faces& finalized) const
  {
    Bucket_queue& queue = m_state.part(part).queue;
    Index f;
    while (queue.pop_face(f))
    {
      if (is_finalized(f) || m_state.postpone(f)) continue;
      if (finds_hidden(f, finalized.hidden)) queue.push_face(queue.current() + 2, f);
      else finalize(f, finalized.faces);
    }
  }

  // Finds hidden vertices: corners of a face whose distance is longer than a path along an edge of the face. In needles, many
  // paths are equal up to rounding. Then each of two windows may be cut beside a vertex, as if the other window reached it.
  bool finds_hidden(Index f, std::vector<Index>& hidden) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return false;
    const Unfolded_mesh<FT>& mesh = m_state.mesh;
    const std::vector<FT>& distance = m_state.field.distance;
    const auto* const edge = &mesh[3 * f];
    const FT &d0 = distance[edge[0].origin], &d1 = distance[edge[1].origin], &d2 = distance[edge[2].origin];
    if (!(CGAL::abs(FT(d1 - d0)) > edge[0].length) && !(CGAL::abs(FT(d2 - d1)) > edge[1].length) &&
        !(CGAL::abs(FT(d0 - d2)) > edge[2].length))
      return false;
    return find_hidden(f, hidden);
  }

  // True if a face has a hidden vertex whose distance may be less than `settled`.
  bool hides_vertex(Index f, const FT& settled) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return false;
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (is_hidden(h, settled)) return true;
    return false;
  }

  bool is_finalized(Index f) const { return m_state.is_finalized[f]; }

  void finalize(Index f, std::vector<Index>& finalized) const
  {
    CGAL_precondition(!is_finalized(f));
    if (m_state.face_state[f] & State::SCHEDULED) m_state.pending_faces.remove(f);
    else m_state.list_marked(f, m_state.faces);
    m_state.is_finalized[f] = true;
    finalized.push_back(f);
  }

private:
  // True if the source of h has a longer distance than a path along an edge of the face of h, of at most `maximum`.
  bool is_hidden(Index h, const FT& maximum) const
  {
    const Vertex_update<FT> along_edge = m_state.along_edge(h, Source_ref());
    const FT length = along_edge.distance + FT(m_state.field.error_of_origin(along_edge.pseudo_source)); // of a path
    return along_edge.distance <= maximum && m_state.is_shorter(length, m_state.field.distance[m_state.mesh.source(h)]);
  }

  BOOST_NOINLINE bool find_hidden(Index f, std::vector<Index>& hidden) const
  {
    const std::size_t before = hidden.size();
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (is_hidden(h, m_state.maximum)) hidden.push_back(h);
    return hidden.size() > before;
  }

  State& m_state;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
