// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_NEST_OFFSET_CURVES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_NEST_OFFSET_CURVES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_curve.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Curve_nesting.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Element_division.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Curve_context.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief is the place of an offset curve in the tree of nesting of a family, see `nest_offset_curves()`.
*/
struct Offset_curve_nesting
{
  /// the parent of a curve that no curve surrounds.
  static constexpr std::size_t no_parent = (std::numeric_limits<std::size_t>::max)();

  std::size_t parent = no_parent;     ///< the index of the innermost curve that surrounds this curve, or `no_parent`
  Orientation inner_side = COLLINEAR; ///< the side of the interior: `LEFT_TURN`, `RIGHT_TURN`, or `COLLINEAR` without interior
  std::size_t depth = 0;              ///< the number of curves that surround this curve
};

namespace Geodesic_offset::internal {

template <class Surface>
Curve_context<Surface> context_type(const Geodesic_offset_curve<Surface>&);

} // namespace Geodesic_offset::internal

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief finds for each curve of a family which curve surrounds it, and on which side its interior is.

The curves divide the surface into cells. A part of the surface has an outermost cell: that at the border cycle around the largest
area, for a plate the outer one (the longest cycle if the mesh has lengths instead of points); without border, the cell with the
largest area. Here, a border cycle counts as a hole that is filled: all cells at it are one.

A closed curve has an interior if it separates the surface. The interior is the side without the outermost cell, and the curve
surrounds all curves in it. On surfaces with handles, a curve need not separate the surface, for instance around the tube of a
torus; it has no interior, and the cells on both of its sides count as one. Open curves have no interior: both of their sides are
connected around an end inside the surface, or through a border. Curves without interior may have a parent.

Only the topology of the curves matters, so the distances of nested curves may increase or decrease inwards.

Uses `double` for all number types. The time is linear in the size of the mesh, plus \f$ O(n \log n) \f$ for \f$ n \f$ pieces, plus,
for each curve inside a single face, the number of pieces in this face.

\tparam OffsetCurves a model of `ConstRange` with `Geodesic_offset_curve` as value type
\param curves curves of one field, of one or several distances, in any order
\return the places, in the order of the curves
\pre The curves do not meet, as those of one field, and are curves of one `Surface_mesh_geodesic_offset` or of one call.
\throws std::logic_error if a curve was moved from
*/
template <class OffsetCurves>
std::vector<Offset_curve_nesting> nest_offset_curves(const OffsetCurves& curves)
{
  using namespace Geodesic_offset::internal;
  typedef decltype(context_type(*std::begin(curves))) Context;
  typedef decltype(Context::surface_of(*std::begin(curves))) Surface;
  typedef Curve_nesting<typename std::decay<Surface>::type::Number, Offset_curve_nesting> Nesting;
  std::vector<typename Nesting::Curve> views;
  for (const auto& c : curves)
  {
    Context::surface_of(c); // or an exception
    views.push_back({&Context::pieces_of(c), c.is_closed()});
  }
  if (views.empty()) return {};
  Surface surface = Context::surface_of(*std::begin(curves));
  return Nesting(surface.unfolded, std::move(views))([&](const std::vector<Index>& border) {
    double sum = 0;
    Space_vector area = NULL_VECTOR;
    const auto at = [&](Index h) { return space_vector(surface.point_of_vertex(surface.unfolded.source(h))); };
    for (std::size_t i = 0; i < border.size(); ++i)
      if (!surface.has_points) sum += CGAL::to_double(surface.unfolded[border[i]].length);
      else if (i > 0) area = area + cross_product(at(border[i - 1]) - at(border[0]), at(border[i]) - at(border[0]));
    return surface.has_points ? length(area) : sum;
  });
}

} // namespace CGAL

#endif
