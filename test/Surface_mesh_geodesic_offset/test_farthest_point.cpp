// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The farthest point: closed forms in the plane and on polyhedra; on generated and data meshes, no sample may be farther,
// and the distance must be attained at the point. Each with kept windows and during the propagation, the latter also with
// offsets, limits, targets, updates and tolerances.

#include "closed_forms.h"
#include "known_cases.h"
#include "planar_polyline.h"
#include "query_cases.h"

#include <string>
#include <vector>

namespace test_farthest_point {

using namespace test;

typedef std::pair<Face_location, double> Farthest;

Worst_error& error()
{
  static Worst_error worst(1e-12, 4);
  return worst;
}

/// Builds in both ways, and checks the properties of a farthest point. Returns that from windows.
Farthest farthest_point(Geodesic& geodesic, const test::Surface_mesh& mesh)
{
  geodesic.build(CGAL::parameters::compute_largest_distance(true));
  const Farthest on_the_way = geodesic.farthest_point().value();
  CHECK(on_the_way.second == geodesic.largest_distance().value());
  CHECK(on_the_way.second >= geodesic.largest_vertex_distance().value());
  geodesic.build(CGAL::parameters::keep_windows(true));
  CHECK(geodesic.statistics().faces_searched == 0);
  const Farthest result = geodesic.farthest_point().value();
  CHECK(result.second == geodesic.largest_distance().value());
  CHECK_CLOSE(error(), on_the_way.second, result.second);
  CHECK_CLOSE(error(), geodesic.distance_to_sources(on_the_way.first), result.second);
  for (const double w : result.first.second) CHECK(w >= -1e-13 && w <= 1 + 1e-13);
  CHECK_CLOSE(error(), geodesic.distance_to_sources(result.first), result.second);
  for (const auto v : vertices(mesh))
  {
    const double d = geodesic.distance_to_sources(v);
    if (std::isfinite(d)) CHECK_DETAIL(d <= result.second, values(d, result.second));
  }
  return result;
}

/// Checks that the point is at one of the places, up to `tolerance`.
void check_place(const Point_2& p, const std::vector<Point_2>& places, double tolerance = 1e-11)
{
  double nearest = infinity;
  for (const Point_2& q : places) nearest = (std::min)(nearest, distance(p, q));
  CHECK_DETAIL(nearest <= tolerance, std::to_string(p.x()) + ' ' + std::to_string(p.y()));
}

/// Points of a planar mesh as sources, and the expected farthest points.
void points_in_plane(const Planar_mesh& plane, const std::vector<Point_2>& sources, const std::vector<Point_2>& places)
{
  Geodesic geodesic(plane.data.mesh);
  for (const Point_2& p : sources) geodesic.add_source_point(plane.location(p));
  double expected = infinity;
  for (const Point_2& p : sources) expected = (std::min)(expected, distance(p, places.front()));
  const Farthest result = farthest_point(geodesic, plane.data.mesh);
  CHECK_CLOSE(error(), result.second, expected);
  check_place(plane.uv(result.first), places);
}

void unit_square()
{
  const Point_2 a(0, 0), b(1, 0), c(1, 1), d(0, 1), m(0.5, 0.5);
  const std::pair<const char*, Soup> soups[] = {
    {"two triangles", random_rectangle(1, 1, 0, 0, 1)},
    {"random square", random_rectangle(1, 1, 60, 4, 2)},
    {"turned random square", rotated(random_rectangle(1, 1, 60, 4, 3), 5)},
    {"forward grid", planar_grid(8, 8, Diagonals::forward, 0.125)},
    {"odd grid", planar_grid(7, 7, Diagonals::alternating, 1. / 7)},
    {"random grid", planar_grid(9, 9, Diagonals::random, 1. / 9)}};
  for (const auto& soup : soups)
  {
    Report::instance().set_context(soup.first);
    const Planar_mesh plane(soup.second);
    points_in_plane(plane, {a}, {c});
    points_in_plane(plane, {m}, {a, b, c, d});
    points_in_plane(plane, {a, b, c, d}, {m});
    points_in_plane(plane, {a, c}, {b, d});
    points_in_plane(plane, {a, b}, {Point_2(0.5, 1)}); // where two distances tie on the border
    points_in_plane(plane, {Point_2(0.5, 0)}, {c, d});
    points_in_plane(plane, {a, b, Point_2(0.5, 1)}, {Point_2(0.5, 0.375), Point_2(0, 0.625), Point_2(1, 0.625)});
    points_in_plane(plane, {a, b, c, d, m}, {Point_2(0.5, 0), Point_2(1, 0.5), Point_2(0.5, 1), Point_2(0, 0.5)});
  }
}

/// Triangle with its vertices as sources: the circumcentre, or a point of the longest edge.
void triangle_from_its_vertices()
{
  Report::instance().set_context("triangle from its vertices");
  const Point_2 a(0, 0), b(1, 0);
  for (const Point_2& c : {Point_2(0.5, std::sqrt(0.75)), Point_2(0.3, 0.8), Point_2(0.6, 1.9), Point_2(0, 1),
                           Point_2(0.2, 0.1), Point_2(0.55, 0.01)})
  {
    Soup soup;
    for (const Point_2& p : {a, b, c}) soup.points.push_back(Point_3(p.x(), p.y(), 0));
    soup.add_triangle({{0, 1, 2}}, 0, {{a, b, c}});
    const double angle_at_c = std::acos(((a - c) * (b - c)) / (distance(a, c) * distance(b, c)));
    std::vector<Point_2> places;
    if (angle_at_c <= CGAL_PI / 2 + 1e-9) places.push_back(CGAL::circumcenter(a, b, c));
    else
    {
      // as far from c as from a or b
      const double ta = (c - a).squared_length() / (2 * c.x()), tb = (c - b).squared_length() / (2 * (1 - c.x()));
      places.push_back(ta > tb ? Point_2(ta, 0) : Point_2(1 - tb, 0));
    }
    points_in_plane(Planar_mesh(soup), {a, b, c}, places);
    points_in_plane(Planar_mesh(rotated(soup, 7)), {a, b, c}, places);
  }
}

/// Two parallel polylines: the distance is largest along a line.
void strip(const Planar_mesh& plane, double low, double high, double height)
{
  Geodesic geodesic(plane.data.mesh);
  plane.add(geodesic, {Point_2(0, low), Point_2(4, low)});
  plane.add(geodesic, {Point_2(0, high), Point_2(4, high)});
  const Farthest result = farthest_point(geodesic, plane.data.mesh);
  CHECK_CLOSE(error(), result.second, (std::max)({low, (high - low) / 2, height - high}));
}

void strips()
{
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    Report::instance().set_context("strip " + std::to_string(seed));
    const Planar_mesh random(random_rectangle(4, 3, 80, 6, seed)), turned(rotated(random_rectangle(4, 3, 80, 6, seed), seed));
    const Planar_mesh grid(planar_grid(16, 12, Diagonals(seed - 1), 0.25));
    const Planar_mesh needles(random_rectangle(4, 0.003, 40, 3, seed));
    for (const Planar_mesh* plane : {&random, &turned, &grid})
    {
      strip(*plane, 0.25, 2.75, 3);
      strip(*plane, 1, 2, 3);
      strip(*plane, 0.4, 0.5, 3);
      strip(*plane, 1.1, 2.9, 3);
    }
    strip(needles, 0.001, 0.0025, 0.003);
    strip(needles, 0.0001, 0.0029, 0.003);
  }
}

