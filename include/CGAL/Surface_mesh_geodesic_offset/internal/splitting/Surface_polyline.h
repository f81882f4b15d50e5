// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A polyline on a mesh as a curve of straight pieces, each in a face, for Mesh_splitting.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_SURFACE_POLYLINE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_SURFACE_POLYLINE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class TriangleMesh, class FaceLocation>
class Surface_polyline
{
public:
  typedef FaceLocation Face_location;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

  class Piece
  {
  public:
    typedef double FT;

    Piece(const Face_location& start, const Face_location& end) : m_start(start), m_end(end) {}

    const Face_location& start() const { return m_start; }
    const Face_location& end() const { return m_end; }
    face_descriptor face() const { return m_start.first; }

    static constexpr bool is_arc() { return false; }
    // for arcs, so they are never called
    Face_location location(double t) const { return t < 0.5 ? m_start : m_end; }
    static constexpr std::size_t number_of_chords(double) { return 1; }

  private:
    Face_location m_start, m_end; // in one face
  };

  // number: of the polyline, for messages.
  // \throws std::invalid_argument if consecutive points have no face in common
  Surface_polyline(const TriangleMesh& tm, const std::vector<Face_location>& locations, bool is_closed, std::size_t number)
    : m_is_closed(is_closed && locations.size() > 1)
  {
    const std::size_t n = locations.size();
    for (std::size_t i = 0; i + 1 < n + (m_is_closed ? 1 : 0); ++i)
    {
      const Face_location &p = locations[i], &q = locations[(i + 1) % n];
      if (!add(tm, p, q))
        throw std::invalid_argument("Surface_mesh_geodesic_offset: point " + std::to_string(i) + " of polyline " +
                                    std::to_string(number) + " and the next one have no face in common");
    }
  }

  bool is_closed() const { return m_is_closed; }
  std::size_t number_of_pieces() const { return m_pieces.size(); }
  const Piece& piece(std::size_t i) const { return m_pieces[i]; }

private:
  // Adds the piece between two locations that have a face in common, unless they are equal. Returns false if they have none.
  bool add(const TriangleMesh& tm, const Face_location& p, const Face_location& q)
  {
    namespace PMP = Polygon_mesh_processing;
    for (const halfedge_descriptor h : halfedges_around_face(halfedge(p.first, tm), tm))
      for (const halfedge_descriptor g : halfedges_around_target(h, tm))
      {
        const face_descriptor f = CGAL::is_border(g, tm) ? p.first : face(g, tm);
        if (!is_in(tm, p, f) || !is_in(tm, q, f)) continue;
        const Face_location a = PMP::locate_in_adjacent_face(p, f, tm), b = PMP::locate_in_adjacent_face(q, f, tm);
        if (a != b) m_pieces.emplace_back(a, b);
        return true;
      }
    return false;
  }

  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;

  // True if a location is in a face or on its boundary.
  static bool is_in(const TriangleMesh& tm, const Face_location& p, face_descriptor f)
  {
    if (p.first == f) return true;
    halfedge_descriptor h = halfedge(p.first, tm);
    for (std::size_t k = 0; k < 3; ++k, h = next(h, tm))
    {
      if (p.second[k] == 0) continue;
      bool is_corner = false;
      for (const auto v : vertices_around_face(halfedge(f, tm), tm)) is_corner |= v == source(h, tm);
      if (!is_corner) return false;
    }
    return true;
  }

  std::vector<Piece> m_pieces;
  const bool m_is_closed;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
