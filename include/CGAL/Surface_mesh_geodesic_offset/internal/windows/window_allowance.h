// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Allowances for the rounding of windows: of their distances, rays and images.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_ALLOWANCE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_WINDOW_ALLOWANCE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

namespace CGAL::Geodesic_offset::internal {

// Units of rounding, of a distance and the edges beside it, within which paths are taken for equally long: windows are pruned
// (pruning_allowance()) only beyond this difference, so distances by windows may differ by as much.
constexpr double roundings_of_window = 256;

// `scale`: the distance, plus the edges if it may be short. Zero for exact numbers.
template <class FT>
inline FT window_allowance(const FT& scale)
{
  return Number_policy<FT>::rounding(roundings_of_window) * scale;
}

// Units of rounding, of the distance and the edges beside it, by which a ray that has crossed many faces is off, and the distance
// along it.
constexpr double roundings_of_ray = 64;

// Units of rounding by which two rays differ that are one: each has been turned into the frame by some four operations.
constexpr double roundings_of_turn = 16;

// Units of rounding, an angle, that a cone is wider than if it is open: each of its two slopes has been rounded at least once.
constexpr double roundings_of_cone = 2;

// Units of rounding, of the length of a ray, that its part across an edge is at least: below a fraction of the last place, the sign
// is noise. Then `grazing_across`, a part of the same length, stands for it: the ray meets the line of the edge far beyond the end.
constexpr double roundings_across_edge = 0.1, grazing_across = 1e-40;

// Height of an image over its edge that is never divided by: the smallest normal number is 2e-308, so slopes stay finite for
// positions up to 1e8.
constexpr double least_height = 1e-300;

// Height given to an image that rounding has put on or behind the edge that its rays cross. `length`: of the edge that determines
// the rounding of the height.
template <class FT>
inline FT rounding_of_height(const FT& length)
{
  return Number_policy<FT>::rounding(1) * length;
}

// Rounding error of an image that has crossed the longest edge of the mesh.
template <class FT>
inline FT error_of_image(const FT& longest_edge)
{
  if constexpr (!Number_policy<FT>::is_inexact) return FT(0);
  else return Number_policy<FT>::rounding(16) * longest_edge;
}

// Largest distance between a point and a ray that may meet it, with rounding: bounding rays of neighbouring windows differ by some
// rounding errors per edge that they have crossed. `size`: of the coordinates of the point and the image.
template <class FT, class Mesh>
inline FT error_of_rays(const Mesh& mesh, const FT& size)
{
  if constexpr (!Number_policy<FT>::is_inexact) return FT(0);
  else return Number_policy<FT>::rounding(roundings_of_ray) * size + error_of_image(mesh.longest_edge());
}

} // namespace CGAL::Geodesic_offset::internal

#endif
