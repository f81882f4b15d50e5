// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes split along offset curves: valid triangle meshes with the surface and topology of the original, new vertices on their
// levels, curves of edges, bands with the areas that the curves enclose, the nearest sources of faces, and calls of the visitor.

#include "offset_integrals.h"
#include "query_cases.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <iostream>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_splitting {

using namespace test;

typedef Surface_mesh::Face_index Face_index;
typedef Surface_mesh::Edge_index Edge_index;
typedef Surface_mesh::Vertex_index Vertex_index;

struct Totals
{
  std::size_t meshes = 0, splits = 0, located = 0, levels = 0, at_vertices = 0, on_edges = 0, vertices = 0;
  std::size_t polylines = 0, sections = 0, boundaries = 0;
  // largest: off the level, of the diagonal; of areas of bands, of the surface and of the band; of the surface
  double off = 0, area = 0, of_band = 0, surface = 0;
};
Totals totals;

// Bands that are larger than this part of the surface have the areas that the curves enclose, up to this part of them.
// The smaller the bands, the more chords.
const double compared_bands = number_of_cases(0.1, 0.01);
constexpr double area_tolerance = 1e-6;

template <class Mesh>
long euler_characteristic(const Mesh& mesh)
{
  return long(num_vertices(mesh)) - long(num_edges(mesh)) + long(num_faces(mesh));
}

