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

\brief holds the named parameters of a build: any number of the functions below, in any order, joined by dots, as in
`parameters::distance_limit(2.).keep_windows(true)`.
*/
template <class T, class Tag, class Base = internal_np::No_property>
struct Geodesic_parameters : Named_function_parameters<T, Tag, Base>
{
#ifndef DOXYGEN_RUNNING
  typedef Named_function_parameters<T, Tag, Base> Named_parameters;
  using Named_parameters::Named_parameters;
#endif

  /// the largest distance that is computed, inclusive. Points farther away are at infinity. %Default: infinity.
  template <class FT>
  auto distance_limit(const FT& d) const
  {
    return and_also<internal_np::geodesic_distance_limit_t>(d);
  }

  /// whether the windows are kept after the propagation, which queries at points other than vertices need.
  /// %Default: `false`.
  auto keep_windows(bool keep) const { return and_also<internal_np::geodesic_keep_windows_t>(keep); }

  /// whether the largest distance of the surface is computed while the front advances, for `largest_distance()` and
  /// `farthest_point()`. Takes little time, and memory for one face. %Default: `false`; these functions need kept windows then.
  auto compute_largest_distance(bool compute) const
  {
    return and_also<internal_np::geodesic_compute_largest_distance_t>(compute);
  }

  /// the points whose distances are requested: the propagation stops once all of these distances are final.
  /// \tparam Range a model of `ConstRange` with `vertex_descriptor` or `Face_location` as value type. The range is not copied,
  ///         and must outlive the build. An empty range has no effect.
  template <class Range>
  auto targets(const Range& range) const
  {
    return and_also<internal_np::geodesic_targets_t>(std::cref(range));
  }

  /// a function object `bool(double)`, called periodically with the completed fraction of the surface: a number from 0 to 1
  /// that never decreases and is 1 at the end only. If the visitor returns `false`, the build is cancelled. The function object
  /// is copied; `std::ref` passes an object with a state. A chain of parameters cannot begin with a visitor:
  /// `parameters::visitor(f)` is \cgal's, and none of the functions of this class can follow it.
  template <class Visitor>
  auto visitor(const Visitor& function) const
  {
    return and_also<internal_np::visitor_t>(function);
  }

  /// the largest relative amount by which a distance may be smaller than the exact distance: a number from 0 to 0.5, in
  /// practice from 1e-9 to 1e-3. %Default: 0, exact distances.
  ///
  /// On smooth fine meshes a tolerance saves much time and memory: neighbouring windows are merged if all distances stay within
  /// the tolerance, so that a few windows per vertex are propagated. `statistics()` reports the error bound that was reached.
  /// Distances, signed distances, gradients and labels are available then; paths, offset curves, nearest points and the
  /// farthest point are not. Needs a floating point number type.
  template <class FT>
  auto relative_tolerance(const FT& t) const
  {
    return and_also<internal_np::geodesic_relative_tolerance_t>(t);
  }

  /// the largest length by which a distance may be smaller than the exact distance, in the units of the mesh's points: finite,
  /// and not negative. %Default: 0.
  ///
  /// A length far below the size of the faces merges windows that differ only by noise in the coordinates, for instance in the
  /// planes of a CAD model. Otherwise as `relative_tolerance()`; if both are given, a distance may be smaller by the sum, but
  /// never by more than half of the exact distance.
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
/// sets the largest distance that is computed, see `Geodesic_parameters::distance_limit()`.
/// \param d a distance, not negative
template <class FT>
auto distance_limit(const FT& d)
{
  return Geodesic_parameters<FT, internal_np::geodesic_distance_limit_t>(d);
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// sets whether the windows are kept after the propagation, see `Geodesic_parameters::keep_windows()`.
/// \param keep whether the windows are kept
inline auto keep_windows(bool keep)
{
  return Geodesic_parameters<bool, internal_np::geodesic_keep_windows_t>(keep);
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// sets whether the largest distance of the surface is computed, see `Geodesic_parameters::compute_largest_distance()`.
/// \param compute whether the largest distance is computed
inline auto compute_largest_distance(bool compute)
{
  return Geodesic_parameters<bool, internal_np::geodesic_compute_largest_distance_t>(compute);
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// sets the points whose distances are requested, see `Geodesic_parameters::targets()`.
/// \param range a range of `vertex_descriptor` or `Face_location`, which must outlive the build
template <class Range>
auto targets(const Range& range)
{
  return Geodesic_parameters<std::reference_wrapper<const Range>, internal_np::geodesic_targets_t>(std::cref(range));
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// sets the relative tolerance of distances, see `Geodesic_parameters::relative_tolerance()`.
/// \param t a number from 0 to 0.5
template <class FT>
auto relative_tolerance(const FT& t)
{
  return Geodesic_parameters<FT, internal_np::geodesic_relative_tolerance_t>(t);
}

/// \ingroup PkgSurfaceMeshGeodesicOffsetParameters
/// sets the absolute tolerance of distances, see `Geodesic_parameters::merging_tolerance()`.
/// \param t a length, finite and not negative
template <class FT>
auto merging_tolerance(const FT& t)
{
  return Geodesic_parameters<FT, internal_np::geodesic_merging_tolerance_t>(t);
}

} // namespace parameters
} // namespace CGAL

#endif
