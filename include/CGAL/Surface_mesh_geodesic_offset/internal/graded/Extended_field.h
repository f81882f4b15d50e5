// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A propagation with twice the digits of double.

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

// True if the computation is in double, with the functors of the package: others may have another metric. False with options of
// the compiler that spoil extended numbers.
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

  std::vector<Index> source_of; // per id of a source there, that of the user
  std::optional<Initial_windows<FT>> initial;
  Geodesic_field<FT> results;

  // Distances are final up to `maximum`, and sources with larger start values are left out.
  // \throws std::runtime_error if there are too many windows, see Window_lists and Wavefront_state::limit_work()
  void propagate(const Extended_mesh<Number>& mesh, const Source_set<double>& sources, double maximum, bool keeps_windows)
  {
    initial.emplace(mesh.sources(sources, maximum, source_of).initial_windows(mesh.unfolded()));
    results.clear(mesh.unfolded(), initial->start_values);
    typedef typename Extended_mesh<Number>::Traits Traits;
    const Traits traits;
    Wavefront<Traits> front(mesh.unfolded(), *initial, traits, mesh.to_scale(maximum), keeps_windows, false, results);
    front.limit_work(most_work_of_mesh + most_work_of_halfedge * mesh.unfolded().number_of_halfedges());
    Ignoring_consumer consumer;
    front.run(consumer, [](const FT&, std::size_t) { return true; });
  }

private:
  // Windows of all processed lists, for a mesh and for each halfedge. Meshes of the tests and of attacks take up to 41 windows
  // for a halfedge. In needles, where rays wind around a vertex until rounding ends them, the number is the square of that of
  // the turns. Binding test: test_graded_distances, winding rays.
  static constexpr std::size_t most_work_of_mesh = std::size_t(1) << 20, most_work_of_halfedge = std::size_t(1) << 10;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
