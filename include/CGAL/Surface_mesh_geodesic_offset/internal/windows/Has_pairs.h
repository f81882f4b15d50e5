// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether functors of traits have operators for pairs of numbers, see SurfaceMeshGeodesicOffsetTraitsWithPairs.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_HAS_PAIRS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WINDOWS_HAS_PAIRS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_number_pair.h>

#include <type_traits>

namespace CGAL::Geodesic_offset::internal {

// The value of the tag Has_pairs of a functor; false without the tag.
template <class Functor, class = void>
struct Has_pairs : std::false_type
{
};

template <class Functor>
struct Has_pairs<Functor, std::void_t<typename Functor::Has_pairs>> : std::bool_constant<Functor::Has_pairs::value>
{
};

// True if images are brought to another frame as pairs: then both ends of a window are unfolded at once.
template <class Traits>
struct Has_pair_children
{
  typedef typename Traits::FT FT;
  typedef const Geodesic_number_pair<FT>& Pair;
  typedef const typename Traits::Change_frame_2& Change_frame;

  static constexpr bool value = Has_pairs<typename Traits::Change_frame_2>::value;

  static_assert(!value || (std::is_invocable<Change_frame, Pair, const FT&, bool, Pair, Pair, Pair>::value &&
                           std::is_invocable_r<Geodesic_number_pair<FT>, Change_frame, Pair, Pair, Pair>::value),
                "Surface_mesh_geodesic_offset: Change_frame_2::Has_pairs is Tag_true, but an operator of "
                "SurfaceMeshGeodesicOffsetTraitsWithPairs is missing");
};

// True if the distances of two windows are computed as a pair.
template <class Traits>
struct Has_pair_distances
{
  typedef const Geodesic_number_pair<typename Traits::FT>& Pair;
  typedef const typename Traits::Compute_distance_2& Distance;

  static constexpr bool value = Has_pairs<typename Traits::Compute_distance_2>::value;

  static_assert(!value ||
                  std::is_invocable_r<Geodesic_number_pair<typename Traits::FT>, Distance, Pair, Pair, Pair, Pair, Pair>::value,
                "Surface_mesh_geodesic_offset: Compute_distance_2::Has_pairs is Tag_true, but the operator of "
                "SurfaceMeshGeodesicOffsetTraitsWithPairs is missing");
};

} // namespace CGAL::Geodesic_offset::internal

#endif
