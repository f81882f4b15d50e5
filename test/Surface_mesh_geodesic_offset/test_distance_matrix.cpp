// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Many fields of a mesh, each in the memory of the one before: rows of matrices and pairs against single fields on a mesh that is set
// up anew, farthest points against searches in all single fields.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "test_check.h"

#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_farthest_points.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_distance_matrix {

using namespace test;

typedef test::Surface_mesh Mesh;
typedef Mesh::Vertex_index Vertex_index;
typedef Mesh::Face_index Face_index;
typedef std::vector<std::vector<double>> Matrix;

// The distances of targets in a build of their own, on a mesh of its own.
template <class Target>
std::vector<double> single_row(const Mesh& mesh, const Source& source, const std::vector<Target>& targets,
                               double limit = infinity)
{
  Geodesic geodesic(mesh);
  geodesic.add_sources(source_set({source}));
  geodesic.build(CGAL::parameters::keep_windows(true).distance_limit(limit));
  std::vector<double> row;
  for (const Target& t : targets) row.push_back(geodesic.distance_to_sources(t));
  return row;
}

// The rows of a matrix, which come in the order of the sources; checks the lists of reached targets.
template <class AnyMesh, class Sources, class Targets, class NamedParameters = CGAL::parameters::Default_named_parameters>
Matrix rows(const AnyMesh& mesh, const Sources& sources, const Targets& targets,
            const NamedParameters& np = CGAL::parameters::default_values())
{
  Matrix result;
  const std::size_t n = CGAL::geodesic_distance_matrix(
    mesh, sources, targets,
    [&](std::size_t i, const std::vector<double>& row, const std::vector<std::size_t>& reached) {
      CHECK(i == result.size() && row.size() == targets.size());
      std::vector<std::size_t> finite;
      for (std::size_t k = 0; k < row.size(); ++k)
        if (row[k] < infinity) finite.push_back(k);
      CHECK(reached == finite);
      result.push_back(row);
    },
    np);
  CHECK(n == result.size());
  return result;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  CHECK(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) largest = (std::max)(largest, std::abs(a[i] - b[i]));
  return largest;
}

std::vector<Vertex_index> some_vertices(const Mesh& mesh, std::size_t n, unsigned seed)
{
  Random random(seed);
  std::vector<Vertex_index> result;
  for (std::size_t i = 0; i < n; ++i)
    result.push_back(Vertex_index(Mesh::size_type(uniform_index(random, mesh.number_of_vertices()))));
  return result;
}

Geodesic::Face_location some_location(const Mesh& mesh, Random& random)
{
  const double x = uniform(random, 0.1, 0.6);
  return {Face_index(Mesh::size_type(uniform_index(random, mesh.number_of_faces()))), {{x, 0.3, 0.7 - x}}};
}

// A closed surface with saddles, large enough for fronts that list what they reach and fronts that do not.
const Mesh& noisy_torus()
{
  static const Generated_mesh<Mesh> result(with_noise(rotated(torus(70, 40), 3), 0.01, 4, 0.01));
  return result.mesh;
}

// Two parts: a sheet, and a small torus.
const Mesh& two_parts()
{
  static const Mesh result = [] {
    Soup soup = jittered_grid(9, 7, 5);
    const std::size_t n = soup.points.size();
    const Soup other = torus(8, 6);
    for (const Point_3& p : other.points) soup.points.push_back(p + Vector_3(0, 0, 10));
    for (const auto& t : other.triangles) soup.add_triangle({t[0] + n, t[1] + n, t[2] + n});
    return Generated_mesh<Mesh>(soup).mesh;
  }();
  return result;
}

void entries()
{
  const Mesh& mesh = noisy_torus();
  const Geodesic::Mesh set_up(mesh);
  const std::vector<Vertex_index> points = some_vertices(mesh, 12, 1), all(mesh.vertices().begin(), mesh.vertices().end());
  const Matrix to_all = rows(set_up, points, all), square = rows(set_up, points, points), anew = rows(mesh, points, points);
  const Matrix half = rows(set_up, points, points, CGAL::parameters::upper_half(true));
  CHECK(to_all.size() == points.size() && square.size() == points.size() && half.size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    CHECK(largest_difference(to_all[i], single_row(mesh, point_source(points[i]), all)) <= 1e-13);
    CHECK(largest_difference(square[i], single_row(mesh, point_source(points[i]), points)) <= 1e-13);
    CHECK(square[i] == anew[i]);
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      CHECK(std::abs(square[i][k] - square[k][i]) <= 1e-12 && (square[i][k] > 0) == (points[i] != points[k]));
      CHECK(k < i ? half[i][k] == infinity : half[i][k] == square[i][k]);
    }
  }
}

