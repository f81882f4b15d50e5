// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets inside and outside of closed polylines: inside is the side without border, or else the one with the smaller area,
// independent of the polyline's direction. Polylines without inside are rejected.

#include "locations.h"
#include "planar_polyline.h"
#include "plane_section.h"

#include <CGAL/Surface_mesh_geodesic_offset/geodesic_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Inner_sides.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/source_classification.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_inner_sides {

using namespace test;
using CGAL::Offset_end;
using CGAL::Offset_side;

typedef std::vector<Point_2> Line;
typedef Generated_mesh<test::Surface_mesh> Data;

Line reversed(const Line& line) { return Line(line.rbegin(), line.rend()); }

void check(const Geodesic& geodesic, double level, Offset_side side, std::size_t curves, double length)
{
  const Offset_curves found = offsets(geodesic, level, side);
  CHECK_DETAIL(found.size() == curves && number_of_closed(found) == curves,
               std::to_string(found.size()) + " curves, " + std::to_string(number_of_closed(found)) + " closed");
  CHECK_DETAIL(std::abs(total_length(found) - length) <= 1e-11 * length, values(total_length(found), length));
}

// A square of side 2 around (2, 2), in both directions.
void squares(const std::string& name, const Planar_mesh& plane)
{
  const Line square{{1, 1}, {3, 1}, {3, 3}, {1, 3}};
  for (const bool clockwise : {false, true})
    for (const bool keep : {true, false})
    {
      Report::instance().set_context(name + (clockwise ? ", clockwise" : ", counterclockwise"));
      Geodesic geodesic(plane.data.mesh);
      plane.add(geodesic, clockwise ? reversed(square) : square, true);
      geodesic.build(CGAL::parameters::keep_windows(keep));
      for (double d : {0.125, 0.25, 0.5, 0.75})
      {
        const double inner = 8 * (1 - d), outer = 8 + 2 * CGAL_PI * d;
        check(geodesic, d, Offset_side::INSIDE, 1, inner);
        check(geodesic, d, Offset_side::OUTSIDE, 1, outer);
        check(geodesic, d, Offset_side::BOTH, 2, inner + outer);
        check(geodesic, d, clockwise ? Offset_side::RIGHT : Offset_side::LEFT, 1, inner);
        check(geodesic, d, clockwise ? Offset_side::LEFT : Offset_side::RIGHT, 1, outer);
      }
    }
}

// A clockwise hole in a counterclockwise square: the left of both is the ring, the inside of each is its own.
void hole(const Planar_mesh& plane)
{
  Report::instance().set_context("a hole");
  const Line outer{{0.75, 0.75}, {3.25, 0.75}, {3.25, 3.25}, {0.75, 3.25}};
  const Line inner{{1.75, 1.75}, {2.25, 1.75}, {2.25, 2.25}, {1.75, 2.25}};
  const Geodesic geodesic = plane.field({outer, reversed(inner)}, true);
  const double d = 0.125, round = 2 * CGAL_PI * d;
  check(geodesic, d, Offset_side::LEFT, 2, 10 - 8 * d + 2 + round);
  check(geodesic, d, Offset_side::RIGHT, 2, 10 + round + 2 - 8 * d);
  check(geodesic, d, Offset_side::INSIDE, 2, 10 - 8 * d + 2 - 8 * d);
  check(geodesic, d, Offset_side::OUTSIDE, 2, 10 + round + 2 + round);
}

// More than half of the surface: nevertheless inside, as the rest has the border.
void large(const Planar_mesh& plane)
{
  Report::instance().set_context("a large square");
  for (const bool clockwise : {false, true})
  {
    Geodesic geodesic(plane.data.mesh);
    const Line square{{0.5, 0.5}, {3.5, 0.5}, {3.5, 3.5}, {0.5, 3.5}}; // 9 of 16
    plane.add(geodesic, clockwise ? reversed(square) : square, true);
    geodesic.build(CGAL::parameters::keep_windows(true));
    check(geodesic, 0.25, Offset_side::INSIDE, 1, 12 - 8 * 0.25);
    check(geodesic, 0.25, Offset_side::OUTSIDE, 1, 12 + 2 * CGAL_PI * 0.25);
  }
}

