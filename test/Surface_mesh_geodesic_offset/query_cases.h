// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes with random sources and random query points.

#ifndef GEODESIC_OFFSET_TEST_QUERY_CASES_H
#define GEODESIC_OFFSET_TEST_QUERY_CASES_H

#include "data_meshes.h"
#include "generated_meshes.h"
#include "path_tools.h"
#include "plane_section.h"

#include <memory>
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

  std::string name;
  test::Surface_mesh mesh;
  Path_checker checker;
};

typedef std::vector<std::unique_ptr<Query_case>> Query_cases;

/// Eight small generated meshes.
inline Query_cases generated_query_cases()
{
  Query_cases cases;
  const std::pair<const char*, Soup> generated[] = {
    {"rectangle", rotated(random_rectangle(2, 1, 150, 10, 1), 1)},
    {"grid", planar_grid(14, 12, Diagonals::alternating)},
    {"box", rotated(box_sides(1, 0.7, 0.4).triangulated(40, 4, 2), 2)},
    {"saddle", Cone(8, 3 * CGAL_PI, 1).triangulated(30, 4, 3)},
    {"icosphere", icosphere(3)},
    {"genus 5", marching_genus_5(10)},
    {"torus", torus(24, 16)},
    {"L", l_shape(80, 5, 4)}};
  for (const auto& mesh : generated) cases.push_back(std::make_unique<Query_case>(mesh.first, mesh.second));
  return cases;
}

/// Two small meshes of the data directory.
inline Query_cases data_query_cases()
{
  Query_cases cases;
  for (const char* name : {"anchor.off", "mesh_with_border.off"})
  {
    test::Surface_mesh mesh;
    const std::string reason = read_data_mesh(std::filesystem::path(data_directory()) / name, 10000, mesh);
    if (reason.empty()) cases.push_back(std::make_unique<Query_case>(name, mesh));
    else std::cout << name << ": skipped, " << reason << std::endl;
  }
  return cases;
}

/// Calls f(case, seed, whether windows are kept) for all cases of the requested kinds, with each of the seeds from 1 on.
template <class Function>
void for_each_query_case(unsigned seeds, const Function& f)
{
  Query_cases cases;
  if (mesh_kinds().generated) cases = generated_query_cases();
  if (mesh_kinds().data)
    for (auto& c : data_query_cases()) cases.push_back(std::move(c));
  for (const auto& c : cases)
    for (unsigned seed = 1; seed <= seeds; ++seed)
      for (const bool keep : {true, false}) try
        {
          f(*c, seed, keep);
        }
        catch (const std::exception& e)
        {
          CHECK_DETAIL(!"an exception was thrown", e.what());
        }
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
