// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Plane sections against CGAL::Polygon_mesh_slicer, in general position and through vertices, edges and faces; their
// orientation; and sections as sources.

#include "data_meshes.h"
#include "generated_meshes.h"
#include "geodesic_types.h"
#include "locations.h"
#include "section_search.h"
#include "test_check.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_geodesic_offset/Radical_numbers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_plane_section {

using namespace test;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef Kernel::Plane_3 Plane_3;

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// Length of polylines, and number of closed ones.
struct Measure
{
  double length = 0;
  std::size_t number = 0, closed = 0;
};

template <class TriangleMesh>
class Section_checker
{
  typedef test::Locations<TriangleMesh> Locations;
  typedef Geodesic_on<TriangleMesh> Geodesic;
  typedef typename Geodesic::Face_location Face_location;
  typedef typename Geodesic::Plane_section Plane_section;

public:
  explicit Section_checker(const TriangleMesh& mesh) : m_mesh(mesh), m_geodesic(mesh), m_locations(mesh), m_slicer(mesh)
  {
    const CGAL::Bbox_3 box = PMP::bbox(mesh);
    m_scale = (std::max)({box.x_span(), box.y_span(), box.z_span(), std::abs(box.xmax()), std::abs(box.xmin()),
                          std::abs(box.ymax()), std::abs(box.ymin()), std::abs(box.zmax()), std::abs(box.zmin())});
  }

  // Computes the section and checks that its points are in the plane, its segments in faces, with the positive side on
  // their left.
  Plane_section operator()(const Plane_3& plane, Measure& measure)
  {
    const Plane_section section = m_geodesic.plane_section(plane);
    const double tolerance = 1e-14 * m_scale;
    for (const auto& polyline : section.polylines)
    {
      const auto& l = polyline.locations;
      const std::size_t n = l.size();
      ++measure.number;
      measure.closed += polyline.is_closed;
      CHECK(n >= (polyline.is_closed ? 3u : 2u));
      for (std::size_t i = 0; i < n; ++i)
      {
        const Point_3 p = PMP::construct_point(l[i], m_mesh);
        CHECK(std::sqrt(CGAL::squared_distance(p, plane)) <= tolerance);
        if (i + 1 == n && !polyline.is_closed) break;
        const Face_location& next = l[(i + 1) % n];
        const Point_3 q = PMP::construct_point(next, m_mesh);
        measure.length += distance(p, q);
        const auto f = m_locations.common_face(l[i], next);
        if (!CHECK(f != boost::graph_traits<TriangleMesh>::null_face()) || !(distance(p, q) > 1e-6 * m_scale)) continue;
        const auto c = m_locations.corners(f);
        const auto points = get(CGAL::vertex_point, m_mesh);
        const Vector_3 normal = CGAL::normal(get(points, c[0]), get(points, c[1]), get(points, c[2]));
        const double rise = CGAL::cross_product(normal, q - p) * plane.orthogonal_vector();
        const double largest =
          std::sqrt(normal.squared_length() * (q - p).squared_length() * plane.orthogonal_vector().squared_length());
        if (m_locations.support(l[i]).size() > 1 || m_locations.support(next).size() > 1) // otherwise there is another face
          CHECK(rise > -1e-6 * largest);
      }
    }
    return section;
  }

  Measure by_slicer(const Plane_3& plane)
  {
    std::vector<std::vector<Point_3>> polylines;
    m_slicer(plane, std::back_inserter(polylines));
    Measure measure;
    for (const auto& polyline : polylines)
    {
      if (polyline.size() < 2) continue; // a single contact at a vertex
      ++measure.number;
      measure.closed += polyline.front() == polyline.back();
      for (std::size_t i = 1; i < polyline.size(); ++i) measure.length += distance(polyline[i - 1], polyline[i]);
    }
    return measure;
  }