// Ten levels between 0 and the largest distance: if there are such, two at which an edge lies, and three at those of vertices.
std::vector<double> levels_of(const Geodesic& geodesic, const Surface_mesh& mesh, Random& random)
{
  const double largest = geodesic.largest_distance().value();
  const auto is_inside = [&](double d) { return d > 0.01 * largest && d < 0.99 * largest; };
  std::vector<double> levels, on_edges;
  for (const Edge_index e : mesh.edges())
  {
    const double d = geodesic.distance_to_sources(mesh.vertex(e, 0));
    if (!is_inside(d) || std::abs(geodesic.distance_to_sources(mesh.vertex(e, 1)) - d) > 1e-14 * largest) continue;
    const auto h = mesh.is_border(mesh.halfedge(e)) ? mesh.opposite(mesh.halfedge(e)) : mesh.halfedge(e);
    if (std::abs(geodesic.distance_to_sources(Locations<Surface_mesh>(mesh).on_edge(h, 0.4)) - d) <= 1e-14 * largest)
      on_edges.push_back(d);
  }
  for (std::size_t i = 0; i < 2 && !on_edges.empty(); ++i) levels.push_back(on_edges[uniform_index(random, on_edges.size())]);
  totals.on_edges += levels.size();
  for (int i = 0; i < 3; ++i)
  {
    const Vertex_index v(Surface_mesh::size_type(uniform_index(random, mesh.number_of_vertices())));
    const double d = mesh.is_isolated(v) ? 0 : geodesic.distance_to_sources(v);
    if (!is_inside(d)) continue;
    levels.push_back(d);
    ++totals.at_vertices;
  }
  while (levels.size() < 10) levels.push_back(uniform(random, 0.01, 0.99) * largest);
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

// False for surfaces that meet themselves: points in space do not tell the location then.
bool locates_itself(const Geodesic& geodesic, const Surface_mesh& mesh, double tolerance)
{
  for (const Vertex_index v : mesh.vertices())
    if (!mesh.is_isolated(v) && !(std::abs(geodesic.distance_to_sources(geodesic.locate(mesh.point(v))) -
                                           geodesic.distance_to_sources(v)) <= tolerance))
      return false;
  return true;
}

struct Nearer
{
  double area, length; // of the points nearer than a level, and of its curves
};

// The integrals need levels that do not pass through vertices; the area between such a level and the given one is the length times
// the distance of the levels, up to 1e-15 of the surface.
Nearer nearer_than(double level, Offset_integrals& integrals, double diagonal)
{
  double beside = level;
  const auto& at_vertices = integrals.vertex_distances();
  for (auto v = std::upper_bound(at_vertices.begin(), at_vertices.end(), level + 1e-9 * diagonal);
       v != at_vertices.begin() && *--v > beside - 1e-9 * diagonal;)
    beside = *v - 2e-9 * diagonal;
  const Level_measure measure = integrals.measure(beside);
  return {measure.area() + measure.length * (level - beside), measure.length};
}

// The areas between chords of this tolerance and their arcs are at most 2/3 of it times the length: half of what the bands may be
// off.
double chord_tolerance_for(const std::vector<Nearer>& nearer, double surface, double diagonal)
{
  double result = 1e-7 * diagonal;
  for (std::size_t i = 0; i < nearer.size(); ++i)
  {
    const double band = nearer[i].area - (i == 0 ? 0 : nearer[i - 1].area);
    const double length = nearer[i].length + (i == 0 ? 0 : nearer[i - 1].length);
    if (band > compared_bands * surface) result = (std::min)(result, 0.75 * area_tolerance * band / length);
  }
  return result;
}

void split(const std::string& name, const Surface_mesh& original, const std::vector<Source>& sources, Random& random)
{
  Report::instance().set_context(name);
  const Geodesic geodesic = built(original, sources);
  const std::vector<double> levels = levels_of(geodesic, original, random);
  const double diagonal = bounding_box_diagonal(original), old_area = CGAL::Polygon_mesh_processing::area(original);
  Offset_integrals integrals(geodesic, original);
  std::vector<Nearer> expected;
  for (const double l : levels) expected.push_back(nearer_than(l, integrals, diagonal));
  const double chord_tolerance = chord_tolerance_for(expected, old_area, diagonal);
  Surface_mesh mesh = original;
  Geodesic on_copy(mesh);
  on_copy.add_sources(source_set(sources));
  std::vector<Offset_curve> curves;
  on_copy.build_with_offset_curves(levels, std::back_inserter(curves));
  auto distance = mesh.add_property_map<Vertex_index, double>("distance").first;
  on_copy.vertex_distances(distance);

  const std::size_t old_vertices = mesh.number_of_vertices();
  auto constrained = mesh.add_property_map<Edge_index, bool>("constrained", false).first;
  auto band = mesh.add_property_map<Face_index, std::size_t>("band").first;
  CGAL::split_along_offset_curves(mesh, curves,
                                  CGAL::parameters::edge_is_constrained_map(constrained)
                                    .face_band_map(band)
                                    .vertex_distance_map(distance)
                                    .chord_tolerance(chord_tolerance));
  ++totals.splits;
  totals.levels += levels.size();

  CHECK(CGAL::is_valid_polygon_mesh(mesh) || !CGAL::is_valid_polygon_mesh(original)); // cube-ouvert.off has an unused vertex
  CHECK(CGAL::is_triangle_mesh(mesh));
  CHECK(CGAL::is_closed(mesh) == CGAL::is_closed(original));
  CHECK(euler_characteristic(mesh) == euler_characteristic(original));
  const double area = CGAL::Polygon_mesh_processing::area(mesh);
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
  CHECK_DETAIL(length <= exact_length * (1 + 1e-9) + 1e-8 * diagonal && length >= 0.49 * exact_length,
               values(length, exact_length));
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
    CHECK_DETAIL(off <= 1e-9 * diagonal,
                 "vertex " + std::to_string(v) + " is off its level by " + std::to_string(off / diagonal));
  }

  const double tolerance = 2 * chord_tolerance + 1e-9 * diagonal;
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
  double nearer = 0;
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    nearer += areas[i];
    const double band = expected[i].area - (i == 0 ? 0 : expected[i - 1].area), off = std::abs(areas[i] - band);
    totals.area = (std::max)({totals.area, std::abs(nearer - expected[i].area) / old_area, off / old_area});
    if (band > compared_bands * old_area) totals.of_band = (std::max)(totals.of_band, off / band);
    CHECK_DETAIL(std::abs(nearer - expected[i].area) <= area_tolerance * old_area &&
                   off <= area_tolerance * (std::max)(band, compared_bands * old_area),
                 "level " + std::to_string(i) + ": " + values(nearer, expected[i].area) + "; band " + values(areas[i], band));
  }
}

// Through neighbouring faces, with corners inside and on edges.
std::vector<Geodesic::Face_location> random_polyline(const Surface_mesh& mesh, Random& random)
{
  const Locations<Surface_mesh> on_mesh(mesh);
  Face_index f(Surface_mesh::size_type(uniform_index(random, mesh.number_of_faces())));
  std::vector<Geodesic::Face_location> result = {{f, random_barycentric(random)}};
  for (int i = 0; i < 8; ++i)
  {
    auto h = mesh.halfedge(f);
    for (std::size_t k = uniform_index(random, 3); k > 0; --k) h = mesh.next(h);
    if (mesh.is_border(mesh.opposite(h))) continue;
    result.push_back(on_mesh.on_edge(h, uniform(random, 0.1, 0.9)));
    f = mesh.face(mesh.opposite(h));
    result.push_back({f, random_barycentric(random)});
  }
  return result;
}

