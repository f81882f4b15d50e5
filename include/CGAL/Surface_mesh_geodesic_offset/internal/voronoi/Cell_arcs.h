// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arcs of bisectors in one cell, from all pairs of its windows.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_CELL_ARCS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_CELL_ARCS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_arc.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Label_changes.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Parameter_intervals.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_cell.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Where a bisector runs along a side, the label of the side is that of one of the two cells, or a third one that ties there; it
// is the same for both cells. So the arc belongs to the cell whose label is not that of the side.
template <class NT>
class Arcs_along_sides
{
public:
  typedef Point_in_face<NT> Point;

  // The tolerances may change between calls.
  Arcs_along_sides(const std::vector<Voronoi_window<NT>>& windows, const Voronoi_tolerances<NT>& tolerances)
    : m_windows(windows), m_tolerances(tolerances)
  {
  }

  // Divides arcs along sides at the gates, and removes the parts that belong to the neighbour.
  void keep_own(const Voronoi_cell<NT>& cell, std::vector<Bisector_arc<NT>>& arcs) const
  {
    std::vector<Bisector_arc<NT>> own;
    for (const Bisector_arc<NT>& a : arcs)
    {
      int k = 0;
      while (k < 3 && !is_along(cell, k, a)) ++k;
      if (k == 3) own.push_back(a);
      else add_own_parts(cell, k, a, own);
    }
    arcs.swap(own);
  }

  // A side may have a label that no window of the cell has there, but one beyond the side: adds links along it, between this
  // label and that of the cell.
  void add_links(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates, std::vector<Bisector_arc<NT>>& arcs)
  {
    for (int k = 0; k < 3; ++k)
    {
      NT begin = 0;
      Index label = cell.label[k];
      for (const Voronoi_gate<NT>& g : cell.gates)
      {
        if (g.side != k) continue;
        const NT end = dot(g.point - cell.corner[k], cell.direction[k]);
        add_links(cell, candidates, k, begin, end, label, arcs);
        begin = end;
        label = g.to;
      }
      add_links(cell, candidates, k, begin, cell.side_length(k), label, arcs);
    }
  }

private:
  bool is_along(const Voronoi_cell<NT>& cell, int k, const Bisector_arc<NT>& a) const
  {
    return a.is_on(cell.outside(k), m_tolerances.along_side());
  }

  static void add_own_parts(const Voronoi_cell<NT>& cell, int k, const Bisector_arc<NT>& a, std::vector<Bisector_arc<NT>>& own)
  {
    const auto position = [&](const Point& p) { return dot(p - cell.corner[k], cell.direction[k]); };
    const bool is_forward = position(a.end) > position(a.start);
    const Index inner = is_forward ? a.left.label : a.right.label;
    std::vector<NT> ends{a.from, a.to};
    for (const Voronoi_gate<NT>& g : cell.gates)
    {
      const NT t = g.side == k ? a.conic.parameter_near(g.point, a.conic.between(a.from, a.to, 0.5)) : a.from;
      if (a.from < t && t < a.to) ends.push_back(t);
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      Bisector_arc<NT> part(a);
      part.from = ends[i];
      part.to = ends[i + 1];
      part.start = part.conic.at(part.from).point();
      part.end = part.conic.at(part.to).point();
      Index label = cell.label[k]; // of the side
      for (const Voronoi_gate<NT>& g : cell.gates)
        if (g.side == k && position(g.point) <= position(part.middle())) label = g.to;
      if (label == inner) continue;
      Bisector_side& beyond = is_forward ? part.right : part.left;
      if (label != beyond.label)
      {
        part.is_link = true;
        part.left.window = part.right.window = no_index;
        beyond = Bisector_side();
        beyond.label = label;
      }
      own.push_back(part);
    }
  }

