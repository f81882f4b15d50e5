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

#include "border_stitching.h"
#include "common.h"
#include "polygon_links.h"
#include "surface_parts.h"

#include <CGAL/Bbox_3.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {

// Whether no path crosses an edge.
struct Barrier_map
{
  using key_type = Edge;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  const std::vector<bool>* is_barrier; // by edge

  friend bool get(const Barrier_map& map, Edge e) { return (*map.is_barrier)[e]; }
};

// The mesh, with its relation to the file.
class Mesh_input
{
  Soup m_soup;
  Mesh m_mesh;
  std::vector<std::string> m_remarks;
  std::string m_warning;
  CGAL::Bbox_3 m_box;
  double m_diagonal = 0;
  Surface_parts m_parts;
  std::vector<bool> m_is_barrier; // by edge; empty: none is
  bool m_is_region = false; // whether faces were removed

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

    // For each vertex of the file the point with which it was merged, itself if with none; empty: all are themselves.
    std::vector<std::uint32_t> merged;

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
  // Throws Input_error.
  Mesh_input(const std::string& path, const Border_joining& joining);

  // `path`: for messages.
  Mesh_input(const std::string& path, Soup soup, const Border_joining& joining);
  Mesh_input(Mesh_input&&) = default;
  Mesh_input(const Mesh_input&) = delete;
  Mesh_input& operator=(const Mesh_input&) = delete;

  const Soup& soup() const { return m_soup; }
  const Mesh& mesh() const { return m_mesh; }

  // Of the vertices with faces.
  const CGAL::Bbox_3& bounding_box() const { return m_box; }
  double bounding_box_diagonal() const { return m_diagonal; }

  const Surface_parts& parts() const { return m_parts; }

  // Description of the changes, one line each.
  const std::vector<std::string>& remarks() const { return m_remarks; }

  // One line on a condition that changes the meaning of distances; empty if there is none.
  const std::string& warning() const { return m_warning; }

  bool has_barriers() const { return !m_is_barrier.empty(); }

  // Precondition: has_barriers().
  Barrier_map barriers() const { return {&m_is_barrier}; }

  // Whether the mesh is only a part of the surface.
  bool is_region() const { return m_is_region; }

  // Calls f(mesh), which may split edges and faces, and returns whether each edge is a barrier. New vertices are at none of the file.
  template <class Function>
  void split(const Function& f)
  {
    m_is_barrier = f(m_mesh);
    m_parts = Surface_parts(m_mesh);
    drop_missing_barriers();
  }

  // Removes all other faces and the vertices without faces. Where only a vertex connects faces that are kept, each fan of them
  // that a removed face bounds has a vertex of its own: no path passes there. Precondition: a face is kept.
  void keep_faces(const std::vector<bool>& is_kept);

  // Whether the mesh has a vertex at a vertex of the file: a face with an area has it.
  bool has_vertex(std::size_t file_vertex) const { return m_first_vertex[file_vertex] != Mesh::null_vertex(); }

  bool has_coinciding_border_edges() const;

  template <class Function>
  void for_each_vertex_of(std::size_t file_vertex, const Function& function) const
  {
    if(!has_vertex(file_vertex)) return;
    function(m_first_vertex[file_vertex]);
    const auto range = m_further_vertices.equal_range(file_vertex);
    for(auto it = range.first; it != range.second; ++it) function(it->second);
  }

private:
  // Numbers of the vertices at the targets of the halfedges after keep_faces(), and the present vertex of each number.
  struct Kept_corners
  {
    std::vector<std::uint32_t> number_at;
    std::vector<Vertex> vertices;
  };

  Kept_corners kept_corners(const std::vector<bool>& is_kept) const;

  // An empty list costs nothing: no map is passed to the solver.
  void drop_missing_barriers();

  void set_diagonal(); // from the box

  using Vertex_pairs = std::vector<std::pair<Vertex, Vertex>>;

  // Called before the mesh is built.
  void require_memory_for_faces(const std::string& path) const;

  // Checks the tolerance of border edges, too.
  void measure(const std::string& path, double tolerance);

  // Removes consecutive repetitions of a vertex. Returns whether a polygon remains.
  static bool clean(Polygon& polygon);

  static bool has_repetition(const Polygon& polygon);

  void clean_polygons(const std::string& path, Faces& faces);

  void build(const std::string& path, Faces& faces, const Border_joining& joining);

  // Merges the ends of border edges at the same place. Parts that only touch at a vertex remain separate. Returns whether there
  // are such edges.
  bool stitch(const Polygon_links& links, double tolerance, Faces& faces);

  // Returns whether there are such faces.
  bool remove_degenerate_faces(const std::string& path, Faces& faces);

  // Gives each vertex one fan. Returns the number of vertices added along cuts.
  std::size_t make_manifold(const std::string& path, Faces& faces, const Polygon_links& links);

  // Finds the copies of points with several fans and without cuts, by comparing polygons before and after the orientation.
  // Returns their number.
  static std::size_t find_copies(Faces& faces, const std::vector<Polygon>& before, std::size_t number_of_points);

  // Whether the polygons have the same corners in the same order; points from number_of_points on are copies.
  static bool is_same(const Polygon& before, const Polygon& after, const std::vector<Point>& points,
                      std::size_t number_of_points);

  // Builds the mesh if the polygons are a manifold with one fan per vertex; returns whether they are. Much faster than a
  // separate test.
  bool make_mesh(Faces& faces, const Polygon_links& links);

  static void drop_repeated_faces(Faces& faces);

  void map_vertices(const Faces& faces);

  void divide(const std::vector<Halfedge>& corners);
  void triangulate(const std::string& path, const Faces& faces);

  static Vertex_pairs pairs_of_vertices(const Faces& faces);

  void renumber_vertices(const std::vector<Vertex>& new_vertex);

  // Merges copies into one vertex.
  void join(const std::string& path, const Vertex_pairs& copies);
};

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_MESH_INPUT_H
