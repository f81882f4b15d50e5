// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divides the arcs in a face into chords within a tolerance, such that chords of different levels do not cross.
//
// The chord of an arc is nearer to the center than the arc. So it may cross an arc of a smaller level with the same center, if that
// level is nearer than the height of the chord. Both arcs are divided at common directions from the center then, as far as both
// reach: their chords are parallel.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_ARC_DIVISION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_ARC_DIVISION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/chord_tolerance.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Split_piece.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class Piece>
class Arc_division
{
public:
  typedef Split_piece<Piece> Piece_in_face;

  // `least_length`: of chords; centers of arcs that are nearer to each other are one.
  Arc_division(double chord_tolerance, double least_length) : m_tolerance(chord_tolerance), m_least_length(least_length) {}

  // The parameters of the ends of the chords of each arc of a face, from 0 to 1; none for straight pieces.
  std::vector<std::vector<double>> operator()(const std::vector<Piece_in_face>& pieces)
  {
    std::vector<std::vector<double>> result(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (pieces[i].arc) result[i] = uniform(*pieces[i].arc);
    if constexpr (are_circles)
    {
      m_arcs.clear();
      for (std::size_t i = 0; i < pieces.size(); ++i)
        if (pieces[i].arc) m_arcs.push_back(arc_of(pieces[i], i));
      std::sort(m_arcs.begin(), m_arcs.end(), [](const Arc& a, const Arc& b) { return a.radius < b.radius; });
      for (std::size_t i = 0; i < m_arcs.size(); ++i)
      {
        if (!has_concentric(i)) continue;
        divide(i);
        const Arc& a = m_arcs[i];
        std::vector<double>& t = result[a.index];
        t = {0};
        for (std::size_t j = 1; j + 1 < a.chord_ends.size(); ++j) t.push_back((a.chord_ends[j] - a.start) / a.turn);
        t.push_back(1);
      }
    }
    return result;
  }

private:
  template <class P, class = void>
  struct Is_circle : std::false_type
  {
  };
  template <class P>
  struct Is_circle<P, std::void_t<decltype(std::declval<const P&>().radius())>> : std::true_type
  {
  };
  static constexpr bool are_circles = Is_circle<Piece>::value;
  static constexpr double full_turn = 6.283185307179586;

  std::vector<double> uniform(const Piece& piece) const
  {
    const auto n = std::size_t(piece.number_of_chords(typename Piece::FT(m_tolerance)));
    std::vector<double> t;
    for (std::size_t i = 0; i <= n; ++i) t.push_back(double(i) / double(n));
    return t;
  }

  struct Arc
  {
    std::size_t index, level;       // of the piece
    double x, y, radius;            // center
    double start, turn;             // angles
    std::vector<double> chord_ends; // angles, from start to start + turn, if there is a concentric arc
  };

  static Arc arc_of(const Piece_in_face& p, std::size_t index)
  {
    const auto c = p.arc->center(), s = p.arc->start_2();
    const double x = CGAL::to_double(c.x()), y = CGAL::to_double(c.y());
    const double start = std::atan2(CGAL::to_double(s.y()) - y, CGAL::to_double(s.x()) - x);
    return {index, p.level, x, y, CGAL::to_double(p.arc->radius()), start, CGAL::to_double(p.arc->angle()), {}};
  }

  bool are_concentric(const Arc& a, const Arc& b) const
  {
    return a.level != b.level && std::abs(a.radius - b.radius) <= m_tolerance &&
           std::hypot(b.x - a.x, b.y - a.y) <= m_least_length;
  }

  // True if an arc of another level has the same center within the tolerance.
  bool has_concentric(std::size_t i) const
  {
    const auto is_near = [&](std::size_t j) { return std::abs(m_arcs[i].radius - m_arcs[j].radius) <= m_tolerance; };
    for (std::size_t j = i; j > 0 && is_near(j - 1); --j)
      if (are_concentric(m_arcs[i], m_arcs[j - 1])) return true;
    for (std::size_t j = i + 1; j < m_arcs.size() && is_near(j); ++j)
      if (are_concentric(m_arcs[i], m_arcs[j])) return true;
    return false;
  }

  // Divides an arc at multiples of a part of the full turn, 2^-n of it for chords within the tolerance; chords of a larger arc are
  // never longer parts of the full turn. Then, from the largest to the smallest of the smaller arcs, at the ends of chords that a
  // chord of this arc may cut off.
  void divide(std::size_t i)
  {
    Arc& a = m_arcs[i];
    const double half_angle = (std::max)(0.5 * least_chord_angle, std::acos((std::max)(0., 1 - m_tolerance / a.radius)));
    const double step = full_turn * std::exp2(-std::ceil(std::log2(full_turn / (2 * half_angle))));
    a.chord_ends = {a.start, a.start + a.turn};
    for (double angle = std::ceil(a.start / step) * step; angle < a.start + a.turn; angle += step) add(a, angle, 0);
    for (std::size_t j = i; j > 0 && a.radius - m_arcs[j - 1].radius <= m_tolerance; --j)
    {
      const Arc& b = m_arcs[j - 1];
      if (!are_concentric(a, b) || b.level > a.level) continue;
      for (const double angle : b.chord_ends) add(a, angle, (a.radius - b.radius) / 2);
    }
  }

  // Divides the chord at an angle if its height is more than `height` and both parts are long enough.
  void add(Arc& a, double angle, double height) const
  {
    angle -= full_turn * std::floor((angle - a.start) / full_turn);
    const auto next = std::upper_bound(a.chord_ends.begin(), a.chord_ends.end(), angle);
    if (next == a.chord_ends.begin() || next == a.chord_ends.end()) return;
    const double last = *(next - 1), least = m_least_length / a.radius;
    const double sine = std::sin((*next - last) / 4); // height: r (1 - cos(angle / 2))
    if (2 * a.radius * sine * sine > height && angle - last > least && *next - angle > least) a.chord_ends.insert(next, angle);
  }

  const double m_tolerance, m_least_length;
  std::vector<Arc> m_arcs; // of the face, by radius
};

} // namespace CGAL::Geodesic_offset::internal

#endif
