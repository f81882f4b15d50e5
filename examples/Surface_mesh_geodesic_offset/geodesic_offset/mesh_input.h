// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// From points and polygons to a triangle mesh that the solver can work on: oriented, stitched, triangulated, without
// degenerate faces. The order of the file is kept track of, so that vertices can be named and listed as they stand there.

#ifndef GEODESIC_OFFSET_MESH_INPUT_H
#define GEODESIC_OFFSET_MESH_INPUT_H

#include "common.h"
#include "mesh_repair.h"
#include "polygon_triangles.h"
#include "soup_reader.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {

// The mesh and how it came from the file
class Mesh_input
{
  Soup                     m_soup;
  Mesh                     m_mesh;
  std::vector<std::string> m_remarks;
  double                   m_diagonal = 0;

  // The vertices of the mesh at a vertex of the file: none if no face uses it, several where the surface had to be cut
  std::vector<Vertex>                m_first_vertex;
  std::multimap<std::size_t, Vertex> m_further_vertices;

  // While the mesh is built: its faces, with the vertices of the file (names) and with those of the mesh to be (polygons).
  // Corners correspond.
  struct Faces
  {
    std::vector<std::size_t> positions; // in the file
    std::vector<Polygon>     names;
    std::vector<char>        is_reversed; // against the file
    std::vector<Point>       points;
    std::vector<Polygon>     polygons;
    std::vector<Vertex>      vertices; // of the points

    void add(std::size_t position, Polygon name)
    {
      positions.push_back(position);
      names.push_back(std::move(name));
      is_reversed.push_back(false);
    }
  };

public:
  // join_borders: whether border edges at the same place become one edge
  Mesh_input(const std::string& path, bool join_borders) : m_soup(read_soup(path)), m_remarks(m_soup.remarks)
  {
    measure(path);
    Faces faces;
    clean_polygons(path, faces);
    build(path, faces, join_borders);
    map_vertices(faces);
    triangulate(path, faces);
    remove_faces_without_area(path);
  }
  Mesh_input(Mesh_input&&) = default;
  Mesh_input(const Mesh_input&) = delete;
  Mesh_input& operator=(const Mesh_input&) = delete;

  const Soup& soup() const { return m_soup; }
  const Mesh& mesh() const { return m_mesh; }
  double      bounding_box_diagonal() const { return m_diagonal; }

  // What was changed, one line each
  const std::vector<std::string>& remarks() const { return m_remarks; }

  template <class Function>
  void for_each_vertex_of(std::size_t file_vertex, const Function& function) const
  {
    if(m_first_vertex[file_vertex] == Mesh::null_vertex())
      return;
    function(m_first_vertex[file_vertex]);
    const auto range = m_further_vertices.equal_range(file_vertex);
    for(auto it = range.first; it != range.second; ++it)
      function(it->second);
  }

private:
  void measure(const std::string& path)
  {
    CGAL::Bbox_3 box;
    for(const Point& p : m_soup.points)
      box += p.bbox();
    double square = 0;
    for(int c = 0; c < 3; ++c)
      square += (box.max(c) - box.min(c)) * (box.max(c) - box.min(c));
    m_diagonal = std::sqrt(square);
    // squares of lengths, and products of two of them, must stay within the range of double
    if(!(m_diagonal < 1e70) || (m_diagonal > 0 && m_diagonal < 1e-70))
      throw Input_error(quoted(path) + ": the coordinates are too " + (m_diagonal > 1 ? "large" : "small"));
    if(m_diagonal == 0)
      throw Input_error(quoted(path) + ": all vertices are at the same place");
  }

  // Removes repetitions of a vertex that follow each other. Returns whether a polygon is left.
  static bool clean(Polygon& polygon)
  {
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    while(polygon.size() > 1 && polygon.front() == polygon.back())
      polygon.pop_back();
    return polygon.size() >= 3;
  }

  static bool has_repetition(const Polygon& polygon)
  {
    if(polygon.size() == 3)
      return polygon[0] == polygon[1] || polygon[1] == polygon[2] || polygon[2] == polygon[0];
    Polygon sorted = polygon;
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  }

