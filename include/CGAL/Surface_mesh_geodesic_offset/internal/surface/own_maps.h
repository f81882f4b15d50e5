// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Metafunctions for the property maps of the mesh type. A mesh type needs a map only if no named parameter gives one.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_OWN_MAPS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_OWN_MAPS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class TriangleMesh>
struct Own_vertex_index_map
{
  typedef typename GetInitializedVertexIndexMap<TriangleMesh>::const_type type;
};

template <class TriangleMesh>
struct Own_face_index_map
{
  typedef typename GetInitializedFaceIndexMap<TriangleMesh>::const_type type;
};

template <class TriangleMesh>
struct Own_vertex_point_map
{
  typedef typename boost::property_map<TriangleMesh, boost::vertex_point_t>::const_type type;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