/// Patches with closed form: the distance at the point, and a given largest distance.
void from_point(const std::string& name, const Soup& soup, std::size_t source_patch, const Point_2& source, double expected)
{
  Report::instance().set_context(name);
  const Generated_mesh<test::Surface_mesh> data(soup);
  // the face of the patch that contains the point
  for (std::size_t i = 0; i < data.faces.size(); ++i)
  {
    if (data.patches[i] != source_patch) continue;
    const std::array<Point_2, 3>& c = data.uv[i];
    std::array<double, 3> w;
    const double all = CGAL::area(c[0], c[1], c[2]);
    for (std::size_t k = 0; k < 3; ++k) w[k] = CGAL::area(source, c[(k + 1) % 3], c[(k + 2) % 3]) / all;
    if (*std::min_element(w.begin(), w.end()) < -1e-13) continue;
    for (double& x : w)
      if (std::abs(x) < 1e-14) x = 0;
    Geodesic geodesic(data.mesh);
    geodesic.add_source_point(Face_location(data.faces[i], w));
    const Farthest result = farthest_point(geodesic, data.mesh);
    CHECK_CLOSE(error(), result.second, expected);
    return;
  }
  CHECK(!"no face contains the source");
}

void polyhedra()
{
  for (const std::size_t n : {1, 2, 3, 5})
  {
    const std::string suffix = " of " + std::to_string(n);
    from_point("cube from a corner" + suffix, cube_grid(n), 0, Point_2(0, 0), std::sqrt(5.));
    from_point("cube from the centre of a side" + suffix, cube_grid(n), 0, Point_2(0.5, 0.5), 2);
  }
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    // not the opposite corner, but a quarter of the diagonal of the square side away from it
    const Polyhedron_sides box = box_sides(1, 1, 2);
    for (const std::size_t points : {0, 2, 10})
      from_point("box from a corner", rotated(box.triangulated(points, points / 2, seed), seed), 0, box.uv(0)[0],
                 std::sqrt(130.) / 4);
    const Polyhedron_sides tetrahedron = tetrahedron_sides();
    const double edge = distance(tetrahedron.uv(0)[0], tetrahedron.uv(0)[1]);
    for (const std::size_t points : {0, 2, 10})
      from_point("tetrahedron from a corner", rotated(tetrahedron.triangulated(points, points / 2, seed), seed), 0,
                 tetrahedron.uv(0)[0], edge * 2 / std::sqrt(3.));
  }
}

