// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds with a tolerance against exact builds and certified bounds: no distance is larger, none is smaller by more than
// the reported bound, and the bound is within the tolerance.

#include "query_cases.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>

#include <array>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace test_bounded_error {

using namespace test;
namespace parameters = CGAL::parameters;

const double tolerances[] = {1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 0.3};

// Rounding of either distance, which the bounds exclude.
double rounding(double distance, double scale) { return 1e-12 * distance + 1e-14 * scale; }

std::string text_of(double x)
{
  std::ostringstream text;
  text << x;
  return text.str();
}

struct Totals
{
  std::size_t exact = 0, windows = 0, merged = 0;
};
std::map<double, Totals> totals; // per tolerance

// `largest`: error allowed by the tolerance at a distance.
template <class Function>
void check_distances(const Query_case& c, const Geodesic& exact, const Geodesic& g, const Path_locations& points,
                     const Function& largest)
{
  const auto& s = g.statistics();
  const auto check = [&](double d, double expected, double bound) {
    if (!CHECK_DETAIL(std::isfinite(d) == std::isfinite(expected), values(d, expected))) return;
    if (!std::isfinite(d)) return;
    const double slack = rounding(expected, c.checker.scale);
    CHECK_DETAIL(d <= expected + slack, values(d, expected));
    CHECK_DETAIL(d >= expected - bound - slack, values(d, expected));
    CHECK_DETAIL(d >= expected - largest(expected) - slack, values(d, expected));
    CHECK_DETAIL(d >= expected - s.relative_error_bound * expected - slack, values(d, expected));
  };
  for (Vertex_index v : vertices(c.mesh))
  {
    const double bound = g.error_bound(v);
    CHECK(bound >= 0 && bound <= s.error_bound);
    check(g.distance_to_sources(v), exact.distance_to_sources(v), bound);
  }
  for (const Face_location& l : points) check(g.distance_to_sources(l), exact.distance_to_sources(l), s.error_bound);
}

void check_with_all_tolerances(const Query_case& c, const std::vector<Any_source>& sources, Random& random)
{
  Geodesic exact(c.mesh), g(c.mesh);
  for (const Any_source& s : sources)
  {
    s.add_to(exact);
    s.add_to(g);
  }
  exact.build(parameters::keep_windows(true));
  CHECK(exact.statistics().error_bound == 0 && exact.statistics().relative_error_bound == 0);
  CHECK(exact.statistics().windows_merged == 0);
  const Path_locations points = c.random_points(random, 200);
  const std::string context = Report::instance().context();
  for (const double t : tolerances)
  {
    Report::instance().set_context(context + ", tolerance " + text_of(t));
    g.build(parameters::relative_tolerance(t).keep_windows(true));
    CHECK(g.statistics().relative_error_bound <= t);
    check_distances(c, exact, g, points, [t](double d) { return t * d; });
    Totals& sum = totals[t];
    sum.exact += exact.statistics().windows_propagated;
    sum.windows += g.statistics().windows_propagated;
    sum.merged += g.statistics().windows_merged;
  }
  Report::instance().set_context(context + ", merging tolerance");
  const double absolute = 1e-4 * c.checker.scale;
  g.build(parameters::merging_tolerance(absolute).keep_windows(true));
  CHECK(g.statistics().error_bound <= absolute);
  check_distances(c, exact, g, points, [absolute](double d) { return (std::min)(absolute, d / 2); });
  g.build(parameters::merging_tolerance(absolute).relative_tolerance(1e-3).keep_windows(true));
  check_distances(c, exact, g, points, [absolute](double d) { return absolute + 1e-3 * d; });
  Report::instance().set_context(context);
}

// Several kinds of sources together.
void random_sources_of(const Query_cases& cases)
{
  for (const auto& c : cases)
    for (unsigned seed = 1; seed <= 6; ++seed)
    {
      Report::instance().set_context(c->name + ", seed " + std::to_string(seed));
      Random random(seed);
      std::vector<Any_source> sources;
      for (unsigned i = 0; i < 1 + seed % 3; ++i) sources.push_back(c->random_source(random));
      check_with_all_tolerances(*c, sources, random);
    }
}

