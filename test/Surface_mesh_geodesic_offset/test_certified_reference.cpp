// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Certified bounds contain the distances of an independent reference with 113 bits, which unfolds all sequences of faces:
// on meshes that formerly violated them, on adversarial meshes of 5 to 20 faces, from points, vertices and segments with start
// values, and on general ones. The reference itself is tested with distances in the plane and closed forms. Single steps,
// in the faces of such meshes and on halfedges, keep the statements of the error analysis. Input beyond the proof is rejected.
//
//   test_certified_reference [--meshes N]

#include "certified_search.h"
#include "certified_steps.h"
#include "test_check.h"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_certified_reference {

using namespace test;

typedef Certified_search::Enclosure Enclosure;
typedef Reference_distances::Number Number;

std::size_t number_of_meshes = 6000; // adversarial, plus a tenth of this number of general ones

Certified_case case_of(const Soup& soup)
{
  Certified_case c;
  for (const Point_3& p : soup.points) c.points.push_back({p.x(), p.y(), p.z()});
  for (const auto& t : soup.triangles) c.triangles.push_back(t);
  return c;
}

double euclidean(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

void reference_in_the_plane()
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const Soup soup = random_rectangle(2, 1, 6, 1, seed);
    Certified_case c = case_of(soup);
    Reference_distances reference(c.points, c.triangles);
    reference.solve({0}, {}, {});
    for (std::size_t v = 0; v < c.points.size(); ++v)
      CHECK_DETAIL(std::abs(double(reference.of_vertex(v)) - euclidean(soup.points[0], soup.points[v])) < 1e-15,
                   values(double(reference.of_vertex(v)), euclidean(soup.points[0], soup.points[v])));
    // from a point of a face, and of an edge, to points of all faces
    const auto point = [&](const Certified_case::Location& l) {
      const auto& t = c.triangles[l.triangle];
      double x = 0, y = 0;
      for (int k = 0; k < 3; ++k)
      {
        x += l.weights[k] * c.points[t[k]][0];
        y += l.weights[k] * c.points[t[k]][1];
      }
      return Point_3(x, y, 0);
    };
    std::vector<Certified_case::Location> queries;
    for (std::size_t f = 0; f < c.triangles.size(); ++f) queries.push_back({f, {0.25, 0.25, 0.5}});
    for (const Certified_case::Location& source : {Certified_case::Location{seed, {0.5, 0.25, 0.25}}, {seed, {0.75, 0, 0.25}}})
    {
      reference.solve({}, {source}, queries);
      for (std::size_t q = 0; q < queries.size(); ++q)
        CHECK_DETAIL(std::abs(double(reference.of_query(q)) - euclidean(point(source), point(queries[q]))) < 1e-15,
                     values(double(reference.of_query(q)), euclidean(point(source), point(queries[q]))));
    }
  }
}

void reference_with_bends()
{
  // an L: around its reflex corner
  Certified_case c;
  c.points = {{1, 1, 0}, {2, 1, 0}, {2, 0, 0}, {0, 0, 0}, {0, 2, 0}, {1, 2, 0}};
  c.triangles = {{1, 0, 2}, {2, 0, 3}, {3, 0, 4}, {4, 0, 5}};
  Reference_distances reference(c.points, c.triangles);
  reference.solve({1}, {}, {});
  CHECK(reference.of_vertex(5) == Number(2) && reference.of_vertex(0) == Number(1));
  CHECK(std::abs(double(reference.of_vertex(4)) - (1 + std::sqrt(2.))) < 1e-15);
  // the opposite corner of a unit cube
  const Soup cube = cube_grid(1);
  c = case_of(cube);
  Reference_distances of_cube(c.points, c.triangles);
  of_cube.solve({0}, {}, {});
  double farthest = 0;
  for (std::size_t v = 0; v < c.points.size(); ++v)
    if (std::abs(euclidean(cube.points[0], cube.points[v]) - std::sqrt(3.)) < 1e-9) farthest = double(of_cube.of_vertex(v));
  CHECK_DETAIL(std::abs(farthest - std::sqrt(5.)) < 1e-15, values(farthest, std::sqrt(5.)));
  // an unreachable part
  Reference_distances two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  two.solve({0}, {}, {});
  CHECK(two.of_vertex(2) == Number(1) && two.of_vertex(4) == Reference_distances::infinity());
}

