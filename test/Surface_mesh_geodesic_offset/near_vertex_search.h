// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances from sources at 1e-16 to 1e-6 edge lengths from a vertex or an edge, also of needles, from polylines that turn
// around a vertex of a graded mesh, and from segments beside a vertex, perpendicular to an edge there. Sources are compared with
// the reference of reference_distances.h, polylines on flat convex meshes with distances in the plane.

#ifndef GEODESIC_OFFSET_TEST_NEAR_VERTEX_SEARCH_H
#define GEODESIC_OFFSET_TEST_NEAR_VERTEX_SEARCH_H

#include "field_features.h"
#include "generated_flat_meshes.h"
#include "geodesic_types.h"
#include "locations.h"
#include "reference_distances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Results of the cases of one kind.
struct Near_vertex_counts
{
  std::size_t meshes = 0, queries = 0, wrong = 0, wrong_meshes = 0;
  double worst = 0;      // error relative to distance plus longest edge
  double worst_near = 0; // error relative to distance plus longest edge of the triangle or at the vertex
  double widest_gap = 0; // between neighbouring windows of an edge, relative to distance plus longest edge
};

class Near_vertex_search
{
public:
  typedef Reference_distances::Location Location;

  /// BESIDE: sources beside vertices and edges. AROUND: polylines around vertices of graded meshes. IN_NEEDLES: sources beside
  /// edges of needles. PERPENDICULAR: segments from beside a vertex, perpendicular to an edge there.
  enum Sources { BESIDE, AROUND, IN_NEEDLES, PERPENDICULAR };

  static constexpr double tolerance = 1e-11; // relative to distance plus longest edge

  /// Gaps between windows up to this part of an edge are measured: a lost cone as wide as this gives wrong distances.
  static constexpr double widest_measured_gap = 1e-9;

  /// Writes up to `printed` wrong distances to `log`.
  Near_vertex_search(std::ostream& log, std::size_t printed, std::size_t queries, Sources sources = BESIDE)
    : log_(log), printed_(printed), queries_(queries), sources_(sources)
  {
  }

  /// Runs the case of a seed.
  void run(unsigned seed)
  {
    random_.seed(seed);
    for (int i = 0; i < 8; ++i) random_();
    if (sources_ == AROUND) return run_around(seed);
    if (sources_ == IN_NEEDLES) return run_in_needles(seed);
    if (sources_ == PERPENDICULAR) return run_perpendicular(seed);
    const std::size_t kind = uniform_index(random_, 5);
    const Soup soup = make_mesh(kind, seed);
    const bool is_polyline = kind == 0;
    static const char* const names[5] = {"polylines on flat discs", "flat discs", "cones", "saddles", "bent discs"};
    count_mesh(names[kind], [&](Near_vertex_counts& counts) {
      const Generated_mesh<Surface_mesh> data(soup);
      if (is_polyline) check_polyline(soup, data, counts, seed);
      else check_points(soup, data, counts, seed);
    });
  }

  /// Compares the distances from a polyline with the reference.
  void run(const std::string& name, const Soup& soup, const std::vector<Location>& polyline, bool is_closed)
  {
    const Generated_mesh<Surface_mesh> data(soup);
    Open_geodesic geodesic(data.mesh);
    std::vector<Face_location> locations;
    for (const Location& l : polyline) locations.push_back(location(soup, data, l));
    ++counts_[name].meshes;
    compare_polyline(soup, data, geodesic, locations, is_closed, counts_[name], 0);
  }

  const std::map<std::string, Near_vertex_counts>& counts() const { return counts_; }

  /// Faces with edges of length 100 beside some of 1e-3 to 1. The shortest paths from polylines around vertex 4 to vertex 8 bend at
  /// vertex 6.
  static Soup large_beside_small_faces()
  {
    Soup soup;
    soup.points = {Point_3(0, 0, 0),
                   Point_3(73.6, 59, 0),
                   Point_3(0, 1, 0),
                   Point_3(0.1, 0.057, -0.02),
                   Point_3(0.2, 0.164, -0.065),
                   Point_3(0.04, 0.03, 0),
                   Point_3(0.023, 0.0197, -0.0072),
                   Point_3(0.004, 0.002, 0),
                   Point_3(0.007, 0.002, 0)};
    static const std::array<std::size_t, 3> triangles[] = {{0, 4, 1}, {2, 0, 5}, {0, 2, 6}, {1, 4, 6}, {0, 3, 7},
                                                           {3, 0, 8}, {1, 6, 2}, {4, 0, 6}, {3, 5, 7}, {5, 0, 7}};
    for (const auto& t : triangles) soup.add_triangle(t);
    return soup;
  }

private:
  typedef Geodesic::Face_location Face_location;

