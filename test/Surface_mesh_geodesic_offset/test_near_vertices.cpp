// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances from points and corners of polylines close to vertices and edges, also of needles, and from polylines around
// vertices: cases with former errors, and bounded runs of the search
// (benchmark/Surface_mesh_geodesic_offset/Robustness/near_vertex_search.cpp is the long run).

#include "near_vertex_search.h"
#include "test_check.h"

#include <array>
#include <cstddef>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace test_near_vertices {

using namespace test;

void check(const Near_vertex_search& search)
{
  for (const auto& c : search.counts())
  {
    CHECK_DETAIL(c.second.wrong == 0 && c.second.queries > 0,
                 c.first + ": " + std::to_string(c.second.wrong) + " wrong distances, the worst is off by " +
                   std::to_string(c.second.worst));
    CHECK_DETAIL(c.second.widest_gap <= 1e-13, c.first + ": a gap of " + std::to_string(c.second.widest_gap * 1e13) + "e-13");
  }
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
  for (const unsigned seed : {487u, 2280u, 2977u, 3283u, 4796u, 6431u, 7520u, 9611u, 12028u, 13429u}) known.run(seed);
  check(known);
  Near_vertex_search search(std::cout, 20, 20, Near_vertex_search::PERPENDICULAR);
  for (unsigned seed = 1; seed <= 2000; ++seed) search.run(seed);
  CHECK(search.counts().size() == 4);
  check(search);
}

Soup planar_soup(const std::vector<std::array<double, 2>>& points, const std::vector<std::array<std::size_t, 3>>& triangles)
{
  Soup soup;
  for (const auto& p : points) soup.points.push_back(Point_3(p[0], p[1], 0));
  for (const auto& t : triangles) soup.add_triangle(t);
  return soup;
}

// A corner 1e-13 beside an edge: its rays reach the vertex behind the edge, but their interval on the edge is less than rounding.
void corner_beside_edge()
{
  Near_vertex_search search(std::cout, 20, 100);
  const Soup border = planar_soup(
    {{0, 0},
     {0.5816349245055592, 0},
     {1, 0},
     {0, 0.31113336148985826},
     {0.43779154393954284, 0.34139573463332745},
     {1, 0.3235465043753601},
     {0, 0.7041878443999885},
     {0.5839497600126249, 0.6838725942931915},
     {1, 0.6964381061004035},
     {0, 1},
     {0.4890586898584087, 1},
     {1, 1}},
    {{1, 3, 0},
     {3, 1, 5},
     {5, 1, 2},
     {3, 5, 4},
     {3, 4, 6},
     {10, 9, 4},
     {8, 4, 5},
     {11, 4, 8},
     {10, 4, 7},
     {9, 6, 4},
     {11, 7, 4},
     {7, 11, 10}});
  search.run("corners at the border", border,
             {{8, {0.9999999999812121, 1.7520756958262165e-11, 1.2670465611994846e-12}},
              {8, {0.5, 0.25, 0.25}},
              {8, {0.9999981467695995, 1.853229790374947e-06, 6.100742329568362e-13}},
              {8, {0.9999999999938907, 3.175236899272817e-12, 2.934094791965198e-12}}},
             false);
  check(search);
}

} // namespace test_near_vertices

GEODESIC_OFFSET_TEST(test_near_vertices)
{
  const std::pair<const char*, void (*)()> tests[] = {
    {"known cases", known_cases},
    {"polyline from large to small faces", polyline_from_large_to_small_faces},
    {"search", search},
    {"search around vertices", search_around},
    {"search in needles", search_in_needles},
    {"segments perpendicular to edges", segments_perpendicular_to_edges},
    {"corner beside an edge", corner_beside_edge}};
  return run_tests("test_near_vertices", tests);
}
