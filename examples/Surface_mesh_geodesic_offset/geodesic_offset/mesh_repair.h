// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Changes to a mesh that leave the surface as it is: what the solver needs and files often do not give.

#ifndef GEODESIC_OFFSET_MESH_REPAIR_H
#define GEODESIC_OFFSET_MESH_REPAIR_H

#include "common.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace geodesic_offset {

// Surface_mesh does not notice when two fans of faces share a vertex. Expects a mesh without garbage.
inline bool has_pinched_vertex(const Mesh& mesh)
{
  std::vector<std::uint32_t> degree(mesh.number_of_vertices(), 0);
  for(Halfedge h : mesh.halfedges())
    ++degree[mesh.target(h)];
  for(Vertex v : mesh.vertices())
  {
    if(mesh.is_isolated(v))
      continue;
    const Halfedge first = mesh.halfedge(v);
    Halfedge h = first;
    do
    {
      --degree[v];
      h = mesh.opposite(mesh.next(h));
    } while(h != first);
    if(degree[v] != 0)
      return true;
  }
  return false;
}

inline std::size_t number_of_border_edges(const Mesh& mesh)
{
  const auto edges = mesh.edges();
  return static_cast<std::size_t>(
    std::count_if(edges.begin(), edges.end(), [&](Edge e) { return mesh.is_border(e); }));
}

// Whether two border edges lie at the same place
inline bool has_double_border(const Mesh& mesh)
{
  std::vector<std::pair<Point, Point>> borders;
  for(Edge e : mesh.edges())
    if(mesh.is_border(e))
    {
      Point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
      if(q < p)
        std::swap(p, q);
      borders.emplace_back(p, q);
    }
  std::sort(borders.begin(), borders.end());
  return std::adjacent_find(borders.begin(), borders.end()) != borders.end();
}

// Joins border edges that lie at the same place. Returns the number of pairs. Numbers of faces do not change.
inline std::size_t stitch(Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  if(!has_double_border(mesh))
    return 0;
  const std::size_t before = number_of_border_edges(mesh);
  PMP::stitch_borders(mesh);
  // parts with opposite orientations, such as the loose triangles of an unoriented soup
  if(has_double_border(mesh))
    PMP::merge_reversible_connected_components(mesh);
  const std::size_t after = number_of_border_edges(mesh);
  mesh.collect_garbage();
  return (before - after) / 2;
}

inline std::vector<Face> degenerate_faces(const Mesh& mesh)
{
  std::vector<Face> faces;
  for(Face f : mesh.faces())
    if(CGAL::Polygon_mesh_processing::is_degenerate_triangle_face(f, mesh))
      faces.push_back(f);
  return faces;
}

// What no flip and no collapse may change: the numbers of parts and of borders, and the Euler characteristic
inline std::array<std::size_t, 3> shape_of(const Mesh& mesh)
{
  std::vector<std::size_t> part(mesh.num_faces());
  const auto map = CGAL::make_property_map(part);
  std::vector<Halfedge> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  return {CGAL::Polygon_mesh_processing::connected_components(mesh, map), borders.size(),
          mesh.number_of_vertices() + mesh.number_of_faces() - mesh.number_of_edges()};
}

// A face without area is a fold of the file and not of the surface. Flips of edges take it out and, where vertices lie at
// the same place, collapses. new_vertex[v] tells what became of v. Returns false if that did not work.
inline bool remove_degenerate_faces(Mesh& mesh, const std::vector<Face>& degenerate, std::vector<Vertex>& new_vertex)
{
  const auto shape = shape_of(mesh);
  auto old_vertex = mesh.add_property_map<Vertex, Vertex>("v:old").first;
  std::vector<Point> points(mesh.number_of_vertices());
  for(Vertex v : mesh.vertices())
  {
    old_vertex[v] = v;
    points[v] = mesh.point(v);
  }

  CGAL::Polygon_mesh_processing::remove_degenerate_faces(degenerate, mesh);
  for(Vertex v : mesh.vertices())
    if(mesh.is_isolated(v))
      mesh.remove_vertex(v);
  mesh.collect_garbage();
  if(mesh.number_of_faces() == 0 || has_pinched_vertex(mesh) || shape_of(mesh) != shape || !degenerate_faces(mesh).empty())
    return false;

  new_vertex.assign(points.size(), Mesh::null_vertex());
  std::map<Point, Vertex> at;
  for(Vertex v : mesh.vertices())
  {
    if(old_vertex[v] != Mesh::null_vertex())
      new_vertex[old_vertex[v]] = v;
    at.emplace(mesh.point(v), v);
  }
  mesh.remove_property_map(old_vertex);
  for(std::size_t v = 0; v < points.size(); ++v)
    if(new_vertex[v] == Mesh::null_vertex())
    {
      const auto it = at.find(points[v]);
      if(it == at.end())
        return false;
      new_vertex[v] = it->second;
    }
  return true;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_MESH_REPAIR_H
