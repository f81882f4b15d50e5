// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetConcepts

\brief The types, and the one predicate, that `CGAL::Surface_mesh_geodesic_offset` needs.

\cgalConcept

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_mesh_geodesic_offset_traits}
\cgalHasModelsEnd
*/
class SurfaceMeshGeodesicOffsetTraits
{
public:
  /// \name Types
  /// @{

  /// The kernel of the points of the mesh.
  typedef unspecified_type Kernel;

  /// The mesh: a model of `FaceListGraph`.
  typedef unspecified_type Triangle_mesh;

  /// The number type of distances and of coordinates in the unfolded faces: a model of `FieldWithSqrt`.
  /// For a floating point type, the algorithm makes allowance for rounding; for any other type, equal
  /// means equal.
  typedef unspecified_type FT;

  /// The point type of the mesh.
  typedef unspecified_type Point_3;

  /// The vector type that belongs to `Point_3`.
  typedef unspecified_type Vector_3;

  /*!
  Compares the entry point of a ray of a window with that of the ray of the same window that hits the apex of the
  face.

  It works in the frame of the halfedge through which the window enters the face: the origin is the source of the
  halfedge, the \f$x\f$ axis points to its target, and the face, with its apex \f$(a_x, a_y)\f$, is
  above. The image of the window's source is \f$(X : Y : W)\f$: the point \f$(X, Y)\f$ if \f$W = 1\f$, for an interval
  window; the direction \f$(X, Y)\f$ if \f$W = 0\f$, for a parallel-source window. The ray that enters the face at
  \f$(b, 0)\f$ has the direction \f$(bW - X, -Y)\f$. Its cross product with the vector from \f$(b, 0)\f$ to the apex is
  \f[ b\,(W a_y - Y) - (X a_y - Y a_x). \f]

  An object of this type must provide the operator
  `CGAL::Sign operator()(FT x, FT y, bool is_parallel, FT b, FT ax, FT ay) const`
  which returns the sign of this value, where \f$W\f$ is 0 if `is_parallel` is `true` and 1 otherwise:
  - `CGAL::POSITIVE` if the apex is to the left of the ray, that is, if the ray enters beyond the one that hits the
    apex, and leaves the face through the edge from the target of the halfedge to the apex;
  - `CGAL::ZERO` if the ray hits the apex;
  - `CGAL::NEGATIVE` if the apex is to the right of the ray.

  The sign must be that of the exact value for the numbers given. A wrong sign near zero can send a
  window through the wrong edge.

  \pre \f$a_y > 0\f$ and \f$Y \le 0\f$, with \f$Y < 0\f$ unless the source lies on the halfedge itself
  */
  typedef unspecified_type Compare_entry_with_apex_2;

  /// @}

  /// \name Operations
  /// @{

  /// Returns an object of the type `Compare_entry_with_apex_2`.
  Compare_entry_with_apex_2 compare_entry_with_apex_2_object() const;

  /// @}
};
