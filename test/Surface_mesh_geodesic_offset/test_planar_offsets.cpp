// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offset curves of polylines on triangulated rectangles against planar offsets computed without mesh: Hausdorff distance
// 1e-12 of the diagonal, the same numbers of closed curves and of curves from border to border, the same lengths (1e-11
// relative); closed forms of the length.

#include "flat_paths.h"
#include "generated_meshes.h"
#include "geodesic_types.h"
#include "offset_tools.h"
#include "planar_offset.h"
#include "test_check.h"
#include "unfolded_curves.h"

#include <iterator>
#include <string>
#include <vector>

namespace test_planar_offsets {

using namespace test;

typedef Generated_mesh<test::Surface_mesh> Data;
typedef Flat_path_generator<test::Surface_mesh> Generator;
typedef Generator::Face_location Face_location;
typedef Generator::Path Path;
typedef Geodesic::Offset_curve Offset_curve;
typedef std::vector<Offset_curve> Curves;
using CGAL::Offset_end;
using CGAL::Offset_side;
using CGAL::Source_side;

/// Counts of comparisons, and the worst errors (in diagonals, and relative for lengths).
struct Tally
{
  std::size_t polylines = 0, crossing = 0, closed = 0, levels = 0, closed_curves = 0, open_curves = 0, pieces = 0, specks = 0,
              levels_as_requested = 0;
  double to_plane = 0, from_plane = 0, as_requested = 0, length = 0, off_source = 0;
};

Tally tally;

bool crosses_itself(const std::vector<Leg>& legs)
{
  for (std::size_t i = 0; i < legs.size(); ++i)
    for (std::size_t j = i + 2; j < legs.size(); ++j)
    {
      const Leg &p = legs[i], &q = legs[j];
      if (CGAL::orientation(p.a, p.b, q.a) * CGAL::orientation(p.a, p.b, q.b) < 0 &&
          CGAL::orientation(q.a, q.b, p.a) * CGAL::orientation(q.a, q.b, p.b) < 0)
        return true;
    }
  return false;
}

class Plane
{
public:
  Plane(const std::string& name, const Soup& soup, unsigned seed, bool turn = true)
    : name_(name + ", seed " + std::to_string(seed)), data_(turn ? rotated(soup, seed) : soup), generator_(data_, 500 + seed),
      unfolding_(data_), box_{0, 0, 0, 0}
  {
    for (const auto& corners : data_.uv)
      for (const Point_2& p : corners)
      {
        box_.x1 = (std::max)(box_.x1, p.x());
        box_.y1 = (std::max)(box_.y1, p.y());
      }
  }

  Generator& generator() { return generator_; }
  const Data& data() const { return data_; }
  const Rectangle& box() const { return box_; }
  const Unfolding_of_patches<test::Surface_mesh>& unfolding() const { return unfolding_; }

  /// Legs through the points, divided where they cross mesh edges.
  Path path(const std::vector<Point_2>& points, bool closed = false) const
  {
    Path result;
    result.locations.push_back(unfolding_.locate(0, points.front()));
    for (std::size_t i = 1; i < points.size(); ++i)
      if (!generator_.add_leg(result, unfolding_.locate(0, points[i]), 0))
        throw std::logic_error("a leg runs through a vertex");
    if (closed)
    {
      if (!generator_.add_leg(result, result.locations.front(), 0)) throw std::logic_error("a leg runs through a vertex");
      result.locations.pop_back();
    }
    if (result.legs.empty()) result.legs.push_back(generator_.leg_at(result.locations[0]));
    return result;
  }

  /// Path from vertex to vertex of a mesh; each step is a leg.
  Path vertex_path(const std::vector<std::size_t>& vertices, bool closed = false) const
  {
    Path result;
    for (std::size_t v : vertices) result.locations.push_back(generator_.locations().at_vertex(data_.vertices[v], v));
    for (std::size_t i = 0; i + 1 < vertices.size() + (closed ? 1 : 0); ++i)
      result.legs.push_back({0, unfolding_.uv(result.locations[i]),
                             unfolding_.uv(result.locations[(i + 1) % vertices.size()])});
    if (vertices.size() == 1)
      result.legs.push_back({0, unfolding_.uv(result.locations[0]), unfolding_.uv(result.locations[0])});
    return result;
  }

