// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Levels through vertices, along edges, through maxima and saddles of the distance, beyond it, and invalid levels. A level
// bounds the points that are strictly nearer. Most coordinates are multiples of 1/8, so ties are exact.

#include "known_cases.h"
#include "level_check.h"

#include <string>
#include <vector>

namespace test_degenerate_levels {

using namespace test;

// A level through vertices (3-4-5 triangles), one that touches the border, one that meets it at vertices, one through the
// farthest points, and one beyond.
void vertices_on_the_level()
{
  for (const Diagonals diagonals : all_diagonals)
    for (double side : {0.25, 0.5})
    {
      const Square square(diagonals, side);
      const auto source = square.vertices({{2, 2}});
      for (double level : {0.25, 0.5, 0.75, 1., 1.25, 1.5, std::sqrt(2.), 2.})
        check_level("vertex of a grid", square.mesh, source, level, {1, 1, 2 * pi * level});
      const auto corners = [](double d) { return 4 * d * (pi / 2 - 2 * std::acos(2 / d)); };
      check_level("vertices on the border", square.mesh, source, 2.5, {4, 0, corners(2.5), 10});
      const double farthest = std::sqrt(8.);
      check_level("the farthest points", square.mesh, source, farthest, {0, 0, 0});
      const double just_below = farthest * (1 - 1e-6);
      check_level("just below them", square.mesh, source, just_below, {4, 0, corners(just_below), 20});
      check_level("beyond them", square.mesh, source, 3, {0, 0, 0});
      check_level("far beyond them", square.mesh, source, 1e9, {0, 0, 0});
    }
}

// Sources along a line of edges: whole edges lie on the level.
void edges_on_the_level()
{
  for (const Diagonals diagonals : all_diagonals)
  {
    const Square square(diagonals, 0.25);
    const auto line = square.polylines({{Point_2(0, 2), Point_2(4, 2)}});
    for (double level : {0.125, 0.25, 0.5, 1., 1.75, 2.}) check_level("a line of edges", square.mesh, line, level, {2, 0, 8});
    check_level("beyond the border edges", square.mesh, line, 2.5, {0, 0, 0});
    const auto segment = square.polylines({{Point_2(1, 2), Point_2(3, 2)}});
    for (double level : {0.25, 0.5, 0.75, 1.})
      check_level("edges inside", square.mesh, segment, level, {1, 1, 4 + 2 * pi * level});
    const auto slanted = square.polylines({{Point_2(1, 1), Point_2(3, 3)}});
    for (double level : {std::sqrt(0.03125), std::sqrt(0.125), 0.75})
      check_level("a diagonal", square.mesh, slanted, level, {1, 1, 2 * std::sqrt(8.) + 2 * pi * level});
    // the maximum between two lines is a line: the level bounds the points on either side
    const auto two_lines = square.polylines({{Point_2(0, 1), Point_2(4, 1)}, {Point_2(0, 2), Point_2(4, 2)}});
    check_level("two lines, between", square.mesh, two_lines, 0.25, {4, 0, 16});
    check_level("two lines, maximum", square.mesh, two_lines, 0.5, {4, 0, 16});
    check_level("two lines, above", square.mesh, two_lines, 0.5 + 1e-9, {2, 0, 8});
  }
}

// Saddle between two points, at a vertex or inside an edge: two curves below it, one above.
void saddles()
{
  for (const Diagonals diagonals : all_diagonals)
  {
    const Square square(diagonals, 0.5);
    for (double half : {0.5, 0.75})
    {
      const auto two = square.vertices({{2 - 0.5, 2}, {2 - 0.5 + 2 * half, 2}});
      const auto one_curve = [half](double d) { return 4 * d * (pi - std::acos(half / d)); };
      check_level("below the saddle", square.mesh, two, half * (1 - 1e-6), {2, 2, 4 * pi * half * (1 - 1e-6)});
      check_level("the saddle", square.mesh, two, half, {2, 2, 4 * pi * half});
      check_level("above the saddle", square.mesh, two, half * (1 + 1e-6), {1, 1, one_curve(half * (1 + 1e-6)), 1e4});
      check_level("far above", square.mesh, two, half + 0.25, {1, 1, one_curve(half + 0.25), 40});
    }
    // a saddle in the form of a segment
    const auto parallel = square.polylines({{Point_2(1, 1.5), Point_2(3, 1.5)}, {Point_2(1, 2.5), Point_2(3, 2.5)}});
    check_level("two segments, saddle", square.mesh, parallel, 0.5, {2, 2, 8 + 2 * pi});
    check_level("two segments, above", square.mesh, parallel, 0.625, {1, 1, 4 + 4 * 0.625 * (pi - std::acos(0.5 / 0.625)), 40});
  }
  // Around a tube of square section with period 4, the front meets itself at 2.
  Soup tube;
  const std::size_t around = 8, up = 10;
  for (std::size_t j = 0; j <= up; ++j)
    for (std::size_t i = 0; i < around; ++i)
    {
      const double u = 0.5 * double(i), v = 0.5 * double(j);
      tube.points.push_back(u <= 1   ? Point_3(u, 0, v)
                            : u <= 2 ? Point_3(1, u - 1, v)
                            : u <= 3 ? Point_3(3 - u, 1, v)
                                     : Point_3(0, 4 - u, v));
    }
  for (std::size_t j = 0; j < up; ++j)
    for (std::size_t i = 0; i < around; ++i)
    {
      const std::size_t a = j * around + i, b = j * around + (i + 1) % around, c = b + around, d = a + around;
      tube.add_triangle({{a, b, c}});
      tube.add_triangle({{a, c, d}});
    }
  const Data data(tube);
  for (std::size_t i : {0, 1})
  {
    const auto source = [&](Geodesic& g) { g.add_source_point(data.vertices[5 * around + i]); };
    for (double level : {0.5, 1., 1.5, 2.}) check_level("tube", data.mesh, source, level, {1, 1, 2 * pi * level});
    for (double level : {2 * (1 + 1e-6), 2.25, 2.5})
      check_level("tube, above the saddle", data.mesh, source, level,
                  {2, 2, level * (2 * pi - 4 * std::acos(2 / level)), 5000});
  }
}

// Sources at multiples of 1/2, levels at multiples of 1/4: fronts touch each other and themselves at vertices, and inside
// edges that are long relative to the level.
void touching_fronts()
{
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    Random random(seed);
    const std::size_t n = 1 + uniform_index(random, 4), m = 1 + uniform_index(random, 4);
    Planar_mesh plane(planar_grid(n, m, all_diagonals[seed % 4], 1, 0, seed));
    const test::Surface_mesh& mesh = plane.data.mesh;
    Geodesic geodesic(mesh);
    for (std::size_t i = 0; i < 2 + seed % 2; ++i) switch (uniform_index(random, 4))
      {
      case 0: geodesic.add_source_point(plane.data.vertices[uniform_index(random, plane.data.vertices.size())]); break;
      case 1:
        geodesic.add_source_edges(std::vector<test::Surface_mesh::Edge_index>{
          test::Surface_mesh::Edge_index(test::Surface_mesh::size_type(uniform_index(random, num_edges(mesh))))});
        break;
      default:
        geodesic.add_source_point(plane.location(Point_2(0.5 * double(uniform_index(random, 2 * n + 1)),
                                                         0.5 * double(uniform_index(random, 2 * m + 1)))));
      }
    geodesic.build(CGAL::parameters::keep_windows(true));
    Validation_options options;
    options.probes = 100;
    options.quadrature_faces = 2;
    options.largest_number_of_texts = 2;
    const Curve_checker checker(mesh, geodesic, options);
    for (double level = 0.25; level <= 1.5; level += 0.25)
    {
      Report::instance().set_context("touching fronts, seed " + std::to_string(seed) + ", level " + std::to_string(level));
      const Offset_curves kept = offsets(geodesic, level);
      checker.check({level}, kept);
      Geodesic again(geodesic);
      Offset_curves on_the_way;
      again.build_with_offset_curves(level, std::back_inserter(on_the_way));
      CHECK(on_the_way.size() == kept.size() && again.statistics().forced_joints == 0);
    }
  }
}