  /// Calls check(counts) for a mesh of a kind.
  template <class Check>
  void count_mesh(const std::string& kind, const Check& check)
  {
    Near_vertex_counts& counts = counts_[kind];
    ++counts.meshes;
    const std::size_t before = counts.wrong;
    check(counts);
    counts.wrong_meshes += counts.wrong > before ? 1 : 0;
  }

  void run_around(unsigned seed)
  {
    const std::size_t kind = uniform_index(random_, 5);
    static const char* const names[5] = {"graded discs", "graded cones", "graded saddles", "bent graded discs",
                                         "large beside small"};
    Soup soup = kind == 4 ? changed(large_beside_small_faces()) : make_graded_mesh(kind, seed);
    for (auto& t : soup.triangles) // the first corner is the origin of coordinates in the face
      std::rotate(t.begin(), t.begin() + std::ptrdiff_t(uniform_index(random_, 3)), t.end());
    count_mesh(names[kind], [&](Near_vertex_counts& counts) {
      const Generated_mesh<Surface_mesh> data(soup);
      const auto v = data.vertices[kind == 4 ? 4 : uniform_index(random_, soup.points.size())];
      check_polyline_around(soup, data, v, counts, seed);
    });
  }

  void run_in_needles(unsigned seed)
  {
    const std::size_t kind = uniform_index(random_, 4);
    static const char* const names[4] = {"flat bands of needles", "bent bands of needles", "flat fans of needles",
                                         "bent fans of needles"};
    Soup soup = kind < 2 ? needle_bands(kind == 1) : needle_fan(kind == 3);
    for (auto& t : soup.triangles) std::rotate(t.begin(), t.begin() + std::ptrdiff_t(uniform_index(random_, 3)), t.end());
    count_mesh(names[kind],
               [&](Near_vertex_counts& counts) { check_points(soup, Generated_mesh<Surface_mesh>(soup), counts, seed); });
  }

  /// A bounding ray of the segment runs along the edge, and rays of its end cross the edge far from the vertex. The heights of
  /// almost flat discs are noise.
  void run_perpendicular(unsigned seed)
  {
    const std::size_t kind = uniform_index(random_, 4);
    static const char* const names[4] = {"flat discs", "flat grids", "almost flat discs", "almost flat grids"};
    const std::size_t columns = 1 + uniform_index(random_, 3), rows = 1 + uniform_index(random_, 3);
    // Diagonals by a seed of their own: those of consecutive seeds are alike.
    Soup soup = kind % 2 == 0 ? make_mesh(1, seed)
                              : planar_grid(columns, rows, Diagonals::random, 1, 0, static_cast<unsigned>(random_()));
    const double noise = kind < 2 ? 0 : std::pow(10, uniform(random_, -9, -3));
    for (Point_3& p : soup.points) p = Point_3(p.x(), p.y(), noise * uniform(random_, -1, 1));
    count_mesh(names[kind], [&](Near_vertex_counts& counts) {
      const Generated_mesh<Surface_mesh> data(soup);
      const std::vector<Location> segment = perpendicular_segment(soup);
      if (kind < 2) return compare_polyline_in_plane(soup, data, segment, counts, seed);
      Open_geodesic geodesic(data.mesh);
      compare_polyline(soup, data, geodesic, {location(soup, data, segment[0]), location(soup, data, segment[1])}, false,
                       counts, seed);
    });
  }

  /// Segment in a triangle from a point within 1e-16 to 1e-3 edge lengths of a corner, in a direction within 1e-16 to 1e-2 of
  /// the perpendicular of an edge at this corner.
  std::vector<Location> perpendicular_segment(const Soup& soup)
  {
    for (;;)
    {
      const std::size_t f = uniform_index(random_, soup.triangles.size()), k = uniform_index(random_, 3);
      const std::array<std::size_t, 3>& t = soup.triangles[f];
      std::vector<std::size_t> neighbours;
      for (const auto& s : soup.triangles)
        if (std::count(s.begin(), s.end(), t[k]) != 0)
          for (const std::size_t v : s)
            if (v != t[k]) neighbours.push_back(v);
      const Vector_3 along = soup.points[neighbours[uniform_index(random_, neighbours.size())]] - soup.points[t[k]];
      const Vector_3 a = soup.points[t[1]] - soup.points[t[0]], b = soup.points[t[2]] - soup.points[t[0]];
      const Vector_3 normal = CGAL::cross_product(a, b),
                     across = CGAL::cross_product(normal, along) / std::sqrt(normal.squared_length());
      const double sign = uniform(random_) < 0.5 ? -1 : 1,
                   turn = uniform(random_) < 0.5 ? 0 : std::pow(10, uniform(random_, -16, -2));
      const Vector_3 u = sign * across + turn * uniform(random_, -1, 1) * along;
      const double size = std::pow(10, uniform(random_, -16, -3));
      std::array<double, 3> w;
      w[(k + 1) % 3] = size * uniform(random_);
      w[(k + 2) % 3] = uniform(random_) < 0.2 ? 0 : size * uniform(random_);
      w[k] = 1 - (w[(k + 1) % 3] + w[(k + 2) % 3]);
      // Change of the weights along u.
      const double area = normal.squared_length();
      std::array<double, 3> g;
      g[1] = CGAL::cross_product(u, b) * normal / area;
      g[2] = CGAL::cross_product(a, u) * normal / area;
      g[0] = -(g[1] + g[2]);
      double most = std::numeric_limits<double>::max();
      for (std::size_t i = 0; i < 3; ++i)
        if (g[i] < 0) most = (std::min)(most, -w[i] / g[i]);
      if (!(most > 1e-6)) continue; // leaves the triangle
      const double length =
        most * (uniform(random_) < 0.7 ? uniform(random_, 0.05, 0.95) : std::pow(10, uniform(random_, -5, -1)));
      std::array<double, 3> end;
      for (std::size_t i = 0; i < 3; ++i) end[i] = w[i] + length * g[i];
      return {{f, w}, {f, end}};
    }
  }