  /// Compares everything at several levels with the plane. At `touching` levels the planar offset may touch itself: there
  /// only the cut distances are compared.
  void compare(const std::string& what, const Path& path, bool closed, const std::vector<double>& levels, bool touching = false)
  {
    Report::instance().set_context(name_ + ", " + what);
    guarded([&] {
      Geodesic geodesic(data_.mesh);
      geodesic.add_source_polyline(path.locations, CGAL::parameters::is_closed(closed));
      ++tally.polylines;
      tally.closed += closed ? 1 : 0;
      tally.crossing += crosses_itself(path.legs) ? 1 : 0;
      std::size_t calls = 0;
      const auto check = [&](double level, Curves&& curves) {
        Report::instance().set_context(name_ + ", " + what + ", level " + std::to_string(level));
        ++calls;
        compare_level(geodesic, path, closed, level, curves, touching);
      };
      if (tally.polylines % 2 == 0)
      {
        geodesic.build();
        geodesic.offset_curves_by_distance(levels, check);
      }
      else
      {
        // The checks need distances of vertices, so they follow the build.
        std::vector<std::pair<double, Curves>> all;
        geodesic.build_with_offset_curves_by_distance(levels, [&](double level, Curves&& curves) {
          all.emplace_back(level, std::move(curves));
        });
        for (auto& entry : all) check(entry.first, std::move(entry.second));
      }
      CHECK(calls == levels.size());
    });
  }

  /// Compares curves of a selection: numbers of closed and open curves, and their total length.
  void compare_length(const std::string& what, const Path& path, bool closed, double level, const Offset_selection& selection,
                      std::size_t number_closed, std::size_t number_open, double expected)
  {
    Report::instance().set_context(name_ + ", " + what + ", level " + std::to_string(level));
    guarded([&] {
      Geodesic geodesic(data_.mesh);
      if (path.locations.size() == 1) geodesic.add_source_point(path.locations[0]);
      else geodesic.add_source_polyline(path.locations, CGAL::parameters::is_closed(closed));
      Curves curves;
      geodesic.build_with_offset_curves(level, std::back_inserter(curves), selection.parameters());
      double length = 0;
      std::size_t n_closed = 0;
      for (const Offset_curve& curve : curves)
      {
        length += curve.length();
        n_closed += curve.is_closed() ? 1 : 0;
      }
      CHECK_DETAIL(n_closed == number_closed, std::to_string(n_closed) + " closed");
      CHECK_DETAIL(curves.size() - n_closed == number_open, std::to_string(curves.size() - n_closed) + " open");
      CHECK_DETAIL(std::abs(length - expected) <= 1e-11 * expected, values(length, expected));
      tally.length = (std::max)(tally.length, std::abs(length - expected) / expected);
    });
  }

private:
  void compare_level(const Geodesic& geodesic, const Path& path, bool closed, double level, const Curves& curves, bool touching)
  {
    const double diagonal = box_.diagonal(), tolerance = 1e-12 * diagonal;
    ++tally.levels;
    std::vector<Planar_piece> pieces;
    std::vector<double> closed_lengths, open_lengths;
    Piece_checker<Geodesic> checker(geodesic, tolerance);
    for (const Offset_curve& curve : curves)
    {
      CHECK(curve.distance() == level);
      checker.check(curve);
      (curve.is_closed() ? closed_lengths : open_lengths).push_back(curve.length());
      for (const auto& piece : curve.pieces())
      {
        pieces.push_back(unfolding_(piece));
        if (piece.length() > tolerance) check_source(piece, path, closed, level);
      }
      if (!curve.is_closed())
      {
        check_on_border(curve.piece(0).start());
        check_on_border(curve.piece(curve.number_of_pieces() - 1).end());
      }
    }
    tally.pieces += pieces.size();
    tally.specks += checker.number_of_specks();
    tally.closed_curves += closed_lengths.size();
    tally.open_curves += open_lengths.size();

    const Planar_offset expected(path.legs, cut_level(level), box_);
    compare_lengths(expected, true, closed_lengths);
    compare_lengths(expected, false, open_lengths);
    const double to = directed_hausdorff_distance(pieces, expected.pieces(), 8) / diagonal,
                 from = directed_hausdorff_distance(expected.pieces(), pieces, 32) / diagonal;
    CHECK_DETAIL(to <= 1e-12, values(to, 0));
    CHECK_DETAIL(from <= 1e-12, values(from, 0));
    tally.to_plane = (std::max)(tally.to_plane, to);
    tally.from_plane = (std::max)(tally.from_plane, from);
    if (touching) return;

    // Use the requested level unless the corners of the offset move fast with the level.
    const Planar_offset asked(path.legs, level, box_);
    if ((level - cut_level(level)) * asked.speed_of_joints() > 0.5 * tolerance) return;
    ++tally.levels_as_requested;
    CHECK(asked.number_of_components(true) == closed_lengths.size());
    CHECK(asked.number_of_components(false) == open_lengths.size());
    const double both = (std::max)(directed_hausdorff_distance(pieces, asked.pieces(), 8),
                                   directed_hausdorff_distance(asked.pieces(), pieces, 32)) /
                        diagonal;
    CHECK_DETAIL(both <= 1e-12, values(both, 0));
    tally.as_requested = (std::max)(tally.as_requested, both);
  }

