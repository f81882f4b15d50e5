// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest tolerance eps for which curves are proven to be an offset: they bound a region R with {D < d - eps} inside R, and R
// inside {D <= d + eps}.
//
// Let C be the union of the curves and of the pinched vertices at the level, where several fans meet. Let R be C together with all
// points that an even number of curves separates from the sources. A component that is connected to the sources only through
// pinched vertices may count as inside or as outside: both choices satisfy the proof.
//
// {D < d - eps} is inside R: a shortest path to a point p outside of R starts at a source, in R, so it meets C. D grows along
// the path, so D(p) is at least the minimum of D on C. Thus it is enough that D >= d - eps on C, and that all sources are in R.
// A source with the start value s outside of R needs eps >= d - s, as D is at least s on all paths from it.
//
// R is inside {D <= d + eps}: D has a largest value on R, which is compact. The point where it is taken is on C, or on a part of
// an edge in R, or it is in the interior of a face and of R, and so a local maximum of D. It is enough to bound D on C, on these
// parts of edges, and at local maxima. The last part of each shortest path to a point p inside a face is straight. If a direction
// u has a positive scalar product with the last parts of all shortest paths to p, then p is no local maximum: otherwise, for p_i
// = p + t_i u with t_i > 0 converging to 0, the last parts of shortest paths to p_i converge to one to p. Let x_i be the points
// where these parts start. Then D(p_i) - D(p) >= |p_i - x_i| - |p - x_i|, which is positive for small t_i. (x_i stays away from
// p, as p is inside the face and, as u exists, not a source.) So a triangle in a face can be left out if all rays that may be
// shortest in it are within less than half a turn. All other triangles are bisected until their upper bound is at most d + eps. A
// triangle whose lower bound exceeds d + eps meets no curve, so it lies on one side, that of any of its points; outside of R it is
// left out.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_OFFSET_CERTIFICATION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_OFFSET_CERTIFICATION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_certificate.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Curve_region.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Face_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Piece_bounds.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Lengths are in units of the certified mesh.
struct Offset_certification_result
{
  bool bounds_region = false;
  double excess = 0;
  Offset_certificate_limit limit = Offset_certificate_limit::NONE;
  Index face = no_index;
  Point_in_face<double> place{0, 0};
  Bounds bounds{0, 0};
  std::size_t curve = no_curve;
  std::vector<std::size_t> reversed; // curves, increasing
};

class Offset_certification
{
public:
  typedef Surface_point<double> Place;
  typedef Offset_certificate_limit Limit;
  typedef Offset_certification_result Result;

  Offset_certification(const Certified_mesh& mesh, const Certified_sources& sources, const Certified_field& field,
                       double distance)
    : m_mesh(mesh), m_sources(sources), m_field(field), m_distance(distance), m_bounds(mesh, sources, field),
      m_region(mesh.unfolded()), m_side(mesh, sources, m_region, m_pieces)
  {
  }

  // Adds a polyline on the surface. Returns false if two consecutive points have no common face; then the result has the point.
  bool add_polyline(const std::vector<Place>& points, bool is_closed)
  {
    const std::size_t curve = m_curves++, n = points.size();
    if (n == 1) add_segment(points[0], points[0], curve);
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < n; ++i)
      if (!add_segment(points[i], points[(i + 1) % n], curve)) return fail(Limit::NOT_JOINED, points[i], curve);
    if (!is_closed && n > 0) add_ends(points.front(), points.back(), curve);
    return true;
  }

  // A piece of an offset curve. `from`, `to`: its ends on the surface. Consecutive pieces must meet within `joint_tolerance`.
  // The end of the earlier piece becomes the joint, and the gap between both counts as uncertainty of the points of the later
  // piece.
  struct Arc
  {
    Index face;
    Place from, to;
    Point_in_face<double> start, end, center; // in units of the mesh
    double radius;                            // 0: a segment
  };
  bool add_arcs(const std::vector<Arc>& arcs, bool is_closed)
  {
    const std::size_t curve = m_curves++, n = arcs.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const Place& from = i > 0 ? arcs[i - 1].to : is_closed ? arcs[n - 1].to : arcs[0].from;
      if (!add_arc(arcs[i], from, curve)) return fail(Limit::NOT_JOINED, arcs[i].from, curve);
    }
    if (!is_closed && n > 0) add_ends(arcs.front().from, arcs.back().to, curve);
    return true;
  }

  // To be called once, after all curves were added.
  const Result& operator()()
  {
    if (m_result.limit != Limit::NONE || !check_ends()) return m_result;
    std::vector<Index> pinches = pinches_at_level();
    if (!m_region.set_pieces(m_pieces, pinches) && !add_pinches(pinches))
    {
      set_limit(Limit::NO_REGION, m_region.conflict_face(), m_sources.corner(m_region.conflict_face(), 0), {0., 0.}, no_curve);
      m_result.excess = Number_policy<double>::infinity();
      return m_result;
    }
    m_result.bounds_region = true;
    find_sides(pinches);
    find_reversed();
    // points first: they raise the tolerance early, so that fewer pieces are bisected
    for (const Curve_piece& p : m_pieces) bound_point({p.face, p.geometry.hull[0], p.curve}, p.moved);
    for (const Curve_point& p : m_points) bound_point(p, 0);
    for (const Index v : pinches) bound_pinch(v);
    for (const Curve_piece& p : m_pieces)
    {
      m_bounds.set_face(p.face);
      bound_curve(p.geometry, p, 0, m_bounds.end_of_candidates(), 0);
    }
    bound_edges();
    bound_faces();
    return m_result;
  }

  // The longest edge is between 1 and 2. Coordinates of joints in their faces have errors of some 2^-50 of the size of the face
  // and of the distance; pieces that are farther apart were not joined.
  static constexpr double joint_tolerance = 0x1p-30;