// Along the border, and within rounding of it, the only side is inside. A wider strip has the border, so it is outside.
void along_border(const std::string& name, const Planar_mesh& plane)
{
  const auto square = [](double e) { return Line{{e, e}, {4 - e, e}, {4 - e, 4 - e}, {e, 4 - e}}; };
  for (const bool clockwise : {false, true})
  {
    Report::instance().set_context(name + ", border" + (clockwise ? ", clockwise" : ""));
    const auto add = [&](Geodesic& geodesic, double e) {
      plane.add(geodesic, clockwise ? reversed(square(e)) : square(e), true);
    };
    for (const double e : {0., 1e-6})
    {
      Geodesic geodesic(plane.data.mesh);
      add(geodesic, e);
      geodesic.build(CGAL::parameters::keep_windows(true));
      check(geodesic, 0.25, Offset_side::INSIDE, 1, 4 * (4 - 2 * e) - 8 * 0.25);
      CHECK(offsets(geodesic, 0.25, Offset_side::OUTSIDE).empty());
    }
    Geodesic geodesic(plane.data.mesh);
    const double e = 0.03125;
    add(geodesic, e);
    geodesic.build(CGAL::parameters::keep_windows(true));
    check(geodesic, e / 2, Offset_side::OUTSIDE, 1, 4 * (4 - 2 * e) + CGAL_PI * e);
    check(geodesic, 0.25, Offset_side::INSIDE, 1, 4 * (4 - 2 * e) - 8 * 0.25);
  }
}

// Around a hole of the surface, the only side encloses nothing, but exists.
void round_hole()
{
  const Soup grid = planar_grid(8, 8, Diagonals::alternating, 0.5);
  const std::size_t middle = 4 * 9 + 4; // a vertex without faces
  Soup soup;
  soup.points = grid.points;
  soup.points.erase(soup.points.begin() + middle);
  for (std::size_t i = 0; i < grid.triangles.size(); ++i)
  {
    std::array<std::size_t, 3> corners = grid.triangles[i];
    const Point_3 center = CGAL::centroid(grid.points[corners[0]], grid.points[corners[1]], grid.points[corners[2]]);
    if (std::abs(center.x() - 2) < 0.5 && std::abs(center.y() - 2) < 0.5) continue;
    for (std::size_t& v : corners) v -= v > middle ? 1 : 0;
    soup.add_triangle(corners, 0, grid.uv[i]);
  }
  const Planar_mesh plane(soup);
  const Line hole{{1.5, 1.5}, {2.5, 1.5}, {2.5, 2.5}, {1.5, 2.5}};
  for (const Line& line : {hole, reversed(hole)})
  {
    Report::instance().set_context("round a hole");
    const Geodesic geodesic = plane.field({line}, true);
    check(geodesic, 0.25, Offset_side::INSIDE, 1, 4 + 2 * CGAL_PI * 0.25);
    CHECK(offsets(geodesic, 0.25, Offset_side::OUTSIDE).empty());
  }
}

// A square far smaller than its face has an inside, although samples of areas may miss it.
void tiny()
{
  const Planar_mesh plane(random_rectangle(4, 4, 0, 0, 1)); // two triangles
  const double e = 1. / 1024;
  for (const Point_2& p : {Point_2(3, 0.5), Point_2(2.1, 1.3), Point_2(1, 2.5)})
  {
    Report::instance().set_context("a tiny square");
    const Line square{p, p + Vector_2(e, 0), p + Vector_2(e, e), p + Vector_2(0, e)};
    const Geodesic geodesic = plane.field({square}, true);
    check(geodesic, e / 4, Offset_side::INSIDE, 1, 2 * e);
    check(geodesic, e / 4, Offset_side::OUTSIDE, 1, 4 * e + CGAL_PI * e / 2);
  }
}

