// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The section of a mesh by a plane, as polylines on the surface.
// The sides of the vertices are decided exactly. So the section runs from face to face without gaps, whatever the position
// of the plane; only the coordinates of its points on the edges are rounded. Where the surface passes through the plane, the
// polylines have the positive side of the plane on their left.

#ifndef GEODESIC_OFFSET_PLANE_SECTION_H
#define GEODESIC_OFFSET_PLANE_SECTION_H

#include "common.h"
#include "location.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace geodesic_offset {

struct Surface_polyline
{
  std::vector<Face_location> locations;
  bool                       closed = false; // then the first location is not repeated
};

struct Plane_section
{
  std::vector<Surface_polyline> polylines;
  std::vector<Vertex>           touched_vertices; // where the plane only touches the surface
  std::size_t                   faces_in_plane = 0;
};

class Plane_cutter
{
  // A point of the section: a vertex in the plane, or the crossing of an edge
  struct Node
  {
    Face_location            location;
    std::vector<std::size_t> segments;
  };

  const Mesh&                                    m_mesh;
  Kernel::Plane_3                                m_plane;
  std::vector<signed char>                       m_side;
  std::vector<Node>                              m_nodes;
  std::vector<std::array<std::size_t, 2>>        m_segments;
  std::unordered_map<std::size_t, std::size_t>   m_node_of_edge;
  std::unordered_map<std::size_t, std::size_t>   m_node_of_vertex;

public:
  Plane_cutter(const Mesh& mesh, const std::array<double, 4>& plane)
    : m_mesh(mesh), m_plane(plane[0], plane[1], plane[2], plane[3]), m_side(mesh.number_of_vertices(), 0)
  {}

  Plane_section operator()()
  {
    for(Vertex v : m_mesh.vertices())
      m_side[v] = static_cast<signed char>(m_plane.oriented_side(m_mesh.point(v)));

    Plane_section section;
    for(Face f : m_mesh.faces())
      section.faces_in_plane += cut(f);
    // an edge in the plane belongs to the section unless it lies inside a part of the surface that is in the plane
    for(Edge e : m_mesh.edges())
    {
      const Halfedge h = m_mesh.halfedge(e);
      if(m_side[m_mesh.source(h)] == 0 && m_side[m_mesh.target(h)] == 0 && !(in_plane(h) && in_plane(m_mesh.opposite(h))))
      {
        const Halfedge along = (left_side(h) >= left_side(m_mesh.opposite(h))) ? h : m_mesh.opposite(h);
        add_segment(node_of(m_mesh.source(along)), node_of(m_mesh.target(along)));
      }
    }
    for(Vertex v : m_mesh.vertices())
      if(m_side[v] == 0 && !m_mesh.is_isolated(v) && m_node_of_vertex.count(v) == 0 && !is_inside_plane(v))
        section.touched_vertices.push_back(v);
    chain(section.polylines);
    return section;
  }

private:
  bool in_plane(Halfedge h) const
  {
    return !m_mesh.is_border(h) && m_side[m_mesh.source(h)] == 0 && m_side[m_mesh.target(h)] == 0 &&
           m_side[m_mesh.target(m_mesh.next(h))] == 0;
  }

  // The side of the face left of a halfedge in the plane; 0 if the face is in the plane or there is none
  int left_side(Halfedge h) const { return m_mesh.is_border(h) ? 0 : m_side[m_mesh.target(m_mesh.next(h))]; }

  bool is_inside_plane(Vertex v) const
  {
    for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if(in_plane(h))
        return true;
    return false;
  }

  std::size_t node_of(Vertex v)
  {
    const auto inserted = m_node_of_vertex.emplace(v, m_nodes.size());
    if(inserted.second)
      m_nodes.push_back({location_of(m_mesh, v), {}});
    return inserted.first->second;
  }

  std::size_t node_of(Halfedge h)
  {
    const auto inserted = m_node_of_edge.emplace(m_mesh.edge(h), m_nodes.size());
    if(inserted.second)
    {
      if(m_mesh.is_border(h))
        h = m_mesh.opposite(h);
      const Exact_value a = value(m_mesh.source(h)), b = value(m_mesh.target(h));
      // rounding must not move the point into a vertex: that would be another node
      const double epsilon = std::numeric_limits<double>::epsilon();
      const double t = std::min(std::max(CGAL::to_double(Exact_value(a / (a - b))), epsilon / 2), 1 - epsilon / 2);
      m_nodes.push_back({location_on(m_mesh, h, t), {}});
    }
    return inserted.first->second;
  }

  using Exact_value = CGAL::Exact_rational;

  Exact_value value(Vertex v) const
  {
    const Point& p = m_mesh.point(v);
    return Exact_value(m_plane.a()) * Exact_value(p.x()) + Exact_value(m_plane.b()) * Exact_value(p.y()) +
           Exact_value(m_plane.c()) * Exact_value(p.z()) + Exact_value(m_plane.d());
  }

  void add_segment(std::size_t a, std::size_t b)
  {
    m_nodes[a].segments.push_back(m_segments.size());
    m_nodes[b].segments.push_back(m_segments.size());
    m_segments.push_back({a, b});
  }

  // The segment inside a face with vertices on both sides. Returns 1 for a face in the plane.
  std::size_t cut(Face f)
  {
    std::vector<std::size_t> ends; // where the boundary of the face goes down is the start
    bool is_down = false;          // of the first end
    int zeros = 0;
    for(Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
    {
      const int s = m_side[m_mesh.source(h)], t = m_side[m_mesh.target(h)];
      zeros += (t == 0);
      if(s * t >= 0)
        continue;
      if(ends.empty())
        is_down = (s > 0);
      ends.push_back(node_of(h));
    }
    if(ends.size() == 1)
      for(Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
        if(m_side[v] == 0)
          ends.push_back(node_of(v));
    if(ends.size() == 2)
      add_segment(ends[is_down ? 0 : 1], ends[is_down ? 1 : 0]);
    return zeros == 3 ? 1 : 0;
  }

  // Polylines from branching point to branching point or end; then the closed ones that remain.
  void chain(std::vector<Surface_polyline>& polylines)
  {
    std::vector<bool> used(m_segments.size(), false);
    for(std::size_t n = 0; n < m_nodes.size(); ++n)
      if(m_nodes[n].segments.size() != 2)
        for(std::size_t s : m_nodes[n].segments)
          if(!used[s])
            polylines.push_back(walk(n, s, used));
    for(std::size_t s = 0; s < m_segments.size(); ++s)
      if(!used[s])
        polylines.push_back(walk(m_segments[s][0], s, used));
  }

  Surface_polyline walk(const std::size_t first, std::size_t segment, std::vector<bool>& used) const
  {
    Surface_polyline polyline;
    const bool is_backward = (m_segments[segment][0] != first);
    std::size_t node = first;
    for(;;)
    {
      polyline.locations.push_back(m_nodes[node].location);
      used[segment] = true;
      node = m_segments[segment][m_segments[segment][0] == node ? 1 : 0];
      if(node == first || m_nodes[node].segments.size() != 2)
        break;
      const std::vector<std::size_t>& both = m_nodes[node].segments;
      segment = both[both[0] == segment ? 1 : 0];
    }
    polyline.closed = (node == first);
    if(!polyline.closed)
      polyline.locations.push_back(m_nodes[node].location);
    if(is_backward)
      std::reverse(polyline.locations.begin(), polyline.locations.end());
    return polyline;
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_PLANE_SECTION_H
