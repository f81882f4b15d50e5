// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The tree of nesting of offset curves, and their order. Oracles: point-in-polygon tests on plates with holes; on other surfaces,
// the parts into which the mesh falls if it is split along one curve.

#include "geodesic_offset/curve_order.h"
#include "generated_meshes.h"
#include "offset_tools.h"
#include "planar_pieces.h"

#include <CGAL/Surface_mesh_geodesic_offset/geodesic_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/nest_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_offset_nesting {

using namespace test;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef std::vector<CGAL::Offset_curve_nesting> Places;
constexpr std::size_t no_parent = CGAL::Offset_curve_nesting::no_parent;

/// By curve: those that surround it. Of these, the parent has most around itself.
typedef std::vector<std::vector<std::size_t>> Surrounding;

void check_places(const Places& places, const Surrounding& around, const std::vector<CGAL::Orientation>& inner)
{
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    std::size_t parent = no_parent;
    for (const std::size_t j : around[i])
      if (parent == no_parent || around[j].size() > around[parent].size()) parent = j;
    CHECK_DETAIL(places[i].parent == parent && places[i].depth == around[i].size() && places[i].inner_side == inner[i],
                 "curve " + std::to_string(i) + ": parent " + std::to_string(places[i].parent) + ", depth " +
                   std::to_string(places[i].depth) + ", side " + std::to_string(places[i].inner_side) + ", expected " +
                   std::to_string(parent) + ", " + std::to_string(around[i].size()) + ", " + std::to_string(inner[i]));
  }
}

std::vector<Point_2> planar(const Offset_curve& curve)
{
  std::vector<Point_3> points;
  curve.points(1e-5, std::back_inserter(points));
  std::vector<Point_2> result;
  for (const Point_3& p : points) result.push_back(Point_2(p.x(), p.y()));
  return result;
}

bool is_in_polygon(const Point_2& p, const std::vector<Point_2>& polygon)
{
  bool is_in = false;
  for (std::size_t i = 1; i < polygon.size(); ++i)
  {
    const Point_2 &a = polygon[i - 1], &b = polygon[i];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      is_in = !is_in;
  }
  return is_in;
}

double signed_area(const std::vector<Point_2>& polygon)
{
  double sum = 0;
  for (std::size_t i = 1; i < polygon.size(); ++i) sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]) / 2;
  return sum;
}

/// Checks a family in the plane z = 0; returns the number of curves that others surround.
std::size_t check_planar(const Offset_curves& curves)
{
  const Places places = CGAL::nest_offset_curves(curves);
  std::vector<std::vector<Point_2>> polygons;
  for (const Offset_curve& c : curves) polygons.push_back(planar(c));
  Surrounding around(curves.size());
  std::vector<CGAL::Orientation> inner;
  std::size_t surrounded = 0;
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    inner.push_back(!curves[i].is_closed()         ? CGAL::COLLINEAR
                    : signed_area(polygons[i]) > 0 ? CGAL::LEFT_TURN
                                                   : CGAL::RIGHT_TURN);
    for (std::size_t j = 0; j < curves.size(); ++j)
    {
      if (j == i || !curves[j].is_closed()) continue;
      // most of some points: others may be within the chord tolerance of the polygon
      std::size_t number = 0;
      for (std::size_t k = 0; k < 5; ++k) number += is_in_polygon(polygons[i][k * polygons[i].size() / 5], polygons[j]) ? 1 : 0;
      if (number > 2) around[i].push_back(j);
    }
    surrounded += around[i].empty() ? 0 : 1;
  }
  check_places(places, around, inner);
  return surrounded;
}

/// Star-shaped polygon around a point.
std::vector<Point_2> star(const Point_2& center, double least, double largest, Random& random)
{
  std::vector<Point_2> polygon;
  const std::size_t n = 5 + uniform_index(random, 9);
  for (std::size_t i = 0; i <= n; ++i)
  {
    const double angle = 2 * CGAL_PI * (static_cast<double>(i) + 0.3) / static_cast<double>(n);
    polygon.push_back(center + uniform(random, least, largest) * turned(Vector_2(1, 0), angle));
  }
  polygon.back() = polygon.front();
  return polygon;
}

