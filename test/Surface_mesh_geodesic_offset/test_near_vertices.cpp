// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances from points and corners of polylines close to vertices and edges: cases with former errors, and a bounded run
// of the search (benchmark/Surface_mesh_geodesic_offset/Robustness/near_vertex_search.cpp is the long run).

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

void search()
{
  Near_vertex_search search(std::cout, 20, 200);
  for (unsigned seed = 1; seed <= 500; ++seed) search.run(seed);
  CHECK(search.counts().size() == 5);
  check(search);
}

} // namespace test_near_vertices

GEODESIC_OFFSET_TEST(test_near_vertices)
{
  const std::pair<const char*, void (*)()> tests[] = {{"known cases", known_cases}, {"search", search}};
  return run_tests("test_near_vertices", tests);
}
