// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 5 of the pipeline: offset curves from faces. Each face yields chains of pieces between gates, the crossings of a level
// with its edges. A level is passed on and released when it is cut in all its faces.
//
// A face is cut at all levels when it is finalized. A face that is large against the spacing of levels is finalized late; so
// that many levels do not wait for it, it is also cut at those levels at which its distances are final already.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_EXTRACTION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_OFFSET_EXTRACTION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Crossing.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Face_cutting.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Level_groups.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Offset curves of distances that are continuous in each face, but not across edges, as those of a build with a tolerance. Each
// face finds the crossings of a level with its edges by itself. The curves of a level bound the union of the parts of all faces
// that are nearer; so they run along an edge between two crossings where only one of its two faces is near.
template <class FT>
class Edge_joining
{
public:
  Edge_joining(const Unfolded_mesh<FT>& mesh, const Offset_levels<FT>& levels) : m_mesh(mesh), m_levels(levels) {}

  // Adds the crossings that the face of h has found on the edge of h.
  void add(Index h, const std::vector<Crossing<FT>>& found)
  {
    if (found.empty()) return;
    const Index g = m_mesh.twin(h);
    std::vector<Gate_on_edge>& gates = m_gates[(std::min)(h, g)];
    for (const Crossing<FT>& c : found) gates.push_back({c.level, c.position, c.starts_chain(g < h), c.gate});
  }

  // Joins the chains of both faces of the edge of h at the levels before `end`, at which both are cut: calls
  // connect(level, gate at the end of a chain, gate at the start of a chain, piece from there to there). The piece is null if
  // both gates are the same point up to rounding; it has no source.
  template <class Function>
  void join(Index h, std::size_t end, const Function& connect)
  {
    const Index edge = (std::min)(h, m_mesh.twin(h));
    const auto stored = m_gates.find(edge);
    if (stored == m_gates.end()) return;
    std::vector<Gate_on_edge>& gates = stored->second;
    const auto last = std::partition(gates.begin(), gates.end(), [end](const Gate_on_edge& g) { return g.level < end; });
    std::stable_sort(gates.begin(), last); // gates of one face alternate
    const Face_frame<FT> frame(m_mesh, m_mesh.face(edge));
    CGAL_assertion((last - gates.begin()) % 2 == 0);
    for (auto g = gates.begin(); g != last; g += 2)
    { // before the first gate and between pairs, both faces are near, or none of them
      CGAL_assertion(g[0].level == g[1].level && g[0].is_start != g[1].is_start);
      const bool is_forward = g[1].is_start; // along the halfedge with the smaller index
      const Gate_on_edge &from = g[is_forward ? 0 : 1], &to = g[is_forward ? 1 : 0];
      if (g[1].position - g[0].position > Offset_tolerances<FT>::interval_gap(FT(m_mesh[edge].length + m_levels[from.level])))
      {
        const Level_piece<FT> piece = piece_along(edge, frame, from.position, to.position);
        connect(from.level, from.gate, to.gate, &piece);
      }
      else connect(from.level, from.gate, to.gate, static_cast<const Level_piece<FT>*>(nullptr));
    }
    if (last == gates.end()) m_gates.erase(stored);
    else gates.erase(gates.begin(), last);
  }

private:
  struct Gate_on_edge
  {
    std::size_t level;
    FT position;   // along the halfedge with the smaller index
    bool is_start; // of a chain
    Index gate;

    friend bool operator<(const Gate_on_edge& a, const Gate_on_edge& b)
    {
      return a.level < b.level || (a.level == b.level && a.position < b.position);
    }
  };

  // The near face is on the left.
  Level_piece<FT> piece_along(Index h, const Face_frame<FT>& frame, const FT& from, const FT& to) const
  {
    const int k = int(h % 3);
    const Point_in_face<FT>& u = frame.direction(k);
    Level_piece<FT> p{};
    p.start = frame.on_edge(k, from);
    p.end = frame.on_edge(k, to);
    p.center = from < to ? Point_in_face<FT>{u.y, -u.x} : Point_in_face<FT>{-u.y, u.x};
    p.radius = dot(p.center, p.start);
    p.face = m_mesh.face(h);
    p.is_straight = true;
    p.start_edge = p.end_edge = (unsigned char)(k);
    return p;
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Offset_levels<FT>& m_levels;
  std::unordered_map<Index, std::vector<Gate_on_edge>> m_gates; // by the smaller halfedge of the edge
};

template <class FT>
class Offset_extraction
{
  static_assert(!std::is_floating_point<FT>::value || std::numeric_limits<FT>::digits >= 53,
                "offset curves need numbers with the precision of double, at least");

public:
  Offset_extraction(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field,
                    const Offset_levels<FT>& levels, const FT& maximum, const Merging_tolerance<FT>& tolerance)
    : m_mesh(mesh), m_initial(initial), m_field(field), m_reach(mesh), m_sources(initial, field, m_reach), m_levels(levels),
      m_maximum(maximum), m_tolerance(tolerance), m_next_level(mesh.number_of_faces(), 0),
      m_groups(initial, field, m_next_level), m_joining(mesh, levels)
  {
    make_cuttings(1);
  }