void random_sources() { random_sources_of(generated_query_cases()); }

void with_one_point(const std::string& name, const Soup& soup)
{
  Report::instance().set_context(name);
  const Query_case c(name, soup);
  Random random(1);
  check_with_all_tolerances(c, {{{random_location(c.checker.locations, c.mesh, random, 0)}, false}}, random);
}

Soup wavy(std::size_t n)
{
  Soup soup = planar_grid(n, n, Diagonals::random, 1. / double(n), 0.2, 7);
  for (Point_3& p : soup.points)
    p = Point_3(p.x(), p.y(), 0.15 * std::sin(9 * p.x()) * std::cos(7 * p.y()) + 0.05 * std::sin(23 * p.x() + 3 * p.y()));
  return soup;
}

void smooth_and_rough_shapes()
{
  with_one_point("sphere", icosphere(5));
  with_one_point("torus", torus(90, 50));
  with_one_point("wavy", wavy(60));
  with_one_point("tiny faces", marching_sphere(16));
  with_one_point("genus 5", marching_genus_5(16));
  with_one_point("needles", random_rectangle(1, 0.002, 400, 30, 3));
  with_one_point("needle fan", needle_fan(300));
  with_one_point("noisy needles", with_noise(random_rectangle(1, 0.01, 400, 30, 3), 1e-5, 1, 1e-6));
  with_one_point("rough", with_noise(wavy(40), 2e-2, 5, 1e-3));
}

void data_meshes()
{
  random_sources_of(data_query_cases());
  const Names names = {"bunny00.off", "elephant.off", "fandisk.off", "mech-holes-shark.off"};
  for_each_data_mesh(names, 80000, [](const std::string& name, const test::Surface_mesh& mesh) {
    Report::instance().set_context(name);
    const Query_case c(name, mesh);
    Random random(2);
    check_with_all_tolerances(c, {c.random_source(random), c.random_source(random)}, random);
  });
}

// Against certified bounds.
void certified()
{
  typedef CGAL::Surface_mesh_geodesic_enclosure<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh>> Enclosure;
  for (const Soup& soup : {wavy(30), with_noise(wavy(25), 2e-2, 5, 1e-3), torus(40, 24)})
  {
    const Query_case c("", soup);
    Enclosure certain(c.mesh);
    Geodesic g(c.mesh);
    for (const std::size_t i : {std::size_t(5), soup.points.size() / 2})
    {
      certain.add_source_point(Vertex_index(Vertex_index::size_type(i)));
      g.add_source_point(Vertex_index(Vertex_index::size_type(i)));
    }
    certain.build();
    for (const double t : tolerances)
    {
      g.build(parameters::relative_tolerance(t));
      for (Vertex_index v : vertices(c.mesh))
      {
        const auto bounds = certain.distance_bounds(v);
        const double d = g.distance_to_sources(v), slack = rounding(d, 1);
        CHECK_DETAIL(d <= bounds.second + slack, values(d, bounds.second));
        CHECK_DETAIL(d + g.error_bound(v) >= bounds.first - slack, values(d + g.error_bound(v), bounds.first));
      }
    }
  }
}

// Planes with noise: in exact builds, each vertex splits windows; within a tolerance, they merge again.
void noise()
{
  const auto run = [](const std::string& name, const Soup& soup, std::size_t source, double most, double least_of_exact,
                      double tolerance = 1e-9) {
    Report::instance().set_context(name);
    const Query_case c(name, soup);
    Geodesic exact(c.mesh), g(c.mesh);
    const Vertex_index s{Vertex_index::size_type(source)};
    exact.add_source_point(s);
    g.add_source_point(s);
    exact.build(parameters::keep_windows(true));
    g.build(parameters::merging_tolerance(tolerance).keep_windows(true));
    Random random(1);
    check_distances(c, exact, g, c.random_points(random, 300), [tolerance](double) { return tolerance; });
    const double n = double(soup.points.size()), a = double(g.statistics().windows_propagated) / n,
                 e = double(exact.statistics().windows_propagated) / n;
    std::cout << name << ": " << a << " windows a vertex, exactly " << e << "; error bound " << g.statistics().error_bound
              << std::endl;
    CHECK_DETAIL(a <= most, std::to_string(a));
    CHECK_DETAIL(e >= least_of_exact, std::to_string(e));
  };
  for (const double z : {1e-7, 1e-6})
  {
    const std::string name = "grid with noise " + text_of(z);
    const double exact = z == 1e-7 ? 7 : 50;
    const Soup jittered = with_noise(jittered_grid(100, 100, 1), z, 1);
    run(name + ", jittered", jittered, 0, 3.1, exact);
    run(name + ", jittered, from the middle", jittered, 5100, 3.1, exact);
    run(name + ", regular", with_noise(planar_grid(100, 100, Diagonals::alternating), z, 1), 0, 3.1, exact);
  }
  run("box with noise", with_noise(cube_grid(30), 1e-8, 1, 1e-8), 17, 4.5, 20, 1e-8);
}

