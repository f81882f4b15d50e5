// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_SIDE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_SIDE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

namespace CGAL {

/// \ingroup PkgSurfaceMeshGeodesicOffsetEnums
/// the side of the source from which the shortest path to a point of the surface starts. Left and right refer to the
/// direction of travel along a polyline, seen from the outside of the surface.
enum class Source_side : unsigned char {
  NONE = 0,  ///< the source is a point or a set of edges, which have no sides
  LEFT = 1,  ///< left of a polyline
  RIGHT = 2, ///< right of a polyline
  CAP = 3    ///< beyond an end of an open polyline
};

/// \ingroup PkgSurfaceMeshGeodesicOffsetEnums
/// the side of polylines on which offset curves are requested. Sources without sides (points, sets of edges) are offset in
/// all directions whatever the value is.
enum class Offset_side : unsigned char {
  BOTH,   ///< both sides of polylines
  LEFT,   ///< only points whose nearest source point is reached from the left of its polyline
  RIGHT,  ///< only points whose nearest source point is reached from the right of its polyline
  INSIDE, ///< only points inside closed polylines: on the side with the smaller area; for a polyline that runs along the
          ///< border all the way, on the side of the surface. The areas are estimated, by some 250 samples per face near the
          ///< polyline: areas that differ by less than a few percent may be confused
  OUTSIDE ///< only points outside closed polylines
};

/// \ingroup PkgSurfaceMeshGeodesicOffsetEnums
/// the cap style at the ends of open polylines.
enum class Offset_end : unsigned char {
  ROUND, ///< points beyond an end belong to the offset, whichever side is requested
  BUTT   ///< points beyond an end do not belong to the offset; the curve is open there
};

} // namespace CGAL

#endif
