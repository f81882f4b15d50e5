// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Faces without area: the function of the library on soups of all types, and the reader of the programs on files to which they are
// added (benchmark/Surface_mesh_geodesic_offset/Robustness/degenerate_search.cpp is the long run). Borders that are open by
// rounding, and parts of the surface.

#include "data_directory.h"
#include "degenerate_search.h"
#include "test_check.h"
#include "test_registry.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_geodesic_offset/remove_degenerate_faces_in_polygon_soup.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_degenerate_faces {

using namespace test;

typedef std::vector<std::array<std::size_t, 3>> Triangles;

double area(const Point_3& p, const Point_3& q, const Point_3& r)
{
  return std::sqrt(CGAL::cross_product(q - p, r - p).squared_length()) / 2;
}

double area(const std::vector<Point_3>& points, const Triangles& triangles)
{
  double sum = 0;
  for (const auto& t : triangles) sum += area(points[t[0]], points[t[1]], points[t[2]]);
  return sum;
}

// A square with a flat triangle on its diagonal, divided by a point, and one on a side.
template <class Point>
std::vector<Point> square_points()
{
  return {Point(0, 0, 0), Point(4, 0, 0), Point(4, 4, 0), Point(0, 4, 0), Point(1, 1, 0), Point(3, 3, 0), Point(2, 0, 0)};
}
const Triangles square_triangles = {{0, 1, 2}, {0, 5, 3}, {5, 2, 3}, {0, 4, 5}, {0, 2, 4}, {4, 2, 5}, {1, 0, 6}};

// The same changes for points of any kernel and polygons of any type.
template <class Point, class Polygon>
void one_type(const std::string& name)
{
  Report::instance().set_context(name);
  const std::vector<Point> points = square_points<Point>();
  std::vector<Polygon> polygons;
  for (const auto& t : square_triangles)
  {
    Polygon polygon{};
    if constexpr (std::is_same<Polygon, std::array<int, 3>>::value) std::copy(t.begin(), t.end(), polygon.begin());
    else polygon.assign(t.begin(), t.end());
    polygons.push_back(polygon);
  }
  const CGAL::Polygon_soup_repair repair = CGAL::remove_degenerate_faces_in_polygon_soup(points, polygons);
  CHECK(repair.merged_points == 0 && repair.collapsed_faces == 0 && repair.dropped_faces == 0);
  CHECK(repair.flipped_faces == 4 && polygons.size() == 7);
  CHECK(repair.polygon_indices.size() == polygons.size() && repair.point_indices.size() == points.size());
  // each edge of the square inside has two faces: a disc of 7 vertices and 7 faces
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    CHECK(repair.polygon_indices[i] < 3);
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(edges.emplace(std::size_t(polygons[i][k]), std::size_t(polygons[i][(k + 1) % 3])).second);
  }
  std::size_t border = 0;
  for (const auto& e : edges) border += edges.count({e.second, e.first}) == 0 ? 1 : 0;
  CHECK(border == 5);

  const std::vector<Polygon> before = polygons;
  const CGAL::Polygon_soup_repair none = CGAL::remove_degenerate_faces_in_polygon_soup(points, polygons);
  CHECK(none.point_indices.empty() && none.polygon_indices.empty() && none.flipped_faces == 0 && polygons == before);
}

void types()
{
  typedef CGAL::Simple_cartesian<float> Short_kernel;
  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact_kernel;
  one_type<Point_3, std::vector<std::size_t>>("vectors");
  one_type<Point_3, std::array<int, 3>>("arrays");
  one_type<Short_kernel::Point_3, std::vector<unsigned>>("float");
  one_type<Exact_kernel::Point_3, std::vector<std::size_t>>("exact points");
  one_type<CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::Point_3, std::vector<std::size_t>>("exact traits");
  Report::instance().set_context("");
}