  void clean_polygons(const std::string& path, Faces& faces)
  {
    std::size_t repetitions = 0, first_repetition = 0, divided = 0, first_divided = 0;
    faces.names.reserve(m_soup.polygons.size());
    faces.positions.reserve(m_soup.polygons.size());
    faces.is_reversed.reserve(m_soup.polygons.size());
    for(std::size_t i = 0; i < m_soup.polygons.size(); ++i)
    {
      Polygon polygon = m_soup.polygons[i];
      const bool is_polygon = clean(polygon);
      if(polygon.size() != m_soup.polygons[i].size() && repetitions++ == 0)
        first_repetition = i;
      if(!is_polygon)
        continue;
      if(!has_repetition(polygon) && is_simple(polygon, m_soup.points))
      {
        faces.add(i, std::move(polygon));
        continue;
      }
      if(divided++ == 0)
        first_divided = i;
      for(Polygon& triangle : triangles_of(polygon, m_soup.points))
        if(!has_repetition(triangle))
          faces.add(i, std::move(triangle));
    }
    if(repetitions != 0)
      m_remarks.push_back(counted(repetitions, "face") + " with repeated vertices cleaned (the first is face " +
                          std::to_string(first_repetition) + ")");
    if(divided != 0)
      m_remarks.push_back(counted(divided, "face") + " not planar or not simple, divided into triangles all the same (the "
                          "first is face " + std::to_string(first_divided) + ")");
    if(faces.names.empty())
      throw Input_error(quoted(path) + ": no face has three different vertices");
  }

  void build(const std::string& path, Faces& faces, bool join_borders)
  {
    const std::size_t polygons_before = faces.names.size();
    faces.points = m_soup.points;
    faces.polygons = faces.names;
    std::size_t added = make_manifold(path, faces);
    const std::vector<Vertex> double_borders =
      join_borders ? vertices_of_double_borders(m_mesh) : std::vector<Vertex>();
    if(!double_borders.empty())
    {
      const std::size_t before = number_of_border_edges(m_mesh);
      merge(double_borders, faces);
      added = make_manifold(path, faces);
      const std::size_t after = number_of_border_edges(m_mesh);
      if(after < before)
        m_remarks.push_back(counted((before - after) / 2, "pair") + " of border edges stitched");
    }
    if(faces.names.size() != polygons_before)
      m_remarks.push_back(counted(polygons_before - faces.names.size(), "repeated face") + " left out");
    const auto reversed = std::count(faces.is_reversed.begin(), faces.is_reversed.end(), true);
    if(reversed != 0)
      m_remarks.push_back(counted(static_cast<std::size_t>(reversed), "face") + " reversed to orient the surface");
    if(added != 0)
      m_remarks.push_back("cut where it is not an orientable manifold: " + counted(added, "vertex", "vertices") + " added");
  }

  // Returns how many vertices had to be added.
  std::size_t make_manifold(const std::string& path, Faces& faces)
  {
    if(make_mesh(faces))
      return 0;
    drop_repeated_faces(faces);
    const std::vector<Polygon> before = faces.polygons;
    const std::size_t number_of_points = faces.points.size();
    CGAL::Polygon_mesh_processing::orient_polygon_soup(faces.points, faces.polygons);
    for(std::size_t i = 0; i < before.size(); ++i)
    {
      // vertices are the same as before or added ones at the same place
      bool same = true;
      for(std::size_t k = 0; k < before[i].size(); ++k)
      {
        const std::uint32_t v = faces.polygons[i][k], w = before[i][k];
        same = same && (v == w || (v >= number_of_points && faces.points[v] == faces.points[w]));
      }
      if(same)
        continue;
      std::reverse(faces.names[i].begin(), faces.names[i].end());
      faces.is_reversed[i] = !faces.is_reversed[i];
    }
    if(!make_mesh(faces))
      throw Input_error(quoted(path) + ": the faces cannot be made a manifold");
    return faces.points.size() - number_of_points;
  }

  // Returns whether the polygons are a manifold as they are. Much faster than to ask first.
  bool make_mesh(Faces& faces)
  {
    std::vector<bool> used(faces.points.size(), false);
    std::size_t corners = 0;
    for(const Polygon& polygon : faces.polygons)
    {
      for(std::uint32_t v : polygon)
        used[v] = true;
      corners += polygon.size();
    }
    m_mesh = Mesh();
    m_mesh.reserve(static_cast<Mesh::size_type>(faces.points.size()), static_cast<Mesh::size_type>(corners / 2 + 16),
                   static_cast<Mesh::size_type>(faces.polygons.size()));
    faces.vertices.assign(faces.points.size(), Mesh::null_vertex());
    for(std::size_t i = 0; i < faces.points.size(); ++i)
      if(used[i])
        faces.vertices[i] = m_mesh.add_vertex(faces.points[i]);
    std::vector<Vertex> vertices;
    for(const Polygon& polygon : faces.polygons)
    {
      vertices.clear();
      for(std::uint32_t v : polygon)
        vertices.push_back(faces.vertices[v]);
      if(m_mesh.add_face(vertices) == Mesh::null_face())
        return false;
    }
    return !has_pinched_vertex(m_mesh);
  }

