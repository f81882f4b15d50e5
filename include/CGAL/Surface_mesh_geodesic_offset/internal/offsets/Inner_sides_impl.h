// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for Inner_sides.h.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_INNER_SIDES_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_INNER_SIDES_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Inner_sides.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
Inner_sides<FT>::Inner_sides(const Unfolded_mesh<FT>& mesh, const Source_set<FT>& sources) : m_mesh(mesh.without_barriers())
{
  sources.for_each([&](std::size_t id, const auto& source) {
    if (source.kind != Source_set<FT>::CLOSED_POLYLINE) return;
    std::vector<Place> points = source.points;
    for (Place& p : points)
      if (p.kind == Place::VERTEX) p.element = mesh.first_copy(p.element);
    add(id, points);
  });
}

template <class FT>
Index Inner_sides<FT>::node(Index h) const
{
  const Index v = m_mesh.source(h);
  if (!m_mesh.has_several_fans(v)) return v;
  Index first = m_mesh.first_on_border(h);
  if (first == no_index)
  {
    first = h;
    m_mesh.any_corner(h, [&](Index c) { return first = (std::min)(first, c), false; });
  }
  return m_more_nodes.emplace(first, Index(m_mesh.number_of_vertices() + m_more_nodes.size())).first->second;
}

template <class FT>
void Inner_sides<FT>::add(std::size_t id, std::vector<Place> points)
{
  const auto are_equal = [](const Place& p, const Place& q) {
    return p.kind == q.kind && p.element == q.element && (p.kind == Place::VERTEX || (p.x == q.x && p.y == q.y));
  };
  points.erase(std::unique(points.begin(), points.end(), are_equal), points.end());
  while (points.size() > 1 && are_equal(points.front(), points.back())) points.pop_back();
  if (points.size() < 2) return;
  m_contours.push_back({id});
  Contour& contour = m_contours.back();
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < points.size(); ++i)
    segments.push_back(segment(points[i], points[(i + 1) % points.size()], contour));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Segment &s = segments[i], &next = segments[(i + 1) % points.size()];
    contour.length += s.size;
    contour.turns_back = contour.turns_back || turns_back(s, next);
    if (s.face != no_index) m_pieces.push_back({Index(m_contours.size() - 1), s.face, s.start, s.end});
    add_joint(s, next);
  }
}

// True if a segment leads back along the one before it, up to rounding of its direction; its sides are not those of a region then.
template <class FT>
bool Inner_sides<FT>::turns_back(const Segment& in, const Segment& out) const
{
  const double rounding = 0x1p-40; // of the angle between two segments that are not much shorter than their face
  Point_in_face<FT> a, b, c;
  unsigned unused;
  const Index face = face_of_both(m_mesh, in.first, in.second, a, b, unused);
  if (!position_in_face(m_mesh, out.second, face, c, unused)) return false;
  const Point u{CGAL::to_double(a.x - b.x), CGAL::to_double(a.y - b.y)},
    v{CGAL::to_double(c.x - b.x), CGAL::to_double(c.y - b.y)};
  return dot(u, v) > 0 && std::abs(cross(u, v)) <= rounding * dot(u, v);
}

template <class FT>
typename Inner_sides<FT>::Segment Inner_sides<FT>::segment(const Place& p, const Place& q, Contour& contour) const
{
  const auto plain = [](const Point_in_face<FT>& a) { return Point{CGAL::to_double(a.x), CGAL::to_double(a.y)}; };
  Point_in_face<FT> a, b;
  unsigned edge;
  Segment s{p, q, face_of_both(m_mesh, p, q, a, b, edge), plain(a), plain(b), 0};
  CGAL_precondition(s.face != no_index);
  contour.face = s.face;
  s.size = length(s.end - s.start);
  if (edge == 0) return s;
  const int k = edge_of_bit(edge);
  const Index h = 3 * s.face + Index(k), twin = m_mesh.twin(h);
  if (p.kind == Place::VERTEX) contour.left = corner_at(s.face, p.element);
  if (twin == no_index) contour.covered += s.size;
  const Face_frame<FT> frame(m_mesh, s.face);
  if (!(frame.along(k, a) < frame.along(k, b))) return s; // this face is on the right
  s.face = twin == no_index ? no_index : m_mesh.face(twin);
  if (s.face == no_index) return s;
  unsigned unused;
  position_in_face(m_mesh, p, s.face, a, unused);
  position_in_face(m_mesh, q, s.face, b, unused);
  s.start = plain(a);
  s.end = plain(b);
  return s;
}

