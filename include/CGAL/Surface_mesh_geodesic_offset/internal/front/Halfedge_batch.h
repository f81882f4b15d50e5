// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Processes the windows of one halfedge: reduces them to their lower envelope, merges them within the tolerance, and propagates
// new windows across the face. Writes its own result only.
//
// If only distances at vertices are wanted, a monotone list, as the children of one batch mostly are, is propagated without the
// reduction. Its neighbours are cut when they meet the windows of another batch, one or two faces later, at the cost of a few
// more windows. Distances do not change by more windows.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_HALFEDGE_BATCH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_HALFEDGE_BATCH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Batch_propagation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Window_merging.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/memory/Inline_sequence.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Lower_envelope.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

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

} // namespace CGAL::Geodesic_offset::internal

#endif
