// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetConcepts

\brief The concept `OffsetSplittingVisitor` describes the functions that `CGAL::split_along_offset_curves()` and
`CGAL::split_along_polylines()` call while they change the mesh, for example to copy the attributes of a face to the faces into which it is split.

First all edges with new vertices are split, then faces. The names are those of the concept `PMPCorefinementVisitor`. The
functions must neither change the mesh nor throw. The visitor is copied; it refers to data that are to remain.

\cgalConcept

\cgalHasModelsBegin
\cgalHasModels{CGAL::Default_offset_splitting_visitor}
\cgalHasModelsEnd
*/
class OffsetSplittingVisitor
{
public:
  /// the mesh
  typedef unspecified_type Triangle_mesh;
  /// a vertex of the mesh
  typedef unspecified_type vertex_descriptor;
  /// a halfedge of the mesh
  typedef unspecified_type halfedge_descriptor;
  /// a face of the mesh
  typedef unspecified_type face_descriptor;

  /// called once for each edge that is split, before its first new vertex.
  /// \param h a halfedge of the edge; its target remains
  /// \param tm the mesh
  void before_edge_split(halfedge_descriptor h, Triangle_mesh& tm);

  /// called after a vertex is inserted into the edge of the last call of `before_edge_split()`.
  /// \param hnew the new halfedge, whose target is the new vertex; the halfedge `h` is the next one
  /// \param tm the mesh
  void edge_split(halfedge_descriptor hnew, Triangle_mesh& tm);

  /// called once for each edge that is split, after its last new vertex.
  void after_edge_split();

  /// called once for each new vertex, when its point is set: for vertices on edges between `before_edge_split()` and
  /// `after_edge_split()`, for vertices inside faces between `before_subface_creations()` and `after_subface_creations()`.
  /// \param v the vertex; the connectivity inside faces is not set yet
  /// \param tm the mesh
  void new_vertex_added(vertex_descriptor v, Triangle_mesh& tm);

  /// called before a face is split, when its edges are. The face remains as one of its triangles, for which the two
  /// functions below are not called.
  /// \param f_split the face
  /// \param tm the mesh
  void before_subface_creations(face_descriptor f_split, Triangle_mesh& tm);

  /// called before each of the other triangles of the face is created.
  /// \param tm the mesh
  void before_subface_created(Triangle_mesh& tm);

  /// called after each of the other triangles of the face is created.
  /// \param f_new the new face
  /// \param tm the mesh
  void after_subface_created(face_descriptor f_new, Triangle_mesh& tm);

  /// called when all triangles of a face are created.
  /// \param tm the mesh
  void after_subface_creations(Triangle_mesh& tm);
};