// Local maximum at a vertex, inside an edge, inside a face, on a segment.
void maxima()
{
  for (const Diagonals diagonals : all_diagonals)
  {
    const Square square(diagonals, 0.5);
    const auto boundary = [&](Geodesic& g) {
      std::vector<test::Surface_mesh::Edge_index> border;
      for (auto e : edges(square.mesh))
        if (square.mesh.is_border(e)) border.push_back(e);
      g.add_source_edges(border);
    };
    for (double level : {0.25, 0.5, 1., 1.5, 2 - 1e-6})
      check_level("the boundary of a square", square.mesh, boundary, level, {1, 1, 8 * (2 - level), 8});
    check_level("the middle of a square", square.mesh, boundary, 2, {0, 0, 0});
    const auto inner = square.polylines({{Point_2(0.5, 1), Point_2(3.5, 1), Point_2(3.5, 2), Point_2(0.5, 2)}}, true);
    check_level("a rectangle", square.mesh, inner, 0.25, {2, 2, 8 - 8 * 0.25 + 8 + 2 * pi * 0.25, 20});
    // the maximum inside is a segment of length 2, reached from all sides
    check_level("a rectangle, maximum", square.mesh, inner, 0.5, {2, 2, 4 + 8 + pi, 20});
  }
  const Data cube(cube_grid(4)), coarse(box_sides(1, 1, 1).triangulated(0, 0, 1));
  const auto middle_of_top = [&](Geodesic& g) {
    for (auto v : cube.vertices)
      if (cube.mesh.point(v) == Point_3(0.5, 0.5, 1)) g.add_source_point(v);
  };
  check_level("cube, the opposite vertex", cube.mesh, middle_of_top, 2, {0, 0, 0});
  // the loop around it: four arcs of radius d around points at distance 2, with corners at (t, t)
  const double d = 2 - 0.001, t = 1 - std::sqrt(d * d / 2 - 1);
  check_level("cube, just below", cube.mesh, middle_of_top, d, {1, 1, 8 * d * std::asin(t / d), 9});
  check_level("cube, round edges", cube.mesh, middle_of_top, 0.5, {1, 1, pi});
  const auto corner = [&](Geodesic& g) { g.add_source_point(coarse.vertices[0]); };
  for (double level : {0.5, 1.}) check_level("corner of a cube", coarse.mesh, corner, level, {1, 1, 1.5 * pi * level});

  const Data tetrahedron(tetrahedron_sides().triangulated(0, 0, 1));
  const auto apex = [&](Geodesic& g) { g.add_source_point(tetrahedron.vertices[0]); };
  const double edge = std::sqrt(8.), middle = 2 * edge / std::sqrt(3.);
  for (double level : {0.5, 1., edge * std::sqrt(0.75), 2.7, edge})
    check_level("tetrahedron", tetrahedron.mesh, apex, level, {1, 1, pi * level, 10});
  for (double level : {2.9, 3.2, middle * (1 - 1e-6)})
    check_level("tetrahedron, opposite face", tetrahedron.mesh, apex, level,
                {1, 1, 6 * level * (pi / 6 - std::acos(edge / level)), 40});
  check_level("tetrahedron, the farthest point", tetrahedron.mesh, apex, middle * (1 + 1e-12), {0, 0, 0});

  // A thin rhombus: the distance decreases slowly from its center.
  for (double half : {0.25, 0.0625, 0.0078125, 0.0009765625})
  {
    Soup rhombus;
    rhombus.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, half, 0), Point_3(-1, 0, 0), Point_3(0, -half, 0)};
    for (std::size_t i = 1; i <= 4; ++i) rhombus.add_triangle({{0, i, i % 4 + 1}});
    const Data data(rhombus);
    const auto boundary = [&](Geodesic& g) {
      std::vector<test::Surface_mesh::Edge_index> border;
      for (auto e : edges(data.mesh))
        if (data.mesh.is_border(e)) border.push_back(e);
      g.add_source_edges(border);
    };
    Geodesic geodesic(data.mesh);
    boundary(geodesic);
    geodesic.build();
    const double largest = geodesic.distance_to_sources(data.vertices[0]);
    const std::string name = "rhombus of half width " + std::to_string(half);
    check_level(name, data.mesh, boundary, largest, {0, 0, 0});
    check_level(name + ", half", data.mesh, boundary, largest / 2, {1, 1, 2 * std::hypot(1, half), 8 / half});
  }
}

