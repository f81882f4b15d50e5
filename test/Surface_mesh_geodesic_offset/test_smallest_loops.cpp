// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The smallest curve around a largest distance, for levels approaching that distance. With doubles, a curve is omitted only
// as documented (manual, Special Levels): shorter than 2^-26 of the level plus the mean edge, with a rise inside of at most
// 3 * 2^-41 of that. With exact numbers, no curve is omitted.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "search_tolerances.h"
#include "test_check.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/Radical_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_smallest_loops {

using namespace test;

/// Mesh with one largest distance from a vertex, or from the border. Near it, distances are linear.
struct Peak
{
  std::string name;
  Soup soup;
  int source;                    // a vertex; -1: the border
  double numerator, denominator; // of the largest distance
  double length_per_rise;        // length of the curve around the largest distance, per rise inside
  bool is_closed;

  double largest() const { return numerator / denominator; }
};

Soup soup_of(const std::vector<Point_3>& points, const std::vector<std::array<std::size_t, 3>>& triangles)
{
  Soup soup;
  soup.points = points;
  for (const auto& t : triangles) soup.add_triangle(t);
  return soup;
}

std::vector<Peak> peaks()
{
  // Rhombus with integer half diagonals and sides; the distance decreases slowly along the longer diagonal.
  const auto rhombus = [](double n) {
    const double a = n * n - 1, b = 2 * n, side = n * n + 1;
    return Peak{"rhombus of 1 : " + std::to_string(int(n / 2)),
                soup_of({Point_3(0, 0, 0), Point_3(a, 0, 0), Point_3(0, b, 0), Point_3(-a, 0, 0), Point_3(0, -b, 0)},
                        {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 4}}, {{0, 4, 1}}}),
                -1,
                a * b,
                side,
                4 * side / (a * b / side),
                true};
  };
  const Soup square = soup_of({Point_3(0, 0, 0), Point_3(2, 0, 0), Point_3(2, 2, 0), Point_3(0, 2, 0), Point_3(1, 1, 0)},
                              {{{0, 1, 4}}, {{1, 2, 4}}, {{2, 3, 4}}, {{3, 0, 4}}});
  const Soup halves =
    soup_of({Point_3(0, 0, 0), Point_3(2, 0, 0), Point_3(2, 2, 0), Point_3(0, 2, 0)}, {{{0, 1, 2}}, {{0, 2, 3}}});
  const Soup triangle = soup_of({Point_3(0, 0, 0), Point_3(4, 0, 0), Point_3(0, 3, 0)}, {{{0, 1, 2}}});
  const Soup rectangle =
    soup_of({Point_3(0, 0, 0), Point_3(4, 0, 0), Point_3(4, 3, 0), Point_3(0, 3, 0)}, {{{0, 1, 3}}, {{1, 2, 3}}});
  // a cube with the center of its top as source: the largest distance is that of the center of the bottom
  const Soup cube = soup_of(
    {Point_3(-1, -1, 0), Point_3(1, -1, 0), Point_3(1, 1, 0), Point_3(-1, 1, 0), Point_3(-1, -1, 2), Point_3(1, -1, 2),
     Point_3(1, 1, 2), Point_3(-1, 1, 2), Point_3(0, 0, 2)},
    {{{0, 2, 1}},
     {{0, 3, 2}},
     {{0, 1, 5}},
     {{0, 5, 4}},
     {{1, 2, 6}},
     {{1, 6, 5}},
     {{2, 3, 7}},
     {{2, 7, 6}},
     {{3, 0, 4}},
     {{3, 4, 7}},
     {{4, 5, 8}},
     {{5, 6, 8}},
     {{6, 7, 8}},
     {{7, 4, 8}}});
  return {{"triangle, in a face", triangle, -1, 1, 1, 12, true},
          {"square, at a vertex", square, -1, 1, 1, 8, true},
          {"square, on an edge", halves, -1, 1, 1, 8, true},
          {"rectangle, at a border vertex", rectangle, 0, 5, 1, 25. / 12, false},
          // the triangle (0, 0) (4, 0) (4, 3) on both sides
          {"two faces, at their vertex",
           soup_of({Point_3(0, 0, 0), Point_3(4, 0, 0), Point_3(4, 3, 0)}, {{{0, 1, 2}}, {{1, 0, 2}}}), 0, 5, 1, 8. / 3, true},
          {"cube, on an edge", cube, 8, 4, 1, 8, true},
          rhombus(16),
          rhombus(0x1p17)};
}