// The crossings where the polyline passes an edge or a vertex.
template <class FT>
void Inner_sides<FT>::add_joint(const Segment& in, const Segment& out)
{
  const Place& p = in.second;
  if (p.kind == Place::EDGE && in.face != out.face)
  {
    const Index h = canonical(p.element);
    const double x = CGAL::to_double(p.x) / length_of(h), t = p.element == h ? x : 1 - x;
    cross_at(h, t, m_mesh.face(h) == in.face ? 1 : -1); // from the left of h to its right: the left of the polyline is ahead
  }
  if (p.kind != Place::VERTEX) return;
  // Counterclockwise around the vertex, from where the polyline comes to where it goes.
  if (in.face == out.face)
  {
    if (in.face == no_index || !(cross(in.start - in.end, out.end - out.start) < 0)) return;
    const Index corner = corner_at(in.face, p.element);
    const Index next = m_mesh.corner_ccw(corner);
    add_crossing_near(m_mesh.previous(corner), p.element);
    add_turn(p.element, next, corner);
    return;
  }
  // Beyond the border: between the last corner of an open fan and its first one.
  add_turn(p.element, in.face == no_index ? no_index : corner_at(in.face, p.element),
           out.face == no_index ? no_index : corner_at(out.face, p.element));
}

// The crossings with the edges of a vertex counterclockwise from a corner to another one.
template <class FT>
void Inner_sides<FT>::add_turn(Index v, Index in, Index out)
{
  if (in != no_index)
  {
    const Index begin = in;
    while (in != out)
    {
      const Index h = m_mesh.previous(in);
      if (m_mesh.twin(h) == no_index)
      {
        add_crossing_near(h, v);
        in = no_index;
        break;
      }
      if (m_mesh.twin(h) == begin) return; // a closed fan; the polyline leaves it through the vertex
      add_crossing_near(h, v);
      in = m_mesh.twin(h);
    }
  }
  if (in == out) return;
  const Index first = m_mesh.first_on_border(out);
  if (first == no_index) return;
  add_crossing_near(first, v);
  add_turn(v, first, out);
}

template <class FT>
Index Inner_sides<FT>::corner_at(Index face, Index v) const
{
  Index h = 3 * face;
  while (m_mesh.source(h) != v) ++h;
  return h;
}

// The polyline crosses the edge of h next to its end v, which is on the left.
template <class FT>
void Inner_sides<FT>::add_crossing_near(Index h, Index v)
{
  h = canonical(h);
  if (m_mesh.source(h) == v) cross_at(h, 0, -1);
  else cross_at(h, 1, 1);
}

template <class FT>
void Inner_sides<FT>::cross_at(Index h, double t, int jump)
{
  m_crossings.push_back({Index(m_contours.size() - 1), h, t, jump});
}

