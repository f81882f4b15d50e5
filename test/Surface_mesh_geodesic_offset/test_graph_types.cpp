// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// All models of FaceListGraph give the same distances as Surface_mesh, with one templated body: Surface_mesh with removed
// elements, Polyhedron_3 with and without ids, Linear_cell_complex, Seam_mesh, Face_filtered_graph, OpenMesh if it is installed,
// an archetype of the concept, and a mesh that has lengths instead of points. Lengths alone: a flat torus, which embeds nowhere,
// against its closed form.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "locations.h"
#include "mesh_archetype.h"
#include "test_check.h"

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesic_offset/shortest_path_to_sources.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/graph_traits_Seam_mesh.h>
#ifdef GEODESIC_OFFSET_HAS_OPENMESH
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#endif

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace test_graph_types {

using namespace test;

typedef test::Surface_mesh Mesh;
typedef Mesh::Edge_index Edge_index;
typedef Mesh::Face_index Face_index;
typedef Mesh::Vertex_index Vertex_index;

template <class Graph>
auto points_of(const Graph& graph)
{
  return get(CGAL::vertex_point, graph);
}
inline mesh_archetype::Point_map points_of(const mesh_archetype::Mesh& mesh) { return {&mesh}; }

// Found by the type of the graph alone; CGAL has no overload for the archetype.
template <class Graph>
auto vertices_of(const Graph& graph)
{
  return vertices(graph);
}
template <class Graph>
auto faces_of(const Graph& graph)
{
  return faces(graph);
}

template <class Graph>
struct Geodesic_for
{
  typedef Geodesic_on<Graph> type;
};
template <>
struct Geodesic_for<mesh_archetype::Mesh>
{
  typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, mesh_archetype::Mesh>,
                                             mesh_archetype::Vertex_index_map, mesh_archetype::Face_index_map,
                                             mesh_archetype::Point_map>
    type;
};

/// A graph with its elements by the numbers of a soup, which are found by their points.
template <class Graph>
struct Numbered
{
  typedef boost::graph_traits<Graph> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  Numbered(const Graph& graph, const Soup& soup) : graph(graph)
  {
    const auto points = points_of(graph);
    std::map<Point_3, vertex_descriptor> vertex_at;
    for (vertex_descriptor v : vertices_of(graph)) vertex_at[get(points, v)] = v;
    for (const Point_3& p : soup.points) vertices.push_back(vertex_at.at(p));
    std::map<std::set<Point_3>, face_descriptor> face_at;
    for (face_descriptor f : faces_of(graph))
    {
      std::set<Point_3> corners;
      for (vertex_descriptor v : CGAL::vertices_around_face(halfedge(f, graph), graph)) corners.insert(get(points, v));
      face_at[corners] = f;
    }
    for (const auto& t : soup.triangles) faces.push_back(face_at.at({soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]}));
  }

  const Graph& graph;
  std::vector<vertex_descriptor> vertices;
  std::vector<face_descriptor> faces;
};

/// Distances of all points of the soup from a vertex, a location, a polyline in a face and the edges of a face.
template <class Graph, class NamedParameters>
std::vector<double> distances(const Numbered<Graph>& data, const Soup& soup, unsigned seed, const NamedParameters& np)
{
  typedef typename Geodesic_for<Graph>::type Geodesic;
  Random random(seed);
  Geodesic geodesic(data.graph, np);
  const Locations<Graph> locations(data.graph);
  const auto location = [&](std::size_t triangle, const std::array<double, 3>& weights) {
    return locations.in_triangle(data, soup, triangle, weights);
  };
  const auto any_triangle = [&] { return uniform_index(random, soup.triangles.size()); };
  geodesic.add_source_point(data.vertices[uniform_index(random, data.vertices.size())]);
  geodesic.add_source_point(location(any_triangle(), random_barycentric(random)));
  const std::size_t t = any_triangle();
  geodesic.add_source_polyline(std::vector<typename Geodesic::Face_location>{
    location(t, {{0, 0.3, 0.7}}), location(t, random_barycentric(random)), location(t, {{1, 0, 0}})});
  std::vector<typename Geodesic::edge_descriptor> edges;
  const auto h = halfedge(data.faces[any_triangle()], data.graph);
  for (auto g : CGAL::halfedges_around_face(h, data.graph)) edges.push_back(edge(g, data.graph));
  geodesic.add_source_edges(edges);
  geodesic.build();
  std::vector<double> result;
  for (auto v : data.vertices) result.push_back(geodesic.distance_to_sources(v));
  return result;
}

