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
  /// the start values of the points, linear between them; empty if they are all the same
  std::vector<typename FaceLocation::second_type::value_type> start_values = {};
};

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents the section of a mesh by a plane: curves with sides, and edges and vertices that the plane only touches.

Planes with opposite normals have the same section, with polylines in opposite directions.

\tparam FaceLocation the type of locations
\tparam VertexDescriptor the type of vertices
\tparam EdgeDescriptor the type of edges
*/
template <class FaceLocation, class VertexDescriptor, class EdgeDescriptor>
struct Geodesic_plane_section
{
  /// the curves of the section, with the positive side of the plane on their left and the negative side on their right. Along the
  /// boundary of the surface, and along faces in the plane, only one side exists. A polyline ends at the boundary, where several
  /// polylines meet, and where the neighbours of faces in the plane change from the positive to the negative side.
  std::vector<Geodesic_polyline<FaceLocation>> polylines;

  /// edges that the plane touches: both faces of the edge are on the same side of the plane; or one face is within the plane
  /// and there is no other. They have no sides.
  std::vector<EdgeDescriptor> touched_edges;

  std::vector<VertexDescriptor> touched_vertices; ///< vertices where the plane touches the surface, and no edge there
  std::size_t number_of_faces_in_plane = 0; ///< faces in the plane; the section has the border of their union in their place
};

} // namespace CGAL

#endif
