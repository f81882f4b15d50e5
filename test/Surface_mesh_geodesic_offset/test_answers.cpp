// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distance, nearest source, signed distance, gradient and path of a point agree: cases in which they did not once, and bounded runs
// of the search (benchmark/Surface_mesh_geodesic_offset/Robustness/answer_search.cpp runs it at length).

#include "answer_search.h"
#include "path_tools.h"
#include "test_check.h"

#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace test_answers {

using namespace test;

void check(const Answer_search& search)
{
  std::size_t queries = 0;
  for (const auto& c : search.counts())
  {
    const Answer_counts& n = c.second;
    queries += n.queries;
    CHECK_DETAIL(n.total_wrong() == 0,
                 c.first + ": " + std::to_string(n.wrong) + " points with a fault, " + std::to_string(n.exceptions) +
                   " exceptions, " + std::to_string(n.wrong_polylines) + " wrong polylines");
  }
  CHECK(queries > 0);
}

void run(Answer_search::Sources sources, const std::vector<unsigned>& seeds)
{
  Answer_search search(std::cout, 20, 33, sources);
  for (const unsigned seed : seeds) search.run(seed);
  check(search);
}

void run(Answer_search::Sources sources, unsigned first, unsigned last)
{
  Answer_search search(std::cout, 20, 33, sources);
  for (unsigned seed = first; seed <= last; ++seed) search.run(seed);
  CHECK(search.counts().size() == (sources == Answer_search::BESIDE ? 7u : 17u));
  check(search);
}

// A polyline through a grid, joined from its ends and its middle: the last segment before the corner is short, and in one line with
// those before it.
void joined_polyline_on_grid()
{
  test::Surface_mesh mesh;
  std::vector<Vertex_index> v;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 7; ++j) v.push_back(mesh.add_vertex(Point_3(i, j, 0)));
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < 6; ++j)
    {
      const std::size_t a = 7 * i + j;
      mesh.add_face(v[a], v[a + 7], v[a + 8]);
      mesh.add_face(v[a], v[a + 8], v[a + 1]);
    }
  const auto at = [](std::uint32_t f, double a, double b, double c) { return Face_location(Face_index(f), {a, b, c}); };
  const Path_locations polyline = {
    at(59, 0.72347564279420951, 0.27652435720579049, 0),
    at(45, 0.12431645794370877, 0, 0.87568354205629118),
    at(44, 0.84988975952498269, 0.15011024047501734, 0),
    at(43, 0.29614872234942313, 0, 0.70385127765057687),
    at(42, 0.64240490226667712, 0.35759509773332288, 0),
    at(41, 0.46798098675513766, 0, 0.53201901324486234),
    at(40, 0.43492004500837167, 0.56507995499162833, 0),
    at(39, 0.63981325116085208, 0, 0.36018674883914792),
    at(38, 0.2274351877500661, 0.7725648122499339, 0),
    at(37, 0.81164551556656661, 0, 0.18835448443343339),
    at(36, 0.019950330491760426, 0.98004966950823957, 0),
    at(36, 0, 0.98347777997227992, 0.01652222002772008),
    at(37, 0, 0.97943218147115585, 0.020567818528844203),
    at(38, 0, 0.78678222397782371, 0.21321777602217623),
    at(39, 0, 0.73457413610336664, 0.26542586389663342),
    at(40, 0, 0.59008666798336762, 0.40991333201663238),
    at(41, 0, 0.4897160907355772, 0.5102839092644228),
    at(42, 0, 0.3933911119889113, 0.6066088880110887),
    at(43, 0, 0.24485804536778777, 0.75514195463221223),
    at(44, 0, 0.19669555599445498, 0.80330444400554502),
    at(45, 0, 0, 1)};
  const Face_location query = at(23, 0, 0.5, 0.5);
  Answer_checker checker(mesh, true);
  Geodesic geodesic(mesh);
  geodesic.add_source_polyline(polyline);
  geodesic.build(CGAL::parameters::keep_windows(true));
  CHECK_DETAIL(checker.check(geodesic, query) == 0, checker.detail());
  const auto nearest = geodesic.nearest_source(query);
  CHECK(nearest && nearest->part == 0 && nearest->is_segment);
  Path_locations path;
  geodesic.shortest_path_to_sources(query, std::back_inserter(path));
  const double length = double(checker.length(path));
  CHECK_DETAIL(std::abs(length - 2.4260441347937) <= 1e-13, values(length, 2.4260441347937));
}