// A vertex whose distance is the level of cutting up to rounding: the loop around it has a length of 1e-16, and the sign of its
// area is rounding (found by fuzz_offsets).
void loops_of_no_length()
{
  for (const Known_case& c : known_cases("loops_of_no_length.txt"))
  {
    Report::instance().set_context(c.name);
    const Geodesic geodesic = built(c.mesh, c.sources);
    const double d = geodesic.distance_to_sources(Surface_mesh::Vertex_index(unsigned(c.numbers.at(0))));
    CHECK_DETAIL(std::abs(d - c.numbers.at(1)) <= 1e-15, values(d, c.numbers[1]));
    std::vector<double> levels = {0.65431248505444006, d, level_cut_at(d)};
    for (int i = -8; i <= 8; ++i) levels.push_back(level_cut_at(d) * (1 + i * 0x1p-53));
    for (const double level : levels)
      for (const auto& curve : offsets(geodesic, level)) CHECK_DETAIL(curve.length() > 1e-13, values(curve.length(), level));
  }
}

// Saddle vertex on the level: the curve behind it is an arc around it.
void saddle_vertex()
{
  for (double turns : {1.25, 1.5})
  {
    const Cone cone(8, turns * 2 * pi, 1);
    const Data data(cone.triangulated(25, 4, 5));
    // the nearest neighbour of the apex
    test::Surface_mesh::Vertex_index nearest = data.vertices[1];
    const auto source = [&](Geodesic& g) { g.add_source_point(nearest); };
    for (auto h : halfedges_around_target(data.mesh.halfedge(data.vertices[0]), data.mesh))
      if (CGAL::squared_distance(data.mesh.point(data.mesh.source(h)), data.mesh.point(data.vertices[0])) <
          CGAL::squared_distance(data.mesh.point(nearest), data.mesh.point(data.vertices[0])))
        nearest = data.mesh.source(h);
    const double radius = std::sqrt(CGAL::squared_distance(data.mesh.point(nearest), data.mesh.point(data.vertices[0])));
    const double inner = std::cos(cone.sector_angle() / 2);
    if (!CHECK(2.2 * radius < inner)) continue;
    check_level("saddle vertex", data.mesh, source, radius, {1, 1, 2 * pi * radius, 10});
    const double level = 1.1 * radius, behind = level - radius;
    // the whole circle, and an arc around the vertex
    check_level("behind a saddle vertex", data.mesh, source, level,
                {1, 1, 2 * pi * level + behind * (cone.total_angle - 2 * pi), 10});
  }
}

