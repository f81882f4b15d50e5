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
  INSIDE, ///< only points inside closed polylines, see `Geodesic_inner_side`
  OUTSIDE ///< only points outside closed polylines
};

/// \ingroup PkgSurfaceMeshGeodesicOffsetEnums
/// the cap style at the ends of open polylines. The default is round where both sides are requested, and butt where one side is.
enum class Offset_end : unsigned char {
  ROUND, ///< points beyond an end belong to the offset, whichever side is requested
  BUTT   ///< points beyond an end do not belong to the offset; the curve is open there
};

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents which side of a closed polyline is inside.

If exactly one side contains no border of the surface, it is inside; otherwise the side with the smaller area is. Parts of the
border along which the polyline runs count for neither side, nor does border of a length up to 1e-5 of that of the polyline. A
polyline that is along the border as near as this has only one side, which is inside.
*/
struct Geodesic_inner_side
{
  Source_side side = Source_side::NONE; ///< left or right; none if the polyline does not divide its part of the surface in two
  double inner_area = 0;                ///< the area inside
  double outer_area = 0;                ///< the area outside, in the same part of the surface
  bool is_by_area = false;              ///< whether the areas decide, and not the border
  bool has_border = false;              ///< whether both sides have border, such as that of holes, or the only side has

  /// whether the areas decide, and the larger one exceeds the smaller one by at most a tenth; or whether there is border inside,
  /// which may be that of holes, or the outer one.
  bool is_doubtful() const { return has_border || (is_by_area && 10 * (outer_area - inner_area) <= outer_area); }
};

} // namespace CGAL

#endif
