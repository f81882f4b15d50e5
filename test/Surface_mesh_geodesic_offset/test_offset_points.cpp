// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points of offset curves: within the tolerance, and few.

#include "data_meshes.h"
#include "generated_meshes.h"
#include "offset_tools.h"
#include "thin_polylines.h"

#include <CGAL/Surface_mesh_geodesic_offset/IO/write_dxf.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_svg.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_vtk.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_offset_points {

using namespace test;

typedef std::vector<Geodesic::Offset_curve> Curves;

// All curves at multiples of a fraction of the largest distance.
Curves curves_at_levels(const Surface_mesh& mesh, std::size_t levels)
{
  Geodesic geodesic(mesh);
  geodesic.add_source_point(*vertices(mesh).begin());
  geodesic.build();
  std::vector<double> distances;
  for (std::size_t i = 1; i <= levels; ++i)
    distances.push_back(geodesic.largest_vertex_distance().value() * static_cast<double>(i) / static_cast<double>(levels + 1));
  Curves curves;
  geodesic.offset_curves(distances, std::back_inserter(curves));
  CHECK(curves.size() >= levels);
  return curves;
}

// At most 1.3 times the points that Douglas and Peucker need, from the points of all pieces or from a much finer polyline.
void few_points(const std::string& name, const Curves& curves, double tolerance, double size)
{
  std::size_t written = 0, piecewise = 0, needed = 0;
  for (const auto& curve : curves)
  {
    check_thin_polyline(curve, tolerance, size);
    written += curve_points(curve, tolerance).size();
    const Polyline_3 points = piecewise_points(curve, tolerance);
    piecewise += points.size();
    needed += (std::min)(points_needed(points, tolerance), points_needed(piecewise_points(curve, tolerance / 64), tolerance));
  }
  std::cout << name << ", tolerance " << tolerance << ": " << written << " points, " << needed << " needed, " << piecewise
            << " piece by piece\n";
  CHECK_DETAIL(static_cast<double>(written) <= 1.3 * static_cast<double>(needed),
               std::to_string(written) + " points, needed " + std::to_string(needed));
}

void generated()
{
  const std::pair<const char*, Soup> soups[] = {
    {"cube", cube_grid(10)},
    {"turned cube", rotated(cube_grid(12), 5)},
    {"grid", jittered_grid(40, 40, 7)},
    {"coarse rectangle", random_rectangle(4, 3, 5, 2, 3)},
    {"torus", torus(40, 30)},
    {"icosphere", icosphere(3)},
    {"needles", needle_fan(60)}};
  for (const auto& [name, soup] : soups)
  {
    const Surface_mesh mesh = mesh_of(soup);
    const double size = size_of(mesh);
    const Curves curves = curves_at_levels(mesh, 15);
    for (double part : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6})
    {
      Report::instance().set_context(std::string(name) + ", tolerance " + std::to_string(part));
      few_points(name, curves, part * size, size);
    }
  }
}

void data_meshes()
{
  for (const char* name : {"fandisk.off", "armadillo.off"})
  {
    const std::filesystem::path file = std::filesystem::path(data_directory()) / name;
    Surface_mesh mesh;
    if (!std::filesystem::exists(file))
    {
      std::cout << "no " << name << "\n";
      continue;
    }
    Report::instance().set_context(name);
    if (!CHECK(read_data_mesh(file, 1000000, mesh).empty())) continue;
    const double size = size_of(mesh);
    const Curves curves = curves_at_levels(mesh, 20);
    for (double part : {1e-2, 1e-3, 1e-4}) few_points(name, curves, part * size, size);
  }
}

