// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offset curves on boxes, prisms, cones below and above 2 pi, the regular tetrahedron, and a torus of flat quads against
// closed forms: every point at its distance (1e-12 of the diagonal), numbers of curves, total lengths (1e-11 relative),
// lengths behind vertices where shortest paths bend.

#include "closed_forms.h"
#include "flat_paths.h"
#include "generated_meshes.h"
#include "geodesic_types.h"
#include "planar_offset.h"
#include "test_check.h"
#include "unfolded_curves.h"

#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace test_closed_form_offsets {

using namespace test;

typedef Generated_mesh<test::Surface_mesh> Data;
typedef Flat_path_generator<test::Surface_mesh> Generator;
typedef Generator::Path Path;
typedef Geodesic::Offset_curve Offset_curve;
typedef Geodesic::Face_location Face_location;

const double pi = CGAL_PI;
const std::size_t any = std::numeric_limits<std::size_t>::max();

struct Expected
{
  std::size_t closed, open;
  double length;
  double bent_length = 0; // of the pieces behind pseudo-sources
  std::size_t arcs = any; // number of arcs, where it is known
};

/// A mesh and its checks.
class Case
{
public:
  Case(const std::string& name, const Soup& soup)
    : data_(soup), generator_(data_, 1), unfolding_(data_), name_(name), diagonal_(bounding_box_diagonal(data_.mesh))
  {
  }

  const Data& data() const { return data_; }
  Generator& generator() { return generator_; }
  const Unfolding_of_patches<test::Surface_mesh>& unfolding() const { return unfolding_; }

  Path start(std::size_t patch, const Point_2& p) const
  {
    Path path;
    path.locations.push_back(unfolding_.locate(patch, p));
    return path;
  }
  void go(Path& path, std::size_t patch, const Point_2& p) const
  {
    if (!generator_.add_leg(path, unfolding_.locate(patch, p), patch)) throw std::logic_error("a leg runs through a vertex");
  }
  void close(Path& path, std::size_t patch) const
  {
    if (!generator_.add_leg(path, path.locations.front(), patch)) throw std::logic_error("a leg runs through a vertex");
    path.locations.pop_back();
  }

  /// Legs of a path, or its point.
  std::vector<Leg> legs(const Path& path) const
  {
    return path.legs.empty() ? std::vector<Leg>{generator_.leg_at(path.locations[0])} : path.legs;
  }

  /// `distance` returns the closed form at a point of a curve, if available.
  void check(const std::string& what, const Path& path, bool closed, double level, const Expected& expected,
             const std::function<double(const Face_location&)>& distance)
  {
    Report::instance().set_context(name_ + ", " + what + ", level " + std::to_string(level));
    guarded([&] {
      Geodesic geodesic(data_.mesh);
      std::size_t id = 0;
      if (path.locations.size() == 1) id = geodesic.add_source_point(path.locations[0]);
      else id = geodesic.add_source_polyline(path.locations, CGAL::parameters::is_closed(closed));
      std::vector<Offset_curve> curves;
      geodesic.build_with_offset_curves(level, std::back_inserter(curves));

      Piece_checker<Geodesic> checker(geodesic, 1e-12 * diagonal_);
      double length = 0, bent_length = 0;
      std::size_t n_closed = 0, arcs = 0;
      for (const Offset_curve& curve : curves)
      {
        CHECK(curve.distance() == level);
        checker.check(curve);
        length += curve.length();
        n_closed += curve.is_closed() ? 1 : 0;
        for (const auto& piece : curve.pieces())
        {
          CHECK(piece.source() == id);
          CHECK(piece.source_part() < path.locations.size());
          CHECK(piece.is_arc() || piece.length() <= 1e-12 * diagonal_ || piece.is_nearest_to_segment());
          if (piece.pseudo_source()) bent_length += piece.length();
          // rounding of the points of a polyline may bend it by about 1e-11, which creates arcs of such lengths
          arcs += piece.is_arc() && piece.length() > 1e-11 * diagonal_ ? 1 : 0;
          for (int k = 0; distance && k <= 4; ++k)
          {
            const double off = std::abs(distance(piece.location(k / 4.)) - level);
            CHECK_DETAIL(off <= 1e-12 * diagonal_, values(off, 0));
            worst_off = (std::max)(worst_off, off / diagonal_);
            ++points;
          }
        }
      }
      number_of_curves += curves.size();
      CHECK_DETAIL(n_closed == expected.closed || expected.closed == any,
                   std::to_string(n_closed) + " closed, expected " + std::to_string(expected.closed));
      CHECK_DETAIL(curves.size() - n_closed == expected.open,
                   std::to_string(curves.size() - n_closed) + " open, expected " + std::to_string(expected.open));
      const double error = std::abs(length - expected.length) / expected.length;
      CHECK_DETAIL(error <= 1e-11, values(length, expected.length));
      worst_length = (std::max)(worst_length, error);
      CHECK_DETAIL(std::abs(bent_length - expected.bent_length) <= 1e-11 * expected.length,
                   values(bent_length, expected.bent_length));
      CHECK_DETAIL(arcs == expected.arcs || expected.arcs == any, std::to_string(arcs) + " arcs");
      ++levels;
    });
  }

