// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Geodesic distances by definition, for small meshes: a reference for certified bounds and other results. It includes no
// header of the package and shares no idea with it.
//
// A shortest path is a sequence of straight pieces between vertices and sources. Each piece crosses a sequence of distinct
// faces and is a straight segment in the plane into which these faces are unfolded. So from each start the search unfolds
// all such sequences with the cone of directions visible through all crossed edges, and records the vertices and query
// points in the cone. Dijkstra's algorithm joins the pieces. From a segment, the directions are a strip perpendicular to it.
//
// Numbers have 113 bits: unfolding is exact to about 1e-32 of the size of the faces.

#ifndef GEODESIC_OFFSET_TEST_REFERENCE_DISTANCES_H
#define GEODESIC_OFFSET_TEST_REFERENCE_DISTANCES_H

#ifndef __SIZEOF_FLOAT128__
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace test {

class Reference_distances
{
public:
#ifdef __SIZEOF_FLOAT128__
  __extension__ typedef __float128 Number;
#else
  typedef boost::multiprecision::cpp_bin_float_quad Number;
#endif
  typedef std::array<double, 3> Point;
  typedef std::array<std::size_t, 3> Triangle;

  /// Point of a triangle by weights of its corners, which are divided by their sum. Zero weights put it on an edge or at a
  /// corner.
  struct Location
  {
    std::size_t triangle;
    std::array<double, 3> weights;
  };

  /// Segment in a triangle, by weights of its ends.
  struct Segment
  {
    std::size_t triangle;
    std::array<double, 3> first, second;
  };

  struct Planar
  {
    Number x, y;
  };

  static constexpr std::size_t no_triangle = std::size_t(-1);

  /// Side from corner k to the next one: the third corner in the plane with the side as x axis, and the adjacent triangle
  /// with the number of its side.
  struct Side
  {
    Number length;
    Planar apex;
    std::pair<std::size_t, int> beyond{no_triangle, 0};
  };

  /// Distance of unreachable vertices.
  static Number infinity() { return Number(std::numeric_limits<double>::max()); }

  /// Newton's iteration from the root in double: 53, 106, 212 bits.
  static Number root(const Number& square)
  {
    if (!(square > Number(0))) return Number(0);
    Number r(std::sqrt(double(square)));
    for (int i = 0; i < 3; ++i) r = (r + square / r) / Number(2);
    return r;
  }

  static Number absolute(const Number& x) { return x < Number(0) ? -x : x; }
  static Number cross(const Planar& a, const Planar& b) { return a.x * b.y - a.y * b.x; }
  static Number length(const Planar& p) { return root(p.x * p.x + p.y * p.y); }

  /// The triangles form a manifold with border and consistent orientation.
  Reference_distances(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
    : Reference_distances(points.size(), triangles)
  {
    for (std::size_t f = 0; f < triangles.size(); ++f)
      for (int k = 0; k < 3; ++k)
      {
        Side& s = sides_[f][k];
        const std::size_t p = triangles[f][k], q = triangles[f][(k + 1) % 3], r = triangles[f][(k + 2) % 3];
        const Vector along = difference(points[q], points[p]), to_apex = difference(points[r], points[p]);
        s.length = root(dot(along, along));
        s.apex = {dot(along, to_apex) / s.length, root(square_of_area(points[p], points[q], points[r])) / s.length};
      }
  }

  /// Overload for triangles by the lengths of their sides, from corner k to the next one. Sums of two lengths minus the third
  /// one are exact if their ratio is less than 2^60.
  Reference_distances(std::size_t number_of_vertices, const std::vector<Triangle>& triangles,
                      const std::vector<std::array<double, 3>>& lengths)
    : Reference_distances(number_of_vertices, triangles)
  {
    for (std::size_t f = 0; f < triangles.size(); ++f)
      for (int k = 0; k < 3; ++k)
      {
        const Number a(lengths[f][k]), b(lengths[f][(k + 1) % 3]), c(lengths[f][(k + 2) % 3]);
        const Number area = root((a + b + c) * (a + b - c) * (b + c - a) * (c + a - b)) / Number(2); // twice the area
        sides_[f][k].length = a;
        sides_[f][k].apex = {(a * a + (c + b) * (c - b)) / (Number(2) * a), area / a};
      }
  }

  /// Computes the distances of all vertices and queries from the nearest source. The ends of `segments` are among the sources.
  void solve(const std::vector<std::size_t>& source_vertices, const std::vector<Location>& sources,
             const std::vector<Location>& queries, const std::vector<Segment>& segments = {})
  {
    queries_.clear();
    for (const Location& q : queries) queries_.push_back({q.triangle, in_plane(q)});
    distances_.assign(number_of_vertices_ + queries.size(), infinity());
    done_.assign(number_of_vertices_, false);
    for (std::size_t v : source_vertices) distances_[v] = 0;
    bound_edges(source_vertices, sources);
    for (const Location& s : sources) leave(s);
    for (const Segment& s : segments) leave(s);
    for (;;)
    {
      std::size_t nearest = number_of_vertices_;
      for (std::size_t v = 0; v < number_of_vertices_; ++v)
        if (!done_[v] && distances_[v] < infinity() && (nearest == number_of_vertices_ || distances_[v] < distances_[nearest]))
          nearest = v;
      if (nearest == number_of_vertices_) return;
      done_[nearest] = true;
      leave(nearest);
    }
  }

  const Number& of_vertex(std::size_t v) const { return distances_[v]; }
  const Number& of_query(std::size_t q) const { return distances_[number_of_vertices_ + q]; }
  const Side& side(std::size_t triangle, int k) const { return sides_[triangle][k]; }
  std::size_t number_of_vertices() const { return number_of_vertices_; }

private:
  // The sides without their shape
  Reference_distances(std::size_t number_of_vertices, const std::vector<Triangle>& triangles)
    : triangles_(triangles), sides_(triangles.size()), number_of_vertices_(number_of_vertices)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, int>> side_of;
    for (std::size_t f = 0; f < triangles.size(); ++f)
      for (int k = 0; k < 3; ++k) side_of[{triangles[f][k], triangles[f][(k + 1) % 3]}] = {f, k};
    for (const auto& [corners, side] : side_of)
    {
      const auto beyond = side_of.find({corners.second, corners.first});
      if (beyond != side_of.end()) sides_[side.first][side.second].beyond = beyond->second;
    }
  }

  typedef std::array<Number, 3> Vector;

  struct Query
  {
    std::size_t triangle;
    std::array<Number, 3> weights;
  };

  static Vector difference(const Point& p, const Point& q)
  {
    return {Number(p[0]) - Number(q[0]), Number(p[1]) - Number(q[1]), Number(p[2]) - Number(q[2])};
  }
  static Number dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

  // Square of twice the area, from the two shortest sides, which lose the fewest digits.
  static Number square_of_area(const Point& p, const Point& q, const Point& r)
  {
    const std::array<Vector, 3> u = {difference(q, p), difference(r, q), difference(p, r)};
    int longest = 0;
    for (int k : {1, 2})
      if (dot(u[k], u[k]) > dot(u[longest], u[longest])) longest = k;
    const Vector &a = u[(longest + 1) % 3], &b = u[(longest + 2) % 3];
    const Vector n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    return dot(n, n);
  }

  static std::array<Number, 3> in_plane(const Location& l)
  {
    const Number sum = Number(l.weights[0]) + Number(l.weights[1]) + Number(l.weights[2]);
    return {Number(l.weights[0]) / sum, Number(l.weights[1]) / sum, Number(l.weights[2]) / sum};
  }

  // Corners of a triangle whose side k runs from a to b.
  std::array<Planar, 3> placed(std::size_t triangle, int k, const Planar& a, const Planar& b) const
  {
    const Side& s = sides_[triangle][k];
    const Planar u = {(b.x - a.x) / s.length, (b.y - a.y) / s.length};
    std::array<Planar, 3> corners;
    corners[k] = a;
    corners[(k + 1) % 3] = b;
    corners[(k + 2) % 3] = {a.x + s.apex.x * u.x - s.apex.y * u.y, a.y + s.apex.x * u.y + s.apex.y * u.x};
    return corners;
  }

  static Planar at(const std::array<Planar, 3>& corners, const std::array<Number, 3>& weights)
  {
    return {weights[0] * corners[0].x + weights[1] * corners[1].x + weights[2] * corners[2].x,
            weights[0] * corners[0].y + weights[1] * corners[1].y + weights[2] * corners[2].y};
  }

  // Paths along edges: upper bounds that terminate the search.
  void bound_edges(const std::vector<std::size_t>& source_vertices, const std::vector<Location>& sources)
  {
    bounds_.assign(number_of_vertices_, infinity());
    for (std::size_t v : source_vertices) bounds_[v] = 0;
    for (const Location& s : sources)
      for (int k = 0; k < 3; ++k)
      { // no farther than via the longer side at the corner
        const Number d = (std::max)(sides_[s.triangle][k].length, sides_[s.triangle][(k + 2) % 3].length);
        lower(bounds_[triangles_[s.triangle][k]], d);
      }
    for (bool changed = true; changed;)
    {
      changed = false;
      for (std::size_t f = 0; f < triangles_.size(); ++f)
        for (int k = 0; k < 3; ++k)
        {
          const std::size_t p = triangles_[f][k], q = triangles_[f][(k + 1) % 3];
          const Number& l = sides_[f][k].length;
          changed |= lower(bounds_[q], bounds_[p] + l);
          changed |= lower(bounds_[p], bounds_[q] + l);
        }
    }
    farthest_ = 0;
    for (const Number& b : bounds_)
      if (b < infinity()) farthest_ = (std::max)(farthest_, b);
    Number longest = 0; // for queries
    for (const auto& f : sides_)
      for (const Side& s : f) longest = (std::max)(longest, s.length);
    if (!queries_.empty()) farthest_ += longest;
  }

  static bool lower(Number& x, const Number& y)
  {
    if (!(y < x)) return false;
    x = y;
    return true;
  }

  // Straight pieces from a vertex.
  void leave(std::size_t v)
  {
    start_ = distances_[v];
    visited_.assign(triangles_.size(), false);
    for (std::size_t f = 0; f < triangles_.size(); ++f)
      for (int k = 0; k < 3; ++k)
        if (triangles_[f][k] == v)
        {
          const Planar zero = {0, 0}, a = {sides_[f][k].length, 0};
          start_in(f, placed(f, k, zero, a), 1u << (k + 1) % 3);
        }
  }

  // Straight pieces from a source, into its triangle and adjacent triangles of edges that contain it.
  void leave(const Location& s)
  {
    start_ = 0;
    visited_.assign(triangles_.size(), false);
    const std::array<Number, 3> weights = in_plane(s);
    unsigned exits = 0;
    for (int k = 0; k < 3; ++k)
      if (weights[(k + 2) % 3] != Number(0)) exits |= 1u << k;
      else if (sides_[s.triangle][k].beyond.first != no_triangle)
      {
        const auto [f, side] = sides_[s.triangle][k].beyond;
        std::array<Number, 3> seen_from_there = {0, 0, 0};
        seen_from_there[side] = weights[(k + 1) % 3];
        seen_from_there[(side + 1) % 3] = weights[k];
        start_around(f, seen_from_there, 7u ^ 1u << side);
      }
    start_around(s.triangle, weights, exits);
  }

  // From a point of a triangle through its sides in `exits`.
  void start_around(std::size_t f, const std::array<Number, 3>& weights, unsigned exits)
  {
    std::array<Planar, 3> corners = placed(f, 0, {0, 0}, {sides_[f][0].length, 0});
    // from the nearest corner: other corners are far away in graded triangles
    const int near = int(std::max_element(weights.begin(), weights.end()) - weights.begin());
    const std::array<Number, 3>& w = weights;
    const int p = (near + 1) % 3, q = (near + 2) % 3;
    corners = placed(f, near, {0, 0}, {sides_[f][near].length, 0});
    const Planar s = {w[p] * corners[p].x + w[q] * corners[q].x, w[p] * corners[p].y + w[q] * corners[q].y};
    for (Planar& c : corners) c = {c.x - s.x, c.y - s.y};
    start_in(f, corners, exits);
  }

  // A triangle that contains the start, which is the origin.
  void start_in(std::size_t f, const std::array<Planar, 3>& corners, unsigned exits)
  {
    for (int k = 0; k < 3; ++k) lower(distances_[triangles_[f][k]], start_ + length(corners[k]));
    for (std::size_t q = 0; q < queries_.size(); ++q)
      if (queries_[q].triangle == f)
        lower(distances_[number_of_vertices_ + q], start_ + length(at(corners, queries_[q].weights)));
    visited_[f] = true;
    for (int k = 0; k < 3; ++k)
      if (exits & 1u << k) cross_side(f, k, corners[k], corners[(k + 1) % 3], corners[k], corners[(k + 1) % 3]);
    visited_[f] = false;
  }

  Number perimeter(std::size_t f) const { return sides_[f][0].length + sides_[f][1].length + sides_[f][2].length; }

  // Straight pieces from inside a segment, to both sides.
  void leave(const Segment& s)
  {
    start_ = 0;
    rounding_of_strip_ = Number(1e-33) * perimeter(s.triangle);
    visited_.assign(triangles_.size(), false);
    const std::array<Number, 3> first = in_plane({s.triangle, s.first}), second = in_plane({s.triangle, s.second});
    const std::array<Planar, 3> corners = placed(s.triangle, 0, {0, 0}, {sides_[s.triangle][0].length, 0});
    for (const bool is_reversed : {false, true})
    {
      const Planar a = at(corners, is_reversed ? second : first), b = at(corners, is_reversed ? first : second);
      Planar along = {b.x - a.x, b.y - a.y};
      const Number size = length(along);
      if (!(size > Number(0))) continue;
      along = {along.x / size, along.y / size};
      // with the segment on the x axis, from the origin; the pieces have the direction of the y axis
      const auto turned = [&](const Planar& p) {
        const Planar u = {p.x - a.x, p.y - a.y};
        return Planar{u.x * along.x + u.y * along.y, cross(along, u)};
      };
      std::array<Planar, 3> c;
      for (int k = 0; k < 3; ++k) c[k] = turned(corners[k]);
      reach_in_strip(s.triangle, c, Number(0), size);
      visited_[s.triangle] = true;
      for (int k = 0; k < 3; ++k) cross_side_in_strip(s.triangle, k, c[k], c[(k + 1) % 3], Number(0), size);
      visited_[s.triangle] = false;
    }
  }

  // Corners and queries of a triangle in the strip [low, high] x [0, infinity), which includes points on the segment up to 1e-30 of
  // the sides of the triangle, or to the rounding of those of the segment's triangle.
  void reach_in_strip(std::size_t f, const std::array<Planar, 3>& corners, const Number& low, const Number& high)
  {
    const Number rounding = (std::max)(Number(1e-30) * perimeter(f), rounding_of_strip_);
    const auto reach = [&](const Planar& p, Number& distance) {
      if (low <= p.x && p.x <= high && p.y >= -rounding) lower(distance, (std::max)(p.y, Number(0)));
    };
    for (int k = 0; k < 3; ++k) reach(corners[k], distances_[triangles_[f][k]]);
    for (std::size_t q = 0; q < queries_.size(); ++q)
      if (queries_[q].triangle == f) reach(at(corners, queries_[q].weights), distances_[number_of_vertices_ + q]);
  }

  // Crosses side k, which runs from a to b, within the strip. The pieces cross it outward if b is on the left of a.
  void cross_side_in_strip(std::size_t from, int k, const Planar& a, const Planar& b, Number low, Number high)
  {
    low = (std::max)(low, b.x);
    high = (std::min)(high, a.x);
    const auto [f, side] = sides_[from][k].beyond;
    if (!(low < high) || f == no_triangle || visited_[f] || (std::min)(a.y, b.y) > farthest_) return;
    const std::array<Planar, 3> corners = placed(f, side, b, a);
    const Planar& c = corners[(side + 2) % 3];
    reach_in_strip(f, corners, low, high);
    visited_[f] = true;
    cross_side_in_strip(f, (side + 1) % 3, a, c, low, high);
    cross_side_in_strip(f, (side + 2) % 3, c, b, low, high);
    visited_[f] = false;
  }

  // Crosses side k, which runs from a to b counterclockwise around the origin, within the cone from `right` to `left`.
  void cross_side(std::size_t from, int k, const Planar& a, const Planar& b, const Planar& right, const Planar& left)
  {
    const auto [f, side] = sides_[from][k].beyond;
    if (f == no_triangle || visited_[f] || !(cross(right, left) > Number(0))) return;
    if (start_ + distance_of_line(a, b) > farthest_) return;
    const std::array<Planar, 3> corners = placed(f, side, b, a);
    const Planar& c = corners[(side + 2) % 3];
    const bool is_left_of_right = is_to_the_left(right, c), is_right_of_left = is_to_the_left(c, left);
    if (is_left_of_right && is_right_of_left) lower(distances_[triangles_[f][(side + 2) % 3]], start_ + length(c));
    for (std::size_t q = 0; q < queries_.size(); ++q)
      if (queries_[q].triangle == f)
      {
        const Planar p = at(corners, queries_[q].weights);
        if (is_to_the_left(right, p) && is_to_the_left(p, left)) lower(distances_[number_of_vertices_ + q], start_ + length(p));
      }
    visited_[f] = true;
    const bool is_inside = is_left_of_right && is_right_of_left;
    if (is_left_of_right) cross_side(f, (side + 1) % 3, a, c, right, is_inside ? c : left);
    if (is_right_of_left) cross_side(f, (side + 2) % 3, c, b, is_inside ? c : right, left);
    visited_[f] = false;
  }

  // Whether b is to the left of the ray to a, or on it up to 1e-30 of the ray's length; then a path via a point of the ray
  // is as long.
  static bool is_to_the_left(const Planar& a, const Planar& b)
  {
    const Number p = a.x * b.y, q = a.y * b.x;
    return p - q >= Number(-1e-30) * (absolute(p) + absolute(q));
  }

  // Distance of the origin from the segment from a to b.
  static Number distance_of_line(const Planar& a, const Planar& b)
  {
    const Planar u = {b.x - a.x, b.y - a.y};
    const Number l = length(u), t = -(a.x * u.x + a.y * u.y);
    if (t <= Number(0)) return length(a);
    if (t >= l * l) return length(b);
    return absolute(cross(a, u)) / l;
  }

  std::vector<Triangle> triangles_;
  std::vector<std::array<Side, 3>> sides_;
  std::size_t number_of_vertices_;
  std::vector<Query> queries_;
  std::vector<Number> distances_, bounds_; // of vertices, followed by those of queries
  std::vector<bool> done_, visited_;
  Number farthest_ = 0, start_ = 0, rounding_of_strip_ = 0;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_REFERENCE_DISTANCES_H
