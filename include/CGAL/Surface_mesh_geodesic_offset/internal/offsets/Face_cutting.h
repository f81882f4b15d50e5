// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts one face at all levels that cross it, in two steps: crossings with its edges; then, when these gates are numbered, the
// chains of pieces between them. Several threads may cut several faces, each with its own object.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_FACE_CUTTING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_FACE_CUTTING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Crossing.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Edge_crossings.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Face_crossings.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Interior_maximum.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_tracer.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Merging_tolerance.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A range of level indices.
struct Level_range
{
  std::size_t first, last; // `last` is excluded
  bool is_empty() const { return first >= last; }
  std::size_t size() const { return is_empty() ? 0 : last - first; }
};

// A face with the results of its cutting.
template <class FT>
struct Face_cut
{
  typedef Level_piece<FT> Piece;

  struct Gate
  {
    std::size_t level;
    Level_gate<FT> gate;
  };
  struct Chain
  {
    std::size_t level;
    Index start, end;        // gates; no_index for a loop
    std::size_t first, last; // pieces
  };

  Face_cut(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& geodesic_field)
    : field(mesh, initial, geodesic_field)
  {
  }

  // Adds crossings with halfedge k, given along it or, `reversed`, along its twin. Gates come counterclockwise.
  template <class Iterator>
  void add_gates(int k, Iterator begin, Iterator end, bool reversed)
  {
    const auto n = end - begin;
    for (std::ptrdiff_t i = 0; i < n; ++i)
    {
      const Crossing<FT>& c = begin[reversed ? n - 1 - i : i];
      const FT t = reversed ? FT(field.frame().edge_length(k) - c.position) : c.position;
      gates.push_back({c.level, {field.frame().on_edge(k, t), (unsigned char)(k), c.starts_chain(reversed), c.gate}});
      levels.first = (std::min)(levels.first, c.level);
      levels.last = (std::max)(levels.last, c.level + 1);
    }
  }

  Level_range levels{0, 0};
  Face_field<FT> field;
  Per_corner<std::vector<Crossing<FT>>> crossings; // with the edges that this face examines first
  std::vector<Gate> gates;
  std::vector<Chain> chains;                  // by level
  const std::vector<Piece>* pieces = nullptr; // with those of all chains
};

template <class FT>
class Face_cutting
{
public:
  // `tolerance`: that of the field. If it is not zero, distances jump at edges.
  Face_cutting(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field,
               const Vertex_reach<FT>& reach, const Offset_sources<FT>& sources, const Offset_levels<FT>& levels,
               const FT& maximum, const Merging_tolerance<FT>& tolerance)
    : m_mesh(mesh), m_field(field), m_reach(reach), m_levels(levels), m_end(levels.first_above(maximum)), m_sources(sources),
      m_tolerance(tolerance), m_crossings(mesh, initial, field, reach, sources), m_face_crossings(mesh, field, reach, sources),
      m_tracer(mesh.longest_edge(), sources)
  {
  }

  // The levels that may cross a face, by the distances of its corners; of a face that is not finalized, those nearer than
  // `settled`.
  Level_range levels_of(Index face, const FT& settled) const
  {
    FT near, far;
    range_of(face, (std::min)(m_field.maximum, settled), near, far);
    return {m_levels.first_above(near), (std::min)(m_end, m_levels.first_above(far))};
  }

  // Step 1: the crossings with the edges of the face; with edge k, of the levels from first[k]. With a tolerance, they are those
  // of this face, otherwise those of both faces of the edge. Precondition: cut.levels is a part of levels_of(face, settled).
  void find_crossings(Index face, const FT& settled, const std::array<std::size_t, 3>& first, Face_cut<FT>& cut)
  {
    Level_range& l = cut.levels;
    cut.gates.clear();
    cut.chains.clear();
    cut.field.set_face(face);
    const FT slack = Offset_tolerances<FT>::bound_slack(far_end_of(face, (std::min)(m_field.maximum, settled)));
    l.first = (std::max)(l.first, m_levels.first_above(FT(cut.field.lower_bound() - slack)));
    for (Index k = 0; k < 3; ++k)
    {
      cut.crossings[k].clear();
      const Index h = 3 * face + k;
      const Level_range left{(std::max)(l.first, first[k]), l.last};
      if (m_tolerance.is_zero()) find_crossings((std::min)(h, m_mesh.twin(h)), m_crossings, left, cut.field, cut.crossings[k]);
      else find_crossings(h, m_face_crossings, left, cut.field, cut.crossings[k]);
    }
  }