// An offset inside a square is a square: five points, at its corners.
void squares()
{
  for (unsigned seed = 1; seed <= 6; ++seed)
    for (const double shift : {0., 0.3137})
    {
      const Soup flat = jittered_grid(20, 20, seed), turned = rotated(flat, seed);
      const Surface_mesh mesh = mesh_of(seed % 2 == 1 ? flat : turned);
      const double d = 0.1 + 0.7 * seed;
      // three points of a planar grid determine the affine map
      const auto& points = seed % 2 == 1 ? flat.points : turned.points;
      const Point_3 origin = points[0];
      const double width = std::sqrt(CGAL::squared_distance(points[0], points[20]));
      const Vector_3 x = (points[20] - points[0]) / width, y = (points[21 * 20] - points[0]) / width;
      const auto at = [&](double u, double v) { return origin + width * (u * x + v * y); };
      const double low = 0.2 + shift * 0.1, high = 0.8 - shift * 0.07; // less than half of the area
      const double inner = d / 20;                                     // in widths
      Geodesic geodesic(mesh);
      const auto square =
        geodesic.locate_polyline(std::vector<Point_3>{at(low, low), at(high, low), at(high, high), at(low, high)},
                                 CGAL::parameters::is_closed(true));
      geodesic.add_source_polyline(square);
      geodesic.build();
      Curves curves;
      geodesic.offset_curves(std::vector<double>{inner * width}, std::back_inserter(curves),
                             CGAL::parameters::offset_side(CGAL::Offset_side::INSIDE));
      if (!CHECK(curves.size() == 1)) continue;
      CHECK(curves[0].number_of_pieces() > 20);
      for (double tolerance : {1e-2, 1e-4, 1e-6, 1e-9})
      {
        Report::instance().set_context("square " + std::to_string(seed) + ", tolerance " + std::to_string(tolerance));
        const Polyline_3 polyline = curve_points(curves[0], tolerance * width);
        CHECK_DETAIL(polyline.size() == 5, std::to_string(polyline.size()));
        for (double u : {low + inner, high - inner})
          for (double v : {low + inner, high - inner})
          {
            double nearest = infinity;
            for (const Point_3& p : polyline) nearest = (std::min)(nearest, std::sqrt(CGAL::squared_distance(p, at(u, v))));
            // a corner may be replaced by a point where the polyline leaves its face, within a fraction of the tolerance
            CHECK_DETAIL(nearest <= tolerance * width / 256 + 1e-11 * width, values(nearest, 0));
          }
        check_thin_polyline(curves[0], tolerance * width, width);
      }
    }
}

std::size_t occurrences(const std::string& text, const std::string& part)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// In files with true arcs, an arc or a segment is one however many faces it crosses: the outer offset of a square has four
// of each, the inner one four segments; a circle has two arcs in a DXF file and three in an SVG file. Faces may be coplanar
// up to seven digits, which divides a circle into thousands of pieces.
void true_arcs()
{
  for (const bool is_rounded : {false, true})
    for (const std::size_t n : {20, 100})
    {
      Report::instance().set_context("true arcs, " + std::to_string(n) + (is_rounded ? ", rounded" : ""));
      Soup soup = jittered_grid(n, n, 3);
      if (is_rounded) soup = rotated(soup, 4);
      if (is_rounded)
        for (Point_3& p : soup.points) p = Point_3(float(p.x()), float(p.y()), float(p.z()));
      const Surface_mesh mesh = mesh_of(soup);
      const Vector_3 x = soup.points[n] - soup.points[0], y = soup.points[(n + 1) * n] - soup.points[0];
      const auto at = [&](double u, double v) { return soup.points[0] + u * x + v * y; };
      const double width = std::sqrt(x * x);
      const auto write = [&](Geodesic& geodesic, double distance, std::string& dxf, std::string& svg) {
        Curves curves;
        geodesic.build_with_offset_curves(distance, std::back_inserter(curves));
        std::ostringstream dxf_stream, svg_stream;
        CHECK(CGAL::IO::write_offset_DXF(dxf_stream, curves, CGAL::parameters::chord_tolerance(1e-4 * width)) &&
              CGAL::IO::write_offset_SVG(svg_stream, curves));
        dxf = dxf_stream.str();
        svg = svg_stream.str();
        return curves.size();
      };
      std::string dxf, svg;
      Geodesic circle(mesh);
      circle.add_source_point(circle.locate(at(0.48, 0.51)));
      CHECK(write(circle, 0.4 * width, dxf, svg) == 1);
      CHECK_DETAIL(occurrences(svg, " A") <= 4 && occurrences(svg, " L") == 0, std::to_string(occurrences(svg, " A")));
      if (is_rounded) continue;
      CHECK_DETAIL(occurrences(dxf, "AcDbPolyline\n90\n2\n") == 1, "a circle is two bulges");
      Geodesic square(mesh);
      const auto polyline = square.locate_polyline(std::vector<Point_3>{at(0.2, 0.2), at(0.8, 0.2), at(0.8, 0.8), at(0.2, 0.8)},
                                                   CGAL::parameters::is_closed(true));
      square.add_source_polyline(polyline.locations, CGAL::parameters::is_closed(true));
      CHECK(write(square, 0.1 * width, dxf, svg) == 2);
      CHECK_DETAIL(occurrences(svg, " A") == 4 && occurrences(svg, " L") == 8,
                   std::to_string(occurrences(svg, " A")) + " arcs, " + std::to_string(occurrences(svg, " L")) + " segments");
      CHECK(occurrences(dxf, "AcDbPolyline\n90\n8\n") == 1 && occurrences(dxf, "AcDbPolyline\n90\n4\n") == 1);
    }
}

