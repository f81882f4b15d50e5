// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Polylines through points that are one or more faces apart: shortest paths connect the points, as long as the distances of
// a build on the whole mesh, and the polylines can be sources.

#include "data_meshes.h"
#include "generated_meshes.h"
#include "geodesic_types.h"
#include "locations.h"
#include "test_check.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_geodesic_offset/Radical_numbers.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace test_joined_polylines {

using namespace test;
namespace PMP = CGAL::Polygon_mesh_processing;

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

template <class TriangleMesh>
class Join_checker
{
public:
  typedef test::Locations<TriangleMesh> Locations;
  typedef Geodesic_on<TriangleMesh> Geodesic;
  typedef typename Geodesic::Face_location Face_location;
  typedef typename Geodesic::Polyline Polyline;

  explicit Join_checker(const TriangleMesh& mesh) : geodesic(mesh), m_mesh(mesh), m_locations(mesh)
  {
    for (auto f : faces(mesh)) m_faces.push_back(f);
  }

  // At a vertex, on an edge, or in a face.
  Face_location random_location(Random& random) const
  {
    Face_location l(m_faces[uniform_index(random, m_faces.size())], {0, 0, 0});
    const std::size_t kind = uniform_index(random, 3), k = uniform_index(random, 3);
    if (kind == 0) l.second[k] = 1;
    else
    {
      const double t = uniform(random, 0.05, 0.95), s = kind == 1 ? 0 : uniform(random, 0.05, 0.95);
      l.second = {(1 - s) * t, (1 - s) * (1 - t), s};
      std::rotate(l.second.begin(), l.second.begin() + std::ptrdiff_t(k), l.second.end());
    }
    return l;
  }

  double length(const Polyline& polyline) const
  {
    double sum = 0;
    const auto& l = polyline.locations;
    const std::size_t n = l.size();
    for (std::size_t i = 0; i + 1 < n + (polyline.is_closed ? 1 : 0); ++i)
    {
      CHECK(m_locations.common_face(l[i], l[(i + 1) % n]) != boost::graph_traits<TriangleMesh>::null_face());
      sum += distance(PMP::construct_point(l[i], m_mesh), PMP::construct_point(l[(i + 1) % n], m_mesh));
    }
    return sum;
  }

  // Polylines of n locations.
  void random_polylines(unsigned seed, int n)
  {
    Random random(seed);
    const bool closed = seed % 2 == 1;
    std::vector<Face_location> locations;
    for (int i = 0; i < n; ++i) locations.push_back(random_location(random));
    double expected = 0;
    for (int i = 0; i + (closed ? 0 : 1) < n; ++i)
    {
      geodesic.clear_sources();
      geodesic.add_source_point(locations[std::size_t(i)]);
      geodesic.build(CGAL::parameters::keep_windows(true));
      expected += geodesic.distance_to_sources(locations[std::size_t((i + 1) % n)]);
    }
    geodesic.clear_sources();
    if (std::isinf(expected))
    {
      CHECK_THROWS(geodesic.join_polyline(locations, CGAL::parameters::is_closed(closed)), std::invalid_argument);
      return;
    }
    const Polyline polyline = geodesic.join_polyline(locations, CGAL::parameters::is_closed(closed));
    const double actual = length(polyline);
    CHECK_DETAIL(std::abs(actual - expected) <= 1e-12 * expected, values(actual, expected));
    CHECK(polyline.is_closed == closed || polyline.locations.size() < 3);
    CHECK(polyline.locations.front() == locations.front() && (closed || polyline.locations.back() == locations.back()));
    CHECK(geodesic.add_source_polyline(polyline) < std::size_t(-1));
  }

  Geodesic geodesic;

private:
  const TriangleMesh& m_mesh;
  const Locations m_locations;
  std::vector<typename Locations::face_descriptor> m_faces;
};