  void against_slicer(const Plane_3& plane)
  {
    Measure ours;
    const Plane_section section = (*this)(plane, ours);
    const Measure theirs = by_slicer(plane);
    CHECK_DETAIL(std::abs(ours.length - theirs.length) <= 1e-12 * (theirs.length + m_scale),
                 values(ours.length, theirs.length));
    CHECK_DETAIL(ours.number == theirs.number && ours.closed == theirs.closed,
                 values(double(ours.number), double(theirs.number)));
    CHECK(section.touched_vertices.empty() && section.number_of_faces_in_plane == 0);
    length += ours.length / m_scale;

    // as sources: distance zero there, and the whole section is a source
    m_geodesic.clear_sources();
    const std::vector<std::size_t> ids = m_geodesic.add_source_plane_section(plane);
    CHECK(ids.size() == section.polylines.size() && m_geodesic.number_of_sources() == ids.size());
  }

  void in_general_position(unsigned seed)
  {
    Random random(seed);
    const CGAL::Bbox_3 box = PMP::bbox(m_mesh);
    for (int i = 0; i < 5; ++i)
    {
      const Point_3 p(uniform(random, box.xmin(), box.xmax()), uniform(random, box.ymin(), box.ymax()),
                      uniform(random, box.zmin(), box.zmax()));
      const Vector_3 n(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
      against_slicer(Plane_3(p, n));
    }
  }

  double length = 0; // of all sections, relative to the size of the mesh

private:
  const TriangleMesh& m_mesh;
  Geodesic m_geodesic;
  const Locations m_locations;
  CGAL::Polygon_mesh_slicer<TriangleMesh, Kernel> m_slicer;
  double m_scale;
};

template <class TriangleMesh>
void generated()
{
  double length = 0;
  const std::vector<std::pair<std::string, Soup>> soups = {
    {"grid", rotated(jittered_grid(12, 9, 1), 2)},
    {"cube", rotated(cube_grid(7), 3)},
    {"torus", torus(40, 20)},
    {"icosphere", icosphere(4)},
    {"genus 5", marching_genus_5(14)}};
  for (const auto& [name, soup] : soups)
  {
    Report::instance().set_context(name);
    const Generated_mesh<TriangleMesh> data(soup);
    Section_checker<TriangleMesh> check(data.mesh);
    for (unsigned seed = 0; seed < 10; ++seed) check.in_general_position(seed);
    length += check.length;
  }
  CHECK(length > 100); // planes intersected the meshes
}

void data_meshes()
{
  for (const auto& file : data_files())
  {
    const std::string name = file.filename().string();
    test::Surface_mesh mesh;
    if (!read_data_mesh(file, 20000, mesh).empty()) continue;
    Report::instance().set_context(name);
    try
    {
      Section_checker<test::Surface_mesh> check(mesh);
      check.in_general_position(1);
    }
    catch (const std::invalid_argument& e)
    {
      CHECK_DETAIL(std::string(e.what()).find(" is degenerate ") != std::string::npos, e.what());
      std::cout << file.filename().string() << ": skipped, " << e.what() << std::endl;
    }
  }
}

// Through vertices, along edges, and in faces: cases with known results.
template <class TriangleMesh>
void special_positions()
{
  const auto expect = [](const TriangleMesh& mesh, const Plane_3& plane, double length, std::size_t number, std::size_t closed,
                         std::size_t touched, std::size_t faces, std::size_t touched_edges = 0) {
    for (const Plane_3& p : {plane, plane.opposite()})
    {
      Measure m;
      const auto section = Section_checker<TriangleMesh>(mesh)(p, m);
      CHECK_DETAIL(std::abs(m.length - length) <= 1e-13 * length, values(m.length, length));
      CHECK(section.touched_edges.size() == touched_edges);
      CHECK_DETAIL(m.number == number && m.closed == closed, values(double(m.number), double(number)));
      CHECK(section.touched_vertices.size() == touched && section.number_of_faces_in_plane == faces);
    }
  };
  const Generated_mesh<TriangleMesh> cube(cube_grid(4)); // the unit cube, 4 x 4 squares per side
  Report::instance().set_context("cube");
  expect(cube.mesh, Plane_3(0, 0, 1, -0.5), 4, 1, 1, 0, 0); // along edges
  expect(cube.mesh, Plane_3(0, 0, 1, -0.6), 4, 1, 1, 0, 0); // across
  expect(cube.mesh, Plane_3(0, 0, 1, -1), 4, 1, 1, 0, 32);  // a side
  expect(cube.mesh, Plane_3(0, 0, 1, 0), 4, 1, 1, 0, 32);
  expect(cube.mesh, Plane_3(1, 1, 1, 0), 0, 0, 0, 1, 0);                      // a corner
  expect(cube.mesh, Plane_3(1, 1, 0, 0), 0, 0, 0, 0, 0, 4);                   // an edge of the cube
  expect(cube.mesh, Plane_3(1, 1, 1, -1), 3 * std::sqrt(2.), 1, 1, 0, 0);     // through three corners
  expect(cube.mesh, Plane_3(1, -1, 0, 0), 2 + 2 * std::sqrt(2.), 1, 1, 0, 0); // through four
  expect(cube.mesh, Plane_3(0, 0, 1, -1.25), 0, 0, 0, 0, 0);                  // misses it

  Report::instance().set_context("grid");
  const Generated_mesh<TriangleMesh> grid(planar_grid(6, 4));
  expect(grid.mesh, Plane_3(1, 0, 0, -3), 4, 1, 0, 0, 0);                 // along edges, from border to border
  expect(grid.mesh, Plane_3(1, 0, 0, 0), 4, 1, 0, 0, 0);                  // along the border
  expect(grid.mesh, Plane_3(1, -1, 0, 0), 4 * std::sqrt(2.), 1, 0, 0, 0); // along the diagonals
  expect(grid.mesh, Plane_3(1, 1, 0, -4), 4 * std::sqrt(2.), 1, 0, 0, 0); // across them, through vertices
  expect(grid.mesh, Plane_3(1, 1, 0, 0), 0, 0, 0, 1, 0);                  // a corner
  expect(grid.mesh, Plane_3(0, 0, 1, 0), 0, 0, 0, 0, 48, 20);             // all of it: its border

  // polylines end where two lines of the section cross
  Soup saddle;
  for (int i = 0; i < 8; ++i)
  {
    const double height = i % 2 == 0 ? 0 : i % 4 == 1 ? 1 : -1;
    saddle.points.push_back(Point_3(std::cos(i * CGAL_PI / 4), std::sin(i * CGAL_PI / 4), height));
  }
  saddle.points.push_back(Point_3(0, 0, 0));
  for (std::size_t i = 0; i < 8; ++i) saddle.add_triangle({{8, i, (i + 1) % 8}});
  Report::instance().set_context("saddle");
  const Generated_mesh<TriangleMesh> crossing(saddle);
  expect(crossing.mesh, Plane_3(0, 0, 1, 0), 4, 4, 0, 0, 0);
}

// An edge that the plane touches is a source without sides, beside a polyline from which it goes on.
void touched_edges()
{
  Soup soup; // a ridge at height 0 that goes over into a slope
  for (const auto& p : {Point_3(0, 0, 0), Point_3(0, 1, 0), Point_3(0, 2, 0), Point_3(-1, 0, -1), Point_3(-1, 1, -1),
                        Point_3(-1, 2, -1), Point_3(1, 0, -1), Point_3(1, 1, 1), Point_3(1, 2, 1)})
    soup.points.push_back(p);
  for (const auto& t : std::vector<std::array<std::size_t, 3>>{
         {3, 0, 4}, {0, 1, 4}, {4, 1, 5}, {1, 2, 5}, {0, 6, 1}, {6, 7, 1}, {1, 7, 2}, {7, 8, 2}})
    soup.add_triangle(t);
  const Generated_mesh<test::Surface_mesh> data(soup);
  const auto edge_between = [&](std::size_t a, std::size_t b) {
    return data.mesh.edge(data.mesh.halfedge(data.vertices[a], data.vertices[b]));
  };
  for (const double up : {1., -1.})
  {
    Geodesic geodesic(data.mesh);
    const Plane_3 plane(0, 0, up, 0);
    const auto section = geodesic.plane_section(plane);
    CHECK(section.touched_edges == std::vector<Surface_mesh::Edge_index>{edge_between(0, 1)});
    CHECK(section.touched_vertices.empty());
    // from the border along the ridge, and across the slope; they meet at vertex 1
    CHECK(section.polylines.size() == 1);
    CHECK(geodesic.add_source_plane_section(plane) == (std::vector<std::size_t>{0, 1}));
    geodesic.build(CGAL::parameters::keep_windows(true));
    const auto middle = [&](std::size_t triangle) {
      return Geodesic::Face_location(data.faces[triangle], {1. / 3, 1. / 3, 1. / 3});
    };
    const auto side_of = [&](std::size_t triangle) { return geodesic.nearest_source(middle(triangle))->side; };
    CHECK(side_of(1) == CGAL::Source_side::NONE && side_of(4) == CGAL::Source_side::NONE);
    CHECK(side_of(3) == (up > 0 ? CGAL::Source_side::RIGHT : CGAL::Source_side::LEFT));
    CHECK(side_of(6) == (up > 0 ? CGAL::Source_side::LEFT : CGAL::Source_side::RIGHT));
    CHECK(!geodesic.signed_distance_to_sources(middle(1)));
    CHECK(up * or_nan(geodesic.signed_distance_to_sources(middle(3))) > 0 &&
          up * or_nan(geodesic.signed_distance_to_sources(middle(6))) < 0);
  }
}

// A bounded run of the search (benchmark/Surface_mesh_geodesic_offset/Robustness/section_search.cpp runs it at length).
void search()
{
  Section_search search(std::cout, 20, 10);
  for (unsigned seed = 1; seed <= 150; ++seed) search.run(seed);
  CHECK(search.counts().size() == 8);
  std::size_t touched_edges = 0, faces = 0, signs = 0;
  for (const auto& c : search.counts())
  {
    CHECK_DETAIL(c.second.wrong == 0, c.first + ": " + std::to_string(c.second.wrong) + " wrong planes");
    touched_edges += c.second.touched_edges;
    faces += c.second.faces_in_plane;
    signs += c.second.signs;
  }
  CHECK(touched_edges > 100 && faces > 100 && signs > 1000);
}

// A section through a flat mesh: distances are those from a line.
void distances_to_a_line()
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    Random random(seed);
    const Soup soup = seed % 2 == 0 ? jittered_grid(9, 7, seed) : planar_grid(9, 7);
    const Generated_mesh<test::Surface_mesh> data(soup);
    const double angle = seed % 3 == 0 ? 0 : uniform(random, -0.2, 0.2), at = seed % 3 == 0 ? 4 : uniform(random, 3, 5);
    const Plane_3 plane(std::cos(angle), std::sin(angle), 0, -at);
    Geodesic geodesic(data.mesh);
    CHECK(geodesic.add_source_plane_section(plane) == std::vector<std::size_t>{0});
    geodesic.build();
    Worst_error worst(1e-13, 10);
    for (auto v : data.mesh.vertices())
    {
      // the nearest point of the line is on the mesh unless it is beyond the border
      const Point_3 p = data.mesh.point(v), foot = plane.projection(p);
      if (foot.y() < 0 || foot.y() > 7) continue;
      CHECK_CLOSE(worst, geodesic.distance_to_sources(v), distance(p, foot));
      const double side = plane.a() * p.x() + plane.b() * p.y() + plane.d();
      if (std::abs(side) > 1e-9 && foot.y() > 1e-9 && foot.y() < 7 - 1e-9) // the positive side is on the left
        CHECK(geodesic.nearest_source(v)->side == (side > 0 ? CGAL::Source_side::LEFT : CGAL::Source_side::RIGHT));
    }
    CHECK(worst.count() > 40);
  }
}

