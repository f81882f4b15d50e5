// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Families of offsets: all forms of requests give the same curves, one propagation serves any number of levels, curves
// arrive by distance during the propagation.

#include "query_cases.h"
#include "search_cases.h"

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_offset_families {

using namespace test;
typedef CGAL::Offset_levels<double> Levels;

double worst_length = 0;
std::size_t number_of_curves = 0;

// Curves received by a callback, which is called by increasing distance.
struct Received
{
  std::vector<double> distances;
  Offset_curves curves;
  void operator()(double distance, Offset_curves&& some)
  {
    CHECK(distances.empty() || distances.back() < distance);
    for (const Offset_curve& c : some) CHECK(c.distance() == distance);
    distances.push_back(distance);
    std::move(some.begin(), some.end(), std::back_inserter(curves));
  }
};

template <class Family>
Offset_curves cut_during_build(Geodesic& geodesic, const Family& family)
{
  Offset_curves result;
  geodesic.build_with_offset_curves(family, std::back_inserter(result));
  return result;
}

// Compares every way to request the curves of a family with one level at a time from kept windows. `levels`: those of the
// family in increasing order; `called`: expected number of levels for a callback.
template <class Family>
void compare(const test::Surface_mesh& mesh, const std::vector<Source>& sources, const Family& family,
             const std::vector<double>& levels, std::size_t called)
{
  Geodesic kept = built(mesh, sources), plain = built(mesh, sources, false);
  Offset_curves one_by_one;
  for (double level : levels)
  {
    const Offset_curves curves = offsets(kept, level);
    one_by_one.insert(one_by_one.end(), curves.begin(), curves.end());
  }
  number_of_curves += one_by_one.size();
  const double scale = bounding_box_diagonal(mesh);
  const auto same = [&](const char* way, const Offset_curves& curves) {
    for (std::size_t i = 0; i + 1 < curves.size(); ++i) CHECK(curves[i].distance() <= curves[i + 1].distance());
    CHECK_DETAIL(same_curves(curves, one_by_one, scale, worst_length),
                 std::string(way) + ": " + std::to_string(curves.size()) + " curves of length " +
                   std::to_string(total_length(curves)) + ", not " + std::to_string(one_by_one.size()) + " of length " +
                   std::to_string(total_length(one_by_one)));
  };
  same("kept windows", offsets(kept, family));
  same("windows not kept", offsets(plain, family));
  Geodesic again(mesh);
  again.add_sources(source_set(sources));
  same("built with", cut_during_build(again, family));
  CHECK(again.is_built() &&
        again.distance_to_sources(*vertices(mesh).begin()) == plain.distance_to_sources(*vertices(mesh).begin()));
  // cutting and keeping need lower envelopes; without them, a few more windows are propagated, most where many meet at
  // once, opposite to the source on a small sphere
  const std::size_t windows = kept.statistics().windows_propagated;
  CHECK(again.statistics().windows_propagated == windows);
  CHECK(plain.statistics().windows_propagated <= windows + windows / 20 + 10);
  if (levels.size() < 3) return;

  const std::vector<double> expected(levels.begin(), levels.begin() + static_cast<std::ptrdiff_t>(called));
  const auto check_received = [&](const char* way, const Received& r) {
    CHECK_DETAIL(r.distances == expected, std::string(way) + ": called " + std::to_string(r.distances.size()) + " times, not " +
                                            std::to_string(expected.size()));
    same(way, r.curves);
  };
  Received from_kept, from_plain, while_built, while_built_and_kept;
  const auto to = [](Received& r) { return [&r](const double& d, Offset_curves&& c) { r(d, std::move(c)); }; };
  kept.offset_curves_by_distance(family, to(from_kept));
  plain.offset_curves_by_distance(family, to(from_plain));
  again.build_with_offset_curves_by_distance(family, to(while_built));
  again.build_with_offset_curves_by_distance(family, to(while_built_and_kept), CGAL::parameters::keep_windows(true));
  check_received("callback, kept windows", from_kept);
  check_received("callback, windows not kept", from_plain);
  check_received("callback while built", while_built);
  check_received("callback while built, windows kept", while_built_and_kept);
}

// Part of a curve in one face on one circle or line. Source and piece numbers are left out: collinear segments of a source
// tie everywhere, and rounding decides between them.
struct Stroke
{
  std::size_t face;
  Point_2 start, end, center;
  double radius; // 0: a segment

  Stroke(const Offset_piece& p)
    : face(p.face()), start(p.start_2()), end(p.end_2()), center(p.is_arc() ? p.center() : start),
      radius(p.is_arc() ? p.radius() : 0)
  {
  }

  static double distance(const Point_2& p, const Point_2& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

  bool is_continued(const Stroke& next, double rounding) const
  {
    if (face != next.face || (radius == 0) != (next.radius == 0)) return false;
    if (radius > 0) return distance(center, next.center) <= rounding && std::abs(radius - next.radius) <= rounding;
    return distance(start, end) + distance(next.start, next.end) <= distance(start, next.end) + rounding;
  }
  bool is_near(const Stroke& s, double rounding) const
  {
    return face == s.face && distance(start, s.start) <= rounding && distance(end, s.end) <= rounding &&
           std::abs(radius - s.radius) <= rounding && (radius == 0 || distance(center, s.center) <= rounding);
  }
};

std::vector<Stroke> strokes(const Offset_curves& curves, double rounding)
{
  std::vector<Stroke> result;
  for (const Offset_curve& curve : curves)
  {
    std::vector<Stroke> all;
    for (const Offset_piece& p : curve.pieces())
      if (p.length() > rounding) all.push_back(p);
    std::size_t first = 0; // index of the first stroke of one
    if (curve.is_closed())
      while (first < all.size() && all[(first + all.size() - 1) % all.size()].is_continued(all[first], rounding)) ++first;
    if (first < all.size()) std::rotate(all.begin(), all.begin() + std::ptrdiff_t(first), all.end());
    const std::size_t begin = result.size();
    for (const Stroke& s : all)
      if (result.size() > begin && result.back().is_continued(s, rounding)) result.back().end = s.end;
      else result.push_back(s);
  }
  return result;
}

// Whether the strokes can be paired.
bool same_strokes(const std::vector<Stroke>& a, const std::vector<Stroke>& b, double rounding)
{
  std::multimap<std::size_t, Stroke> left; // of b, by face
  for (const Stroke& s : b) left.emplace(s.face, s);
  for (const Stroke& s : a)
  {
    auto [partner, end] = left.equal_range(s.face);
    while (partner != end && !s.is_near(partner->second, rounding)) ++partner;
    if (partner == end) return false;
    left.erase(partner);
  }
  return left.empty();
}

std::size_t windows_with_limit = 0, windows_without_limit = 0; // for levels in the nearer half
std::size_t number_of_limited_strokes = 0;

// With a distance limit equal to the largest level, the curves are those of the build without limit, piece by piece up to
// rounding, also at levels through vertices and the farthest point.
void limited_to_the_largest_level(const test::Surface_mesh& mesh, const std::vector<Source>& sources, unsigned seed)
{
  Geodesic geodesic(mesh);
  geodesic.add_sources(source_set(sources));
  geodesic.build(CGAL::parameters::compute_largest_distance(true));
  const double farthest = geodesic.largest_distance().value();
  std::vector<double> at_vertices;
  for (auto v : vertices(mesh))
    if (const double d = geodesic.distance_to_sources(v); d > 0 && std::isfinite(d)) at_vertices.push_back(d);
  std::sort(at_vertices.begin(), at_vertices.end());
  Random random(seed);
  std::vector<double> levels = {farthest, at_vertices.front(), at_vertices.back()};
  for (int i = 0; i < 3; ++i)
  {
    levels.push_back(uniform(random, 0.02, 1) * farthest);
    levels.push_back(at_vertices[uniform_index(random, at_vertices.size())]);
  }
  for (const double level : levels)
    for (const double factor : {1., 1 + 1e-15, 1 - 1e-15})
    {
      const double largest = factor * level;
      const std::vector<double> both = {0.4 * largest, largest};
      Offset_curves limited, unlimited;
      geodesic.build_with_offset_curves(both, std::back_inserter(unlimited));
      const std::size_t all = geodesic.statistics().windows_propagated;
      geodesic.build_with_offset_curves(both, std::back_inserter(limited), CGAL::parameters::distance_limit(largest));
      const std::size_t windows = geodesic.statistics().windows_propagated;
      CHECK(windows <= all);
      if (largest < 0.5 * farthest)
      {
        windows_with_limit += windows;
        windows_without_limit += all;
      }
      const std::string at = "at " + std::to_string(level / farthest) + " of the largest distance";
      const double scale = bounding_box_diagonal(mesh), rounding = 1e-11 * scale;
      CHECK_DETAIL(same_curves(limited, unlimited, scale, worst_length), at);
      CHECK_DETAIL(same_strokes(strokes(limited, rounding), strokes(unlimited, rounding), rounding), at);
      number_of_limited_strokes += strokes(limited, rounding).size();
    }
}

void all_ways(const std::string& name, const test::Surface_mesh& mesh, const std::vector<Source>& sources)
{
  Report::instance().set_context(name);
  guarded([&] {
    const Geodesic geodesic = built(mesh, sources, false);
    limited_to_the_largest_level(mesh, sources, unsigned(mesh.number_of_faces()));
    const double largest = largest_vertex_distance(geodesic, mesh);
    const auto part = [&](double x) { return x * largest; };
    compare(mesh, sources, part(0.37), {part(0.37)}, 1);
    compare(mesh, sources, std::vector<double>{part(0.1), part(0.45), part(0.9)}, {part(0.1), part(0.45), part(0.9)}, 3);
    // unsorted, repeated, beyond the largest distance
    compare(mesh, sources, std::vector<double>{part(3), part(0.6), part(0.2), part(2), part(0.6), part(0.2), part(0.03)},
            {part(0.03), part(0.2), part(0.6), part(2), part(3)}, 5);
    const double spacing = largest / 7.3;
    std::vector<double> multiples;
    for (int i = 1; i <= 12; ++i) multiples.push_back(i * spacing);
    compare(mesh, sources, Levels::equally_spaced(spacing, 5), {multiples.begin(), multiples.begin() + 5}, 5);
    compare(mesh, sources, Levels::equally_spaced(spacing, 12), multiples, 12);
    std::vector<double> started;
    for (int i = 0; i < 5; ++i) started.push_back(part(0.05) + i * spacing);
    compare(mesh, sources, Levels::equally_spaced(spacing, 5, part(0.05)), started, 5);
    // until covered: one more level than multiples below the farthest vertex may exist inside a face
    const std::size_t covered = offsets(geodesic, multiples[7]).empty() ? 7 : 8;
    CHECK(offsets(geodesic, multiples[8]).empty());
    compare(mesh, sources, Levels::equally_spaced(spacing),
            {multiples.begin(), multiples.begin() + static_cast<std::ptrdiff_t>(covered)}, covered);
  });
}

// The number of windows does not depend on the number of levels.
void one_propagation(const test::Surface_mesh& mesh, const Source_set& sources)
{
  Report::instance().set_context("one propagation");
  Geodesic geodesic = built(mesh, sources);
  const double largest = largest_vertex_distance(geodesic, mesh);
  const std::size_t whole = geodesic.statistics().windows_propagated;
  CHECK(whole > 0);
  for (double share : {1., 0.3})
  {
    const auto maximum = CGAL::parameters::distance_limit(share * largest);
    geodesic.build(maximum.keep_windows(true));
    const std::size_t expected = geodesic.statistics().windows_propagated;
    CHECK(share == 1 ? expected <= whole : expected < whole);
    for (std::size_t n : {1, 200})
    {
      Offset_curves curves;
      geodesic.build_with_offset_curves(Levels::equally_spaced(share * largest / (double(n) + 0.5), n),
                                        std::back_inserter(curves), maximum);
      CHECK(geodesic.statistics().windows_propagated == expected);
      CHECK(curves.size() >= n);
      // pieces are counted before neighbours across an edge become one arc
      CHECK(geodesic.statistics().pieces >= sorted_pieces(curves).size());
    }
  }
}

// Counts changes of frame, which propagated windows take, so that a callback can measure the progress of the front.
struct Counting_traits : CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh>
{
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh> Base;
  static std::size_t& count()
  {
    static std::size_t value = 0;
    return value;
  }
  struct Change_frame_2 : Base::Change_frame_2
  {
    template <class... Arguments>
    auto operator()(Arguments&&... arguments) const
    {
      ++count();
      return Base::Change_frame_2::operator()(std::forward<Arguments>(arguments)...);
    }
  };
  Change_frame_2 change_frame_2_object() const { return Change_frame_2(); }
};

struct Enough : std::exception
{
};

// On a long strip, curves arrive soon after the front has passed them; an exception of the callback stops the propagation
// and leaves the last build unchanged.
void streaming()
{
  Report::instance().set_context("streaming");
  const Generated_mesh<test::Surface_mesh> strip(planar_grid(400, 4, Diagonals::alternating, 1, 0.2, 3));
  typedef CGAL::Surface_mesh_geodesic_offset<Counting_traits> Counted;
  Counted geodesic(strip.mesh);
  const auto left = strip.vertices[0], right = strip.vertices[400];
  geodesic.add_source_point(left);
  std::size_t& count = Counting_traits::count();
  count = 0;
  geodesic.build();
  const std::size_t all = count;
  CHECK_DETAIL(all > 1000, std::to_string(all));
  // without levels, a build without windows is not repeated
  count = 0;
  std::size_t levels = 0;
  geodesic.offset_curves_by_distance(std::vector<double>(), [&](double, std::vector<Counted::Offset_curve>&&) { ++levels; });
  CHECK_DETAIL(count == 0 && levels == 0, std::to_string(count));
  for (const bool keep : {false, true})
  {
    std::vector<std::size_t> counts;
    count = 0;
    geodesic.build_with_offset_curves_by_distance(
      Levels::equally_spaced(20, 19), [&](double, std::vector<Counted::Offset_curve>&&) { counts.push_back(count); },
      CGAL::parameters::keep_windows(keep));
    CHECK_DETAIL(count == all, std::to_string(count) + ", without offsets " + std::to_string(all));
    if (CHECK(counts.size() == 19))
      for (std::size_t i = 0; i < 19; ++i)
      { // the front is at most a twentieth of the strip beyond the level
        const double share = double(counts[i]) / double(all), level = double(20 * (i + 1)) / 400;
        CHECK_DETAIL(share < level + 0.05 && share > level - 0.05, values(share, level));
      }
  }

  const double distance = geodesic.distance_to_sources(right);
  CHECK(std::isfinite(distance));
  geodesic.clear_sources();
  geodesic.add_source_point(right);
  count = 0;
  CHECK_THROWS(geodesic.build_with_offset_curves_by_distance(Levels::equally_spaced(20),
                                                             [](double d, std::vector<Counted::Offset_curve>&&) {
                                                               if (d > 50) throw Enough();
                                                             }),
               Enough);
  CHECK_DETAIL(count < all / 4,
               std::to_string(count) + " of " + std::to_string(all)); // it stopped at 60
  CHECK(geodesic.is_built() && geodesic.distance_to_sources(right) == distance && geodesic.distance_to_sources(left) == 0);
  std::size_t calls = 0;
  geodesic.offset_curves_by_distance(100., [&](double, std::vector<Counted::Offset_curve>&& curves) {
    ++calls;
    CHECK(curves.size() == 1 && curves[0].number_of_pieces() > 0);
  });
  CHECK(calls == 1);
  CHECK_THROWS(geodesic.offset_curves_by_distance(100., [](double, std::vector<Counted::Offset_curve>&&) { throw Enough(); }),
               Enough);
  // a rejected selection also leaves the last build unchanged
  geodesic.add_source_polyline(std::vector<Counted::Face_location>{{strip.faces[0], {{0.4, 0.3, 0.3}}},
                                                                   {strip.faces[0], {{0.3, 0.4, 0.3}}}});
  std::vector<Counted::Offset_curve> none;
  CHECK_THROWS(geodesic.build_with_offset_curves(1., std::back_inserter(none),
                                                 CGAL::parameters::offset_side(CGAL::Offset_side::INSIDE)),
               std::invalid_argument);
  CHECK(none.empty() && geodesic.distance_to_sources(right) == distance);
}

// A strip of 1 x 1 squares, 4 high, and a fan of faces as long as the strip from its upper side to a point far above.
Soup strip_with_long_faces(std::size_t columns)
{
  Soup soup = planar_grid(columns, 4, Diagonals::alternating);
  const std::size_t upper = 4 * (columns + 1), tip = soup.points.size();
  soup.points.push_back({double(columns) / 2, 4 + double(columns), 0});
  for (std::size_t i = 0; i < columns; ++i) soup.add_triangle({upper + i, upper + i + 1, tip});
  return soup;
}

// Levels do not wait until faces that are long against their spacing are finalized: these faces are cut before.
void long_faces()
{
  Report::instance().set_context("long faces");
  const Generated_mesh<test::Surface_mesh> fan(strip_with_long_faces(400));
  typedef CGAL::Surface_mesh_geodesic_offset<Counting_traits> Counted;
  Counted geodesic(fan.mesh);
  geodesic.add_source_point(fan.vertices[0]);
  std::size_t& count = Counting_traits::count();
  count = 0;
  geodesic.build();
  const std::size_t all = count;
  const double spacing = 0.2;
  std::vector<std::pair<double, std::size_t>> calls; // distance, count
  count = 0;
  geodesic.build_with_offset_curves_by_distance(Levels::equally_spaced(spacing, 1900),
                                                [&](double d, std::vector<Counted::Offset_curve>&& curves) {
                                                  CHECK(!curves.empty());
                                                  calls.push_back({d, count});
                                                });
  CHECK(count == all && calls.size() == 1900);
  // A fourth as many pieces as the mesh has faces may wait, and each level has six pieces or more.
  const double longest_wait = spacing * double(num_faces(fan.mesh)) / 4 / 6;
  double worst = 0;
  for (const auto& [distance, counted] : calls)
  { // the number of windows grows evenly with the distance
    const double waited = 400 * double(counted) / double(all) - distance;
    worst = (std::max)(worst, waited);
  }
  CHECK_DETAIL(worst < longest_wait + 20, values(worst, longest_wait));
  std::cout << "long faces: the front is at most " << worst << " ahead of the curves in a strip of length 400" << std::endl;

  const Generated_mesh<test::Surface_mesh> short_fan(strip_with_long_faces(120));
  std::vector<double> multiples;
  for (int i = 1; i <= 200; ++i) multiples.push_back(0.55 * i);
  for (const std::size_t source : {std::size_t(0), std::size_t(60), short_fan.vertices.size() - 1})
    compare(short_fan.mesh, {point_source(short_fan.vertices[source])}, Levels::equally_spaced(0.55, multiples.size()),
            multiples, multiples.size());
}

// Levels that are close against the faces: few pieces are in memory at one time.
void close_levels()
{
  Report::instance().set_context("close levels");
  const Generated_mesh<test::Surface_mesh> fan(strip_with_long_faces(100));
  for (const double spacing : {0.01, 0.002})
  {
    Geodesic geodesic(fan.mesh);
    geodesic.add_source_point(fan.vertices[0]);
    std::size_t calls = 0;
    geodesic.build_with_offset_curves_by_distance(Levels::equally_spaced(spacing, std::size_t(90 / spacing)),
                                                  [&](double, Offset_curves&&) { ++calls; });
    const CGAL::Geodesic_offset_statistics& s = geodesic.statistics();
    // less than those of the levels between two buckets of the front, 5 % of all
    CHECK_DETAIL(s.pieces_peak > 0 && 50 * s.pieces_peak < s.pieces, values(s.pieces_peak, s.pieces));
    std::cout << "close levels: spacing " << spacing << ", " << calls << " levels, " << s.pieces << " pieces, at most "
              << s.pieces_peak << " at one time; " << num_faces(fan.mesh) << " faces" << std::endl;
  }
}

// Few pieces are in memory at one time while a family is cut.
void check_waiting_pieces(const std::string& name, const Soup& soup, const std::function<void(Geodesic&)>& add_sources,
                          const std::vector<double>& levels)
{
  const Generated_mesh<test::Surface_mesh> data(soup);
  Geodesic geodesic(data.mesh);
  add_sources(geodesic);
  const std::size_t n = levels.size();
  std::size_t calls = 0;
  geodesic.build_with_offset_curves_by_distance(levels, [&](double, Offset_curves&&) { ++calls; });
  const CGAL::Geodesic_offset_statistics& s = geodesic.statistics();
  // twice one for four faces, but for 1024 at least, as levels at the front are not complete; and those of three levels, of which
  // one is cut
  const std::size_t most = 3 * s.pieces / n + 2 * (std::max)(std::size_t(num_faces(data.mesh)) / 4, std::size_t(1024));
  CHECK_DETAIL(calls == n && s.pieces_peak <= most, name + ": " + values(s.pieces_peak, most));
  std::cout << name << ": " << s.pieces << " pieces, at most " << s.pieces_peak << " at one time; " << num_faces(data.mesh)
            << " faces" << std::endl;
}

// Adds n levels between two distances, equally spaced.
void add_levels(std::vector<double>& levels, double low, double high, int n)
{
  for (int i = 0; i < n; ++i) levels.push_back(low + (high - low) * (i + 0.5) / n);
}

// Also where many faces are finalized together: rings of a cylinder around its border, of many rings and of one, a fan of faces,
// and a strip that the front has passed before its first face is finalized.
void faces_finalized_together()
{
  Report::instance().set_context("faces that are finalized together");
  const auto run =
    [&](const std::string& name, const Soup& soup, const std::function<void(Geodesic&)>& add_source, double length) {
      std::vector<double> levels;
      add_levels(levels, 0, length, 500);
      check_waiting_pieces(name, soup, add_source, levels);
    };
  const auto from_border = [](Geodesic& g) { g.add_source_boundary(); };
  const auto from_vertex = [](Geodesic& g) { g.add_source_point(test::Surface_mesh::Vertex_index(0)); };
  run("many rings", tube(100, 12, 1, 0.5), from_border, 3);
  run("one ring", tube(100, 1, 1, 6), from_border, 3);
  run("one ring, from a vertex", tube(300, 1, 1, 6), from_vertex, 6);
  run("strip", planar_grid(1, 300), from_vertex, 300);
  Soup cone = tube(500, 0, 1, 0); // its rim
  const std::size_t tip = cone.points.size();
  cone.points.push_back({0, 0, 3});
  for (std::size_t i = 0; i < 500; ++i) cone.add_triangle({i, (i + 1) % 500, tip});
  run("cone", cone, from_vertex, 4);

  // the first bucket is longer than the faces of one cone, whose levels also cross the needles of the other
  Soup double_cone = tube(500, 0, 0.01, 0);
  for (const double z : {3., -0.1})
  {
    const std::size_t end = double_cone.points.size();
    double_cone.points.push_back({0, 0, z});
    for (std::size_t i = 0; i < 500; ++i)
      if (z > 0) double_cone.add_triangle({i, (i + 1) % 500, end});
      else double_cone.add_triangle({(i + 1) % 500, i, end});
  }
  run("double cone", double_cone, from_vertex, 3);
}

// Adds a part, scaled and moved along the x axis, to a soup. Returns its first vertex.
std::size_t add_part(Soup& soup, const Soup& part, double scale, double x)
{
  const std::size_t first = soup.points.size();
  for (const Point_3& p : part.points) soup.points.push_back({x + scale * p.x(), scale * p.y(), scale * p.z()});
  for (const auto& t : part.triangles) soup.add_triangle({first + t[0], first + t[1], first + t[2]});
  return first;
}

// Also where faces have far more pieces than those before: 10 sources in each of six faces, at once or after faces without curves
// whose bounds of levels are loose, and a fan in the shadow of its center, whose faces have no windows.
void dense_faces()
{
  Report::instance().set_context("dense faces");
  const auto add_source = [](Geodesic& g, std::size_t vertex, double start_value) {
    g.add_source_point(test::Surface_mesh::Vertex_index(unsigned(vertex)), CGAL::parameters::start_value(start_value));
  };
  const auto add_sources_in_faces = [](Geodesic& g, int first, double start_value) {
    test::Random random(1);
    for (int i = 0; i < 60; ++i)
    {
      const double u = uniform(random, 0, 1), v = uniform(random, 0, 1 - u);
      g.add_source_point(Face_location{test::Surface_mesh::Face_index(unsigned(first + i % 6)), {u, v, 1 - u - v}},
                         CGAL::parameters::start_value(start_value));
    }
  };
  std::vector<double> levels;
  add_levels(levels, 0, 0.2, 500);
  check_waiting_pieces(
    "many sources in a face", planar_grid(3, 1), [&](Geodesic& g) { add_sources_in_faces(g, 0, 0); }, levels);

  std::vector<double> small_levels;
  for (int i = 0; i < 200; ++i) small_levels.push_back(std::pow(10, -5 + 0.0275 * i));
  check_waiting_pieces(
    "crossing segments in a face", planar_grid(3, 3),
    [](Geodesic& g) {
      test::Random random(7);
      std::vector<Face_location> polyline;
      for (int i = 0; i < 30; ++i)
      {
        const double u = uniform(random, 0, 1), v = uniform(random, 0, 1 - u);
        polyline.push_back({test::Surface_mesh::Face_index(5), {u, v, 1 - u - v}});
      }
      g.add_source_polyline(polyline);
    },
    small_levels);

  Soup parts;
  add_part(parts, planar_grid(1, 1), 4, 0);
  const std::size_t empty = add_part(parts, needle_fan(10), 4.5, 30);
  const int dense = int(parts.triangles.size());
  add_part(parts, needle_fan(6), 1, 60);
  levels.clear();
  add_levels(levels, 0, 3.99, 400);
  add_levels(levels, 20, 20.1, 600);
  check_waiting_pieces(
    "many sources in a face, later", parts,
    [&](Geodesic& g) {
      add_source(g, 0, 0);
      add_source(g, empty, 4);
      add_sources_in_faces(g, dense, 20);
    },
    levels);

  Soup shadow;
  add_part(shadow, planar_grid(1, 1), 4, 0);
  const std::size_t disc = add_part(shadow, needle_fan(5000), 1, 20);
  const std::size_t center = shadow.points.size(), source = center + 1;
  const auto add_ray = [&](double angle) { shadow.points.push_back({40 + std::cos(angle), std::sin(angle), 0}); };
  shadow.points.push_back({40, 0, 0});
  for (const double angle : {1., 0.5, 0.}) add_ray(angle * CGAL_PI);
  for (int i = 1; i <= 200; ++i) add_ray(-0.9 * CGAL_PI * i / 200);
  for (std::size_t i = source; i + 1 < shadow.points.size(); ++i) shadow.add_triangle({center, i + 1, i});
  levels.clear();
  add_levels(levels, 0.5, 1, 30);
  add_levels(levels, 10.005, 10.985, 470);
  check_waiting_pieces(
    "in the shadow of a vertex", shadow,
    [&](Geodesic& g) {
      add_source(g, 0, 0);
      add_source(g, disc, 3);
      add_source(g, source, 9);
    },
    levels);
}

void run(const Query_case& c)
{
  Random random(7);
  all_ways(c.name + ", vertex", c.mesh, {point_source(*vertices(c.mesh).begin())});
  all_ways(c.name + ", point in a face", c.mesh, {point_source({random_face(c.mesh, random), random_barycentric(random)})});
  std::vector<Source> section;
  for (const auto& s : random_plane_section(c.mesh, 3)) section.push_back(polyline_source(s.locations, s.closed));
  all_ways(c.name + ", plane section", c.mesh, section);
}

// For all families above, propagation is shorter with a limit at their largest level.
void limits_save_windows()
{
  std::cout << number_of_limited_strokes << " pieces with a limit at their level; " << windows_with_limit
            << " windows for levels in the nearer half, " << windows_without_limit << " without the limit" << std::endl;
  CHECK(windows_with_limit > 0 && windows_with_limit < windows_without_limit / 2);
}

} // namespace test_offset_families

GEODESIC_OFFSET_TEST(test_offset_families)
{
  std::cout.precision(3);
  const Query_case torus_mesh("torus", torus(40, 30));
  const std::pair<const char*, std::function<void()>> tests[] = {
    {"generated meshes", [] { for_each_mesh(all_mesh_names(), {}, run); }},
    {data_case,
     [] {
       for_each_mesh({}, {"eight.off", "anchor.off", "elephant.off", "mask_cone.off", "rotor.off"}, run);
     }},
    {"one propagation from a vertex", [&] { one_propagation(torus_mesh.mesh, source_set({point_source(Vertex_index(0))})); }},
    {"one propagation from a section", [&] { one_propagation(torus_mesh.mesh, torus_mesh.section(3)); }},
    {"streaming", streaming},
    {"long faces", long_faces},
    {"close levels", close_levels},
    {"faces finalized together", faces_finalized_together},
    {"dense faces", dense_faces},
    {"limits save windows", limits_save_windows}};
  const int result = run_tests("test_offset_families", tests);
  std::cout << number_of_curves << " curves in families; lengths differ by at most " << worst_length
            << " of the length and the diagonal" << std::endl;
  return result;
}