/// Compares with expected distances: the order of elements, and the layout by lengths, change rounding.
template <class Graph, class NamedParameters>
void compare(const std::string& name, const Graph& graph, const Soup& soup, const std::vector<std::vector<double>>& expected,
             Worst_error& worst, const NamedParameters& np)
{
  const Numbered<Graph> data(graph, soup);
  for (unsigned seed = 0; seed < expected.size(); ++seed)
  {
    Report::instance().set_context(name + ", seed " + std::to_string(seed));
    const std::vector<double> found = distances(data, soup, seed, np);
    for (std::size_t i = 0; i < found.size(); ++i) CHECK_CLOSE(worst, found[i], expected[seed][i]);
  }
}

/// A Surface_mesh with the soup between elements that are removed.
Mesh with_garbage(const Soup& soup)
{
  Mesh mesh;
  std::vector<Vertex_index> vertices;
  std::vector<Face_index> removed;
  const auto add_garbage = [&](double x) {
    const Vertex_index a = mesh.add_vertex(Point_3(x, 90, 0)), b = mesh.add_vertex(Point_3(x, 91, 0)),
                       c = mesh.add_vertex(Point_3(x, 90, 1));
    removed.push_back(mesh.add_face(a, b, c));
  };
  for (std::size_t i = 0; i < soup.points.size(); ++i)
  {
    if (i % 5 == 0) add_garbage(double(i));
    vertices.push_back(mesh.add_vertex(soup.points[i]));
  }
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
  {
    if (i % 7 == 0) add_garbage(-double(i + 1));
    const auto& t = soup.triangles[i];
    mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  }
  for (Face_index f : removed) CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  for (Vertex_index v : mesh.vertices())
    if (mesh.is_isolated(v)) mesh.remove_vertex(v);
  CHECK(mesh.has_garbage() && mesh.number_of_vertices() == soup.points.size());
  return mesh;
}

#ifdef GEODESIC_OFFSET_HAS_OPENMESH
/// Smart handles, which the ranges of OpenMesh have, are sources as handles are.
template <class Graph>
void smart_handles(const Graph& mesh)
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor Vertex;
  static_assert(!std::is_same<std::decay_t<decltype(*vertices(mesh).begin())>, Vertex>::value, "the handles are smart");
  std::map<Vertex, double> expected, found;
  CGAL::geodesic_distances(mesh, Vertex(0), boost::make_assoc_property_map(expected));
  CGAL::geodesic_distances(mesh, *vertices(mesh).begin(), boost::make_assoc_property_map(found));
  CHECK(found == expected && found.size() == num_vertices(mesh) && found.at(Vertex(1)) > 0);
  CGAL::geodesic_distances(mesh, vertices(mesh), boost::make_assoc_property_map(found));
  for (const auto& [v, distance] : found) CHECK(distance == 0);
  CGAL::geodesic_distances(mesh, *edges(mesh).begin(), boost::make_assoc_property_map(found));
  const auto h = halfedge(*edges(mesh).begin(), mesh);
  CHECK(found.at(source(h, mesh)) == 0 && found.at(target(h, mesh)) == 0);
  std::vector<Point_3> path;
  CGAL::shortest_path_to_sources(mesh, *vertices(mesh).begin(), Vertex(1), std::back_inserter(path));
  CHECK(path.size() > 1);
}
#endif

/// Distances of a Surface_mesh from three random sets of sources. A Polyhedron_3 with its elements in the same order has the same ones.
std::vector<std::vector<double>> expected_distances(const std::string& name, const Soup& soup)
{
  const auto none = CGAL::parameters::default_values();
  const Generated_mesh<Mesh> data(soup);
  const Generated_mesh<CGAL::Polyhedron_3<Kernel>> other(soup);
  std::vector<std::vector<double>> expected;
  for (unsigned seed = 0; seed < 3; ++seed)
  {
    Report::instance().set_context(name + ", Polyhedron_3 in the same order, seed " + std::to_string(seed));
    expected.push_back(distances(Numbered<Mesh>(data.mesh, soup), soup, seed, none));
    CHECK(*std::max_element(expected.back().begin(), expected.back().end()) < 1e3);
    CHECK(distances(Numbered<CGAL::Polyhedron_3<Kernel>>(other.mesh, soup), soup, seed, none) == expected.back());
  }
  return expected;
}