// Two collinear polylines, one of which turns back by 1: each point is on both.
void turn_back()
{
  const Polyline_3 p = {Point_3(0, 0, 0), Point_3(3, 0, 0)},
                   q = {Point_3(0, 0, 0), Point_3(2, 0, 0), Point_3(1, 0, 0), Point_3(3, 0, 0)};
  CHECK(!Frechet_decision(p, q, 0.499)() && Frechet_decision(p, q, 0.501)());
  CHECK(!Frechet_decision(q, p, 0.499)() && Frechet_decision(q, p, 0.501)());
  CHECK(Frechet_decision(q, q, 1e-6)() && !Frechet_decision(q, Polyline_3(q.rbegin(), q.rend()), 2.999)());
}

// Circles of few pieces, with tolerances from below rounding to more than the mesh.
void circles_in_faces()
{
  Random random(11);
  const Surface_mesh needles = mesh_of(needle_fan(9)), grid = mesh_of(jittered_grid(6, 6, 2));
  for (const Surface_mesh* mesh : {&needles, &grid})
    for (int i = 0; i < 100; ++i)
    {
      Geodesic geodesic(*mesh);
      const auto face = *std::next(faces(*mesh).begin(), static_cast<std::ptrdiff_t>(uniform_index(random, num_faces(*mesh))));
      const double u = uniform(random), v = uniform(random) * (1 - u);
      geodesic.add_source_point(Geodesic::Face_location(face, {u, v, 1 - u - v}));
      Curves curves;
      const double radius = std::pow(10., uniform(random, -6, -1));
      geodesic.build_with_offset_curves(radius, std::back_inserter(curves));
      for (const double tolerance : {1e-2 * radius, 0.3 * radius, radius, 8 * radius, 1e3, 1e300})
      {
        Report::instance().set_context("circle " + std::to_string(i) + ", tolerance " + std::to_string(tolerance / radius));
        for (const auto& curve : curves) check_thin_polyline(curve, tolerance, size_of(*mesh));
      }
      // the angle of the arcs is so small that discretize() has few chords, which may exceed the tolerance
      Report::instance().set_context("circle " + std::to_string(i) + ", tolerances less than rounding");
      for (const auto& curve : curves)
        for (const double tolerance : {1e-25, 1e-300, std::numeric_limits<double>::denorm_min()})
        {
          double chords = 0;
          for (const auto& piece : curve.pieces()) chords += double(piece.number_of_chords(tolerance));
          if (chords < 1e5) CHECK(curve_points(curve, tolerance).size() <= piecewise_points(curve, tolerance).size());
        }
    }
}

// Writes a curve to a file of each format; returns whether all of them are refused, and write nothing.
template <class Exception>
bool is_refused_by_writers(const Curves& curves, double tolerance)
{
  bool result = true;
  for (const auto format : {CGAL::IO::Offset_file_format::VTK, CGAL::IO::Offset_file_format::OBJ,
                            CGAL::IO::Offset_file_format::DXF, CGAL::IO::Offset_file_format::POLYLINES})
  {
    std::ostringstream os;
    const auto is_refused = [&](const auto& write) {
      try
      {
        write();
      }
      catch (const Exception&)
      {
        return os.str().empty();
      }
      return false;
    };
    result &=
      is_refused([&] { CGAL::IO::write_offset_curves(os, format, curves, CGAL::parameters::chord_tolerance(tolerance)); });
  }
  return result;
}