  void compare_lengths(const Planar_offset& expected, bool closed, std::vector<double>& actual)
  {
    std::vector<double> lengths;
    for (const Planar_offset::Component& c : expected.components())
      if (c.is_closed == closed) lengths.push_back(c.length);
    if (!CHECK_DETAIL(lengths.size() == actual.size(), std::to_string(actual.size()) + (closed ? " closed" : " open") +
                                                         ", expected " + std::to_string(lengths.size())))
      return;
    std::sort(lengths.begin(), lengths.end());
    std::sort(actual.begin(), actual.end());
    for (std::size_t i = 0; i < lengths.size(); ++i)
    {
      const double error = std::abs(actual[i] - lengths[i]) / expected.length();
      CHECK_DETAIL(error <= 1e-11, values(actual[i], lengths[i]));
      tally.length = (std::max)(tally.length, error);
    }
  }

  void check_on_border(const Face_location& location)
  {
    const Point_2 p = unfolding_.uv(location);
    const double to_border =
      (std::min)({std::abs(p.x() - box_.x0), std::abs(p.x() - box_.x1), std::abs(p.y() - box_.y0), std::abs(p.y() - box_.y1)});
    CHECK_DETAIL(to_border <= 1e-12 * box_.diagonal(), values(to_border, 0));
  }

  // Deviation from the level of the distance of `p` from segment `part` and its collinear neighbours, which act as one
  // segment.
  double off_straight_chain(const Path& path, bool closed, std::size_t part, const Point_2& p, double level) const
  {
    const std::size_t n = path.locations.size(), segments = closed ? n : n - 1;
    const auto end = [&](std::size_t i) { return unfolding_.uv(path.locations[i % n]); };
    const auto direction = end(part + 1) - end(part);
    double off = std::abs(segment_distance(p, end(part), end(part + 1)) - level);
    for (const bool forward : {true, false})
      for (std::size_t step = 1; step < segments; ++step)
      {
        if (!closed && (forward ? part + step >= segments : step > part)) break;
        const std::size_t i = forward ? part + step : part + segments - step;
        const Point_2 a = end(closed ? i : i % segments), b = end((closed ? i : i % segments) + 1);
        const auto u = b - a;
        const double turn = std::abs(u.x() * direction.y() - u.y() * direction.x());
        const double size = std::sqrt(u.squared_length() * direction.squared_length());
        if (size > 0 && (turn > 1e-9 * size || u * direction < 0)) break;
        off = (std::min)(off, std::abs(segment_distance(p, a, b) - level));
      }
    return off;
  }