/// Checks that no sample is farther, neither anywhere nor near the point.
void check_samples(const Geodesic& geodesic, const test::Surface_mesh& mesh, const Farthest& farthest, std::size_t count,
                   Random& random)
{
  const Locations<test::Surface_mesh> on_mesh(mesh);
  const std::vector<test::Surface_mesh::Face_index> all(faces(mesh).begin(), faces(mesh).end());
  const auto check = [&](const Face_location& l) {
    const double d = geodesic.distance_to_sources(l);
    if (std::isfinite(d)) CHECK_DETAIL(d <= farthest.second * (1 + 1e-12), values(d, farthest.second));
  };
  for (std::size_t i = 0; i < count; ++i)
    check(Face_location(all[uniform_index(random, all.size())], random_barycentric(random)));
  std::vector<test::Surface_mesh::Face_index> around;
  for (const auto v : on_mesh.corners(farthest.first.first))
    for (const auto h : CGAL::halfedges_around_target(v, mesh))
      if (!is_border(h, mesh)) around.push_back(face(h, mesh));
  for (std::size_t i = 0; i < count; ++i)
    check(Face_location(around[uniform_index(random, around.size())], random_barycentric(random)));
  for (double t = 0.1; t > 1e-9; t /= 3)
    for (int i = 0; i < 20; ++i)
    {
      Face_location l(farthest.first.first, random_barycentric(random));
      for (std::size_t k = 0; k < 3; ++k) l.second[k] = (1 - t) * farthest.first.second[k] + t * l.second[k];
      check(l);
    }
}

/// Sources of all kinds.
void sources_of_all_kinds(const Query_case& c, std::size_t samples, unsigned seed)
{
  Random random(seed);
  for (std::size_t i = 0; i < 6; ++i)
  {
    c.set_context("seed " + std::to_string(seed) + ", sources " + std::to_string(i));
    Geodesic geodesic(c.mesh);
    if (i < 5) geodesic.add_sources(c.random_sources(random, i < 3 ? 1 : i));
    else if (geodesic.add_source_boundary().empty()) continue;
    check_samples(geodesic, c.mesh, farthest_point(geodesic, c.mesh), samples, random);
  }
}