// Points and edges are offset with any selection.
void with_points(const Planar_mesh& plane)
{
  Report::instance().set_context("with points");
  Geodesic geodesic(plane.data.mesh);
  const Line square{{1, 1}, {2, 1}, {2, 2}, {1, 2}};
  plane.add(geodesic, square, true);
  geodesic.add_source_point(plane.location(Point_2(3.25, 3.25)));
  geodesic.add_source_point(plane.location(Point_2(1.5, 1.5)));
  geodesic.build(CGAL::parameters::keep_windows(true));
  const double d = 0.125, circles = 2 * 2 * CGAL_PI * d, inner = 4 - 8 * d, outer = 4 + 2 * CGAL_PI * d;
  check(geodesic, d, Offset_side::INSIDE, 3, circles + inner);
  check(geodesic, d, Offset_side::OUTSIDE, 3, circles + outer);
  check(geodesic, d, Offset_side::LEFT, 3, circles + inner);
  check(geodesic, d, Offset_side::RIGHT, 3, circles + outer);
  for (const Offset_curve& curve : offsets(geodesic, d, Offset_side::OUTSIDE))
    for (const Offset_piece& piece : curve.pieces()) CHECK((piece.side() == CGAL::Source_side::NONE) == (piece.source() != 0));
  // a closed polyline without extent is a point
  geodesic.clear_sources();
  geodesic.add_source_polyline(std::vector<Face_location>(3, plane.location(Point_2(1.5, 1.5))),
                               CGAL::parameters::is_closed(true));
  geodesic.build();
  check(geodesic, d, Offset_side::INSIDE, 1, 2 * CGAL_PI * d);
}

// Within one face: all corners of the face are outside.
void in_one_face()
{
  const Planar_mesh plane(random_rectangle(4, 4, 0, 0, 1)); // two triangles
  const Line triangle{{3, 0.5}, {3.5, 0.5}, {3.5, 1}}, other{{0.5, 3}, {1, 3.5}, {0.5, 3.5}};
  for (const Line& line : {triangle, reversed(triangle), other, reversed(other)})
  {
    Report::instance().set_context("in one face");
    const Geodesic geodesic = plane.field({line}, true);
    const double perimeter = 1 + std::sqrt(0.5),
                 d = 0.0625;                // a right isosceles triangle with legs 1/2
    const double radius = 0.25 / perimeter; // inscribed radius: twice the area over the perimeter
    check(geodesic, d, Offset_side::INSIDE, 1, perimeter * (1 - d / radius));
    check(geodesic, d, Offset_side::OUTSIDE, 1, perimeter + 2 * CGAL_PI * d);
  }
}

// Sections of a cube at any height: the part with the smaller area is inside, however few faces it has.
void sections_of_boxes()
{
  for (std::size_t n : {0, 1, 4})
    for (double z : {0.1, 0.3, 0.45, 0.55, 0.7, 0.9})
      for (const double up : {1., -1.})
      {
        const Data box(n == 0 ? box_sides(1, 1, 1).triangulated(0, 0, 1) : cube_grid(n));
        Report::instance().set_context("cube of " + std::to_string(box.faces.size()) + " faces cut at " + std::to_string(z) +
                                       (up > 0 ? ", upper" : ", lower") + " side on the left");
        const auto sections = plane_section(box.mesh, Point_3(0, 0, z), Vector_3(0, 0, up));
        if (!CHECK(sections.size() == 1 && sections[0].closed)) continue;
        Geodesic geodesic(box.mesh);
        geodesic.add_source_polyline(sections[0].locations, CGAL::parameters::is_closed(true));
        geodesic.build(CGAL::parameters::keep_windows(true));
        for (const Offset_side side : {Offset_side::INSIDE, Offset_side::OUTSIDE})
        {
          const Offset_curves curves = offsets(geodesic, 0.05, side);
          CHECK_DETAIL(curves.size() == 1 && std::abs(total_length(curves) - 4) <= 1e-11,
                       std::to_string(curves.size()) + " curves");
          const bool above = (z > 0.5) == (side == Offset_side::INSIDE);
          for (const Offset_curve& c : curves)
            for (const Offset_piece& p : c.pieces()) CHECK((p.point(0.5).z() > z) == above);
        }
      }
}