// Ten tolerances, from below rounding to large. Never many more windows than in exact builds.
void check_degenerate(const Query_case& c, const std::vector<Any_source>& sources, Random& random)
{
  Geodesic exact(c.mesh), g(c.mesh);
  for (const Any_source& s : sources)
  {
    s.add_to(exact);
    s.add_to(g);
  }
  exact.build(parameters::keep_windows(true));
  const double most = 20 + 1.1 * double(exact.statistics().windows_propagated);
  const Path_locations points = c.random_points(random, 50);
  const std::string context = Report::instance().context();
  for (const double t : {1e-12, 1e-10, 1e-9, 1e-6, 1e-3})
  {
    Report::instance().set_context(context + ", tolerance " + text_of(t));
    g.build(parameters::relative_tolerance(t).keep_windows(true));
    CHECK(g.statistics().relative_error_bound <= t);
    CHECK_DETAIL(double(g.statistics().windows_propagated) <= most, std::to_string(g.statistics().windows_propagated));
    check_distances(c, exact, g, points, [t](double d) { return t * d; });
    Report::instance().set_context(context + ", merging tolerance " + text_of(t));
    const double length = t * c.checker.scale;
    g.build(parameters::merging_tolerance(length).keep_windows(true));
    CHECK(g.statistics().error_bound <= length);
    CHECK_DETAIL(double(g.statistics().windows_propagated) <= most, std::to_string(g.statistics().windows_propagated));
    check_distances(c, exact, g, points, [length](double d) { return (std::min)(length, d / 2); });
  }
  Report::instance().set_context(context);
}

// Bending needles, with noise in z of up to `noise` times the height.
Soup bent(Soup soup, double height, double noise, unsigned seed)
{
  Random random(seed);
  for (Point_3& p : soup.points)
    p = Point_3(p.x(), p.y(), height * (0.1 * std::sin(9 * p.x()) + uniform(random, -noise, noise)));
  return soup;
}

// Needles thinner than the square root of rounding, where distances do not determine directions; slits. After a rotation,
// their coordinates have the rounding errors of the longest edges.
void degenerate_meshes()
{
  const auto run = [](const std::string& name, const Soup& soup, unsigned seed) {
    const Query_case c(name, soup);
    Random random(seed);
    for (std::size_t kind = 0; kind < 3; ++kind) // vertex, edge, face
    {
      Report::instance().set_context(name + ", point " + std::to_string(kind));
      check_degenerate(c, {{{random_location(c.checker.locations, c.mesh, random, kind)}, false}}, random);
    }
    Report::instance().set_context(name + ", sources");
    check_degenerate(c, {c.random_source(random), c.random_source(random)}, random);
    Report::instance().set_context(name + ", curve");
    std::vector<Any_source> curves;
    for (const auto& s : random_plane_section(c.mesh, seed)) curves.push_back({s.locations, s.closed});
    if (!curves.empty()) check_degenerate(c, curves, random);
  };
  unsigned seed = 0;
  for (const double height : {1e-2, 1e-4, 1e-6, 4e-8, 1e-8, 5e-9, 3e-10, 1e-10})
    for (const bool is_rotated : {false, true})
    {
      ++seed;
      const std::string name = (is_rotated ? "rotated, 1 : " : "1 : ") + text_of(height);
      const auto placed = [&](const Soup& soup) { return is_rotated ? rotated(soup, seed) : soup; };
      run("needles, " + name, placed(random_rectangle(1, height, 250, 20, seed)), seed);
      run("bent needles, " + name, placed(bent(random_rectangle(1, height, 350, 25, seed), height, 1e-3, seed)), seed);
      Soup grid = planar_grid(14, 14, Diagonals::random, 1. / 14, 0.2, seed);
      for (Point_3& p : grid.points) p = Point_3(p.x(), height * p.y(), 0);
      run("squashed grid, " + name, placed(grid), seed);
    }
  run("needle fan", needle_fan(150), 1);
  run("needle fan, rotated", rotated(needle_fan(164), 85), 85);
  run("saddle fan", saddle_fan(80), 2);
  run("saddle fan, rotated", rotated(saddle_fan(80), 3), 3);
  run("strip, rotated", rotated(planar_grid(3, 400, Diagonals::random, 1, 0.2, 4), 4), 4);
}

