// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offset curves of a build, as the public classes pass them on: during the propagation, or afterwards.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_CUTTING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_CUTTING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Geodesic_mesh_data.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Curve_output.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Inner_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_selection.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Levels from a distance, a range of distances, or an Offset_levels object.
template <class Surface, class Levels>
Offset_levels<typename Surface::Number> offset_levels(const Levels& levels)
{
  typedef typename Surface::Number Number;
  if constexpr (std::is_convertible<Levels, typename Surface::FT>::value)
    return Offset_levels<Number>(std::array<Number, 1>{Surface::imported(typename Surface::FT(levels))});
  else return Offset_levels<Number>(levels);
}

template <class Surface, class T>
Offset_levels<typename Surface::Number> offset_levels(const Offset_levels<T>& levels)
{
  return levels.template converted<typename Surface::Number>(
    [](const T& d) { return Surface::imported(typename Surface::FT(d)); });
}

// Callback that writes the curves of all levels to an output iterator, which must outlive the callback.
template <class Curve, class OutputIterator>
auto curve_writer(OutputIterator& out)
{
  return [&out](const auto&, std::vector<Curve>&& curves) { out = std::move(curves.begin(), curves.end(), out); };
}

template <class Surface, class Build, class Function>
auto make_curve_output(const Geodesic_mesh_data<Surface>& mesh, const Build& build,
                       const Offset_levels<typename Surface::Number>& levels, const Offset_selection& selection, Function& f)
{
  typedef Number_policy<typename Surface::Number> Policy;
  // levels nearer to each other than rounding would never end
  if (levels.is_unlimited() && levels[0] < Policy::rounding(1024) * mesh.unfolded().longest_edge())
    throw std::invalid_argument("Surface_mesh_geodesic_offset: the spacing of offsets is less than the rounding of "
                                "distances");
  std::map<Index, Source_side> inside;
  if (selection.needs_inner_sides()) inside = inner_sides(mesh.unfolded(), mesh.traits, build.sources);
  return Curve_output<Surface, Function>(mesh.shared_surface, build.initial.primitives, levels, selection, std::move(inside), f);
}

// Propagates, and calls f(distance, curves) for each level.
template <class Concurrency_tag, class Surface, class Build, class Function>
void propagate_and_cut(const Geodesic_mesh_data<Surface>& mesh, Build& build,
                       const Offset_levels<typename Surface::Number>& levels, const Offset_selection& selection, Function& f)
{
  const auto output = make_curve_output(mesh, build, levels, selection, f);
  build.template propagate_and_cut<Concurrency_tag>(mesh.traits, levels, output);
  output.finish();
}

// Calls f(distance, curves) for each level of a finished build.
template <class Concurrency_tag, class Surface, class Build, class Function>
void cut_offset_curves(const Geodesic_mesh_data<Surface>& mesh, const Build& build,
                       const Offset_levels<typename Surface::Number>& levels, const Offset_selection& selection, Function& f)
{
  if (build.kept)
  {
    const auto output = make_curve_output(mesh, build, levels, selection, f);
    build.template cut<Concurrency_tag>(levels, output);
    output.finish();
    return;
  }
  typename Surface::Number maximum = build.maximum;
  if (!levels.is_unlimited() && levels.size() > 0) maximum = (std::min)(maximum, levels[levels.size() - 1]);
  Build again(mesh.unfolded(), build.sources, {maximum, false, {}, {}, {}});
  propagate_and_cut<Concurrency_tag>(mesh, again, levels, selection, f);
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