// Each source has its own side, and the default cap style is that of its side.
void side_of_each(const Planar_mesh& plane)
{
  Report::instance().set_context("a pocket with an island");
  Geodesic geodesic(plane.data.mesh);
  const std::size_t pocket = plane.add(geodesic, {{0.5, 0.5}, {3.5, 0.5}, {3.5, 3.5}, {0.5, 3.5}}, true);
  const std::size_t island = plane.add(geodesic, {{1.5, 1.5}, {1.5, 2}, {2, 2}, {2, 1.5}}, true);
  const std::size_t line = plane.add(geodesic, {{2.5, 2.5}, {3, 2.5}});
  const double d = 0.0625, round = 2 * CGAL_PI * d;
  const auto length = [&](const auto& np) {
    Offset_curves curves;
    geodesic.build_with_offset_curves(d, std::back_inserter(curves), np);
    return total_length(curves);
  };
  const auto check_length = [](double found, double expected) {
    CHECK_DETAIL(std::abs(found - expected) <= 1e-11 * expected, values(found, expected));
  };
  std::map<std::size_t, Offset_side> sides{{pocket, Offset_side::INSIDE}, {island, Offset_side::OUTSIDE}};
  const double both = 12 - 8 * d + 2 + round;
  check_length(length(CGAL::parameters::offset_side(sides)), both + 1 + round); // the line has both sides
  check_length(length(CGAL::parameters::offset_side(sides).end_style(Offset_end::BUTT)), both + 1);
  sides[line] = Offset_side::LEFT;
  check_length(length(CGAL::parameters::offset_side(sides)), both + 0.5);
  check_length(length(CGAL::parameters::offset_side(sides).end_style(Offset_end::ROUND)), both + 0.5 + round);
  geodesic.remove_source(line);
  check_length(length(CGAL::parameters::offset_side(Offset_side::INSIDE)), 12 - 8 * d + 2 - 8 * d);
  const auto inner = geodesic.inner_sides();
  CHECK(inner.size() == 2 && inner.at(pocket).side == CGAL::Source_side::LEFT &&
        inner.at(island).side == CGAL::Source_side::RIGHT);
  check_length(inner.at(pocket).inner_area, 9);
  check_length(inner.at(pocket).outer_area, 7);
  CHECK(!inner.at(pocket).is_by_area && !inner.at(pocket).is_doubtful());
  // only the sides that are needed must exist
  plane.add(geodesic, {{2.5, 2.5}, {3, 2.5}});
  check_length(length(CGAL::parameters::offset_side(std::map<std::size_t, Offset_side>{{pocket, Offset_side::INSIDE},
                                                                                       {island, Offset_side::INSIDE}})),
               12 - 8 * d + 2 - 8 * d + 1 + round);
}

// Curves that cross themselves or lead back along themselves have no inside.
void crossed(const Planar_mesh& plane)
{
  const Line lines[] = {{{1, 1}, {3, 3}, {3, 1}, {1, 3}},                          // an eight
                        {{1, 1}, {3, 1}, {3, 3}, {1.5, 0.5}},                      // with a loop
                        {{1, 1}, {3, 1}, {3, 3.5}, {3, 3}, {1, 3}},                // with a spur
                        {{1, 1}, {3, 1}, {3.3, 3.4}, {3, 1}, {1, 3}, {1.2, 1.4}}}; // with a spur across faces
  for (const Line& line : lines)
  {
    Report::instance().set_context("crossed curve " + std::to_string(&line - lines));
    Geodesic geodesic(plane.data.mesh);
    plane.add(geodesic, line, true);
    CHECK(geodesic.inner_sides().at(0).side == CGAL::Source_side::NONE);
  }
}

