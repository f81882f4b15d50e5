// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds of the distances of all points of a piece of a face.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_PIECE_BOUNDS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_PIECE_BOUNDS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Face_piece.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// A lower bound of the distances of all points of a piece, and an upper bound of them; and whether no point inside the piece
// can be a local maximum of the distance that is larger than the level, if this was wanted.
//
// The distance at a point of a face is the least of the functions of the windows whose rays reach it, of the sources in the
// face, and of the paths by way of the three vertices. Each function has its exact range on the piece. It is at least the
// range's least value for the lower bound, unless all rays of the window certainly miss the piece's convex hull; for the upper
// bound it counts only if its rays reach the whole hull, which is so if they reach the corners of the hull, as the rays of a
// window cover a convex part of the face.
//
// Where neighbouring windows meet, the rays of none of them reach all of a piece. There the distance of an inner point bounds the
// others, as distances differ by no more than the points are apart.
struct Piece_range
{
  double lower, upper;
  Bounds at_inner_point;
  bool has_no_maximum;
};

class Piece_bounds
{
public:
  typedef Point_in_face<double> Point;

  // `level`: smaller local maxima do not matter.
  Piece_bounds(const Certified_mesh& mesh, const Certified_sources& sources, const Certified_field& field, double level)
    : m_mesh(mesh), m_sources(sources), m_field(field), m_level(level), m_is_source(mesh.unfolded().number_of_vertices(), 0)
  {
    for (const Certified_source_vertex& s : sources.vertices) m_is_source[s.vertex] = 1;
  }

  // Selects the face; all windows of it may matter.
  void set_face(Index face)
  {
    m_face = face;
    m_candidates.clear();
    for (int k = 0; k < 3; ++k)
      m_field.for_each_window(3 * face + Index(k), [&](const Certified_window& w) { m_candidates.push_back({&w, k, 0}); });
    m_perimeter = m_mesh.length(3 * face) + m_mesh.length(3 * face + 1) + m_mesh.length(3 * face + 2);
  }

  // The candidates for pieces that are not part of another one.
  std::size_t first_candidate() const { return 0; }
  std::size_t end_of_candidates() const { return m_candidates.size(); }
  void drop_candidates(std::size_t end) { m_candidates.resize(end); }

  // Bounds the distances of a piece, given in the frame of the face's first halfedge. `moved`: bound of the difference between
  // this piece and the piece in question. Appends the candidates in [begin, end) that may matter for parts of the piece.
  Piece_range operator()(const Face_piece& piece, double moved, std::size_t begin, std::size_t end, bool wants_maxima)
  {
    Bounds inner(0., Number_policy<double>::infinity());
    if (piece.size > 1)
    {
      const Piece_range r = (*this)(Face_piece::point(piece.inner_point()), moved + piece.rounding(), begin, end, false);
      inner = {r.lower, r.upper};
      drop_candidates(end);
    }
    const double reach = piece.size > 1 ? piece.diameter() + piece.rounding() : Number_policy<double>::infinity();
    m_lower = m_upper = Number_policy<double>::infinity();
    m_directions.clear();
    m_dividing = {0., 0.};
    const double everywhere = moved + 4 * length_error * m_perimeter + piece.rounding() + piece.off_circle();
    Face_piece frame[3] = {piece, {}, {}};
    frame[1] = frame[0].in_next_frame(m_mesh, 3 * m_face);
    frame[2] = frame[1].in_next_frame(m_mesh, 3 * m_face + 1);
    for (Face_piece& f : frame) f = f.above_axis();
    add_sources(piece, everywhere);
    add_vertices(frame, everywhere);
    for (std::size_t i = begin; i < end; ++i)
    {
      const Candidate c = m_candidates[i];
      add_window(c, frame[c.frame], everywhere + 2 * frame[c.frame].clamped);
    }
    const double upper = m_upper = (std::min)(m_upper, inner.second + reach);
    const auto is_farther = [&](const Candidate& c) { return c.lower > upper; };
    m_candidates.erase(std::remove_if(m_candidates.begin() + std::ptrdiff_t(end), m_candidates.end(), is_farther),
                       m_candidates.end());
    bool has_no_maximum = false;
    if (wants_maxima && Number_policy<double>::is_finite(upper))
    {
      add_source_directions(piece, everywhere);
      for (std::size_t i = end; i < m_candidates.size(); ++i) add_directions(m_candidates[i], frame[m_candidates[i].frame]);
      add_vertex_directions(frame);
      has_no_maximum = are_in_half_plane();
    }
    // A path that passes a vertex within the error of an image may be shorter by this error; see the error analysis.
    const double lower = (std::max)({m_lower * (1 - 2 * unit_roundoff) - m_sources.loss, inner.first - reach, 0.});
    return {lower, upper, piece.size > 1 ? inner : Bounds(lower, upper), has_no_maximum};
  }

private:
  struct Candidate
  {
    const Certified_window* window;
    int frame;
    double lower; // of the piece for which it was appended
  };