// Tolerances without a limit: the angle of chords has a minimum, and curves with too many chords are refused at once.
void tiny_tolerances()
{
  Report::instance().set_context("tiny tolerances");
  using CGAL::Geodesic_offset::internal::least_chord_angle;
  const Surface_mesh mesh = mesh_of(random_rectangle(4, 3, 5, 2, 3));
  Geodesic geodesic(mesh);
  geodesic.add_source_point(geodesic.locate(Point_3(2, 1.5, 0)));
  Curves curves;
  geodesic.build_with_offset_curves(1., std::back_inserter(curves)); // a circle: 62,831,854 chords
  if (!CHECK(curves.size() == 1)) return;
  double sum = 0;
  for (const auto& piece : curves[0].pieces())
  {
    const double angle = piece.angle();
    for (const double tolerance : {1e-25, 1e-300, std::numeric_limits<double>::denorm_min()})
      CHECK(double(piece.number_of_chords(tolerance)) == std::ceil(angle / least_chord_angle));
    sum += angle;
    // the largest tolerance for which chords have the least angle, and a larger one
    const double height = 2 * piece.radius() * std::pow(std::sin(least_chord_angle / 4), 2);
    CHECK(double(piece.number_of_chords(1.1 * height)) < angle / least_chord_angle);
    // the height of a chord is the rounding of points of the arc
    CHECK(height <= 12 * std::numeric_limits<double>::epsilon() / 2 * piece.radius());
  }
  CHECK(std::abs(sum - 2 * CGAL_PI) < 1e-12);
  for (const double tolerance : {1e-16, 1e-300, std::numeric_limits<double>::denorm_min()})
  {
    Polyline_3 points;
    CHECK_THROWS(curves[0].points(tolerance, std::back_inserter(points)), std::length_error);
    CHECK(points.empty() && is_refused_by_writers<std::length_error>(curves, tolerance));
  }
  for (const double tolerance : {0., -1e-300, std::nan("")})
    CHECK(is_refused_by_writers<std::invalid_argument>(curves, tolerance));
  // the arcs of SVG files need no chords
  std::ostringstream os;
  CHECK(CGAL::IO::write_offset_curves(os, CGAL::IO::Offset_file_format::SVG, curves, CGAL::parameters::chord_tolerance(1e-300)));
  CHECK(!os.str().empty());
}

// Closed curves smaller than the tolerance remain triangles.
void small_curves()
{
  const Surface_mesh cube = mesh_of(cube_grid(3)), grid = mesh_of(jittered_grid(6, 6, 2));
  for (const Surface_mesh* mesh : {&cube, &grid})
    for (double radius : {1e-6, 1e-3, 0.3, 1.1})
      for (bool is_inside : {false, true})
      {
        Geodesic geodesic(*mesh);
        const auto face = *std::next(faces(*mesh).begin(), 31);
        if (is_inside) geodesic.add_source_point(Geodesic::Face_location(face, {0.3, 0.3, 0.4}));
        else geodesic.add_source_point(source(halfedge(face, *mesh), *mesh));
        Curves curves;
        geodesic.build_with_offset_curves(radius, std::back_inserter(curves));
        CHECK(!curves.empty());
        for (double factor : {1e-3, 0.1, 0.5, 1., 2., 100., 1e6})
        {
          Report::instance().set_context("radius " + std::to_string(radius) + ", tolerance " + std::to_string(factor * radius));
          for (const auto& curve : curves) check_thin_polyline(curve, factor * radius, size_of(*mesh));
        }
      }
}

// Points where source or side change are points of VTK files, so that the values of points are correct.
void values_of_points()
{
  Report::instance().set_context("values of points");
  const Surface_mesh mesh = mesh_of(random_rectangle(4, 3, 100, 3, 1));
  Geodesic geodesic(mesh);
  const Point_3 a(1.5, 1.4, 0), b(2.3, 1.6, 0);
  const std::size_t first = geodesic.add_source_point(geodesic.locate(a)),
                    second = geodesic.add_source_point(geodesic.locate(b));
  for (double tolerance : {1e-3, 0.05, 0.3, 10.})
  {
    Curves curves;
    geodesic.build_with_offset_curves(0.7, std::back_inserter(curves));
    if (!CHECK(curves.size() == 1)) return;
    std::stringstream os;
    CHECK(CGAL::IO::write_offset_VTK(os, curves, CGAL::parameters::chord_tolerance(tolerance)));
    const auto skip_to = [&](const std::string& word) {
      for (std::string w; w != word && os >> w;) continue;
    };
    std::size_t n = 0;
    skip_to("POINTS");
    os >> n;
    skip_to("double");
    Polyline_3 points;
    for (double x, y, z; points.size() < n && os >> x >> y >> z;) points.push_back(Point_3(x, y, z));
    skip_to("POINT_DATA");
    skip_to("source");
    skip_to("int");
    std::vector<std::size_t> sources;
    for (std::size_t s; sources.size() < n && os >> s;) sources.push_back(s);
    if (!CHECK(sources.size() == n && points.size() == n && n >= 3)) continue;
    std::size_t changes = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      // a point belongs to its source, or to both; a segment to the source of its end
      const auto off = [&](const Point_3& p, std::size_t s) {
        return std::sqrt(CGAL::squared_distance(p, s == first ? a : b)) - 0.7;
      };
      CHECK(sources[i] == first || sources[i] == second);
      const std::size_t next = (i + 1) % n, s = sources[next];
      CHECK_DETAIL(std::abs(off(points[i], s)) <= 1e-10 && std::abs(off(points[next], s)) <= 1e-10,
                   values(off(points[i], s), off(points[next], s)));
      changes += sources[i] != s ? 1 : 0;
    }
    CHECK_DETAIL(changes == 2, std::to_string(changes) + " changes");
  }
}