  // Step 2: the chains between all gates of the face, and the loops inside. Their pieces are stored in this object.
  void find_chains(Face_cut<FT>& cut)
  {
    if (cut.levels.is_empty()) return;
    cut.pieces = &m_pieces;
    const bool loops = cut.field.has_local_sources() || may_have_interior_maximum(cut.field);
    std::stable_sort(cut.gates.begin(), cut.gates.end(), [](const auto& a, const auto& b) { return a.level < b.level; });
    auto next = cut.gates.begin();
    m_tracer.set_face(cut.field, m_reach.of_face(cut.field.face()), cut_level(cut.levels.first),
                      cut_level(cut.levels.last - 1));
    const Face_frame<FT>& frame = cut.field.frame();
    for (int k = 0; k < 3; ++k)
    {
      m_cell.corner[k] = frame.corner(k);
      m_cell.direction[k] = frame.direction(k);
    }
    for (std::size_t i = cut.levels.first; i < cut.levels.last; ++i)
    {
      m_cell.gates.clear();
      for (; next != cut.gates.end() && next->level == i; ++next) m_cell.gates.push_back(next->gate);
      if (m_cell.gates.empty() && !loops) continue;
      const FT level = cut_level(i);
      for (Index k = 0; k < 3; ++k) m_cell.is_near[k] = m_sources.is_near(m_mesh.source(3 * cut.field.face() + k), level);
      m_tracer(level, m_cell, loops, [&](Index start, Index end, const std::vector<Level_piece<FT>>& pieces) {
        const std::size_t first = m_pieces.size();
        m_pieces.insert(m_pieces.end(), pieces.begin(), pieces.end());
        cut.chains.push_back({i, start, end, first, m_pieces.size()});
      });
    }
    CGAL_assertion(next == cut.gates.end());
  }

  // The pieces of all faces are no longer needed.
  void clear_pieces() { m_pieces.clear(); }

  std::size_t number_of_forced_joints() const { return m_tracer.number_of_forced_joints(); }
  std::size_t number_of_crossed_cells() const { return m_tracer.number_of_crossed_cells(); }

private:
  // The crossings of levels with the edge of h, by level. As the level rises, an edge is first far from the sources, then
  // crossed, then near them. So the first and the last crossed level are found from those of the ends of the edge, and no other
  // level is computed but one on each side.
  template <class Crossings>
  void find_crossings(Index h, Crossings& crossings, const Level_range& levels, const Face_field<FT>& field,
                      std::vector<Crossing<FT>>& found)
  {
    const auto add = [&](std::size_t i) {
      const std::size_t before = found.size();
      crossings(h, field, this->cut_level(i), [&](const FT& t, bool falling) {
        found.push_back({i, t, falling, no_index});
      });
      return found.size() > before;
    };
    if (levels.is_empty()) return;
    const Index p = m_mesh.source(h), q = m_mesh.target(h);
    const std::size_t at_end = m_levels.first_above((std::min)(m_field.distance[p], m_field.distance[q]));
    std::size_t i = (std::min)((std::max)(at_end, levels.first), levels.last);
    while (i > levels.first && add(i - 1)) --i;
    found.clear();
    for (; i < levels.last; ++i)
      if (!add(i) && m_sources.is_near(p, cut_level(i)) && m_sources.is_near(q, cut_level(i))) return;
  }

  // A point at exactly the level counts as farther: with inexact numbers, a level is cut slightly below itself. Levels through
  // vertices and along edges, frequent on CAD meshes, then need no special case.
  FT cut_level(std::size_t i) const { return m_levels[i] - Offset_tolerances<FT>::level_shift(m_levels[i]); }

  // Upper bound of the distances in a face up to `maximum`.
  FT far_end_of(Index face, const FT& maximum) const
  {
    FT far = maximum;
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
    {
      const FT& d = m_field.distance[m_mesh.source(h)];
      if (Number_policy<FT>::is_finite(d))
        far = (std::min)(far, FT(d + (std::max)(m_mesh[h].length, m_mesh[m_mesh.previous(h)].length)));
    }
    return far;
  }

  // Bounds of the distances in a face up to `maximum`; distances of vertices up to `maximum` are final.
  void range_of(Index face, const FT& maximum, FT& near, FT& far) const
  {
    FT longest(0), highest(0);
    far = far_end_of(face, maximum);
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
    { // a vertex without a distance is beyond the maximum
      longest = (std::max)(longest, m_mesh[h].length);
      const FT lowest = (std::min)(m_field.distance[m_mesh.source(h)], maximum);
      if (Number_policy<FT>::is_finite(lowest)) highest = (std::max)(highest, lowest);
    }
    near = (std::max)(FT(0), FT(m_tolerance.least_of(highest) - longest - Offset_tolerances<FT>::edge_rounding(longest)));
    if (!Number_policy<FT>::is_finite(far)) far = FT(0);
    else
    { // the distances of two vertices may differ by the tolerance more than the length of the edge between them
      far = (std::min)(maximum, FT(far + m_tolerance.error_at(far)));
      near -= Offset_tolerances<FT>::bound_slack(far);
      far += Offset_tolerances<FT>::bound_slack(far);
    }
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Geodesic_field<FT>& m_field;
  const Vertex_reach<FT>& m_reach;
  const Offset_levels<FT>& m_levels;
  const std::size_t m_end; // number of levels up to the distance limit
  const Offset_sources<FT>& m_sources;
  const Merging_tolerance<FT> m_tolerance;
  Edge_crossings<FT> m_crossings;
  Face_crossings<FT> m_face_crossings;
  Level_tracer<FT> m_tracer;
  Level_cell<FT> m_cell; // the face with the gates of one level
  std::vector<Level_piece<FT>> m_pieces;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
