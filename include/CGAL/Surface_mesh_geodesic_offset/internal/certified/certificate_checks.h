// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Debug mode of certified bounds, with CGAL_GEODESIC_OFFSET_CHECK_CERTIFICATES: asserts each statement of the error
// analysis with 200 bits for each window. Throws Certificate_error if a statement does not hold.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFICATE_CHECKS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFICATE_CHECKS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Precise_mesh.h>

#ifdef CGAL_GEODESIC_OFFSET_CHECK_CERTIFICATES

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_window.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// The image and the distances at the ends of the interval are within their error bounds.
inline void check_window(const Certified_window& w, double length)
{
  const Precise_image& p = *w.precise;
  check_certificate(p.is_parallel == w.is_parallel(), "kind of an image");
  check_certificate(precise_length(precise(w.image().x) - p.x, precise(w.image().y) - p.y) <= w.error_of_image(),
                    "error of an image");
  const Precise off_sigma = boost::multiprecision::abs(precise({w.sigma, w.sigma_low}) - p.sigma);
  check_certificate(off_sigma <= 4 * w.error_of_image() * (1 + std::abs(w.sigma)), "error of sigma");
  for (const auto& [t, d] : {std::make_pair(w.b0, w.d0), std::make_pair(w.b1, w.d1)})
  {
    const Precise off = boost::multiprecision::abs(d - p.distance(t));
    check_certificate(off <= length_error * (std::abs(d) + length) + w.error_of_image(), "distance at the end of an interval");
  }
}

// The face of a halfedge, for checks of windows that cross it.
class Certificate_of_face
{
public:
  Certificate_of_face(const Certified_mesh& mesh, Index h)
    : m_length(mesh.precise()[h].length), m_left_length(mesh.precise()[mesh.unfolded().previous(h)].length),
      m_right_length(mesh.precise()[mesh.unfolded().next(h)].length), m_apex(mesh.precise().apex(h)),
      m_left(mesh.precise()[h].corner), m_right(mesh.precise()[mesh.unfolded().next(h)].corner),
      m_rounded_length(mesh.length(h)), m_rounded_left_length(mesh.length(mesh.unfolded().previous(h))),
      m_rounded_right_length(mesh.length(mesh.unfolded().next(h))), m_mesh(mesh.precise())
  {
  }

  // A certain side is correct.
  void check_side(const Certified_window& w, double b, Sign side) const
  {
    const Precise s = w.precise->side(m_apex.x, m_apex.y, place(b));
    check_certificate(side == ZERO || (side == POSITIVE ? s > 0 : s < 0), "side of an apex");
  }

  // The distance of the image at the apex, and the length of a path through the interval to the apex, are within the error.
  void check_apex(const Certified_window& w, double d, double error) const
  {
    const Precise_image& p = *w.precise;
    const Precise distance = p.distance(m_apex.x, m_apex.y), allowed = Precise(error) - Precise(w.radius);
    check_certificate(boost::multiprecision::abs(d - distance) <= allowed, "distance at an apex");
    for (const double b : {w.b0, w.b1})
    {
      const Precise side = p.side(m_apex.x, m_apex.y, place(b));
      if (b == w.b0 ? side > 0 : side < 0)
        check_certificate(through(p, b, m_apex.x, m_apex.y) - d <= allowed, "path to an apex beside the rays");
    }
  }

  // Angle at the apex from the edge to the source of the halfedge to the ray from the image.
  Precise direction_at_apex(const Certified_window& w) const
  {
    const Precise_image& p = *w.precise;
    const Precise x = p.is_parallel ? p.x : Precise(p.x - m_apex.x), y = p.is_parallel ? p.y : Precise(p.y - m_apex.y);
    return atan2(m_left.y * x - m_left.x * y, -(m_left.x * x + m_left.y * y));
  }

  void check_entry(const Certified_window& w, double entry, double error) const
  {
    const Precise_image& p = *w.precise;
    const Precise e =
      p.is_parallel ? Precise(m_apex.x - m_apex.y * (p.x / p.y)) : Precise(p.x + (m_apex.x - p.x) * (p.y / (p.y - m_apex.y)));
    check_certificate(boost::multiprecision::abs(entry - e) <= error, "entry of the ray to an apex");
  }

  // A window without a child: its rays are along the edge, or do not meet the edge.
  void check_no_child(const Certified_window& w, bool to_left, bool is_turned) const
  {
    const Precise_image& p = *w.precise;
    if (is_turned) check_certificate(denominator(p, to_left, to_left ? w.b0 : w.b1) <= 0, "window without a child");
    else check_certificate(unfolded(p, to_left).y >= -2 * Precise(w.error_of_image()) * (2 + m_length), "window along an edge");
  }

