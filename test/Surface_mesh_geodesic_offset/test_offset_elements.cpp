// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Elements of offset curves: they cover the curve, are exact, and are no more than the geometry has.

#include "generated_meshes.h"
#include "offset_tools.h"
#include "planar_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_offset_elements {

using namespace test;

typedef Offset_curve::Element Element;

double length(const Vector_3& v) { return std::sqrt(v * v); }

/// Distance of a point from the whole line or circle of an element.
double deviation(const Element& e, const Point_3& p)
{
  if (e.is_segment()) return length(CGAL::cross_product(p - e.start(), e.end() - e.start())) / length(e.end() - e.start());
  const double height = (p - e.center()) * e.normal();
  return std::hypot(height, length(p - e.center() - height * e.normal()) - e.radius());
}

struct Worst
{
  double length = 0, radius = 0;
};

/// The pieces of the curve, by points at parameters of each, are on their elements, which follow one another.
void check_elements(const Offset_curve& curve, const std::vector<Element>& elements, double size, Worst& worst)
{
  const std::size_t n = curve.number_of_pieces();
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * size;
  double sum = 0;
  std::size_t pieces = 0;
  for (std::size_t k = 0; k < elements.size(); ++k)
  {
    const Element& e = elements[k];
    sum += e.length();
    pieces += e.number_of_pieces();
    const bool is_last = k + 1 == elements.size();
    if (!is_last || curve.is_closed())
    {
      const Element& next = elements[is_last ? 0 : k + 1];
      CHECK(e.end() == next.start() && (e.first_piece() + e.number_of_pieces()) % n == next.first_piece());
    }
    CHECK(!e.faces().empty() && e.faces().size() <= e.number_of_pieces() && std::abs(length(e.normal()) - 1) < 1e-12);
    CHECK(length(e.point(0) - e.start()) <= rounding && length(e.point(1) - e.end()) <= 1e-9 * size);
    CHECK(e.sweep() >= 0 && e.sweep() <= 2 * CGAL_PI * (1 + 1e-12));
    for (std::size_t i = e.first_piece(); i < e.first_piece() + e.number_of_pieces(); ++i)
    {
      const auto piece = curve.piece(i % n);
      CHECK(!e.source() || *e.source() == piece.source());
      CHECK(!e.side() || *e.side() == piece.side());
      for (const double t : {0., 0.21, 0.5, 0.83, 1.})
      {
        const Point_3 p = piece.point(t);
        if (e.is_segment()) CHECK_DETAIL(deviation(e, p) <= rounding + 1e-11 * e.length(), values(deviation(e, p), 0));
        if (e.is_segment()) continue;
        const double off = std::abs(length(p - e.center()) - e.radius());
        CHECK_DETAIL(off <= 1e-12 * e.radius() + rounding, values(off, e.radius()));
        worst.radius = (std::max)(worst.radius, off / (e.radius() + rounding / 1e-12));
        CHECK_DETAIL(std::abs((p - e.center()) * e.normal()) <= 1e-9 * e.radius() + rounding,
                     values((p - e.center()) * e.normal(), e.radius()));
      }
    }
  }
  const double l = curve.length();
  CHECK_DETAIL(pieces == n && std::abs(sum - l) <= 1e-12 * l, values(sum, l));
  worst.length = (std::max)(worst.length, std::abs(sum - l) / l);
  if (curve.is_closed()) return;
  CHECK(elements.front().start() == curve.point(curve.piece(0).start()));
  CHECK(elements.back().end() == curve.point(curve.piece(n - 1).end()));
}

