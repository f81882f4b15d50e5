// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_SOURCE_SET_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_SOURCE_SET_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_plane_section.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/point_conversion.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <CGAL/NT_converter.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief holds sources on a triangle mesh: vertices, locations, polylines and sets of edges, each with an id.

A source set refers to no mesh, so its functions do not check whether a source fits one. The functions that compute distances
check this, and throw `std::invalid_argument` for a source that does not fit the mesh.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam FT_ the number type of barycentric coordinates
*/
template <class TriangleMesh, class FT_ = double>
class Geodesic_source_set
{
public:
  /// \name Types
  /// @{

  /// the number type of barycentric coordinates
  typedef FT_ FT;
  /// a vertex of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  /// an edge of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  /// a face of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  /// a point of the surface, the same type as `Polygon_mesh_processing::Face_location`: a face, and the barycentric
  /// coordinates of the point with respect to the source of the face's halfedge, its target, and the third vertex
  typedef std::pair<face_descriptor, std::array<FT, 3>> Face_location;

  /// the kinds of sources
  enum class Kind : unsigned char {
    VERTEX,          ///< a vertex
    LOCATION,        ///< a point anywhere on the surface
    OPEN_POLYLINE,   ///< a polyline from its first point to its last one
    CLOSED_POLYLINE, ///< a polyline whose last point is joined to the first one
    EDGES            ///< a set of edges
  };

  /// a source
  struct Source
  {
    Kind kind;                            ///< the kind; it determines which of the other members have values
    vertex_descriptor vertex;             ///< the vertex of `VERTEX`
    std::vector<Face_location> locations; ///< the point of `LOCATION`, and the points of a polyline
    std::vector<edge_descriptor> edges;   ///< the edges of `EDGES`
    FT start_value = FT(0);               ///< the distance of the points of the source; finite and not negative
    std::vector<FT> start_values = {};    ///< of polylines: the distances of its points, linear between them, in place of
                                          ///< `start_value`; empty if they are all the same
  };
  /// @}

  /// \name Construction
  /// @{

  /// makes a set without sources.
  Geodesic_source_set() = default;

  /// converts the numbers of a set with another number type. The sources have the same ids.
  template <class Number>
  explicit Geodesic_source_set(const Geodesic_source_set<TriangleMesh, Number>& set) : m_next(set.m_next)
  {
    const CGAL::NT_converter<Number, FT> convert{};
    for (const auto& [id, s] : set.m_sources)
    {
      Source& source =
        m_sources.emplace(id, Source{Kind(s.kind), s.vertex, converted(s.locations), s.edges, convert(s.start_value)})
          .first->second;
      for (const Number& value : s.start_values) source.start_values.push_back(convert(value));
    }
  }
  /// @}

  /// \name Modification
  /// Each function that adds a source returns its id: 0, 1, 2, ... Ids of removed sources are not used again. Constant or
  /// linear time in the size of the source, and logarithmic time in the number of sources.
  ///
  /// \param np an optional named parameter; for polylines also `is_closed`
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{start_value}
  ///     \cgalParamDescription{a distance that is added to all distances from the source}
  ///     \cgalParamType{convertible to `FT_`, a finite number that is not negative}
  ///     \cgalParamDefault{0}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// @{

  /// adds a vertex.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_vertex(vertex_descriptor v, const NamedParameters& np = parameters::default_values())
  {
    return add({Kind::VERTEX, v, {}, {}, Geodesic_offset::internal::start_value_of<FT>(np)});
  }

  /// adds a point of the surface.
  template <class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_location(const Face_location& location, const NamedParameters& np = parameters::default_values())
  {
    return add({Kind::LOCATION,
                boost::graph_traits<TriangleMesh>::null_vertex(),
                {location},
                {},
                Geodesic_offset::internal::start_value_of<FT>(np)});
  }

  /// Overload for a location with the coordinates of another kernel, which are converted.
  template <class Coordinate, class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_location(const std::pair<face_descriptor, std::array<Coordinate, 3>>& location,
                           const NamedParameters& np = parameters::default_values())
  {
    return add_location(Geodesic_offset::internal::converted_location<FT>(location), np);
  }

