// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Checks of shortest paths in all forms of output.

#ifndef GEODESIC_OFFSET_TEST_PATH_TOOLS_H
#define GEODESIC_OFFSET_TEST_PATH_TOOLS_H

#include "locations.h"
#include "offset_tools.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace test {

typedef Surface_mesh::Vertex_index Vertex_index;
typedef Surface_mesh::Halfedge_index Halfedge_index;
typedef Surface_mesh::Face_index Face_index;
typedef Locations<Surface_mesh> Mesh_locations;
typedef std::vector<Face_location> Path_locations;
typedef Geodesic::Source_set Source_set;

inline double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

inline Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

/// Sum of the lengths of the segments.
inline double length_of(const Mesh_locations& locations, const Path_locations& path)
{
  double sum = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) sum += distance(locations.point(path[i]), locations.point(path[i + 1]));
  return sum;
}

inline double mean_edge_length(const Surface_mesh& mesh)
{
  double sum = 0;
  for (auto e : edges(mesh)) sum += distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  return sum / static_cast<double>(num_edges(mesh));
}

inline bool is_isolated(Vertex_index v, const Surface_mesh& mesh) { return halfedge(v, mesh) == Surface_mesh::null_halfedge(); }

inline std::vector<Vertex_index> used_vertices(const Surface_mesh& mesh)
{
  std::vector<Vertex_index> result;
  for (Vertex_index v : vertices(mesh))
    if (!is_isolated(v, mesh)) result.push_back(v);
  return result;
}

inline Face_index random_face(const Surface_mesh& mesh, Random& random)
{
  return *std::next(faces(mesh).begin(), static_cast<std::ptrdiff_t>(uniform_index(random, num_faces(mesh))));
}

/// In a face (`kind` 0), on an edge (1) or at a vertex (2).
inline Face_location random_location(const Mesh_locations& locations, const Surface_mesh& mesh, Random& random,
                                     std::size_t kind)
{
  const Face_index f = random_face(mesh, random);
  Halfedge_index h = halfedge(f, mesh);
  for (std::size_t turns = uniform_index(random, 3); turns > 0; --turns) h = next(h, mesh);
  if (kind == 0) return Face_location(f, random_barycentric(random));
  if (kind == 1) return locations.on_edge(h, uniform(random, 0.02, 0.98));
  return locations.at_vertex(target(h, mesh), uniform_index(random, 8));
}

/// Replaces coordinates that are zero up to rounding by zero: such a location is on an edge.
inline Face_location snapped(Face_location location)
{
  for (double& weight : location.second)
    if (std::abs(weight) <= 1e-13) weight = 0;
  return location;
}

inline bool is_at_vertex(const Face_location& location)
{
  return std::count(location.second.begin(), location.second.end(), 0.) == 2;
}

/// Visitor as for SMSP that makes a location of each element of a path.
class Sequence_collector
{
public:
  explicit Sequence_collector(const Surface_mesh& mesh) : mesh_(mesh), locations_(mesh) {}

  void operator()(Halfedge_index h, double t)
  {
    CHECK_DETAIL(t >= 0 && t <= 1, std::to_string(t));
    path.push_back(is_border(h, mesh_) ? locations_.on_edge(opposite(h, mesh_), 1 - t) : locations_.on_edge(h, t));
    ++edges;
  }
  void operator()(Vertex_index v)
  {
    path.push_back(locations_.at_vertex(v));
    ++vertices;
  }
  void operator()(Face_index f, const Geodesic::Barycentric_coordinates& w)
  {
    path.push_back(Face_location(f, w));
    ++faces;
  }

  Path_locations path;
  std::size_t edges = 0, vertices = 0, faces = 0;

private:
  const Surface_mesh& mesh_;
  Mesh_locations locations_;
};

/// Figures of all paths of a test.
struct Path_totals
{
  std::size_t paths = 0, points = 0, unreachable = 0;
  double worst_length = 0; // difference from the distance, relative to the distance or to an edge
};

/// Checks of paths on one mesh.
class Path_checker
{
public:
  explicit Path_checker(const Surface_mesh& mesh)
    : locations(mesh), scale(bounding_box_diagonal(mesh)), mean_edge(mean_edge_length(mesh)), mesh_(mesh)
  {
    for (Vertex_index v : vertices(mesh))
      for (int i = 0; i < 3; ++i) scale = (std::max)(scale, std::abs(mesh.point(v)[i]));
  }

  Point_3 point(Vertex_index v) const { return mesh_.point(v); }
  Point_3 point(const Face_location& l) const { return locations.point(l); }