// Sources of every kind, and targets inside faces and in space.
void kinds()
{
  const Mesh& mesh = noisy_torus();
  const Geodesic::Mesh set_up(mesh);
  Random random(7);
  std::vector<Geodesic::Face_location> locations;
  std::vector<Point_3> points;
  for (int i = 0; i < 20; ++i)
  {
    locations.push_back(some_location(mesh, random));
    points.push_back(mesh.point(Vertex_index(Mesh::size_type(31 * i))));
  }
  const Matrix by_locations = rows(set_up, locations, locations), by_points = rows(set_up, points, points);
  for (std::size_t i = 0; i < locations.size(); ++i)
  {
    CHECK(largest_difference(by_locations[i], single_row(mesh, point_source(locations[i]), locations)) <= 1e-13);
    CHECK(by_points[i][i] == 0 && by_locations[i][i] == 0);
    for (std::size_t k = 0; k < i; ++k) CHECK(std::abs(by_locations[i][k] - by_locations[k][i]) <= 1e-12);
  }
  const std::vector<Source> polylines{polyline_source(set_up.locate_polyline(points).locations), point_source(locations[3])};
  const std::vector<Geodesic::Source_set> sets{source_set({polylines[0]}), source_set({polylines[1]})};
  const Matrix by_sets = rows(set_up, sets, locations);
  for (std::size_t i = 0; i < sets.size(); ++i)
    CHECK(largest_difference(by_sets[i], single_row(mesh, polylines[i], locations)) <= 1e-13);
  // pairs: of two points, a vertex is the target
  for (std::size_t i = 0; i < locations.size(); ++i)
  {
    const Vertex_index v(Mesh::size_type(97 * i));
    const double d = single_row(mesh, point_source(v), locations)[i];
    CHECK(std::abs(CGAL::geodesic_distance(set_up, v, locations[i]) - d) <= 1e-12);
    CHECK(CGAL::geodesic_distance(set_up, locations[i], v) == CGAL::geodesic_distance(set_up, v, locations[i]));
    CHECK(std::abs(CGAL::geodesic_distance(set_up, locations[i], locations[0]) - by_locations[i][0]) <= 1e-12);
    CHECK(CGAL::geodesic_distance(set_up, locations[i], locations[i]) == 0);
  }
  CHECK(CGAL::geodesic_distance(mesh, points[0], Vertex_index(0)) == 0);
}

void limits()
{
  const Mesh& mesh = noisy_torus();
  const Geodesic::Mesh set_up(mesh);
  const std::vector<Vertex_index> points = some_vertices(mesh, 12, 2), all(mesh.vertices().begin(), mesh.vertices().end());
  Random random(8);
  std::vector<Geodesic::Face_location> locations;
  for (int i = 0; i < 200; ++i) locations.push_back(some_location(mesh, random));
  std::size_t number_reached = 0, number_listed = 0, number_of_rows = 0;
  for (const double limit : {0., 0.05, 0.2, 0.6, 1.5, 0.1, 9., 0.1}) // after small and after large fronts
  {
    const auto parameters = CGAL::parameters::distance_limit(limit);
    const Matrix to_vertices = rows(set_up, points, all, parameters),
                 to_locations = rows(set_up, points, locations, parameters);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const std::vector<double> expected = single_row(mesh, point_source(points[i]), all);
      std::size_t reached = 0;
      for (std::size_t k = 0; k < all.size(); ++k)
      {
        const bool is_reached = expected[k] <= limit;
        CHECK(to_vertices[i][k] == (is_reached ? expected[k] : infinity));
        reached += is_reached;
      }
      number_reached += reached;
      number_listed += reached < CGAL::Geodesic_offset::internal::Front_marks::most_listed(mesh.number_of_faces());
      ++number_of_rows;
      CHECK(largest_difference(to_locations[i], single_row(mesh, point_source(points[i]), locations, limit)) <= 1e-13);
    }
    CHECK(CGAL::geodesic_distance(set_up, points[0], points[1], parameters) == to_vertices[0][points[1]]);
  }
  CHECK(number_reached > 5 * mesh.number_of_vertices());
  CHECK(number_listed > number_of_rows / 4 && number_listed < number_of_rows); // both ways to clear a field
}