/// Consecutive elements of one kind are on different lines or circles.
void check_maximal(const Offset_curve& curve, const std::vector<Element>& elements, double size)
{
  for (std::size_t k = 0; k < elements.size(); ++k)
  {
    if (elements.size() == 1 || (k == 0 && !curve.is_closed())) continue;
    const Element &e = elements[k > 0 ? k - 1 : elements.size() - 1], &f = elements[k];
    if (e.is_arc() != f.is_arc() || e.length() < 1e-3 * size || f.length() < 1e-3 * size) continue;
    double off = 0;
    for (const double t : {0.3, 0.6, 1.}) off = (std::max)({off, deviation(e, f.point(t)), deviation(f, e.point(1 - t))});
    CHECK_DETAIL(off > 1e-10 * size, values(off, f.length()));
  }
}

/// Random star-shaped polygon around (2, 2).
std::vector<Point_2> random_polygon(Random& random)
{
  std::vector<Point_2> polygon;
  const std::size_t n = 5 + uniform_index(random, 9);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2 * CGAL_PI * (static_cast<double>(i) + uniform(random, 0, 0.8)) / static_cast<double>(n);
    const double radius = uniform(random, 0.35, 1.3);
    polygon.push_back(Point_2(2 + radius * std::cos(angle), 2 + radius * std::sin(angle)));
  }
  return polygon;
}

struct Number_of_elements
{
  std::size_t segments = 0, arcs = 0;
};

/// Segments and arcs of the offset of a polygon in the plane, on both sides: parts of the lines parallel to its edges and of the
/// circles around its corners that are not nearer to another part of the polygon, found by points on them. None if a part, or the
/// gap between two parts, is too small to be certain.
std::optional<Number_of_elements> planar_elements(const std::vector<Point_2>& polygon, double d)
{
  const std::size_t n = polygon.size();
  bool is_certain = true;
  const auto parts = [&](const auto& at) {
    constexpr int samples = 3000, least = 6;
    std::size_t result = 0;
    int run = 0;
    bool is_kept = false;
    for (int k = 0; k <= samples; ++k)
    {
      const Point_2 p = at(k / static_cast<double>(samples));
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < n; ++i) nearest = (std::min)(nearest, segment_distance(p, polygon[i], polygon[(i + 1) % n]));
      const bool is_offset = nearest >= d - 1e-9;
      if (k > 0 && is_offset == is_kept)
      {
        ++run;
        continue;
      }
      if (k > 0 && run < least) is_certain = false;
      result += is_offset ? 1 : 0;
      is_kept = is_offset;
      run = 1;
    }
    if (run < least) is_certain = false;
    return result;
  };
  Number_of_elements result;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point_2 &a = polygon[(i + n - 1) % n], &b = polygon[i], &c = polygon[(i + 1) % n];
    const Vector_2 u = (b - a) / distance(a, b), v = (c - b) / distance(b, c);
    for (const double side : {-1., 1.})
      result.segments += parts([&](double t) { return b + t * (c - b) + side * d * quarter_turn(v); });
    const double turn = std::atan2(cross(u, v), u * v); // the arc is on the other side
    result.arcs += parts([&](double t) { return b + (turn > 0 ? -d : d) * turned(quarter_turn(u), t * turn); });
  }
  return is_certain ? std::optional(result) : std::nullopt;
}