// Sources so close to an edge that their rays fill a half turn behind it, up to rounding.
void points_beside_edges()
{
  Random random(8);
  for (const Diagonals diagonals : all_diagonals)
    for (double side : {0.5, 4.})
    {
      const Square square(diagonals, side);
      const Locations locations(square.mesh);
      for (double off : {1e-12, 3e-12, 1e-11, 3e-11, 1e-10, 3e-10, 1e-9, 1e-8, 1e-7, 1e-5})
        for (int i = 0; i < 6; ++i)
        {
          // beside the edge from the first corner of a face to the second one
          const auto face = square.plane.data.faces[uniform_index(random, square.plane.data.faces.size())];
          const double t = uniform(random, 0.2, 0.8);
          Face_location near(face, {{1 - t - off / 2, t - off / 2, 0}});
          near.second[2] = 1 - near.second[0] - near.second[1];
          const auto point = [&](Geodesic& g) { g.add_source_point(near); };
          const Point_3 p = locations.point(near);
          const double room = (std::min)({p.x(), p.y(), 4 - p.x(), 4 - p.y()}), level = uniform(random, 0.1, 1) * room;
          if (room < 0.1) continue; // beside a border edge
          check_level("a point beside an edge, by " + std::to_string(off * 1e12) + "e-12", square.mesh, point, level,
                      {1, 1, 2 * pi * level, 10});
        }
    }
}

