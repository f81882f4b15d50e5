// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer test of offsets on small meshes, from sources of all kinds, at and near vertex distances: each face is compared
// with the exact arrangement of ../offset_oracle.h, and no joint is forced, in one pass or from kept windows, on both sides or
// one. Polylines for curves are within their tolerance, and offsets on both sides are certified. Faces flatter than 2^-30 are
// skipped.

#include "../certified_search.h"
#include "../offset_oracle.h"
#include "../offset_tools.h"
#include "../thin_polylines.h"
#include "fuzz_sources.h"

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using test::Geodesic;

class Offsets
{
public:
  Offsets(test::Fuzz_bytes& bytes, const test::Fuzz_case& fuzz_case)
    : bytes_(bytes), size_(fuzz_case.size()), flatness_(fuzz_case.flatness()), data_(test::soup_of(fuzz_case.certified_case())),
      geodesic_(data_.mesh)
  {
    const test::Certified_case& c = fuzz_case.certified_case();
    for (std::size_t v : c.source_vertices) geodesic_.add_source_point(data_.vertices[v]);
    for (const auto& s : c.sources) geodesic_.add_source_point(test::Certified_search::location(data_, c, s));
    for (std::size_t n = bytes_.index(3); n > 0; --n) test::Fuzz_curves(bytes_, data_).add_to(geodesic_);
    geodesic_.build(CGAL::parameters::keep_windows(true));
  }

  void compare()
  {
    test::Offset_oracle oracle;
    oracle.most_windows = 40;
    test::Face_tracing tracing(geodesic_.mesh(), geodesic_.initial(), geodesic_.field());
    std::vector<double> levels;
    for (int i = 0; i < 2; ++i)
    {
      const double level = draw_level();
      if (!(level > 1e-9 * size_)) continue;
      for (const auto f : data_.mesh.faces())
        oracle.compare(tracing, geodesic_.field_index(f), level,
                       [](const std::string& text) { std::cerr << text << std::endl; });
      if (oracle.counts.differences() > 0) test::fail_fuzzing("the oracle has other curves");
      levels.push_back(level);
    }
    if (levels.empty()) return;
    const CGAL::Offset_side sides[] = {CGAL::Offset_side::BOTH, CGAL::Offset_side::LEFT, CGAL::Offset_side::RIGHT};
    const test::Offset_selection selection(sides[bytes_.index(3)],
                                           bytes_.flag() ? CGAL::Offset_end::BUTT : CGAL::Offset_end::ROUND);
    Geodesic again(geodesic_);
    test::Offset_curves curves;
    again.build_with_offset_curves(levels, std::back_inserter(curves), selection.parameters());
    if (again.statistics().forced_joints > 0) test::fail_fuzzing("forced joints at the level " + std::to_string(levels[0]));
    if (!std::isfinite(test::total_length(curves) + test::total_length(test::offsets(geodesic_, levels, selection))))
      test::fail_fuzzing("a curve without a finite length");
    check_polylines(curves);
    for (const double level : levels) certify(level);
  }

private:
  typedef test::Certified_search::Enclosure Enclosure;

  void check_polylines(const test::Offset_curves& curves)
  {
    const double tolerance = size_ * std::pow(10, -1. - double(bytes_.index(6)));
    for (const auto& curve : curves) test::check_thin_polyline(curve, tolerance, size_);
    if (test::Report::instance().failures() > 0)
      test::fail_fuzzing("a polyline for a curve, tolerance " + std::to_string(tolerance));
  }

  // A curve crosses a smallest cell straight, with distances that differ from the level by up to its diameter. The certificate
  // finds the tolerance up to 2^-45 of the level and two edges, which is less. But it divides a face into 2^16 triangles at most:
  // in a strip along a source that is thinner than 2^-12 of an edge, it is proven up to 2^-12 of an edge only.
  double largest_tolerance(double level) const
  {
    double longest_edge = 0;
    for (const auto e : data_.mesh.edges())
      longest_edge =
        (std::max)(longest_edge, double(CGAL::Polygon_mesh_processing::edge_length(data_.mesh.halfedge(e), data_.mesh)));
    const double strip = 0x1p-12 * longest_edge;
    if (level < strip) return strip;
    return 2 * CGAL::Geodesic_offset::internal::Offset_tolerances<double>(level + longest_edge).smallest_cell;
  }

  // The tolerance of an offset is rounding, unless faces are flat.
  void certify(double level)
  {
    constexpr double least_flatness = 0x1p-10;
    if (!(flatness_ > least_flatness)) return;
    Enclosure enclosure(data_.mesh);
    enclosure.add_sources(geodesic_.sources());
    try
    {
      enclosure.build(CGAL::parameters::keep_windows(true));
    }
    catch (const std::runtime_error&)
    { // documented for needles
      return;
    }
    const test::Offset_curves curves = test::offsets(geodesic_, std::vector<double>{level});
    const auto certificate = enclosure.certify_offset(level, curves);
    if (!certificate.bounds_region) test::fail_fuzzing("no region at the level " + std::to_string(level));
    const double largest = largest_tolerance(level);
    if (!(certificate.tolerance <= largest))
      test::fail_fuzzing("certified only within " + std::to_string(certificate.tolerance / largest) +
                         " times the largest tolerance");
  }

  double draw_level()
  {
    const double d = geodesic_.distance_to_sources(data_.vertices[bytes_.index(data_.vertices.size())]);
    if (!std::isfinite(d)) return 0;
    switch (bytes_.index(4))
    {
    case 0: return d;
    case 1: return test::level_cut_at(d);
    case 2: return d * (1 + (bytes_.flag() ? 1 : -1) * std::pow(10, -double(bytes_.index(16))));
    default: return bytes_.weight() * 2 * size_;
    }
  }

  test::Fuzz_bytes& bytes_;
  const double size_, flatness_;
  const test::Generated_mesh<test::Surface_mesh> data_;
  test::Cut_geodesic geodesic_;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  test::Fuzz_bytes bytes(data, size);
  const test::Fuzz_case fuzz_case(bytes);
  if (!(fuzz_case.flatness() > 0x1p-30)) return 0;
  try
  {
    Offsets(bytes, fuzz_case).compare();
  }
  catch (const std::exception& error)
  {
    test::fail_fuzzing(error.what());
  }
  return 0;
}
