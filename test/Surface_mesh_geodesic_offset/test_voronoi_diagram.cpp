// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams on boxes and cones in closed form; on other meshes, the points of bisectors, vertices of the diagram, faces that
// no curve crosses and cells of split meshes against the distances from single sources; sources that tie; bad input.

#include "data_meshes.h"
#include "generated_meshes.h"
#include "geodesic_types.h"
#include "known_cases.h"
#include "locations.h"
#include "offset_tools.h"
#include "test_check.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_geodesic_offset/construct_geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_geodesic_voronoi_diagram.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_voronoi_diagram {

using namespace test;

typedef Geodesic::Field Field;
typedef Field::Voronoi_diagram Diagram;
typedef Surface_mesh::Face_index Face_index;
typedef Surface_mesh::Edge_index Edge_index;
typedef Surface_mesh::Vertex_index Vertex_index;
typedef Geodesic::Face_location Location;

struct Totals
{
  std::size_t diagrams = 0, curves = 0, vertices = 0, points = 0, labels = 0, forced = 0, divisions = 0, crossed = 0;
  double tie = 0, vertex = 0, area = 0;
};
Totals totals;

double distance_between(const Point_3& p, const Point_3& q) { return std::sqrt((p - q).squared_length()); }

Diagram diagram_of(const Surface_mesh& mesh, const std::vector<Source>& sources)
{
  ++totals.diagrams;
  const Diagram diagram = built(mesh, sources).field().voronoi_diagram();
  totals.curves += diagram.number_of_curves();
  totals.vertices += diagram.number_of_vertices();
  totals.forced += diagram.number_of_forced_cells();
  totals.divisions += diagram.number_of_divisions();
  return diagram;
}

Location random_location(const Surface_mesh& mesh, Random& random)
{
  return Location(Face_index(Surface_mesh::size_type(uniform_index(random, mesh.number_of_faces()))),
                  random_barycentric(random));
}

// The edges of the graph fit together: each vertex has curves of three cells or more, and each end of a curve is at its vertex.
void check_graph(const Surface_mesh& mesh, const Diagram& diagram, double tolerance)
{
  std::vector<std::size_t> ends(diagram.number_of_vertices(), 0);
  for (std::size_t i = 0; i < diagram.number_of_curves(); ++i)
  {
    const auto c = diagram.curve(i);
    CHECK(c.number_of_pieces() > 0 && c.source_on_left() != c.source_on_right());
    for (const auto& p : c.pieces())
      CHECK(p.source_on_left() == c.source_on_left() && p.source_on_right() == c.source_on_right());
    const auto check_end = [&](const auto& vertex, const Location& l) {
      if (vertex)
      {
        ++ends[*vertex];
        CHECK(distance_between(c.point(l), diagram.vertex_point(*vertex)) <= tolerance);
        const auto& curves = diagram.curves_at_vertex(*vertex);
        CHECK(std::find(curves.begin(), curves.end(), i) != curves.end());
      }
      else if (!c.is_closed())
      { // on the border
        std::size_t zeros = 0;
        for (const double w : l.second) zeros += w == 0 ? 1 : 0;
        CHECK_DETAIL(zeros > 0 && !CGAL::is_closed(mesh),
                     std::to_string(c.point(l).x()) + " " + std::to_string(c.point(l).y()) + " " +
                       std::to_string(c.point(l).z()) + " curves " + std::to_string(diagram.number_of_curves()));
      }
    };
    check_end(c.start_vertex(), c.piece(0).start());
    check_end(c.end_vertex(), c.piece(c.number_of_pieces() - 1).end());
    for (std::size_t k = 0; k + 1 < c.number_of_pieces(); ++k)
      CHECK(distance_between(c.point(c.piece(k).end()), c.point(c.piece(k + 1).start())) <= tolerance);
    if (c.is_closed())
      CHECK(distance_between(c.point(c.piece(c.number_of_pieces() - 1).end()), c.point(c.piece(0).start())) <= tolerance);
  }
  for (std::size_t v = 0; v < ends.size(); ++v) CHECK(ends[v] >= 3 && ends[v] == diagram.curves_at_vertex(v).size());
}