// Corners of polylines close to edges: the offset is that of a corner on the edge.
void corners_beside_edges()
{
  Report::instance().set_context("a corner beside an edge");
  test::Surface_mesh mesh;
  const auto a = mesh.add_vertex(Point_3(4, 3, 0)), b = mesh.add_vertex(Point_3(5, 3, 0)),
             c = mesh.add_vertex(Point_3(5, 4, 0)), d = mesh.add_vertex(Point_3(4, 4, 0));
  mesh.add_face(a, b, c);
  const auto face = mesh.add_face(a, c, d);
  const auto at = [&](double wa, double wc, double wd) {
    Face_location l(face, {{0, 0, 0}});
    auto h = mesh.halfedge(face);
    for (int k = 0; k < 3; ++k, h = mesh.next(h)) l.second[k] = mesh.source(h) == a ? wa : mesh.source(h) == c ? wc : wd;
    return l;
  };
  double on_the_edge = 0;
  for (const double off : {0., 1.25e-10, 1e-9, 1e-8, 1e-7})
  {
    Geodesic geodesic(mesh);
    geodesic.add_source_polyline(std::vector<Face_location>{at(0.31, 0, 0.69), at(0.55 - off, 0.45, off), at(0.29, 0.38, 0.33),
                                                            at(0.645, 0.183, 0.172)});
    Offset_curves curves;
    geodesic.build_with_offset_curves(0.405, std::back_inserter(curves));
    CHECK(geodesic.statistics().forced_joints == 0);
    if (off == 0) on_the_edge = total_length(curves);
    CHECK_DETAIL(curves.size() == 1 && std::abs(total_length(curves) - on_the_edge) < 1e-9 + 20 * off,
                 values(total_length(curves), on_the_edge));
  }
  CHECK(on_the_edge > 1);
}

// Border edges with both end points (x, y) satisfying `is_wanted`.
template <class Predicate>
Add_sources border_edges(const test::Surface_mesh& mesh, const Predicate& is_wanted)
{
  std::vector<test::Surface_mesh::Edge_index> edges;
  const auto fits = [&](auto v) { return is_wanted(mesh.point(v).x(), mesh.point(v).y()); };
  for (const auto e : mesh.edges())
    if (mesh.is_border(e) && fits(mesh.vertex(e, 0)) && fits(mesh.vertex(e, 1))) edges.push_back(e);
  return [edges](Geodesic& g) { g.add_source_edges(edges); };
}

// Levels near a line of largest distance: the two sides of a strip narrower than the resolution of arcs. In general
// position, as the medial line of a pocket lies in the faces of a CAD mesh.
void plateaus()
{
  const double relative[] = {-1e-9, -1e-10, -3e-11, -1e-11, -3e-12, -1e-12, 0, 1e-12, 3e-12, 1e-11, 1e-10, 1e-9};
  for (std::size_t inside : {1, 2, 5, 20, 100})
    for (unsigned seed = 1; seed <= 6; ++seed)
    {
      const Data data(random_rectangle(6, 4, inside, 1 + inside / 10, seed));
      const auto border = border_edges(data.mesh, [](double, double) { return true; });
      for (double r : relative)
      {
        const double level = 2 * (1 + r), c = cut_of(level);
        const std::string name = "the medial line of a rectangle, " + std::to_string(inside) + " points inside, seed " +
                                 std::to_string(seed) + ", " + std::to_string(r * 1e12) + "e-12 above";
        check_level(name, data.mesh, border, level, c < 2 ? Expected{1, 1, 20 - 8 * c, 1e3} : Expected{0, 0, 0});
      }
    }
}

