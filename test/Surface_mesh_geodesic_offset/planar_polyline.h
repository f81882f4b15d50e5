// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Polylines on a flat convex mesh, with the signed distance in closed form.

#ifndef GEODESIC_OFFSET_TEST_PLANAR_POLYLINE_H
#define GEODESIC_OFFSET_TEST_PLANAR_POLYLINE_H

#include "flat_paths.h"
#include "generated_meshes.h"
#include "offset_tools.h"

#include <map>
#include <utility>
#include <vector>

namespace test {

/// Flat convex mesh with points of the plane as locations.
class Planar_mesh
{
public:
  typedef Generated_mesh<test::Surface_mesh> Data;
  typedef Flat_path<test::Surface_mesh> Path;

  explicit Planar_mesh(const Soup& soup, unsigned seed = 1) : data(soup), generator(data, seed) {}

  /// Location of a point of the plane; exactly at a vertex or on an edge if the point is.
  Face_location location(const Point_2& p) const
  {
    Face_location best;
    double largest = -1e300;
    for (std::size_t i = 0; i < data.faces.size(); ++i)
    {
      const std::array<Point_2, 3>& c = data.uv[i];
      std::array<double, 3> w;
      const double all = area(c[0], c[1], c[2]);
      for (std::size_t k = 0; k < 3; ++k) w[k] = area(p, c[(k + 1) % 3], c[(k + 2) % 3]) / all;
      const double smallest = (std::min)(w[0], (std::min)(w[1], w[2]));
      if (smallest > largest)
      {
        largest = smallest;
        for (double& x : w)
          if (std::abs(x) < 1e-14) x = 0;
        best = Face_location(data.faces[i], w);
      }
    }
    return best;
  }

  Point_2 uv(const Face_location& l) const { return generator.uv(l, 0); }

  /// Polyline through points of the plane, with a location at each intersection with an edge or a vertex, and its legs. A
  /// closed polyline does not repeat its first location.
  Path path(const std::vector<Point_2>& points, bool closed) const
  {
    Path result;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      result.locations.push_back(location(points[i]));
      if (i + 1 == n && !closed) break;
      add_between(points[i], points[(i + 1) % n], result.locations);
      result.legs.push_back(Leg{0, points[i], points[(i + 1) % n]});
    }
    return result;
  }

  std::size_t add(Geodesic& geodesic, const std::vector<Point_2>& points, bool closed = false) const
  {
    return geodesic.add_source_polyline(path(points, closed).locations, CGAL::parameters::is_closed(closed));
  }

  /// The field of polylines.
  Geodesic field(const std::vector<std::vector<Point_2>>& lines, bool closed = false) const
  {
    Geodesic result(data.mesh);
    for (const auto& line : lines) add(result, line, closed);
    result.build(CGAL::parameters::keep_windows(true));
    return result;
  }

  Data data;
  Flat_path_generator<test::Surface_mesh> generator;

private:
  // Intersections of the leg from a to b with vertices and edges.
  void add_between(const Point_2& a, const Point_2& b, std::vector<Face_location>& out) const
  {
    std::vector<std::pair<double, Face_location>> met;
    const auto add = [&](const Point_2& p, const Face_location& l) {
      const double t = ((p - a) * (b - a)) / (b - a).squared_length();
      if (t > 1e-12 && t < 1 - 1e-12) met.push_back({t, l});
    };
    const auto& on_mesh = generator.locations();
    std::map<test::Surface_mesh::Vertex_index, Point_2> place;
    for (auto v : data.vertices)
    {
      const Point_2 p = place[v] = uv(on_mesh.at_vertex(v));
      if (CGAL::orientation(a, b, p) == CGAL::COLLINEAR) add(p, on_mesh.at_vertex(v));
    }
    for (auto e : edges(data.mesh))
    {
      auto h = data.mesh.halfedge(e);
      if (data.mesh.is_border(h)) h = data.mesh.opposite(h);
      const Point_2 p = place[source(h, data.mesh)], q = place[target(h, data.mesh)];
      if (CGAL::orientation(a, b, p) * CGAL::orientation(a, b, q) >= 0) continue;
      const double dp = area(a, b, p), dq = area(a, b, q), t = dp / (dp - dq);
      if (t > 1e-12 && t < 1 - 1e-12) add(p + t * (q - p), on_mesh.on_edge(h, t));
    }
    std::sort(met.begin(), met.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    for (const auto& m : met) out.push_back(m.second);
  }

  static double area(const Point_2& a, const Point_2& b, const Point_2& c)
  {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  }
};

/// Signed distance from legs in the plane: each leg starts at the end of the previous one.
struct Signed_distance
{
  enum Side { LEFT = 1, RIGHT = 2, CAP = 3 };

  explicit Signed_distance(const std::vector<Leg>& legs, bool closed) : legs(legs), closed(closed) {}

  /// Distance and side. The side is 0 if the nearest source points of two sides are equally far within the margin, or p is
  /// on a line between two sides.
  std::pair<double, int> operator()(const Point_2& p, double margin) const
  {
    std::vector<std::pair<double, int>> candidates;
    double smallest = 1e300;
    const auto add = [&](double d, int side) {
      candidates.push_back({d, side});
      smallest = (std::min)(smallest, d);
    };
    const std::size_t n = legs.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const Point_2 &a = legs[i].a, &b = legs[i].b;
      const double l = distance(a, b);
      const double t = ((p - a) * (b - a)) / l;
      const double height = cross(b - a, p - a) / l;
      if (t > 0 && t < l) add(std::abs(height), std::abs(height) <= margin ? 0 : height > 0 ? LEFT : RIGHT);
      if (closed || i > 0) add(distance(p, a), side_at_joint(p, legs[(i + n - 1) % n], legs[i]));
      else add(distance(p, a), std::abs(t) <= margin ? 0 : CAP);
      if (!closed && i + 1 == n) add(distance(p, b), std::abs(t - l) <= margin ? 0 : CAP);
    }
    int side = smallest <= margin ? 0 : -1;
    for (const auto& c : candidates)
      if (c.first <= smallest + margin) side = side == -1 || side == c.second ? c.second : 0;
    return {smallest, side};
  }

  std::vector<Leg> legs;
  bool closed;

private:
  static double cross(const Vector_2& a, const Vector_2& b) { return a.x() * b.y() - a.y() * b.x(); }

  // Shortest paths end at a joint only on its reflex side.
  static int side_at_joint(const Point_2& p, const Leg& in, const Leg& out)
  {
    const Vector_2 u = in.b - in.a, v = out.b - out.a;
    const double turn = cross(u, v);
    if (std::abs(turn) <= 1e-12 * std::sqrt(u.squared_length() * v.squared_length()))
      return u * v < 0 ? 0 : cross(v, p - out.a) > 0 ? LEFT : RIGHT; // reversal, or straight
    return turn < 0 ? LEFT : RIGHT;
  }
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_PLANAR_POLYLINE_H
