// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Faults in the data between the steps of the pipeline, each of which an assertion must detect: an unsorted list of
// windows, a sleeping part of the front, swapped twins, and others. Skipped without assertions (NDEBUG).

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "test_check.h"

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Front_partition.h>
#include <CGAL/exceptions.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace test_invariants {

using namespace test;
using namespace CGAL::Geodesic_offset::internal;

typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh> Traits;
typedef CGAL::Geodesic_offset::internal::Window<double> Window;
typedef Unfolded_mesh<double> Mesh;

All_face_links links_of(const Soup& soup)
{
  const Generated_mesh<test::Surface_mesh> data(soup);
  const auto& mesh = data.mesh;
  const std::vector<test::Surface_mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  Single_worker alone;
  return face_links(mesh, faces, get(boost::vertex_index, mesh), get(boost::face_index, mesh), faces.size(), alone);
}

Mesh unfolded(const Soup& soup, const All_face_links& links)
{
  std::vector<Index> face_at(links.size());
  for (Index f = 0; f < face_at.size(); ++f) face_at[f] = f;
  Single_worker alone;
  const std::vector<Point_3> points(soup.points.begin(), soup.points.end());
  return Mesh(Index_renumbering(points.size(), links.size()), links, face_at, points, Traits(), alone);
}

// Whether an assertion stops f, with the given condition in its text. Other exceptions are failures.
bool is_stopped(const std::function<void()>& f, const std::string& condition)
{
  const auto behaviour = CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  const auto handler = CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  bool result = false;
  try
  {
    f();
  }
  catch (const CGAL::Failure_exception& failure)
  {
    result = failure.expression().find(condition) != std::string::npos;
    CHECK_DETAIL(result, failure.expression());
  }
  CGAL::set_error_handler(handler);
  CGAL::set_error_behaviour(behaviour);
  return result;
}

// Two faces of a vertex with swapped neighbours.
void swapped_twin()
{
  const Soup soup = torus(8, 6);
  const All_face_links links = links_of(soup);
  CHECK(unfolded(soup, links).is_laid_out());
  std::size_t stopped = 0;
  for (Index f = 0; f < links.size(); ++f)
  {
    All_face_links faulty = links;
    std::swap(faulty[f].beyond[0], faulty[f].beyond[1]);
    stopped += is_stopped([&] { unfolded(soup, faulty); }, "") ? 1 : 0;
  }
  CHECK(stopped == links.size());
}

// A border on one side of an edge only.
void one_sided_border()
{
  const Soup soup = torus(8, 6);
  All_face_links links = links_of(soup);
  links[5].beyond[1] = no_index;
  CHECK(is_stopped([&] { unfolded(soup, links); }, "has_consistent_twins"));
}

// The state of a front on the torus, in many parts.
struct Front
{
  Front() : soup(torus(60, 40)), mesh(unfolded(soup, links_of(soup))), partition(mesh, false)
  {
    field.clear(mesh, {});
    state.reset(new Wavefront_state<double>(mesh, infinity, true, field, partition.parts()));
  }

  Soup soup;
  Mesh mesh;
  Front_partition partition;
  Geodesic_field<double> field;
  std::unique_ptr<Wavefront_state<double>> state;
};

void part_asleep()
{
  Front front;
  Wavefront_state<double>& state = *front.state;
  const Index last_face = Index(front.mesh.number_of_faces() - 1);
  CHECK(state.parts.of_face(last_face) != state.parts.of_face(0));
  state.move_to(7);
  CHECK(is_stopped([&] { state.schedule(last_face); }, "is_awake"));
  const Window w({0.1, -1, 0, 0, 0, Source_ref(0, CGAL::Source_side::NONE), 0}, 0, 0.1);
  CHECK(is_stopped([&] { state.append(3 * last_face, w); }, "is_awake"));
  state.awake_part(state.parts.of_face(last_face));
  state.schedule(last_face);
  state.append(3 * last_face, w);
  CHECK(is_stopped([&] { state.schedule(0); }, "is_awake"));
  CHECK(is_stopped([&] { state.move_to(6); }, "bucket >= m_current"));
}

void unsorted_list()
{
  Front front;
  const Traits traits;
  const double length = front.mesh[0].length;
  std::vector<Window> windows;
  for (int i = 0; i < 4; ++i)
  {
    windows.push_back(Window({length / 2, -1, 0, 0, 0, Source_ref(0, CGAL::Source_side::NONE), 0}, length * i / 4,
                             length * (i + 1) / 4));
  }
  Batch_propagation<Traits> propagate(*front.state, traits);
  const auto run = [&] {
    double split_distance = infinity, split_entry = 0;
    propagate(0, windows.data(), windows.size(), split_distance, split_entry);
  };
  run();
  CHECK(propagate.number_of_windows() == 4 && !propagate.updates().empty());
  std::swap(windows[1], windows[2]);
  CHECK(is_stopped(run, "is_sorted"));

  // the envelope sorts, so the result is a valid list again
  const std::vector<Index> source_of{0};
  Lower_envelope<Traits> envelope(source_of, traits);
  CHECK(envelope(windows.data(), windows.data() + windows.size(), length).size() == 1);
  // but windows outside the edge are invalid
  windows[0].b0 = -length;
  CHECK(is_stopped([&] { envelope(windows.data(), windows.data() + windows.size(), length); }, "are_in_order"));
}

