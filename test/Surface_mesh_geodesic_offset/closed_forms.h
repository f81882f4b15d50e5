// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Closed forms of the distance from a point of a flat patch to a straight leg of a source.

#ifndef GEODESIC_OFFSET_TEST_CLOSED_FORMS_H
#define GEODESIC_OFFSET_TEST_CLOSED_FORMS_H

#include "generated_flat_meshes.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace test {

/// Straight segment in the plane of a patch; a point if its length is zero.
struct Leg
{
  std::size_t patch;
  Point_2 a, b;
};

inline double distance(const Point_2& p, const Point_2& q) { return std::hypot(p.x() - q.x(), p.y() - q.y()); }

/// Parameter in (0, 1) of the foot of p on the line through a leg, or -1 if the foot is not inside the leg.
inline double inner_foot(const Point_2& p, const Point_2& a, const Point_2& b)
{
  if (a == b) return -1;
  const double t = ((p - a) * (b - a)) / (b - a).squared_length();
  return (t > 0 && t < 1) ? t : -1;
}

inline double segment_distance(const Point_2& p, const Point_2& a, const Point_2& b)
{
  if (inner_foot(p, a, b) < 0) return (std::min)(distance(p, a), distance(p, b));
  const Vector_2 d = b - a, v = p - a;
  return std::abs(d.x() * v.y() - d.y() * v.x()) / std::hypot(d.x(), d.y());
}

/// Convex flat region.
struct Plane_distance
{
  double operator()(std::size_t, const Point_2& p, const Leg& leg) const { return segment_distance(p, leg.a, leg.b); }
};

/// The L of `l_shape`: straight paths, or paths around its reflex corner, from which every point is visible.
struct L_shape_distance
{
  double operator()(std::size_t, const Point_2& p, const Leg& leg) const
  {
    const Point_2 corner(1, 1);
    double result = distance(p, corner) + segment_distance(corner, leg.a, leg.b);
    const double t = inner_foot(p, leg.a, leg.b);
    if (t > 0 && sees(p, leg.a + t * (leg.b - leg.a))) result = (std::min)(result, segment_distance(p, leg.a, leg.b));
    for (const Point_2& end : {leg.a, leg.b})
      if (sees(p, end)) result = (std::min)(result, distance(p, end));
    return result;
  }

private:
  static bool sees(const Point_2& p, const Point_2& q)
  {
    const Point_2 corner(1, 1);
    if (p.x() > 1 && q.y() > 1) return CGAL::orientation(p, q, corner) == CGAL::RIGHT_TURN;
    if (q.x() > 1 && p.y() > 1) return CGAL::orientation(q, p, corner) == CGAL::RIGHT_TURN;
    return true;
  }
};

/// Lateral surface of a prism: the plane modulo its period.
struct Prism_distance
{
  explicit Prism_distance(const Prism& prism) : period(prism.period()) {}

  double operator()(std::size_t, const Point_2& p, const Leg& leg) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (int turn = -1; turn <= 1; ++turn)
      result = (std::min)(result, segment_distance(Point_2(p.x() + turn * period, p.y()), leg.a, leg.b));
    return result;
  }

  double period;
};

/// The cone of a `Cone`: straight in the unfolding if the angle between the points is below pi, otherwise through the apex.
struct Cone_distance
{
  explicit Cone_distance(const Cone& cone) : cone(cone) {}

  double operator()(std::size_t patch, const Point_2& p, const Leg& leg) const
  {
    const double radius = std::hypot(p.x(), p.y());
    double result = radius + segment_distance(Point_2(0, 0), leg.a, leg.b);
    const int turns = cone.is_open ? 0 : 1;
    for (int turn = -turns; turn <= turns; ++turn)
    {
      // The target in the plane of the leg's patch, after a turn around the apex by `angle`.
      const double sectors = static_cast<double>(patch) - static_cast<double>(leg.patch);
      const double angle = std::atan2(p.y(), p.x()) + sectors * cone.sector_angle() + turn * cone.total_angle;
      const Point_2 image(radius * std::cos(angle), radius * std::sin(angle));
      const double t = inner_foot(image, leg.a, leg.b);
      if (t > 0 && is_straight(angle, leg.a + t * (leg.b - leg.a)))
        result = (std::min)(result, segment_distance(image, leg.a, leg.b));
      for (const Point_2& end : {leg.a, leg.b})
        if (is_straight(angle, end)) result = (std::min)(result, distance(image, end));
    }
    return result;
  }

