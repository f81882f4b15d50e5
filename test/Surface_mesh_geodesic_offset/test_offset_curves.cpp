// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offset curves at ten distances on generated meshes and meshes of the data directory, checked by the validation oracle;
// the same curves one level at a time, all at once, and during the build.
//
//   test_offset_curves [MAXIMUM_FACES [NAME_PART]]
//
// for the data directory; default: 6000 faces, all names

#include "curve_checks.h"
#include "data_meshes.h"
#include "flat_paths.h"
#include "generated_meshes.h"
#include "geodesic_types.h"
#include "plane_section.h"
#include "test_check.h"

#include <map>
#include <string>
#include <vector>

namespace test_offset_curves {

using namespace test;

typedef Geodesic::Offset_curve Offset_curve;
typedef Geodesic::Face_location Face_location;

struct Totals
{
  std::size_t curves = 0, closed = 0;
  double length = 0;
};

std::map<double, Totals> totals(const std::vector<Offset_curve>& curves)
{
  std::map<double, Totals> result;
  for (const Offset_curve& curve : curves)
  {
    Totals& total = result[curve.distance()];
    ++total.curves;
    total.closed += curve.is_closed() ? 1 : 0;
    total.length += curve.length();
  }
  return result;
}

// Ten distances over the whole range of the field.
std::vector<double> ten_levels(const test::Surface_mesh& mesh, const Geodesic& geodesic)
{
  double largest = 0;
  for (auto v : vertices(mesh))
    if (std::isfinite(geodesic.distance_to_sources(v))) largest = (std::max)(largest, geodesic.distance_to_sources(v));
  const bool vertices_decide = largest > 0; // all of them may be sources
  for (auto f : faces(mesh))
    if (!vertices_decide)
    {
      const double d = geodesic.distance_to_sources(Face_location(f, {{1. / 3, 1. / 3, 1. / 3}}));
      if (std::isfinite(d)) largest = (std::max)(largest, d);
    }
  std::vector<double> result;
  for (int i = 0; i < 10; ++i) result.push_back(largest * (0.013 + 0.1037 * i));
  return result;
}

// Figures of several cases.
struct Summary
{
  std::size_t meshes = 0, cases = 0, exceptions = 0, forced_joints = 0;
  Validation_report report;
};

Summary& summary()
{
  static Summary s;
  return s;
}

// Prints figures since the last call.
void print_summary(const std::string& what)
{
  std::cout << what << ": " << summary().meshes << " meshes, " << summary().cases << " cases, " << summary().exceptions
            << " exceptions; ";
  print(std::cout, summary().report);
  std::cout << "; " << summary().forced_joints << " joints forced" << std::endl;
  summary() = Summary();
}

template <class AddSources>
void run(const std::string& name, const test::Surface_mesh& mesh, const AddSources& add_sources)
{
  Report::instance().set_context(name);
  ++summary().cases;
  try
  {
    Geodesic geodesic(mesh);
    add_sources(geodesic);
    geodesic.build(CGAL::parameters::keep_windows(true));
    const std::vector<double> levels = ten_levels(mesh, geodesic);
    std::vector<Offset_curve> one_by_one, at_once, while_building;
    for (double level : levels)
    {
      const std::size_t before = one_by_one.size();
      geodesic.offset_curves(level, std::back_inserter(one_by_one));
      for (std::size_t i = before; i < one_by_one.size(); ++i) CHECK(one_by_one[i].distance() == level);
    }
    CHECK(!one_by_one.empty());
    const Validation_report report = Curve_checker(mesh, geodesic).check(levels, one_by_one);

    geodesic.offset_curves(levels, std::back_inserter(at_once));
    Geodesic again(mesh);
    add_sources(again);
    again.build_with_offset_curves(levels, std::back_inserter(while_building));
    const auto expected = totals(one_by_one);
    for (const std::vector<Offset_curve>* curves : {&at_once, &while_building})
    {
      const auto actual = totals(*curves);
      CHECK(actual.size() == expected.size());
      for (const auto& entry : expected)
      {
        const auto found = actual.find(entry.first);
        if (!CHECK(found != actual.end())) continue;
        CHECK(found->second.curves == entry.second.curves && found->second.closed == entry.second.closed);
        CHECK_DETAIL(std::abs(found->second.length - entry.second.length) <= 1e-10 * entry.second.length,
                     values(found->second.length, entry.second.length));
      }
    }
    summary().report.add(report);
    CHECK(again.statistics().forced_joints == 0);
    summary().forced_joints += again.statistics().forced_joints;
    std::cout << name << ": ";
    print(std::cout, report);
    std::cout << "; " << again.statistics().forced_joints << " joints forced" << std::endl;
  }
  catch (const std::exception& e)
  {
    ++summary().exceptions;
    CHECK_DETAIL(!"an exception was thrown", e.what());
  }
}

// A vertex; a point in a face; plane sections; the boundary, if there is one; all of it together.
void run_all_sources(const std::string& name, const test::Surface_mesh& mesh, unsigned seed)
{
  ++summary().meshes;
  Random random(seed);
  const auto random_face = [&]() {
    return *std::next(faces(mesh).begin(), static_cast<std::ptrdiff_t>(uniform_index(random, num_faces(mesh))));
  };
  const auto vertex = source(halfedge(random_face(), mesh), mesh);
  const Face_location in_face(random_face(), random_barycentric(random));
  const auto sections = random_plane_section(mesh, seed);
  std::vector<test::Surface_mesh::Edge_index> border;
  for (auto e : edges(mesh))
    if (mesh.is_border(e)) border.push_back(e);
  const auto add_sections = [&](Geodesic& geodesic) {
    for (const auto& section : sections)
      geodesic.add_source_polyline(section.locations, CGAL::parameters::is_closed(section.closed));
  };
  run(name + ", vertex", mesh, [&](Geodesic& geodesic) { geodesic.add_source_point(vertex); });
  run(name + ", point in a face", mesh, [&](Geodesic& geodesic) { geodesic.add_source_point(in_face); });
  run(name + ", plane section", mesh, add_sections);
  if (!border.empty()) run(name + ", boundary", mesh, [&](Geodesic& geodesic) { geodesic.add_source_edges(border); });
  run(name + ", all together", mesh, [&](Geodesic& geodesic) {
    geodesic.add_source_point(vertex);
    geodesic.add_source_point(in_face);
    add_sections(geodesic);
    if (!border.empty()) geodesic.add_source_edges(border);
  });
}

// One level with known number of curves and total length. Levels are cut below themselves by a fraction of 2^-42, which
// matters where the length changes fast, by `growth` per unit of the level.
template <class AddSources>
void check_length(const std::string& name, const test::Surface_mesh& mesh, const AddSources& add_sources, double level,
                  std::size_t expected_curves, std::size_t expected_closed, double expected_length, double growth = 0)
{
  Report::instance().set_context(name + ", level " + std::to_string(level));
  try
  {
    Geodesic geodesic(mesh);
    add_sources(geodesic);
    geodesic.build(CGAL::parameters::keep_windows(true));
    std::vector<Offset_curve> curves;
    geodesic.offset_curves(level, std::back_inserter(curves));
    CHECK_DETAIL(curves.size() == expected_curves, std::to_string(curves.size()) + " curves");
    const Totals total = totals(curves)[level];
    CHECK_DETAIL(total.closed == expected_closed, std::to_string(total.closed) + " closed");
    // Joints of curves that meet at a small angle are less well conditioned than distances.
    CHECK_DETAIL(std::abs(total.length - expected_length) <= 1e-11 * expected_length + 2.5e-13 * level * growth,
                 values(total.length, expected_length));
    Curve_checker(mesh, geodesic).check({level}, curves);
  }
  catch (const std::exception& e)
  {
    CHECK_DETAIL(!"an exception was thrown", e.what());
  }
}

void known_lengths()
{
  typedef Generated_mesh<test::Surface_mesh> Data;
  const double pi = CGAL_PI;
  for (unsigned seed : {1u, 2u, 3u})
  {
    const Data data(rotated(random_rectangle(4, 4, 300, 8, seed), seed));
    Flat_path_generator<test::Surface_mesh> generator(data, seed);
    const auto in_middle = [&](double size) { // a location within size / 2 of the centre
      for (;;)
      {
        const Face_location location = generator.random_location(0);
        const Point_2 p = generator.uv(location, 0);
        if ((std::max)(std::abs(p.x() - 2), std::abs(p.y() - 2)) < size / 2) return location;
      }
    };
    const Face_location a = in_middle(1);
    for (double level : {1e-4, 0.1, 0.9, 1.4})
      check_length(
        "circle, seed " + std::to_string(seed), data.mesh, [&](Geodesic& g) { g.add_source_point(a); }, level, 1, 1,
        2 * pi * level);

    const Face_location b = in_middle(1);
    const double apart = distance(generator.uv(a, 0), generator.uv(b, 0));
    for (double ratio : {0.3, 0.45, 0.6, 1.5})
    {
      const double level = ratio * apart, lost = ratio > 0.5 ? std::acos(0.5 / ratio) : 0;
      if (level < 1.45 && apart > 1e-3)
        check_length(
          "two circles, seed " + std::to_string(seed), data.mesh,
          [&](Geodesic& g) {
            g.add_source_point(a);
            g.add_source_point(b);
          },
          level, ratio > 0.5 ? 1 : 2, ratio > 0.5 ? 1 : 2, 4 * level * (pi - lost));
    }
    Flat_path<test::Surface_mesh> path;
    path.locations.push_back(a);
    if (CHECK(generator.add_leg(path, b, 0)))
      for (double level : {0.01, 0.3, 1.3})
        check_length(
          "stadium, seed " + std::to_string(seed), data.mesh, [&](Geodesic& g) { g.add_source_polyline(path.locations); },
          level, 1, 1, 2 * apart + 2 * pi * level);

    for (double level : {0.05, 0.7, 1.9})
      check_length(
        "rectangle's boundary, seed " + std::to_string(seed), data.mesh,
        [&](Geodesic& g) {
          std::vector<test::Surface_mesh::Edge_index> border;
          for (auto e : edges(data.mesh))
            if (data.mesh.is_border(e)) border.push_back(e);
          g.add_source_edges(border);
        },
        level, 1, 1, 4 * (4 - 2 * level));

    for (double turns : {0.4, 1.3, 2.2})
    {
      const Cone cone(8, turns * 2 * pi, 1);
      const Data cone_data(cone.triangulated(30, 4, seed));
      const double inner_radius = std::cos(cone.sector_angle() / 2);
      for (double level : {0.01, 0.5 * inner_radius, 0.97 * inner_radius})
        check_length(
          "cone of " + std::to_string(turns) + " turns from its apex", cone_data.mesh,
          [&](Geodesic& g) { g.add_source_point(cone_data.vertices[0]); }, level, 1, 1, cone.total_angle * level);
    }
  }

  // Levels through vertices and along edges of a regular grid.
  const Data grid(planar_grid(16, 16, Diagonals::alternating));
  for (double level : {1., 2., 5., std::sqrt(2.), std::sqrt(5.), 7.5})
    check_length(
      "grid", grid.mesh, [&](Geodesic& g) { g.add_source_point(grid.vertices[8 * 17 + 8]); }, level, 1, 1, 2 * pi * level);
  for (double level : {1., 3., 3.5, 15.})
    check_length(
      "grid's left side", grid.mesh,
      [&](Geodesic& g) {
        std::vector<test::Surface_mesh::Edge_index> side;
        for (std::size_t j = 0; j < 16; ++j)
          side.push_back(grid.mesh.edge(grid.mesh.halfedge(grid.vertices[17 * j], grid.vertices[17 * (j + 1)])));
        g.add_source_edges(side);
      },
      level, 1, 0, 16);

  // The offset of a triangle's sides is a loop inside the triangle without edge crossings.
  const Data triangle(rotated(random_rectangle(3, 4, 0, 0, 1), 9)); // two right triangles with sides 3, 4, 5
  for (double level : {0.2, 0.9, 0.999})
    check_length(
      "triangles' sides", triangle.mesh,
      [&](Geodesic& g) {
        g.add_source_edges(std::vector<test::Surface_mesh::Edge_index>(edges(triangle.mesh).begin(),
                                                                       edges(triangle.mesh).end()));
      },
      level, 2, 2, 2 * 12 * (1 - level), 2 * 12);
}

// Shortest paths along an edge that pass a flat vertex: the distance through the vertex ties with the correct one up to the
// square of the angle between path and edge, and the two levels touch so closely that they can be distinguished only far
// along.
void nearly_along_an_edge()
{
  typedef Generated_mesh<test::Surface_mesh> Data;
  for (const bool is_point : {false, true})
    for (int i = 0; i < 8; ++i)
      for (const double side : {-1., 1.})
      {
        const double tilt = side * 1e-7 * std::pow(4, i);
        Soup soup;
        soup.points = {Point_3(-7.5 - 3 * tilt, -3, 0),
                       Point_3(-7.5 + 3 * tilt, 3, 0),
                       Point_3(0, 0, 0),
                       Point_3(6.3, 0, 0),
                       Point_3(3.2, 5.2, 0),
                       Point_3(3.1, -5.3, 0)};
        for (const std::array<std::size_t, 3>& t :
             std::vector<std::array<std::size_t, 3>>{{{0, 2, 1}}, {{2, 3, 4}}, {{2, 5, 3}}, {{1, 2, 4}}, {{0, 5, 2}}})
          soup.add_triangle(t);
        const Data data(rotated(soup, unsigned(i + 1)));
        run(std::string(is_point ? "point" : "edge") + " and edge along paths, " + std::to_string(tilt), data.mesh,
            [&](Geodesic& g) {
              if (is_point) g.add_source_point(Face_location(data.faces[0], {{0.25 + 0.5 * tilt, 0.5, 0.25 - 0.5 * tilt}}));
              else
                g.add_source_edges(std::vector<test::Surface_mesh::Edge_index>(
                  1, data.mesh.edge(data.mesh.halfedge(data.vertices[0], data.vertices[1]))));
            });
      }
}

} // namespace test_offset_curves

