// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divides the arcs in a face into chords within a tolerance, such that chords of different levels do not cross.
//
// The chord of an arc is nearer to the center. So it may cross an arc of a smaller level with the same center, if that level is
// nearer than the height of the chord. Both arcs are divided at common directions from the center then, as far as both reach:
// their chords are parallel.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_ARC_DIVISION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_ARC_DIVISION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Split_piece.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class Piece>
class Arc_division
{
public:
  typedef Split_piece<Piece> Piece_in_face;

  // `least_length`: of chords; centers of arcs that are nearer to each other are one.
  Arc_division(double chord_tolerance, double least_length) : m_tolerance(chord_tolerance), m_least_length(least_length) {}

  void set_face(const std::vector<Piece_in_face>& pieces)
  {
    m_arcs.clear();
    if constexpr (are_circles)
    {
      for (const Piece_in_face& p : pieces)
        if (p.arc) m_arcs.push_back(arc_of(p));
      std::sort(m_arcs.begin(), m_arcs.end(), [](const Arc& a, const Arc& b) { return a.radius < b.radius; });
    }
  }

  // The parameters of the ends of the chords of an arc, from 0 to 1.
  std::vector<double> operator()(const Piece_in_face& p) const
  {
    std::vector<double> t = {0};
    if constexpr (are_circles)
    {
      const Arc a = arc_of(p);
      std::vector<const Arc*> nearer; // whose ends the chords of a may cut off
      if (finds_concentric(a, nearer)) t = common_parameters(a, nearer);
    }
    if (t.size() == 1)
    {
      const auto n = std::size_t(p.arc->number_of_chords(typename Piece::FT(m_tolerance)));
      for (std::size_t i = 1; i < n; ++i) t.push_back(double(i) / double(n));
    }
    t.push_back(1);
    return t;
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

  struct Arc
  {
    double x, y, radius; // center
    double start, turn;  // angles
    std::size_t level;
  };

  static Arc arc_of(const Piece_in_face& p)
  {
    const auto c = p.arc->center(), s = p.arc->start_2();
    const double x = CGAL::to_double(c.x()), y = CGAL::to_double(c.y());
    return {x,
            y,
            CGAL::to_double(p.arc->radius()),
            std::atan2(CGAL::to_double(s.y()) - y, CGAL::to_double(s.x()) - x),
            CGAL::to_double(p.arc->angle()),
            p.level};
  }

  // Collects the arcs of smaller levels with the same center within the tolerance. Returns true if there are such arcs, or arcs
  // of larger levels.
  bool finds_concentric(const Arc& a, std::vector<const Arc*>& nearer) const
  {
    bool result = false;
    auto b = std::lower_bound(m_arcs.begin(), m_arcs.end(), a.radius - m_tolerance, [](const Arc& arc, double radius) {
      return arc.radius < radius;
    });
    for (; b != m_arcs.end() && b->radius <= a.radius + m_tolerance; ++b)
    {
      if (b->level == a.level || !(std::hypot(b->x - a.x, b->y - a.y) <= m_least_length)) continue;
      result = true;
      if (b->level < a.level) nearer.push_back(&*b);
    }
    return result;
  }

  // Multiples of a part of the full turn, 2^-i of it for chords within the tolerance, and the ends of the nearer arcs. The chords
  // of a larger arc are never longer parts of the full turn.
  std::vector<double> common_parameters(const Arc& a, const std::vector<const Arc*>& nearer) const
  {
    const double half_angle = std::acos((std::max)(0., 1 - m_tolerance / a.radius));
    const double step = full_turn * std::exp2(-std::ceil(std::log2(full_turn / (2 * half_angle))));
    std::vector<double> t = {0};
    const auto add = [&](double angle) {
      const double part = angle / a.turn;
      if (part < 1) t.push_back(part);
    };
    for (double angle = std::ceil(a.start / step) * step - a.start; angle < a.turn; angle += step) add(angle);
    for (const Arc* const b : nearer)
      for (const double end : {b->start, b->start + b->turn})
        add(end - a.start - full_turn * std::floor((end - a.start) / full_turn));
    std::sort(t.begin(), t.end());
    const double least = m_least_length / (a.radius * a.turn); // difference of parameters
    std::size_t n = 1;
    for (const double part : t)
      if (part - t[n - 1] > least && 1 - part > least) t[n++] = part;
    t.resize(n);
    return t;
  }

  const double m_tolerance, m_least_length;
  std::vector<Arc> m_arcs; // of the face, by radius
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