  /// adds a polyline. Reads two more named parameters: `is_closed(b)`, whether the last point is joined to the first one (default:
  /// whether there are more than three locations, and the last one is equal to the first one); and `start_values(range)`, a start value
  /// for each location, linear between them, in place of `start_value`. Each of its segments is straight within one closed face, and
  /// along an edge where start values vary.
  /// \tparam FaceLocationRange a model of `ConstRange` with `Face_location`, or a location with the coordinates of another kernel,
  ///         as value type
  /// \param locations the vertices of the polyline, at least one
  template <class FaceLocationRange, class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_polyline(const FaceLocationRange& locations, const NamedParameters& np = parameters::default_values())
  {
    namespace internal = Geodesic_offset::internal;
    const FT start_value = internal::start_value_of<FT, internal::Polyline_source_parameters>(np);
    std::vector<Face_location> points = converted(locations);
    std::vector<FT> start_values = internal::start_values_of<FT>(np, points.size());
    const bool repeats_first = points.size() > 3 && points.front() == points.back();
    const bool is_closed = internal::is_closed_of(np, repeats_first);
    if (is_closed && repeats_first) points.pop_back();
    internal::drop_repeated_start_value(start_values, points.size());
    if constexpr (internal::has_parameter<internal_np::geodesic_start_value_t, NamedParameters>)
      if (!start_values.empty())
        throw std::invalid_argument("Surface_mesh_geodesic_offset: a polyline with start_value and start_values");
    return add({is_closed ? Kind::CLOSED_POLYLINE : Kind::OPEN_POLYLINE,
                boost::graph_traits<TriangleMesh>::null_vertex(),
                std::move(points),
                {},
                start_value,
                std::move(start_values)});
  }

  /// Overload for a polyline that is open or closed itself; its locations may have the coordinates of another kernel.
  template <class Location, class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_polyline(const Geodesic_polyline<Location>& polyline,
                           const NamedParameters& np = parameters::default_values())
  {
    Geodesic_offset::internal::check_named_parameters<Geodesic_offset::internal::Source_parameters, NamedParameters>();
    if (polyline.start_values.empty()) return add_polyline(polyline.locations, np.is_closed(polyline.is_closed));
    return add_polyline(polyline.locations, np.is_closed(polyline.is_closed).start_values(std::cref(polyline.start_values)));
  }

  /// adds a set of edges.
  /// \tparam EdgeRange a model of `ConstRange` with `edge_descriptor` as value type
  /// \param edges the edges, at least one
  template <class EdgeRange, class NamedParameters = parameters::Default_named_parameters>
  std::size_t add_edges(const EdgeRange& edges, const NamedParameters& np = parameters::default_values())
  {
    return add({Kind::EDGES,
                boost::graph_traits<TriangleMesh>::null_vertex(),
                {},
                std::vector<edge_descriptor>(std::begin(edges), std::end(edges)),
                Geodesic_offset::internal::start_value_of<FT>(np)});
  }

  /// adds a source.
  std::size_t add(Source source)
  {
    m_sources.emplace(m_next, std::move(source));
    return m_next++;
  }

  /// removes a source.
  /// \throws std::invalid_argument if there is no source with this id.
  void remove(std::size_t id)
  {
    if (m_sources.erase(id) == 0)
      throw std::invalid_argument("Surface_mesh_geodesic_offset: there is no source " + std::to_string(id));
  }

  /// removes all sources.
  void clear() { m_sources.clear(); }
  /// @}

  /// \name Access
  /// @{

  /// the number of sources.
  std::size_t size() const { return m_sources.size(); }

  /// whether there is no source.
  bool empty() const { return m_sources.empty(); }

  /// the sources by their ids.
  const std::map<std::size_t, Source>& sources() const { return m_sources; }
  /// @}

private:
  template <class, class>
  friend class Geodesic_source_set;

  template <class FaceLocationRange>
  static std::vector<Face_location> converted(const FaceLocationRange& locations)
  {
    constexpr bool has_points = Geodesic_offset::internal::has_points_in_space<FaceLocationRange>;
    static_assert(!has_points, CGAL_GEODESIC_OFFSET_NEEDS_LOCATION);
    std::vector<Face_location> result;
    if constexpr (!has_points)
      for (const auto& l : locations) result.push_back(Geodesic_offset::internal::converted_location<FT>(l));
    return result;
  }

  std::map<std::size_t, Source> m_sources;
  std::size_t m_next = 0;
};

} // namespace CGAL

#endif
