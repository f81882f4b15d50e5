// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Small meshes for tests of distance bounds: adversarial ones, designed to expose missing error terms, and general ones. A
// seed determines a case.

#ifndef GEODESIC_OFFSET_TEST_CERTIFIED_CASES_H
#define GEODESIC_OFFSET_TEST_CERTIFIED_CASES_H

#include "generated_curved_meshes.h"
#include "generated_flat_meshes.h"
#include "reference_distances.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test {

struct Certified_case
{
  typedef Reference_distances::Point Point;
  typedef Reference_distances::Triangle Triangle;
  typedef Reference_distances::Location Location;

  struct Segment
  {
    Reference_distances::Segment place;
    double start_value;
  };

  std::string kind;
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<std::size_t> source_vertices;
  std::vector<Location> sources, queries;
  std::vector<Segment> segments;
};

inline Soup soup_of(const Certified_case& c)
{
  Soup soup;
  for (const auto& p : c.points) soup.points.push_back(Point_3(p[0], p[1], p[2]));
  for (const auto& t : c.triangles) soup.add_triangle(t);
  return soup;
}

class Certified_cases
{
public:
  typedef Certified_case::Point Point;
  typedef Certified_case::Triangle Triangle;
  typedef Certified_case::Location Location;

  // With segments, the sources are segments with start values.
  static Certified_case adversarial(unsigned seed, bool has_segments = false)
  {
    Certified_cases c(seed);
    switch (seed % 8)
    {
    case 0: c.flat_cap(); break;
    case 1: c.graded_cluster(); break;
    case 2: c.tangent_sector(); break;
    case 3: c.needles(); break;
    case 4: c.ties(); break;
    case 5: c.near_saddle(); break;
    case 6: c.flat_faces(); break;
    default: c.graded_needles(); break;
    }
    if (has_segments) c.use_segments();
    return c.finished();
  }

  static Certified_case general(unsigned seed)
  {
    Certified_cases c(seed);
    const std::size_t n = c.index(4);
    switch (seed % 8)
    {
    case 0:
      c.use("random patch", random_rectangle(2, 1, 3 + n, 1, seed));
      c.crumple(c.number(0, 1));
      break;
    case 1: c.use("disc", graded_disc(9 + 3 * n, c.number(0, 3), c.number(0, 1), seed)); break;
    case 2:
      c.use("torus", torus(3 + n % 2, 3, 1, c.number(0.1, 0.6)));
      c.crumple(0.1);
      break;
    case 3:
      c.use("octasphere", icosphere(0));
      c.crumple(c.number(0, 0.5));
      break;
    case 4: c.use("crumpled needles", crumpled_needles(std::pow(10, -c.number(0, 4)), 0.1, 4 + n, seed)); break;
    case 5:
      c.use("grid", planar_grid(2 + n % 2, 2 + n / 2, Diagonals::alternating));
      c.crumple(c.number(0, 0.4));
      break;
    case 6: c.use("cone", rotated(Cone(6, c.number(0.5, 6), 1).triangulated(2, 1, seed), seed)); break;
    default:
      c.use("saddle fan", saddle_fan(4 + n, c.number(2.1, 5) * CGAL_PI));
      c.grow(4 + n);
      break;
    }
    c.add_any_source();
    return c.finished();
  }

private:
  explicit Certified_cases(unsigned seed) : random_(seed * 2654435761u + 1) {}

  double number(double low, double high) { return uniform(random_, low, high); }
  std::size_t index(std::size_t n) { return uniform_index(random_, n); }
  bool one_of(std::size_t n) { return index(n) == 0; }
  double sign() { return one_of(2) ? 1 : -1; }
  // log-uniform
  double power(double low, double high) { return std::pow(10, number(low, high)); }
  // zero, or arbitrarily small
  double tiny(double low, double high) { return one_of(4) ? 0 : sign() * power(low, high); }