// Arc length from the start of the curve to a point of a piece, by chords.
double way_to(const Geodesic::Offset_curve& curve, std::size_t piece, const Point_3& p)
{
  double way = 0;
  for (std::size_t i = 0; i <= piece; ++i)
  {
    const auto part = curve.piece(i);
    const double chord = std::sqrt(CGAL::squared_distance(part.point(0), i < piece ? part.point(1) : p));
    way += part.is_segment() ? chord : 2 * part.radius() * std::asin((std::min)(chord / (2 * part.radius()), 1.));
  }
  return way;
}

void check_spaced_points(const Geodesic::Offset_curve& curve, double spacing, double size)
{
  std::vector<Geodesic::Offset_curve::Oriented_point> points;
  curve.points_at_spacing(spacing, std::back_inserter(points));
  const double length = curve.length();
  const auto n = double(points.size() - 1);
  if (!CHECK(n >= (curve.is_closed() ? 3 : 1))) return;
  CHECK(length / n <= spacing * (1 + 1e-9) && (length / (n - 1) > spacing || n == (curve.is_closed() ? 3 : 1)));
  for (std::size_t j = 0; j < points.size(); ++j)
  {
    const auto& p = points[j];
    const auto piece = curve.piece(p.piece);
    const bool is_end = curve.is_closed() && j + 1 == points.size();
    const double way = way_to(curve, p.piece, p.point), expected = is_end ? 0 : double(j) * length / n;
    // the angle of a half turn is ill-conditioned
    CHECK_DETAIL(std::abs(way - expected) <= 1e-7 * size, values(way, expected));
    CHECK(p.location.first == piece.face() && CGAL::squared_distance(curve.point(p.location), p.point) == 0);
    CHECK(std::abs(p.tangent * p.tangent - 1) < 1e-12 && std::abs(p.normal * p.normal - 1) < 1e-12);
    CHECK_DETAIL(std::abs(p.tangent * p.normal) < 1e-9, values(p.tangent * p.normal, 0));
    if (piece.length() < 1e-3 * size) continue;
    const double t = (std::min)((std::max)((way - way_to(curve, p.piece, piece.point(0))) / piece.length(), 1e-3), 1 - 1e-3);
    const Vector_3 forward = piece.point(t + 1e-3) - piece.point(t - 1e-3);
    CHECK(forward * p.tangent >= (1 - 1e-4) * std::sqrt(forward * forward));
  }
  CHECK(!curve.is_closed() ||
        (points.front().location == points.back().location && points.front().point == points.back().point));
}

