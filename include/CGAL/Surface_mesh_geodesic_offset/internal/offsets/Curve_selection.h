// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains the cut pieces of a level, drops loops that rounding makes, and selects the requested side.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CURVE_SELECTION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CURVE_SELECTION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Inner_sides.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_selection.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Shallow_loop.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/level_cutting.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// The parts of a curve on the selected side of the sources.
class Side_selection
{
public:
  // `inside`: inner sides of closed polylines, by source id; of those that the selection needs.
  Side_selection(const Offset_selection& selection, const std::vector<Source_primitive>& primitives,
                 std::map<std::size_t, Geodesic_inner_side> inside)
    : m_selection(selection), m_primitives(primitives), m_inside(std::move(inside))
  {
  }

  bool operator()(Source_ref source_ref) const
  {
    if (source_ref.side() == Source_side::NONE) return true;
    const std::size_t source = m_primitives[source_ref.primitive()].source;
    if (source_ref.side() == Source_side::CAP) return m_selection.end_of(source) == Offset_end::ROUND;
    switch (m_selection.side_of(source))
    {
    case Offset_side::LEFT: return source_ref.side() == Source_side::LEFT;
    case Offset_side::RIGHT: return source_ref.side() == Source_side::RIGHT;
    case Offset_side::INSIDE: return source_ref.side() == m_inside.at(source).side;
    case Offset_side::OUTSIDE: return source_ref.side() != m_inside.at(source).side;
    default: return true;
    }
  }

  // Calls out(closed, pieces) for each maximal part of a curve in the selection that is longer than `shortest`. Between parts of the
  // other kind, a part of a side of a polyline that is not longer than `rounded` belongs to them.
  template <class FT, class Function>
  void operator()(const FT& shortest, const FT& rounded, bool closed, std::vector<Level_piece<FT>>&& pieces,
                  const Function& out) const
  {
    if (m_selection.is_everything()) return out(closed, std::move(pieces));
    std::vector<char> is_wanted;
    for (const Level_piece<FT>& p : pieces) is_wanted.push_back((*this)(p.source_ref));
    const std::size_t n = pieces.size();
    const auto end_of = [&](std::size_t i) { // of the part that begins at i
      return std::size_t(std::find(is_wanted.begin() + i, is_wanted.end(), char(!is_wanted[i])) - is_wanted.begin());
    };
    // A closed curve starts at a change.
    const auto rotate = [&] {
      const std::size_t start = closed ? end_of(0) : n;
      if (start == n) return;
      std::rotate(pieces.begin(), pieces.begin() + start, pieces.end());
      std::rotate(is_wanted.begin(), is_wanted.begin() + start, is_wanted.end());
    };
    const auto is_longer = [&](std::size_t first, std::size_t last, const FT& than) {
      FT sum(0);
      for (; first < last; ++first) sum += length(pieces[first].end - pieces[first].start);
      return sum > than;
    };
    const auto has_side = [](const Level_piece<FT>& p) {
      return p.source_ref.side() == Source_side::LEFT || p.source_ref.side() == Source_side::RIGHT;
    };
    rotate();
    const bool is_divided = end_of(0) < n && is_longer(0, n, FT(4) * rounded); // small loops stay as they are
    for (std::size_t first = 0, last; is_divided && first < n; first = last)
    {
      last = end_of(first);
      const bool is_between = closed ? last - first < n : first > 0 && last < n;
      if (is_between && std::all_of(pieces.begin() + first, pieces.begin() + last, has_side) &&
          !is_longer(first, last, rounded))
        std::fill(is_wanted.begin() + first, is_wanted.begin() + last, char(!is_wanted[first]));
    }
    rotate();
    for (std::size_t first = 0, last; first < n; first = last)
    {
      last = end_of(first);
      if (!is_wanted[first]) continue;
      if (last - first == n) return out(closed, std::move(pieces));
      if (is_longer(first, last, shortest))
        out(false, std::vector<Level_piece<FT>>(std::make_move_iterator(pieces.begin() + first),
                                                std::make_move_iterator(pieces.begin() + last)));
    }
  }

private:
  Offset_selection m_selection;
  const std::vector<Source_primitive>& m_primitives;
  std::map<std::size_t, Geodesic_inner_side> m_inside;
};

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
