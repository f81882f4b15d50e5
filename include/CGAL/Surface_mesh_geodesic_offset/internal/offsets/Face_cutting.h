// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts one face at all levels that cross it, in two steps: crossings with its edges; then, when these gates are numbered, the
// chains of pieces between them. Several threads may cut several faces, each with its own object.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_FACE_CUTTING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_FACE_CUTTING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Crossing.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Edge_crossings.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_range.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_tracer.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Near_intervals.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Vertex_reach.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Merging_tolerance.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Face_crossings
{
public:
  Face_crossings(const Unfolded_mesh<FT>& mesh, const Geodesic_field<FT>& field, const Vertex_reach<FT>& reach,
                 const Offset_sources<FT>& sources)
    : m_mesh(mesh), m_field(field), m_reach(reach), m_sources(sources)
  {
  }

  // Calls out(t, falling) as Edge_crossings does, for the edge of h, a halfedge of the face of `field`.
  template <class OutputFunction>
  void operator()(Index h, const Face_field<FT>& field, const FT& level, const OutputFunction& out)
  {
    const Index p = m_mesh.source(h), q = m_mesh.target(h);
    const bool p_is_near = m_sources.is_near(p, level), q_is_near = m_sources.is_near(q, level);
    const FT length = m_mesh[h].length;
    const int k = int(h % 3);
    m_near.start(length, m_reach.of_face(field.face()), level);
    if (p_is_near) m_near.add_end(true, level - m_field.distance[p]);
    if (q_is_near) m_near.add_end(false, level - m_field.distance[q]);
    for (std::size_t i = 0; i < field.windows().size(); ++i)
      if (const Face_window<FT>& w = field.windows()[i]; field.lowest(i) < level && m_sources.reach(w.source_ref, level))
        m_near.add_window(w, field.frame().corner(k), field.frame().direction(k), false);
    if (!(m_mesh.twin(h) < h)) return m_near.for_each_end(p_is_near, q_is_near, out);
    m_ends.clear();
    m_near.for_each_end(p_is_near, q_is_near, [&](const FT& t, bool falling) { this->m_ends.push_back({t, falling}); });
    for (std::size_t i = m_ends.size(); i-- > 0;) out(FT(length - m_ends[i].first), !m_ends[i].second);
  }

private:
  const Unfolded_mesh<FT>& m_mesh;
  const Geodesic_field<FT>& m_field;
  const Vertex_reach<FT>& m_reach;
  const Offset_sources<FT>& m_sources;
  Near_intervals<FT> m_near;
  std::vector<std::pair<FT, bool>> m_ends;
};

// False only if the directions of all rays in the face lie in an open half-plane, as the distance then grows along their middle
// direction. (Corner functions count only where shortest paths continue behind the corner; elsewhere they are never below the
// other windows.)
template <class FT>
bool may_have_interior_maximum(const Face_field<FT>& field)
{
  typedef Point_in_face<FT> Point;
  // The directions of a window reach counterclockwise from its right to its left ray, by less than a half turn. [from, to] is
  // the cone of all directions, counterclockwise, as long as it is narrower than a half turn.
  bool empty = true;
  Point from{FT(1), FT(0)}, to{FT(1), FT(0)};
  for (const Face_window<FT>& w : field.windows())
  {
    if (w.origin == STARTS_IN_FACE) return true;
    if (w.is_empty()) continue;
    const Point r = w.right_ray(), l = w.left_ray();
    if (empty)
    {
      from = r;
      to = l;
      empty = false;
      continue;
    }
    for (const Point& u : {r, l})
    {
      const bool after_from = !CGAL::is_negative(cross(from, u)), before_to = !CGAL::is_negative(cross(u, to));
      if (after_from && before_to && CGAL::is_positive(dot(u, from + to))) continue;
      if (after_from && CGAL::is_positive(cross(from, u)) && !before_to) to = u;
      else if (before_to && CGAL::is_positive(cross(u, to)) && !after_from) from = u;
      else return true;
    }
  }
  return false;
}

// A face with the results of its cutting.
template <class FT>
struct Face_cut
{
  typedef Level_piece<FT> Piece;

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

  Index face = no_index;
  Level_range levels{0, 0};
  Per_corner<std::vector<Crossing<FT>>> crossings; // per edge, by level; first those that this face finds, then all
  std::vector<Chain> chains;                       // by level
  const std::vector<Piece>* pieces = nullptr;      // with those of all chains
  Face_field<FT> field;                            // used by Face_cutting
  bool has_windows = false;                        // false if the field has to be set to the face
};

