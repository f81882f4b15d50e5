// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_DEFAULT_OFFSET_SPLITTING_VISITOR_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_DEFAULT_OFFSET_SPLITTING_VISITOR_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief is a visitor whose functions do nothing: a base class for visitors of `split_along_offset_curves()` and `split_along_polylines()`.

\cgalModels{OffsetSplittingVisitor}

\tparam TriangleMesh the type of the mesh
*/
template <class TriangleMesh>
struct Default_offset_splitting_visitor
{
  /// a vertex of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  /// a halfedge of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  /// a face of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

  /// does nothing.
  void before_edge_split(halfedge_descriptor, TriangleMesh&) {}
  /// does nothing.
  void edge_split(halfedge_descriptor, TriangleMesh&) {}
  /// does nothing.
  void after_edge_split() {}
  /// does nothing.
  void new_vertex_added(vertex_descriptor, TriangleMesh&) {}
  /// does nothing.
  void before_subface_creations(face_descriptor, TriangleMesh&) {}
  /// does nothing.
  void before_subface_created(TriangleMesh&) {}
  /// does nothing.
  void after_subface_created(face_descriptor, TriangleMesh&) {}
  /// does nothing.
  void after_subface_creations(TriangleMesh&) {}
};

} // namespace CGAL

#endif
