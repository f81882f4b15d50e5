// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer test of distances on small meshes, with points as sources, options, updates and targets, against the 113-bit
// reference of ../reference_distances.h. Certified bounds must always hold; distances in doubles must be accurate to 1e-10 of
// the distance plus the size of the mesh, unless faces are flatter than 2^-30.

#include "../certified_search.h"
#include "fuzz_case.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace {

using test::Geodesic;
using test::Reference_distances;

[[noreturn]] void fail(const std::string& text)
{
  std::cerr << text << std::endl;
  std::abort();
}

class Distances
{
public:
  explicit Distances(test::Fuzz_bytes& bytes)
    : c_(test::Fuzz_case(bytes).certified_case()), bytes_(bytes), reference_(c_.points, c_.triangles)
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
      const auto parameters = CGAL::parameters::keep_windows(keeps).distance_limit(limit).relative_tolerance(relative)
                                .compute_largest_distance(bytes_.flag());
      geodesic.build(parameters);
      compare_vertices(data, geodesic, limit, relative);
      if (keeps && !has_limit) compare_queries(data, geodesic, relative);
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

  void compare(double actual, double expected, double limit, double relative, const char* what, std::size_t i) const
  {
    const double tolerance = 1e-10 * (expected + 4); // coordinates are from -1 to 1
    const bool is_right = expected > limit - tolerance && !(actual < test::infinity)
                            ? true // beyond the limit
                            : actual <= expected + tolerance && actual >= expected * (1 - relative) - tolerance;
    if (!is_right)
      fail(std::string(what) + ' ' + std::to_string(i) + ": " + std::to_string(actual) + " instead of " +
           std::to_string(expected) + ", off by " + std::to_string(1e12 * (actual - expected)) + "e-12");
  }

  const test::Certified_case c_;
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
    test::Fuzz_bytes again(data, size);
    Distances distances(again);
  }
  catch (const std::exception& error)
  {
    fail(error.what());
  }
  return 0;
}
