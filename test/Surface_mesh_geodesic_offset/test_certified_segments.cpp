// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Certified bounds beside segments that touch edges nearly at right angles, with start values, on flat rectangles: some have rows
// of faces as thin as 1e-9, and some are a billion times smaller than the start values. Coordinates and weights have few digits,
// so that the distance, that of the nearest segment in the plane, is computed with 113 bits from exact places.
//
//   test_certified_segments [N]      N times as many rectangles

#include "geodesic_types.h"
#include "reference_distances.h"
#include "test_check.h"

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_certified_segments {

typedef test::Surface_mesh Mesh;
typedef Mesh::Face_index Face;
typedef CGAL::Surface_mesh_geodesic_enclosure<CGAL::Surface_mesh_geodesic_offset_traits<test::Kernel, Mesh>> Enclosure;
typedef Enclosure::Face_location Location;
typedef test::Reference_distances::Number Number;

struct Point
{
  Number x, y;
};

struct Segment
{
  Point a, b;
  Number start_value;
};

Number distance(const Point& p, const Segment& s)
{
  const Number ux = s.b.x - s.a.x, uy = s.b.y - s.a.y, square = ux * ux + uy * uy;
  Number t(0);
  if (square > Number(0)) t = ((p.x - s.a.x) * ux + (p.y - s.a.y) * uy) / square;
  t = (std::max)(Number(0), (std::min)(Number(1), t));
  const Number dx = p.x - s.a.x - t * ux, dy = p.y - s.a.y - t * uy;
  return test::Reference_distances::root(dx * dx + dy * dy) + s.start_value;
}

class Rectangle
{
public:
  explicit Rectangle(unsigned seed) : m_random(seed), m_scale(seed % 3 == 0 ? 0x1p-30 : 1)
  {
    const std::vector<double> x = lines(2 + number(4)), y = lines(2 + number(3));
    std::vector<Mesh::Vertex_index> v;
    for (double b : y)
      for (double a : x) v.push_back(m_mesh.add_vertex(test::Kernel::Point_3(m_scale * a, m_scale * b, 0)));
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
      {
        const auto p = v[j * x.size() + i], q = v[j * x.size() + i + 1], r = v[(j + 1) * x.size() + i + 1],
                   s = v[(j + 1) * x.size() + i];
        const bool is_first = number(2) == 0;
        m_faces.push_back(m_mesh.add_face(p, q, is_first ? r : s));
        m_faces.push_back(m_mesh.add_face(is_first ? p : q, r, s));
      }
  }

  const Mesh& mesh() const { return m_mesh; }

  // A random number below n.
  std::size_t number(unsigned n) { return m_random() % n; }

  // A multiple of 2^-22 between 0 and 1, often small.
  double weight() { return std::ldexp(double(number(3) ? number(1 << 10) << 12 : (1 + number(3)) << number(8)), -22); }

  Location location()
  {
    const double a = weight(), b = number(2) ? weight() : 0;
    std::array<double, 3> w = {a, b, 0};
    if (a + b > 1) w = {a / 2, b / 2, 0};
    w[2] = 1 - w[0] - w[1];
    std::rotate(w.begin(), w.begin() + std::ptrdiff_t(number(3)), w.end());
    return {m_faces[number(unsigned(m_faces.size()))], {{w[0], w[1], w[2]}}};
  }

  // A segment parallel to an edge of its face, which is mostly orthogonal to another one.
  std::pair<Location, Location> segment()
  {
    const Location first = location();
    Location second = first;
    const std::size_t from = number(3), to = (from + 1 + number(2)) % 3;
    const double part = std::ldexp(std::floor(std::ldexp(first.second[from] * (number(2) ? 1 : 0.7), 22)), -22);
    second.second[from] -= part;
    second.second[to] += part;
    return {first, second};
  }

  Point place(const Location& l) const
  {
    Point p{Number(0), Number(0)};
    const auto h = m_mesh.halfedge(l.first);
    const Mesh::Vertex_index corner[] = {m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h))};
    for (std::size_t k = 0; k < 3; ++k)
    {
      p.x += Number(l.second[k]) * Number(m_mesh.point(corner[k]).x());
      p.y += Number(l.second[k]) * Number(m_mesh.point(corner[k]).y());
    }
    return p;
  }

