// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points of a face with equal distances through two windows: a line, a parabola, or a branch of a hyperbola.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_BISECTOR_CONIC_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_BISECTOR_CONIC_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_window.h>

#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Geodesic_offset::internal {

// A point of a face and its distance.
template <class NT>
struct Point_with_distance
{
  NT x, y, d;
  Point_in_face<NT> point() const { return {x, y}; }
  friend Point_with_distance<NT> operator+(const Point_with_distance<NT>& a, const Point_with_distance<NT>& b)
  {
    return {a.x + b.x, a.y + b.y, a.d + b.d};
  }
  friend Point_with_distance<NT> operator*(NT s, const Point_with_distance<NT>& a) { return {s * a.x, s * a.y, s * a.d}; }
};

// The linear form x px + y py + d pd - m.
template <class NT>
struct Linear_form
{
  NT x, y, d, m;
  NT linear(const Point_with_distance<NT>& p) const { return x * p.x + y * p.y + d * p.d; }
  NT value(const Point_with_distance<NT>& p) const { return linear(p) - m; }
};

// The polynomial q2 t^2 + q1 t + q0.
template <class NT>
struct Quadratic
{
  NT q2, q1, q0;
};

// The graphs of the distances of windows in (x, y, distance) are cones (points) and planes of the same slope (parallel rays). The
// difference of the equations of two of them is linear, so the bisector of two windows, lifted to its distances, is a section of
// one cone and a plane: with a parameter t,
//
//   hyperbola, two points:                 c0 + c1 t + c2 / t,  t > 0  (t = e^s for the hyperbolic angle s)
//   parabola, a point and parallel rays:   c0 + c1 t + c2 t^2
//   line, two bundles of parallel rays:    c0 + c1 t
//
// and linear forms on it are quadratic in t. In all cases rounding moves points by a few u of the coordinates of the images. Of
// two points with equal sigma the hyperbola is a line, too.
template <class NT>
class Bisector_conic
{
public:
  typedef Point_in_face<NT> Point;
  enum Kind : unsigned char { SEGMENT, PARABOLA, HYPERBOLA };

  // Returns false if there is no bisector: one of the windows is nearer everywhere, or both have the same distances. On a ray
  // on which a window is just as near as another one that is nearer beside the ray, cones may meet: is_ray(). `center`: a point
  // of the face, the same for all bisectors of two bundles of parallel rays. Where these are nearly one, rounding places the
  // line, and at the center it does so least. Binding test: test_voronoi_diagram, parallel rays of nearly one direction.
  bool make(const Voronoi_window<NT>& a, const Voronoi_window<NT>& b, NT tie, const Point& center)
  {
    m_is_ray = false;
    m_has_inverse = false;
    m_low = -std::numeric_limits<NT>::infinity();
    if (a.is_parallel() && b.is_parallel()) return make_line(a, b, center);
    if (a.is_parallel()) return make_parabola(b, a, tie);
    if (b.is_parallel()) return make_parabola(a, b, tie);
    return a.sigma() < b.sigma() ? make_hyperbola(b, a, tie) : make_hyperbola(a, b, tie);
  }

  // The left or right bounding ray of a window.
  void make_bound(const Voronoi_window<NT>& w, bool is_left)
  {
    const Half_plane<NT>& bound = w.bound[is_left ? 0 : 1]; // may be beside the end of the chord, as at a common ray
    const Point end = w.end[is_left ? 0 : 1], u = (is_left ? -1. : 1.) * quarter_turn(bound.n);
    m_kind = SEGMENT;
    m_is_ray = true;
    m_has_inverse = false;
    m_low = -std::numeric_limits<NT>::infinity();
    m_c0 = {end.x, end.y, w.distance_at(end)};
    m_c1 = {u.x, u.y, 1};
    m_c2 = {0, 0, 0};
  }

  Kind kind() const { return m_kind; }
  bool is_ray() const { return m_is_ray; }
  NT lowest_parameter() const { return m_low; }

