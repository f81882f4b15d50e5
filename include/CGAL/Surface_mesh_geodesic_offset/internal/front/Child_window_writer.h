// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the children of windows that leave a face through one of the two other edges, after pruning.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_CHILD_WINDOW_WRITER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_CHILD_WINDOW_WRITER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Simd_edge_exit.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_propagation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_pruning.h>

#include <boost/config.hpp>

namespace CGAL::Geodesic_offset::internal {

template <class Traits, bool is_left_>
struct Child_window_writer
{
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  static constexpr bool is_left = is_left_;

  // Adds the rays of a window on one side of `bound`. at_apex: the rays up to the apex, where the distance is d_apex.
  template <bool is_parallel>
  BOOST_FORCEINLINE void take(const Window_propagation<Traits>& face, const Window& w, const FT& bound, bool at_apex,
                              const FT& d_apex)
  {
    Window& child = output.next();
    if constexpr (is_left)
    {
      if (!face.template left_child<is_parallel>(w, bound, at_apex, d_apex, child)) return;
      if (pruning.is_filtered(child.b0, child.d0)) return;
    }
    else
    {
      if (!face.template right_child<is_parallel>(w, bound, at_apex, d_apex, child)) return;
      if (pruning.is_filtered(child.b1, child.d1)) return;
    }
    if (pruning.trim(child)) Wavefront_state<FT>::keep(output, maximum);
  }

  // Adds a window with all its rays.
  template <bool is_parallel>
  BOOST_FORCEINLINE void take_whole(const Window_propagation<Traits>& face, const Simd_edge_exit<Traits, is_left>& edge,
                                    const Window& w)
  {
    if constexpr (Has_pair_children<Traits>::value)
    {
      Window_pairs<FT> p(w);
      if (BOOST_LIKELY(edge.template child<is_parallel>(p))) take_child<is_parallel>(w, p);
      else take_by_parts<is_parallel>(face, w);
    }
    else take_by_parts<is_parallel>(face, w);
  }

  Window_pruning<FT> pruning;
  typename Wavefront_state<FT>::Output::Cursor output;
  const FT maximum;

private:
  template <bool is_parallel>
  BOOST_FORCEINLINE void take_child(const Window& w, const Window_pairs<FT>& p)
  {
    const FT b0 = p.b.first(), b1 = p.b.second(), d0 = p.d.first(), d1 = p.d.second();
    if (pruning.is_filtered(is_left ? b0 : b1, is_left ? d0 : d1)) return;
    Window& child = output.next();
    if (BOOST_UNLIKELY(!pruning.leaves_all(p.b, p.d) || !pruning.is_wide(b0, b1)))
    {
      p.put(child);
      take_origin(w, child);
      if (pruning.trim(child)) Wavefront_state<FT>::keep(output, maximum);
      return;
    }
    const FT nearest = minimum(is_parallel, b0, b1, FT(p.image.first()), FT(p.sigma - p.image.second()), d0, d1);
    if (certainly_less(maximum, nearest)) return;
    p.put(child);
    take_origin(w, child);
    output.keep(nearest);
  }

  // Copies the origin by one load and one store.
  static void take_origin(const Window& w, Window& child)
  {
    const Source_ref source_ref = w.source_ref;
    const Index bits = w.bits;
    child.source_ref = source_ref;
    child.bits = bits;
  }

  // Adds a window with all rays, one end after the other.
  template <bool is_parallel>
  BOOST_NOINLINE void take_by_parts(const Window_propagation<Traits>& face, const Window& w)
  {
    if constexpr (is_left) take<is_parallel>(face, w, w.b1, false, w.d1);
    else take<is_parallel>(face, w, w.b0, false, w.d0);
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
