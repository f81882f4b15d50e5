// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds with Parallel_tag: distances, nearest sources, paths and offsets are those of Sequential_tag up to rounding, and
// bitwise equal for any number of threads and in every run; set-up and cutting of given windows do not depend on the tag at
// all. Built with and without ThreadSanitizer.
//
//   test_parallel [--small]      --small: without the larger meshes

// many parts of small meshes
#define CGAL_GEODESIC_OFFSET_BITS_OF_A_PART 5

#include "query_cases.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cfenv>
#include <functional>
#include <map>
#include <stdexcept>
#include <thread>
#include <type_traits>

namespace test_parallel {

using namespace test;

typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh> Traits;

static_assert(std::is_same<CGAL::Geodesic_offset::internal::Concurrency<CGAL::Parallel_tag, CGAL::Interval_nt<>>::Tag,
                           CGAL::Sequential_tag>::value,
              "numbers that are not floating point numbers are computed with by one thread");

// Documented bound of relative differences of distances between the two tags.
constexpr double bound = 1e-13;

template <class Tag>
Geodesic built_with(const test::Surface_mesh& mesh, const Source_set& sources, const Tag& tag)
{
  Geodesic result(mesh);
  result.add_sources(sources);
  result.build(CGAL::parameters::concurrency_tag(tag));
  return result;
}

std::vector<double> distances(const Geodesic& geodesic, const test::Surface_mesh& mesh)
{
  std::vector<double> result;
  for (Vertex_index v : vertices(mesh)) result.push_back(geodesic.distance_to_sources(v));
  return result;
}

template <class Function>
void with_threads(int n, const Function& f)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, std::size_t(n));
  tbb::task_arena arena(n);
  arena.execute(f);
}

// Results of all kinds of builds on one mesh, always in the same order.
struct Outcome
{
  std::vector<double> distances; // of vertices and points
  std::vector<double> lengths;   // of the curves of a level, with the numbers of curves and closed curves
  std::vector<double> rest;      // dependent on the order of the front: counts, and the stopping distance
};

template <class Tag>
class Builds
{
public:
  Builds(Query_case& c, unsigned seed, bool checks_paths, Outcome& outcome)
    : m_case(c), m_random(seed), m_checks_paths(checks_paths), m_out(outcome),
      m_geodesic(c.mesh, CGAL::parameters::concurrency_tag(Tag()))
  {
  }

  void run(std::size_t points)
  {
    m_points = m_case.random_points(m_random, points);
    add(1);
    m_geodesic.build(CGAL::parameters::compute_largest_distance(true).concurrency_tag(Tag()));
    m_out.distances.push_back(m_geodesic.largest_distance().value());
    take_down(false);
    compare_with_envelopes();
    add(2); // including polylines
    m_geodesic.build(CGAL::parameters::keep_windows(true).concurrency_tag(Tag()));
    take_down(true);
    m_out.distances.push_back(m_geodesic.largest_distance().value());
    const double largest = largest_vertex_distance(m_geodesic, m_case.mesh);
    const std::vector<double> levels = {0.07 * largest, 0.31 * largest, 0.66 * largest};
    take_curves([&](auto out) { m_geodesic.offset_curves(levels, out, CGAL::parameters::concurrency_tag(Tag())); });
    add(3);
    m_geodesic.update(CGAL::parameters::concurrency_tag(Tag()));
    take_down(true);
    add(1);
    m_geodesic.build(CGAL::parameters::distance_limit(0.37 * largest).compute_largest_distance(true).concurrency_tag(Tag()));
    m_out.distances.push_back(m_geodesic.largest_distance().value());
    take_down(false);
    m_geodesic.update(CGAL::parameters::concurrency_tag(Tag()));
    m_out.distances.push_back(m_geodesic.largest_distance().value());
    take_down(false);
    take_curves([&](auto out) { m_geodesic.offset_curves(0.2 * largest, out, CGAL::parameters::concurrency_tag(Tag())); });
    const auto largest_too = CGAL::parameters::compute_largest_distance(true);
    take_curves([&](auto out) { m_geodesic.build_with_offset_curves(levels, out, largest_too.concurrency_tag(Tag())); });
    m_out.distances.push_back(m_geodesic.largest_distance().value());
    take_down(false);
    const auto equal = CGAL::Offset_levels<double>::equally_spaced(0.05 * largest, 12);
    take_curves([&](auto out) {
      m_geodesic.build_with_offset_curves_by_distance(
        equal,
        [&](double d, Offset_curves&& curves) {
          m_out.distances.push_back(d);
          std::move(curves.begin(), curves.end(), out);
        },
        CGAL::parameters::keep_windows(true).concurrency_tag(Tag()));
    });
    take_down(true);
    targets_and_visitors();
  }

private:
  void add(std::size_t n) { m_geodesic.add_sources(m_case.random_sources(m_random, n)); }

