// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetConcepts

\brief The concept `SurfaceMeshGeodesicOffsetTraits` describes the types, predicates and constructions that
`CGAL::Surface_mesh_geodesic_offset` and the functions of the package need.

All geometry is in the plane, in the frame of a halfedge: the origin is the source of the halfedge, the \f$x\f$ axis points to
its target, and the face, with its apex \f$(a_x, a_y)\f$, is above the axis. The image of a window's source is \f$(X : Y : W)\f$: the point
\f$(X, Y)\f$ if \f$W = 1\f$, for an interval window, whose distance at \f$p\f$ is \f$\sigma + |p - (X, Y)|\f$; the unit vector
\f$(X, Y)\f$ if \f$W = 0\f$, for a parallel-source window, whose distance at \f$p\f$ is \f$\sigma - (X, Y) \cdot p\f$. An argument
`is_parallel` says that \f$W = 0\f$.

A model may be derived from `CGAL::Surface_mesh_geodesic_offset_traits` and replace functors: it then declares the type of the
functor and the function that returns it. The concept `SurfaceMeshGeodesicOffsetTraitsWithPairs` has optional operators that make
the propagation faster.

Objects of a model and of its functors are copied; if the model is default constructible, the argument `traits` is optional. With
`CGAL::Parallel_tag` several threads call the functors concurrently.

\cgalConcept

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_mesh_geodesic_offset_traits}
\cgalHasModelsEnd

\sa `SurfaceMeshGeodesicOffsetTraitsWithPairs`
*/
class SurfaceMeshGeodesicOffsetTraits
{
public:
  /// \name Types
  /// @{

  /// A \cgal kernel.
  typedef unspecified_type Kernel;

  /// The mesh: a model of `FaceListGraph`. Its points may be of another kernel: their coordinates are converted by
  /// `CGAL::NT_converter`.
  typedef unspecified_type Triangle_mesh;

  /*!
  The number type of distances and of coordinates in the unfolded faces, the same as `Kernel::FT`: a model of `FieldWithSqrt`
  and `RealEmbeddable`, and of `ImplicitInteroperable` with `int` and `ExplicitInteroperable` with `double`. In addition:
  - `FT` is constructible from `double`, without rounding if it is exact, and can be compared with `double` by `<`, `>`, `<=` and
    `>=`.
  - If `FT` is not exact (`CGAL::Algebraic_structure_traits<FT>::Is_exact` is `CGAL::Tag_false`), the algorithm allows for
    rounding in comparisons. The rounding unit is `std::numeric_limits<FT>::%epsilon()`. If `std::numeric_limits<FT>` is not
    specialized, `FT` must have the static function `get_default_precision()`, which returns the number of bits, as
    `CGAL::Gmpfr` does. Comparisons of exact numbers are exact. `CORE::Expr` is accepted only with the functors of
    `Surface_mesh_geodesic_offset_traits`.
  - If `std::numeric_limits<FT>::%has_infinity` is `true`, operations and comparisons with infinity are those of IEEE 754. In
    particular, `<`, `<=`, `>` and `>=` are `false` for the result of \f$\infty - \infty\f$. Otherwise \f$10^{300}\f$ stands for
    infinity, and must be in the range of `FT`.
  - Offset curves need numbers with the precision of `double`, at least.
  - With `CGAL::Parallel_tag` several threads operate concurrently on different numbers that are copies of each other.
  */
  typedef unspecified_type FT;

  /// The point type, `Kernel::Point_3`.
  typedef unspecified_type Point_3;

  /// The vector type, `Kernel::Vector_3`.
  typedef unspecified_type Vector_3;

  /// A halfedge and the apex of its face, in the frame of the halfedge: a class with the public data members `length`, `x` and
  /// `y` of type `FT`.
  typedef unspecified_type Apex_2;

  /// The image of a window's source: a class with the public data members `x`, `y` and `sigma` of type `FT`, the numbers
  /// \f$X\f$, \f$Y\f$ and \f$\sigma\f$ above.
  typedef unspecified_type Image_2;

  /*!
  Lays a face out in the plane, in the frames of its three halfedges. An object of this type must provide the operator
  `std::array<Apex_2, 3> operator()(Point_3 p, Point_3 q, Point_3 r) const`
  for the face with the halfedges from `p` to `q`, from `q` to `r` and from `r` to `p`, in this order. For each of them, with
  the vectors \f$u\f$ along it and \f$v\f$ from its source to the third vertex, the result has the `length` \f$|u|\f$ and the
  apex (`x`, `y`) \f$= (u \cdot v,\ |u \times v|) / |u|\f$ in its frame. A `length` or a `y` that is not positive means that the
  face is degenerate; then the other members may have any value.
  */
  typedef unspecified_type Construct_apices_2;

  /*!
  Changes the frame of an image. An object of this type must provide the operator
  `Image_2 operator()(FT x, FT y, FT sigma, bool is_parallel, FT ox, FT oy, FT c, FT s) const`
  which returns the image in the frame with origin \f$o\f$ and \f$x\f$ axis in the unit direction \f$(c, s)\f$:
  with \f$(X', Y') = (X, Y) - W o\f$ the result is \f$(c X' + s Y',\ c Y' - s X')\f$, and its `sigma` is
  \f$\sigma\f$ if \f$W = 1\f$, and \f$\sigma - (X, Y) \cdot o\f$ if \f$W = 0\f$.
  */
  typedef unspecified_type Change_frame_2;

  /*!
  Compares the entry point of a ray of a window with that of the ray of the same window that hits the apex of the
  face.

  The ray that enters the face at
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

  With numbers that are not exact, bounding rays have directions, and the functor is not called.
  */
  typedef unspecified_type Compare_entry_with_apex_2;

  /*!
  Computes a distance. An object of this type must provide the operator
  `FT operator()(FT x, FT y, FT sigma, bool is_parallel, FT px, FT py) const`
  which returns the distance of the window at \f$p\f$.
  */
  typedef unspecified_type Compute_distance_2;

  /*!
  Compares the distances that two windows give to one point. An object of this type must provide the operator
  `CGAL::Comparison_result operator()(FT d, FT e, FT scale) const`
  which returns `CGAL::EQUAL` if `d` and `e`, results of `Compute_distance_2` of a magnitude of at most `scale`, differ by no
  more than rounding.
  */
  typedef unspecified_type Compare_distance_2;

  /// @}

  /// \name Operations
  /// @{

  /// returns a functor of type `Construct_apices_2`.
  Construct_apices_2 construct_apices_2_object() const;
  /// returns a functor of type `Change_frame_2`.
  Change_frame_2 change_frame_2_object() const;
  /// returns a functor of type `Compare_entry_with_apex_2`.
  Compare_entry_with_apex_2 compare_entry_with_apex_2_object() const;
  /// returns a functor of type `Compute_distance_2`.
  Compute_distance_2 compute_distance_2_object() const;
  /// returns a functor of type `Compare_distance_2`.
  Compare_distance_2 compare_distance_2_object() const;

  /// @}
};