  static bool is_straight(double angle, const Point_2& q) { return std::abs(angle - std::atan2(q.y(), q.x())) < CGAL_PI; }

  Cone cone;
};

/// Boundary of a convex polyhedron: all unfoldings along sequences of distinct sides (a shortest path meets each side at
/// most once), with the straight lines that stay inside their sequence.
class Polyhedron_distance
{
public:
  explicit Polyhedron_distance(const Polyhedron_sides& polyhedron) : polyhedron_(polyhedron)
  {
    const std::size_t count = polyhedron.sides.size();
    for (std::size_t i = 0; i < count; ++i) uv_.push_back(polyhedron.uv(i));
    unfoldings_.resize(count * count);
    for (std::size_t i = 0; i < count; ++i)
    {
      std::vector<bool> visited(count, false);
      visited[i] = true;
      Unfolding start{{1, 0}, {0, 0}, {}};
      unfold(i, i, start, visited);
    }
  }

  double operator()(std::size_t patch, const Point_2& p, const Leg& leg) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (const Unfolding& unfolding : unfoldings_[leg.patch * uv_.size() + patch])
    {
      const Point_2 image = unfolding.image(p);
      const double t = inner_foot(image, leg.a, leg.b);
      if (t > 0 && unfolding.contains(leg.a + t * (leg.b - leg.a), image))
        result = (std::min)(result, segment_distance(image, leg.a, leg.b));
      for (const Point_2& end : {leg.a, leg.b})
        if (unfolding.contains(end, image)) result = (std::min)(result, distance(image, end));
    }
    return result;
  }

private:
  // Maps p to rotation * p + shift (complex numbers); the path crosses `doors` in this order.
  struct Unfolding
  {
    Vector_2 rotation, shift;
    std::vector<std::pair<Point_2, Point_2>> doors; // right end, left end

    Point_2 image(const Point_2& p) const
    {
      return Point_2(rotation.x() * p.x() - rotation.y() * p.y() + shift.x(),
                     rotation.x() * p.y() + rotation.y() * p.x() + shift.y());
    }

    // Whether the segment from q to p passes through all doors (ends included, up to rounding).
    bool contains(const Point_2& q, const Point_2& p) const
    {
      const Vector_2 d = p - q;
      for (const std::pair<Point_2, Point_2>& door : doors)
      {
        const Vector_2 right = door.first - q, left = door.second - q;
        if (d.x() * right.y() - d.y() * right.x() > 1e-14 || d.x() * left.y() - d.y() * left.x() < -1e-14) return false;
      }
      return true;
    }
  };

  void unfold(std::size_t start, std::size_t side, const Unfolding& unfolding, std::vector<bool>& visited)
  {
    unfoldings_[start * uv_.size() + side].push_back(unfolding);
    const std::vector<std::size_t>& corners = polyhedron_.sides[side];
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const std::size_t c0 = corners[i], c1 = corners[(i + 1) % corners.size()];
      for (std::size_t other = 0; other < uv_.size(); ++other)
      {
        const std::vector<std::size_t>& others = polyhedron_.sides[other];
        for (std::size_t j = 0; j < others.size() && !visited[other]; ++j)
          if (others[j] == c1 && others[(j + 1) % others.size()] == c0)
          {
            const Point_2 p0 = unfolding.image(uv_[side][i]);
            const Point_2 p1 = unfolding.image(uv_[side][(i + 1) % corners.size()]);
            const Point_2 q1 = uv_[other][j], q0 = uv_[other][(j + 1) % others.size()];
            Unfolding further = unfolding;
            const Vector_2 p = p1 - p0, q = q1 - q0;
            const double length = q.squared_length();
            further.rotation = Vector_2((p.x() * q.x() + p.y() * q.y()) / length, (p.y() * q.x() - p.x() * q.y()) / length);
            further.shift = Vector_2(0, 0);
            further.shift = p0 - further.image(q0);
            further.doors.push_back({p0, p1}); // sides are counterclockwise: seen from inside, p0 is on the right
            visited[other] = true;
            unfold(start, other, further, visited);
            visited[other] = false;
            break;
          }
      }
    }
  }

  Polyhedron_sides polyhedron_;
  std::vector<std::vector<Point_2>> uv_;
  std::vector<std::vector<Unfolding>> unfoldings_; // [start side * number of sides + end side]
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_CLOSED_FORMS_H