void parts_and_input()
{
  const Mesh& mesh = two_parts();
  const Geodesic::Mesh set_up(mesh);
  const std::vector<Vertex_index> all(mesh.vertices().begin(), mesh.vertices().end());
  const std::vector<Vertex_index> points{all.front(), all.back()};
  const Matrix matrix = rows(set_up, points, all);
  for (std::size_t i = 0; i < points.size(); ++i)
    CHECK(largest_difference(matrix[i], single_row(mesh, point_source(points[i]), all)) <= 1e-13);
  CHECK(matrix[0].back() == infinity && matrix[1].front() == infinity);
  CHECK(CGAL::geodesic_distance(set_up, points[0], points[1]) == infinity);
  CHECK(rows(set_up, std::vector<Vertex_index>(), all).empty());
  CHECK(rows(set_up, points, std::vector<Vertex_index>()) == Matrix(2));

  const std::vector<Vertex_index> foreign{all[0], Vertex_index(Mesh::size_type(all.size()))};
  const std::vector<Vertex_index> null{Mesh::null_vertex()};
  const auto fails = [&](const auto& sources, const auto& targets, const auto& np) {
    CHECK_THROWS(rows(set_up, sources, targets, np), std::invalid_argument);
  };
  const auto none = CGAL::parameters::default_values();
  fails(foreign, points, none); // before the first row
  fails(points, foreign, none);
  fails(null, points, none);
  fails(points, null, none);
  fails(points, points, CGAL::parameters::distance_limit(-1.));
  fails(points, points, CGAL::parameters::distance_limit(std::nan("")));
  fails(points, all, CGAL::parameters::upper_half(true));
  CHECK_THROWS(CGAL::geodesic_distance(set_up, points[0], null[0]), std::invalid_argument);
  CHECK_THROWS(CGAL::geodesic_distance(set_up, foreign[1], points[0]), std::invalid_argument);
  CHECK_THROWS(CGAL::geodesic_distance(set_up, points[0], points[1], CGAL::parameters::distance_limit(-1.)),
               std::invalid_argument);
  CHECK(rows(set_up, points, all) == matrix);
}

// Exceptions and cancellation in the middle of a front: later rows are those of a new mesh.
template <class Concurrency_tag>
void stopped()
{
  const Mesh& mesh = noisy_torus();
  const Geodesic::Mesh set_up(mesh);
  const std::vector<Vertex_index> points = some_vertices(mesh, 6, 3), all(mesh.vertices().begin(), mesh.vertices().end());
  const Matrix expected = rows(mesh, points, all);
  const auto tag = CGAL::parameters::concurrency_tag(Concurrency_tag());
  const auto nothing = [](std::size_t, const std::vector<double>&) {};
  for (int turn = 1; turn < 60; turn += 7)
  {
    int calls = 0;
    const std::function<bool(double)> throwing = [&](double) -> bool {
      if (++calls == turn) throw std::domain_error("visitor");
      return true;
    };
    CHECK_THROWS(CGAL::geodesic_distance_matrix(set_up, points, all, nothing, tag.visitor(throwing)), std::domain_error);
    CHECK(largest_difference(rows(set_up, points, all)[0], expected[0]) == 0);
    calls = 0;
    double last = 0;
    const std::function<bool(double)> cancelling = [&](double done) {
      CHECK(done >= last && done < 1);
      last = done;
      return ++calls != turn;
    };
    std::size_t received = 0;
    const auto count = [&](std::size_t i, const std::vector<double>& row) {
      CHECK(row == expected[i]);
      ++received;
    };
    const std::size_t n = CGAL::geodesic_distance_matrix(set_up, points, all, count, tag.visitor(cancelling));
    CHECK(n == received && n < points.size());
    // a front within a limit after the one that was stopped
    CHECK(CGAL::geodesic_distance(set_up, points[1], points[2]) == expected[1][points[2]]);
  }
  const auto failing = [](std::size_t i, const std::vector<double>&) {
    if (i == 2) throw std::domain_error("output");
  };
  CHECK_THROWS(CGAL::geodesic_distance_matrix(set_up, points, all, failing, tag), std::domain_error);
  CHECK(rows(set_up, points, all, tag) == expected);
  double done = 0;
  const std::function<bool(double)> watching = [&](double d) { return done = d, true; };
  rows(set_up, points, all, tag.visitor(watching));
  CHECK(done == 1);
}

