// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The region that curves on a surface bound: which parts of the edges are inside.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CURVE_REGION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CURVE_REGION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Face_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// A piece of a curve in a face, from one point of the surface to another one. Consecutive pieces share a point.
struct Curve_piece
{
  Index face;
  Surface_point<double> from, to;
  Face_piece geometry;        // in the frame of the face, in units of the certified mesh
  Double_double_2 start, end; // of `from` and `to` there; those of the geometry are within `moved`
  double moved;               // how far a point of the given curve may be from its geometry
  std::size_t curve;
  int edge = -1; // the halfedge of the face along which the piece runs
};

// Curves as a chain modulo 2. The border of each face is cut into parts, at its corners and at the ends of pieces on its edges.
// In a face, a disc, two points just inside the border are on different sides if and only if an odd number of ends of pieces lies
// between them. From one face to the next, sides are equal unless an odd number of pieces runs along the common edge. So all
// sides of a component follow from one of them, without any geometry, and the curves bound a region if and only if these rules
// do not contradict each other. The two halfedges of an edge have separate parts, which differ where a piece runs along the edge.
class Curve_region
{
public:
  typedef Surface_point<double> Surface_point_;

  explicit Curve_region(const Unfolded_mesh<double>& mesh) : m_mesh(mesh) {}

  // Finds the sides. Returns false if the rules contradict each other, in the face conflict_face() or at one of its halfedges.
  // `pinches`: vertices with several fans that are points of the curves, too: their fans may be on different sides.
  bool set_pieces(const std::vector<Curve_piece>& pieces, const std::vector<Index>& pinches)
  {
    find_events(pieces);
    m_first.assign(m_mesh.number_of_halfedges() + 1, 0);
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h) m_first[h + 1] = m_first[h] + number_of_events(h) + 1;
    m_parent.resize(m_first.back());
    for (std::size_t i = 0; i < m_parent.size(); ++i) m_parent[i] = i;
    m_differs.assign(m_parent.size(), 0);
    m_flips_behind.assign(m_parent.size(), 0);
    m_is_carried.assign(m_parent.size(), 0);
    m_on_curve.assign(m_mesh.number_of_vertices(), 0);
    m_pieces_of_face.clear();
    for (std::size_t i = 0; i < pieces.size(); ++i) add(pieces[i], i);
    std::sort(m_pieces_of_face.begin(), m_pieces_of_face.end());
    for (const Index v : pinches) m_on_curve[v] = 1;
    if (!unite_all()) return false;
    m_component.assign(m_parent.size(), 0);
    m_has_curve.assign(m_parent.size(), 0);
    for (const Curve_piece& p : pieces)
      if (key(p.from) != key(p.to)) m_has_curve[find(m_first[3 * p.face]).first] = 1;
    return true;
  }

  Index conflict_face() const { return m_conflict; }

  // All parts are numbered together, and those of a halfedge along it.
  std::size_t number_of_parts() const { return m_parent.size(); }
  std::size_t number_of_parts(Index h) const { return m_first[h + 1] - m_first[h]; }
  std::size_t part(Index h, std::size_t i) const { return m_first[h] + i; }

  // Where part i of a halfedge begins, also the one behind the last one.
  Surface_point_ begin_of_part(Index h, std::size_t i) const
  {
    if (i == 0) return Surface_point_::at_vertex(m_mesh.source(h));
    return i == number_of_parts(h) ? Surface_point_::at_vertex(m_mesh.target(h)) : Surface_point_::on_edge(h, event(h, i - 1));
  }

  bool is_carried(std::size_t part) const { return m_is_carried[part]; }

  // Makes a part, and all of its component that is on its side, inside or outside. To be called once for a component.
  void set_side(std::size_t part, bool is_inside)
  {
    const auto [root, differs] = find(part);
    m_component[root] = char(1 + (is_inside != differs));
  }
  bool has_side(std::size_t part) const { return m_component[find(part).first] != 0; }
  bool has_curve(std::size_t part) const { return m_has_curve[find(part).first]; } // in its component
  bool is_inside(std::size_t part) const
  {
    const auto [root, differs] = find(part);
    return (m_component[root] == 2) != differs;
  }

  bool is_on_curve(Index v) const { return m_on_curve[v]; }
  bool is_crossed(Index face) const
  {
    const auto range = pieces_of_face(face);
    return range.first != range.second;
  }

  typedef std::vector<std::pair<Index, std::size_t>>::const_iterator Piece_iterator; // face, number of the piece

  // The pieces that run inside a face.
  std::pair<Piece_iterator, Piece_iterator> pieces_of_face(Index face) const
  {
    const auto less = [](const std::pair<Index, std::size_t>& a, Index f) { return a.first < f; };
    const Piece_iterator begin = std::lower_bound(m_pieces_of_face.begin(), m_pieces_of_face.end(), face, less);
    return {begin, std::lower_bound(begin, m_pieces_of_face.end(), face + 1, less)};
  }

  // The parts of the border of the piece's face before and behind the end of a piece, counterclockwise; false if other ends are
  // there, or if the point is not on the border.
  bool parts_at_end(const Curve_piece& piece, bool at_start, std::size_t& before, std::size_t& behind) const
  {
    if (piece.edge >= 0) return false;
    if (!find_part(piece.face, at_start ? piece.from : piece.to, before)) return false;
    behind = next_part(before);
    return m_flips_behind[before];
  }

  // A part along which a piece on an edge runs, on the side of its face, and whether that is on the left of the piece; false if
  // the other pieces there leave nothing of it.
  bool part_along(const Curve_piece& piece, std::size_t& part, bool& is_left) const
  {
    const Index h = 3 * piece.face + Index(piece.edge);
    const std::size_t a = first_part_behind(h, piece.from), b = first_part_behind(h, piece.to);
    part = m_first[h] + (std::min)(a, b);
    is_left = a < b;
    return a != b && m_is_carried[part];
  }

  // Points of the surface in one order, with one name for each point of an edge.
  typedef std::tuple<int, Index, double, double> Key;
  Key key(const Surface_point_& p) const
  {
    if (p.kind == Surface_point_::EDGE) return {p.kind, edge_of(p.element), along_edge(p), 0.};
    return {p.kind, p.element, p.x, p.y};
  }

  bool is_on_border(const Surface_point_& p) const
  {
    if (p.kind == Surface_point_::EDGE) return m_mesh.twin(p.element) == no_index;
    if (p.kind == Surface_point_::FACE) return false;
    bool result = false;
    m_mesh.for_each_fan(p.element, [&](Index first) { result = result || m_mesh.first_on_border(first) != no_index; });
    return result;
  }

