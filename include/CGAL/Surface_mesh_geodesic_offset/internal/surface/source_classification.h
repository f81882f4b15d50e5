// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Classification of the user's sources on a mesh.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_SOURCE_CLASSIFICATION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_SOURCE_CLASSIFICATION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Polyline_closing.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Geodesic_mesh_data.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_set.h>

#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// \throws std::invalid_argument if the source is empty, a location or an edge is not one of the mesh, or the start value is not
// a finite number or is negative
template <class Surface, class Source>
auto classified_source(const Geodesic_mesh_data<Surface>& mesh, const Source& source)
{
  typedef Source_set<typename Surface::Number> Sources;
  typedef decltype(source.kind) Kind;
  if (!(source.start_value >= 0) || !Number_policy<std::decay_t<decltype(source.start_value)>>::is_finite(source.start_value))
    throw std::invalid_argument("Surface_mesh_geodesic_offset: the start value of a source is negative or not a finite number");
  typename Sources::Source result{Sources::POINT, {}, {}, mesh.surface().imported(source.start_value), {}};
  for (const auto& s : source.start_values)
  {
    if (!(s >= 0) || !Number_policy<std::decay_t<decltype(s)>>::is_finite(s))
      throw std::invalid_argument(
        "Surface_mesh_geodesic_offset: a start value of a polyline is negative or not a finite number");
    result.start_values.push_back(mesh.surface().imported(s));
  }
  if (!result.start_values.empty() && result.start_values.size() != source.locations.size())
    throw std::invalid_argument("Surface_mesh_geodesic_offset: a polyline has not as many start values as points");
  switch (source.kind)
  {
  case Kind::VERTEX: result.points.push_back(mesh.classified(source.vertex)); break;
  case Kind::LOCATION: break;
  case Kind::OPEN_POLYLINE: result.kind = Sources::OPEN_POLYLINE; break;
  case Kind::CLOSED_POLYLINE: result.kind = Sources::CLOSED_POLYLINE; break;
  case Kind::EDGES: result.kind = Sources::EDGES; break;
  }
  for (const auto& l : source.locations) result.points.push_back(mesh.classified(l));
  for (const auto e : source.edges)
    result.halfedges.push_back(mesh.surface().index_beside_edge(halfedge(e, mesh.surface().tm)));
  if (result.kind == Sources::EDGES ? result.halfedges.empty() : result.points.empty())
    throw std::invalid_argument(result.kind == Sources::EDGES ? "Surface_mesh_geodesic_offset: an empty set of edges"
                                                              : "Surface_mesh_geodesic_offset: a polyline without points");
  return result;
}

// \throws std::invalid_argument if a source does not fit the mesh
template <class Surface, class User_set>
auto classified_sources(const Geodesic_mesh_data<Surface>& mesh, const User_set& set)
{
  Source_set<typename Surface::Number> result;
  for (const auto& [id, source] : set.sources()) result.insert(id, classified_source(mesh, source));
  return result;
}

// \throws std::invalid_argument if the source does not fit the mesh, or rays cannot start from it
template <class Surface, class Source>
void check_source(const Geodesic_mesh_data<Surface>& mesh, const Source& source)
{
  Source_set<typename Surface::Number>::check(mesh.unfolded(), classified_source(mesh, source));
}

// Closes an open polyline whose ends meet, see polyline_closing(). A short segment between the ends remains; they need a common face.
// \throws std::invalid_argument if the source does not fit the mesh
template <class Surface, class Source>
void close_if_ends_meet(const Geodesic_mesh_data<Surface>& mesh, Source& source)
{
  const auto classified = classified_source(mesh, source);
  if (classified.kind != Source_set<typename Surface::Number>::OPEN_POLYLINE || !mesh.surface().has_points) return;
  std::vector<typename Surface::Point_3> points;
  for (const auto& l : source.locations) points.push_back(mesh.surface().point(l));
  Point_in_face<typename Surface::Number> first, last;
  unsigned edge;
  if (polyline_closing(points) == Polyline_closing::CLOSED &&
      face_of_both(mesh.unfolded(), classified.points.back(), classified.points.front(), last, first, edge) != no_index)
    source.kind = decltype(source.kind)::CLOSED_POLYLINE;
}

// Adds a vertex or a location to a set of sources.
template <class User_set, class Point, class NamedParameters>
void add_point(User_set& set, const Point& point, const NamedParameters& np)
{
  static_assert(!is_point_in_space<Point>, CGAL_GEODESIC_OFFSET_NEEDS_LOCATION);
  if constexpr (std::is_convertible<const Point&, typename User_set::vertex_descriptor>::value) set.add_vertex(point, np);
  else if constexpr (!is_point_in_space<Point>) set.add_location(point, np);
}

// Adds the sources of `added` to a set, in the order of their ids; none if check_source() throws, or without memory. Returns the
// new ids. `added` is a copy, since it may be the set itself.
template <class Surface, class User_set>
std::vector<std::size_t> add_checked(const Geodesic_mesh_data<Surface>& mesh, User_set& set, User_set added)
{
  for (const auto& s : added.sources()) check_source(mesh, s.second);
  std::vector<std::size_t> ids;
  ids.reserve(added.size());
  try
  {
    for (const auto& s : added.sources()) ids.push_back(set.add(s.second));
  }
  catch (...)
  {
    for (const std::size_t id : ids) set.remove(id);
    throw;
  }
  return ids;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
