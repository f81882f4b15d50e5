// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_SPLIT_ALONG_GEODESIC_VORONOI_DIAGRAM_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_SPLIT_ALONG_GEODESIC_VORONOI_DIAGRAM_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Default_offset_splitting_visitor.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Mesh_splitting.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Split_lengths.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief splits the faces of a mesh along the curves of a geodesic Voronoi diagram, so that each face lies in one cell.

The new vertices are on the exact curves, and the chords between them nowhere farther from the curves than `chord_tolerance`. All
else is as in `split_along_offset_curves()`: crossed faces are replaced by constrained Delaunay triangulations, points closer than
2^-33 of the diagonal of the bounding box are one, and a closed mesh stays closed.

The source of a face is the one nearest to the centroid of the face. If other sources are farther by at most twice the chord tolerance,
it is the source of the neighbouring faces on the same side of the curves. In cells narrower than the chord tolerance, chords of
different curves may cross; then two faces may have the same source although an edge of a curve separates them, and different ones
although none does.

The time is linear in the size of the mesh, plus \f$ O(n \log n) \f$ for the \f$ n \f$ points of the curves in each face. If an
exception is thrown before the mesh is changed, as for bad parameters, the mesh stays as it was.

\tparam TriangleMesh a model of `MutableFaceGraph`, `FaceListGraph` and `VertexListGraph`
\tparam VoronoiDiagram an instance of `Geodesic_voronoi_diagram`
\tparam NamedParameters a sequence of named parameters
\param tm the mesh. Afterwards, the diagram, fields and geodesic objects of it must not be used any more.
\param diagram a Voronoi diagram on `tm`
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
  \cgalParamNBegin{face_source_map}
    \cgalParamDescription{receives for each face the id of the source in whose cell it lies; `no_source()` of the field if no source
                          reaches it}
    \cgalParamType{a model of `WritablePropertyMap` with `face_descriptor` as key and `std::size_t` as value}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices, with which the diagram was computed}
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

\pre All faces of `tm` are triangles. The diagram is of `tm` with these points, or of a mesh that has the same descriptors: if `tm`
is a copy of a `Surface_mesh`, a diagram of the original remains valid.
\throws std::invalid_argument unless `chord_tolerance > 0`; then the mesh is unchanged
\throws std::length_error if the curves have more than 20,000,000 chords in all; then the mesh is unchanged
*/
template <class TriangleMesh, class VoronoiDiagram, class NamedParameters = parameters::Default_named_parameters>
void split_along_geodesic_voronoi_diagram(TriangleMesh& tm, const VoronoiDiagram& diagram,
                                          const NamedParameters& np = parameters::default_values())
{
  namespace internal = Geodesic_offset::internal;
  internal::check_named_parameters<internal::Voronoi_splitting_parameters, NamedParameters>();
  typedef typename VoronoiDiagram::Curve Curve;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::type Vertex_point_map;
  const Vertex_point_map vpm = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                            get_property_map(boost::vertex_point, tm));

  const auto lengths = internal::Split_lengths::of<typename Curve::FT>(tm, vpm, diagram.curves(), np);
  internal::Mesh_splitting<TriangleMesh, Vertex_point_map, Curve> splitting(tm, vpm, lengths.diagonal, lengths.chord_tolerance);
  splitting.set_barriers(internal::surface_of(diagram));
  for (std::size_t i = 0; i < diagram.number_of_curves(); ++i) splitting.add(diagram.curve(i), i);
  splitting.triangulate();
  constexpr bool has_sources = internal::has_parameter<internal_np::geodesic_face_source_t, NamedParameters>;
  std::map<std::vector<std::size_t>, std::size_t> number_of; // of lists of sources
  // Beside a curve, chords leave points of the other cell in a face, up to the tolerance: each of the two distances changes by
  // that.
  if constexpr (has_sources)
    splitting.find_sources([&](const auto f, const std::array<double, 3>& w) {
      return number_of.emplace(diagram.sources_of_part(f, w, 2 * lengths.chord_tolerance), number_of.size()).first->second;
    });
  const auto numbers = get(CGAL::dynamic_face_property_t<std::size_t>(), tm);
  auto visitor = parameters::choose_parameter(parameters::get_parameter(np, internal_np::visitor),
                                              Default_offset_splitting_visitor<TriangleMesh>());
  splitting.split(parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained),
                                               Static_boolean_property_map<typename Graph_traits::edge_descriptor, false>()),
                  visitor, [&](const auto f, std::size_t number) { put(numbers, f, number); });
  if constexpr (has_sources)
  {
    std::vector<const std::vector<std::size_t>*> sources(number_of.size());
    for (const auto& entry : number_of) sources[entry.second] = &entry.first;
    splitting.write_cells(
      parameters::get_parameter(np, internal_np::geodesic_face_source),
      [&](const auto f) -> const std::vector<std::size_t>& { return *sources[get(numbers, f)]; },
      [&](std::size_t i) {
        const Curve c = diagram.curve(i);
        return std::make_pair(c.source_on_left(), c.source_on_right());
      });
  }
}

#ifndef DOXYGEN_RUNNING
// Chosen for meshes that are const or temporary.
template <class TriangleMesh, class VoronoiDiagram, class NamedParameters = parameters::Default_named_parameters>
void split_along_geodesic_voronoi_diagram(const TriangleMesh&, const VoronoiDiagram&,
                                          const NamedParameters& = parameters::default_values())
{
  static_assert(
    !std::is_same<TriangleMesh, TriangleMesh>::value,
    "split_along_geodesic_voronoi_diagram() splits the mesh in place, which must not be const or temporary: split a copy");
}
#endif

} // namespace CGAL

#endif