// Compares a diagram with the distances from each source alone, and splits the mesh along it. `has_narrow_cells`: cells may be
// narrower than the snap distance of splits.
void compare(const std::string& name, const Surface_mesh& mesh, const std::vector<Source>& sources, Random& random,
             std::size_t random_points, bool has_narrow_cells = false)
{
  Report::instance().set_context(name);
  const Diagram diagram = diagram_of(mesh, sources);
  const double diagonal = bounding_box_diagonal(mesh);
  check_graph(mesh, diagram, 1e-8 * diagonal);
  const Locations<Surface_mesh> locations(mesh);

  struct Point
  {
    Location location;
    std::size_t left, right; // sources; equal: the label
  };
  std::vector<Point> points;
  std::set<Face_index> crossed;
  for (const auto& c : diagram.curves())
    for (const auto& p : c.pieces())
    {
      crossed.insert(p.face());
      for (const double t : {0., 0.03, 0.4, 0.8}) points.push_back({p.location(t), p.source_on_left(), p.source_on_right()});
    }
  totals.crossed += crossed.size();
  const std::size_t on_curves = points.size();
  for (std::size_t v = 0; v < diagram.number_of_vertices(); ++v)
    for (const std::size_t i : diagram.curves_at_vertex(v))
      points.push_back({diagram.vertex(v), diagram.curve(i).source_on_left(), diagram.curve(i).source_on_right()});
  const std::size_t bisected = points.size();
  for (std::size_t i = 0; i < random_points; ++i)
  {
    const Location l = random_location(mesh, random);
    if (crossed.count(l.first) == 0) points.push_back({l, diagram.source_at_face(l.first), diagram.source_at_face(l.first)});
  }
  const std::size_t uncrossed = points.size();

  // The split mesh has the surface and the topology of the original, and edges on curves between different cells only.
  Surface_mesh split = mesh;
  auto source = split.add_property_map<Face_index, std::size_t>("source", 0).first;
  auto is_on_curve = split.add_property_map<Edge_index, bool>("curve", false).first;
  const double chord_tolerance = 1e-6 * diagonal;
  CGAL::split_along_geodesic_voronoi_diagram(
    split, diagram,
    CGAL::parameters::face_source_map(source).edge_is_constrained_map(is_on_curve).chord_tolerance(chord_tolerance));
  CHECK(CGAL::is_valid_polygon_mesh(split) && CGAL::is_triangle_mesh(split) && CGAL::is_closed(split) == CGAL::is_closed(mesh));
  const auto euler = [](const Surface_mesh& m) {
    return long(m.number_of_vertices()) - long(m.number_of_edges()) + long(m.number_of_faces());
  };
  CHECK(euler(split) == euler(mesh));
  std::vector<double> areas(sources.size(), 0);
  for (const Face_index f : split.faces())
    if (CHECK(source[f] < sources.size() || source[f] == Field::no_source()) && source[f] < sources.size())
      areas[source[f]] += CGAL::Polygon_mesh_processing::face_area(f, split);
  double sum = 0;
  for (const double a : areas) sum += a;
  double reached = 0;
  for (const Face_index f : mesh.faces())
    if (diagram.source_at_face(f) != Field::no_source()) reached += CGAL::Polygon_mesh_processing::face_area(f, mesh);
  totals.area = (std::max)(totals.area, std::abs(sum - reached) / reached);
  // a needle has less area than rounding of its points allows
  CHECK_DETAIL(std::abs(sum - reached) <= 1e-12 * reached + 1e-16 * diagonal * diagonal, std::to_string(sum / reached - 1));
  std::size_t wrong_edges = 0;
  for (const Edge_index e : split.edges())
  {
    if (split.is_border(e)) continue;
    const auto h = split.halfedge(e);
    if ((source[split.face(h)] != source[split.face(split.opposite(h))]) != bool(is_on_curve[e])) ++wrong_edges;
  }
  CHECK_DETAIL(wrong_edges == 0 || has_narrow_cells, std::to_string(wrong_edges));
  // Faces of the split mesh, by their centers
  std::vector<Location> centers;
  std::vector<std::size_t> labels;
  for (const Face_index f : split.faces())
    if (source[f] != Field::no_source() && uniform(random) * double(split.number_of_faces()) < double(random_points))
    {
      const auto c = Locations<Surface_mesh>(split).corners(f);
      const Point_3 center = CGAL::centroid(split.point(c[0]), split.point(c[1]), split.point(c[2]));
      centers.push_back(Geodesic::Mesh(mesh).locate(center));
      labels.push_back(source[f]);
      if (centers.size() == random_points / 10) break;
    }

  // Distances from single sources
  std::vector<double> least(points.size() + centers.size(), infinity), left(points.size(), infinity), right(left),
    of_label(centers.size(), infinity);
  for (std::size_t s = 0; s < sources.size(); ++s)
  {
    const Field field = built(mesh, {sources[s]}).field();
    for (std::size_t i = 0; i < points.size() + centers.size(); ++i)
    {
      const bool is_center = i >= points.size();
      const double d = field.distance_to_sources(is_center ? centers[i - points.size()] : points[i].location);
      least[i] = (std::min)(least[i], d);
      if (is_center && labels[i - points.size()] == s) of_label[i - points.size()] = d;
      if (!is_center && points[i].left == s) left[i] = d;
      if (!is_center && points[i].right == s) right[i] = d;
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (points[i].left == Field::no_source())
    {
      CHECK(least[i] == infinity);
      continue;
    }
    const double error = (std::max)(std::abs(left[i] - right[i]), (std::max)(left[i], right[i]) - least[i]);
    const double relative = error / (least[i] + 0.01 * diagonal);
    if (i < bisected) ++totals.points;
    else ++totals.labels;
    double& worst = i < on_curves ? totals.tie : totals.vertex;
    if (i < bisected) worst = (std::max)(worst, relative);
    CHECK_DETAIL(relative <= 1e-10,
                 std::to_string(relative) +
                   (i < on_curves ? " on a curve of " + std::to_string(points[i].left) + " " + std::to_string(points[i].right) +
                                      " face " + std::to_string(points[i].location.first)
                    : i < bisected ? " at a vertex"
                                   : " in a face"));
  }
  CHECK(uncrossed == points.size());
  for (std::size_t i = 0; i < centers.size(); ++i) CHECK(of_label[i] <= least[points.size() + i] + 2 * chord_tolerance);
  totals.labels += centers.size();
}

// The centers of the sides of a cube are the sources: the bisectors are the edges. And two opposite centers: a square.
void boxes()
{
  for (const bool is_grid : {false, true})
    for (const std::size_t n : {std::size_t(1), std::size_t(4), std::size_t(5)})
    {
      Report::instance().set_context("cube");
      const Surface_mesh mesh =
        Generated_mesh<Surface_mesh>(is_grid ? cube_grid(n) : box_sides(1, 1, 1).triangulated(8 * n, n, 3)).mesh;
      const Geodesic::Mesh prepared(mesh);
      std::vector<Source> sources;
      for (int k = 0; k < 3; ++k)
        for (const double x : {0., 1.})
        {
          const Location l = prepared.locate(Point_3(k == 0 ? x : 0.5, k == 1 ? x : 0.5, k == 2 ? x : 0.5));
          sources.push_back(point_source(l));
        }
      const Diagram edges = diagram_of(mesh, sources);
      check_graph(mesh, edges, 1e-10);
      CHECK_DETAIL(edges.number_of_curves() == 12, std::to_string(edges.number_of_curves()));
      CHECK_DETAIL(edges.number_of_vertices() == 8, std::to_string(edges.number_of_vertices()));
      for (const auto& c : edges.curves())
        for (const auto& p : c.pieces())
          for (const double t : {0., 0.5, 1.})
          {
            const Point_3 q = p.point(t);
            int at_ends = 0;
            for (int k = 0; k < 3; ++k) at_ends += (std::min)(std::abs(q[k]), std::abs(1 - q[k])) < 1e-10 ? 1 : 0;
            CHECK(at_ends >= 2);
          }
      const Diagram square = diagram_of(mesh, {sources[4], sources[5]});
      check_graph(mesh, square, 1e-10);
      CHECK(square.number_of_curves() == 1 && square.number_of_vertices() == 0 && square.curve(0).is_closed());
      double length = 0;
      for (const auto& p : square.curve(0).pieces())
      {
        CHECK(std::abs(p.point(0.5).z() - 0.5) < 1e-12 && std::abs(p.point(0).z() - 0.5) < 1e-12);
        length += distance_between(p.point(0), p.point(1));
      }
      CHECK_DETAIL(std::abs(length - 4) < 1e-10, std::to_string(length));
    }
}

// On a cone, one source in each sector, at equal distances from the apex: the bisectors are the legs. Two other sources:
// distances by the law of cosines.
void cones()
{
  for (const double angle : {1.3 * CGAL_PI, 1.8 * CGAL_PI, 2.6 * CGAL_PI})
    for (const std::size_t points : {std::size_t(0), std::size_t(30)})
    {
      Report::instance().set_context("cone of angle " + std::to_string(angle) + ", points " + std::to_string(points));
      const Cone cone(6, angle, 2);
      const Generated_mesh<Surface_mesh> data(cone.triangulated(points, points / 5, 2));
      const auto polar = [&](const Location& l) { // distance from the apex, and angle
        double x = 0, y = 0;
        const std::size_t f = data.face_number(l.first);
        for (std::size_t k = 0; k < 3; ++k)
        {
          x += l.second[k] * data.uv[f][k].x();
          y += l.second[k] * data.uv[f][k].y();
        }
        return std::make_pair(std::hypot(x, y), double(data.patches[f]) * cone.sector_angle() + std::atan2(y, x));
      };
      const auto at = [&](double r, double a) { // nearest of the centers of faces to a point
        Location best;
        double least = infinity;
        for (const Face_index f : data.faces)
          for (const double w : {0.2, 1. / 3, 0.6})
          {
            const Location l(f, {w, (1 - w) / 2, (1 - w) / 2});
            const auto p = polar(l);
            const double d = std::hypot(p.first - r, p.first * (p.second - a));
            if (d < least) best = l;
            least = (std::min)(least, d);
          }
        return best;
      };
      const auto distance = [&](const std::pair<double, double>& p, const std::pair<double, double>& q) {
        double turn = std::abs(p.second - q.second);
        turn = (std::min)(turn, angle - turn);
        if (turn >= CGAL_PI) return p.first + q.first;
        return std::sqrt((std::max)(0., p.first * p.first + q.first * q.first - 2 * p.first * q.first * std::cos(turn)));
      };
      std::vector<Source> sources;
      if (points == 0)
      {
        for (const Face_index f : data.faces) sources.push_back(point_source(Location(f, {1. / 3, 1. / 3, 1. / 3})));
        const Diagram legs = diagram_of(data.mesh, sources);
        check_graph(data.mesh, legs, 1e-10);
        CHECK(legs.number_of_curves() == 6 && legs.number_of_vertices() == 1);
        for (const auto& c : legs.curves())
        {
          CHECK(c.start_vertex().has_value() != c.end_vertex().has_value());
          for (const auto& p : c.pieces())
          {
            const auto q = polar(p.location(0.5));
            const double a = q.second / cone.sector_angle();
            CHECK_DETAIL(std::abs(a - std::round(a)) * q.first < 1e-10, std::to_string(a) + " at " + std::to_string(q.first));
          }
        }
      }
      Random random(17);
      for (int i = 0; i < 5; ++i)
      {
        const Location l = at(uniform(random, 0.3, 1.5), uniform(random, 0, angle / 2)),
                       m = at(uniform(random, 0.3, 1.5), uniform(random, angle / 2, angle));
        const double start = i < 2 ? 0 : uniform(random, 0, 0.2);
        const Diagram diagram = diagram_of(data.mesh, {point_source(l), point_source(m, start)});
        check_graph(data.mesh, diagram, 1e-9);
        for (const auto& c : diagram.curves())
          for (const auto& p : c.pieces())
            for (const double t : {0., 0.3, 1.})
            {
              const auto q = polar(p.location(t));
              const double d = distance(q, polar(l)), e = start + distance(q, polar(m));
              CHECK_DETAIL(std::abs(d - e) < 1e-10, std::to_string(d - e));
              ++totals.points;
            }
      }
    }
}

std::vector<Source> random_sources(const Surface_mesh& mesh, std::size_t number, int kind, Random& random)
{
  std::vector<Source> sources;
  const Locations<Surface_mesh> locations(mesh);
  const double spacing = std::sqrt(CGAL::Polygon_mesh_processing::area(mesh) / double(number));
  for (std::size_t i = 0; i < number; ++i)
  {
    const double start = kind % 2 == 1 ? uniform(random, 0, 0.1) * spacing : 0;
    Vertex_index v(Surface_mesh::size_type(uniform_index(random, mesh.number_of_vertices())));
    while (mesh.is_isolated(v)) v = Vertex_index(Surface_mesh::size_type(uniform_index(random, mesh.number_of_vertices())));
    if (i % 3 == 0 && kind < 2)
    {
      sources.push_back(point_source(v, start));
      continue;
    }
    if (i % 3 == 1 || kind < 2)
    {
      const Location l = random_location(mesh, random);
      sources.push_back(point_source(l, start));
      continue;
    }
    std::vector<Vertex_index> path{v}; // along edges
    for (std::size_t k = 0; k < 4; ++k)
    {
      auto h = mesh.halfedge(path.back());
      for (std::size_t turns = uniform_index(random, 6); turns > 0; --turns) h = mesh.opposite(mesh.next(h));
      if (std::find(path.begin(), path.end(), mesh.source(h)) == path.end()) path.push_back(mesh.source(h));
    }
    std::vector<Location> polyline;
    for (const Vertex_index w : path) polyline.push_back(locations.at_vertex(w));
    sources.push_back(polyline_source(polyline, false, start));
  }
  return sources;
}

void generated_meshes()
{
  unsigned seed = 0;
  for (const auto& soup : {icosphere(2), torus(14, 10), cube_grid(3), l_shape(10, 2, 1), saddle_fan(), planar_grid(8, 8),
                           box_sides(1, 2, 3).triangulated(10, 2, 2)})
    for (const int kind : {0, 1, 2, 3})
    {
      Random random(++seed);
      const Surface_mesh mesh = Generated_mesh<Surface_mesh>(soup).mesh;
      compare("generated mesh, seed " + std::to_string(seed), mesh, random_sources(mesh, 8, kind, random), random, 100);
    }
}

// Sources that tie in regions: the smallest id is the label, and there are no curves between them.
void ties()
{
  const Surface_mesh mesh = Generated_mesh<Surface_mesh>(planar_grid(8, 8, Diagonals::alternating)).mesh;
  const Locations<Surface_mesh> locations(mesh);
  const auto vertex = [](std::size_t i, std::size_t j) { return Vertex_index(Surface_mesh::size_type(9 * j + i)); };
  const auto point = [&](std::size_t i, std::size_t j) -> Source { return point_source(vertex(i, j)); };
  const auto polyline = [&](std::vector<std::pair<std::size_t, std::size_t>> at) -> Source {
    std::vector<Location> path;
    for (const auto& p : at) path.push_back(locations.at_vertex(vertex(p.first, p.second)));
    return polyline_source(path);
  };
  Random random(5);
  compare("two equal points", mesh, {point(2, 2), point(2, 2)}, random, 0);
  CHECK(diagram_of(mesh, {point(2, 2), point(2, 2)}).number_of_curves() == 0);
  const Diagram three = diagram_of(mesh, {point(2, 4), point(2, 4), point(6, 4)});
  CHECK(three.number_of_curves() == 1);
  for (const auto& p : three.curve(0).pieces()) CHECK(std::abs(p.point(0.5).x() - 4) < 1e-12);
  // the lines x = 4 and y = 4 are edges
  const Diagram four = diagram_of(mesh, {point(2, 2), point(6, 2), point(6, 6), point(2, 6)});
  CHECK(four.number_of_curves() == 4 && four.number_of_vertices() == 1);
  CHECK(distance_between(four.vertex_point(0), Point_3(4, 4, 0)) < 1e-10);
  // equal polylines; a common corner; a common end, and a common line; a point on a polyline; crossing polylines
  const auto corner = polyline({{1, 1}, {2, 1}, {3, 1}, {3, 2}, {3, 3}});
  compare("equal polylines", mesh, {corner, corner, point(7, 7)}, random, 100);
  compare("common corner", mesh, {corner, polyline({{5, 1}, {4, 1}, {3, 1}}), point(7, 7)}, random, 100);
  compare("common end", mesh, {polyline({{1, 3}, {2, 3}, {3, 3}}), polyline({{3, 3}, {4, 3}, {5, 3}}), point(7, 7)}, random,
          100);
  compare("ends at one point", mesh,
          {polyline({{2, 3}, {3, 3}}), polyline({{3, 5}, {3, 4}, {3, 3}}), polyline({{3, 3}, {3, 2}})}, random, 100);
  compare("point on a polyline", mesh, {corner, point(2, 1), point(7, 7)}, random, 100);
  compare("crossing polylines", mesh, {polyline({{2, 4}, {3, 4}, {4, 4}, {5, 4}}), polyline({{4, 2}, {4, 3}, {4, 4}, {4, 5}})},
          random, 100);
}

// A location beside a vertex, at 1e-3 to 1e-12 of the edges.
Location location_beside_vertex(const Surface_mesh& mesh, Random& random)
{
  const std::size_t k = uniform_index(random, 3);
  const double e = std::pow(10, -uniform(random, 3, 12)), part = uniform(random);
  Location l = random_location(mesh, random);
  l.second[k] = 1 - e;
  l.second[(k + 1) % 3] = e * part;
  l.second[(k + 2) % 3] = (std::max)(0., 1 - l.second[k] - l.second[(k + 1) % 3]);
  return l;
}

// The cone of a source near a vertex has bounding rays with few exact digits.
void beside_vertices()
{
  unsigned seed = 500;
  for (const auto& soup :
       {icosphere(1), cube_grid(1), saddle_fan(), planar_grid(3, 3), box_sides(1, 2, 3).triangulated(3, 2, 2)})
    for (int i = 0; i < 12; ++i)
    {
      Random random(++seed);
      const Surface_mesh mesh = Generated_mesh<Surface_mesh>(soup).mesh;
      std::vector<Source> sources;
      const std::size_t number = 2 + uniform_index(random, 6);
      for (std::size_t s = 0; s < number; ++s)
      {
        const Location l = uniform_index(random, 3) == 0 ? random_location(mesh, random) : location_beside_vertex(mesh, random);
        const double start = uniform_index(random, 3) == 0 ? uniform(random, 0, 0.3) : 0;
        sources.push_back(point_source(l, start));
      }
      compare("beside vertices, seed " + std::to_string(seed), mesh, sources, random, 100, true);
    }
}

// The bisector of a vertex and a point beside it crosses the faces of the vertex so near to it that its pieces in some of them are
// points up to rounding: the split still joins the pieces on both sides of such a face.
void curves_beside_vertices()
{
  const std::size_t n = 180;
  Surface_mesh fan;
  const Vertex_index center = fan.add_vertex(Point_3(0, 0, 0));
  std::vector<Vertex_index> rim;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double turn = 2 * CGAL_PI * double(i) / double(n);
    rim.push_back(fan.add_vertex(Point_3(std::cos(turn), std::sin(turn), 0)));
  }
  for (std::size_t i = 0; i < n; ++i) fan.add_face(center, rim[i], rim[(i + 1) % n]);
  const Locations<Surface_mesh> locations(fan);
  Random random(900);
  for (int i = 0; i < 60; ++i)
  {
    const double e = std::pow(10, -uniform(random, 8.6, 9.2)), part = uniform(random);
    Location beside = random_location(fan, random);
    const auto c = locations.corners(beside.first);
    for (std::size_t k = 0; k < 3; ++k)
      beside.second[k] = c[k] == center ? 1 - e : c[(k + 1) % 3] == center ? e * part : e * (1 - part);
    const Diagram diagram = diagram_of(fan, {point_source(center), point_source(beside)});
    Surface_mesh split = fan;
    CGAL::split_along_geodesic_voronoi_diagram(split, diagram);
    CHECK(CGAL::is_valid_polygon_mesh(split) && CGAL::is_triangle_mesh(split));
    const double area = CGAL::Polygon_mesh_processing::area(fan);
    CHECK_DETAIL(std::abs(CGAL::Polygon_mesh_processing::area(split) - area) <= 1e-12 * area,
                 std::to_string(CGAL::Polygon_mesh_processing::area(split) / area));
  }
}

