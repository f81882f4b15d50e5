// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rays from polylines and edges. Parallel-source windows start to both sides of every segment. Interval windows start only
// where shortest paths can start at a point: at a vertex of a polyline, in the sector between the normals on its reflex side;
// at an end, in the half disk beyond it.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_SEGMENT_SEEDING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SOURCES_SEGMENT_SEEDING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Vertex_sector.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Segment_seeding
{
public:
  typedef Surface_point<FT> Surface_point_;
  typedef Point_in_face<FT> Point;
  typedef Ray_at_vertex<FT> Ray;

  Segment_seeding(const Unfolded_mesh<FT>& mesh, Initial_windows<FT>& out) : m_mesh(mesh), m_sector(mesh), m_out(out) {}

  // start_values: of the points, linear between them; empty if they are equal, see Initial_windows::set_start_value().
  void add_polyline(Index source, const std::vector<Surface_point_>& points, const std::vector<FT>& start_values, bool closed)
  {
    const std::size_t n = points.size();
    if (n == 0) return;
    std::vector<Segment> segments;
    FT left_out(0);          // length of the degenerate segments since the last segment
    std::optional<FT> least; // start value of the points that these make one
    for (std::size_t i = 0; i + 1 < n + (closed ? 1 : 0); ++i)
    {
      Segment s;
      const Surface_point_ &p = points[i], &q = points[(i + 1) % n];
      s.part = Index(i);
      if (!start_values.empty()) s.starts = {start_values[i], start_values[(i + 1) % n]};
      if (make_segment(p, q, i, left_out, s))
      {
        set_slope(s, i);
        s.start_before = std::exchange(least, std::nullopt);
        segments.push_back(s);
        continue;
      }
      if (s.starts)
      {
        const FT start = (std::min)(s.starts->first, s.starts->second);
        m_out.set_start_value(start);
        take_least(least, start);
      }
      m_out.add_primitive({source, s.part, true}, {p, q}); // sends no rays, but certified bounds count it
    }
    if (segments.empty() || (closed && segments.size() == 1)) // a single segment is as short as those that lead back
    {
      if (!start_values.empty()) m_out.set_start_value(*std::min_element(start_values.begin(), start_values.end()));
      m_out.add_point(source, points.front());
      return;
    }
    if (closed && least) take_least(segments.front().start_before, *least);
    straighten(segments, closed);
    for (const Segment& s : segments)
    {
      if (s.is_silent) continue;
      if (s.starts) m_out.set_start_value((std::min)(s.starts->first, s.starts->second));
      add_segment(source, s);
      if (const auto other = across_barrier(s)) add_segment(source, *other);
    }
    const std::size_t m = segments.size();
    if (!closed)
    {
      add_corner(source, segments.front().first, nullptr, &segments.front(), 0);
      add_corner(source, segments.back().second, &segments.back(), nullptr, Index(n - 1), least);
    }
    for (std::size_t i = closed ? 0 : 1; i < m; ++i)
      add_corner(source, segments[i].first, &segments[(i + m - 1) % m], &segments[i], segments[i].part);
  }

  // Adds edges, given by one halfedge each.
  void add_edges(Index source, const std::vector<Index>& halfedges)
  {
    std::vector<Index> ends;
    std::vector<char> is_source(m_mesh.number_of_halfedges(), 0);
    for (std::size_t i = 0; i < halfedges.size(); ++i)
    {
      for (const Index h : {halfedges[i], m_mesh.across_barrier(halfedges[i])})
      {
        if (h == no_index || is_source[h]) continue;
        is_source[h] = 1;
        const Index primitive =
          m_out.add_primitive({source, Index(i), true},
                              {Surface_point_::at_vertex(m_mesh.source(h)), Surface_point_::at_vertex(m_mesh.target(h))});
        const Source_ref source_ref(primitive, Source_side::NONE);
        m_out.add_edge_windows(h, FT(0), m_mesh[h].length, source_ref, source_ref);
        if (m_mesh.twin(h) != no_index) is_source[m_mesh.twin(h)] = 1;
        for (const Index v : {m_mesh.source(h), m_mesh.target(h)}) m_mesh.for_each_copy(v, [&](Index w) { ends.push_back(w); });
      }
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (Index v : ends)
    {
      const Surface_point_ place = Surface_point_::at_vertex(v);
      const Source_ref source_ref(m_out.add_primitive({source, v, false}, {place, place}), Source_side::NONE);
      m_out.add_seed_at_source(v, source_ref);
      m_mesh.for_each_fan(v, [&](Index first) { add_fan_between_edges(v, first, is_source, source_ref); });
    }
  }

private:
  struct Segment
  {
    Surface_point_ first, second;
    Index face = no_index; // contains both ends
    Point a{}, b{};
    unsigned edge = 0; // bit of the halfedge that contains both ends, or 0
    Index part = no_index;
    Point direction{};                            // unit vector from a to b
    FT uncertainty{};                             // of the direction, an angle
    bool is_short = false;                        // see Source_primitive
    std::optional<std::pair<FT, FT>> starts = {}; // start values of the ends, if those of the polyline may differ
    std::optional<FT> start_before = {};          // start value of the points before it that are one with its first one
    bool varies = false;                          // they differ
    bool is_silent = false;                       // they differ by the length or more: paths to one end are nowhere longer
  };

  static void take_least(std::optional<FT>& least, const FT& start)
  {
    if (!least || start < *least) least = start;
  }

  // Makes the segment from p, the point with the given number, to q. Returns false for a degenerate segment, which has no
  // direction and no sides: the points are equal, or count as one point of a face or an edge. Throws if they have no face in
  // common. `left_out`: total length of the degenerate segments since the last segment. It is limited, so that a polyline of
  // many tiny segments is not lost.
  bool make_segment(const Surface_point_& p, const Surface_point_& q, std::size_t number, FT& left_out, Segment& s) const
  {
    find_face(p, q, s);
    if (s.face == no_index)
      throw std::invalid_argument("Surface_mesh_geodesic_offset: point " + std::to_string(number) +
                                  " of a polyline and the next one have no face in common");
    if (s.first.kind == Surface_point_::VERTEX && s.second.kind == Surface_point_::VERTEX &&
        s.first.element == s.second.element)
      return false;
    const FT size = length(s.b - s.a);
    if (!CGAL::is_positive(size)) return false;
    if (are_of_one_element(m_mesh, s.first, s.second) && left_out + size <= size_of_point(m_mesh, s.face))
    {
      left_out += size;
      return false;
    }
    left_out = FT(0);
    s.direction = (FT(1) / size) * (s.b - s.a);
    if (s.edge)
    { // exactly that of the edge: rounding in coordinates would turn a short segment
      const Point along = Face_frame<FT>(m_mesh, s.face).direction(edge_of_bit(s.edge));
      s.direction = CGAL::is_negative(dot(along, s.direction)) ? FT(-1) * along : along;
    }
    s.uncertainty = s.edge ? FT(0) : m_out.direction_uncertainty(s.face, size);
    s.is_short = size <= largest_short_part() * Face_frame<FT>(m_mesh, s.face).longest_edge();
    return true;
  }

  // Compares the start values of the ends. number: of the segment, for messages.
  void set_slope(Segment& s, std::size_t number) const
  {
    if (!s.starts || s.starts->first == s.starts->second) return;
    if (!s.edge)
      throw std::invalid_argument("Surface_mesh_geodesic_offset: segment " + std::to_string(number) +
                                  " of a polyline has start values that vary, but is not along an edge; "
                                  "split_along_polylines() makes edges of it");
    s.varies = true;
    const FT size = length(s.b - s.a), rest = size - CGAL::abs(FT(s.starts->second - s.starts->first));
    s.is_silent = rest <= Number_policy<FT>::rounding(roundings_of_slope) * size;
  }

  // Units of rounding that the slope of start values is at least less than 1: rays along the segment have a rounding error of a
  // quarter of this in their direction, by which they would not leave the edge.
  static constexpr double roundings_of_slope = 256;

  // Finds a face of both ends, one where they are on the same edge if there is one, and the sides of barriers of this face.
  void find_face(const Surface_point_& p, const Surface_point_& q, Segment& s) const
  {
    s.face = no_index;
    for_each_side(m_mesh, p, [&](const Surface_point_& first) {
      for_each_side(m_mesh, q, [&](const Surface_point_& second) {
        Segment t = s;
        const Index face = face_of_both(m_mesh, first, second, t.a, t.b, t.edge);
        if (face == no_index || (s.face != no_index && (s.edge || !t.edge))) return;
        t.first = first;
        t.second = second;
        t.face = face;
        s = t;
      });
    });
  }

  // The segment on the other side of the barrier along which it runs; empty if there is none.
  std::optional<Segment> across_barrier(const Segment& s) const
  {
    const Index h = s.edge ? m_mesh.across_barrier(3 * s.face + Index(edge_of_bit(s.edge))) : no_index;
    if (h == no_index) return std::nullopt;
    Segment other = s;
    other.face = m_mesh.face(h);
    for (Surface_point_* const p : {&other.first, &other.second})
    {
      const Surface_point_ known = *p;
      for_each_side(m_mesh, known, [&](const Surface_point_& q) {
        if (q.kind == Surface_point_::VERTEX ? q.element == m_mesh.source(h) || q.element == m_mesh.target(h) : q.element == h)
          *p = q;
      });
    }
    unsigned edges;
    position_in_face(m_mesh, other.first, other.face, other.a, edges);
    position_in_face(m_mesh, other.second, other.face, other.b, edges);
    other.edge = 1u << h % 3;
    const Point along = Face_frame<FT>(m_mesh, other.face).direction(int(h % 3));
    other.direction = CGAL::is_negative(dot(along, other.b - other.a)) ? FT(-1) * along : along;
    return other;
  }

  // Length of a short segment, as a part of an edge: a straight path of 2^14 edges may miss its goal by as much, see
  // Path_goals::nearby.
  static FT largest_short_part() { return FT(1. / (1 << 16)); }

  // Gives a short segment the direction of an adjacent segment, or the opposite one, if both are equal up to rounding. Otherwise
  // the strips of rays of the two segments would overlap, or leave a gap that widens with the distance.
  void straighten(std::vector<Segment>& segments, bool closed) const
  {
    const std::size_t m = segments.size(), steps = closed ? 2 * m : m;
    for (std::size_t j = 1; j < steps; ++j)
    {
      Segment& s = segments[j % m];
      take_direction(segments[(j - 1) % m], s.first, s);
    }
    for (std::size_t j = steps - 1; j > 0; --j)
    {
      Segment& s = segments[(j - 1) % m];
      take_direction(segments[j % m], s.second, s);
    }
  }

  // Largest distance of an end of a segment from the line of another segment with an equal direction, in units of rounding of
  // the longest edge: the coordinates of each of the three points are sums of two products.
  static constexpr double roundings_of_line = 16;

  // Gives s the direction of `known`, or the opposite one, if that is more certain and equal up to rounding. p: the common point
  // of both segments.
  void take_direction(const Segment& known, const Surface_point_& p, Segment& s) const
  {
    if (!(known.uncertainty < s.uncertainty) || p.kind == Surface_point_::VERTEX) return;
    if (p.kind == Surface_point_::EDGE && m_mesh.across_barrier(p.element) != no_index) return;
    Point t = vector_in_face(m_mesh, p, s.face, vector_at_point(m_mesh, p, known.face, known.direction));
    if (CGAL::is_negative(dot(t, s.direction))) t = FT(-1) * t;
    // The rounding of a large face must not count in a tiny face next to it.
    const FT size =
      (std::min)(Face_frame<FT>(m_mesh, s.face).longest_edge(), Face_frame<FT>(m_mesh, known.face).longest_edge());
    const FT off = CGAL::abs(cross(t, s.b - s.a)); // of the end of the segment
    if (!CGAL::is_positive(dot(t, s.direction)) || off > Number_policy<FT>::rounding(roundings_of_line) * size) return;
    s.direction = t;
    s.uncertainty = known.uncertainty;
  }

  void add_segment(Index source, const Segment& s)
  {
    const Index primitive = m_out.add_primitive({source, s.part, true, s.is_short, s.varies}, {s.first, s.second});
    const Source_ref left(primitive, Source_side::LEFT), right(primitive, Source_side::RIGHT);
    const Face_frame<FT> frame(m_mesh, s.face);
    if (s.edge)
    {
      const int k = edge_of_bit(s.edge);
      const Index h = 3 * s.face + Index(k);
      FT ta = position_on_edge(s.first, h), tb = position_on_edge(s.second, h);
      const bool forward = ta < tb;
      if (!forward) std::swap(ta, tb);
      if (!s.varies) m_out.add_edge_windows(h, ta, tb, forward ? left : right, forward ? right : left);
      else
        m_out.add_edge_windows(h, ta, tb, forward ? left : right, forward ? right : left,
                               forward ? s.starts->first : s.starts->second, forward ? s.starts->second : s.starts->first);
      return;
    }
    const FT size = length(s.b - s.a);
    const FT extent = frame.longest_edge();
    const Point &t = s.direction, n = {-t.y, t.x};
    m_out.add_strip(s.face, s.a, s.b, n, left);
    m_out.add_strip(s.face, s.b, s.a, FT(-1) * n, right);
    for (int k = 0; k < 3; ++k)
    {
      const Point v = frame.corner(k) - s.a;
      const FT foot = dot(t, v);
      // A corner on the normal through an end of the segment counts as beside the segment, up to the rounding of its direction.
      const FT direction = Number_policy<FT>::rounding(16) * (size + extent) / size;
      const FT allowance = (std::min)(direction, Number_policy<FT>::rounding(1 << 20)) * (size + length(v));
      if (foot < -allowance || foot > size + allowance) continue;
      const FT beyond = CGAL::is_negative(foot) ? FT(-foot) : (std::max)(FT(foot - size), FT(0));
      const FT height = dot(n, v), distance = square_root<FT>(height * height + beyond * beyond);
      const Point back = CGAL::is_negative(height) ? n : FT(-1) * n;
      m_out.seed_corner(s.face, frame, k, distance, back, CGAL::is_negative(height) ? right : left);
    }
  }

  // Position of p along h; exactly 0 or the length at a vertex.
  FT position_on_edge(const Surface_point_& p, Index h) const
  {
    if (p.kind == Surface_point_::VERTEX) return p.element == m_mesh.source(h) ? FT(0) : m_mesh[h].length;
    return p.element == h ? p.x : FT(m_mesh[h].length - p.x);
  }

  // Direction of the segment from one of its ends, a mesh vertex, towards the other end.
  Ray ray_of(const Segment& s, bool at_second) const
  {
    const Index v = (at_second ? s.second : s.first).element;
    const Face_frame<FT> frame(m_mesh, s.face);
    int k = 0;
    while (m_mesh.source(3 * s.face + Index(k)) != v) ++k;
    const Index h = 3 * s.face + Index(k), before = m_mesh.previous(h);
    if (s.edge == 1u << k) return {h, FT(1), FT(0)};
    if (s.edge == 1u << (before % 3))
    {
      if (m_mesh.twin(before) != no_index) return {m_mesh.twin(before), FT(1), FT(0)};
      return {h, m_mesh[h].apex_x, m_mesh[h].apex_y};
    }
    const Point u = frame.vector_to_halfedge(k, at_second ? FT(-1) * s.direction : s.direction);
    return {h, u.x, u.y};
  }

  // Variant of ray_of() for an end p inside an edge or a face: a vector in the frame of the halfedge or face of p. The segment
  // may give the same point by the opposite halfedge.
  Point vector_of(const Segment& s, bool at_second, const Surface_point_& p) const
  {
    return vector_at_point(m_mesh, p, s.face, at_second ? FT(-1) * s.direction : s.direction);
  }

  // Adds the rays from the end of a segment, where another one may start. On a barrier, each side has its own.
  // start: start value of points behind the last segment that are one with its end.
  void add_corner(Index source, const Surface_point_& point, const Segment* in, const Segment* out, Index part,
                  std::optional<FT> start = std::nullopt)
  {
    if (in && in->starts) take_least(start, in->starts->second);
    if (out && out->starts) take_least(start, out->starts->first);
    if (out && out->start_before) take_least(start, *out->start_before);
    if (start) m_out.set_start_value(*start);
    if (in && in->is_silent) in = nullptr;
    if (out && out->is_silent) out = nullptr;
    for_each_side(m_mesh, point, [&](const Surface_point_& p) {
      const std::optional<Segment> arriving = on_side(in, p), leaving = on_side(out, p);
      if (arriving && leaving) add_joint(source, p, *arriving, *leaving);
      else if (arriving) add_end(source, p, *arriving, true, part);
      else if (leaving) add_end(source, p, *leaving, false, part);
      else m_out.add_all_directions({source, part, false}, p, Source_side::CAP);
    });
  }

  // The segment, or that on the other side of its barrier, if it is in a face of the side of p.
  std::optional<Segment> on_side(const Segment* s, const Surface_point_& p) const
  {
    if (!s) return std::nullopt;
    const auto is_beside = [&](const Segment& t) {
      if (p.kind == Surface_point_::VERTEX)
        return m_mesh.source(3 * t.face) == p.element || m_mesh.source(3 * t.face + 1) == p.element ||
               m_mesh.source(3 * t.face + 2) == p.element;
      return m_mesh.across_barrier(p.element) == no_index || m_mesh.face(p.element) == t.face;
    };
    if (p.kind == Surface_point_::FACE || is_beside(*s)) return *s;
    const auto other = across_barrier(*s);
    return other && is_beside(*other) ? other : std::nullopt;
  }

  void add_end(Index source, const Surface_point_& p, const Segment& s, bool at_second, Index part)
  {
    const Source_ref source_ref(m_out.add_primitive({source, part, false, s.is_short}, {p, p}), Source_side::CAP);
    if (p.kind == Surface_point_::VERTEX)
    {
      const Ray r = ray_of(s, at_second);
      m_out.add_seed_at_source(p.element, source_ref);
      add_sector_between(p.element, r, r, source_ref, uncertainty_at_vertex(s));
      add_other_fans(p.element, r.corner, no_index, source_ref);
      return;
    }
    const Point u = vector_of(s, at_second, p);
    const Point back = FT(-1) * u, from = quarter_turn(u), to = FT(-1) * from;
    m_out.add_seeds_of_point(p, [source_ref](const Point&) { return source_ref; });
    if (!s.varies) return m_out.add_flat_sector(p, &from, &to, source_ref);
    m_out.add_flat_sector(p, &u, &back, source_ref);
    m_out.add_flat_sector(p, &back, &u, source_ref);
  }

  // Of the direction of a segment at a vertex. Where start values vary, rays from the vertex start in all directions beside the
  // segment: those between the segment and its own rays are nowhere shortest.
  FT uncertainty_at_vertex(const Segment& s) const
  {
    return s.varies ? FT(1) : m_out.direction_uncertainty(s.face, length(s.b - s.a));
  }

  void add_joint(Index source, const Surface_point_& p, const Segment& in, const Segment& out)
  {
    const Index primitive = m_out.add_primitive({source, out.part, false, in.is_short || out.is_short}, {p, p});
    const Source_ref left(primitive, Source_side::LEFT), right(primitive, Source_side::RIGHT);
    if (p.kind == Surface_point_::VERTEX)
    {
      const FT uncertainty = (std::max)(uncertainty_at_vertex(in), uncertainty_at_vertex(out));
      const Ray r_in = ray_of(in, true), r_out = ray_of(out, false);
      m_out.add_seed_at_source(p.element, left);
      if (same_fan(r_in.corner, r_out.corner))
      {
        add_sector_between(p.element, r_out, r_in, left, uncertainty);
        add_sector_between(p.element, r_in, r_out, right, uncertainty);
      }
      else
      {
        add_sector_between(p.element, r_out, r_out, left, uncertainty);
        add_sector_between(p.element, r_in, r_in, left, uncertainty);
      }
      add_other_fans(p.element, r_in.corner, r_out.corner, left);
      return;
    }
    const Point u_in = vector_of(in, true, p), u_out = vector_of(out, false, p);
    const FT turn = cross(u_in, u_out);
    // The left side is the sector counterclockwise from u_out to u_in. It is reflex if u_in is to the right of u_out.
    const bool reflex_left = !CGAL::is_negative(turn);
    m_out.add_seeds_of_point(p, [&](const Point& v) {
      const Point &first = reflex_left ? u_in : u_out, &last = reflex_left ? u_out : u_in; // of the side that is not reflex
      const bool is_between = CGAL::is_positive(cross(first, v)) && CGAL::is_positive(cross(v, last));
      return is_between == reflex_left ? right : left;
    });
    if (in.varies || out.varies)
    { // in all directions, as at a vertex
      const bool folds_back = CGAL::is_positive(dot(u_in, u_out));
      const Point ahead = folds_back ? FT(-1) * u_out : u_in;
      m_out.add_flat_sector(p, &u_out, &ahead, left);
      m_out.add_flat_sector(p, &ahead, &u_out, folds_back ? left : right);
      return;
    }
    // u_in points backward along the incoming segment; on a straight polyline u_in and u_out are opposite.
    const FT straight = -dot(u_in, u_out), uncertainty = (std::max)(in.uncertainty, out.uncertainty);
    const auto add_side = [&](bool is_left) {
      const Point from = quarter_turn(is_left ? u_out : u_in), to = FT(-1) * quarter_turn(is_left ? u_in : u_out);
      m_out.add_flat_sector(p, &from, &to, is_left ? left : right);
    };
    if (!CGAL::is_zero(turn) || !CGAL::is_positive(straight)) add_side(reflex_left);
    // On an almost straight polyline, rounding decides which side is reflex; then rays start on both sides.
    if (CGAL::is_positive(uncertainty) && CGAL::abs(turn) <= FT(2) * uncertainty * straight) add_side(!reflex_left);
  }

  bool same_fan(Index c, Index d) const
  {
    if (c == d) return true;
    for (Index e = m_mesh.corner_ccw(c); e != no_index && e != c; e = m_mesh.corner_ccw(e))
      if (e == d) return true;
    for (Index e = m_mesh.corner_cw(c); e != no_index && e != c; e = m_mesh.corner_cw(e))
      if (e == d) return true;
    return false;
  }

  // Adds all directions of the fans of a pinched vertex that the polyline does not enter.
  void add_other_fans(Index v, Index c, Index d, Source_ref source_ref)
  {
    if (!m_mesh.has_several_fans(v)) return;
    m_mesh.for_each_fan(v, [&](Index first) {
      if (!same_fan(first, c) && (d == no_index || !same_fan(first, d)))
        m_out.fans.push_back({v, Ray(), Ray(), first, source_ref});
    });
  }

  // Uncertainty of the direction of a segment with the length of 2^-28 edges. On the edges at its vertex, rounding then turns
  // the rays from its other end by 2^-25. A path that bends by this angle is longer by 2^-53 of its length.
  static FT largest_uncertainty() { return FT(1. / (1 << 18)); }

  // Adds the rays from a vertex in the sector between two consecutive source segments, with directions a and b,
  // counterclockwise. Rays can be shortest if their angle to each segment is at least a right angle, minus the uncertainty of
  // the directions. If the uncertainty exceeds largest_uncertainty(), the segment is so short that rounding loses the rays from
  // its other end on the edges at v. Then rays start from v in all directions of the sector.
  void add_sector_between(Index v, const Ray& a, const Ray& b, Source_ref source_ref, const FT& uncertainty)
  {
    if (uncertainty > largest_uncertainty())
    {
      const Index first = m_mesh.first_on_border(a.corner);
      if (a.corner == b.corner)
      { // all directions except a wedge in one corner; nothing if the sector is this wedge
        if (!CGAL::is_positive(cross(a.x, a.y, b.x, b.y)))
          m_out.fans.push_back({v, Ray(), Ray(), first != no_index ? first : a.corner, source_ref});
      }
      else if (!m_sector.passes_border(a, b)) m_out.fans.push_back({v, a, b, a.corner, source_ref});
      else
      {
        m_out.fans.push_back({v, a, Ray(), first, source_ref});
        m_out.fans.push_back({v, Ray(), b, first, source_ref});
      }
      return;
    }
    const Ray from = m_sector.turn_ccw(a, 1, uncertainty), to = m_sector.turn_cw(b, 1, uncertainty);
    if (m_sector.passes_border(a, b))
    {
      const Index first = m_mesh.first_on_border(a.corner);
      if (from.corner != no_index) m_out.fans.push_back({v, from, Ray(), first, source_ref});
      if (to.corner != no_index) m_out.fans.push_back({v, Ray(), to, first, source_ref});
    }
    else if (from.corner != no_index && to.corner != no_index && m_sector.is_reflex(a, b, uncertainty) &&
             m_sector.come_in_order(a, from, to))
      m_out.fans.push_back({v, from, to, from.corner, source_ref});
  }

  void add_fan_between_edges(Index v, Index first, const std::vector<char>& is_source, Source_ref source_ref)
  {
    std::vector<Ray> rays;
    Index c = first;
    do {
      if (is_source[c]) rays.push_back({c, FT(1), FT(0)});
      const Index n = m_mesh.corner_ccw(c);
      if (n == no_index && is_source[m_mesh.previous(c)]) rays.push_back({c, m_mesh[c].apex_x, m_mesh[c].apex_y});
      c = n;
    } while (c != no_index && c != first);
    if (rays.empty()) m_out.fans.push_back({v, Ray(), Ray(), first, source_ref});
    for (std::size_t i = 0; i < rays.size(); ++i)
      add_sector_between(v, rays[i], rays[(i + 1) % rays.size()], source_ref, FT(0));
  }

  const Unfolded_mesh<FT>& m_mesh;
  Vertex_sector<FT> m_sector;
  Initial_windows<FT>& m_out;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
