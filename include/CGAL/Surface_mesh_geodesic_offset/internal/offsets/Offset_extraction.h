// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 5 of the pipeline: offset curves from finished faces. Each face yields chains of pieces between gates, the
// crossings of a level with its edges. A level whose faces are all finished is given out and released.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_EXTRACTION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_EXTRACTION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Edge_crossings.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Interior_maximum.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_tracer.h>

#include <algorithm>
#include <limits>
#include <map>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class FT>
class Offset_extraction
{
  static_assert(!std::is_floating_point<FT>::value || std::numeric_limits<FT>::digits >= 53,
                "offset curves need numbers with the precision of double, at least");

public:
  typedef Level_piece<FT> Piece;

  Offset_extraction(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field,
                    const Offset_levels<FT>& levels, const FT& maximum)
    : m_mesh(mesh), m_field(field), m_levels(levels), m_end(levels.first_above(maximum)),
      m_face(mesh, initial, field), m_crossings(mesh, initial, field),
      m_is_cut(mesh.number_of_faces(), 0)
  {
  }

  // Cuts one finished face at all levels that pass through it.
  void operator()(Index face)
  {
    cut(face);
    m_is_cut[face] = 1;
  }

  // Gives out the levels that are finished if all faces with points nearer than `settled` have been cut: calls
  // out(level index, curves) with Level_curves, for each level that has any, by increasing level.
  template <class Function>
  void release(const FT& settled, const Function& out)
  {
    while (!m_curves.empty())
    {
      const auto first = m_curves.begin();
      if (!(m_levels[first->first] < settled && first->second.is_complete())) return;
      give_out(first, out);
    }
  }

  // Gives out all levels that are left up to a distance, once all faces have been cut.
  template <class Function>
  void release_all(const FT& maximum, const Function& out)
  {
    while (!m_curves.empty() && m_levels[m_curves.begin()->first] <= maximum) give_out(m_curves.begin(), out);
  }

  std::size_t number_of_pieces() const { return m_number_of_pieces; }
  std::size_t number_of_forced_joints() const { return m_tracer.number_of_forced_joints(); }

private:
  typedef std::map<std::size_t, Level_curves<FT>> Curves_of_levels;

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

  template <class Function>
  void give_out(typename Curves_of_levels::iterator level, const Function& out)
  {
    m_number_of_pieces += level->second.number_of_pieces();
    out(level->first, level->second);
    m_curves.erase(level);
  }

  void cut(Index face)
  {
    FT near, far;
    range_of(face, near, far);
    std::size_t first = m_levels.first_above(near), last = (std::min)(m_end, m_levels.first_above(far));
    if (first >= last) return;
    m_face.set_face(face);
    const Face_field<FT>& field = m_face;
    first = (std::max)(first, m_levels.first_above(FT(field.lower_bound() - slack(far))));
    if (first >= last) return;
    const bool loops = field.has_local_sources() || may_have_interior_maximum(field);
    find_gates(field, first, last);
    std::stable_sort(m_face_gates.begin(), m_face_gates.end(),
                     [](const Face_gate& a, const Face_gate& b) { return a.level < b.level; });
    auto next = m_face_gates.begin();
    m_tracer.set_face(field, cut_level(first), cut_level(last - 1));
    for (std::size_t i = first; i < last; ++i)
    {
      m_gates.clear();
      for (; next != m_face_gates.end() && next->level <= i; ++next) m_gates.push_back(next->gate);
      if (m_gates.empty() && !loops) continue;
      m_tracer(cut_level(i), m_gates, loops, [&](Index start, Index end, const std::vector<Piece>& pieces) {
        m_curves[i].add_chain(start, end, pieces);
      });
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
    far = m_field.maximum;
    near = FT(0);
    for (Index h = 3 * face; h < 3 * face + 3; ++h) longest = (std::max)(longest, m_mesh[h].length);
    longest *= FT(1) + Number_policy<FT>::rounding(16);
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
    {
      const FT& d = m_field.distance[m_mesh.source(h)];
      if (Number_policy<FT>::is_finite(d))
        far = (std::min)(far, FT(d + (std::max)(m_mesh[h].length, m_mesh[m_mesh.previous(h)].length)));
      const FT lowest = (std::min)(d, m_field.maximum); // what has no distance is farther than the maximum
      if (Number_policy<FT>::is_finite(lowest)) near = (std::max)(near, FT(lowest - longest));
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
        for (const Crossing& c : stored->second)
        {
          add(c, true);
          m_curves[c.level].gate_found();
        }
        m_waiting.erase(stored);
        continue;
      }
      std::vector<Crossing> found;
      for (std::size_t i = first; i < last; ++i)
        m_crossings(h, field, cut_level(i), [&](const FT& t, bool falling) {
          found.push_back({i, t, falling, m_curves[i].new_gate(g == no_index)});
        });
      for (const Crossing& c : found) add(c, false);
      if (g != no_index && !found.empty()) m_waiting.emplace(h, std::move(found));
    }
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Geodesic_field<FT>& m_field;
  const Offset_levels<FT>& m_levels;
  const std::size_t m_end; // of the levels up to the distance limit
  Face_field<FT> m_face; // of the face being cut
  Edge_crossings<FT> m_crossings;
  Level_tracer<FT> m_tracer;
  std::vector<Face_gate> m_face_gates;
  std::vector<Level_gate<FT>> m_gates;
  std::vector<char> m_is_cut; // per face
  std::unordered_map<Index, std::vector<Crossing>> m_waiting; // by the halfedge of the face that came first
  Curves_of_levels m_curves;                                  // of the levels that are not finished
  std::size_t m_number_of_pieces = 0;                         // given out
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