// Faces of very different sizes along a straight border: a source on its line lies in line with edges up to rounding of
// coordinates, so no cone of a window reaches these edges.
void graded_grids()
{
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    Random random(seed);
    const std::size_t n = 3 + uniform_index(random, 5);
    const double shift = seed % 3 == 0 ? 1e3 : 0;
    std::vector<double> at[2];
    for (std::vector<double>& x : at)
    {
      const double ratio = uniform(random, 0.15, 0.6);
      x.push_back(shift);
      for (std::size_t i = n; i-- > 0;) x.push_back(shift + std::pow(ratio, double(i)));
    }
    Surface_mesh mesh;
    std::vector<Vertex_index> v;
    for (const double x : at[0])
      for (const double y : at[1]) v.push_back(mesh.add_vertex(Point_3(x, y, shift)));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
      {
        const Vertex_index a = v[i * (n + 1) + j], b = v[(i + 1) * (n + 1) + j], c = v[(i + 1) * (n + 1) + j + 1],
                           d = v[i * (n + 1) + j + 1];
        mesh.add_face(a, b, c);
        mesh.add_face(a, c, d);
      }
    // corners of the square, vertices of its border, and points
    std::vector<Source> sources;
    const Vertex_index on_border = v[n * (n + 1) + uniform_index(random, n + 1)], corner = v[n];
    const Location l = random_location(mesh, random);
    sources.push_back(point_source(on_border));
    if (seed % 2 == 0) sources.push_back(point_source(l));
    else sources.push_back(point_source(corner));
    compare("graded grid, seed " + std::to_string(seed), mesh, sources, random, 100, true);
  }
}

// A strip of which the upper border is in line with a source up to rounding of its coordinates, that of the sums of edges.
// There were four curves along the border before, of points 0.8 off.
void graded_strip()
{
  Surface_mesh mesh;
  std::vector<Vertex_index> v;
  for (const double x : {0., 0.0006032011217889932, 0.003848988428089954, 0.02456015313040603, 0.15671679275178532, 1.})
    for (const double y : {0., 1.}) v.push_back(mesh.add_vertex(Point_3(x, y, 0)));
  for (std::size_t i = 0; i + 3 < v.size(); i += 2)
  {
    mesh.add_face(v[i], v[i + 2], v[i + 3]);
    mesh.add_face(v[i], v[i + 3], v[i + 1]);
  }
  Random random(11);
  compare("graded strip", mesh, {point_source(v[1]), point_source(v[8])}, random, 100);
}

// Two sources within 1e-15 to 1e-12 of each other, among others: the curve between them is known up to a large angle only, but
// at its vertices with a third cell both distances agree.
void sources_beside_each_other()
{
  Random random(23);
  for (const bool is_bumpy : {false, true})
  {
    Soup soup = planar_grid(3, 3);
    if (is_bumpy)
      for (Point_3& p : soup.points) p = Point_3(p.x(), p.y(), uniform(random, 0, 0.4));
    const Surface_mesh mesh = Generated_mesh<Surface_mesh>(soup).mesh;
    for (int exponent = 12; exponent <= 15; ++exponent)
      for (int repeat = 0; repeat < 5; ++repeat)
      {
        std::vector<Source> sources;
        const Location first = random_location(mesh, random);
        Location second = first;
        second.second[0] += std::pow(10, -exponent);
        second.second[1] -= std::pow(10, -exponent) * uniform(random);
        for (const Location& l : {first, second, random_location(mesh, random), random_location(mesh, random)})
          sources.push_back(point_source(l));
        compare("sources 1e-" + std::to_string(exponent) + " apart", mesh, sources, random, 100, true);
      }
  }
}