  // The child contains all exits of the rays from the near end to `far`; paths to all its points are within its radius.
  void check_child(const Certified_window& w, double far, bool reaches_apex, bool to_left, Certified_window& child) const
  {
    const Precise_image& p = *w.precise;
    child.precise = m_mesh.add(unfolded(p, to_left));
    const double near = to_left ? w.b0 : w.b1;
    const Precise& edge = to_left ? m_left_length : m_right_length;
    const double rounded_edge = to_left ? m_rounded_left_length : m_rounded_right_length;
    // measured from the common corner of both edges
    const Precise child_near = to_left ? Precise(child.b0) : Precise(m_right_length - child.b1);
    const Precise child_far = to_left ? Precise(child.b1) : Precise(m_right_length - child.b0);
    const bool is_whole = to_left ? child.b1 >= rounded_edge : child.b0 == 0;
    const Precise near_den = denominator(p, to_left, near), far_den = denominator(p, to_left, far);
    const bool starts_at_corner = to_left ? child.b0 == 0 : child.b1 >= rounded_edge;
    if (near_den > 0 && !starts_at_corner)
      check_certificate(child_near <= from_corner(to_left, near) * -p.y / near_den, "near exit");
    if (!is_whole)
      check_certificate(!reaches_apex && far_den > 0 && child_far >= from_corner(to_left, far) * -p.y / far_den, "far exit");
    // rays beside the interval
    const double other = reaches_apex ? (to_left ? w.b1 : w.b0) : far;
    const Precise allowed = Precise(child.radius) - Precise(w.radius);
    for (const Precise& t : {starts_at_corner ? Precise(0) : child_near, is_whole ? edge : child_far})
    {
      const Precise_2& c = to_left ? m_left : m_right;
      const Precise x = to_left ? Precise(t * c.x) : Precise(m_length - t * c.x), y = t * c.y;
      for (const double b : {near, other})
      {
        const Precise side = p.side(x, y, place(b));
        if ((b == near) == to_left ? side > 0 : side < 0)
          check_certificate(through(p, b, x, y) - p.distance(x, y) <= allowed, "radius of a child");
      }
    }
    check_window(child, rounded_edge);
  }

private:
  Precise place(double b) const { return b < m_rounded_length ? Precise(b) : m_length; }

  // Length of the path to (x, y) via (b, 0).
  Precise through(const Precise_image& p, double b, const Precise& x, const Precise& y) const
  {
    return p.distance(place(b), Precise(0)) + precise_length(x - place(b), y);
  }

  Precise from_corner(bool at_source, double b) const { return at_source ? place(b) : Precise(m_length - place(b)); }

  // Exact version of Certified_propagation::across().
  Precise denominator(const Precise_image& p, bool to_left, double b) const
  {
    const Precise_2& c = to_left ? m_left : m_right;
    const Precise to_image = p.to_image(place(b));
    return c.y * (to_left ? to_image : Precise(-to_image)) - c.x * p.y;
  }

  Precise_image unfolded(const Precise_image& p, bool to_left) const
  {
    const Precise x = to_left || p.is_parallel ? p.x : Precise(p.x - m_length);
    const Precise_2 t = Precise_mesh::in_frame(to_left ? m_left : Precise_2{m_right.x, -m_right.y}, {x, p.y});
    if (to_left) return {t.x, t.y, p.sigma, p.is_parallel};
    if (!p.is_parallel) return {t.x + m_right_length, t.y, p.sigma, false};
    return {t.x, t.y, p.sigma - p.x * m_length + t.x * m_right_length, true};
  }

  const Precise m_length, m_left_length, m_right_length;
  const Precise_2 m_apex, m_left, m_right;
  const double m_rounded_length, m_rounded_left_length, m_rounded_right_length;
  const Precise_mesh& m_mesh;
};

// In the removed part of an interval, the path via an end of the halfedge is shorter by more than the radius.
inline void check_pruning(const Certified_window& before, const Certified_window* after, double upper_source,
                          double upper_target, double length, double radius)
{
  const Precise_image& p = *before.precise;
  const auto by_source = [&](double t) { return p.distance(t) - t > Precise(upper_source) + radius; };
  const auto by_target = [&](double t) { return p.distance(t) + t > Precise(upper_target) + length + radius; };
  if (!after) return check_certificate(by_source(before.b1) || by_target(before.b0), "window that is pruned");
  check_certificate(before.b0 == after->b0 || by_source(after->b0), "interval trimmed from its source");
  check_certificate(before.b1 == after->b1 || by_target(after->b1), "interval trimmed from its target");
}

inline void check_filter(const Certified_window& w, double t, double far_x, double far_yy, double upper, double radius)
{
  const Precise u = Precise(t) - far_x;
  check_certificate(w.precise->distance(t) > upper + radius + boost::multiprecision::sqrt(Precise(u * u + far_yy)),
                    "window that is filtered");
}