// Without the parameter is_closed one rule decides for points and locations, in functions and in the class.
void closing(const Planar_mesh& plane)
{
  const double d = 0.125, length = 8;
  const std::pair<double, CGAL::Polyline_closing> gaps[] = {
    {0, CGAL::Polyline_closing::CLOSED},           {1e-16, CGAL::Polyline_closing::CLOSED},
    {1e-12, CGAL::Polyline_closing::CLOSED},       {1e-10, CGAL::Polyline_closing::CLOSED},
    {0.99e-9, CGAL::Polyline_closing::CLOSED},     {1.01e-9, CGAL::Polyline_closing::NEARLY_CLOSED},
    {1e-6, CGAL::Polyline_closing::NEARLY_CLOSED}, {0.99e-4, CGAL::Polyline_closing::NEARLY_CLOSED},
    {1.01e-4, CGAL::Polyline_closing::OPEN},       {1e-3, CGAL::Polyline_closing::OPEN}};
  for (const auto& [gap, expected] : gaps)
  {
    Report::instance().set_context("gap " + std::to_string(gap));
    const Line square{{1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1 + gap * length}};
    std::vector<Point_3> points;
    for (const Point_2& p : square) points.push_back(Point_3(p.x(), p.y(), 0));
    const bool closed = expected == CGAL::Polyline_closing::CLOSED;
    CHECK(CGAL::polyline_closing(points) == expected);
    Geodesic geodesic(plane.data.mesh);
    CHECK(geodesic.locate_polyline(points).is_closed == closed);
    CHECK(geodesic.locate_polyline(points).locations ==
          geodesic.locate_polyline(points, CGAL::parameters::is_closed(closed)).locations);
    const auto joined = plane.path(square, false).locations;
    CHECK(geodesic.join_polyline(joined).is_closed == closed);
    CHECK(!geodesic.join_polyline(joined, CGAL::parameters::is_closed(false)).is_closed);
    geodesic.add_source_polyline(joined);
    CHECK((geodesic.sources().sources().begin()->second.kind == Geodesic::Source_set::Kind::CLOSED_POLYLINE) == closed);
    geodesic.build(CGAL::parameters::keep_windows(true));
    if (closed) CHECK(std::abs(total_length(offsets(geodesic, d, Offset_side::INSIDE)) - (8 - 8 * d)) <= 1e-7);
    std::vector<Offset_curve> curves;
    CGAL::geodesic_offset_curves(plane.data.mesh, points, d, std::back_inserter(curves));
    const double expected_length = 16 - 8 * d + 2 * CGAL_PI * d;
    if (closed) CHECK(std::abs(total_length(curves) - expected_length) <= 1e-9);
    Geodesic::Source_set set; // without a mesh: equal locations
    set.add_polyline(joined);
    CHECK((set.sources().begin()->second.kind == Geodesic::Source_set::Kind::CLOSED_POLYLINE) ==
          (joined.front() == joined.back()));
  }
  // there and back is open
  CHECK(CGAL::polyline_closing(std::vector<Point_3>{{1, 1, 0}, {2, 2, 0}, {1, 1, 0}}) == CGAL::Polyline_closing::OPEN);
}

template <class Function>
void check_refused(const Function& f, const std::string& what)
{
  std::string message = "nothing was thrown";
  try
  {
    f();
  }
  catch (const std::invalid_argument& e)
  {
    message = e.what();
  }
  CHECK_DETAIL(message.find(what) != std::string::npos, message);
}

