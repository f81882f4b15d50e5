// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Data shared by offset curves: the surface, and the sources.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_CURVE_CONTEXT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_CURVE_CONTEXT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Geodesic_surface.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

template <class>
class Geodesic_offset_curve;

namespace Geodesic_offset {
namespace internal {

template <class Surface>
struct Curve_context
{
  std::shared_ptr<const Surface> surface;
  std::vector<Source_primitive> primitives;

  // Curves: an offset curve, or a Voronoi diagram.
  template <class Curves>
  static const Surface& surface_of(const Curves& curves)
  {
    return *curves.m_context->surface;
  }

  template <class FT, class Pieces>
  static Geodesic_offset_curve<Surface> make_curve(const std::shared_ptr<const Curve_context>& context, const FT& distance,
                                                   const FT& tolerance, bool is_closed, Pieces&& pieces)
  {
    return Geodesic_offset_curve<Surface>(context, distance, tolerance, is_closed, std::forward<Pieces>(pieces));
  }

  static const auto& pieces_of(const Geodesic_offset_curve<Surface>& curve) { return curve.m_pieces; }

  // \throws std::logic_error if the curve was moved from
  static const Surface& surface_of(const Geodesic_offset_curve<Surface>& curve) { return *curve.context().surface; }
};

// The surface of an offset curve or of a Voronoi diagram.
template <template <class> class Curves, class Surface>
const Surface& surface_of(const Curves<Surface>& curves)
{
  return Curve_context<Surface>::surface_of(curves);
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
