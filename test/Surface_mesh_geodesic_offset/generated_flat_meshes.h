// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes with geodesic distances in closed form: planes, boxes, prisms, cones, the L, the tetrahedron.

#ifndef GEODESIC_OFFSET_TEST_GENERATED_FLAT_MESHES_H
#define GEODESIC_OFFSET_TEST_GENERATED_FLAT_MESHES_H

#include "generated_soup.h"

#include <algorithm>

namespace test {

enum class Diagonals {
  forward,     // from (i, j) to (i + 1, j + 1)
  backward,    // from (i + 1, j) to (i, j + 1)
  alternating, // changing direction from square to square
  random
};

/// n x m squares of side `side` in the plane z = 0, each split in two; vertex (i, j) has index j (n + 1) + i. Inner
/// vertices are displaced by up to `jitter` sides in x and in y (faces keep their orientation below 0.25).
inline Soup planar_grid(std::size_t n, std::size_t m, Diagonals diagonals = Diagonals::forward, double side = 1,
                        double jitter = 0, unsigned seed = 1)
{
  Random random(seed);
  Soup soup;
  for (std::size_t j = 0; j <= m; ++j)
    for (std::size_t i = 0; i <= n; ++i)
    {
      double x = static_cast<double>(i), y = static_cast<double>(j);
      if (i > 0 && i < n) x += jitter * uniform(random, -1, 1);
      if (j > 0 && j < m) y += jitter * uniform(random, -1, 1);
      soup.points.push_back(Point_3(side * x, side * y, 0));
    }
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    std::array<Point_2, 3> uv;
    std::size_t k = 0;
    for (std::size_t v : {a, b, c}) uv[k++] = Point_2(soup.points[v].x(), soup.points[v].y());
    soup.add_triangle({{a, b, c}}, 0, uv);
  };
  for (std::size_t j = 0; j < m; ++j)
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
      const bool forward = diagonals == Diagonals::forward || (diagonals == Diagonals::alternating && (i + j) % 2 == 0) ||
                           (diagonals == Diagonals::random && uniform(random) < 0.5);
      if (forward)
      {
        add(a, b, c);
        add(a, c, d);
      }
      else
      {
        add(a, b, d);
        add(b, c, d);
      }
    }
  return soup;
}

inline Soup jittered_grid(std::size_t n, std::size_t m, unsigned seed, double jitter = 0.24)
{
  return planar_grid(n, m, Diagonals::random, 1, jitter, seed);
}

/// Random points in a rectangle with the Delaunay triangulation of the unit square, stretched: with a small height, all
/// faces are needles.
inline Soup random_rectangle(double width, double height, std::size_t points_inside, std::size_t points_per_edge, unsigned seed)
{
  Patch_assembler assembler(points_per_edge, points_inside, seed);
  const std::vector<Point_2> uv = {Point_2(0, 0), Point_2(width, 0), Point_2(width, height), Point_2(0, height)};
  std::vector<std::size_t> corners;
  for (const Point_2& p : uv) corners.push_back(assembler.add_corner(Point_3(p.x(), p.y(), 0)));
  assembler.add_patch(corners, uv, 0);
  return assembler.soup();
}

/// Strip of needles, 1 : thickness, with as much noise in the third coordinate, in general position.
inline Soup crumpled_needles(double thickness, double noise, std::size_t points_inside, unsigned seed)
{
  Soup soup = random_rectangle(1, thickness, points_inside, 4, seed);
  Random random(seed);
  for (Point_3& p : soup.points) p = Point_3(p.x(), p.y(), uniform(random, -noise, noise));
  return rotated(soup, seed);
}

/// Points at distances of 10^-decades to 1, Delaunay-triangulated and bent by the given fraction of their distance: tiny
/// faces beside large ones.
inline Soup graded_disc(std::size_t points, double decades, double bending, unsigned seed)
{
  Random random(seed);
  std::vector<Point_2> plane;
  Soup soup;
  for (std::size_t i = 0; i < points; ++i)
  {
    const double radius = std::pow(10, uniform(random, -decades, 0));
    const double angle = uniform(random, 0, 2 * CGAL_PI);
    plane.push_back(Point_2(radius * std::cos(angle), radius * std::sin(angle)));
    const double height = bending * radius * uniform(random, -1, 1);
    soup.points.push_back(Point_3(plane.back().x(), plane.back().y(), height));
  }
  for (const std::array<std::size_t, 3>& triangle : delaunay_triangles(plane))
    soup.add_triangle(triangle, 0, {plane[triangle[0]], plane[triangle[1]], plane[triangle[2]]});
  return soup;
}