// Points within 1e-13 of each other have one cell, that of the smallest id; so do segments whose ends are so near to each other.
void coinciding_sources()
{
  Random random(29);
  const Surface_mesh mesh = Generated_mesh<Surface_mesh>(icosphere(0)).mesh;
  const auto beside = [&](const Location& l) {
    Location result = l;
    const double x = 2e-14 * uniform(random), y = 2e-14 * uniform(random);
    result.second = {l.second[0] - x - y, l.second[1] + x, l.second[2] + y};
    return result;
  };
  const auto has_cell = [](const Diagram& diagram, std::size_t source) {
    bool result = false;
    for (const auto& c : diagram.curves()) result = result || c.source_on_left() == source || c.source_on_right() == source;
    return result;
  };
  for (int i = 0; i < 60; ++i)
  {
    const Location first = random_location(mesh, random);
    const Location end(first.first, {0.1, 0.2, 0.7});
    std::vector<Source> sources;
    for (int k = 0; k < 2; ++k) sources.push_back(point_source(random_location(mesh, random)));
    for (int k = 0; k < 3; ++k)
      if (i % 2 == 0) sources.push_back(point_source(k == 0 ? first : beside(first)));
      else sources.push_back(polyline_source({beside(first), beside(end)}));
    compare("coinciding sources", mesh, sources, random, 50);
    const Diagram diagram = diagram_of(mesh, sources);
    CHECK(has_cell(diagram, 2) && !has_cell(diagram, 3) && !has_cell(diagram, 4));
    CHECK(diagram.source_at(beside(first)) == 2);
  }
}

// Two polylines begin at a point 1.4e-12 beside an edge: behind the edge, the rays from this point between those of their segments
// pass it within less than a unit in the last place.
void common_end_beside_edge()
{
  Surface_mesh mesh;
  std::vector<Vertex_index> v;
  for (const Point_3& p : {Point_3(0, 0, 0), Point_3(0, 0.153, -0.2155), Point_3(0.001, -0.974, 0), Point_3(0.0015, -0.758, 0)})
    v.push_back(mesh.add_vertex(p));
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[3], v[0], v[2]);
  const Face_index f(0);
  const Location end(f, {0.748936, 1.4e-12, 0.251064 - 1.4e-12});
  Random random(5);
  for (const double x : {1e-5, 1e-4, 1e-3})
    compare("common end beside an edge", mesh,
            {polyline_source({end, Location(f, {0.696, 0, 0.304})}), point_source(Location(f, {0.9999995, 2.5e-7, 2.5e-7})),
             polyline_source({end, Location(f, {1 - 1.2 * x, x, 0.2 * x})})},
            random, 100, true);
}

// A polyline begins 1e-11 behind an edge, which it crosses aslant. On one side, points of the edge are nearest to the crossing,
// from which no window comes over the edge; the next one is that of another polyline.
void end_behind_edge()
{
  Random random(11);
  for (int i = 0; i < 40; ++i)
  {
    Surface_mesh mesh;
    std::vector<Vertex_index> v;
    for (const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, 0.8, 0), Point_3(0.5, -0.8, 0)})
      v.push_back(mesh.add_vertex(p));
    const Face_index upper = mesh.add_face(v[0], v[1], v[2]), lower = mesh.add_face(v[1], v[0], v[3]);
    const auto at = [&](Face_index f, double x, double height) {
      Location result(f, {0, 0, 0});
      auto h = mesh.halfedge(f);
      for (double& w : result.second)
      {
        const Vertex_index u = mesh.source(h);
        w = u == v[0] ? 1 - x - height / 1.6 : u == v[1] ? x - height / 1.6 : height / 0.8;
        h = mesh.next(h);
      }
      return result;
    };
    const double x = uniform(random, 0.4, 0.6), y = 1e-11 * uniform(random, 0.5, 4), depth = uniform(random, 0.2, 0.3),
                 slope = (i % 2 == 0 ? 1 : -1) * uniform(random, 0.4, 0.9), near = x + slope * uniform(random, 0.1, 0.2),
                 far = x - slope * uniform(random, 0, 0.1);
    compare("end behind an edge", mesh,
            {polyline_source({at(lower, near, depth), at(lower, far, depth)}),
             polyline_source({at(upper, x + slope * y, y), at(lower, x, 0), at(lower, x - slope * 0.15, 0.15)})},
            random, 20, true);
  }
}

// A polyline ends some 1e-12 beside a vertex that is a source: they differ by a few ties, and a tie more or less moves the ends
// of the curves between them far.
void end_beside_source()
{
  const double s = std::sqrt(0.75);
  Random random(8);
  for (int i = 0; i < 40; ++i)
  {
    const double h = i % 2 == 0 ? 0.69999998807907104 : 0.7;
    Surface_mesh mesh;
    std::vector<Vertex_index> v;
    for (const Point_3& p :
         {Point_3(1, 0, 2 * h), Point_3(1, 0, h), Point_3(-0.5, s, 2 * h), Point_3(-0.5, s, 3 * h), Point_3(1, 0, 3 * h)})
      v.push_back(mesh.add_vertex(p));
    mesh.add_face(v[0], v[1], v[2]);
    mesh.add_face(v[3], v[0], v[2]);
    mesh.add_face(v[4], v[0], v[3]);
    const Face_index f(0);
    const double y = i == 0 ? 7.1994236424081837e-13 : 1e-12 * uniform(random, 0.2, 1),
                 z = i == 0 ? 4.7361568763684234e-13 : 1e-12 * uniform(random, 0.2, 1),
                 x = i < 2 ? 0.74281152372491965 : uniform(random, 0.6, 0.9);
    const std::vector<Location> polyline{Location(f, {1 - x, x, 0}), Location(f, {0, 0.5, 0.5}),
                                         Location(f, {z, 1 - y - z, y})};
    compare("end beside a source", mesh, {polyline_source(polyline), point_source(v[0])}, random, 20, true);
  }
}

// A strip of 18 needles of length 1 and about the given width, in the plane. Vertices of even indices have y = 0, the others y = 1.
Surface_mesh needle_strip(Random& random, double width)
{
  Surface_mesh mesh;
  std::vector<Vertex_index> v;
  double x = 0;
  for (int k = 0; k < 10; ++k)
    for (const double y : {0., 1.})
    {
      v.push_back(mesh.add_vertex(Point_3(x + width * uniform(random, 0, 0.9), y, 0)));
      if (y > 0) x += width * uniform(random, 1, 3);
    }
  for (std::size_t k = 0; k + 2 < v.size(); ++k)
    if (k % 2 == 0) mesh.add_face(v[k], v[k + 2], v[k + 1]);
    else mesh.add_face(v[k], v[k + 1], v[k + 2]);
  return mesh;
}

// Strips of needles of height 1e-9: rays of sources far along them differ by angles of 1e-8, less than the gaps between cones
// that are closed, and bounding rays graze the edges where they start.
void needle_strips()
{
  Random random(12);
  for (int i = 0; i < 60; ++i)
  {
    const Surface_mesh mesh = needle_strip(random, 1e-9);
    const Face_index first(0), last(unsigned(mesh.number_of_faces() - 1));
    const double s = uniform(random, 0.1, 0.4), t = uniform(random, 0.6, 0.9);
    compare("needle strip", mesh, {point_source(Location(first, {s, 1 - s, 0})), point_source(Location(last, {0, t, 1 - t}))},
            random, 20, true);
  }
}

// The cells of three vertices of a strip meet in the middle of a long edge up to rounding, where the curve between two of them
// leaves its face at a small angle.
void cells_that_meet_on_an_edge()
{
  Random random(31);
  for (int i = 0; i < 60; ++i)
  {
    const Surface_mesh mesh = needle_strip(random, 1e-6);
    std::vector<Source> sources;
    for (const unsigned v : {1u, 16u, 14u}) sources.push_back(point_source(Vertex_index(v)));
    compare("cells that meet on an edge", mesh, sources, random, 20, true);
  }
}

// Two points 2e-10 apart, with start values that differ by 2e-11: windows that tie on a long edge of a needle have no certain order
// on 1e-10 of it, and their cones leave gaps behind it.
void windows_without_order()
{
  Random random(37);
  for (int i = 0; i < 60; ++i)
  {
    const Surface_mesh mesh = needle_strip(random, 1e-3);
    std::vector<Source> sources;
    const double x = uniform(random, 0.3, 0.5), y = 1e-9 * uniform(random), z = 1e-5 * uniform(random);
    const auto add = [&](double start_value, const std::array<double, 3>& weights) {
      sources.push_back(point_source(Location(Face_index(8), weights), start_value));
    };
    add(1.9e-9, {x - 0.2, 1.2 - x - z, z});
    add(0, {x, 1 - x - y, y});
    add(2e-11 * uniform(random), {x + 2e-10 * uniform(random), 1 - x - y - 2e-10, y + 2e-10 * uniform(random)});
    compare("windows without order", mesh, sources, random, 20, true);
  }
}

