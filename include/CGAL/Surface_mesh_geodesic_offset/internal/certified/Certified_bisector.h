// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Certain statements about the difference of the distances of two windows on a halfedge.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_BISECTOR_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_BISECTOR_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_number_pair.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_window.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_offset::internal {

// The difference is the distance of window a minus that of window b.
class Certified_bisector
{
public:
  typedef Certified_window Window;

  Certified_bisector(const Window& a, const Window& b, double length)
    : m_a(a), m_b(b), m_margin(a.radius + b.radius + 2 * (a.error_of_image() + b.error_of_image()) +
                               2 * length_error * ((std::max)((std::max)(a.d0, a.d1), (std::max)(b.d0, b.d1)) + length))
  {
  }

  // A difference beyond the margin is certain.
  double margin() const { return m_margin; }
  double difference(double t) const { return m_a.distance_at(t) - m_b.distance_at(t); }

  // Approximate stationary point of the difference. At most one exists; it is collinear with both images.
  bool stationary_point(double& t) const
  {
    const bool pa = m_a.is_parallel(), pb = m_b.is_parallel();
    if (pa && pb) return false;
    const double den = (pa ? 0. : m_b.y) - (pb ? 0. : m_a.y);
    if (den == 0) return false;
    t = (m_a.x * m_b.y - m_b.x * m_a.y) / den;
    return true;
  }

  // Sign of the derivative of the difference, that of (t - x) / |y| for a minus the one for b; ZERO if uncertain.
  Sign slope(double t) const
  {
    const double p = m_a.to_image(t) * m_b.y, q = m_b.to_image(t) * m_a.y;
    const double value = p - q, error = side_error * (std::abs(p) + std::abs(q));
    return value > error ? POSITIVE : value < -error ? NEGATIVE : ZERO;
  }

  // True if a minimum of the absolute difference may lie between two points at which the same window is certainly farther:
  // a for `of` = 1, b for `of` = -1.
  bool may_turn_between(int of, double from, double to) const { return int(slope(from)) * of <= 0 && int(slope(to)) * of >= 0; }

  // Approximate test for a stationary point between two points.
  bool may_turn(double from, double to) const
  {
    double t;
    return stationary_point(t) && from < t && t < to;
  }

  // Position of a cut, and the window's distance there.
  struct Cut
  {
    double t, distance;
  };

  // For a difference that is certainly negative at u and certainly positive at v, computes the retained parts: a up to
  // of_a, and b from of_b. Returns false if it is not certain that the rest is superfluous.
  BOOST_FORCEINLINE bool find(double u, double v, Cut& of_a, Cut& of_b) const
  {
    double t;
    if (m_a.is_parallel() || m_b.is_parallel() || !closed_form(u, v, t)) return false;
    // one step of Newton's iteration, then a displacement that makes the sign certain
    typedef Geodesic_number_pair<double> Pair;
    const Pair x = (Pair(t) - Pair(m_a.x, m_b.x)) - Pair(m_a.x_low, m_b.x_low), y(m_a.y, m_b.y);
    const Pair r = square_root(x * x + y * y);
    const double xa = x.first(), xb = x.second(), ra = r.first(), rb = r.second();
    const double inverse = ra * rb / (xa * rb - xb * ra); // of the derivative, xa / ra - xb / rb
    t -= ((m_a.sigma - m_b.sigma) + (ra - rb)) * inverse;
    const double aside = 3 * m_margin * inverse;
    of_a.t = t + aside;
    of_b.t = t - aside;
    if (!(u < of_b.t && of_a.t < v)) return false;
    const Pair of_first = m_a.distances_at({of_a.t, of_b.t}), of_second = m_b.distances_at({of_a.t, of_b.t});
    of_a.distance = of_first.first();
    of_b.distance = of_second.second();
    return of_a.distance - of_second.first() > m_margin && of_b.distance - of_first.second() > m_margin &&
           slope(of_a.t) == POSITIVE && slope(of_b.t) == POSITIVE;
  }

private:
  // Approximate bisector point of two point images. With k = sigma_b - sigma_a, |t - A| = |t - B| + k, and m t + n = |t -
  // A|^2 - |t - B|^2 - k^2 = 2 k |t - B|. Squaring gives a quadratic equation; one of its two roots has the right sign.
  bool closed_form(double u, double v, double& t) const
  {
    const double k = (m_b.sigma - m_a.sigma) + (m_b.sigma_low - m_a.sigma_low);
    const double dx = (m_a.x - m_b.x) + (m_a.x_low - m_b.x_low), dy = (m_a.y - m_b.y) + (m_a.y_low - m_b.y_low);
    const double m = -2 * dx, n = dx * (m_a.x + m_b.x) + dy * (m_a.y + m_b.y) - k * k, k4 = 4 * k * k;
    if (k == 0)
    {
      t = -n / m;
      return u < t && t < v;
    }
    const double qa = m * m - k4, qb = m * n + k4 * m_b.x, qc = n * n - k4 * (m_b.x * m_b.x + m_b.y * m_b.y);
    const double discriminant = qb * qb - qa * qc;
    if (!(discriminant >= 0)) return false;
    const double q = -qb - std::copysign(std::sqrt(discriminant), qb);
    t = q / qa;
    if (u < t && t < v && (m * t + n) * k >= 0) return true;
    t = qc / q;
    return u < t && t < v;
  }

  const Window& m_a;
  const Window& m_b;
  const double m_margin;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
