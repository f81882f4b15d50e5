// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piece of a curve in one face, and a part of it that is an edge of a triangle.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_SPLIT_PIECE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_SPLIT_PIECE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <cstddef>

namespace CGAL::Geodesic_offset::internal {

// A piece of a curve between two points of Split_points, with the index of its level. `arc` is null for a straight piece.
template <class Piece>
struct Split_piece
{
  std::size_t from, to, level;
  const Piece* arc;
};

// A constrained edge in the direction of its curve: the points that are nearer than the level are on its left.
struct Split_edge
{
  std::size_t from, to, level;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