  /// Weights within 1e-16 to 1e-2 of a side of a triangle.
  std::array<double, 3> beside_side()
  {
    const std::size_t k = uniform_index(random_, 3);
    const double part = uniform(random_) < 0.7 ? uniform(random_) : std::pow(10, uniform(random_, -8, 0));
    const bool is_first = uniform(random_) < 0.5;
    std::array<double, 3> w;
    w[k] = std::pow(10, uniform(random_, -16, -2));
    w[(k + 1) % 3] = (1 - w[k]) * (is_first ? part : 1 - part);
    w[(k + 2) % 3] = 1 - (w[k] + w[(k + 1) % 3]);
    return w;
  }

  /// Columns of points at distances of 1e-8 to 1e-5, joined by needles of length 1. The outline of flat bands is a rectangle.
  Soup needle_bands(bool is_bent)
  {
    const std::size_t bands = 1 + uniform_index(random_, 4), rows = 1 + uniform_index(random_, 8);
    const double step = std::pow(10, uniform(random_, -8, -5));
    Soup soup;
    for (std::size_t i = 0; i <= bands; ++i)
      for (std::size_t j = 0; j <= rows; ++j)
      {
        const bool is_inside = i > 0 && i < bands;
        const bool is_between = j > 0 && j < rows;
        const double out = is_inside || is_bent ? std::pow(10, uniform(random_, -9, -1)) * (is_bent ? step : 1) : 0;
        const double along = is_between ? uniform(random_, -0.3, 0.3) : 0,
                     height = is_bent ? step * uniform(random_, -0.3, 0.3) : 0;
        soup.points.push_back(Point_3(double(i) + out, step * (double(j) + along), height));
      }
    for (std::size_t i = 0; i < bands; ++i)
      for (std::size_t j = 0; j < rows; ++j)
      {
        const std::size_t a = i * (rows + 1) + j, b = a + rows + 1;
        if (uniform(random_) < 0.5)
        {
          soup.add_triangle({a, b, b + 1});
          soup.add_triangle({a, b + 1, a + 1});
        }
        else
        {
          soup.add_triangle({a, b, a + 1});
          soup.add_triangle({b, b + 1, a + 1});
        }
      }
    return soup;
  }

  /// Needles of length 1 around a corner. Behind their bases, there is a second row, a point at distance 1, or both, or nothing.
  Soup needle_fan(bool is_bent)
  {
    const std::size_t n = 2 + uniform_index(random_, 10), rows = 1 + uniform_index(random_, 2);
    const double step = std::pow(10, uniform(random_, -8, -4)), bend = is_bent ? step : 0;
    Soup soup;
    soup.points.push_back(Point_3(0, 0, 0));
    for (std::size_t i = 1; i <= rows; ++i)
      for (std::size_t j = 0; j <= n; ++j)
      {
        const double r = double(i) * (1 + (uniform(random_) < 0.5 ? 0 : std::pow(10, uniform(random_, -9, -1))));
        const double angle = step * (double(j) + uniform(random_, -0.3, 0.3));
        soup.points.push_back(Point_3(r * std::cos(angle), r * std::sin(angle), bend * uniform(random_, -0.3, 0.3)));
      }
    const std::size_t last = (rows - 1) * (n + 1) + 1, behind = soup.points.size();
    for (std::size_t j = 1; j <= n; ++j) soup.add_triangle({0, j, j + 1});
    for (std::size_t j = 1; j <= n && rows == 2; ++j)
    {
      soup.add_triangle({j, j + n + 1, j + n + 2});
      soup.add_triangle({j, j + n + 2, j + 1});
    }
    if (uniform(random_) < 0.5) return soup;
    soup.points.push_back(Point_3(double(rows) + 1, step * double(n) * uniform(random_), 0));
    for (std::size_t j = last; j < last + n; ++j) soup.add_triangle({j + 1, j, behind});
    return soup;
  }