// A line and a circle that touch or nearly touch: the level ends in cusps that are narrower than that resolution over a
// long distance.
void cusps()
{
  for (std::size_t inside : {2, 5, 20, 100})
    for (unsigned seed = 1; seed <= 6; ++seed)
    {
      const Data data(random_rectangle(6, 4, inside, 1 + inside / 10, seed));
      const auto bottom = border_edges(data.mesh, [](double, double y) { return y == 0; });
      const auto line_and_point = [&](Geodesic& g) {
        bottom(g);
        g.add_source_point(g.locate(Point_3(3, 4, 0)));
      };
      for (double r : {-1e-6, -1e-9, -1e-11, -1e-12, 1e-12, 3e-12, 1e-11, 1e-10, 1e-9, 1e-6})
      {
        const double level = 2 * (1 + r), c = cut_of(level);
        const double h = c > 2 ? std::sqrt(8 * (c - 2)) : 0;
        const double length = c > 2 ? 2 * (3 - h + c * std::acos(h / c)) : 6 + pi * c;
        const std::string name = "a line and a circle that touch, " + std::to_string(inside) + " points inside, seed " +
                                 std::to_string(seed) + ", " + std::to_string(r * 1e12) + "e-12 above";
        check_level(name, data.mesh, line_and_point, level, {2, 0, length, 3e4});
      }
    }
}

// A strip over source edges, a corner of which is beyond the end of these edges. The level is that of the end of the opposite
// edge up to rounding, but passes before the corner, which is farther.
void corner_beyond_an_end()
{
  for (const double height : {1e-7, 1.5e-8, 2e-9})
    for (const double lean : {0.1, 0.2, 0.5, 2.})
      for (const double below : {1e-8, 1e-9, 0.})
        for (const bool is_one_pass : {false, true})
        {
          Report::instance().set_context("a corner beyond an end, height " + std::to_string(1e9 * height) + "e-9, lean " +
                                         std::to_string(lean));
          Soup soup;
          soup.points = {Point_3(0, 0, 0), Point_3(6, 0.4 * height, 0), Point_3(12, 0, 0),
                         Point_3(12 + lean * height, height, 0), Point_3(0, height, 0)};
          soup.add_triangle({{0, 1, 4}});
          soup.add_triangle({{1, 3, 4}});
          soup.add_triangle({{1, 2, 3}});
          const Data data(soup);
          Geodesic geodesic(data.mesh);
          std::vector<Surface_mesh::Edge_index> source;
          for (std::size_t i : {0, 1})
            source.push_back(edge(halfedge(data.vertices[i], data.vertices[i + 1], data.mesh).first, data.mesh));
          geodesic.add_source_edges(source);
          geodesic.build(CGAL::parameters::keep_windows(true));
          const double level = height * (1 - below), side = std::hypot(lean, 1.);
          Offset_curves curves;
          if (is_one_pass) geodesic.build_with_offset_curves(level, std::back_inserter(curves));
          else curves = offsets(geodesic, level);
          const Point_3 crossing(12 + lean / side * level, level / side, 0);
          bool is_found = false;
          for (const Offset_curve& c : curves)
            for (const Point_3& p : {c.piece(0).point(0), c.piece(c.number_of_pieces() - 1).point(1)})
              is_found = is_found || CGAL::squared_distance(p, crossing) < 1e-6 * height * height;
          CHECK_DETAIL(is_found, std::to_string(curves.size()) + " curves");
          CHECK(geodesic.statistics().forced_joints == 0);
        }
}

// The curves of a level, from kept windows or cut during a build; all of their points are on the level, up to a tolerance.
Offset_curves curves_on_level(const Geodesic& geodesic, double level, bool is_one_pass, double tolerance)
{
  Offset_curves curves;
  if (is_one_pass)
  {
    Geodesic again(geodesic);
    again.build_with_offset_curves(level, std::back_inserter(curves));
    CHECK(again.statistics().forced_joints == 0);
  }
  else curves = offsets(geodesic, level);
  for (const Offset_curve& c : curves)
    for (const Offset_piece& piece : c.pieces())
      for (double t : {0.1, 0.5, 0.9})
      {
        const double d = geodesic.distance_to_sources(piece.location(t));
        CHECK_DETAIL(std::abs(d - level) <= tolerance, values(d, level) + ", length " + std::to_string(piece.length()));
      }
  return curves;
}

