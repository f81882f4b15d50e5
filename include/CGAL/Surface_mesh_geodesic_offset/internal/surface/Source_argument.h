// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The argument `sources` of the free functions: writes it to a source set, by its type.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_SOURCE_ARGUMENT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_SOURCE_ARGUMENT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_plane_section.h>
#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_source_set.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/point_conversion.h>

#include <array>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

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

} // namespace CGAL::Geodesic_offset::internal

#endif