  Point_with_distance<NT> at(NT t) const
  {
    return m_has_inverse ? m_c0 + t * m_c1 + (1 / t) * m_c2 : m_c0 + t * m_c1 + (t * t) * m_c2;
  }

  // A triangle that contains the arc between two parameters: both ends, and the common point of their tangents.
  std::array<Point, 3> triangle_around(NT s, NT t) const
  {
    const Point_with_distance<NT> common =
      m_has_inverse ? m_c0 + (2 * s * t / (s + t)) * m_c1 + (2 / (s + t)) * m_c2 : m_c0 + ((s + t) / 2) * m_c1 + (s * t) * m_c2;
    return {at(s).point(), common.point(), at(t).point()};
  }

  // Tangent in the direction of increasing parameters, not normalized.
  Point tangent(NT t) const { return (m_has_inverse ? m_c1 + (-1 / (t * t)) * m_c2 : m_c1 + (2 * t) * m_c2).point(); }

  // The values of a linear form; for a hyperbola, times t.
  Quadratic<NT> along(const Linear_form<NT>& f) const
  {
    if (m_has_inverse) return {f.linear(m_c1), f.value(m_c0), f.linear(m_c2)};
    return {f.linear(m_c2), f.linear(m_c1), f.value(m_c0)};
  }

  // The parameter of the point of the conic that is nearest to a point beside it, found by steps along the tangent from the
  // parameter t: on the same branch, where two of them are close.
  NT parameter_near(const Point& p, NT t) const
  {
    constexpr int most_steps = 8;
    for (int i = 0; i < most_steps; ++i)
    {
      const Point u = tangent(t);
      const NT next = t + dot(p - at(t).point(), u) / dot(u, u);
      t = m_has_inverse ? (std::max)(next, t / 2) : next; // t > 0
    }
    return t;
  }

  // The parameter of a point on the conic: from its component across the axis.
  NT parameter_of(const Point& p) const
  {
    const Point c1 = m_c1.point(), across = m_has_inverse ? c1 - m_c2.point() : c1;
    const NT t = dot(p - m_c0.point(), across) / dot(across, across);
    if (!m_has_inverse) return t;
    const NT root = square_root<NT>(t * t + NT(1));
    return t < NT(0) ? NT(1) / (root - t) : root + t; // exp(asinh(t))
  }

  // For a line: the parameter of the point nearest to c.
  NT nearest_parameter(const Point& c) const
  {
    const Point u = m_c1.point();
    return dot(c - m_c0.point(), u) / dot(u, u);
  }

  // For a line: (p - c)^2 - e^2 - 2 tie e with e = d - sigma, in the parameter minus t. Where e is positive, it is negative where a
  // point at c is nearer, or, up to `tie`, as near.
  Quadratic<NT> along_line(const Point& c, NT sigma, NT t, NT tie) const
  {
    const Point_with_distance<NT> at_t = at(t);
    const Point p = at_t.point() - c, u = m_c1.point();
    const NT e = at_t.d - sigma, f = m_c1.d;
    return {dot(u, u) - f * f, 2 * (dot(p, u) - (e + tie) * f), dot(p, p) - e * (e + 2 * tie)};
  }

  // The parameter between s (at 0) and t (at 1): for a hyperbola, in proportion to the hyperbolic angle.
  NT between(NT s, NT t, NT part) const
  {
    if (part == NT(1)) return t;
    return m_has_inverse ? s * NT(std::pow(CGAL::to_double(t / s), CGAL::to_double(part))) : s + part * (t - s);
  }

