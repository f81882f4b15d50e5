// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_NAMED_PARAMETERS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_NAMED_PARAMETERS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>

namespace CGAL {
namespace internal_np {

enum geodesic_distance_limit_t { geodesic_distance_limit };
enum geodesic_keep_windows_t { geodesic_keep_windows };
enum geodesic_compute_largest_distance_t { geodesic_compute_largest_distance };
enum geodesic_targets_t { geodesic_targets };
enum geodesic_relative_tolerance_t { geodesic_relative_tolerance };
enum geodesic_merging_tolerance_t { geodesic_merging_tolerance };

} // namespace internal_np

namespace parameters {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetParameters

\brief what a build takes: any number of these in any order, joined by dots, as in
`parameters::distance_limit(2.).keep_windows(true)`.
*/
template <class T, class Tag, class Base = internal_np::No_property>
struct Geodesic_parameters : Named_function_parameters<T, Tag, Base>
{
  typedef Named_function_parameters<T, Tag, Base> Named_parameters;
  using Named_parameters::Named_parameters;

  /// the largest distance that is computed, inclusive. Points farther away are at infinity. %Default: infinity.
  template <class FT>
  auto distance_limit(const FT& d) const
  {
    return and_also<internal_np::geodesic_distance_limit_t>(d);
  }

  /// whether the windows are kept after the propagation, which queries at points other than vertices need.
  /// %Default: `false`.
  auto keep_windows(bool keep) const { return and_also<internal_np::geodesic_keep_windows_t>(keep); }

  /// whether the largest distance of the surface is computed while the front passes, for `largest_distance()` and
  /// `farthest_point()`. Takes little time, and memory for one face. %Default: `false`; these functions need kept windows then.
  auto compute_largest_distance(bool compute) const
  {
    return and_also<internal_np::geodesic_compute_largest_distance_t>(compute);
  }

  /// points whose distances are wanted: the propagation stops once all of them are final.
  /// \tparam Range a model of `ConstRange` with `vertex_descriptor` or `Face_location` as value type; it is not copied, and
  ///         must live until the build has ended. An empty one stops nothing.
  template <class Range>
  auto targets(const Range& range) const
  {
    return and_also<internal_np::geodesic_targets_t>(std::cref(range));
  }

  /// a function object `bool(double)`. It is told, every now and then, which part of the surface the front has passed: from
  /// 0 to 1, never decreasing, and 1 at the end alone. If it returns `false` the build is cancelled. It is copied:
  /// `std::ref` hands on an object with a state.
  /// (`parameters::visitor()` is that of \cgal; it can be given alone, or behind one of these.)
  template <class Visitor>
  auto visitor(const Visitor& function) const
  {
    return and_also<internal_np::visitor_t>(function);
  }

  /// the part of the distance by which every distance may be smaller than the exact one: a number from 0 to 0.5, in practice
  /// from 1e-9 to 1e-3. On smooth fine meshes this takes much less time and memory: neighbouring windows are merged where
  /// that keeps all distances within the tolerance, so that a few windows a vertex are propagated. `statistics()` tells
  /// the error bound that was reached. %Default: 0, exact distances.
  ///
  /// Distances, gradients, sides and labels can be had then; there are no paths, offset curves, nearest points, and no
  /// farthest point. Needs a floating point number type.
  template <class FT>
  auto relative_tolerance(const FT& t) const
  {
    return and_also<internal_np::geodesic_relative_tolerance_t>(t);
  }

  /// a length by which every distance may be smaller than the exact one, in the units of the mesh's points: finite, and not
  /// negative. With a length far below the size of the faces, windows that only noise in the coordinates keeps apart are
  /// merged, for instance in the planes of a CAD model. Otherwise as `relative_tolerance()`; if both are given, a distance
  /// may be smaller by the sum, but never by more than a half of itself. %Default: 0.
  template <class FT>
  auto merging_tolerance(const FT& t) const
  {
    return and_also<internal_np::geodesic_merging_tolerance_t>(t);
  }

private:
  template <class New_tag, class U>
  auto and_also(const U& value) const
  {
    return Geodesic_parameters<U, New_tag, Geodesic_parameters>(value, *this);
  }
};

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// see `Geodesic_parameters::distance_limit()`.
template <class FT>
auto distance_limit(const FT& d)
{
  return Geodesic_parameters<FT, internal_np::geodesic_distance_limit_t>(d);
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// see `Geodesic_parameters::keep_windows()`.
inline auto keep_windows(bool keep)
{
  return Geodesic_parameters<bool, internal_np::geodesic_keep_windows_t>(keep);
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// see `Geodesic_parameters::compute_largest_distance()`.
inline auto compute_largest_distance(bool compute)
{
  return Geodesic_parameters<bool, internal_np::geodesic_compute_largest_distance_t>(compute);
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// see `Geodesic_parameters::targets()`.
template <class Range>
auto targets(const Range& range)
{
  return Geodesic_parameters<std::reference_wrapper<const Range>, internal_np::geodesic_targets_t>(std::cref(range));
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// see `Geodesic_parameters::relative_tolerance()`.
template <class FT>
auto relative_tolerance(const FT& t)
{
  return Geodesic_parameters<FT, internal_np::geodesic_relative_tolerance_t>(t);
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// see `Geodesic_parameters::merging_tolerance()`.
template <class FT>
auto merging_tolerance(const FT& t)
{
  return Geodesic_parameters<FT, internal_np::geodesic_merging_tolerance_t>(t);
}

} // namespace parameters
} // namespace CGAL

#endif