// Larger meshes on which rays were lost, or windows with one image no longer merged. In needles, gaps stay open until the front has
// passed them, so that windows on both sides of a gap are propagated separately.
void lost_rays_and_split_windows()
{
  const auto run = [](const std::string& name, const Soup& soup, double most, double most_from_curve) {
    const Query_case c(name, soup);
    std::vector<Any_source> curves;
    for (const auto& s : random_plane_section(c.mesh, 1)) curves.push_back({s.locations, s.closed});
    for (const bool is_curve : {false, true})
    {
      Report::instance().set_context(name + (is_curve ? ", curve" : ", vertex"));
      Geodesic exact(c.mesh), g(c.mesh);
      for (Geodesic* each : {&exact, &g})
      {
        if (!is_curve) each->add_source_point(Vertex_index(0));
        else
          for (const Any_source& s : curves) s.add_to(*each);
      }
      exact.build(parameters::keep_windows(true));
      g.build(parameters::merging_tolerance(1e-9).keep_windows(true));
      Random random(1);
      check_distances(c, exact, g, c.random_points(random, 300), [](double d) { return (std::min)(1e-9, d / 2); });
      const double n = double(soup.points.size()), a = double(g.statistics().windows_propagated) / n;
      std::cout << Report::instance().context() << ": " << a << " windows a vertex, exactly "
                << double(exact.statistics().windows_propagated) / n << std::endl;
      CHECK_DETAIL(a <= (is_curve ? most_from_curve : most), std::to_string(a));
    }
  };
  for (const double height : {1e-4, 1e-6, 1e-8})
    run("rotated needles, 1 : " + text_of(height), rotated(random_rectangle(1, height, 2000, 60, 1), 5), 5.8, 9.5);
  run("rotated strip", rotated(planar_grid(4, 2500), 3), 3, 3);
}