// Around the point where two polylines cross, there are four cells of two sources.
void crossing_polylines()
{
  const Surface_mesh square = Generated_mesh<Surface_mesh>(planar_grid(1, 1)).mesh;
  const Geodesic::Mesh prepared(square);
  const auto box = CGAL::Polygon_mesh_processing::bbox(square);
  const auto at = [&](double x, double y) {
    return prepared.locate(Point_3(box.xmin() + x * box.x_span(), box.ymin() + y * box.y_span(), 0));
  };
  const auto segment = [&](const Location& from, const Location& to) -> Source {
    const auto path = prepared.join_polyline(std::vector<Location>{from, to}).locations;
    return polyline_source(path);
  };
  const Diagram cross = diagram_of(square, {segment(at(0.05, 0.3), at(0.97, 0.7)), segment(at(0.1, 0.6), at(0.93, 0.2))});
  check_graph(square, cross, 1e-12);
  CHECK_DETAIL(cross.number_of_curves() == 4, std::to_string(cross.number_of_curves()));
  CHECK_DETAIL(cross.number_of_divisions() == 0, std::to_string(cross.number_of_divisions()));
  // x = 0.05 + 0.92 t = 0.1 + 0.83 s, and y = 0.3 + 0.4 t = 0.6 - 0.4 s
  const double t = (0.05 + 0.83 * 0.75) / (0.92 + 0.83);
  const Point_3 crossing(box.xmin() + (0.05 + 0.92 * t) * box.x_span(), box.ymin() + (0.3 + 0.4 * t) * box.y_span(), 0);
  if (CHECK(cross.number_of_vertices() == 1)) CHECK(distance_between(cross.vertex_point(0), crossing) < 1e-13 * box.x_span());

  unsigned seed = 700;
  for (const auto& soup : {icosphere(1), cube_grid(1), saddle_fan(), planar_grid(3, 3)})
    for (int i = 0; i < 12; ++i)
    {
      Random random(++seed);
      const Surface_mesh mesh = Generated_mesh<Surface_mesh>(soup).mesh;
      const Geodesic::Mesh data(mesh);
      std::vector<Source> sources;
      const std::size_t number = 2 + uniform_index(random, 4);
      for (std::size_t s = 0; s < number; ++s)
      {
        std::vector<Location> corners;
        const std::size_t length = 2 + uniform_index(random, 3);
        for (std::size_t k = 0; k < length; ++k)
          corners.push_back(uniform_index(random, 3) == 0 ? location_beside_vertex(mesh, random)
                                                          : random_location(mesh, random));
        const auto path = data.join_polyline(corners).locations;
        sources.push_back(polyline_source(path));
      }
      compare("crossing polylines, seed " + std::to_string(seed), mesh, sources, random, 100, true);
    }
}

// A source with the start value that another source has there ties with it on the ray behind it only.
void ties_on_a_ray()
{
  const Surface_mesh mesh = Generated_mesh<Surface_mesh>(box_sides(1, 2, 3).triangulated(1, 1, 1)).mesh;
  for (const Vertex_index v : mesh.vertices())
    for (const Face_index f : mesh.faces())
      for (const auto& weights : {std::array<double, 3>{0.25, 0.25, 0.5}, std::array<double, 3>{1. / 3, 1. / 3, 1. / 3}})
      {
        const Location l(f, weights);
        const double start = built(mesh, {point_source(v)}).distance_to_sources(l);
        const Diagram diagram = diagram_of(mesh, {point_source(v), point_source(l, start)});
        CHECK_DETAIL(diagram.number_of_curves() == 0, std::to_string(diagram.number_of_curves()));
        for (const Face_index g : mesh.faces())
        {
          CHECK(diagram.source_at_face(g) == 0);
          CHECK(diagram.source_at(Location(g, {0.2, 0.3, 0.5})) == 0);
        }
      }
}

// A polyline ties at its end only, which is the center of a face: the face belongs to the edge that is nearer everywhere else,
// unless rounding lets the polyline be nearer in a lens around the last segment.
void tie_at_a_center()
{
  Surface_mesh mesh;
  std::vector<Vertex_index> v{mesh.add_vertex(Point_3(0, 0, -1.3308796789576884))};
  for (int k = 0; k < 5; ++k)
    v.push_back(mesh.add_vertex(Point_3(std::cos(0.4 * k * CGAL_PI), std::sin(0.4 * k * CGAL_PI), 0)));
  for (std::size_t k = 0; k < 5; ++k) mesh.add_face(v[0], v[k + 1], v[(k + 1) % 5 + 1]);
  const Location apex(Face_index(1), {1, 0, 0}), center(Face_index(1), {1. / 3, 1. / 3, 1. / 3});
  const Source edge = edge_source({Edge_index(7)});
  const Field field = built(mesh, {edge}).field();
  for (const double rounding : {-1e-15, 0., 1e-15})
  {
    const double start = field.distance_to_sources(center) + rounding;
    const Diagram diagram =
      diagram_of(mesh,
                 {edge, point_source(apex, field.distance_to_sources(apex)), polyline_source({apex, center}, false, start)});
    std::size_t curves_of_lens = 0;
    for (const auto& c : diagram.curves())
      if (c.source_on_left() == 2 || c.source_on_right() == 2) ++curves_of_lens;
    CHECK(rounding < 0 || curves_of_lens == 0);
    for (const Face_index f : mesh.faces())
      CHECK(diagram.source_at_face(f) != 2 || (rounding < 0 && f == center.first && curves_of_lens > 0));
    const double apart = 1e-6; // a lead of 1e-15 gives a lens of 7e-8
    for (const Location& l : {Location(center.first, {1. / 3, 1. / 3 - apart, 1. / 3 + apart}),
                              Location(center.first, {1. / 3, 1. / 3 + apart, 1. / 3 - apart}),
                              Location(center.first, {1. / 3 + apart, 1. / 3 - 2 * apart, 1. / 3 + apart})})
      CHECK(diagram.source_at(l) != 2);
  }
}

// Points of a source edge whose coordinate for the opposite corner is zero up to rounding, and may be negative: they are on the
// edge, whatever is beside it.
void locations_on_source_edge()
{
  Surface_mesh mesh;
  const Vertex_index a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(1, 0, 0)),
                     c = mesh.add_vertex(Point_3(0, 1, 0));
  const Face_index f = mesh.add_face(a, b, c);
  const auto location = [&](double of_a, double of_b, double of_c) {
    Location l(f, {});
    const auto h = mesh.halfedge(f);
    int k = 0;
    for (const Vertex_index v : {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))})
      l.second[k++] = v == a ? of_a : v == b ? of_b : of_c;
    return l;
  };
  const std::vector<Location> polyline = {location(0.2, 0.2, 0.6), location(0.5, 0.4, 0.1)};
  const Diagram diagram = diagram_of(mesh, {edge_source({mesh.edge(mesh.halfedge(a, b))}), polyline_source(polyline)});
  for (int i = 1; i < 100; ++i)
    for (const double height : {-9e-14, -7e-15, -1e-16, 0., 1e-15})
      CHECK_DETAIL(diagram.source_at(location(i / 100., 1 - i / 100. - height, height)) == 0, std::to_string(i));
}

// A vertex and an edge at it: where the vertex is the nearest point of the edge, both tie, and the curve is the border of this
// region. It runs along rays on both sides of which the distances are equal up to the square of the distance from the ray, so
// rounding may end windows anywhere beside them; on two sides of the other end of the edge, these rays meet.
void vertex_and_edge()
{
  Random random(4);
  const auto run = [&](const std::string& name, const Soup& soup, std::size_t cases) {
    const Surface_mesh mesh = Generated_mesh<Surface_mesh>(soup).mesh;
    for (std::size_t i = 0; i < cases; ++i)
    {
      const Edge_index e(unsigned(uniform_index(random, mesh.number_of_edges())));
      const auto h = mesh.halfedge(e, unsigned(uniform_index(random, 2)));
      compare(name, mesh, {point_source(mesh.source(h)), edge_source({e})}, random, 50, true);
    }
  };
  for (int i = 0; i < number_of_cases(60, 600); ++i)
  { // an octahedron with other positions of its vertices
    const double thickness = std::pow(10, uniform(random, -4, 0));
    Soup octahedron;
    for (int k = 0; k < 6; ++k)
    {
      const double turn = (k + uniform(random, -0.4, 0.4)) * CGAL_PI / 2;
      octahedron.points.push_back(k < 4 ? Point_3(std::cos(turn), std::sin(turn), thickness * uniform(random, -0.2, 0.2))
                                        : Point_3(uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2),
                                                  k == 4 ? thickness : -thickness));
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      octahedron.add_triangle({{k, (k + 1) % 4, 4}});
      octahedron.add_triangle({{(k + 1) % 4, k, 5}});
    }
    run("octahedron, a vertex and an edge", octahedron, 5);
  }
  for (unsigned i = 0; i < number_of_cases(60u, 600u); ++i)
    run("thin box, a vertex and an edge",
        box_sides(1, uniform(random, 0.3, 2), std::pow(10, uniform(random, -5, -1)))
          .triangulated(uniform_index(random, 3), uniform_index(random, 3), i),
        5);
}

