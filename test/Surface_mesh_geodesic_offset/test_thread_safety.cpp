// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// All const queries from several threads on one object, against the results of one thread. Built with and without
// ThreadSanitizer.

#include "query_cases.h"

#include <map>
#include <string>
#include <thread>
#include <vector>

namespace test_thread_safety {

using namespace test;

typedef std::vector<double> Answers;

void add(Answers& answers, const Face_location& l)
{
  answers.push_back(double(std::size_t(l.first)));
  answers.insert(answers.end(), l.second.begin(), l.second.end());
}

void add(Answers& answers, const Point_3& p)
{
  for (int i = 0; i < 3; ++i) answers.push_back(p[i]);
}

// Replaces `Sequence_collector`, whose checks are not thread-safe.
struct Sequence_answers
{
  void operator()(Halfedge_index h, double t)
  {
    answers.push_back(double(std::size_t(h)));
    answers.push_back(t);
  }
  void operator()(Vertex_index v) { answers.push_back(double(std::size_t(v))); }
  void operator()(Face_index f, const Geodesic::Barycentric_coordinates& w) { add(answers, Face_location(f, w)); }

  Answers& answers;
};

template <class Query>
void ask(const Geodesic& geodesic, const Query& query, Answers& answers)
{
  answers.push_back(geodesic.distance_to_sources(query));
  const double with_sign = or_nan(geodesic.signed_distance_to_sources(query));
  answers.push_back(std::isnan(with_sign) ? -1e300 : with_sign);
  const auto nearest = geodesic.nearest_source(query);
  if (nearest)
  {
    answers.push_back(double(nearest->source));
    answers.push_back(double(nearest->part));
    add(answers, nearest->location);
  }
  add(answers, CGAL::ORIGIN + geodesic.gradient(query).value_or(CGAL::NULL_VECTOR));
  Path_locations path;
  geodesic.shortest_path_to_sources(query, std::back_inserter(path));
  for (const Face_location& l : path) add(answers, l);
  std::vector<Point_3> points;
  geodesic.shortest_path_points_to_sources(query, std::back_inserter(points));
  for (const Point_3& p : points) add(answers, p);
  Sequence_answers sequence{answers};
  geodesic.shortest_path_sequence_to_sources(query, sequence);
}

// All queries of one thread; `turn` selects the first one, so that threads run different queries concurrently.
std::vector<Answers> ask_all(const Geodesic& geodesic, const test::Surface_mesh& mesh, const Path_locations& points, bool keep,
                             std::size_t turn)
{
  const Mesh_locations locations(mesh);
  const std::vector<Vertex_index> used = used_vertices(mesh);
  const std::size_t tasks = 6;
  std::vector<Answers> result(tasks);
  for (std::size_t i = 0; i < tasks; ++i)
  {
    const std::size_t task = (i + turn) % tasks;
    Answers& answers = result[task];
    switch (task)
    {
    case 0:
      for (const Face_location& l : points)
        if (keep || is_at_vertex(l)) ask(geodesic, l, answers);
      break;
    case 1:
      for (std::size_t k = 0; k < used.size(); k += 5) ask(geodesic, used[k], answers);
      break;
    case 2:
      for (const CGAL::Offset_side side : {CGAL::Offset_side::BOTH, CGAL::Offset_side::LEFT})
        for (const Offset_curve& curve : offsets(geodesic, std::vector<double>{0.21, 0.4}, side))
        {
          std::vector<Point_3> chords;
          curve.points(1e-2, std::back_inserter(chords));
          for (const Point_3& p : chords) add(answers, p);
          for (const Offset_piece& piece : curve.pieces()) answers.push_back(piece.length());
        }
      break;
    case 3:
      for (const Face_location& l : points)
      {
        const Point_3 p = locations.point(l);
        add(answers, geodesic.locate(p));
        add(answers, geodesic.locate(p + Vector_3(0.1, 0, 0), CGAL::parameters::snapping_tolerance(0.1)));
        if (const auto hit = geodesic.locate(Geodesic::Ray_3(p, Point_3(-1, -2, -3)))) add(answers, *hit);
      }
      break;
    case 4:
      if (keep)
      {
        const auto farthest = geodesic.farthest_point().value();
        add(answers, farthest.first);
        answers.push_back(farthest.second);
      }
      break;
    default:
    {
      std::map<Vertex_index, double> distances;
      std::map<Vertex_index, std::size_t> labels;
      geodesic.vertex_distances(boost::make_assoc_property_map(distances));
      geodesic.source_labels(boost::make_assoc_property_map(labels));
      for (const auto& d : distances) answers.push_back(d.second);
      for (const auto& l : labels) answers.push_back(double(l.second));
      answers.push_back(double(geodesic.statistics().windows_propagated));
      answers.push_back(geodesic.covered_distance());
    }
    }
  }
  return result;
}

void run(const Query_case& c, bool keep)
{
  c.set_context(keep ? "with windows" : "without windows");
  Random random(5);
  const Face_location point = c.random_points(random, 1).front();
  Source_set sources = c.section(3);
  sources.add(point_source(point));
  // Two equal objects: the threads are the first to query one of them, half of them a copy.
  const Geodesic alone = built(c.mesh, sources, keep), shared = built(c.mesh, sources, keep), copy(shared);
  const Path_locations points = c.random_points(random, 60);

  // two threads are the first to locate points: initially without a tree, which is built meanwhile
  const std::size_t turns[] = {0, 3, 3, 4}, number = 4;
  std::vector<std::vector<Answers>> answers(number);
  std::vector<std::thread> threads;
  std::vector<std::string> failures(number);
  for (std::size_t t = 0; t < number; ++t)
    threads.emplace_back([&, t] {
      try
      {
        answers[t] = ask_all(t % 2 == 0 ? shared : copy, c.mesh, points, keep, turns[t]);
      }
      catch (const std::exception& e)
      {
        failures[t] = e.what();
      }
    });
  for (std::thread& t : threads) t.join();
  const std::vector<Answers> expected = ask_all(alone, c.mesh, points, keep, 0);
  std::size_t count = 0;
  for (const Answers& a : expected) count += a.size();
  CHECK(count > 1000);
  for (std::size_t t = 0; t < number; ++t)
  {
    CHECK_DETAIL(failures[t].empty(), failures[t]);
    for (std::size_t task = 0; failures[t].empty() && task < expected.size(); ++task)
      CHECK_DETAIL(answers[t][task] == expected[task], "thread " + std::to_string(t) + ", task " + std::to_string(task));
  }
  std::cout << Report::instance().context() << ": " << number << " threads, " << count << " numbers each" << std::endl;
}

} // namespace test_thread_safety

GEODESIC_OFFSET_TEST(test_thread_safety)
{
  for_each_mesh({"torus", "genus 5", "grid"}, {}, [](const Query_case& c) {
    for (const bool keep : {true, false}) run(c, keep);
  });
  return Report::instance().finish("test_thread_safety");
}
