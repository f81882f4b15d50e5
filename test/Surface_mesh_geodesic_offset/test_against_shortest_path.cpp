// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances of all vertices and of random points (in faces, on edges, at vertices) from point sources, on generated meshes and on the
// manifold triangle meshes of the data directory, against CGAL::Surface_mesh_shortest_path: 1e-10 relative. Path lengths equal
// distances to 1e-12.
//
// If our distance is smaller, the path must prove it: every path is checked to be valid on the mesh, from the query point
// to a source, and as long as the distance. (Surface_mesh_shortest_path 5.5 is wrong at some vertices of blade.off.)
//
//   test_against_shortest_path [MAXIMUM_FACES [NAME_PART]]     default 3000 or 20000 faces, all names

#include "query_cases.h"

#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace test_against_shortest_path {

using namespace test;

typedef CGAL::Surface_mesh_shortest_path_traits<Kernel, test::Surface_mesh> Shortest_path_traits;
typedef CGAL::Surface_mesh_shortest_path<Shortest_path_traits> Shortest_path;

struct Totals
{
  std::size_t proved = 0, other_paths = 0, vertex_paths = 0;
};

// From a source on an edge, Surface_mesh_shortest_path 5.5 finds distances that are not the lengths of its own paths (it
// confuses the coordinates of the two ends). So its source is moved off the edge, by 1e-12.
Face_location just_inside(Face_location location)
{
  for (double& w : location.second)
    if (w == 0)
    {
      w = 1e-12;
      *std::max_element(location.second.begin(), location.second.end()) -= w;
    }
  return location;
}

// Distances of the vertices, then of the points; nothing if the other solver fails on this mesh. Unreachable: -1.
std::optional<std::vector<double>> reference_distances(const test::Surface_mesh& mesh, const Path_locations& sources,
                                                       const Path_locations& points, std::string& failure)
{
  try
  {
    const Mesh_locations locations(mesh);
    Shortest_path shortest_path(mesh);
    for (const Face_location& s : sources)
      if (is_at_vertex(s)) shortest_path.add_source_point(locations.support(s).front().first);
      else
      {
        const Face_location inner = just_inside(s);
        shortest_path.add_source_point(inner.first, inner.second);
      }
    shortest_path.build_sequence_tree();
    std::vector<double> result;
    for (Vertex_index v : vertices(mesh))
      result.push_back(is_isolated(v, mesh) ? -1 : shortest_path.shortest_distance_to_source_points(v).first);
    for (const Face_location& l : points)
      result.push_back(is_at_vertex(l) ? result[locations.support(l).front().first]
                                       : shortest_path.shortest_distance_to_source_points(l.first, l.second).first);
    for (double& d : result)
      if (d < 0) d = infinity;
    return result;
  }
  catch (const std::exception& e)
  {
    failure = e.what();
    return std::nullopt;
  }
}

// Compares the path from a vertex, without kept windows, with `path`, traced with kept windows. They may differ if there
// are several shortest paths.
void check_without_windows(Path_checker& check, const Geodesic& geodesic, Vertex_index v, const Path_locations& path,
                           Totals& totals)
{
  const Path_locations other = check(geodesic, v, false);
  ++totals.vertex_paths;
  CHECK(other.empty() == path.empty());
  const double l = length_of(check.locations, path), m = length_of(check.locations, other);
  CHECK_DETAIL(std::abs(l - m) <= 1e-12 * (std::max)(l, check.mean_edge), values(m, l));
  bool same = other.size() == path.size();
  for (std::size_t i = 0; same && i < path.size(); ++i)
    same = distance(check.point(path[i]), check.point(other[i])) <= 1e-9 * check.scale;
  totals.other_paths += same ? 0 : 1;
}