// A polyline along a part of an edge.
Source along_edge(const Surface_mesh& mesh, Surface_mesh::Halfedge_index h, double from, double to, double start_value = 0)
{
  if (mesh.is_border(h))
  {
    h = mesh.opposite(h);
    from = 1 - from;
    to = 1 - to;
  }
  const Locations<Surface_mesh> locations(mesh);
  return polyline_source({locations.on_edge(h, from), locations.on_edge(h, to)}, false, start_value);
}

std::vector<Soup> symmetric_soups()
{
  Soup octahedron;
  for (const double x : {1., -1.}) octahedron.points.push_back(Point_3(x, 0, 0));
  for (const double y : {1., -1.}) octahedron.points.push_back(Point_3(0, y, 0));
  for (const double z : {1., -1.}) octahedron.points.push_back(Point_3(0, 0, z));
  for (const auto& t : std::vector<std::array<std::size_t, 3>>{
         {{0, 2, 4}}, {{2, 0, 5}}, {{3, 0, 4}}, {{0, 3, 5}}, {{2, 1, 4}}, {{1, 2, 5}}, {{1, 3, 4}}, {{3, 1, 5}}})
    octahedron.add_triangle(t);
  return {octahedron, cube_grid(1), cube_grid(2), icosphere(0), planar_grid(2, 2)};
}

// Polylines that start at one vertex and run along parts of the edges there: bisectors run along other edges and along medians
// of faces, on which windows of three sources tie, and touch them.
void parts_of_edges_at_a_vertex()
{
  Random random(6);
  std::vector<Surface_mesh> meshes;
  for (const Soup& soup : symmetric_soups()) meshes.push_back(Generated_mesh<Surface_mesh>(soup).mesh);
  { // the bisector of two of them is a median of a face, and parabolas of the third one touch it
    const Surface_mesh& mesh = meshes.front();
    std::vector<Source> sources;
    for (const auto h : halfedges_around_source(Vertex_index(1), mesh))
      sources.push_back(
        along_edge(mesh, h, std::array<double, 4>{0.0052619506861588464, 0.092934787624367715, 0, 0.2}[sources.size()], 0.5));
    for (int i = 0; i < 4; ++i)
    {
      compare("octahedron, parts of four edges", mesh, {sources[0], sources[1], sources[2]}, random, 100, true);
      std::rotate(sources.begin(), sources.begin() + 1, sources.end());
    }
  }
  for (int i = 0; i < number_of_cases(400, 4000); ++i)
  {
    const Surface_mesh& mesh = meshes[uniform_index(random, meshes.size())];
    const Vertex_index v(unsigned(uniform_index(random, mesh.number_of_vertices())));
    const bool has_middles = uniform_index(random, 2) == 0;
    std::vector<Source> sources;
    for (const auto h : halfedges_around_source(v, mesh))
      if (!mesh.is_border(h) && uniform_index(random, 3) > 0)
      {
        const double from = uniform_index(random, 3) > 0 ? 0 : uniform(random, 0, 0.1);
        sources.push_back(along_edge(mesh, h, from, has_middles ? 0.5 : uniform(random, 0.15, 1)));
      }
    if (sources.size() >= 2) compare("parts of edges at a vertex", mesh, sources, random, 30, true);
  }
}

// Sources that share edges, or parts of them, and go on along other ones, in line or not; with start values that differ by
// rounding, and on meshes perturbed by rounding.
void shared_segments()
{
  { // an edge of a source that another one has, too, and its next edge in line with it
    const Surface_mesh mesh = Generated_mesh<Surface_mesh>(symmetric_soups().front()).mesh;
    const auto edge = [&](unsigned from, unsigned to) {
      return mesh.edge(mesh.halfedge(Vertex_index(from), Vertex_index(to)));
    };
    Random random(1);
    compare("octahedron, shared edge", mesh,
            {along_edge(mesh, mesh.halfedge(Vertex_index(4), Vertex_index(3)), 1. / 3, 0), edge_source({edge(4, 3)}),
             edge_source({edge(4, 3), edge(3, 5)})},
            random, 100, true);
  }
  Random random(10);
  const std::vector<Soup> soups = symmetric_soups();
  for (int i = 0; i < number_of_cases(600, 6000); ++i)
  {
    Soup soup = soups[uniform_index(random, soups.size())];
    const double noise = uniform_index(random, 2) == 0 ? 0 : std::pow(10, uniform(random, -14, -7));
    for (Point_3& p : soup.points)
      p = Point_3(p.x() + uniform(random, -noise, noise), p.y() + uniform(random, -noise, noise),
                  p.z() + uniform(random, -noise, noise));
    const Surface_mesh mesh = Generated_mesh<Surface_mesh>(soup).mesh;
    const Vertex_index v(unsigned(uniform_index(random, mesh.number_of_vertices())));
    std::vector<Surface_mesh::Halfedge_index> around;
    for (const auto h : halfedges_around_source(v, mesh)) around.push_back(h);
    const auto any = [&] { return around[uniform_index(random, around.size())]; };
    const Edge_index shared = mesh.edge(any());
    std::vector<Source> sources;
    for (std::size_t k = 2 + uniform_index(random, 3); k > 0; --k)
    {
      const double start = uniform_index(random, 3) > 0 ? 0 : std::pow(10, uniform(random, -16, -12));
      switch (uniform_index(random, 4))
      {
      case 0: sources.push_back(point_source(v, start)); break;
      case 1:
        sources.push_back(along_edge(mesh, any(), 0, uniform_index(random, 2) == 0 ? 0.5 : uniform(random, 0.1, 1), start));
        break;
      default: sources.push_back(edge_source({shared, mesh.edge(any())}, start));
      }
    }
    compare("shared segments", mesh, sources, random, 30, true);
  }
}

// A source and a vertex whose start value is its distance from this source, so that they tie on the rays behind the vertex:
// along edges of a box, and in faces.
void start_value_of_distance()
{
  Random random(7);
  for (int i = 0; i < number_of_cases(400, 4000); ++i)
  {
    Soup soup = cube_grid(1 + uniform_index(random, 2));
    const double height = uniform(random, 0.3, 1);
    for (Point_3& p : soup.points) p = Point_3(p.x(), p.y(), height * p.z());
    const Surface_mesh mesh = Generated_mesh<Surface_mesh>(soup).mesh;
    const Vertex_index v(unsigned(uniform_index(random, mesh.number_of_vertices())));
    const Source source = uniform_index(random, 2) == 0
                          ? point_source(Vertex_index(unsigned(uniform_index(random, mesh.number_of_vertices()))))
                          : point_source(random_location(mesh, random));
    const double start = built(mesh, {source}, false).distance_to_sources(v);
    if (start > 0)
      compare("start value of the distance from another source", mesh, {source, point_source(v, start)}, random, 30, true);
  }
}

// A vertex, and a polyline from another vertex into a face beside it.
void vertex_and_polyline()
{
  Random random(8);
  for (int i = 0; i < number_of_cases(200, 2000); ++i)
  {
    Surface_mesh mesh;
    std::vector<Vertex_index> v;
    for (const Point_3& p : {Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, -1, 0), Point_3(0, 0, 1), Point_3(0, 0, -1)})
      v.push_back(mesh.add_vertex(p));
    mesh.add_face(v[0], v[1], v[3]);
    mesh.add_face(v[2], v[0], v[3]);
    const Face_index f = mesh.add_face(v[0], v[2], v[4]);
    std::vector<Location> polyline{Location(f, {0, 1, 0}), Location(f, {1. / 3, 1. / 3, 1. / 3})};
    for (std::size_t k = uniform_index(random, 3); k > 0; --k) polyline.push_back(Location(f, random_barycentric(random)));
    compare("vertex and polyline", mesh, {point_source(v[0]), polyline_source(polyline)}, random, 30, true);
  }
}

// In faces that are thin, a point that rounding has moved out of a face is put back on its edge without moving along it.
void thin_boxes()
{
  Random random(9);
  for (int i = 0; i < number_of_cases(60, 600); ++i)
  {
    const Surface_mesh mesh =
      Generated_mesh<Surface_mesh>(
        box_sides(uniform(random, 3, 8), 3, std::pow(10, uniform(random, -5, -3))).triangulated(2, 2, unsigned(i)))
        .mesh;
    const Geodesic::Mesh prepared(mesh);
    std::vector<Source> sources;
    for (std::size_t k = 2 + uniform_index(random, 3); k > 0; --k)
    {
      const auto path =
        prepared.join_polyline(std::vector<Location>{random_location(mesh, random), random_location(mesh, random)}).locations;
      const Vertex_index v(unsigned(uniform_index(random, mesh.number_of_vertices())));
      if (k % 2 == 0) sources.push_back(point_source(v));
      else sources.push_back(polyline_source(path));
    }
    compare("thin box", mesh, sources, random, 30, true);
  }
}