template <class TriangleMesh>
void generated()
{
  Soup two = icosphere(2); // components
  const std::size_t n = two.points.size(), m = two.triangles.size();
  for (std::size_t i = 0; i < n; ++i) two.points.push_back(two.points[i] + Vector_3(5, 0, 0));
  for (std::size_t i = 0; i < m; ++i)
    two.add_triangle({{two.triangles[i][0] + n, two.triangles[i][1] + n, two.triangles[i][2] + n}});
  const std::vector<std::pair<std::string, Soup>> soups = {
    {"grid", rotated(jittered_grid(12, 9, 1), 2)},
    {"flat grid", planar_grid(8, 8)},
    {"cube", rotated(cube_grid(5), 3)},
    {"torus", torus(24, 12)},
    {"icosphere", icosphere(3)},
    {"genus 5", marching_genus_5(10)},
    {"saddle", saddle_fan()},
    {"L", l_shape(40, 4, 1)},
    {"two components", two},
    {"needles", random_rectangle(1, 1e-3, 60, 9, 1)}};
  for (const auto& [name, soup] : soups)
  {
    Report::instance().set_context(name);
    const Generated_mesh<TriangleMesh> data(soup);
    Join_checker<TriangleMesh> check(data.mesh);
    for (unsigned seed = 0; seed < 30; ++seed) check.random_polylines(seed, 2 + int(seed % 4));
  }
}

void data_meshes()
{
  for (const auto& file : data_files())
  {
    test::Surface_mesh mesh;
    if (!read_data_mesh(file, 10000, mesh).empty()) continue;
    Report::instance().set_context(file.filename().string());
    try
    {
      Join_checker<test::Surface_mesh> check(mesh);
      for (unsigned seed = 0; seed < 2; ++seed) check.random_polylines(seed, 3);
    }
    catch (const std::invalid_argument& e)
    {
      CHECK_DETAIL(std::string(e.what()).find(" is degenerate ") != std::string::npos, e.what());
      std::cout << file.filename().string() << ": skipped, " << e.what() << std::endl;
    }
  }
}

// Points in space near a flat mesh: connections are straight.
void points_in_space()
{
  const Generated_mesh<test::Surface_mesh> data(planar_grid(20, 20));
  Join_checker<test::Surface_mesh> check(data.mesh);
  const Geodesic& geodesic = check.geodesic;
  const std::vector<Point_3> square = {Point_3(2.5, 3, 0.1), Point_3(17, 3, -0.1), Point_3(17, 12.25, 0),
                                       Point_3(2.5, 12.25, 2)};
  const auto close = [](double x, double y) { return std::abs(x - y) <= 1e-13 * y; };
  CHECK(close(check.length(geodesic.locate_polyline(square)), 14.5 + 9.25 + 14.5));
  CHECK(close(check.length(geodesic.locate_polyline(square, CGAL::parameters::is_closed(true))), 2 * (14.5 + 9.25)));
  std::vector<Point_3> twice;
  for (const Point_3& p : square) twice.insert(twice.end(), 2, p);
  twice.push_back(square.front());
  for (const auto& points : {square, twice}) // the first point may be repeated
  {
    const auto polyline = geodesic.locate_polyline(points, CGAL::parameters::is_closed(true));
    CHECK(polyline.is_closed &&
          polyline.locations.size() == geodesic.locate_polyline(square, CGAL::parameters::is_closed(true)).locations.size());
    Geodesic again(data.mesh);
    again.add_source_polyline(polyline);
    again.build(CGAL::parameters::keep_windows(true));
    CHECK(close(again.distance_to_sources(geodesic.locate(Point_3(10, 8, 0))), 4.25));
    CHECK(close(again.distance_to_sources(geodesic.locate(Point_3(10, 0, 0))), 3));
  }

  const Point_3 p(1, 2, 0);
  for (const bool closed : {false, true})
  {
    for (const std::size_t n : {1, 2, 3}) // one point
    {
      const auto polyline = geodesic.locate_polyline(std::vector<Point_3>(n, p), CGAL::parameters::is_closed(closed));
      CHECK(!polyline.is_closed && polyline.locations.size() == 1);
    }
    CHECK_THROWS(geodesic.locate_polyline(std::vector<Point_3>(), CGAL::parameters::is_closed(closed)), std::invalid_argument);
    CHECK_THROWS(geodesic.locate_polyline(std::vector<Point_3>{p, Point_3(infinity, 0, 0)}, CGAL::parameters::is_closed(closed)),
                 std::invalid_argument);
    const std::vector<Geodesic::Face_location> outside = {{Geodesic::face_descriptor(0), {2, 0, -1}}};
    CHECK_THROWS(geodesic.join_polyline(outside, CGAL::parameters::is_closed(closed)), std::invalid_argument);
  }
}

