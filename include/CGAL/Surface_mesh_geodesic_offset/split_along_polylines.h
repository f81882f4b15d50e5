// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_SPLIT_ALONG_POLYLINES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_SPLIT_ALONG_POLYLINES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Default_offset_splitting_visitor.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Mesh_splitting.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Split_lengths.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Surface_polyline.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/iterator.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/value_type.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief splits the faces of a mesh along polylines on it, so that the polylines consist of edges.

With the edges as barriers (the named parameter `edge_is_constrained_map` of `Geodesic_mesh`), no path crosses the polylines; of closed
polylines, the faces on one side are a region.

Crossed faces are replaced by constrained Delaunay triangulations. Points of polylines closer than 2^-33 of the diagonal of the
bounding box to each other, to a vertex or to an edge are one point, the vertex, or on the edge. Where polylines cross in a face, there
is a new vertex. A closed mesh stays closed. The time is linear in the size of the mesh, plus \f$ O(n \log n) \f$ for the \f$ n \f$
points and crossings of polylines in each face.

\tparam TriangleMesh a model of `MutableFaceGraph`, `FaceListGraph` and `VertexListGraph`
\tparam Polylines a model of `ConstRange` whose value type is `Geodesic_mesh::Polyline`
\tparam NamedParameters a sequence of named parameters
\param tm the mesh. Afterwards, fields and geodesic objects of it must not be used any more.
\param polylines polylines on `tm`, such as those of `Geodesic_mesh::locate_polyline()`; polylines of fewer than two points count for
       nothing
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{receives `true` for each edge on a polyline; other values are not written}
    \cgalParamType{a model of `WritablePropertyMap` with `edge_descriptor` as key and `bool` as value}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{output_iterator}
    \cgalParamDescription{receives a pair of the number of the polyline and a halfedge for each edge on a polyline, in the direction of
                          the polyline, in no particular order; several times where polylines share edges}
    \cgalParamType{a model of `OutputIterator` that accepts `std::pair<std::size_t, halfedge_descriptor>`}
    \cgalParamDefault{`Emptyset_iterator`}
    \cgalParamExtra{The iterator is copied.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadWritePropertyMap` with `vertex_descriptor` as key and a 3D point as value}
    \cgalParamDefault{`get(boost::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is called for each new vertex, split edge and new face; `before_subface_creations()` tells the face from
                          which the new faces come}
    \cgalParamType{a model of `OffsetSplittingVisitor`}
    \cgalParamDefault{`Default_offset_splitting_visitor`}
    \cgalParamExtra{The visitor is copied.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre All faces of `tm` are triangles. The polylines are of `tm`, or of a mesh that has the same descriptors.
\throws std::invalid_argument if consecutive points of a polyline have no face in common; then the mesh is unchanged
*/
template <class TriangleMesh, class Polylines, class NamedParameters = parameters::Default_named_parameters>
void split_along_polylines(TriangleMesh& tm, const Polylines& polylines,
                           const NamedParameters& np = parameters::default_values())
{
  namespace internal = Geodesic_offset::internal;
  internal::check_named_parameters<internal::Polyline_splitting_parameters, NamedParameters>();
  typedef typename boost::range_value<Polylines>::type Polyline;
  typedef internal::Surface_polyline<TriangleMesh, typename decltype(Polyline::locations)::value_type> Curve;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::type Vertex_point_map;
  const Vertex_point_map vpm = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                            get_property_map(boost::vertex_point, tm));
  const double diagonal = internal::Split_lengths::diagonal_of(tm, vpm);
  internal::Mesh_splitting<TriangleMesh, Vertex_point_map, Curve> splitting(tm, vpm, diagonal, diagonal);
  std::size_t number = 0;
  for (const Polyline& p : polylines) splitting.add(Curve(tm, p.locations, p.is_closed, number), number), ++number;
  splitting.cross_pieces();
  splitting.triangulate();
  auto visitor = parameters::choose_parameter(parameters::get_parameter(np, internal_np::visitor),
                                              Default_offset_splitting_visitor<TriangleMesh>());
  splitting.split(parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained),
                                               Static_boolean_property_map<typename Graph_traits::edge_descriptor, false>()),
                  visitor, [](const auto&, std::size_t) {});
  auto out = parameters::choose_parameter(parameters::get_parameter(np, internal_np::output_iterator), Emptyset_iterator());
  splitting.for_each_edge([&](std::size_t polyline, const auto& h) { *out++ = std::make_pair(polyline, h); });
}

#ifndef DOXYGEN_RUNNING
// A constant or temporary mesh
template <class TriangleMesh, class Polylines, class NamedParameters = parameters::Default_named_parameters>
void split_along_polylines(const TriangleMesh&, const Polylines&, const NamedParameters& = parameters::default_values())
{
  static_assert(!std::is_same<TriangleMesh, TriangleMesh>::value,
                "split_along_polylines() splits the mesh in place, which must not be const or temporary: split a copy");
}
#endif

} // namespace CGAL

#endif
