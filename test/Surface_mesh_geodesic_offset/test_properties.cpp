// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Properties of every field, on meshes of the catalogue with sources of all kinds:
//
// - updates: `update()` gives the field of a new build, with and without kept windows;
// - stops: fields that end at targets, at a distance limit, or by cancellation are the full field up to the covered distance;
// - minimum: the field of several sources with start values is the minimum of their fields: distances, nearest sources, paths,
//   gradients and farthest points; an update, certified bounds and free functions agree; the derivative of areas is the length of
//   offsets;
// - answers: distance, nearest source, signed distance, gradient and path of a point agree;
// - shift: a start value is added to all distances, and shifts all offsets;
// - restart: a field continues from the vertices of a region with their distances as start values;
// - ties: a source with its own distance from another source as start value, up to rounding, changes no distance;
// - samples: polylines against points on them, closer and closer.
//
// On the meshes and sources of the search for wrong offsets:
//
// - surfaces: the distance is 1-Lipschitz, and symmetric; that from several sources is the minimum of those from each. It depends on
//   the surface, not on its faces: dividing faces and edges at exact points and flipping edges in planes changes nothing; neither do
//   rigid motions, beyond the rounding of coordinates; half turns about an axis change no bit. Scaling by a power of two scales
//   distances by it, exact to the bit, and curves, which may be divided into other pieces.
//
//   test_properties [PROPERTY [N [SEED]]]     one property, N times as many seeds; for `surfaces`, N cases (280) from a seed on (1)