  // Monotone lists are propagated unchanged if only distances at vertices are requested.
  void compare_with_envelopes()
  {
    Geodesic whole(m_geodesic);
    whole.build(CGAL::parameters::keep_windows(true).concurrency_tag(Tag()));
    Worst_error worst(bound, m_case.checker.scale);
    for (Vertex_index v : vertices(m_case.mesh))
      CHECK_CLOSE(worst, m_geodesic.distance_to_sources(v), whole.distance_to_sources(v));
  }

  // Results of stopped builds depend on the order of the front.
  void targets_and_visitors()
  {
    const std::vector<Vertex_index> targets = {used_vertices(m_case.mesh).front()};
    m_geodesic.build(CGAL::parameters::targets(targets).concurrency_tag(Tag()));
    m_out.distances.push_back(m_geodesic.distance_to_sources(targets.front()));
    m_out.rest.push_back(m_geodesic.covered_distance());
    m_geodesic.build(CGAL::parameters::keep_windows(true).visitor([](double f) { return f < 0.3; }).concurrency_tag(Tag()));
    m_out.rest.push_back(m_geodesic.covered_distance());
    for (Vertex_index v : vertices(m_case.mesh)) m_out.rest.push_back(m_geodesic.distance_to_sources(v));
    m_geodesic.update(CGAL::parameters::concurrency_tag(Tag()));
    take_down(true);
    const std::size_t windows = m_geodesic.statistics().windows_propagated;
    const auto gives_up = [](double f) -> bool {
      if (f > 0.2) throw std::runtime_error("the visitor gives up");
      return true;
    };
    CHECK_THROWS(m_geodesic.build(CGAL::parameters::keep_windows(true).visitor(gives_up).concurrency_tag(Tag())),
                 std::runtime_error);
    CHECK(m_geodesic.statistics().windows_propagated == windows);
  }

  void take_down(bool has_windows)
  {
    const Geodesic& g = m_geodesic;
    for (Vertex_index v : vertices(m_case.mesh)) m_out.distances.push_back(g.distance_to_sources(v));
    m_out.distances.push_back(g.covered_distance());
    for (const Face_location& l : m_points)
      if (has_windows || is_at_vertex(l))
      {
        m_out.distances.push_back(g.distance_to_sources(l));
        if (m_checks_paths) m_case.checker(g, l, has_windows); // and the nearest source
      }
    const auto& s = g.statistics();
    for (const std::size_t n : {s.windows_created, s.windows_propagated, s.windows_peak}) m_out.rest.push_back(double(n));
  }

  template <class Function>
  void take_curves(const Function& cut)
  {
    Offset_curves curves;
    cut(std::back_inserter(curves));
    std::map<double, Offset_curves> levels;
    for (const Offset_curve& curve : curves) levels[curve.distance()].push_back(curve);
    for (const auto& level : levels)
    {
      m_out.lengths.push_back(total_length(level.second));
      m_out.lengths.push_back(double(level.second.size()));
      m_out.lengths.push_back(double(number_of_closed(level.second)));
    }
    if (CGAL::is_closed(m_case.mesh)) CHECK(number_of_closed(curves) == curves.size());
  }

  Query_case& m_case;
  Random m_random;
  const bool m_checks_paths;
  Outcome& m_out;
  Geodesic m_geodesic;
  Path_locations m_points;
};

void compare(const Query_case& c, unsigned seed, const Outcome& parallel, const Outcome& sequential)
{
  Worst_error worst(bound, c.checker.scale);
  CHECK(parallel.distances.size() == sequential.distances.size());
  if (parallel.distances.size() != sequential.distances.size()) return;
  for (std::size_t i = 0; i < sequential.distances.size(); ++i)
    CHECK_CLOSE(worst, parallel.distances[i], sequential.distances[i]);
  double curves = 0;
  CHECK(parallel.lengths.size() == sequential.lengths.size());
  if (parallel.lengths.size() != sequential.lengths.size()) return;
  for (std::size_t i = 0; i < sequential.lengths.size(); ++i)
  {
    const double m = parallel.lengths[i], n = sequential.lengths[i];
    CHECK_DETAIL(std::abs(m - n) <= (i % 3 == 0 ? 1e-12 * (n + c.checker.scale) : 0), values(m, n));
    curves = (std::max)(curves, std::abs(m - n) / (n + c.checker.scale));
  }
  std::cout << c.name << ", seed " << seed << ": " << worst.count() << " distances, worst " << worst.error() << ", "
            << sequential.lengths.size() / 3 << " levels, worst " << curves << std::endl;
}

