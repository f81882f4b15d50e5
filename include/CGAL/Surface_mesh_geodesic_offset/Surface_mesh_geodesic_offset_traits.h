// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_SURFACE_MESH_GEODESIC_OFFSET_TRAITS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_SURFACE_MESH_GEODESIC_OFFSET_TRAITS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_number_pair.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Profile_counter.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/config.hpp>

#include <array>
#include <cmath>
#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetTraitsClasses

\brief provides the types, predicates and constructions of `Surface_mesh_geodesic_offset`.

All constructions use the arithmetic of the kernel's `FT`: they are rounded for a floating point type, and exact for an exact
number type with square roots, such as that of `Exact_predicates_exact_constructions_kernel_with_sqrt`.

If `FT` is `double`, computations use the predicates of `Exact_predicates_inexact_constructions_kernel`, whatever the kernel. With
exact numbers, `Compare_entry_with_apex_2` decides on which side of a ray an apex lies. With others, bounding rays have directions,
and a ray that passes an apex within rounding counts as a ray to the apex; the functor is not called.

The points of the mesh may belong to another kernel, for example an exact one: their coordinates are converted, with
`CGAL::to_double()` if `FT` is `double`.

If `CGAL_PROFILE` is defined, also for the compiled library, the number of calls of `Compare_entry_with_apex_2`, and of those that its
filter left undecided, is printed when the program ends.

\tparam K a \cgal kernel. Its `FT` is a floating point type, or a model of `FieldWithSqrt`.
\tparam TriangleMesh a model of `FaceListGraph`

\cgalModels{SurfaceMeshGeodesicOffsetTraits}
\cgalModels{SurfaceMeshGeodesicOffsetTraitsWithPairs}, if `K::FT` is a floating point type
*/
template <class K, class TriangleMesh>
class Surface_mesh_geodesic_offset_traits
{
  static_assert(Geodesic_offset::internal::has_square_roots<typename K::FT>(),
                "Surface_mesh_geodesic_offset: distances need square roots. The FT of this kernel has none. Take a kernel "
                "with a floating point type, as Exact_predicates_inexact_constructions_kernel, or one with exact square "
                "roots, as Exact_predicates_exact_constructions_kernel_with_sqrt; the mesh's points may be of any kernel.");

public:
  /// \name Types
  /// @{

  /// the kernel
  typedef K Kernel;
  /// the mesh
  typedef TriangleMesh Triangle_mesh;
  /// the number type of distances and of coordinates
  typedef typename K::FT FT;
  /// a point in space
  typedef typename K::Point_3 Point_3;
  /// a vector in space
  typedef typename K::Vector_3 Vector_3;
  /// two numbers
  typedef Geodesic_number_pair<FT> FT_pair;

  /// a halfedge and the apex of its face, in the frame of the halfedge
  struct Apex_2
  {
    FT length; ///< length of the halfedge
    FT x;      ///< abscissa of the apex
    FT y;      ///< ordinate of the apex
  };

  /// the image of a source
  struct Image_2
  {
    FT x;     ///< abscissa of the point, or of the direction
    FT y;     ///< ordinate of the point, or of the direction
    FT sigma; ///< distance at the point, or, for parallel rays, at the origin
  };

  /// the image of a source, with both coordinates in a pair
  struct Image_pair_2
  {
    FT_pair image; ///< abscissa and ordinate
    FT sigma;      ///< as in `Image_2`
  };

  /*!
  Lays a face out in the plane, once for each of its halfedges.

  Computes, from the halfedge vectors \f$u_0 = q - p\f$, \f$u_1 = r - q\f$, \f$u_2 = p - r\f$, the lengths \f$|u_k|\f$ and the
  apices \f$(-u_k \cdot u_{k+2},\ A) / |u_k|\f$, with indices modulo 3. \f$A = |u_i \times u_{i+1}|\f$ is twice the area, from the
  two shorter edges. The law of cosines, which needs only the three lengths, would lose several digits with needle faces. Exact if
  `FT` is.
  */
  class Construct_apices_2
  {
  public:
    /// returns the lengths and apices of the face with the vertices `p`, `q`, `r`, in the order of the halfedges from `p`, `q`
    /// and `r`. If a length is zero, the members that depend on it are zero.
    std::array<Apex_2, 3> operator()(const Point_3& p, const Point_3& q, const Point_3& r) const
    {
      const FT u[3][3] = {{q.x() - p.x(), q.y() - p.y(), q.z() - p.z()},
                          {r.x() - q.x(), r.y() - q.y(), r.z() - q.z()},
                          {p.x() - r.x(), p.y() - r.y(), p.z() - r.z()}};
      const FT square[3] = {dot(u[0], u[0]), dot(u[1], u[1]), dot(u[2], u[2])};
      const FT(&a)[3] = u[after_longest(square)], (&b)[3] = u[(after_longest(square) + 1) % 3];
      const FT n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
      const FT area = root(dot(n, n));
      return {{apex(square[0], dot(u[0], u[2]), area), apex(square[1], dot(u[1], u[0]), area),
               apex(square[2], dot(u[2], u[1]), area)}};
    }