void run(const std::string& name, const Soup& soup, Worst_error& worst)
{
  const auto none = CGAL::parameters::default_values();
  const Generated_mesh<Mesh> data(soup);
  const std::vector<std::vector<double>> expected = expected_distances(name, soup);

  compare(name + ", Surface_mesh with garbage", with_garbage(soup), soup, expected, worst, none);

  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::copy_face_graph(data.mesh, polyhedron);
  compare(name + ", Polyhedron_3", polyhedron, soup, expected, worst, none);

  CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3> with_ids;
  CGAL::copy_face_graph(data.mesh, with_ids);
  compare(name + ", Polyhedron_3 with unset ids", with_ids, soup, expected, worst, none);
  CGAL::set_halfedgeds_items_id(with_ids);
  compare(name + ", Polyhedron_3 with ids", with_ids, soup, expected, worst, none);

  typedef CGAL::Linear_cell_complex_traits<3, Kernel> Complex_traits;
  CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Complex_traits>::type complex;
  CGAL::copy_face_graph(data.mesh, complex);
  compare(name + ", Linear_cell_complex", complex, soup, expected, worst, none);

  Mesh of_two_parts = data.mesh;
  const std::size_t n = of_two_parts.number_of_faces();
  of_two_parts.add_face(of_two_parts.add_vertex(Point_3(9, 9, 0)), of_two_parts.add_vertex(Point_3(10, 9, 0)),
                        of_two_parts.add_vertex(Point_3(9, 10, 0)));
  const auto part = of_two_parts.add_property_map<Face_index, std::size_t>("f:part", 0).first;
  for (Face_index f : of_two_parts.faces()) part[f] = f.idx() < n ? 0 : 1;
  const CGAL::Face_filtered_graph<Mesh> filtered(of_two_parts, 0, part);
  compare(name + ", Face_filtered_graph", filtered, soup, expected, worst, none);

  Mesh of_seams = data.mesh; // without seams; seams() has a mesh with them
  const auto is_seam_edge = of_seams.add_property_map<Edge_index, bool>("e:seam", false).first;
  const auto is_seam_vertex = of_seams.add_property_map<Vertex_index, bool>("v:seam", false).first;
  const CGAL::Seam_mesh<Mesh, Mesh::Property_map<Edge_index, bool>, Mesh::Property_map<Vertex_index, bool>> seam_mesh(
    of_seams, is_seam_edge, is_seam_vertex);
  compare(name + ", Seam_mesh", seam_mesh, soup, expected, worst, none);

  const mesh_archetype::Mesh archetype(soup);
  compare(name + ", archetype", archetype, soup, expected, worst,
          CGAL::parameters::vertex_point_map(points_of(archetype))
            .vertex_index_map(mesh_archetype::Vertex_index_map())
            .face_index_map(mesh_archetype::Face_index_map()));

#ifdef GEODESIC_OFFSET_HAS_OPENMESH
  struct Traits : OpenMesh::DefaultTraits
  {
    typedef OpenMesh::Vec3d Point;
  };
  OpenMesh::TriMesh_ArrayKernelT<Traits> open_mesh; // CGAL::copy_face_graph() rounds its points to floats
  std::vector<OpenMesh::VertexHandle> handles;
  for (const Point_3& p : soup.points) handles.push_back(open_mesh.add_vertex(OpenMesh::Vec3d(p.x(), p.y(), p.z())));
  for (const auto& c : soup.triangles) open_mesh.add_face(handles[c[0]], handles[c[1]], handles[c[2]]);
  compare(name + ", OpenMesh", open_mesh, soup, expected, worst, none);
  smart_handles(open_mesh);
#endif

  Mesh with_lengths = data.mesh;
  const auto length = with_lengths.add_property_map<Edge_index, double>("e:length").first;
  for (Edge_index e : with_lengths.edges())
    length[e] = std::sqrt(CGAL::squared_distance(with_lengths.point(with_lengths.vertex(e, 0)),
                                                 with_lengths.point(with_lengths.vertex(e, 1))));
  compare(name + ", lengths", with_lengths, soup, expected, worst, CGAL::parameters::edge_length_map(length));
}