  // For the part of side k from `begin` to `end`, with a label.
  void add_links(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates, int k, NT begin, NT end, Index label,
                 std::vector<Bisector_arc<NT>>& arcs)
  {
    const auto at = [&](NT t) { return cell.corner[k] + t * cell.direction[k]; };
    const auto is_of_neighbour = [&](NT t) {
      const Point p = at(t);
      const NT most = least_path_length(m_windows, candidates, p) + m_tolerances.of_neighbour();
      return std::none_of(candidates.begin(), candidates.end(), [&](unsigned c) {
        const Voronoi_window<NT>& w = m_windows[c];
        return w.label == label && w.distance_at(p) <= most && w.contains(p, m_tolerances.slack);
      });
    };
    if (end - begin <= m_tolerances.joint) return;
    if (candidates.empty())
    { // the face has the label of its first corner
      if (label != cell.label[0]) arcs.push_back(Bisector_arc<NT>::link(at(begin), at(end), cell.label[0], label));
      return;
    }
    if (!is_of_neighbour(begin) && !is_of_neighbour((begin + end) / 2) && !is_of_neighbour(end)) return;
    std::vector<Label_change<NT>> changes;
    m_changes(at(begin), cell.direction[k], end - begin, label, label, m_windows, candidates, candidates, m_tolerances,
              std::nullopt, [&](const Label_change<NT>& c) { changes.push_back(c); });
    for (std::size_t i = 0; i + 1 < changes.size(); ++i)
    {
      const Index inner = changes[i].to;
      const NT from = begin + changes[i].t, to = begin + changes[i + 1].t;
      if (inner == label || to - from <= m_tolerances.joint || !is_of_neighbour((from + to) / 2)) continue;
      const Point p = at((from + to) / 2);
      const bool is_known = std::any_of(arcs.begin(), arcs.end(), [&](const Bisector_arc<NT>& a) {
        return is_along(cell, k, a) && dot(p - a.start, cell.direction[k]) * dot(p - a.end, cell.direction[k]) <= 0;
      });
      if (!is_known) arcs.push_back(Bisector_arc<NT>::link(at(from), at(to), inner, label));
    }
  }

  const std::vector<Voronoi_window<NT>>& m_windows;
  const Voronoi_tolerances<NT>& m_tolerances;
  Label_changes<NT> m_changes;
};

// The bisector of two windows of different sources belongs to the diagram where it is in the cell and in both cones, and where no
// other window is nearer. Each of these conditions is quadratic in the parameter of the bisector.
template <class NT>
class Cell_arcs
{
public:
  typedef Point_in_face<NT> Point;

  // `center`, `radius`: a disk around the face. The tolerances may change between calls.
  Cell_arcs(const std::vector<Voronoi_window<NT>>& windows, const Voronoi_tolerances<NT>& tolerances, const Point& center,
            NT radius)
    : m_windows(windows), m_tolerances(tolerances), m_center(center), m_radius(radius)
  {
  }

