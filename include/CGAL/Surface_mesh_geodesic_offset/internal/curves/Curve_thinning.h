// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Selection of points of an offset curve for a polyline within a tolerance.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_CURVE_THINNING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CURVES_CURVE_THINNING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Polyline_thinning.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/chord_tolerance.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// The point of a piece at the parameter part / parts. A point between two pieces belongs to the first of them, so it is the
// same point seen from both pieces.
struct Curve_point
{
  std::size_t piece, part, parts;

  template <class Curve>
  typename Curve::Face_location location(const Curve& curve) const
  {
    typedef typename Curve::FT FT;
    const std::size_t n = curve.number_of_pieces();
    // the first and last points of a closed curve must be in the same face
    if (part == parts) return curve.is_closed() && piece + 1 == n ? curve.piece(0).start() : curve.piece(piece).end();
    if (part == 0) return curve.piece(piece).start();
    return curve.piece(piece).location(FT(double(part)) / FT(double(parts)));
  }
};

// Selects points of a curve. Up to rounding, the Frechet distance between the curve and the polyline through these points
// is at most the tolerance. The polyline has no more points than that of `Geodesic_offset_curve::discretize()`, whose
// chords do not pass ends of pieces.
//
// The candidates form a polyline closer to the curve: ends of pieces, and points inside arcs. If the curve runs straight
// through several faces, only the ends of the straight part are candidates, so corners of a polygon are candidates and
// points beside them are not. Polyline_thinning then selects from the candidates.
template <class Curve>
class Curve_thinning
{
  typedef typename Curve::FT FT;
  typedef typename Curve::Piece Piece;

  // Height of an arc over the segments between candidates, relative to the tolerance. The remaining 15/16 of the tolerance
  // are for chords over several pieces, which are shorter by 1 - sqrt(15/16), 3 percent, than with the whole tolerance. A
  // smaller value needs more candidates: the longest chord of one arc spans sqrt(16) segments.
  static constexpr double arc_part = 1. / 16;
  // An arc with this many chords within the whole tolerance has no candidates but their ends: others could save fewer than
  // two of sixteen chords. So the number of candidates is at most that of the points of `discretize()` plus a constant per
  // piece.
  static constexpr std::size_t many_chords = 16;
  // Deviation of a straight part of the curve from its chord, relative to the tolerance: it displaces a right-angled corner
  // by at most sqrt(2) times this length.
  static constexpr double straight_part = 1. / 1024;

public:
  // \throws std::invalid_argument unless the tolerance is positive
  // \throws std::length_error if there are too many candidates
  Curve_thinning(const Curve& curve, const FT& tolerance) : m_curve(curve), m_tolerance(tolerance)
  {
    check_number_of_chords(curve, tolerance);
  }

  // Points of the whole curve. A closed curve without a chosen start may start at any end of a piece, and ends with its first point. is_kept(i):
  // whether the end of piece i must be selected.
  template <class Condition>
  std::vector<Curve_point> whole(const Condition& is_kept) const
  {
    if (m_curve.number_of_pieces() == 0) return std::vector<Curve_point>();
    const double tolerance = CGAL::to_double(m_tolerance);
    Candidates few = without_straight_parts(candidates(is_kept, 1));
    if (m_curve.is_closed() && !m_curve.has_chosen_start()) turn_to_corner(few);
    std::vector<Curve_point> result = selected(few, Polyline_thinning(few.vertices, tolerance)());
    if (!m_curve.is_closed() || result.size() >= 4) return result;
    // A closed curve within the tolerance of a point or segment remains a triangle. At least two of its pieces are not
    // points, and at least one of these is an arc, so three parts per arc give at least three segments.
    const Candidates all = candidates(is_kept, 3);
    return selected(all, Polyline_thinning(all.vertices, tolerance).triangle_at_least());
  }

private:
  struct Candidates
  {
    std::vector<Thinning_vertex> vertices;
    std::vector<Curve_point> points;
    std::vector<char> is_straight; // straight before and after the vertex: no corner

    void push(const Curve& curve, const Curve_point& p, double height)
    {
      const auto point = curve.point(p.location(curve));
      Thinning_vertex v;
      v.point = {CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())};
      v.height = height;
      vertices.push_back(v);
      points.push_back(p);
      is_straight.push_back(false);
    }

    void pop()
    {
      vertices.pop_back();
      points.pop_back();
      is_straight.pop_back();
    }

