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
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

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

} // namespace CGAL::Geodesic_offset::internal

#endif