// A map from other values to points, and the traits that decide.
void named_parameters()
{
  const std::vector<Point_3> points = square_points<Point_3>();
  std::vector<std::size_t> values(points.size());
  std::iota(values.begin(), values.end(), std::size_t(0));
  const auto map = CGAL::make_property_map(points);
  Triangles triangles = square_triangles;
  CGAL::remove_degenerate_faces_in_polygon_soup(values, triangles, CGAL::parameters::point_map(map));
  CHECK(triangles.size() == 7);

  // a height of 1e-9 is an area in double, none in float
  const std::vector<Point_3> flat = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, 1e-9, 0), Point_3(0, -1, 0)};
  Triangles exact = {{0, 1, 2}, {1, 0, 3}}, rounded = exact;
  typedef CGAL::Surface_mesh_geodesic_offset_traits<CGAL::Simple_cartesian<float>, Surface_mesh> Short_traits;
  CHECK(CGAL::remove_degenerate_faces_in_polygon_soup(flat, exact).flipped_faces == 0);
  CHECK(CGAL::remove_degenerate_faces_in_polygon_soup(flat, rounded, CGAL::parameters::geom_traits(Short_traits()))
          .flipped_faces == 1);
}

// Which heights are rounding: 64 units of the shortest side, 16 of the largest coordinate. Sides, needles, spikes, and underflow.
void limits()
{
  constexpr double unit = std::numeric_limits<double>::epsilon();
  const auto is_removed =
    [](std::vector<Point_3> points, std::vector<std::vector<std::size_t>> polygons = {{0, 1, 2}, {1, 0, 3}}) {
      const CGAL::Polygon_soup_repair r = CGAL::remove_degenerate_faces_in_polygon_soup(points, polygons);
      const std::size_t changes = r.merged_points + r.shortened_faces + r.flipped_faces + r.dropped_faces + r.collapsed_faces;
      CHECK(r.point_indices.empty() == (changes == 0));
      CHECK(r.polygon_indices.size() == (r.point_indices.empty() ? 0 : polygons.size()));
      return !r.point_indices.empty();
    };
  const auto cap = [](double height, double shift) {
    return std::vector<Point_3>{Point_3(0, shift, 0), Point_3(1, shift, 0), Point_3(0.25, shift + height, 0),
                                Point_3(0, -1, 0)};
  };
  CHECK(is_removed(cap(0, 0)) && is_removed(cap(15 * unit, 0)) && !is_removed(cap(18 * unit, 0)));
  // by coordinates that are larger than the triangle
  CHECK(is_removed(cap(1000 * unit, 100)) && !is_removed(cap(2000 * unit, 100)));
  // a side shorter than the rounding of its coordinates, and one that is longer
  const auto needle = [](double width, double shift) {
    return std::vector<Point_3>{Point_3(0, shift, 0), Point_3(1, shift, 0), Point_3(0, shift + width, 0), Point_3(0.5, -1, 0)};
  };
  CHECK(is_removed(needle(8 * unit, 1)) && !is_removed(needle(64 * unit, 1)));
  // at a coordinate that is zero there is no rounding, but underflow
  CHECK(!is_removed(needle(1e-100, 0)) && is_removed(needle(1e-170, 0)));

  const std::vector<Point_3> points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0),
                                       Point_3(0, 1, 0), Point_3(3, 0, 0), Point_3(0.5, 0, 0)};
  CHECK(!is_removed(points, {{0, 1, 2, 3}}));
  CHECK(!is_removed(points, {{0, 5, 1, 2, 3}}));  // a straight corner
  CHECK(is_removed(points, {{0, 4, 1, 2, 3}}));   // a spike
  CHECK(is_removed(points, {{0, 4, 5, 1}}));      // a flat polygon
  CHECK(is_removed(points, {{0, 1, 2, 0, 3}}));   // a corner twice
  CHECK(is_removed(points, {{0, 1}, {0, 1, 2}})); // too few corners
  CHECK(!is_removed(points, {{0, 1, 2}, {0, 2, 3}}));

  // a spike is cut off, and its tip, at a border, is on no face any more
  std::vector<std::vector<std::size_t>> polygons = {{0, 4, 1, 2, 3}};
  CHECK(CGAL::remove_degenerate_faces_in_polygon_soup(points, polygons).dropped_faces == 1);
  CHECK(polygons.size() == 1 && polygons[0].size() == 4);

  // points without polygons may be anywhere
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Point_3> with_nan = square_points<Point_3>();
  with_nan.push_back(Point_3(nan, nan, nan));
  Triangles triangles = square_triangles;
  CHECK(CGAL::remove_degenerate_faces_in_polygon_soup(with_nan, triangles).flipped_faces == 4);
}

