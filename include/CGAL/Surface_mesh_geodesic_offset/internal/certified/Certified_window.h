// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Window with an error bound.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_WINDOW_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_WINDOW_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_number_pair.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Double_double.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_offset::internal {

// Relative errors of one rounding, and of the few roundings in a length, a side test, and an exit.
constexpr double unit_roundoff = 0x1p-53;
constexpr double length_error = 16 * unit_roundoff;
constexpr double side_error = 8 * unit_roundoff;
constexpr double exit_error = 6 * unit_roundoff;

// Error of an image after at most `most_faces` faces without a bend, relative to its distance and the longest edge, which
// is between 1 and 2.
constexpr double image_error = 0x1p-72;
constexpr Index most_faces = 0xffff;

// An image this near to the line of an edge, relative to its distance and the edge, is on it: its rays are along the edge. Two
// roundings of a rotation. In faces that are thinner than this, seen from the image, the rays are lost; so it must not be larger,
// though images have larger errors. Binding test: test_certified_reference, near a vertex.
constexpr double along_edge = 0x1p-96;

// Windows lose the paths that pass a vertex within the error o of their image, at a distance of r or more from it. The path via
// the vertex is longer by at most 2 r, and by 4 o^2 / r if h, at most 2 o, is how far the path is off the vertex: h^2 / 2 (1 / r
// + 1 / D) behind the vertex, where the distance D to the next bend counts as r at least. With o up to 4 times the image_error,
// the smaller of both is largest, 11.4 times the image_error, for r = 5.7 times the image_error. Binding test:
// test_certified_reference, near a vertex.
inline double loss_beside_vertex(double r)
{
  const double largest = 12 * image_error;
  return r > largest ? 64 * (image_error / r) * image_error : largest;
}

// Error of a corner or an apex, relative to the length of the edges.
constexpr double corner_error = 0x1p-97;

// Counterpart of `Window` with an image of twice the digits. The interval contains all rays that may be shortest, and some
// beside them within rounding. Each point of the rays has a path that is at most `radius` longer than the window's
// distance; if the window's path is shortest, its length differs from that distance by at most `radius`.
struct Certified_window
{
  double x, y, sigma;
  double b0, b1, d0, d1;
  double radius;
  double x_low, y_low, sigma_low;
  Index bits; // bit 0: parallel; bit 1: propagated; from bit 2: number of faces since the last bend

  bool is_parallel() const { return bits & 1u; }
  bool is_propagated() const { return bits & 2u; }
  void set_propagated() { bits |= 2u; }

  // Number of faces that the image was unfolded across.
  Index faces() const { return bits >> 2; }
  Index bits_of_child() const { return (bits & ~2u) + 4u; }
  void set_faces_of_both(const Certified_window& o) { bits = (std::max)(bits >> 2, o.bits >> 2) << 2 | (bits & 3u); }

  Double_double_2 image() const { return {{x, x_low}, {y, y_low}}; }
  void set_image(const Double_double_2& image)
  {
    x = image.x.high;
    x_low = image.x.low;
    y = image.y.high;
    y_low = image.y.low;
  }

  // x coordinate of the vector from a point of the halfedge to the image, accurate also if both are close together; for
  // parallel rays, of their direction.
  double to_image(const Double_double& t) const { return is_parallel() ? x : (x - t.high) + (x_low - t.low); }

  // Error at most length_error (D + size of the face).
  double distance_at(double t) const { return distance_at(t, 0.); }
  double distance_at(double px, double py) const
  {
    if (is_parallel()) return sigma - (x * px + y * py);
    const double u = (px - x) - x_low, v = (py - y) - y_low;
    return sigma + std::sqrt(u * u + v * v);
  }

  // Distances at two points of the halfedge.
  Geodesic_number_pair<double> distances_at(const Geodesic_number_pair<double>& t) const
  {
    if (is_parallel()) return Pair(sigma) - Pair(x) * t;
    return Pair(sigma) + radii(t, Pair(x), Pair(x_low), Pair(y + y_low));
  }

  // Distance of a at u, and of b at v.
  static Geodesic_number_pair<double> distances_at(const Certified_window& a, double u, const Certified_window& b, double v)
  {
    if ((a.bits | b.bits) & 1u) return Pair(a.distance_at(u), b.distance_at(v));
    return Pair(a.sigma, b.sigma) +
           radii(Pair(u, v), Pair(a.x, b.x), Pair(a.x_low, b.x_low), Pair(a.y + a.y_low, b.y + b.y_low));
  }

  void set_interval(double from, double to)
  {
    CGAL_precondition(from <= to);
    const Geodesic_number_pair<double> t(from, to);
    t.put(b0, b1);
    distances_at(t).put(d0, d1);
  }

  double error_of_image() const { return image_error * (is_parallel() ? 1. : std::abs(x) + std::abs(y) + 1.); }

  // Side of the ray through (b, 0) on which a point (px, py) of the face lies: POSITIVE for left; ZERO if uncertain.
  Sign side_of(const Double_double& px, double py, const Double_double& b) const
  {
    // Image, b and p are displaced by at most their errors; seen from b, the image and the point turn by their errors. All
    // sizes are those of vectors from b, since coordinates may be much larger.
    const double from_b = to_image(b), along = (px.high - b.high) + (px.low - b.low), value = y * along - from_b * py;
    const double off = error_of_image(), off_p = corner_error * (std::abs(px.high) + py + b.high);
    // The image is below the halfedge, and p is not: if both are before b, or both behind b, p is not on the ray.
    if (from_b < -off && along < -off_p) return POSITIVE;
    if (from_b > off && along > off_p) return NEGATIVE;
    const double error = side_error * (std::abs(from_b) * py + std::abs(y * along)) + off * (std::abs(along) + py) +
                         off_p * (std::abs(from_b) + std::abs(y));
    return value > error ? POSITIVE : value < -error ? NEGATIVE : ZERO;
  }

  // Excess length of the path around the end b of the interval over the distance of a point p for which side_of() is
  // uncertain. The distance of p from the ray through b is at most twice the error in side_of(), divided by the length r of the
  // ray up to b: at most 16 u |p - b| + 2 off |p - b|_1 / r + 2 corner_error (|p|_1 + b) sqrt(2). The path is longer by at most
  // that, if p is not behind b; p is behind b by at most off |p - b|_1 / r + corner_error (|p|_1 + b), as otherwise its side is
  // certain, and the path is longer by twice this, too. It is longer by at most 2 r. Binding tests: test_certified_reference,
  // steps in faces; for parallel rays, which start at a segment that p may be behind, test_certified_segments.
  double way_around(const Double_double& px, double py, const Double_double& b) const
  {
    const double along = std::abs((px.high - b.high) + (px.low - b.low)) + py;
    const double r = is_parallel() ? 1. : std::abs(to_image(b)) - y;
    // r is the sum of both coordinates, at most sqrt(2) times the length
    const double by_image = 6 * error_of_image() * along;
    return 5 * side_error * along + 8 * corner_error * (std::abs(px.high) + py + b.high) +
           (is_parallel() || by_image < 2 * r * r ? by_image / r : 2 * r);
  }

  double minimum() const
  {
    if (!is_parallel() && b0 < x && x < b1) return sigma - y;
    return (std::min)(d0, d1);
  }

private:
  typedef Geodesic_number_pair<double> Pair;

  // Distances from points of the halfedge to images.
  static Pair radii(const Pair& t, const Pair& x, const Pair& x_low, const Pair& y)
  {
    const Pair u = (t - x) - x_low;
    return square_root(u * u + y * y);
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