/// Flat subdivided L: [0, 2] x [0, 1] together with [0, 1] x [0, 2]; reflex corner (1, 1).
inline Soup l_shape(std::size_t points_per_square, std::size_t points_per_edge, unsigned seed)
{
  Patch_assembler assembler(points_per_edge, points_per_square, seed);
  std::map<std::pair<int, int>, std::size_t> ids;
  for (int y = 0; y <= 2; ++y)
    for (int x = 0; x <= 2; ++x)
      if (x < 2 || y < 2) ids[{x, y}] = assembler.add_corner(Point_3(x, y, 0));
  for (const std::pair<int, int>& square : {std::make_pair(0, 0), std::make_pair(1, 0), std::make_pair(0, 1)})
  {
    std::vector<std::size_t> corners;
    std::vector<Point_2> uv;
    for (const std::pair<int, int>& step :
         {std::make_pair(0, 0), std::make_pair(1, 0), std::make_pair(1, 1), std::make_pair(0, 1)})
    {
      const int x = square.first + step.first, y = square.second + step.second;
      corners.push_back(ids.at({x, y}));
      uv.push_back(Point_2(x, y));
    }
    assembler.add_patch(corners, uv, 0);
  }
  return assembler.soup();
}

/// Convex polyhedron with flat triangles or rectangles as sides; patch i is side i.
struct Polyhedron_sides
{
  std::vector<Point_3> corners;
  std::vector<std::vector<std::size_t>> sides; // counterclockwise seen from outside

  /// Coordinates of the corners of side i in its plane: the first corner at the origin, the second on the x axis.
  std::vector<Point_2> uv(std::size_t i) const
  {
    const std::vector<std::size_t>& side = sides[i];
    const Point_3 origin = corners[side[0]];
    Vector_3 x = corners[side[1]] - origin;
    x = x / std::sqrt(x.squared_length());
    Vector_3 normal = CGAL::cross_product(x, corners[side[2]] - origin);
    normal = normal / std::sqrt(normal.squared_length());
    const Vector_3 y = CGAL::cross_product(normal, x);
    std::vector<Point_2> result;
    for (std::size_t c : side) result.push_back(Point_2((corners[c] - origin) * x, (corners[c] - origin) * y));
    return result;
  }

  Soup triangulated(std::size_t points_per_side, std::size_t points_per_edge, unsigned seed) const
  {
    Patch_assembler assembler(points_per_edge, points_per_side, seed);
    for (const Point_3& p : corners) assembler.add_corner(p);
    for (std::size_t i = 0; i < sides.size(); ++i) assembler.add_patch(sides[i], uv(i), i);
    return assembler.soup();
  }
};

inline Polyhedron_sides box_sides(double a, double b, double c)
{
  Polyhedron_sides box;
  for (int i = 0; i < 8; ++i) box.corners.push_back(Point_3((i & 1) ? a : 0, (i & 2) ? b : 0, (i & 4) ? c : 0));
  box.sides = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return box;
}

/// Unit cube with n x n squares per side, each split in two; patch i is side i of `box_sides(1, 1, 1)`.
inline Soup cube_grid(std::size_t n)
{
  const Polyhedron_sides cube = box_sides(1, 1, 1);
  Soup soup;
  std::map<std::array<std::size_t, 3>, std::size_t> ids;
  for (std::size_t side = 0; side < 6; ++side)
  {
    const std::vector<std::size_t>& c = cube.sides[side];
    const Point_3 origin = cube.corners[c[0]];
    const Vector_3 x = cube.corners[c[1]] - origin, y = cube.corners[c[3]] - origin;
    const auto at = [&](std::size_t i, std::size_t j) {
      const Point_3 p = origin + (static_cast<double>(i) * x + static_cast<double>(j) * y) / static_cast<double>(n);
      std::array<std::size_t, 3> key;
      for (int k = 0; k < 3; ++k)
        key[static_cast<std::size_t>(k)] = static_cast<std::size_t>(std::lround(p[k] * static_cast<double>(n)));
      const auto inserted = ids.emplace(key, soup.points.size());
      if (inserted.second) soup.points.push_back(p);
      return inserted.first->second;
    };
    const auto uv = [n](std::size_t i, std::size_t j) {
      return Point_2(static_cast<double>(i) / static_cast<double>(n), static_cast<double>(j) / static_cast<double>(n));
    };
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
      {
        soup.add_triangle({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}}, side, {{uv(i, j), uv(i + 1, j), uv(i + 1, j + 1)}});
        soup.add_triangle({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}}, side, {{uv(i, j), uv(i + 1, j + 1), uv(i, j + 1)}});
      }
  }
  return soup;
}

inline Polyhedron_sides tetrahedron_sides()
{
  Polyhedron_sides tetrahedron;
  tetrahedron.corners = {Point_3(1, 1, 1), Point_3(1, -1, -1), Point_3(-1, 1, -1), Point_3(-1, -1, 1)};
  tetrahedron.sides = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return tetrahedron;
}