// Valid and invalid queries.
void queries()
{
  const Query_case c("", wavy(30));
  Random random(3);
  const std::vector<Any_source> sources = {c.random_source(random), c.random_source(random), c.random_source(random)};
  Geodesic exact(c.mesh), g(c.mesh);
  std::vector<Geodesic> single;
  for (const Any_source& s : sources)
  {
    s.add_to(exact);
    s.add_to(g);
    single.emplace_back(c.mesh);
    s.add_to(single.back());
    single.back().build();
  }
  exact.build(parameters::keep_windows(true));
  g.build(parameters::relative_tolerance(1e-4).keep_windows(true));
  std::map<Vertex_index, std::size_t> labels;
  g.source_labels(boost::make_assoc_property_map(labels));
  for (Vertex_index v : vertices(c.mesh))
  {
    const double d = g.distance_to_sources(v), slack = rounding(d, 1);
    // the labelled source is nearest within the bound
    CHECK(single[labels.at(v)].distance_to_sources(v) <= d + g.error_bound(v) + slack);
    const double length = std::sqrt(g.gradient(v).value_or(CGAL::NULL_VECTOR).squared_length());
    CHECK(d == 0 || std::abs(length - 1) < 1e-12);
  }
  std::size_t turned = 0, other_side = 0;
  const Path_locations points = c.random_points(random, 300);
  for (const Face_location& l : points)
  {
    const Vector_3 a = g.gradient(l).value_or(CGAL::NULL_VECTOR), b = exact.gradient(l).value_or(CGAL::NULL_VECTOR);
    if (exact.distance_to_sources(l) > 0 && a * b < 0.99) ++turned;
    const double x = or_nan(g.signed_distance_to_sources(l)), y = or_nan(exact.signed_distance_to_sources(l));
    CHECK(std::isnan(x) || std::abs(x) == g.distance_to_sources(l));
    if (std::isnan(x) != std::isnan(y) || x * y < 0) ++other_side;
  }
  CHECK_DETAIL(turned <= points.size() / 20, std::to_string(turned)); // near ridges
  CHECK_DETAIL(other_side <= points.size() / 50, std::to_string(other_side));

  const Vertex_index v(3);
  Path_locations path;
  std::vector<Geodesic::Offset_curve> curves;
  CHECK_THROWS(g.shortest_path_to_sources(v, std::back_inserter(path)), std::logic_error);
  CHECK_THROWS(g.nearest_source(v), std::logic_error);
  CHECK_THROWS(g.farthest_point(), std::logic_error);
  g.build(parameters::relative_tolerance(0.)); // exact
  g.shortest_path_to_sources(v, std::back_inserter(path));
  g.build_with_offset_curves(0.1, std::back_inserter(curves), parameters::relative_tolerance(0.).merging_tolerance(0.));
  CHECK(!path.empty() && !curves.empty());
}

// A point in a face of a small mesh, from kept windows: the distance within a tolerance is not larger than the exact one.
void check_point(const std::string& name, std::size_t source, double relative, double length, std::size_t face,
                 const std::array<double, 3>& weights, double expected)
{
  Report::instance().set_context(name);
  Surface_mesh mesh;
  const std::string file = std::string(GEODESIC_OFFSET_TEST_DIR) + "/data/" + name;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) throw std::runtime_error("cannot read " + file);
  Geodesic geodesic(mesh);
  geodesic.add_source_point(Vertex_index(Surface_mesh::size_type(source)));
  const Face_location point(Face_index(Surface_mesh::size_type(face)), weights);
  const double exact = geodesic.build(parameters::keep_windows(true)).distance_to_sources(point);
  CHECK_DETAIL(std::abs(exact - expected) <= rounding(expected, 1), values(exact, expected));
  const auto field = geodesic.build(parameters::relative_tolerance(relative).merging_tolerance(length).keep_windows(true));
  const double d = field.distance_to_sources(point);
  CHECK_DETAIL(d <= expected + rounding(expected, 1), values(d, expected));
  CHECK_DETAIL(d >= expected - field.statistics().error_bound - rounding(expected, 1), values(d, expected));
}

// Kept windows take sigma from the pseudo-source unless they have an origin of their own: merged windows with new images must.
void new_images()
{
  check_point("tolerance_new_images.off", 81, 0, 5.37e-6, 21,
              {{0.025145871555036781, 0.21603197880646507, 0.75882214963849814}}, 0.17068885786378057);
}

// A gap between windows beside the bounding ray of a pseudo-source: if it is closed before the window of the pseudo-source
// arrives, this window is lost where the gap opens again.
void gaps()
{
  check_point("tolerance_gaps.off", 0, 1.07e-6, 0, 0, {{0.78924845808932353, 0.19835356576433127, 0.012397976146345203}},
              0.17854352230673831);
}

void bad_tolerances()
{
  const Query_case c("", torus(12, 8));
  Geodesic g(c.mesh);
  g.add_source_point(Vertex_index(0));
  g.build();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double t : {-1e-9, -infinity, 0.51, infinity, nan})
    CHECK_THROWS(g.build(parameters::relative_tolerance(t)), std::invalid_argument);
  for (const double t : {-1e-9, -infinity, infinity, nan})
    CHECK_THROWS(g.build(parameters::merging_tolerance(t)), std::invalid_argument);
  CHECK(g.error_bound(Vertex_index(1)) == 0);
  // a huge length leaves half of each distance
  g.build(parameters::merging_tolerance(1e300));
  CHECK(g.statistics().relative_error_bound <= 0.5);
}

