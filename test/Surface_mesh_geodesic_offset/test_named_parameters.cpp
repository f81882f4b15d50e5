// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Named parameters in every order: those of CGAL and those of the package. refused.cpp has parameters that a function does not
// read, which must not compile.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "offset_tools.h"
#include "test_check.h"

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace test_named_parameters {

using namespace test;

typedef test::Surface_mesh Mesh;
typedef Mesh::Vertex_index Vertex_index;

struct Visitor
{
  int calls = 0;
  double last = 0;

  bool operator()(double fraction)
  {
    ++calls;
    last = fraction;
    return true;
  }
};

/// Named parameters in an order: each function appends one.
template <class NP>
auto chain(const NP& np)
{
  return np;
}
template <class NP, class P, class... Ps>
auto chain(const NP& np, const P& p, const Ps&... ps)
{
  return chain(p(np), ps...);
}

/// The text that a function writes to std::clog.
template <class Function>
std::string logged(const Function& f)
{
  std::ostringstream text;
  std::streambuf* const before = std::clog.rdbuf(text.rdbuf());
  f();
  std::clog.rdbuf(before);
  return text.str();
}

class Orders
{
public:
  Orders() : data_(rotated(torus(16, 10), 1)), geodesic_(data_.mesh)
  {
    geodesic_.add_source_point(Vertex_index(3));
    geodesic_.build(CGAL::parameters::keep_windows(true).distance_limit(0.9).concurrency_tag(CGAL::Parallel_if_available_tag()));
    expected_ = distances();
    CHECK(std::count(expected_.begin(), expected_.end(), infinity) > 0);
  }

  void run()
  {
    const auto keep = [](const auto& np) { return np.keep_windows(true); };
    const auto verbose = [](const auto& np) { return np.verbose(true); };
    const auto limit = [](const auto& np) { return np.distance_limit(0.9); };
    const auto visit = [this](const auto& np) { return np.visitor(std::ref(visitor_)); };
    const auto parallel = [](const auto& np) { return np.concurrency_tag(CGAL::Parallel_if_available_tag()); };
    three(keep, verbose, limit, visit);
    three(verbose, keep, limit, visit);
    three(limit, keep, verbose, visit);
    three(visit, keep, verbose, limit);
    for_order(parallel, visit, keep, limit, verbose);
    for_order(visit, parallel, verbose, limit, keep);
    for_order(limit, verbose, visit, keep, parallel);
    CHECK(number_ == 4 * 3 * 2 + 3);
  }

private:
  template <class First, class A, class B, class C>
  void three(const First& first, const A& a, const B& b, const C& c)
  {
    for_order(first, a, b, c);
    for_order(first, a, c, b);
    for_order(first, b, a, c);
    for_order(first, b, c, a);
    for_order(first, c, a, b);
    for_order(first, c, b, a);
  }

  template <class... Ps>
  void for_order(const Ps&... ps)
  {
    Report::instance().set_context("order " + std::to_string(++number_));
    visitor_ = Visitor();
    geodesic_.build();
    const std::string text = logged([&] { geodesic_.build(chain(CGAL::parameters::default_values(), ps...)); });
    CHECK_DETAIL(text.find("windows propagated") != std::string::npos, text);
    CHECK(visitor_.calls > 1 && visitor_.last == 1);
    const std::vector<double> found = distances(); // needs kept windows
    for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == expected_[i] || std::abs(found[i] - expected_[i]) < 1e-14);
  }

  std::vector<double> distances() const
  {
    std::vector<double> result;
    for (auto v : data_.mesh.vertices()) result.push_back(geodesic_.distance_to_sources(v));
    for (auto f : data_.mesh.faces())
      result.push_back(geodesic_.distance_to_sources(Geodesic::Face_location(f, {{0.2, 0.3, 0.5}})));
    return result;
  }

  const Generated_mesh<Mesh> data_;
  Geodesic geodesic_;
  Visitor visitor_;
  std::vector<double> expected_;
  int number_ = 0;
};