  void take(double lower, double upper)
  {
    m_lower = (std::min)(m_lower, lower);
    m_upper = (std::min)(m_upper, upper);
  }

  static Bounds distances_from(const Face_piece& piece, const Certified_source& s)
  {
    return s.is_segment ? distances_from_segment(piece, s) : piece.distances_from(s.first);
  }

  double error_of(const Certified_source& s, const Bounds& distances, double everywhere) const
  {
    return 4 * s.moved + everywhere + length_error * (s.start_value + distances.second + m_perimeter);
  }

  void add_sources(const Face_piece& piece, double everywhere)
  {
    m_sources.for_each_in_face(m_face, [&](const Certified_source& s) {
      const Bounds d = distances_from(piece, s);
      const double error = error_of(s, d, everywhere);
      take(s.start_value + d.first - error, s.start_value + d.second + error);
    });
  }

  // Paths from a source are among the vectors from its ends to the corners of the hull, which span a cone if source and piece
  // are disjoint.
  void add_source_directions(const Face_piece& piece, double everywhere)
  {
    m_sources.for_each_in_face(m_face, [&](const Certified_source& s) {
      const Bounds d = distances_from(piece, s);
      const double error = error_of(s, d, everywhere);
      if (s.start_value + d.first - error > m_upper) return;
      if (!(d.first > error))
      {
        const bool is_first = m_dividing.x == 0 && m_dividing.y == 0;
        if (is_first && divides(s, piece, error)) return;
        m_has_unknown = true;
      }
      for (int i = 0; i < piece.size && !m_has_unknown; ++i)
        for (const Double_double_2& end : {s.first, s.second})
        {
          const Point v = difference(piece.hull[i], end);
          add_direction(0, (1 / length(v)) * v);
        }
    });
  }

  // True if a source segment passes the piece, none of whose points are beyond its ends: each point has only the ray that is normal
  // to the segment, from its side. A side where the piece is no farther from the segment than the error does not matter if the
  // distances there are at most the level. An error of 1e-7 of the segment turns the normal by less than the margin of the
  // directions.
  bool divides(const Certified_source& s, const Face_piece& piece, double error)
  {
    if (!s.is_segment || !(s.start_value + 2 * error <= m_level)) return false;
    const Point way = difference(s.second, s.first), along = (1 / length(way)) * way, n = quarter_turn(along);
    const double first = along.x * s.first.x.high + along.y * s.first.y.high;
    const Bounds place = piece.products_with(along);
    if (!(error < 0.1 * direction_margin * length(way)) || place.first - first < error ||
        first + length(way) - place.second < error)
      return false;
    const double height = n.x * s.first.x.high + n.y * s.first.y.high;
    const Bounds heights = piece.products_with(n);
    m_dividing = n;
    m_has_side[0] = heights.second - height > error;
    m_has_side[1] = height - heights.first > error;
    return true;
  }

