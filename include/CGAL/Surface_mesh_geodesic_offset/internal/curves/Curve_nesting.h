// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cells into which curves divide a surface, and the tree of cells and curves.
//
// Cells are sets of nodes in a union-find structure: the two sides of each curve, and the intervals between crossings on each edge.
// A crossing joins each side of its curve with an interval, a corner of a face joins the intervals beside it. Within a face, the
// parts of curves between edges need no other treatment. A curve inside one face is joined with what a ray from it meets.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_CURVE_NESTING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_CURVE_NESTING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Computes in `double` for all number types. Place: Offset_curve_nesting.
template <class FT, class Place>
class Curve_nesting
{
public:
  typedef Level_piece<FT> Piece;

  struct Curve
  {
    const std::vector<Piece>* pieces;
    bool is_closed;
  };

  // The mesh and the pieces must outlive this object.
  Curve_nesting(const Unfolded_mesh<FT>& mesh, std::vector<Curve> curves) : m_mesh(mesh), m_curves(std::move(curves))
  {
    for (std::size_t i = 0; i < m_curves.size(); ++i) add_crossings(i);
    std::sort(m_crossings.begin(), m_crossings.end());
    number_intervals();
    join_intervals();
    for (const std::size_t i : m_loops) join_loop(i);
  }

  // By curve. border_size(halfedges): the size of a border cycle; the largest one of a part of the surface is outside.
  template <class Function>
  std::vector<Place> operator()(const Function& border_size)
  {
    find_tree(find_roots(border_size));
    std::vector<Place> places(m_curves.size());
    const auto place = [&](std::size_t i, std::size_t outer, Orientation inner_side) {
      const std::size_t parent = m_tree[top(outer)].entry;
      places[i] = {parent, inner_side, parent == none ? 0 : places[parent].depth + 1};
    };
    for (const std::size_t c : m_order)
      if (const Tree_cell& t = m_tree[c]; t.entry != none && t.top == c)
        place(t.entry, t.up, cell(side(t.entry, left)) == c ? LEFT_TURN : RIGHT_TURN);
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      if (places[i].inner_side == COLLINEAR) place(i, cell(side(i, left)), COLLINEAR);
    return places;
  }

private:
  typedef Point_in_face<double> Point;
  typedef boost::disjoint_sets_with_storage<> Cells;

  static constexpr int left = 0, right = 1; // sides of curves
  static constexpr std::size_t none = Place::no_parent;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct Crossing
  {
    Index edge; // its halfedge with the smaller index
    double t;   // distance from the source of this halfedge
    std::size_t curve;
    bool rises; // the left side of the curve is towards the source

    bool operator<(const Crossing& c) const { return std::tie(edge, t) < std::tie(c.edge, c.t); }
  };

  static Point point(const Point_in_face<FT>& p) { return {CGAL::to_double(p.x), CGAL::to_double(p.y)}; }
  Index edge_of(Index h) const { return (std::min)(h, m_mesh.twin(h)); } // no_index is the largest index
  static std::size_t side(std::size_t curve, int s) { return 2 * curve + std::size_t(s); }
  std::size_t cell(std::size_t node) { return m_cells.find_set(node); }
  void join(std::size_t a, std::size_t b) { m_cells.union_set(a, b); }

