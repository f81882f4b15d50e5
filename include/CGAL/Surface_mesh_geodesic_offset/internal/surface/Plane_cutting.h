// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The section of the mesh by a plane. The kernel decides once per vertex on which side of the plane it lies. So the section
// runs from face to face without gaps for every plane; only the positions of its points on edges are rounded.
//
// A segment of the section has a direction if the surface is higher on one of its sides than on the other, in the order
// negative, in the plane, positive; a side without a face counts as in the plane. The higher side is on the left. Polylines
// consist of directed segments. Edges whose sides are equal are touched edges, without a direction.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_PLANE_CUTTING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_PLANE_CUTTING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_plane_section.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Geodesic_surface.h>

#include <CGAL/assertions.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class Surface, class Plane_3>
class Plane_cutting
{
  typedef typename Surface::FT FT;
  typedef typename Surface::Number Number;
  typedef typename Surface::Face_location Face_location;

public:
  typedef Geodesic_plane_section<Face_location, typename Surface::vertex_descriptor, typename Surface::edge_descriptor> Section;

  Plane_cutting(const Surface& surface, const Plane_3& plane)
    : m_surface(surface), m_mesh(surface.unfolded.without_barriers()), m_plane(plane), m_side(m_mesh.number_of_vertices(), 0),
      m_has_more(m_mesh.number_of_vertices(), 0)
  {
  }

  Section operator()()
  {
    for (Index v = 0; v < m_side.size(); ++v)
      if (m_mesh.corner(v) != no_index)
        m_side[v] = static_cast<signed char>(m_plane.oriented_side(m_surface.position(m_surface.vertex_of[v])));
    Section section;
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
      if (m_mesh.source(3 * f) != no_index) section.number_of_faces_in_plane += cut(f);
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.source(h) != no_index && h == first_of_edge(h)) add_edge_in_plane(h, section.touched_edges);
    for (Index v = 0; v < m_side.size(); ++v)
      if (m_mesh.corner(v) != no_index && m_side[v] == 0 && !m_has_more[v])
        section.touched_vertices.push_back(m_surface.vertex_of[v]);
    chain(section.polylines);
    return section;
  }