/// Pockets of random polygons on finely and randomly triangulated plates: as many segments and arcs as in the plane, with centers
/// at the corners.
void planar_families()
{
  Random random(1);
  Worst worst;
  std::size_t compared = 0, uncertain = 0, elements_of_all = 0, pieces_of_all = 0;
  for (unsigned family = 0; family < 50; ++family)
  {
    const Soup flat = random_rectangle(4, 4, 300 + uniform_index(random, 2000), 10, family + 1);
    const Soup soup = family % 2 == 0 ? flat : rotated(flat, family + 1);
    const Surface_mesh mesh = mesh_of(soup);
    const Point_3 origin = soup.points[0];
    const Vector_3 x = (soup.points[1] - origin) / 4, y = (soup.points[3] - origin) / 4;
    const std::vector<Point_2> polygon = random_polygon(random);
    std::vector<Point_3> corners;
    for (const Point_2& p : polygon) corners.push_back(origin + p.x() * x + p.y() * y);
    Geodesic geodesic(mesh);
    geodesic.add_source_polyline(geodesic.locate_polyline(corners, CGAL::parameters::is_closed(true)));
    geodesic.build();
    for (int level = 0; level < 4; ++level)
    {
      const double d = uniform(random, 0.02, 0.5);
      Report::instance().set_context("planar family " + std::to_string(family) + ", distance " + std::to_string(d));
      const auto expected = planar_elements(polygon, d);
      Number_of_elements actual;
      for (const Offset_curve& curve : offsets(geodesic, std::vector<double>{d}))
      {
        const std::vector<Element> elements = curve.elements(0);
        check_elements(curve, elements, 4, worst);
        elements_of_all += elements.size();
        pieces_of_all += curve.number_of_pieces();
        for (const Element& e : elements)
        {
          (e.is_arc() ? actual.arcs : actual.segments) += 1;
          CHECK(e.source() == std::optional<std::size_t>(0) && e.side() && *e.side() == *curve.side());
          if (e.is_segment()) continue;
          double nearest = std::numeric_limits<double>::infinity();
          for (const Point_3& p : corners) nearest = (std::min)(nearest, length(p - e.center()));
          CHECK_DETAIL(nearest <= 1e-12 * 4, values(nearest, 0));
        }
      }
      uncertain += expected ? 0 : 1;
      if (!expected) continue;
      ++compared;
      CHECK_DETAIL(actual.segments == expected->segments && actual.arcs == expected->arcs,
                   std::to_string(actual.segments) + " segments, " + std::to_string(actual.arcs) + " arcs, expected " +
                     std::to_string(expected->segments) + " and " + std::to_string(expected->arcs));
    }
  }
  CHECK(compared >= 100);
  std::cout << "planar: " << compared << " offsets compared, " << uncertain << " uncertain, " << elements_of_all
            << " elements of " << pieces_of_all << " pieces; errors: length " << worst.length << ", radius " << worst.radius
            << "\n";
}

void spatial_families()
{
  const std::pair<const char*, Soup> soups[] = {
    {"cube", cube_grid(10)},
    {"turned cube", rotated(cube_grid(12), 5)},
    {"saddle", saddle_fan()},
    {"turned saddle", rotated(saddle_fan(7, 3 * CGAL_PI), 2)},
    {"bumpy grid", with_noise(jittered_grid(20, 20, 7), 0.2, 3)},
    {"crumpled needles", crumpled_needles(1e-2, 1e-2, 100, 4)},
    {"torus", torus(40, 30)},
    {"icosphere", icosphere(3)},
    {"marching sphere", marching_sphere()},
    {"needles", needle_fan(60)}};
  Random random(2);
  Worst worst;
  std::size_t arcs = 0, elements_of_all = 0, pieces_of_all = 0;
  for (const auto& [name, soup] : soups)
  {
    const Surface_mesh mesh = mesh_of(soup);
    const double size = size_of(mesh);
    for (int family = 0; family < 5; ++family)
    {
      Geodesic geodesic(mesh);
      const auto face = *std::next(faces(mesh).begin(), static_cast<std::ptrdiff_t>(uniform_index(random, num_faces(mesh))));
      const double u = uniform(random), v = uniform(random) * (1 - u);
      if (family % 2 == 0) geodesic.add_source_point(Face_location(face, {u, v, 1 - u - v}));
      else geodesic.add_source_point(source(halfedge(face, mesh), mesh));
      geodesic.build();
      std::vector<double> levels;
      for (int i = 0; i < 4; ++i) levels.push_back(uniform(random, 0.05, 0.95) * geodesic.largest_vertex_distance().value());
      Report::instance().set_context(std::string(name) + ", family " + std::to_string(family));
      for (const Offset_curve& curve : offsets(geodesic, levels))
      {
        const std::vector<Element> elements = curve.elements(0);
        check_elements(curve, elements, size, worst);
        check_maximal(curve, elements, size);
        elements_of_all += elements.size();
        pieces_of_all += curve.number_of_pieces();
        for (const Element& e : elements) arcs += e.is_arc() && e.number_of_pieces() > 1 ? 1 : 0;
      }
    }
  }
  CHECK(arcs > 100);
  std::cout << "spatial: " << elements_of_all << " elements of " << pieces_of_all << " pieces, " << arcs
            << " joined arcs; errors: length " << worst.length << ", radius " << worst.radius << "\n";
}