// Several threads: the same bits, in order and as they come.
template <class Concurrency_tag>
void threads()
{
  const Mesh& mesh = noisy_torus();
  const Geodesic::Mesh set_up(mesh);
  const std::vector<Vertex_index> points = some_vertices(mesh, 40, 6), all(mesh.vertices().begin(), mesh.vertices().end());
  const auto tag = CGAL::parameters::concurrency_tag(Concurrency_tag());
  const Matrix expected = rows(set_up, points, all);
  CHECK(rows(set_up, points, all, tag) == expected);
  Matrix received(points.size());
  const std::size_t n = CGAL::geodesic_distance_matrix(
    set_up, points, all, [&](std::size_t i, const std::vector<double>& row) { received[i] = row; }, tag.rows_in_order(false));
  CHECK(n == points.size() && received == expected);
}

// Each sample is a farthest vertex by the fields of all samples before it; labels and radius are those of these fields.
void check_samples(const Mesh& mesh, const std::vector<Vertex_index>& start, std::size_t n, double radius)
{
  const std::vector<Vertex_index> all(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<Vertex_index> samples;
  std::vector<double> distances(all.size());
  std::vector<std::size_t> labels(all.size());
  const auto maps = CGAL::parameters::covering_radius(radius)
                      .vertex_distance_map(CGAL::make_property_map(distances))
                      .vertex_source_map(CGAL::make_property_map(labels));
  const double reached =
    start.empty() ? CGAL::geodesic_farthest_points(mesh, n, std::back_inserter(samples), maps)
                  : CGAL::geodesic_farthest_points(mesh, n, std::back_inserter(samples), maps.start_set(std::cref(start)));
  std::vector<double> nearest(all.size(), infinity);
  for (const Vertex_index v : all)
    if (mesh.is_isolated(v)) nearest[v] = -1;
  Matrix fields;
  const auto largest = [&] { return *std::max_element(nearest.begin(), nearest.end()); };
  const auto add = [&](Vertex_index v) {
    fields.push_back(single_row(mesh, point_source(v), all));
    for (const Vertex_index u : all) nearest[u] = (std::min)(nearest[u], fields.back()[u]);
  };
  for (const Vertex_index v : start) add(v);
  for (const Vertex_index v : samples)
  {
    CHECK(largest() > radius && nearest[v] >= largest() - 1e-12);
    add(v);
  }
  CHECK(reached == largest() || std::abs(reached - largest()) <= 1e-12);
  CHECK(samples.size() == n || reached <= radius);
  for (const Vertex_index v : all)
  {
    if (nearest[v] < 0 || nearest[v] == infinity)
    {
      CHECK(distances[v] == infinity && labels[v] == Geodesic::no_source());
      continue;
    }
    CHECK(std::abs(distances[v] - nearest[v]) <= 1e-12);
    CHECK(labels[v] < fields.size() && std::abs(fields[labels[v]][v] - nearest[v]) <= 1e-12);
  }
}

void farthest_points()
{
  check_samples(noisy_torus(), {}, 60, 0);
  check_samples(noisy_torus(), some_vertices(noisy_torus(), 3, 9), 20, 0);
  check_samples(noisy_torus(), {}, 1000, 0.5);
  check_samples(two_parts(), {}, 30, 0);
  check_samples(two_parts(), {Vertex_index(3)}, 1, 0);
  check_samples(two_parts(), {Vertex_index(3)}, 0, 0);
  Mesh small(Generated_mesh<Mesh>(with_noise(planar_grid(5, 4), 0.2, 3)).mesh);
  small.add_vertex(Point_3(0, 0, 0));
  check_samples(small, {}, 1000, 0); // all vertices but the isolated one
  std::vector<Vertex_index> samples;
  CHECK(CGAL::geodesic_farthest_points(small, 1000, std::back_inserter(samples)) == 0);
  CHECK(samples.size() + 1 == small.number_of_vertices());
}

void farthest_points_input()
{
  const Mesh& mesh = noisy_torus();
  const Geodesic::Mesh set_up(mesh);
  std::vector<Vertex_index> samples, again;
  int calls = 0;
  const std::function<bool(double)> cancelling = [&](double done) {
    CHECK(done == calls / 20.);
    return ++calls < 8;
  };
  const double radius =
    CGAL::geodesic_farthest_points(set_up, 20, std::back_inserter(samples), CGAL::parameters::visitor(cancelling));
  CHECK(samples.size() == 7);
  CHECK(CGAL::geodesic_farthest_points(set_up, 7, std::back_inserter(again)) == radius && again == samples);
  // the memory of a field that has grown serves for rows
  CHECK(rows(set_up, samples, samples) == rows(mesh, samples, samples));
  const auto sample = [&](const auto& np) { CGAL::geodesic_farthest_points(set_up, 3, std::back_inserter(again), np); };
  CHECK_THROWS(sample(CGAL::parameters::covering_radius(-1.)), std::invalid_argument);
  CHECK_THROWS(sample(CGAL::parameters::covering_radius(std::nan(""))), std::invalid_argument);
  CHECK_THROWS(sample(CGAL::parameters::start_set(Mesh::null_vertex())), std::invalid_argument);
  // a start set with edges, whose ids the samples continue
  std::vector<std::size_t> labels(mesh.number_of_vertices());
  Geodesic::Source_set set;
  set.add_edges(std::vector<Mesh::Edge_index>{Mesh::Edge_index(5), Mesh::Edge_index(6)});
  set.add_vertex(Vertex_index(100));
  set.remove(0);
  sample(CGAL::parameters::start_set(set).vertex_source_map(CGAL::make_property_map(labels)));
  CHECK(*std::max_element(labels.begin(), labels.end()) == 4 && *std::min_element(labels.begin(), labels.end()) == 1);
  CHECK(CGAL::geodesic_farthest_points(Mesh(), 3, std::back_inserter(again)) == 0);
}

// A local build in the memory of another one marks what it reaches, whatever the other one has reached. Binding: most_listed().
void local_cost()
{
  namespace internal = CGAL::Geodesic_offset::internal;
  const Mesh& mesh = noisy_torus();
  const Geodesic::Mesh set_up(mesh);
  const auto& data = internal::Mesh_access::data(set_up);
  typedef internal::Source_set<double> Sources;
  internal::Build_series<internal::Surface_of<Geodesic::Mesh>> series(data);
  const std::size_t most = internal::Front_marks::most_listed(mesh.number_of_faces());
  CHECK(most == 64 + mesh.number_of_faces() / 64);
  for (const double limit : {0.02, 3., 0.02, 0.2, 0.02})
  {
    Sources sources;
    sources.insert(0, {Sources::POINT, {internal::Surface_point<double>::at_vertex(55)}, {}, 0., {}});
    internal::Build_request<double> request;
    request.maximum = limit;
    const auto& field = (series.build(sources, request), series.last().field);
    const auto reached =
      std::size_t(std::count_if(field.distance.begin(), field.distance.end(), [](double d) { return d < infinity; }));
    CHECK(field.marks.are_listed == (limit != 3));
    CHECK(!field.marks.are_listed || (field.marks.vertices.size() < most && field.marks.vertices.size() >= reached));
    CHECK(reached >= 1);
    CHECK(limit != 3 || reached == mesh.number_of_vertices());
  }
}

} // namespace test_distance_matrix

GEODESIC_OFFSET_TEST(test_distance_matrix)
{
  const std::vector<std::pair<std::string, void (*)()>> tests{
    {"entries", &entries},
    {"kinds of sources and targets", &kinds},
    {"distance limits", &limits},
    {"parts and bad input", &parts_and_input},
    {"stopped", &stopped<CGAL::Sequential_tag>},
#ifdef CGAL_LINKED_WITH_TBB
    {"stopped, several threads", &stopped<CGAL::Parallel_tag>},
    {"several threads", &threads<CGAL::Parallel_tag>},
#endif
    {"as they come", &threads<CGAL::Sequential_tag>},
    {"farthest points", &farthest_points},
    {"farthest points, input", &farthest_points_input},
    {"cost of local builds", &local_cost}};
  return run_tests("test_distance_matrix", tests);
}