  /// Overload for the closed forms of closed_forms.h.
  template <class ClosedForm>
  void check_form(const ClosedForm& form, const std::string& what, const Path& path, bool closed, double level,
                  const Expected& expected)
  {
    const std::vector<Leg> all = legs(path);
    check(what, path, closed, level, expected, [&](const Face_location& l) {
      double result = infinity;
      for (const Leg& leg : all) result = (std::min)(result, form(unfolding_.patch_of(l.first), unfolding_.uv(l), leg));
      return result;
    });
  }

  static double worst_off, worst_length;
  static std::size_t points, number_of_curves, levels;

private:
  Data data_;
  Generator generator_;
  Unfolding_of_patches<test::Surface_mesh> unfolding_;
  std::string name_;
  double diagonal_;
};

double Case::worst_off = 0;
double Case::worst_length = 0;
std::size_t Case::points = 0;
std::size_t Case::number_of_curves = 0;
std::size_t Case::levels = 0;

void print_totals(const std::string& what)
{
  std::cout << what << ": " << Case::levels << " levels, " << Case::number_of_curves << " curves, " << Case::points
            << " points off by at most " << Case::worst_off << " diagonals, lengths by " << Case::worst_length << std::endl;
  Case::levels = Case::number_of_curves = Case::points = 0;
  Case::worst_off = Case::worst_length = 0;
}

// Triangulations of several sizes.
struct Size
{
  std::size_t per_patch, per_edge;
};
const Size sizes[] = {{0, 0}, {12, 2}, {60, 5}};

// ------------------------------------------------------------------------------------------------

Point_2 in_side(const Polyhedron_sides& sides, std::size_t i, const Point_3& p)
{
  const std::vector<std::size_t>& side = sides.sides[i];
  const Point_3 origin = sides.corners[side[0]];
  Vector_3 x = sides.corners[side[1]] - origin;
  x = x / std::sqrt(x.squared_length());
  Vector_3 normal = CGAL::cross_product(x, sides.corners[side[2]] - origin);
  normal = normal / std::sqrt(normal.squared_length());
  return Point_2((p - origin) * x, (p - origin) * CGAL::cross_product(normal, x));
}

