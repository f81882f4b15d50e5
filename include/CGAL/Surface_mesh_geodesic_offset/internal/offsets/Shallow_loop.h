// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed curves around a maximum that equals the level up to rounding, and open curves that cut off such a vertex of the
// border. They arise where a level only touches a maximum.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_SHALLOW_LOOP_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_SHALLOW_LOOP_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Shallow_loop
{
public:
  typedef Level_piece<FT> Piece;
  typedef std::vector<Piece> Pieces;

  // `distance`: of the vertices; infinite beyond the limit of the distances.
  Shallow_loop(const Unfolded_mesh<FT>& mesh, const std::vector<FT>& distance)
    : m_mesh(mesh), m_edge(mesh.mean_edge_length()), m_distance(distance)
  {
  }

  // True if the curve is such a loop, or an open curve that cuts off such a vertex.
  bool operator()(bool closed, const Pieces& pieces, const FT& level) const
  {
    FT sum(0);
    for (const Piece& p : pieces) sum += length(p.end - p.start);
    const FT magnitude = level + m_edge;
    if (sum > Offset_tolerances<FT>::longest_shallow_loop(magnitude)) return false;
    const std::vector<Index> faces = faces_of(pieces);
    const bool has_vertex = !closed || faces.size() > 2 || crosses_two_edges(pieces); // a vertex may have two faces
    const Index v = !closed    ? vertex_cut_off(pieces.front(), pieces.back())
                  : has_vertex ? vertex_inside(faces, pieces)
                               : no_index;
    if (has_vertex && !is_common(v, faces)) return false; // more than one vertex inside
    // A curve this short is a point up to rounding, and the sign of its area is rounding. Around a source, its level or the
    // angle of the surface would be below rounding.
    const bool has_area = sum > Offset_tolerances<FT>(magnitude).error;
    if (has_area && CGAL::is_positive(signed_area(pieces, faces, v))) return false; // around a source
    // The distance rises by at most half the length.
    const FT most = Offset_tolerances<FT>::shallow_rise(magnitude);
    if (v != no_index && rise_at(v, pieces, level) > most) return false;
    return (closed && sum <= FT(2) * most) || rise(pieces, faces, v) <= most;
  }

private:
  typedef Point_in_face<FT> Point;

  // The rise of the distance at the vertex inside, an upper bound if its distance is unknown. The rays of a piece need not
  // reach the vertex: behind the end of a source segment, the distance is larger than that from its line.
  FT rise_at(Index v, const Pieces& pieces, const FT& level) const
  {
    if (Number_policy<FT>::is_finite(m_distance[v])) return m_distance[v] - level;
    const FT slack = Offset_tolerances<FT>(level + m_edge).error;
    FT result = Number_policy<FT>::infinity();
    for (const Piece& p : pieces)
    {
      if (corner_of(p.face, v) > 2) continue;
      const Point q = Face_frame<FT>(m_mesh, p.face).corner(corner_of(p.face, v));
      const FT by_end = (std::min)(length(q - p.start), length(q - p.end)); // the distance is 1-Lipschitz
      result = (std::min)(result, is_beside(q, p, slack) ? (std::min)(p.rise(q), by_end) : by_end);
    }
    return result;
  }

  // True if the rays through a piece pass a point, up to a length.
  static bool is_beside(const Point& q, const Piece& p, const FT& slack)
  {
    if (p.is_straight)
    {
      const Point along = quarter_turn(p.center);
      return dot(along, q - p.start) >= -slack && dot(along, p.end - q) >= -slack;
    }
    const Point start = p.start - p.center, end = p.end - p.center;
    return cross(start, q - p.center) >= -slack * length(start) && cross(q - p.center, end) >= -slack * length(end);
  }

  // Bound of the rise of the distance inside: per face, that of the piece whose function rises least. The function is
  // convex, so its maximum is at an end of a piece of the face, or at the vertex inside the loop.
  FT rise(const Pieces& pieces, const std::vector<Index>& faces, Index v) const
  {
    FT result(0);
    std::vector<Point> corners;
    for (const Index f : faces)
    {
      corners.clear();
      if (v != no_index) corners.push_back(Face_frame<FT>(m_mesh, f).corner(corner_of(f, v)));
      for (const Piece& p : pieces)
        if (p.face == f)
        {
          corners.push_back(p.start);
          corners.push_back(p.end);
        }
      FT least = Number_policy<FT>::infinity();
      for (const Piece& p : pieces)
      {
        if (p.face != f) continue;
        FT rise(0);
        for (const Point& q : corners) rise = (std::max)(rise, p.rise(q));
        least = (std::min)(least, rise);
      }
      result = (std::max)(result, least);
    }
    return result;
  }

  static std::vector<Index> faces_of(const Pieces& pieces)
  {
    std::vector<Index> faces;
    for (const Piece& p : pieces) faces.push_back(p.face);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  // Twice the area of the polygon of all ends and middle points of pieces; positive if the loop runs counterclockwise, with the
  // smaller distances inside. Without middle points, two half turns around a source on an edge have no area. In each face the
  // area is relative to the vertex v or, in two faces, to a point on their common edge.
  FT signed_area(const Pieces& pieces, const std::vector<Index>& faces, Index v) const
  {
    FT area(0);
    for (const Index f : faces)
    {
      const auto is_origin = [&](const Piece& p) { return p.face == f && (faces.size() == 1 || p.start_edge < 3); };
      Point origin{FT(0), FT(0)};
      if (v != no_index) origin = Face_frame<FT>(m_mesh, f).corner(corner_of(f, v));
      else if (const auto p = std::find_if(pieces.begin(), pieces.end(), is_origin); p != pieces.end()) origin = p->start;
      for (const Piece& p : pieces)
        if (p.face == f) area += cross(p.start - origin, p.middle() - origin) + cross(p.middle() - origin, p.end - origin);
    }
    return area;
  }

  bool is_common(Index v, const std::vector<Index>& faces) const
  {
    return v != no_index && std::all_of(faces.begin(), faces.end(), [&](Index f) { return this->corner_of(f, v) < 3; });
  }

  bool crosses_two_edges(const Pieces& pieces) const
  {
    Index first = no_index;
    for (const Piece& p : pieces)
    {
      if (p.start_edge > 2) continue;
      const Index h = 3 * p.face + p.start_edge, edge = (std::min)(h, m_mesh.twin(h));
      if (first == no_index) first = edge;
      if (edge != first) return true;
    }
    return false;
  }

  // The vertex of all faces of a closed curve at which all edges end that it crosses.
  Index vertex_inside(const std::vector<Index>& faces, const Pieces& pieces) const
  {
    for (Index h = 3 * faces.front(); h < 3 * faces.front() + 3; ++h)
    {
      const Index v = m_mesh.source(h);
      const auto ends_there = [&](const Piece& p) {
        const Index g = 3 * p.face + p.start_edge;
        return p.start_edge > 2 || m_mesh.source(g) == v || m_mesh.source(m_mesh.next(g)) == v;
      };
      if (is_common(v, faces) && std::all_of(pieces.begin(), pieces.end(), ends_there)) return v;
    }
    return no_index;
  }

  // The common vertex of the border edges at both ends of an open curve. Along the border, with the surface on its left, the
  // curve starts before the vertex and ends behind it.
  Index vertex_cut_off(const Piece& first, const Piece& last) const
  {
    if (first.start_edge > 2 || last.end_edge > 2) return no_index;
    const Index v = m_mesh.source(3 * last.face + last.end_edge);
    return m_mesh.source(m_mesh.next(3 * first.face + first.start_edge)) == v ? v : no_index;
  }

  int corner_of(Index face, Index v) const
  {
    for (int k = 0; k < 3; ++k)
      if (m_mesh.source(3 * face + Index(k)) == v) return k;
    return 3;
  }

  const Unfolded_mesh<FT>& m_mesh;
  const FT m_edge;
  const std::vector<FT>& m_distance;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
