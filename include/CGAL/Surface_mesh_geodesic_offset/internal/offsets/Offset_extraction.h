// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 5 of the pipeline: offset curves from finalized faces. Each face yields chains of pieces between gates, the crossings of
// a level with its edges. A level is passed on and released when all its faces are finalized.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_EXTRACTION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_EXTRACTION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Face_cutting.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <type_traits>
#include <unordered_map>
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
  Offset_extraction(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field,
                    const Offset_levels<FT>& levels, const FT& maximum)
    : m_mesh(mesh), m_initial(initial), m_field(field), m_reach(mesh), m_sources(initial, field, m_reach), m_levels(levels),
      m_maximum(maximum), m_turn(mesh.number_of_faces(), no_turn)
  {
  }

  // Cuts finalized faces, each once, at all levels that cross them. Curves do not depend on the threads.
  template <class Team>
  void cut(const std::vector<Index>& faces, Team& team)
  {
    make_cuttings(team.size());
    const std::size_t at_once = items_at_once(team.size());
    for (const Index f : faces)
    {
      CGAL_precondition(m_turn[f] == no_turn);
      m_turn[f] = m_next_turn++;
      const Level_range levels = m_cuttings.front()->levels_of(f);
      if (!levels.is_empty()) m_crossed.push_back({f, levels});
      if (m_crossed.size() == at_once) cut_crossed(team);
    }
    cut_crossed(team);
  }

  // Passes on the levels that are finished when all faces with points nearer than `settled` are cut: calls out(level index,
  // Level_curves) for each level with curves, by increasing level.
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

  // Passes on all remaining levels up to a distance, when all faces are cut.
  template <class Function>
  void release_all(const FT& maximum, const Function& out)
  {
    while (!m_curves.empty() && m_levels[m_curves.begin()->first] <= maximum) give_out(m_curves.begin(), out);
  }

  std::size_t number_of_pieces() const { return m_number_of_pieces; }
  std::size_t number_of_forced_joints() const
  {
    std::size_t n = 0;
    for (const auto& c : m_cuttings) n += c->number_of_forced_joints();
    return n;
  }

  std::size_t number_of_crossed_cells() const
  {
    std::size_t n = 0;
    for (const auto& c : m_cuttings) n += c->number_of_crossed_cells();
    return n;
  }

private:
  typedef std::map<std::size_t, Level_curves<FT>> Curves_of_levels;
  typedef std::unordered_map<Index, std::vector<Crossing<FT>>> Waiting_crossings; // by halfedge of the first face

  static constexpr Index no_turn = no_index;
  static constexpr std::size_t worthwhile = 16; // levels in faces; the wake-up of other threads costs more than fewer

  struct Crossed_face
  {
    Index face;
    Level_range levels;
  };

  void make_cuttings(unsigned number)
  {
    while (m_cuttings.size() < number)
      m_cuttings.push_back(
        std::make_unique<Face_cutting<FT>>(m_mesh, m_initial, m_field, m_reach, m_sources, m_levels, m_maximum));
  }

  template <class Team>
  void cut_crossed(Team& team)
  {
    const Index number = Index(m_crossed.size());
    while (m_cuts.size() < number) m_cuts.push_back(std::make_unique<Face_cut<FT>>(m_mesh, m_initial, m_field));
    std::size_t work = 0;
    for (const Crossed_face& c : m_crossed) work += c.levels.size();
    const auto weight = [this](Index i) { return this->m_crossed[i].levels.size(); };
    team.for_each(number, weight, work >= worthwhile, [this](unsigned worker, Index i) {
      const Crossed_face& c = this->m_crossed[i];
      this->m_cuts[i]->levels = c.levels;
      this->m_cuttings[worker]->find_crossings(
        c.face, [this](Index h) { return this->is_first_at(h); }, *this->m_cuts[i]);
    });
    for (Index i = 0; i < number; ++i) number_gates(*m_cuts[i]);
    for (const auto& c : m_cuttings) c->clear_pieces();
    team.for_each(number, weight, work >= worthwhile,
                  [this](unsigned worker, Index i) { this->m_cuttings[worker]->find_chains(*this->m_cuts[i]); });
    for (Index i = 0; i < number; ++i)
      for (const auto& c : m_cuts[i]->chains)
      {
        const Level_piece<FT>* const pieces = m_cuts[i]->pieces->data();
        m_curves[c.level].add_chain(c.start, c.end, pieces + c.first, pieces + c.last);
      }
    m_crossed.clear();
  }

  // True if the face of a halfedge is cut before the face on the other side.
  bool is_first_at(Index h) const
  {
    const Index g = m_mesh.twin(h);
    return g == no_index || m_turn[m_mesh.face(h)] < m_turn[m_mesh.face(g)];
  }

  // Numbers the gates of a face, from crossings of this face or of the neighbour that was cut before. Only the first face of an
  // edge finds crossings. Faces come in their order of turns.
  void number_gates(Face_cut<FT>& cut)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index h = 3 * cut.field.face() + Index(k), g = m_mesh.twin(h);
      if (is_first_at(h))
      {
        if (cut.crossings[k].empty()) continue;
        for (Crossing<FT>& c : cut.crossings[k]) c.gate = m_curves[c.level].new_gate(g == no_index);
        cut.add_gates(k, cut.crossings[k], g < h);
        if (g != no_index) m_waiting.emplace(h, cut.crossings[k]);
      }
      else if (const auto stored = m_waiting.find(g); stored != m_waiting.end())
      {
        cut.add_gates(k, stored->second, g < h);
        for (const Crossing<FT>& c : stored->second) m_curves[c.level].gate_found();
        m_waiting.erase(stored);
      }
    }
  }

  template <class Function>
  void give_out(typename Curves_of_levels::iterator level, const Function& out)
  {
    CGAL_precondition(level == m_curves.begin());
    m_number_of_pieces += level->second.number_of_pieces();
    out(level->first, level->second);
    m_curves.erase(level);
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
  const Vertex_reach<FT> m_reach;
  const Offset_sources<FT> m_sources;
  const Offset_levels<FT>& m_levels;
  const FT m_maximum;
  std::vector<Index> m_turn; // per face: its turn
  Index m_next_turn = 0;
  std::vector<Crossed_face> m_crossed;                       // to be cut next
  std::vector<std::unique_ptr<Face_cutting<FT>>> m_cuttings; // per worker
  std::vector<std::unique_ptr<Face_cut<FT>>> m_cuts;         // per face of a batch
  Waiting_crossings m_waiting;
  Curves_of_levels m_curves;          // of unfinished levels
  std::size_t m_number_of_pieces = 0; // passed on
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
