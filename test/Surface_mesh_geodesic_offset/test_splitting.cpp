// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes split along offset curves: valid triangle meshes with the surface and topology of the original, new vertices on their
// levels, curves of edges, and bands with the areas that the curves enclose.

#include "data_meshes.h"
#include "generated_meshes.h"
#include "locations.h"
#include "offset_integrals.h"
#include "plane_section.h"
#include "test_check.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace test_splitting {

using namespace test;

typedef std::function<void(Geodesic&)> Add_sources;
typedef Surface_mesh::Face_index Face_index;
typedef Surface_mesh::Edge_index Edge_index;
typedef Surface_mesh::Vertex_index Vertex_index;

struct Totals
{
  std::size_t meshes = 0, located = 0, levels = 0, vertices = 0;
  double off = 0, area = 0, surface = 0; // largest: off the level, of the diagonal; of areas of bands and surface, relative
};
Totals totals;

// Chords, of the diagonal: areas of bands differ by the area between chords and arcs.
constexpr double chord_tolerance = 1e-7;

template <class Mesh>
long euler_characteristic(const Mesh& mesh)
{
  return long(num_vertices(mesh)) - long(num_edges(mesh)) + long(num_faces(mesh));
}

// Levels between 0 and the largest distance; some at those of vertices, on which edges may lie as well.
std::vector<double> levels_of(const Geodesic& geodesic, const Surface_mesh& mesh, Random& random)
{
  const double largest = geodesic.largest_distance();
  std::vector<double> levels;
  for (int i = 0; i < 10; ++i)
  {
    const Vertex_index v(Surface_mesh::size_type(uniform_index(random, mesh.number_of_vertices())));
    const double d = mesh.is_isolated(v) ? 0 : geodesic.distance_to_sources(v);
    levels.push_back(i % 2 == 1 && d > 0 && d < largest ? d : uniform(random, 0.01, 0.99) * largest);
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

// False for surfaces that meet themselves: points in space do not tell the location then.
bool locates_itself(const Geodesic& geodesic, const Surface_mesh& mesh, double tolerance)
{
  for (const Vertex_index v : mesh.vertices())
    if (!mesh.is_isolated(v) &&
        !(std::abs(geodesic.distance_to_sources(geodesic.locate(mesh.point(v))) - geodesic.distance_to_sources(v)) <= tolerance))
      return false;
  return true;
}

void split(const std::string& name, const Surface_mesh& original, const Add_sources& add_sources, Random& random)
{
  Report::instance().set_context(name);
  Geodesic geodesic(original);
  add_sources(geodesic);
  geodesic.build(CGAL::parameters::keep_windows(true));
  const std::vector<double> levels = levels_of(geodesic, original, random);
  Surface_mesh mesh = original;
  Geodesic on_copy(mesh);
  add_sources(on_copy);
  std::vector<Offset_curve> curves;
  on_copy.build_with_offset_curves(levels, std::back_inserter(curves));
  auto distance = mesh.add_property_map<Vertex_index, double>("distance").first;
  on_copy.vertex_distances(distance);

  const auto box = CGAL::Polygon_mesh_processing::bbox(original);
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  const std::size_t old_vertices = mesh.number_of_vertices();
  auto constrained = mesh.add_property_map<Edge_index, bool>("constrained", false).first;
  auto band = mesh.add_property_map<Face_index, std::size_t>("band").first;
  CGAL::split_along_offset_curves(mesh, curves,
                                  CGAL::parameters::edge_is_constrained_map(constrained)
                                    .face_band_map(band)
                                    .vertex_distance_map(distance)
                                    .chord_tolerance(chord_tolerance * diagonal));
  ++totals.meshes;
  totals.levels += levels.size();

  CHECK(CGAL::is_valid_polygon_mesh(mesh) || !CGAL::is_valid_polygon_mesh(original)); // cube-ouvert.off has an unused vertex
  CHECK(CGAL::is_triangle_mesh(mesh));
  CHECK(CGAL::is_closed(mesh) == CGAL::is_closed(original));
  CHECK(euler_characteristic(mesh) == euler_characteristic(original));
  const double area = CGAL::Polygon_mesh_processing::area(mesh), old_area = CGAL::Polygon_mesh_processing::area(original);
  totals.surface = (std::max)(totals.surface, std::abs(area - old_area) / old_area);
  CHECK_DETAIL(std::abs(area - old_area) <= 1e-12 * old_area, values(area, old_area));

  // Each new vertex, and each vertex of a curve, is on a level.
  std::vector<bool> is_on_curve(mesh.number_of_vertices(), false);
  double length = 0, exact_length = 0;
  for (const Edge_index e : mesh.edges())
  {
    if (!constrained[e]) continue;
    is_on_curve[mesh.vertex(e, 0)] = is_on_curve[mesh.vertex(e, 1)] = true;
    length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  }
  for (const Offset_curve& c : curves) exact_length += c.length();
  // two curves may share edges on a ridge
  CHECK_DETAIL(length <= exact_length * (1 + 1e-9) + 1e-8 * diagonal && length >= 0.49 * exact_length, values(length, exact_length));
  const bool is_simple = locates_itself(geodesic, original, 1e-9 * diagonal);
  totals.located += is_simple;
  for (const Vertex_index v : mesh.vertices())
  {
    CHECK(std::size_t(v) < old_vertices || is_on_curve[v]);
    if (!is_on_curve[v] || !is_simple) continue;
    const double d = geodesic.distance_to_sources(geodesic.locate(mesh.point(v)));
    const auto above = std::lower_bound(levels.begin(), levels.end(), d);
    double off = 1e300;
    if (above != levels.end()) off = (std::min)(off, *above - d);
    if (above != levels.begin()) off = (std::min)(off, d - *(above - 1));
    totals.off = (std::max)(totals.off, off / diagonal);
    ++totals.vertices;
    CHECK_DETAIL(off <= 1e-9 * diagonal, "vertex " + std::to_string(v) + " is off its level by " + std::to_string(off / diagonal));
  }

  const double tolerance = 2 * chord_tolerance * diagonal;
  std::vector<double> areas(levels.size() + 1, 0);
  for (const Face_index f : mesh.faces())
  {
    CHECK(band[f] <= levels.size());
    const std::size_t i = (std::min)(band[f], levels.size());
    areas[i] += CGAL::Polygon_mesh_processing::face_area(f, mesh);
    if (!is_simple) continue;
    const auto h = mesh.halfedge(f);
    const Point_3 center =
      CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
    const double d = geodesic.distance_to_sources(geodesic.locate(center));
    CHECK_DETAIL((i == 0 || d >= levels[i - 1] - tolerance) && (i == levels.size() || d <= levels[i] + tolerance),
                 "face " + std::to_string(f) + " of band " + std::to_string(i) + " is at distance " + std::to_string(d));
  }
  // The integrals need levels that do not pass through vertices.
  Offset_integrals integrals(geodesic, original);
  double nearer = 0;
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    nearer += areas[i];
    const auto& at_vertices = integrals.vertex_distances();
    const auto next = std::lower_bound(at_vertices.begin(), at_vertices.end(), levels[i] - 1e-9 * diagonal);
    if (next != at_vertices.end() && *next <= levels[i] + 1e-9 * diagonal) continue;
    const double expected = integrals.measure(levels[i]).area();
    totals.area = (std::max)(totals.area, std::abs(nearer - expected) / old_area);
    CHECK_DETAIL(std::abs(nearer - expected) <= 1e-6 * old_area, "level " + std::to_string(i) + ": " + values(nearer, expected));
  }
}

void split_from_all(const std::string& name, const Surface_mesh& mesh, unsigned seed)
{
  Random random(seed);
  const auto sections = random_plane_section(mesh, 2);
  const auto vertex = *mesh.vertices().begin();
  split(name + ", vertex", mesh, [&](Geodesic& g) { g.add_source_point(vertex); }, random);
  if (!sections.empty() && sections[0].locations.size() > 2)
    split(name + ", section", mesh, [&](Geodesic& g) {
      for (const auto& s : sections) g.add_source_polyline(s.locations, s.closed);
    }, random);
  if (!CGAL::is_closed(mesh))
    split(name + ", boundary", mesh, [&](Geodesic& g) { 
      for (const auto& cycle : g.mesh().boundary_edges()) g.add_source_edges(cycle);
    }, random);
}

void generated_meshes()
{
  const std::pair<const char*, Soup> soups[] = {{"torus", torus(14, 10)},
                                                {"icosphere", icosphere(2)},
                                                {"cube", cube_grid(4)},
                                                {"grid", planar_grid(8, 6)},
                                                {"needles", random_rectangle(1, 0.01, 60, 4, 3)},
                                                {"tiny faces", marching_sphere(6)},
                                                {"cone of 1.5 turns", Cone(8, 3 * CGAL_PI, 1).triangulated(25, 4, 5)},
                                                {"jittered grid", jittered_grid(12, 9, 7)}};
  unsigned seed = 0;
  for (const auto& soup : soups) split_from_all(soup.first, Generated_mesh<Surface_mesh>(soup.second).mesh, ++seed);
}

void data_meshes()
{
  for (const auto& file : data_files())
  {
    Surface_mesh mesh;
    if (read_data_mesh(file, 1500, mesh).empty()) split_from_all(file.filename().string(), mesh, 1);
  }
}

// The inner squares of a square, with the level at the middles of edges: all chords are edges of the result.
void squares()
{
  Report::instance().set_context("squares");
  Surface_mesh mesh = Generated_mesh<Surface_mesh>(planar_grid(4, 4)).mesh;
  std::vector<CGAL::Geodesic_offset_curve_type<Surface_mesh>> curves;
  Geodesic geodesic(mesh);
  for (const auto& cycle : geodesic.mesh().boundary_edges()) geodesic.add_source_edges(cycle);
  geodesic.build_with_offset_curves(std::vector<double>{0.5, 1, 1.5}, std::back_inserter(curves));
  auto constrained = mesh.add_property_map<Edge_index, bool>("constrained", false).first;
  auto band = mesh.add_property_map<Face_index, std::size_t>("band").first;
  CGAL::split_along_offset_curves(mesh, curves, CGAL::parameters::face_band_map(band).edge_is_constrained_map(constrained));
  double length = 0;
  for (const Edge_index e : mesh.edges())
    if (constrained[e]) length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  CHECK_DETAIL(std::abs(length - (12 + 8 + 4)) <= 1e-9, values(length, 24));
  double areas[4] = {};
  for (const Face_index f : mesh.faces()) areas[band[f]] += CGAL::Polygon_mesh_processing::face_area(f, mesh);
  const double expected[] = {7, 5, 3, 1};
  for (int i = 0; i < 4; ++i) CHECK_DETAIL(std::abs(areas[i] - expected[i]) <= 1e-9, values(areas[i], expected[i]));
  // the level along edges of the grid inserts no vertex beside those of the grid
  for (const auto v : mesh.vertices())
    for (const auto w : mesh.vertices()) CHECK(v == w || CGAL::squared_distance(mesh.point(v), mesh.point(w)) > 1e-6);
}

// The same split of a Polyhedron_3; components without curves; bad parameters leave the mesh as it was.
void other_meshes()
{
  Report::instance().set_context("polyhedron");
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  Soup two = cube_grid(2);
  const std::size_t n = two.points.size();
  const Soup other = icosphere(0);
  for (const Point_3& p : other.points) two.points.push_back(p + Vector_3(10, 0, 0));
  for (const auto& t : other.triangles) two.add_triangle({t[0] + n, t[1] + n, t[2] + n});
  const Generated_mesh<Polyhedron> data(two);
  Polyhedron mesh = data.mesh;
  std::vector<CGAL::Geodesic_offset_curve_type<Polyhedron>> curves;
  CGAL::geodesic_offset_curves(mesh, std::vector<Polyhedron::Vertex_handle>{*vertices(mesh).first}, std::vector<double>{0.4, 0.9},
                               std::back_inserter(curves));
  const std::size_t before = num_faces(mesh);
  CHECK_THROWS(CGAL::split_along_offset_curves(mesh, curves, CGAL::parameters::chord_tolerance(0.)), std::invalid_argument);
  CHECK_THROWS(CGAL::split_along_offset_curves(mesh, curves, CGAL::parameters::chord_tolerance(1e-300)), std::length_error);
  CHECK(num_faces(mesh) == before);
  auto distance = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  CGAL::geodesic_distances(mesh, std::vector<Polyhedron::Vertex_handle>{*vertices(mesh).first}, distance);
  auto band = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  CGAL::split_along_offset_curves(mesh, curves, CGAL::parameters::face_band_map(band).vertex_distance_map(distance));
  CHECK(num_faces(mesh) > before);
  CHECK(CGAL::is_valid_polygon_mesh(mesh) && CGAL::is_triangle_mesh(mesh) && CGAL::is_closed(mesh));
  double areas[3] = {};
  for (const auto f : faces(mesh)) areas[get(band, f)] += CGAL::Polygon_mesh_processing::face_area(f, mesh);
  CHECK(areas[0] > 0 && areas[1] > 0);
  // the other component is unreachable, so it is beyond all distances
  CHECK(areas[2] > CGAL::Polygon_mesh_processing::area(Generated_mesh<Surface_mesh>(other).mesh));

  const std::size_t after = num_faces(mesh);
  CGAL::split_along_offset_curves(mesh, std::vector<CGAL::Geodesic_offset_curve_type<Polyhedron>>());
  CHECK(num_faces(mesh) == after);
}

} // namespace test_splitting

GEODESIC_OFFSET_TEST(test_splitting)
{
  const std::pair<const char*, void (*)()> tests[] = {
    {"generated meshes", generated_meshes}, {"squares", squares}, {"other meshes", other_meshes}, {data_case, data_meshes}};
  const int result = run_tests("test_splitting", tests);
  std::cout.precision(3);
  std::cout << totals.meshes << " meshes, " << totals.located << " of them checked by locations, split along " << totals.levels << " levels; " << totals.vertices
            << " vertices on curves, off by at most " << totals.off << " of the diagonal; areas of bands off by at most "
            << totals.area << ", of surfaces by " << totals.surface << std::endl;
  return result;
}
