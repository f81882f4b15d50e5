// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Queries of an offset curve: start and end of pieces, points at an arc length, chords within a tolerance and their minimal
// number, thin polylines, centers, lines, sides and sources; on Surface_mesh and Polyhedron_3.

#include "flat_paths.h"
#include "generated_meshes.h"
#include "geodesic_types.h"
#include "planar_pieces.h"
#include "test_check.h"
#include "thin_polylines.h"
#include "unfolded_curves.h"

#include <CGAL/Polyhedron_3.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace test_offset_curve_queries {

using namespace test;

const double pi = CGAL_PI;

/// The mesh is the rectangle [0, 4] x [0, 3] in the plane z = 0, so points in space are those of the plane.
template <class TriangleMesh>
class Queries
{
  typedef Geodesic_on<TriangleMesh> Geodesic;
  typedef typename Geodesic::Offset_curve Offset_curve;
  typedef typename Offset_curve::Piece Piece;
  typedef typename Geodesic::Face_location Face_location;
  typedef std::vector<Offset_curve> Curves;

public:
  Queries(const std::string& name, std::size_t points_inside, unsigned seed)
    : name_(name + ", seed " + std::to_string(seed)), data_(random_rectangle(4, 3, points_inside, 3, seed)), unfolding_(data_),
      generator_(data_, seed), locations_(data_.mesh)
  {
  }

  void run()
  {
    circle();
    stadium();
    polygon();
    several_sources();
  }

private:
  Face_location at(double x, double y) const { return unfolding_.locate(0, Point_2(x, y)); }

  static double x_y_distance(const Point_3& p, double x, double y) { return std::hypot(p.x() - x, p.y() - y); }

  static Point_2 flat(const Point_3& p) { return Point_2(p.x(), p.y()); }

  void context(const std::string& what) { Report::instance().set_context(name_ + ", " + what); }

  static Curves curves_of(Geodesic& geodesic, double level)
  {
    Curves curves;
    geodesic.build_with_offset_curves(level, std::back_inserter(curves));
    return curves;
  }

  void circle()
  {
    for (double d : {0.003, 0.3, 1.4})
    {
      context("circle " + std::to_string(d));
      Geodesic geodesic(data_.mesh);
      const std::size_t id = geodesic.add_source_point(at(2.1, 1.45));
      const Curves curves = curves_of(geodesic, d);
      if (!CHECK(curves.size() == 1)) continue;
      const Offset_curve& curve = curves[0];
      check_any(curve);
      CHECK(curve.is_closed());
      CHECK(std::abs(curve.length() - 2 * pi * d) <= 1e-11 * d);
      // The point at an arc length is turned counterclockwise from the start by arc length / d.
      const Point_3 start = curve.point(0.);
      for (int k = -1; k <= 41; ++k)
      {
        const double way = 2 * pi * d * k / 40;
        const double turn = (std::min)((std::max)(way, 0.), curve.length()) / d;
        const Vector_2 v = turned(Vector_2(start.x() - 2.1, start.y() - 1.45), turn);
        const Point_3 p = curve.point(way), q = locations_.point(curve.location(way));
        CHECK_DETAIL(x_y_distance(p, 2.1 + v.x(), 1.45 + v.y()) <= 5e-12,
                     values(x_y_distance(p, 2.1 + v.x(), 1.45 + v.y()), 0));
        CHECK(CGAL::squared_distance(p, q) <= 1e-28);
        CHECK(p.z() == 0);
      }
      for (const Piece& piece : curve.pieces())
      {
        CHECK(piece.is_arc() && !piece.is_segment() && !piece.is_nearest_to_segment());
        CHECK(piece.source() == id && piece.source_part() == 0);
        CHECK(piece.side() == CGAL::Source_side::NONE);
        CHECK(std::abs(piece.radius() - cut_level(d)) <= 1e-13);
        CHECK_DETAIL(distance(piece.center(), unfolding_.in_frame(piece.face(), Point_2(2.1, 1.45))) <= 2e-12,
                     values(distance(piece.center(), unfolding_.in_frame(piece.face(), Point_2(2.1, 1.45))), 0));
      }
    }
  }