  // Number of chords between two parameters that are no farther from the conic than the tolerance. The point that is farthest from
  // a chord is that of the middle parameter, where the tangent is parallel to the chord:
  //   parabola:  |c1 x c2| h^2 / (4 |tangent|), with the tangent c1 + 2 t c2
  //   hyperbola: (cosh(h / 2) - 1) |A x B| / |A sinh s + B cosh s|, with the point A cosh s + B sinh s
  NT number_of_chords(NT s, NT t, NT tolerance) const
  {
    if (m_kind == SEGMENT) return 1;
    if (s > t) std::swap(s, t);
    const Point c1 = m_c1.point(), c2 = m_c2.point();
    if (!m_has_inverse)
    {
      const NT apex = -dot(c1, c2) / (2 * dot(c2, c2)), nearest = (std::max)(s, (std::min)(t, apex));
      const NT h = 2 * square_root<NT>(tolerance * length(tangent(nearest)) / CGAL::abs(cross(c1, c2)));
      return std::ceil((t - s) / h);
    }
    const Point a = c1 + c2, b = c1 - c2; // orthogonal
    const NT nearest = (std::max)(s, (std::min)(t, 1.)), angle = std::log(nearest);
    const NT slope = length(std::sinh(angle) * a + std::cosh(angle) * b);
    const NT h = 4 * std::asinh(square_root<NT>(tolerance * slope / (2 * CGAL::abs(cross(a, b)))));
    return std::ceil(std::log(t / s) / h);
  }

private:
  template <class>
  friend class Bisector_conic;

  bool make_line(const Voronoi_window<NT>& a, const Voronoi_window<NT>& b, const Point& center)
  {
    const Point g = a.image() - b.image();
    const NT size = length(g);
    if (!(size > 4 * std::numeric_limits<NT>::epsilon())) return false;
    const Point n = (1 / size) * g, u = quarter_turn(n);
    const NT off = a.distance_at(center) - b.distance_at(center); // falls by `size` along n
    const Point p = center + (off / size) * n;
    m_kind = SEGMENT;
    m_c0 = {p.x, p.y, a.distance_at(p)};
    m_c1 = {u.x, u.y, -dot(a.image(), u)};
    m_c2 = {0, 0, 0};
    return true;
  }

  // The part of a ray of `a` that is behind its image.
  bool make_ray(const Voronoi_window<NT>& a, const Point& direction)
  {
    m_kind = SEGMENT;
    m_is_ray = true;
    m_low = 0;
    m_c0 = {a.image().x, a.image().y, a.sigma()};
    m_c1 = {direction.x, direction.y, 1};
    m_c2 = {0, 0, 0};
    return true;
  }

  // `a`: a point, `b`: parallel rays. The difference at the point decides; it is the distance of focus and directrix.
  bool make_parabola(const Voronoi_window<NT>& a, const Voronoi_window<NT>& b, NT tie)
  {
    const Point v = b.image(), f = a.image();
    const NT n = b.distance_at(f) - a.sigma();
    if (n < -tie) return false;
    if (n <= tie) return make_ray(a, -1. * v);
    const Point w = quarter_turn(v);
    m_kind = PARABOLA;
    m_c0 = {f.x + n / 2 * v.x, f.y + n / 2 * v.y, a.sigma() + n / 2};
    m_c1 = {n * w.x, n * w.y, 0};
    m_c2 = {-n / 2 * v.x, -n / 2 * v.y, n / 2};
    return true;
  }

  // sigma of `a` is not less than that of `b`, so the branch bends around the image of `a`.
  bool make_hyperbola(const Voronoi_window<NT>& a, const Voronoi_window<NT>& b, NT tie)
  {
    const Point e = b.image() - a.image();
    const NT d = length(e), k = a.sigma() - b.sigma();
    if (d <= tie || k > d + tie) return false;
    const Point u = (1 / d) * e, w = quarter_turn(u);
    if (k >= d - tie) return make_ray(a, -1. * u);
    const NT height = square_root<NT>((d - k) * (d + k)) / 4, width = k / 4;
    const Point middle = 0.5 * (a.image() + b.image());
    m_kind = k == 0 ? SEGMENT : HYPERBOLA;
    m_has_inverse = true;
    m_low = 0;
    m_c0 = {middle.x, middle.y, (a.sigma() + b.sigma()) / 2};
    m_c1 = {-width * u.x + height * w.x, -width * u.y + height * w.y, d / 4};
    m_c2 = {-width * u.x - height * w.x, -width * u.y - height * w.y, d / 4};
    return true;
  }

  Point_with_distance<NT> m_c0, m_c1, m_c2;
  NT m_low;
  Kind m_kind;
  bool m_has_inverse, m_is_ray;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