// Any triples of a few points, most of them on a line: no degenerate triangle remains, and the area is the same.
void random_triples()
{
  Random random(7);
  for (int i = 0; i < 3000; ++i)
  {
    std::vector<Point_3> points;
    const std::size_t n = 4 + uniform_index(random, 12), rows = 1 + uniform_index(random, 3);
    for (std::size_t v = 0; v < n; ++v)
      points.push_back(Point_3(double(uniform_index(random, 12)),
                               uniform(random) < 0.7 ? 0 : double(uniform_index(random, rows)), 0));
    Triangles triangles;
    for (std::size_t f = 1 + uniform_index(random, 40); f-- > 0;)
      triangles.push_back({uniform_index(random, n), uniform_index(random, n), uniform_index(random, n)});
    const double before = area(points, triangles);
    const CGAL::Polygon_soup_repair repair = CGAL::remove_degenerate_faces_in_polygon_soup(points, triangles);
    CHECK(std::abs(area(points, triangles) - before) < 1e-9);
    for (const auto& t : triangles) CHECK(area(points[t[0]], points[t[1]], points[t[2]]) > 0.1);
    for (std::size_t v = 0; v < repair.point_indices.size(); ++v) CHECK(points[repair.point_indices[v]] == points[v]);
  }
}

geodesic_offset::Mesh_input read(const std::string& name, const std::string& bytes,
                                 const geodesic_offset::Border_joining& joining = geodesic_offset::Border_joining{})
{
  return geodesic_offset::Mesh_input(name, geodesic_offset::parse_soup(geodesic_offset::mesh_format(name), name, bytes),
                                     joining);
}

// A sphere of longitudes and latitudes, as exporters write it: a vertex for each corner of the grid, with m + 1 vertices at each pole
// and on the first meridian twice, in triangles or in quads.
std::string sphere_of_latitudes(std::size_t n, std::size_t m, bool has_quads)
{
  std::ostringstream out;
  out.precision(6);
  out << std::fixed;
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= m; ++j)
    {
      const double a = CGAL_PI * double(i) / double(n), b = 2 * CGAL_PI * double(j % m) / double(m);
      out << "v " << std::sin(a) * std::cos(b) << ' ' << std::sin(a) * std::sin(b) << ' ' << std::cos(a) << '\n';
    }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j)
    {
      const std::size_t a = i * (m + 1) + j + 1, b = a + m + 1;
      if (has_quads) out << "f " << a << ' ' << b << ' ' << b + 1 << ' ' << a + 1 << '\n';
      else out << "f " << a << ' ' << b << ' ' << b + 1 << "\nf " << a << ' ' << b + 1 << ' ' << a + 1 << '\n';
    }
  return out.str();
}

