// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unfolds both ends of a window across a face at once, in the usual case.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_SIMD_EDGE_EXIT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_SIMD_EDGE_EXIT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Has_pairs.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_pairs.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_propagation.h>

#include <boost/config.hpp>

namespace CGAL::Geodesic_offset::internal {

// One of the two other edges of a face, for windows whose rays all leave through it.
template <class Traits, bool is_left, bool has_pairs = Has_pair_children<Traits>::value>
class Simd_edge_exit
{
  typedef typename Traits::FT FT;
  typedef Geodesic_number_pair<FT> Pair;

public:
  Simd_edge_exit(const Window_propagation<Traits>& face, const Traits& traits)
    : m_change_frame(traits.change_frame_2_object()), m_c(is_left ? face.cl : face.cr), m_s(is_left ? face.sl : face.sr),
      m_turn(is_left ? Pair(face.sl, FT(-face.sl)) : Pair(FT(-face.sr), face.sr)),
      m_length(is_left ? face.left_length : face.right_length), m_apex(face.apex_x, face.apex_y)
  {
  }

  // Constructs the child in place. Returns false outside the usual case; then use left_child() or right_child() of the face.
  template <bool is_parallel>
  BOOST_FORCEINLINE bool child(Window_pairs<FT>& w) const
  {
    Pair t = w.t;
    if constexpr (is_left) w.image = m_change_frame(w.image, m_c, m_turn);
    else
    {
      if constexpr (is_parallel) { t = t + Pair(w.image.first() * m_apex.second() - w.image.second() * m_apex.first()); }
      const auto changed = m_change_frame(w.image, w.sigma, is_parallel, m_apex, m_c, m_turn);
      w.image = changed.image;
      w.sigma = changed.sigma;
    }
    const Pair x = w.image.both_first(), y = w.image.both_second(), sigma(w.sigma), zero(FT(0)), one(FT(1));
    if constexpr (is_parallel)
    {
      w.b = t / y;
      w.d = sigma - x * w.b;
    }
    else
    {
      const Pair s = is_left ? m_s : zero - m_s, across = m_c - s * t, r = square_root(one + t * t);
      if (BOOST_UNLIKELY((m_least * r < across).bits() != 3)) return false;
      const Pair inverse = one / across;
      t = (m_c * t + s) * inverse;
      w.b = x - y * t;
      w.d = sigma - y * (r * inverse);
    }
    w.t = t;
    if (BOOST_UNLIKELY(((zero <= w.b) & (w.b <= m_length)).bits() != 3 || !(w.b.first() < w.b.second()))) return false;
    return w.image.second() < FT(0);
  }

private:
  const typename Traits::Change_frame_2 m_change_frame;
  const Pair m_c, m_s, m_turn, m_length; // of the edge
  const Pair m_apex, m_least{Number_policy<FT>::rounding(roundings_across_edge)};
};

template <class Traits, bool is_left>
class Simd_edge_exit<Traits, is_left, false>
{
public:
  Simd_edge_exit(const Window_propagation<Traits>&, const Traits&) {}
};

} // namespace CGAL::Geodesic_offset::internal

#endif
