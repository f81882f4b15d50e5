// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surface_mesh and Polyhedron_3 give identical distances, with one templated body.

#include "flat_paths.h"
#include "generated_meshes.h"
#include "geodesic_types.h"
#include "test_check.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/property_map.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace test_mesh_types {

using namespace test;

enum class Sources { vertex, points, polyline, edges };

/// Distances of all vertices, in the order of the soup's points, from sources given by soup indices, so that they are the
/// same for each mesh type.
template <class TriangleMesh>
std::vector<double> distances(const Soup& soup, Sources sources, unsigned seed)
{
  typedef Geodesic_on<TriangleMesh> Geodesic;
  const Generated_mesh<TriangleMesh> data(soup);
  const Locations<TriangleMesh> locations(data.mesh);
  Random random(seed);
  Geodesic geodesic(data.mesh);

  const auto location = [&](std::size_t triangle, const std::array<double, 3>& weights) {
    return locations.in_triangle(data, soup, triangle, weights);
  };
  const std::size_t triangle = uniform_index(random, soup.triangles.size());
  switch (sources)
  {
  case Sources::vertex: geodesic.add_source_point(data.vertices[uniform_index(random, data.vertices.size())]); break;
  case Sources::points:
    geodesic.add_source_point(location(triangle, random_barycentric(random)));
    geodesic.add_source_point(location(uniform_index(random, soup.triangles.size()), {{0.25, 0.75, 0}}));
    break;
  case Sources::polyline:
    geodesic.add_source_polyline(std::vector<typename Geodesic::Face_location>{
      location(triangle, {{0, 0.3, 0.7}}), location(triangle, random_barycentric(random)), location(triangle, {{0.6, 0, 0.4}}),
      location(triangle, {{1, 0, 0}})});
    break;
  case Sources::edges:
  {
    std::vector<typename Geodesic::edge_descriptor> edges;
    // The edge of a face's halfedge depends on the mesh type, so use all three.
    for (auto h : CGAL::halfedges_around_face(halfedge(data.faces[triangle], data.mesh), data.mesh))
      edges.push_back(edge(h, data.mesh));
    geodesic.add_source_edges(edges);
    break;
  }
  }
  geodesic.build();
  std::vector<double> result;
  for (auto v : data.vertices) result.push_back(geodesic.distance_to_sources(v));
  return result;
}

void run(const std::string& name, const Soup& soup)
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  std::size_t count = 0;
  for (Sources sources : {Sources::vertex, Sources::points, Sources::polyline, Sources::edges})
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
      Report::instance().set_context(name + ", sources " + std::to_string(static_cast<int>(sources)) + ", seed " +
                                     std::to_string(seed));
      try
      {
        const std::vector<double> a = distances<test::Surface_mesh>(soup, sources, seed);
        const std::vector<double> b = distances<Polyhedron>(soup, sources, seed);
        CHECK(a.size() == b.size() && a.size() == soup.points.size());
        for (std::size_t i = 0; i < a.size() && i < b.size(); ++i, ++count)
          CHECK_DETAIL(a[i] == b[i] && std::isfinite(a[i]), values(a[i], b[i]));
      }
      catch (const std::exception& e)
      {
        CHECK_DETAIL(!"an exception was thrown", e.what());
      }
    }
  std::cout << name << ": " << count << " distances compared" << std::endl;
}

// Unset indices, the initial state of all elements of a Polyhedron_3 with ids.
template <class Descriptor>
struct Unset_index
{
  typedef Descriptor key_type;
  typedef std::size_t value_type, reference;
  typedef boost::readable_property_map_tag category;
  friend std::size_t get(const Unset_index&, Descriptor) { return std::size_t(-1); }
};

void unset_indices()
{
  Report::instance().set_context("unset indices");
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh> Traits;
  typedef Unset_index<test::Surface_mesh::Vertex_index> Unset_vertex_index;
  typedef Unset_index<test::Surface_mesh::Face_index> Unset_face_index;
  const test::Surface_mesh mesh = Generated_mesh<test::Surface_mesh>(icosphere(1)).mesh;
  const auto no_faces = [&] {
    CGAL::Surface_mesh_geodesic_offset<Traits, CGAL::Default, Unset_face_index>(
      mesh, CGAL::parameters::face_index_map(Unset_face_index()));
  };
  const auto no_vertices = [&] {
    CGAL::Surface_mesh_geodesic_offset<Traits, Unset_vertex_index>(mesh,
                                                                   CGAL::parameters::vertex_index_map(Unset_vertex_index()));
  };
  CHECK_THROWS(no_faces(), std::length_error);
  CHECK_THROWS(no_vertices(), std::length_error);
}

} // namespace test_mesh_types

GEODESIC_OFFSET_TEST(test_mesh_types)
{
  unset_indices();
  run("genus 5", marching_genus_5(10));
  run("box", rotated(box_sides(1, 0.7, 0.45).triangulated(40, 4, 1), 1));
  run("saddle", Cone(8, 3 * CGAL_PI, 1).triangulated(30, 4, 2));
  run("grid", planar_grid(15, 10, Diagonals::alternating));
  run("icosphere", icosphere(2));
  return Report::instance().finish("test_mesh_types");
}