void known_files()
{
  for (const bool has_quads : {false, true})
  {
    const geodesic_offset::Mesh_input sphere = read("file.obj", sphere_of_latitudes(6, 9, has_quads));
    CHECK(sphere.mesh().number_of_vertices() == 2 + 5 * 9 && sphere.parts().number() == 1);
    CHECK(sphere.parts().number_of_border_cycles() == 0);
    for (std::size_t i = 0; i < sphere.soup().points.size(); ++i) CHECK(sphere.has_vertex(i));
  }

  const std::string square = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n", faces = "3 0 1 2\n3 1 3 2\n";
  const auto check = [](const geodesic_offset::Mesh_input& input, std::size_t vertices, std::size_t triangles) {
    CHECK(input.mesh().number_of_vertices() == vertices && input.mesh().number_of_faces() == triangles);
    CHECK(input.parts().number() == 1 && input.parts().number_of_border_cycles() == 1);
  };
  // a stray point; a face on the border; facets with their own vertices; a vertex without faces
  check(read("file.off", "OFF\n7 3 0\n" + square + "0 0 0\n0 0 0\n0 0 0\n" + faces + "3 4 5 6\n"), 4, 2);
  check(read("file.off", "OFF\n5 3 0\n" + square + "0.5 0 0\n" + faces + "3 1 0 4\n"), 5, 3);
  check(read("file.off",
             "OFF\n9 3 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n0 1 0\n1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 3 4 5\n3 6 7 8\n"),
        4, 2);
  for (const char* coordinate : {"nan", "-nan", "inf", "1e999", "NaN(0x1)"})
    check(read("file.off", "OFF\n5 2 0\n" + square + coordinate + " 7e200 0\n" + faces), 4, 2);
  check(read("file.obj", "v 0 0 0\nv nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 4\n"), 3, 1);
  check(read("file.ply",
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
             "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 nan\n0 1 0\n3 0 1 3\n"),
        3, 1);
}

// Polygons far from planar, whose projections are simple only up to rounding, in all rotations; and a planar one of many corners.
void polygons()
{
  const std::string points[] = {"v 1 0 0\nv 1 2 0\nv 0 0 0\nv 2 0 0\nv 1 1 1\n",
                                "v 2 1 1\nv 1 0 1\nv 2 1 0\nv 1 1 1\nv 0 2 1\n"};
  const int corners[] = {2, 3, 5, 4, 1};
  for (const std::string& vertices : points)
    for (int first = 0; first < 10; ++first)
    {
      std::ostringstream file;
      file << vertices << 'f';
      for (int k = 0; k < 5; ++k) file << ' ' << corners[(first + (first < 5 ? k : 5 - k)) % 5];
      const geodesic_offset::Mesh_input input = read("file.obj", file.str() + "\n");
      CHECK(input.mesh().number_of_faces() == 3 && CGAL::is_triangle_mesh(input.mesh()));
    }
  for (const int n : {4, 5, 7, 40, 299, 300, 301, 500})
  {
    std::ostringstream file; // a comb: every second corner is nearer to the center
    for (int i = 0; i < n; ++i)
    {
      const double angle = 2 * CGAL_PI * i / n, r = i % 2 == 0 ? 1 : 0.7;
      file << "v " << r * std::cos(angle) << ' ' << r * std::sin(angle) << " 1\n";
    }
    file << 'f';
    for (int i = 1; i <= n; ++i) file << ' ' << i;
    const geodesic_offset::Mesh_input input = read("file.obj", file.str() + "\n");
    CHECK(input.mesh().number_of_faces() == std::size_t(n - 2) && CGAL::is_triangle_mesh(input.mesh()));
    double area = 0, expected = 0;
    for (auto f : input.mesh().faces()) area += CGAL::to_double(CGAL::Polygon_mesh_processing::face_area(f, input.mesh()));
    const auto& p = input.soup().points;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
      const auto& q = p[(i + 1) % p.size()];
      expected += (p[i].x() * q.y() - p[i].y() * q.x()) / 2;
    }
    CHECK_DETAIL(std::abs(area - expected) <= 1e-12, std::to_string(n));
  }
}

// Two rows of triangles whose borders differ by `gap`.
std::string open_seam(double gap, std::size_t n)
{
  std::ostringstream out;
  out.precision(17);
  out << "OFF\n" << 4 * (n + 1) << ' ' << 4 * n << " 0\n";
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t i = 0; i <= n; ++i)
      out << i << ' ' << (row < 2 ? double(row) : double(row) - 1 + gap) << ' ' << (row == 2 ? gap * double(i % 2) : 0) << '\n';
  for (std::size_t row : {0, 2})
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = row * (n + 1) + i, b = a + n + 1;
      out << "3 " << a << ' ' << a + 1 << ' ' << b + 1 << "\n3 " << a << ' ' << b + 1 << ' ' << b << '\n';
    }
  return out.str();
}

