// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertex distances from points against CGAL::Surface_mesh_shortest_path, 1e-10 relative, on generated meshes and on the
// manifold triangle meshes of the data directory.
//
// If our distance is smaller, its path must prove it: valid on the mesh, from the vertex to a source, and as long as the
// distance. (Surface_mesh_shortest_path 5.5 is wrong at some vertices of blade.off.)
//
//   test_against_shortest_path [MAXIMUM_FACES [NAME_PART]]     default 20000 faces, all names

#include "data_meshes.h"
#include "flat_paths.h"
#include "generated_meshes.h"
#include "geodesic_types.h"
#include "test_check.h"

#include <CGAL/Surface_mesh_shortest_path.h>

#include <optional>
#include <string>
#include <vector>

namespace test_against_shortest_path {

using namespace test;

typedef CGAL::Surface_mesh_shortest_path_traits<Kernel, test::Surface_mesh> Shortest_path_traits;
typedef CGAL::Surface_mesh_shortest_path<Shortest_path_traits> Shortest_path;
typedef Geodesic::Face_location Face_location;
typedef test::Surface_mesh::Vertex_index Vertex_index;

// Surface_mesh_shortest_path returns -1 for unreachable vertices.
double as_distance(double answer) { return answer < 0 ? infinity : answer; }

bool is_isolated(Vertex_index v, const test::Surface_mesh& mesh)
{
  return halfedge(v, mesh) == test::Surface_mesh::null_halfedge();
}

// Distances of all vertices, or nothing if the other solver fails on this mesh.
template <class AddSource>
std::optional<std::vector<double>> reference_distances(const test::Surface_mesh& mesh, const AddSource& add_source,
                                                       std::string& failure)
{
  try
  {
    Shortest_path shortest_path(mesh);
    add_source(shortest_path);
    shortest_path.build_sequence_tree();
    std::vector<double> result;
    for (Vertex_index v : vertices(mesh))
      result.push_back(is_isolated(v, mesh) ? infinity
                                            : as_distance(shortest_path.shortest_distance_to_source_points(v).first));
    return result;
  }
  catch (const std::exception& e)
  {
    failure = e.what();
    return std::nullopt;
  }
}

// Whether the path traced from v is a path on the mesh that ends at distance 0 and is no longer than `length`.
bool is_proved_by_path(const test::Surface_mesh& mesh, const Geodesic& geodesic, Vertex_index v, double length)
{
  const Locations<test::Surface_mesh> locations(mesh);
  std::vector<Face_location> path;
  geodesic.shortest_path_to_sources(locations.at_vertex(v), std::back_inserter(path));
  if (path.size() < 2 || locations.point(path.front()) != mesh.point(v) ||
      geodesic.distance_to_sources(path.back()) > 1e-12 * length)
    return false;
  double path_length = 0;
  for (Face_location& location : path)
    for (double& weight : location.second)
    {
      if (std::abs(weight) <= 1e-13) weight = 0;
      if (!(weight >= 0)) return false;
    }
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    if (locations.common_face(path[i], path[i + 1]) == test::Surface_mesh::null_face()) return false;
    path_length += std::sqrt(CGAL::squared_distance(locations.point(path[i]), locations.point(path[i + 1])));
  }
  return path_length <= length * (1 + 1e-12);
}