void spaced_points()
{
  const Surface_mesh flat = mesh_of(jittered_grid(20, 20, 4));
  Geodesic geodesic(flat);
  geodesic.add_source_point(geodesic.locate(Point_3(9.3, 10.2, 0)));
  Curves circle;
  geodesic.build_with_offset_curves(6., std::back_inserter(circle));
  std::vector<Geodesic::Offset_curve::Oriented_point> points;
  circle[0].points_at_spacing(12 * CGAL_PI / 7, std::back_inserter(points)); // exactly seven parts, up to rounding
  CHECK_DETAIL(points.size() == 8, std::to_string(points.size()));
  for (std::size_t j = 1; j < points.size(); ++j)
  {
    const double chord = std::sqrt(CGAL::squared_distance(points[j - 1].point, points[j].point));
    CHECK_DETAIL(std::abs(chord - 12 * std::sin(CGAL_PI / 7)) < 1e-12 * 6, values(chord, 12 * std::sin(CGAL_PI / 7)));
    const Vector_3 out = (points[j].point - Point_3(9.3, 10.2, 0)) / 6; // smaller distances on the left
    CHECK((CGAL::cross_product(points[j].normal, points[j].tangent) + out).squared_length() < 1e-20);
    CHECK((points[j].normal - Vector_3(0, 0, 1)).squared_length() == 0);
  }
  const std::pair<const char*, Soup> soups[] = {{"turned cube", rotated(cube_grid(8), 5)},
                                                {"grid", jittered_grid(20, 20, 7)},
                                                {"torus", torus(40, 30)},
                                                {"needles", needle_fan(60)}};
  for (const auto& [name, soup] : soups)
  {
    const Surface_mesh mesh = mesh_of(soup);
    Report::instance().set_context(name);
    for (const auto& curve : curves_at_levels(mesh, 10))
      for (double part : {1e-2, 0.3, 10.}) check_spaced_points(curve, part * size_of(mesh), size_of(mesh));
  }
  for (const double bad : {0., -1., std::nan("")})
    CHECK_THROWS(circle[0].points_at_spacing(bad, std::back_inserter(points)), std::invalid_argument);
  points.clear();
  CHECK_THROWS(circle[0].points_at_spacing(1e-7, std::back_inserter(points)), std::length_error);
  CHECK(points.empty());
  std::ostringstream os;
  CHECK_THROWS(CGAL::IO::write_offset_CSV(os, circle, CGAL::parameters::point_spacing(1e-7)), std::length_error);
  CHECK_THROWS(CGAL::IO::write_offset_VTK(os, circle, CGAL::parameters::point_spacing(0)), std::invalid_argument);
  CHECK(os.str().empty());
  CHECK(CGAL::IO::write_offset_polylines(os, circle, CGAL::parameters::point_spacing(12)) && os.str().substr(0, 2) == "5 ");
}

// At corners and edges of a cube, however it is divided into triangles; on a sphere; in a plane.
void smooth_normals()
{
  const auto normal_at = [](const Geodesic::Offset_curve& curve, const Surface_mesh& mesh, Surface_mesh::Vertex_index v) {
    const auto h = mesh.halfedge(v); // v is its target
    const auto f = mesh.is_border(h) ? mesh.face(mesh.opposite(h)) : mesh.face(h);
    Geodesic::Face_location location(f, {0, 0, 0});
    auto g = mesh.prev(mesh.halfedge(f));
    for (double& w : location.second)
    {
      w = mesh.target(g) == v ? 1 : 0;
      g = mesh.next(g);
    }
    return curve.smooth_normal(location);
  };
  const Surface_mesh cube = mesh_of(cube_grid(3)), sphere = mesh_of(icosphere(3));
  const auto on_cube = curves_at_levels(cube, 3).front(), on_sphere = curves_at_levels(sphere, 3).front();
  double low = infinity, high = -infinity;
  for (const auto v : cube.vertices())
    for (int i = 0; i < 3; ++i)
    {
      low = (std::min)(low, cube.point(v)[i]);
      high = (std::max)(high, cube.point(v)[i]);
    }
  for (const auto v : cube.vertices())
  {
    double sides[3];
    for (int i = 0; i < 3; ++i) sides[i] = cube.point(v)[i] == high ? 1 : cube.point(v)[i] == low ? -1 : 0;
    Vector_3 expected(sides[0], sides[1], sides[2]);
    expected = expected / std::sqrt(expected * expected);
    CHECK((normal_at(on_cube, cube, v) - expected).squared_length() < 1e-28);
  }
  for (const auto v : sphere.vertices()) CHECK(normal_at(on_sphere, sphere, v) * (sphere.point(v) - CGAL::ORIGIN) > 1 - 1e-4);
  for (const auto& piece : on_sphere.pieces())
    CHECK(on_sphere.smooth_normal(piece.location(0.5)) * (piece.point(0.5) - CGAL::ORIGIN) > 0.99);
  CHECK_THROWS(on_sphere.smooth_normal({Surface_mesh::null_face(), {1, 0, 0}}), std::invalid_argument);
}

} // namespace test_offset_points

GEODESIC_OFFSET_TEST(test_offset_points)
{
  const std::vector<std::pair<const char*, void (*)()>> tests = {
    {"squares", squares},
    {"true arcs", true_arcs},
    {"turn back", turn_back},
    {"circles in faces", circles_in_faces},
    {"tiny tolerances", tiny_tolerances},
    {"small curves", small_curves},
    {"values of points", values_of_points},
    {"spaced points", spaced_points},
    {"smooth normals", smooth_normals},
    {"generated meshes", generated},
    {data_case, data_meshes}};
  return run_tests("test_offset_points", tests);
}
