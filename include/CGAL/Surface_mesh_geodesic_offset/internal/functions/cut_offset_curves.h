// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offset curves of a build for the public classes: during the propagation, or after it.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FUNCTIONS_CUT_OFFSET_CURVES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FUNCTIONS_CUT_OFFSET_CURVES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_curve.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Geodesic_mesh_data.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Curve_context.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_selection.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/level_cutting.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

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
  return levels.template converted<typename Surface::Number>([](const T& d) {
    return Surface::imported(typename Surface::FT(d));
  });
}

// Callback that writes the curves of all levels to an output iterator, which must outlive the callback.
template <class Curve, class OutputIterator>
auto curve_writer(OutputIterator& out)
{
  return [&out](const auto&, std::vector<Curve>&& curves) { out = std::move(curves.begin(), curves.end(), out); };
}

// The requested part of an offset.
template <class NamedParameters>
Offset_selection offset_selection(const NamedParameters& np)
{
  using parameters::get_parameter;
  Offset_selection result;
  if constexpr (has_parameter<internal_np::geodesic_offset_side_t, NamedParameters>)
  {
    const auto& sides = get_parameter(np, internal_np::geodesic_offset_side);
    if constexpr (std::is_convertible<decltype(sides), Offset_side>::value) result.side = sides;
    else
      for (const auto& [source, side] : sides) result.side_of_source[std::size_t(source)] = side;
  }
  if constexpr (has_parameter<internal_np::geodesic_end_style_t, NamedParameters>)
    result.end = get_parameter(np, internal_np::geodesic_end_style);
  return result;
}

// Calls f(distance, curves) for each level, in increasing order.
template <class Surface, class Function>
class Curve_output
{
public:
  typedef typename Surface::Number Number;
  typedef Geodesic_offset_curve<Surface> Curve;
  typedef Curve_context<Surface> Context;

  // `levels` and `f` must outlive this object.
  template <class Build>
  Curve_output(const std::shared_ptr<const Surface>& surface, const Build& build, const Offset_levels<Number>& levels,
               Function& f)
    : m_context(std::make_shared<Context>(Context{surface, build.initial.primitives})), m_tolerance(build.request().tolerance),
      m_levels(levels), m_function(f)
  {
  }

  // Adds a level; skipped levels have no curves.
  void add(std::size_t level, std::vector<Level_curve<Number>>&& cut)
  {
    CGAL_precondition(level >= m_next);
    pass_to(level);
    std::vector<Curve> curves;
    const typename Surface::FT tolerance = Surface::exported(m_tolerance.error_at(m_levels[level]));
    for (Level_curve<Number>& c : cut)
      curves.push_back(Context::make_curve(m_context, Surface::exported(m_levels[level]), tolerance, c.is_closed,
                                           std::move(c.pieces)));
    m_next = level + 1;
    m_function(Surface::exported(m_levels[level]), std::move(curves));
  }

  void finish()
  {
    if (!m_levels.is_unlimited()) pass_to(m_levels.size());
  }

private:
  void pass_to(std::size_t level)
  {
    for (; m_next < level; ++m_next) m_function(Surface::exported(m_levels[m_next]), std::vector<Curve>());
  }

  std::shared_ptr<const Context> m_context;
  const Merging_tolerance<Number> m_tolerance;
  const Offset_levels<Number>& m_levels;
  Function& m_function;
  std::size_t m_next = 0; // level
};

// Propagates, and calls f(distance, curves) for each level. `only_curves`: as in Level_request.
template <class Concurrency_tag, unsigned parts, class Surface, class Build, class Function>
void propagate_and_cut(const Geodesic_mesh_data<Surface>& mesh, Build& build,
                       const Offset_levels<typename Surface::Number>& levels, const Offset_selection& selection,
                       bool only_curves, Function& f)
{
  Curve_output<Surface, Function> output(mesh.shared_surface, build, levels, f);
  cut_finalized_faces<Concurrency_tag, Build::parts_for(parts)>(
    mesh.unfolded(), build, mesh.traits, {levels, selection, only_curves},
    [&](std::size_t level, auto&& cut) { output.add(level, std::move(cut)); });
  output.finish();
}

// Calls f(distance, curves) for each level of a finished build: from its windows, or, if they were not kept, by a second
// propagation up to the largest level.
template <class Concurrency_tag, class Surface, class Build, class Function>
void cut_offset_curves(const Geodesic_mesh_data<Surface>& mesh, const Build& build,
                       const Offset_levels<typename Surface::Number>& levels, const Offset_selection& selection, Function& f)
{
  if (build.kept || levels.size() == 0)
  {
    Curve_output<Surface, Function> output(mesh.shared_surface, build, levels, f);
    cut_all_faces<Concurrency_tag>(mesh.unfolded(), build, {levels, selection}, [&](std::size_t level, auto&& cut) {
      output.add(level, std::move(cut));
    });
    output.finish();
    return;
  }
  typename Surface::Number maximum = build.maximum;
  if (!levels.is_unlimited()) maximum = (std::min)(maximum, levels[levels.size() - 1]);
  Build second_build(mesh.unfolded(), build.sources, {maximum, false, {}, {}, build.request().tolerance});
  propagate_and_cut<Concurrency_tag, MERGING>(mesh, second_build, levels, selection, true, f);
}

} // namespace CGAL::Geodesic_offset::internal

#endif
