// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains the cut pieces of a level, drops loops that rounding makes, and selects the requested side.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CURVE_SELECTION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CURVE_SELECTION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Inner_sides.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Shallow_loop.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Side_selection.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/level_cutting.h>

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Curve_selection
{
public:
  // All arguments must outlive this object.
  template <class Build>
  Curve_selection(const Unfolded_mesh<FT>& mesh, const Build& build, const Level_request<FT>& request,
                  const Level_output<FT>& out)
    : m_levels(request.levels),
      m_select(request.selection, build.initial.primitives, inside(mesh, build.sources, request.selection)),
      m_is_shallow(mesh, build.field.distance), m_edge(mesh.mean_edge_length()), m_out(out)
  {
    // With a spacing below the rounding of distances, the number of levels would be practically unlimited.
    if (m_levels.is_unlimited() && m_levels.spacing() < Offset_tolerances<FT>::least_spacing(mesh.longest_edge()))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: the spacing of offsets is less than the rounding of "
                                  "distances");
  }

  // Returns whether some piece is in the selection, also if its part is dropped.
  bool operator()(std::size_t level, const Level_curves<FT>& cut) const
  {
    bool is_selected = false;
    std::vector<Level_curve<FT>> curves;
    const FT shortest = Offset_tolerances<FT>::shortest_part(m_levels[level] + m_edge);
    const FT rounded = Offset_tolerances<FT>::part_of_rounded_side(m_levels[level]);
    cut.for_each_curve([&](bool closed, std::vector<Level_piece<FT>>&& pieces) {
      for (const Level_piece<FT>& p : pieces) is_selected = is_selected || m_select(p.source_ref);
      if (m_is_shallow(closed, pieces, m_levels[level])) return;
      m_select(shortest, rounded, closed, std::move(pieces), [&](bool is_closed, std::vector<Level_piece<FT>>&& part) {
        curves.push_back({is_closed, std::move(part)});
      });
    });
    m_out(level, std::move(curves));
    return is_selected;
  }

private:
  // Inner sides, if some are selected. Throws if a polyline has none.
  static std::map<std::size_t, Geodesic_inner_side> inside(const Unfolded_mesh<FT>& mesh, const Source_set<FT>& sources,
                                                           const Offset_selection& selection)
  {
    typedef Source_set<FT> Set;
    bool is_needed = false;
    sources.for_each([&](std::size_t id, const typename Set::Source& s) {
      is_needed = is_needed || (s.kind == Set::CLOSED_POLYLINE && selection.needs_inside_of(id));
      if (s.kind == Set::OPEN_POLYLINE && selection.needs_inside_of(id))
        throw std::invalid_argument("Surface_mesh_geodesic_offset: source " + std::to_string(id) +
                                    " is an open polyline and has no inside");
    });
    if (!is_needed) return {};
    std::map<std::size_t, Geodesic_inner_side> sides = Inner_sides<FT>(mesh, sources)();
    for (const auto& [id, inner] : sides)
      if (inner.side == Source_side::NONE && selection.needs_inside_of(id))
        throw std::invalid_argument("Surface_mesh_geodesic_offset: source " + std::to_string(id) +
                                    " does not divide the surface into an inside and an outside");
    return sides;
  }

  const Offset_levels<FT>& m_levels;
  const Side_selection m_select;
  const Shallow_loop<FT> m_is_shallow;
  const FT m_edge; // mean length
  const Level_output<FT>& m_out;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
