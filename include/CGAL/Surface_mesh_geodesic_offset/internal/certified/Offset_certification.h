// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tolerance eps for which curves are proven to be an offset: they bound a region R with {D < d - eps} inside R, and R inside
// {D <= d + eps}. The proof is in the manual: doc/Surface_mesh_geodesic_offset/certified_bounds.txt, "Certified Offsets".
//
// C is the union of the curves and of some pinched vertices, where several fans meet: those at the level, and, if the curves
// bound no region without them, the pinched vertices with distances nearest to it. R is C together with all points of even
// parity: in each component of the surface without the pinched vertices of C, paths from the first source to the point cross
// the curves an even number of times. Other sources may be outside. A component without sources may be on either side.
//
// {D < d - eps} is inside R if D >= d - eps on C, and if eps >= d - s for each source outside of R, with the start value s.
//
// R is inside {D <= d + eps} if D <= d + eps on C, on the parts of edges in R, and at local maxima of D inside faces and R. If
// all rays that may be shortest in a triangle in a face are within less than half a turn, it contains no local maximum. All
// other triangles are bisected until their upper bound is at most d + eps, or, if bisection gains no more or reaches its limit,
// eps is raised to this bound. A triangle whose lower bound exceeds d + eps meets no curve, so it lies on one side, that of any
// of its points; outside of R it is left out. If no source reaches a point of R, eps is infinite.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_OFFSET_CERTIFICATION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_OFFSET_CERTIFICATION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_certificate.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Curve_region.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Face_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Given_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Piece_bounds.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Precondition: the field has its windows, and the rounding mode is to nearest. The arguments of the constructor must outlive
// the object. `distance`: d, not negative, in units of the certified mesh, as are all lengths here.
class Offset_certification
{
public:
  typedef Offset_certificate_limit Limit;
  typedef Offset_certification_result Result;

  Offset_certification(const Certified_mesh& mesh, const Certified_sources& sources, const Certified_field& field,
                       double distance)
    : m_mesh(mesh), m_sources(sources), m_field(field), m_distance(distance), m_bounds(mesh, sources, field, distance),
      m_region(mesh.unfolded()), m_curves(mesh, sources, m_region), m_side(mesh, sources, m_region, m_curves.pieces)
  {
  }

  Given_curves& curves() { return m_curves; }

  // To be called once, after all curves were added, or one was refused: the result has the reason then.
  const Result& operator()()
  {
    const double infinite = Number_policy<double>::infinity();
    const Given_curves::Refusal& r = m_curves.refusal;
    if (!m_curves.check_ends()) return raise(infinite, r.limit, r.face, r.place, {0., 0.}, r.curve);
    std::vector<Index> pinches = pinches_at_level();
    if (!m_region.set_pieces(m_curves.pieces, pinches) && !add_pinches(pinches))
      return raise(infinite, Limit::NO_REGION, m_region.conflict_face(), m_sources.corner(m_region.conflict_face(), 0),
                   {0., 0.}, no_curve);
    m_result.bounds_region = true;
    find_sides(pinches);
    find_reversed();
    // Points first: they raise the tolerance early, so that fewer pieces are bisected. Pieces come before faces: add_triangle()
    // needs D <= d + eps on all curves.
    for (const Curve_piece& p : m_curves.pieces) bound_point({p.face, p.geometry.hull[0], p.curve}, p.moved);
    for (const Given_curves::Single_point& p : m_curves.points) bound_point(p, 0);
    for (const Index v : pinches) bound_pinch(v);
    for (const Curve_piece& p : m_curves.pieces)
    {
      m_bounds.set_face(p.face);
      bound_curve(p.geometry, p, 0, m_bounds.end_of_candidates(), 0);
    }
    bound_edges();
    bound_faces();
    return m_result;
  }

private:
  // Bisection ends when the bounds of a part exceed those of its inner point by no more than this fraction of the distance plus
  // the size of a face, twice the error of the bounds of a point. Unless a limit below ends it before, the tolerance is larger
  // by at most this than the bounds of points prove.
  static constexpr double resolution = 0x1p-45;
  // Relative uncertainty of the level d: the package cuts the offset at d (1 - 2^-42). Binding tests: test_certified_offsets,
  // rounding of levels, pinched vertices.
  static constexpr double level_rounding = 0x1p-41;
  // Limits of the halvings of a piece and of the triangles of a face. Where one is reached, the tolerance is valid but larger.
  static constexpr int most_halvings = 60;
  static constexpr std::size_t most_triangles = 1u << 16;

  double smallest_step(Index face) const
  {
    return resolution * (m_distance + m_mesh.length(3 * face) + m_mesh.length(3 * face + 1));
  }

  void bound_point(const Given_curves::Single_point& p, double moved)
  {
    m_bounds.set_face(p.face);
    const std::size_t end = m_bounds.end_of_candidates();
    allow_for(m_bounds(Face_piece::point(p.place), moved, 0, end, false).at_inner_point, p.place, p.face, p.curve);
    m_bounds.drop_candidates(end);
  }

