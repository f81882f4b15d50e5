// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One call of a free function: its mesh, sources and build.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FUNCTIONS_ONE_CALL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FUNCTIONS_ONE_CALL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_mesh_type.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_plane_section.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_source_set.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/point_conversion.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/statistics_report.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/build_parameters.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/source_classification.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <array>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// The argument `sources` of the free functions: writes it to a source set, by its type.
template <class Mesh>
class Source_argument
{
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  typedef typename Mesh::edge_descriptor edge_descriptor;
  typedef typename Mesh::face_descriptor face_descriptor;
  typedef typename Mesh::FT FT;
  typedef typename Mesh::Point_3 Point_3;
  typedef typename Mesh::Source_set Source_set;

  template <class T>
  static constexpr bool is_vertex = std::is_convertible<const T&, vertex_descriptor>::value;
  template <class T>
  static constexpr bool is_edge = std::is_same<T, edge_descriptor>::value ||
                                  (std::is_convertible<const T&, edge_descriptor>::value && !is_vertex<T>);

public:
  Source_argument(const Mesh& mesh, Source_set& set) : m_mesh(mesh), m_set(set) {}

  // Overload for a source set, whose ids are kept.
  template <class Number>
  void read(const Geodesic_source_set<typename Mesh::Triangle_mesh, Number>& set)
  {
    m_set = Source_set(set);
  }

  template <class Argument>
  void read(const Argument& argument)
  {
    add(argument);
  }

private:
  template <class Coordinate>
  void add(const std::pair<face_descriptor, std::array<Coordinate, 3>>& location)
  {
    m_set.add_location(location);
  }

  template <class Location>
  void add(const Geodesic_polyline<Location>& polyline)
  {
    m_set.add_polyline(polyline);
  }

  // A source set in a range: its sources get new ids.
  template <class Number>
  void add(const Geodesic_source_set<typename Mesh::Triangle_mesh, Number>& set)
  {
    const Source_set converted(set);
    for (const auto& s : converted.sources()) m_set.add(s.second);
  }

  // Overload for an element of the mesh, a point in space, or a range. Handles of other types may convert to an element.
  template <class Argument>
  void add(const Argument& argument)
  {
    if constexpr (is_edge<Argument>) m_set.add_edges(std::array<edge_descriptor, 1>{{argument}});
    else if constexpr (is_vertex<Argument>) m_set.add_vertex(argument);
    else if constexpr (is_point_in_space<Argument>) m_set.add_location(m_mesh.locate(converted_point<Point_3, FT>(argument)));
    else
    {
      typedef std::decay_t<decltype(*std::begin(argument))> Value;
      if constexpr (is_edge<Value>) m_set.add_edges(argument);
      else if constexpr (is_point_in_space<Value>) add_polyline_through(argument);
      else
        for (const auto& a : argument) add(a);
    }
  }

  template <class PointRange>
  void add_polyline_through(const PointRange& range)
  {
    std::vector<Point_3> points;
    for (const auto& p : range) points.push_back(converted_point<Point_3, FT>(p));
    add(m_mesh.locate_polyline(points));
  }

  const Mesh& m_mesh;
  Source_set& m_set;
};

// A vertex, a location or a point in space, classified on the mesh.
template <class Mesh, class From>
auto classified_start(const Mesh& mesh, const From& from)
{
  if constexpr (is_point_in_space<From>)
    return Mesh_access::data(mesh).classified(mesh.locate(converted_point<typename Mesh::Point_3, typename Mesh::FT>(from)));
  else return Mesh_access::data(mesh).classified(from);
}

template <class TriangleMesh, class Sources, class NamedParameters>
class One_call
{
public:
  typedef Geodesic_mesh_type<TriangleMesh, NamedParameters> Mesh;
  typedef Surface_of<Mesh> Surface;
  typedef typename Surface::Number Number;
  typedef typename Surface::vertex_descriptor vertex_descriptor;
  typedef Geodesic_build<typename Surface::Computing_traits> Build;
  typedef Build_request<Number> Request;
  typedef Concurrency_tag_of<NamedParameters> Concurrency_tag;

  // Points in space are joined by paths, which need kept windows; so there is one propagation for both.
  static constexpr unsigned parts = build_parts_of<NamedParameters> | (has_points_in_space<Sources> ? KEPT_WINDOWS : NO_PARTS);

  One_call(const TriangleMesh& tm, const Sources& sources, const NamedParameters& np)
    : m_mesh(Mesh_access::make<Mesh>(tm, np)), m_np(np)
  {
    Source_argument<Mesh>(m_mesh, m_sources).read(sources);
  }

  const Mesh& mesh() const { return m_mesh; }
  const auto& data() const { return Mesh_access::data(m_mesh); }

  Request request() const
  {
    return read_build_request<Number>(m_np, [this](const auto& t) { return data().classified(t); });
  }

  // The build before its propagation.
  Build build(const Request& request) const { return Build(data().unfolded(), classified_sources(data(), m_sources), request); }

  // The build after its propagation, without offset curves. `more_parts`: those that the request needs beyond its
  // parameters, see Build_part.
  template <unsigned more_parts = NO_PARTS>
  std::unique_ptr<const Build> propagated(const Request& request) const
  {
    std::unique_ptr<Build> result(new Build(build(request)));
    result->template propagate<Concurrency_tag, Build::parts_for(parts | more_parts)>(data().traits);
    report(result->statistics, m_np);
    return result;
  }

private:
  Mesh m_mesh;
  typename Mesh::Source_set m_sources;
  const NamedParameters& m_np;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