// Three meshes with former violations: a bounding ray that leaves through a flat face, twice, and an apex near the far end
// of an edge that is long relative to all distances.
void known_cases()
{
  struct Known
  {
    Certified_case c;
    std::size_t source, target;
    double distance;
  };
  std::vector<Known> cases(3);
  cases[0].c.points = {{-0.82019278731968059, -0.082492129927905, -0.56610850561418946},
                       {0, 0, 0},
                       {0.18124802508223958, -0.0088105160229521497, -0.26131109288076221},
                       {-0.38846372626513415, 0.018883756447567568, 0.56006674200951623},
                       {1.6403855746443747, 0.16498425985556628, 1.1322170112211507},
                       {-0.0210820019958331, -2.0475068864132928, -0.55432039407006461}};
  cases[0].c.triangles = {{1, 2, 3}, {1, 3, 0}, {1, 0, 5}, {1, 5, 2}, {3, 2, 4}};
  cases[1].c.points = {{-1, 0, 0},
                       {0, 0, 0},
                       {1.0127329380847979e-06, -0.52215836501058543, 0},
                       {1.0219661850357909e-06, 0.47784163498941457, 0},
                       {2, -8.8000000000000013e-12, 0},
                       {-0.5, -0.5, 2},
                       {0.20000102196618505, -0.12215836501058541, 0.40000000000000002}};
  cases[1].c.triangles = {{1, 2, 3}, {1, 3, 0}, {1, 0, 5}, {1, 5, 2}, {3, 2, 4}, {0, 3, 6}, {3, 4, 6}};
  for (int i : {0, 1})
  {
    cases[i].source = 0;
    cases[i].target = 4;
    cases[i].distance = 3;
  }
  cases[2].c.points = {{0, 0, 0},
                       {7.0380251529683995e-13, 0, -1.5024396073309775e-13},
                       {1.021953953895639e-12, 7.4249300916841146e-13, 8.5790651642227992e-14},
                       {3.7359561466121022e-13, 1.1498090728036763e-12, -2.3227911362302035e-13},
                       {-3.0285555308638307e-13, 9.3209354987606745e-13, -6.4153012497803578e-14},
                       {-7.5839973563013988e-13, 5.5100966116331935e-13, -2.4404505641398854e-13},
                       {-1.2912215294768589e-12, 1.581290313063985e-28, -3.7817012125034375e-13},
                       {0.77283787021244865, -1, 0.5}};
  cases[2].c.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 7, 1}, {0, 6, 7}};
  cases[2].source = 3;
  cases[2].target = 6;
  cases[2].distance = 2.0877254162284486e-12;
  Certified_search search(std::cout, 10);
  for (Known& k : cases)
  {
    k.c.kind = "known";
    k.c.source_vertices = {k.source};
    Reference_distances reference(k.c.points, k.c.triangles);
    reference.solve(k.c.source_vertices, {}, {});
    CHECK_DETAIL(std::abs(double(reference.of_vertex(k.target)) - k.distance) <= 1e-15 * k.distance,
                 values(double(reference.of_vertex(k.target)), k.distance));
    search.run(k.c, "known case");
  }
  CHECK(search.total().violations == 0 && search.total().refused == 0 && search.total().invalid == 0);
}