  // Checks that the piece's segment or point has the level's distance from the middle of the piece, which is on its side.
  template <class Piece>
  void check_source(const Piece& piece, const Path& path, bool closed, double level)
  {
    const double tolerance = 1e-12 * box_.diagonal();
    const std::size_t n = path.locations.size(), part = piece.source_part();
    CHECK(piece.source() == 0);
    CHECK(!piece.pseudo_source());
    CHECK(piece.is_segment() == piece.is_nearest_to_segment());
    if (!CHECK(part < n)) return;
    const Point_2 p = unfolding_.uv(piece.location(0.5)), a = unfolding_.uv(path.locations[part]),
                  b = unfolding_.uv(path.locations[(part + 1) % n]);
    const bool is_last = part + 1 == n && !closed;
    if (piece.is_nearest_to_segment())
    {
      const double off = is_last ? level : off_straight_chain(path, closed, part, p, level);
      CHECK_DETAIL(off <= tolerance, values(off, 0));
      tally.off_source = (std::max)(tally.off_source, off / box_.diagonal());
      const bool is_left = CGAL::orientation(a, b, p) == CGAL::LEFT_TURN;
      CHECK(piece.side() == (is_left ? Source_side::LEFT : Source_side::RIGHT));
      return;
    }
    const double off = std::abs(distance(a, p) - level);
    CHECK_DETAIL(off <= tolerance, values(off, 0));
    tally.off_source = (std::max)(tally.off_source, off / box_.diagonal());
    const Point_2 center = unfolding_.uv(piece.face(), piece.center());
    // Coordinates of the plane are rounded, which turns the frame of a small face.
    const double turn = 1e-15 * box_.diagonal() / smallest_edge(piece.face());
    CHECK_DETAIL(distance(center, a) <= tolerance + 4 * turn * (level + box_.diagonal()), values(distance(center, a), 0));
    CHECK((piece.side() == Source_side::NONE || piece.side() == Source_side::CAP) ==
          (!closed && (is_first(path, part) || is_at_end(path, part))));
  }

  bool is_first(const Path& path, std::size_t part) const
  {
    for (std::size_t i = 0; i < part; ++i)
      if (unfolding_.uv(path.locations[i]) != unfolding_.uv(path.locations[part])) return false;
    return true;
  }

  bool is_at_end(const Path& path, std::size_t part) const
  {
    for (std::size_t i = part; i < path.locations.size(); ++i)
      if (unfolding_.uv(path.locations[i]) != unfolding_.uv(path.locations[part])) return false;
    return true;
  }

  double smallest_edge(test::Surface_mesh::Face_index f) const
  {
    const auto& c = data_.uv[data_.face_number(f)];
    return (std::min)({distance(c[0], c[1]), distance(c[1], c[2]), distance(c[2], c[0])});
  }