void open_borders()
{
  for (const double gap : {0., 1e-15, 1e-9, 1e-5, 1e-3})
  {
    const std::string bytes = open_seam(gap, 10);
    const auto parts = [&](const geodesic_offset::Border_joining& joining) {
      const geodesic_offset::Mesh_input input = read("file.off", bytes, joining);
      CHECK(input.parts().number_of_border_cycles() == input.parts().number());
      CHECK(input.mesh().number_of_faces() == 40);
      if (input.parts().number() == 1)
      {
        CHECK(input.remarks().size() == 1 && input.remarks()[0].find("10 pairs of border edges stitched") == 0);
        CHECK((input.remarks()[0].find("gaps") != std::string::npos) == (gap != 0));
        CHECK(input.mesh().number_of_vertices() == 33);
        for (std::size_t i = 0; i < 44; ++i) CHECK(input.has_vertex(i));
      }
      return input.parts().number();
    };
    CHECK(parts({false, 0}) == 2);
    CHECK(parts({true, 0}) == (gap == 0 ? 1u : 2u));
    CHECK(parts({true, 2 * gap}) == 1);
    if (gap > 1e-14) CHECK(parts({true, gap / 2}) == 2);
    CHECK(parts({true, 0.01}) == 1);
  }
  // points that an edge connects stay apart: a strip narrower than the tolerance keeps its faces
  const geodesic_offset::Mesh_input strip =
    read("file.off", "OFF\n6 4 0\n0 0 0\n1 0 0\n2 0 0\n0 1e-3 0\n1 1e-3 0\n2 1e-3 0\n3 0 1 4\n3 0 4 3\n3 1 2 5\n3 1 5 4\n",
         {true, 0.02});
  CHECK(strip.mesh().number_of_faces() == 4 && strip.remarks().empty());
  // edges shorter than the tolerance have no place of their own
  CHECK(read("file.off", open_seam(0, 3000), {true, 2}).parts().number() == 2);
  try
  {
    read("file.off", open_seam(0, 10), {true, 1});
    CHECK(false);
  }
  catch (const geodesic_offset::Input_error& e)
  {
    CHECK_DETAIL(std::string(e.what()).find("a hundredth of the diagonal") != std::string::npos, e.what());
  }
}

void search()
{
  Degenerate_search search(std::cout, 20);
  const unsigned files = number_of_cases(3000u, 20000u);
  for (unsigned seed = 1; seed <= files; ++seed) search.run(seed);
  CHECK(search.counts().size() == 16 && search.added().size() == 7);
  for (const auto& c : search.counts())
    CHECK_DETAIL(c.second.refused + c.second.wrong + c.second.missing == 0 && c.second.flat_faces > 0,
                 c.first + ": " + std::to_string(c.second.refused) + " refused, " + std::to_string(c.second.wrong) +
                   " wrong, " + std::to_string(c.second.missing) + " with a missing vertex");
}

// The only files that are refused have no faces.
void data_meshes()
{
  std::size_t meshes = 0;
  for (const std::filesystem::path& file : data_files())
  {
    Report::instance().set_context(file.filename().string());
    try
    {
      const geodesic_offset::Mesh_input input(file.string(), geodesic_offset::Border_joining{});
      Geodesic geodesic(input.mesh()); // refuses faces without area
      ++meshes;
    }
    catch (const geodesic_offset::Input_error& e)
    {
      CHECK_DETAIL(std::string(e.what()).find("no faces") != std::string::npos, e.what());
    }
  }
  Report::instance().set_context("");
  std::cout << meshes << " meshes of the data directory" << std::endl;
}

} // namespace test_degenerate_faces

GEODESIC_OFFSET_TEST(test_degenerate_faces)
{
  const std::pair<const char*, void (*)()> tests[] = {
    {"types", types},
    {"named parameters", named_parameters},
    {"limits", limits},
    {"random triples", random_triples},
    {"known files", known_files},
    {"polygons", polygons},
    {"open borders", open_borders},
    {"search", search},
    {data_case, data_meshes}};
  return run_tests("test_degenerate_faces", tests);
}