  std::size_t add(double x, double y, double z)
  {
    case_.points.push_back({x, y, z});
    return case_.points.size() - 1;
  }
  void add_triangle(std::size_t p, std::size_t q, std::size_t r) { case_.triangles.push_back({p, q, r}); }

  // A saddle vertex in front of a flat face, and a target behind it: the shortest path bends at the vertex little or not at
  // all, and the target is at the end of the pseudo-source's sector.
  void flat_cap()
  {
    case_.kind = "flat cap behind a saddle";
    const double height = power(-16, -1), tilt = one_of(2) ? tiny(-17, -3) : number(-0.5, 0.5);
    const double x = power(-3, 1), y = tilt * number(0, 1);
    const std::size_t s = add(-x, y, 0), v = add(0, 0, 0);
    const std::size_t p = add(height * number(0.5, 2), -power(-2, 1), 0), q = add(height * number(0.5, 2), power(-2, 1), 0);
    // straight ahead, up to rounding or slightly more
    const double far = one_of(2) ? std::ldexp(1, int(index(5)) - 2) : number(0.2, 5);
    const std::size_t t = add(far * x, -far * y + tiny(-17, -8), 0);
    const std::size_t m = add(number(-1, 0), number(-1, 0), number(0.2, 2));
    add_triangle(v, p, q);
    add_triangle(v, q, s);
    add_triangle(v, s, m);
    add_triangle(v, m, p);
    if (one_of(2)) add_triangle(q, p, t);
    else
    { // in two faces
      const double y = number(-0.5, 0.5);
      const std::size_t w = add(0.5 * case_.points[t][0], y, 0);
      add_triangle(q, p, w);
      add_triangle(q, w, t);
    }
    add_source(s);
    finish_shape(3);
  }

  // A fan of tiny faces, some with a distant vertex.
  void graded_cluster()
  {
    case_.kind = "graded cluster";
    const double size = power(-13, -1), bending = one_of(2) ? power(-6, 0) : 0;
    const std::size_t k = 4 + index(5), center = add(0, 0, 0);
    std::vector<std::size_t> ring;
    for (std::size_t i = 0; i < k; ++i)
    {
      const double angle = 2 * CGAL_PI * (double(i) + number(-0.3, 0.3)) / double(k), r = size * number(0.5, 1.5);
      ring.push_back(add(r * std::cos(angle), r * std::sin(angle), bending * size * number(-1, 1)));
    }
    const std::size_t far = index(k), second = one_of(2) ? index(k) : far;
    for (std::size_t i = 0; i < k; ++i)
    {
      const std::size_t a = ring[i], b = ring[(i + 1) % k];
      if (i != far && i != second) add_triangle(center, a, b);
      else
      {
        const std::size_t c = add(number(-1, 1), number(-1, 1), number(-1, 1));
        add_triangle(center, a, c);
        add_triangle(center, c, b);
      }
    }
    if (one_of(3)) add_any_source();
    else add_source(ring[index(k)]);
    finish_shape(4);
  }

  // Edges behind a saddle vertex that are nearly parallel to the bounding ray of its sector.
  void tangent_sector()
  {
    case_.kind = "sector along edges";
    const std::size_t s = add(-1, 0, 0), v = add(0, 0, 0), m = add(-0.5, number(-1, 0), number(0.5, 2));
    std::size_t upper = add(number(-0.5, 0.5), number(0.2, 1), 0), lower = add(number(0, 0.5), -number(0.2, 1), 0);
    add_triangle(v, upper, s);
    add_triangle(v, s, m);
    add_triangle(v, m, lower);
    add_triangle(v, lower, upper);
    double x = (std::max)(case_.points[upper][0], case_.points[lower][0]);
    const std::size_t n = 1 + index(4);
    for (std::size_t i = 0; i < n; ++i)
    { // a strip along the ray
      x += one_of(2) ? number(0.1, 1) : power(-6, 0);
      const std::size_t w = add(x, tiny(-16, -2), 0);
      const bool above = one_of(2);
      add_triangle(lower, w, upper);
      (above ? upper : lower) = w;
    }
    add_source(s);
    finish_shape(2);
  }

