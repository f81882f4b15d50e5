// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Sources that touch, cross, overlap, repeat points, and lie along the boundary. Most coordinates are multiples of 1/8, so
// ties are exact.

#include "level_check.h"
#include "locations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace test_degenerate_sources {

using namespace test;

void sources_that_meet()
{
  for (const Diagonals diagonals : all_diagonals)
  {
    const Square square(diagonals, 0.5);
    typedef std::vector<Point_2> Line;
    const auto plus = [](double d) { return 8 * (1 - d) + 4 * pi * d; };
    const auto bar = [](double l, double d) { return 2 * l + 2 * pi * d; };
    for (double d : {0.125, 0.25, 0.5, 0.75})
    {
      check_level("crossing", square.mesh, square.polylines({{{1, 2}, {3, 2}}, {{2, 1}, {2, 3}}}), d, {1, 1, plus(d), 10});
      check_level("crossing inside a face", square.mesh,
                  square.polylines({{{1.125, 2.25}, {3.125, 2.25}}, {{2.125, 1.25}, {2.125, 3.25}}}), d, {1, 1, plus(d), 10});
      check_level("touching at ends", square.mesh, square.polylines({{{1, 2}, {2, 2}}, {{2, 2}, {3, 2}}}), d,
                  {1, 1, bar(2, d)});
      check_level("touching within", square.mesh, square.polylines({{{1, 2}, {3, 2}}, {{2, 2}, {2, 3}}}), d,
                  {1, 1, 2 + 4 * (1 - d) + 3 * pi * d, 10});
      check_level("overlapping", square.mesh, square.polylines({{{1, 2}, {2.5, 2}}, {{1.75, 2}, {3, 2}}}), d,
                  {1, 1, bar(2, d)});
      const Line line{{1, 2}, {3, 2}}, slanted{{1.125, 1.25}, {2.75, 2.5}};
      const Line back(line.rbegin(), line.rend()), slanted_back(slanted.rbegin(), slanted.rend());
      check_level("twice", square.mesh, square.polylines({line, line}), d, {1, 1, bar(2, d)});
      check_level("there and back", square.mesh, square.polylines({line, back}), d, {1, 1, bar(2, d)});
      check_level("slanted, there and back", square.mesh, square.polylines({slanted, slanted_back, slanted}), d,
                  {1, 1, bar(distance(slanted[0], slanted[1]), d)});
      check_level("one polyline there and back", square.mesh, square.polylines({{{1, 2}, {3, 2}, {1, 2}}}), d,
                  {1, 1, bar(2, d)});
      check_level("repeated points", square.mesh,
                  [&](Geodesic& g) {
                    std::vector<Face_location> locations;
                    for (const Face_location& l : square.plane.path(slanted, false).locations)
                      locations.insert(locations.end(), 3, l);
                    g.add_source_polyline(locations);
                  },
                  d, {1, 1, bar(distance(slanted[0], slanted[1]), d)});
      check_level("a vertex twice", square.mesh, square.vertices({{2, 2}, {2, 2}}), d, {1, 1, 2 * pi * d});
      check_level("points on a line", square.mesh,
                  [&](Geodesic& g) {
                    square.vertices({{2, 2}, {1, 2}})(g);
                    square.polylines({line})(g);
                  },
                  d, {1, 1, bar(2, d)});
    }
    for (double d : {0.25, 0.5, 1., 1.5})
    {
      check_level("along the border", square.mesh, square.polylines({{{0, 0}, {4, 0}}}), d, {1, 0, 4});
      check_level("a part of the border", square.mesh, square.polylines({{{1.75, 0}, {2.25, 0}}}), d, {1, 0, 0.5 + pi * d});
      check_level("the boundary as a polyline", square.mesh, square.polylines({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}, true), d,
                  {1, 1, 8 * (2 - d), 8});
      check_level("the boundary turned round", square.mesh, square.polylines({{{0, 0}, {0, 4}, {4, 4}, {4, 0}}}, true), d,
                  {1, 1, 8 * (2 - d), 8});
    }
  }
}

