// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 5 of the pipeline: offset curves from finished faces. Each face yields chains of pieces between gates, the
// crossings of a level with its edges; a gate is shared by the two faces beside the edge, so chains are linked into
// curves by the gates' numbers alone, never by proximity.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSET_EXTRACTION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSET_EXTRACTION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Edge_crossings.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Interior_maximum.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Level_tracer.h>

#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Offset_extraction
{
public:
  typedef Level_piece<FT> Piece;
  typedef typename Level_tracer<FT>::Chain Chain;

  Offset_extraction(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field,
                    const Offset_levels<FT>& levels)
    : m_mesh(mesh), m_initial(initial), m_field(field), m_levels(levels), m_crossings(mesh, initial, field),
      m_is_cut(mesh.number_of_faces(), 0)
  {
  }

  // Cuts one finished face at all levels that pass through it.
  void operator()(Index face)
  {
    cut(face);
    m_is_cut[face] = 1;
  }

  // Calls out(level index, closed, pieces) for each curve, by increasing level.
  template <class Function>
  void for_each_curve(const Function& out)
  {
    std::vector<std::size_t> order(m_links.size());
    std::vector<char> used(m_links.size(), 0), entered(m_link_of_gate.size(), 0);
    for (std::size_t i = 0; i < m_links.size(); ++i)
    {
      order[i] = i;
      if (m_links[i].end != no_index) entered[m_links[i].end] = 1;
    }
    // within a level, curves that start on the border first
    const auto starts_on_border = [&](const Link& l) { return l.start != no_index && !entered[l.start]; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      if (m_links[a].level != m_links[b].level) return m_links[a].level < m_links[b].level;
      return starts_on_border(m_links[a]) && !starts_on_border(m_links[b]);
    });
    for (std::size_t i : order)
    {
      if (used[i]) continue;
      std::vector<Piece> pieces;
      const bool open = starts_on_border(m_links[i]);
      for (std::size_t j = i; j != none && !used[j]; j = m_links[j].end == no_index ? none : m_link_of_gate[m_links[j].end])
      {
        used[j] = 1;
        pieces.insert(pieces.end(), m_pieces.begin() + m_links[j].first, m_pieces.begin() + m_links[j].last);
      }
      if (!is_point(pieces, m_levels[m_links[i].level])) out(m_links[i].level, !open, std::move(pieces));
    }
  }

  std::size_t number_of_pieces() const { return m_pieces.size(); }
  std::size_t number_of_forced_joints() const { return m_tracer.number_of_forced_joints(); }