  static Bounds distances_from_segment(const Face_piece& piece, const Certified_source& s)
  {
    const Point way = difference(s.second, s.first), along = (1 / length(way)) * way, n = quarter_turn(along);
    Bounds result(Number_policy<double>::infinity(), 0.);
    const auto nearer = [&](double d) { result.first = (std::min)(result.first, d); };
    // the distance to a segment is convex: at most that of a corner of the hull
    for (int i = 0; i < piece.size; ++i)
    {
      const double d = Face_piece::near_segment(difference(s.first, piece.hull[i]), difference(s.second, piece.hull[i]));
      result.second = (std::max)(result.second, d);
      if (i < 2 || !piece.is_arc) nearer(d);
    }
    // The least distance is that of an end of the source, or of an end of the piece, or of the point of an arc whose tangent is
    // parallel to the source and whose foot is in it; or piece and source may cross.
    nearer(piece.distances_from(s.first).first);
    nearer(piece.distances_from(s.second).first);
    const auto product = [](const Point& u, const Double_double_2& p) { return u.x * p.x.high + u.y * p.y.high; };
    const double level = product(n, s.first), slack = 4 * s.moved;
    const double first = product(along, s.first) - slack, second = product(along, s.second) + slack;
    const Bounds height = piece.products_with(n), place = piece.products_with(along);
    if (height.first <= level && level <= height.second && place.first <= second && place.second >= first) nearer(0.);
    if (!piece.is_arc) return result;
    const double foot = product(along, piece.center), center = product(n, piece.center);
    if (foot < first || foot > second) return result;
    if (piece.has_direction(n)) nearer(std::abs(center + piece.radius - level));
    if (piece.has_direction(-1. * n)) nearer(std::abs(center - piece.radius - level));
    return result;
  }