void split_from_all(const Query_case& c, unsigned seed)
{
  Random random(seed);
  ++totals.meshes;
  split(c.name + ", vertex", c.mesh, {point_source(*c.mesh.vertices().begin())}, random);
  const auto polyline = random_polyline(c.mesh, random);
  if (polyline.size() > 1)
  {
    ++totals.polylines;
    split(c.name + ", polyline", c.mesh, {polyline_source(polyline)}, random);
  }
  std::vector<Source> sections, boundary;
  for (const auto& s : random_plane_section(c.mesh, 2)) sections.push_back(polyline_source(s.locations, s.closed));
  if (!sections.empty() && sections[0].locations.size() > 2)
  {
    ++totals.sections;
    split(c.name + ", section", c.mesh, sections, random);
  }
  for (const auto& cycle : Geodesic::Mesh(c.mesh).boundary_edges()) boundary.push_back(edge_source(cycle));
  if (!boundary.empty())
  {
    ++totals.boundaries;
    split(c.name + ", boundary", c.mesh, boundary, random);
  }
}

void generated_meshes()
{
  unsigned seed = 0;
  for_each_mesh({"torus", "icosphere", "cube", "grid", "needles", "tiny faces", "saddle", "jittered grid"}, {},
                [&](const Query_case& c) { split_from_all(c, ++seed); });
}

void data_meshes()
{
  std::size_t readable = 0;
  for_each_mesh(
    {}, data_mesh_names(),
    [&](const Query_case& c) {
      if (readable++ % number_of_cases(3, 1) == 0) split_from_all(c, 1);
    },
    1500);
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
    if (constrained[e])
      length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  CHECK_DETAIL(std::abs(length - (12 + 8 + 4)) <= 1e-9, values(length, 24));
  double areas[4] = {};
  for (const Face_index f : mesh.faces()) areas[band[f]] += CGAL::Polygon_mesh_processing::face_area(f, mesh);
  const double expected[] = {7, 5, 3, 1};
  for (int i = 0; i < 4; ++i) CHECK_DETAIL(std::abs(areas[i] - expected[i]) <= 1e-9, values(areas[i], expected[i]));
  // the level along edges of the grid inserts no vertex beside those of the grid
  for (const auto v : mesh.vertices())
    for (const auto w : mesh.vertices()) CHECK(v == w || CGAL::squared_distance(mesh.point(v), mesh.point(w)) > 1e-6);
}

// Counts what a visitor hears of, and gives each new face the value of the face of which it is a part.
struct Counts
{
  std::size_t split_edges = 0, edge_vertices = 0, vertices = 0, split_faces = 0, new_faces = 0;
  bool in_edge = false, in_face = false, in_creation = false;
};
struct Visitor : CGAL::Default_offset_splitting_visitor<Surface_mesh>
{
  Counts& counts;
  Surface_mesh::Property_map<Face_index, std::size_t> parent;
  Face_index split_face;
  halfedge_descriptor split_halfedge;

  Visitor(Counts& c, const Surface_mesh::Property_map<Face_index, std::size_t>& p) : counts(c), parent(p) {}

  void before_edge_split(halfedge_descriptor h, Surface_mesh&)
  {
    CHECK(!counts.in_edge && counts.split_faces == 0);
    counts.in_edge = true;
    split_halfedge = h;
    ++counts.split_edges;
  }
  void edge_split(halfedge_descriptor h, Surface_mesh& mesh)
  {
    CHECK(counts.in_edge && mesh.next(h) == split_halfedge && std::size_t(mesh.target(h)) + 1 == mesh.number_of_vertices());
    ++counts.edge_vertices;
  }
  void after_edge_split()
  {
    CHECK(counts.in_edge);
    counts.in_edge = false;
  }
  void new_vertex_added(vertex_descriptor v, Surface_mesh& mesh)
  {
    CHECK(counts.in_edge != counts.in_face && std::size_t(v) + 1 == mesh.number_of_vertices());
    CHECK(mesh.point(v) != Point_3(0, 0, 0)); // outside all meshes of this test
    ++counts.vertices;
  }
  void before_subface_creations(face_descriptor f, Surface_mesh&)
  {
    CHECK(!counts.in_face && !counts.in_edge);
    counts.in_face = true;
    split_face = f;
    ++counts.split_faces;
  }
  void before_subface_created(Surface_mesh&)
  {
    CHECK(counts.in_face && !counts.in_creation);
    counts.in_creation = true;
  }
  void after_subface_created(face_descriptor f, Surface_mesh& mesh)
  {
    CHECK(counts.in_creation && std::size_t(f) + 1 == mesh.number_of_faces());
    counts.in_creation = false;
    parent[f] = parent[split_face];
    ++counts.new_faces;
  }
  void after_subface_creations(Surface_mesh&)
  {
    CHECK(counts.in_face && !counts.in_creation);
    counts.in_face = false;
  }
};