void compare(const test::Surface_mesh& mesh, const Path_locations& sources, const Path_locations& points, Path_checker& check,
             Worst_error& worst, Totals& totals)
{
  std::string failure;
  const auto expected = reference_distances(mesh, sources, points, failure);
  if (!expected)
  {
    std::replace(failure.begin(), failure.end(), '\n', ' ');
    std::cout << Report::instance().context() << ": not compared, Surface_mesh_shortest_path fails: " << failure << std::endl;
    if (points.empty()) return;
  }
  std::vector<Source> set;
  for (const Face_location& s : sources) set.push_back(point_source(s));
  const Geodesic geodesic = built(mesh, set), without_windows = built(mesh, set, false);
  const auto compare_distance = [&](double d, std::size_t i) {
    const double reference = expected ? (*expected)[i] : d;
    const bool is_proved = d < reference * (1 - 1e-10) - 1e-14 * check.scale;
    if (is_proved) ++totals.proved;
    else CHECK_CLOSE(worst, d, reference);
    return is_proved;
  };
  Worst_error worst_without(1e-13, check.scale);
  std::size_t number = 0;
  for (Vertex_index v : vertices(mesh))
  {
    const double d = without_windows.distance_to_sources(v);
    CHECK_CLOSE(worst_without, d, geodesic.distance_to_sources(v));
    if (compare_distance(d, number++)) check(geodesic, v);
  }
  std::size_t refused = 0;
  for (const Face_location& l : points)
  {
    const Path_locations path = check(geodesic, l);
    const double d = geodesic.distance_to_sources(l);
    compare_distance(d, number++);
    if (is_at_vertex(l))
    {
      const Vertex_index v = check.locations.support(l).front().first;
      CHECK(geodesic.distance_to_sources(v) == d);
      // of paths that tie, a list that is not reduced keeps all
      CHECK_CLOSE(worst_without, without_windows.distance_to_sources(v), d);
      CHECK(without_windows.distance_to_sources(l) == without_windows.distance_to_sources(v));
      check(geodesic, v);
      check_without_windows(check, without_windows, v, path, totals);
    }
    else if (refused++ < 4)
    {
      CHECK_THROWS(without_windows.distance_to_sources(l), std::logic_error);
      CHECK_THROWS(without_windows.nearest_source(l), std::logic_error);
      CHECK_THROWS(without_windows.gradient(l), std::logic_error);
      Path_locations none;
      CHECK_THROWS(without_windows.shortest_path_to_sources(l, std::back_inserter(none)), std::logic_error);
      CHECK(none.empty());
    }
  }
}

// From a point in a face, on an edge, a vertex, and five points; a quarter of the queries for each.
void run(Query_case& c, std::size_t queries)
{
  Random random(11);
  Worst_error worst(1e-10, c.checker.scale + 300 * c.checker.mean_edge); // see just_inside
  Totals totals;
  const char* kinds[] = {"a face point", "an edge point", "a vertex", "five points"};
  for (std::size_t kind = queries > 0 ? 0 : 2; kind < 4; ++kind)
  {
    c.set_context(std::string("from ") + kinds[kind]);
    Path_locations sources;
    for (std::size_t i = 0; i < (kind == 3 ? 5 : 1); ++i)
      sources.push_back(random_location(c.checker.locations, c.mesh, random, kind == 3 ? i % 3 : kind));
    guarded([&] { compare(c.mesh, sources, c.random_points(random, queries / 4), c.checker, worst, totals); });
  }
  const Path_totals& paths = c.checker.totals;
  std::cout << c.name << ": " << num_faces(c.mesh) << " faces, " << worst.count() << " distances; worst relative difference "
            << worst.error() << "; " << paths.paths << " paths of " << paths.points << " points, " << paths.unreachable
            << " unreachable, worst difference of length and distance " << paths.worst_length << "; " << totals.other_paths
            << " of " << totals.vertex_paths << " paths are others without kept windows";
  if (totals.proved > 0)
    std::cout << "; Surface_mesh_shortest_path is too long at " << totals.proved << " points, proved by paths";
  std::cout << std::endl;
}

} // namespace test_against_shortest_path

GEODESIC_OFFSET_TEST(test_against_shortest_path)
{
  const std::size_t maximum_faces = argc > 1 ? std::stoul(argv[1]) : number_of_cases(3000ul, 20000ul);
  const std::string name_part = argc > 2 ? argv[2] : "";
  std::cout.precision(3);
  Names with_queries = {"elephant.off", "anchor.off",           "mask_cone.off", "cow.off",
                        "homer.off",    "mesh_with_border.off", "holes.off"};
  if (number_of_cases(0, 1) == 1) with_queries.insert(with_queries.end(), {"fandisk.off", "bull.off", "cheese.off"});
  if (!name_part.empty()) with_queries.clear();
  Names others;
  for (const std::string& name : data_mesh_names())
    if (name.find(name_part) != std::string::npos &&
        std::find(with_queries.begin(), with_queries.end(), name) == with_queries.end())
      others.push_back(name);
  for_each_mesh(name_part.empty() ? all_mesh_names() : Names(), {}, [](Query_case& c) { run(c, 250); });
  for_each_mesh(
    {}, with_queries, [](Query_case& c) { run(c, 1000); }, 100000);
  for_each_mesh(
    {}, others, [](Query_case& c) { run(c, 0); }, maximum_faces);
  return Report::instance().finish("test_against_shortest_path");
}
