// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// An archetype of the graph concepts: a mesh with the types and functions of FaceListGraph and VertexListGraph, and no others. It
// has no property maps; the maps are named parameters. Its descriptors can be copied and compared for equality only.

#ifndef GEODESIC_OFFSET_TEST_MESH_ARCHETYPE_H
#define GEODESIC_OFFSET_TEST_MESH_ARCHETYPE_H

#include "generated_soup.h"

#include <CGAL/Iterator_range.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace mesh_archetype {

/// A descriptor; the tag tells kinds apart.
template <class Tag>
struct Descriptor
{
  Descriptor() = default;
  explicit Descriptor(std::size_t n) : number(n) {}

  std::size_t number = std::size_t(-1);

  friend bool operator==(const Descriptor& a, const Descriptor& b) { return a.number == b.number; }
  friend bool operator!=(const Descriptor& a, const Descriptor& b) { return a.number != b.number; }
};

typedef Descriptor<struct Vertex_tag> Vertex;
typedef Descriptor<struct Halfedge_tag> Halfedge;
typedef Descriptor<struct Edge_tag> Edge;
typedef Descriptor<struct Face_tag> Face;

/// The halfedges of edge e are 2 e and 2 e + 1.
class Mesh
{
public:
  explicit Mesh(const test::Soup& soup) : points_(soup.points), out_(soup.points.size(), none)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> number;
    const auto halfedge_between = [&](std::size_t a, std::size_t b) {
      const auto known = number.find({a, b});
      if (known != number.end()) return known->second;
      const std::size_t h = target_.size();
      number[{a, b}] = h;
      number[{b, a}] = h + 1;
      target_.insert(target_.end(), {b, a});
      next_.resize(h + 2, none);
      face_.resize(h + 2, none);
      return h;
    };
    for (std::size_t v = 0; v < soup.points.size(); ++v) vertices_.push_back(Vertex(v));
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    {
      const auto& t = soup.triangles[f];
      faces_.push_back(Face(f));
      std::size_t h[3];
      for (std::size_t k = 0; k < 3; ++k)
      {
        h[k] = halfedge_between(t[k], t[(k + 1) % 3]);
        face_[h[k]] = f;
        out_[t[k]] = h[k];
      }
      for (std::size_t k = 0; k < 3; ++k) next_[h[k]] = h[(k + 1) % 3];
      of_face_.push_back(h[0]);
    }
    // border halfedges, at vertices with one fan
    std::map<std::size_t, std::size_t> border_from;
    for (std::size_t h = 0; h < target_.size(); ++h)
      if (face_[h] == none) border_from[target_[h ^ 1]] = h;
    for (std::size_t h = 0; h < target_.size(); ++h)
      if (face_[h] == none)
      {
        next_[h] = border_from.at(target_[h]);
        out_[target_[h ^ 1]] = h;
      }
    previous_.resize(next_.size());
    for (std::size_t h = 0; h < next_.size(); ++h) previous_[next_[h]] = h;
  }

  const test::Point_3& point(Vertex v) const { return points_[v.number]; }

  friend CGAL::Iterator_range<std::vector<Vertex>::const_iterator> vertices(const Mesh& m)
  {
    return CGAL::make_range(m.vertices_.begin(), m.vertices_.end());
  }
  friend CGAL::Iterator_range<std::vector<Face>::const_iterator> faces(const Mesh& m)
  {
    return CGAL::make_range(m.faces_.begin(), m.faces_.end());
  }
  friend std::size_t num_vertices(const Mesh& m) { return m.vertices_.size(); }
  friend std::size_t num_faces(const Mesh& m) { return m.faces_.size(); }

  friend Halfedge halfedge(Vertex v, const Mesh& m) { return Halfedge(m.out_[v.number] ^ 1); }
  friend Halfedge halfedge(Edge e, const Mesh&) { return Halfedge(2 * e.number); }
  friend Halfedge halfedge(Face f, const Mesh& m) { return Halfedge(m.of_face_[f.number]); }
  friend Edge edge(Halfedge h, const Mesh&) { return Edge(h.number / 2); }
  friend Face face(Halfedge h, const Mesh& m) { return Face(m.face_[h.number]); }
  friend Halfedge opposite(Halfedge h, const Mesh&) { return Halfedge(h.number ^ 1); }
  friend Halfedge next(Halfedge h, const Mesh& m) { return Halfedge(m.next_[h.number]); }
  friend Halfedge prev(Halfedge h, const Mesh& m) { return Halfedge(m.previous_[h.number]); }
  friend Vertex target(Halfedge h, const Mesh& m) { return Vertex(m.target_[h.number]); }
  friend Vertex source(Halfedge h, const Mesh& m) { return Vertex(m.target_[h.number ^ 1]); }
  friend std::size_t degree(Face, const Mesh&) { return 3; }

private:
  static constexpr std::size_t none = std::size_t(-1);

  std::vector<test::Point_3> points_;
  std::vector<Vertex> vertices_;
  std::vector<Face> faces_;
  std::vector<std::size_t> out_, of_face_;                   // halfedges
  std::vector<std::size_t> target_, face_, next_, previous_; // of halfedges
};

/// The number of an element.
class Index_map
{
public:
  typedef std::size_t value_type;
  typedef std::size_t reference;
  typedef boost::readable_property_map_tag category;

  template <class Tag>
  friend std::size_t get(const Index_map&, const Descriptor<Tag>& d)
  {
    return d.number;
  }
};
struct Vertex_index_map : Index_map
{
  typedef Vertex key_type;
};
struct Face_index_map : Index_map
{
  typedef Face key_type;
};

struct Point_map
{
  typedef Vertex key_type;
  typedef test::Point_3 value_type;
  typedef const test::Point_3& reference;
  typedef boost::readable_property_map_tag category;

  const Mesh* mesh;

  friend const test::Point_3& get(const Point_map& map, Vertex v) { return map.mesh->point(v); }
};

} // namespace mesh_archetype

namespace boost {

template <>
struct graph_traits<mesh_archetype::Mesh>
{
  typedef mesh_archetype::Vertex vertex_descriptor;
  typedef mesh_archetype::Halfedge halfedge_descriptor;
  typedef mesh_archetype::Edge edge_descriptor;
  typedef mesh_archetype::Face face_descriptor;
  typedef std::vector<vertex_descriptor>::const_iterator vertex_iterator;
  typedef std::vector<face_descriptor>::const_iterator face_iterator;
  typedef std::size_t vertices_size_type;
  typedef std::size_t faces_size_type;
  typedef std::size_t degree_size_type;
  typedef undirected_tag directed_category;
  typedef disallow_parallel_edge_tag edge_parallel_category;
  typedef vertex_list_graph_tag traversal_category;

  static vertex_descriptor null_vertex() { return vertex_descriptor(); }
  static halfedge_descriptor null_halfedge() { return halfedge_descriptor(); }
  static face_descriptor null_face() { return face_descriptor(); }
};

} // namespace boost

#endif // GEODESIC_OFFSET_TEST_MESH_ARCHETYPE_H