// Sources whose rays pass a vertex next to them: within the error of an image, and into a face that is thinner than its former
// displacement beside an edge. From searches.
void near_vertices()
{
  Certified_search search(std::cout, 10);
  for (unsigned seed : {90144505u, 100024398u}) search.run(Certified_cases::adversarial(seed, true), std::to_string(seed));
  CHECK(search.total().violations == 0 && search.total().meshes == 2);
}

// A source in a flat cap, beside its obtuse corner: outside the line of one edge by rounding, it is near another one. From an
// attack.
void in_flat_cap()
{
  Certified_case c;
  c.points = {{-0x1.cep-20, -0x1.08p-19, 0},
              {-0x1.2a962p-1, -0x1.553ddd78p-1, 0},
              {-0x1.31a03be48b832p-3, -0x1.5d496904c85aap-3, 0}};
  c.triangles = {{0, 2, 1}};
  Certified_search search(std::cout, 10);
  std::array<double, 3> weights = {0x1.c093039bc51d2p-34, 0x1.562bc5b548e16p-36, 1};
  for (std::size_t k = 0; k < 3; ++k)
  {
    std::rotate(weights.begin(), weights.begin() + 1, weights.end());
    c.sources = {{0, weights}};
    search.run(c, "flat cap " + std::to_string(k));
  }
  CHECK(search.total().violations == 0 && search.total().meshes == 3);
}

template <class Case>
void run(const Case& case_of_seed, std::size_t meshes, double median)
{
  Certified_search search(std::cout, 10);
  for (unsigned seed = 1; seed <= meshes; ++seed)
  {
    const Certified_case c = case_of_seed(seed);
    search.run(c, c.kind + ", seed " + std::to_string(seed));
  }
  search.print_table(stdout);
  Certified_counts total = search.total();
  CHECK(total.violations == 0);
  CHECK(total.bounds > 15 * meshes);
  CHECK(100 * (total.refused + total.invalid) <= meshes);
  CHECK_DETAIL(total.width(0.5) < median, values(total.width(0.5), median)); // otherwise infinite bounds would pass
}

void adversarial_meshes()
{
  run([](unsigned seed) { return Certified_cases::adversarial(seed); }, number_of_meshes, 3e-14);
}
void segments()
{
  run([](unsigned seed) { return Certified_cases::adversarial(seed, true); }, number_of_meshes, 2e-13);
}
void general_meshes() { run(Certified_cases::general, number_of_meshes / 10, 3e-14); }

// Frames of faces, and children of windows in them.
void steps_in_faces()
{
  std::size_t faces = 0;
  for (unsigned seed = 1; seed <= 400; ++seed)
  {
    const Certified_case c = Certified_cases::adversarial(seed);
    const Reference_distances reference(c.points, c.triangles);
    std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, int>> side_of;
    for (std::size_t f = 0; f < c.triangles.size(); ++f)
      for (int k = 0; k < 3; ++k) side_of[{c.triangles[f][k], c.triangles[f][(k + 1) % 3]}] = {f, k};
    const Generated_mesh<test::Surface_mesh> data(soup_of(c));
    const Geodesic geodesic(data.mesh);
    const auto& mesh = CGAL::Geodesic_offset::internal::Mesh_access::data(geodesic.mesh());
    const auto point_of = [&](auto v) { return std::size_t(mesh.surface().vertex_of[v]); };
    const CGAL::Geodesic_offset::internal::Certified_mesh certified(mesh.unfolded(), [&](auto v) {
      return c.points[point_of(v)];
    });
    Random_certified_windows random(seed);
    for (CGAL::Geodesic_offset::internal::Index h = 0; h < 3 * c.triangles.size(); ++h)
    {
      const auto [f, k] = side_of.at({point_of(mesh.unfolded().source(h)), point_of(mesh.unfolded().target(h))});
      Certified_face_check face(certified, h, reference, f, k);
      face.check_frame();
      for (int i = 0; i < 20; ++i) face.check_step(random);
      ++faces;
    }
  }
  CHECK(faces > 5000);
}

