// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points on the surface: finding them, and the faces that share them.

#ifndef GEODESIC_OFFSET_LOCATOR_H
#define GEODESIC_OFFSET_LOCATOR_H

#include "common.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace geodesic_offset {

inline std::array<Vertex, 3> vertices_of(const Mesh& mesh, Face f)
{
  // the order of barycentric coordinates in Polygon_mesh_processing
  const Halfedge h = mesh.halfedge(f);
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
}

inline Point point_of(const Mesh& mesh, const Face_location& location)
{
  return CGAL::Polygon_mesh_processing::construct_point(location, mesh);
}

inline Face_location location_of(const Mesh& mesh, Vertex v)
{
  Face face = Mesh::null_face();
  for(Face f : mesh.faces_around_target(mesh.halfedge(v)))
    if(f != Mesh::null_face())
      face = f;
  const std::array<Vertex, 3> corners = vertices_of(mesh, face);
  Face_location location(face, {0, 0, 0});
  location.second[static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin())] = 1;
  return location;
}

// The point at a fraction of the way from the source to the target of an inner halfedge
inline Face_location location_on(const Mesh& mesh, Halfedge h, double fraction)
{
  const std::array<Vertex, 3> corners = vertices_of(mesh, mesh.face(h));
  const std::size_t i =
    static_cast<std::size_t>(std::find(corners.begin(), corners.end(), mesh.source(h)) - corners.begin());
  Face_location location(mesh.face(h), {0, 0, 0});
  location.second[i] = 1 - fraction;
  location.second[(i + 1) % 3] = fraction;
  return location;
}

// All faces that contain the point: one, two at an edge, a fan at a vertex
inline std::vector<Face> faces_of(const Mesh& mesh, const Face_location& location)
{
  const Halfedge h[3] = {mesh.halfedge(location.first), mesh.next(mesh.halfedge(location.first)),
                         mesh.prev(mesh.halfedge(location.first))};
  int zeros = 0, zero = 0, other = 0;
  for(int i = 0; i < 3; ++i)
    if(location.second[i] == 0)
      ++zeros, zero = i;
    else
      other = i;
  std::vector<Face> faces;
  if(zeros == 2)
  {
    for(Face f : mesh.faces_around_target(mesh.opposite(h[other])))
      if(f != Mesh::null_face())
        faces.push_back(f);
  }
  else
  {
    faces.push_back(location.first);
    if(zeros == 1)
    {
      const Face f = mesh.face(mesh.opposite(h[(zero + 1) % 3]));
      if(f != Mesh::null_face())
        faces.push_back(f);
    }
  }
  return faces;
}

inline bool share_a_face(const Mesh& mesh, const Face_location& a, const Face_location& b)
{
  const std::vector<Face> fa = faces_of(mesh, a), fb = faces_of(mesh, b);
  return std::find_first_of(fa.begin(), fa.end(), fb.begin(), fb.end()) != fa.end();
}

// Nearest points of the surface. The tree is built at the first question.
class Locator
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_NR >= 1060000000
  using Tree_traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
  using Tree_traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif
  using Tree = CGAL::AABB_tree<Tree_traits>;

  const Mesh&           m_mesh;
  std::unique_ptr<Tree> m_tree;

public:
  explicit Locator(const Mesh& mesh) : m_mesh(mesh) {}

  Face_location operator()(const Point& query)
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    if(!m_tree)
    {
      m_tree = std::make_unique<Tree>();
      PMP::build_AABB_tree(m_mesh, *m_tree);
    }
    return snapped(PMP::locate_with_AABB_tree(query, *m_tree, m_mesh));
  }

private:
  // A point that is a vertex or lies on an edge up to the rounding of its own coordinates is put there exactly: next to
  // it, the shortest paths beyond the vertex would start from a detour.
  Face_location snapped(Face_location location) const
  {
    const std::array<Vertex, 3> v = vertices_of(m_mesh, location.first);
    double size = 0, longest = 0;
    for(int i = 0; i < 3; ++i)
    {
      const Point& p = m_mesh.point(v[i]);
      size = std::max({size, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
      longest = std::max(longest, CGAL::to_double(CGAL::squared_distance(p, m_mesh.point(v[(i + 1) % 3]))));
    }
    const double area = std::sqrt(CGAL::squared_area(m_mesh.point(v[0]), m_mesh.point(v[1]), m_mesh.point(v[2])));
    const double altitude = 2 * area / std::sqrt(longest);
    const double rounding = 32 * std::numeric_limits<double>::epsilon() * std::max(size, altitude);

    double sum = 0;
    for(double& b : location.second)
    {
      if(!(b * altitude > rounding))
        b = 0;
      sum += b;
    }
    for(double& b : location.second)
      b /= sum;
    return location;
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_LOCATOR_H