  void stadium()
  {
    context("stadium");
    const double d = 0.4;
    Geodesic geodesic(data_.mesh);
    typename Generator::Path path;
    path.locations.push_back(at(1.1, 1.2));
    if (!CHECK(generator_.add_leg(path, at(2.6, 1.7), 0))) return;
    const std::size_t id = geodesic.add_source_polyline(path.locations);
    const Curves curves = curves_of(geodesic, d);
    if (!CHECK(curves.size() == 1)) return;
    check_any(curves[0]);
    const Point_2 a(1.1, 1.2), b(2.6, 1.7);
    const Vector_2 along = (b - a) / distance(a, b);
    double on_side[4] = {0, 0, 0, 0};
    for (const Piece& piece : curves[0].pieces())
    {
      CHECK(piece.source() == id);
      CHECK(piece.source_part() < path.locations.size());
      on_side[static_cast<int>(piece.side())] += piece.length();
      const Point_2 middle = flat(piece.point(0.5));
      const double foot = along * (middle - a);
      if (foot < 0 || foot > distance(a, b)) CHECK(piece.side() == CGAL::Source_side::CAP);
      else
        CHECK(piece.side() ==
              (CGAL::orientation(a, b, middle) == CGAL::LEFT_TURN ? CGAL::Source_side::LEFT : CGAL::Source_side::RIGHT));
      CHECK(piece.is_segment() == (foot >= 0 && foot <= distance(a, b)));
      if (!piece.is_nearest_to_segment()) CHECK(piece.source_part() == (foot < 0 ? 0 : path.locations.size() - 1));
      else if (CHECK(piece.source_part() + 1 < path.locations.size()))
      {
        const Point_2 p = flat(locations_.point(path.locations[piece.source_part()])),
                      q = flat(locations_.point(path.locations[piece.source_part() + 1]));
        // the path is straight, so its segments act as one
        CHECK(std::abs(std::abs(CGAL::determinant(q - p, middle - p)) / distance(p, q) - d) <= 1e-12);
      }
    }
    const double l = distance(a, b);
    CHECK(std::abs(on_side[static_cast<int>(CGAL::Source_side::LEFT)] - l) <= 1e-11);
    CHECK(std::abs(on_side[static_cast<int>(CGAL::Source_side::RIGHT)] - l) <= 1e-11);
    CHECK(std::abs(on_side[static_cast<int>(CGAL::Source_side::CAP)] - 2 * pi * d) <= 1e-11);
  }

  // A counterclockwise square and the level on both of its sides.
  void polygon()
  {
    context("square");
    const double d = 0.21;
    const Point_2 corners[] = {Point_2(1.21, 1.02), Point_2(2.53, 1.11), Point_2(2.44, 2.43), Point_2(1.12, 2.34)};
    typename Generator::Path path;
    path.locations.push_back(at(corners[0].x(), corners[0].y()));
    for (std::size_t k : {1, 2, 3})
      if (!CHECK(generator_.add_leg(path, at(corners[k].x(), corners[k].y()), 0))) return;
    if (!CHECK(generator_.add_leg(path, path.locations.front(), 0))) return;
    path.locations.pop_back();
    Geodesic geodesic(data_.mesh);
    geodesic.add_source_polyline(path.locations, CGAL::parameters::is_closed(true));
    const Curves curves = curves_of(geodesic, d);
    if (!CHECK(curves.size() == 2)) return;
    const double side = distance(corners[0], corners[1]);
    for (const Offset_curve& curve : curves)
    {
      check_any(curve);
      CHECK(curve.is_closed());
      const bool outside = curve.piece(0).side() == CGAL::Source_side::RIGHT;
      for (const Piece& piece : curve.pieces())
      {
        CHECK(piece.side() == (outside ? CGAL::Source_side::RIGHT : CGAL::Source_side::LEFT));
        CHECK(outside || piece.is_segment());
      }
      const double expected = outside ? 4 * side + 2 * pi * d : 4 * (side - 2 * d);
      CHECK_DETAIL(std::abs(curve.length() - expected) <= 1e-11 * expected, values(curve.length(), expected));
    }
  }

