// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// From points and polygons to a triangle mesh for the solver: oriented, stitched, triangulated, without degenerate faces.
// Tracks the order of the file, so that vertices can be named and listed as in the file.
//
// Rule for non-manifold vertices: if several fans of faces share a vertex, and each edge there has one face or two
// consistently oriented faces, the vertex is one point of the surface: paths pass through it between all fans, whether
// these are open or closed. If an edge has more than two faces, or two faces without a consistent orientation, the surface
// is cut along this edge, ends included, and no path crosses the cut.

#ifndef GEODESIC_OFFSET_MESH_INPUT_H
#define GEODESIC_OFFSET_MESH_INPUT_H

#include "common.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {

// The mesh, with its relation to the file.
class Mesh_input
{
  Soup m_soup;
  Mesh m_mesh;
  std::vector<std::string> m_remarks;
  std::string m_warning;
  double m_diagonal = 0;

  // Vertices of the mesh at a vertex of the file: none if no face uses it, several at a cut.
  std::vector<Vertex> m_first_vertex;
  std::multimap<std::size_t, Vertex> m_further_vertices;

  // Faces during the construction of the mesh, with the vertices of the file (names) and of the future mesh (polygons).
  // Corners correspond.
  struct Faces
  {
    std::vector<std::size_t> positions; // in the file
    std::vector<Polygon> names;
    std::vector<char> is_reversed; // against the file
    std::vector<Point> points;
    std::vector<Polygon> polygons;
    std::vector<Vertex> vertices; // of the points

    // Points added so that each has one fan, with the original point. Excludes points added by cuts.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> copies;

    void add(std::size_t position, Polygon name)
    {
      positions.push_back(position);
      names.push_back(std::move(name));
      is_reversed.push_back(false);
    }
  };

public:
  // join_borders: whether border edges at the same place become one edge.
  Mesh_input(const std::string& path, bool join_borders);
  Mesh_input(Mesh_input&&) = default;
  Mesh_input(const Mesh_input&) = delete;
  Mesh_input& operator=(const Mesh_input&) = delete;

  const Soup& soup() const { return m_soup; }
  const Mesh& mesh() const { return m_mesh; }
  double bounding_box_diagonal() const { return m_diagonal; }

  // Description of the changes, one line each.
  const std::vector<std::string>& remarks() const { return m_remarks; }

  // One line on a condition that changes the meaning of distances; empty if there is none.
  const std::string& warning() const { return m_warning; }

  template <class Function>
  void for_each_vertex_of(std::size_t file_vertex, const Function& function) const
  {
    if(m_first_vertex[file_vertex] == Mesh::null_vertex()) return;
    function(m_first_vertex[file_vertex]);
    const auto range = m_further_vertices.equal_range(file_vertex);
    for(auto it = range.first; it != range.second; ++it) function(it->second);
  }

private:
  using Vertex_pairs = std::vector<std::pair<Vertex, Vertex>>;

  // Called before the mesh is built.
  void require_memory_for_faces(const std::string& path) const;

  void measure(const std::string& path);

  // Removes consecutive repetitions of a vertex. Returns whether a polygon remains.
  static bool clean(Polygon& polygon);

  static bool has_repetition(const Polygon& polygon);

  void clean_polygons(const std::string& path, Faces& faces);

  void build(const std::string& path, Faces& faces, bool join_borders);

  // Gives each vertex one fan. Returns the number of vertices added along cuts.
  std::size_t make_manifold(const std::string& path, Faces& faces);

  // Finds the copies of points with several fans and without cuts, by comparing polygons before and after the orientation.
  // Returns their number.
  static std::size_t find_copies(Faces& faces, const std::vector<Polygon>& before, std::size_t number_of_points);

  // Whether the polygons have the same corners in the same order; points from number_of_points on are copies.
  static bool is_same(const Polygon& before, const Polygon& after, const std::vector<Point>& points,
                      std::size_t number_of_points);

  // Builds the mesh if the polygons are a manifold with one fan per vertex; returns whether they are. Much faster than a
  // separate test.
  bool make_mesh(Faces& faces);

  static void drop_repeated_faces(Faces& faces);

  // Merges vertices at the same place if they are in `double_borders`. Parts that only touch remain separate.
  void merge(const std::vector<Vertex>& double_borders, Faces& faces) const;

  void map_vertices(const Faces& faces);

  void triangulate(const std::string& path, const Faces& faces);

  // Named by vertices: at this stage faces no longer have their numbers of the file.
  std::string name_of(Face face) const;

  static Vertex_pairs pairs_of_vertices(const Faces& faces);

  void renumber_vertices(const std::vector<Vertex>& new_vertex);

  // Merges copies into one vertex.
  void join(const std::string& path, const Vertex_pairs& copies);

  void remove_faces_without_area(const std::string& path, Vertex_pairs& copies);

  void flip_flat_caps();

  // The vertices of a face may be collinear up to less than the rounding of its area.
  void require_area_in_doubles(const std::string& path) const;
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_MESH_INPUT_H
