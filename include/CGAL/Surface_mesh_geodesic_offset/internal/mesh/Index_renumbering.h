// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Indices of vertices and faces in the flat arrays: those of the mesh, or, if these scatter neighbours in memory, indices
// along a space-filling curve.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_INDEX_RENUMBERING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_INDEX_RENUMBERING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_links.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

class Index_renumbering
{
public:
  typedef std::function<Per_corner<double>(std::size_t)> Coordinates; // of the i-th vertex; finite

  // Upper bounds of the indices of the mesh; indices below may be unused.
  Index_renumbering(std::size_t vertices_end, std::size_t faces_end) : m_vertices_end(vertices_end), m_faces_end(faces_end) {}

  // Replaces the indices if neighbours are scattered. vertices: the mesh indices of all vertices.
  template <class Team>
  void renumber_if_scattered(const All_face_links& links, const std::vector<Index>& vertices, const Coordinates& coordinates,
                             Team& team);

  // Adds vertices behind all others. To be called before renumber_if_scattered().
  void add_vertices(std::size_t n) { m_vertices_end += n; }

  // Upper bounds of the new indices; indices below may be unused.
  std::size_t vertices_end() const { return m_vertices_end; }
  std::size_t faces_end() const { return m_faces_end; }

  // Precondition: `index` is an index of the mesh.
  Index of_vertex(Index index) const { return m_vertex.empty() ? index : m_vertex[index]; }
  Index of_face(Index index) const { return m_face.empty() ? index : m_face[index]; }

  // For any index: no_index or an unused index if the mesh does not have it.
  Index of_any_vertex(std::size_t index) const { return number(m_vertex, index); }
  Index of_any_face(std::size_t index) const { return number(m_face, index); }

private:
  static Index number(const std::vector<Index>& renumbered, std::size_t i)
  {
    return renumbered.empty() ? Index(i) : i < renumbered.size() ? renumbered[i] : no_index;
  }

  static bool is_scattered(const All_face_links& links);

  std::size_t m_vertices_end, m_faces_end;
  std::vector<Index> m_vertex, m_face; // by mesh index; empty: identity
};

} // namespace CGAL::Geodesic_offset::internal

#ifndef CGAL_GEODESIC_OFFSET_COMPILED
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Index_renumbering_impl.h>
#endif

#endif