void generated_meshes()
{
  for_each_mesh(all_mesh_names(), {}, [](const Query_case& c) {
    for (unsigned seed = 1; seed <= 3; ++seed) sources_of_all_kinds(c, 1500, seed);
  });
}

void data_meshes()
{
  for_each_mesh(
    {}, data_mesh_names(), [](const Query_case& c) { sources_of_all_kinds(c, 200, 1); }, 6000);
}

/// Plates whose border is the source: all vertices have distance zero.
void plates()
{
  const auto largest = [](const Soup& soup) {
    const Generated_mesh<test::Surface_mesh> plate(soup);
    Geodesic geodesic(plate.mesh);
    CHECK(!geodesic.add_source_boundary().empty());
    const double result = farthest_point(geodesic, plate.mesh).second;
    CHECK(geodesic.largest_vertex_distance().value() == 0);
    return result;
  };
  Report::instance().set_context("plate");
  const double width = 100, height = 60, a = 30, b = 20; // a and b: of the frame around the hole
  const auto corner = [](double x, double y) { return Point_3(x, y, 0); };
  Soup plate;
  plate.points = {corner(0, 0), corner(width, 0), corner(width, height), corner(0, height)};
  Soup with_hole = plate;
  plate.add_triangle({{0, 1, 2}});
  plate.add_triangle({{0, 2, 3}});
  CHECK_CLOSE(error(), largest(plate), height / 2);
  for (const Point_3& p : {corner(a, b), corner(width - a, b), corner(width - a, height - b), corner(a, height - b)})
    with_hole.points.push_back(p);
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t j = (i + 1) % 4;
    with_hole.add_triangle({{i, j, i + 4}});
    with_hole.add_triangle({{j, j + 4, i + 4}});
  }
  // as far from two sides of the plate as from a corner of the hole
  const double t = a + b - std::sqrt(2 * a * b);
  CHECK(t > a / 2 && t < b);
  CHECK_CLOSE(error(), largest(with_hole), t);
  CHECK_CLOSE(error(), largest(rotated(with_hole, 4)), t);
}