// Parameters of a mesh, of a build and of a selection together, in the free functions.
void of_several_kinds()
{
  Report::instance().set_context("of several kinds");
  Mesh mesh = Generated_mesh<Mesh>(rotated(torus(16, 10), 1)).mesh;
  const auto moved = mesh.add_property_map<Vertex_index, Point_3>("v:moved").first;
  for (Vertex_index v : mesh.vertices())
    moved[v] = Point_3(2 * mesh.point(v).x(), 2 * mesh.point(v).y(), 2 * mesh.point(v).z());
  const auto distance = mesh.add_property_map<Vertex_index, double>("v:distance").first;
  const auto twice = mesh.add_property_map<Vertex_index, double>("v:twice").first;
  Visitor visitor;
  CGAL::geodesic_distances(mesh, Vertex_index(3), distance, CGAL::parameters::distance_limit(1));
  CGAL::geodesic_distances(mesh, Vertex_index(3), twice,
                           CGAL::parameters::visitor(std::ref(visitor)).distance_limit(2).vertex_point_map(moved));
  CHECK(visitor.calls > 1);
  for (Vertex_index v : mesh.vertices()) CHECK(twice[v] == 2 * distance[v] || std::abs(twice[v] - 2 * distance[v]) < 1e-14);

  // targets: copied, by reference, an array; an empty range has no effect
  Geodesic geodesic(mesh);
  geodesic.add_source_point(Vertex_index(3));
  geodesic.build();
  const double all = geodesic.covered_distance();
  const std::vector<Vertex_index> near{Vertex_index(4), Vertex_index(5)};
  const Vertex_index array[] = {Vertex_index(4), Vertex_index(5)};
  const double covered = geodesic.build(CGAL::parameters::targets(near)).covered_distance();
  CHECK(all == infinity && covered < 3);
  CHECK(geodesic.build(CGAL::parameters::verbose(false).targets(std::cref(near))).covered_distance() == covered);
  CHECK(geodesic.build(CGAL::parameters::targets(array)).covered_distance() == covered);
  CHECK(geodesic.build(CGAL::parameters::targets(std::vector<Vertex_index>())).covered_distance() == infinity);
  CHECK(logged([&] { geodesic.build(CGAL::parameters::verbose(false)); }).empty());
}

// Closed polylines with a start value, in both orders; polylines that are closed themselves.
void polylines()
{
  Report::instance().set_context("polylines");
  const Mesh mesh = Generated_mesh<Mesh>(rotated(torus(16, 10), 1)).mesh;
  const Geodesic::Mesh located(mesh);
  std::vector<Point_3> points;
  for (const unsigned i : {3u, 17u, 31u}) points.push_back(mesh.point(Vertex_index(i)));
  const auto closed = located.locate_polyline(points, CGAL::parameters::is_closed(true));
  const auto open = located.locate_polyline(points),
             false_open = located.locate_polyline(points, CGAL::parameters::is_closed(false));
  CHECK(closed.is_closed && !open.is_closed && !false_open.is_closed && false_open.locations == open.locations);
  CHECK(located.join_polyline(open.locations, CGAL::parameters::is_closed(true)).locations == closed.locations);

  const auto distances = [&](const auto& add) {
    Geodesic geodesic(located);
    add(geodesic);
    geodesic.build();
    std::vector<double> result;
    for (Vertex_index v : mesh.vertices()) result.push_back(geodesic.distance_to_sources(v));
    return result;
  };
  namespace parameters = CGAL::parameters;
  const auto expected =
    distances([&](Geodesic& g) { g.add_source_polyline(closed.locations, parameters::start_value(1.).is_closed(true)); });
  const auto line = distances([&](Geodesic& g) { g.add_source_polyline(open.locations, parameters::start_value(1.)); });
  CHECK(*std::min_element(expected.begin(), expected.end()) == 1 && line != expected);
  CHECK(distances([&](Geodesic& g) { g.add_source_polyline(closed.locations, parameters::is_closed(true).start_value(1.)); }) ==
        expected);
  CHECK(distances([&](Geodesic& g) { g.add_source_polyline(closed, parameters::start_value(1.)); }) == expected);
  CHECK(distances([&](Geodesic& g) { g.add_source_polyline(open, parameters::start_value(1.)); }) == line);
  const auto of_set = [&](const auto& polyline, const auto& np) {
    Geodesic::Source_set set;
    set.add_polyline(polyline, np);
    return distances([&](Geodesic& g) { g.add_sources(set); });
  };
  CHECK(of_set(closed.locations, parameters::is_closed(true).start_value(1.)) == expected);
  CHECK(of_set(closed, parameters::start_value(1.)) == expected && of_set(open, parameters::start_value(1.)) == line);

  // of an enclosure
  CGAL::Surface_mesh_geodesic_enclosure<Geodesic::Traits> both(located), self(located);
  both.add_source_polyline(closed.locations, parameters::start_value(1.).is_closed(true));
  self.add_source_polyline(closed, parameters::start_value(1.));
  both.build();
  self.build();
  for (Vertex_index v : mesh.vertices()) CHECK(both.distance_bounds(v) == self.distance_bounds(v));
}

} // namespace test_named_parameters

GEODESIC_OFFSET_TEST(test_named_parameters)
{
  Orders().run();
  of_several_kinds();
  polylines();
  return Report::instance().finish("test_named_parameters");
}