  std::string name_;
  Data data_;
  Generator generator_;
  Unfolding_of_patches<test::Surface_mesh> unfolding_;
  Rectangle box_;
};

void print_tally(const std::string& what)
{
  std::cout << what << ": " << tally.polylines << " polylines (" << tally.closed << " closed, " << tally.crossing
            << " self-crossing), " << tally.levels << " levels (" << tally.levels_as_requested
            << " also at the requested level), " << tally.closed_curves << " closed and " << tally.open_curves
            << " open curves, " << tally.pieces << " pieces (" << tally.specks << " specks); Hausdorff distance "
            << tally.to_plane << " and " << tally.from_plane << " diagonals (at the requested level " << tally.as_requested
            << "), relative error of lengths " << tally.length << ", off the source named " << tally.off_source << std::endl;
  tally = Tally();
}

// ------------------------------------------------------------------------------------------------

void random_polylines()
{
  const std::size_t meshes = 20, polylines_per_mesh = 10;
  for (unsigned seed = 1; seed <= meshes; ++seed)
  {
    Random random(seed);
    const double width = uniform(random, 0.5, 3), height = uniform(random, 0.5, 3);
    const std::size_t inside[] = {0, 4, 40, 150, 400};
    const Soup soup = seed % 4 == 3 ? jittered_grid(6 + seed, 24 - seed / 2, seed)
                                    : random_rectangle(width, height, inside[seed % 5], seed % 7, seed);
    Plane plane("random polylines", soup, seed, seed % 2 == 0);
    for (std::size_t i = 0; i < polylines_per_mesh; ++i)
    {
      const bool closed = i % 3 == 2;
      const std::size_t legs[] = {1, 3, 6, 12, 25};
      const Path path = plane.generator().random_path((std::max<std::size_t>)(legs[i % 5], closed ? 2 : 1), closed);
      std::vector<double> levels;
      for (double largest : {0.004, 0.03, 0.12, 0.4})
        levels.push_back(plane.box().diagonal() * largest * uniform(random, 0.3, 1));
      plane.compare("polyline " + std::to_string(i) + " of " + std::to_string(path.legs.size()) + " legs", path, closed,
                    levels);
    }
  }
  CHECK(tally.polylines == 200);
  CHECK(tally.crossing >= 40);
  CHECK(tally.closed >= 40);
  CHECK(tally.closed_curves >= 400);
  CHECK(tally.open_curves >= 200);
  CHECK(10 * tally.levels_as_requested >= 9 * tally.levels);
  print_tally("200 random polylines");
}

// Thin faces: the centers of a level's arcs are far away, in units of the faces.
void needles()
{
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    Plane plane("needles", random_rectangle(1, 0.03, 60, 8, seed), seed);
    for (std::size_t i = 0; i < 6; ++i)
    {
      const bool closed = i % 3 == 2;
      const Path path = plane.generator().random_path(2 + i, closed);
      plane.compare("polyline " + std::to_string(i), path, closed, {1e-4, 7e-4, 0.013, 0.21});
    }
  }
  print_tally("needles");
}

// All in one triangle: segments meet inside it, and the offset may have loops without edge crossings.
void one_face()
{
  Soup soup;
  soup.points = {Point_3(0, 0, 0), Point_3(4, 0, 0), Point_3(0, 4, 0)};
  soup.add_triangle({{0, 1, 2}}, 0, {{Point_2(0, 0), Point_2(4, 0), Point_2(0, 4)}});
  Plane plane("one face", soup, 1, false);
  // The outer loop was lost formerly.
  plane.compare("a folded quadrilateral",
                plane.path({Point_2(1.3210769831202924, 1.1145089550409466), Point_2(1.325284565333277, 1.3418801832012832),
                            Point_2(0.65751199587248266, 1.4492052588611841), Point_2(1.3120946323033422, 0.60614790744148195)},
                           true),
                true, {0.17628903908655047});
  Random random(77);
  for (std::size_t i = 0; i < 1200; ++i)
  {
    std::vector<Point_2> points;
    for (std::size_t k = 0; k < 2 + i % 9; ++k) points.push_back(Point_2(uniform(random, 0.5, 1.5), uniform(random, 0.5, 1.5)));
    const bool closed = i % 2 == 1;
    plane.compare("polyline " + std::to_string(i), plane.path(points, closed), closed,
                  {uniform(random, 0.01, 0.1), uniform(random, 0.1, 0.3)});
  }
  print_tally("one face");
}