/// The largest distance during propagation, in builds of all kinds.
void builds_of_all_kinds(const std::string& name, const test::Surface_mesh& mesh, const Face_location& source,
                         const Face_location& other)
{
  namespace parameters = CGAL::parameters;
  const auto wanted = parameters::compute_largest_distance(true);
  const auto context = [&](const char* what) { Report::instance().set_context(name + ", " + what); };
  context("everywhere");
  Geodesic geodesic(mesh);
  geodesic.add_source_point(source);
  const double full = farthest_point(geodesic, mesh).second;
  const double at_vertices = geodesic.largest_vertex_distance().value();
  const auto check = [&](double expected) { CHECK_CLOSE(error(), geodesic.largest_distance().value(), expected); };

  context("offsets");
  std::vector<Geodesic::Offset_curve> curves, again;
  const std::vector<double> levels = {0.3 * full, 0.9 * full};
  geodesic.build_with_offset_curves(levels, std::back_inserter(curves));
  CHECK_THROWS(geodesic.largest_distance(), std::logic_error);
  geodesic.build_with_offset_curves(levels, std::back_inserter(again), wanted);
  check(full);
  CHECK(again.size() == curves.size() && !curves.empty());

  for (const bool keep : {false, true})
  {
    context(keep ? "a limit, with windows" : "a limit");
    for (const double limit : {0., 1e-6 * full, 0.2 * full, at_vertices, (at_vertices + full) / 2})
      if (limit < full)
      {
        geodesic.build(wanted.distance_limit(limit).keep_windows(keep));
        CHECK_DETAIL(geodesic.largest_distance().value() == limit, values(geodesic.largest_distance().value(), limit));
        CHECK_THROWS(geodesic.farthest_point(), std::logic_error);
      }
    geodesic.build(wanted.distance_limit(1.001 * full).keep_windows(keep));
    check(full);
    geodesic.build_with_offset_curves(levels, std::back_inserter(curves),
                                      wanted.distance_limit(levels.back()).keep_windows(keep));
    CHECK(geodesic.largest_distance().value() == levels.back());
  }

  context("a cancel");
  geodesic.build(wanted.visitor([](double part) { return part < 0.4; }));
  if (geodesic.is_cancelled()) CHECK(geodesic.largest_distance().value() == geodesic.covered_distance());
  else CHECK(mesh.number_of_faces() < 20); // all of them are finalized at the end

  context("targets");
  const std::vector<Face_location> targets = {other};
  geodesic.build(wanted.targets(targets));
  const double covered = geodesic.covered_distance();
  if (covered < at_vertices) CHECK(geodesic.largest_distance().value() == covered);
  else check((std::min)(covered, full));

  context("a tolerance");
  geodesic.build(wanted.relative_tolerance(1e-3));
  CHECK(geodesic.largest_distance().value() <= full * (1 + 1e-12));
  CHECK(geodesic.largest_distance().value() >= full * (1 - 1e-12) - geodesic.statistics().error_bound);
  CHECK_THROWS(geodesic.farthest_point(), std::logic_error);

  context("an update");
  geodesic.add_source_point(other);
  const double of_both = farthest_point(geodesic, mesh).second;
  CHECK(of_both <= full);
  for (const bool keep : {false, true})
    for (const double limit : {infinity, 1.001 * of_both, 0.5 * of_both, 1e-6 * of_both})
    {
      Geodesic updated(mesh);
      updated.add_source_point(source);
      updated.build(wanted.distance_limit(limit).keep_windows(keep));
      updated.add_source_point(other);
      updated.update();
      CHECK_CLOSE(error(), updated.largest_distance().value(), (std::min)(limit, of_both));
    }
}

void builds_of_all_kinds()
{
  const std::pair<const char*, Soup> soups[] = {
    {"jittered grid", jittered_grid(12, 9, 4)},
    {"cube", cube_grid(5)},
    {"icosphere", icosphere(3)},
    {"torus", torus(24, 12)},
    {"saddle", saddle_fan()},
    {"marching sphere", marching_sphere(8)}};
  for (const auto& soup : soups)
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
      const Generated_mesh<test::Surface_mesh> data(rotated(soup.second, seed));
      Random random(seed);
      const auto point = [&](bool is_vertex) {
        const auto f = data.faces[uniform_index(random, data.faces.size())];
        return Face_location(f, is_vertex ? std::array<double, 3>{{1, 0, 0}} : random_barycentric(random));
      };
      builds_of_all_kinds(soup.first, data.mesh, point(seed == 1), point(seed == 2));
    }
}

/// Few faces are searched during propagation, even if many have the same distance.
void searched_faces()
{
  const std::pair<const char*, Soup> soups[] = {
    {"jittered grid", jittered_grid(90, 70, 4)},
    {"grid", planar_grid(90, 70)},
    {"icosphere", icosphere(5)},
    {"torus", torus(120, 60)},
    {"genus 5", marching_genus_5(20)}};
  std::size_t searched = 0;
  for (const auto& soup : soups)
  {
    Report::instance().set_context(std::string(soup.first) + ", searched faces");
    const Generated_mesh<test::Surface_mesh> data(soup.second);
    for (const std::size_t number_of_sources : {1, 20})
    {
      Geodesic geodesic(data.mesh);
      for (std::size_t i = 0; i < number_of_sources; ++i)
        geodesic.add_source_point(data.vertices[i * data.vertices.size() / number_of_sources]);
      geodesic.build(CGAL::parameters::compute_largest_distance(true));
      searched += geodesic.statistics().faces_searched;
      CHECK_DETAIL(geodesic.statistics().faces_searched < data.faces.size() / 50,
                   std::to_string(geodesic.statistics().faces_searched) + " of " + std::to_string(data.faces.size()));
    }
  }
  CHECK(searched > 0);

  Report::instance().set_context("strip, searched faces"); // the front is as long as the mesh
  const Generated_mesh<test::Surface_mesh> strip(planar_grid(1200, 20));
  std::vector<test::Surface_mesh::Edge_index> bottom;
  for (const auto e : strip.mesh.edges())
    if (strip.mesh.point(strip.mesh.vertex(e, 0)).y() + strip.mesh.point(strip.mesh.vertex(e, 1)).y() == 0) bottom.push_back(e);
  CHECK(bottom.size() == 1200);
  Geodesic geodesic(strip.mesh);
  geodesic.add_source_edges(bottom);
  geodesic.build(CGAL::parameters::compute_largest_distance(true));
  CHECK_CLOSE(error(), geodesic.largest_distance().value(), 20);
  CHECK_DETAIL(geodesic.statistics().faces_searched <= 2 * 1200, // the last row
               std::to_string(geodesic.statistics().faces_searched));
}

