// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances in multiprecision numbers and in floats agree with those in doubles.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "path_tools.h"
#include "test_check.h"

#include <CGAL/Gmpfr.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace test_long_numbers {

using namespace test;

typedef CGAL::Simple_cartesian<CGAL::Gmpfr> Long_kernel;
typedef Generated_mesh<test::Surface_mesh> Data;

// With 200 bits, results agree with double to rounding, and the straight line is correct to 55 digits.
void long_numbers()
{
  CGAL::Gmpfr::set_default_precision(200);
  std::size_t count = 0;
  for (unsigned seed = 1; seed <= 6; ++seed)
    for (const Soup& soup : {rotated(random_rectangle(2, 1, 12, 4, seed), seed), rotated(icosphere(1), seed),
                             rotated(torus(5 + seed % 3, 4), seed), rotated(marching_sphere(4), seed)})
    {
      const Data data(soup);
      const Vertex_index source = data.vertices[seed % data.vertices.size()];
      const std::vector<double> expected = distances_from<Kernel>(data.mesh, source);
      const std::vector<CGAL::Gmpfr> distances = distances_from<Long_kernel>(data.mesh, source);
      Worst_error worst(1e-13, bounding_box_diagonal(data.mesh));
      for (std::size_t i = 0; i < expected.size(); ++i, ++count) CHECK_CLOSE(worst, CGAL::to_double(distances[i]), expected[i]);
    }
  std::cout << "200 bits: " << count << " distances" << std::endl;

  const Data flat(random_rectangle(2, 1, 20, 4, 3));
  const std::vector<CGAL::Gmpfr> distances = distances_from<Long_kernel>(flat.mesh, flat.vertices[0]);
  for (std::size_t i = 0; i < flat.vertices.size(); ++i)
  {
    const auto &p = flat.mesh.point(flat.vertices[0]), &q = flat.mesh.point(flat.vertices[i]);
    const CGAL::Gmpfr x = CGAL::Gmpfr(q.x()) - CGAL::Gmpfr(p.x()), y = CGAL::Gmpfr(q.y()) - CGAL::Gmpfr(p.y());
    const CGAL::Gmpfr straight = CGAL::sqrt(CGAL::Gmpfr(x * x + y * y));
    CHECK(CGAL::abs(CGAL::Gmpfr(distances[i] - straight)) <= CGAL::Gmpfr(1e-55));
  }

  // the largest distance, and points of the surface
  typedef Geodesic_with<Long_kernel, test::Surface_mesh> Long_geodesic;
  const Data torus_data(rotated(torus(7, 5), 1));
  Geodesic short_numbers(torus_data.mesh);
  Long_geodesic long_numbers(torus_data.mesh);
  short_numbers.add_source_points(std::vector<Vertex_index>{torus_data.vertices[0]});
  long_numbers.add_source_points(std::vector<Vertex_index>{torus_data.vertices[0]});
  short_numbers.build(CGAL::parameters::compute_largest_distance(true));
  long_numbers.build(CGAL::parameters::compute_largest_distance(true));
  Worst_error largest(1e-13, 2);
  CHECK_CLOSE(largest, CGAL::to_double(long_numbers.largest_distance().value()), short_numbers.largest_distance().value());
  for (int i = 0; i < 20; ++i)
  {
    const double x = std::cos(double(i)), y = std::sin(double(i)), z = 0.1 * i;
    const auto a = short_numbers.locate_with_distance(Point_3(x, y, z));
    const auto b = long_numbers.locate_with_distance(Long_kernel::Point_3(x, y, z));
    CHECK_CLOSE(largest, CGAL::to_double(b.second), a.second);
  }
  CHECK(long_numbers.add_source_sharp_edges(1) && long_numbers.add_source_boundary().empty());

  // with a tolerance, too
  const Data round(icosphere(2));
  Geodesic exact(round.mesh);
  Geodesic_with<Long_kernel, test::Surface_mesh> bounded(round.mesh);
  exact.add_source_point(round.vertices[0]);
  bounded.add_source_point(round.vertices[0]);
  exact.build();
  bounded.build(CGAL::parameters::relative_tolerance(1e-3));
  CHECK(bounded.statistics().windows_propagated < exact.statistics().windows_propagated);
  for (Vertex_index v : round.vertices)
  {
    const double d = CGAL::to_double(bounded.distance_to_sources(v)), expected = exact.distance_to_sources(v);
    CHECK_DETAIL(d <= expected + 1e-12 && d >= expected - CGAL::to_double(bounded.error_bound(v)) - 1e-12, values(d, expected));
  }
}

// Numbers with fewer digits than double, as wide as an index.
void short_numbers()
{
  typedef CGAL::Simple_cartesian<float> Short_kernel;
  for (const Soup& soup : {rotated(random_rectangle(2, 1, 60, 6, 1), 1), icosphere(2), saddle_fan()})
  {
    const Data data(soup);
    const std::vector<double> expected = distances_from<Kernel>(data.mesh, data.vertices[0]);
    const std::vector<float> distances = distances_from<Short_kernel>(data.mesh, data.vertices[0]);
    Worst_error worst(1e-5, bounding_box_diagonal(data.mesh));
    Geodesic geodesic(data.mesh);
    Geodesic_with<Short_kernel, test::Surface_mesh> short_geodesic(data.mesh);
    geodesic.add_source_point(data.vertices[0]);
    short_geodesic.add_source_point(data.vertices[0]);
    geodesic.build(CGAL::parameters::compute_largest_distance(true));
    short_geodesic.build(CGAL::parameters::compute_largest_distance(true));
    CHECK_CLOSE(worst, static_cast<double>(short_geodesic.largest_distance().value()), geodesic.largest_distance().value());
    for (Vertex_index v : data.vertices) // rounding errors of floats are below an edge length
    {
      const Point_3& p = data.mesh.point(v);
      const auto located = short_geodesic.locate_with_distance(Short_kernel::Point_3(float(p.x()), float(p.y()), float(p.z())));
      CHECK(located.second < 1e-6);
    }
    for (std::size_t i = 0; i < expected.size(); ++i) CHECK_CLOSE(worst, static_cast<double>(distances[i]), expected[i]);
  }
}

} // namespace test_long_numbers

GEODESIC_OFFSET_TEST(test_long_numbers)
{
  const std::pair<const char*, void (*)()> tests[] = {{"long numbers", test_long_numbers::long_numbers},
                                                      {"short numbers", test_long_numbers::short_numbers}};
  return run_tests("test_long_numbers", tests);
}
