// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offset curves of distances that are continuous in each face, but not across edges, as those of a build with a tolerance. Each
// face finds the crossings of a level with its edges by itself. The curves of a level bound the union of the parts of all faces
// that are nearer; so they run along an edge between two crossings where only one of its two faces is near.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_EDGE_JOINING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_EDGE_JOINING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Crossing.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

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

} // namespace CGAL::Geodesic_offset::internal

#endif
