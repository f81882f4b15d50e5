// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads the arguments of Python functions: locations, polylines and sources. The documentation of the module has their forms.

#ifndef GEODESIC_OFFSET_PYTHON_INPUT_H
#define GEODESIC_OFFSET_PYTHON_INPUT_H

#include "bindings.h"

#include <CGAL/Surface_mesh_geodesic_offset/Polyline_closing.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset_python {

// An index of an element; what fits no index is one that no mesh has.
template <class Element>
Element element(std::int64_t i)
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  return Element(i < 0 || i > none ? none : static_cast<std::uint32_t>(i));
}

// Weights of Python are those of the corners in their order; the halfedge of a face leads from the last corner to the first one.
inline Face_location location(std::int64_t face, const double* w) { return {element<Face>(face), {w[2], w[0], w[1]}}; }

inline std::array<double, 3> weights(const Face_location& l) { return {l.second[1], l.second[2], l.second[0]}; }

// Faces and weights of their corners, as arrays.
inline py::tuple exported(const std::vector<Face_location>& locations)
{
  std::vector<std::int64_t> faces;
  std::vector<std::array<double, 3>> corners;
  for(const Face_location& l : locations)
  {
    faces.push_back(l.first == Mesh::null_face() ? -1 : static_cast<std::int64_t>(l.first.idx()));
    corners.push_back(weights(l));
  }
  return py::make_tuple(moved<std::int64_t>(std::move(faces)), moved<double>(std::move(corners), 3));
}

// Locations of a query: vertices, or points in faces. `is_scalar`: one of them, and a result that is no array.
struct Locations
{
  std::vector<Vertex> vertices;
  std::vector<Face_location> locations;
  bool is_scalar = false;

  std::size_t size() const { return vertices.size() + locations.size(); }

  // f(i, location), for vertices and for locations
  template <class Function>
  void for_each(const Function& f) const
  {
    for(std::size_t i = 0; i < vertices.size(); ++i) f(i, vertices[i]);
    for(std::size_t i = 0; i < locations.size(); ++i) f(i, locations[i]);
  }

  // An array with a row per location, or its only row.
  py::object shaped(const py::array& rows) const { return is_scalar ? py::object(rows[py::int_(0)]) : py::object(rows); }
};

// An argument as an array of numbers; empty if it is none.
inline std::optional<py::array> numbers(const py::object& argument)
{
  if(py::isinstance<py::tuple>(argument) || py::isinstance<py::str>(argument)) return std::nullopt;
  if(py::isinstance<py::list>(argument)) // of numbers, or of lists of numbers; not of arrays
    for(const py::handle item : argument)
      if(py::isinstance<py::array>(item) || (!py::isinstance<py::list>(item) && !PyNumber_Check(item.ptr())))
        return std::nullopt;
  const py::array array = py::array::ensure(argument);
  if(!array || (array.dtype().kind() != 'i' && array.dtype().kind() != 'u' && array.dtype().kind() != 'f'))
  {
    PyErr_Clear();
    return std::nullopt;
  }
  return array;
}

inline bool has_integers(const py::array& array) { return array.dtype().kind() != 'f'; }
inline bool are_points(const py::array& array)
{
  return (array.ndim() == 2 && array.shape(1) == 3) || (array.ndim() == 1 && array.shape(0) == 3 && !has_integers(array));
}

inline std::vector<Point> points_of(const py::array& array)
{
  const Doubles coordinates(array);
  const double* const x = coordinates.data();
  std::vector<Point> points;
  for(py::ssize_t i = 0; i < coordinates.size(); i += 3) points.emplace_back(x[i], x[i + 1], x[i + 2]);
  return points;
}

inline std::vector<Vertex> vertices_of(const py::array& array)
{
  const Indices indices(array);
  std::vector<Vertex> vertices;
  for(py::ssize_t i = 0; i < indices.size(); ++i) vertices.push_back(element<Vertex>(indices.data()[i]));
  return vertices;
}

