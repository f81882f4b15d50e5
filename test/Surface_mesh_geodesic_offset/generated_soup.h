// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangle soups with intrinsic (unfolded) coordinates, and meshes built from them.

#ifndef GEODESIC_OFFSET_TEST_GENERATED_SOUP_H
#define GEODESIC_OFFSET_TEST_GENERATED_SOUP_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Vector_2 Vector_2;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef std::mt19937 Random;

inline double uniform(Random& random, double low = 0, double high = 1)
{
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

inline std::size_t uniform_index(Random& random, std::size_t count)
{
  return static_cast<std::size_t>(uniform(random) * static_cast<double>(count));
}

/// Triangles with, for each corner, its coordinates in the plane of the flat patch that contains the triangle. Within one
/// patch the surface is isometric to that plane.
struct Soup
{
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> patches;
  std::vector<std::array<Point_2, 3>> uv;

  void add_triangle(const std::array<std::size_t, 3>& corners, std::size_t patch = 0,
                    const std::array<Point_2, 3>& coordinates = std::array<Point_2, 3>())
  {
    triangles.push_back(corners);
    patches.push_back(patch);
    uv.push_back(coordinates);
  }
};

/// Delaunay triangles of points in the plane, as indices of their corners.
std::vector<std::array<std::size_t, 3>> delaunay_triangles(const std::vector<Point_2>& points);

/// Builds a soup from flat triangles and parallelograms; those with two common corners share the points between them.
class Patch_assembler
{
public:
  /// Each edge has `points_per_edge` and each patch `points_per_patch` random points.
  Patch_assembler(std::size_t points_per_edge, std::size_t points_per_patch, unsigned seed)
    : points_per_edge_(points_per_edge), points_per_patch_(points_per_patch), random_(seed)
  {
  }

  std::size_t add_corner(const Point_3& p)
  {
    soup_.points.push_back(p);
    return soup_.points.size() - 1;
  }

  /// Corners in counterclockwise order; the fourth corner of a parallelogram is redundant but must be given.
  void add_patch(const std::vector<std::size_t>& corners, const std::vector<Point_2>& corner_uv, std::size_t patch)
  {
    static const std::vector<Point_2> reference_triangle = {Point_2(0, 0), Point_2(1, 0), Point_2(0, 1)};
    static const std::vector<Point_2> reference_square = {Point_2(0, 0), Point_2(1, 0), Point_2(1, 1), Point_2(0, 1)};
    const std::size_t size = corners.size();
    const std::vector<Point_2>& reference = (size == 3) ? reference_triangle : reference_square;
    const std::size_t last = size - 1; // the corner at (0, 1)

    std::vector<Local_point> local;
    for (std::size_t i = 0; i < size; ++i) local.push_back({reference[i], corner_uv[i], corners[i]});
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::size_t j = (i + 1) % size;
      for (const Edge_point& e : edge_points(corners[i], corners[j]))
      {
        const double t = (corners[i] < corners[j]) ? e.t : 1 - e.t;
        local.push_back({between(reference[i], reference[j], t), between(corner_uv[i], corner_uv[j], t), e.id});
      }
    }
    const Point_3 origin = soup_.points[corners[0]];
    const Vector_3 side_s = soup_.points[corners[1]] - origin;
    const Vector_3 side_t = soup_.points[corners[last]] - origin;
    for (std::size_t i = 0; i < points_per_patch_; ++i)
    {
      double s = uniform(random_, 0.01, 0.99);
      double t = uniform(random_, 0.01, 0.99);
      if (size == 3 && s + t > 1)
      {
        s = 1 - s;
        t = 1 - t;
      }
      if (size == 3 && s + t > 0.995) continue;
      const Vector_2 u = s * (corner_uv[1] - corner_uv[0]) + t * (corner_uv[last] - corner_uv[0]);
      local.push_back({Point_2(s, t), corner_uv[0] + u, add_corner(origin + s * side_s + t * side_t)});
    }
    triangulate(local, patch);
  }

  const Soup& soup() const { return soup_; }

private:
  struct Edge_point
  {
    double t; // from the corner with the smaller index
    std::size_t id;
  };
  struct Local_point
  {
    Point_2 reference, uv;
    std::size_t id;
  };

  static Point_2 between(const Point_2& p, const Point_2& q, double t)
  {
    return Point_2((1 - t) * p.x() + t * q.x(), (1 - t) * p.y() + t * q.y());
  }

  const std::vector<Edge_point>& edge_points(std::size_t i, std::size_t j)
  {
    const std::pair<std::size_t, std::size_t> key = std::minmax(i, j);
    const auto found = edges_.find(key);
    if (found != edges_.end()) return found->second;
    std::vector<Edge_point> result;
    const Point_3 p = soup_.points[key.first];
    const Point_3 q = soup_.points[key.second];
    for (std::size_t k = 0; k < points_per_edge_; ++k)
    {
      // A multiple of 2^-20, so that t, 1 - t and their sum are exact, and the reference points exactly collinear.
      const double cell = (static_cast<double>(k) + uniform(random_, 0.1, 0.9)) / static_cast<double>(points_per_edge_);
      const double t = std::floor(cell * 1048576.0) / 1048576.0;
      result.push_back({t, add_corner(p + t * (q - p))});
    }
    return edges_.emplace(key, result).first->second;
  }

  void triangulate(const std::vector<Local_point>& local, std::size_t patch)
  {
    std::vector<Point_2> points;
    for (const Local_point& p : local) points.push_back(p.reference);
    for (const std::array<std::size_t, 3>& triangle : delaunay_triangles(points))
    {
      std::array<std::size_t, 3> corners;
      std::array<Point_2, 3> coordinates;
      for (std::size_t k = 0; k < 3; ++k)
      {
        corners[k] = local[triangle[k]].id;
        coordinates[k] = local[triangle[k]].uv;
      }
      soup_.add_triangle(corners, patch, coordinates);
    }
  }

  std::size_t points_per_edge_, points_per_patch_;
  Random random_;
  Soup soup_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Edge_point>> edges_;
};