void boxes(unsigned seed)
{
  const double a = 1, b = 0.7, c = 0.45;
  const Polyhedron_sides box = box_sides(a, b, c), cube = box_sides(1, 1, 1);
  const Polyhedron_distance box_distance(box), cube_distance(cube);
  for (const Size& size : sizes)
  {
    Case on_box("box, seed " + std::to_string(seed), rotated(box.triangulated(size.per_patch, size.per_edge, seed), seed));
    const auto at = [&](std::size_t side, double x, double y, double z) { return in_side(box, side, Point_3(x, y, z)); };

    // The three right angles at a corner.
    for (double d : {0.001, 0.2, 0.44})
      on_box.check_form(box_distance, "corner", on_box.start(2, at(2, 0, 0, 0)), false, d, {1, 0, 1.5 * pi * d});
    // An edge: a line on each side, and a quarter circle at each end.
    Path edge = on_box.start(2, at(2, 0, 0, 0));
    {
      std::vector<std::pair<double, std::size_t>> on_edge;
      const Soup plain = box.triangulated(size.per_patch, size.per_edge, seed);
      for (std::size_t v = 0; v < plain.points.size(); ++v)
        if (plain.points[v].y() == 0 && plain.points[v].z() == 0) on_edge.push_back({plain.points[v].x(), v});
      std::sort(on_edge.begin(), on_edge.end());
      edge.locations.clear();
      for (const auto& v : on_edge)
        edge.locations.push_back(on_box.generator().locations().at_vertex(on_box.data().vertices[v.second]));
      edge.legs.push_back({2, at(2, 0, 0, 0), at(2, a, 0, 0)});
    }
    for (double d : {0.001, 0.2, 0.44}) on_box.check_form(box_distance, "edge", edge, false, d, {1, 0, 2 * a + pi * d});
    // A ring at height z: rings above and below, then rectangles on top and bottom.
    const double z = 0.3;
    Path ring = on_box.start(2, at(2, 0, 0, z));
    on_box.go(ring, 2, at(2, a, 0, z));
    on_box.go(ring, 5, at(5, a, b, z));
    on_box.go(ring, 3, at(3, 0, b, z));
    on_box.close(ring, 4);
    const double round = 2 * (a + b);
    for (double d : {0.01, 0.1, 0.149}) on_box.check_form(box_distance, "ring", ring, true, d, {2, 0, 2 * round, 0, 0});
    for (double d : {0.16, 0.2, 0.29})
      on_box.check_form(box_distance, "ring", ring, true, d, {2, 0, 2 * round - 8 * (d - (c - z)), 0, 0});
    for (double d : {0.31, 0.4, 0.49})
      on_box.check_form(box_distance, "ring", ring, true, d, {2, 0, 2 * round - 8 * (d - (c - z)) - 8 * (d - z), 0, 0});

    // From the center of a cube's side: a circle, folded over the edges, and cut by the planes of symmetry behind the
    // corners.
    Case on_cube("cube, seed " + std::to_string(seed), rotated(cube.triangulated(size.per_patch, size.per_edge, seed), seed));
    const Path middle = on_cube.start(1, in_side(cube, 1, Point_3(0.5, 0.5, 1)));
    for (double d : {0.01, 0.3, 0.49, 0.55, 0.7})
      on_cube.check_form(cube_distance, "middle", middle, false, d, {1, 0, 2 * pi * d});
    for (double d : {0.75, 1., 1.4, 1.55})
      on_cube.check_form(cube_distance, "middle", middle, false, d, {1, 0, 8 * d * std::asin(0.5 / d)});
    for (double d : {1.65, 1.8, 1.95})
      on_cube.check_form(cube_distance, "middle", middle, false, d, {1, 0, 8 * d * (std::asin(std::sqrt(2.) / d) - pi / 4)});
  }
}

