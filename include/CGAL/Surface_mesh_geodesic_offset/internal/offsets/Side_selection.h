// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of a curve on the selected side of the sources.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_SIDE_SELECTION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_SIDE_SELECTION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_selection.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

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

  // Calls out(closed, pieces) for each maximal part of a curve in the selection that is longer than `shortest`.
  template <class FT, class Function>
  void operator()(const FT& shortest, bool closed, std::vector<Level_piece<FT>>&& pieces, const Function& out) const
  {
    const auto is_wanted = [&](const Level_piece<FT>& p) { return (*this)(p.source_ref); };
    if (m_selection.is_everything() || std::all_of(pieces.begin(), pieces.end(), is_wanted))
    {
      out(closed, std::move(pieces));
      return;
    }
    // A closed curve starts behind a piece outside the selection.
    if (closed) std::rotate(pieces.begin(), std::find_if_not(pieces.begin(), pieces.end(), is_wanted), pieces.end());
    for (auto first = pieces.begin(); first != pieces.end();)
    {
      first = std::find_if(first, pieces.end(), is_wanted);
      const auto last = std::find_if_not(first, pieces.end(), is_wanted);
      std::vector<Level_piece<FT>> part(first, last);
      FT sum(0);
      for (const Level_piece<FT>& p : part) sum += length(p.end - p.start);
      if (sum > shortest) out(false, std::move(part));
      first = last;
    }
  }

private:
  Offset_selection m_selection;
  const std::vector<Source_primitive>& m_primitives;
  std::map<std::size_t, Geodesic_inner_side> m_inside;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