// A segment between the midpoints of consecutive edges, whose end normals are along edges: the distance at all vertices.
void segments_between_edges()
{
  for (const Diagonals diagonals : all_diagonals)
    for (double side : {0.5, 1.})
    {
      const Square square(diagonals, side);
      Report::instance().set_context("between edges, side " + std::to_string(side));
      for (double x = side / 2; x + side < 4; x += side / 2)
        for (double y = side / 2; y < 4; y += side / 2)
          for (const bool upright : {false, true})
          {
            const Point_2 a(x, y), b(x + side / 2, y);
            const Point_2 p(upright ? a.y() : a.x(), upright ? a.x() : a.y());
            const Point_2 q(upright ? b.y() : b.x(), upright ? b.x() : b.y());
            Geodesic geodesic(square.mesh);
            square.plane.add(geodesic, {p, q});
            geodesic.build();
            Worst_error worst(1e-12, 4);
            for (auto v : square.mesh.vertices())
            {
              const Point_3 z = square.mesh.point(v);
              CHECK_CLOSE(worst, geodesic.distance_to_sources(v), segment_distance(Point_2(z.x(), z.y()), p, q));
            }
          }
    }
}

// Offsets of a segment by sides, where an end of the segment lies beside an edge by about 1e-12: each side has the length of
// the segment, and the rest is the arcs around its ends.
void ends_beside_edges()
{
  Random random(5);
  for (const Diagonals diagonals : all_diagonals)
    for (double side : {0.5, 1., 4.})
    {
      const Square square(diagonals, side);
      const Locations<test::Surface_mesh> locations(square.mesh);
      for (double off : {2e-13, 4e-13, 7e-13, 1e-12, 2e-12, 5e-12, 1e-11, 1e-10})
        for (int i = 0; i < 12; ++i)
        {
          const auto face = square.plane.data.faces[uniform_index(random, square.plane.data.faces.size())];
          const int corner = int(uniform_index(random, 3));
          const double t = uniform(random, 0.2, 0.8);
          Face_location end(face, {{0, 0, 0}}), start(face, {{0, 0, 0}});
          end.second[corner] = off;
          end.second[(corner + 1) % 3] = t;
          end.second[(corner + 2) % 3] = 1 - t - off;
          start.second = random_barycentric(random, 0.1);
          const Point_3 p = locations.point(start), q = locations.point(end);
          double room = 4;
          for (const Point_3& z : {p, q}) room = (std::min)({room, z.x(), z.y(), 4 - z.x(), 4 - z.y()});
          if (room < 0.1) continue;
          const double length = std::sqrt(CGAL::squared_distance(p, q)), level = uniform(random, 0.3, 0.95) * room;
          Report::instance().set_context("an end beside an edge, by " + std::to_string(off * 1e12) + "e-12, side " +
                                         std::to_string(side));
          for (const bool is_reversed : {false, true})
          {
            Geodesic geodesic(square.mesh);
            geodesic.add_source_polyline(is_reversed ? std::vector<Face_location>{end, start}
                                                     : std::vector<Face_location>{start, end});
            geodesic.build(CGAL::parameters::keep_windows(true));
            for (const CGAL::Offset_side s : {CGAL::Offset_side::LEFT, CGAL::Offset_side::RIGHT})
            {
              const double l = total_length(offsets(geodesic, level, {s, CGAL::Offset_end::BUTT}));
              // a straight piece touches the arc behind it, so their joint moves by the square root of rounding
              CHECK_DETAIL(std::abs(l - length) <= 1e-5 * level, values(l, length));
            }
            const double all = total_length(offsets(geodesic, level));
            CHECK_DETAIL(std::abs(all - 2 * length - 2 * pi * level) <= 1e-9 * all, values(all, 2 * length + 2 * pi * level));
          }
        }
    }
}

// Rays of a source near the tip of a cone of needles cross thousands of faces around it, but only the first round of them is of
// shortest paths.
void beside_the_tip_of_a_narrow_cone()
{
  for (const std::size_t n : {std::size_t(3), std::size_t(5), std::size_t(40)})
    for (const double radius : {1e-3, 1e-4, 1e-6})
      for (const double part : {1e-3, 1e-5, 1e-8})
      {
        Surface_mesh mesh;
        const auto tip = mesh.add_vertex(Point_3(0, 0, 0));
        std::vector<Surface_mesh::Vertex_index> rim;
        for (std::size_t i = 0; i < n; ++i)
        {
          const double angle = 2 * pi * double(i) / double(n);
          rim.push_back(mesh.add_vertex(Point_3(radius * std::cos(angle), radius * std::sin(angle), 1)));
        }
        for (std::size_t i = 0; i < n; ++i) mesh.add_face(tip, rim[(i + 1) % n], rim[i]);
        Face_location l(Surface_mesh::Face_index(0), {part / 2, part / 2, part / 2});
        auto h = mesh.halfedge(l.first);
        for (double& w : l.second)
        {
          if (mesh.source(h) == tip) w = 1 - part;
          h = mesh.next(h);
        }
        Geodesic geodesic(mesh);
        geodesic.add_source_point(l);
        const auto field = geodesic.build(CGAL::parameters::keep_windows(true));
        const Point_3 source = Locations<Surface_mesh>(mesh).point(l);
        for (const Surface_mesh::Vertex_index v : {tip, rim[0], rim[1]}) // in the face of the source, so the path is straight
        {
          const double d = std::sqrt(CGAL::squared_distance(source, mesh.point(v)));
          CHECK_DETAIL(std::abs(field.distance_to_sources(v) - d) <= 1e-14, values(field.distance_to_sources(v), d));
        }
        // elsewhere, it is at most the way over the tip
        const double over_tip = std::sqrt(CGAL::squared_distance(source, mesh.point(tip)));
        for (const Surface_mesh::Vertex_index v : rim)
        {
          const double d = field.distance_to_sources(v), length = std::sqrt(1 + radius * radius);
          CHECK_DETAIL(d <= length + over_tip + 1e-14 && d >= length - over_tip - 1e-14, values(d, length));
        }
      }
}