// Faces and weights.
inline Locations read_pair(const py::tuple& pair)
{
  const std::optional<py::array> faces = pair.size() == 2 ? numbers(pair[0]) : std::nullopt;
  if(!faces || !has_integers(*faces) || faces->ndim() > 1)
    throw py::type_error("geodesic_offset: a tuple is a location if it has faces, integers, and weights");
  const Indices indices(*faces);
  const Doubles corners = Doubles::ensure(pair[1]);
  if(!corners || corners.ndim() != indices.ndim() + 1 || corners.size() != 3 * indices.size() ||
     corners.shape(corners.ndim() - 1) != 3)
  {
    PyErr_Clear();
    throw py::value_error("geodesic_offset: locations need three weights for each face");
  }
  Locations result;
  result.is_scalar = indices.ndim() == 0;
  for(py::ssize_t i = 0; i < indices.size(); ++i)
    result.locations.push_back(location(indices.data()[i], corners.data() + 3 * i));
  return result;
}

// Vertices, points in space, or locations.
inline Locations read_locations(const Shared_mesh& mesh, const py::object& argument)
{
  if(py::isinstance<py::tuple>(argument)) return read_pair(argument);
  const std::optional<py::array> array = numbers(argument);
  if(!array) throw py::type_error("geodesic_offset: locations are vertices, points, or a tuple of faces and weights");
  Locations result;
  if(are_points(*array))
  {
    result.is_scalar = array->ndim() == 1;
    const std::vector<Point> points = points_of(*array);
    const py::gil_scoped_release release;
    for(const Point& p : points) result.locations.push_back(mesh.prepared->locate(p));
  }
  else if(array->ndim() < 2 && (has_integers(*array) || array->size() == 0))
  {
    result.is_scalar = array->ndim() == 0;
    result.vertices = vertices_of(*array);
  }
  else
    throw py::value_error("geodesic_offset: vertices are integers in one dimension, points have three columns");
  return result;
}

// All of them as locations in faces: a vertex as a corner of one of its faces.
inline std::vector<Face_location> in_faces(const Shared_mesh& mesh, const Locations& given)
{
  std::vector<Face_location> result = given.locations;
  for(const Vertex v : given.vertices)
  {
    if(!mesh.tm.has_valid_index(v))
      throw std::invalid_argument("geodesic_offset: vertex " + std::to_string(v.idx()) + " is not a vertex of the mesh");
    Halfedge h = mesh.tm.halfedge(v);
    if(h != Mesh::null_halfedge() && mesh.tm.is_border(h)) h = mesh.tm.prev(mesh.tm.opposite(h));
    if(h == Mesh::null_halfedge())
      throw std::invalid_argument("geodesic_offset: vertex " + std::to_string(v.idx()) + " has no face");
    const Halfedge first = mesh.tm.halfedge(mesh.tm.face(h));
    std::array<double, 3> w{0, 0, 0}; // of the source of `first`, of its target, and of the third corner
    w[mesh.tm.source(first) == v ? 0 : mesh.tm.target(first) == v ? 1 : 2] = 1;
    result.emplace_back(mesh.tm.face(h), w);
  }
  return result;
}

// The polyline through points in space or locations. `closed`: empty for a polyline that is closed if its ends meet.
inline Polyline read_polyline(const Shared_mesh& mesh, const py::object& argument, const std::optional<bool>& closed,
                              const std::optional<std::vector<double>>& start_values)
{
  const std::optional<py::array> array = numbers(argument);
  const auto join = [&](const auto& points, bool is_closed, const auto& through) {
    const py::gil_scoped_release release;
    const auto np = CGAL::parameters::is_closed(is_closed);
    return start_values ? through(points, np.start_values(std::cref(*start_values))) : through(points, np);
  };
  if(array && are_points(*array))
  {
    const std::vector<Point> points = points_of(*array);
    return join(points, closed.value_or(CGAL::polyline_closing(points) == CGAL::Polyline_closing::CLOSED),
                [&](const auto& p, const auto& np) { return mesh.prepared->locate_polyline(p, np); });
  }
  const std::vector<Face_location> locations = in_faces(mesh, read_locations(mesh, argument));
  const bool repeats_first = locations.size() > 3 && locations.front() == locations.back();
  return join(locations, closed.value_or(repeats_first),
              [&](const auto& p, const auto& np) { return mesh.prepared->join_polyline(p, np); });
}