GEODESIC_OFFSET_TEST(test_offset_curves)
{
  const std::size_t maximum_faces = argc > 1 ? std::stoul(argv[1]) : number_of_cases(3000ul, 6000ul);
  const std::string name_part = argc > 2 ? argv[2] : "";
  std::cout.precision(3);
  if (mesh_kinds().generated && name_part.empty())
  {
    known_lengths();
    nearly_along_an_edge();
    print_summary("edges along paths");
    const std::pair<const char*, Soup> generated[] = {
      {"torus", torus(20, 14)},
      {"icosphere", icosphere(2)},
      {"genus 5", marching_genus_5(9)},
      {"marching sphere", marching_sphere(8)},
      {"box", rotated(box_sides(1, 0.7, 0.45).triangulated(40, 4, 1), 1)},
      {"cube", box_sides(1, 1, 1).triangulated(10, 3, 1)},
      {"tetrahedron", tetrahedron_sides().triangulated(0, 0, 1)},
      {"prism", Prism(6, 0.5, 1.5).triangulated(30, 4, 3)},
      {"cone of 0.75 turns", Cone(8, 1.5 * CGAL_PI, 1).triangulated(25, 4, 4)},
      {"cone of 1.5 turns", Cone(8, 3 * CGAL_PI, 1).triangulated(25, 4, 5)},
      {"jittered grid", jittered_grid(14, 10, 7)},
      {"grid", planar_grid(10, 10, Diagonals::alternating)},
      {"L", rotated(l_shape(50, 5, 8), 8)}};
    unsigned seed = 10;
    for (const auto& mesh : generated)
      run_all_sources(mesh.first, Generated_mesh<test::Surface_mesh>(mesh.second).mesh, ++seed);
    print_summary("generated");
  }
  for (const std::filesystem::path& file : data_files())
  {
    const std::string name = file.filename().string();
    test::Surface_mesh mesh;
    if (name.find(name_part) != std::string::npos && read_data_mesh(file, maximum_faces, mesh).empty())
      run_all_sources(name, mesh, 3);
  }
  print_summary("data directory");
  return Report::instance().finish("test_offset_curves");
}
