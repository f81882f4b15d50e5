// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The front on one thread: processes the halfedges and vertices of a bucket one by one. Parallel_front is its counterpart for
// several threads.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_SEQUENTIAL_FRONT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_SEQUENTIAL_FRONT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Batch_propagation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Face_finalizer.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Ray_spreading.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Window_merging.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/memory/Inline_sequence.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Lower_envelope.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Processes the windows of one halfedge: reduces them to their lower envelope, merges them within the tolerance, and propagates
// new windows across the face. Writes its own result only.
//
// If only distances at vertices are wanted, a monotone list, as the children of one batch mostly are, is propagated without the
// reduction. Its neighbours are cut when they meet the windows of another batch, one or two faces later, at the cost of a few
// more windows. Distances do not change by more windows.
template <class Traits>
class Halfedge_batch
{
public:
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef std::conditional_t<Traits::may_merge, Window_merging<FT>, No_merging> Merging;

  Halfedge_batch(const Wavefront_state<FT>& state, const std::vector<Index>& source_of, const Traits& traits,
                 const Merging_tolerance<FT>& tolerance)
    : m_mesh(state.mesh), m_state(state), m_envelope(source_of, traits, state.mesh.longest_edge()),
      m_merging(state.field, source_of, tolerance), m_propagate(state, traits)
  {
  }

  // Windows [begin, end) that replace the propagated windows [first, last) of a list and all pending ones.
  struct Replacement
  {
    const Window *begin, *end;
    std::size_t first, last;
  };

  // Propagates the pending windows of a halfedge. Of the list, only flags and the split change. The result is valid until the next
  // call. With floating-point numbers, the batch of a reduced list costs the pending windows and the propagated ones that they meet.
  Replacement operator()(Index h, Window_list<FT>& list)
  {
    const Window *begin = list.pending.begin(), *end = list.pending.end();
    const std::size_t propagated = list.propagated.size;
    Replacement result{begin, end, 0, propagated};
    if (needs_envelope(list))
    {
      const FT& length = m_mesh[h].length;
      if constexpr (is_inexact)
        if (list.is_reduced) narrow(list, length, result);
      restore(list, length, result);
      const Window* const old = m_windows.data();
      const Inline_sequence<Window>& envelope = m_envelope(old, old + (result.last - result.first), length, begin, end);
      result.begin = envelope.begin();
      result.end = envelope.end();
      list.is_reduced = true;
    }
    // Propagated windows cannot be merged, and they are most of the lists of second batches.
    if constexpr (Traits::may_merge)
      if (propagated == 0 && m_merging.pays_for(h, std::size_t(result.end - result.begin)))
      {
        const Inline_sequence<Window>& merged = m_merging(result.begin, result.end);
        result.begin = merged.begin();
        result.end = merged.end();
        list.is_reduced = false;
      }
    m_propagate(h, result.begin, std::size_t(result.end - result.begin), list.split_distance, list.split_entry);
    return result;
  }

  // Result of the propagation.
  const Batch_propagation<Traits>& propagated() const { return m_propagate; }
  const Merging& merging() const { return m_merging; }

private:
  static constexpr bool is_inexact = Number_policy<FT>::is_inexact;

  bool needs_envelope(const Window_list<FT>& list) const
  {
    if constexpr (!is_inexact) return true;
    else
      return m_state.needs_envelopes || list.propagated.size > 0 ||
             !Lower_envelope<Traits>::is_monotone_list(list.pending.begin(), list.pending.end());
  }

  // Restores the propagated windows of a range, and marks them for the envelope.
  void restore(const Window_list<FT>& list, const FT& length, const Replacement& range)
  {
    if (m_windows.size() < range.last - range.first) m_windows.resize(range.last - range.first);
    Window* out = m_windows.data();
    for (std::size_t i = range.first; i < range.last; ++i, ++out)
    {
      *out = restored(list.propagated.data[i], length);
      out->set_propagated();
    }
  }

  // Finds the propagated windows of a reduced list that may meet the pending ones. Where rays graze the edge, one that meets them by
  // rounding may be left out: then both stay, and no distance changes.
  void narrow(const Window_list<FT>& list, const FT& length, Replacement& range) const
  {
    CGAL_precondition(range.begin != range.end);
    FT low = range.begin->b0, high = range.begin->b1, farthest(0);
    for (const Window* w = range.begin; w != range.end; ++w)
    {
      low = (std::min)(low, w->b0);
      high = (std::max)(high, w->b1);
      farthest = (std::max)({farthest, w->d0, w->d1});
    }
    const FT gap = m_envelope.reach(length, farthest);
    const auto *const begin = list.propagated.begin(), *const end = list.propagated.end();
    const auto* const old =
      std::partition_point(begin, end, [&](const Stored_window<FT>& w) { return w.position(w.t1) < low - gap; });
    range.first = std::size_t(old - begin);
    range.last =
      std::size_t(std::partition_point(old, end, [&](const Stored_window<FT>& w) { return w.position(w.t0) <= high + gap; }) -
                  begin);
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Wavefront_state<FT>& m_state;
  Lower_envelope<Traits> m_envelope;
  Merging m_merging;
  Batch_propagation<Traits> m_propagate;
  std::vector<Window> m_windows; // propagated ones, restored
};

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
