// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A catalogue of meshes, random sources and points on a mesh, and the runners of properties: functions of a mesh, or of a mesh, a
// seed, and whether windows are kept.

#ifndef GEODESIC_OFFSET_TEST_QUERY_CASES_H
#define GEODESIC_OFFSET_TEST_QUERY_CASES_H

#include "data_meshes.h"
#include "generated_meshes.h"
#include "path_tools.h"
#include "plane_section.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Mesh with query points and candidates for sources.
struct Query_case
{
  Query_case(const std::string& name, const Soup& soup)
    : name(name), mesh(Generated_mesh<test::Surface_mesh>(soup).mesh), checker(mesh)
  {
  }
  Query_case(const std::string& name, const test::Surface_mesh& m) : name(name), mesh(m), checker(mesh) {}
  Query_case(const Query_case&) = delete;

  /// Point of any kind, plane section, or part of a section.
  Any_source random_source(Random& random) const
  {
    const std::size_t kind = uniform_index(random, 5);
    if (kind < 3) return {{random_location(checker.locations, mesh, random, kind)}, false};
    const auto sections = random_plane_section(mesh, random());
    if (sections.empty()) // the plane missed the mesh
      return {{random_location(checker.locations, mesh, random, 0)}, false};
    const auto& section = sections[uniform_index(random, sections.size())];
    if (kind == 4) return {section.locations, section.closed};
    const std::size_t first = uniform_index(random, section.locations.size());
    const std::size_t last = (std::min)(section.locations.size(), first + 1 + uniform_index(random, 20));
    return {Path_locations(section.locations.begin() + std::ptrdiff_t(first), section.locations.begin() + std::ptrdiff_t(last)),
            false};
  }

  Path_locations random_points(Random& random, std::size_t count) const
  {
    Path_locations result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(random_location(checker.locations, mesh, random, i % 3));
    return result;
  }

  /// Sources of all kinds; two thirds of them have start values of up to `largest_start`.
  Source_set random_sources(Random& random, std::size_t count, double largest_start = 0) const
  {
    Source_set result;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double start = random() % 3 == 0 ? 0 : uniform(random, 0, largest_start);
      const auto np = CGAL::parameters::start_value(start);
      const std::size_t kind = uniform_index(random, 5);
      auto h = halfedge(random_face(mesh, random), mesh);
      if (kind == 0) result.add_vertex(target(h, mesh), np);
      else if (kind == 1)
      {
        std::vector<test::Surface_mesh::Edge_index> edges;
        for (int k = 0; k < 3 && !is_border(h, mesh); ++k)
        {
          edges.push_back(edge(h, mesh));
          h = next(opposite(next(h, mesh), mesh), mesh);
        }
        result.add_edges(edges, np);
      }
      else
      {
        const Any_source source = random_source(random);
        if (source.locations.size() == 1) result.add_location(source.locations[0], np);
        else result.add_polyline(source.locations, np.is_closed(source.closed));
      }
    }
    return result;
  }

  /// The curves of a section by a plane in general position.
  Source_set section(unsigned seed) const
  {
    Source_set result;
    for (const auto& s : random_plane_section(mesh, seed))
      result.add_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
    return result;
  }

  /// The context of further failures.
  void set_context(const std::string& what) const { Report::instance().set_context(name + ", " + what); }

  std::string name;
  test::Surface_mesh mesh;
  Path_checker checker;
};

typedef std::vector<std::string> Names;