/// Lateral surface of a prism with k sides, open at both ends: flat except for its bends. Patch i is side i, with the
/// coordinates of the unrolled strip: u from i w to (i + 1) w for the width w of a side, v from 0 to height.
struct Prism
{
  Prism(std::size_t k, double radius, double height) : sides(k), radius(radius), height(height) {}

  double side_width() const { return 2 * radius * std::sin(CGAL_PI / static_cast<double>(sides)); }
  double period() const { return static_cast<double>(sides) * side_width(); }

  Soup triangulated(std::size_t points_per_side, std::size_t points_per_edge, unsigned seed) const
  {
    Patch_assembler assembler(points_per_edge, points_per_side, seed);
    for (double z : {0., height})
      for (std::size_t i = 0; i < sides; ++i)
      {
        const double angle = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(sides);
        assembler.add_corner(Point_3(radius * std::cos(angle), radius * std::sin(angle), z));
      }
    for (std::size_t i = 0; i < sides; ++i)
    {
      const std::size_t j = (i + 1) % sides;
      const double u0 = static_cast<double>(i) * side_width(), u1 = static_cast<double>(i + 1) * side_width();
      assembler.add_patch({i, j, sides + j, sides + i},
                          {Point_2(u0, 0), Point_2(u1, 0), Point_2(u1, height), Point_2(u0, height)}, i);
    }
    return assembler.soup();
  }

  std::size_t sides;
  double radius, height;
};

/// k equal planar triangles around an apex (vertex 0) with legs of length `leg`; their angles at the apex sum to
/// `total_angle`, below or above 2 pi (then k must be even, and the fan alternates up and down). Patch i is triangle i,
/// with the apex at the origin and its first leg on the x axis. An open cone is slit along its first leg, so the apex is on
/// the border; it lies in the plane, overlapping itself if its angle is large.
struct Cone
{
  Cone(std::size_t k, double total_angle, double leg, bool is_open = false)
    : sectors(k), total_angle(total_angle), leg(leg), is_open(is_open)
  {
  }

  double sector_angle() const { return total_angle / static_cast<double>(sectors); }

  Soup triangulated(std::size_t points_per_sector, std::size_t points_per_edge, unsigned seed) const
  {
    Patch_assembler assembler(points_per_edge, points_per_sector, seed);
    const std::size_t apex = assembler.add_corner(Point_3(0, 0, 0));
    const double turn = is_open ? sector_angle() : 2 * CGAL_PI / static_cast<double>(sectors);
    const std::size_t legs = is_open ? sectors + 1 : sectors;
    // The legs leave the apex at an angle to the plane z = 0: all downwards, or alternately upwards and downwards.
    const bool saddle = !is_open && total_angle > 2 * CGAL_PI;
    const double horizontal = saddle ? std::sqrt((1 + std::cos(sector_angle())) / (1 + std::cos(turn)))
                                     : std::sin(sector_angle() / 2) / std::sin(turn / 2);
    const double vertical = std::sqrt((std::max)(0., 1 - horizontal * horizontal));
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < legs; ++i)
    {
      const double angle = turn * static_cast<double>(i);
      const double z = (saddle && i % 2 == 0) ? vertical : -vertical;
      ends.push_back(assembler.add_corner(Point_3(leg * horizontal * std::cos(angle), leg * horizontal * std::sin(angle),
                                                  leg * z)));
    }
    const Point_2 second(leg * std::cos(sector_angle()), leg * std::sin(sector_angle()));
    for (std::size_t i = 0; i < sectors; ++i)
      assembler.add_patch({apex, ends[i], ends[(i + 1) % legs]}, {Point_2(0, 0), Point_2(leg, 0), second}, i);
    return assembler.soup();
  }

  std::size_t sectors;
  double total_angle, leg;
  bool is_open;
};

/// Saddle of 2 k faces whose only inner vertex is the apex.
inline Soup saddle_fan(std::size_t k = 4, double total_angle = 2.6 * CGAL_PI)
{
  return Cone(2 * k, total_angle, 1).triangulated(0, 0, 1);
}

/// Planar disc of k thin triangles around vertex 0.
inline Soup needle_fan(std::size_t k)
{
  Soup soup;
  soup.points.push_back(Point_3(0, 0, 0));
  for (std::size_t i = 0; i < k; ++i)
  {
    const double angle = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(k);
    soup.points.push_back(Point_3(std::cos(angle), std::sin(angle), 0));
  }
  for (std::size_t i = 0; i < k; ++i)
  {
    const std::size_t a = 1 + i, b = 1 + (i + 1) % k;
    soup.add_triangle({{0, a, b}}, 0,
                      {{Point_2(0, 0), Point_2(soup.points[a].x(), soup.points[a].y()),
                        Point_2(soup.points[b].x(), soup.points[b].y())}});
  }
  return soup;
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_GENERATED_FLAT_MESHES_H