bool same_bits(const Outcome& a, const Outcome& b)
{
  return a.distances == b.distances && a.lengths == b.lengths && a.rest == b.rest;
}

// Numbers of threads; the first one twice in all cases, for repeated runs
std::vector<int> thread_counts(bool is_small)
{
  if (is_small) return {2, 3};
  return number_of_cases(std::vector<int>{2, 1, 3}, std::vector<int>{2, 1, 3, 4, 2});
}

void compare_tags(Query_case& c, unsigned seed, std::size_t points, bool is_small)
{
  Report::instance().set_context(c.name + ", seed " + std::to_string(seed));
  Outcome sequential;
  Builds<CGAL::Sequential_tag>(c, seed, false, sequential).run(points);
  std::vector<Outcome> parallel;
  for (const int threads : thread_counts(is_small))
  {
    parallel.emplace_back();
    with_threads(threads, [&] { Builds<CGAL::Parallel_tag>(c, seed, parallel.size() == 1, parallel.back()).run(points); });
    CHECK_DETAIL(same_bits(parallel.back(), parallel.front()), std::to_string(threads) + " threads");
  }
  compare(c, seed, parallel.front(), sequential);
}

// All pieces as numbers.
std::vector<double> pieces_of(const Offset_curves& curves)
{
  std::vector<double> result;
  const auto add_point = [&](const auto& p) {
    result.push_back(p.x());
    result.push_back(p.y());
  };
  for (const Offset_curve& curve : curves)
  {
    result.push_back(curve.distance());
    result.push_back(double(curve.is_closed()));
    for (const auto& piece : curve.pieces())
    {
      result.push_back(double(piece.face()));
      result.push_back(double(piece.source()));
      result.push_back(piece.length());
      add_point(piece.start_2());
      add_point(piece.end_2());
      if (piece.is_arc()) add_point(piece.center());
    }
  }
  return result;
}

// Several threads cut the same curves from given windows as one thread, piece by piece, at few levels and at many.
void same_pieces(Query_case& c)
{
  Report::instance().set_context(c.name + ", pieces");
  Random random(5);
  Geodesic geodesic(c.mesh);
  geodesic.add_sources(c.random_sources(random, 3));
  geodesic.build(CGAL::parameters::keep_windows(true).concurrency_tag(CGAL::Parallel_tag()));
  const double largest = largest_vertex_distance(geodesic, c.mesh);
  for (const std::size_t n : {1, 3, 60})
  {
    const auto levels = CGAL::Offset_levels<double>::equally_spaced(largest / double(n + 1), n);
    Offset_curves curves;
    geodesic.offset_curves(levels, std::back_inserter(curves));
    const std::vector<double> expected = pieces_of(curves);
    CHECK(!expected.empty());
    for (const int threads : {1, 2, 3})
    {
      Offset_curves parallel;
      with_threads(threads, [&] {
        geodesic.offset_curves(levels, std::back_inserter(parallel), CGAL::parameters::concurrency_tag(CGAL::Parallel_tag()));
      });
      CHECK_DETAIL(pieces_of(parallel) == expected, std::to_string(threads) + " threads, " + std::to_string(n) + " levels");
    }
  }
}

// Several threads set up the same mesh as one thread, and report the same bad face.
void same_set_up(Query_case& c)
{
  Report::instance().set_context(c.name + ", set-up");
  Random random(6);
  const Source_set sources = c.random_sources(random, 1);
  const Geodesic alone = built(c.mesh, sources, false);
  for (const int threads : {1, 2, 3})
  {
    std::unique_ptr<Geodesic> geodesic;
    with_threads(threads, [&] {
      geodesic = std::make_unique<Geodesic>(c.mesh, CGAL::parameters::concurrency_tag(CGAL::Parallel_tag()));
    });
    geodesic->add_sources(sources);
    geodesic->build();
    CHECK_DETAIL(distances(*geodesic, c.mesh) == distances(alone, c.mesh), std::to_string(threads) + " threads");
    CHECK(geodesic->statistics().windows_propagated == alone.statistics().windows_propagated);
  }

  test::Surface_mesh bad = c.mesh; // with vertices without extent, or with a hole in space
  const std::size_t n = bad.number_of_vertices();
  for (const std::size_t i : {n / 7, n / 2, n - 2})
    bad.point(Vertex_index(test::Surface_mesh::size_type(i))) = Point_3(0, 0, i == n / 2 ? infinity : 0);
  const auto complaint = [&](auto tag) -> std::string {
    try
    {
      Geodesic geodesic(bad, CGAL::parameters::concurrency_tag(tag));
    }
    catch (const std::invalid_argument& e)
    {
      return e.what();
    }
    return "";
  };
  const std::string one = complaint(CGAL::Sequential_tag());
  CHECK(!one.empty());
  with_threads(3, [&] { CHECK_DETAIL(complaint(CGAL::Parallel_tag()) == one, one); });
}

