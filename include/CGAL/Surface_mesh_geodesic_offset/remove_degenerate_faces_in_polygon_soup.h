// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_REMOVE_DEGENERATE_FACES_IN_POLYGON_SOUP_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_REMOVE_DEGENERATE_FACES_IN_POLYGON_SOUP_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_offset_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Degenerate_face_removal.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/point_conversion.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief is the result of `remove_degenerate_faces_in_polygon_soup()`.
*/
struct Polygon_soup_repair
{
  /// number of points that were merged into another one, as the ends of a side of length zero
  std::size_t merged_points = 0;
  /// number of polygons that were removed because less than three of their corners are different points
  std::size_t collapsed_faces = 0;
  /// number of polygons that lost spikes, or were divided at a corner that they had twice
  std::size_t shortened_faces = 0;
  /// number of flat triangles that were removed by dividing the polygons at their longest side
  std::size_t flipped_faces = 0;
  /// number of flat triangles that were removed alone, as their longest side is on the border
  std::size_t dropped_faces = 0;
  /// for each point, the index of the point that stands for it: its own, or that of the point into which it was merged. Empty if
  /// the soup is unchanged
  std::vector<std::size_t> point_indices;
  /// for each polygon of the result, the index of the polygon of which it is a part, before the call. Empty if the soup is
  /// unchanged, as `point_indices`
  std::vector<std::size_t> polygon_indices;
};

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief removes the faces without area from a polygon soup, which `Surface_mesh_geodesic_offset` and `Geodesic_mesh` refuse, so that
the rest keeps its points and its connection.

A triangle is degenerate if its area is zero in the number type of the traits, or if the height of its middle corner above its longest
side is at most rounding: 64 units in the last place of its shortest side, or 16 units of the coordinates there. Clusters of degenerate faces are removed, whatever
their shape:
- The ends of a side that is not longer than 16 units in the last place of their coordinates become one point. A triangle with such a side vanishes, and its two neighbours at the other
  sides become neighbours of each other.
- A flat triangle between three different points is replaced by a corner in the polygons beyond its longest side; a triangle there
  is divided into two. If this side is on the border, the flat triangle is dropped.

So all faces with an area cover the same surface as before, up to rounding, and shortest paths have the same lengths. Faces that
only a degenerate face connects become neighbours. Points that only degenerate faces without such neighbours have are no longer
used; the function removes no points. Polygons may have more than three corners; those whose corners are all on one line are divided
into triangles, which are then treated like others. Other polygons are not divided, and must be triangulated before distances are
computed, for example with `Polygon_mesh_processing::triangulate_polygons()`.

Polygons are neighbours if they have a side with the same indices of points. If each face has its own points, as in many files,
`Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup()` must be called before. For a triangle mesh, call
`Polygon_mesh_processing::polygon_mesh_to_polygon_soup()` before, and
`Polygon_mesh_processing::orient_polygon_soup()` and `Polygon_mesh_processing::polygon_soup_to_polygon_mesh()` after this function.

Linear in the size of the soup, plus, for each flat triangle, the number of faces at an end of its longest side.

\tparam PointRange a model of `RandomAccessContainer` whose value type is a point of any \cgal kernel, or what `point_map` maps to one
\tparam PolygonRange a model of `RandomAccessContainer` and `BackInsertionSequence` whose value type is a
        `RandomAccessContainer` of indices of points: a sequence that can be resized, or an array of three indices
\tparam NamedParameters a sequence of named parameters
\param points the points, whose coordinates must be finite, with squares of products of distances within the range of the number
       type. Points without polygons may have any coordinates
\param polygons the polygons
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{the map from the values of `points` to points}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{the traits whose number type and whose `Construct_apices_2` decide which faces have no area: a model of
                          `SurfaceMeshGeodesicOffsetTraits`}
    \cgalParamDefault{`Surface_mesh_geodesic_offset_traits` with the kernel of the points, or with
                      `Exact_predicates_inexact_constructions_kernel` if the number type of this kernel has no square roots}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the numbers of changes, and the relation to the soup before the call
*/
template <class PointRange, class PolygonRange, class NamedParameters = parameters::Default_named_parameters>
Polygon_soup_repair remove_degenerate_faces_in_polygon_soup(const PointRange& points, PolygonRange& polygons,
                                                            const NamedParameters& np = parameters::default_values())
{
  namespace internal = Geodesic_offset::internal;
  internal::check_named_parameters<internal::Polygon_soup_parameters, NamedParameters>();
  typedef typename std::iterator_traits<decltype(points.begin())>::value_type Value;
  typedef internal::Parameter_type<internal_np::point_t, NamedParameters, Identity_property_map<Value>> Point_map;
  typedef typename Kernel_traits<typename boost::property_traits<Point_map>::value_type>::Kernel Soup_kernel;
  typedef std::conditional_t<internal::has_square_roots<typename Soup_kernel::FT>(), Soup_kernel,
                             Exact_predicates_inexact_constructions_kernel>
    Kernel;
  typedef internal::Parameter_type<internal_np::geom_traits_t, NamedParameters, Surface_mesh_geodesic_offset_traits<Kernel, void>>
    Traits;
  const Point_map point_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::point_map), Point_map());
  const Traits traits = parameters::choose_parameter(parameters::get_parameter(np, internal_np::geom_traits), Traits());
  const auto point_of = [&](internal::Index i) -> typename Traits::Point_3 {
    return internal::converted_point<typename Traits::Point_3, typename Traits::FT>(get(point_map, points[i]));
  };
  internal::Degenerate_face_removal<Traits, decltype(point_of), PolygonRange> removal(points.size(), point_of, polygons, traits);
  Polygon_soup_repair repair;
  if (!removal.is_needed()) return repair;
  removal.run();
  repair.merged_points = removal.number_of_merged_points();
  repair.collapsed_faces = removal.number_of_collapsed_faces();
  repair.shortened_faces = removal.number_of_shortened_faces();
  repair.flipped_faces = removal.number_of_flipped_faces();
  repair.dropped_faces = removal.number_of_dropped_faces();
  repair.point_indices = removal.merged_points();
  repair.polygon_indices = removal.origins();
  return repair;
}

} // namespace CGAL

#endif