template <class FT>
class Face_cutting
{
public:
  // `tolerance`: that of the field. If it is not zero, distances jump at edges.
  Face_cutting(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field,
               const Vertex_reach<FT>& reach, const Offset_sources<FT>& sources, const Offset_levels<FT>& levels,
               const FT& maximum, const Merging_tolerance<FT>& tolerance)
    : m_mesh(mesh), m_initial(initial), m_field(field), m_reach(reach), m_levels(levels), m_end(levels.first_above(maximum)),
      m_sources(sources), m_tolerance(tolerance), m_crossings(mesh, initial, field, reach, sources),
      m_face_crossings(mesh, field, reach, sources), m_tracer(mesh.longest_edge(), sources)
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
    const FT maximum = (std::min)(m_field.maximum, settled);
    const Level_range& l = cut.levels;
    cut.face = face;
    cut.chains.clear();
    const Index h = 3 * face;
    const bool is_on_border = m_mesh.twin(h) == no_index || m_mesh.twin(h + 1) == no_index || m_mesh.twin(h + 2) == no_index;
    cut.has_windows = is_on_border || !m_tolerance.is_zero();
    if (cut.has_windows) cut.field.set_face(face);
    for (Index k = 0; k < 3; ++k)
    {
      cut.crossings[k].clear();
      const Level_range left{(std::max)(l.first, first[k]), l.last};
      if (m_tolerance.is_zero())
        find_crossings((std::min)(h + k, m_mesh.twin(h + k)), maximum, m_crossings, left, cut.field, cut.crossings[k]);
      else find_crossings(h + k, maximum, m_face_crossings, left, cut.field, cut.crossings[k]);
    }
  }

  // Step 2: the chains between all gates of the face, and the loops inside. Their pieces are stored in this object. Windows are
  // made only if a level has gates or may have loops: a third of the visits of faces find neither.
  void find_chains(Face_cut<FT>& cut)
  {
    cut.pieces = &m_pieces;
    const Level_range gates = levels_of_gates(cut);
    const Level_range loops = levels_of_loops(cut);
    Level_range levels = gates;
    if (!loops.is_empty()) levels = {(std::min)(gates.first, loops.first), (std::max)(gates.last, loops.last)};
    if (levels.is_empty()) return;
    const FT reach = m_reach.of_face(cut.face);
    if (!cut.has_windows)
    {
      const FT highest = cut_level(levels.last - 1);
      cut.field.set_face(cut.face, highest + Offset_tolerances<FT>(reach + highest).smallest_cell);
    }
    const bool has_loops = cut.field.has_local_sources() || may_have_interior_maximum(cut.field);
    if (!has_loops) levels = gates;
    if (levels.is_empty()) return;
    m_tracer.set_face(cut.field, reach, cut_level(levels.first), cut_level(levels.last - 1));
    const Face_frame<FT>& frame = cut.field.frame();
    for (int k = 0; k < 3; ++k)
    {
      m_cell.corner[k] = frame.corner(k);
      m_cell.direction[k] = frame.direction(k);
    }
    Per_corner<std::size_t> next{};
    for (std::size_t i = levels.first; i < levels.last; ++i)
    {
      m_cell.gates.clear();
      for (int k = 0; k < 3; ++k) add_gates(cut, k, i, next[k]);
      if (m_cell.gates.empty() && !(has_loops && loops.first <= i && i < loops.last)) continue;
      const FT level = cut_level(i);
      for (Index k = 0; k < 3; ++k) m_cell.is_near[k] = m_sources.is_near(m_mesh.source(3 * cut.face + k), level);
      m_tracer(level, m_cell, has_loops, [&](Index start, Index end, const std::vector<Level_piece<FT>>& pieces) {
        const std::size_t first = m_pieces.size();
        m_pieces.insert(m_pieces.end(), pieces.begin(), pieces.end());
        cut.chains.push_back({i, start, end, first, m_pieces.size()});
      });
    }
    for (int k = 0; k < 3; ++k) CGAL_assertion(next[k] == cut.crossings[k].size());
  }

  // The pieces of all faces are no longer needed.
  void clear_pieces() { m_pieces.clear(); }

  std::size_t number_of_forced_joints() const { return m_tracer.number_of_forced_joints(); }
  std::size_t number_of_crossed_cells() const { return m_tracer.number_of_crossed_cells(); }