private:
  // A point of the section: a vertex in the plane, or the crossing of an edge.
  struct Node
  {
    Face_location location;
    std::vector<std::size_t> in, out; // segments that end and start here

    bool is_passed() const { return in.size() == 1 && out.size() == 1; }
  };

  struct Segment
  {
    std::size_t from, to; // nodes
  };

  // One halfedge per edge.
  Index first_of_edge(Index h) const { return (std::min)(h, m_mesh.twin(h)); }

  int side_of_source(Index h) const { return m_side[m_mesh.source(h)]; }
  int side_of_target(Index h) const { return m_side[m_mesh.target(h)]; }

  // Adds the segment inside a face with vertices on both sides. Returns 1 for a face in the plane, otherwise 0.
  std::size_t cut(Index f)
  {
    std::vector<std::size_t> ends; // the segment starts where the face boundary goes to the negative side
    bool is_down = false;          // at the first end
    int zeros = 0;
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const int s = side_of_source(h), t = side_of_target(h);
      zeros += s == 0;
      if (s * t >= 0) continue;
      if (ends.empty()) is_down = s > 0;
      ends.push_back(node_on_edge(first_of_edge(h)));
    }
    if (zeros == 3)
    {
      for (Index h = 3 * f; h < 3 * f + 3; ++h) m_has_more[m_mesh.source(h)] = 1;
      return 1;
    }
    if (ends.size() == 1)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (side_of_source(h) == 0) ends.push_back(node_at_vertex(m_mesh.source(h)));
    CGAL_assertion(ends.size() <= 2);
    if (ends.size() == 2) add_segment(ends[is_down ? 0 : 1], ends[is_down ? 1 : 0]);
    return 0;
  }

  // Adds an edge in the plane, except inside a part of the surface that lies in the plane.
  template <class Edges>
  void add_edge_in_plane(Index h, Edges& touched)
  {
    if (side_of_source(h) != 0 || side_of_target(h) != 0) return;
    const Index g = m_mesh.twin(h), from = m_mesh.source(h), to = m_mesh.target(h);
    const int left = m_side[m_mesh.apex(h)], right = g == no_index ? 0 : m_side[m_mesh.apex(g)];
    if (left > right) return add_segment(node_at_vertex(from), node_at_vertex(to));
    if (left < right) return add_segment(node_at_vertex(to), node_at_vertex(from));
    if (left == 0 && g != no_index) return;
    m_has_more[from] = m_has_more[to] = 1;
    touched.push_back(edge(m_surface.halfedge_of(h), m_surface.tm));
  }

  std::size_t node_at_vertex(Index v)
  {
    const auto [it, is_new] = m_node_of_vertex.emplace(v, m_nodes.size());
    if (is_new) m_nodes.push_back({m_surface.location(Surface_point<Number>::at_vertex(v)), {}, {}});
    m_has_more[v] = 1;
    return it->second;
  }

  std::size_t node_on_edge(Index h)
  {
    const auto [it, is_new] = m_node_of_edge.emplace(h, m_nodes.size());
    if (is_new) m_nodes.push_back({m_surface.location_on(h, part_of(h)), {}, {}});
    return it->second;
  }

  // Crossing of a halfedge with the plane, as a fraction of its length. Rounding must not move it to a vertex, which is another
  // node.
  FT part_of(Index h) const
  {
    typedef std::conditional_t<std::is_same<FT, double>::value || std::is_same<FT, float>::value, Exact_rational, FT> Exact;
    const Exact a = height<Exact>(m_mesh.source(h)), b = height<Exact>(m_mesh.target(h));
    if constexpr (!Number_policy<FT>::is_inexact) return a / (a - b);
    else
    {
      const FT low = Number_policy<FT>::rounding(0.5), t = rounded(Exact(a / (a - b)));
      return t > low ? (std::min)(t, FT(FT(1) - low)) : low; // a and b differ in exact numbers
    }
  }

  static FT rounded(const Exact_rational& x) { return FT(CGAL::to_double(x)); }
  template <class Exact>
  static std::enable_if_t<!std::is_same<Exact, Exact_rational>::value, FT> rounded(const Exact& x)
  {
    return x;
  }

  template <class Exact>
  Exact height(Index v) const
  {
    const auto p = m_surface.position(m_surface.vertex_of[v]);
    return Exact(m_plane.a()) * Exact(p.x()) + Exact(m_plane.b()) * Exact(p.y()) + Exact(m_plane.c()) * Exact(p.z()) +
           Exact(m_plane.d());
  }

  void add_segment(std::size_t from, std::size_t to)
  {
    CGAL_precondition(from != to);
    m_nodes[from].out.push_back(m_segments.size());
    m_nodes[to].in.push_back(m_segments.size());
    m_segments.push_back({from, to});
  }

  // Chains segments: first polylines between nodes that are ends or junctions, then the remaining closed ones.
  void chain(std::vector<Geodesic_polyline<Face_location>>& polylines) const
  {
    std::vector<char> is_used(m_segments.size(), 0);
    for (const Node& n : m_nodes)
      if (!n.is_passed())
        for (std::size_t s : n.out) polylines.push_back(walk(s, is_used));
    for (std::size_t s = 0; s < m_segments.size(); ++s)
      if (!is_used[s]) polylines.push_back(walk(s, is_used));
  }

  Geodesic_polyline<Face_location> walk(std::size_t segment, std::vector<char>& is_used) const
  {
    Geodesic_polyline<Face_location> polyline;
    const std::size_t first = m_segments[segment].from;
    for (;;)
    {
      CGAL_assertion(!is_used[segment]);
      is_used[segment] = 1;
      polyline.locations.push_back(m_nodes[m_segments[segment].from].location);
      const std::size_t n = m_segments[segment].to;
      polyline.is_closed = n == first;
      if (polyline.is_closed) return polyline;
      if (!m_nodes[n].is_passed())
      {
        polyline.locations.push_back(m_nodes[n].location);
        return polyline;
      }
      segment = m_nodes[n].out.front();
    }
  }

  const Surface& m_surface;
  const Unfolded_mesh<Number>& m_mesh;
  const Plane_3& m_plane;
  std::vector<signed char> m_side; // per vertex
  std::vector<char> m_has_more;    // per vertex: true if an edge or a face there belongs to the section
  std::vector<Node> m_nodes;
  std::vector<Segment> m_segments;
  std::unordered_map<Index, std::size_t> m_node_of_edge, m_node_of_vertex;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