/// A mesh that is cut along a path of edges, by Seam_mesh, and by copies of its vertices.
void seams(Worst_error& worst)
{
  Report::instance().set_context("Seam_mesh");
  Mesh mesh = Generated_mesh<Mesh>(rotated(torus(20, 12), 2)).mesh;
  const auto is_seam_edge = mesh.add_property_map<Edge_index, bool>("e:seam", false).first;
  const auto is_seam_vertex = mesh.add_property_map<Vertex_index, bool>("v:seam", false).first;
  typedef CGAL::Seam_mesh<Mesh, Mesh::Property_map<Edge_index, bool>, Mesh::Property_map<Vertex_index, bool>> Seam_mesh;
  Seam_mesh seam_mesh(mesh, is_seam_edge, is_seam_vertex);
  auto h = *CGAL::halfedges(mesh).first;
  const auto turned = [&](auto g) { return next(opposite(g, mesh), mesh); }; // the next edge at the source of g
  for (int i = 0; i < 6; ++i)
  {
    CHECK(seam_mesh.add_seam(source(h, mesh), target(h, mesh)));
    h = turned(turned(next(h, mesh))); // straight on, the third of six edges
  }

  // the same mesh with copies: a vertex of the seam mesh is a class of halfedges with the same target
  Mesh cut;
  const auto points = get(CGAL::vertex_point, static_cast<const Seam_mesh&>(seam_mesh));
  std::map<typename Seam_mesh::vertex_descriptor, Vertex_index> copy;
  for (const auto v : CGAL::vertices(seam_mesh)) copy[v] = cut.add_vertex(get(points, v));
  std::vector<Face_index> copied_faces;
  for (const auto f : CGAL::faces(seam_mesh))
  {
    std::vector<Vertex_index> corners;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, seam_mesh), seam_mesh)) corners.push_back(copy.at(v));
    copied_faces.push_back(cut.add_face(corners));
  }
  CHECK(cut.number_of_vertices() == mesh.number_of_vertices() + 5);

  Geodesic_on<Seam_mesh> on_seams(seam_mesh);
  Geodesic_on<Mesh> on_copies(cut), uncut(mesh);
  const auto source = *CGAL::vertices(seam_mesh).first;
  on_seams.add_source_point(source);
  on_copies.add_source_point(copy.at(source));
  on_seams.build();
  on_copies.build();
  uncut.add_source_point(target(source.hd, mesh));
  uncut.build();
  double longest_detour = 0;
  for (const auto v : CGAL::vertices(seam_mesh))
  {
    CHECK_CLOSE(worst, on_seams.distance_to_sources(v), on_copies.distance_to_sources(copy.at(v)));
    longest_detour =
      (std::max)(longest_detour, on_seams.distance_to_sources(v) - uncut.distance_to_sources(target(v.hd, mesh)));
  }
  CHECK(longest_detour > 0.01);
}