  void add_vertices(const Face_piece (&frame)[3], double everywhere)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index v = m_mesh.unfolded().source(3 * m_face + Index(k));
      if (!Number_policy<double>::is_finite(m_field.bounds.upper(v))) continue;
      const Bounds d = frame[k].distances_from({Double_double(0.), Double_double(0.)});
      const double error = length_error * (m_field.bounds.upper(v) + d.second) + everywhere + 2 * frame[k].clamped;
      take(m_field.bounds.lower(v) + d.first - error, m_field.bounds.upper(v) + d.second + error);
      m_by_vertex[k] = m_field.bounds.lower(v) + d.first - error;
    }
  }

  Double_double place(const Candidate& c, double b) const
  {
    const Index h = 3 * m_face + Index(c.frame);
    return b < m_mesh.length(h) ? Double_double(b) : m_mesh[h].length;
  }

  void add_window(const Candidate& c, const Face_piece& piece, double everywhere)
  {
    const Certified_window& w = *c.window;
    const Double_double b0 = place(c, w.b0), b1 = place(c, w.b1);
    bool is_left = true, is_right = true, is_inside = true;
    double around = 0;
    for (int i = 0; i < piece.size; ++i)
    {
      const Double_double& x = piece.hull[i].x;
      const double y = piece.hull[i].y.high;
      const Sign from = w.side_of(x, y, b0), to = w.side_of(x, y, b1);
      is_left = is_left && from == POSITIVE;
      is_right = is_right && to == NEGATIVE;
      is_inside = is_inside && from != POSITIVE && to != NEGATIVE;
      if (from == ZERO) around = (std::max)(around, w.way_around(x, y, b0));
      if (to == ZERO) around = (std::max)(around, w.way_around(x, y, b1));
    }
    if (is_left || is_right) return;
    Bounds d;
    if (w.is_parallel())
    {
      const Bounds product = piece.products_with({w.x, w.y});
      d = {w.sigma - product.second, w.sigma - product.first};
    }
    else
    {
      d = piece.distances_from(w.image());
      d = {w.sigma + d.first, w.sigma + d.second};
    }
    const double error =
      w.radius + length_error * (std::abs(d.second) + m_perimeter) + everywhere + 4 * w.error_of_image() + around;
    if (d.second + error < m_sources.least_start_value) return; // behind the segment that the rays start from
    m_lower = (std::min)(m_lower, d.first - error);
    if (is_inside) m_upper = (std::min)(m_upper, d.second + error);
    m_candidates.push_back({c.window, c.frame, d.first - error});
  }

  // The directions in which the rays of a window pass the piece.
  void add_directions(const Candidate& c, const Face_piece& piece)
  {
    const Certified_window& w = *c.window;
    const Double_double ends[2] = {place(c, w.b0), place(c, w.b1)};
    const auto add = [&](Point v) {
      const double l = length(v);
      add_direction(c.frame, l > 0 ? (1 / l) * v : Point{0., 0.});
    };
    if (w.is_parallel())
    {
      add({-w.x, -w.y});
      return;
    }
    const Double_double_2 a = w.image();
    for (int i = 0; i < piece.size; ++i)
    {
      const Double_double& x = piece.hull[i].x;
      const double y = piece.hull[i].y.high;
      if (w.side_of(x, y, ends[0]) == POSITIVE) add(difference({ends[0], Double_double(0.)}, a));
      else if (w.side_of(x, y, ends[1]) == NEGATIVE) add(difference({ends[1], Double_double(0.)}, a));
      else add(difference(piece.hull[i], a));
    }
  }

  // Shortest paths bend only at these vertices, or start there.
  void add_vertex_directions(const Face_piece (&frame)[3])
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index v = m_mesh.unfolded().source(3 * m_face + Index(k));
      if (!(m_mesh.can_be_pseudo_source(v) || m_is_source[v])) continue;
      if (!(m_by_vertex[k] <= m_upper) || !Number_policy<double>::is_finite(m_field.bounds.upper(v))) continue;
      for (int i = 0; i < frame[k].size; ++i)
      {
        const Point p = {frame[k].hull[i].x.high, frame[k].hull[i].y.high};
        const double l = length(p);
        // a corner of the piece that is at the vertex: paths to the points inside the piece go between the other corners
        if (l > 4 * length_error * m_perimeter) add_direction(k, (1 / l) * p);
      }
    }
  }

  // From the frame of halfedge k to that of the face.
  void add_direction(int k, const Point& u)
  {
    const Double_double_2 d = m_sources.direction(m_face, k);
    if (u.x == 0 && u.y == 0) m_has_unknown = true;
    m_directions.push_back(std::atan2(d.x.high * u.y + d.y.high * u.x, d.x.high * u.x - d.y.high * u.y));
  }

  // True if the directions are within less than half a turn, with the normal of a dividing source on each side of it.
  bool are_in_half_plane()
  {
    const bool is_unknown = m_has_unknown;
    m_has_unknown = false;
    if (is_unknown) return false;
    if (m_dividing.x == 0 && m_dividing.y == 0) return are_within_half_a_turn();
    const std::vector<double> others = m_directions;
    for (const int side : {0, 1})
    {
      m_directions = others;
      add_direction(0, (side == 0 ? 1. : -1.) * m_dividing);
      if (m_has_side[side] && !are_within_half_a_turn()) return false;
    }
    return true;
  }

  // True if one of the directions has a positive scalar product with all directions. The margin of the test is far above the
  // rounding of directions.
  bool are_within_half_a_turn()
  {
    if (m_directions.empty()) return false;
    std::sort(m_directions.begin(), m_directions.end());
    double gap = m_directions.front() + 2 * CGAL_PI - m_directions.back();
    for (std::size_t i = 1; i < m_directions.size(); ++i) gap = (std::max)(gap, m_directions[i] - m_directions[i - 1]);
    return gap > CGAL_PI + direction_margin;
  }

  static constexpr double direction_margin = 1e-6;

  const Certified_mesh& m_mesh;
  const Certified_sources& m_sources;
  const Certified_field& m_field;
  double m_level;
  std::vector<char> m_is_source; // per vertex
  Index m_face = no_index;
  double m_perimeter = 0;
  std::vector<Candidate> m_candidates;
  double m_lower = 0, m_upper = 0;
  double m_by_vertex[3] = {0, 0, 0};
  std::vector<double> m_directions;
  Point m_dividing{0, 0};              // normal of a source segment that divides the piece; zero: there is none
  bool m_has_side[2] = {false, false}; // whether the piece has points on the side of the normal, and on the other side
  bool m_has_unknown = false;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