// From several sources: the source of a face is nearest to its centroid, by a field of each source alone. The parts of a face have
// its area.
void sources_and_visitor()
{
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    Report::instance().set_context("sources, seed " + std::to_string(seed));
    Random random(seed);
    Surface_mesh mesh = Generated_mesh<Surface_mesh>(seed % 2 == 0 ? icosphere(2) : torus(14, 10)).mesh;
    const Surface_mesh original = mesh;
    const double diagonal = bounding_box_diagonal(mesh);
    Geodesic all(mesh);
    std::deque<Geodesic> alone; // on the original, since the mesh changes
    const auto add = [&](const auto& add_source) {
      CHECK(add_source(all) == alone.size());
      alone.emplace_back(original);
      add_source(alone.back());
      alone.back().build(CGAL::parameters::keep_windows(true));
    };
    for (int i = 0; i < 4; ++i)
    {
      const Vertex_index v(Surface_mesh::size_type(uniform_index(random, mesh.number_of_vertices())));
      add([&](Geodesic& g) { return g.add_source_point(v); });
    }
    const auto polyline = random_polyline(mesh, random);
    add([&](Geodesic& g) { return g.add_source_polyline(polyline); });
    const auto field = all.build(CGAL::parameters::keep_windows(true));
    std::vector<Offset_curve> curves;
    all.offset_curves(std::vector<double>{0.3 * all.largest_distance().value(), 0.7 * all.largest_distance().value()},
                      std::back_inserter(curves));

    auto source = mesh.add_property_map<Face_index, std::size_t>("source", 99).first;
    auto parent = mesh.add_property_map<Face_index, std::size_t>("parent").first;
    for (const Face_index f : mesh.faces()) parent[f] = std::size_t(f);
    Counts counts;
    const auto without_windows = Geodesic(all).build();
    CHECK_THROWS(CGAL::split_along_offset_curves(mesh, curves,
                                                 CGAL::parameters::face_source_map(source).distance_field(without_windows)),
                 std::logic_error);
    CHECK(mesh.number_of_faces() == original.number_of_faces());
    CGAL::split_along_offset_curves(
      mesh, curves, CGAL::parameters::face_source_map(source).distance_field(field).visitor(Visitor(counts, parent)));

    CHECK(counts.vertices == mesh.number_of_vertices() - original.number_of_vertices());
    CHECK(counts.new_faces == mesh.number_of_faces() - original.number_of_faces());
    CHECK(counts.split_edges > 50 && counts.edge_vertices >= counts.split_edges && counts.vertices > counts.edge_vertices);
    CHECK(counts.split_faces > 50 && !counts.in_edge && !counts.in_face);
    std::vector<double> areas(original.number_of_faces(), 0);
    std::vector<std::size_t> faces_of(alone.size(), 0);
    for (const Face_index f : mesh.faces())
    {
      areas[parent[f]] += CGAL::Polygon_mesh_processing::face_area(f, mesh);
      if (!CHECK(source[f] < alone.size())) continue;
      ++faces_of[source[f]];
      const auto h = mesh.halfedge(f);
      const auto center = alone[0].locate(CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                                         mesh.point(mesh.target(mesh.next(h)))));
      double nearest = infinity;
      for (const Geodesic& g : alone) nearest = (std::min)(nearest, g.distance_to_sources(center));
      CHECK(alone[source[f]].distance_to_sources(center) <= nearest + 1e-9 * diagonal);
    }
    for (const Face_index f : original.faces())
      CHECK(std::abs(areas[f] - CGAL::Polygon_mesh_processing::face_area(f, original)) <= 1e-12 * diagonal * diagonal);
    CHECK(std::count(faces_of.begin(), faces_of.end(), 0) <= 1);
  }
}