template <class FT>
void Inner_sides<FT>::find_cells()
{
  // Jumps along the edges that are crossed, zeros left out.
  std::map<Index, std::vector<std::pair<Index, int>>> jumps;
  for (const Crossing& c : m_crossings)
  {
    auto& of_edge = jumps[c.halfedge];
    if (of_edge.empty() || of_edge.back().first != c.contour) of_edge.emplace_back(c.contour, 0);
    of_edge.back().second += c.jump;
  }
  std::vector<char> is_crossed(m_mesh.number_of_halfedges(), 0);
  for (auto& [h, of_edge] : jumps)
  {
    of_edge.erase(std::remove_if(of_edge.begin(), of_edge.end(), [](const auto& j) { return j.second == 0; }), of_edge.end());
    is_crossed[h] = !of_edge.empty();
  }
  const auto for_each_halfedge = [&](const auto& f) {
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.source(h) != no_index) f(h);
    m_visits += m_mesh.number_of_halfedges();
  };
  for_each_halfedge([&](Index h) { node(h); }); // numbers all fans
  m_cell.resize(m_mesh.number_of_vertices() + m_more_nodes.size());
  std::iota(m_cell.begin(), m_cell.end(), Index(0));
  const auto root = [&](Index v) {
    for (; m_cell[v] != v; v = m_cell[v]) m_cell[v] = m_cell[m_cell[v]];
    return v;
  };
  for_each_halfedge([&](Index h) {
    if (h != canonical(h) || is_crossed[h]) return;
    const Index a = root(node(h)), b = root(node(m_mesh.next(h)));
    m_cell[(std::max)(a, b)] = (std::min)(a, b);
  });
  for (Index v = 0; v < m_cell.size(); ++v) m_cell[v] = root(v);

  for (const auto& [h, of_edge] : jumps)
  {
    if (of_edge.empty()) continue;
    m_links.push_back({m_cell[node(h)], m_cell[node(m_mesh.next(h))], of_edge});
    Link& l = m_links.back();
    if (l.first < l.second) continue;
    std::swap(l.first, l.second);
    for (auto& j : l.jumps) j.second = -j.second;
  }
  std::sort(m_links.begin(), m_links.end());
  m_links.erase(std::unique(m_links.begin(), m_links.end()), m_links.end());
  m_links_of.resize(m_cell.size());
  for (Index i = 0; i < m_links.size(); ++i)
    for (const Index c : {m_links[i].first, m_links[i].second}) m_links_of[c].push_back(i);

  m_area.assign(m_cell.size(), 0);
  m_border.assign(m_cell.size(), 0);
  m_winding.assign(m_cell.size(), INT_MIN);
  for_each_halfedge([&](Index h) {
    if (h % 3 == 0) m_area[m_cell[node(h)]] += area_of(h / 3);
    if (m_mesh.twin(h) == no_index) m_border[m_cell[node(h)]] += length_of(h);
  });
}

// Computes the winding numbers of the cells. Returns false if there are none.
template <class FT>
bool Inner_sides<FT>::find_windings(const Contour& contour)
{
  for (const Index c : m_cells) m_winding[c] = INT_MIN;
  m_cells.assign(1, m_cell[node(3 * contour.face)]);
  m_winding[m_cells[0]] = 0;
  const Index number = Index(&contour - m_contours.data());
  for (std::size_t i = 0; i < m_cells.size(); ++i)
  {
    const Index c = m_cells[i];
    ++m_visits;
    for (const Index l : m_links_of[c])
    {
      const Link& link = m_links[l];
      const auto it = std::lower_bound(link.jumps.begin(), link.jumps.end(), std::make_pair(number, INT_MIN));
      const int jump = it != link.jumps.end() && it->first == number ? it->second : 0;
      const bool forward = link.first == c;
      const Index d = forward ? link.second : link.first;
      const int winding = m_winding[c] + (forward ? jump : -jump);
      if (link.first == link.second && jump != 0) return false;
      if (m_winding[d] == INT_MIN) m_cells.push_back(d), m_winding[d] = winding;
      else if (m_winding[d] != winding) return false;
    }
  }
  return true;
}

template <class FT>
int Inner_sides<FT>::winding_on_edge(Index contour, Index h, double t) const
{
  const Index c = canonical(h);
  if (c != h) t = 1 - t;
  int winding = m_winding[m_cell[node(c)]];
  const auto is_less = [](const Crossing& x, const std::pair<Index, Index>& y) {
    return std::make_pair(x.contour, x.halfedge) < y;
  };
  for (auto it = std::lower_bound(m_crossings.begin(), m_crossings.end(), std::make_pair(contour, c), is_less);
       it != m_crossings.end() && it->contour == contour && it->halfedge == c && it->t < t; ++it)
    winding += it->jump;
  return winding;
}

