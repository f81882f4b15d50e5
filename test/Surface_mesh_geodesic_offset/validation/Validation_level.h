// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves of one level: pieces by face, crossings by edge, and the side of each vertex.

#ifndef GEODESIC_OFFSET_TEST_VALIDATION_VALIDATION_LEVEL_H
#define GEODESIC_OFFSET_TEST_VALIDATION_VALIDATION_LEVEL_H

#include "Validation_piece.h"
#include "Validation_surface.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Entry of a curve into a face (`is_start`), or exit from it.
struct Validation_gate
{
  Index halfedge; // of the face
  double t;       // from its source, 0, to its target, 1
  bool is_start;
};

// Crossing of a curve with an edge.
struct Validation_crossing
{
  Index edge; // the smaller of its halfedge indices
  double t;   // along this halfedge
  int step;   // 1 if the near region begins along the halfedge, -1 if it ends
};

struct Validation_level
{
  // Side of a vertex with several fans that is on the level up to rounding: the fans may have different sides, since no
  // curve leads from one fan to another.
  static constexpr char either_side = 2;

  double level, cut; // requested distance, and distance of the cut
  std::size_t number;
  std::size_t curves = 0;
  std::vector<Validation_piece> pieces;
  std::vector<Validation_gate> gates;
  std::vector<Validation_crossing> crossings;
  std::vector<Index> loops;  // faces of curves that stay in one face
  std::vector<char> is_near; // per vertex: 0, 1, or either_side

  // Records the exit of a curve from the face of a halfedge, or the entry. The smaller distances are on the left of the
  // curve, so the near part of the halfedge follows an exit.
  void add_gate(Index halfedge, double t, bool is_start) { gates.push_back({halfedge, t, is_start}); }
  template <class Surface>
  void add_crossing(const Surface& surface, Index halfedge, double t, bool is_start)
  {
    const Index twin = surface.twin(halfedge);
    const int step = is_start ? -1 : 1;
    if (twin < halfedge) crossings.push_back({twin, 1 - t, -step});
    else crossings.push_back({halfedge, t, step});
  }

  void sort()
  {
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const Validation_piece& a, const Validation_piece& b) { return a.face < b.face; });
    std::sort(gates.begin(), gates.end(), [](const Validation_gate& a, const Validation_gate& b) {
      return std::make_pair(a.halfedge, a.t) < std::make_pair(b.halfedge, b.t);
    });
    std::sort(crossings.begin(), crossings.end(), [](const Validation_crossing& a, const Validation_crossing& b) {
      return std::make_pair(a.edge, a.t) < std::make_pair(b.edge, b.t);
    });
  }

  // Precondition of the functions below: sort() was called.

  auto pieces_in(Index face) const
  {
    struct By_face
    {
      bool operator()(const Validation_piece& a, Index f) const { return a.face < f; }
      bool operator()(Index f, const Validation_piece& a) const { return f < a.face; }
    };
    return std::equal_range(pieces.begin(), pieces.end(), face, By_face());
  }

  // Counterclockwise around the face.
  auto gates_of(Index face) const
  {
    struct By_face
    {
      bool operator()(const Validation_gate& a, Index f) const { return a.halfedge / 3 < f; }
      bool operator()(Index f, const Validation_gate& a) const { return f < a.halfedge / 3; }
    };
    return std::equal_range(gates.begin(), gates.end(), face, By_face());
  }

  auto crossings_of(Index edge) const
  {
    struct By_edge
    {
      bool operator()(const Validation_crossing& a, Index e) const { return a.edge < e; }
      bool operator()(Index e, const Validation_crossing& a) const { return e < a.edge; }
    };
    return std::equal_range(crossings.begin(), crossings.end(), edge, By_edge());
  }

  // Whether the level may pass through a face.
  template <class Surface>
  bool may_cross(const Surface& surface, const Validation_face& face) const
  {
    const auto range = pieces_in(face.face);
    if (range.first != range.second) return true;
    double low, high;
    surface.range_of(face, low, high);
    return low < cut && cut <= high && std::isfinite(low);
  }

  // Determines the side of each vertex. Curves without extent are not reported, so a vertex whose distance equals the cut
  // up to rounding may be on either side; the crossings of one of its edges decide, and the checks of edges test whether
  // the others agree. Returns the number of such vertices.
  template <class Surface>
  std::size_t find_sides(const Surface& surface)
  {
    const double doubt = (std::max)(1e-12 * surface.diagonal(), std::ldexp(level, -34));
    const std::size_t nv = surface.number_of_vertices();
    is_near.assign(nv, 0);
    std::vector<char> is_decided(nv, 1);
    std::size_t undecided = 0;
    for (Index v = 0; v < nv; ++v)
    {
      const double d = surface.vertex_distance(v);
      is_near[v] = d < cut;
      if (!(std::abs(d - cut) <= doubt)) continue;
      ++undecided;
      if (surface.is_shared(v)) is_near[v] = either_side;
      else is_decided[v] = 0;
    }
    if (undecided > 0) spread_sides(surface, doubt, is_decided);
    return undecided;
  }

  std::size_t most_loops_in_face() const
  {
    std::unordered_map<Index, std::size_t> count;
    std::size_t most = 0;
    for (const Index f : loops) most = (std::max)(most, ++count[f]);
    return most;
  }

  // Sum of the steps of all crossings of an edge.
  int sum_of_steps(Index edge) const
  {
    const auto range = crossings_of(edge);
    int sum = 0;
    for (auto c = range.first; c != range.second; ++c) sum += c->step;
    return sum;
  }