private:
  typedef std::pair<Index, double> Event; // edge, place on it

  Index edge_of(Index h) const
  {
    const Index g = m_mesh.twin(h);
    return g == no_index ? h : (std::min)(h, g);
  }

  // On the halfedge that names the edge.
  double along_edge(const Surface_point_& p) const
  {
    return edge_of(p.element) == p.element ? p.x : m_mesh[p.element].length - p.x;
  }

  void find_events(const std::vector<Curve_piece>& pieces)
  {
    m_events.clear();
    for (const Curve_piece& piece : pieces)
      for (const Surface_point_& p : {piece.from, piece.to})
        if (p.kind == Surface_point_::EDGE) m_events.push_back({edge_of(p.element), along_edge(p)});
    std::sort(m_events.begin(), m_events.end());
    m_events.erase(std::unique(m_events.begin(), m_events.end()), m_events.end());
  }

  std::pair<std::size_t, std::size_t> events_of(Index edge) const
  {
    const auto less = [](const Event& e, Index i) { return e.first < i; };
    const auto begin = std::lower_bound(m_events.begin(), m_events.end(), edge, less);
    const auto end = std::lower_bound(begin, m_events.end(), edge + 1, less);
    return {std::size_t(begin - m_events.begin()), std::size_t(end - m_events.begin())};
  }

  std::size_t number_of_events(Index h) const
  {
    if (m_events.empty()) return 0;
    const auto range = events_of(edge_of(h));
    return range.second - range.first;
  }

  // Along h.
  double event(Index h, std::size_t i) const
  {
    const auto range = events_of(edge_of(h));
    if (edge_of(h) == h) return m_events[range.first + i].second;
    return m_mesh[h].length - m_events[range.second - 1 - i].second;
  }

  // The number of the event at a point of the edge of h, along h.
  std::size_t event_at(Index h, const Surface_point_& p) const
  {
    const auto range = events_of(edge_of(h));
    const Event e{edge_of(h), along_edge(p)};
    const std::size_t i = std::size_t(std::lower_bound(m_events.begin(), m_events.end(), e) - m_events.begin());
    CGAL_assertion(i < range.second && m_events[i] == e);
    return edge_of(h) == h ? i - range.first : range.second - 1 - i;
  }

  // The part of the border of a face that ends at a point; false if the point is not on the border.
  bool find_part(Index face, const Surface_point_& p, std::size_t& part) const
  {
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
    {
      if (p.kind == Surface_point_::VERTEX && m_mesh.target(h) == p.element)
      {
        part = m_first[h + 1] - 1;
        return true;
      }
      if (p.kind == Surface_point_::EDGE && edge_of(h) == edge_of(p.element))
      {
        part = m_first[h] + event_at(h, p);
        return true;
      }
    }
    return false;
  }

  std::size_t next_part(std::size_t part) const
  {
    const Index h = Index(std::upper_bound(m_first.begin(), m_first.end(), part) - m_first.begin()) - 1;
    return part + 1 < m_first[h + 1] ? part + 1 : m_first[m_mesh.next(h)];
  }

  void add(const Curve_piece& piece, std::size_t number)
  {
    for (const Surface_point_& p : {piece.from, piece.to})
      if (p.kind == Surface_point_::VERTEX) m_on_curve[p.element] = 1;
    if (piece.edge >= 0)
    {
      carry(3 * piece.face + Index(piece.edge), piece);
      return;
    }
    m_pieces_of_face.push_back({piece.face, number});
    for (const Surface_point_& p : {piece.from, piece.to})
      if (std::size_t before; find_part(piece.face, p, before)) m_flips_behind[before] ^= 1;
  }

  // The number, on h, of the part that begins at a point of h.
  std::size_t first_part_behind(Index h, const Surface_point_& p) const
  {
    if (p.kind == Surface_point_::EDGE) return event_at(h, p) + 1;
    return m_mesh.source(h) == p.element ? std::size_t(0) : number_of_parts(h);
  }

  // Parts between the ends of a piece that runs along h.
  void carry(Index h, const Curve_piece& piece)
  {
    const std::size_t a = first_part_behind(h, piece.from), b = first_part_behind(h, piece.to), n = number_of_parts(h);
    const Index g = m_mesh.twin(h);
    for (std::size_t i = (std::min)(a, b); i < (std::max)(a, b); ++i)
    {
      m_is_carried[m_first[h] + i] ^= 1;
      if (g != no_index) m_is_carried[m_first[g] + n - 1 - i] ^= 1;
    }
  }

  // The representative of a part, and whether it is on the other side.
  std::pair<std::size_t, bool> find(std::size_t i) const
  {
    std::size_t root = i;
    bool differs = false;
    while (m_parent[root] != root)
    {
      differs ^= bool(m_differs[root]);
      root = m_parent[root];
    }
    const std::pair<std::size_t, bool> result(root, differs);
    while (m_parent[i] != root && i != root)
    {
      const std::size_t next = m_parent[i];
      const bool next_differs = differs ^ bool(m_differs[i]);
      m_parent[i] = root;
      m_differs[i] = differs;
      differs = next_differs;
      i = next;
    }
    return result;
  }

  bool unite(std::size_t i, std::size_t j, bool differ)
  {
    const auto a = find(i), b = find(j);
    const bool roots_differ = a.second ^ b.second ^ differ;
    if (a.first == b.first) return !roots_differ;
    m_parent[b.first] = a.first;
    m_differs[b.first] = roots_differ;
    return true;
  }

  bool unite_all()
  {
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      if (m_mesh.source(3 * f) == no_index) continue;
      for (std::size_t i = m_first[3 * f]; i < m_first[3 * f + 3]; ++i)
        if (!unite(i, i + 1 < m_first[3 * f + 3] ? i + 1 : m_first[3 * f], m_flips_behind[i])) return complain(f);
    }
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
    {
      const Index g = m_mesh.source(h) == no_index ? no_index : m_mesh.twin(h);
      if (g == no_index || g < h) continue;
      const std::size_t n = number_of_parts(h);
      for (std::size_t i = 0; i < n; ++i)
        if (!unite(m_first[h] + i, m_first[g] + n - 1 - i, m_is_carried[m_first[h] + i])) return complain(h / 3);
    }
    for (Index v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (m_mesh.corner(v) != no_index && !m_on_curve[v] && m_mesh.has_several_fans(v))
      { // paths pass from fan to fan there
        bool fits = true;
        m_mesh.for_each_fan(v, [&](Index c) { fits = unite(m_first[m_mesh.corner(v)], m_first[c], false) && fits; });
        if (!fits) return complain(m_mesh.corner(v) / 3);
      }
    return true;
  }

  bool complain(Index face)
  {
    m_conflict = face;
    return false;
  }

  const Unfolded_mesh<double>& m_mesh;
  std::vector<Event> m_events;
  std::vector<std::size_t> m_first;          // part, per halfedge
  mutable std::vector<std::size_t> m_parent; // per part, as are the others
  mutable std::vector<char> m_differs;
  std::vector<char> m_flips_behind, m_is_carried, m_component, m_has_curve;
  std::vector<char> m_on_curve; // per vertex
  std::vector<std::pair<Index, std::size_t>> m_pieces_of_face;
  Index m_conflict = no_index;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