  void add_crossings(std::size_t curve)
  {
    const std::vector<Piece>& pieces = *m_curves[curve].pieces;
    const std::size_t before = m_crossings.size(), n = pieces.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const Piece &a = pieces[i], &b = pieces[i + 1 < n ? i + 1 : 0];
      if ((i + 1 == n && !m_curves[curve].is_closed) || a.face == b.face) continue;
      CGAL_assertion(a.end_edge < 3 && m_mesh.twin(3 * a.face + a.end_edge) == 3 * b.face + b.start_edge);
      const Index h = 3 * a.face + a.end_edge, edge = edge_of(h);
      const Face_frame<FT> frame(m_mesh, m_mesh.face(edge)); // the same for all crossings of the edge
      m_crossings.push_back({edge, CGAL::to_double(frame.along(int(edge % 3), edge == h ? a.end : b.start)), curve, edge != h});
    }
    if (m_crossings.size() == before) m_loops.push_back(curve);
  }

  void number_intervals()
  {
    const std::size_t n = m_mesh.number_of_halfedges();
    m_first.assign(n + 1, 2 * m_curves.size());
    auto c = m_crossings.begin();
    for (Index h = 0; h < n; ++h)
    {
      m_first[h + 1] = m_first[h] + (edge_of(h) == h ? 1 : 0);
      for (; c != m_crossings.end() && c->edge == h; ++c) ++m_first[h + 1];
    }
    m_cells = Cells(m_first[n]);
  }

  // The interval at the source of a halfedge, and that at its target.
  std::size_t first_interval(Index h) const { return edge_of(h) == h ? m_first[h] : m_first[m_mesh.twin(h) + 1] - 1; }
  std::size_t last_interval(Index h) const { return edge_of(h) == h ? m_first[h + 1] - 1 : m_first[m_mesh.twin(h)]; }

  void join_intervals()
  {
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h) join(last_interval(m_mesh.previous(h)), first_interval(h));
    std::size_t number = 0; // of the crossing on its edge
    for (std::size_t j = 0; j < m_crossings.size(); ++j)
    {
      const Crossing& c = m_crossings[j];
      number = j > 0 && m_crossings[j - 1].edge == c.edge ? number + 1 : 0;
      join(m_first[c.edge] + number, side(c.curve, c.rises ? left : right));
      join(m_first[c.edge] + number + 1, side(c.curve, c.rises ? right : left));
    }
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      if (!m_curves[i].is_closed) join_open(i);
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (is_border(h)) join(m_first[h], m_first[next_on_border(h)]);
  }

  // An open curve has the same cell on both sides, around an end in the surface or through the border.
  void join_open(std::size_t i)
  {
    join(side(i, left), side(i, right));
    const Piece &first = m_curves[i].pieces->front(), &last = m_curves[i].pieces->back();
    const auto join_end = [&](Index face, int k) {
      const Index h = k < 3 ? 3 * face + Index(k) : no_index;
      if (k < 3 && is_border(h)) join(side(i, left), m_first[h]);
    };
    join_end(first.face, first.start_edge);
    join_end(last.face, last.end_edge);
  }

  // Indices of faces may have gaps.
  bool is_used(Index h) const { return m_mesh.source(h) != no_index; }
  bool is_border(Index h) const { return m_mesh.twin(h) == no_index && is_used(h); }

  Index next_on_border(Index h) const
  {
    for (h = m_mesh.next(h); m_mesh.twin(h) != no_index;) h = m_mesh.next(m_mesh.twin(h));
    return h;
  }

  // Twice the area between a piece and the origin of the frame of its face.
  static double area_below(const Piece& p)
  {
    const Point start = point(p.start), end = point(p.end);
    if (p.is_straight) return cross(start, end);
    const double r = CGAL::to_double(p.radius);
    const double angle = std::atan2(CGAL::to_double(p.turn_sine()), CGAL::to_double(p.turn_cosine()));
    return cross(point(p.center), end - start) + r * r * angle;
  }

  // Calls f(t, side) where the ray from o in the unit direction u meets the piece: on the side where it arrives.
  template <class Function>
  static void for_each_hit(const Piece& p, const Point& o, const Point& u, const Function& f)
  {
    const Point c = point(p.center), start = point(p.start), end = point(p.end);
    const double r = CGAL::to_double(p.radius);
    if (p.is_straight) // on the line with the normal c, which has the smaller distances behind
    {
      const double t = (r - dot(c, o)) / dot(c, u);
      if (t > 0 && (cross(u, start - o) > 0) != (cross(u, end - o) > 0)) f(t, dot(c, u) > 0 ? left : right);
      return;
    }
    const double b = dot(o - c, u), h = cross(u, c - o), square = (r - h) * (r + h);
    if (!(square > 0)) return;
    for (const int sign : {-1, 1})
    {
      const double t = -b + sign * std::sqrt(square);
      const Point q = o + t * u;
      // up to a half turn: left of the chord's opposite
      if (t > 0 && cross(end - start, q - start) < 0) f(t, sign > 0 ? left : right);
    }
  }

  // Joins the outer side of a curve that crosses no edge with what a ray from it meets after it has left the curve.
  void join_loop(std::size_t i)
  {
    const std::vector<Piece>& pieces = *m_curves[i].pieces;
    double area = 0;
    for (const Piece& p : pieces) area += area_below(p);
    const std::size_t outer = side(i, area > 0 ? right : left); // of an open curve, any side
    const Index face = pieces.front().face;
    if (m_pieces_in.empty()) // of the faces with such curves
    {
      for (const std::size_t k : m_loops) m_pieces_in[m_curves[k].pieces->front().face];
      for (std::size_t k = 0; k < m_curves.size(); ++k)
        for (const Piece& p : *m_curves[k].pieces)
          if (const auto it = m_pieces_in.find(p.face); it != m_pieces_in.end()) it->second.emplace_back(&p, k);
    }
    // in a direction that no edge has by construction
    const Point o = point(pieces.front().middle()), u{std::cos(1.), std::sin(1.)};
    double last = 0, next = infinity;
    for (const Piece& p : pieces) for_each_hit(p, o, u, [&](double t, int) { last = (std::max)(last, t); });
    std::size_t met = none;
    for (const auto& [p, k] : m_pieces_in[face])
      if (k != i)
        for_each_hit(*p, o, u, [&, curve = k](double t, int s) {
          if (!(t > last && t < next)) return;
          next = t;
          met = side(curve, s);
        });
    join(outer, met != none ? met : interval_met(face, o, u));
  }

  // The interval of an edge where a ray from inside a face leaves the face.
  std::size_t interval_met(Index face, const Point& o, const Point& u) const
  {
    const Face_frame<FT> frame(m_mesh, face);
    double least = infinity, t = 0;
    Index edge = 0;
    for (int k = 0; k < 3; ++k)
    {
      const Point c = point(frame.corner(k)), d = point(frame.direction(k));
      const double way = cross(d, c - o) / cross(d, u);
      if (!(cross(d, u) < 0) || !(way < least)) continue; // towards the outside
      least = way;
      const Index h = 3 * face + Index(k);
      const double along = dot(o + way * u - c, d);
      t = edge_of(h) == h ? along : CGAL::to_double(frame.edge_length(k)) - along;
      edge = edge_of(h);
    }
    const auto begin = std::lower_bound(m_crossings.begin(), m_crossings.end(), Crossing{edge, -infinity, 0, false});
    const auto end = std::lower_bound(begin, m_crossings.end(), Crossing{edge, t, 0, false});
    return m_first[edge] + std::size_t(end - begin);
  }

  // Twice the areas of cells, by node: sums over the boundaries of their parts in the faces.
  std::vector<double> areas() const
  {
    std::vector<double> area(m_first.back(), 0);
    const auto height = [this](Index h) { // of the origin of the face frame over the halfedge
      return h == no_index ? 0 : CGAL::to_double(Face_frame<FT>(m_mesh, m_mesh.face(h)).height(int(h % 3), {FT(0), FT(0)}));
    };
    auto c = m_crossings.begin();
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
    {
      if (!is_used(h) || edge_of(h) != h) continue;
      const double heights = height(h) + height(m_mesh.twin(h));
      double t = 0;
      for (std::size_t i = m_first[h]; i < m_first[h + 1]; ++i)
      {
        const double end = i + 1 < m_first[h + 1] ? (c++)->t : CGAL::to_double(m_mesh[h].length);
        area[i] += heights * (end - t);
        t = end;
      }
    }
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      for (const Piece& p : *m_curves[i].pieces)
      {
        area[side(i, left)] += area_below(p);
        area[side(i, right)] -= area_below(p);
      }
    return area;
  }

  // A node of the outermost cell of each part of the surface: that with the border cycle of the largest size, otherwise that with
  // the largest area.
  template <class Function>
  std::vector<std::size_t> find_roots(const Function& border_size)
  {
    Cells parts = m_cells;
    for (std::size_t i = 0; i < m_curves.size(); ++i) parts.union_set(side(i, left), side(i, right));
    std::map<std::size_t, std::pair<double, std::size_t>> best; // by part: size and node
    const auto add = [&](std::size_t node, double size) {
      const auto [it, is_new] = best.emplace(parts.find_set(node), std::make_pair(size, node));
      if (!is_new && it->second.first < size) it->second = {size, node};
    };
    std::vector<char> is_done(m_mesh.number_of_halfedges(), 0);
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
    {
      if (!is_border(h) || is_done[h]) continue;
      std::vector<Index> cycle;
      for (Index g = h; !is_done[g]; g = next_on_border(g))
      {
        is_done[g] = 1;
        cycle.push_back(g);
      }
      add(m_first[h], border_size(cycle));
    }
    const auto with_border = best;
    const std::vector<double> area = areas();
    std::map<std::size_t, double> area_of; // by cell
    for (std::size_t i = 0; i < area.size(); ++i)
      if (area[i] != 0 && with_border.count(parts.find_set(i)) == 0) area_of[cell(i)] += area[i];
    for (const auto& [node, size] : area_of) add(node, size);
    std::vector<std::size_t> roots;
    for (const auto& [part, root] : best) roots.push_back(root.second);
    return roots;
  }

  // A spanning tree of the graph of cells and curves. Cells on a cycle of the graph count as one: none of its curves divides.
  void find_tree(const std::vector<std::size_t>& roots)
  {
    std::map<std::size_t, std::vector<std::size_t>> curves_at; // by cell
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      for (const int s : {left, right}) curves_at[cell(side(i, s))].push_back(i);
    const auto add = [&](std::size_t c, std::size_t entry, std::size_t up, std::size_t depth) {
      if (m_tree.emplace(c, Tree_cell{entry, up, depth, c}).second) m_order.push_back(c);
    };
    for (const std::size_t root : roots) add(cell(root), none, none, 0);
    for (std::size_t k = 0; k < m_order.size(); ++k)
      for (const std::size_t i : curves_at[m_order[k]])
        for (const int s : {left, right}) add(cell(side(i, s)), i, m_order[k], m_tree[m_order[k]].depth + 1);
    for (std::size_t i = 0; i < m_curves.size(); ++i)
    {
      std::size_t a = top(cell(side(i, left))), b = top(cell(side(i, right)));
      if (m_tree[a].entry == i || m_tree[b].entry == i) continue;
      for (; a != b; a = top(m_tree[a].top = m_tree[a].up))
        if (m_tree[a].depth < m_tree[b].depth) std::swap(a, b);
    }
  }

  // The outermost of the cells that count as one with c.
  std::size_t top(std::size_t c)
  {
    while (m_tree[c].top != c) c = m_tree[c].top = m_tree[m_tree[c].top].top;
    return c;
  }

  struct Tree_cell
  {
    std::size_t entry, up; // curve towards the root, and the cell beyond
    std::size_t depth;
    std::size_t top; // on the way to the outermost cell
  };

  const Unfolded_mesh<FT>& m_mesh;
  const std::vector<Curve> m_curves;
  std::vector<Crossing> m_crossings; // sorted along each edge
  std::vector<std::size_t> m_loops;  // curves without crossings
  std::vector<std::size_t> m_first;  // by halfedge: node of the first interval on its edge
  Cells m_cells;
  std::map<std::size_t, Tree_cell> m_tree;                                        // by cell
  std::vector<std::size_t> m_order;                                               // of cells in the tree, from the roots
  std::map<Index, std::vector<std::pair<const Piece*, std::size_t>>> m_pieces_in; // by face, with their curves
};

} // namespace CGAL::Geodesic_offset::internal

#endif