// Typical drawings on a regular grid. Vertex 17 j + i is at (i, j).
void degenerate()
{
  for (const Diagonals diagonals : {Diagonals::forward, Diagonals::alternating, Diagonals::random})
    for (const bool turn : {false, true})
    {
      Plane plane("grid " + std::to_string(static_cast<int>(diagonals)) + (turn ? ", turned" : ""),
                  planar_grid(16, 16, diagonals, 1, 0, 5), 5, turn);
      const auto v = [](std::size_t i, std::size_t j) { return 17 * j + i; };
      // Distances of vertices: integers and square roots.
      const std::vector<double> levels = {0.5, 1, std::sqrt(2.), 2, 2.5, std::sqrt(5.), 3, 5};

      plane.compare("a vertex", plane.vertex_path({v(8, 8)}), false, levels, true);
      plane.compare("a vertex, repeated", plane.vertex_path({v(8, 8), v(8, 8), v(8, 8)}), false, levels, true);
      plane.compare("along edges", plane.vertex_path({v(5, 8), v(6, 8), v(7, 8), v(8, 8), v(9, 8)}), false, levels, true);
      plane.compare("along edges, points repeated",
                    plane.vertex_path({v(5, 8), v(5, 8), v(6, 8), v(7, 8), v(7, 8), v(8, 8), v(8, 8)}), false, levels, true);
      plane.compare("along edges and back", plane.vertex_path({v(5, 8), v(6, 8), v(7, 8), v(8, 8), v(7, 8), v(6, 8)}), false,
                    levels, true);
      plane.compare("a corner", plane.vertex_path({v(5, 8), v(6, 8), v(7, 8), v(7, 9), v(7, 10), v(7, 11)}), false, levels,
                    true);
      // Its two arms are 4 apart: the fronts of level 2 meet along a whole segment.
      plane.compare("a U",
                    plane.vertex_path({v(5, 11), v(5, 10), v(5, 9), v(5, 8), v(6, 8), v(7, 8), v(8, 8), v(9, 8), v(9, 9),
                                       v(9, 10), v(9, 11)}),
                    false, levels, true);
      plane.compare("a square",
                    plane.vertex_path({v(6, 6), v(7, 6), v(8, 6), v(9, 6), v(10, 6), v(10, 7), v(10, 8), v(10, 9), v(10, 10),
                                       v(9, 10), v(8, 10), v(7, 10), v(6, 10), v(6, 9), v(6, 8), v(6, 7)},
                                      true),
                    true, levels, true);
      plane.compare("an eight along edges",
                    plane.vertex_path({v(8, 8), v(9, 8), v(10, 8), v(10, 9), v(10, 10), v(9, 10), v(8, 10), v(8, 9), v(8, 8),
                                       v(8, 7), v(8, 6), v(7, 6), v(6, 6), v(6, 7), v(6, 8), v(7, 8)},
                                      true),
                    true, levels, true);

      const auto p = [](double x, double y) { return Point_2(x, y); };
      plane.compare("collinear points", plane.path({p(3.25, 7.5), p(4.5, 7.5), p(4.75, 7.5), p(9.25, 7.5)}), false,
                    {0.5, 0.75, 1.5, 2.5, 4.5}, true);
      plane.compare("a point inside a face", plane.path({p(8.25, 8.125)}), false, levels, true);
      plane.compare("inside faces, and back", plane.path({p(3.25, 7.5), p(9.25, 7.5), p(5.25, 7.5)}), false,
                    {0.5, 0.75, 1.5, 2.5, 4.5}, true);
      plane.compare("a rectangle through faces", plane.path({p(4.5, 5.25), p(11.5, 5.25), p(11.5, 9.25), p(4.5, 9.25)}, true),
                    true, {0.25, 0.75, 1, 1.75, 1.9375, 3.5}, true);
      plane.compare("a cross", plane.path({p(4.5, 7.5), p(11.5, 7.5), p(8.375, 7.5), p(8.375, 3.25), p(8.375, 12.25)}), false,
                    {0.5, 0.75, 1.5, 2.5, 4.5}, true);
    }
  print_tally("degenerate");
}

// ------------------------------------------------------------------------------------------------

