// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances and shortest paths at random points (in faces, on edges, at vertices) from point sources, against
// CGAL::Surface_mesh_shortest_path: 1e-10 relative; path lengths equal distances to 1e-12.
//
// If our distance is smaller, the path must prove it: every path is checked to be valid on the mesh, from the query point
// to a source, and as long as the distance.
//
//   test_queries_against_shortest_path [QUERIES_PER_MESH [MESH_NAME...]]
//
// default: 1000, seven or ten meshes of the data directory; QUERIES_PER_MESH above 1000 adds meshes

#include "data_meshes.h"
#include "generated_meshes.h"
#include "path_tools.h"

#include <CGAL/Surface_mesh_shortest_path.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace test_queries_against_shortest_path {

using namespace test;

typedef CGAL::Surface_mesh_shortest_path_traits<Kernel, test::Surface_mesh> Shortest_path_traits;
typedef CGAL::Surface_mesh_shortest_path<Shortest_path_traits> Shortest_path;

struct Query
{
  Face_location location;
  std::size_t kind;    // 0 in a face, 1 on an edge, 2 at a vertex
  Vertex_index vertex; // of kind 2
};

struct Totals
{
  std::size_t queries = 0, proved = 0, other_paths = 0, vertex_paths = 0;
  double seconds = 0;
};

std::vector<Query> random_queries(const Mesh_locations& locations, const test::Surface_mesh& mesh, Random& random,
                                  std::size_t count)
{
  std::vector<Query> result;
  for (std::size_t i = 0; i < count; ++i)
  {
    Query q{random_location(locations, mesh, random, i % 3), i % 3, Vertex_index()};
    if (q.kind == 2) q.vertex = locations.support(q.location).front().first;
    result.push_back(q);
  }
  return result;
}

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

std::optional<std::vector<double>> reference_distances(const test::Surface_mesh& mesh,
                                                       const std::vector<Face_location>& sources,
                                                       const std::vector<Query>& queries, std::string& failure)
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
    for (const Query& q : queries)
    {
      const double d =
        q.kind == 2 ? shortest_path.shortest_distance_to_source_points(q.vertex).first
                    : shortest_path.shortest_distance_to_source_points(q.location.first, q.location.second).first;
      result.push_back(d < 0 ? infinity : d); // -1 if unreachable
    }
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

void compare(const std::string& name, const test::Surface_mesh& mesh, const std::vector<Face_location>& sources, Random& random,
             std::size_t count, Path_checker& check, Worst_error& worst, Totals& totals)
{
  const std::vector<Query> queries = random_queries(check.locations, mesh, random, count);
  const auto start = std::chrono::steady_clock::now();
  std::string failure;
  const auto expected = reference_distances(mesh, sources, queries, failure);
  totals.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!expected)
  {
    std::replace(failure.begin(), failure.end(), '\n', ' ');
    std::cout << name << ": not compared, Surface_mesh_shortest_path fails: " << failure << std::endl;
  }
  Geodesic geodesic(mesh), without_windows(mesh);
  for (Geodesic* g : {&geodesic, &without_windows})
    for (const Face_location& s : sources) g->add_source_point(s);
  geodesic.build(CGAL::parameters::keep_windows(true));
  without_windows.build();
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    const Query& q = queries[i];
    const Path_locations path = check(geodesic, q.location);
    const double d = geodesic.distance_to_sources(q.location);
    ++totals.queries;
    if (q.kind == 2)
    {
      CHECK(geodesic.distance_to_sources(q.vertex) == d);
      CHECK(without_windows.distance_to_sources(q.vertex) == d);
      CHECK(without_windows.distance_to_sources(q.location) == d);
      check(geodesic, q.vertex);
      check_without_windows(check, without_windows, q.vertex, path, totals);
    }
    else if (i < 6)
    {
      CHECK_THROWS(without_windows.distance_to_sources(q.location), std::logic_error);
      CHECK_THROWS(without_windows.nearest_source(q.location), std::logic_error);
      CHECK_THROWS(without_windows.gradient(q.location), std::logic_error);
      Path_locations none;
      CHECK_THROWS(without_windows.shortest_path_to_sources(q.location, std::back_inserter(none)), std::logic_error);
      CHECK(none.empty());
    }
    if (!expected) continue;
    if (d < (*expected)[i] * (1 - 1e-10) - 1e-14 * check.scale) ++totals.proved;
    else CHECK_CLOSE(worst, d, (*expected)[i]);
  }
}

