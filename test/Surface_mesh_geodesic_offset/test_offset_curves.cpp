// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offset curves at ten distances on generated meshes and meshes of the data directory, checked by the validation oracle. Other forms
// of requests give the same curves (test_offset_families), and known lengths are those of test_planar_offsets,
// test_closed_form_offsets and test_degenerate_levels.
//
//   test_offset_curves [MAXIMUM_FACES [NAME_PART]]
//
// for the data directory; default: 6000 faces, all names

#include "curve_checks.h"
#include "query_cases.h"

#include <string>
#include <vector>

namespace test_offset_curves {

using namespace test;

typedef Geodesic::Offset_curve Offset_curve;
typedef Geodesic::Face_location Face_location;

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

void run(const std::string& name, const test::Surface_mesh& mesh, const std::vector<Source>& sources)
{
  Report::instance().set_context(name);
  ++summary().cases;
  try
  {
    Geodesic geodesic = built(mesh, sources);
    const std::vector<double> levels = ten_levels(mesh, geodesic);
    std::vector<Offset_curve> curves;
    for (double level : levels) geodesic.offset_curves(level, std::back_inserter(curves));
    CHECK(!curves.empty());
    const Validation_report report = Curve_checker(mesh, geodesic).check(levels, curves);
    geodesic.build_with_offset_curves(levels, std::back_inserter(curves));
    summary().report.add(report);
    CHECK(geodesic.statistics().forced_joints == 0);
    summary().forced_joints += geodesic.statistics().forced_joints;
    std::cout << name << ": ";
    print(std::cout, report);
    std::cout << "; " << geodesic.statistics().forced_joints << " joints forced" << std::endl;
  }
  catch (const std::exception& e)
  {
    ++summary().exceptions;
    CHECK_DETAIL(!"an exception was thrown", e.what());
  }
}

// A vertex; a point in a face; plane sections; the boundary, if there is one; all of it together.
void run_all_sources(const Query_case& c, unsigned seed)
{
  ++summary().meshes;
  Random random(seed);
  std::vector<Source> sections, all = {point_source(source(halfedge(random_face(c.mesh, random), c.mesh), c.mesh)),
                                       point_source({random_face(c.mesh, random), random_barycentric(random)})};
  for (const auto& s : random_plane_section(c.mesh, seed)) sections.push_back(polyline_source(s.locations, s.closed));
  std::vector<test::Surface_mesh::Edge_index> border;
  for (auto e : edges(c.mesh))
    if (c.mesh.is_border(e)) border.push_back(e);
  run(c.name + ", vertex", c.mesh, {all[0]});
  run(c.name + ", point in a face", c.mesh, {all[1]});
  run(c.name + ", plane section", c.mesh, sections);
  all.insert(all.end(), sections.begin(), sections.end());
  if (!border.empty()) run(c.name + ", boundary", c.mesh, {edge_source(border)});
  if (!border.empty()) all.push_back(edge_source(border));
  run(c.name + ", all together", c.mesh, all);
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
            {is_point ? point_source(Face_location(data.faces[0], {{0.25 + 0.5 * tilt, 0.5, 0.25 - 0.5 * tilt}}))
                      : edge_source({data.mesh.edge(data.mesh.halfedge(data.vertices[0], data.vertices[1]))})});
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
    nearly_along_an_edge();
    print_summary("edges along paths");
    unsigned seed = 10;
    for_each_mesh(all_mesh_names(), {}, [&](const Query_case& c) { run_all_sources(c, ++seed); });
    run_all_sources(Query_case("bare tetrahedron", tetrahedron_sides().triangulated(0, 0, 1)), ++seed);
    print_summary("generated");
  }
  Names names = data_mesh_names();
  names.erase(std::remove_if(names.begin(), names.end(),
                             [&](const std::string& name) { return name.find(name_part) == std::string::npos; }),
              names.end());
  for_each_mesh(
    {}, names, [](const Query_case& c) { run_all_sources(c, 3); }, maximum_faces);
  print_summary("data directory");
  return Report::instance().finish("test_offset_curves");
}
