// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer test of distances and paths on small meshes, with points as sources, options, updates and targets, against the
// 113-bit reference of ../reference_distances.h. Certified bounds must always hold; distances in doubles and lengths of paths
// must be accurate to 1e-10 of the distance plus the size of the mesh, unless faces are flatter than 2^-30.

#include "../certified_search.h"
#include "fuzz_case.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace {

using test::Geodesic;
using test::Reference_distances;

class Distances
{
public:
  Distances(const test::Fuzz_case& fuzz_case, test::Fuzz_bytes& bytes)
    : c_(fuzz_case.certified_case()), size_(fuzz_case.size()), bytes_(bytes), reference_(c_.points, c_.triangles)
  {
    test::Soup soup;
    for (const auto& p : c_.points) soup.points.push_back(test::Point_3(p[0], p[1], p[2]));
    for (const auto& t : c_.triangles) soup.add_triangle(t);
    const test::Generated_mesh<test::Surface_mesh> data(soup);
    Geodesic geodesic(data.mesh);
    add_sources(data, geodesic, 0, number_of_sources());
    reference_.solve(c_.source_vertices, c_.sources, c_.queries);
    largest_ = 0;
    for (std::size_t v = 0; v < c_.points.size(); ++v) largest_ = (std::max)(largest_, double(reference_.of_vertex(v)));
    build(data, geodesic);
    update(data);
    build_to_target(data, geodesic);
  }

private:
  typedef test::Generated_mesh<test::Surface_mesh> Mesh;

  std::size_t number_of_sources() const { return c_.source_vertices.size() + c_.sources.size(); }

  void add_sources(const Mesh& data, Geodesic& geodesic, std::size_t first, std::size_t last) const
  {
    const std::size_t n = c_.source_vertices.size();
    for (std::size_t i = first; i < last; ++i)
      if (i < n) geodesic.add_source_point(data.vertices[c_.source_vertices[i]]);
      else geodesic.add_source_point(test::Certified_search::location(data, c_, c_.sources[i - n]));
  }

  // Builds with options from the bytes, then again with other options.
  void build(const Mesh& data, Geodesic& geodesic)
  {
    for (int round = 0; round < 2; ++round)
    {
      const bool keeps = bytes_.flag(), has_limit = bytes_.index(4) == 0, is_coarse = bytes_.index(4) == 0;
      const double limit = has_limit ? bytes_.weight() * largest_ : test::infinity;
      const double relative = is_coarse ? std::pow(10, -2. - double(bytes_.index(8))) : 0;
      const bool finds_farthest = bytes_.flag();
      const auto parameters =
        CGAL::parameters::keep_windows(keeps).distance_limit(limit).relative_tolerance(relative).compute_largest_distance(
          finds_farthest);
      geodesic.build(parameters);
      compare_vertices(data, geodesic, limit, relative);
      if (has_limit || is_coarse) continue;
      if (keeps || finds_farthest) compare_farthest(geodesic);
      if (!keeps) continue;
      compare_queries(data, geodesic, relative);
      for (std::size_t q = 0; q < c_.queries.size(); ++q)
        compare_path(geodesic, test::Certified_search::location(data, c_, c_.queries[q]), reference_.of_query(q));
      for (std::size_t v = 0; v < c_.points.size(); ++v) compare_path(geodesic, data.vertices[v], reference_.of_vertex(v));
    }
  }

  // Builds from some sources, then adds the others.
  void update(const Mesh& data) const
  {
    const std::size_t before = bytes_.index(number_of_sources());
    const bool keeps = bytes_.flag();
    Geodesic geodesic(data.mesh);
    add_sources(data, geodesic, 0, before);
    geodesic.build(CGAL::parameters::keep_windows(keeps));
    add_sources(data, geodesic, before, number_of_sources());
    geodesic.update();
    compare_vertices(data, geodesic, test::infinity, 0);
    if (keeps) compare_queries(data, geodesic, 0);
  }