  // A strip of needles, bent in all directions.
  void needles()
  {
    case_.kind = "needles";
    const double width = power(-6, -1), noise = one_of(2) ? width : power(-8, -1);
    std::size_t a = add(0, 0, 0), b = add(width, number(0, 0.2), noise * number(-1, 1));
    const std::size_t first = a, n = 3 + index(7);
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t c =
        add((i + 2.) * width * number(0.5, 1), one_of(2) ? 1 - number(0, 0.1) : number(0, 1), noise * number(-1, 1));
      add_triangle(a, b, c);
      (one_of(2) ? a : b) = c;
    }
    if (one_of(2)) add_any_source();
    else add_source(first);
    finish_shape(2);
  }

  // Symmetric meshes, exactly or nearly: many paths of equal length.
  void ties()
  {
    case_.kind = "ties";
    const std::size_t k = 3 + index(5);
    const double height = power(-2, 0), off = one_of(2) ? 0 : power(-17, -7);
    const std::size_t top = add(0, 0, height), bottom = add(0, 0, -height * (one_of(2) ? 1 : number(0, 1)));
    std::vector<std::size_t> ring;
    for (std::size_t i = 0; i < k; ++i)
    {
      const double angle = 2 * CGAL_PI * double(i) / double(k);
      ring.push_back(add(std::cos(angle) + off * number(-1, 1), std::sin(angle) + off * number(-1, 1), off * number(-1, 1)));
    }
    const bool is_closed = one_of(2);
    for (std::size_t i = 0; i < k; ++i)
    {
      add_triangle(top, ring[i], ring[(i + 1) % k]);
      if (is_closed || i > 0) add_triangle(bottom, ring[(i + 1) % k], ring[i]);
    }
    if (one_of(3)) add_any_source();
    else add_source(one_of(2) ? top : ring[0]);
    if (one_of(3)) add_source(one_of(2) ? bottom : ring[index(k)]);
    finish_shape(is_closed ? 0 : 2);
  }

  // A source so close to a saddle vertex that the direction to it is ill-conditioned.
  void near_saddle()
  {
    case_.kind = "source near a saddle";
    const std::size_t k = 4 + index(4), v = add(0, 0, 0);
    std::vector<std::size_t> ring;
    const double flat = one_of(2) ? power(-12, -2) : 1;
    for (std::size_t i = 0; i < k; ++i)
    { // zigzag: more than a full turn; some corners nearly as wide as a half turn
      const double angle = 2 * CGAL_PI * (double(i) + (i == 1 ? flat - 0.5 : 0)) / double(k);
      ring.push_back(add(std::cos(angle), std::sin(angle), (i % 2 ? -1 : 1) * number(0, 1)));
    }
    for (std::size_t i = 0; i < k; ++i) add_triangle(v, ring[i], ring[(i + 1) % k]);
    const std::size_t f = index(k);
    const double distance = power(-12.9, -3), along = one_of(3) ? 0 : one_of(2) ? power(-12.9, 0) : number(0, 1);
    const double second = distance * along;
    if (second > 0 && second < 1.1e-13) add_source_in(f, {1 - distance, distance, 0});
    else add_source_in(f, {1 - distance - second, distance, second});
    finish_shape(4);
  }

  // Faces whose height is far below their length, in the plane or bent.
  void flat_faces()
  {
    case_.kind = "flat faces";
    const double height = power(-14, -3), bending = one_of(2) ? 0 : power(-8, 0);
    const std::size_t n = 3 + index(4);
    std::vector<std::size_t> row;
    for (std::size_t i = 0; i <= n; ++i) row.push_back(add(double(i) + number(-0.3, 0.3), height * number(-1, 1), 0));
    // caps on both sides of the row
    const std::size_t up = add(number(0, double(n)), number(0.1, 1), bending * number(-1, 1));
    const std::size_t down = add(number(0, double(n)), -number(0.1, 1), bending * number(-1, 1));
    for (std::size_t i = 0; i < n; ++i)
    {
      add_triangle(row[i], row[i + 1], up);
      if (i + 1 < n && one_of(2))
      { // a cap that spans two edges of the row
        const std::size_t p = row[i], q = row[i + 1], r = row[i + 2];
        const Point a = case_.points[p], b = case_.points[r];
        const double t = (case_.points[q][0] - a[0]) / (b[0] - a[0]), y = a[1] + t * (b[1] - a[1]);
        if (y < case_.points[q][1])
        {
          add_triangle(q, p, r);
          add_triangle(r, p, down);
          ++i;
          add_triangle(row[i], row[i + 1], up);
          continue;
        }
      }
      add_triangle(row[i + 1], row[i], down);
    }
    if (one_of(2)) add_any_source();
    else add_source(one_of(2) ? up : row[0]);
    finish_shape(2);
  }

  // A cluster at the far end of long needles: windows cross edges far from the origin of their coordinates.
  void graded_needles()
  {
    case_.kind = "graded needles";
    const double size = power(-12, -1), bending = one_of(2) ? 1 : 0;
    const std::size_t far = add(1, number(-0.1, 0.1), 0), n = 3 + index(5);
    std::vector<std::size_t> row;
    for (std::size_t i = 0; i <= n; ++i)
      row.push_back(add(size * number(-1, 1), size * (double(i) + number(-0.3, 0.3)), bending * size * number(-1, 1)));
    for (std::size_t i = 0; i < n; ++i) add_triangle(row[i + 1], row[i], far);
    const std::size_t side = add(-size * number(1.5, 3), size * number(0, double(n)), bending * size * number(-1, 1));
    for (std::size_t i = 0; i < n; ++i)
      if (i == 0 || !one_of(3)) add_triangle(row[i], row[i + 1], side);
    add_source(row[index(n + 1)]);
    finish_shape(4);
  }

  // Random flips, additional faces at the border, a motion, and sometimes another source.
  void finish_shape(std::size_t faces)
  {
    if (one_of(3)) grow(index(faces + 1));
    if (one_of(2))
      for (Triangle& t : case_.triangles) std::swap(t[1], t[2]);
    if (one_of(2))
      for (Triangle& t : case_.triangles) std::swap(t[0], t[2]), std::swap(t[0], t[1]); // change the first side
    if (one_of(2)) move();
    if (one_of(6))
    {
      case_.source_vertices.clear();
      case_.sources.clear();
      add_any_source();
    }
  }

  // Adds n triangles of similar size at random border edges.
  void grow(std::size_t n)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      std::map<std::pair<std::size_t, std::size_t>, int> sides;
      for (const Triangle& t : case_.triangles)
        for (int k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
      std::vector<std::pair<std::size_t, std::size_t>> border;
      for (const auto& s : sides)
        if (sides.find({s.first.second, s.first.first}) == sides.end()) border.push_back(s.first);
      if (border.empty()) return;
      const auto [p, q] = border[index(border.size())];
      const Point &a = case_.points[p], &b = case_.points[q];
      const double l = std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
      const double t = number(-0.2, 1.2), height = l * (one_of(3) ? power(-3, 0) : number(0.3, 1.5));
      const std::size_t r =
        add(a[0] + t * (b[0] - a[0]) + height * number(-1, 1), a[1] + t * (b[1] - a[1]) + height * number(-1, 1),
            a[2] + t * (b[2] - a[2]) + height * number(-1, 1));
      add_triangle(q, p, r);
    }
  }

  // Rotation and scaling: coordinates are rounded.
  void move()
  {
    const double scale = one_of(3) ? power(-20, 20) : 1;
    double axes[3][3];
    for (auto& a : axes)
      for (double& x : a) x = number(-1, 1);
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        const double d = axes[i][0] * axes[j][0] + axes[i][1] * axes[j][1] + axes[i][2] * axes[j][2];
        for (int k = 0; k < 3; ++k) axes[i][k] -= d * axes[j][k];
      }
      const double l = std::sqrt(axes[i][0] * axes[i][0] + axes[i][1] * axes[i][1] + axes[i][2] * axes[i][2]);
      for (double& x : axes[i]) x /= l;
    }
    for (Point& p : case_.points)
    {
      const Point q = p;
      for (int k = 0; k < 3; ++k) p[k] = scale * (axes[0][k] * q[0] + axes[1][k] * q[1] + axes[2][k] * q[2]);
    }
  }

  void use(const char* kind, const Soup& soup)
  {
    case_.kind = kind;
    for (const Point_3& p : soup.points) add(p.x(), p.y(), p.z());
    for (const auto& t : soup.triangles) case_.triangles.push_back(t);
  }
  void crumple(double noise)
  {
    for (Point& p : case_.points)
      for (double& x : p) x += noise * number(-0.5, 0.5);
  }

  void add_source(std::size_t v) { case_.source_vertices.push_back(v); }
  void add_source_in(std::size_t triangle, const std::array<double, 3>& weights)
  {
    case_.sources.push_back({triangle, weights});
  }

  // At a vertex, on an edge, near a corner, or inside a face. Nonzero weights exceed the tolerance for zero.
  Location any_location()
  {
    Location l{index(case_.triangles.size()), {0, 0, 0}};
    const int k = int(index(3));
    if (one_of(2))
    { // on an edge
      const double t = one_of(2) ? power(-12, -0.4) : number(0.01, 0.99);
      l.weights[k] = 1 - t;
      l.weights[(k + 1) % 3] = t;
    }
    else
    {
      const double s = one_of(3) ? power(-12, -0.4) : number(0.01, 0.49), t = one_of(3) ? power(-12, -0.4) : number(0.01, 0.49);
      l.weights[k] = s;
      l.weights[(k + 1) % 3] = t;
      l.weights[(k + 2) % 3] = 1 - s - t;
    }
    return l;
  }
  void add_any_source()
  {
    if (one_of(2)) add_source(case_.triangles[index(case_.triangles.size())][index(3)]);
    else case_.sources.push_back(any_location());
  }

  // One to three segments, some of which are parallel to an edge. Start values are zero, of the size of the mesh, or much larger.
  void use_segments()
  {
    case_.source_vertices.clear();
    case_.sources.clear();
    for (std::size_t n = 1 + index(3); n > 0; --n)
    {
      const Location a = any_location(), b = any_location();
      Reference_distances::Segment s{a.triangle, a.weights, b.weights};
      if (one_of(2))
      {
        s.second = s.first;
        const std::size_t from = index(3), to = (from + 1 + index(2)) % 3;
        const double part = one_of(2) ? s.first[from] : s.first[from] * number(0.1, 0.9);
        s.second[from] -= part;
        s.second[to] += part;
      }
      if (s.first == s.second) continue;
      case_.segments.push_back({s, one_of(2) ? 0 : one_of(2) ? number(0, 1) : power(-12, 6)});
    }
  }

  // Removes unused points.
  Certified_case finished()
  {
    std::vector<std::size_t> number(case_.points.size(), std::size_t(-1));
    std::vector<Point> used;
    for (Triangle& t : case_.triangles)
      for (std::size_t& v : t)
      {
        if (number[v] == std::size_t(-1))
        {
          number[v] = used.size();
          used.push_back(case_.points[v]);
        }
        v = number[v];
      }
    std::vector<std::size_t> sources;
    for (std::size_t v : case_.source_vertices)
      if (number[v] != std::size_t(-1)) sources.push_back(number[v]);
    if (sources.empty() && case_.sources.empty() && case_.segments.empty()) sources.push_back(0);
    case_.source_vertices = sources;
    case_.points = used;
    for (int i = 0; i < 6; ++i) case_.queries.push_back(any_location());
    return case_;
  }

  Random random_;
  Certified_case case_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_CERTIFIED_CASES_H
