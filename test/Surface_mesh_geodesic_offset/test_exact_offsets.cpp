// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact offsets of meshes in general position: their curves are those of doubles, and very few signs need exact arithmetic,
// although joints are ends of two arcs and gates lie on arcs: identities of expressions prove that these differences are
// zero. Each sign by exact arithmetic may take seconds on such meshes.

#include "exact_offset_meshes.h"
#include "geodesic_types.h"
#include "test_check.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace test_exact_offsets {

using namespace test;

typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt Exact_kernel;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Exact_kernel, test::Surface_mesh>>
  Exact_geodesic;

struct Totals
{
  std::size_t curves = 0, pieces = 0;
  double length = 0;
};

template <class G>
Totals offset(G& geodesic, const Generated_mesh<test::Surface_mesh>& data, double level)
{
  geodesic.add_source_point(data.vertices[0]);
  std::vector<typename G::Offset_curve> curves;
  typedef typename G::FT FT;
  geodesic.build_with_offset_curves(CGAL::Offset_levels<FT>(std::vector<FT>{FT(level)}), std::back_inserter(curves));
  Totals t;
  t.curves = curves.size();
  for (const auto& c : curves)
    for (const auto& p : c.pieces())
    {
      ++t.pieces;
      t.length += CGAL::to_double(p.length());
    }
  return t;
}

void compare(const std::string& name, const Soup& soup, double part, std::size_t most_by_exact_arithmetic)
{
  Report::instance().set_context(name);
  const Generated_mesh<test::Surface_mesh> data(soup);
  Geodesic distances(data.mesh), rounded(data.mesh);
  distances.add_source_point(data.vertices[0]);
  distances.build();
  const double level = part * distances.largest_vertex_distance().value();
  const Totals expected = offset(rounded, data, level);
  Exact_geodesic exact(data.mesh);
  const std::size_t before = signs_by_exact_arithmetic();
  const Totals actual = offset(exact, data, level);
  const std::size_t by_exact_arithmetic = signs_by_exact_arithmetic() - before;
  const auto& statistics = exact.statistics();
  std::cout << name << ": " << actual.curves << " curves, " << actual.pieces << " pieces, " << statistics.sign_decisions
            << " signs, " << statistics.exact_decisions << " not by intervals, " << by_exact_arithmetic
            << " by exact arithmetic" << std::endl;
  CHECK(actual.curves > 0 && actual.curves == expected.curves);
  CHECK_DETAIL(actual.pieces == expected.pieces, std::to_string(actual.pieces) + ", " + std::to_string(expected.pieces));
  CHECK_DETAIL(std::abs(actual.length - expected.length) <= same_length * expected.length,
               values(actual.length, expected.length));
  CHECK_DETAIL(by_exact_arithmetic <= most_by_exact_arithmetic, std::to_string(by_exact_arithmetic));
  CHECK(statistics.exact_decisions < statistics.sign_decisions / 10);
}

} // namespace test_exact_offsets

GEODESIC_OFFSET_TEST(test_exact_offsets)
{
  using namespace test_exact_offsets;
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    compare("hull of 20 faces, seed " + std::to_string(seed), test::random_hull(20, seed), 0.5, 20);
    compare("hull of 50 faces, seed " + std::to_string(seed), test::random_hull(50, seed), 0.4, 40);
    compare("flat graded disc, seed " + std::to_string(seed), test::graded_disc(30, 3, 0, seed), 0.4, 300);
  }
  return test::Report::instance().finish("test_exact_offsets");
}
