// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a level leaves in a face: pieces of offset curves, and the gates through which they come and go.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_PIECE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_PIECE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>

#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A part of an offset curve in one face, in the face's frame: an arc round `center`, counterclockwise, or a segment.
template <class FT>
struct Level_piece
{
  Point_in_face<FT> center; // of a segment: unit direction from the source
  FT radius;                // of a segment: distance of its line from the frame's origin along that direction
  Point_in_face<FT> start, end;
  Index face;
  Root root;
  Index pseudo_source; // no_index if none
  bool is_straight;
  unsigned char start_edge, end_edge; // the halfedge of the face that the end lies on, 3 if it lies inside
};

// A level that just touches a vertex, or a point where the distance is largest, is cut as a loop without extent: up to some
// 1e-8 of the level or of the edges of the mesh, since the cut below the level is that much wider where the distance is
// flat. `scale`: the level and the mean edge length, together.
template <class FT>
bool is_point(const std::vector<Level_piece<FT>>& pieces, const FT& scale)
{
  FT sum(0);
  for (const Level_piece<FT>& p : pieces) sum += length(p.end - p.start);
  return sum <= Number_policy<FT>::rounding(1 << 26) * scale;
}

// A crossing of the level with an edge of the face. The level's curve starts in this face where, counterclockwise along
// the face's boundary, the distance rises above the level.
template <class FT>
struct Level_gate
{
  Point_in_face<FT> point;
  unsigned char edge; // halfedge of the face
  bool is_start;
  Index id;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