void closed_forms()
{
  const double pi = CGAL_PI;
  for (unsigned seed = 1; seed <= 8; ++seed)
  {
    const std::size_t inside[] = {0, 12, 150, 500};
    Plane plane("closed forms", random_rectangle(4, 4, inside[seed % 4], seed, seed), seed);
    Random random(seed);
    const Point_2 a(uniform(random, 1.5, 2.5), uniform(random, 1.5, 2.5)),
      b(uniform(random, 1.5, 2.5), uniform(random, 1.5, 2.5));
    const double l = distance(a, b);
    const Offset_selection everything;
    for (double d : {1e-3, 0.04, 0.3, 1.2})
    {
      plane.compare_length("point", plane.path({a}), false, d, everything, 1, 0, 2 * pi * d);
      const Path segment = plane.path({a, b});
      plane.compare_length("stadium", segment, false, d, everything, 1, 0, 2 * l + 2 * pi * d);
      plane.compare_length("butt ends", segment, false, d, Offset_selection(Offset_side::BOTH, Offset_end::BUTT), 0, 2, 2 * l);
      for (const Offset_side side : {Offset_side::LEFT, Offset_side::RIGHT})
      {
        plane.compare_length("one side", segment, false, d, Offset_selection(side, Offset_end::BUTT), 0, 1, l);
        plane.compare_length("one side with caps", segment, false, d, side, 0, 1, l + 2 * pi * d);
      }
    }

    // A convex polygon around a circle: offset inwards, it keeps its shape.
    const double in_radius = 0.4;
    const std::size_t n = 3 + seed % 5;
    std::vector<double> angles;
    for (std::size_t i = 0; i < n; ++i)
      angles.push_back(2 * pi * (static_cast<double>(i) + uniform(random, 0, 0.15)) / static_cast<double>(n));
    std::vector<Point_2> corners;
    for (std::size_t i = 0; i < n; ++i)
    {
      double half = (angles[(i + 1) % n] - angles[i]) / 2;
      if (half < 0) half += pi;
      const double r = in_radius / std::cos(half), middle = angles[i] + half;
      corners.push_back(Point_2(2 + r * std::cos(middle), 2 + r * std::sin(middle)));
    }
    double perimeter = 0;
    for (std::size_t i = 0; i < n; ++i) perimeter += distance(corners[i], corners[(i + 1) % n]);
    std::vector<Point_2> clockwise(corners.rbegin(), corners.rend());
    const Path ccw = plane.path(corners, true), cw = plane.path(clockwise, true);
    for (double d : {1e-3, 0.1, 0.25, 0.36})
    {
      const double outside = perimeter + 2 * pi * d, inside_length = perimeter * (1 - d / in_radius);
      plane.compare_length("polygon outside", ccw, true, d, Offset_side::OUTSIDE, 1, 0, outside);
      plane.compare_length("polygon, right", ccw, true, d, Offset_side::RIGHT, 1, 0, outside);
      plane.compare_length("clockwise outside", cw, true, d, Offset_side::OUTSIDE, 1, 0, outside);
      plane.compare_length("clockwise, left", cw, true, d, Offset_side::LEFT, 1, 0, outside);
      plane.compare_length("polygon inside", ccw, true, d, Offset_side::INSIDE, 1, 0, inside_length);
      plane.compare_length("polygon, left", ccw, true, d, Offset_side::LEFT, 1, 0, inside_length);
      plane.compare_length("polygon", ccw, true, d, everything, 2, 0, outside + inside_length);
    }
    plane.compare_length("polygon outside", ccw, true, 0.6, everything, 1, 0, perimeter + 2 * pi * 0.6);
  }
  std::cout << "closed forms: relative error of lengths " << tally.length << std::endl;
  tally = Tally();
}

} // namespace test_planar_offsets

GEODESIC_OFFSET_TEST(test_planar_offsets)
{
  std::cout.precision(3);
  random_polylines();
  needles();
  one_face();
  degenerate();
  closed_forms();
  return Report::instance().finish("test_planar_offsets");
}