  // Adds the arcs in a cell, of some of the windows, that reach up to `margin` beyond its sides.
  void operator()(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates, NT margin,
                  std::vector<Bisector_arc<NT>>& out) const
  {
    std::vector<Distances_in_cell> distances;
    for (const unsigned i : candidates) distances.emplace_back(m_windows[i], cell);
    // A corner moves by up to the slack, which is at least the margin, over the sine of half its angle, at most twice the diameter
    // over the least height; the difference of two distances changes by twice as much.
    const NT beyond = m_tolerances.slack * (2 + 4 * cell.diameter() / cell.least_height());
    for (std::size_t i = 0; i < candidates.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (m_windows[candidates[i]].label != m_windows[candidates[j]].label && !distances[i].are_less(distances[j], beyond) &&
            !distances[j].are_less(distances[i], beyond))
          add_arcs(cell, candidates, candidates[i], candidates[j], margin, out);
  }

private:
  // The distances of a window in a cell, were there no cone: convex, and below the linear interpolation of the corners by no more
  // than `bend`, as their second derivatives are at most the inverse of the distance from the image.
  struct Distances_in_cell
  {
    std::array<NT, 3> at_corner;
    NT bend = 0;

    Distances_in_cell(const Voronoi_window<NT>& w, const Voronoi_cell<NT>& cell)
    {
      for (int k = 0; k < 3; ++k) at_corner[std::size_t(k)] = w.distance_at(cell.corner[k]);
      if (w.is_parallel()) return;
      const NT radius = cell.radius(), to_image = length(cell.center() - w.image()) - radius;
      bend = to_image > radius / 4 ? radius * radius / (2 * to_image) : 2 * radius;
    }

    // True if they are less than others by more than `margin`, everywhere in the cell.
    bool are_less(const Distances_in_cell& other, NT margin) const
    {
      bool result = true;
      for (std::size_t k = 0; k < 3; ++k) result = result && at_corner[k] + margin < other.at_corner[k] - other.bend;
      return result;
    }
  };

  // Adds the parts of the bisector of two windows that belong to the diagram.
  void add_arcs(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates, unsigned a, unsigned b, NT margin,
                std::vector<Bisector_arc<NT>>& out) const
  {
    const Voronoi_window<NT>*v = &m_windows[a], *w = &m_windows[b];
    if (v->is_parallel()) // the base is a point, if one of them is
    {
      std::swap(v, w);
      std::swap(a, b);
    }
    Bisector_conic<NT> conic;
    if (is_same_function(*v, *w))
    { // the bounds of the cone of the smaller label
      const unsigned c = v->label < w->label ? a : b;
      for (const bool is_left : {true, false})
      {
        conic.make_bound(m_windows[c], is_left);
        add_parts(cell, candidates, conic, a, b, c, margin, out);
      }
    }
    else if (conic.make(*v, *w, m_tolerances.tie, m_center))
      add_parts(cell, candidates, conic, a, b, precedes(a, b) ? a : b, margin, out);
  }

  // `nearer`: the one of the two windows that is nearer in its cone, if the bisector is a ray. The ray is then a bound of this
  // cone.
  void add_parts(const Voronoi_cell<NT>& cell, const std::vector<unsigned>& candidates, const Bisector_conic<NT>& conic,
                 unsigned a, unsigned b, unsigned nearer, NT margin, std::vector<Bisector_arc<NT>>& out) const
  {
    const Voronoi_window<NT>&v = m_windows[a], &w = m_windows[b];
    Parameter_intervals<NT> parts(conic.lowest_parameter(), std::numeric_limits<NT>::infinity());
    const auto keep = [&](const Half_plane<NT>& h, NT m) {
      parts.keep_not_positive(conic.along(Linear_form<NT>{h.n.x, h.n.y, 0, h.m + m}));
      return !parts.is_empty();
    };
    for (const Voronoi_window<NT>* const x : {&v, &w})
      for (int k = 0; k < x->number_of_bounds; ++k)
        if (!keep(x->bound[std::size_t(k)], m_tolerances.slack)) return;
    for (int k = 0; k < 3; ++k)
      if (!keep(cell.outside(k), margin)) return;
    const std::array<Point, 3> around = conic.triangle_around(parts.begin()->begin, std::prev(parts.end())->end);
    for (const unsigned c : candidates)
    {
      if (c == a || c == b || is_outside_cone(m_windows[c], around)) continue;
      subtract_nearer(conic, v, w, a, b, c, parts);
      if (parts.is_empty()) return;
    }
    for (const auto& p : parts)
    {
      if (!is_finite(p.begin) || !is_finite(p.end)) continue;
      const NT middle = conic.between(p.begin, p.end, 0.5);
      const Point point = conic.at(middle).point();
      bool a_is_on_left;
      if (conic.is_ray())
      {
        // rays point away from the images, as does the direction of the bisector
        const bool is_left_bound = is_on_bound(m_windows[nearer], 0, point),
                   is_right_bound = is_on_bound(m_windows[nearer], 1, point);
        if (is_left_bound == is_right_bound) continue;
        // the normals of bounds point out of the cone
        const Point beyond = point + 4 * m_tolerances.slack * m_windows[nearer].bound[is_left_bound ? 0 : 1].n;
        if (!is_nearest_beyond_ray(candidates, nearer == a ? b : a, nearer, beyond)) continue;
        a_is_on_left = is_right_bound == (nearer == a);
      }
      else
      {
        const Point growth = v.gradient(point) - w.gradient(point); // of the distance of a, compared to b
        a_is_on_left = cross(conic.tangent(middle), growth) < 0;
      }
      out.push_back(arc(conic, a, b, p.begin, p.end, a_is_on_left));
    }
  }

  // True if one of the bounds of a cone separates it from a triangle.
  bool is_outside_cone(const Voronoi_window<NT>& w, const std::array<Point, 3>& triangle) const
  {
    return std::any_of(w.bound.begin(), w.bound.begin() + w.number_of_bounds, [&](const Half_plane<NT>& h) {
      return std::all_of(triangle.begin(), triangle.end(), [&](const Point& p) { return h.value(p) > m_tolerances.slack; });
    });
  }

  // True if no window but `nearer`, whose cone ends at a ray, precedes window a at a point beyond this ray.
  bool is_nearest_beyond_ray(const std::vector<unsigned>& candidates, unsigned a, unsigned nearer, const Point& p) const
  {
    const NT d = m_windows[a].distance_at(p);
    return std::none_of(candidates.begin(), candidates.end(), [&](unsigned c) {
      if (c == a || c == nearer || !m_windows[c].contains(p, 0) || is_same_function(m_windows[a], m_windows[c])) return false;
      return m_windows[c].distance_at(p) <= d + (this->precedes(c, a) ? m_tolerances.tie : -m_tolerances.tie);
    });
  }

  Bisector_arc<NT> arc(const Bisector_conic<NT>& conic, unsigned a, unsigned b, NT from, NT to, bool a_is_on_left) const
  {
    Bisector_arc<NT> arc;
    arc.conic = conic;
    arc.from = from;
    arc.to = to;
    arc.start = conic.at(from).point();
    arc.end = conic.at(to).point();
    const unsigned left = a_is_on_left ? a : b, right = a_is_on_left ? b : a;
    arc.left = Bisector_side::of(m_windows[left], left);
    arc.right = Bisector_side::of(m_windows[right], right);
    return arc;
  }

  // True if p is on a bounding ray of a window, up to rounding: the left one (0) or the right one (1).
  bool is_on_bound(const Voronoi_window<NT>& w, int k, const Point& p) const
  {
    return w.bound[std::size_t(k)].value(p) > -4 * m_tolerances.slack;
  }

  bool is_same_function(const Voronoi_window<NT>& v, const Voronoi_window<NT>& w) const
  {
    return v.is_same_function(w, m_center, m_radius, m_tolerances.tie);
  }

  // Subtracts the points where window c is nearer than the windows v and w (a and b) of the bisector; where they tie, the order of
  // windows decides.
  void subtract_nearer(const Bisector_conic<NT>& conic, const Voronoi_window<NT>& v, const Voronoi_window<NT>& w, unsigned a,
                       unsigned b, unsigned c, Parameter_intervals<NT>& parts) const
  {
    const Voronoi_window<NT>& x = m_windows[c];
    Parameter_intervals<NT> nearer = parts;
    for (int k = 0; k < x.number_of_bounds && !nearer.is_empty(); ++k)
    {
      const Half_plane<NT>& h = x.bound[std::size_t(k)];
      nearer.keep_not_positive(conic.along(Linear_form<NT>{h.n.x, h.n.y, 0, h.m + m_tolerances.slack}));
    }
    if (nearer.is_empty()) return;
    const bool like_v = is_same_function(v, x), like_w = !like_v && is_same_function(w, x);
    if (like_v || like_w)
    {
      const Voronoi_window<NT>& y = like_v ? v : w;
      if (x.label != y.label ? y.label < x.label : (like_v ? a : b) < c) return;
    }
    else
    {
      const bool precedes_v = precedes(c, a), precedes_w = precedes(c, b);
      const bool wins_ties = precedes_v == precedes_w || is_rival(conic, x, v, w, parts) ? precedes_v : precedes_w;
      const NT tie = wins_ties ? m_tolerances.tie : -m_tolerances.tie;
      if (x.is_parallel())
      {
        const Point n = x.image();
        nearer.keep_not_positive(conic.along(Linear_form<NT>{-n.x, -n.y, -1, -x.sigma() + tie}));
      }
      else if (!v.is_parallel())
      { // (|p - x|^2 - (d - sigma)^2) / 2 <= tie (d - sigma), with |p - v|^2 = (d - sigma_v)^2
        const Point to = x.image() - v.image(), sum = x.image() + v.image();
        const NT k = x.sigma() - v.sigma(), size = hypotenuse(to.x, to.y, k);
        if (k >= length(to) + m_tolerances.tie) return; // nowhere nearer
        const Linear_form<NT> form{-to.x / size, -to.y / size, (k - tie) / size,
                                   ((k * (x.sigma() + v.sigma()) - dot(to, sum)) / 2 - tie * x.sigma()) / size};
        nearer.keep_not_positive(conic.along(form));
      }
      else
      {
        // relative to the nearest point of the line, which may be the image
        const NT t = conic.nearest_parameter(x.image());
        const Quadratic<NT> excess = conic.along_line(x.image(), x.sigma(), t, tie);
        nearer.keep_not_positive(excess, t);
        nearer.keep_not_positive(conic.along(Linear_form<NT>{0, 0, -1, -x.sigma()}));
      }
    }
    parts.subtract(nearer);
  }

  // Order of windows that tie.
  bool precedes(unsigned a, unsigned b) const
  {
    const Voronoi_window<NT>&v = m_windows[a], &w = m_windows[b];
    return v.precedes(w) || (!w.precedes(v) && a < b);
  }

  // True if x may have a ray in common with v, rather than with w: their distances are equal along a ray, or else its label, or
  // a more similar direction.
  bool is_rival(const Bisector_conic<NT>& conic, const Voronoi_window<NT>& x, const Voronoi_window<NT>& v,
                const Voronoi_window<NT>& w, const Parameter_intervals<NT>& parts) const
  {
    const bool ties_with_v = x.ties_on_ray(v, m_tolerances.tie), ties_with_w = x.ties_on_ray(w, m_tolerances.tie);
    if (ties_with_v != ties_with_w) return ties_with_v;
    if (x.label == v.label || x.label == w.label) return x.label == v.label;
    const auto& part = *parts.begin();
    if (!is_finite(part.begin) || !is_finite(part.end)) return true;
    const Point p = conic.at(conic.between(part.begin, part.end, 0.5)).point(), u = x.gradient(p);
    return dot(u, v.gradient(p)) >= dot(u, w.gradient(p));
  }

  const std::vector<Voronoi_window<NT>>& m_windows;
  const Voronoi_tolerances<NT>& m_tolerances;
  const Point m_center;
  const NT m_radius;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