  void build_to_target(const Mesh& data, Geodesic& geodesic) const
  {
    const std::size_t v = bytes_.index(data.vertices.size());
    geodesic.build(CGAL::parameters::targets(std::vector<test::Surface_mesh::Vertex_index>{data.vertices[v]}));
    compare(geodesic.distance_to_sources(data.vertices[v]), double(reference_.of_vertex(v)), test::infinity, 0, "target", v);
  }

  void compare_vertices(const Mesh& data, const Geodesic& geodesic, double limit, double relative) const
  {
    for (std::size_t v = 0; v < c_.points.size(); ++v)
      compare(geodesic.distance_to_sources(data.vertices[v]), double(reference_.of_vertex(v)), limit, relative, "vertex", v);
  }

  void compare_queries(const Mesh& data, const Geodesic& geodesic, double relative) const
  {
    for (std::size_t q = 0; q < c_.queries.size(); ++q)
      compare(geodesic.distance_to_sources(test::Certified_search::location(data, c_, c_.queries[q])),
              double(reference_.of_query(q)), test::infinity, relative, "query", q);
  }

  // The length of the path, the distance of the nearest source, and that of the path's last point from its nearest point.
  template <class Location>
  void compare_path(const Geodesic& geodesic, const Location& location, Reference_distances::Number distance) const
  {
    const double expected = double(distance);
    const auto source = geodesic.nearest_source(location);
    std::vector<test::Point_3> path;
    geodesic.shortest_path_points_to_sources(location, std::back_inserter(path));
    if (!source || path.empty()) test::fail_fuzzing("no path");
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) length += std::sqrt(CGAL::squared_distance(path[i - 1], path[i]));
    compare(length, expected, test::infinity, 0, "path of", path.size());
    compare(source->distance, expected, test::infinity, 0, "source", source->source);
    const double slope = std::sqrt(geodesic.gradient(location).value_or(CGAL::NULL_VECTOR).squared_length());
    if (slope != 0 && std::abs(slope - 1) > 1e-10) test::fail_fuzzing("a gradient of length " + std::to_string(slope));
  }

  // No vertex or query may be farther.
  void compare_farthest(const Geodesic& geodesic) const
  {
    double largest = largest_;
    for (std::size_t q = 0; q < c_.queries.size(); ++q) largest = (std::max)(largest, double(reference_.of_query(q)));
    const double actual = geodesic.farthest_point()->second;
    if (!(actual >= largest - tolerance(largest))) test::fail_fuzzing("the farthest point is at " + std::to_string(actual));
  }

  double tolerance(double distance) const { return 1e-10 * (distance + 4 * size_); }

  void compare(double actual, double expected, double limit, double relative, const char* what, std::size_t i) const
  {
    const double allowed = tolerance(expected);
    const bool is_right = expected > limit - allowed && !(actual < test::infinity)
                          ? true // beyond the limit
                          : actual <= expected + allowed && actual >= expected * (1 - relative) - allowed;
    if (!is_right)
      test::fail_fuzzing(std::string(what) + ' ' + std::to_string(i) + ": " + std::to_string(actual) + " instead of " +
                         std::to_string(expected) + ", off by " + std::to_string(1e12 * (actual - expected)) + "e-12");
  }

  const test::Certified_case c_;
  const double size_;
  test::Fuzz_bytes& bytes_;
  Reference_distances reference_;
  double largest_;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  test::Fuzz_bytes bytes(data, size);
  const test::Fuzz_case fuzz_case(bytes);
  const double flatness = fuzz_case.flatness();
  if (!(flatness > 1e-17)) return 0; // no face may be degenerate
  test::Certified_search search(std::cerr, 5);
  search.run(fuzz_case.certified_case(), "certified bounds");
  if (search.total().violations > 0) std::abort();
  if (!(flatness > 0x1p-30)) return 0;
  try
  {
    Distances distances(fuzz_case, bytes);
  }
  catch (const std::exception& error)
  {
    test::fail_fuzzing(error.what());
  }
  return 0;
}
