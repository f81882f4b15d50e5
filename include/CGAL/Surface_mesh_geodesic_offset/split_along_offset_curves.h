// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_SPLIT_ALONG_OFFSET_CURVES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_SPLIT_ALONG_OFFSET_CURVES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Default_offset_splitting_visitor.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_curve.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Mesh_splitting.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Split_lengths.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Split_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <boost/range/value_type.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief splits the faces of a mesh along offset curves, so that the curves are polylines of edges.

The new vertices are on the exact curves, and the chords between them nowhere farther from the curves than `chord_tolerance`.
Crossed faces are replaced by the constrained Delaunay triangulation of their part of the curves; the surface stays the same
set of points up to rounding, and a closed mesh stays closed. Vertices, edges that no curve crosses, and faces without points of
curves keep their descriptors.

Points of curves within 2^-33 of the diagonal of the bounding box, about 1e-10, of each other, of a vertex or of an edge are
identified, so that a level that touches a vertex or runs along an edge leaves no thin triangles there. Distances that differ by
less than 2^-31 of the diagonal count as one level, and only the curves of the smallest of them split the mesh. Curves at distances
below 2^-31 of the diagonal are ignored. The chords of two curves cross only where the curves are closer to each other than 2^-33 of
the diagonal, as both sides of a narrow strip. Crossings become vertices, within the chord tolerance of the curves.

The time is linear in the size of the mesh, plus \f$ O(n \log n) \f$ for the \f$ n \f$ points of the curves in each face. Curves of
the same center that are closer to each other than the chord tolerance are divided in the same directions: the points of each
count for the farther ones. If an exception is thrown before the mesh is changed, as for bad parameters, the mesh stays as it was.

