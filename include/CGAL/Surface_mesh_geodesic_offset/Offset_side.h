// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_SIDE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_OFFSET_SIDE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

namespace CGAL {

/// \ingroup PkgSurfaceMeshGeodesicOffsetEnums
/// the side of its source from which a point of the surface is reached. Left and right are those of the direction of
/// travel along a polyline, seen from the outside of the surface.
enum class Source_side : unsigned char
{
  NONE = 0,  ///< the source is a point or a set of edges: these have no sides
  LEFT = 1,  ///< left of a polyline
  RIGHT = 2, ///< right of a polyline
  CAP = 3    ///< beyond an end of an open polyline
};

/// \ingroup PkgSurfaceMeshGeodesicOffsetEnums
/// the part of an offset that is asked for. Sources without sides (points, sets of edges) are offset in all directions
/// whatever is chosen.
enum class Offset_side : unsigned char
{
  BOTH,   ///< both sides of polylines
  LEFT,   ///< only points whose nearest source point is reached from the left of its polyline
  RIGHT,  ///< only points whose nearest source point is reached from the right of its polyline
  INSIDE, ///< only points inside closed polylines: on the side with the smaller area, or, of a polyline that runs along the
          ///< border all the way, on the side where the surface is. The areas are estimated, by some 250 samples in each
          ///< face near the polyline: sides that differ by less than a few percent may be confused
  OUTSIDE ///< only points outside closed polylines
};

/// \ingroup PkgSurfaceMeshGeodesicOffsetEnums
/// what becomes of an offset at the ends of open polylines.
enum class Offset_end : unsigned char
{
  ROUND, ///< all points at the distance belong to it, those beyond an end with either side
  BUTT   ///< points beyond an end do not belong to it; the curve is open there
};

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses
\brief The part of the offset of polylines that is asked for: everything, unless it says otherwise.

A curve that leaves the part is cut there, so curves may be open with ends inside the surface.
*/
struct Offset_selection
{
  Offset_side side = Offset_side::BOTH;
  Offset_end end = Offset_end::ROUND;

  /// all of the offset.
  Offset_selection() = default;
  /// the part on one side.
  Offset_selection(Offset_side which_side, Offset_end which_end = Offset_end::ROUND) : side(which_side), end(which_end) {}

  /// whether nothing is left out.
  bool is_everything() const { return side == Offset_side::BOTH && end == Offset_end::ROUND; }
};

} // namespace CGAL

#endif