// Equal results with other kernels.
template <class Other_kernel>
void other_kernel(double tolerance)
{
  typedef CGAL::Surface_mesh<typename Other_kernel::Point_3> Mesh;
  typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Other_kernel, Mesh>> Other_geodesic;
  const Generated_mesh<test::Surface_mesh> data(icosphere(1));
  Mesh mesh;
  for (auto v : data.mesh.vertices())
  {
    const Point_3 p = data.mesh.point(v);
    typedef typename Other_kernel::FT FT;
    mesh.add_vertex(typename Other_kernel::Point_3(FT(p.x()), FT(p.y()), FT(p.z())));
  }
  for (auto f : data.mesh.faces())
  {
    std::vector<typename Mesh::Vertex_index> corners;
    for (auto v : data.mesh.vertices_around_face(data.mesh.halfedge(f)))
      corners.push_back(typename Mesh::Vertex_index(std::uint32_t(v)));
    mesh.add_face(corners);
  }
  const Geodesic geodesic(data.mesh);
  const Other_geodesic other(mesh);
  const auto section = geodesic.plane_section(Plane_3(1, 2, 3, -0.5));
  const auto same = other.plane_section(typename Other_kernel::Plane_3(1, 2, 3, typename Other_kernel::FT(-0.5)));
  CHECK(section.polylines.size() == 1 && same.polylines.size() == 1);
  const auto& l = section.polylines.front().locations;
  const auto& m = same.polylines.front().locations;
  CHECK(l.size() > 10 && l.size() == m.size());
  CHECK(section.polylines.front().is_closed && same.polylines.front().is_closed);
  for (std::size_t i = 0; i < l.size() && i < m.size(); ++i)
  {
    CHECK(std::uint32_t(l[i].first) == std::uint32_t(m[i].first));
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(CGAL::to_double(m[i].second[k]) - l[i].second[k]) <= tolerance);
  }
}

