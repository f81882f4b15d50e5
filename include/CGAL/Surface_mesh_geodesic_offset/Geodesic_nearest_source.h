// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_NEAREST_SOURCE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_NEAREST_SOURCE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief describes the nearest source of a point of the surface, and the nearest point of that source: the end of the path that
`shortest_path_to_sources()` writes. If several sources are equally near up to rounding, one of them; all queries at the point choose
the same one, see \ref SurfaceMeshGeodesicOffsetUseQueries.

\tparam FT_ a number type
\tparam FaceLocation the type of locations
*/
template <class FT_, class FaceLocation>
struct Geodesic_nearest_source
{
  std::size_t source; ///< id of the source, as returned when it was added
  std::size_t part;   ///< index of the point, or of the segment, within the source; for a set of edges: index of the edge
                      ///< in the range, or index of the vertex
  bool is_segment;  ///< whether the path meets a segment (or an edge), at a right angle; the nearest point may be an end of it.
                    ///< Otherwise the nearest point is a point, or an end or a corner that the path reaches at another angle
  Source_side side; ///< side of the source from which the shortest path starts: `NONE` for points and sets of edges, `CAP` for
                    ///< ends of open polylines, `LEFT` or `RIGHT` for their segments and corners. Without meaning at distance 0
  FT_ distance;     ///< length of the shortest path
  FaceLocation location; ///< the nearest point of the source, on the part; in the null face for an isolated vertex
};

} // namespace CGAL

#endif