  private:
    static FT dot(const FT (&u)[3], const FT (&v)[3]) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

    // Of a halfedge u with the squared length `square`, and the previous halfedge v with the product `product`.
    static Apex_2 apex(const FT& square, const FT& product, const FT& area)
    {
      const FT length = root(square);
      if (!CGAL::is_positive(length)) return {FT(0), FT(0), FT(0)};
      return {length, FT(-product / length), FT(area / length)};
    }

    // From long edges that differ little the area would lose digits.
    static int after_longest(const FT (&square)[3])
    {
      if constexpr (!Geodesic_offset::internal::Number_policy<FT>::is_inexact) return 0;
      return square[0] >= square[1] ? (square[0] >= square[2] ? 1 : 0) : square[1] >= square[2] ? 2 : 0;
    }
  };

  /*!
  Brings the image of a source into another frame, whose origin is at \f$o\f$ and whose \f$x\f$ axis has the unit direction
  \f$(c, s)\f$.

  With \f$(X', Y') = (X, Y) - W o\f$, the image becomes \f$(c X' + s Y',\ c Y' - s X')\f$; with \f$W = 0\f$, the distance
  \f$\sigma\f$ at the origin becomes \f$\sigma - (X, Y) \cdot o\f$. Exact if `FT` is.
  */
  class Change_frame_2
  {
  public:
    /// `Tag_true` if `FT` is a floating point type: then there are operators for pairs
    typedef Boolean_tag<std::is_floating_point<FT>::value> Has_pairs;

    /// returns the image `(x, y)` and `sigma` in the new frame.
    BOOST_FORCEINLINE Image_2 operator()(const FT& x, const FT& y, const FT& sigma, bool is_parallel, const FT& ox,
                                         const FT& oy, const FT& c, const FT& s) const
    {
      if (is_parallel) return rotated(x, y, FT(sigma - (x * ox + y * oy)), c, s);
      return rotated(FT(x - ox), FT(y - oy), sigma, c, s);
    }

    /// returns the image and `sigma` in the new frame. `c` holds the cosine twice, `s` the sine and its negative.
    BOOST_FORCEINLINE Image_pair_2 operator()(const FT_pair& image, const FT& sigma, bool is_parallel, const FT_pair& o,
                                              const FT_pair& c, const FT_pair& s) const
    {
      if (!is_parallel) return {(*this)(image - o, c, s), sigma};
      const FT_pair shift = image * o;
      return {(*this)(image, c, s), FT(sigma - (shift.first() + shift.second()))};
    }

    /// returns the image in a new frame with the same origin.
    BOOST_FORCEINLINE FT_pair operator()(const FT_pair& image, const FT_pair& c, const FT_pair& s) const
    {
      return c * image + s * image.swapped();
    }

  private:
    BOOST_FORCEINLINE static Image_2 rotated(const FT& x, const FT& y, const FT& sigma, const FT& c, const FT& s)
    {
      return {FT(c * x + s * y), FT(c * y - s * x), sigma};
    }
  };

  /*!
  Compares the entry point of a ray of a window into a face with that of the ray to the apex of the face.

  In the frame of a halfedge (origin at its source, \f$x\f$ axis along it, face above) the source image of the window is
  \f$(X : Y : W)\f$ with \f$Y < 0\f$ for \f$W = 1\f$. The ray through \f$(b, 0)\f$ has direction \f$(bW - X, -Y)\f$. The sign
  returned is that of \f$ b\,(W a_y - Y) - (X a_y - Y a_x)\f$, the cross product of that direction and the vector from
  \f$(b,0)\f$ to the apex \f$(a_x, a_y)\f$: `POSITIVE` if the apex is to the left of the ray (the ray passes to the right of
  the apex), `ZERO` if the ray hits it.

  Exact for the given coordinates if `FT` is exact, or if `FT` is `double` or `float` and the kernel has exact predicates:
  where the filter, in `double`, does not decide, the kernel's `Orientation_2` does for interval windows, and exact arithmetic
  for parallel-source windows.
  */
  class Compare_entry_with_apex_2
  {
  public:
    /// returns the sign of the cross product.
    Sign operator()(const FT& x, const FT& y, bool is_parallel, const FT& b, const FT& ax, const FT& ay) const
    {
      if constexpr (is_filtered)
      {
        CGAL_BRANCH_PROFILER("side tests beyond the filter / side tests", profiler);
        double bound;
        const double value = cross_product<double>(x, y, is_parallel, b, ax, ay, bound);
        if (value > bound) return POSITIVE;
        if (value < -bound) return NEGATIVE;
        CGAL_BRANCH_PROFILER_BRANCH(profiler);
        return is_parallel ? of_parallel_ray(x, y, b, ax, ay) : of_ray(x, y, b, ax, ay);
      }
      else
      {
        FT bound;
        return CGAL::sign(cross_product<FT>(x, y, is_parallel, b, ax, ay, bound));
      }
    }

