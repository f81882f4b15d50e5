// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed curves round a place where the distance is largest, but larger than the level by no more than rounding can tell: a
// level that just touches such a place is cut as a loop about it.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_SHALLOW_LOOP_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_SHALLOW_LOOP_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Shallow_loop
{
public:
  typedef Level_piece<FT> Piece;
  typedef std::vector<Piece> Pieces;

  explicit Shallow_loop(const Unfolded_mesh<FT>& mesh) : m_mesh(mesh), m_edge(mesh.mean_edge_length()) {}

  // Is the curve such a loop? The distance inside a small one is the smallest of the functions of its pieces. At this scale
  // they are linear, so a point in the middle rises above the level by a third of the largest rise, at least.
  bool operator()(const Pieces& pieces, const FT& level) const
  {
    FT sum(0);
    for (const Piece& p : pieces) sum += length(p.end - p.start);
    const FT magnitude = level + m_edge;
    if (sum > Offset_tolerances<FT>::longest_shallow_loop(magnitude)) return false;
    if (sum <= Offset_tolerances<FT>(magnitude).error) return true; // the distance rises by less than the length
    const FT rise = rise_inside(pieces);
    return Number_policy<FT>::is_finite(rise) && rise <= FT(2) * Offset_tolerances<FT>::level_shift(magnitude);
  }

private:
  typedef Point_in_face<FT> Point;

  // At the middle of a loop in one face, at the middle of the chord on the edge of a loop in two, or at the vertex that all
  // faces of the loop share.
  FT rise_inside(const Pieces& pieces) const
  {
    const Index face = pieces.front().face;
    const auto is_in = [&](Index f) { return [f](const Piece& p) { return p.face == f; }; };
    if (std::all_of(pieces.begin(), pieces.end(), is_in(face)))
    {
      Point sum{FT(0), FT(0)};
      for (const Piece& p : pieces) sum = sum + p.start;
      return rise_at(pieces, [&](Index) { return (FT(1) / FT(double(pieces.size()))) * sum; });
    }
    const FT at_vertex = rise_at_vertex(pieces);
    if (Number_policy<FT>::is_finite(at_vertex)) return at_vertex;
    // in two faces: the middle of the ends on their common edge
    return rise_at(pieces, [&](Index f) {
      Point sum{FT(0), FT(0)};
      int n = 0;
      for (const Piece& p : pieces)
        if (p.face == f && p.start_edge < 3)
        {
          sum = sum + p.start;
          ++n;
        }
      for (const Piece& p : pieces)
        if (p.face == f && p.end_edge < 3)
        {
          sum = sum + p.end;
          ++n;
        }
      return (FT(1) / FT(double((std::max)(n, 1)))) * sum;
    });
  }

  // At a vertex that all faces of the loop share and that is farther than the level; infinite if there is none.
  FT rise_at_vertex(const Pieces& pieces) const
  {
    const Index face = pieces.front().face;
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
    {
      const Index v = m_mesh.source(h);
      if (!std::all_of(pieces.begin(), pieces.end(), [&](const Piece& p) { return this->corner_of(p.face, v) < 3; }))
        continue;
      const auto corner = [&](Index f) { return Face_frame<FT>(this->m_mesh, f).corner(this->corner_of(f, v)); };
      const FT rise = rise_at(pieces, corner);
      if (!CGAL::is_negative(rise)) return rise;
    }
    return Number_policy<FT>::infinity();
  }

  // The smallest rise of the pieces' functions at a point, which `point(face)` gives in the frame of a face.
  template <class Function>
  FT rise_at(const Pieces& pieces, const Function& point) const
  {
    FT rise = Number_policy<FT>::infinity();
    for (const Piece& p : pieces)
    {
      const Point q = point(p.face);
      rise = (std::min)(rise, FT((p.is_straight ? dot(p.center, q) : length(q - p.center)) - p.radius));
    }
    return rise;
  }

  int corner_of(Index face, Index v) const
  {
    for (int k = 0; k < 3; ++k)
      if (m_mesh.source(3 * face + Index(k)) == v) return k;
    return 3;
  }

  const Unfolded_mesh<FT>& m_mesh;
  const FT m_edge;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