/// The generated meshes by name, on surfaces of all kinds.
inline const std::vector<std::pair<std::string, Soup (*)()>>& mesh_catalogue()
{
  static const std::vector<std::pair<std::string, Soup (*)()>> meshes = {
    {"rectangle", [] { return rotated(random_rectangle(2, 1, 150, 10, 1), 1); }},
    {"grid", [] { return planar_grid(14, 12, Diagonals::alternating); }},
    {"jittered grid", [] { return jittered_grid(12, 9, 7); }},
    {"L", [] { return l_shape(80, 5, 4); }},
    {"needles", [] { return random_rectangle(1, 0.01, 60, 4, 3); }},
    {"needle fan", [] { return needle_fan(64); }},
    {"box", [] { return rotated(box_sides(1, 0.7, 0.4).triangulated(40, 4, 2), 2); }},
    {"cube", [] { return rotated(cube_grid(5), 2); }},
    {"tetrahedron", [] { return rotated(tetrahedron_sides().triangulated(30, 3, 1), 3); }},
    {"prism", [] { return rotated(Prism(6, 0.5, 1.5).triangulated(30, 4, 3), 4); }},
    {"cone", [] { return Cone(8, 1.5 * CGAL_PI, 1).triangulated(25, 4, 4); }},
    {"saddle", [] { return Cone(8, 3 * CGAL_PI, 1).triangulated(30, 4, 3); }},
    {"icosphere", [] { return icosphere(3); }},
    {"torus", [] { return torus(24, 16); }},
    {"genus 5", [] { return marching_genus_5(10); }},
    {"tiny faces", [] { return marching_sphere(8); }}};
  return meshes;
}

inline Soup named_soup(const std::string& name)
{
  for (const auto& mesh : mesh_catalogue())
    if (mesh.first == name) return mesh.second();
  throw std::logic_error("no mesh is named " + name);
}

/// Calls f(name, mesh) for the meshes of the data directory with the given names. Prints which are skipped.
template <class Function>
void for_each_data_mesh(const Names& names, std::size_t maximum_faces, const Function& f)
{
  for (const std::string& name : names)
  {
    test::Surface_mesh mesh;
    const std::string reason = read_data_mesh(std::filesystem::path(data_directory()) / name, maximum_faces, mesh);
    if (reason.empty()) f(name, mesh);
    else std::cout << name << ": skipped, " << reason << std::endl;
  }
}

/// Calls f(case) for the meshes of the catalogue and those of the data directory with the given names, of those kinds that are
/// requested.
template <class Function>
void for_each_mesh(const Names& generated, const Names& data, const Function& f, std::size_t maximum_faces = 10000)
{
  const auto run = [&](Query_case&& c) {
    Report::instance().set_context(c.name);
    guarded([&] { f(c); });
  };
  for (const std::string& name : mesh_kinds().generated ? generated : Names()) run(Query_case(name, named_soup(name)));
  if (mesh_kinds().data)
    for_each_data_mesh(data, maximum_faces,
                       [&](const std::string& name, const test::Surface_mesh& mesh) { run(Query_case(name, mesh)); });
}

/// All files of the data directory.
inline Names data_mesh_names()
{
  Names result;
  for (const auto& file : data_files()) result.push_back(file.filename().string());
  return result;
}

inline Names all_mesh_names(const std::string& excluded = "")
{
  Names result;
  for (const auto& mesh : mesh_catalogue())
    if (mesh.first != excluded) result.push_back(mesh.first);
  return result;
}

typedef std::vector<std::unique_ptr<Query_case>> Query_cases;

/// Eight small generated meshes.
inline Query_cases generated_query_cases()
{
  Query_cases cases;
  for (const char* name : {"rectangle", "grid", "box", "saddle", "icosphere", "genus 5", "torus", "L"})
    cases.push_back(std::make_unique<Query_case>(name, named_soup(name)));
  return cases;
}

/// Two small meshes of the data directory.
inline Names small_data_meshes() { return {"anchor.off", "mesh_with_border.off"}; }

inline Query_cases data_query_cases()
{
  Query_cases cases;
  for_each_data_mesh(small_data_meshes(), 10000, [&](const std::string& name, const test::Surface_mesh& mesh) {
    cases.push_back(std::make_unique<Query_case>(name, mesh));
  });
  return cases;
}

inline double largest_vertex_distance(const Geodesic& geodesic, const test::Surface_mesh& mesh)
{
  double result = 0;
  for (Vertex_index v : vertices(mesh))
    if (std::isfinite(geodesic.distance_to_sources(v))) result = (std::max)(result, geodesic.distance_to_sources(v));
  return result;
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_QUERY_CASES_H