private:
  template <class Surface>
  void spread_sides(const Surface& surface, double doubt, std::vector<char>& is_decided)
  {
    struct Neighbor
    {
      Index vertex;
      int step; // from the neighbor
    };
    std::unordered_map<Index, std::vector<Neighbor>> around; // of the undecided vertices
    std::vector<Index> next;
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      for (Index h = 3 * f; surface.is_used(f) && h < 3 * f + 3; ++h)
      {
        if (surface.twin(h) < h) continue;
        const Index u = surface.origin(h), v = surface.target(h);
        if (is_decided[u] && is_decided[v]) continue;
        if (is_near[u] == either_side || is_near[v] == either_side) continue;
        const int sum = sum_of_steps(h);
        if (!is_decided[u]) around[u].push_back({v, -sum});
        if (!is_decided[v]) around[v].push_back({u, sum});
        for (Index w : {u, v})
          if (!is_decided[w] && is_decided[w == u ? v : u]) next.push_back(w);
      }
    const auto spread = [&] {
      while (!next.empty())
      {
        const Index v = next.back();
        next.pop_back();
        if (is_decided[v]) continue;
        for (const Neighbor& n : around[v])
          if (is_decided[n.vertex])
          {
            is_near[v] = char(is_near[n.vertex] + n.step == 1);
            is_decided[v] = 1;
            break;
          }
        for (const Neighbor& n : around[v])
          if (!is_decided[n.vertex]) next.push_back(n.vertex);
      }
    };
    spread();
    // In a component without decided vertices, start from the midpoint of an edge without crossings.
    for (Index h = 0; h < 3 * surface.number_of_faces(); ++h)
    {
      if (!surface.is_used(h / 3) || is_decided[surface.origin(h)] || is_near[surface.origin(h)] == either_side) continue;
      const auto range = crossings_of(surface.twin(h) < h ? surface.twin(h) : h);
      if (range.first != range.second) continue;
      typename Surface::Weights middle{{0, 0, 0}};
      middle[h % 3] = middle[(h + 1) % 3] = 0.5;
      const double d = surface.distance_at(h / 3, middle);
      if (!(std::abs(d - cut) > doubt)) continue;
      const Index v = surface.origin(h);
      is_near[v] = d < cut;
      is_decided[v] = 1;
      for (const Neighbor& n : around[v]) next.push_back(n.vertex);
      spread();
    }
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif // GEODESIC_OFFSET_TEST_VALIDATION_VALIDATION_LEVEL_H