/// Field and its offsets, from kept windows and in one pass.
template <class Kernel>
class Field
{
public:
  typedef typename Kernel::FT FT;
  typedef CGAL::Surface_mesh<typename Kernel::Point_3> Mesh;
  typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;
  typedef std::vector<typename Geodesic::Offset_curve> Curves;

  explicit Field(const Soup& soup, int source) : mesh_(mesh_of(soup)), geodesic_(mesh_)
  {
    if (source >= 0) geodesic_.add_source_point(typename Mesh::Vertex_index(typename Mesh::size_type(source)));
    else
    {
      std::vector<typename Mesh::Edge_index> border;
      for (const auto e : mesh_.edges())
        if (mesh_.is_border(e)) border.push_back(e);
      geodesic_.add_source_edges(border);
    }
    geodesic_.build(CGAL::parameters::keep_windows(true));
  }

  Curves kept(const FT& level) const
  {
    Curves result;
    geodesic_.offset_curves(level, std::back_inserter(result));
    return result;
  }
  Curves in_one_pass(const FT& level) const
  {
    Curves result;
    Geodesic again(geodesic_);
    again.build_with_offset_curves(level, std::back_inserter(result));
    CHECK(again.statistics().forced_joints == 0);
    return result;
  }

  double mean_edge() const
  {
    double sum = 0;
    for (const auto f : mesh_.faces())
      for (const auto h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_))
        sum += std::sqrt(CGAL::to_double(CGAL::squared_distance(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)))));
    return sum / (3. * double(mesh_.number_of_faces()));
  }

private:
  static Mesh mesh_of(const Soup& soup)
  {
    Mesh mesh;
    std::vector<typename Mesh::Vertex_index> vertices;
    for (const auto& p : soup.points) vertices.push_back(mesh.add_vertex(typename Kernel::Point_3(p.x(), p.y(), p.z())));
    for (const auto& t : soup.triangles) mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    return mesh;
  }

  const Mesh mesh_;
  Geodesic geodesic_;
};

/// The smallest curve found, and the largest rise without a curve, per level plus mean edge.
struct Smallest
{
  double length = std::numeric_limits<double>::infinity(), rise = length, left_out = 0;
};

// Levels approaching the largest distance from below.
void near_peak(const std::string& name, const Peak& peak, const Soup& soup, Smallest& smallest)
{
  Report::instance().set_context(name);
  const Field<test::Kernel> field(soup, peak.source);
  const double edge = field.mean_edge(), unit = peak.largest() + edge;
  for (double below = 0x1p-12; below >= 0x1p-54; below *= 0.75)
  {
    const double level = peak.largest() - below * unit;
    if (level < peak.largest() / 2) continue; // a flat peak
    const double m = level + edge, rise = peak.largest() - cut_of(level);
    const double expected = rise * peak.length_per_rise;
    // the rise known to the package has the error of two distances
    const bool must_exist = rise > (unseen_rise + 2 * distance_error) * m || expected > 1.01 * longest_unseen_curve * m;
    for (const bool is_one_pass : {false, true})
    {
      const auto curves = is_one_pass ? field.in_one_pass(level) : field.kept(level);
      const std::string where =
        "rise " + std::to_string(std::log2(rise / m)) + ", length " + std::to_string(std::log2(expected / m)) +
        " (powers of 2), " + std::to_string(curves.size()) + " curves";
      CHECK_DETAIL(curves.size() <= 1 && (curves.size() == 1 || !must_exist), where);
      if (curves.empty()) smallest.left_out = (std::max)(smallest.left_out, rise / m);
      if (curves.size() != 1) continue;
      const double length = curves[0].length();
      // the error of a distance, and, for arcs, the square of the rise
      const double allowed = distance_error * m * peak.length_per_rise + 4 * expected * rise / peak.largest();
      CHECK_DETAIL(curves[0].is_closed() == peak.is_closed && std::abs(length - expected) <= allowed, where);
      smallest.length = (std::min)(smallest.length, length / m);
      smallest.rise = (std::min)(smallest.rise, rise / m);
    }
  }
  for (const double level : {peak.largest() * (1 + 0x1p-41), peak.largest() * (1 + 0x1p-30), 2 * peak.largest()})
    CHECK(field.kept(level).empty() && field.in_one_pass(level).empty());
}