void bad_input()
{
  const Generated_mesh<test::Surface_mesh> data(icosphere(1));
  Geodesic geodesic(data.mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {nan, infinity, -infinity})
    for (int i = 0; i < 4; ++i)
    {
      const Plane_3 plane(i == 0 ? bad : 1, i == 1 ? bad : 1, i == 2 ? bad : 1, i == 3 ? bad : 0);
      CHECK_THROWS(geodesic.plane_section(plane), std::invalid_argument);
      CHECK_THROWS(geodesic.add_source_plane_section(plane), std::invalid_argument);
    }
  CHECK_THROWS(geodesic.plane_section(Plane_3(0, 0, 0, 1)), std::invalid_argument);
  CHECK(geodesic.add_source_plane_section(Plane_3(0, 0, 1, 2)).empty()); // misses the mesh
  CHECK(geodesic.number_of_sources() == 0);

  test::Surface_mesh isolated; // isolated vertices are not part of the surface
  isolated.add_vertex(Point_3(0, 0, 0));
  const auto section = Geodesic(isolated).plane_section(Plane_3(0, 0, 1, 0));
  CHECK(section.polylines.empty() && section.touched_vertices.empty());
}

} // namespace test_plane_section

GEODESIC_OFFSET_TEST(test_plane_section)
{
  const std::vector<std::pair<std::string, std::function<void()>>> tests = {
    {"generated, Surface_mesh", generated<test::Surface_mesh>},
    {"generated, Polyhedron_3", generated<CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>>},
    {data_case, data_meshes},
    {"special positions", special_positions<test::Surface_mesh>},
    {"touched edges", touched_edges},
    {"search", search},
    {"distances to a line", distances_to_a_line},
    {"cartesian doubles", [] { other_kernel<CGAL::Simple_cartesian<double>>(0); }},
    {"cartesian floats", [] { other_kernel<CGAL::Simple_cartesian<float>>(1e-5); }},
    {"exact numbers", [] { other_kernel<CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt>(1e-15); }},
    {"bad input", bad_input}};
  return run_tests("test_plane_section", tests);
}
