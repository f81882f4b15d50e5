// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 6 of the pipeline: builds curves from the cut pieces, level by level, and passes them to the caller.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CURVE_OUTPUT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CURVE_OUTPUT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_curve.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Shallow_loop.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Side_selection.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Merging_tolerance.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Calls f(distance, curves) for each level, in increasing order.
template <class Surface, class Function>
class Curve_output
{
public:
  typedef typename Surface::Number FT;
  typedef Geodesic_offset_curve<Surface> Curve;
  typedef Curve_context<Surface> Context;

  // `distance`: of the vertices; `tolerance`: of the distances. `distance`, `levels` and `f` must outlive this object.
  Curve_output(const std::shared_ptr<const Surface>& surface, const std::vector<Source_primitive>& primitives,
               const std::vector<FT>& distance, const Merging_tolerance<FT>& tolerance, const Offset_levels<FT>& levels,
               const Offset_selection& selection, std::map<Index, Source_side> inside, Function& f)
    : m_context(std::make_shared<Context>(Context{surface, primitives})), m_tolerance(tolerance), m_levels(levels),
      m_select(selection, m_context->primitives, std::move(inside)), m_is_shallow(surface->unfolded, distance),
      m_edge(surface->unfolded.mean_edge_length()), m_function(f)
  {
  }

  // Adds a level; skipped levels have no curves.
  void operator()(std::size_t level, const Level_curves<FT>& cut) const
  {
    CGAL_precondition(level >= m_next);
    pass_to(level);
    std::vector<Curve> curves;
    const typename Surface::FT tolerance = Surface::exported(m_tolerance.error_at(m_levels[level]));
    const FT shortest = Offset_tolerances<FT>::shortest_part(m_levels[level] + m_edge);
    cut.for_each_curve([&](bool closed, std::vector<Level_piece<FT>>&& pieces) {
      if (m_is_shallow(closed, pieces, m_levels[level])) return;
      m_select(shortest, closed, std::move(pieces), [&](bool is_closed, auto&& part) {
        curves.push_back(Context::make_curve(m_context, Surface::exported(m_levels[level]), tolerance, is_closed,
                                             std::forward<decltype(part)>(part)));
      });
    });
    m_next = (std::max)(m_next, level + 1);
    m_function(Surface::exported(m_levels[level]), std::move(curves));
  }

  void finish() const
  {
    if (!m_levels.is_unlimited()) pass_to(m_levels.size());
  }

private:
  void pass_to(std::size_t level) const
  {
    for (; m_next < level; ++m_next) m_function(Surface::exported(m_levels[m_next]), std::vector<Curve>());
  }

  std::shared_ptr<const Context> m_context;
  const Merging_tolerance<FT> m_tolerance;
  const Offset_levels<FT>& m_levels;
  Side_selection m_select;
  Shallow_loop<FT> m_is_shallow;
  FT m_edge; // mean length
  Function& m_function;
  mutable std::size_t m_next = 0; // level
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