void prisms(unsigned seed)
{
  for (const std::size_t sides : {3u, 24u})
    for (const Size& size : sizes)
    {
      const Prism prism(sides, 0.5, 4);
      const Prism_distance distance(prism);
      const double period = prism.period(), w = prism.side_width(), h = prism.height;
      Case on("prism of " + std::to_string(sides) + " sides, seed " + std::to_string(seed),
              rotated(prism.triangulated(size.per_patch, size.per_edge, seed), seed));
      const Path point = on.start(1, Point_2(1.3 * w, h / 2));
      for (double d : {0.01, 0.2, 0.49 * period, 0.7 * period})
        if (d < h / 2)
          on.check_form(distance, "point", point, false, d,
                        d < period / 2 ? Expected{1, 0, 2 * pi * d} : Expected{2, 0, 4 * d * std::asin(period / 2 / d)});
      // Beyond both ends, above and below: two strips remain.
      const double rim = 0.5;
      const Path low = on.start(1, Point_2(1.3 * w, rim));
      for (double d : {0.6, 0.45 * period})
        if (d > rim) on.check_form(distance, "point near the rim", low, false, d, {0, 1, d * (pi + 2 * std::asin(rim / d))});
      // Around the prism at one height.
      Path ring = on.start(0, Point_2(0, 1.1));
      for (std::size_t i = 0; i + 1 < sides; ++i) on.go(ring, i, Point_2(static_cast<double>(i + 1) * w, 1.1));
      on.close(ring, sides - 1);
      for (double d : {0.001, 0.4, 1.09}) on.check_form(distance, "ring", ring, true, d, {2, 0, 2 * period, 0, 0});
      for (double d : {1.11, 2.8}) on.check_form(distance, "ring", ring, true, d, {1, 0, period, 0, 0});
      // A helix over three sides: straight in the unrolled strip.
      Path helix = on.start(0, Point_2(0.4 * w, 1.6));
      const double rise = 0.3;
      on.go(helix, 0, Point_2(w, 1.6 + rise * 0.6));
      on.go(helix, 1, Point_2(2 * w, 1.6 + rise * 1.6));
      on.go(helix, 2, Point_2(2.25 * w, 1.6 + rise * 1.85));
      const double l = std::hypot(1.85 * w, 1.85 * rise);
      for (double d : {0.01, 0.1, 0.2 * period})
        if (1.85 * w + 2 * d < period) on.check_form(distance, "helix", helix, false, d, {1, 0, 2 * l + 2 * pi * d});
      // Along a side.
      Path line = on.start(1, Point_2(1.37 * w, 1.7));
      on.go(line, 1, Point_2(1.37 * w, 2.3));
      for (double d : {0.01, 0.3 * period, 0.5001 * period})
        if (d < 1.7)
          on.check_form(distance, "line along", line, false, d,
                        d < period / 2 ? Expected{1, 0, 2 * 0.6 + 2 * pi * d}
                                       : Expected{2, 0, 4 * d * std::asin(period / 2 / d)});
    }
}

// ------------------------------------------------------------------------------------------------

Point_2 polar(double r, double angle) { return Point_2(r * std::cos(angle), r * std::sin(angle)); }

