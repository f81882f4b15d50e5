// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight pieces of a face that cross, or pass a point nearer than the snap distance: divides them at common points. Triangles
// between almost equal points would have no area after rounding.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_PIECE_CROSSINGS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_PIECE_CROSSINGS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Split_piece.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class Points, class Piece>
class Piece_crossings
{
public:
  typedef typename Points::Id Id;
  typedef typename Points::face_descriptor face_descriptor;
  typedef std::vector<Split_piece<Piece>> Pieces;

  Piece_crossings(Points& points, face_descriptor f) : m_points(points), m_face(f), m_flat(points.flat(f)) {}

  // Adds the points where two pieces cross to the points of the mesh. Time: quadratic in the number of pieces.
  std::vector<Id> find(const Pieces& pieces)
  {
    std::vector<Id> crossings;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
      {
        const Point p = at(pieces[i].from), u = at(pieces[i].to) - p, q = at(pieces[j].from), v = at(pieces[j].to) - q;
        const double turn = cross(u, v), s = cross(q - p, v), t = cross(q - p, u);
        if (turn == 0 || s * turn <= 0 || t * turn <= 0 || !(s / turn < 1) || !(t / turn < 1)) continue;
        const Point x = p + (s / turn) * u;
        const double b = x.y / m_flat.apex_y, a = (x.x - b * m_flat.apex_x) / m_flat.length;
        crossings.push_back(m_points.add(m_face, {1 - a - b, a, b}));
      }
    return crossings;
  }

  // Divides the pieces at all given points that are nearer than the snap distance.
  void divide(Pieces& pieces, std::vector<Id> ids) const
  {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    Pieces result;
    for (const Split_piece<Piece>& piece : pieces)
    {
      const Point p = at(piece.from), u = at(piece.to) - p;
      const double size = length(u);
      std::vector<std::pair<double, Id>> inner; // by their place along the piece
      for (const Id id : ids)
      {
        if (id == piece.from || id == piece.to) continue;
        const Point w = at(id) - p;
        const double along = dot(u, w) / size;
        if (along > 0 && along < size && std::abs(cross(u, w)) <= m_points.snap_distance() * size)
          inner.emplace_back(along, id);
      }
      std::sort(inner.begin(), inner.end());
      Id last = piece.from;
      for (const auto& i : inner)
      {
        result.push_back({last, i.second, piece.level, nullptr});
        last = i.second;
      }
      result.push_back({last, piece.to, piece.level, nullptr});
    }
    pieces.swap(result);
  }

private:
  typedef Point_in_face<double> Point;

  Point at(Id id) const
  {
    const auto w = m_points.weights(m_face, id);
    return {w[1] * m_flat.length + w[2] * m_flat.apex_x, w[2] * m_flat.apex_y};
  }

  Points& m_points;
  const face_descriptor m_face;
  const Flat_face m_flat;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
