// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetConcepts

\brief The concept `SurfaceMeshGeodesicOffsetTraitsWithPairs` refines `SurfaceMeshGeodesicOffsetTraits` by operators on pairs of
numbers, which make the propagation faster.

The two ends of a window's interval need the same operations, and so do the distances of two windows. With the operators of
this concept, the algorithm computes them at once, as `CGAL::Geodesic_number_pair<FT>`, written `Pair` below. For `double`, a
pair is one register of the processor.

Each of the functors `Change_frame_2` and `Compute_distance_2` states by a type `Has_pairs` whether it has the operators for
pairs. If `Has_pairs` is `CGAL::Tag_true`, the operators must exist; otherwise the code does not compile. If it is
`CGAL::Tag_false`, or if the functor has no type `Has_pairs`, the algorithm calls only the operators for single numbers. The
functors are independent of each other.

So traits that are derived from `CGAL::Surface_mesh_geodesic_offset_traits` and replace a functor need no operators for pairs.
Only if the new functor is itself derived from the one of the base, it inherits the tag: then it must provide the operators, too, or
declare `typedef CGAL::Tag_false Has_pairs`.

For both numbers of a pair, an operator must return what the operator for single numbers returns, up to rounding. The
operators for single numbers remain necessary, as they are called for windows that do not meet the conditions below.

\cgalConcept

\cgalRefines{SurfaceMeshGeodesicOffsetTraits}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_mesh_geodesic_offset_traits, with a kernel whose `FT` is a floating point type}
\cgalHasModelsEnd
*/
class SurfaceMeshGeodesicOffsetTraitsWithPairs
{
public:
  /// \name Types
  /// @{

  /// The image of a window's source: a class with the public data members `image` of type `Pair`, the numbers \f$(X, Y)\f$, and
  /// `sigma` of type `FT`.
  typedef unspecified_type Image_pair_2;

  /*!
  Changes the frame of an image. The type `Change_frame_2::Has_pairs` is `CGAL::Tag_true`, and an object must also provide the
  operators
  - `Image_pair_2 operator()(Pair image, FT sigma, bool is_parallel, Pair o, Pair c, Pair s) const`,
    where `c` holds \f$(c, c)\f$ and `s` holds \f$(s, -s)\f$;
  - `Pair operator()(Pair image, Pair c, Pair s) const`, which returns the image for the origin \f$o = (0, 0)\f$, where
    \f$\sigma\f$ does not change.
  */
  typedef unspecified_type Change_frame_2;

  /*!
  Computes the distances of two interval windows. The type `Compute_distance_2::Has_pairs` is `CGAL::Tag_true`, and an object
  must also provide the operator
  `Pair operator()(Pair x, Pair y, Pair sigma, Pair px, Pair py) const`
  which returns the distance of the first window at the first point and that of the second window at the second point.
  */
  typedef unspecified_type Compute_distance_2;

  /// @}
};