// Two polylines in line along an edge, with a gap between their ends, and the same start value: it does not make the gap smaller.
void gap_between_sources_with_start_values()
{
  Surface_mesh mesh;
  std::vector<Surface_mesh::Vertex_index> v;
  for (const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.3, 1, 0.2), Point_3(0.6, -1, 0.4)})
    v.push_back(mesh.add_vertex(p));
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[1], v[0], v[3]);
  const Locations<Surface_mesh> locations(mesh);
  const auto h = mesh.halfedge(v[0], v[1]);
  for (const double start : {0., 0.1, 3., 1e3})
    for (double gap = 1e-3; gap > 1e-10; gap /= 3)
    {
      Geodesic geodesic(mesh);
      const std::pair<double, double> ends[] = {{0.1, 0.4}, {0.4 + gap, 0.9}};
      for (const auto& [from, to] : ends)
        geodesic.add_source_polyline(std::vector<Face_location>{locations.on_edge(h, from), locations.on_edge(h, to)},
                                     CGAL::parameters::start_value(start));
      const auto field = geodesic.build(CGAL::parameters::keep_windows(true));
      Report::instance().set_context("gap of " + std::to_string(gap) + ", start value " + std::to_string(start));
      for (const double part : {0.1, 0.25, 0.5, 0.9})
      {
        const double d = field.distance_to_sources(locations.on_edge(h, 0.4 + part * gap)),
                     expected = start + gap * (std::min)(part, 1 - part);
        CHECK_DETAIL(std::abs(d - expected) <= 1e-13 * (1 + start), values(d, expected));
      }
    }
}

// A short segment along an edge, from a vertex with a corner of nearly half a turn: the half turn behind the segment, less the
// uncertainty of its direction, may end in this corner.
void ends_in_corner_of_nearly_half_a_turn()
{
  for (double height = 1e-7; height > 1e-12; height /= 3)
  {
    const Point_3 p[] = {{0, 0, 0}, {0.75, height, 0}, {-0.25, height, 0}, {-0.25, 1, 0}, {0.75, 1, 0}, {0.25, -1, 0}};
    Surface_mesh mesh;
    std::vector<Surface_mesh::Vertex_index> v;
    for (const Point_3& q : p) v.push_back(mesh.add_vertex(q));
    for (const auto& f : {std::array<int, 3>{0, 1, 2}, {2, 1, 4}, {2, 4, 3}, {0, 2, 5}, {0, 5, 1}})
      mesh.add_face(v[f[0]], v[f[1]], v[f[2]]);
    const Locations<Surface_mesh> locations(mesh);
    for (const int other : {1, 2}) // the segment lies on either edge of the corner
      for (double part = 1e-3; part > 1e-6; part /= 3)
        for (const bool is_reversed : {false, true})
        {
          const auto h = mesh.halfedge(v[0], v[other]);
          std::vector<Face_location> ends{locations.on_edge(h, 0), locations.on_edge(h, part)};
          if (is_reversed) std::swap(ends[0], ends[1]);
          Geodesic geodesic(mesh);
          geodesic.add_source_polyline(ends);
          const auto field = geodesic.build();
          Report::instance().set_context("corner of nearly half a turn, height " + std::to_string(height));
          for (std::size_t i = 0; i < v.size(); ++i)
          {
            const double d = field.distance_to_sources(v[i]),
                         expected =
                           std::sqrt(CGAL::squared_distance(p[i], Kernel::Segment_3(p[0], p[0] + part * (p[other] - p[0]))));
            CHECK_DETAIL(std::abs(d - expected) <= 1e-13, values(d, expected));
          }
        }
  }
}