void known_cases()
{
  joined_polyline_on_grid();
  // gradients of needles; ends at corners with short segments, ends at the last crossing
  run(Answer_search::SPREAD,
      {1032379, 7022994, 7040422, 7044623, 7044689, 7045815, 7046760, 20021964, 20063132, 20063376, 50035092, 50036766});
  // short segments in line with others, repeated points, ties, sources without sides that touch others, parts in faces that have a
  // vertex in common with the face of the point
  run(Answer_search::SPREAD, {865, 11269, 11733, 12002, 13989, 14227, 15630, 15869, 19456, 24666, 29372});
  // gradients beside sources, labels, corners, open ends; a path that runs along another edge; one that ends on another source
  run(Answer_search::COINCIDING, {688, 1769, 5025, 6088, 7272, 8239, 9309, 13329, 17951, 22098, 8006331, 8028953});
  // sides and parts told from far away where a needle, or a short segment, hides them; parts of points at distance 0 in other faces
  run(Answer_search::SPREAD, {90049607, 90060584, 50003823, 200030937, 200046440, 200075509, 200080482, 200081085, 500146315});
  run(Answer_search::COINCIDING, {60026440, 140009919, 300021106, 300036858});
  // polylines whose points are one point: sources without sides
  run(Answer_search::COINCIDING, {80000044, 300005737, 300014946});
  // near sources: measured paths are traced as they were measured; a path that is one point in space; the rounding of a vertex
  run(Answer_search::SPREAD, {500055435, 500097521, 500149794, 500199769});
  run(Answer_search::COINCIDING, {600007633, 600027313, 600050658});
  // the distance of a vertex near a source is the length of its path
  run(Answer_search::SPREAD, {1200019576, 1600047455});
  // joined polylines that end beside an edge
  run(Answer_search::BESIDE, {263, 9732, 400000423, 400003635, 400006489});
  // the names of points at the ends of polylines
  run(Answer_search::BESIDE, {525, 1507, 400000806, 400034264});
  // sources beside vertices, which paths pass on the right side; goals before the last edge; starts beside a pseudo-source
  run(Answer_search::BESIDE, {1750, 2229, 2526, 400003299, 400003536, 400004661, 400004843, 400010692, 400011616, 400028913});
  // gaps behind and beside a segment, which its rays must not take over
  run(Answer_search::BESIDE, {9935, 400023463});
  // a segment that a path from a long edge meets before an edge, up to the rounding of the long one
  run(Answer_search::BESIDE, {7078});
  // far from the origin
  run(Answer_search::BESIDE, {175, 712, 940, 1254, 1535});
  // segments shorter than 1e-8 of an edge: their points have distance 0, also where rounding puts them behind both sides
  run(Answer_search::BESIDE, {333, 510, 1643, 2152, 2297, 2503});
  // beyond an edge, two strips of a corner beside it leave no cone
  run(Answer_search::BESIDE, {2100017232});
}

