// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points on the surface, and the faces that share them.

#ifndef GEODESIC_OFFSET_LOCATION_H
#define GEODESIC_OFFSET_LOCATION_H

#include "common.h"

#include <CGAL/Polygon_mesh_processing/locate.h>

#include <algorithm>
#include <array>
#include <cstddef>
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

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_LOCATION_H