// Updates keep the tolerance, also with a maximum distance and targets.
void updates_and_limits()
{
  const Query_case c("", wavy(40));
  Geodesic g(c.mesh), scratch(c.mesh), exact(c.mesh);
  const auto add = [&](Vertex_index v) {
    for (Geodesic* each : {&g, &scratch, &exact}) each->add_source_point(v);
  };
  add(Vertex_index(7));
  g.build(parameters::relative_tolerance(1e-4).keep_windows(true));
  add(Vertex_index(1000));
  g.update();
  scratch.build(parameters::relative_tolerance(1e-4).keep_windows(true));
  for (Vertex_index v : vertices(c.mesh)) CHECK(g.distance_to_sources(v) == scratch.distance_to_sources(v));
  CHECK(g.statistics().error_bound == scratch.statistics().error_bound && g.statistics().error_bound > 0);

  exact.build();
  const double limit = 0.4 * largest_vertex_distance(exact, c.mesh);
  g.build(parameters::relative_tolerance(1e-3).distance_limit(limit));
  std::size_t beyond = 0;
  for (Vertex_index v : vertices(c.mesh))
  {
    const double d = g.distance_to_sources(v), e = exact.distance_to_sources(v), slack = rounding(e, 1);
    if (e <= limit) CHECK(d <= e + slack && d >= (1 - 1e-3) * e - slack);
    else CHECK(!std::isfinite(d) || (d <= limit && d >= (1 - 1e-3) * e - slack));
    beyond += std::isfinite(d) ? 0 : 1;
  }
  CHECK(beyond > 0);
  const std::vector<Vertex_index> targets = {Vertex_index(900)};
  g.build(parameters::targets(targets).relative_tolerance(1e-3));
  const double e = exact.distance_to_sources(targets[0]), d = g.distance_to_sources(targets[0]);
  CHECK_DETAIL(d <= e + rounding(e, 1) && d >= (1 - 1e-3) * e - rounding(e, 1), values(d, e));
}

// Savings: all cases above together, and increasingly fine meshes of a shape.
void fewer_windows()
{
  for (const auto& item : totals)
  {
    const double part = double(item.second.windows) / double(item.second.exact);
    std::cout << "tolerance " << item.first << ": " << 100 * part << " % of the exact windows, " << item.second.merged
              << " merged\n";
    CHECK_DETAIL(part < (item.first < 1e-8   ? 1
                         : item.first < 1e-5 ? 0.9
                         : item.first < 1e-3 ? 0.6
                                             : 0.4),
                 std::to_string(part));
  }
  double last = infinity;
  for (const std::size_t n : {40, 80, 160})
  {
    const Query_case c("", torus(n, n / 2));
    Geodesic exact(c.mesh), g(c.mesh);
    exact.add_source_point(Vertex_index(0));
    g.add_source_point(Vertex_index(0));
    exact.build();
    g.build(parameters::relative_tolerance(1e-4));
    const double part = double(g.statistics().windows_propagated) / double(exact.statistics().windows_propagated);
    CHECK_DETAIL(part < 0.75 * last, std::to_string(part));
    last = part;
  }
}

} // namespace test_bounded_error

GEODESIC_OFFSET_TEST(test_bounded_error)
{
  std::cout.precision(3);
  const std::pair<const char*, std::function<void()>> tests[] = {
    {"random sources", random_sources},
    {"shapes", smooth_and_rough_shapes},
    {data_case, data_meshes},
    {"certified", certified},
    {"noise", noise},
    {"degenerate meshes", degenerate_meshes},
    {"lost rays, split windows", lost_rays_and_split_windows},
    {"queries", queries},
    {"kept windows of new images", new_images},
    {"gaps", gaps},
    {"bad tolerances", bad_tolerances},
    {"updates and limits", updates_and_limits},
    {"fewer windows", fewer_windows}};
  return run_tests("test_bounded_error", tests);
}