/// A plate [0, 8] x [0, 8]: of two triangles, of a grid with or without noise, or of random triangles; with ragged holes.
Surface_mesh plate(unsigned family, Random& random)
{
  const unsigned kind = family % 4;
  Soup soup = kind == 0 ? planar_grid(1 + family % 3, 1, Diagonals::forward, 1)
            : kind == 1 ? planar_grid(16, 16, Diagonals::random, 0.5, 0, family + 1)
            : kind == 2 ? jittered_grid(8, 8, family + 1)
                        : random_rectangle(8, 8, 20 + uniform_index(random, 800), 1 + uniform_index(random, 12), family + 1);
  if (kind == 0)
    for (Point_3& p : soup.points) p = Point_3(8 * p.x() / (1 + family % 3), 8 * p.y(), 0);
  Surface_mesh mesh = mesh_of(soup);
  if (kind == 0) return mesh;
  for (std::size_t holes = uniform_index(random, 4); holes > 0; --holes)
  {
    const auto hole = star(Point_2(uniform(random, 2, 6), uniform(random, 2, 6)), 0.3, 1.5, random);
    for (const auto f : faces(mesh))
    {
      Vector_3 sum(0, 0, 0);
      for (const auto v : vertices_around_face(halfedge(f, mesh), mesh)) sum = sum + (mesh.point(v) - CGAL::ORIGIN) / 3;
      if (is_in_polygon(Point_2(sum.x(), sum.y()), hole)) CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
    }
  }
  PMP::keep_largest_connected_components(mesh, 1);
  return mesh;
}

void add_random_sources(Geodesic& geodesic, Random& random)
{
  const auto place = [&] { return Point_3(uniform(random, 0, 8), uniform(random, 0, 8), 0); };
  for (std::size_t n = 1 + uniform_index(random, 4); n > 0; --n) switch (uniform_index(random, 6))
    {
    case 0: geodesic.add_source_boundary(); break;
    case 1:
    case 2:
    {
      std::vector<Point_3> corners;
      for (const Point_2& p : star(Point_2(uniform(random, 2, 6), uniform(random, 2, 6)), 0.4, 2, random))
        corners.push_back(Point_3(p.x(), p.y(), 0));
      corners.pop_back();
      try
      {
        geodesic.add_source_polyline(geodesic.locate_polyline(corners, CGAL::parameters::is_closed(true)));
      }
      catch (const std::invalid_argument&) // across a hole
      {
        geodesic.add_source_point(geodesic.locate(corners[0]));
      }
      break;
    }
    case 3:
    {
      const auto v = vertices(geodesic.mesh().triangle_mesh());
      geodesic.add_source_point(
        *std::next(v.begin(), std::ptrdiff_t(uniform_index(random, std::size_t(std::distance(v.begin(), v.end()))))));
      break;
    }
    default: geodesic.add_source_point(geodesic.locate(place()));
    }
}

void plates()
{
  Random random(1);
  std::size_t curves_of_all = 0, surrounded = 0, open = 0;
  for (unsigned family = 0; family < 200; ++family)
  {
    const Surface_mesh mesh = plate(family, random);
    Geodesic geodesic(mesh);
    add_random_sources(geodesic, random);
    const double tolerance = family % 7 == 6 ? 1e-4 : 0;
    geodesic.build(CGAL::parameters::compute_largest_distance(true).relative_tolerance(tolerance));
    const double largest = geodesic.largest_distance().value();
    std::vector<double> levels;
    for (std::size_t n = 2 + uniform_index(random, 9), i = 1; i <= n; ++i)
      levels.push_back(family % 4 == 1 ? 0.5 * static_cast<double>(i)
                                       : largest * (static_cast<double>(i) - uniform(random, 0, 0.5)) / static_cast<double>(n));
    const auto side = family % 5 == 4 ? CGAL::Offset_side::LEFT : CGAL::Offset_side::BOTH;
    Report::instance().set_context("family " + std::to_string(family));
    const Offset_curves curves = offsets(geodesic, levels, side);
    surrounded += check_planar(curves);
    curves_of_all += curves.size();
    open += curves.size() - number_of_closed(curves);
  }
  CHECK(surrounded > 500 && open > 500);
  std::cout << "plates: " << curves_of_all << " curves, " << open << " open, " << surrounded << " with a parent\n";
}

/// The connected parts of the surface beside some curves, by face of a copy of the mesh that is split along them.
struct Parts
{
  Surface_mesh mesh;
  Surface_mesh::Property_map<Surface_mesh::Face_index, std::size_t> part;
  std::size_t number;

  Parts(const Surface_mesh& whole, const Offset_curves& curves) : mesh(whole)
  {
    const auto on_curve = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:on_curve", false).first;
    part = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:part", 0).first;
    CGAL::split_along_offset_curves(mesh, curves, CGAL::parameters::chord_tolerance(1e-5).edge_is_constrained_map(on_curve));
    number = PMP::connected_components(mesh, part, CGAL::parameters::edge_is_constrained_map(on_curve));
  }

  std::size_t part_of(const Point_3& p) const { return part[PMP::locate(p, mesh).first]; }