// All functions reject both selections; left, right and the last build remain available.
void check_without_inside(const test::Surface_mesh& mesh, const std::vector<Face_location>& locations, bool closed,
                          double level, const std::string& what)
{
  Geodesic geodesic(mesh);
  geodesic.add_source_point(locations[0]);
  geodesic.build(CGAL::parameters::keep_windows(true));
  const auto v = *vertices(mesh).begin();
  const double distance = geodesic.distance_to_sources(v);
  geodesic.clear_sources();
  geodesic.add_source_polyline(locations, CGAL::parameters::is_closed(closed));
  Offset_curves curves;
  const auto never = [](double, Offset_curves&&) { CHECK(!"a curve of a selection that is refused"); };
  for (const Offset_side side : {Offset_side::INSIDE, Offset_side::OUTSIDE})
  {
    const auto np = CGAL::parameters::offset_side(side);
    check_refused([&] { geodesic.build_with_offset_curves(level, std::back_inserter(curves), np); }, what);
    check_refused([&] { geodesic.build_with_offset_curves_by_distance(level, never, np); }, what);
    CHECK(geodesic.distance_to_sources(v) == distance);
  }
  for (const bool keep : {false, true})
  {
    geodesic.build(CGAL::parameters::keep_windows(keep));
    for (const Offset_side side : {Offset_side::INSIDE, Offset_side::OUTSIDE})
    {
      const auto np = CGAL::parameters::offset_side(side);
      check_refused([&] { geodesic.offset_curves(level, std::back_inserter(curves), np); }, what);
      check_refused([&] { geodesic.offset_curves_by_distance(level, never, np); }, what);
    }
    CHECK(curves.empty());
    const auto both = sorted_pieces(offsets(geodesic, level, {Offset_side::BOTH, Offset_end::BUTT}));
    const auto left = sorted_pieces(offsets(geodesic, level, {Offset_side::LEFT, Offset_end::BUTT}));
    const auto right = sorted_pieces(offsets(geodesic, level, {Offset_side::RIGHT, Offset_end::BUTT}));
    CHECK(!left.empty() && !right.empty() && left.size() + right.size() == both.size());
  }
}

void no_inside()
{
  const std::string closed = "does not divide the surface", open = "is an open polyline and has no inside";
  for (const auto& size : {std::make_pair(3, 3), std::make_pair(4, 3), std::make_pair(8, 5), std::make_pair(20, 14)})
  {
    const std::size_t n = std::size_t(size.first), m = std::size_t(size.second);
    const Data data(torus(n, m));
    const Locations<test::Surface_mesh> on_mesh(data.mesh);
    const auto at = [&](std::size_t i, std::size_t j) { return on_mesh.at_vertex(data.vertices[(i % n) * m + j % m]); };
    std::vector<Face_location> meridian, longitude, both_ways;
    for (std::size_t j = 0; j < m; ++j) meridian.push_back(at(0, j));
    for (std::size_t i = 0; i < n; ++i) longitude.push_back(at(i, 0));
    for (std::size_t i = 0; i < n * m; ++i) both_ways.push_back(at(i, i)); // along diagonals
    const std::string name = "torus of " + std::to_string(n) + " x " + std::to_string(m) + ", ";
    Report::instance().set_context(name + "meridian");
    check_without_inside(data.mesh, meridian, true, 0.1, closed);
    Report::instance().set_context(name + "longitude");
    check_without_inside(data.mesh, longitude, true, 0.1, closed);
    Report::instance().set_context(name + "open");
    check_without_inside(data.mesh, meridian, false, 0.05, open);
    // a square of two faces divides
    Report::instance().set_context(name + "square");
    for (const bool turned : {false, true})
    {
      std::vector<Face_location> square{at(1, 1), at(2, 1), at(2, 2), at(1, 2)};
      if (turned) std::reverse(square.begin(), square.end());
      Geodesic geodesic(data.mesh);
      geodesic.add_source_polyline(square, CGAL::parameters::is_closed(true));
      geodesic.build();
      const Offset_curves inside = offsets(geodesic, 0.01, Offset_side::INSIDE),
                          outside = offsets(geodesic, 0.01, Offset_side::OUTSIDE);
      CHECK(inside.size() == 1 && outside.size() == 1);
      CHECK(total_length(inside) < total_length(outside));
    }
  }
  // along a seam that touches every face
  const Data data(torus(3, 3));
  const Locations<test::Surface_mesh> on_mesh(data.mesh);
  std::vector<Face_location> seam;
  for (std::size_t k = 0; k < 9; ++k) // three times around in one direction, once in the other
    seam.push_back(on_mesh.at_vertex(data.vertices[(k % 3) * 3 + (k / 3)]));
  Report::instance().set_context("torus of 3 x 3, seam through all vertices");
  check_without_inside(data.mesh, seam, true, 0.02, closed);
}