  /// Moves the points of a mesh by up to a tenth of their coordinates.
  Soup changed(Soup soup)
  {
    const double most = std::pow(10, uniform(random_, -3, -1));
    const auto other = [&](double x) { return x * uniform(random_, 1 - most, 1 + most); };
    for (Point_3& p : soup.points) p = Point_3(other(p.x()), other(p.y()), other(p.z()));
    return soup;
  }

  /// Disc with edges of very different lengths; the height of its points makes it a cone, a saddle, or bends it everywhere.
  Soup make_graded_mesh(std::size_t kind, unsigned seed)
  {
    const double decades = uniform(random_, 0, 6), slope = std::pow(10, uniform(random_, -3, 0.5)),
                 bending =
                   kind == 0 ? 0 : std::pow(10, uniform(random_) < 0.3 ? uniform(random_, -6, -1) : uniform(random_, -1, 0.3));
    const std::size_t number = 7 + uniform_index(random_, uniform(random_) < 0.3 ? 24 : 8),
                      waves = 2 + uniform_index(random_, 2);
    Soup soup = uniform(random_) < 0.3 ? graded_disc(number, decades, bending, seed) : graded_corner(number, bending);
    flip_edges(soup, uniform_index(random_, 3 * number));
    std::vector<Point_3>& points = soup.points;
    for (Point_3& p : points)
    {
      const double r = std::hypot(p.x(), p.y()), angle = std::atan2(p.y(), p.x());
      const double height = kind == 1 ? slope * r : kind == 2 ? slope * r * std::cos(double(waves) * angle) : 0;
      p = Point_3(p.x(), p.y(), p.z() + height);
    }
    return soup;
  }

