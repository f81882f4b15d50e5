// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points of a mesh as face locations: at vertices, on edges, in faces; conversion between faces.

#ifndef GEODESIC_OFFSET_TEST_LOCATIONS_H
#define GEODESIC_OFFSET_TEST_LOCATIONS_H

#include "generated_soup.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace test {

/// Functions on face locations of a mesh. All are combinatorial: a location is on an edge or at a vertex if coordinates are
/// exactly zero.
template <class TriangleMesh>
class Locations
{
public:
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef std::array<double, 3> Barycentric_coordinates;
  typedef std::pair<face_descriptor, Barycentric_coordinates> Face_location;

  explicit Locations(const TriangleMesh& mesh) : mesh_(mesh) {}

  std::array<vertex_descriptor, 3> corners(face_descriptor f) const
  {
    const halfedge_descriptor h = halfedge(f, mesh_);
    return {{source(h, mesh_), target(h, mesh_), target(next(h, mesh_), mesh_)}};
  }

  /// The point with given weights at the soup's corners of a triangle. `Mesh_of_soup` has the vertices and faces of the mesh in the
  /// order of the soup.
  template <class Mesh_of_soup>
  Face_location in_triangle(const Mesh_of_soup& data, const Soup& soup, std::size_t triangle,
                            const Barycentric_coordinates& weights) const
  {
    Face_location result(data.faces[triangle], {{0, 0, 0}});
    const auto c = corners(result.first);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j)
        if (c[k] == data.vertices[soup.triangles[triangle][j]]) result.second[k] = weights[j];
    return result;
  }

  /// Vertices with nonzero weight: one at a vertex, two on an edge, three in a face.
  std::vector<std::pair<vertex_descriptor, double>> support(const Face_location& location) const
  {
    const std::array<vertex_descriptor, 3> c = corners(location.first);
    std::vector<std::pair<vertex_descriptor, double>> result;
    for (std::size_t k = 0; k < 3; ++k)
      if (location.second[k] != 0) result.push_back({c[k], location.second[k]});
    return result;
  }

  /// Converts the location to face `f` if all vertices with weight are corners of `f`.
  bool express(const Face_location& location, face_descriptor f, Barycentric_coordinates& result) const
  {
    if (location.first == f)
    {
      result = location.second;
      return true;
    }
    const std::array<vertex_descriptor, 3> c = corners(f);
    result = {{0, 0, 0}};
    for (const std::pair<vertex_descriptor, double>& s : support(location))
    {
      const auto found = std::find(c.begin(), c.end(), s.first);
      if (found == c.end()) return false;
      result[static_cast<std::size_t>(found - c.begin())] = s.second;
    }
    return true;
  }

  /// All faces whose closure contains the location.
  std::vector<face_descriptor> incident_faces(const Face_location& location) const
  {
    std::vector<face_descriptor> result;
    const vertex_descriptor v = support(location).front().first;
    Barycentric_coordinates ignored;
    for (halfedge_descriptor h : CGAL::halfedges_around_target(v, mesh_))
      if (!is_border(h, mesh_) && express(location, face(h, mesh_), ignored)) result.push_back(face(h, mesh_));
    return result;
  }

  /// A face that contains both locations, or the null face.
  face_descriptor common_face(const Face_location& a, const Face_location& b) const
  {
    Barycentric_coordinates ignored;
    if (a.first == b.first || express(b, a.first, ignored)) return a.first;
    for (face_descriptor f : incident_faces(a))
      if (express(b, f, ignored)) return f;
    return Graph_traits::null_face();
  }

  /// `v` as a corner of one of its faces, the `turn`-th around it.
  Face_location at_vertex(vertex_descriptor v, std::size_t turn = 0) const
  {
    std::vector<face_descriptor> around;
    for (halfedge_descriptor h : CGAL::halfedges_around_target(v, mesh_))
      if (!is_border(h, mesh_)) around.push_back(face(h, mesh_));
    Face_location result(around.at(turn % around.size()), Barycentric_coordinates{{0, 0, 0}});
    const std::array<vertex_descriptor, 3> c = corners(result.first);
    for (std::size_t k = 0; k < 3; ++k) result.second[k] = c[k] == v ? 1 : 0;
    return result;
  }

  /// The point (1 - t) source(h) + t target(h) in the face of h, which is not a border halfedge.
  Face_location on_edge(halfedge_descriptor h, double t) const
  {
    Face_location result(face(h, mesh_), Barycentric_coordinates{{0, 0, 0}});
    const std::array<vertex_descriptor, 3> c = corners(result.first);
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (c[k] == source(h, mesh_)) result.second[k] = 1 - t;
      if (c[k] == target(h, mesh_)) result.second[k] = t;
    }
    return result;
  }

  Point_3 point(const Face_location& location) const
  {
    const std::array<vertex_descriptor, 3> c = corners(location.first);
    const auto points = get(CGAL::vertex_point, mesh_);
    double xyz[3] = {0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) xyz[i] += location.second[k] * get(points, c[k])[i];
    return Point_3(xyz[0], xyz[1], xyz[2]);
  }

private:
  const TriangleMesh& mesh_;
};

/// Strictly inside the triangle, with all coordinates at least `margin` / (1 + 3 margin).
inline std::array<double, 3> random_barycentric(Random& random, double margin = 0.02)
{
  std::array<double, 3> result;
  double sum = 0;
  for (double& w : result)
  {
    w = margin - std::log(uniform(random, 1e-9, 1));
    sum += w;
  }
  for (double& w : result) w /= sum;
  return result;
}

template <class TriangleMesh>
double bounding_box_diagonal(const TriangleMesh& mesh)
{
  CGAL::Bbox_3 box;
  const auto points = get(CGAL::vertex_point, mesh);
  for (auto v : vertices(mesh)) box += get(points, v).bbox();
  return std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_LOCATIONS_H