/// The square of side 1 with opposite sides joined: the nearest of all copies of the source in the plane is straight away.
void flat_torus()
{
  Report::instance().set_context("flat torus");
  constexpr unsigned n = 24;
  Mesh mesh;
  std::vector<Vertex_index> vertices;
  for (unsigned i = 0; i < n * n; ++i) vertices.push_back(mesh.add_vertex(Point_3(0, 0, 0))); // points must not be read
  const auto at = [&](unsigned i, unsigned j) { return vertices[(i % n) * n + j % n]; };
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  const auto length = mesh.add_property_map<Edge_index, double>("e:length").first;
  for (Edge_index e : mesh.edges())
  {
    const unsigned a = mesh.vertex(e, 0).idx(), b = mesh.vertex(e, 1).idx();
    length[e] = std::sqrt((a / n != b / n) + (a % n != b % n)) / n;
  }
  const auto np = CGAL::parameters::edge_length_map(length);
  Worst_error worst(1e-12, 1);
  const auto distance = mesh.add_property_map<Vertex_index, double>("v:distance").first;
  CGAL::geodesic_distances(mesh, at(3, 5), distance, np);
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j)
    {
      const double x = std::min(i, n - i), y = std::min(j, n - j);
      CHECK_CLOSE(worst, distance[at(3 + i, 5 + j)], std::hypot(x, y) / n);
    }

  // offsets by lengths, of half a unit in all: a circle that meets itself nowhere; functions that need points throw
  Geodesic_on<Mesh> geodesic(mesh, np);
  geodesic.add_source_point(at(3, 5));
  std::vector<Geodesic_on<Mesh>::Offset_curve> curves;
  geodesic.build_with_offset_curves(0.3, std::back_inserter(curves), CGAL::parameters::keep_windows(true));
  CHECK(curves.size() == 1 && curves[0].is_closed());
  CHECK_CLOSE(worst, curves[0].length(), 2 * CGAL_PI * 0.3);
  const Geodesic_on<Mesh>::Face_location inside(Face_index(11), {{0.2, 0.3, 0.5}});
  CHECK(std::isfinite(geodesic.distance_to_sources(inside)));
  std::vector<Geodesic_on<Mesh>::Face_location> path;
  geodesic.shortest_path_to_sources(inside, std::back_inserter(path));
  CHECK(path.size() > 2);
  std::vector<Point_3> points;
  std::vector<Edge_index> sharp;
  CHECK_THROWS(curves[0].point(0.1), std::logic_error);
  CHECK_THROWS(geodesic.locate(Point_3(0, 0, 0)), std::logic_error);
  CHECK_THROWS(geodesic.gradient(inside), std::logic_error);
  CHECK_THROWS(geodesic.shortest_path_points_to_sources(inside, std::back_inserter(points)), std::logic_error);
  CHECK_THROWS(geodesic.sharp_edges(30, std::back_inserter(sharp)), std::logic_error);

  // lengths of a face that are not those of a triangle: the message names it
  const auto complaint = [&](Edge_index e, double bad) -> std::string {
    const double good = length[e];
    length[e] = bad;
    std::string text;
    try
    {
      Geodesic_on<Mesh> refused(mesh, np);
    }
    catch (const std::invalid_argument& error)
    {
      text = error.what();
    }
    length[e] = good;
    return text;
  };
  const Face_index f(40);
  const Edge_index e = mesh.edge(mesh.halfedge(f));
  const unsigned other = mesh.face(mesh.opposite(mesh.halfedge(f))).idx();
  const std::string names = "face " + std::to_string(std::min(40u, other)) + ":";
  const double sum = length[mesh.edge(mesh.next(mesh.halfedge(f)))] + length[mesh.edge(mesh.prev(mesh.halfedge(f)))];
  for (const double bad : {5., sum, 0., -length[e], infinity, std::numeric_limits<double>::quiet_NaN()})
    CHECK_DETAIL(complaint(e, bad).find(names) != std::string::npos, std::to_string(bad) + ": " + complaint(e, bad));
  CHECK(complaint(e, 0.99 * sum).empty());
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
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
  typedef Unset_index<Vertex_index> Unset_vertex_index;
  typedef Unset_index<Face_index> Unset_face_index;
  const Mesh mesh = Generated_mesh<Mesh>(icosphere(1)).mesh;
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

} // namespace test_graph_types

GEODESIC_OFFSET_TEST(test_graph_types)
{
  Worst_error worst(1e-13, 1);
  run("torus", rotated(torus(20, 12), 1), worst);
  run("saddle", Cone(8, 3 * CGAL_PI, 1).triangulated(30, 4, 2), worst);
  run("grid", planar_grid(15, 10, Diagonals::alternating), worst);
  expected_distances("genus 5", marching_genus_5(10));
  expected_distances("box", rotated(box_sides(1, 0.7, 0.45).triangulated(40, 4, 1), 1));
  expected_distances("icosphere", icosphere(2));
  unset_indices();
  seams(worst);
  flat_torus();
  return Report::instance().finish("test_graph_types");
}