// Several threads propagate no farther beyond the maximum distance than one does.
void up_to_maximum(Query_case& c)
{
  Report::instance().set_context(c.name + ", up to a maximum distance");
  Random random(3);
  Geodesic geodesic = built(c.mesh, c.random_sources(random, 1), false);
  const double largest = largest_vertex_distance(geodesic, c.mesh);
  for (const double part : {0.15, 0.4, 0.75})
  {
    const auto maximum = CGAL::parameters::distance_limit(part * largest);
    geodesic.build(maximum);
    const double created = double(geodesic.statistics().windows_created);
    geodesic.build(maximum.concurrency_tag(CGAL::Parallel_tag()));
    CHECK_DETAIL(double(geodesic.statistics().windows_created) <= 1.001 * created + 4,
                 values(double(geodesic.statistics().windows_created), created));
  }
}

// Concurrent builds of several objects: in threads outside of TBB, each of which may request further threads from TBB, and within
// tasks of TBB, which ThreadSanitizer does not understand.
void several_at_once(Query_case& c)
{
  Report::instance().set_context(c.name + ", several at once");
  const auto build = [&](std::size_t seed) {
    Random random(static_cast<unsigned>(seed));
    return distances(built_with(c.mesh, c.random_sources(random, 3), CGAL::Parallel_if_available_tag()), c.mesh);
  };
  const std::size_t n = 6;
  std::vector<std::vector<double>> expected, together(n);
  for (std::size_t i = 0; i < n; ++i) expected.push_back(build(i));
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < n; i += 2)
    threads.emplace_back([&, i] {
      for (std::size_t k = i; k < i + 2; ++k) together[k] = build(k);
    });
  for (std::thread& t : threads) t.join();
  CHECK(together == expected);
#if !defined(__SANITIZE_THREAD__)
  tbb::parallel_for(std::size_t(0), n, [&](std::size_t i) { together[i] = build(i); });
  CHECK(together == expected);
#endif
}

// All threads use the caller's rounding mode, also after rounds with another mode.
void rounding_of_the_caller(const test::Surface_mesh& mesh)
{
  const auto build = [&](int threads, int mode) {
    std::vector<double> result;
    with_threads(threads, [&] {
      const int before = std::fegetround();
      std::fesetround(mode);
      result = distances(built_with(mesh, source_set({point_source(*vertices(mesh).begin())}), CGAL::Parallel_tag()), mesh);
      std::fesetround(before);
    });
    return result;
  };
  const std::vector<double> nearest = build(2, FE_TONEAREST), upward = build(1, FE_UPWARD);
  CHECK(nearest != upward);
  for (int i = 0; i < 3; ++i) CHECK(build(2, FE_UPWARD) == upward);
  CHECK(build(2, FE_TONEAREST) == nearest);
}

// Builds from one source with both tags; their distances differ by at most `allowed`.
void same_distances(const test::Surface_mesh& mesh, Vertex_index source, double start_value, double allowed)
{
  const Source_set sources = source_set({point_source(source, start_value)});
  const Geodesic parallel = built_with(mesh, sources, CGAL::Parallel_tag()),
                 sequential = built_with(mesh, sources, CGAL::Sequential_tag());
  for (Vertex_index v : vertices(mesh))
  {
    const double d = parallel.distance_to_sources(v), e = sequential.distance_to_sources(v);
    CHECK_DETAIL(d >= start_value && std::abs(d - e) <= allowed, values(d, e));
  }
}

// Start values so large that all buckets of the front are one, or beyond the range of their numbers: builds end.
void large_start_values(const test::Surface_mesh& mesh)
{
  for (const double s : {1e15, 1e16, 1e19, 1e100, 1e300})
  {
    Report::instance().set_context("start value " + std::to_string(s));
    same_distances(mesh, *vertices(mesh).begin(), s, bound * s);
  }
}