\tparam TriangleMesh a model of `MutableFaceGraph`, `FaceListGraph` and `VertexListGraph`
\tparam OffsetCurves a model of `ConstRange` with `Geodesic_offset_curve` as value type
\tparam NamedParameters a sequence of named parameters
\param tm the mesh. Afterwards, curves, fields and geodesic objects of it must not be used any more.
\param curves offset curves on `tm`, in any order; without curves the mesh stays as it is
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{chord_tolerance}
    \cgalParamDescription{the largest distance of a chord from its curve}
    \cgalParamType{a number}
    \cgalParamDefault{1e-4 of the diagonal of the bounding box of the faces}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{receives `true` for each edge on a curve; other values are not written}
    \cgalParamType{a model of `WritablePropertyMap` with `edge_descriptor` as key and `bool` as value}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{face_band_map}
    \cgalParamDescription{receives for each face its band: the number of distances of the curves that do not exceed the distances
                          in the face, 0 nearest to the sources}
    \cgalParamType{a model of `WritablePropertyMap` with `face_descriptor` as key and `std::size_t` as value}
    \cgalParamDefault{none}
    \cgalParamExtra{The curves must be all curves of their distances, on both sides of the sources; distances without curves do
                    not count. A region without a curve on its border, as a component of the surface that no curve crosses, gets the
                    lowest band, unless `vertex_distance_map` is given and the region has a vertex of the mesh; so does a
                    region whose border has only curves that are both sides of strips narrower than 2^-33 of the diagonal. Where
                    chords cross, bands may be wrong.}
  \cgalParamNEnd
  \cgalParamNBegin{face_source_map}
    \cgalParamDescription{receives for each face the id of the source that is nearest to the centroid of the face; other points
                          of the face may be nearer to others. `no_source()` of the field if no source reaches it}
    \cgalParamType{a model of `WritablePropertyMap` with `face_descriptor` as key and `std::size_t` as value}
    \cgalParamDefault{none}
    \cgalParamExtra{Needs `distance_field`.}
  \cgalParamNEnd
  \cgalParamNBegin{distance_field}
    \cgalParamDescription{the distances on `tm` before the split, with kept windows and without a tolerance. It is used before
                          the mesh changes.}
    \cgalParamType{an instance of `Geodesic_distance_field`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_distance_map}
    \cgalParamDescription{the distances of the vertices before the split}
    \cgalParamType{a model of `ReadablePropertyMap` with `vertex_descriptor` as key and a number as value}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices, with which the curves were computed}
    \cgalParamType{a model of `ReadWritePropertyMap` with `vertex_descriptor` as key and a 3D point as value}
    \cgalParamDefault{`get(boost::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is called for each new vertex, split edge and new face}
    \cgalParamType{a model of `OffsetSplittingVisitor`}
    \cgalParamDefault{`Default_offset_splitting_visitor`}
    \cgalParamExtra{The visitor is copied.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre All faces of `tm` are triangles. The curves and the field are of `tm` with these points, or of a mesh that has the same
descriptors: if `tm` is a copy of a `Surface_mesh`, curves and field of the original remain valid.
\throws std::invalid_argument unless `chord_tolerance > 0`, or if the curves have a tolerance; then the mesh is unchanged
\throws std::length_error if the curves have more than 20,000,000 chords in all; then the mesh is unchanged
\throws std::logic_error if `distance_field` has no kept windows, or has a tolerance; then the mesh is unchanged
*/
template <class TriangleMesh, class OffsetCurves, class NamedParameters = parameters::Default_named_parameters>
void split_along_offset_curves(TriangleMesh& tm, const OffsetCurves& curves,
                               const NamedParameters& np = parameters::default_values())
{
  namespace internal = Geodesic_offset::internal;
  internal::check_named_parameters<internal::Splitting_parameters, NamedParameters>();
  typedef typename boost::range_value<OffsetCurves>::type Curve;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::type Vertex_point_map;
  const Vertex_point_map vpm = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                            get_property_map(boost::vertex_point, tm));

  const auto lengths = internal::Split_lengths::of<typename Curve::FT>(tm, vpm, curves, np);
  internal::Mesh_splitting<TriangleMesh, Vertex_point_map, Curve> splitting(tm, vpm, lengths.diagonal, lengths.chord_tolerance);
  if (!std::empty(curves)) splitting.set_barriers(internal::surface_of(*std::begin(curves)));
  std::vector<typename Curve::FT> distances;
  for (const Curve& c : curves)
  {
    if (!CGAL::is_zero(c.tolerance()))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: a mesh is split along exact curves, without a tolerance");
    distances.push_back(c.distance());
  }
  const internal::Split_levels<typename Curve::FT> levels(std::move(distances), lengths.diagonal);
  for (const Curve& c : curves)
    if (const auto level = levels.index_of(c.distance())) splitting.add(c, *level);
  splitting.triangulate();
  constexpr bool has_sources = internal::has_parameter<internal_np::geodesic_face_source_t, NamedParameters>;
  if constexpr (has_sources)
  {
    static_assert(internal::has_parameter<internal_np::geodesic_distance_field_t, NamedParameters>,
                  "Surface_mesh_geodesic_offset: face_source_map needs distance_field");
    const auto field = parameters::get_parameter(np, internal_np::geodesic_distance_field);
    typedef typename std::remove_const<decltype(field)>::type Field;
    splitting.find_sources([&](const auto f, const std::array<double, 3>& w) {
      typedef typename Field::FT FT;
      const auto nearest = field.nearest_source_and_side(typename Field::Face_location(f, {FT(w[0]), FT(w[1]), FT(w[2])}));
      return nearest ? nearest->first : Field::no_source();
    });
  }
  auto visitor = parameters::choose_parameter(parameters::get_parameter(np, internal_np::visitor),
                                              Default_offset_splitting_visitor<TriangleMesh>());
  splitting.split(parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained),
                                               Static_boolean_property_map<typename Graph_traits::edge_descriptor, false>()),
                  visitor, [&]([[maybe_unused]] const auto f, [[maybe_unused]] const std::size_t source) {
                    if constexpr (has_sources) put(parameters::get_parameter(np, internal_np::geodesic_face_source), f, source);
                  });
  if constexpr (internal::has_parameter<internal_np::geodesic_face_band_t, NamedParameters>)
  {
    const auto band_map = parameters::get_parameter(np, internal_np::geodesic_face_band);
    if constexpr (internal::has_parameter<internal_np::geodesic_vertex_distance_t, NamedParameters>)
    {
      const auto distance_map = parameters::get_parameter(np, internal_np::geodesic_vertex_distance);
      splitting.write_bands(band_map, levels, std::make_optional([&](const auto v) {
                              typename boost::property_traits<std::decay_t<decltype(distance_map)>>::value_type d =
                                get(distance_map, v);
                              return d;
                            }));
    }
    else splitting.write_bands(band_map, levels, std::optional<double (*)(typename Graph_traits::vertex_descriptor)>());
  }
}

#ifndef DOXYGEN_RUNNING
// Chosen for meshes that are const or temporary.
template <class TriangleMesh, class OffsetCurves, class NamedParameters = parameters::Default_named_parameters>
void split_along_offset_curves(const TriangleMesh&, const OffsetCurves&, const NamedParameters& = parameters::default_values())
{
  static_assert(!std::is_same<TriangleMesh, TriangleMesh>::value,
                "split_along_offset_curves() splits the mesh in place, which must not be const or temporary: split a copy");
}
#endif

} // namespace CGAL

#endif