  /// Returns the path from `query` after all checks: its forms agree, it starts at the query point and ends at the nearest
  /// source point, it is connected, its length is the distance, and its first direction is opposite to the gradient.
  /// `AnyGeodesic`: Geodesic, or with other index maps.
  template <class AnyGeodesic, class Query>
  Path_locations operator()(const AnyGeodesic& geodesic, const Query& query, bool has_windows = true)
  {
    Path_locations path;
    geodesic.shortest_path_to_sources(query, std::back_inserter(path));
    check_forms(geodesic, query, path);
    const double d = geodesic.distance_to_sources(query);
    const auto nearest = geodesic.nearest_source(query);
    CHECK(nearest.has_value() == std::isfinite(d) && path.empty() == std::isinf(d));
    ++totals.paths;
    totals.points += path.size();
    if (path.empty() || !nearest)
    {
      ++totals.unreachable;
      CHECK(!geodesic.gradient(query));
      return path;
    }
    CHECK_DETAIL(nearest->distance == d, values(nearest->distance, d));
    const double off = distance(point(path.front()), point(query));
    CHECK_DETAIL(off <= 1e-14 * scale, values(off, 0));
    const double miss = distance(point(path.back()), point(nearest->location));
    CHECK_DETAIL(miss <= 1e-12 * scale, values(miss, 0));
    const auto& sources = geodesic.sources().sources();
    const auto found = sources.find(nearest->source);
    const double start = found == sources.end() ? 0 : found->second.start_value; // if the source was not removed
    if (has_windows)
    {
      const double rest = geodesic.distance_to_sources(path.back()) - start;
      CHECK_DETAIL(rest <= 1e-14 * scale, values(rest, 0));
    }
    check_connected(path);
    const double length = start + length_of(locations, path);
    const double error = std::abs(length - d) / (std::max)(d, mean_edge);
    totals.worst_length = (std::max)(totals.worst_length, error);
    CHECK_DETAIL(error <= 1e-12, values(length, d));
    check_gradient(geodesic.gradient(query).value_or(CGAL::NULL_VECTOR), path);
    return path;
  }

  /// Whether coordinates are valid and consecutive points share a face.
  bool is_connected(Path_locations path) const
  {
    for (Face_location& l : path)
    {
      l = snapped(l);
      for (double w : l.second)
        if (!(w >= 0 && w <= 1 + 1e-13)) return false;
    }
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      if (locations.common_face(path[i], path[i + 1]) == Surface_mesh::null_face()) return false;
    return true;
  }

  /// Whether two locations are the same point, possibly in different faces. In a tiny or needle face, two different points
  /// of the surface may have the same coordinates in space.
  bool is_same(const Face_location& a, const Face_location& b) const
  {
    const Face_index f = locations.common_face(a, b);
    Geodesic::Barycentric_coordinates u, v;
    return f != Surface_mesh::null_face() && locations.express(a, f, u) && locations.express(b, f, v) && u == v;
  }

  /// Component of the unit vector orthogonal to the face.
  double out_of_plane(const Vector_3& v, Face_index f) const
  {
    return std::abs(CGAL::Polygon_mesh_processing::compute_face_normal(f, mesh_) * v);
  }

  Mesh_locations locations;
  Path_totals totals;
  double scale; // of the coordinates
  double mean_edge;

private:
  template <class AnyGeodesic, class Query>
  void check_forms(const AnyGeodesic& geodesic, const Query& query, const Path_locations& path)
  {
    std::vector<Point_3> points;
    geodesic.shortest_path_points_to_sources(query, std::back_inserter(points));
    Sequence_collector sequence(mesh_);
    geodesic.shortest_path_sequence_to_sources(query, sequence);
    CHECK_DETAIL(points.size() == path.size(), values(double(points.size()), double(path.size())));
    CHECK_DETAIL(sequence.path.size() == path.size(), values(double(sequence.path.size()), double(path.size())));
    for (std::size_t i = 0; i < (std::min)(points.size(), path.size()); ++i)
      CHECK(distance(points[i], point(path[i])) <= 1e-14 * scale);
    for (std::size_t i = 0; i < (std::min)(sequence.path.size(), path.size()); ++i)
      CHECK(distance(point(sequence.path[i]), point(path[i])) <= 1e-13 * scale);
    // only the ends can lie inside a face
    CHECK(sequence.faces <= 2);
    if (std::is_same<Query, Vertex_index>::value && !path.empty()) CHECK(sequence.vertices >= 1);
  }

  void check_connected(const Path_locations& path) const
  {
    CHECK(is_connected(path));
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      CHECK_DETAIL(!is_same(snapped(path[i]), snapped(path[i + 1])),
                   "points " + std::to_string(i) + " and the next of " + std::to_string(path.size()));
  }

  void check_gradient(const Vector_3& gradient, const Path_locations& path) const
  {
    if (path.size() < 2)
    {
      CHECK(gradient == CGAL::NULL_VECTOR);
      return;
    }
    CHECK_DETAIL(std::abs(gradient.squared_length() - 1) <= 1e-12, values(gradient.squared_length(), 1));
    const Vector_3 start = point(path[1]) - point(path[0]);
    const double length = std::sqrt(start.squared_length());
    if (length < 1e-5 * scale) return;
    const double error = std::sqrt((gradient + start / length).squared_length());
    // a path within about 1e-9 edges of a vertex may pass through the vertex
    const double allowed = is_at_vertex(snapped(path[1])) ? 1e-9 + 4e-9 * mean_edge / length : 1e-9;
    CHECK_DETAIL(error <= allowed, values(error, 0));
  }

  const Surface_mesh& mesh_;
};

/// Source of any kind, which can be added to several objects.
struct Any_source
{
  Path_locations locations; // one location: a point
  bool closed;

  std::size_t add_to(Geodesic& geodesic) const
  {
    return locations.size() == 1 ? geodesic.add_source_point(locations.front())
                                 : geodesic.add_source_polyline(locations, CGAL::parameters::is_closed(closed));
  }
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_PATH_TOOLS_H