    void erase(std::size_t i)
    {
      vertices[i + 1].height = (std::max)(vertices[i].height, vertices[i + 1].height);
      vertices[i + 1].is_kept = vertices[i + 1].is_kept || vertices[i].is_kept;
      vertices.erase(vertices.begin() + std::ptrdiff_t(i));
      points.erase(points.begin() + std::ptrdiff_t(i));
      is_straight.erase(is_straight.begin() + std::ptrdiff_t(i));
    }
  };

  // least_parts: minimum number of parts per arc
  template <class Condition>
  Candidates candidates(const Condition& is_kept, std::size_t least_parts) const
  {
    const std::size_t n = m_curve.number_of_pieces();
    const double tolerance = CGAL::to_double(m_tolerance);
    Candidates c;
    c.push(m_curve, m_curve.is_closed() ? Curve_point{n - 1, 1, 1} : Curve_point{0, 0, 1}, 0);
    bool is_after_segment = false;
    for (std::size_t i = 0; i < n; ++i)
    {
      const Piece piece = m_curve.piece(i);
      std::size_t chords = piece.number_of_chords(m_tolerance), divisor = 1;
      double height = 0;
      if (piece.is_arc())
      {
        const double r = CGAL::to_double(piece.radius()), angle = CGAL::to_double(piece.angle());
        // see Geodesic_offset_piece::number_of_chords()
        const auto height_over = [&](std::size_t n_chords) {
          const double sine = std::sin(angle / (4 * double(n_chords)));
          return 2 * r * sine * sine;
        };
        height = height_over(chords);
        // The height of a part is approximately, and at least, the height of the chord divided by the square of the number
        // of parts. number_of_chords() has a minimum angle per chord, so the height may exceed a tolerance below rounding.
        if (chords < many_chords && height > arc_part * tolerance)
          divisor = std::size_t(std::ceil(std::sqrt((std::min)(height / tolerance, 1.) / arc_part) * (1 - 1e-12)));
        divisor = (std::max)(divisor, least_parts);
        height = height_over(chords * divisor);
      }
      const std::size_t parts = chords * divisor;
      c.vertices.back().free_steps = divisor;
      c.is_straight.back() = is_after_segment && piece.is_segment();
      for (std::size_t j = 1; j < parts; ++j)
      {
        c.push(m_curve, {i, j, parts}, height);
        c.vertices.back().free_steps = (std::min)(divisor, parts - j);
      }
      c.push(m_curve, {i, parts, parts}, height);
      c.vertices.back().is_kept = is_kept(i);
      // drop a piece that is a point, also an arc of which all parts round to one, but retain the first and last points of the
      // curve
      const auto before = c.vertices.rbegin() + 1;
      const bool is_point = std::all_of(before, before + std::ptrdiff_t(parts), [&](const Thinning_vertex& v) {
        return v.point == c.vertices.back().point;
      });
      for (std::size_t j = 1; is_point && j < parts; ++j) c.erase(c.points.size() - 2);
      const std::size_t size = c.points.size();
      if (!is_point) is_after_segment = piece.is_segment();
      else if (size > 2) c.erase(size - 2);
      else if (i + 1 < n) c.pop();
    }
    return c;
  }

  // Removes candidates inside straight parts, so that no points beside a corner are selected.
  Candidates without_straight_parts(const Candidates& all) const
  {
    const double tolerance = CGAL::to_double(m_tolerance) * straight_part;
    std::vector<Thinning_vertex> vertices = all.vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      vertices[i].is_kept = vertices[i].is_kept || !all.is_straight[i];
      vertices[i].free_steps = 1;
    }
    const std::vector<std::size_t> indices = Polyline_thinning(vertices, tolerance)();
    Candidates few;
    for (std::size_t k = 0; k < indices.size(); ++k)
    {
      const std::size_t i = indices[k];
      few.vertices.push_back(all.vertices[i]);
      few.points.push_back(all.points[i]);
      few.is_straight.push_back(all.is_straight[i]);
      if (k > 0 && indices[k - 1] + 1 < i) few.vertices.back().height = tolerance;
    }
    return few;
  }

  // Rotates a closed curve such that it starts at a kept end of a piece, otherwise at the sharpest corner: a polygon starts
  // at a corner, not inside a side.
  static void turn_to_corner(Candidates& c)
  {
    const std::size_t n = c.points.size() - 1; // the last point equals the first
    std::size_t corner = 0;
    double least_cosine = 2;
    for (std::size_t i = 0; i < n; ++i)
    {
      if (c.points[i].part != c.points[i].parts) continue;
      const double cosine = c.vertices[i].is_kept || (i == 0 && c.vertices[n].is_kept)
                            ? -2
                            : turn_cosine(c.vertices[i > 0 ? i - 1 : n - 1], c.vertices[i], c.vertices[i + 1]);
      if (cosine >= least_cosine) continue;
      least_cosine = cosine;
      corner = i;
    }
    c.vertices[0].height = c.vertices[n].height;
    c.vertices[0].is_kept = c.vertices[n].is_kept;
    const auto turn = [&](auto& v) {
      v.pop_back();
      std::rotate(v.begin(), v.begin() + std::ptrdiff_t(corner), v.end());
      v.push_back(v.front());
    };
    turn(c.vertices);
    turn(c.points);
    turn(c.is_straight);
  }

  static double turn_cosine(const Thinning_vertex& p, const Thinning_vertex& q, const Thinning_vertex& r)
  {
    double product = 0, first = 0, second = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double v = q.point[i] - p.point[i], w = r.point[i] - q.point[i];
      product += v * w;
      first += v * v;
      second += w * w;
    }
    return first > 0 && second > 0 ? product / std::sqrt(first * second) : 1;
  }

  static std::vector<Curve_point> selected(const Candidates& c, const std::vector<std::size_t>& indices)
  {
    std::vector<Curve_point> points;
    for (std::size_t i : indices) points.push_back(c.points[i]);
    return points;
  }

  const Curve& m_curve;
  FT m_tolerance;
};

// Points of a whole curve for a polyline within the tolerance.
template <class Curve>
std::vector<Curve_point> thinned_points(const Curve& curve, const typename Curve::FT& tolerance)
{
  return Curve_thinning<Curve>(curve, tolerance).whole([](std::size_t) { return false; });
}

} // namespace CGAL::Geodesic_offset::internal

#endif