/// Points moved by up to `noise` in z, and up to `across` in x and y.
inline Soup with_noise(Soup soup, double noise, unsigned seed, double across = 0)
{
  Random random(seed);
  for (Point_3& p : soup.points)
  {
    const double x = uniform(random, -across, across), y = uniform(random, -across, across);
    p = p + Vector_3(x, y, uniform(random, -noise, noise));
  }
  return soup;
}

/// Rotates and translates the soup so that its coordinates are generic.
inline Soup rotated(Soup soup, unsigned seed)
{
  Random random(seed);
  double q[4], norm = 0;
  for (double& c : q)
  {
    c = uniform(random, -1, 1);
    norm += c * c;
  }
  for (double& c : q) c /= std::sqrt(norm);
  const Vector_3 axis(q[1], q[2], q[3]);
  const Vector_3 shift(uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5));
  for (Point_3& p : soup.points)
  {
    const Vector_3 v = p - CGAL::ORIGIN;
    const Vector_3 twice = 2 * CGAL::cross_product(axis, v);
    p = CGAL::ORIGIN + (v + q[0] * twice + CGAL::cross_product(axis, twice) + shift);
  }
  return soup;
}

/// Mesh built from a soup, with the soup's intrinsic coordinates for each face, in the order of the face's barycentric
/// coordinates (that of `Polygon_mesh_processing::Face_location`).
template <class TriangleMesh>
struct Generated_mesh
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef std::array<double, 3> Barycentric_coordinates;
  typedef std::pair<face_descriptor, Barycentric_coordinates> Face_location;

  explicit Generated_mesh(const Soup& soup) : patches(soup.patches)
  {
    if (soup.uv.size() != soup.triangles.size() || soup.patches.size() != soup.triangles.size())
      throw std::logic_error("a triangle of the soup was added without add_triangle()");
    auto points = get(CGAL::vertex_point, mesh);
    for (const Point_3& p : soup.points)
    {
      vertices.push_back(add_vertex(mesh));
      put(points, vertices.back(), p);
    }
    for (std::size_t i = 0; i < soup.triangles.size(); ++i)
    {
      std::array<vertex_descriptor, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = vertices[soup.triangles[i][k]];
      const face_descriptor f = CGAL::Euler::add_face(corners, mesh);
      if (f == Graph_traits::null_face()) throw std::runtime_error("the soup is not manifold");
      faces.push_back(f);
      face_numbers[f] = i;
      std::size_t first = 0;
      while (corners[first] != source(halfedge(f, mesh), mesh)) ++first;
      std::array<Point_2, 3> coordinates;
      for (std::size_t k = 0; k < 3; ++k) coordinates[k] = soup.uv[i][(first + k) % 3];
      uv.push_back(coordinates);
    }
    if (faces.empty()) throw std::runtime_error("the soup has no triangle");
  }
  Generated_mesh(const Generated_mesh&) = delete;
  Generated_mesh& operator=(const Generated_mesh&) = delete;

  std::size_t face_number(face_descriptor f) const { return face_numbers.at(f); }

  TriangleMesh mesh;
  std::vector<vertex_descriptor> vertices; // in the order of the soup's points
  std::vector<face_descriptor> faces;      // in the order of the soup's triangles
  std::vector<std::size_t> patches;
  std::vector<std::array<Point_2, 3>> uv;
  std::map<face_descriptor, std::size_t> face_numbers;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_GENERATED_SOUP_H