private:
  // The crossings of levels with the edge of h, by level. As the level rises, an edge is first far from the sources, then
  // crossed, then near them. So the first and the last crossed level are found from those of the ends of the edge, and no other
  // level is computed but one on each side. `maximum`: distances of vertices up to it are final.
  template <class Crossings>
  void find_crossings(Index h, const FT& maximum, Crossings& crossings, const Level_range& levels, const Face_field<FT>& field,
                      std::vector<Crossing<FT>>& found)
  {
    const auto add = [&](std::size_t i) {
      const std::size_t before = found.size();
      crossings(h, field, this->cut_level(i), [&](const FT& t, bool falling) { found.push_back({i, t, falling, no_index}); });
      return found.size() > before;
    };
    if (levels.is_empty()) return;
    const Index p = m_mesh.source(h), q = m_mesh.target(h);
    const std::size_t at_end = m_levels.first_above((std::min)(m_field.distance[p], m_field.distance[q]));
    std::size_t i = (std::min)((std::max)(at_end, levels.first), levels.last);
    if (i > levels.first)
    {
      const std::size_t lowest = m_levels.first_above(lower_bound_on_edge(h, maximum));
      while (i > levels.first && i > lowest && add(i - 1)) --i;
      found.clear();
    }
    for (; i < levels.last; ++i)
      if (!add(i) && m_sources.is_near(p, cut_level(i)) && m_sources.is_near(q, cut_level(i))) return;
  }

  // Lower bound of the distances on the edge of h: they change by no more than the length between two points.
  FT lower_bound_on_edge(Index h, const FT& maximum) const
  {
    const FT d0 = (std::min)(m_field.distance[m_mesh.source(h)], maximum);
    const FT d1 = (std::min)(m_field.distance[m_mesh.target(h)], maximum);
    if (!Number_policy<FT>::is_finite(d0) || !Number_policy<FT>::is_finite(d1)) return FT(0);
    return m_tolerance.least_of(FT((d0 + d1 - m_mesh[h].length) / FT(2))) - Offset_tolerances<FT>::bound_slack(d0 + d1);
  }

  // From the first to the last level with gates.
  static Level_range levels_of_gates(const Face_cut<FT>& cut)
  {
    Level_range levels{cut.levels.last, 0};
    for (const std::vector<Crossing<FT>>& c : cut.crossings)
    {
      if (c.empty()) continue;
      levels.first = (std::min)(levels.first, c.front().level);
      levels.last = (std::max)(levels.last, c.back().level + 1);
    }
    return levels;
  }

  // The levels that may have loops but no gates. Without sources in the face, such a loop is around a maximum, and all corners
  // are near.
  Level_range levels_of_loops(const Face_cut<FT>& cut) const
  {
    Level_range levels = cut.levels;
    if (const auto local = local_windows(m_initial, cut.face); local.first != local.second) return levels;
    for (Index h = 3 * cut.face; h < 3 * cut.face + 3; ++h)
      levels.first = (std::max)(levels.first, m_levels.first_above(m_field.distance[m_mesh.source(h)]));
    return levels;
  }

  // Adds the gates of a level on edge k of the face, counterclockwise. `next`: its first crossing with the edge; becomes that of
  // the next level.
  void add_gates(const Face_cut<FT>& cut, int k, std::size_t level, std::size_t& next)
  {
    const std::vector<Crossing<FT>>& crossings = cut.crossings[k];
    const std::size_t first = next;
    while (next < crossings.size() && crossings[next].level == level) ++next;
    if (next == first) return;
    const Face_frame<FT>& frame = cut.field.frame();
    const Index h = 3 * cut.face + Index(k);
    const bool reversed = m_mesh.twin(h) < h;
    for (std::size_t i = first; i < next; ++i)
    {
      const Crossing<FT>& c = crossings[reversed ? first + (next - 1 - i) : i];
      const FT t = reversed ? FT(frame.edge_length(k) - c.position) : c.position;
      m_cell.gates.push_back({frame.on_edge(k, t), (unsigned char)(k), c.starts_chain(reversed), c.gate});
    }
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
  const Initial_windows<FT>& m_initial;
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

} // namespace CGAL::Geodesic_offset::internal

#endif
