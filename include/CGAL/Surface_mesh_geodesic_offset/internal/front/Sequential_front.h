// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the halfedges and vertices of the front's bucket are worked on: here one after the other, each on what the one before
// has left. Parallel_front.h does it in rounds.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_SEQUENTIAL_FRONT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_SEQUENTIAL_FRONT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Face_finalizer.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Halfedge_batch.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Ray_spreading.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Takes the list of a halfedge: reduces it to its lower envelope, if it must, and propagates what is new. What comes of it
// is told to `front`: the state itself, or something that keeps it for later.
template <class Traits, class Arena, class Front>
BOOST_FORCEINLINE void process_halfedge(Index h, Wavefront_state<typename Traits::FT>& state,
                                     typename Wavefront_state<typename Traits::FT>::Part& part,
                                     Halfedge_batch<Traits>& batch, Arena& arena, Front& front)
{
  typedef Window_list<typename Traits::FT> List;
  auto& lists = state.field.lists;
  List* const known = lists.find(h);
  if (!known) return;
  List& list = *known;
  if (list.bucket != state.current() || !(list.has_new() || list.has_gap)) return;
  list.bucket = List::not_queued;
  list.has_gap = false;
  if (const auto* const envelope = batch(h, list)) lists.assign(h, list, *envelope, arena);
  list.processed = list.size;
  CGAL_assertion(!list.has_new());
  if constexpr (Number_policy<typename Traits::FT>::is_inexact) state.await_gap(h, list, batch.nearest_gap());
  state.schedule(state.mesh.face(h));
  const auto& propagated = batch.propagated();
  part.counts.windows_propagated += propagated.number_of_windows();
  for (const auto& a : propagated.updates()) front.update_apex(propagated.apex(), a);
  front.append(propagated.left(), arena);
  front.append(propagated.right(), arena);
}

template <class Traits>
class Sequential_front
{
  typedef typename Traits::FT FT;

public:
  Sequential_front(Wavefront_state<FT>& state, const std::vector<Index>& source_of, const Traits& traits,
                  const Merging_tolerance<FT>& tolerance)
    : m_state(state), m_batch(state, source_of, traits, tolerance)
  {
  }

  // One part is all of the front.
  struct Partition
  {
    Partition(const Unfolded_mesh<FT>&, bool) {}
    Front_parts parts() const { return Front_parts(); }
  };

  // Moves on to the next bucket in which anything waits; false when there is nothing left that can move the front.
  bool advance()
  {
    Bucket_queue& queue = m_state.part(0).queue;
    const bool is_left = queue.advance();
    m_state.move_to(queue.current());
    return is_left;
  }

  // Says that others have changed the state.
  void look_at_all_parts() {}

  // Looks at the faces of the bucket; those that the front has passed are added to `passed`.
  void pass_faces(const Face_finalizer<FT>& passing, Passed_faces& passed) { passing.look(0, passed); }

  // Gives up the lists of faces that the front has passed.
  void release(const std::vector<Index>& faces)
  {
    m_state.field.lists.release_faces(faces, m_state.field.lists.arena(0));
  }

  // Works on all halfedges and vertices of the bucket.
  void process_bucket(const Ray_spreading<Traits>& spreading)
  {
    Bucket_queue& queue = m_state.part(0).queue;
    for (Index i;;)
      if (m_state.pop_halfedge(queue, i))
        process_halfedge(i, m_state, m_state.part(0), m_batch, m_state.field.lists.arena(0), m_state);
      else if (queue.pop_vertex(i))
        spreading.spread_from_pseudo_source(i, m_state);
      else
        return;
  }

  // Who works on it.
  Single_worker team() const { return Single_worker(); }

  const Window_merging<FT>& merging() const { return m_batch.merging(); }
  Merging_counts merging_counts() const { return merging().counts(); }

private:
  Wavefront_state<FT>& m_state;
  Halfedge_batch<Traits> m_batch;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
