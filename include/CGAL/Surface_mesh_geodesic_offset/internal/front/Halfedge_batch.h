// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Processes the windows of one halfedge: reduces them to their lower envelope, merges them within the tolerance, and propagates
// new windows across the face. Writes its own result only.
//
// If only distances at vertices are wanted, a monotone list, as the children of one batch mostly are, is propagated without the
// reduction. Its neighbours are cut when they meet the windows of another batch, one or two faces later, at the cost of a few
// more windows. A reduced list is written back only at its second batch: later windows cut the same parts again. Distances do
// not change by more windows.

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
      m_merging(state.field, source_of, tolerance), m_propagate(state, traits),
      m_needs_envelopes(!is_inexact || state.needs_envelopes)
  {
  }

  // Windows that replace the processed windows [first, last) of a list and all pending ones; null if the list stays.
  struct Replacement
  {
    const Inline_sequence<Window>* windows = nullptr;
    std::size_t first = 0, last = 0;
  };

  // Propagates the new windows of a halfedge. Of the list, only flags and the split change. The result is valid until the next
  // call. A batch costs the new windows and the processed ones that they meet.
  Replacement operator()(Index h, Window_list<FT>& list)
  {
    CGAL_precondition(list.processed <= list.size);
    const bool may_stay = !m_needs_envelopes && list.processed == 0 && !list.waiting.data;
    const FT& length = m_mesh[h].length;
    const std::size_t n = list.size + list.waiting.size;
    if (m_windows.size() < n) m_windows.resize(n);
    Window *const first = m_windows.data(), *const fresh = first + list.processed;
    Window* const middle = restore(list.data + list.processed, list.end(), length, fresh);
    if constexpr (is_inexact)
    {
      if (may_stay && Lower_envelope<Traits>::is_monotone_list(fresh, middle))
      {
        if constexpr (Traits::may_merge)
          if (m_merging.pays_for(h, list.size)) return {&propagate_merged(h, list, first, middle)};
        m_propagate(h, first, list.size, list.split_distance, list.split_entry);
        return {};
      }
    }
    Window* const last = restore(list.waiting.begin(), list.waiting.end(), length, middle);
    Replacement result{nullptr, 0, list.processed};
    if constexpr (is_inexact)
      if (list.is_reduced) narrow(list, fresh, last, length, result);
    Window *const old = first + result.first, *const old_end = first + result.last;
    restore(list.data + result.first, list.data + result.last, length, old);
    // A flag marks the processed windows for the envelope, which has another order.
    for (Window* w = old; w != old_end; ++w) w->set_propagated();
    const Inline_sequence<Window>& envelope = m_envelope(old, old_end, length, fresh, last);
    // Propagated windows cannot be merged, and they are most of the lists of second batches.
    if constexpr (Traits::may_merge)
      if (list.processed == 0 && m_merging.pays_for(h, envelope.size()))
        return {&propagate_merged(h, list, envelope.begin(), envelope.end())};
    m_propagate(h, envelope.data(), envelope.size(), list.split_distance, list.split_entry);
    if (may_stay) return {};
    list.is_reduced = true;
    result.windows = &envelope;
    return result;
  }

  // Result of the propagation.
  const Batch_propagation<Traits>& propagated() const { return m_propagate; }
  const Merging& merging() const { return m_merging; }

private:
  static constexpr bool is_inexact = Number_policy<FT>::is_inexact;

  const Inline_sequence<Window>& propagate_merged(Index h, Window_list<FT>& list, const Window* first, const Window* last)
  {
    const Inline_sequence<Window>& merged = m_merging(first, last);
    m_propagate(h, merged.data(), merged.size(), list.split_distance, list.split_entry);
    return merged;
  }

  // Restores the windows [first, last) on a halfedge of the given length to `out`. Returns the end.
  static Window* restore(const Stored_window<FT>* first, const Stored_window<FT>* last, const FT& length, Window* out)
  {
    for (; first != last; ++first) ::new (static_cast<void*>(out++)) Window(restored(*first, length));
    return out;
  }

  // Finds the processed windows of a reduced list that may meet the new windows [fresh, last).
  void narrow(const Window_list<FT>& list, const Window* fresh, const Window* last, const FT& length, Replacement& range) const
  {
    CGAL_precondition(fresh != last);
    FT low = fresh->b0, high = fresh->b1, farthest(0);
    for (const Window* w = fresh; w != last; ++w)
    {
      low = (std::min)(low, w->b0);
      high = (std::max)(high, w->b1);
      farthest = (std::max)(farthest, w->d1);
    }
    const FT gap = m_envelope.reach(length, farthest);
    const auto *const begin = list.data, *const end = begin + list.processed;
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
  const bool m_needs_envelopes;
  std::vector<Window> m_windows; // of the list
};

} // namespace CGAL::Geodesic_offset::internal

#endif
