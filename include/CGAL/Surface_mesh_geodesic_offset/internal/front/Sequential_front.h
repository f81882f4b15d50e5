// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The front on one thread: processes the halfedges and vertices of a bucket one by one. Parallel_front is its counterpart for
// several threads.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_SEQUENTIAL_FRONT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_SEQUENTIAL_FRONT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Halfedge_batch.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Ray_spreading.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Processes the list of a halfedge: reduces it to its lower envelope if required, and propagates new windows. `front` receives
// the results: the state, or messages for later.
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
  if (list.bucket != state.current() || !list.has_new()) return;
  list.bucket = List::not_queued;
  const auto replacement = batch(h, list);
  lists.replace(h, list, replacement.first, replacement.last, replacement.begin, replacement.end, arena);
  CGAL_assertion(!list.has_new());
  const auto& propagated = batch.propagated();
  part.counts.windows_propagated += propagated.number_of_windows();
  for (const auto& a : propagated.updates()) front.update_apex(propagated.apex(), a);
  state.schedule(state.mesh.face(h), true);
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

  // One part: the whole front.
  struct Partition
  {
    Partition(const Unfolded_mesh<FT>&, bool) {}
    Front_parts parts() const { return Front_parts(); }
  };

  // Advances to the next nonempty bucket. Returns false if no event is left that can move the front.
  bool advance()
  {
    Bucket_queue& queue = m_state.part(0).queue;
    const bool is_left = queue.advance();
    m_state.move_to(queue.current());
    return is_left;
  }

  // Notifies the front of changes of the state from outside.
  void refresh_all_parts() {}

  // Examines the faces of the bucket. Appends finalized faces to `finalized`.
  void finalize_faces(const Face_finalizer<FT>& finalizer, Finalized_faces& finalized)
  {
    finalizer.examine_bucket(0, finalized);
  }

  // Releases the lists of finalized faces.
  void release(const std::vector<Index>& faces) { m_state.field.lists.release_faces(faces, m_state.field.lists.arena(0)); }

  // Processes all halfedges and vertices of the bucket.
  void process_bucket(const Ray_spreading<Traits>& spreading)
  {
    Bucket_queue& queue = m_state.part(0).queue;
    for (Index i;;)
      if (m_state.pop_halfedge(queue, i))
        process_halfedge(i, m_state, m_state.part(0), m_batch, m_state.field.lists.arena(0), m_state);
      else if (queue.pop_vertex(i)) spreading.spread_from_pseudo_source(i, m_state);
      else return;
  }

  // The threads.
  Single_worker team() const { return Single_worker(); }

  const auto& merging() const { return m_batch.merging(); }
  Merging_counts merging_counts() const { return merging().counts(); }

private:
  Wavefront_state<FT>& m_state;
  Halfedge_batch<Traits> m_batch;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
