// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of a window in pairs for equal operations: the image, and the two ends of the interval.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_PAIRS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_PAIRS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_number_pair.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
struct Window_pairs
{
  typedef Geodesic_number_pair<FT> Pair;

  explicit Window_pairs(const Window<FT>& w)
    : image(Pair::of(w.x, w.y)), b(Pair::of(w.b0, w.b1)), d(Pair::of(w.d0, w.d1)), t(Pair::of(w.t0, w.t1)), sigma(w.sigma)
  {
  }

  void put(Window<FT>& w) const
  {
    image.put(w.x, w.y);
    w.sigma = sigma;
    b.put(w.b0, w.b1);
    d.put(w.d0, w.d1);
    t.put(w.t0, w.t1);
  }

  Pair image, b, d, t;
  FT sigma;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
