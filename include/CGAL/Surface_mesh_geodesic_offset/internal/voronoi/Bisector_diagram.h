// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bisectors of a build: the curves of its Voronoi diagram.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_BISECTOR_DIAGRAM_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_BISECTOR_DIAGRAM_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Geodesic_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_arc.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Face_cells.h>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Where three arcs or more meet. The place is that of the end of an arc.
template <class NT>
struct Bisector_vertex
{
  Index face;
  Point_in_face<NT> point;
  unsigned char edge;                // halfedge of the face that has the point; 3: none
  std::vector<std::size_t> curves{}; // that end here; one with both ends twice
};

template <class NT>
struct Bisector_chain
{
  std::vector<Bisector_arc<NT>> arcs;
  bool is_closed;
  std::size_t start_vertex, end_vertex; // no_vertex: on the border
  static constexpr std::size_t no_vertex = ~std::size_t(0);
};

template <class NT>
struct Bisector_diagram
{
  std::vector<Bisector_chain<NT>> chains;
  std::vector<Bisector_vertex<NT>> vertices;
  std::vector<Index> label_of_face;                // of the center: of all points, if no bisector crosses the face
  std::unordered_map<Index, Face_cells<NT>> cells; // of the faces that bisectors may cross
  std::size_t divisions = 0, forced_cells = 0;
};

// Finds the bisectors in all faces. NT: the number type of the curves. Windows must be kept.
template <class NT, class FT>
Bisector_diagram<NT> find_bisectors(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial,
                                    const Geodesic_field<FT>& field);

} // namespace CGAL::Geodesic_offset::internal

#ifndef CGAL_GEODESIC_OFFSET_COMPILED
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_diagram_impl.h>
#endif

#endif