// A polyline beside or along an edge, and levels around its start value: up to it only the other source has an offset, and
// above it the whole polyline has one.
void levels_at_start_values()
{
  for (const Known_case& c : known_cases("start_value_cases.txt"))
  {
    const double start_value = c.sources.back().start_value, longest_edge = c.numbers.at(0), expected = c.numbers.at(1);
    const std::vector<Source> others(c.sources.begin(), c.sources.end() - 1);
    const Geodesic both = built(c.mesh, c.sources), other = built(c.mesh, others);
    const double unit = 0x1p-42 * (start_value + longest_edge); // the least offset
    for (double step : {-1e3, -4., -2., -1., -0.5, 0., 0.001, 0.1, 0.25, 0.5, 0.75, 1., 1.5, 2., 3., 4., 16.})
      for (const bool is_one_pass : {false, true})
      {
        const double level = start_value + step * unit;
        if (!(level > 0)) continue;
        Report::instance().set_context(c.name + ", start value plus " + std::to_string(step) + " units");
        const Offset_curves curves = curves_on_level(both, level, is_one_pass, 4 * unit);
        // Just above the start value, either is right: only rounding decides which of them is found.
        const double length = total_length(curves);
        const double length_of_other = others.empty() ? 0 : total_length(offsets(other, level));
        const bool is_other = std::abs(length - length_of_other) <= 1e-9 * longest_edge;
        const bool is_both = expected == 0 ? length > 10 * length_of_other : std::abs(length - expected) <= 5e-3 * expected;
        CHECK_DETAIL(step <= 0 ? is_other : step >= 3 ? is_both : is_other || is_both, values(length, length_of_other));
      }
  }
}

// Levels a few times the least offset above the distance zero: the two sides of the offset are nearer to each other than the
// largest ties. All points of the curves are on the level nevertheless.
void sides_near_each_other()
{
  for (const Known_case& c : known_cases("narrow_offsets.txt"))
  {
    const Geodesic geodesic = built(c.mesh, c.sources);
    for (double level = 0x1p-41 * c.numbers.at(0); level < 1e-11; level *= 1.01)
      for (const bool is_one_pass : {false, true})
      {
        Report::instance().set_context(c.name + ", level " + std::to_string(1e15 * level) + "e-15");
        CHECK(!curves_on_level(geodesic, level, is_one_pass, 0.25 * level).empty());
      }
  }
}

template <class Function>
void check_refused(const Function& f)
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
  CHECK_DETAIL(message.find("must be a positive finite number") != std::string::npos, message);
}

void levels_that_are_no_distances()
{
  Report::instance().set_context("bad levels");
  const Square square(Diagonals::forward, 1);
  Geodesic geodesic(square.mesh);
  square.vertices({{2, 2}})(geodesic);
  geodesic.build();
  const double distance = geodesic.distance_to_sources(square.vertex(0, 0));
  square.vertices({{1, 1}})(geodesic); // would change the next build
  Offset_curves curves;
  const auto never = [](double, Offset_curves&&) { CHECK(!"a curve of a bad level"); };
  for (double level : {0., -0., -1., -1e-300, infinity, -infinity, std::nan("")})
  {
    check_refused([&] { geodesic.offset_curves(level, std::back_inserter(curves)); });
    check_refused([&] { geodesic.offset_curves(std::vector<double>{1, level}, std::back_inserter(curves)); });
    check_refused([&] { geodesic.offset_curves_by_distance(level, never); });
    check_refused([&] { geodesic.build_with_offset_curves(level, std::back_inserter(curves)); });
    check_refused([&] { geodesic.build_with_offset_curves_by_distance(std::vector<double>{level, 1}, never); });
    check_refused([&] { CGAL::Offset_levels<double>::equally_spaced(level); });
    check_refused([&] { CGAL::Offset_levels<double>::equally_spaced(level, 3); });
  }
  for (double spacing : {1e-300, 1e-14}) // levels that rounding cannot distinguish, without an end
  {
    const auto levels = CGAL::Offset_levels<double>::equally_spaced(spacing);
    CHECK_THROWS(geodesic.offset_curves(levels, std::back_inserter(curves)), std::invalid_argument);
    CHECK_THROWS(geodesic.build_with_offset_curves(levels, std::back_inserter(curves)), std::invalid_argument);
  }
  CHECK(curves.empty());
  CHECK(geodesic.distance_to_sources(square.vertex(0, 0)) == distance); // the last build still exists
  geodesic.offset_curves(std::vector<double>(), std::back_inserter(curves));
  geodesic.offset_curves(CGAL::Offset_levels<double>::equally_spaced(0.5, 0), std::back_inserter(curves));
  CHECK(curves.empty());
  geodesic.offset_curves(1e-300, std::back_inserter(curves)); // any positive spacing is valid
  geodesic.offset_curves(std::numeric_limits<double>::denorm_min(), std::back_inserter(curves));
  curves.clear();
  geodesic.offset_curves(std::vector<double>{4, 5, 1e300}, std::back_inserter(curves));
  CHECK(curves.empty());
}