// Needles on both sides of a row of vertices, which is straight up to 1e-11: rays are also started beyond the opposite edge.
void needles()
{
  Report::instance().set_context("needles");
  Soup soup;
  const std::size_t n = 40;
  for (std::size_t i = 0; i <= n; ++i) soup.points.push_back({double(i), i % 2 == 0 ? 0 : 1e-11 * double(i % 7 + 1), 0});
  soup.points.push_back({0.7 * double(n), 1e-10, 0});
  soup.points.push_back({0.3 * double(n), -7e-11, 0});
  for (std::size_t i = 0; i < n; ++i)
  {
    soup.add_triangle({n + 1, i, i + 1});
    soup.add_triangle({n + 2, i + 1, i});
  }
  const Generated_mesh<test::Surface_mesh> data(soup);
  for (Vertex_index v : vertices(data.mesh)) same_distances(data.mesh, v, 0, bound * double(n));
}

// The exception of the first failing item, with any number of threads; the team remains usable.
void exceptions_of_a_team()
{
  typedef CGAL::Geodesic_offset::internal::Index Index;
  for (const unsigned size : {1u, 2u, 3u})
  {
    CGAL::Geodesic_offset::internal::Worker_team team(size);
    for (int round = 0; round < 2000; ++round)
    {
      std::vector<std::atomic<int>> calls(40);
      const bool throws = round % 3 > 0;
      Index thrown = 40;
      try
      {
        team.for_each(
          40, [](Index i) { return i % 7; }, round % 2 == 0,
          [&](unsigned worker, Index i) {
            if (worker >= size) throw std::logic_error("no such worker");
            ++calls[i];
            if (throws && (i == 11 || i == 23 || i == 38)) throw i;
          });
      }
      catch (const Index& i)
      {
        thrown = i;
      }
      CHECK(thrown == (throws ? 11u : 40u));
      for (std::size_t i = 0; i < 40; ++i) CHECK(calls[i] == 1 || (throws && i > 11 && calls[i] == 0));
    }
  }
}

void data_meshes(bool is_small, unsigned seeds)
{
  const Query_cases cases = data_query_cases();
  for (const auto& c : cases)
    for (unsigned seed = 1; seed <= seeds; ++seed) compare_tags(*c, seed, 30, is_small);
  if (!cases.empty()) several_at_once(*cases.back());
  for (const char* name : {"elephant.off", "bunny00.off"})
  {
    test::Surface_mesh mesh;
    if (is_small || !read_data_mesh(std::filesystem::path(data_directory()) / name, 100000, mesh).empty()) continue;
    Query_case c(name, mesh);
    compare_tags(c, 1, 30, is_small);
  }
}

} // namespace test_parallel

GEODESIC_OFFSET_TEST(test_parallel)
{
  const bool is_small = argc > 1 && std::string(argv[1]) == "--small";
  std::vector<std::pair<std::string, std::function<void()>>> tests;
  const Query_cases cases = generated_query_cases();
  const unsigned seeds = is_small ? 1 : number_of_cases(1u, 6u);
  for (const auto& c : cases)
    for (unsigned seed = 1; seed <= seeds; ++seed)
      tests.emplace_back(c->name, [&c, seed, is_small] { compare_tags(*c, seed, 30, is_small); });
  Query_case large("large torus",
                   rotated(torus(is_small ? 60 : number_of_cases(160, 260), is_small ? 40 : number_of_cases(100, 150)), 4));
  tests.emplace_back("large torus", [&] { compare_tags(large, 1, 30, is_small); });
  tests.emplace_back("pieces", [&] { same_pieces(large); });
  tests.emplace_back("pieces", [&] { same_pieces(*cases.front()); });
  tests.emplace_back("set-up", [&] { same_set_up(large); });
  tests.emplace_back("up to a maximum distance", [&] { up_to_maximum(large); });
  tests.emplace_back("rounding of the caller", [&] { rounding_of_the_caller(large.mesh); });
  tests.emplace_back("large start values", [&] { large_start_values(cases.front()->mesh); });
  tests.emplace_back("needles", needles);
  tests.emplace_back("exceptions of a team", exceptions_of_a_team);
  tests.emplace_back("several at once", [&] { several_at_once(large); });
  tests.emplace_back(data_case, [&] { data_meshes(is_small, seeds); });
  return run_tests("test_parallel", tests);
}
