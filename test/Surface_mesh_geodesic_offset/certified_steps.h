// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Single steps of certified windows, compared with formulas in 113 bits: the statements of the error analysis about frames, about
// windows that cross a face, and about the sweep of a halfedge. In the bounds of whole meshes, an error bound that is too small
// hardly ever shows.

#ifndef GEODESIC_OFFSET_TEST_CERTIFIED_STEPS_H
#define GEODESIC_OFFSET_TEST_CERTIFIED_STEPS_H

#include "generated_soup.h"
#include "reference_distances.h"
#include "test_check.h"

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_envelope.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_propagation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace test {

typedef CGAL::Geodesic_offset::internal::Certified_window Certified_window;

/// Image of a window, or its direction for parallel rays, of which the window's image may be an approximation.
struct Exact_image
{
  typedef Reference_distances::Number Number;
  typedef Reference_distances::Planar Planar;
  typedef CGAL::Geodesic_offset::internal::Double_double Double_double;

  Planar at;
  Number sigma;
  bool is_parallel;

  static Number number(const Double_double& x) { return Number(x.high) + Number(x.low); }
  static Planar planar(const CGAL::Geodesic_offset::internal::Double_double_2& p) { return {number(p.x), number(p.y)}; }

  explicit Exact_image(const Certified_window& w)
    : at(planar(w.image())), sigma(number({w.sigma, w.sigma_low})), is_parallel(w.is_parallel())
  {
  }

  Number distance(const Planar& p) const
  {
    if (is_parallel) return sigma - (at.x * p.x + at.y * p.y);
    return sigma + Reference_distances::length({p.x - at.x, p.y - at.y});
  }
  Number distance(double t) const { return distance(Planar{Number(t), Number(0)}); }

  /// Direction of the ray through (b, 0).
  Planar ray(const Number& b) const { return {is_parallel ? Number(-at.x) : Number(b - at.x), -at.y}; }

  /// Positive if p is to the left of the ray through (b, 0).
  Number side(const Planar& p, const Number& b) const { return Reference_distances::cross(ray(b), {p.x - b, p.y}); }

  /// Length of the path to p via (b, 0).
  Number via(const Number& b, const Planar& p) const
  {
    return distance(Planar{b, Number(0)}) + Reference_distances::length({p.x - b, p.y});
  }
};

/// Random windows of a halfedge, of which many have rays near to a corner of the next face, or along an edge.
class Random_certified_windows
{
public:
  explicit Random_certified_windows(unsigned seed) : random_(seed) {}

  double number(double low, double high) { return uniform(random_, low, high); }
  bool one_of(std::size_t n) { return uniform_index(random_, n) == 0; }
  double power(double low, double high) { return std::pow(10, number(low, high)); }

  /// The rays of some windows pass (apex_x, apex_y) at the beginning of the interval, or at its end.
  Certified_window operator()(double length, double apex_x, double apex_y)
  {
    double b0, b1;
    do {
      b0 = one_of(4) ? 0 : number(0, length);
      b1 = one_of(4) ? length : one_of(6) ? (std::min)(b0 * (1 + power(-15, 0)), length) : number(0, length);
      if (b1 < b0) std::swap(b0, b1);
    } while (b0 == b1);
    const double through = one_of(2) ? b0 : b1, angle = one_of(4) ? power(-26, 0) : number(0, CGAL_PI);
    double x = -std::cos(angle), y = -std::sin(angle);
    if (one_of(3))
    { // away from the apex, or parallel to an edge
      const double from = one_of(2) ? through : one_of(2) ? 0 : length, size = std::hypot(apex_x - from, apex_y);
      x = (from - apex_x) / size;
      y = -apex_y / size;
    }
    Certified_window w{};
    if (one_of(5))
    {
      w.bits = 1;
      const Double_double size = square_root(Double_double(x) * x + Double_double(y) * y);
      w.set_image({Double_double(x) / size, Double_double(y) / size});
      w.sigma = 3 * length;
    }
    else
    {
      const double away = power(one_of(3) ? -10 : -1, 1) * length;
      w.set_image({Double_double(through) + digits(x * away), digits(y * away)});
      w.sigma = one_of(2) ? 0 : number(0, length);
    }
    w.set_interval(b0, b1);
    return w;
  }

  /// Several windows of a halfedge, which tie at a point up to rounding or nearly so, or have nearly one image.
  std::vector<Certified_window> list(double length)
  {
    std::vector<Certified_window> windows;
    const double tie = number(0, length), distance = 16 * length;
    for (std::size_t n = 2 + uniform_index(random_, 5); windows.size() < n;)
    {
      Certified_window w = (*this)(length, number(0, length), number(0.1, 1) * length);
      if (!windows.empty() && one_of(4))
      {
        const Certified_window& other = windows[uniform_index(random_, windows.size())];
        const double off = power(-34, -18) * other.error_of_image() / 0x1p-72;
        w.bits = other.bits & 1u;
        w.set_image({other.image().x + Double_double(number(-1, 1) * off),
                     other.image().y + Double_double(number(-1, 1) * off)});
        w.sigma = other.sigma;
        w.sigma_low = other.sigma_low;
      }
      else w.sigma += distance - w.distance_at(tie) + (one_of(2) ? 0 : number(-1, 1) * power(-16, -12)) * length;
      w.set_interval(w.b0, w.b1);
      w.radius = one_of(2) ? 0 : power(-18, -13) * length;
      if (one_of(3)) w.set_propagated();
      windows.push_back(w);
    }
    return windows;
  }

  /// An image that differs from that of the window by the largest error allowed.
  Exact_image displaced(const Certified_window& w)
  {
    Exact_image image(w);
    const double angle = number(0, 2 * CGAL_PI), off = 0.999 * w.error_of_image();
    image.at.x += Exact_image::Number(off * std::cos(angle));
    image.at.y += Exact_image::Number(off * std::sin(angle));
    return image;
  }

private:
  typedef Exact_image::Double_double Double_double;

  Double_double digits(double x) { return CGAL::Geodesic_offset::internal::quick_two_sum(x, x * number(-0x1p-54, 0x1p-54)); }

  Random random_;
};

/// Face of a halfedge p -> q with the apex r, in the units of the certified mesh.
class Certified_face_check
{
public:
  typedef Exact_image::Number Number;
  typedef Exact_image::Planar Planar;
  typedef CGAL::Geodesic_offset::internal::Certified_mesh Certified_mesh;
  typedef CGAL::Geodesic_offset::internal::Index Index;

  Certified_face_check(const Certified_mesh& mesh, Index h, const Reference_distances& reference, std::size_t triangle, int k)
    : mesh_(mesh), h_(h), face_(mesh, h)
  {
    const Number unit(mesh.from_unit(1.));
    const auto scaled = [&](int side) {
      Reference_distances::Side s = reference.side(triangle, side % 3);
      return Reference_distances::Side{s.length / unit, {s.apex.x / unit, s.apex.y / unit}, s.beyond};
    };
    const Reference_distances::Side base = scaled(k);
    length_ = base.length;
    apex_ = base.apex;
    const Number right = scaled(k + 1).length, left = scaled(k + 2).length;
    corner_ = {apex_.x / left, apex_.y / left};
    const Planar at_target = scaled(k + 1).apex;
    left_ = {true, {Number(0), Number(0)}, corner_, left, face_.left_length};
    right_ = {false, {length_, Number(0)}, {-at_target.x / length_, at_target.y / length_}, right, face_.right_length};
  }

  void check_frame() const
  {
    const auto& e = mesh_[h_];
    const Planar corner = Exact_image::planar(e.corner);
    const Number off = Exact_image::number(e.length) - length_;
    CHECK_DETAIL(Reference_distances::absolute(off) <= Number(0x1p-98) * length_, text(off / length_, 0x1p-98));
    const Number turned = Reference_distances::length({corner.x - corner_.x, corner.y - corner_.y});
    CHECK_DETAIL(turned <= Number(0x1p-98), text(turned, 0x1p-98));
  }

  void check_step(Random_certified_windows& random)
  {
    const Certified_window w = random(face_.length, face_.apex_x, face_.apex_y);
    const Exact_image image = random.displaced(w);
    if (!(image.at.y < Number(0))) return;
    bool is_clear;
    const int side = face_.clear_side(w, is_clear);
    const CGAL::Sign from = face_.side_of_apex(w, w.b0), to = face_.side_of_apex(w, w.b1);
    const Number at_b0 = image.side(apex_, place(w.b0)), at_b1 = image.side(apex_, place(w.b1));
    CHECK(from == CGAL::ZERO || (from == CGAL::POSITIVE) == (at_b0 > Number(0)));
    CHECK(to == CGAL::ZERO || (to == CGAL::POSITIVE) == (at_b1 > Number(0)));
    if (is_clear) CHECK(side < 0 ? at_b1 < Number(0) : side > 0 ? at_b0 > Number(0) : at_b0 <= Number(0) && at_b1 >= Number(0));
    if (from == CGAL::POSITIVE) return check_child(w, image, false, w.b0, false, 0.);
    if (to == CGAL::NEGATIVE) return check_child(w, image, true, w.b1, false, 0.);
    const bool is_inside = from == CGAL::NEGATIVE && to == CGAL::POSITIVE;
    const double lateral = is_inside ? 0. : face_.lateral_error(w);
    check_apex(w, image, lateral);
    for (const bool to_left : {true, false})
    {
      check_child(w, image, to_left, to_left ? w.b1 : w.b0, true, lateral);
      check_child(w, image, to_left, random.number(w.b0, w.b1), false, lateral);
    }
  }

private:
  // Edge p -> r, or r -> q, by the direction from its corner at p, or q, to the apex.
  struct Edge
  {
    bool is_left;
    Planar corner, axis;
    Number length;
    double rounded_length;

    // Position in the frame of the edge from the distance from the corner, and vice versa.
    Number position(const Number& t) const { return is_left ? t : Number(length - t); }

    Planar point(double b) const
    {
      const Number t = position(b < rounded_length ? Number(b) : length);
      return {corner.x + t * axis.x, corner.y + t * axis.y};
    }

    Planar in_frame(const Exact_image& a) const
    {
      const Planar v = a.is_parallel ? a.at : Planar{a.at.x - corner.x, a.at.y - corner.y};
      const Number along = axis.x * v.x + axis.y * v.y, across = Reference_distances::cross(axis, v);
      if (is_left) return {along, across};
      return {a.is_parallel ? Number(-along) : Number(length - along), -across};
    }
  };

  static std::string text(const Number& value, double bound) { return values(double(value), bound); }

  static double rounding(double distance, double size)
  {
    return CGAL::Geodesic_offset::internal::length_error * (std::abs(distance) + size);
  }

  // The end of the halfedge is the vertex itself.
  Number place(double b) const { return b < face_.length ? Number(b) : length_; }

  void check_apex(const Certified_window& w, const Exact_image& image, double lateral) const
  {
    const double d = face_.distance_at_apex(w), error = face_.error_at_apex(w, d, lateral);
    const Number off = Reference_distances::absolute(Number(d) - image.distance(apex_));
    CHECK_DETAIL(off <= Number(error), text(off, error));
    const bool is_before = image.side(apex_, place(w.b0)) > Number(0), is_behind = image.side(apex_, place(w.b1)) < Number(0);
    if (is_before || is_behind)
    {
      const Number excess = image.via(place(is_before ? w.b0 : w.b1), apex_) - Number(d);
      CHECK_DETAIL(excess <= Number(error), text(excess, error));
    }
    const double entry = face_.entry_of_apex(w), allowed = face_.error_of_entry(d + error, entry);
    const Planar& a = image.at;
    const Number exact = image.is_parallel ? apex_.x - apex_.y * (a.x / a.y) : a.x + (apex_.x - a.x) * (a.y / (a.y - apex_.y));
    const Number moved = Reference_distances::absolute(Number(entry) - exact);
    CHECK_DETAIL(moved <= Number(allowed), text(moved, allowed));
  }

  // Child with the rays between an end of the interval and `other`, or the apex.
  void check_child(const Certified_window& w, const Exact_image& image, bool to_left, double other, bool to_apex,
                   double lateral) const
  {
    const Edge& edge = to_left ? left_ : right_;
    const double near = to_left ? w.b0 : w.b1;
    Certified_window child{};
    const bool exists =
      to_left ? face_.left_child(w, other, to_apex, lateral, child) : face_.right_child(w, other, to_apex, lateral, child);
    // all rays through the edge are in the child, except for those along the edge
    const Planar next = edge.in_frame(image);
    if (next.y < Number(-3 * w.error_of_image()) * (Number(2) + length_))
      for (const double part : {0., 0.01, 0.5, 0.99, 1.})
      {
        const Number b = place(part == 1. ? other : near + part * (other - near));
        const Planar v = image.ray(b), p = {b - edge.corner.x, Number(0)};
        const Number den = Reference_distances::cross(edge.axis, v), t = edge.position(Reference_distances::cross(p, v) / den);
        const bool is_forward = Reference_distances::cross(p, edge.axis) / den >= Number(0);
        if (!is_forward || t < Number(0) || t >= Number(edge.rounded_length)) continue;
        CHECK(exists);
        if (exists) CHECK_DETAIL(Number(child.b0) <= t && t <= Number(child.b1), text(t, child.b0) + ", " + text(t, child.b1));
      }
    if (!exists) return;
    const Exact_image of_child(child);
    const Planar turned = edge.in_frame(Exact_image(w));
    const Number off = Reference_distances::length({of_child.at.x - turned.x, of_child.at.y - turned.y});
    CHECK_DETAIL(off <= Number(0x1p-97 * (std::abs(w.x) + std::abs(w.y) + 1)), text(off, 0x1p-97));
    for (const double b : {child.b0, child.b1})
    {
      const double d = b == child.b0 ? child.d0 : child.d1, allowed = rounding(d, edge.rounded_length) + child.error_of_image();
      const Planar end = edge.point(b);
      const Number difference = Reference_distances::absolute(Number(d) - Exact_image(w).distance(end));
      CHECK_DETAIL(difference <= Number(allowed), text(difference, allowed));
      // rays beside the interval
      for (const double beside : {near, to_apex ? (to_left ? w.b1 : w.b0) : other})
      {
        const Number side = image.side(end, place(beside));
        if (!((beside == near) == to_left ? side > Number(0) : side < Number(0))) continue;
        const Number excess = image.via(place(beside), end) - image.distance(end);
        CHECK_DETAIL(excess <= Number(child.radius), text(excess, child.radius));
      }
    }
  }

  const Certified_mesh& mesh_;
  const Index h_;
  const CGAL::Geodesic_offset::internal::Certified_propagation face_;
  Number length_;
  Planar apex_, corner_;
  Edge left_, right_;
};

/// At sample points of each window, the envelope has a window with this image up to the tolerance for merging and at least its
/// radius, or one that is nearer beyond all errors.
inline void check_certified_envelope(const std::vector<Certified_window>& windows, double length)
{
  typedef Exact_image::Number Number;
  CGAL::Geodesic_offset::internal::Certified_envelope sweep;
  const auto& envelope = sweep(windows.data(), windows.data() + windows.size(), length);
  for (const Certified_window& w : windows)
    for (const double part : {0., 0.01, 0.3, 0.5, 0.8, 0.99, 1.})
    {
      const double t = part == 1. ? w.b1 : (std::min)(w.b1, w.b0 + part * (w.b1 - w.b0));
      const Exact_image image(w);
      const bool is_represented = std::any_of(envelope.begin(), envelope.end(), [&](const Certified_window& x) {
        if (!(x.b0 <= t && t <= x.b1)) return false;
        const Exact_image other(x);
        const Number off = Reference_distances::length({other.at.x - image.at.x, other.at.y - image.at.y});
        if (other.is_parallel == image.is_parallel && x.radius >= w.radius && off <= Number(0x1p-17 * w.error_of_image()) &&
            Reference_distances::absolute(other.sigma - image.sigma) <= Number(0x1p-17 * w.error_of_image()))
          return true;
        const Number errors = Number(x.radius) + Number(w.radius) + Number(x.error_of_image()) + Number(w.error_of_image());
        return other.distance(t) + errors < image.distance(t);
      });
      CHECK_DETAIL(is_represented, values(t, length));
    }
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_CERTIFIED_STEPS_H