private:
  // A point of a curve that belongs to no piece: a polyline of one point, or a repeated point.
  struct Curve_point
  {
    Index face;
    Double_double_2 place;
    std::size_t curve;
  };

  // Resolution of the tolerance, as a fraction of the distance plus the size of a face: the tolerance exceeds the smallest one that
  // the bounds of points prove by at most this. It is twice the error of the bounds of a point.
  static constexpr double resolution = 0x1p-45;
  // Relative uncertainty of the level d: the package cuts the offset at d (1 - 2^-42). Binding tests: test_certified_offsets,
  // rounding of levels, pinched vertices.
  static constexpr double level_rounding = 0x1p-41;
  // Limits of the halvings of a piece, and of the number of triangles of a face.
  static constexpr int most_halvings = 60;
  static constexpr std::size_t most_triangles = 1u << 16;

  double smallest_step(Index face) const
  {
    return resolution * (m_distance + m_mesh.length(3 * face) + m_mesh.length(3 * face + 1));
  }

  bool place_in(Index face, const Place& p, Double_double_2& place, unsigned& edges) const
  {
    return m_sources.place_in_face(p, face, place, edges);
  }

  bool add_segment(const Place& from, const Place& to, std::size_t curve)
  {
    for (Index face : faces_of(m_mesh.unfolded(), from))
    {
      Double_double_2 p, q;
      unsigned p_edges, q_edges;
      if (!place_in(face, from, p, p_edges) || !place_in(face, to, q, q_edges)) continue;
      if (m_region.key(from) == m_region.key(to))
      {
        m_points.push_back({face, p, curve});
        return true;
      }
      const int edge = (p_edges & q_edges) ? edge_of_bit(p_edges & q_edges) : -1;
      m_pieces.push_back({face, from, to, Face_piece::segment(p, q), p, q, 0., curve, edge});
      return true;
    }
    return false;
  }

  bool add_arc(const Arc& arc, const Place& from, std::size_t curve)
  {
    Double_double_2 p, q;
    unsigned p_edges, q_edges;
    if (!place_in(arc.face, from, p, p_edges) || !place_in(arc.face, arc.to, q, q_edges)) return false;
    // not along an edge: a straight piece of the size of rounding from a vertex to itself
    const bool is_along_edge = !(arc.radius > 0) && (p_edges & q_edges) && m_region.key(from) != m_region.key(arc.to);
    const auto point = [](const Point_in_face<double>& x) { return Double_double_2{Double_double(x.x), Double_double(x.y)}; };
    const Double_double_2 start = point(arc.start), end = point(arc.end);
    const Face_piece piece =
      arc.radius > 0 ? Face_piece::arc(start, end, point(arc.center), arc.radius) : Face_piece::segment(start, end);
    double moved = (std::max)(length(difference(p, start)), length(difference(q, end)));
    moved = (std::max)({moved, piece.off_circle(), outside(piece, arc.face)});
    if (!(moved <= joint_tolerance)) return false;
    m_pieces.push_back({arc.face, from, arc.to, piece, p, q, moved, curve,
                        is_along_edge ? edge_of_bit(p_edges & q_edges) : -1});
    return true;
  }

  // How far a piece is outside of its face.
  double outside(const Face_piece& piece, Index face) const
  {
    double result = 0;
    Face_piece f = piece;
    for (Index k = 0; k < 3; ++k)
    {
      result = (std::max)(result, -f.products_with({0., 1.}).first);
      f = f.in_next_frame(m_mesh, 3 * face + k);
    }
    return result;
  }

  void add_ends(const Place& first, const Place& last, std::size_t curve)
  {
    m_ends.push_back({first, curve});
    m_ends.push_back({last, curve});
  }

  void bound_point(const Curve_point& p, double moved)
  {
    m_bounds.set_face(p.face);
    const std::size_t end = m_bounds.end_of_candidates();
    allow_for(m_bounds(Face_piece::point(p.place), moved, 0, end, false).at_inner_point, p.place, p.face, p.curve);
    m_bounds.drop_candidates(end);
  }

  // How far the distance of a vertex may be from the level.
  double excess(Index v) const { return (std::max)(m_distance - m_field.bounds.lower(v), upper(v) - m_distance); }

  void sort_pinches(std::vector<Index>& pinches) const
  {
    std::stable_sort(pinches.begin(), pinches.end(), [&](Index v, Index w) { return upper(v) < upper(w); });
  }

  // The vertices with several fans for which is_wanted(vertex).
  template <class Predicate>
  std::vector<Index> pinched_vertices(const Predicate& is_wanted) const
  {
    std::vector<Index> result;
    const Unfolded_mesh<double>& unfolded = m_mesh.unfolded();
    for (Index v = 0; v < unfolded.number_of_vertices(); ++v)
      if (unfolded.corner(v) != no_index && unfolded.has_several_fans(v) && is_wanted(v)) result.push_back(v);
    return result;
  }

  // Pinched vertices whose bounds contain the level, ordered by their upper bounds. Where an offset touches such a vertex, it is a
  // single point, and no curve need pass it. The vertex is added to C, as it may separate the fans.
  std::vector<Index> pinches_at_level() const
  {
    const double rounding = level_rounding * (m_distance + m_mesh.to_unit(m_mesh.unfolded().longest_edge()));
    std::vector<Index> result = pinched_vertices([&](Index v) {
      return m_field.bounds.lower(v) - m_distance <= rounding && m_distance - upper(v) <= rounding;
    });
    sort_pinches(result);
    return result;
  }

  // Curves within a tolerance may touch a pinched vertex whose distance is within that tolerance of the level. Adds to the
  // pinches at the level those nearest to it, as few as needed for the curves to bound a region. Returns false if they do not
  // with all of them.
  bool add_pinches(std::vector<Index>& pinches)
  {
    std::vector<Index> others =
      pinched_vertices([&](Index v) { return !m_region.is_on_curve(v) && Number_policy<double>::is_finite(excess(v)); });
    std::stable_sort(others.begin(), others.end(), [&](Index v, Index w) { return excess(v) < excess(w); });
    const auto bounds_with = [&](std::size_t number) {
      std::vector<Index> all = pinches;
      all.insert(all.end(), others.begin(), others.begin() + std::ptrdiff_t(number));
      return m_region.set_pieces(m_pieces, all);
    };
    if (others.empty() || !bounds_with(others.size())) return false;
    std::size_t least = 0, enough = others.size(); // not enough; enough
    while (enough - least > 1)
    {
      const std::size_t middle = least + (enough - least) / 2;
      (bounds_with(middle) ? enough : least) = middle;
    }
    bounds_with(enough);
    pinches.insert(pinches.end(), others.begin(), others.begin() + std::ptrdiff_t(enough));
    sort_pinches(pinches);
    return true;
  }

  void bound_pinch(Index v)
  {
    const Bounds bounds{m_field.bounds.lower(v), upper(v)};
    const Index corner = m_mesh.unfolded().corner(v);
    const Double_double_2 place = m_sources.corner(corner / 3, int(corner % 3));
    raise(m_distance - bounds.first, Limit::CURVE_TOO_NEAR, corner / 3, place, bounds, no_curve);
    raise(bounds.second - m_distance, Limit::CURVE_TOO_FAR, corner / 3, place, bounds, no_curve);
  }

  // Open curves go on as others, or end at the border.
  bool check_ends()
  {
    const auto less = [&](const auto& a, const auto& b) { return m_region.key(a.first) < m_region.key(b.first); };
    std::stable_sort(m_ends.begin(), m_ends.end(), less);
    for (std::size_t i = 0, next; i < m_ends.size(); i = next)
    {
      for (next = i + 1; next < m_ends.size() && !less(m_ends[i], m_ends[next]); ++next) {}
      if ((next - i) % 2 == 1 && !m_region.is_on_border(m_ends[i].first))
        return fail(Limit::OPEN_END, m_ends[i].first, m_ends[i].second);
    }
    return true;
  }

  bool fail(Limit limit, const Place& p, std::size_t curve)
  {
    if (m_result.limit != Limit::NONE) return false;
    const std::vector<Index> faces = faces_of(m_mesh.unfolded(), p);
    Double_double_2 place{};
    unsigned edges;
    if (!faces.empty()) place_in(faces.front(), p, place, edges);
    set_limit(limit, faces.empty() ? no_index : faces.front(), place, {0., 0.}, curve);
    m_result.excess = Number_policy<double>::infinity();
    return false;
  }

  void set_limit(Limit limit, Index face, const Double_double_2& place, const Bounds& bounds, std::size_t curve)
  {
    m_result.limit = limit;
    m_result.face = face;
    m_result.place = {place.x.high, place.y.high};
    m_result.bounds = bounds;
    m_result.curve = curve;
  }

  void raise(double excess, Limit limit, Index face, const Double_double_2& place, const Bounds& bounds, std::size_t curve)
  {
    if (!(excess > m_result.excess)) return;
    m_result.excess = excess;
    set_limit(limit, face, place, bounds, curve);
  }

  // Decides which side of each component is inside. The first source of a component is inside; if another one is outside, the
  // tolerance is at least d - s, with the start value s of that source. Sources with start values near the level, up to its
  // rounding, come last and decide no side. A component without sources is outside; if it has curves, its part at a pinched
  // vertex is inside.
  void find_sides(const std::vector<Index>& pinches)
  {
    const double level = (1 - level_rounding) * m_distance;
    put_sources(0, level);
    for (const Index v : pinches)
      m_mesh.unfolded().for_each_fan(v, [&](Index corner) {
        const std::size_t part = m_region.part(corner, 0);
        if (!m_region.has_side(part) && m_region.has_curve(part)) m_region.set_side(part, true);
      });
    for (std::size_t i = 0; i < m_region.number_of_parts(); ++i)
      if (!m_region.has_side(i)) m_region.set_side(i, false);
    put_sources(level, m_distance);
  }

  // Places the sources with start values in [least, most).
  void put_sources(double least, double most)
  {
    const auto is_put = [=](double start_value) { return start_value >= least && start_value < most; };
    for (const Certified_source_vertex& s : m_sources.vertices)
      if (const Index corner = m_mesh.unfolded().corner(s.vertex);
          is_put(s.start_value) && !m_region.is_on_curve(s.vertex) && corner != no_index)
        put_source({m_region.part(corner, 0), false, true}, s.start_value, corner / 3,
                   m_sources.corner(corner / 3, int(corner % 3)));
    for (const Certified_source& s : m_sources.in_faces)
      if (is_put(s.start_value)) put_source(m_side(s.face, s.first), s.start_value, s.face, s.first);
  }

  void put_source(const Face_side::Side& side, double start_value, Index face, const Double_double_2& place)
  {
    if (side.is_known && !m_region.has_side(side.part)) m_region.set_side(side.part, !side.differs);
    if (!side.is_known || m_region.is_inside(side.part) == side.differs)
      raise(m_distance - start_value, Limit::SOURCE_OUTSIDE, face, place, {0., start_value}, no_curve);
  }

  // Finds the curves that do not have the region on their left.
  void find_reversed()
  {
    std::vector<char> has_ends(m_curves, 0);
    std::vector<const Curve_piece*> longest(m_curves, nullptr);
    for (const Curve_piece& p : m_pieces)
    {
      std::size_t before, behind;
      bool is_right = true;
      if (p.edge >= 0)
      {
        bool is_forward;
        if (!m_region.part_along(p, before, is_forward)) continue;
        is_right = m_region.is_inside(before) == is_forward;
        has_ends[p.curve] = 1;
      }
      else
        for (const bool at_start : {true, false})
          if (m_region.parts_at_end(p, at_start, before, behind))
          {
            is_right = is_right && m_region.is_inside(at_start ? before : behind);
            has_ends[p.curve] = 1;
          }
      if (!is_right) m_result.reversed.push_back(p.curve);
      const Curve_piece*& l = longest[p.curve];
      if (!l || chord(p) > chord(*l)) l = &p;
    }
    for (std::size_t i = 0; i < m_curves; ++i)
      if (!has_ends[i] && longest[i] && m_side.is_right_of(*longest[i])) m_result.reversed.push_back(i);
    std::sort(m_result.reversed.begin(), m_result.reversed.end());
    m_result.reversed.erase(std::unique(m_result.reversed.begin(), m_result.reversed.end()), m_result.reversed.end());
  }

  static double chord(const Curve_piece& p) { return length(difference(p.end, p.start)); }

  // Raises the tolerance such that it allows for a point of a curve; with no_curve, for a point of the region.
  void allow_for(const Bounds& bounds, const Double_double_2& place, Index face, std::size_t curve)
  {
    raise(bounds.second - m_distance, curve == no_curve ? Limit::REGION_TOO_FAR : Limit::CURVE_TOO_FAR, face, place, bounds,
          curve);
    if (curve != no_curve) raise(m_distance - bounds.first, Limit::CURVE_TOO_NEAR, face, place, bounds, curve);
  }

  // Bounds D on a part of a curve, in halves if the bounds are too far apart.
  void bound_curve(const Face_piece& part, const Curve_piece& p, std::size_t begin, std::size_t end, int depth)
  {
    if (part.is_short() || depth == most_halvings)
    {
      const Piece_range r = m_bounds(part, p.moved, begin, end, false);
      const std::size_t next = m_bounds.end_of_candidates();
      bool is_far = r.upper - m_distance > m_result.excess, is_near = m_distance - r.lower > m_result.excess;
      if (is_far || is_near)
      {
        const Double_double_2 place = part.inner_point();
        const Bounds& at = r.at_inner_point;
        allow_for(at, place, p.face, p.curve);
        const double step = depth == most_halvings ? Number_policy<double>::infinity() : smallest_step(p.face);
        if (is_far && r.upper - at.second <= step)
        {
          raise(r.upper - m_distance, Limit::CURVE_TOO_FAR, p.face, place, {r.lower, r.upper}, p.curve);
          is_far = false;
        }
        if (is_near && at.first - r.lower <= step)
        {
          raise(m_distance - r.lower, Limit::CURVE_TOO_NEAR, p.face, place, {r.lower, r.upper}, p.curve);
          is_near = false;
        }
        is_far = is_far && r.upper - m_distance > m_result.excess;
        is_near = is_near && m_distance - r.lower > m_result.excess;
      }
      if (is_far || is_near) bound_halves(part, p, end, next, depth);
      m_bounds.drop_candidates(end);
    }
    else bound_halves(part, p, begin, end, depth);
  }

  void bound_halves(const Face_piece& part, const Curve_piece& p, std::size_t begin, std::size_t end, int depth)
  {
    const auto halves = part.halves();
    bound_curve(halves.first, p, begin, end, depth + 1);
    bound_curve(halves.second, p, begin, end, depth + 1);
  }

  double upper(Index v) const { return m_field.bounds.upper(v); }

  void bound_edges()
  {
    const Unfolded_mesh<double>& unfolded = m_mesh.unfolded();
    for (Index h = 0; h < unfolded.number_of_halfedges(); ++h)
    {
      if (unfolded.source(h) == no_index || (unfolded.twin(h) != no_index && unfolded.twin(h) < h)) continue;
      const double a = upper(unfolded.source(h)), b = upper(unfolded.target(h)), size = m_mesh.length(h);
      // the largest value of the shorter path through one of both ends, with the rounding of the sum
      if (0.5 * (a + b + size) * (1 + 0x1p-50) - m_distance <= m_result.excess) continue;
      for (std::size_t i = 0; i < m_region.number_of_parts(h); ++i)
      {
        const std::size_t part = m_region.part(h, i);
        if (m_region.is_carried(part) || !m_region.is_inside(part)) continue;
        m_bounds.set_face(h / 3);
        bound_part(Face_piece::segment(m_side.begin_of_part(h, i), m_side.begin_of_part(h, i + 1)), h / 3, 0,
                   m_bounds.end_of_candidates(), 0);
      }
    }
  }

  // Bounds D on a part of an edge that is in the region.
  void bound_part(const Face_piece& part, Index face, std::size_t begin, std::size_t end, int depth)
  {
    const Piece_range r = m_bounds(part, 0., begin, end, false);
    const std::size_t next = m_bounds.end_of_candidates();
    if (r.upper - m_distance > m_result.excess)
    {
      const Double_double_2 place = part.inner_point();
      allow_for(r.at_inner_point, place, face, no_curve);
      if (depth == most_halvings || r.upper - r.at_inner_point.second <= smallest_step(face))
        raise(r.upper - m_distance, Limit::REGION_TOO_FAR, face, place, {r.lower, r.upper}, no_curve);
      else if (r.upper - m_distance > m_result.excess)
      {
        const auto halves = part.halves();
        bound_part(halves.first, face, end, next, depth + 1);
        bound_part(halves.second, face, end, next, depth + 1);
      }
    }
    m_bounds.drop_candidates(end);
  }

  void bound_faces()
  {
    const Unfolded_mesh<double>& unfolded = m_mesh.unfolded();
    for (Index f = 0; f < unfolded.number_of_faces(); ++f)
    {
      if (unfolded.source(3 * f) == no_index) continue;
      double bound = Number_policy<double>::infinity();
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        bound =
          (std::min)(bound, upper(unfolded.source(h)) + (std::max)(m_mesh.length(h), m_mesh.length(unfolded.previous(h))));
      if (bound * (1 + 0x1p-50) - m_distance <= m_result.excess) continue;
      const bool is_crossed = m_region.is_crossed(f);
      if (!is_crossed && !m_region.is_inside(m_region.part(3 * f, 0))) continue;
      bound_face(f, !is_crossed);
    }
  }

  // A triangle in a face; parts of it may be in the region.
  struct Triangle
  {
    Face_piece piece;
    Piece_range range;
    bool is_inside;

    bool operator<(const Triangle& o) const { return range.upper < o.range.upper; }
  };

  // The triangles with the largest bounds first, as they raise the tolerance most.
  void bound_face(Index face, bool is_inside)
  {
    m_bounds.set_face(face);
    m_queue.clear();
    m_triangles = 0;
    add_triangle(Face_piece::triangle(m_sources.corner(face, 0), m_sources.corner(face, 1), m_sources.corner(face, 2)), face,
                 is_inside);
    while (!m_queue.empty())
    {
      std::pop_heap(m_queue.begin(), m_queue.end());
      const Triangle t = m_queue.back();
      m_queue.pop_back();
      if (t.range.upper - m_distance <= m_result.excess) return;
      const auto halves = t.piece.halves();
      add_triangle(halves.first, face, t.is_inside);
      add_triangle(halves.second, face, t.is_inside);
    }
  }

  void add_triangle(const Face_piece& triangle, Index face, bool is_inside)
  {
    const std::size_t end = m_bounds.end_of_candidates();
    const Piece_range r = m_bounds(triangle, 0., 0, end, true);
    m_bounds.drop_candidates(end);
    if (r.upper - m_distance <= m_result.excess || r.has_no_maximum) return;
    const Double_double_2 place = triangle.inner_point();
    if (!is_inside && r.lower - m_distance > m_result.excess)
    { // no curve meets it
      const Face_side::Side side = m_side(face, place);
      is_inside = !side.is_known || m_region.is_inside(side.part) != side.differs;
      if (!is_inside) return;
    }
    if (is_inside) allow_for(r.at_inner_point, place, face, no_curve);
    // also if a curve may meet the triangle: d + eps is between its bounds then
    if (r.upper - r.at_inner_point.second <= smallest_step(face) || ++m_triangles > most_triangles)
      raise(r.upper - m_distance, Limit::REGION_TOO_FAR, face, place, {r.lower, r.upper}, no_curve);
    else if (r.upper - m_distance > m_result.excess)
    {
      m_queue.push_back({triangle, r, is_inside});
      std::push_heap(m_queue.begin(), m_queue.end());
    }
  }

  const Certified_mesh& m_mesh;
  const Certified_sources& m_sources;
  const Certified_field& m_field;
  const double m_distance;
  Piece_bounds m_bounds;
  std::vector<Curve_piece> m_pieces;
  std::vector<Curve_point> m_points;
  std::vector<std::pair<Place, std::size_t>> m_ends; // of open curves, with the curve
  std::size_t m_curves = 0, m_triangles = 0;
  std::vector<Triangle> m_queue; // a heap
  Curve_region m_region;
  Face_side m_side;
  Result m_result;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