void cones(unsigned seed)
{
  for (const double turns : {0.2, 0.4, 0.75, 0.95, 1.1, 1.5, 2.2})
    for (const Size& size : sizes)
    {
      const Cone cone(16, turns * 2 * pi, 1);
      const Cone_distance distance(cone);
      const double theta = cone.total_angle, sector = cone.sector_angle(), largest = std::cos(sector / 2);
      Case on("cone of " + std::to_string(turns) + " turns, seed " + std::to_string(seed),
              rotated(cone.triangulated(size.per_patch, size.per_edge, seed), seed));
      const Path apex = on.start(0, Point_2(0, 0));
      for (double d : {0.001, 0.3, 0.98 * largest}) on.check_form(distance, "apex", apex, false, d, {1, 0, theta * d});

      const double h = 0.35, alpha = theta / 2;
      const Path point = on.start(3, polar(h, 0.3 * sector));
      for (double d : {0.02, 0.2, 0.3, 0.349, 0.36, 0.45, 0.98 * (largest - h)})
      {
        if (d > largest - h) continue;
        const double shadow = theta > 2 * pi && d > h ? (theta - 2 * pi) * (d - h) : 0;
        Expected expected{1, 0, 2 * pi * d + shadow, shadow};
        if (alpha < pi)
        {
          // Cut along the ray opposite to the source, the cone is a wedge of half angle alpha.
          const double beta = std::asin((std::min)(1., h * std::sin(alpha) / d));
          if (d > h) expected.length = 2 * d * (alpha + beta);
          else if (alpha < pi / 2 && d > h * std::sin(alpha))
            expected = {2, 0, 2 * d * (alpha + beta) + 2 * d * (beta - alpha)};
        }
        on.check_form(distance, "point off the apex", point, false, d, expected);
      }
      if (theta > 2 * pi)
      {
        // Towards the apex, and up to it; a bend at it.
        Path radial = on.start(2, polar(0.2, 0.4 * sector));
        on.go(radial, 2, polar(0.5, 0.4 * sector));
        for (double d : {0.05, 0.19, 0.21, 0.35})
        {
          const double shadow = d > 0.2 ? (theta - 2 * pi) * (d - 0.2) : 0;
          on.check_form(distance, "radial segment", radial, false, d, {1, 0, 2 * 0.3 + 2 * pi * d + shadow, shadow});
        }
      }
      if (theta > pi)
      {
        Path to_apex = on.start(2, polar(0.5, 0.4 * sector));
        on.go(to_apex, 2, Point_2(0, 0));
        for (double d : {0.05, 0.2, 0.35})
          on.check_form(distance, "segment to the apex", to_apex, false, d, {1, 0, 2 * 0.5 + pi * d + (theta - pi) * d});
      }
      for (const std::size_t other : {6u, 11u})
      {
        Path bent = on.start(2, polar(0.5, 0.4 * sector));
        on.go(bent, 2, Point_2(0, 0));
        on.go(bent, other, polar(0.45, 0.7 * sector));
        const double d = 0.08, first = (static_cast<double>(other - 2) + 0.3) * sector;
        double length = 2 * pi * d;
        bool is_simple = true;
        for (const double angle : {first, theta - first})
        {
          length += 0.5 + 0.45;
          if (angle >= pi) length += (angle - pi) * d;
          else length -= 2 * d / std::tan(angle / 2);
          // Otherwise the caps of the arms meet, too.
          is_simple = is_simple && (angle > pi / 2 || d / std::tan(angle / 2) < 0.3);
        }
        if (is_simple) on.check_form(distance, "bent at the apex", bent, false, d, {1, 0, length});
      }
    }

  for (const double turns : {0.3, 0.8, 1.15, 2.6})
    for (const Size& size : sizes)
    {
      const Cone cone(20, turns * 2 * pi, 1, true);
      const Cone_distance distance(cone);
      const double theta = cone.total_angle, sector = cone.sector_angle();
      Case on("open cone of " + std::to_string(turns) + " turns, seed " + std::to_string(seed),
              rotated(cone.triangulated(size.per_patch, size.per_edge, seed), seed));
      for (double d : {0.001, 0.4, 0.97 * std::cos(sector / 2)})
        on.check_form(distance, "apex", on.start(0, Point_2(0, 0)), false, d, {0, 1, theta * d});
      if (theta <= 2 * pi) continue;
      const double h = 0.3;
      const Path point = on.start(10, polar(h, 0.2 * sector)); // pi is visible to either side
      if (10.2 * sector < pi || 9.8 * sector < pi) continue;
      for (double d : {0.1, 0.29}) on.check_form(distance, "point", point, false, d, {1, 0, 2 * pi * d});
      for (double d : {0.31, 0.5})
        on.check_form(distance, "point", point, false, d,
                      {0, 1, 2 * pi * d + (theta - 2 * pi) * (d - h), (theta - 2 * pi) * (d - h)});
    }
}

// ------------------------------------------------------------------------------------------------

void tetrahedra(unsigned seed)
{
  const Polyhedron_sides sides = tetrahedron_sides();
  const Polyhedron_distance distance(sides);
  const double a = std::sqrt(8.), height = a * std::sqrt(0.75);
  for (const Size& size : sizes)
  {
    Case on("tetrahedron, seed " + std::to_string(seed),
            rotated(sides.triangulated(size.per_patch, size.per_edge, seed), seed));
    // The tetrahedron tiles the plane: images of a vertex form a lattice with step 2 a.
    const Path vertex = on.start(0, Point_2(0, 0));
    for (double d : {0.01, 1., 0.999 * a}) on.check_form(distance, "vertex", vertex, false, d, {1, 0, pi * d});
    for (double d : {1.001 * a, 1.08 * a, 1.14 * a})
      on.check_form(distance, "vertex", vertex, false, d, {1, 0, cut_level(d) * (pi - 6 * std::acos(a / cut_level(d)))});

    // Images of any other source: half turns about the points of the lattice with step a.
    Random random(seed);
    const auto in_side_0 = [&]() {
      const auto w = random_barycentric(random);
      return Point_2(w[1] * a + w[2] * a / 2, w[2] * height);
    };
    for (int kind = 0; kind < 6; ++kind)
    {
      Path path = on.start(0, in_side_0());
      for (int i = 0; i < kind; ++i) on.go(path, 0, in_side_0());
      std::vector<Leg> images;
      for (const Leg& leg : on.legs(path))
        for (int m = -4; m <= 4; ++m)
          for (int n = -3; n <= 3; ++n)
          {
            const Vector_2 shift(2 * m * a + n * a, 2 * n * height);
            images.push_back({0, leg.a + shift, leg.b + shift});
            images.push_back({0, CGAL::ORIGIN + (shift - (leg.a - CGAL::ORIGIN)),
                              CGAL::ORIGIN + (shift - (leg.b - CGAL::ORIGIN))});
          }
      // A fundamental domain with a corner at a generic position.
      const Rectangle box{0.123, 0, 0.123 + 2 * a, height};
      for (double d : {0.05, 0.3, 0.9, 1.6})
      {
        Report::instance().set_context("tetrahedron, tiling");
        guarded([&] {
          const Planar_offset expected(images, cut_level(d), box);
          if (expected.pieces().empty()) return;
          on.check_form(distance, "path of " + std::to_string(kind) + " legs", path, false, d, {any, 0, expected.length()});
        });
      }
    }
  }
}