private:
  static constexpr std::size_t none = std::size_t(-1);

  struct Crossing
  {
    std::size_t level;
    FT position; // along the halfedge of the face that comes first
    bool falling;
    Index gate;
  };
  struct Face_gate
  {
    std::size_t level;
    Level_gate<FT> gate;
  };
  struct Link // a chain of pieces
  {
    Index start, end; // gates
    std::size_t first, last, level;
  };

  void cut(Index face)
  {
    FT near, far;
    range_of(face, near, far);
    std::size_t first = m_levels.first_above(near), last = m_levels.first_above(far);
    if (first == last) return;
    const Face_field<FT> field(m_mesh, m_initial, m_field, face);
    first = (std::max)(first, m_levels.first_above(FT(field.lower_bound() - slack(far))));
    if (first >= last) return;
    const bool loops = field.has_local_sources() || may_have_interior_maximum(field);
    find_gates(field, first, last);
    std::stable_sort(m_face_gates.begin(), m_face_gates.end(),
                     [](const Face_gate& a, const Face_gate& b) { return a.level < b.level; });
    auto next = m_face_gates.begin();
    m_tracer.set_face(field);
    for (std::size_t i = first; i < last; ++i)
    {
      m_gates.clear();
      for (; next != m_face_gates.end() && next->level <= i; ++next) m_gates.push_back(next->gate);
      if (m_gates.empty() && !loops) continue;
      m_chains.clear();
      m_tracer(cut_level(i), m_gates, loops, m_chains);
      for (Chain& c : m_chains) store(c, i);
    }
  }

  // A point at exactly the level counts as farther. So a level is cut infinitesimally below; with rounded numbers, by a
  // distance that is above rounding: then levels that go through vertices and along edges, as they often do on CAD
  // meshes, are as good as any.
  FT cut_level(std::size_t i) const
  {
    const FT level = m_levels[i];
    return level - Number_policy<FT>::rounding(1024) * level;
  }

  void range_of(Index face, FT& near, FT& far) const
  {
    FT longest(0);
    far = Number_policy<FT>::infinity();
    near = FT(0);
    for (Index h = 3 * face; h < 3 * face + 3; ++h) longest = (std::max)(longest, m_mesh[h].length);
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
    {
      const FT& d = m_field.distance[m_mesh.source(h)];
      if (!Number_policy<FT>::is_finite(d)) continue;
      far = (std::min)(far, FT(d + (std::max)(m_mesh[h].length, m_mesh[m_mesh.previous(h)].length)));
      near = (std::max)(near, FT(d - longest * (FT(1) + Number_policy<FT>::rounding(16))));
    }
    if (!Number_policy<FT>::is_finite(far))
      far = FT(0);
    else
    {
      near -= slack(far);
      far += slack(far);
    }
  }

  // The faces beside an edge must agree on the levels that may cross it, whatever rounding does to their bounds.
  static FT slack(const FT& far) { return Number_policy<FT>::rounding(1 << 14) * far; }

  // The gates of a face at the levels [first, last): found now, or when the face on the other side was cut.
  void find_gates(const Face_field<FT>& field, std::size_t first, std::size_t last)
  {
    const Face_frame<FT>& frame = field.frame();
    const Index face = field.face();
    m_face_gates.clear();
    for (Index k = 0; k < 3; ++k)
    {
      const Index h = 3 * face + k, g = m_mesh.twin(h);
      const auto add = [&](const Crossing& c, bool reversed) {
        const FT t = reversed ? FT(m_mesh[h].length - c.position) : c.position;
        m_face_gates.push_back({c.level, {frame.on_edge(int(k), t), (unsigned char)(k), c.falling == reversed, c.gate}});
      };
      if (g != no_index && m_is_cut[m_mesh.face(g)])
      { // what was not found then is not there; the lists may be gone by now
        const auto stored = m_waiting.find(g);
        if (stored == m_waiting.end()) continue;
        for (const Crossing& c : stored->second) add(c, true);
        m_waiting.erase(stored);
        continue;
      }
      std::vector<Crossing> found;
      for (std::size_t i = first; i < last; ++i)
        m_crossings(h, field, cut_level(i), [&](const FT& t, bool falling) {
          found.push_back({i, t, falling, Index(m_link_of_gate.size())});
          m_link_of_gate.push_back(none);
        });
      for (const Crossing& c : found) add(c, false);
      if (g != no_index && !found.empty()) m_waiting.emplace(h, std::move(found));
    }
  }

  void store(const Chain& c, std::size_t level)
  {
    const std::size_t first = m_pieces.size();
    for (const Piece& p : c.pieces)
    {
      if (m_pieces.size() > first && continues(m_pieces.back(), p))
      {
        m_pieces.back().end = p.end;
        m_pieces.back().end_edge = p.end_edge;
      }
      else
        m_pieces.push_back(p);
    }
    if (c.start != no_index) m_link_of_gate[c.start] = m_links.size();
    m_links.push_back({c.start, c.end, first, m_pieces.size(), level});
  }

  // A level that just touches a vertex, or a point where the distance is largest, is cut as a loop without extent.
  static bool is_point(const std::vector<Piece>& pieces, const FT& level)
  {
    FT sum(0);
    for (const Piece& p : pieces) sum += length(p.end - p.start);
    return sum <= Number_policy<FT>::rounding(1 << 18) * level;
  }

  // Neighbouring pieces of one image are one arc, as long as it stays shorter than a half turn.
  static bool continues(const Piece& a, const Piece& b)
  {
    if (a.is_straight != b.is_straight || !(a.root == b.root) || a.pseudo_source != b.pseudo_source) return false;
    if (!a.is_straight && !CGAL::is_positive(cross(a.start - a.center, b.end - a.center))) return false;
    const FT allowance = Number_policy<FT>::rounding(64) * (CGAL::abs(a.radius) + CGAL::abs(a.center.x) +
                                                            CGAL::abs(a.center.y));
    return CGAL::abs(a.radius - b.radius) <= allowance && CGAL::abs(a.center.x - b.center.x) <= allowance &&
           CGAL::abs(a.center.y - b.center.y) <= allowance;
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
  const Offset_levels<FT>& m_levels;
  Edge_crossings<FT> m_crossings;
  Level_tracer<FT> m_tracer;
  std::vector<Face_gate> m_face_gates;
  std::vector<Level_gate<FT>> m_gates;
  std::vector<Chain> m_chains;
  std::vector<char> m_is_cut; // per face
  std::unordered_map<Index, std::vector<Crossing>> m_waiting; // by the halfedge of the face that came first
  std::vector<std::size_t> m_link_of_gate;                    // the chain that starts at the gate
  std::vector<Link> m_links;
  std::vector<Piece> m_pieces;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