  // Ids of sources; curves that end on the border.
  void several_sources()
  {
    context("several sources");
    Geodesic geodesic(data_.mesh);
    const Point_2 points[] = {Point_2(0.7, 0.9), Point_2(3.2, 0.6), Point_2(1.9, 2.5)};
    std::vector<std::size_t> ids;
    for (const Point_2& p : points) ids.push_back(geodesic.add_source_point(at(p.x(), p.y())));
    geodesic.remove_source(ids[1]);
    ids[1] = geodesic.add_source_point(at(points[1].x(), points[1].y()));
    CHECK(ids[1] == 3);
    std::size_t open = 0;
    for (double d : {0.3, 0.8, 1.1})
    {
      const Curves curves = curves_of(geodesic, d);
      CHECK(!curves.empty());
      for (const Offset_curve& curve : curves)
      {
        check_any(curve);
        CHECK(curve.distance() == d);
        open += curve.is_closed() ? 0 : 1;
        for (const Piece& piece : curve.pieces())
        {
          const Point_3 p = piece.point(0.5);
          std::size_t nearest = 0;
          for (std::size_t i : {1, 2})
            if (distance(flat(p), points[i]) < distance(flat(p), points[nearest])) nearest = i;
          CHECK(piece.source() == ids[nearest]);
          CHECK(std::abs(distance(flat(p), points[nearest]) - d) <= 5e-12);
        }
      }
    }
    CHECK(open > 0);
  }

  // ----------------------------------------------------------------------------------------------

