// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_SURFACE_MESH_GEODESIC_OFFSET_TRAITS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_SURFACE_MESH_GEODESIC_OFFSET_TRAITS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetTraitsClasses

\brief A model of the concept `SurfaceMeshGeodesicOffsetTraits`.

\tparam K a \cgal kernel. With a kernel whose `FT` is a floating point type and whose predicates are
        exact, as `Exact_predicates_inexact_constructions_kernel`, the side tests are decided exactly
        behind a floating point filter.
\tparam TriangleMesh a model of `FaceListGraph`

\cgalModels{SurfaceMeshGeodesicOffsetTraits}
*/
template <class K, class TriangleMesh>
class Surface_mesh_geodesic_offset_traits
{
public:
  typedef K Kernel;
  typedef TriangleMesh Triangle_mesh;
  typedef typename K::FT FT;
  typedef typename K::Point_3 Point_3;
  typedef typename K::Vector_3 Vector_3;

  /*!
  Compares where a ray of a window enters a face with where the ray to the face's apex enters it.

  In the frame of a halfedge (origin at its source, \f$x\f$ axis along it, face above) the source image
  of the window is \f$(X : Y : W)\f$ with \f$Y < 0\f$ for \f$W = 1\f$. The ray through \f$(b, 0)\f$ has
  direction \f$(bW - X, -Y)\f$. The sign returned is that of
  \f$ b\,(W a_y - Y) - (X a_y - Y a_x)\f$,
  which is the cross product of that direction and the vector from \f$(b,0)\f$ to the apex
  \f$(a_x, a_y)\f$: `POSITIVE` if the apex is to the left of the ray (the ray passes to the right of the
  apex), `ZERO` if the ray hits it.

  Exact for the coordinates given whenever the kernel has exact predicates.
  */
  class Compare_entry_with_apex_2
  {
  public:
    Sign operator()(const FT& x, const FT& y, bool parallel, const FT& b, const FT& ax, const FT& ay) const
    {
      const FT slope = parallel ? FT(-y) : FT(ay - y);
      const FT left = b * slope;
      const FT r0 = x * ay, r1 = y * ax;
      const FT value = left - (r0 - r1);
      if constexpr (std::is_floating_point<FT>::value && K::Has_filtered_predicates)
      {
        // slope, the three products, two differences: six roundings of at most the magnitudes below
        const FT bound = FT(1e-15) * (std::abs(b) * (std::abs(ay) + std::abs(y)) + std::abs(r0) + std::abs(r1));
        if (value > bound) return POSITIVE;
        if (value < -bound) return NEGATIVE;
        return exact(x, y, parallel, b, ax, ay);
      }
      else
        return CGAL::sign(value);
    }

  private:
    static Sign exact(double x, double y, bool parallel, double b, double ax, double ay)
    {
      const Exact_rational X(x), Y(y), B(b), AX(ax), AY(ay);
      const Exact_rational slope = parallel ? Exact_rational(-Y) : Exact_rational(AY - Y);
      return CGAL::sign(Exact_rational(B * slope - (X * AY - Y * AX)));
    }
  };

  Compare_entry_with_apex_2 compare_entry_with_apex_2_object() const { return Compare_entry_with_apex_2(); }
};

} // namespace CGAL

#endif
