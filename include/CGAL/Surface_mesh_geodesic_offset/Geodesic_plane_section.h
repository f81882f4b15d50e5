// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_PLANE_SECTION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_PLANE_SECTION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents a polyline on a surface.

\tparam FaceLocation the type of locations
*/
template <class FaceLocation>
struct Geodesic_polyline
{
  std::vector<FaceLocation> locations; ///< the points; consecutive points have a face in common
  bool is_closed = false;              ///< whether the last point is joined to the first one, which is not repeated
};

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents the section of a mesh by a plane.

\tparam FaceLocation the type of locations
\tparam VertexDescriptor the type of vertices
*/
template <class FaceLocation, class VertexDescriptor>
struct Geodesic_plane_section
{
  /// the curves of the section. The positive side of the plane is on their left where the surface passes through the plane.
  /// A polyline ends at the boundary of the surface, or where several of them meet.
  std::vector<Geodesic_polyline<FaceLocation>> polylines;
  std::vector<VertexDescriptor> touched_vertices; ///< vertices where the plane only touches the surface
  std::size_t number_of_faces_in_plane = 0;       ///< faces within the plane; the section has the border of their union instead
};

} // namespace CGAL

#endif