// A quarter of the queries each for a vertex, a point on an edge, a point in a face, and five points.
void run(const std::string& name, const test::Surface_mesh& mesh, std::size_t count)
{
  Random random(11);
  Path_checker check(mesh);
  Worst_error worst(1e-10, check.scale + 300 * check.mean_edge); // see just_inside
  Totals totals;
  const char* kinds[] = {"a face point", "an edge point", "a vertex", "five points"};
  for (std::size_t kind = 0; kind < 4; ++kind)
  {
    Report::instance().set_context(name + ", from " + kinds[kind]);
    std::vector<Face_location> sources;
    for (std::size_t i = 0; i < (kind == 3 ? 5 : 1); ++i)
      sources.push_back(random_location(check.locations, mesh, random, kind == 3 ? i % 3 : kind));
    try
    {
      compare(Report::instance().context(), mesh, sources, random, (count + 3 - kind) / 4, check, worst, totals);
    }
    catch (const std::exception& e)
    {
      CHECK_DETAIL(!"an exception was thrown", e.what());
    }
  }
  std::cout << name << ": " << num_faces(mesh) << " faces, " << totals.queries << " points; worst relative difference "
            << worst.error() << "; " << check.totals.paths << " paths of " << check.totals.points << " points, "
            << check.totals.unreachable << " unreachable, worst difference of length and distance " << check.totals.worst_length
            << "; " << totals.other_paths << " of " << totals.vertex_paths << " paths are others without kept windows";
  if (totals.proved > 0)
    std::cout << "; Surface_mesh_shortest_path is too long at " << totals.proved << " points, proved by paths";
  std::cout << "; Surface_mesh_shortest_path took " << totals.seconds << " s" << std::endl;
}

} // namespace test_queries_against_shortest_path

GEODESIC_OFFSET_TEST(test_queries_against_shortest_path)
{
  const std::size_t count = argc > 1 ? std::stoul(argv[1]) : 1000;
  std::cout.precision(3);
  std::vector<std::string> names(argv + (std::min)(argc, 2), argv + argc);
  const bool all = names.empty();
  if (all) names = {"elephant.off", "anchor.off", "mask_cone.off", "cow.off", "homer.off", "mesh_with_border.off", "holes.off"};
  if (all && number_of_cases(0, 1) == 1) names.insert(names.end(), {"fandisk.off", "bull.off", "cheese.off"});
  if (all && count > 1000)
    names.insert(names.end(), {"camel.off", "retinal.off", "dino.off", "femur.off", "rotor.off", "horizons.off",
                               "three_peaks.off", "lion-head.off", "blade.off"});
  if (all && mesh_kinds().generated)
    for (const auto& mesh : {std::make_pair("torus", torus(24, 16)), std::make_pair("L", l_shape(120, 6, 3)),
                             std::make_pair("cube", cube_grid(6))})
      run(mesh.first, Generated_mesh<test::Surface_mesh>(rotated(mesh.second, 7)).mesh, count / 4);
  for (const std::string& name : names)
  {
    test::Surface_mesh mesh;
    const std::string reason = read_data_mesh(std::filesystem::path(data_directory()) / name, 100000, mesh);
    if (reason.empty()) run(name, mesh, count);
    else std::cout << name << ": skipped, " << reason << std::endl;
  }
  return Report::instance().finish("test_queries_against_shortest_path");
}