// Polylines with steps inside a face or along an edge, in units of 2^-53 of the perimeter of the face: up to 16 units they are
// points.
void polylines_of_one_point()
{
  test::Surface_mesh mesh;
  const Vertex_index a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(1, 0, 0)),
                     c = mesh.add_vertex(Point_3(0, 1, 0));
  const Face_index f = mesh.add_face(a, b, c);
  const Locations<test::Surface_mesh> locations(mesh);
  const double unit = std::ldexp(2 + std::sqrt(2.), -53), part = 1. / 64; // of an edge: there, coordinates have the digits
  const auto has_sides = [&](bool on_edge, double step, int steps, bool closed) {
    Path_locations polyline;
    for (int i = 0; i <= steps; ++i)
    {
      const double x = part + i * step * unit, y = on_edge ? 0 : part;
      const auto corners = locations.corners(f);
      Face_location l(f, {0, 0, 0});
      for (std::size_t k = 0; k < 3; ++k) l.second[k] = corners[k] == a ? 1 - x - y : corners[k] == b ? x : y;
      polyline.push_back(l);
    }
    const Geodesic geodesic = built(mesh, {polyline_source(polyline, closed)});
    const auto nearest = geodesic.nearest_source(c);
    const double expected = std::sqrt(part * part + (1 - (on_edge ? 0 : part)) * (1 - (on_edge ? 0 : part)));
    CHECK(nearest && std::abs(nearest->distance - expected) <= 1e-14);
    const bool is_lateral = nearest->side == CGAL::Source_side::LEFT || nearest->side == CGAL::Source_side::RIGHT;
    CHECK(!geodesic.signed_distance_to_sources(c) == !is_lateral);
    return nearest->side != CGAL::Source_side::NONE;
  };
  for (const bool on_edge : {false, true})
  {
    CHECK(!has_sides(on_edge, 0, 1, false));
    CHECK(!has_sides(on_edge, 14, 1, false));
    CHECK(has_sides(on_edge, 18, 1, false));
    CHECK(!has_sides(on_edge, 4, 3, false)); // 12 in all
    CHECK(has_sides(on_edge, 4, 10, false)); // 40 in all: steps do not vanish one by one
    CHECK(!has_sides(on_edge, 7, 1, true));  // there and back
    CHECK(has_sides(on_edge, 18, 1, true));
  }
}

// Points in space, near the vertices of a mesh: no point of the polyline is there twice.
void located_polylines()
{
  for (const auto& [name, soup] :
       std::vector<std::pair<std::string, Soup>>{{"grid", planar_grid(6, 5)},
                                                 {"sphere", icosphere(2)},
                                                 {"box", cube_grid(3)},
                                                 {"needles", random_rectangle(1, 1e-3, 30, 5, 1)}})
  {
    Report::instance().set_context(name);
    const Generated_mesh<test::Surface_mesh> data(soup);
    const Geodesic geodesic(data.mesh);
    const Answer_checker checker(data.mesh, false);
    Random random(1);
    for (int i = 0; i < 300; ++i)
    {
      std::vector<Point_3> points;
      for (std::size_t k = 0, n = 2 + uniform_index(random, 4); k < n; ++k)
      {
        const Point_3 p = data.mesh.point(data.vertices[uniform_index(random, data.vertices.size())]);
        const double off = std::pow(10, uniform(random, -17, -2));
        points.push_back(p + Vector_3(uniform(random, -off, off), uniform(random, -off, off), uniform(random, -off, off)));
        if (uniform(random) < 0.2) points.push_back(points.back());
      }
      for (const bool is_closed : {false, true})
      {
        const auto polyline = geodesic.locate_polyline(points, CGAL::parameters::is_closed(is_closed));
        CHECK(!checker.repeats_points(polyline.locations, polyline.is_closed));
        CHECK(checker.is_connected(polyline.locations));
      }
    }
  }
}

} // namespace test_answers

GEODESIC_OFFSET_TEST(test_answers)
{
  using test::Answer_search;
  const std::pair<const char*, void (*)()> tests[] = {
    {"known cases", test_answers::known_cases},
    {"polylines of one point", test_answers::polylines_of_one_point},
    {"located polylines", test_answers::located_polylines},
    {"spread sources", [] { test_answers::run(Answer_search::SPREAD, 1, 1500); }},
    {"coinciding sources", [] { test_answers::run(Answer_search::COINCIDING, 1, 1500); }},
    {"sources beside vertices", [] { test_answers::run(Answer_search::BESIDE, 1, 500); }},
    {"polylines in faces", [] { test_answers::run(Answer_search::IN_FACES, 1, 1000); }}};
  return test::run_tests("test_answers", tests);
}
