// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances from points and corners of polylines close to vertices and edges, also of needles, and from polylines around
// vertices: cases with former errors, and bounded runs of the search
// (benchmark/Surface_mesh_geodesic_offset/Robustness/near_vertex_search.cpp is the long run).

#include "near_vertex_search.h"
#include "test_check.h"

#include <iostream>
#include <string>
#include <utility>

namespace test_near_vertices {

using namespace test;

void check(const Near_vertex_search& search)
{
  for (const auto& c : search.counts())
    CHECK_DETAIL(c.second.wrong == 0 && c.second.queries > 0,
                 c.first + ": " + std::to_string(c.second.wrong) + " wrong distances, the worst is off by " +
                   std::to_string(c.second.worst));
}

// Corners on both sides of a short segment at a vertex, corners above an edge, a vertex that hides the rays behind it.
void known_cases()
{
  Near_vertex_search search(std::cout, 20, 500);
  for (const unsigned seed : {10954u, 11985u, 12892u, 18468u}) search.run(seed);
  check(search);
  Near_vertex_search other(std::cout, 20, 300);
  other.run(102184);
  check(other);
}

// A polyline turns around vertex 4, between edges of length 0.3 and 100. The path to vertex 8 bends at vertex 6, which the
// polyline's second point reaches straight and, up to the rounding of the large face, around the end of a strip.
void polyline_from_large_to_small_faces()
{
  const Soup soup = Near_vertex_search::large_beside_small_faces();
  Near_vertex_search search(std::cout, 20, 100);
  for (const double t : {0., 1e-8, 1e-7, 1e-6, 3e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.5})
    for (const double u : {0.01, 0.143, 0.3, 0.6})
      for (const bool is_closed : {false, true})
      {
        const Near_vertex_search::Location first{0, {0, 1 - t, t}}, second{7, {u, 1 - u, 0}}, third{3, {0, 0.5, 0.5}};
        search.run("from large to small faces", soup, {first, second, third}, is_closed);
        search.run("with duplicates", soup, {first, first, second, second, third, third}, is_closed);
        search.run("backwards", soup, {third, second, first}, is_closed);
      }
  check(search);
}

void search()
{
  Near_vertex_search search(std::cout, 20, 200);
  for (unsigned seed = 1; seed <= 500; ++seed) search.run(seed);
  CHECK(search.counts().size() == 5);
  check(search);
}

void search_around()
{
  Near_vertex_search search(std::cout, 20, 20, Near_vertex_search::AROUND);
  for (unsigned seed = 1; seed <= 500; ++seed) search.run(seed);
  CHECK(search.counts().size() == 5);
  check(search);
}

// Sources so near to an edge that positions in the frame of a face may lie on the other side.
void search_in_needles()
{
  Near_vertex_search search(std::cout, 20, 40, Near_vertex_search::IN_NEEDLES);
  for (unsigned seed = 1; seed <= 2000; ++seed) search.run(seed);
  CHECK(search.counts().size() == 4);
  check(search);
}

// Rays of the end of a segment beside a bounding ray of the segment, which cross an edge far from the vertex at its end.
void segments_perpendicular_to_edges()
{
  Near_vertex_search known(std::cout, 20, 100, Near_vertex_search::PERPENDICULAR);
  for (const unsigned seed : {1080u, 1197u, 3609u, 4264u, 5939u, 6697u, 9400u, 9656u}) known.run(seed);
  check(known);
  Near_vertex_search search(std::cout, 20, 20, Near_vertex_search::PERPENDICULAR);
  for (unsigned seed = 1; seed <= 2000; ++seed) search.run(seed);
  CHECK(search.counts().size() == 4);
  check(search);
}

} // namespace test_near_vertices

GEODESIC_OFFSET_TEST(test_near_vertices)
{
  const std::pair<const char*, void (*)()> tests[] = {{"known cases", known_cases},
                                                      {"polyline from large to small faces", polyline_from_large_to_small_faces},
                                                      {"search", search},
                                                      {"search around vertices", search_around},
                                                      {"search in needles", search_in_needles},
                                                      {"segments perpendicular to edges", segments_perpendicular_to_edges}};
  return run_tests("test_near_vertices", tests);
}