// Circles around single points, down to 2^-36 of the longest edge around them: one curve, of its length within rounding of that
// edge.
void tiny_circles()
{
  for (int exponent = 6; exponent <= 36; exponent += 2)
    for (int i = 0; i < 30; ++i)
    {
      const double shift = i / 30., level = std::ldexp(1 + shift, -exponent),
                   distance = (std::min)(0.2, level * (3 + 2 * shift));
      Surface_mesh mesh;
      std::vector<Surface_mesh::Vertex_index> v{mesh.add_vertex(Point_3(0.03, 0.02, 0))};
      for (int k = 0; k < 6; ++k)
      {
        const double angle = (k + 0.3 * std::fmod(shift * (k + 7), 1)) * pi / 3,
                     radius = 0.5 + std::fmod(shift * (k + 11), 0.5);
        v.push_back(mesh.add_vertex(Point_3(radius * std::cos(angle), radius * std::sin(angle), 0)));
      }
      for (std::size_t k = 0; k < 6; ++k) mesh.add_face(v[0], v[1 + k], v[1 + (k + 1) % 6]);
      const auto place = [&](double a, double b) { // in the first face, by the weights of its second and third vertex
        const auto h = mesh.halfedge(v[0], v[1]);
        Face_location l(mesh.face(h), {{0, 0, 0}});
        std::size_t k = 0;
        for (const auto u : CGAL::vertices_around_face(mesh.halfedge(l.first), mesh))
          l.second[k++] = u == v[1] ? a : u == v[2] ? b : 1 - a - b;
        return l;
      };
      for (const char* const kind : {"vertex", "beside a vertex", "on an edge"})
      {
        Geodesic geodesic(mesh);
        if (kind[0] == 'v') geodesic.add_source_point(v[0]);
        else
          geodesic.add_source_point(kind[0] == 'b' ? place(distance, distance * (0.5 + shift)) : place(0.3 + 0.3 * shift, 0));
        geodesic.build(CGAL::parameters::keep_windows(true));
        std::vector<Geodesic::Offset_curve> curves;
        geodesic.offset_curves(level, std::back_inserter(curves));
        Report::instance().set_context(std::string("tiny circle, ") + kind);
        CHECK(curves.size() == 1);
        for (const auto& c : curves)
          CHECK_DETAIL(std::abs(c.length() - 2 * pi * level) <= 1e-8 * level + 1e-15, values(c.length(), 2 * pi * level));
      }
    }
}

} // namespace test_degenerate_levels

GEODESIC_OFFSET_TEST(test_degenerate_levels)
{
  vertices_on_the_level();
  edges_on_the_level();
  saddles();
  touching_fronts();
  maxima();
  loops_of_no_length();
  saddle_vertex();
  points_beside_edges();
  corners_beside_edges();
  plateaus();
  cusps();
  corner_beyond_an_end();
  levels_at_start_values();
  sides_near_each_other();
  levels_that_are_no_distances();
  tiny_circles();
  print_level_totals();
  return Report::instance().finish("test_degenerate_levels");
}