void queue_that_goes_back()
{
  Bucket_queue queue(0.5);
  queue.push_halfedge(3, 17);
  CHECK(is_stopped([&] { queue.move_to(4); }, "first()")); // past a pending element
  queue.move_to(2);
  CHECK(is_stopped([&] { queue.move_to(1); }, "first()"));
  queue.move_to(3);
  Index h = no_index;
  CHECK(queue.pop_halfedge(h) && h == 17);
}

void lists_and_arenas()
{
  Window_lists<double> lists(12);
  lists.create(3);
  CHECK(is_stopped([&] { lists.create(3); }, "has(h)"));
  CHECK(is_stopped([&] { lists.arena(1); }, "m_arenas.size()"));
  Window_arena<Window> arena, other;
  CHECK(is_stopped([&] { arena.release(nullptr, 0); }, "nullptr"));
  CHECK(is_stopped([&] { arena.give(other, 0, 1); }, "number_of_free_blocks"));
}

// Gates on the boundary of a cell alternate.
void gates_that_do_not_alternate()
{
  Level_curves<double> curves;
  CHECK(is_stopped([&] { curves.gate_found(); }, "m_waiting"));
  CHECK(is_stopped([&] { curves.add_chain(0, no_index, nullptr, nullptr); }, "no_index"));
  Level_cell<double> cell;
  cell.corner = {{0, 0}, {1, 0}, {0, 1}};
  const double r = std::sqrt(0.5);
  cell.direction = {{1, 0}, {-r, r}, {0, -1}};
  cell.is_near = {true, false, false};
  cell.gates = {{{0.5, 0}, 0, true, 0}, {{0, 0.5}, 2, true, 1}};
  const auto divide = [&] {
    cell.divided([](const auto&, const auto&, double, bool, bool, const auto&) {}, [] { return Index(0); });
  };
  CHECK(is_stopped(divide, "is_consistent"));
}

// An update reads kept windows whose distances are within rounding of zero, as a source is 2e-7 of an edge from a corner. No
// assertion fails, from an attack.
void kept_windows_beside_source()
{
  const double rim[10][2] = {
    {977907.2621949712, 0},
    {1134277.7712716602, 824101.03939999861},
    {361955.720036107, 1113985.1607415413},
    {-392825.93363365467, 1208993.9089197977},
    {-541698.95944042224, 393567.33140971797},
    {-910891.84542556002, 1.1155207828698376e-10},
    {-338642.62511329557, -246038.26894018537},
    {-298157.35964224621, -917633.99725858204},
    {427025.33183943288, -1314248.8337590231},
    {942560.11330038728, -684810.00751428306}};
  test::Surface_mesh mesh;
  const test::Surface_mesh::Vertex_index center = mesh.add_vertex(Point_3(0, 0, 0));
  std::vector<test::Surface_mesh::Vertex_index> v;
  for (const auto& p : rim) v.push_back(mesh.add_vertex(Point_3(p[0], p[1], 0)));
  std::vector<test::Surface_mesh::Face_index> f;
  for (std::size_t i = 0; i < 10; ++i) f.push_back(mesh.add_face(center, v[i], v[(i + 1) % 10]));
  const std::vector<Geodesic::Face_location> loop = {
    {f[7], {{5.6554919309082141e-05, 0.43119312632695139, 0.5687503187537396}}},
    {f[7], {{0, 2.320724213088981e-07, 0.99999976792757872}}},
    {f[7], {{4.25915816853484e-05, 0.1297785241843574, 0.87017888423395728}}}};
  const std::vector<Geodesic::Face_location> segment = {{f[0], {{0.5, 0, 0.5}}}, {f[9], {{0.5, 0.5, 0}}}};
  Geodesic geodesic(mesh);
  geodesic.add_source_polyline(loop, CGAL::parameters::is_closed(true));
  geodesic.build(CGAL::parameters::keep_windows(true));
  geodesic.add_source_polyline(segment);
  CHECK(!is_stopped([&] { geodesic.update(); }, "are_in_order"));
}

} // namespace test_invariants

GEODESIC_OFFSET_TEST(test_invariants)
{
#ifdef CGAL_NO_ASSERTIONS
  std::cout << "test_invariants: skipped, it was built without assertions" << std::endl;
  return skipped;
#else
  const std::pair<const char*, void (*)()> tests[] = {
    {"a swapped twin", swapped_twin},
    {"a border on one side", one_sided_border},
    {"a part that is asleep", part_asleep},
    {"a list that is not sorted", unsorted_list},
    {"a queue that goes back", queue_that_goes_back},
    {"lists and arenas", lists_and_arenas},
    {"gates", gates_that_do_not_alternate},
    {"kept windows beside a source", kept_windows_beside_source}};
  return run_tests("test_invariants", tests);
#endif
}