  private:
    // a float is a double
    static constexpr bool is_filtered =
      (std::is_same<FT, double>::value || std::is_same<FT, float>::value) && K::Has_filtered_predicates;

    template <class T>
    static T cross_product(const T& x, const T& y, bool is_parallel, const T& b, const T& ax, const T& ay, T& bound)
    {
      const T slope = is_parallel ? T(-y) : T(ay - y);
      const T left = b * slope;
      const T r0 = x * ay, r1 = y * ax;
      // slope, the three products, two differences: six roundings of at most the magnitudes below
      if constexpr (is_filtered) bound = T(1e-15) * (std::abs(b) * (std::abs(ay) + std::abs(y)) + std::abs(r0) + std::abs(r1));
      return left - (r0 - r1);
    }

    static Sign of_ray(const FT& x, const FT& y, const FT& b, const FT& ax, const FT& ay)
    {
      typedef typename K::Point_2 Point_2;
      return K().orientation_2_object()(Point_2(x, y), Point_2(b, FT(0)), Point_2(ax, ay));
    }

    static Sign of_parallel_ray(double x, double y, double b, double ax, double ay)
    {
      const Exact_rational X(x), Y(y);
      return CGAL::sign(Exact_rational(Y * (Exact_rational(ax) - Exact_rational(b)) - X * Exact_rational(ay)));
    }
  };

  /*!
  Computes the distance of a point \f$p\f$ on a ray of a window: \f$\sigma + |p - (X, Y)|\f$ for \f$W = 1\f$,
  \f$\sigma - (X, Y) \cdot p\f$ for \f$W = 0\f$. Exact if `FT` is.
  */
  class Compute_distance_2
  {
  public:
    /// `Tag_true` if `FT` is a floating point type: then there are operators for pairs
    typedef Boolean_tag<std::is_floating_point<FT>::value> Has_pairs;

    /// returns the distance at the point `(px, py)`.
    BOOST_FORCEINLINE FT operator()(const FT& x, const FT& y, const FT& sigma, bool is_parallel, const FT& px,
                                    const FT& py) const
    {
      if (is_parallel) return sigma - (x * px + y * py);
      const FT u = px - x, v = py - y;
      return sigma + root(u * u + v * v);
    }

    /// returns the distances of two interval windows at two points.
    BOOST_FORCEINLINE FT_pair operator()(const FT_pair& x, const FT_pair& y, const FT_pair& sigma, const FT_pair& px,
                                         const FT_pair& py) const
    {
      const FT_pair u = px - x, v = py - y;
      return sigma + square_root(u * u + v * v);
    }
  };

  /*!
  Compares the distances of one point in two windows. For a floating point type, distances are equal if they differ by at most
  four units in the last place of the given scale; otherwise the comparison is exact.
  */
  class Compare_distance_2
  {
  public:
    /// compares the distances `d` and `e`.
    BOOST_FORCEINLINE Comparison_result operator()(const FT& d, const FT& e, const FT& scale) const
    {
      const FT difference = d - e, allowance = Geodesic_offset::internal::Number_policy<FT>::rounding(4) * scale;
      return difference > allowance ? LARGER : difference < -allowance ? SMALLER : EQUAL;
    }
  };

  /// @}

  /// \name Operations
  /// @{

  /// returns a functor of type `Construct_apices_2`.
  Construct_apices_2 construct_apices_2_object() const { return Construct_apices_2(); }
  /// returns a functor of type `Change_frame_2`.
  Change_frame_2 change_frame_2_object() const { return Change_frame_2(); }
  /// returns a functor of type `Compare_entry_with_apex_2`.
  Compare_entry_with_apex_2 compare_entry_with_apex_2_object() const { return Compare_entry_with_apex_2(); }
  /// returns a functor of type `Compute_distance_2`.
  Compute_distance_2 compute_distance_2_object() const { return Compute_distance_2(); }
  /// returns a functor of type `Compare_distance_2`.
  Compare_distance_2 compare_distance_2_object() const { return Compare_distance_2(); }
  /// @}

private:
  static FT root(const FT& x) { return Geodesic_offset::internal::square_root<FT>(x); }
};

} // namespace CGAL

#endif