// ------------------------------------------------------------------------------------------------

/// Torus of n x m flat quads. By symmetry, one strip of quads from ring to ring, unfolded into the plane, gives all
/// distances from a ring.
struct Torus
{
  Torus(std::size_t n, std::size_t m, double major, double minor) : n(n), m(m), major(major), minor(minor) {}

  double radius(std::size_t j) const { return major + minor * std::cos(angle(j)); }
  double angle(std::size_t j) const { return 2 * pi * static_cast<double>(j) / static_cast<double>(m); }
  /// Half the length of an edge of ring j.
  double half_chord(std::size_t j) const { return radius(j) * std::sin(pi / static_cast<double>(n)); }
  /// From the midpoint of an edge of ring j to that of ring j + 1.
  double slant(std::size_t j) const
  {
    return std::hypot((radius(j + 1) - radius(j)) * std::cos(pi / static_cast<double>(n)),
                      minor * (std::sin(angle(j + 1)) - std::sin(angle(j))));
  }
  double leg(std::size_t j) const { return std::hypot(slant(j), half_chord(j + 1) - half_chord(j)); }

  /// Vertices i m + j of the soup.
  Path path(const Case& on, const std::vector<std::size_t>& vertices) const
  {
    Path result;
    const Locations<test::Surface_mesh> locations(on.data().mesh);
    for (std::size_t v : vertices) result.locations.push_back(locations.at_vertex(on.data().vertices[v]));
    return result;
  }

  /// The quad (i, j) of a location, and its coordinates: along the edge of ring j from its midpoint, and from that edge
  /// towards ring j + 1.
  Point_2 in_quad(const Case& on, const Soup& soup, const Face_location& l, std::size_t& j) const
  {
    const std::size_t quad = on.data().face_number(l.first) / 2, i = quad / m;
    j = quad % m;
    const Point_3 a = soup.points[i * m + j], b = soup.points[(i + 1) % n * m + j],
                  c = soup.points[(i + 1) % n * m + (j + 1) % m], e = soup.points[i * m + (j + 1) % m];
    const Vector_3 along = b - a, up = CGAL::midpoint(e, c) - CGAL::midpoint(a, b);
    const Vector_3 v = Locations<test::Surface_mesh>(on.data().mesh).point(l) - CGAL::midpoint(a, b);
    return Point_2(v * along / std::sqrt(along.squared_length()), v * up / std::sqrt(up.squared_length()));
  }

  std::size_t n, m;
  double major, minor;
};