// Cells in which rounding decides which windows are nearest: bisectors do not fit together there, and gates are linked.
void links()
{
  { // Two strips of parallel rays, whose directions differ by 4e-8, overlap, and the rays of a vertex between them are lost.
    Surface_mesh mesh;
    std::vector<Vertex_index> v;
    for (const Point_3& p :
         {Point_3(-0.001454, -0.001, 0), Point_3(-0.001454021926611353, -0.00099999999945423932, 0.001),
          Point_3(-0.0014540219267582494, 7.2085165848015279e-14, 0.001), Point_3(-0.001454, 0, 0), Point_3(-0.0005, 0, 0),
          Point_3(-0.00045402192529399668, 1.6590902112596596e-13, 0.001), Point_3(-0.0014540219266057778, 0.001, 0.001),
          Point_3(0, 0.001, 0), Point_3(-0.0005, 0.001, 0), Point_3(-0.000454022, 0.001, 0.001)})
      v.push_back(mesh.add_vertex(p));
    for (const auto& f : std::vector<std::array<unsigned, 3>>{
           {{0, 1, 2}}, {{0, 2, 3}}, {{1, 5, 2}}, {{3, 2, 6}}, {{3, 6, 7}}, {{3, 7, 8}}, {{3, 8, 4}}, {{2, 9, 6}}})
      mesh.add_face(v[f[0]], v[f[1]], v[f[2]]);
    const auto edge = [&](unsigned a, unsigned b, double start) {
      return edge_source({mesh.edge(mesh.halfedge(v[a], v[b]))}, start);
    };
    Random random(1);
    compare("overlapping strips", mesh, {point_source(v[4]), edge(5, 1, 0), edge(9, 2, 0.00070710678155543342)}, random, 100,
            true);
  }
  { // a point beside the common vertex of two edges: one of them is the source of a side by the windows of the neighbour only
    const Surface_mesh mesh = Generated_mesh<Surface_mesh>(cube_grid(1)).mesh;
    Random random(2);
    for (const double step : {1e-6, 1e-8, 1e-9, 1e-10, 1e-11})
      for (const auto v : mesh.vertices())
      {
        const auto h = mesh.halfedge(v), g = mesh.opposite(mesh.next(h));
        const Location beside = Locations<Surface_mesh>(mesh).on_edge(h, 1 - step);
        compare("point beside the common vertex of edges", mesh,
                {point_source(beside), edge_source({mesh.edge(g)}), edge_source({mesh.edge(h)})}, random, 30, true);
      }
  }
  { // a segment as short as rounding coincides with a vertex, and the next one in line does not; and curves beside each other
    Surface_mesh mesh;
    for (const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0)}) mesh.add_vertex(p);
    const Face_index f = mesh.add_face(Vertex_index(0), Vertex_index(1), Vertex_index(2));
    Random random(3);
    const Location b(f, {0.875, 0.125, 0});
    for (const double step : {1e-14, 3e-14, 1e-13, 1e-10})
      compare("short segment in line", mesh,
              {point_source(b),
               polyline_source({Location(f, {0.25, 0.75, 0}), b, Location(f, {0.875 + step, 0.125 - step, 0})})},
              random, 100, true);
    const Location c(f, {0.25, 0.25, 0.5}), beside(f, {0.25 + 6e-10, 0.25 - 6e-10, 0.5}), near_end(f, {0, 0.999999, 1e-6});
    compare("polylines beside each other", mesh,
            {polyline_source({Location(f, {0, 1, 0}), c, near_end}),
             polyline_source({near_end, beside, Location(f, {0, 1, 0})})},
            random, 100, true);
  }
  { // polylines through one point, with ends 8e-9 apart: several bisectors meet at the ends of links
    const Surface_mesh mesh = Generated_mesh<Surface_mesh>(symmetric_soups().front()).mesh;
    Random random(4);
    const Face_index f(1);
    const Location center(f, {1. / 3, 1. / 3, 1. / 3}),
      end(f, {0.62291208656218811, 0.29480699722916781, 0.082280916208644084}), beside(f, {0.62291208, 0.294807, 0.08228092});
    compare("polylines through one point", mesh,
            {polyline_source({Location(f, {1, 0, 0}), center, end}),
             polyline_source({beside, center, Location(f, {0.88, 0.12, 0})})},
            random, 30, true);
  }
  Random random(11);
  for (int i = 0; i < number_of_cases(200, 2000); ++i)
  { // points no farther apart than 1e-8, and two edges, on a bent fan
    Surface_mesh mesh;
    const Vertex_index center = mesh.add_vertex(Point_3(0, 0, 0));
    std::vector<Vertex_index> ring;
    for (int k = 0; k < 9; ++k)
    {
      const double angle = k * CGAL_PI / 4.5, radius = uniform(random, 0.3, 1.5);
      ring.push_back(mesh.add_vertex(Point_3(radius * std::cos(angle), radius * std::sin(angle), uniform(random, 0, 0.5))));
    }
    for (std::size_t k = 0; k + 1 < ring.size(); ++k) mesh.add_face(center, ring[k], ring[k + 1]);
    const auto edge = [&] {
      const std::size_t k = uniform_index(random, 8);
      const auto h = uniform_index(random, 2) == 0 ? mesh.halfedge(center, ring[k]) : mesh.halfedge(ring[k], ring[k + 1]);
      return mesh.edge(h);
    };
    std::vector<Source> sources{edge_source({edge(), edge()})};
    const Location l = random_location(mesh, random);
    for (std::size_t k = 2 + uniform_index(random, 2); k > 0; --k)
    {
      Location beside(l);
      const double step = std::pow(10, uniform(random, -13, -8)) * beside.second[0];
      beside.second[0] -= step;
      beside.second[1] += step;
      sources.push_back(point_source(beside));
    }
    compare("cluster and edges on a fan", mesh, sources, random, 30, true);
  }
  const std::vector<Soup> soups = symmetric_soups();
  for (int i = 0; i < number_of_cases(300, 3000); ++i)
  { // edges and vertices that start with the length of an edge, or with half of it, on perturbed meshes
    Soup soup = soups[uniform_index(random, soups.size())];
    const double noise = std::pow(10, uniform(random, -12, -8));
    for (Point_3& p : soup.points)
      p = Point_3(p.x() + uniform(random, -noise, noise), p.y() + uniform(random, -noise, noise),
                  p.z() + uniform(random, -noise, noise));
    const Surface_mesh mesh = Generated_mesh<Surface_mesh>(soup).mesh;
    std::vector<Source> sources;
    for (std::size_t k = 2 + uniform_index(random, 2); k > 0; --k)
    {
      const Edge_index e(unsigned(uniform_index(random, mesh.number_of_edges()))),
        other(unsigned(uniform_index(random, mesh.number_of_edges())));
      const Vertex_index v = mesh.vertex(e, 0);
      const double size =
        std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(other, 0)), mesh.point(mesh.vertex(other, 1))));
      const double start = std::array<double, 4>{0, 0, size / 2, size}[uniform_index(random, 4)];
      if (uniform_index(random, 3) == 0) sources.push_back(point_source(v, start));
      else sources.push_back(edge_source({e}, start));
    }
    compare("edges that start later, perturbed", mesh, sources, random, 30, true);
  }
  CHECK(totals.forced == 0);
}

// Small cases that gave wrong diagrams.
void cases_of_file()
{
  const std::vector<Known_case> cases = known_cases("voronoi_cases.txt");
  for (const Known_case& c : cases)
  {
    Random random(7);
    compare(c.name, c.mesh, c.sources, random, 100, c.name.find("narrow cells") != std::string::npos);
  }
  CHECK(cases.size() == 30);
  CHECK(totals.forced == 0);
}

// Queries on an edge, and next to it, that rays from a source beside the edge graze. From an attack.
void points_on_edge()
{
  for (const double beside : {1.1e-13, 2.6e-13, 1e-12, 1e-10, 1e-7})
  {
    Surface_mesh mesh;
    for (const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0)}) mesh.add_vertex(p);
    const Face_index faces[] = {mesh.add_face(Vertex_index(0), Vertex_index(1), Vertex_index(2)),
                                mesh.add_face(Vertex_index(0), Vertex_index(2), Vertex_index(3))};
    const auto location = [&](Face_index f, double of_0, double of_2) {
      Location l(f, {0, 0, 0});
      const auto corners = Locations<Surface_mesh>(mesh).corners(f);
      for (std::size_t k = 0; k < 3; ++k)
        l.second[k] = corners[k] == Vertex_index(0) ? of_0 : corners[k] == Vertex_index(2) ? of_2 : 1 - of_0 - of_2;
      return l;
    };
    const double part = 0.32009475681095179; // of vertex 0
    const Location at = location(faces[0], part, 1 - part - beside);
    const Diagram diagram = diagram_of(mesh, {point_source(Vertex_index(0)), point_source(at)});
    const double middle = (1 - part) / 2; // of vertex 2, where the sources tie
    for (const Face_index f : faces)
      for (const double off : {0., 1e-17, 1e-15, 1e-9})
        for (int i = -2000; i <= 2000; ++i)
        {
          const double of_2 = middle + i * 1e-7;
          if (std::abs(i) < 3) continue; // the curve may be beside the middle by `beside`
          CHECK_DETAIL(diagram.source_at(location(f, 1 - of_2 - off, of_2)) == (i < 0 ? 0 : 1),
                       values(beside, off) + ", " + std::to_string(i));
        }
  }
}

// Segments that cross at tiny angles: their arcs end far apart.
void thin_faces()
{
  Random random(1);
  for (const double height : {1e-3, 1e-5})
  {
    Surface_mesh mesh;
    for (const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.3, height, 0)}) mesh.add_vertex(p);
    mesh.add_face(Vertex_index(0), Vertex_index(1), Vertex_index(2));
    std::vector<Source> sources;
    for (int i = 0; i < 12; ++i)
    {
      const std::vector<Location> ends{random_location(mesh, random), random_location(mesh, random)};
      sources.push_back(polyline_source(ends));
    }
    compare("thin face", mesh, sources, random, 100, true);
  }
  CHECK(totals.forced == 0);
}