#include "answer_checker.h"
#include "derivative_check.h"
#include "perturbed_meshes.h"
#include "query_cases.h"

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distances.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/vector_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace test_properties {

using namespace test;
namespace parameters = CGAL::parameters;

// A mesh, and a seed of its sources.
struct Case
{
  Query_case& on;
  unsigned seed;
  bool keep; // windows
  Random random;
  const std::string context;
  const test::Surface_mesh& mesh;
  const double size; // diagonal of the mesh

  Case(Query_case& on, unsigned seed, bool keep)
    : on(on), seed(seed), keep(keep), random(seed), context("seed " + std::to_string(seed) + (keep ? ", with windows" : "")),
      mesh(on.mesh), size(bounding_box_diagonal(on.mesh))
  {
  }

  void step(const std::string& what) const { on.set_context(context + ", " + what); }
  Geodesic field(const Source_set& sources) const { return built(mesh, sources, keep); }
  double largest(const Geodesic& geodesic) const { return largest_vertex_distance(geodesic, mesh); }

  /// f(query) for all vertices, and for random points: with windows of any kind, without windows at vertices.
  template <class Function>
  void for_queries(std::size_t points, const Function& f)
  {
    for (Vertex_index v : used_vertices(mesh)) f(v);
    for (const Face_location& l : on.random_points(random, points))
      if (keep || is_at_vertex(l)) f(l);
  }

  /// Tolerance of distances: those of both builds, each relative to the distance and the diagonal, which needles need.
  void check_distance(double d, double expected) const
  {
    CHECK_DETAIL(d == expected || std::abs(d - expected) <= 1e-12 * (std::max)(expected, size), values(d, expected));
  }
};

void check_same_lengths(const Offset_curves& a, const Offset_curves& b, double scale)
{
  const double m = total_length(a), n = total_length(b);
  CHECK_DETAIL(a.size() == b.size() && std::abs(m - n) <= 1e-10 * (n + scale), values(m, n));
}

// All queries of two objects with the same sources agree up to rounding, also with the covered distance.
void check_same(Case& c, const Geodesic& a, const Geodesic& b)
{
  const double scale = c.on.checker.scale;
  Worst_error worst(1e-13, scale);
  CHECK(a.covered_distance() == b.covered_distance() && a.is_cancelled() == b.is_cancelled());
  for (Vertex_index v : vertices(c.mesh)) CHECK_CLOSE(worst, a.distance_to_sources(v), b.distance_to_sources(v));
  for (const Face_location& l : c.on.random_points(c.random, 60))
  {
    if (!c.keep && !is_at_vertex(l)) continue;
    CHECK_CLOSE(worst, a.distance_to_sources(l), b.distance_to_sources(l));
    const double m = length_of(c.on.checker.locations, c.on.checker(a, l, c.keep)),
                 n = length_of(c.on.checker.locations, c.on.checker(b, l, c.keep));
    CHECK_DETAIL(std::abs(m - n) <= 1e-12 * scale, values(m, n));
  }
  const double largest = c.largest(b);
  for (int i = 0; i < 2 && largest > 0; ++i)
  {
    const double level = uniform(c.random, 0.02, 0.98) * largest;
    check_same_lengths(offsets(a, level), offsets(b, level), scale);
  }
}

// One to three updates, each with one to three new sources; one after a removal, a cancelled build, a build that stopped at its
// target, and a build with a maximum distance, each in some cases.
void updates(Case& c)
{
  Geodesic geodesic(c.mesh);
  const auto add = [&] { geodesic.add_sources(c.on.random_sources(c.random, 1 + uniform_index(c.random, 3))); };
  const auto check = [&](const std::string& what, double limit = infinity) {
    c.step(what);
    Geodesic scratch(c.mesh);
    scratch.add_sources(geodesic.sources());
    scratch.build(parameters::keep_windows(c.keep).distance_limit(limit));
    check_same(c, geodesic, scratch);
  };
  if (c.seed % 10 != 0) add(); // sometimes initially empty
  geodesic.build(parameters::keep_windows(c.keep));
  for (std::size_t round = 0; round < 1 + c.seed % 3; ++round)
  {
    if (c.seed % 7 != 0 || round > 0) add(); // sometimes without changes
    if (c.seed % 4 == 0)                     // sometimes with a visitor
    {
      double last = 0;
      geodesic.update(parameters::visitor([&](double fraction) {
        CHECK(fraction >= last && fraction <= 1);
        last = fraction;
        return true;
      }));
      CHECK(last == 1);
    }
    if (c.seed % 4 == 1) // a cancelled update changes nothing
    {
      const double before = geodesic.distance_to_sources(*vertices(c.mesh).begin());
      geodesic.update(parameters::visitor([](double) { return false; }));
      CHECK(!geodesic.is_cancelled() && geodesic.distance_to_sources(*vertices(c.mesh).begin()) == before);
    }
    if (c.seed % 4 != 0) geodesic.update();
    check("update " + std::to_string(round + 1));
  }
  const auto update = [&](const std::string& what, double limit = infinity) {
    add();
    geodesic.update();
    check(what, limit);
  };
  if (c.seed % 3 == 0 && geodesic.number_of_sources() > 1)
  {
    geodesic.remove_source(std::next(geodesic.sources().sources().begin(),
                                     std::ptrdiff_t(uniform_index(c.random, geodesic.number_of_sources())))
                             ->first);
    update("after a removal");
  }
  if (c.seed % 3 == 1)
  {
    geodesic.build(parameters::keep_windows(c.keep).visitor([](double f) { return f < 0.3; }));
    update("of a cancelled build");
  }
  if (c.seed % 5 == 0)
  {
    geodesic.build(parameters::targets(std::vector<Vertex_index>{used_vertices(c.mesh).front()}).keep_windows(c.keep));
    update("of a build with a target");
  }
  if (c.seed % 3 == 2) // the same parameters again
  {
    const double cut = uniform(c.random, 0.1, 0.6) * c.largest(geodesic);
    geodesic.build(parameters::distance_limit(cut).keep_windows(c.keep));
    update("of a cut-off", cut);
  }
}

// The known part of a stopped field: the full field up to the covered distance, and nothing beyond it.
void check_covered(Case& c, const Geodesic& part, const Geodesic& full)
{
  const double covered = part.covered_distance(), scale = c.on.checker.scale, rounding = 1e-13 * scale;
  CHECK_DETAIL(covered > 0, std::to_string(covered));
  Worst_error worst(1e-13, scale);
  std::size_t i = 0;
  c.for_queries(90, [&](const auto& query) {
    const double d = part.distance_to_sources(query), all = full.distance_to_sources(query);
    if (d <= covered) CHECK_CLOSE(worst, d, all);
    else CHECK_DETAIL(std::isinf(d) && all >= covered - rounding, values(d, all));
    if (all <= covered - rounding) CHECK(std::isfinite(d));
    constexpr bool is_vertex = std::is_same<std::decay_t<decltype(query)>, Vertex_index>::value;
    if (!is_vertex || ++i % 20 == 0) c.on.checker(part, query, c.keep && !is_vertex);
  });
  if (std::isfinite(covered) && covered > 1e-6 * scale)
    check_same_lengths(offsets(part, 0.7 * covered), offsets(full, 0.7 * covered), scale);
}

std::size_t cancelled_builds = 0;

void stops(Case& c)
{
  c.step("the full field");
  const Source_set sources = c.on.random_sources(c.random, 1 + c.seed % 2);
  Geodesic full(c.mesh), part(c.mesh);
  full.add_sources(sources);
  part.add_sources(sources);
  std::vector<double> fractions;
  full.build(parameters::keep_windows(true).visitor([&](double f) {
    fractions.push_back(f);
    return true;
  }));
  CHECK(!full.is_cancelled() && full.covered_distance() == infinity);
  CHECK(!fractions.empty() && fractions.front() >= 0 && fractions.back() == 1);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  const double largest = c.largest(full);
  // lower envelopes, which kept windows need, have slightly fewer windows
  const std::size_t all = (c.keep ? full : c.field(sources)).statistics().windows_propagated;

  // targets: the nearest and the farthest of some vertices
  std::vector<Vertex_index> some = used_vertices(c.mesh);
  for (Vertex_index& v : some) std::swap(v, some[uniform_index(c.random, some.size())]);
  some.resize((std::min)(some.size(), std::size_t(50)));
  std::sort(some.begin(), some.end(),
            [&](Vertex_index v, Vertex_index w) { return full.distance_to_sources(v) < full.distance_to_sources(w); });
  Worst_error worst(1e-13, c.on.checker.scale);
  for (const Vertex_index target : {some.front(), some.back()})
  {
    c.step(target == some.front() ? "a near target" : "a far target");
    part.build(parameters::targets(std::vector<Vertex_index>{target}).keep_windows(c.keep));
    const double d = part.distance_to_sources(target);
    CHECK_DETAIL(!part.is_cancelled() && d <= part.covered_distance(), values(d, part.covered_distance()));
    CHECK_CLOSE(worst, d, full.distance_to_sources(target));
    c.on.checker(part, target, c.keep);
    check_covered(c, part, full);
    const std::size_t windows = part.statistics().windows_propagated;
    CHECK_DETAIL(target == some.front() && d < 0.3 * largest ? windows < all : windows <= all,
                 values(double(windows), double(all)));
  }
  if (c.keep)
  {
    c.step("targets of all kinds");
    const Path_locations targets = c.on.random_points(c.random, 3);
    part.build(parameters::keep_windows(true).targets(targets));
    for (const Face_location& t : targets)
    {
      CHECK_CLOSE(worst, part.distance_to_sources(t), full.distance_to_sources(t));
      c.on.checker(part, t);
    }
    check_covered(c, part, full);
  }
  c.step("a cut-off");
  const double maximum = uniform(c.random, 0.05, 0.9) * largest;
  part.build(parameters::keep_windows(c.keep).distance_limit(maximum));
  CHECK(part.covered_distance() == maximum && !part.is_cancelled());
  check_covered(c, part, full);
  c.step("a cancel");
  const double until = uniform(c.random, 0.05, 0.9);
  bool refused = false;
  double last = 0;
  part.build(parameters::keep_windows(c.keep).visitor([&](double f) {
    CHECK(f >= last && f <= 1 && !refused);
    last = f;
    refused = f >= until;
    return !refused;
  }));
  CHECK(part.is_built() && (refused || !part.is_cancelled()));
  if (refused && last < 1) CHECK(part.is_cancelled());
  if (part.is_cancelled()) CHECK(std::isfinite(part.covered_distance()));
  cancelled_builds += part.is_cancelled() ? 1 : 0;
  check_covered(c, part, full);
}

void minimum(Case& c)
{
  const Source_set sources = c.on.random_sources(c.random, 2 + c.seed % 4, 0.5 * c.size);
  Geodesic geodesic(c.mesh);
  geodesic.add_sources(sources);
  geodesic.build(parameters::keep_windows(true).compute_largest_distance(true));
  std::vector<Geodesic> single;
  std::vector<double> start;
  Geodesic updated(c.mesh); // with the later half of the sources
  for (const auto& [id, source] : sources.sources())
  {
    if (id == (sources.size() + 1) / 2) updated.build(parameters::keep_windows(true));
    Source_set one;
    one.add(source);
    updated.add_sources(one);
    start.push_back(source.start_value);
    one.clear();
    auto alone = source;
    alone.start_value = 0;
    one.add(alone);
    single.push_back(built(c.mesh, one));
  }
  updated.update();
  typedef CGAL::Surface_mesh_geodesic_enclosure<Geodesic::Traits> Enclosure;
  Enclosure enclosure(c.mesh);
  enclosure.add_sources(sources);
  enclosure.build(parameters::keep_windows(true));
  const auto expected = [&](const auto& query) {
    double least = infinity;
    for (std::size_t i = 0; i < single.size(); ++i) least = (std::min)(least, start[i] + single[i].distance_to_sources(query));
    return least;
  };
  std::vector<double> of_function(c.mesh.number_of_vertices());
  std::vector<std::size_t> labels(c.mesh.number_of_vertices());
  CGAL::geodesic_distances(c.mesh, sources, CGAL::make_property_map(of_function));
  geodesic.source_labels(CGAL::make_property_map(labels));
  c.for_queries(60, [&](const auto& query) {
    const double least = expected(query), d = geodesic.distance_to_sources(query);
    c.check_distance(d, least);
    c.check_distance(updated.distance_to_sources(query), d);
    const auto bounds = enclosure.distance_bounds(query);
    c.check_distance((std::min)((std::max)(bounds.first, least), bounds.second), least);
    const auto found = geodesic.nearest_source(query);
    if (!CHECK(found && found->distance == d)) return;
    c.check_distance(start[found->source] + single[found->source].distance_to_sources(query), least);
    c.check_distance(start[found->source] + single[found->source].distance_to_sources(found->location), start[found->source]);
    c.on.checker(geodesic, query); // the path, and the gradient
    if constexpr (std::is_same<std::decay_t<decltype(query)>, Vertex_index>::value)
    {
      c.check_distance(of_function[query], d);
      CHECK(labels[query] == found->source);
    }
  });
  const auto farthest = geodesic.farthest_point().value();
  c.check_distance(farthest.second, expected(farthest.first));

  Offset_integrals integrals(geodesic, c.mesh);
  const double least = *std::min_element(start.begin(), start.end());
  if (least > 0) CHECK(offsets(geodesic, least).empty() && offsets(geodesic, least / 2).empty());
  Derivative_check derivatives;
  for (int i = 0; i < 4; ++i)
    derivatives(integrals, least + uniform(c.random, 0.02, 0.98) * (integrals.largest_distance() - least));
  const double d = uniform(c.random, 0.1, 0.9) * geodesic.largest_distance().value();
  const auto certificate = enclosure.certify_offset(d, offsets(geodesic, d));
  CHECK(certificate.bounds_region);
  CHECK_DETAIL(certificate.tolerance <= 1e-9 * (std::max)(d, c.size), std::to_string(certificate.tolerance));
}

// See answer_checker.h: distance, nearest source, signed distance, gradient and path of a point agree.
void answers(Case& c)
{
  Answer_checker checker(c.mesh, false);
  const Geodesic geodesic = c.field(c.seed % 2 == 1 ? c.on.section(c.seed) : c.on.random_sources(c.random, 1 + c.seed % 3));
  std::vector<std::size_t> labels(c.mesh.number_of_vertices());
  geodesic.source_labels(CGAL::make_property_map(labels));
  c.for_queries(120, [&](const auto& query) {
    if constexpr (std::is_same<std::decay_t<decltype(query)>, Vertex_index>::value)
      CHECK_DETAIL(checker.check_vertex(geodesic, query, labels[query]) == 0, checker.detail());
    else CHECK_DETAIL(checker.check(geodesic, query) == 0, checker.detail());
  });
}

void shift(Case& c)
{
  const double shift = 0.75;
  auto source = c.on.random_sources(c.random, 1).sources().begin()->second;
  Source_set sources, delayed_sources;
  sources.add(source);
  source.start_value = shift;
  delayed_sources.add(source);
  const Geodesic plain = built(c.mesh, sources), delayed = built(c.mesh, delayed_sources);
  const double largest = plain.largest_distance().value();
  c.check_distance(delayed.largest_distance().value(), shift + largest);
  for (const double part : {0.11, 0.37, 0.63, 0.88})
  {
    // levels are cut below themselves
    const double a = total_length(offsets(plain, part * largest)),
                 b = total_length(offsets(delayed, shift + part * largest + 0x1p-42 * shift));
    CHECK_DETAIL(std::abs(a - b) <= 1e-9 * (a + c.size), values(a, b));
  }
  for (const Vertex_index v : used_vertices(c.mesh))
  {
    const double a = or_nan(plain.signed_distance_to_sources(v)), b = or_nan(delayed.signed_distance_to_sources(v));
    if (std::isnan(a)) CHECK(std::isnan(b));
    else if (a == 0) CHECK_DETAIL(b == shift, values(b, shift));
    else c.check_distance(std::copysign(1, a) * b, shift + std::abs(a));
  }
}

void restart(Case& c)
{
  const Geodesic first = built(c.mesh, {point_source(used_vertices(c.mesh).front())}, false);
  Geodesic second(c.mesh);
  const double limit = 0.4 * c.largest(first);
  for (const auto v : used_vertices(c.mesh))
    if (const double d = first.distance_to_sources(v); d <= limit) second.add_source_point(v, parameters::start_value(d));
  second.build(parameters::keep_windows(true));
  // no path is shorter, and the vertices of the region keep their distances
  for (const auto v : used_vertices(c.mesh))
  {
    const double a = second.distance_to_sources(v), b = first.distance_to_sources(v);
    c.check_distance(b <= limit ? a : (std::min)(a, b), b);
  }
  Offset_integrals integrals(second, c.mesh);
  Derivative_check derivatives;
  for (const double part : {0.3, 0.5, 0.7}) derivatives(integrals, part * integrals.largest_distance());
}

void ties(Case& c)
{
  const Face_location source = random_location(c.on.checker.locations, c.mesh, c.random, 0);
  Geodesic alone(c.mesh);
  alone.add_source_point(source);
  alone.build(parameters::keep_windows(true));
  auto h = halfedge(source.first, c.mesh);
  for (int corner = 0; corner < 4; ++corner) // those of its face, and of the next one
  {
    const auto v = target(h, c.mesh);
    h = next(corner == 2 && !is_border(opposite(h, c.mesh), c.mesh) ? opposite(h, c.mesh) : h, c.mesh);
    for (const int units : {-40, -3, -1, 0, 1, 3, 40})
    {
      c.step("corner " + std::to_string(corner) + ", units " + std::to_string(units));
      Geodesic both(c.mesh);
      both.add_source_point(source);
      const double start = (1 + units * std::numeric_limits<double>::epsilon()) * alone.distance_to_sources(v);
      both.add_source_point(v, parameters::start_value(start));
      both.build(parameters::keep_windows(true));
      c.for_queries(10, [&](const auto& q) { c.check_distance(both.distance_to_sources(q), alone.distance_to_sources(q)); });
    }
  }
}

void samples(Case& c)
{
  const auto sections = random_plane_section(c.mesh, c.seed);
  const Mesh_locations& locations = c.on.checker.locations;
  const Geodesic geodesic = built(c.mesh, c.on.section(c.seed));
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * c.size;
  const Path_locations points = c.on.random_points(c.random, 60);
  std::vector<double> gaps;
  for (const int number : {1, 4, 16, 64})
  {
    Geodesic sampled(c.mesh);
    double longest_step = 0, gap = 0;
    for (const auto& section : sections)
      for (std::size_t i = 0; i < section.number_of_segments(); ++i)
      {
        const double length =
          distance(locations.point(section.between(locations, i, 0)), locations.point(section.between(locations, i, 1)));
        longest_step = (std::max)(longest_step, length / number);
        for (int k = 0; k <= number; ++k) sampled.add_source_point(section.between(locations, i, double(k) / number));
      }
    CHECK(sampled.number_of_sources() > 0);
    sampled.build(parameters::keep_windows(number == 16));
    const auto check = [&](const auto& query) {
      const double exact = geodesic.distance_to_sources(query), approximate = sampled.distance_to_sources(query);
      if (!CHECK(std::isinf(exact) == std::isinf(approximate) && !std::isnan(exact)) || std::isinf(exact)) return;
      CHECK_DETAIL(exact <= approximate * (1 + 1e-12) + rounding, values(exact, approximate));
      // The sample nearest to the foot of a shortest path is at most half a step away.
      CHECK_DETAIL(approximate <= exact + longest_step / 2 * (1 + 1e-12) + rounding, values(exact, approximate));
      gap = (std::max)(gap, approximate - exact);
    };
    for (Vertex_index v : vertices(c.mesh)) check(v);
    for (const Face_location& l : number == 16 ? points : Path_locations()) check(l);
    gaps.push_back(gap);
  }
  // The gap is between linear (vertices near the section) and quadratic (distant vertices) in the step: 64 times the samples reduce it
  // by a factor of at least eight.
  CHECK_DETAIL(gaps.back() <= gaps.front() / 8 + rounding, values(gaps.back(), gaps.front()));
}

// Relative to the distance plus the diagonal of the mesh: some thousand units in the last place.
constexpr double tolerance = 0x1p-40;

struct Totals
{
  std::size_t cases = 0, distances = 0, flips = 0, middles = 0, curves = 0;
  double lipschitz = 0, symmetry = 0, faces = 0, motion = 0, minimum = 0; // largest differences, relative as above
};

class Surface_properties
{
public:
  Surface_properties(unsigned seed, Totals& totals)
    : kind_(Search_meshes::kinds()[seed % Search_meshes::kinds().size()].first), random_(seed), soup_(drawn_soup(seed)),
      data_(soup_), diagonal_(bounding_box_diagonal(data_.mesh)), totals_(totals)
  {
    const Open_geodesic geodesic(data_.mesh);
    for (Search_sources& s : sources_) s = Source_drawing(data_.mesh, geodesic, random_)();
    Report::instance().set_context("seed " + std::to_string(seed) + ", " + kind_ + " of " +
                                   std::to_string(data_.mesh.number_of_faces()) + " faces, " + sources_[0].kind);
  }

  void check()
  {
    ++totals_.cases;
    const Geodesic built = build(data_.mesh, sources_[0]);
    const std::vector<double> distances = of_vertices(built, data_.mesh);
    lipschitz(built);
    symmetric();
    minimum(distances);
    other_faces();
    scaled(built, distances);
    moved(distances);
  }

private:
  // Coordinates with 24 digits, so that midpoints of edges are exact.
  Soup drawn_soup(unsigned seed)
  {
    Soup soup = Search_meshes::kinds()[seed % Search_meshes::kinds().size()].second(random_);
    Soup rounded = soup;
    round_to_float(rounded);
    const Generated_mesh<Surface_mesh> data(rounded);
    for (const auto f : data.mesh.faces())
      if (CGAL::Polygon_mesh_processing::is_degenerate_triangle_face(f, data.mesh)) return soup;
    has_exact_middles_ = true;
    return rounded;
  }

  static Geodesic build(const Surface_mesh& mesh, const Search_sources& sources)
  {
    Geodesic geodesic(mesh);
    sources.add_to(geodesic);
    geodesic.build(CGAL::parameters::keep_windows(true));
    return geodesic;
  }
  static std::vector<double> of_vertices(const Geodesic& geodesic, const Surface_mesh& mesh)
  {
    std::vector<double> result;
    for (const auto v : mesh.vertices()) result.push_back(geodesic.distance_to_sources(v));
    return result;
  }

  // Updates `worst` with the difference.
  bool same(double actual, double expected, double& worst)
  {
    ++totals_.distances;
    if (std::isinf(expected)) return actual == expected;
    const double difference = std::abs(actual - expected) / (expected + diagonal_);
    worst = (std::max)(worst, difference);
    return difference <= tolerance;
  }

  Surface_mesh::Face_index face()
  {
    return Surface_mesh::Face_index(Surface_mesh::size_type(uniform_index(random_, data_.mesh.number_of_faces())));
  }

  void lipschitz(const Geodesic& geodesic)
  {
    const Locations<Surface_mesh> locations(data_.mesh);
    for (int i = 0; i < 40; ++i)
    {
      // two points of a face, or of the edge that contains the first one
      Face_location p(face(), random_barycentric(random_)), q(p.first, random_barycentric(random_));
      if (i % 2 == 0) p.second[0] = q.second[0] = 0;
      for (Face_location* l : {&p, &q})
      {
        const double sum = l->second[0] + l->second[1] + l->second[2];
        for (double& w : l->second) w /= sum;
      }
      const double d = geodesic.distance_to_sources(p), e = geodesic.distance_to_sources(q);
      const double way = std::sqrt(CGAL::squared_distance(locations.point(p), locations.point(q)));
      ++totals_.distances;
      if (!CHECK(std::isfinite(d) == std::isfinite(e)) || !std::isfinite(d)) continue;
      const double excess = (std::abs(d - e) - way) / ((std::max)(d, e) + diagonal_);
      totals_.lipschitz = (std::max)(totals_.lipschitz, excess);
      CHECK_DETAIL(excess <= tolerance, values(std::abs(d - e), way));
    }
  }

  void symmetric()
  {
    const Face_location p(face(), random_barycentric(random_)), q(face(), random_barycentric(random_));
    double there = 0, back = 0;
    for (const bool is_there : {true, false})
    {
      Geodesic geodesic = built(data_.mesh, {point_source(is_there ? p : q)});
      (is_there ? there : back) = geodesic.distance_to_sources(is_there ? q : p);
    }
    CHECK_DETAIL(same(there, back, totals_.symmetry), values(there, back));
  }

  void minimum(const std::vector<double>& from_first)
  {
    const std::vector<double> from_second = of_vertices(build(data_.mesh, sources_[1]), data_.mesh);
    Geodesic geodesic(data_.mesh);
    for (const Search_sources& s : sources_) s.add_to(geodesic);
    geodesic.build();
    const std::vector<double> from_both = of_vertices(geodesic, data_.mesh);
    for (std::size_t v = 0; v < from_both.size(); ++v)
    {
      const double expected = (std::min)(from_first[v], from_second[v]);
      CHECK_DETAIL(same(from_both[v], expected, totals_.minimum), values(from_both[v], expected));
    }
  }

  // Sources are vertices or the border, which other faces do not change. Compares distances of vertices, and of middles of
  // edges with those of the vertices that divide the edges.
  void other_faces()
  {
    if (!has_exact_middles_) return;
    const bool from_border = uniform(random_) < 0.2 && has_border(data_.mesh);
    std::vector<Surface_mesh::Vertex_index> vertices;
    for (int i = 0; i < 2; ++i) vertices.push_back(data_.mesh.source(data_.mesh.halfedge(face())));
    const auto built = [&](const Surface_mesh& mesh) {
      Geodesic geodesic(mesh);
      if (from_border)
      {
        std::vector<Surface_mesh::Edge_index> border;
        for (const auto e : mesh.edges())
          if (mesh.is_border(e)) border.push_back(e);
        geodesic.add_source_edges(border);
      }
      else
        for (const auto v : vertices) geodesic.add_source_point(v);
      geodesic.build(CGAL::parameters::keep_windows(true));
      return geodesic;
    };
    const Geodesic geodesic = built(data_.mesh);
    std::vector<double> expected = of_vertices(geodesic, data_.mesh);
    const std::size_t vertices_before = expected.size();
    const Locations<Surface_mesh> locations(data_.mesh);
    for (const double part : {0., 0.3}) // only flips; flips and divided edges
    {
      Surface_mesh mesh = data_.mesh;
      std::vector<Surface_mesh::Edge_index> divided;
      totals_.flips += retriangulate(mesh, random_, part, true, &divided);
      expected.resize(vertices_before);
      for (const auto e : divided)
      {
        const auto h = data_.mesh.halfedge(e), side = data_.mesh.is_border(h) ? data_.mesh.opposite(h) : h;
        expected.push_back(geodesic.distance_to_sources(locations.on_edge(side, 0.5)));
      }
      totals_.middles += divided.size();
      const std::vector<double> actual = of_vertices(built(mesh), mesh);
      if (!CHECK(actual.size() == expected.size())) continue;
      for (std::size_t v = 0; v < expected.size(); ++v)
        CHECK_DETAIL(same(actual[v], expected[v], totals_.faces), values(actual[v], expected[v]));
    }
  }

  static bool has_border(const Surface_mesh& mesh)
  {
    for (const auto e : mesh.edges())
      if (mesh.is_border(e)) return true;
    return false;
  }

  void scaled(const Geodesic& geodesic, const std::vector<double>& distances)
  {
    double largest = 0;
    for (const double d : distances)
      if (std::isfinite(d)) largest = (std::max)(largest, d);
    const double level = uniform(random_, 0.05, 0.95) * largest;
    const Offset_curves curves = level > 0 ? offsets(geodesic, level) : Offset_curves();
    for (const int exponent : {-100, -32, 2, 40, 100})
    {
      const double factor = std::ldexp(1, exponent);
      Soup soup = soup_;
      for (Point_3& p : soup.points) p = Point_3(factor * p.x(), factor * p.y(), factor * p.z());
      const Generated_mesh<Surface_mesh> data(soup);
      const Geodesic other = build(data.mesh, sources_[0]);
      const std::vector<double> actual = of_vertices(other, data.mesh);
      for (std::size_t v = 0; v < actual.size(); ++v)
        CHECK_DETAIL(actual[v] == factor * distances[v], values(actual[v], factor * distances[v]));
      for (const auto v : data.mesh.vertices())
      {
        const Vector_3 gradient = geodesic.gradient(v).value_or(CGAL::NULL_VECTOR);
        CHECK((other.gradient(v).value_or(CGAL::NULL_VECTOR) - gradient).squared_length() < 1e-24);
      }
      if (!(level > 0)) continue;
      const Offset_curves other_curves = offsets(other, factor * level);
      totals_.curves += curves.size();
      CHECK_DETAIL(other_curves.size() == curves.size(), values(double(other_curves.size()), double(curves.size())));
      const double length = total_length(curves), other_length = total_length(other_curves) / factor;
      CHECK_DETAIL(std::abs(other_length - length) <= Search_tolerances::length * (length + diagonal_),
                   values(other_length, length));
    }
  }

  void moved(const std::vector<double>& distances)
  {
    Soup turned = soup_; // a half turn about an axis
    for (Point_3& p : turned.points) p = Point_3(-p.x(), p.y(), -p.z());
    const Generated_mesh<Surface_mesh> half_turn(turned);
    CHECK(of_vertices(build(half_turn.mesh, sources_[0]), half_turn.mesh) == distances);

    // Rounding displaces points by more than the height of a needle.
    if (kind_ == "needles" || kind_ == "strip" || kind_ == "tiny faces") return;
    const Generated_mesh<Surface_mesh> anywhere(rotated(soup_, unsigned(random_())));
    const std::vector<double> actual = of_vertices(build(anywhere.mesh, sources_[0]), anywhere.mesh);
    for (std::size_t v = 0; v < actual.size(); ++v)
      CHECK_DETAIL(same(actual[v], distances[v], totals_.motion), values(actual[v], distances[v]));
  }

  const std::string kind_;
  Random random_;
  bool has_exact_middles_ = false;
  const Soup soup_;
  const Generated_mesh<Surface_mesh> data_;
  const double diagonal_;
  Search_sources sources_[2];
  Totals& totals_;
};

// A saddle vertex on the opposite side of its face, as far as doubles can resolve: its rays through this side have no
// window, and points in the next face are reached around the ends of the two windows that meet at the vertex.
void flat_cap()
{
  Report::instance().set_context("a flat cap");
  const double c = std::cos(75 * CGAL_PI / 180), y = (c + c / 2) / std::sqrt(0.75);
  Soup soup;
  for (const Point_3& p : {Point_3(0, 0, 0), Point_3(-1, -1e-17, 0), Point_3(1, -1e-17, 0), Point_3(0, -1, 0),
                           Point_3(-0.5, std::sqrt(0.75), 0), Point_3(c, y, std::sqrt(1 - c * c - y * y))})
    soup.points.push_back(p);
  for (const auto& t : std::vector<std::array<std::size_t, 3>>{{1, 2, 0}, {1, 3, 2}, {0, 4, 1}, {0, 5, 4}, {0, 2, 5}})
    soup.add_triangle(t);
  const Generated_mesh<Surface_mesh> data(soup);
  const Geodesic geodesic = built(data.mesh, {point_source(data.vertices[4])});
  // the shadow is between the directions of 300 and 330 degrees
  for (const double degrees : {295., 299., 301., 310., 315., 320., 329., 331., 340.})
  {
    const double x = 0.3 * std::cos(degrees * CGAL_PI / 180), y = 0.3 * std::sin(degrees * CGAL_PI / 180);
    Face_location p(data.faces[1], {{0, 0, 0}});
    const auto corners = Locations<Surface_mesh>(data.mesh).corners(p.first);
    for (std::size_t k = 0; k < 3; ++k) // of the points (-1, 0), (0, -1), (1, 0)
      p.second[k] = corners[k] == data.vertices[3] ? -y : (1 + y + (corners[k] == data.vertices[2] ? x : -x)) / 2;
    const double angle = degrees < 300 ? degrees - 120 : degrees > 330 ? 510 - degrees : 180; // seen from the vertex
    const double expected = std::sqrt(1 + 0.09 - 0.6 * std::cos(angle * CGAL_PI / 180));
    const double d = geodesic.distance_to_sources(p);
    CHECK_DETAIL(std::abs(d - expected) < 1e-14, std::to_string(degrees) + " degrees: " + values(d, expected));
  }
}

struct Property
{
  std::string name;
  void (*check)(Case&);
  Names generated, data;
  unsigned seeds, seeds_on_request; // for each mesh, unless all cases are requested
  bool has_windows_only;
};

void surfaces(unsigned cases, unsigned first)
{
  flat_cap();
  Totals totals;
  for (unsigned seed = first; seed < first + cases; ++seed) guarded([&] { Surface_properties(seed, totals).check(); });
  std::cout.precision(2);
  std::cout << totals.cases << " cases, " << totals.distances << " distances, " << totals.flips << " flips, " << totals.middles
            << " divided edges, " << totals.curves
            << " curves; largest differences, in distances plus diagonals: steeper than 1-Lipschitz " << totals.lipschitz
            << ", asymmetric " << totals.symmetry << ", other faces " << totals.faces << ", rigid motion " << totals.motion
            << ", minimum of sources " << totals.minimum << std::endl;
  CHECK(cases < 100 || (totals.flips > 1000 && totals.middles > 1000 && totals.curves > 100));
}

} // namespace test_properties