// Points next to edges of flat ribbons, whose start values are next to their distances from another source. The distance is
// that of the nearest source in the plane. From an attack: rays through the edge next to such a point were lost.
void points_beside_edges_of_ribbons()
{
  struct Source
  {
    Point_3 point;
    double start;
  };
  for (unsigned seed = 1; seed <= 3000; ++seed)
  {
    std::mt19937_64 random(seed);
    const auto number = [&] { return double(random() >> 11) * 0x1p-53; }; // below 1
    const auto choice = [&](unsigned n) { return unsigned(random() % n); };
    const double height = std::pow(10., -5 * number());
    const std::size_t size = 2 + choice(6);
    Surface_mesh mesh;
    const auto border = [&](double y) {
      std::vector<double> x{0, 1};
      while (x.size() < size)
        x.push_back(choice(2) == 0 ? number()
                                   : x[choice(unsigned(x.size()))] + std::pow(10., -1 - 4 * number()) * (choice(2) ? 1 : -1));
      std::sort(x.begin(), x.end());
      std::vector<Surface_mesh::Vertex_index> result;
      for (const double a : x)
        if (a >= 0 && a <= 1 && (result.empty() || a > mesh.point(result.back()).x() + 1e-9))
          result.push_back(mesh.add_vertex(Point_3(a, y, 0)));
      return result;
    };
    const auto lower = border(0), upper = border(height);
    std::vector<Surface_mesh::Face_index> faces;
    for (std::size_t i = 0, j = 0; i + 1 < lower.size() || j + 1 < upper.size();)
    {
      bool is_lower =
        j + 1 == upper.size() || (i + 1 < lower.size() && mesh.point(lower[i + 1]).x() <= mesh.point(upper[j + 1]).x());
      if (choice(4) == 0 && i + 1 < lower.size() && j + 1 < upper.size()) is_lower = !is_lower;
      faces.push_back(is_lower ? mesh.add_face(lower[i], lower[i + 1], upper[j])
                               : mesh.add_face(lower[i], upper[j + 1], upper[j]));
      ++(is_lower ? i : j);
    }
    const auto place = [&](const Face_location& l) {
      CGAL::Vector_3<Kernel> sum(0, 0, 0);
      std::size_t k = 0;
      for (const auto v : CGAL::vertices_around_face(mesh.halfedge(l.first), mesh))
        sum = sum + l.second[++k % 3] * (mesh.point(v) - CGAL::ORIGIN); // begins with the target of the halfedge
      return CGAL::ORIGIN + sum;
    };
    const auto distance = [](const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); };
    Geodesic geodesic(mesh);
    std::vector<Source> sources{{mesh.point(lower[choice(unsigned(lower.size()))]), 0}};
    for (const auto v : lower)
      if (mesh.point(v) == sources[0].point) geodesic.add_source_point(v);
    for (unsigned n = 1 + choice(3); n > 0; --n)
    {
      const double from_edge = choice(4) != 0 ? std::pow(10., -8 - 9 * number()) : 0, along = number() * (1 - from_edge);
      Face_location l(faces[choice(unsigned(faces.size()))], {{1 - along - from_edge, along, from_edge}});
      std::rotate(l.second.begin(), l.second.begin() + choice(3), l.second.end());
      const Point_3 p = place(l);
      const double far = distance(p, sources[0].point), start = far - std::pow(10., -7 - 8 * number()) * far;
      geodesic.add_source_point(l, CGAL::parameters::start_value(start));
      sources.push_back({p, start});
    }
    geodesic.build();
    Report::instance().set_context("ribbon " + std::to_string(seed));
    for (const auto v : mesh.vertices())
    {
      double expected = std::numeric_limits<double>::infinity();
      for (const Source& s : sources) expected = (std::min)(expected, s.start + distance(s.point, mesh.point(v)));
      const double d = geodesic.distance_to_sources(v);
      CHECK_DETAIL(std::abs(d - expected) <= 2e-12 * (1 + expected), values(d, expected));
    }
  }
}

} // namespace test_degenerate_sources

GEODESIC_OFFSET_TEST(test_degenerate_sources)
{
  sources_that_meet();
  segments_between_edges();
  ends_beside_edges();
  beside_the_tip_of_a_narrow_cone();
  gap_between_sources_with_start_values();
  ends_in_corner_of_nearly_half_a_turn();
  points_beside_edges_of_ribbons();
  print_level_totals();
  return Report::instance().finish("test_degenerate_sources");
}