  Point_3 point_of_largest() const
  {
    std::vector<double> area(number, 0);
    for (const auto f : mesh.faces()) area[part[f]] += PMP::face_area(f, mesh);
    const auto largest = std::size_t(std::max_element(area.begin(), area.end()) - area.begin());
    const auto is_in = [&](const auto f) { return part[f] == largest; };
    const auto widest = [&](const auto f, const auto g) {
      return (is_in(f) ? PMP::face_area(f, mesh) : 0) < (is_in(g) ? PMP::face_area(g, mesh) : 0);
    };
    const auto f = *std::max_element(mesh.faces().begin(), mesh.faces().end(), widest);
    const auto v = mesh.vertices_around_face(mesh.halfedge(f));
    return CGAL::centroid(mesh.point(*v.begin()), mesh.point(*std::next(v.begin())), mesh.point(*std::next(v.begin(), 2)));
  }
};

/// Closed surfaces: the outermost cell is the largest, and a curve has an interior if the surface falls apart along it.
void closed_surfaces()
{
  const std::pair<const char*, Soup> soups[] = {
    {"cube", cube_grid(4)}, {"icosphere", icosphere(2)}, {"torus", torus(14, 9)}, {"genus 5", marching_genus_5(10)}};
  Random random(2);
  std::size_t with_parent = 0, without_interior = 0, curves_of_all = 0;
  for (const auto& [name, soup] : soups)
    for (int family = 0; family < 6; ++family)
    {
      const Surface_mesh mesh = mesh_of(soup);
      Geodesic geodesic(mesh);
      for (std::size_t n = 1 + uniform_index(random, 3); n > 0; --n)
      {
        const double u = uniform(random, 0.1, 0.5);
        geodesic.add_source_point(Face_location(Surface_mesh::Face_index(unsigned(uniform_index(random, num_faces(mesh)))),
                                                {u, 0.3, 0.7 - u}));
      }
      geodesic.build();
      std::vector<double> levels;
      for (int i = 1; i < 7; ++i)
        levels.push_back((i - uniform(random, 0.1, 0.9)) / 6 * geodesic.largest_vertex_distance().value());
      Report::instance().set_context(std::string(name) + ", family " + std::to_string(family));
      const Offset_curves curves = offsets(geodesic, levels);
      const Point_3 outside = Parts(mesh, curves).point_of_largest();
      Surrounding around(curves.size());
      std::vector<CGAL::Orientation> inner;
      for (std::size_t j = 0; j < curves.size(); ++j)
      {
        const Parts parts(mesh, {curves[j]});
        inner.push_back(CGAL::COLLINEAR);
        if (!CHECK(parts.number <= 2) || parts.number == 1) continue;
        const std::size_t outer = parts.part_of(outside);
        for (std::size_t i = 0; i < curves.size(); ++i)
          if (i != j && parts.part_of(curves[i].piece(0).point(0.5)) != outer) around[i].push_back(j);
        // a point beside the middle of a long piece, towards the sources
        std::size_t longest = 0;
        for (std::size_t k = 0; k < curves[j].number_of_pieces(); ++k)
          if (curves[j].piece(k).length() > curves[j].piece(longest).length()) longest = k;
        const auto p = curves[j].oriented_point(longest, 0.5);
        const Vector_3 to_left = CGAL::cross_product(p.normal, p.tangent);
        const Point_3 left = p.point + 0.01 * curves[j].piece(longest).length() * to_left;
        inner.back() = parts.part_of(left) != outer ? CGAL::LEFT_TURN : CGAL::RIGHT_TURN;
      }
      for (std::size_t i = 0; i < curves.size(); ++i)
      {
        with_parent += around[i].empty() ? 0 : 1;
        without_interior += inner[i] == CGAL::COLLINEAR ? 1 : 0;
      }
      curves_of_all += curves.size();
      check_places(CGAL::nest_offset_curves(curves), around, inner);
    }
  CHECK(with_parent > 50 && without_interior > 20);
  std::cout << "closed surfaces: " << curves_of_all << " curves, " << with_parent << " with a parent, " << without_interior
            << " without interior\n";
}

double length(const Vector_3& v) { return std::sqrt(v * v); }

