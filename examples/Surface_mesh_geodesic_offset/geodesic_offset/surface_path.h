// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The shortest path on the surface between two of its points, found on the part of the mesh that can contain it.
// The points of a curve are usually close to each other, so this part is small, whatever the size of the mesh.

#ifndef GEODESIC_OFFSET_SURFACE_PATH_H
#define GEODESIC_OFFSET_SURFACE_PATH_H

#include "common.h"
#include "location.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace geodesic_offset {

class Path_finder
{
  const Mesh& m_mesh;

public:
  explicit Path_finder(const Mesh& mesh) : m_mesh(mesh) {}

  // Appends the path without its first point, so that paths can follow each other. Returns false if there is no path.
  bool operator()(const Face_location& from, const Face_location& to, std::vector<Face_location>& path) const
  {
    if(share_a_face(m_mesh, from, to))
    {
      path.push_back(to);
      return true;
    }
    const double bound = length_along_edges(from, to) * (1 + 1e-9);
    if(bound == infinity)
      return false;

    const std::vector<Face> faces = faces_within(from, to, bound);
    std::vector<Face>              face_of_part;
    std::unordered_map<Face, Face> part_of_face;
    const Mesh part = extract(faces, face_of_part, part_of_face);

    Geodesic geodesic(part);
    geodesic.add_source_point(translate(m_mesh, to, part_of_face.at(to.first), part));
    geodesic.build(CGAL::parameters::distance_limit(bound).keep_windows(true));
    std::vector<Face_location> part_path;
    geodesic.shortest_path_to_sources(translate(m_mesh, from, part_of_face.at(from.first), part),
                                      std::back_inserter(part_path));
    Face_location last = from;
    for(std::size_t i = 1; i + 1 < part_path.size(); ++i)
    {
      last = translate(part, on_edge(part_path[i]), face_of_part[part_path[i].first], m_mesh);
      path.push_back(last);
    }
    if(!share_a_face(m_mesh, last, to))
      return false;
    path.push_back(to);
    return true;
  }

private:
  // An upper bound of the distance: a path of edges, with a straight piece inside the first and the last face
  double length_along_edges(const Face_location& from, const Face_location& to) const
  {
    const Point p = point_of(m_mesh, from), q = point_of(m_mesh, to);
    std::unordered_set<Vertex> goals;
    for(Face f : faces_of(m_mesh, to))
      for(Vertex v : vertices_of(m_mesh, f))
        goals.insert(v);

    using Entry = std::pair<double, Vertex>; // a lower bound of the length of a path through the vertex
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::unordered_map<Vertex, double> length;
    std::unordered_set<Vertex> done;
    const auto reach = [&](Vertex v, double l) {
      const auto inserted = length.emplace(v, l);
      if(!inserted.second && inserted.first->second <= l)
        return;
      inserted.first->second = l;
      queue.emplace(l + distance(m_mesh.point(v), q), v);
    };
    for(Face f : faces_of(m_mesh, from))
      for(Vertex v : vertices_of(m_mesh, f))
        reach(v, distance(p, m_mesh.point(v)));
    while(!queue.empty())
    {
      const Vertex v = queue.top().second;
      const double total = queue.top().first;
      queue.pop();
      if(!done.insert(v).second)
        continue;
      if(goals.count(v) != 0)
        return total;
      for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        reach(m_mesh.source(h), length[v] + distance(m_mesh.point(v), m_mesh.point(m_mesh.source(h))));
    }
    return infinity;
  }

  // All faces that a path of this length can pass: those that meet the ellipsoid round the two points, connected
  std::vector<Face> faces_within(const Face_location& from, const Face_location& to, double bound) const
  {
    const Point p = point_of(m_mesh, from), q = point_of(m_mesh, to);
    const auto can_pass = [&](Face f) {
      const std::array<Vertex, 3> v = vertices_of(m_mesh, f);
      const Kernel::Triangle_3 triangle(m_mesh.point(v[0]), m_mesh.point(v[1]), m_mesh.point(v[2]));
      return std::sqrt(CGAL::squared_distance(p, triangle)) + std::sqrt(CGAL::squared_distance(q, triangle)) <=
             bound * (1 + 1e-9);
    };
    std::vector<Face> faces;
    std::unordered_set<Face> seen, chosen;
    const auto visit = [&](Face f, bool always) {
      if(f == Mesh::null_face() || chosen.count(f) != 0)
        return;
      if(!always && !(seen.insert(f).second && can_pass(f)))
        return;
      chosen.insert(f);
      faces.push_back(f);
    };
    for(const Face_location& location : {from, to})
      for(Face f : faces_of(m_mesh, location))
        visit(f, true);
    for(std::size_t grown = 0; grown < faces.size();)
    {
      for(; grown < faces.size(); ++grown)
        for(Vertex v : vertices_of(m_mesh, faces[grown]))
          for(Face f : m_mesh.faces_around_target(m_mesh.halfedge(v)))
            visit(f, false);
      // a vertex where the part would be pinched gets all of its faces
      std::unordered_set<Vertex> looked_at;
      const std::vector<Face> current = faces;
      for(Face f : current)
        for(Vertex v : vertices_of(m_mesh, f))
          if(looked_at.insert(v).second && number_of_fans(v, chosen) > 1)
            for(Face g : m_mesh.faces_around_target(m_mesh.halfedge(v)))
              visit(g, true);
    }
    return faces;
  }

  std::size_t number_of_fans(Vertex v, const std::unordered_set<Face>& chosen) const
  {
    std::size_t fans = 0;
    for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if(chosen.count(m_mesh.face(h)) != 0 && chosen.count(m_mesh.face(m_mesh.opposite(h))) == 0)
        ++fans;
    return fans;
  }

  Mesh extract(const std::vector<Face>& faces, std::vector<Face>& face_of_part,
               std::unordered_map<Face, Face>& part_of_face) const
  {
    Mesh part;
    std::unordered_map<Vertex, Vertex> vertex;
    for(Face f : faces)
    {
      std::array<Vertex, 3> v = vertices_of(m_mesh, f);
      for(Vertex& w : v)
      {
        const auto inserted = vertex.emplace(w, Vertex());
        if(inserted.second)
          inserted.first->second = part.add_vertex(m_mesh.point(w));
        w = inserted.first->second;
      }
      part_of_face[f] = part.add_face(v[0], v[1], v[2]);
      face_of_part.push_back(f);
    }
    return part;
  }

  // Between its ends a path bends and crosses at edges and vertices only, whatever rounding makes of it.
  static Face_location on_edge(Face_location location)
  {
    *std::min_element(location.second.begin(), location.second.end()) = 0;
    double sum = 0;
    for(double& b : location.second)
    {
      if(b < 1e-14)
        b = 0;
      sum += b;
    }
    for(double& b : location.second)
      b /= sum;
    return location;
  }

  // The same location in the same triangle of the other mesh. Its vertices may come in another order there.
  static Face_location translate(const Mesh& mesh, const Face_location& location, Face other_face, const Mesh& other)
  {
    const std::array<Vertex, 3> v = vertices_of(mesh, location.first), w = vertices_of(other, other_face);
    int shift = 0;
    while(shift < 2 && !(mesh.point(v[0]) == other.point(w[shift]) && mesh.point(v[1]) == other.point(w[(shift + 1) % 3])))
      ++shift;
    Face_location result(other_face, {0, 0, 0});
    for(int i = 0; i < 3; ++i)
      result.second[(i + shift) % 3] = location.second[i];
    return result;
  }

  static double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_SURFACE_PATH_H