/// A circle on a plate with noise is one arc within a tolerance, and many without.
void tolerances()
{
  const double noise = 1e-4;
  const Surface_mesh mesh = mesh_of(with_noise(jittered_grid(30, 30, 3), noise, 5));
  Geodesic geodesic(mesh);
  geodesic.add_source_point(geodesic.locate(Point_3(15.2, 14.7, 0)));
  geodesic.build();
  const Offset_curves curves = offsets(geodesic, std::vector<double>{9.});
  if (!CHECK(curves.size() == 1)) return;
  CHECK(curves[0].elements(0).size() > 100);
  const std::vector<Element> elements = curves[0].elements(20 * noise);
  if (!CHECK_DETAIL(elements.size() == 1, std::to_string(elements.size()))) return;
  const Element& e = elements[0];
  CHECK(e.is_arc() && std::abs(e.sweep() - 2 * CGAL_PI) < 1e-9 && e.end() == e.start());
  CHECK(std::abs(e.normal().z() - 1) < 1e-6 && length(e.center() - Point_3(15.2, 14.7, 0)) < 20 * noise);
  for (const auto& piece : curves[0].pieces()) CHECK(deviation(e, piece.point(0.5)) <= 21 * noise);
  for (const double bad : {-1e-300, std::nan("")}) CHECK_THROWS(curves[0].elements(bad), std::invalid_argument);
  Offset_curve moved = curves[0];
  const Offset_curve target = std::move(moved);
  CHECK(moved.elements(0).empty() && target.elements(0).size() > 100);
}

/// Two collinear sources: the segments beside both are one element each, of no single source. The caps are half circles.
void sources_and_sides()
{
  const Surface_mesh mesh = mesh_of(random_rectangle(4, 4, 500, 10, 3));
  Geodesic geodesic(mesh);
  const auto add = [&](double from, double to) {
    return geodesic.add_source_polyline(geodesic.locate_polyline(std::vector<Point_3>{Point_3(from, 2, 0), Point_3(to, 2, 0)}));
  };
  const std::size_t first = add(1.5, 2), second = add(2, 2.5);
  geodesic.build();
  const Offset_curves curves = offsets(geodesic, std::vector<double>{0.3});
  if (!CHECK(curves.size() == 1 && curves[0].is_closed())) return;
  const std::vector<Element> elements = curves[0].elements(0);
  if (!CHECK_DETAIL(elements.size() == 4, std::to_string(elements.size()))) return;
  for (const Element& e : elements)
  {
    if (e.is_segment())
    {
      CHECK(!e.source() && std::abs(e.length() - 1) < 1e-12);
      CHECK(e.side() && *e.side() == (e.start().y() > 2 ? CGAL::Source_side::LEFT : CGAL::Source_side::RIGHT));
      continue;
    }
    CHECK(e.side() == std::optional(CGAL::Source_side::CAP) && std::abs(e.sweep() - CGAL_PI) < 1e-9);
    CHECK(e.source() && *e.source() == (e.center().x() < 2 ? first : second));
  }
}

} // namespace test_offset_elements

GEODESIC_OFFSET_TEST(test_offset_elements)
{
  const std::vector<std::pair<const char*, void (*)()>> tests = {
    {"planar families", planar_families},
    {"spatial families", spatial_families},
    {"tolerances", tolerances},
    {"sources and sides", sources_and_sides}};
  return run_tests("test_offset_elements", tests);
}