  // Cuts finalized faces, each once, at all levels that cross them, except those at which they were cut before. Curves do not
  // depend on the threads.
  template <class Team>
  void cut(const std::vector<Index>& faces, Team& team)
  {
    set_faces(faces, Number_policy<FT>::infinity());
    cut_below(Number_policy<FT>::infinity(), all_levels, all_levels, team);
  }

  // True if cut_pending() is likely to be worth its time: pieces wait for the cutting of faces, or `number` faces have to be cut
  // at levels nearer than `settled`. `finalized`: those of them that are cut next, at all levels; if they may have more pieces
  // than may wait, all these faces must be cut level by level.
  bool needs_pending_faces(const FT& settled, std::size_t number, const std::vector<Index>& finalized)
  {
    const std::size_t end = m_levels.first_above(settled), many = most_waiting_pieces();
    m_possible_pieces =
      end > m_first_waiting ? (std::max)(1., m_groups.pieces_per_crossing()) * double(end - m_first_waiting) * double(number)
                            : 0.;
    m_must_cut_pending = false;
    if (end > m_first_waiting)
    {
      set_faces(finalized, settled);
      m_must_cut_pending = m_groups.expects_more_than(many);
    }
    return m_must_cut_pending || (m_waiting_pieces >= many && m_new_pieces >= many) || m_possible_pieces >= m_next_attempt;
  }

  // Cuts faces that are not cut at all levels, at all levels nearer than `settled`. Their distances nearer than `settled` are
  // final, and all faces with such distances are cut at all levels or among these faces.
  //
  // Few levels are cut at a time, so that about as many pieces are added as may wait; then calls is_cut(distance): the levels
  // nearer than the distance are cut in all faces, and release() may pass them on. Does nothing if too few pieces are to be
  // expected; the time is at most constant per piece.
  template <class Team, class Function>
  void cut_pending(const std::vector<Index>& faces, const FT& settled, Team& team, const Function& is_cut)
  {
    const std::size_t end = m_levels.first_above(settled), last = (std::min)(end, std::size_t(all_levels) - 1);
    const std::size_t many = most_waiting_pieces();
    set_faces(faces, settled);
    m_groups.find_dense_faces();
    const auto next_group = [&](std::size_t first) { return m_groups.next(first, last, pieces_that_may_be_added()); };
    Level_group group = next_group(m_first_waiting);
    if (!m_must_cut_pending && group.end == last &&
        double((std::min)(m_waiting_pieces, m_new_pieces)) + group.expected.pieces < double(many))
    {
      m_next_attempt = 2 * m_possible_pieces;
      return;
    }
    while (true)
    {
      const std::size_t cut_end = cut_group(settled, group, team);
      if (cut_end == last) break;
      is_cut(m_levels[cut_end]);
      group = next_group(cut_end);
    }
    is_cut(last < end ? m_levels[last] : settled);
    m_next_attempt = double(many);
    m_new_pieces = 0;
  }