  static void drop_repeated_faces(Faces& faces)
  {
    std::set<Polygon> seen;
    std::size_t kept = 0;
    for(std::size_t i = 0; i < faces.polygons.size(); ++i)
    {
      Polygon sorted = faces.polygons[i];
      std::sort(sorted.begin(), sorted.end());
      if(!seen.insert(std::move(sorted)).second)
        continue;
      std::swap(faces.polygons[kept], faces.polygons[i]);
      std::swap(faces.names[kept], faces.names[i]);
      faces.is_reversed[kept] = faces.is_reversed[i];
      faces.positions[kept++] = faces.positions[i];
    }
    faces.polygons.resize(kept);
    faces.names.resize(kept);
    faces.is_reversed.resize(kept);
    faces.positions.resize(kept);
  }

  // Makes one of those vertices that are at the same place. Parts that touch elsewhere are not connected by that.
  void merge(const std::vector<Vertex>& double_borders, Faces& faces) const
  {
    std::vector<bool> is_double(m_mesh.number_of_vertices(), false);
    for(Vertex v : double_borders)
      is_double[v] = true;
    std::map<Point, std::uint32_t> at;
    std::vector<std::uint32_t> merged(faces.points.size());
    for(std::uint32_t i = 0; i < merged.size(); ++i)
    {
      const Vertex v = faces.vertices[i];
      merged[i] = (v != Mesh::null_vertex() && is_double[v]) ? at.emplace(faces.points[i], i).first->second : i;
    }
    for(Polygon& polygon : faces.polygons)
    {
      Polygon result = polygon;
      for(std::uint32_t& v : result)
        v = merged[v];
      // a face with an edge of length zero keeps its own vertices, and will be dealt with as a degenerate one
      if(!has_repetition(result))
        polygon = std::move(result);
    }
  }

  void map_vertices(const Faces& faces)
  {
    m_first_vertex.assign(m_soup.points.size(), Mesh::null_vertex());
    for(std::size_t i = 0; i < faces.names.size(); ++i)
      for(std::size_t k = 0; k < faces.names[i].size(); ++k)
        add_vertex_of(faces.names[i][k], faces.vertices[faces.polygons[i][k]]);
  }

  void add_vertex_of(std::size_t file_vertex, Vertex vertex)
  {
    bool known = false;
    for_each_vertex_of(file_vertex, [&](Vertex v) { known = known || v == vertex; });
    if(known)
      return;
    if(m_first_vertex[file_vertex] == Mesh::null_vertex())
      m_first_vertex[file_vertex] = vertex;
    else
      m_further_vertices.emplace(file_vertex, vertex);
  }

  void triangulate(const std::string& path, const Faces& faces)
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    std::vector<Face> others;
    for(Face f : m_mesh.faces())
      if(!CGAL::is_triangle(m_mesh.halfedge(f), m_mesh))
        others.push_back(f);
    if(others.empty())
      return;
    for(Face f : others)
      if(!PMP::triangulate_face(f, m_mesh))
        throw Input_error(quoted(path) + ": face " + std::to_string(faces.positions[f]) + " cannot be triangulated");
    m_remarks.push_back(counted(others.size(), "face") + " with more than three vertices triangulated");
  }

  // Faces have no numbers of the file any more when they are looked at, but their vertices have.
  std::string name_of(Face face) const
  {
    std::vector<std::size_t> file_vertices;
    for(Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(face)))
    {
      file_vertices.push_back(static_cast<std::size_t>(
        std::find(m_first_vertex.begin(), m_first_vertex.end(), v) - m_first_vertex.begin()));
      for(const auto& entry : m_further_vertices)
        if(entry.second == v)
          file_vertices.back() = entry.first;
    }
    return "the face of the vertices " + std::to_string(file_vertices[0]) + ", " + std::to_string(file_vertices[1]) +
           " and " + std::to_string(file_vertices[2]);
  }

  void remove_faces_without_area(const std::string& path)
  {
    const std::vector<Face> degenerate = degenerate_faces(m_mesh);
    if(degenerate.empty())
      return;
    const std::string first = name_of(degenerate.front());
    std::vector<Vertex> new_vertex;
    if(!remove_degenerate_faces(m_mesh, degenerate, new_vertex))
      throw Input_error(quoted(path) + ": " + first + " has no area and cannot be removed");
    for(Vertex& v : m_first_vertex)
      if(v != Mesh::null_vertex())
        v = new_vertex[v];
    for(auto& entry : m_further_vertices)
      entry.second = new_vertex[entry.second];
    m_remarks.push_back(counted(degenerate.size(), "face") + " without area removed (the first is " + first + ")");
  }
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_MESH_INPUT_H