// With few digits: along edges, the upper bound of the length is the length.
void short_numbers()
{
  typedef CGAL::Simple_cartesian<float> Short_kernel;
  typedef CGAL::Surface_mesh<Short_kernel::Point_3> Mesh;
  typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Short_kernel, Mesh>> Short_geodesic;
  for (const float side : {0.1f, 0.3f, 1.7f})
  {
    Mesh mesh;
    std::vector<Mesh::Vertex_index> v;
    for (int i = 0; i <= 6; ++i)
      for (int j = 0; j < 2; ++j) v.push_back(mesh.add_vertex(Short_kernel::Point_3(side * float(i), side * float(j), 0)));
    for (std::size_t i = 0; i < 12; i += 2)
    {
      mesh.add_face(v[i], v[i + 2], v[i + 3]);
      mesh.add_face(v[i], v[i + 3], v[i + 1]);
    }
    Short_geodesic geodesic(mesh);
    const auto polyline = geodesic.locate_polyline(std::vector<Short_kernel::Point_3>{mesh.point(v[0]), mesh.point(v[12])});
    double length = 0;
    for (std::size_t i = 1; i < polyline.locations.size(); ++i)
      length += std::sqrt(CGAL::squared_distance(PMP::construct_point(polyline.locations[i - 1], mesh),
                                                 PMP::construct_point(polyline.locations[i], mesh)));
    CHECK(polyline.locations.size() >= 7 && std::abs(length - 6 * side) <= 1e-6 * side);
    geodesic.add_source_polyline(polyline.locations);
    geodesic.build();
    for (std::size_t i = 0; i < v.size(); ++i)
      CHECK(std::abs(geodesic.distance_to_sources(v[i]) - (i % 2 == 0 ? 0 : side)) <= 1e-6f * side);
  }
}

// With exact numbers: over the edge of a cube whose sides are two triangles each.
void exact_numbers()
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt Exact_kernel;
  typedef CGAL::Surface_mesh<Exact_kernel::Point_3> Mesh;
  typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Exact_kernel, Mesh>> Exact_geodesic;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (const auto& p : {std::array<int, 3>{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, -1}, {1, 1, -1}})
    v.push_back(mesh.add_vertex(Exact_kernel::Point_3(p[0], p[1], p[2])));
  for (const auto& t : {std::array<int, 3>{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}})
    mesh.add_face(v[std::size_t(t[0])], v[std::size_t(t[1])], v[std::size_t(t[2])]);
  const Exact_geodesic geodesic(mesh);
  const auto polyline = geodesic.locate_polyline(std::vector<Exact_kernel::Point_3>{mesh.point(v[0]), mesh.point(v[5])});
  Exact_kernel::FT sum = 0;
  for (std::size_t i = 1; i < polyline.locations.size(); ++i)
    sum += CGAL::sqrt(CGAL::squared_distance(PMP::construct_point(polyline.locations[i - 1], mesh),
                                             PMP::construct_point(polyline.locations[i], mesh)));
  CHECK(sum == CGAL::sqrt(Exact_kernel::FT(5)));
}

} // namespace test_joined_polylines

GEODESIC_OFFSET_TEST(test_joined_polylines)
{
  const std::vector<std::pair<std::string, std::function<void()>>> tests = {
    {"generated, Surface_mesh", generated<test::Surface_mesh>},
    {"generated, Polyhedron_3", generated<CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>>},
    {data_case, data_meshes},
    {"points in space", points_in_space},
    {"short numbers", short_numbers},
    {"exact numbers", exact_numbers}};
  return run_tests("test_joined_polylines", tests);
}