void unreached_parts()
{
  Report::instance().set_context("unreached parts");
  const Generated_mesh<test::Surface_mesh> two([] {
    Soup soup = planar_grid(2, 2), other = planar_grid(20, 20);
    const std::size_t n = soup.points.size();
    for (const Point_3& p : other.points) soup.points.push_back(p + Vector_3(9, 0, 0));
    for (const auto& t : other.triangles) soup.add_triangle({{t[0] + n, t[1] + n, t[2] + n}});
    return soup;
  }());
  Geodesic geodesic(two.mesh);
  CHECK_THROWS(geodesic.farthest_point(), std::logic_error);
  CHECK_THROWS(geodesic.largest_vertex_distance(), std::logic_error);
  for (const bool keep : {true, false})
  {
    geodesic.build(CGAL::parameters::keep_windows(keep).compute_largest_distance(!keep));
    CHECK(!geodesic.farthest_point() && !geodesic.largest_distance() && !geodesic.largest_vertex_distance()); // no source
  }

  geodesic.add_source_point(two.vertices[0]);
  CHECK_CLOSE(error(), farthest_point(geodesic, two.mesh).second, std::sqrt(8.));
  const auto support = Locations<test::Surface_mesh>(two.mesh).support(geodesic.farthest_point()->first);
  CHECK(support.size() == 1 && support[0].first == two.vertices[8]);
  geodesic.build();
  CHECK_THROWS(geodesic.farthest_point(), std::logic_error);
  CHECK_THROWS(geodesic.largest_distance(), std::logic_error);
  geodesic.build(CGAL::parameters::distance_limit(1.5).keep_windows(true));
  CHECK_THROWS(geodesic.farthest_point(), std::logic_error);
}

/// Faces whose windows come from points so near to an edge that their rays graze it. A point on the edge, up to rounding, was
/// taken as beside these rays, and its distance as that around an end of their window: up to 1e-8 too long.
void grazed_edges()
{
  Random random(1);
  for (const Known_case& c : known_cases("grazed_edges.txt"))
  {
    Report::instance().set_context(c.name);
    Geodesic geodesic(c.mesh);
    geodesic.add_sources(source_set(c.sources));
    const Farthest result = farthest_point(geodesic, c.mesh);
    check_samples(geodesic, c.mesh, result, 1000, random);
  }
}

} // namespace test_farthest_point

GEODESIC_OFFSET_TEST(test_farthest_point)
{
  std::cout.precision(3);
  const std::pair<const char*, void (*)()> tests[] = {
    {"unit square", unit_square},
    {"triangle from its vertices", triangle_from_its_vertices},
    {"strips", strips},
    {"polyhedra", polyhedra},
    {"generated meshes", generated_meshes},
    {data_case, data_meshes},
    {"plates", plates},
    {"builds of all kinds", builds_of_all_kinds},
    {"searched faces", searched_faces},
    {"unreached parts", unreached_parts},
    {"grazed edges", grazed_edges}};
  const int result = run_tests("test_farthest_point", tests);
  std::cout << "worst relative error of the distance " << error().error() << std::endl;
  return result;
}
