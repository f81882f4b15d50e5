// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Sides of polylines in the plane against closed forms: signed distances at vertices and elsewhere, sides of pieces, butt
// and round ends of open polylines.

#include "planar_polyline.h"

#include <string>
#include <vector>

namespace test_signed_distance {

using namespace test;
using CGAL::Offset_end;
using CGAL::Offset_side;
using CGAL::Source_side;

struct Totals
{
  std::size_t signs = 0, undecided = 0, pieces = 0, caps = 0;
  Worst_error error{1e-12, 16};
};

void check_signed(double actual, const std::pair<double, int>& expected, Totals& totals)
{
  if (std::isnan(actual))
  {
    ++totals.caps;
    CHECK_DETAIL(expected.second == Signed_distance::CAP || expected.second == 0, values(expected.first, expected.second));
    return;
  }
  CHECK_CLOSE(totals.error, std::abs(actual), expected.first);
  CHECK_DETAIL(expected.second != Signed_distance::CAP || expected.first < 1e-9, values(actual, expected.first));
  if (expected.second == 0) ++totals.undecided;
  else ++totals.signs;
  if (expected.second == Signed_distance::LEFT) CHECK_DETAIL(actual < 0, values(actual, -expected.first));
  if (expected.second == Signed_distance::RIGHT) CHECK_DETAIL(actual > 0, values(actual, expected.first));
}

// One polyline on a planar mesh: the signed distance, and the side of each piece of some offsets.
void compare_with_plane(Planar_mesh& plane, const Planar_mesh::Path& path, bool closed, Totals& totals)
{
  const Geodesic geodesic = built(plane.data.mesh, {polyline_source(path.locations, closed)});
  const Signed_distance expected(path.legs, closed);
  const double margin = 1e-9;
  for (auto v : plane.data.vertices)
    check_signed(or_nan(geodesic.signed_distance_to_sources(v)),
                 expected(plane.uv(plane.generator.locations().at_vertex(v)), margin), totals);
  for (int i = 0; i < 200; ++i)
  {
    const Face_location l = plane.generator.random_location(0);
    check_signed(or_nan(geodesic.signed_distance_to_sources(l)), expected(plane.uv(l), margin), totals);
  }
  for (const Face_location& l : path.locations)
  {
    const double d = or_nan(geodesic.signed_distance_to_sources(l));
    CHECK_DETAIL(std::abs(d) <= 1e-14 * 16, values(d, 0));
  }
  for (double level : {0.037, 0.25, 1., 1.7})
    for (const Offset_curve& curve : offsets(geodesic, level))
      for (const Offset_piece& piece : curve.pieces())
      {
        if (piece.length() < 1e-8) continue;
        const auto plane_side = expected(plane.uv(piece.location(0.5)), margin);
        if (plane_side.second != 0)
          CHECK_DETAIL(int(piece.side()) == plane_side.second,
                       std::to_string(int(piece.side())) + " is not " + std::to_string(plane_side.second));
        const double d = or_nan(geodesic.signed_distance_to_sources(piece.location(0.5)));
        switch (piece.side())
        {
        case Source_side::LEFT: CHECK_DETAIL(std::abs(d + level) <= 1e-12 * 16, values(d, -level)); break;
        case Source_side::RIGHT: CHECK_DETAIL(std::abs(d - level) <= 1e-12 * 16, values(d, level)); break;
        default: CHECK_DETAIL(std::isnan(d) && !closed, values(d, level));
        }
        ++totals.pieces;
      }
}

void random_polylines()
{
  Totals totals;
  const std::pair<const char*, Soup> soups[] = {
    {"rectangle", random_rectangle(4, 3, 120, 6, 1)},
    {"turned rectangle", rotated(random_rectangle(4, 3, 120, 6, 2), 3)},
    {"two triangles", random_rectangle(4, 3, 0, 0, 1)},
    {"jittered grid", jittered_grid(9, 7, 4)},
    {"forward grid", planar_grid(8, 8, Diagonals::forward, 0.5)},
    {"backward grid", planar_grid(8, 8, Diagonals::backward, 0.5)},
    {"alternating grid", planar_grid(8, 8, Diagonals::alternating, 0.5)},
    {"random grid", planar_grid(8, 8, Diagonals::random, 0.5)}};
  for (const auto& soup : soups)
    for (unsigned seed = 1; seed <= 12; ++seed)
      for (const bool closed : {false, true})
      {
        Report::instance().set_context(std::string(soup.first) + (closed ? ", closed" : ", open") + ", seed " +
                                       std::to_string(seed));
        guarded([&] {
          Planar_mesh plane(soup.second, seed);
          const auto path = plane.generator.random_path(closed ? 2 + seed % 5 : 1 + seed % 6, closed);
          compare_with_plane(plane, path, closed, totals);
        });
      }
  std::cout << totals.signs << " signs, " << totals.undecided << " on a line between two sides, " << totals.caps
            << " beyond ends; worst relative error of the distance " << totals.error.error() << "; " << totals.pieces
            << " pieces" << std::endl;
}

struct Expected_curve
{
  bool closed;
  double length;
  Point_2 start, end; // of an open curve
};

// Compares with expected curves, in any order; `straight`: all pieces are segments.
void check_curves(const Planar_mesh& plane, const Geodesic& geodesic, double level, Offset_side side, Offset_end end,
                  std::vector<Expected_curve> expected, bool straight)
{
  const Offset_curves curves = offsets(geodesic, level, {side, end});
  CHECK_DETAIL(curves.size() == expected.size(), std::to_string(curves.size()) + " curves");
  for (const Offset_curve& curve : curves)
  {
    const Point_2 s = plane.uv(curve.piece(0).start()), e = plane.uv(curve.piece(curve.number_of_pieces() - 1).end());
    const auto found = std::find_if(expected.begin(), expected.end(), [&](const Expected_curve& x) {
      return curve.is_closed() == x.closed && std::abs(curve.length() - x.length) <= 1e-11 * x.length &&
             (x.closed || (distance(s, x.start) <= 1e-11 && distance(e, x.end) <= 1e-11));
    });
    CHECK_DETAIL(found != expected.end(),
                 "length " + std::to_string(curve.length()) + " from " + std::to_string(s.x()) + ' ' + std::to_string(s.y()) +
                   " to " + std::to_string(e.x()) + ' ' + std::to_string(e.y()));
    if (found != expected.end()) expected.erase(found);
    for (const Offset_piece& p : curve.pieces()) // only pieces shorter than the shift of levels may be round
      if (straight && p.length() > 1e-12 * level) CHECK(p.is_segment() && p.angle() == 0 && p.is_nearest_to_segment());
  }
}

// One segment: the stadium, cut at the ends of its straight sides.
void one_segment(const Planar_mesh& plane, const Point_2& a, const Point_2& b, double level)
{
  Report::instance().set_context("segment at level " + std::to_string(level));
  const Geodesic geodesic = plane.field({{a, b}});
  const double length = distance(a, b), round = CGAL_PI * level;
  const Vector_2 n = level / length * Vector_2(-(b - a).y(), (b - a).x());
  // the source is on the left of the curves
  const Expected_curve left{false, length, b + n, a + n}, right{false, length, a - n, b - n};
  const Expected_curve stadium{true, 2 * (length + round), a, a};
  check_curves(plane, geodesic, level, Offset_side::LEFT, Offset_end::BUTT, {left}, true);
  check_curves(plane, geodesic, level, Offset_side::RIGHT, Offset_end::BUTT, {right}, true);
  check_curves(plane, geodesic, level, Offset_side::BOTH, Offset_end::BUTT, {left, right}, true);
  check_curves(plane, geodesic, level, Offset_side::BOTH, Offset_end::ROUND, {stadium}, false);
  check_curves(plane, geodesic, level, Offset_side::LEFT, Offset_end::ROUND, {{false, length + 2 * round, b - n, a - n}},
               false);
  check_curves(plane, geodesic, level, Offset_side::RIGHT, Offset_end::ROUND, {{false, length + 2 * round, a + n, b + n}},
               false);

  const Geodesic back = plane.field({{b, a}});
  check_curves(plane, back, level, Offset_side::RIGHT, Offset_end::BUTT, {left}, true);
  check_curves(plane, back, level, Offset_side::LEFT, Offset_end::BUTT, {right}, true);
}

// Two legs with a right angle to the left at (2, 2).
void corner(const Planar_mesh& plane, double level)
{
  Report::instance().set_context("corner at level " + std::to_string(level));
  const Geodesic geodesic = plane.field({{Point_2(1, 2), Point_2(2, 2), Point_2(2, 3)}});
  const double quarter = CGAL_PI / 2 * level;
  const Expected_curve left{false, 2 * (1 - level), Point_2(2 - level, 3), Point_2(1, 2 + level)};
  const Expected_curve right{false, 2 + quarter, Point_2(1, 2 - level), Point_2(2 + level, 3)};
  check_curves(plane, geodesic, level, Offset_side::LEFT, Offset_end::BUTT, {left}, true);
  check_curves(plane, geodesic, level, Offset_side::RIGHT, Offset_end::BUTT, {right}, false);
  check_curves(plane, geodesic, level, Offset_side::BOTH, Offset_end::BUTT, {left, right}, false);
  check_curves(plane, geodesic, level, Offset_side::BOTH, Offset_end::ROUND,
               {{true, 2 * (1 - level) + 2 + 5 * quarter, Point_2(0, 0), Point_2(0, 0)}}, false);
}

void ends_of_open_polylines()
{
  for (const Diagonals diagonals : {Diagonals::forward, Diagonals::backward, Diagonals::alternating, Diagonals::random})
  {
    const Planar_mesh grid(planar_grid(8, 8, diagonals, 0.5)), fine(planar_grid(16, 16, diagonals, 0.25));
    for (const Planar_mesh* plane : {&grid, &fine})
      for (double level : {0.01, 0.25, 0.3, 0.5, 0.9})
      {
        one_segment(*plane, Point_2(1, 2), Point_2(3, 2),
                    level);                                               // along edges, from vertex to vertex
        one_segment(*plane, Point_2(1.25, 2), Point_2(2.75, 2), level);   // between vertices
        one_segment(*plane, Point_2(1, 1), Point_2(3, 3), level);         // along diagonals, or across them
        one_segment(*plane, Point_2(1.1, 1.7), Point_2(2.9, 2.4), level); // anywhere
        if (level < 0.8) corner(*plane, level);
      }
  }
  const Planar_mesh rectangle(random_rectangle(4, 4, 150, 5, 3)), turned(rotated(random_rectangle(4, 4, 150, 5, 3), 4));
  for (const Planar_mesh* plane : {&rectangle, &turned})
    for (double level : {0.01, 0.4, 0.9}) one_segment(*plane, Point_2(1.1, 1.7), Point_2(2.9, 2.4), level);
}

// Sources without sides, unreachable points, and points on the polyline.
void no_side()
{
  Report::instance().set_context("no side");
  const Planar_mesh plane(planar_grid(4, 4, Diagonals::alternating));
  Generated_mesh<test::Surface_mesh> two([] {
    Soup soup = planar_grid(2, 2), other = planar_grid(2, 2);
    const std::size_t n = soup.points.size();
    for (const Point_3& p : other.points) soup.points.push_back(p + Vector_3(9, 0, 0));
    for (const auto& t : other.triangles) soup.add_triangle({{t[0] + n, t[1] + n, t[2] + n}});
    return soup;
  }());
  const auto vertex = [&](std::size_t i, std::size_t j) { return plane.data.vertices[5 * j + i]; };

  Geodesic geodesic(plane.data.mesh);
  geodesic.add_source_point(vertex(2, 2));
  CHECK_THROWS(geodesic.signed_distance_to_sources(vertex(0, 0)), std::logic_error);
  geodesic.build();
  CHECK(!geodesic.signed_distance_to_sources(vertex(0, 2)));
  CHECK(geodesic.signed_distance_to_sources(vertex(2, 2)) == 0);
  CHECK_THROWS(geodesic.signed_distance_to_sources(plane.location(Point_2(0.3, 0.4))), std::logic_error);

  geodesic.clear_sources();
  geodesic.add_source_edges(std::vector<test::Surface_mesh::Edge_index>{
    plane.data.mesh.edge(plane.data.mesh.halfedge(vertex(1, 1), vertex(2, 1)))});
  geodesic.build(CGAL::parameters::keep_windows(true));
  CHECK(!geodesic.signed_distance_to_sources(vertex(1, 3)));
  CHECK(!geodesic.signed_distance_to_sources(plane.location(Point_2(1.5, 0.3))));
  CHECK(geodesic.signed_distance_to_sources(plane.location(Point_2(1.5, 1))) == 0);

  // a polyline of one point is a point
  geodesic.clear_sources();
  geodesic.add_source_polyline(std::vector<Face_location>(3, plane.location(Point_2(1.5, 1.25))));
  geodesic.build(CGAL::parameters::keep_windows(true));
  CHECK(!geodesic.signed_distance_to_sources(vertex(1, 3)));

  Geodesic apart(two.mesh);
  const Locations<test::Surface_mesh> on_two(two.mesh);
  apart.add_source_polyline(std::vector<Face_location>{on_two.at_vertex(two.vertices[0]), on_two.at_vertex(two.vertices[1])});
  apart.build(CGAL::parameters::distance_limit(1.5).keep_windows(true));
  CHECK(apart.signed_distance_to_sources(two.vertices[9]) == infinity); // another part
  CHECK(apart.signed_distance_to_sources(two.vertices[7]) == infinity); // (1, 2) is beyond the maximum distance
  CHECK(apart.signed_distance_to_sources(on_two.at_vertex(two.vertices[12], 1)) == infinity);
  CHECK(!apart.signed_distance_to_sources(two.vertices[5]));   // (2, 1), beyond the end
  Face_location inside(two.faces[0], {{0.125, 0.125, 0.125}}); // (0.25, 0.125)
  const auto corners = on_two.corners(two.faces[0]);
  inside.second[static_cast<std::size_t>(std::find(corners.begin(), corners.end(), two.vertices[0]) - corners.begin())] = 0.75;
  CHECK(apart.signed_distance_to_sources(inside) == -0.125);
}

// Polylines along the edges of grids in general position, where all windows meet at vertices of the polyline and rounding
// decides which of them update the vertex: the sides of all vertices, and the inner side.
void along_edges_of_grids()
{
  Totals totals;
  for (unsigned seed = 1; seed <= 120; ++seed)
  {
    const std::size_t n = 4 * (1 + seed % 8), first = n / 4, last = 3 * n / 4;
    Report::instance().set_context("grid " + std::to_string(n) + ", seed " + std::to_string(seed));
    const Generated_mesh<test::Surface_mesh> data(
      rotated(planar_grid(n, n, seed % 2 ? Diagonals::forward : Diagonals::random, 1, 0, seed), seed));
    const Locations<test::Surface_mesh> locations(data.mesh);
    std::vector<Face_location> polyline;
    std::vector<Leg> legs;
    const auto add = [&](std::size_t i, std::size_t j) {
      const Point_2 p(static_cast<double>(i), static_cast<double>(j));
      if (!legs.empty()) legs.back().b = p;
      legs.push_back({0, p, p});
      polyline.push_back(locations.at_vertex(data.vertices[j * (n + 1) + i], seed));
    };
    for (std::size_t i = first; i < last; ++i) add(i, first);
    for (std::size_t j = first; j < last; ++j) add(last, j);
    for (std::size_t i = last; i > first; --i) add(i, last);
    const bool closed = seed % 3 != 0;
    if (closed)
      for (std::size_t j = last; j > first; --j) add(first, j);
    if (closed) legs.back().b = legs.front().a;
    else legs.pop_back();
    const Geodesic geodesic = built(data.mesh, {polyline_source(polyline, closed)});
    const Signed_distance expected(legs, closed);
    for (std::size_t i = 0; i < data.vertices.size(); ++i)
    {
      const Point_2 p(static_cast<double>(i % (n + 1)), static_cast<double>(i / (n + 1)));
      check_signed(or_nan(geodesic.signed_distance_to_sources(data.vertices[i])), expected(p, 1e-9), totals);
    }
    if (!closed) continue;
    const double level = 0.4, width = static_cast<double>(last - first);
    Offset_curves inside;
    geodesic.offset_curves(level, std::back_inserter(inside), CGAL::parameters::offset_side(Offset_side::INSIDE));
    CHECK(inside.size() == 1);
    for (const Offset_curve& curve : inside) CHECK_CLOSE(totals.error, curve.length(), 4 * (width - 2 * level));
  }
  std::cout << "along edges of grids: " << totals.signs << " signs, " << totals.undecided << " undecided, " << totals.caps
            << " beyond ends" << std::endl;
}

} // namespace test_signed_distance

GEODESIC_OFFSET_TEST(test_signed_distance)
{
  std::cout.precision(3);
  random_polylines();
  ends_of_open_polylines();
  no_side();
  along_edges_of_grids();
  return Report::instance().finish("test_signed_distance");
}