void doubles()
{
  Smallest smallest;
  for (const Peak& peak : peaks())
  {
    near_peak(peak.name, peak, peak.soup, smallest);
    for (unsigned seed = 1; seed <= 3; ++seed)
      near_peak(peak.name + ", turned by seed " + std::to_string(seed), peak, rotated(peak.soup, seed), smallest);
  }
  std::cout << "with doubles, the smallest curve has the length " << smallest.length << " and a rise of " << smallest.rise
            << " inside; the largest rise without a curve is " << smallest.left_out << ", all per level plus mean edge"
            << std::endl;
}

void exact_numbers()
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt Exact;
  typedef Field<Exact>::FT FT;
  double least = 1;
  for (const Peak& peak : peaks())
  {
    Report::instance().set_context(peak.name + ", exact");
    const Field<Exact> field(peak.soup, peak.source);
    const FT largest = FT(peak.numerator) / FT(peak.denominator);
    for (const int exponent : {-20, -42, -60, -100, -300})
    {
      const FT rise = FT(std::ldexp(1., exponent)) * largest;
      for (const auto& curves : {field.kept(largest - rise), field.in_one_pass(largest - rise)})
      {
        if (!CHECK(curves.size() == 1 && curves[0].is_closed() == peak.is_closed)) continue;
        const double ratio = CGAL::to_double(curves[0].length() / rise), off = std::abs(ratio / peak.length_per_rise - 1);
        // arcs: the length is linear up to the square of the rise
        CHECK_DETAIL(off <= 1e-13 + std::ldexp(4., exponent), values(ratio, peak.length_per_rise));
        least = (std::min)(least, CGAL::to_double(curves[0].length() / largest));
      }
    }
    CHECK(field.kept(largest).empty() && field.in_one_pass(largest).empty());
  }
  std::cout << "with exact numbers, the smallest curve has " << least << " of the level" << std::endl;
}

// Decreasing curves around a source vertex. None of them surrounds a largest distance, so none is omitted.
template <class AnyKernel>
void around_source(const std::string& name, int lowest_exponent)
{
  Report::instance().set_context(name);
  const Field<AnyKernel> field(planar_grid(4, 4), 12); // the middle
  const double edge = field.mean_edge();
  for (int exponent = -4; exponent >= lowest_exponent; exponent -= 4)
  {
    const double level = std::ldexp(1., exponent), expected = 2 * CGAL_PI * level;
    for (const auto& curves : {field.kept(level), field.in_one_pass(level)})
    {
      if (!CHECK_DETAIL(curves.size() == 1 && curves[0].is_closed(),
                        "level 2^" + std::to_string(exponent) + ", " + std::to_string(curves.size()) + " curves"))
        continue;
      const double length = CGAL::to_double(curves[0].length());
      CHECK_DETAIL(std::abs(length - expected) <= 1e-12 * expected + 2 * CGAL_PI * distance_error * (level + edge),
                   values(length, expected));
    }
  }
}

void around_sources()
{
  around_source<test::Kernel>("round a source", -44);
  around_source<CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt>("round a source, exact", -300);
}

} // namespace test_smallest_loops

GEODESIC_OFFSET_TEST(test_smallest_loops)
{
  const std::pair<const char*, void (*)()> tests[] = {
    {"doubles", doubles}, {"exact numbers", exact_numbers}, {"around sources", around_sources}};
  return run_tests("test_smallest_loops", tests);
}