  // Properties of every curve.
  void check_any(const Offset_curve& curve)
  {
    CHECK(curve.enclosed_side() == CGAL::LEFT_TURN);
    const std::size_t n = curve.number_of_pieces();
    CHECK(static_cast<std::size_t>(std::distance(curve.pieces().begin(), curve.pieces().end())) == n);
    double way = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      const Piece piece = curve.piece(i);
      check_piece(piece);
      // Arc length up to the middle of each piece.
      const Point_3 p = curve.point(way + piece.length() / 2), q = piece.point(0.5);
      CHECK(CGAL::squared_distance(p, q) <= 1e-24);
      way += piece.length();
      if (i + 1 < n) CHECK(CGAL::squared_distance(piece.point(1.), curve.piece(i + 1).point(0.)) <= 1e-25);
    }
    CHECK(std::abs(way - curve.length()) <= 1e-13 * n);
    CHECK(CGAL::squared_distance(curve.point(0.), curve.piece(0).point(0.)) == 0);
    CHECK(CGAL::squared_distance(curve.point(way + 1), curve.piece(n - 1).point(1.)) == 0);
    CHECK(!curve.is_closed() || CGAL::squared_distance(curve.piece(0).point(0.), curve.piece(n - 1).point(1.)) <= 1e-25);
    for (double tolerance : {0.3, 0.01, 1e-5, 1e-7}) check_chords(curve, tolerance);
  }

  void check_piece(const Piece& piece)
  {
    CHECK(!piece.pseudo_source());
    CHECK(piece.is_arc() != piece.is_segment());
    CHECK(piece.angle() >= 0 && piece.angle() <= pi + 1e-12);
    CHECK(distance(piece.point_2(0), piece.start_2()) <= 1e-13);
    CHECK(distance(piece.point_2(1), piece.end_2()) <= 1e-13);
    for (int k = 0; k <= 8; ++k)
    {
      const double t = k / 8.;
      // The frame and the location give the same point, inside the face.
      const Face_location l = piece.location(t);
      CHECK(l.first == piece.face());
      for (double w : l.second) CHECK(w >= -1e-12 && w <= 1 + 1e-12);
      CHECK(distance(unfolding_.in_frame(piece.face(), unfolding_.uv(l)), piece.point_2(t)) <= 2e-12);
      CHECK(CGAL::squared_distance(locations_.point(l), piece.point(t)) <= 1e-28);
      // The parameter is proportional to length.
      const double straight = distance(piece.point_2(t), piece.start_2());
      const double expected = piece.is_segment() ? t * piece.length() : 2 * piece.radius() * std::sin(t * piece.angle() / 2);
      CHECK_DETAIL(std::abs(straight - expected) <= 1e-12, values(straight, expected));
      if (piece.is_arc()) CHECK(std::abs(distance(piece.point_2(t), piece.center()) - piece.radius()) <= 1e-12);
    }
    if (piece.is_arc())
    {
      CHECK(std::abs(piece.length() - piece.radius() * piece.angle()) <= 1e-15 * piece.length());
      // Counterclockwise: the center, which is nearer to the source, is on the left.
      if (piece.angle() > 1e-6)
        CHECK(CGAL::orientation(piece.start_2(), piece.point_2(0.5), piece.center()) == CGAL::LEFT_TURN);
    }
    else
    {
      const auto line = piece.supporting_line();
      CHECK(CGAL::squared_distance(line, piece.start_2()) <= 1e-24);
      CHECK(CGAL::squared_distance(line, piece.end_2()) <= 1e-24);
      CHECK(std::abs(piece.length() - distance(piece.start_2(), piece.end_2())) <= 1e-15);
      const Vector_2 v = line.to_vector(), u = piece.end_2() - piece.start_2();
      CHECK(std::abs(std::hypot(v.x(), v.y()) - 1) <= 1e-12);
      if (piece.length() > 1e-6) CHECK(u * v >= (1 - 1e-9) * piece.length());
    }
  }

  // Heights of arcs over chords are within the tolerance, but would not be with one chord less.
  void check_chords(const Offset_curve& curve, double tolerance)
  {
    std::vector<std::size_t> chords(curve.number_of_pieces(), 0);
    std::vector<Face_location> from_discretize;
    bool first = true;
    Point_3 last(0, 0, 0);
    double sum = 0;
    curve.discretize(tolerance, [&](const Face_location& l, std::size_t i) {
      from_discretize.push_back(l);
      const Point_3 p = locations_.point(l);
      if (!first)
      {
        ++chords[i];
        sum += std::sqrt(CGAL::squared_distance(last, p));
        const Piece piece = curve.piece(i);
        // height of the arc over this chord
        const double half = std::sqrt(CGAL::squared_distance(last, p)) / 2;
        if (piece.is_arc())
        {
          const double r = piece.radius();
          const double height = r - std::sqrt((std::max)(0., (r - half) * (r + half)));
          const double larger = piece.angle() / chords_of(piece, tolerance) > pi + 1e-9 ? 2 * r - height : height;
          CHECK_DETAIL(larger <= tolerance * (1 + 1e-9) + 1e-14, values(larger, tolerance));
        }
      }
      last = p;
      first = false;
    });
    CHECK(sum <= curve.length() * (1 + 1e-12));
    for (std::size_t i = 0; i < chords.size(); ++i)
    {
      const Piece piece = curve.piece(i);
      const std::size_t n = piece.number_of_chords(tolerance);
      CHECK(chords[i] == n && n >= 1);
      if (n == 1) continue;
      CHECK(piece.is_arc());
      const double step = piece.angle() / static_cast<double>(n - 1);
      const double height = 2 * piece.radius() * std::pow(std::sin(step / 4), 2);
      // No chord spans more than a third of a circle, so small circles remain polygons.
      CHECK_DETAIL(height > tolerance * (1 - 1e-6) || step > 2 * pi / 3 - 1e-9, values(height, tolerance));
    }
    std::vector<Face_location> from_locations;
    curve.face_locations(tolerance, std::back_inserter(from_locations));
    CHECK(from_locations == from_discretize);
    CHECK(!curve.is_closed() || from_locations.front() == from_locations.back());
    check_thin_polyline(curve, tolerance, 4);
  }

  static double chords_of(const Piece& piece, double tolerance)
  {
    return static_cast<double>(piece.number_of_chords(tolerance));
  }

  typedef Flat_path_generator<TriangleMesh> Generator;

  std::string name_;
  Generated_mesh<TriangleMesh> data_;
  Unfolding_of_patches<TriangleMesh> unfolding_;
  Generator generator_;
  Locations<TriangleMesh> locations_;
};

template <class TriangleMesh>
void run(const std::string& name)
{
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const std::size_t points_inside : {0u, 20u, 300u})
      guarded([&] {
        Queries<TriangleMesh>(name + ", " + std::to_string(points_inside) + " points", points_inside, seed).run();
      });
}

} // namespace test_offset_curve_queries

GEODESIC_OFFSET_TEST(test_offset_curve_queries)
{
  run<test::Surface_mesh>("Surface_mesh");
  run<CGAL::Polyhedron_3<Kernel>>("Polyhedron_3");
  return Report::instance().finish("test_offset_curve_queries");
}