private:
  // Coordinates of lines, some of them very close together.
  std::vector<double> lines(std::size_t n)
  {
    std::vector<double> x = {0};
    while (x.size() < n)
      x.push_back(x.back() +
                  (number(3) == 0 ? std::ldexp(1., -int(number(30))) : 0.25 + std::ldexp(double(number(1024)), -10)));
    return x;
  }

  std::mt19937 m_random;
  const double m_scale;
  Mesh m_mesh;
  std::vector<Face> m_faces;
};

std::size_t check_rectangle(unsigned seed)
{
  Rectangle r(seed);
  Enclosure enclosure(r.mesh());
  std::vector<Segment> sources;
  for (std::size_t n = 1 + r.number(4); n > 0; --n)
  {
    const auto ends = r.segment();
    const std::vector<Location> polyline = {ends.first, ends.second};
    if (ends.first.second == ends.second.second) continue;
    Segment s{r.place(ends.first), r.place(ends.second), Number(0)};
    double start = 0;
    if (const std::size_t kind = r.number(4); kind == 1) start = 3.2;
    else if (kind == 2 && !sources.empty()) start = double(distance(s.a, sources[0])); // a tie, up to rounding
    s.start_value = Number(start);
    enclosure.add_source_polyline(polyline, CGAL::parameters::start_value(start));
    sources.push_back(s);
  }
  if (sources.empty()) return 0;
  enclosure.build(CGAL::parameters::keep_windows(true));
  for (int i = 0; i < 100; ++i)
  {
    const Location l = i % 2 == 0 ? r.location() : r.segment().second;
    const Point p = r.place(l);
    Number d = distance(p, sources[0]);
    for (const Segment& s : sources) d = (std::min)(d, distance(p, s));
    const std::pair<double, double> bounds = enclosure.distance_bounds(l);
    CHECK_DETAIL(Number(bounds.first) <= d && d <= Number(bounds.second),
                 std::to_string(seed) + ": " + test::values(bounds.first, double(d)) + test::values(bounds.second, double(d)));
  }
  return 1;
}

// An edge far shorter than the rounding of a point of its faces as the source, and a vertex beside it, as far from it as it is
// long. The nearest point is inside the edge.
void check_short_edges()
{
  for (double size = 1e-10; size > 1e-40; size /= 7)
    for (const bool is_polyline : {false, true})
    {
      Mesh mesh;
      std::vector<Mesh::Vertex_index> v;
      for (const test::Point_3& p :
           {test::Point_3(0, 0, 0), test::Point_3(size, 0, 0), test::Point_3(-0.5, 0.8, 0), test::Point_3(0.6 * size, size, 0)})
        v.push_back(mesh.add_vertex(p));
      const Face f = mesh.add_face(v[0], v[1], v[2]);
      mesh.add_face(v[2], v[1], v[3]);
      Enclosure enclosure(mesh);
      const auto h = mesh.halfedge(v[0], v[1]);
      Location first{f, {{0, 0, 0}}}, second = first;
      const auto start = mesh.halfedge(f);
      const Mesh::Vertex_index corner[] = {mesh.source(start), mesh.target(start), mesh.target(mesh.next(start))};
      for (std::size_t k = 0; k < 3; ++k)
      {
        first.second[k] = corner[k] == v[0];
        second.second[k] = corner[k] == v[1];
      }
      if (is_polyline) enclosure.add_source_polyline(std::vector<Location>{first, second});
      else enclosure.add_source_edges(std::vector<Mesh::Edge_index>{mesh.edge(h)});
      enclosure.build();
      const std::pair<double, double> bounds = enclosure.distance_bounds(v[3]);
      CHECK_DETAIL(bounds.first <= size && size <= bounds.second,
                   test::values(bounds.first, size) + test::values(bounds.second, size));
    }
}

} // namespace test_certified_segments

GEODESIC_OFFSET_TEST(test_certified_segments)
{
  const unsigned times = argc > 1 ? unsigned(std::stoul(argv[1])) : 1;
  std::size_t n = 0;
  for (unsigned seed = 1; seed <= 10000 * times; ++seed) n += test_certified_segments::check_rectangle(seed);
  test_certified_segments::check_short_edges();
  std::cout << n << " flat rectangles" << std::endl;
  return test::Report::instance().finish("test_certified_segments");
}