void tori()
{
  for (const Torus& t : {Torus(12, 16, 1, 0.4), Torus(7, 24, 2, 0.7), Torus(30, 12, 1, 0.5)})
  {
    const Soup soup = rotated(torus(t.n, t.m, t.major, t.minor), 4);
    Case on("torus of " + std::to_string(t.n) + " x " + std::to_string(t.m) + " quads", soup);
    const double n = static_cast<double>(t.n);
    const std::size_t m = t.m;

    // All strips get narrower from the outer equator: the distance is the length along the strip, and the offsets are
    // polygons.
    std::vector<std::size_t> outer, inner, meridian;
    for (std::size_t i = 0; i < t.n; ++i)
    {
      outer.push_back(i * m);
      inner.push_back(i * m + m / 2);
    }
    for (std::size_t j = 0; j < m; ++j) meridian.push_back(j);
    std::vector<double> up(1, 0);
    for (std::size_t j = 0; j < m / 2; ++j) up.push_back(up.back() + t.slant(j));
    const auto from_outer = [&](const Face_location& l) {
      std::size_t j;
      const Point_2 p = t.in_quad(on, soup, l, j);
      return j < m / 2 ? up[j] + p.y() : up[m - j] - p.y();
    };
    for (double part : {0.001, 0.03, 0.2, 0.5, 0.71, 0.99})
    {
      const double d = part * up.back();
      std::size_t j = 0;
      while (up[j + 1] < d) ++j;
      const double s = (d - up[j]) / t.slant(j);
      const double half = (1 - s) * t.half_chord(j) + s * t.half_chord(j + 1);
      on.check("outer equator", t.path(on, outer), true, d, {2, 0, 2 * n * 2 * half, 0, 0}, from_outer);
    }

    // From the inner equator, strips get wider, at an increasing rate up to the highest ring: beside the legs, shortest
    // paths bend at the vertices.
    const std::size_t quarter = m / 4;
    std::vector<double> angle, length(1, 0), rise(1, 0); // lengths of legs; distances of the rings
    for (std::size_t k = 0; k < quarter; ++k)
    {
      const std::size_t j = m / 2 + k;
      angle.push_back(std::atan2(t.half_chord(j + 1) - t.half_chord(j), t.slant(j)));
      length.push_back(length.back() + t.leg(j));
      rise.push_back(rise.back() + t.slant(j));
    }
    const auto from_inner = [&](const Face_location& l) {
      std::size_t j;
      const Point_2 p = t.in_quad(on, soup, l, j);
      const std::size_t k = j >= m / 2 ? j - m / 2 : m / 2 - 1 - j;
      const double y = rise[k] + (j >= m / 2 ? p.y() : t.slant(j) - p.y()), x = std::abs(p.x());
      if (x <= t.half_chord(m / 2)) return y;
      // The last vertex on the side of the strip that the shortest path passes.
      double result = 0;
      for (std::size_t i = 0; i <= k; ++i)
      {
        const double dx = x - t.half_chord(m / 2 + i), dy = y - rise[i];
        if (i > 0 && std::atan2(dx, dy) < angle[i - 1]) break;
        result = length[i] + std::hypot(dx, dy);
      }
      return result;
    };
    for (double part : {0.001, 0.1, 0.3, 0.6, 0.8, 0.99})
    {
      const double d = part * rise.back();
      double straight = 2 * t.half_chord(m / 2) + 2 * angle[0] * d, bent = 0;
      for (std::size_t k = 1; k < quarter; ++k)
        if (d > length[k]) bent += 2 * (angle[k] - angle[k - 1]) * (d - length[k]);
      on.check("inner equator", t.path(on, inner), true, d, {2, 0, 2 * n * (straight + bent), 2 * n * bent}, from_inner);
    }

    // From a meridian, as long as the offset stays in the adjacent quads: the length lost or gained at each vertex depends
    // on its angle.
    double legs = 0, shift = 0; // for distance 1
    for (std::size_t j = 0; j < m; ++j)
    {
      legs += t.leg(j);
      const auto base_angle = [&](std::size_t k) // of quad k at ring k
      { return pi / 2 + std::atan2(t.half_chord(k + 1) - t.half_chord(k), t.slant(k)); };
      const double beta = base_angle(j) + pi - base_angle((j + m - 1) % m);
      shift += beta >= pi ? beta - pi : -2 / std::tan(beta / 2);
    }
    for (double d : {0.001, 0.01, 0.02})
      on.check("meridian", t.path(on, meridian), true, d, {2, 0, 2 * (legs + shift * d)},
               std::function<double(const Face_location&)>());
  }
}

} // namespace test_closed_form_offsets

GEODESIC_OFFSET_TEST(test_closed_form_offsets)
{
  std::cout.precision(3);
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    boxes(seed);
    print_totals("boxes");
    prisms(seed);
    print_totals("prisms");
    cones(seed);
    print_totals("cones");
    tetrahedra(seed);
    print_totals("tetrahedra");
  }
  tori();
  print_totals("tori");
  return Report::instance().finish("test_closed_form_offsets");
}