// Calls f(piece, winding number on its left) for the pieces of a polyline in one face. From the middle of each piece a ray leads to
// the edges of the face.
template <class FT>
template <class Function>
void Inner_sides<FT>::for_each_left(const Piece* first, const Piece* last, const Function& f) const
{
  const Face_frame<FT> frame(m_mesh, first->face);
  // Rays are not parallel to pieces, except by chance, whatever the directions of edges and axes are.
  const Point along{0.8479, 0.5301}, up = quarter_turn(along);
  const auto turned = [&](const Point& p) { return Point{dot(p, along), dot(p, up)}; };
  struct Turned
  {
    Point a, b;
    double low() const { return (std::min)(a.x, b.x); }
    double high() const { return (std::max)(a.x, b.x); }
    double middle() const { return (a.x + b.x) / 2; }
    bool meets(double x) const { return low() <= x && x < high(); }
    double height(double x) const { return a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y); }
  };
  Turned edges[3];
  for (int k = 0; k < 3; ++k)
  {
    const auto corner = [&](int i) {
      return turned({CGAL::to_double(frame.corner(i % 3).x), CGAL::to_double(frame.corner(i % 3).y)});
    };
    edges[k] = {corner(k), corner(k + 1)};
  }
  std::vector<Turned> pieces;
  for (const Piece* p = first; p != last; ++p) pieces.push_back({turned(p->start), turned(p->end)});
  std::vector<std::size_t> by_low(pieces.size()), by_middle, active;
  std::iota(by_low.begin(), by_low.end(), std::size_t(0));
  by_middle = by_low;
  std::sort(by_low.begin(), by_low.end(), [&](auto i, auto j) { return pieces[i].low() < pieces[j].low(); });
  std::sort(by_middle.begin(), by_middle.end(), [&](auto i, auto j) { return pieces[i].middle() < pieces[j].middle(); });
  auto next = by_low.begin();
  for (const std::size_t i : by_middle)
  {
    const double x = pieces[i].middle(), y = (pieces[i].a.y + pieces[i].b.y) / 2;
    for (; next != by_low.end() && pieces[*next].low() <= x; ++next) active.push_back(*next);
    active.erase(std::remove_if(active.begin(), active.end(), [&](auto j) { return !(x < pieces[j].high()); }), active.end());
    int top = -1;
    for (int k = 0; k < 3; ++k)
      if (edges[k].meets(x) && (top < 0 || edges[k].height(x) > edges[top].height(x))) top = k;
    if (top < 0 || !pieces[i].meets(x)) continue;
    const double t = (x - edges[top].a.x) / (edges[top].b.x - edges[top].a.x);
    int winding = winding_on_edge(first->contour, 3 * first->face + Index(top), t);
    const auto jump = [&](std::size_t j) { return pieces[j].a.x < pieces[j].b.x ? 1 : -1; }; // upwards
    for (const std::size_t j : active)
      if (j != i && pieces[j].meets(x) && pieces[j].height(x) > y) winding -= jump(j);
    f(first[i], jump(i) > 0 ? winding : winding + 1);
  }
}

// The winding number on the left. Returns false if it is not the same everywhere, except for loops and overlaps as short as the
// width of a strip along the border.
template <class FT>
bool Inner_sides<FT>::find_left(const Contour& contour, int& left) const
{
  const Index number = Index(&contour - m_contours.data());
  const auto is_less = [](const Piece& p, Index n) { return p.contour < n; };
  const Piece* const end = m_pieces.data() + m_pieces.size();
  std::map<int, double> length_of_left;
  for (const Piece* first = std::lower_bound(m_pieces.data(), end, number, is_less); first != end && first->contour == number;)
  {
    const Piece* const last =
      std::find_if(first, end, [&](const Piece& p) { return p.contour != number || p.face != first->face; });
    for_each_left(first, last, [&](const Piece& p, int value) { length_of_left[value] += length(p.end - p.start); });
    first = last;
  }
  if (length_of_left.empty() && contour.left != no_index) // along the border all the way
    length_of_left[m_winding[m_cell[node(contour.left)]]] = 1;
  if (length_of_left.empty()) return false;
  const auto longest = std::max_element(length_of_left.begin(), length_of_left.end(), [](const auto& a, const auto& b) {
    return a.second < b.second;
  });
  left = longest->first;
  double others = 0;
  for (const auto& [value, size] : length_of_left) others += value == left ? 0 : size;
  return others <= Offset_tolerances<double>::border_strip(contour.length);
}