  /// Square whose triangles are split, mostly at its first corner and near to it: thin triangles, with short edges beside long
  /// ones.
  Soup graded_corner(std::size_t splits, double bending)
  {
    const double weight = std::pow(10, uniform(random_, 0, 1.5));
    std::vector<Point_3> points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0)};
    std::vector<std::array<std::size_t, 3>> triangles = {{0, 1, 2}, {0, 2, 3}};
    for (std::size_t i = 0; i < splits; ++i)
    {
      std::vector<std::size_t> candidates;
      const bool is_at_corner = uniform(random_) < 0.7;
      for (std::size_t f = 0; f < triangles.size(); ++f)
        if (!is_at_corner || std::count(triangles[f].begin(), triangles[f].end(), std::size_t(0))) candidates.push_back(f);
      const std::size_t f = candidates[uniform_index(random_, candidates.size())], v = points.size();
      const std::array<std::size_t, 3> t = triangles[f];
      Vector_3 sum(0, 0, 0);
      double weights = 0;
      for (const std::size_t c : t)
      {
        const double w = uniform(random_, 0.05, 1.05) + (c == 0 ? weight : 0);
        sum = sum + w * (points[c] - CGAL::ORIGIN);
        weights += w;
      }
      points.push_back(CGAL::ORIGIN + sum / weights);
      triangles[f] = {t[0], t[1], v};
      triangles.push_back({t[1], t[2], v});
      triangles.push_back({t[2], t[0], v});
    }
    Soup soup;
    for (const Point_3& p : points)
      soup.points.push_back(Point_3(p.x(), p.y(), bending * std::hypot(p.x(), p.y()) * uniform(random_, -1, 1)));
    for (const auto& t : triangles) soup.add_triangle(t);
    return soup;
  }

  /// Flips random edges whose two triangles form a convex quadrilateral in the plane: long edges at vertices of short ones.
  void flip_edges(Soup& soup, std::size_t attempts)
  {
    const auto is_left_turn = [&](std::size_t p, std::size_t q, std::size_t r) {
      const Point_3 &a = soup.points[p], &b = soup.points[q], &c = soup.points[r];
      const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
      return area > 1e-3 * std::hypot(b.x() - a.x(), b.y() - a.y()) * std::hypot(c.x() - a.x(), c.y() - a.y());
    };
    for (std::size_t i = 0; i < attempts; ++i)
    {
      std::array<std::size_t, 3>& t = soup.triangles[uniform_index(random_, soup.triangles.size())];
      const std::size_t k = uniform_index(random_, 3), a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      for (std::array<std::size_t, 3>& s : soup.triangles)
        for (std::size_t j = 0; j < 3; ++j)
        {
          const std::size_t d = s[(j + 2) % 3];
          if (s[j] != b || s[(j + 1) % 3] != a || !is_left_turn(c, a, d) || !is_left_turn(c, d, b)) continue;
          t = {c, a, d};
          s = {c, d, b};
          j = 3;
        }
    }
  }

  Soup make_mesh(std::size_t kind, unsigned seed)
  {
    if (kind == 2) return Cone(3 + uniform_index(random_, 4), uniform(random_, 2, 6), 1).triangulated(1, 1, seed);
    if (kind == 3) return Cone(8, uniform(random_, 6.5, 12), 1).triangulated(uniform_index(random_, 2), 1, seed);
    const std::size_t inside = 2 + uniform_index(random_, 5), ring = 5 + uniform_index(random_, 4);
    std::vector<Point_2> plane;
    for (std::size_t i = 0; i < ring; ++i)
    {
      const double angle = 2 * CGAL_PI * (double(i) + uniform(random_, 0, 0.7)) / double(ring);
      plane.push_back(Point_2(std::cos(angle), std::sin(angle)));
    }
    for (std::size_t i = 0; i < inside; ++i)
    {
      const double r = uniform(random_, 0, 0.6), angle = uniform(random_, 0, 2 * CGAL_PI);
      plane.push_back(Point_2(r * std::cos(angle), r * std::sin(angle)));
    }
    Soup soup;
    for (const Point_2& p : plane) soup.points.push_back(Point_3(p.x(), p.y(), kind == 4 ? uniform(random_, -0.4, 0.4) : 0));
    for (const auto& t : delaunay_triangles(plane)) soup.add_triangle(t);
    return soup;
  }

  /// 1e-16 to 1e-6.
  double small_size() { return std::pow(10, uniform(random_, -16, -6)); }

  /// Weights with sum 1, within a small size of a corner of a triangle, with the given probability, or of a side.
  std::array<double, 3> near_boundary(double at_corner = 0.7)
  {
    const double size = small_size();
    std::array<double, 3> w;
    const std::size_t k = uniform_index(random_, 3);
    if (uniform(random_) < at_corner)
    {
      w[(k + 1) % 3] = size * uniform(random_, 0, 1);
      w[(k + 2) % 3] = uniform(random_) < 0.2 ? 0 : size * uniform(random_, 0, 1);
    }
    else
    {
      w[(k + 1) % 3] = size;
      w[(k + 2) % 3] = uniform(random_, 0.05, 0.95);
    }
    w[k] = 1 - (w[(k + 1) % 3] + w[(k + 2) % 3]);
    return w;
  }

  std::array<double, 3> anywhere()
  {
    std::array<double, 3> w;
    const std::size_t k = uniform_index(random_, 3);
    const double kind = uniform(random_), a = uniform(random_), b = uniform(random_);
    if (kind < 0.1) return near_boundary();
    w[(k + 1) % 3] = kind < 0.2 ? 0 : kind < 0.35 ? a : (std::min)(a, b);
    w[(k + 2) % 3] = kind < 0.35 ? 0 : 1 - (std::max)(a, b);
    w[k] = 1 - (w[(k + 1) % 3] + w[(k + 2) % 3]);
    return w;
  }

  /// A location in the same triangle, within a small size.
  Location beside(const Location& l)
  {
    const double size = small_size();
    Location result = l;
    const std::size_t k = std::size_t(std::max_element(l.weights.begin(), l.weights.end()) - l.weights.begin());
    for (const std::size_t i : {(k + 1) % 3, (k + 2) % 3})
      result.weights[i] = (std::max)(0., l.weights[i] + size * uniform(random_, -1, 1));
    result.weights[k] = 1 - (result.weights[(k + 1) % 3] + result.weights[(k + 2) % 3]);
    return result;
  }

  /// `sources`: also corners of polylines. An eighth more of the queries is beside them.
  std::vector<Location> make_queries(const Soup& soup, const std::vector<Location>& sources)
  {
    std::vector<Location> result;
    for (std::size_t i = 0; i < queries_; ++i) result.push_back({uniform_index(random_, soup.triangles.size()), anywhere()});
    for (std::size_t i = 0; i < queries_ / 8; ++i) result.push_back(beside(sources[uniform_index(random_, sources.size())]));
    for (std::size_t i = 0; i < queries_ && sources_ == PERPENDICULAR; ++i)
      result.push_back({uniform_index(random_, soup.triangles.size()), beside_side()});
    return result;
  }

  // of the corner with the number k in the triangle
  static Face_location location(const Soup& soup, const Generated_mesh<Surface_mesh>& data, const Location& l)
  {
    return Locations<Surface_mesh>(data.mesh).in_triangle(data, soup, l.triangle, l.weights);
  }

  /// Longest edge of the triangles for which f(triangle) is true.
  template <class Function>
  static double longest_edge(const Soup& soup, const Function& f)
  {
    double result = 0;
    for (const auto& t : soup.triangles)
      for (std::size_t k = 0; k < 3 && f(t); ++k)
        result = (std::max)(result, std::sqrt(CGAL::squared_distance(soup.points[t[k]], soup.points[t[(k + 1) % 3]])));
    return result;
  }

  /// Widest measured gap between the windows of an edge of a face, across their rays, relative to their distance plus `size`.
  static double widest_gap(const Face_field& field, int edge, double size)
  {
    const Point_in_face corner = field.frame().corner(edge), along = field.frame().direction(edge);
    std::vector<Face_window> windows;
    for (const Face_window& w : field.windows())
      if (int(w.origin) == edge) windows.push_back(w);
    const auto place = [&](const Point_in_face& p) { return dot(p - corner, along); };
    std::sort(windows.begin(), windows.end(),
              [&](const Face_window& a, const Face_window& b) { return place(a.left) < place(b.left); });
    const auto sine = [&](const Point_in_face& ray) { return std::abs(cross(along, ray)) / length(ray); };
    double result = 0;
    const Face_window* before = nullptr; // ends last
    for (const Face_window& w : windows)
    {
      if (before)
        if (const double gap = place(w.left) - place(before->right);
            gap > 0 && gap < widest_measured_gap * field.frame().edge_length(edge) && loses_rays(field, *before, w, size))
          result = (std::max)(result,
                              gap * (std::min)(sine(before->right_ray()), sine(w.left_ray())) / (w.distance_at(w.left) + size));
      if (!before || place(w.right) > place(before->right)) before = &w;
    }
    return result;
  }

  /// False if the middle between two windows is as near through another side of the face as their rays would make it.
  static bool loses_rays(const Face_field& field, const Face_window& a, const Face_window& b, double size)
  {
    const Point_in_face middle = 0.5 * (a.right + b.left);
    const auto by = [&](const Face_window& w) {
      const double d = w.distance_at(middle);
      return d < 0 ? std::numeric_limits<double>::infinity() : d; // behind the source
    };
    const double by_rays = (std::min)(by(a), by(b));
    std::size_t nearest;
    return field.distance(middle, nearest) > by_rays + 1e-14 * (by_rays + size);
  }

  /// Compares the distances of queries and vertices with those expected, and measures the gaps between windows.
  template <class Of_query, class Of_vertex>
  void compare(const Soup& soup, const Generated_mesh<Surface_mesh>& data, const Open_geodesic& geodesic,
               const std::vector<Location>& queries, const Of_query& of_query, const Of_vertex& of_vertex,
               Near_vertex_counts& counts, unsigned seed)
  {
    typedef std::array<std::size_t, 3> Triangle;
    const double size = longest_edge(soup, [](const Triangle&) { return true; });
    Face_field field = geodesic.face_field();
    for (const auto f : faces(data.mesh))
    {
      field.set_face(geodesic.field_index(f));
      for (int k = 0; k < 3; ++k) counts.widest_gap = (std::max)(counts.widest_gap, widest_gap(field, k, size));
    }
    for (std::size_t q = 0; q < queries.size(); ++q)
    {
      const Triangle& triangle = soup.triangles[queries[q].triangle];
      const double near = longest_edge(soup, [&](const Triangle& t) { return t == triangle; });
      compare(geodesic.distance_to_sources(location(soup, data, queries[q])), of_query(q), size, near, counts, seed, q);
    }
    for (std::size_t v = 0; v < soup.points.size(); ++v)
    {
      const double near = longest_edge(soup, [v](const Triangle& t) { return t[0] == v || t[1] == v || t[2] == v; });
      compare(geodesic.distance_to_sources(data.vertices[v]), of_vertex(v), size, near, counts, seed, queries.size() + v);
    }
  }

  /// `near`: longest edge next to the point.
  void compare(double distance, double expected, double size, double near, Near_vertex_counts& counts, unsigned seed,
               std::size_t query)
  {
    ++counts.queries;
    const double error = std::abs(distance - expected) / (expected + size);
    if (!(error <= counts.worst)) counts.worst = error;
    counts.worst_near = (std::max)(counts.worst_near, error * (expected + size) / (expected + near));
    if (error <= tolerance) return;
    ++counts.wrong;
    if (printed_ == 0) return;
    --printed_;
    log_.precision(17);
    log_ << "seed " << seed << ", query " << query << ": " << distance << " instead of " << expected << std::endl;
  }

  void check_points(const Soup& soup, const Generated_mesh<Surface_mesh>& data, Near_vertex_counts& counts, unsigned seed)
  {
    std::vector<Location> sources;
    for (std::size_t i = 0, n = 1 + uniform_index(random_, 2); i < n; ++i)
      sources.push_back({uniform_index(random_, soup.triangles.size()), near_boundary(sources_ == IN_NEEDLES ? 0.2 : 0.7)});
    const std::vector<Location> queries = make_queries(soup, sources);
    std::vector<Reference_distances::Point> points;
    for (const Point_3& p : soup.points) points.push_back({p.x(), p.y(), p.z()});
    Reference_distances reference(points, soup.triangles);
    reference.solve({}, sources, queries);
    Open_geodesic geodesic(data.mesh);
    for (const Location& s : sources) geodesic.add_source_point(location(soup, data, s));
    geodesic.build(CGAL::parameters::keep_windows(true));
    compare(
      soup, data, geodesic, queries, [&](std::size_t q) { return double(reference.of_query(q)); },
      [&](std::size_t v) { return double(reference.of_vertex(v)); }, counts, seed);
  }

  /// A polyline in the faces around a vertex: through points of consecutive edges or faces, at 1e-8 to 1 of their length from the
  /// vertex.
  std::vector<Face_location> polyline_around(const Generated_mesh<Surface_mesh>& data, Surface_mesh::Vertex_index v)
  {
    const bool is_equal = uniform(random_) < 0.3, is_on_edges = uniform(random_) < 0.7;
    const double size = std::pow(10, uniform(random_, -8, -0.3));
    std::vector<Face_location> result;
    const Locations<Surface_mesh> locations(data.mesh);
    const auto start = [&] {
      for (auto h : CGAL::halfedges_around_source(v, data.mesh))
        if (data.mesh.is_border(data.mesh.opposite(h))) return h; // the first clockwise
      return data.mesh.opposite(data.mesh.halfedge(v));
    }();
    auto h = start; // leaves v
    do {
      const double t = is_equal               ? size
                     : uniform(random_) < 0.5 ? uniform(random_)
                                              : std::pow(10, uniform(random_, -8, -0.3)),
                   part = uniform(random_);
      if (uniform(random_) < 0.05) result.push_back(locations.at_vertex(v));
      if (data.mesh.is_border(h)) // the last edge
      {
        const auto g = data.mesh.opposite(h);
        result.push_back(locations.on_edge(g, 1 - t));
        break;
      }
      if (is_on_edges || uniform(random_) < 0.5) result.push_back(locations.on_edge(h, t));
      if (!is_on_edges)
      {
        Face_location l(data.mesh.face(h), {0, 0, 0});
        const auto c = locations.corners(l.first);
        for (std::size_t k = 0; k < 3; ++k)
          l.second[k] = c[k] == v ? 1 - t : c[k] == data.mesh.target(h) ? t * part : t * (1 - part);
        // neighbours in one face, or with a point of the edge between
        if (!result.empty() && locations.common_face(result.back(), l) == Surface_mesh::null_face())
          result.push_back(locations.on_edge(h, t));
        result.push_back(l);
      }
      if (uniform(random_) < 0.05) result.push_back(result.back());
      h = data.mesh.opposite(data.mesh.prev(h));
    } while (h != start);
    if (result.size() > 2 && uniform(random_) < 0.4)
    { // a part of it
      const std::size_t first = uniform_index(random_, result.size() - 1);
      result.erase(result.begin(), result.begin() + std::ptrdiff_t(first));
      result.resize(2 + uniform_index(random_, result.size() - 1));
    }
    if (uniform(random_) < 0.5) std::reverse(result.begin(), result.end());
    return result;
  }

  void check_polyline_around(const Soup& soup, const Generated_mesh<Surface_mesh>& data, Surface_mesh::Vertex_index v,
                             Near_vertex_counts& counts, unsigned seed)
  {
    const Locations<Surface_mesh> locations(data.mesh);
    Open_geodesic geodesic(data.mesh);
    std::vector<Face_location> polyline = polyline_around(data, v);
    bool is_closed =
      locations.common_face(polyline.front(), polyline.back()) != Surface_mesh::null_face() && uniform(random_) < 0.6;
    if (uniform(random_) < 0.2)
    { // joined to a point elsewhere
      polyline.push_back(location(soup, data, {uniform_index(random_, soup.triangles.size()), anywhere()}));
      const Geodesic::Polyline joined = geodesic.join_polyline(polyline, CGAL::parameters::is_closed(is_closed));
      polyline = joined.locations;
      is_closed = joined.is_closed;
    }
    compare_polyline(soup, data, geodesic, polyline, is_closed, counts, seed);
  }

  void compare_polyline(const Soup& soup, const Generated_mesh<Surface_mesh>& data, Open_geodesic& geodesic,
                        const std::vector<Face_location>& polyline, bool is_closed, Near_vertex_counts& counts, unsigned seed)
  {
    const Locations<Surface_mesh> locations(data.mesh);
    std::vector<Location> sources;
    std::vector<Reference_distances::Segment> segments;
    const auto of_triangle = [&](Surface_mesh::Face_index f, const std::array<double, 3>& weights) {
      const std::size_t triangle = data.face_numbers.at(f);
      const auto c = locations.corners(f);
      std::array<double, 3> result;
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t j = 0; j < 3; ++j)
          if (data.vertices[soup.triangles[triangle][j]] == c[k]) result[j] = weights[k];
      return Location{triangle, result};
    };
    for (std::size_t i = 0; i < polyline.size(); ++i)
    {
      sources.push_back(of_triangle(polyline[i].first, polyline[i].second));
      if (i + 1 == polyline.size() && !is_closed) break;
      const Face_location &a = polyline[i], &b = polyline[(i + 1) % polyline.size()];
      const auto f = locations.common_face(a, b);
      std::array<double, 3> u, v;
      locations.express(a, f, u);
      locations.express(b, f, v);
      const Location first = of_triangle(f, u), second = of_triangle(f, v);
      segments.push_back({first.triangle, first.weights, second.weights});
    }
    const std::vector<Location> queries = make_queries(soup, sources);
    std::vector<Reference_distances::Point> points;
    for (const Point_3& p : soup.points) points.push_back({p.x(), p.y(), p.z()});
    Reference_distances reference(points, soup.triangles);
    reference.solve({}, sources, queries, segments);
    geodesic.add_source_polyline(polyline, CGAL::parameters::is_closed(is_closed));
    geodesic.build(CGAL::parameters::keep_windows(true));
    compare(
      soup, data, geodesic, queries, [&](std::size_t q) { return double(reference.of_query(q)); },
      [&](std::size_t v) { return double(reference.of_vertex(v)); }, counts, seed);
  }

  struct Planar
  {
    long double x, y;
  };

  static Planar in_plane(const Soup& soup, const Location& l)
  {
    Planar p{0, 0};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point_3& c = soup.points[soup.triangles[l.triangle][k]];
      p.x += static_cast<long double>(l.weights[k]) * c.x();
      p.y += static_cast<long double>(l.weights[k]) * c.y();
    }
    return p;
  }

  static long double distance_to_segment(const Planar& p, const Planar& a, const Planar& b)
  {
    const Planar u{b.x - a.x, b.y - a.y}, v{p.x - a.x, p.y - a.y};
    const long double uu = u.x * u.x + u.y * u.y;
    const long double t = uu == 0 ? 0 : (std::max)(0.L, (std::min)(1.L, (u.x * v.x + u.y * v.y) / uu));
    return std::hypot(v.x - t * u.x, v.y - t * u.y);
  }

  /// Polyline in one triangle, with vertices near its corners and sides between arbitrary ends.
  void check_polyline(const Soup& soup, const Generated_mesh<Surface_mesh>& data, Near_vertex_counts& counts, unsigned seed)
  {
    const std::size_t f = uniform_index(random_, soup.triangles.size());
    std::vector<Location> corners = {{f, anywhere()}};
    for (std::size_t i = 0, n = 1 + uniform_index(random_, 2); i < n; ++i)
    {
      corners.push_back({f, near_boundary()});
      corners.push_back({f, anywhere()});
    }
    compare_polyline_in_plane(soup, data, corners, counts, seed);
  }

  /// `corners`: of a polyline in one triangle of a flat convex mesh.
  void compare_polyline_in_plane(const Soup& soup, const Generated_mesh<Surface_mesh>& data,
                                 const std::vector<Location>& corners, Near_vertex_counts& counts, unsigned seed)
  {
    const std::vector<Location> queries = make_queries(soup, corners);
    std::vector<Face_location> polyline;
    std::vector<Planar> placed;
    for (const Location& c : corners)
    {
      polyline.push_back(location(soup, data, c));
      placed.push_back(in_plane(soup, c));
    }
    Open_geodesic geodesic(data.mesh);
    geodesic.add_source_polyline(polyline);
    geodesic.build(CGAL::parameters::keep_windows(true));
    const auto expected = [&](const Planar& p) {
      long double d = infinity();
      for (std::size_t i = 1; i < placed.size(); ++i) d = (std::min)(d, distance_to_segment(p, placed[i - 1], placed[i]));
      return double(d);
    };
    compare(
      soup, data, geodesic, queries, [&](std::size_t q) { return expected(in_plane(soup, queries[q])); },
      [&](std::size_t v) {
        return expected({soup.points[v].x(), soup.points[v].y()});
      },
      counts, seed);
  }

  static long double infinity() { return std::numeric_limits<long double>::infinity(); }

  std::ostream& log_;
  std::size_t printed_, queries_;
  Sources sources_;
  Random random_;
  std::map<std::string, Near_vertex_counts> counts_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_NEAR_VERTEX_SEARCH_H