  // How far the distance of a vertex may be from the level.
  double deviation(Index v) const { return (std::max)(m_distance - m_field.bounds.lower(v), upper(v) - m_distance); }

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

  // Pinched vertices whose bounds contain the level, ordered by their upper bounds. Where an offset touches such a vertex, it
  // is a single point, and no curve need pass it. The vertex is added to C, as it may separate the fans.
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
  // pinches at the level those nearest to it, as few as needed for the curves to bound a region. More pinches only remove
  // conditions, so the number is found by bisection. Returns false if the curves bound no region even with all pinched
  // vertices.
  bool add_pinches(std::vector<Index>& pinches)
  {
    std::vector<Index> others =
      pinched_vertices([&](Index v) { return !m_region.is_on_curve(v) && Number_policy<double>::is_finite(deviation(v)); });
    std::stable_sort(others.begin(), others.end(), [&](Index v, Index w) { return deviation(v) < deviation(w); });
    const auto bounds_with = [&](std::size_t number) {
      std::vector<Index> all = pinches;
      all.insert(all.end(), others.begin(), others.begin() + std::ptrdiff_t(number));
      return m_region.set_pieces(m_curves.pieces, all);
    };
    if (others.empty() || !bounds_with(others.size())) return false;
    std::size_t too_few = 0, enough = others.size();
    while (enough - too_few > 1)
    {
      const std::size_t middle = too_few + (enough - too_few) / 2;
      (bounds_with(middle) ? enough : too_few) = middle;
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

  const Result& raise(double tolerance, Limit limit, Index face, const Double_double_2& place, const Bounds& bounds,
                      std::size_t curve)
  {
    if (!(tolerance > m_result.tolerance)) return m_result;
    m_result.tolerance = tolerance;
    m_result.limit = limit;
    m_result.face = face;
    m_result.place = {place.x.high, place.y.high};
    m_result.bounds = bounds;
    m_result.curve = curve;
    return m_result;
  }

  // Decides which side of each component is inside. The first source of a component is inside; if another one is outside, the
  // tolerance is at least d - s, with the start value s of that source. Sources with start values near the level, up to its
  // rounding, come last and decide no side. In a component whose side no source decides, the part at the first of `pinches` is
  // inside if the component has curves; otherwise one part is outside.
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

  // Places the sources with start values in [least, most). Both ends of a segment are elements of m_sources, too; where a
  // segment leaves the region between them, a curve has a distance of at most the start value.
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
    if (!side.is_known || m_region.is_inside(side.part) == side.differs) // an unknown side counts as outside
      raise(m_distance - start_value, Limit::SOURCE_OUTSIDE, face, place, {0., start_value}, no_curve);
  }

  // Finds the curves with a piece that does not have the region on its left. Pieces inside faces are tested at their ends on
  // edges, pieces along edges by a part there. A curve without such tests is tested by a point beside its longest piece.
  void find_reversed()
  {
    std::vector<char> is_tested(m_curves.size, 0);
    std::vector<const Curve_piece*> longest(m_curves.size, nullptr);
    for (const Curve_piece& p : m_curves.pieces)
    {
      std::size_t before, behind;
      bool has_region_on_left = true;
      if (p.edge >= 0)
      {
        bool is_left;
        if (!m_region.part_along(p, before, is_left)) continue;
        has_region_on_left = m_region.is_inside(before) == is_left;
        is_tested[p.curve] = 1;
      }
      else
        for (const bool at_start : {true, false})
          if (m_region.parts_at_end(p, at_start, before, behind))
          {
            has_region_on_left = has_region_on_left && m_region.is_inside(at_start ? before : behind);
            is_tested[p.curve] = 1;
          }
      if (!has_region_on_left) m_result.reversed.push_back(p.curve);
      const Curve_piece*& l = longest[p.curve];
      if (!l || chord(p) > chord(*l)) l = &p;
    }
    for (std::size_t i = 0; i < m_curves.size; ++i)
      if (!is_tested[i] && longest[i] && m_side.is_right_of(*longest[i])) m_result.reversed.push_back(i);
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

  // Bounds D on a portion of a curve, in halves if the bounds are too far apart. `begin`, `end`: the candidates of the
  // enclosing portion in m_bounds, which appends those of this portion behind them.
  void bound_curve(const Face_piece& portion, const Curve_piece& p, std::size_t begin, std::size_t end, int depth)
  {
    if (portion.is_short() || depth == most_halvings)
    {
      const Piece_range r = m_bounds(portion, p.moved, begin, end, false);
      const std::size_t next = m_bounds.end_of_candidates();
      bool is_far = r.upper - m_distance > m_result.tolerance, is_near = m_distance - r.lower > m_result.tolerance;
      if (is_far || is_near)
      {
        const Double_double_2 place = portion.inner_point();
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
        is_far = is_far && r.upper - m_distance > m_result.tolerance;
        is_near = is_near && m_distance - r.lower > m_result.tolerance;
      }
      if (is_far || is_near) bound_halves(portion, p, end, next, depth);
      m_bounds.drop_candidates(end);
    }
    else bound_halves(portion, p, begin, end, depth);
  }

  void bound_halves(const Face_piece& portion, const Curve_piece& p, std::size_t begin, std::size_t end, int depth)
  {
    const auto halves = portion.halves();
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
      if (0.5 * (a + b + size) * (1 + 0x1p-50) - m_distance <= m_result.tolerance) continue;
      for (std::size_t i = 0; i < m_region.number_of_parts(h); ++i)
      {
        const std::size_t part = m_region.part(h, i);
        if (m_region.is_carried(part) || !m_region.is_inside(part)) continue; // bounded by bound_curve(); outside
        m_bounds.set_face(h / 3);
        bound_edge_part(Face_piece::segment(m_side.begin_of_part(h, i), m_side.begin_of_part(h, i + 1)), h / 3, 0,
                        m_bounds.end_of_candidates(), 0);
      }
    }
  }

  // Bounds D on a portion of an edge that is in the region; `begin` and `end` as in bound_curve().
  void bound_edge_part(const Face_piece& portion, Index face, std::size_t begin, std::size_t end, int depth)
  {
    const Piece_range r = m_bounds(portion, 0., begin, end, false);
    const std::size_t next = m_bounds.end_of_candidates();
    if (r.upper - m_distance > m_result.tolerance)
    {
      const Double_double_2 place = portion.inner_point();
      allow_for(r.at_inner_point, place, face, no_curve);
      if (depth == most_halvings || r.upper - r.at_inner_point.second <= smallest_step(face))
        raise(r.upper - m_distance, Limit::REGION_TOO_FAR, face, place, {r.lower, r.upper}, no_curve);
      else if (r.upper - m_distance > m_result.tolerance)
      {
        const auto halves = portion.halves();
        bound_edge_part(halves.first, face, end, next, depth + 1);
        bound_edge_part(halves.second, face, end, next, depth + 1);
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
      if (bound * (1 + 0x1p-50) - m_distance <= m_result.tolerance) continue;
      const bool is_crossed = m_region.is_crossed(f);
      if (!is_crossed && !m_region.is_inside(m_region.part(3 * f, 0))) continue;
      bound_face(f, !is_crossed);
    }
  }

  // A triangle in a face. `is_known_inside`: false if a curve may meet it.
  struct Triangle
  {
    Face_piece piece;
    Piece_range range;
    bool is_known_inside;

    bool operator<(const Triangle& o) const { return range.upper < o.range.upper; }
  };

  // The triangles with the largest bounds first, as they raise the tolerance most.
  void bound_face(Index face, bool is_known_inside)
  {
    m_bounds.set_face(face);
    m_queue.clear();
    m_triangles = 0;
    add_triangle(Face_piece::triangle(m_sources.corner(face, 0), m_sources.corner(face, 1), m_sources.corner(face, 2)), face,
                 is_known_inside);
    while (!m_queue.empty())
    {
      std::pop_heap(m_queue.begin(), m_queue.end());
      const Triangle t = m_queue.back();
      m_queue.pop_back();
      if (t.range.upper - m_distance <= m_result.tolerance) return;
      const auto halves = t.piece.halves();
      add_triangle(halves.first, face, t.is_known_inside);
      add_triangle(halves.second, face, t.is_known_inside);
    }
  }

  void add_triangle(const Face_piece& triangle, Index face, bool is_known_inside)
  {
    const std::size_t end = m_bounds.end_of_candidates();
    const Piece_range r = m_bounds(triangle, 0., 0, end, true);
    m_bounds.drop_candidates(end);
    if (r.upper - m_distance <= m_result.tolerance || r.has_no_maximum) return;
    const Double_double_2 place = triangle.inner_point();
    if (!is_known_inside && r.lower - m_distance > m_result.tolerance)
    { // no curve meets it, so one side is that of all its points; an unknown side counts as inside
      const Face_side::Side side = m_side(face, place);
      is_known_inside = !side.is_known || m_region.is_inside(side.part) != side.differs;
      if (!is_known_inside) return;
    }
    if (is_known_inside) allow_for(r.at_inner_point, place, face, no_curve);
    // A triangle that a curve may meet counts, too: it may contain points of the region.
    if (r.upper - r.at_inner_point.second <= smallest_step(face) || ++m_triangles > most_triangles)
      raise(r.upper - m_distance, Limit::REGION_TOO_FAR, face, place, {r.lower, r.upper}, no_curve);
    else if (r.upper - m_distance > m_result.tolerance)
    {
      m_queue.push_back({triangle, r, is_known_inside});
      std::push_heap(m_queue.begin(), m_queue.end());
    }
  }

  const Certified_mesh& m_mesh;
  const Certified_sources& m_sources;
  const Certified_field& m_field;
  const double m_distance;
  Piece_bounds m_bounds;
  std::size_t m_triangles = 0;
  std::vector<Triangle> m_queue; // a heap
  Curve_region m_region;
  Given_curves m_curves;
  Face_side m_side;
  Result m_result;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