template <class FT>
Geodesic_inner_side Inner_sides<FT>::side_of(const Contour& contour)
{
  Geodesic_inner_side result;
  int left;
  if (contour.turns_back || !find_windings(contour) || !find_left(contour, left)) return result;
  const Index number = Index(&contour - m_contours.data());
  double area = 0, border = 0, left_area = 0, left_border = -contour.covered;
  for (const Index c : m_cells)
  {
    const int is_left = m_winding[c] - left + 1; // 1 or 0
    area += m_area[c];
    border += m_border[c];
    left_area += is_left * m_area[c];
    left_border += is_left * m_border[c];
  }
  // Beyond, in faces: the winding number minus that at the first corner of the face, which is the origin of its frame, so that only
  // the pieces and the second edge contribute to the integral.
  const auto is_before = [](const auto& x, Index n) { return x.contour < n; };
  for (auto it = std::lower_bound(m_crossings.begin(), m_crossings.end(), number, is_before);
       it != m_crossings.end() && it->contour == number; ++it)
    for (const bool is_twin : {false, true})
    {
      const Index h = is_twin ? m_mesh.twin(it->halfedge) : it->halfedge;
      if (h == no_index)
      {
        left_border += it->jump * (1 - it->t) * length_of(it->halfedge);
        continue;
      }
      const double part[] = {1, is_twin ? it->t : 1 - it->t, 0};
      left_area += (is_twin ? -it->jump : it->jump) * part[h % 3] * area_of(h / 3);
    }
  for (auto it = std::lower_bound(m_pieces.begin(), m_pieces.end(), number, is_before);
       it != m_pieces.end() && it->contour == number; ++it)
    left_area += cross(it->start, it->end) / 2;

  const double strip = Offset_tolerances<double>::border_strip(contour.length);
  const double areas[] = {(std::max)(0., left_area), (std::max)(0., area - left_area)};
  const double borders[] = {left_border, border - contour.covered - left_border};
  // A strip between the polyline and the border is no side.
  const auto is_strip = [&](int i) {
    return areas[i] <= strip * contour.length && (borders[i] > strip || contour.covered > strip);
  };
  const auto only = [](bool left_is, bool right_is) { return left_is == right_is ? -1 : left_is ? 0 : 1; };
  int inner = only(!is_strip(0), !is_strip(1));
  if (inner < 0) inner = only(!(borders[0] > strip), !(borders[1] > strip));
  result.is_by_area = inner < 0;
  if (inner < 0) inner = areas[1] < areas[0] ? 1 : 0;
  result.has_border = borders[inner] > strip;
  result.side = inner == 0 ? Source_side::LEFT : Source_side::RIGHT;
  result.inner_area = areas[inner];
  result.outer_area = areas[1 - inner];
  return result;
}

template <class FT>
std::map<std::size_t, Geodesic_inner_side> Inner_sides<FT>::operator()()
{
  std::map<std::size_t, Geodesic_inner_side> result;
  if (m_contours.empty()) return result;
  std::sort(m_crossings.begin(), m_crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.contour, a.halfedge, a.t) < std::tie(b.contour, b.halfedge, b.t);
  });
  std::sort(m_pieces.begin(), m_pieces.end(),
            [](const Piece& a, const Piece& b) { return std::tie(a.contour, a.face) < std::tie(b.contour, b.face); });
  find_cells();
  for (const Contour& c : m_contours) result[c.id] = side_of(c);
  return result;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
