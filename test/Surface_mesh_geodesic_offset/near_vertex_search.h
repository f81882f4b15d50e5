// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances from sources at 1e-16 to 1e-6 edge lengths from a vertex or an edge. Point sources are compared with the
// reference of reference_distances.h, polylines on flat convex meshes with distances in the plane.

#ifndef GEODESIC_OFFSET_TEST_NEAR_VERTEX_SEARCH_H
#define GEODESIC_OFFSET_TEST_NEAR_VERTEX_SEARCH_H

#include "generated_flat_meshes.h"
#include "geodesic_types.h"
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
  double worst = 0; // error relative to distance plus longest edge
};

class Near_vertex_search
{
public:
  typedef Reference_distances::Location Location;

  static constexpr double tolerance = 1e-11; // relative to distance plus longest edge

  /// Writes up to `printed` wrong distances to `log`.
  Near_vertex_search(std::ostream& log, std::size_t printed, std::size_t queries)
    : log_(log), printed_(printed), queries_(queries)
  {}

  /// Runs the case of a seed.
  void run(unsigned seed)
  {
    random_.seed(seed);
    for (int i = 0; i < 8; ++i) random_();
    const std::size_t kind = uniform_index(random_, 5);
    const Soup soup = make_mesh(kind, seed);
    const bool is_polyline = kind == 0;
    static const char* const names[5] = {"polylines on flat discs", "flat discs", "cones", "saddles", "bent discs"};
    Near_vertex_counts& counts = counts_[names[kind]];
    ++counts.meshes;
    const std::size_t before = counts.wrong;
    const Generated_mesh<Surface_mesh> data(soup);
    if (is_polyline) check_polyline(soup, data, counts, seed);
    else check_points(soup, data, counts, seed);
    counts.wrong_meshes += counts.wrong > before ? 1 : 0;
  }

  const std::map<std::string, Near_vertex_counts>& counts() const { return counts_; }

private:
  typedef Geodesic::Face_location Face_location;

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
    for (const Point_2& p : plane)
      soup.points.push_back(Point_3(p.x(), p.y(), kind == 4 ? uniform(random_, -0.4, 0.4) : 0));
    for (const auto& t : delaunay_triangles(plane)) soup.add_triangle(t);
    return soup;
  }

  /// 1e-16 to 1e-6.
  double small_size() { return std::pow(10, uniform(random_, -16, -6)); }

  /// Weights with sum 1, within a small size of a corner or a side of a triangle.
  std::array<double, 3> near_boundary()
  {
    const double size = small_size();
    std::array<double, 3> w;
    const std::size_t k = uniform_index(random_, 3);
    if (uniform(random_) < 0.7)
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
    for (std::size_t i = 0; i < queries_; ++i)
      result.push_back({uniform_index(random_, soup.triangles.size()), anywhere()});
    for (std::size_t i = 0; i < queries_ / 8; ++i) result.push_back(beside(sources[uniform_index(random_, sources.size())]));
    return result;
  }

  // of the corner with the number k in the triangle
  static Face_location location(const Soup& soup, const Generated_mesh<Surface_mesh>& data, const Location& l)
  {
    const auto f = data.faces[l.triangle];
    Face_location result(f, {0, 0, 0});
    auto h = halfedge(f, data.mesh);
    for (std::size_t i = 0; i < 3; ++i, h = next(h, data.mesh))
      for (std::size_t k = 0; k < 3; ++k)
        if (data.vertices[soup.triangles[l.triangle][k]] == source(h, data.mesh)) result.second[i] = l.weights[k];
    return result;
  }

  static double longest_edge(const Soup& soup)
  {
    double result = 0;
    for (const auto& t : soup.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        result = (std::max)(result, std::sqrt(CGAL::squared_distance(soup.points[t[k]], soup.points[t[(k + 1) % 3]])));
    return result;
  }

  void compare(double distance, double expected, double size, Near_vertex_counts& counts, unsigned seed, std::size_t query)
  {
    ++counts.queries;
    const double error = std::abs(distance - expected) / (expected + size);
    if (!(error <= counts.worst)) counts.worst = error;
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
      sources.push_back({uniform_index(random_, soup.triangles.size()), near_boundary()});
    const std::vector<Location> queries = make_queries(soup, sources);
    std::vector<Reference_distances::Point> points;
    for (const Point_3& p : soup.points) points.push_back({p.x(), p.y(), p.z()});
    Reference_distances reference(points, soup.triangles);
    reference.solve({}, sources, queries);
    Geodesic geodesic(data.mesh);
    for (const Location& s : sources) geodesic.add_source_point(location(soup, data, s));
    geodesic.build(CGAL::parameters::keep_windows(true));
    const double size = longest_edge(soup);
    for (std::size_t q = 0; q < queries.size(); ++q)
      compare(geodesic.distance_to_sources(location(soup, data, queries[q])), double(reference.of_query(q)), size, counts, seed, q);
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      compare(geodesic.distance_to_sources(data.vertices[v]), double(reference.of_vertex(v)), size, counts, seed, queries.size() + v);
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
    const std::vector<Location> queries = make_queries(soup, corners);
    std::vector<Face_location> polyline;
    std::vector<Planar> placed;
    for (const Location& c : corners)
    {
      polyline.push_back(location(soup, data, c));
      placed.push_back(in_plane(soup, c));
    }
    Geodesic geodesic(data.mesh);
    geodesic.add_source_polyline(polyline);
    geodesic.build(CGAL::parameters::keep_windows(true));
    const double size = longest_edge(soup);
    const auto expected = [&](const Planar& p) {
      long double d = infinity();
      for (std::size_t i = 1; i < placed.size(); ++i)
        d = (std::min)(d, distance_to_segment(p, placed[i - 1], placed[i]));
      return double(d);
    };
    for (std::size_t q = 0; q < queries.size(); ++q)
      compare(geodesic.distance_to_sources(location(soup, data, queries[q])), expected(in_plane(soup, queries[q])), size, counts, seed, q);
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      compare(geodesic.distance_to_sources(data.vertices[v]), expected({soup.points[v].x(), soup.points[v].y()}), size, counts, seed,
              queries.size() + v);
  }

  static long double infinity() { return std::numeric_limits<long double>::infinity(); }

  std::ostream& log_;
  std::size_t printed_, queries_;
  Random random_;
  std::map<std::string, Near_vertex_counts> counts_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_NEAR_VERTEX_SEARCH_H
