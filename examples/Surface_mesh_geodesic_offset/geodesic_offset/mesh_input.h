// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// From points and polygons to a triangle mesh that the solver can work on: oriented, stitched, triangulated, without
// degenerate faces. The order of the file is kept track of, so that vertices can be named and listed as they stand there.

#ifndef GEODESIC_OFFSET_MESH_INPUT_H
#define GEODESIC_OFFSET_MESH_INPUT_H

#include "common.h"
#include "mesh_repair.h"
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

  // The file's vertex behind each vertex of the mesh before stitching; and a face of the mesh that has it.
  std::vector<std::size_t> m_origin;
  std::vector<Face>        m_witness;

  std::vector<std::size_t> m_face_of_polygon; // positions in the file of the polygons that became faces

public:
  explicit Mesh_input(const std::string& path) : m_soup(read_soup(path)) { build(path); }
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
  void build(const std::string& path)
  {
    measure(path);
    std::vector<Polygon> polygons = clean_polygons(path);
    m_origin.resize(m_soup.points.size());
    for(std::size_t i = 0; i < m_origin.size(); ++i)
      m_origin[i] = i;
    if(!make_mesh(m_soup.points, polygons))
      orient_and_make_mesh(path, std::move(polygons));
    if(const std::size_t pairs = stitch(m_mesh))
      m_remarks.push_back(counted(pairs, "pair") + " of border edges stitched");
    map_vertices();
    triangulate(path);
    remove_faces_without_area(path);
  }

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

  // Polygons that use a vertex several times in a row lose the repetitions; those that are then no polygons, and those
  // that are there twice, are left out.
  std::vector<Polygon> clean_polygons(const std::string& path)
  {
    std::vector<Polygon> polygons;
    polygons.reserve(m_soup.polygons.size());
    std::size_t repetitions = 0, first_repetition = 0;
    for(std::size_t i = 0; i < m_soup.polygons.size(); ++i)
    {
      Polygon polygon = m_soup.polygons[i];
      polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
      while(polygon.size() > 1 && polygon.front() == polygon.back())
        polygon.pop_back();
      if(polygon.size() != m_soup.polygons[i].size() && repetitions++ == 0)
        first_repetition = i;
      if(polygon.size() < 3)
        continue;
      if(polygon.size() > 3)
      {
        Polygon sorted = polygon;
        std::sort(sorted.begin(), sorted.end());
        if(std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
          throw Input_error(quoted(path) + ": face " + std::to_string(i) + " passes twice through one of its vertices");
      }
      polygons.push_back(std::move(polygon));
      m_face_of_polygon.push_back(i);
    }
    if(repetitions != 0)
      m_remarks.push_back(counted(repetitions, "face") + " with repeated vertices cleaned (the first is face " +
                          std::to_string(first_repetition) + ")");
    if(polygons.empty())
      throw Input_error(quoted(path) + ": no face has three different vertices");
    return polygons;
  }

  // Returns whether the polygons are a manifold as they are. Much faster than to ask first.
  bool make_mesh(const std::vector<Point>& points, const std::vector<Polygon>& polygons)
  {
    m_mesh.clear();
    std::vector<Vertex> vertices(points.size(), Mesh::null_vertex());
    std::size_t corners = 0;
    for(const Polygon& polygon : polygons)
    {
      for(std::uint32_t v : polygon)
        vertices[v] = Vertex(0);
      corners += polygon.size();
    }
    m_mesh.reserve(static_cast<Mesh::size_type>(points.size()), static_cast<Mesh::size_type>(corners / 2 + 16),
                   static_cast<Mesh::size_type>(polygons.size()));
    for(std::size_t i = 0; i < points.size(); ++i)
      if(vertices[i] != Mesh::null_vertex())
        vertices[i] = m_mesh.add_vertex(points[i]);

    m_witness.assign(points.size(), Mesh::null_face());
    std::vector<Vertex> face_vertices;
    for(const Polygon& polygon : polygons)
    {
      face_vertices.clear();
      for(std::uint32_t v : polygon)
        face_vertices.push_back(vertices[v]);
      const Face face = m_mesh.add_face(face_vertices);
      if(face == Mesh::null_face())
        return false;
      for(std::uint32_t v : polygon)
        m_witness[v] = face;
    }
    return !has_pinched_vertex(m_mesh);
  }

  void orient_and_make_mesh(const std::string& path, std::vector<Polygon> polygons)
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    std::vector<Point> points = m_soup.points;

    std::set<Polygon> seen;
    std::size_t kept = 0, reversed = 0;
    for(std::size_t i = 0; i < polygons.size(); ++i)
    {
      Polygon sorted = polygons[i];
      std::sort(sorted.begin(), sorted.end());
      if(!seen.insert(std::move(sorted)).second)
        continue;
      m_face_of_polygon[kept] = m_face_of_polygon[i];
      std::swap(polygons[kept++], polygons[i]);
    }
    if(kept != polygons.size())
      m_remarks.push_back(counted(polygons.size() - kept, "repeated face") + " left out");
    polygons.resize(kept);
    m_face_of_polygon.resize(kept);
    seen.clear();

    const std::vector<Polygon> before = polygons;
    PMP::orient_polygon_soup(points, polygons);

    m_origin.resize(points.size());
    for(std::size_t i = 0; i < polygons.size(); ++i)
    {
      const std::size_t n = polygons[i].size();
      bool same = true;
      for(std::size_t k = 0; k < n; ++k)
        same = same && (polygons[i][k] == before[i][k] || (polygons[i][k] >= m_soup.points.size() &&
                                                           points[polygons[i][k]] == points[before[i][k]]));
      if(!same)
        ++reversed;
      for(std::size_t k = 0; k < n; ++k)
        m_origin[polygons[i][k]] = before[i][same ? k : n - 1 - k];
    }
    if(reversed != 0)
      m_remarks.push_back(counted(reversed, "face") + " reversed to orient the surface");
    if(points.size() != m_soup.points.size())
      m_remarks.push_back(counted(points.size() - m_soup.points.size(), "vertex", "vertices") +
                          " added to cut the surface where it is not an orientable manifold");
    if(reversed == 0 && points.size() == m_soup.points.size() && kept == before.size())
      m_remarks.push_back("faces connected as a polygon soup");
    if(!make_mesh(points, polygons))
      throw Input_error(quoted(path) + ": the faces cannot be made a manifold");
  }

  void map_vertices()
  {
    m_first_vertex.assign(m_soup.points.size(), Mesh::null_vertex());
    for(std::size_t i = 0; i < m_witness.size(); ++i)
    {
      if(m_witness[i] == Mesh::null_face())
        continue;
      const std::size_t file_vertex = m_origin[i];
      const Vertex vertex = vertex_at(m_witness[i], m_soup.points[file_vertex]);
      bool known = false;
      for_each_vertex_of(file_vertex, [&](Vertex v) { known = known || v == vertex; });
      if(known)
        continue;
      if(m_first_vertex[file_vertex] == Mesh::null_vertex())
        m_first_vertex[file_vertex] = vertex;
      else
        m_further_vertices.emplace(file_vertex, vertex);
    }
    m_witness = std::vector<Face>();
    m_origin  = std::vector<std::size_t>();
  }

  Vertex vertex_at(Face face, const Point& point) const
  {
    for(Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(face)))
      if(m_mesh.point(v) == point)
        return v;
    return Mesh::null_vertex();
  }

  void triangulate(const std::string& path)
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
        throw Input_error(quoted(path) + ": face " + std::to_string(m_face_of_polygon[f]) + " cannot be triangulated");
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