  // Passes on the levels that are finished when all faces with points nearer than `settled` are cut: calls out(level index,
  // Level_curves) for each level with curves, by increasing level.
  template <class Function>
  void release(const FT& settled, const Function& out)
  {
    std::size_t end = m_levels.first_above(settled);
    while (end > m_first_waiting && !(m_levels[end - 1] < settled)) --end;
    m_first_waiting = (std::max)(m_first_waiting, end);
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
  std::size_t largest_number_of_waiting_pieces() const { return m_waiting_pieces_peak; }
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

  static constexpr Index all_levels = no_index;
  static constexpr std::size_t worthwhile = 16; // levels in faces; the wake-up of other threads costs more than fewer
  // With more levels than this in the faces of a batch, the batch has fewer faces: their crossings are in memory.
  static constexpr std::size_t levels_per_face = 2;
  // Faces of the mesh per piece that may wait: 18 bytes a face, where the mesh and the field take some 150. And the number of
  // pieces that may always wait: 72 kB.
  static constexpr std::size_t faces_per_waiting_piece = 4, least_waiting_pieces = 1 << 10;
  struct Crossed_face
  {
    Index face;
    Level_range levels;
    FT settled;                             // the distances are final up to here
    Index next_level;                       // of the face when it is cut: crossings with levels before are due
    std::array<std::size_t, 3> next_beside; // of the neighbours: their crossings with levels before are found
  };

  std::size_t most_waiting_pieces() const
  {
    return (std::max)(m_next_level.size() / faces_per_waiting_piece, std::size_t(least_waiting_pieces));
  }

  // The levels nearer than `settled` that may cross a face, and at which it is not cut.
  Level_range levels_left(Index f, const FT& settled) const
  {
    Level_range levels = m_cuttings.front()->levels_of(f, settled);
    levels.first = (std::max)(levels.first, std::size_t(m_next_level[f]));
    return levels;
  }

  // Sets the faces of the next groups and of cut_below(), with the levels nearer than `settled`.
  void set_faces(const std::vector<Index>& faces, const FT& settled)
  {
    m_groups.clear();
    for (const Index f : faces) m_groups.add(f, levels_left(f, settled));
  }

  // By a group of levels: as many as may wait, fewer if more wait, and some in any case, since each group visits all faces.
  std::size_t pieces_that_may_be_added() const
  {
    const std::size_t most = most_waiting_pieces(), least = most / 8;
    if (m_waiting_pieces <= most) return most;
    return m_waiting_pieces + least < 2 * most ? 2 * most - m_waiting_pieces : least;
  }

  // Cuts faces at the levels of a group, or at the first ones. Returns the end of the levels that are cut in all faces.
  template <class Team>
  std::size_t cut_group(const FT& settled, const Level_group& group, Team& team)
  {
    const std::size_t before = m_new_pieces;
    const Index end = cut_below(settled, Index(group.first), Index(group.end), team);
    m_groups.count(group, m_new_pieces - before, end == group.end);
    return end;
  }

  // Cuts the faces at the levels before the level with index `end`. If these have more pieces than may wait, cuts the other faces
  // at fewer levels, up to level `first` at least. Returns the end of the levels that are cut in all faces.
  template <class Team>
  Index cut_below(const FT& settled, Index first, Index end, Team& team)
  {
    make_cuttings(team.size());
    const std::size_t faces_at_once = items_at_once(team.size()), levels_at_once = levels_per_face * faces_at_once;
    const std::size_t most = m_new_pieces + pieces_that_may_be_added();
    std::size_t work = 0;
    for (auto [f, levels] : m_groups.faces())
    {
      CGAL_precondition(m_next_level[f] != all_levels);
      if (end <= m_next_level[f]) continue;
      levels.first = (std::max)(levels.first, std::size_t(m_next_level[f]));
      if (end != all_levels) levels.last = (std::min)(levels.last, std::size_t(end));
      if (!levels.is_empty()) m_crossed.push_back({f, levels, settled, end, next_levels_beside(f)});
      m_next_level[f] = end;
      if (!m_tolerance.is_zero()) m_to_join.push_back(f);
      work += levels.size();
      if (m_crossed.size() < faces_at_once && work < levels_at_once) continue;
      cut_crossed(team);
      work = 0;
      if (m_new_pieces > most && end > first) end = first + 1;
    }
    cut_crossed(team);
    return end;
  }

  // Indices of levels may be larger than an Index.
  std::array<std::size_t, 3> next_levels_beside(Index f) const
  {
    std::array<std::size_t, 3> next;
    for (Index k = 0; k < 3; ++k)
    {
      const Index g = m_mesh.twin(3 * f + k);
      // with a tolerance, each face finds all crossings with its edges
      next[k] = g == no_index || !m_tolerance.is_zero() ? 0 : level_of(m_next_level[m_mesh.face(g)]);
    }
    return next;
  }

  static std::size_t level_of(Index next_level)
  {
    return next_level == all_levels ? (std::numeric_limits<std::size_t>::max)() : next_level;
  }

  void make_cuttings(unsigned number)
  {
    while (m_cuttings.size() < number)
      m_cuttings.push_back(std::make_unique<Face_cutting<FT>>(m_mesh, m_initial, m_field, m_reach, m_sources, m_levels,
                                                              m_maximum, m_tolerance));
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
      this->m_cuttings[worker]->find_crossings(c.face, c.settled, c.next_beside, *this->m_cuts[i]);
    });
    for (Index i = 0; i < number; ++i) number_gates(m_crossed[i], *m_cuts[i]);
    for (const auto& c : m_cuttings) c->clear_pieces();
    team.for_each(number, weight, work >= worthwhile,
                  [this](unsigned worker, Index i) { this->m_cuttings[worker]->find_chains(*this->m_cuts[i]); });
    for (Index i = 0; i < number; ++i)
      for (const auto& c : m_cuts[i]->chains)
      {
        const Level_piece<FT>* const pieces = m_cuts[i]->pieces->data();
        Level_curves<FT>& curves = m_curves[c.level];
        const std::size_t before = curves.number_of_pieces();
        curves.add_chain(c.start, c.end, pieces + c.first, pieces + c.last);
        m_waiting_pieces += curves.number_of_pieces() - before;
        m_new_pieces += curves.number_of_pieces() - before;
      }
    for (const Index f : m_to_join) join_with_neighbors(f);
    m_to_join.clear();
    m_waiting_pieces_peak = (std::max)(m_waiting_pieces_peak, m_waiting_pieces);
    m_crossed.clear();
  }

