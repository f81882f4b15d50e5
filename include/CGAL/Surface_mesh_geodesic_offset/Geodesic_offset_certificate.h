// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_OFFSET_CERTIFICATE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_OFFSET_CERTIFICATE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief the point that determines the tolerance of a `Geodesic_offset_certificate`, or the reason why the curves bound no region.
*/
enum class Offset_certificate_limit {
  NONE,           ///< the tolerance is 0: no point is uncertain
  CURVE_TOO_NEAR, ///< a point of a curve whose distance may be smaller than the requested one by the tolerance
  CURVE_TOO_FAR,  ///< a point of a curve whose distance may be larger by the tolerance
  REGION_TOO_FAR, ///< a point of the region, not on a curve, whose distance may be larger by the tolerance
  SOURCE_OUTSIDE, ///< a source that is outside of the region, although the region contains another source
  OPEN_END,       ///< no region: a curve ends inside the surface, and no other curve begins there
  NOT_JOINED,     ///< no region: consecutive points of a curve are in no common face, or consecutive pieces do not meet
  NO_REGION       ///< no region: the curves do not separate the surface, as a single loop around the hole of a torus
};

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents the result of `Surface_mesh_geodesic_enclosure::certify_offset()`: whether curves bound a region of the
surface, and which tolerance is proven for them.

\tparam FaceLocation the type of locations
*/
template <class FaceLocation>
struct Geodesic_offset_certificate
{
  /// whether the curves bound a region that contains the sources.
  bool bounds_region = false;
  /// the smallest tolerance that is proven: all points that are nearer than the requested distance minus the tolerance are in
  /// the region, and all points of the region are no farther than the distance plus the tolerance. Infinite if there is no
  /// region, or if the region contains points that no source reaches.
  double tolerance = std::numeric_limits<double>::infinity();
  /// what the tolerance is needed for, or why there is no region.
  Offset_certificate_limit limit = Offset_certificate_limit::NONE;
  /// the place of the limit, if there is one.
  std::optional<FaceLocation> location;
  /// the bounds of the distance there, or of the distances of the points near there that were bounded together.
  std::pair<double, double> distance_bounds = {0., 0.};
  /// the index of the curve of the limit, if there is one.
  std::optional<std::size_t> curve;
  /// the number of curves that have the region on their right somewhere; and the index of the first one. They do
  /// not change the tolerance: the region does not depend on the directions of the curves.
  std::size_t number_of_reversed_curves = 0;
  /// see `number_of_reversed_curves`
  std::optional<std::size_t> first_reversed_curve;
};

} // namespace CGAL

#endif