// Version of Certificate_of_face::check_apex() for a point (x, y) and the ends b0 and b1 of the interval.
inline void check_query(const Certified_window& w, const Precise& x, const Precise& y, const Precise& b0, const Precise& b1,
                        double d, double error)
{
  const Precise_image& p = *w.precise;
  const Precise allowed = Precise(error) - Precise(w.radius);
  check_certificate(boost::multiprecision::abs(d - p.distance(x, y)) <= allowed, "distance at a query point");
  if (p.side(x, y, b0) > 0)
    check_certificate(p.distance(b0, Precise(0)) + precise_length(x - b0, y) - d <= allowed, "path to a query point");
  if (p.side(x, y, b1) < 0)
    check_certificate(p.distance(b1, Precise(0)) + precise_length(x - b1, y) - d <= allowed, "path to a query point");
}

// At sample points of each input window, some window of the envelope has the same image or is certainly nearer.
inline void check_envelope(const Certified_window* first, const Certified_window* last,
                           const std::vector<Certified_window>& envelope)
{
  for (const Certified_window* w = first; w != last; ++w)
    for (const double part : {0., 0.01, 0.3, 0.5, 0.8, 0.99, 1.})
    {
      const double t = part == 1. ? w->b1 : (std::min)(w->b1, w->b0 + part * (w->b1 - w->b0));
      const Precise d = w->precise->distance(t);
      const bool is_represented = std::any_of(envelope.begin(), envelope.end(), [&](const Certified_window& x) {
        if (!(x.b0 <= t && t <= x.b1)) return false;
        const Precise_image &p = *w->precise, &q = *x.precise;
        if (p.is_parallel == q.is_parallel && boost::multiprecision::abs(p.sigma - q.sigma) <= x.radius + w->error_of_image() &&
            precise_length(p.x - q.x, p.y - q.y) <= w->error_of_image() + x.error_of_image())
          return true;
        return q.distance(t) + x.radius < d - w->radius;
      });
      check_certificate(is_represented, "sweep");
    }
}

// Sector behind a vertex: the windows emitted into its corners cover all directions at angles of at least pi to a path.
class Certificate_of_sector
{
public:
  explicit Certificate_of_sector(const Certified_mesh& mesh) : m_mesh(mesh) {}

  void clear() { m_windows.clear(); }
  // Window on the edge opposite to the corner, in the frame of the edge's twin.
  void add(Index corner, double from, double to) { m_windows[corner].push_back({from, to}); }

  // back: angle from the halfedge `corner`.
  void check(Index corner, const Precise& back) const
  {
    const Unfolded_mesh<double>& unfolded = m_mesh.unfolded();
    const Precise_mesh& mesh = m_mesh.precise();
    const Precise pi = boost::math::constants::pi<Precise>();
    const Index border = unfolded.first_on_border(corner);
    const Index first = border == no_index ? corner : border;
    Precise angle = back, total = 0, sum = 0;
    Index c = first;
    do {
      if (c == corner) angle += total;
      total += mesh[c].angle;
      c = unfolded.corner_ccw(c);
    } while (c != no_index && c != first);
    c = first;
    do {
      const Precise end = sum + mesh[c].angle;
      if (border == no_index) check_part(c, angle + pi - sum, angle + total - pi - sum);
      else
      {
        check_part(c, angle + pi - sum, mesh[c].angle);
        check_part(c, Precise(0), angle - pi - sum);
      }
      if (border == no_index) check_part(c, angle + pi - total - sum, angle - pi - sum); // after a full turn
      sum = end;
      c = unfolded.corner_ccw(c);
    } while (c != no_index && c != first);
  }

private:
  void check_part(Index h, Precise from, Precise to) const
  {
    const Unfolded_mesh<double>& unfolded = m_mesh.unfolded();
    const Precise_mesh& mesh = m_mesh.precise();
    const Precise& angle = mesh[h].angle;
    const Index e = unfolded.next(h);
    if (unfolded.twin(e) == no_index) return;
    from = (std::max)(from, Precise(0));
    to = (std::min)(to, angle);
    // Paths through vertices cover rays along the edges of the corner; sectors below the flatness of non-pseudo-sources may
    // be missing.
    if (!(to - from > Precise(Certified_mesh::flat) * 64)) return;
    const auto exit = [&](const Precise& a) { return mesh[e].length - mesh[h].length * sin(a) / sin(a + mesh[e].angle); };
    const Precise b0 = to < angle ? exit(to) : Precise(0), b1 = from > 0 ? exit(from) : mesh[e].length;
    const auto windows = m_windows.find(h);
    check_certificate(windows != m_windows.end(), "corner of a sector");
    const double length = m_mesh.length(e);
    check_certificate(
      std::any_of(windows->second.begin(), windows->second.end(),
                  [&](const std::pair<double, double>& w) { return w.first <= b0 && (w.second >= b1 || w.second >= length); }),
      "rays of a sector");
  }

  const Certified_mesh& m_mesh;
  std::map<Index, std::vector<std::pair<double, double>>> m_windows;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
#endif