  void join_with_neighbors(Index f)
  {
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Index g = m_mesh.twin(h);
      if (g == no_index) continue;
      const Index end = (std::min)(m_next_level[f], m_next_level[m_mesh.face(g)]);
      m_joining.join(h, level_of(end), [this](std::size_t level, Index from, Index to, const Level_piece<FT>* along_edge) {
        this->m_curves[level].connect(from, to, along_edge);
        const std::size_t pieces = along_edge ? 1 : 0;
        this->m_waiting_pieces += pieces;
        this->m_new_pieces += pieces;
      });
    }
  }

  // Numbers the gates of a face. Of the two faces of an edge, the first one that is cut at a level finds the crossings with this
  // level; the other one receives them.
  void number_gates(const Crossed_face& face, Face_cut<FT>& cut)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Index h = 3 * face.face + k, g = m_mesh.twin(h);
      std::vector<Crossing<FT>>& crossings = cut.crossings[k];
      for (Crossing<FT>& c : crossings) c.gate = m_curves[c.level].new_gate(g == no_index);
      if (g == no_index) continue;
      if (!crossings.empty())
      {
        if (!m_tolerance.is_zero()) m_joining.add(h, crossings);
        else
        {
          std::vector<Crossing<FT>>& waiting = m_waiting[h];
          waiting.insert(waiting.end(), crossings.begin(), crossings.end());
        }
      }
      if (face.next_beside[k] > 0) receive_gates(face, g, crossings);
    }
  }

  // Adds the crossings of a face with an edge that the neighbour has found, by halfedge g. They come first, as their levels are
  // lower.
  void receive_gates(const Crossed_face& face, Index g, std::vector<Crossing<FT>>& crossings)
  {
    const auto stored = m_waiting.find(g);
    if (stored == m_waiting.end()) return;
    std::vector<Crossing<FT>>& received = stored->second; // by level
    const auto last = std::partition_point(received.begin(), received.end(), [&face](const Crossing<FT>& c) {
      return face.next_level == all_levels || c.level < face.next_level;
    });
    std::for_each(received.begin(), last, [this](const Crossing<FT>& c) { this->m_curves[c.level].gate_found(); });
    crossings.insert(crossings.begin(), received.begin(), last);
    if (last == received.end()) m_waiting.erase(stored);
    else received.erase(received.begin(), last);
  }

  template <class Function>
  void give_out(typename Curves_of_levels::iterator level, const Function& out)
  {
    CGAL_precondition(level == m_curves.begin());
    m_number_of_pieces += level->second.number_of_pieces();
    m_waiting_pieces -= level->second.number_of_pieces();
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
  const Merging_tolerance<FT> m_tolerance;                   // of the field
  std::vector<Index> m_next_level;                           // per face: the first level at which it is not cut
  Level_groups<FT> m_groups;                                 // of faces that are cut
  std::vector<Crossed_face> m_crossed;                       // to be cut next
  std::vector<std::unique_ptr<Face_cutting<FT>>> m_cuttings; // per worker
  std::vector<std::unique_ptr<Face_cut<FT>>> m_cuts;         // per face of a batch
  Waiting_crossings m_waiting;
  Edge_joining<FT> m_joining;                                  // with a tolerance
  std::vector<Index> m_to_join;                                // faces that were cut since
  Curves_of_levels m_curves;                                   // of levels that are not passed on
  std::size_t m_number_of_pieces = 0;                          // passed on
  std::size_t m_waiting_pieces = 0, m_waiting_pieces_peak = 0; // not passed on
  std::size_t m_new_pieces = 0;                                // since the last cut_pending()
  std::size_t m_first_waiting = 0;                             // level: those before have been passed on
  bool m_must_cut_pending = false;                             // see needs_pending_faces()
  double m_possible_pieces = 0;                                // in pending faces at levels that are not passed on
  double m_next_attempt = double(most_waiting_pieces());       // so many of them may be worth the time of cut_pending()
};

} // namespace CGAL::Geodesic_offset::internal

#endif
