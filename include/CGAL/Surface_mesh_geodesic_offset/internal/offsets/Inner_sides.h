// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The inner sides of closed polylines, all of them in one pass over the faces.
//
// The winding number of a polyline is a function on the rest of the surface that is larger by 1 on the left of the polyline than on
// its right. If it exists and has two values, they are the two sides. The polyline is taken as moved to the right by less than any
// distance, so that it meets no vertex, and its own points are on its left. It then consists of crossings with edges, where the
// winding number jumps, and of pieces inside faces, and areas are sums over both by Green's theorem.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_INNER_SIDES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_INNER_SIDES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_set.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Computes in `double` for all number types.
template <class FT>
class Inner_sides
{
public:
  // Adds all closed polylines of the set. The mesh must outlive this object. Barriers do not count.
  Inner_sides(const Unfolded_mesh<FT>& mesh, const Source_set<FT>& sources);

  // By source id, for all closed polylines that are longer than a point. Time: that of one pass over the mesh, and per polyline
  // linear in its size and in the number of cells of its part of the surface: sets of vertices that edges without crossings connect.
  std::map<std::size_t, Geodesic_inner_side> operator()();

  // Number of halfedges and cells visited by this call: that of passes over the mesh, and over the cells per polyline.
  std::size_t number_of_visits() const { return m_visits; }

private:
  typedef Surface_point<FT> Place;
  typedef Point_in_face<double> Point;

  // Jump of the winding number at parameter t of an edge, in the direction of its halfedge with the lower index.
  struct Crossing
  {
    Index contour, halfedge;
    double t;
    int jump;
  };

  // Part of a polyline in a face.
  struct Piece
  {
    Index contour, face;
    Point start, end;
  };

  // A segment of a polyline, moved to the right: into this face, or beyond the border.
  struct Segment
  {
    Place first, second;
    Index face; // no_index: beyond the border
    Point start, end;
    double size;
  };

  struct Contour
  {
    std::size_t id;
    Index face = no_index; // of its last segment
    double length = 0;
    double covered = 0;      // length of its parts along the border
    Index left = no_index;   // corner at one of its vertices, if it runs along edges
    bool turns_back = false; // along itself
  };

  // Edges between two cells whose winding numbers differ alike: jumps of the polylines from `first` to `second`.
  struct Link
  {
    Index first, second;
    std::vector<std::pair<Index, int>> jumps;
    bool operator<(const Link& l) const { return std::tie(first, second, jumps) < std::tie(l.first, l.second, l.jumps); }
    bool operator==(const Link& l) const { return first == l.first && second == l.second && jumps == l.jumps; }
  };

  Index canonical(Index h) const { return (std::min)(h, m_mesh.twin(h)); } // no_index is the largest index
  double length_of(Index h) const { return CGAL::to_double(m_mesh[h].length); }
  double area_of(Index face) const { return length_of(3 * face) * CGAL::to_double(m_mesh[3 * face].apex_y) / 2; }

  // The vertex at the source of h; another index for each further fan of a pinched vertex.
  Index node(Index h) const;

  void add(std::size_t id, std::vector<Place> points);
  Segment segment(const Place& p, const Place& q, Contour& contour) const;
  bool turns_back(const Segment& in, const Segment& out) const;
  void add_joint(const Segment& in, const Segment& out);
  void add_turn(Index v, Index in, Index out);
  void add_crossing_near(Index h, Index v);
  Index corner_at(Index face, Index v) const;
  void cross_at(Index h, double t, int jump);

  void find_cells();
  bool find_windings(const Contour& contour);
  Geodesic_inner_side side_of(const Contour& contour);
  bool find_left(const Contour& contour, int& left) const;
  template <class Function>
  void for_each_left(const Piece* first, const Piece* last, const Function& f) const;
  int winding_on_edge(Index contour, Index h, double t) const;

  const Unfolded_mesh<FT>& m_mesh;
  mutable std::map<Index, Index> m_more_nodes; // by first corner of the fan
  std::vector<Contour> m_contours;
  std::vector<Crossing> m_crossings; // by contour, halfedge and t
  std::vector<Piece> m_pieces;       // by contour and face
  std::vector<Index> m_cell;         // by node: its root
  std::vector<Link> m_links;
  std::vector<std::vector<Index>> m_links_of; // by cell
  std::vector<double> m_area, m_border;       // by cell
  std::vector<int> m_winding;                 // by cell, of the last polyline
  std::vector<Index> m_cells;                 // of the part of the last polyline
  std::size_t m_visits = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#ifndef CGAL_GEODESIC_OFFSET_COMPILED
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Inner_sides_impl.h>
#endif

#endif