// Loops around the center of a face, three and a half radii long, are found if they are longer than 1.2e-7 of the size of the face
// plus its distances, some 3. Smaller ones leave no part of the cell in the split mesh.
void small_loops()
{
  const double tie = 3 * 0x1p-46; // of the same size
  for (const double radius : {1e-5, 1e-6, 1.5e-7, 5e-8, 1e-9, 1e-16})
  {
    Surface_mesh mesh;
    for (const Point_3& p : {Point_3(0, 0, 0), Point_3(2, 0, 0), Point_3(1, std::sqrt(3.), 0)}) mesh.add_vertex(p);
    const Face_index f = mesh.add_face(Vertex_index(0), Vertex_index(1), Vertex_index(2));
    const Diagram diagram = diagram_of(mesh, {point_source(Location(f, {1. / 3, 1. / 3, 1. / 3}), 1 / std::sqrt(3.) - radius),
                                              edge_source(std::vector<Edge_index>(mesh.edges().begin(), mesh.edges().end()))});
    const bool is_found = radius > 1e-7;
    CHECK_DETAIL(diagram.number_of_curves() == (is_found ? 1 : 0) && diagram.source_at_face(f) == (is_found ? 0 : 1),
                 values(radius, double(diagram.number_of_curves())));
    for (const auto& c : diagram.curves())
      for (const auto& piece : c.pieces()) // three arcs of parabolas with the focus at the center, from r / 2 to 2 r / 3
        for (const double t : {0., 0.3, 0.5, 1.})
        {
          const double r = std::sqrt(CGAL::squared_distance(piece.point(t), Point_3(1, 1 / std::sqrt(3.), 0)));
          CHECK_DETAIL(r > radius / 2 - tie && r < radius * 2 / 3 + tie, values(r, radius));
        }
    auto source = mesh.add_property_map<Face_index, std::size_t>("source", 2).first;
    CGAL::split_along_geodesic_voronoi_diagram(mesh, diagram, CGAL::parameters::face_source_map(source).chord_tolerance(1e-3));
    if (!is_found) CHECK(source[f] == 1);
    else CHECK(std::count_if(mesh.faces().begin(), mesh.faces().end(), [&](Face_index g) { return source[g] == 0; }) > 0);
  }
}

void bad_input()
{
  const Surface_mesh mesh = Generated_mesh<Surface_mesh>(icosphere(1)).mesh;
  const auto at = [](unsigned i) { return Vertex_index(i); };
  Geodesic geodesic(mesh);
  geodesic.add_source_point(at(0));
  geodesic.add_source_point(at(1));
  CHECK_THROWS(geodesic.build().voronoi_diagram(), std::logic_error);
  CHECK_THROWS(geodesic.build(CGAL::parameters::keep_windows(true).distance_limit(0.5)).voronoi_diagram(), std::logic_error);
  CHECK_THROWS(geodesic.build(CGAL::parameters::keep_windows(true).relative_tolerance(0.01)).voronoi_diagram(),
               std::logic_error);
  CHECK_THROWS(Field().voronoi_diagram(), std::logic_error);
  const Diagram diagram = geodesic.build(CGAL::parameters::keep_windows(true)).voronoi_diagram();
  CHECK(diagram.number_of_curves() == 1 && diagram.curve(0).is_closed());
  std::vector<Point_3> points;
  CHECK_THROWS(diagram.curve(0).points(0., std::back_inserter(points)), std::invalid_argument);
  CHECK(points.empty());
  CHECK(CGAL::construct_geodesic_voronoi_diagram(mesh, std::vector<Vertex_index>{at(0), at(1)}).number_of_curves() == 1);
  CHECK_THROWS(CGAL::construct_geodesic_voronoi_diagram(mesh, std::vector<Vertex_index>{at(0), at(1)},
                                                        CGAL::parameters::visitor([](double) { return false; })),
               std::logic_error);
  Surface_mesh copy = mesh;
  CHECK_THROWS(CGAL::split_along_geodesic_voronoi_diagram(copy, diagram, CGAL::parameters::chord_tolerance(-1.)),
               std::invalid_argument);
  CHECK(copy.number_of_faces() == mesh.number_of_faces());
  // without sources, and with one
  CHECK(Geodesic(mesh).build(CGAL::parameters::keep_windows(true)).voronoi_diagram().number_of_curves() == 0);
  Geodesic one(mesh);
  one.add_source_point(at(3));
  const Diagram whole = one.build(CGAL::parameters::keep_windows(true)).voronoi_diagram();
  CHECK(whole.number_of_curves() == 0 && whole.number_of_vertices() == 0);
  for (const Face_index f : mesh.faces()) CHECK(whole.source_at_face(f) == 0);
}

void unreachable()
{
  Surface_mesh mesh = Generated_mesh<Surface_mesh>(icosphere(2)).mesh;
  const Surface_mesh other = Generated_mesh<Surface_mesh>(torus(8, 6, 5, 0.4)).mesh;
  CGAL::copy_face_graph(other, mesh);
  Random random(3);
  const auto at = [](unsigned i) -> Source { return point_source(Vertex_index(i)); };
  compare("unreachable component", mesh, {at(0), at(20), at(70)}, random, 200);
}

void data_meshes()
{
  for (const char* const name : {"sphere.off", "elephant.off", "anchor.off", "mesh_with_border.off", "knot1.off"})
  {
    Surface_mesh mesh;
    if (!read_data_mesh(std::filesystem::path(data_directory()) / name, 20000, mesh).empty()) continue;
    Random random(7);
    compare(name, mesh, random_sources(mesh, number_of_cases(6, 50), int(totals.diagrams % 4), random), random, 500);
  }
  Surface_mesh mesh;
  if (!read_data_mesh(std::filesystem::path(data_directory()) / "rotor_small.off", 20000, mesh).empty()) return;
  // Behind saddle vertices where the sum of angles is larger than a full turn by 1e-6 only, cones part by this angle.
  Random random(7);
  compare("rotor_small, cones that part", mesh,
          {point_source(Location(Face_index(1958), {0.25, 0.25, 0.5})),
           point_source(Location(Face_index(2718), {0.1308263138, 0.8617041370, 0.0074695492}))},
          random, 100);
}

} // namespace test_voronoi_diagram

GEODESIC_OFFSET_TEST(test_voronoi_diagram)
{
  const std::pair<const char*, void (*)()> tests[] = {
    {"boxes", test_voronoi_diagram::boxes},
    {"cones", test_voronoi_diagram::cones},
    {"generated meshes", test_voronoi_diagram::generated_meshes},
    {"ties", test_voronoi_diagram::ties},
    {"beside vertices", test_voronoi_diagram::beside_vertices},
    {"curves beside vertices", test_voronoi_diagram::curves_beside_vertices},
    {"graded grids", test_voronoi_diagram::graded_grids},
    {"graded strip", test_voronoi_diagram::graded_strip},
    {"sources beside each other", test_voronoi_diagram::sources_beside_each_other},
    {"coinciding sources", test_voronoi_diagram::coinciding_sources},
    {"common end beside an edge", test_voronoi_diagram::common_end_beside_edge},
    {"end behind an edge", test_voronoi_diagram::end_behind_edge},
    {"end beside a source", test_voronoi_diagram::end_beside_source},
    {"needle strips", test_voronoi_diagram::needle_strips},
    {"cells that meet on an edge", test_voronoi_diagram::cells_that_meet_on_an_edge},
    {"windows without order", test_voronoi_diagram::windows_without_order},
    {"crossing polylines", test_voronoi_diagram::crossing_polylines},
    {"ties on a ray", test_voronoi_diagram::ties_on_a_ray},
    {"tie at a center", test_voronoi_diagram::tie_at_a_center},
    {"vertex and edge", test_voronoi_diagram::vertex_and_edge},
    {"locations on a source edge", test_voronoi_diagram::locations_on_source_edge},
    {"parts of edges at a vertex", test_voronoi_diagram::parts_of_edges_at_a_vertex},
    {"shared segments", test_voronoi_diagram::shared_segments},
    {"start value of a distance", test_voronoi_diagram::start_value_of_distance},
    {"vertex and polyline", test_voronoi_diagram::vertex_and_polyline},
    {"thin boxes", test_voronoi_diagram::thin_boxes},
    {"links", test_voronoi_diagram::links},
    {"cases of a file", test_voronoi_diagram::cases_of_file},
    {"points on an edge", test_voronoi_diagram::points_on_edge},
    {"thin faces", test_voronoi_diagram::thin_faces},
    {"small loops", test_voronoi_diagram::small_loops},
    {"bad input", test_voronoi_diagram::bad_input},
    {"unreachable", test_voronoi_diagram::unreachable},
    {data_case, test_voronoi_diagram::data_meshes}};
  const auto& totals = test_voronoi_diagram::totals;
  const int result = run_tests("test_voronoi_diagram", tests);
  std::cout.precision(3);
  std::cout << totals.diagrams << " diagrams, " << totals.curves << " curves, " << totals.vertices << " vertices, "
            << totals.crossed << " crossed faces, " << totals.divisions << " divisions, " << totals.forced
            << " forced cells; at " << totals.points << " points distances differ by at most " << totals.tie << " on curves, "
            << totals.vertex << " at vertices; " << totals.labels << " labels; areas off by at most " << totals.area
            << std::endl;
  return result;
}