void steps_on_halfedges()
{
  for (unsigned seed = 1; seed <= 20000; ++seed)
  {
    Random_certified_windows random(seed);
    const double length = random.one_of(2) ? 1. : random.power(-8, 0);
    check_certified_envelope(random.list(length), length);
  }
}

// Flat strip of n faces, straight and nearly unidirectional; its first vertex is the source.
Soup strip(std::size_t n)
{
  Soup soup;
  for (std::size_t i = 0; i < n + 2; ++i) soup.points.push_back(Point_3(0.25 * double(i), double(i % 2), 0));
  for (std::size_t i = 0; i < n; ++i)
    if (i % 2 == 0) soup.add_triangle({i, i + 2, i + 1});
    else soup.add_triangle({i, i + 1, i + 2});
  return soup;
}

void many_faces_without_a_bend()
{
  for (const std::size_t n : {65000u, 66000u})
  {
    const Soup soup = strip(n);
    const Generated_mesh<test::Surface_mesh> data(soup);
    Enclosure enclosure(data.mesh);
    enclosure.add_source_point(data.vertices[0]);
    if (n > 65535)
    {
      CHECK_THROWS(enclosure.build(), std::runtime_error);
      CHECK(!enclosure.is_built());
      continue;
    }
    enclosure.build();
    const auto last = data.vertices.back();
    const std::pair<double, double> bounds = enclosure.distance_bounds(last);
    const double distance = euclidean(soup.points.front(), soup.points.back());
    CHECK(bounds.first <= distance * (1 + 1e-15) && bounds.second >= distance * (1 - 1e-15));
    CHECK_DETAIL(bounds.second - bounds.first < 1e-9 * distance, values(bounds.first, bounds.second));
  }
}

void rounding_mode()
{
  const Generated_mesh<test::Surface_mesh> data(planar_grid(1, 1));
  Enclosure enclosure(data.mesh);
  enclosure.add_source_point(data.vertices[0]);
  enclosure.build();
  const int mode = std::fegetround();
  for (const int other : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
  {
    std::fesetround(other);
    bool build_throws = false, query_throws = false;
    try
    {
      enclosure.build();
    }
    catch (const std::logic_error&)
    {
      build_throws = true;
    }
    try
    {
      enclosure.distance_bounds(data.vertices[1]);
    }
    catch (const std::logic_error&)
    {
      query_throws = true;
    }
    std::fesetround(mode);
    CHECK(build_throws);
    CHECK(query_throws);
  }
}

void tiny_edges()
{
  Soup soup;
  soup.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1e-70, 0), Point_3(-1e-70, 0, 0)};
  soup.add_triangle({0, 1, 2});
  soup.add_triangle({0, 2, 3});
  const Generated_mesh<test::Surface_mesh> data(soup);
  Enclosure enclosure(data.mesh);
  enclosure.add_source_point(data.vertices[0]);
  CHECK_THROWS(enclosure.build(), std::invalid_argument);
}

} // namespace test_certified_reference

GEODESIC_OFFSET_TEST(test_certified_reference)
{
  for (int i = 1; i + 1 < argc; ++i)
    if (argv[i] == std::string("--meshes")) number_of_meshes = std::strtoul(argv[i + 1], nullptr, 10);
  const std::pair<const char*, void (*)()> tests[] = {
    {"reference in the plane", reference_in_the_plane},
    {"reference with bends", reference_with_bends},
    {"steps in faces", steps_in_faces},
    {"steps on halfedges", steps_on_halfedges},
    {"known cases", known_cases},
    {"rounding mode", rounding_mode},
    {"tiny edges", tiny_edges},
    {"many faces without a bend", many_faces_without_a_bend},
    {"general meshes", general_meshes},
    {"adversarial meshes", adversarial_meshes},
    {"near a vertex", near_vertices},
    {"in a flat cap", in_flat_cap},
    {"segments with start values", segments}};
  return run_tests("test_certified_reference", tests);
}