// Edges given by their two vertices.
inline std::vector<Edge> edges_of(const Shared_mesh& mesh, const py::array& array)
{
  const std::vector<Vertex> ends = vertices_of(array);
  std::vector<Edge> edges;
  for(std::size_t i = 0; i + 1 < ends.size(); i += 2)
  {
    const bool are_valid = mesh.tm.has_valid_index(ends[i]) && mesh.tm.has_valid_index(ends[i + 1]);
    Halfedge h = are_valid ? mesh.tm.halfedge(ends[i], ends[i + 1]) : Mesh::null_halfedge();
    if(are_valid && h == Mesh::null_halfedge()) // maybe in another fan of a vertex that several fans share
      for(const Halfedge g : mesh.tm.halfedges())
        if(mesh.tm.source(g) == ends[i] && mesh.tm.target(g) == ends[i + 1]) h = g;
    if(h == Mesh::null_halfedge())
      throw std::invalid_argument("geodesic_offset: the mesh has no edge from vertex " + std::to_string(ends[i].idx()) +
                                  " to vertex " + std::to_string(ends[i + 1].idx()));
    edges.push_back(mesh.tm.edge(h));
  }
  return edges;
}

inline void add(Source_set& set, Source_set::Kind kind, Vertex v, std::vector<Face_location> locations, std::vector<Edge> edges,
                double start_value)
{
  set.add({kind, v, std::move(locations), std::move(edges), start_value, {}});
}

// Adds each location as a source of its own.
inline void add_locations(Source_set& set, const Locations& given, double start_value)
{
  for(const Vertex v : given.vertices) add(set, Source_set::Kind::VERTEX, v, {}, {}, start_value);
  for(const Face_location& l : given.locations) add(set, Source_set::Kind::LOCATION, Mesh::null_vertex(), {l}, {}, start_value);
}

// Adds the sources of an argument.
inline void add_sources(const Shared_mesh& mesh, const py::object& argument, Source_set& set)
{
  if(py::isinstance<Shared_sources>(argument))
  {
    for(const auto& s : argument.cast<const Shared_sources&>().set.sources()) set.add(s.second);
    return;
  }
  if(py::isinstance<Shared_polyline>(argument))
  {
    set.add_polyline(argument.cast<const Shared_polyline&>().polyline);
    return;
  }
  const std::optional<py::array> array = numbers(argument);
  if(array && array->ndim() == 2 && array->shape(1) == 2 && has_integers(*array))
    add(set, Source_set::Kind::EDGES, Mesh::null_vertex(), {}, edges_of(mesh, *array), 0);
  else if(array && array->ndim() == 2 && array->shape(1) == 3)
    set.add_polyline(read_polyline(mesh, argument, std::nullopt, std::nullopt));
  else if(!array && py::isinstance<py::list>(argument))
    for(const py::handle item : argument) add_sources(mesh, py::reinterpret_borrow<py::object>(item), set);
  else
    add_locations(set, read_locations(mesh, argument), 0);
}

inline Source_set read_sources(const Shared_mesh& mesh, const py::object& argument)
{
  Source_set set;
  if(!argument.is_none()) add_sources(mesh, argument, set);
  return set;
}

// A set for each source: each item of a list, and otherwise each location or point.
inline std::vector<Source_set> read_rows(const Shared_mesh& mesh, const py::object& argument)
{
  std::vector<Source_set> rows;
  const std::optional<py::array> array = numbers(argument);
  if(!array && py::isinstance<py::list>(argument))
    for(const py::handle item : argument) rows.push_back(read_sources(mesh, py::reinterpret_borrow<py::object>(item)));
  else
  {
    Source_set all;
    add_locations(all, read_locations(mesh, argument), 0);
    for(const auto& s : all.sources()) rows.emplace_back().add(s.second);
  }
  return rows;
}

} // namespace geodesic_offset_python

#endif // GEODESIC_OFFSET_PYTHON_INPUT_H