/// Both orders: the curves are those given, parents are where they say, and closed curves start nearest to their parents.
void order()
{
  using geodesic_offset::Curve_order;
  Random random(3);
  std::size_t moved = 0;
  for (unsigned family = 0; family < 12; ++family)
  {
    const Surface_mesh mesh = family % 3 == 2 ? mesh_of(icosphere(2)) : plate(family, random);
    Geodesic geodesic(mesh);
    if (family % 3 == 2) geodesic.add_source_point(Surface_mesh::Vertex_index(3));
    else add_random_sources(geodesic, random);
    geodesic.build(CGAL::parameters::compute_largest_distance(true));
    std::vector<double> levels;
    for (int i = 1; i < 8; ++i) levels.push_back(i * 0.124 * geodesic.largest_distance().value());
    Report::instance().set_context("order, family " + std::to_string(family));
    const Offset_curves given = offsets(geodesic, levels);
    for (const Curve_order o : {Curve_order::by_nesting, Curve_order::by_distance})
    {
      Offset_curves curves = given;
      const Places places = geodesic_offset::order_curves(curves, o), again = CGAL::nest_offset_curves(curves);
      double worst = 0;
      CHECK(places.size() == curves.size() && same_curves(curves, given, 1, worst));
      for (std::size_t i = 0; i < curves.size(); ++i)
      {
        CHECK(places[i].parent == again[i].parent && places[i].depth == again[i].depth &&
              places[i].inner_side == again[i].inner_side);
        if (o == Curve_order::by_distance) CHECK(i == 0 || curves[i - 1].distance() <= curves[i].distance());
        else // the parent is the last curve before of a smaller depth
          for (std::size_t j = i; places[i].depth > 0 && j-- > 0;)
            if (places[j].depth < places[i].depth)
            {
              CHECK(j == places[i].parent);
              break;
            }
        if (!curves[i].is_closed()) continue;
        const Point_3 start = curves[i].point(0);
        std::vector<Point_3> points;
        curves[i].points(1e-4, std::back_inserter(points));
        CHECK(points.front() == start && points.back() == start);
        CHECK(length(curves[i].elements(0).front().start() - start) < 1e-12);
        if (places[i].parent == no_parent) continue;
        ++moved;
        const Point_3 goal = curves[places[i].parent].point(0);
        double nearest = infinity;
        for (std::size_t k = 0; k < curves[i].number_of_pieces(); ++k)
          for (int m = 0; m <= 50; ++m) nearest = (std::min)(nearest, length(curves[i].piece(k).point(m / 50.) - goal));
        CHECK_DETAIL(length(start - goal) <= nearest + 1e-12, values(length(start - goal), nearest));
      }
    }
  }
  CHECK(moved > 100);
}

/// A flat torus of side 1, with lengths instead of points: the largest cell is between the curves around the source and that around the
/// farthest point.
void lengths()
{
  const unsigned n = 20;
  Surface_mesh mesh;
  std::vector<Surface_mesh::Vertex_index> v;
  for (unsigned i = 0; i < n * n; ++i) v.push_back(mesh.add_vertex(Point_3(0, 0, 0)));
  const auto at = [&](unsigned i, unsigned j) { return v[(i % n) * n + j % n]; };
  const auto length_of = mesh.add_property_map<Surface_mesh::Edge_index, double>("e:length", 1. / n).first;
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) length_of[mesh.edge(mesh.halfedge(at(i, j), at(i + 1, j + 1)))] = std::sqrt(2.) / n;
  const auto np = CGAL::parameters::edge_length_map(length_of);
  std::vector<CGAL::Geodesic_offset_curve_type<Surface_mesh, std::decay_t<decltype(np)>>> curves;
  CGAL::geodesic_offset_curves(mesh, at(3, 4), std::vector<double>{0.2, 0.4, 0.6}, std::back_inserter(curves), np);
  if (!CHECK(curves.size() == 3)) return;
  for (int turn = 0; turn < 2; ++turn)
  {
    const Places places = CGAL::nest_offset_curves(curves);
    CHECK(places[0].parent == 1 && places[0].inner_side == CGAL::LEFT_TURN && places[0].depth == 1);
    CHECK(places[1].parent == no_parent && places[1].inner_side == CGAL::LEFT_TURN);
    CHECK(places[2].parent == no_parent && places[2].inner_side == CGAL::RIGHT_TURN);
    for (auto& c : curves) c = c.starting_at(c.number_of_pieces() / 2, 0.3);
  }
}

/// No curves, and curves that were moved from.
void misuse()
{
  const Surface_mesh mesh = mesh_of(random_rectangle(8, 8, 60, 4, 3));
  Geodesic geodesic(mesh);
  geodesic.add_source_point(geodesic.locate(Point_3(3, 4, 0)));
  geodesic.build();
  Offset_curves curves = offsets(geodesic, std::vector<double>{0.5, 1., 2.});
  CHECK(CGAL::nest_offset_curves(Offset_curves()).empty());
  const Places places = CGAL::nest_offset_curves(curves);
  if (!CHECK(places.size() == 3)) return;
  CHECK(places[0].parent == 1 && places[1].parent == 2 && places[2].parent == no_parent && places[0].depth == 2);
  const Offset_curve target = std::move(curves[1]);
  CHECK_THROWS(CGAL::nest_offset_curves(curves), std::logic_error);
}

} // namespace test_offset_nesting

GEODESIC_OFFSET_TEST(test_offset_nesting)
{
  const std::vector<std::pair<const char*, void (*)()>> tests = {
    {"plates", plates}, {"closed surfaces", closed_surfaces}, {"order", order}, {"lengths", lengths}, {"misuse", misuse}};
  return run_tests("test_offset_nesting", tests);
}
