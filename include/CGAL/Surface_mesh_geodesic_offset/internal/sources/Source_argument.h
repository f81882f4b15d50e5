// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The argument `sources` of the free functions: adds it to a source set, by its type.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_SOURCE_ARGUMENT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_SOURCE_ARGUMENT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_plane_section.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_source_set.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Geodesic_mesh_data.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/point_conversion.h>

#include <array>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class T, class = void>
constexpr bool is_point_in_space = false;
template <class T>
constexpr bool is_point_in_space<T, std::void_t<decltype(std::declval<const T&>().x(), std::declval<const T&>().z())>> = true;

template <class Mesh>
class Source_argument
{
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  typedef typename Mesh::edge_descriptor edge_descriptor;
  typedef typename Mesh::face_descriptor face_descriptor;
  typedef typename Mesh::FT FT;
  typedef typename Mesh::Point_3 Point_3;
  typedef typename Mesh::Source_set Source_set;

public:
  Source_argument(const Mesh& mesh, Source_set& set) : m_mesh(mesh), m_set(set) {}

  void add(vertex_descriptor v) { m_set.add_vertex(v); }

  template <class Coordinate>
  void add(const std::pair<face_descriptor, std::array<Coordinate, 3>>& location)
  {
    m_set.add_location(converted_location<FT>(location));
  }

  template <class Location>
  void add(const Geodesic_polyline<Location>& polyline)
  {
    std::vector<typename Mesh::Face_location> locations;
    for (const Location& l : polyline.locations) locations.push_back(converted_location<FT>(l));
    m_set.add_polyline(locations, polyline.is_closed);
  }

  template <class Number>
  void add(const Geodesic_source_set<typename Mesh::Triangle_mesh, Number>& set)
  {
    for (const auto& [id, s] : set.sources())
    {
      (void)id;
      typename Source_set::Source source{
        typename Source_set::Kind(s.kind), s.vertex, {}, s.edges, converted_number<FT>(s.start_value)};
      for (const auto& l : s.locations) source.locations.push_back(converted_location<FT>(l));
      m_set.add(std::move(source));
    }
  }

  // Overload for a point in space or a range.
  template <class Argument>
  void add(const Argument& argument)
  {
    if constexpr (is_point_in_space<Argument>) m_set.add_location(m_mesh.locate(converted_point<Point_3, FT>(argument)));
    else
    {
      typedef std::decay_t<decltype(*std::begin(argument))> Value;
      if constexpr (std::is_same<Value, edge_descriptor>::value) m_set.add_edges(argument);
      else if constexpr (is_point_in_space<Value>) add_polyline_through(argument);
      else
        for (const auto& a : argument) add(a);
    }
  }

private:
  // Adds a polyline, closed if the last point equals the first.
  template <class PointRange>
  void add_polyline_through(const PointRange& range)
  {
    std::vector<Point_3> points;
    for (const auto& p : range) points.push_back(converted_point<Point_3, FT>(p));
    const bool closed = points.size() > 3 && points.front() == points.back();
    add(m_mesh.locate_polyline(points, closed));
  }

  const Mesh& m_mesh;
  Source_set& m_set;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
