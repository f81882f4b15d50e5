// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The field on an Extended_mesh, propagated in numbers of twice the digits of double: for distances much smaller than the edges
// around (extended_distances.h), and for bisectors of nearly equal distances (Extended_bisectors.h).

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_EXTENDED_FIELD_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GRADED_EXTENDED_FIELD_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/graded/Extended_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Computation_number.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/double_arithmetic.h>

#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// True if an extended propagation computes the same field as the build: the number type is double, the functors are the
// package's (a user's may define another metric), and no option of the compiler, such as -ffast-math, changes the rounding that
// Extended_number relies on. `Package`: the traits of the package from which the traits are derived, or void.
template <class Traits, class Package = Package_traits<Traits>>
struct Has_extended_fields
{
  static constexpr bool value = may_round_correctly() && std::is_same<typename Package::FT, double>::value &&
                                std::is_same<Functors_of<Traits>, Functors_of<Package>>::value;
};

template <class Traits>
struct Has_extended_fields<Traits, void>
{
  static constexpr bool value = false;
};

// The initial windows of sources on an Extended_mesh, and the results of their propagation.
template <class Number>
struct Extended_field
{
  typedef Number FT;

  std::vector<Index> source_of_part; // per part of a source, that is, per source of `initial`: the id of its source
  std::optional<Initial_windows<FT>> initial;
  Geodesic_field<FT> results;

  // Propagates the parts of `sources` on the mesh; to be called once. Distances are final up to `maximum`, and sources with start
  // values above it are left out. `sources` and `maximum` are in the units of the user, `initial` and `results` in those of the
  // extended mesh.
  // \throws std::runtime_error if there are too many windows, see Window_lists and Wavefront_state::limit_work()
  void propagate(const Extended_mesh<Number>& mesh, const Source_set<double>& sources, double maximum, bool keeps_windows)
  {
    initial.emplace(mesh.sources(sources, maximum, source_of_part).initial_windows(mesh.unfolded()));
    results.clear(mesh.unfolded(), initial->start_values);
    typedef typename Extended_mesh<Number>::Traits Traits;
    const Traits traits;
    Wavefront<Traits> front(mesh.unfolded(), *initial, traits, mesh.to_unit(maximum), keeps_windows,
                            Ignoring_consumer::reads_lists, results);
    front.limit_work(most_windows + most_windows_per_halfedge * mesh.unfolded().number_of_halfedges());
    Ignoring_consumer consumer;
    front.run(consumer, [](const FT&, std::size_t) { return true; });
  }

private:
  // Limit of the propagated windows, a constant plus a number per halfedge. Meshes of the tests and of attacks need up to 41 per
  // halfedge. In needles, rays wind around a vertex until rounding ends them, and the number of windows grows with the square of
  // the number of turns. Binding test: test_graded_distances, winding rays.
  static constexpr std::size_t most_windows = std::size_t(1) << 20, most_windows_per_halfedge = std::size_t(1) << 10;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
