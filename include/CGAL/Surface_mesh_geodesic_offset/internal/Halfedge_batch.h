// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is done with the windows of one halfedge when it is taken: they are reduced to their lower envelope, merged
// within the tolerance, and what is new of it is propagated across the face. Nothing but the result is written.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_HALFEDGE_BATCH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_HALFEDGE_BATCH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Batch_propagation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Lower_envelope.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Window_merging.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Wavefront_state.h>

#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class Traits>
class Halfedge_batch
{
public:
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  Halfedge_batch(const Wavefront_state<FT>& state, const std::vector<Index>& source_of, const Traits& traits,
                 const Merging_tolerance<FT>& tolerance)
    : m_mesh(state.mesh), m_envelope(source_of, traits), m_merging(state.field, source_of, tolerance),
      m_propagate(state, traits)
  {
  }

  // The lower envelope of the windows of a halfedge, valid until the next call. Of the list, only flags and the split are
  // written.
  const std::vector<Window>& operator()(Index h, Window_list<FT>& list)
  {
    // what was taken before is told apart by its place in the list, and by a flag where it meets what is new
    for (Window* w = list.data; w != list.data + list.taken; ++w) w->set_propagated();
    const std::vector<Window>& envelope =
      m_merging(m_envelope(list.begin(), list.end(), m_mesh[h].length, list.waiting.begin(), list.waiting.end()));
    m_propagate(h, envelope, list.split_distance, list.split_entry);
    return envelope;
  }

  // What came of the propagation.
  const Batch_propagation<Traits>& propagated() const { return m_propagate; }
  const Window_merging<FT>& merging() const { return m_merging; }

private:
  const Unfolded_mesh<FT>& m_mesh;
  Lower_envelope<Traits> m_envelope;
  Window_merging<FT> m_merging;
  Batch_propagation<Traits> m_propagate;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