// Splits a square along circles: all vertices are on their level and all bands are right, in both orders of the curves. Levels
// nearer than 2^-31 of the diagonal are one level. Returns the number of vertices. `is_accurate`: no faces are so thin that the
// distances on the result are not.
std::size_t split_along_circles(const std::vector<double>& levels, double chord_tolerance, std::size_t number_of_bands,
                                bool is_accurate)
{
  const double rounding = 2e-9;
  Surface_mesh original = Generated_mesh<Surface_mesh>(planar_grid(2, 2)).mesh; // of size 2
  const Geodesic geodesic = built(original, {point_source(Vertex_index(4))});
  const Point_3 center = original.point(Vertex_index(4));
  std::vector<Geodesic::Offset_curve> curves;
  geodesic.offset_curves(levels, std::back_inserter(curves));
  std::size_t faces_before = 0, number_of_vertices = 0;
  for (const bool is_reversed : {false, true})
  {
    if (is_reversed) std::reverse(curves.begin(), curves.end());
    Surface_mesh mesh = original;
    auto band = mesh.add_property_map<Face_index, std::size_t>("band", 99).first;
    CGAL::split_along_offset_curves(mesh, curves, CGAL::parameters::face_band_map(band).chord_tolerance(chord_tolerance));
    const auto distance = [&](Vertex_index v) { return std::sqrt((mesh.point(v) - center).squared_length()); };
    for (const Vertex_index v : mesh.vertices())
    {
      const double d = distance(v);
      const auto is_level = [&](double level) { return std::abs(d - level) <= rounding; };
      CHECK_DETAIL(original.has_valid_index(v) || std::any_of(levels.begin(), levels.end(), is_level), std::to_string(d));
    }
    std::set<std::size_t> bands;
    for (const Face_index f : mesh.faces())
    {
      bands.insert(band[f]);
      for (const Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      {
        const double d = distance(v);
        CHECK_DETAIL((band[f] == 0 || d >= levels[band[f] - 1] - rounding) &&
                       (band[f] == levels.size() || d <= levels[band[f]] + rounding),
                     std::to_string(band[f]) + ": " + std::to_string(d));
      }
    }
    CHECK_DETAIL(bands.size() == number_of_bands, std::to_string(bands.size()));
    if (is_reversed) CHECK(mesh.number_of_faces() == faces_before);
    faces_before = mesh.number_of_faces();
    number_of_vertices = mesh.number_of_vertices();
    if (!is_accurate) continue;
    const Geodesic again = built(mesh, {point_source(Vertex_index(4))}, false);
    for (const Vertex_index v : mesh.vertices()) CHECK(std::abs(again.distance_to_sources(v) - distance(v)) <= 1e-9);
  }
  return number_of_vertices;
}

// Circles that are much closer to each other than the chord tolerance: their chords do not cross.
void close_levels()
{
  const double radius = 0.6, least_gap = std::sqrt(8.) / 2147483648.;
  for (const double gap : {1e-16, 1e-13, 4e-10, 3e-9, 1e-8, 1e-6, 1e-4})
    for (const double chord_tolerance : {5e-2, 5e-3, 3e-4})
    {
      Report::instance().set_context("gap " + std::to_string(gap * 1e9) + "e-9, tolerance " + std::to_string(chord_tolerance));
      split_along_circles({radius, radius + gap, radius + 2 * gap}, chord_tolerance, gap < least_gap ? 2 : 4,
                          gap < least_gap || gap >= 1e-6);
    }
  // Distances up to the least gap have no curves; the faces are beyond them.
  Report::instance().set_context("distances near 0");
  CHECK(split_along_circles({1e-13, 1e-9}, 1e-3, 1, true) == 9);
  // Many levels within the tolerance: few points are needed for all of them.
  Report::instance().set_context("many levels");
  std::vector<double> levels;
  for (int i = 0; i < 100; ++i) levels.push_back(0.5 + 1e-5 * i);
  const std::size_t alone = split_along_circles({levels[0]}, 1e-2, 2, true) - 9;
  const std::size_t all = split_along_circles(levels, 1e-2, levels.size() + 1, true) - 9;
  CHECK_DETAIL(all <= 2 * levels.size() * alone, std::to_string(all) + " vertices, alone " + std::to_string(alone));
}

// Levels whose curves shrink to points at the farthest vertices, or to a polyline along both sides of a source, leave the bands as
// they are.
void levels_without_width()
{
  for (std::size_t i = 0; i < 9; ++i)
  {
    Surface_mesh mesh = Generated_mesh<Surface_mesh>(planar_grid(2, 2)).mesh;
    const Geodesic geodesic = built(mesh, {point_source(Vertex_index(Surface_mesh::size_type(i)))});
    auto distance = mesh.add_property_map<Vertex_index, double>("distance").first;
    geodesic.vertex_distances(distance);
    std::vector<Geodesic::Offset_curve> curves;
    geodesic.offset_curves(std::vector<double>{geodesic.largest_distance().value() * (1 - 1e-11)}, std::back_inserter(curves));
    CHECK(!curves.empty());
    auto band = mesh.add_property_map<Face_index, std::size_t>("band", 99).first;
    CGAL::split_along_offset_curves(mesh, curves, CGAL::parameters::face_band_map(band).vertex_distance_map(distance));
    for (const Face_index f : mesh.faces()) CHECK_DETAIL(band[f] == 0, std::to_string(i) + ": " + std::to_string(band[f]));
  }
  const double start_value = 0.25;
  { // a strip inside a face
    Surface_mesh mesh = Generated_mesh<Surface_mesh>(planar_grid(2, 2)).mesh;
    Geodesic geodesic(mesh);
    const Face_index f(2);
    geodesic.add_source_polyline(std::vector<Geodesic::Face_location>{{f, {{0.2, 0.2, 0.6}}}, {f, {{0.5, 0.3, 0.2}}}},
                                 CGAL::parameters::start_value(start_value));
    geodesic.build();
    std::vector<Geodesic::Offset_curve> curves;
    geodesic.offset_curves(std::vector<double>{start_value * (1 + 1e-10)}, std::back_inserter(curves));
    CHECK(!curves.empty());
    auto distance = mesh.add_property_map<Vertex_index, double>("distance").first;
    geodesic.vertex_distances(distance);
    auto band = mesh.add_property_map<Face_index, std::size_t>("band", 99).first;
    CGAL::split_along_offset_curves(mesh, curves, CGAL::parameters::face_band_map(band).vertex_distance_map(distance));
    for (const Face_index g : mesh.faces()) CHECK_DETAIL(band[g] == 1, std::to_string(band[g]));
    CHECK(mesh.number_of_vertices() == 9 + 2); // the ends of the source
  }
  for (const bool has_second_level : {false, true})
  {
    Surface_mesh mesh = Generated_mesh<Surface_mesh>(planar_grid(2, 2)).mesh;
    Geodesic geodesic(mesh);
    std::vector<Geodesic::Face_location> row; // through the center
    for (const Surface_mesh::size_type v : {3u, 4u, 5u})
      row.push_back(Locations<Surface_mesh>(mesh).at_vertex(Vertex_index(v)));
    geodesic.add_source_polyline(row, CGAL::parameters::start_value(start_value));
    geodesic.build(CGAL::parameters::keep_windows(true));
    std::vector<double> levels = {start_value * (1 + 1e-11)};
    if (has_second_level) levels.push_back(start_value + 0.5);
    std::vector<Geodesic::Offset_curve> curves;
    geodesic.offset_curves(levels, std::back_inserter(curves));
    auto distance = mesh.add_property_map<Vertex_index, double>("distance").first;
    geodesic.vertex_distances(distance);
    auto band = mesh.add_property_map<Face_index, std::size_t>("band", 99).first;
    CGAL::split_along_offset_curves(mesh, curves, CGAL::parameters::face_band_map(band).vertex_distance_map(distance));
    const double middle = mesh.point(Vertex_index(4)).y();
    for (const Face_index f : mesh.faces())
    {
      double farthest = 0;
      for (const Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
        farthest = (std::max)(farthest, std::abs(mesh.point(v).y() - middle));
      CHECK_DETAIL(band[f] == (has_second_level && farthest > 0.6 ? 2u : 1u), std::to_string(band[f]));
    }
  }
}

// A circle that touches an edge of two equilateral triangles in the plane, up to rounding: no chord is farther from it than the
// tolerance, also not beside the points that are left out as they are on the edge.
void touching_level()
{
  const double height = std::sqrt(0.75);
  for (const double error : {-1e-8, -1e-10, -1e-12, 0., 1e-13, 1e-11, 1e-9})
    for (const double tolerance : {4e-2, 2e-2, 1e-3, 3e-4, 1e-5})
    {
      Surface_mesh mesh;
      std::vector<Vertex_index> v;
      for (const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, height, 0), Point_3(1.5, height, 0)})
        v.push_back(mesh.add_vertex(p));
      mesh.add_face(v[0], v[1], v[2]);
      mesh.add_face(v[1], v[3], v[2]);
      const double level = height * (1 + error);
      std::vector<Geodesic::Offset_curve> curves;
      CGAL::geodesic_offset_curves(mesh, std::vector<Vertex_index>{v[0]}, level, std::back_inserter(curves));
      auto distance = mesh.add_property_map<Vertex_index, double>("distance").first;
      CGAL::geodesic_distances(mesh, std::vector<Vertex_index>{v[0]}, distance);
      auto band = mesh.add_property_map<Face_index, std::size_t>("band", 99).first;
      CGAL::split_along_offset_curves(
        mesh, curves, CGAL::parameters::chord_tolerance(tolerance).face_band_map(band).vertex_distance_map(distance));
      for (const Face_index f : mesh.faces())
      {
        std::vector<Point_3> p;
        for (const Vertex_index u : mesh.vertices_around_face(mesh.halfedge(f))) p.push_back(mesh.point(u));
        double least = 10, most = 0;
        for (int i = 0; i <= 20; ++i)
          for (int j = 0; i + j <= 20; ++j)
          {
            const double d = std::sqrt((CGAL::barycenter(p[0], i, p[1], j, p[2], 20 - i - j) - CGAL::ORIGIN).squared_length());
            least = (std::min)(least, d);
            most = (std::max)(most, d);
          }
        CHECK_DETAIL(band[f] == 0 ? most <= level + 1e-9 : least >= level - 1.0001 * tolerance,
                     std::to_string((level - least) / tolerance));
      }
    }
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
  CGAL::geodesic_offset_curves(mesh, std::vector<Polyhedron::Vertex_handle>{*vertices(mesh).first},
                               std::vector<double>{0.4, 0.9}, std::back_inserter(curves));
  const std::size_t before = num_faces(mesh);
  CHECK_THROWS(CGAL::split_along_offset_curves(mesh, curves, CGAL::parameters::chord_tolerance(0.)), std::invalid_argument);
  CHECK_THROWS(CGAL::split_along_offset_curves(mesh, curves, CGAL::parameters::chord_tolerance(1e-300)), std::length_error);
  const std::size_t most_chords = 20000000;
  const auto chords = [](const auto& some, double tolerance) {
    std::size_t n = 0;
    for (const auto& c : some)
      for (const auto& piece : c.pieces()) n += piece.number_of_chords(tolerance);
    return n;
  };
  double fine = 1e-8;
  while (chords(curves, fine) <= most_chords) fine /= 1.5;
  for (const auto& c : curves) CHECK(chords(std::vector<CGAL::Geodesic_offset_curve_type<Polyhedron>>{c}, fine) < most_chords);
  CHECK_THROWS(CGAL::split_along_offset_curves(mesh, curves, CGAL::parameters::chord_tolerance(fine)), std::length_error);
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
    {"generated meshes", generated_meshes},
    {"squares", squares},
    {"sources and visitor", sources_and_visitor},
    {"close levels", close_levels},
    {"levels without width", levels_without_width},
    {"touching level", touching_level},
    {"other meshes", other_meshes},
    {data_case, data_meshes}};
  const int result = run_tests("test_splitting", tests);
  std::cout.precision(3);
  std::cout << totals.meshes << " meshes, " << totals.splits << " splits (" << totals.polylines << " from polylines, "
            << totals.sections << " from sections, " << totals.boundaries << " from boundaries), " << totals.located
            << " of them checked by locations, " << totals.levels << " levels, " << totals.at_vertices << " at vertices, "
            << totals.on_edges << " along edges; " << totals.vertices << " vertices on curves, off by at most " << totals.off
            << " of the diagonal; areas of bands off by at most " << totals.area << " of the surface, by " << totals.of_band
            << " of bands above " << compared_bands << " of it; areas of surfaces by " << totals.surface << std::endl;
  return result;
}