template <class AddSource, class AddReferenceSource>
void compare(const std::string& name, const test::Surface_mesh& mesh, const AddSource& add_source,
             const AddReferenceSource& add_reference_source)
{
  Report::instance().set_context(name);
  std::string failure;
  const auto expected = reference_distances(mesh, add_reference_source, failure);
  if (!expected)
  {
    std::replace(failure.begin(), failure.end(), '\n', ' ');
    std::cout << name << ": not compared, Surface_mesh_shortest_path fails: " << failure << std::endl;
    return;
  }
  try
  {
    Geodesic geodesic(mesh);
    add_source(geodesic);
    geodesic.build();
    Geodesic with_windows(mesh);
    add_source(with_windows);
    with_windows.build(CGAL::parameters::keep_windows(true));
    Worst_error worst(1e-10, 0), worst_without(1e-13, 0);
    std::size_t infinite = 0, proved = 0, i = 0;
    for (Vertex_index v : vertices(mesh))
    {
      const double actual = geodesic.distance_to_sources(v), reference = (*expected)[i++];
      infinite += std::isinf(actual) ? 1 : 0;
      CHECK_CLOSE(worst_without, actual, with_windows.distance_to_sources(v));
      if (actual < reference * (1 - 1e-10))
      {
        if (CHECK_DETAIL(is_proved_by_path(mesh, with_windows, v, actual), values(actual, reference))) ++proved;
        continue;
      }
      CHECK_CLOSE(worst, actual, reference);
    }
    std::cout << name << ": " << worst.count() << " vertices, " << num_faces(mesh) << " faces, " << infinite
              << " unreachable, worst relative error " << worst.error();
    if (proved > 0) std::cout << "; Surface_mesh_shortest_path is too long at " << proved << " vertices, proved by paths";
    std::cout << std::endl;
  }
  catch (const std::exception& e)
  {
    CHECK_DETAIL(!"an exception was thrown", e.what());
  }
}

// From one vertex, and from two.
void compare_vertex_sources(const std::string& name, const test::Surface_mesh& mesh)
{
  std::vector<Vertex_index> used;
  for (Vertex_index v : vertices(mesh))
    if (!is_isolated(v, mesh)) used.push_back(v);
  const std::vector<Vertex_index> one = {used[used.size() / 3]}, two = {used[0], used[2 * used.size() / 3]};
  for (const std::vector<Vertex_index>& sources : {one, two})
  {
    const auto add = [&](auto& solver) {
      for (Vertex_index v : sources) solver.add_source_point(v);
    };
    compare(name + ", " + std::to_string(sources.size()) + " vertex source(s)", mesh, add, add);
  }
}

void compare_face_source(const std::string& name, const test::Surface_mesh& mesh, unsigned seed)
{
  Random random(seed);
  const std::size_t number = uniform_index(random, num_faces(mesh));
  const Face_location location(*std::next(faces(mesh).begin(), static_cast<std::ptrdiff_t>(number)),
                               random_barycentric(random));
  compare(
    name + ", a point in a face, seed " + std::to_string(seed), mesh,
    [&](Geodesic& geodesic) { geodesic.add_source_point(location); },
    [&](Shortest_path& shortest_path) { shortest_path.add_source_point(location.first, location.second); });
}

void generated_mesh(const std::string& name, const Soup& soup)
{
  const Generated_mesh<test::Surface_mesh> data(rotated(soup, 7));
  compare_vertex_sources(name, data.mesh);
  for (unsigned seed : {1u, 2u}) compare_face_source(name, data.mesh, seed);
}

} // namespace test_against_shortest_path

GEODESIC_OFFSET_TEST(test_against_shortest_path)
{
  const std::size_t maximum_faces = argc > 1 ? std::stoul(argv[1]) : number_of_cases(3000ul, 20000ul);
  const std::string name_part = argc > 2 ? argv[2] : "";
  std::cout.precision(3);

  if (mesh_kinds().generated && name_part.empty())
  {
    generated_mesh("icosphere", icosphere(3));
    generated_mesh("torus", torus(24, 16));
    generated_mesh("genus 5", marching_genus_5(12));
    generated_mesh("box", box_sides(1, 0.7, 0.4).triangulated(60, 5, 3));
    generated_mesh("saddle fan", saddle_fan());
    generated_mesh("saddle", Cone(8, 3 * CGAL_PI, 1).triangulated(40, 4, 3));
    generated_mesh("L", l_shape(120, 6, 3));
  }

  std::size_t used = 0, skipped = 0;
  for (const std::filesystem::path& file : data_files())
  {
    const std::string name = file.filename().string();
    if (name.find(name_part) == std::string::npos) continue;
    test::Surface_mesh mesh;
    const std::string reason = read_data_mesh(file, maximum_faces, mesh);
    if (!reason.empty())
    {
      std::cout << name << ": skipped, " << reason << std::endl;
      ++skipped;
      continue;
    }
    compare_vertex_sources(name, mesh);
    ++used;
  }
  std::cout << used << " meshes of the data directory used, " << skipped << " skipped" << std::endl;
  return Report::instance().finish("test_against_shortest_path");
}