GEODESIC_OFFSET_TEST(test_properties)
{
  const Names eight = {"rectangle", "grid", "box", "saddle", "icosphere", "genus 5", "torus", "L"};
  const Names few = {"torus", "icosphere", "cube", "needles", "tiny faces", "saddle", "jittered grid"};
  const Names small = small_data_meshes();
  const Names data = {"eight.off", "anchor.off",    "elephant.off", "sphere966.off", "cube-meshed.off",     "head.off",
                      "rotor.off", "mask_cone.off", "patch-01.off", "blobby.off",    "mesh_with_border.off"};
  const std::vector<Property> properties = {
    {"updates", updates, eight, small, 10, 10, false},
    {"stops", stops, eight, small, 6, 6, false},
    {"minimum", minimum, all_mesh_names(), {}, 2, 40, true},
    {"answers", answers, all_mesh_names(), {"anchor.off", "elephant.off", "mesh_with_border.off"}, 2, 20, true},
    {"shift", shift, few, {}, 4, 4, true},
    {"restart", restart, few, {}, 1, 1, true},
    {"ties", ties, few, {}, 3, 60, true},
    {"samples", samples, all_mesh_names(), data, 2, 2, true}};
  const std::string wanted = argc > 1 ? argv[1] : "";
  const unsigned times = argc > 2 ? unsigned(std::stoul(argv[2])) : 1;
  for (const Property& p : properties)
  {
    if (!wanted.empty() && p.name != wanted) continue;
    for_each_mesh(p.generated, p.data, [&](Query_case& on) {
      for (unsigned seed = 1; seed <= times * number_of_cases(p.seeds, p.seeds_on_request); ++seed)
        for (const bool keep : {true, false})
          if (keep || !p.has_windows_only)
          {
            Case c(on, seed, keep);
            c.step(p.name);
            guarded([&] { p.check(c); });
          }
    });
    std::cout << p.name << ": " << Report::instance().checks() << " checks so far" << std::endl;
  }
  if (wanted.empty() || wanted == "stops") CHECK(cancelled_builds > 0);
  if (mesh_kinds().generated && (wanted.empty() || wanted == "surfaces"))
    surfaces(argc > 2 ? times : 280, argc > 3 ? unsigned(std::stoul(argv[3])) : 1);
  return Report::instance().finish("test_properties");
}
