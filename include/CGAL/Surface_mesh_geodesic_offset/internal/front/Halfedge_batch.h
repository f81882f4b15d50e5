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

  // Propagates the new windows of a halfedge. Of the list, only flags and the split change. Returns the lower envelope that
  // replaces the windows, valid until the next call; null if the windows stay.
  const Inline_sequence<Window>* operator()(Index h, Window_list<FT>& list)
  {
    const bool may_stay = !m_needs_envelopes && list.processed == 0 && !list.waiting.data;
    const FT& length = m_mesh[h].length;
    const std::size_t n = list.size + list.waiting.size;
    if (m_windows.size() < n) m_windows.resize(n);
    Window* last = m_windows.data();
    for (const auto* w = list.begin(); w != list.end(); ++w) ::new (static_cast<void*>(last++)) Window(restored(*w, length));
    for (const auto* w = list.waiting.begin(); w != list.waiting.end(); ++w)
      ::new (static_cast<void*>(last++)) Window(restored(*w, length));
    Window *const first = m_windows.data(), *const middle = first + list.size;
    if constexpr (is_inexact)
    {
      if (may_stay && Lower_envelope<Traits>::is_monotone_list(first, middle))
      {
        if constexpr (Traits::may_merge)
          if (m_merging.pays_for(h, list.size)) return &propagate_merged(h, list, first, middle);
        m_propagate(h, first, list.size, list.split_distance, list.split_entry);
        return nullptr;
      }
    }
    CGAL_precondition(list.processed <= list.size);
    // The first windows of the list are the processed ones; a flag marks them for the envelope, which has another order.
    for (Window* w = first; w != first + list.processed; ++w) w->set_propagated();
    const Inline_sequence<Window>& envelope = m_envelope(first, middle, length, middle, last);
    // Propagated windows cannot be merged, and they are most of the lists of second batches.
    if constexpr (Traits::may_merge)
      if (list.processed == 0 && m_merging.pays_for(h, envelope.size()))
        return &propagate_merged(h, list, envelope.begin(), envelope.end());
    m_propagate(h, envelope.data(), envelope.size(), list.split_distance, list.split_entry);
    return may_stay ? nullptr : &envelope;
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