// The sides of 1024 polylines on a mesh of 100,489 vertices take three passes over its halfedges for all of them, and for each of
// them one over the 1025 sets of vertices that they separate.
void many()
{
  Report::instance().set_context("many");
  const std::size_t n = 316, number = 32, distance = 9;
  const Data data(planar_grid(n, n, Diagonals::alternating));
  const Locations<test::Surface_mesh> on_mesh(data.mesh);
  Geodesic geodesic(data.mesh);
  for (std::size_t k = 0; k < number * number; ++k)
  {
    const std::size_t x = 4 + distance * (k / number), y = 4 + distance * (k % number);
    const std::size_t square[8][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}; // of side 2
    std::vector<Face_location> polyline;
    for (const auto& p : square) polyline.push_back(on_mesh.at_vertex(data.vertices[(y + p[1]) * (n + 1) + x + p[0]]));
    geodesic.add_source_polyline(polyline, CGAL::parameters::is_closed(true));
  }
  namespace internal = CGAL::Geodesic_offset::internal;
  const auto& mesh = internal::Mesh_access::data(geodesic.mesh());
  internal::Inner_sides<double> sides(mesh.unfolded(), internal::classified_sources(mesh, geodesic.sources()));
  const auto result = sides();
  CHECK(result.size() == number * number);
  for (const auto& [id, inner] : result) CHECK(inner.side == CGAL::Source_side::LEFT && std::abs(inner.inner_area - 4) <= 1e-9);
  const std::size_t cells = result.size() + 1, visits = 3 * mesh.unfolded().number_of_halfedges() + result.size() * cells;
  CHECK_DETAIL(sides.number_of_visits() == visits, values(double(sides.number_of_visits()), double(visits)));
}

} // namespace test_inner_sides

GEODESIC_OFFSET_TEST(test_inner_sides)
{
  for (const Diagonals diagonals : {Diagonals::forward, Diagonals::backward, Diagonals::alternating, Diagonals::random})
    for (double side : {0.25, 0.5, 1.})
    {
      const Planar_mesh plane(planar_grid(std::size_t(4 / side), std::size_t(4 / side), diagonals, side));
      guarded([&] { squares("grid", plane); });
      if (side < 1) guarded([&] { hole(plane); });
      guarded([&] { large(plane); });
      guarded([&] { along_border("grid", plane); });
      guarded([&] { with_points(plane); });
    }
  const Planar_mesh rectangle(random_rectangle(4, 4, 150, 5, 3)), two_triangles(random_rectangle(4, 4, 0, 0, 1));
  guarded([&] { squares("rectangle", rectangle); });
  guarded([&] { hole(rectangle); });
  guarded([&] { large(rectangle); });
  guarded([&] { squares("two triangles", two_triangles); });
  guarded([&] { along_border("rectangle", rectangle); });
  guarded([&] { along_border("two triangles", two_triangles); });
  guarded([&] { side_of_each(rectangle); });
  guarded([&] { side_of_each(two_triangles); });
  guarded([&] { crossed(rectangle); });
  guarded([&] { crossed(two_triangles); });
  guarded([&] { closing(rectangle); });
  guarded([&] { closing(two_triangles); });
  guarded(round_hole);
  guarded(tiny);
  guarded(in_one_face);
  guarded(sections_of_boxes);
  guarded(many);
  guarded(no_inside);
  return Report::instance().finish("test_inner_sides");
}
