// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Cost of an exact offset, as a Markdown table with one line per mesh: random convex hulls, graded discs and regular grids,
// with the first vertex as source.
//
//   exact_offsets [--part P] [--seeds N] [--kind KIND] [--faces F]
//
// The level is P (0.5) times the largest vertex distance; random meshes have N (3) seeds; with a kind or number of faces,
// only such meshes are measured. Seconds are those of build_with_offset_curves() with the kernel
// Exact_predicates_exact_constructions_kernel_with_sqrt. The last columns are the number of signs, of those that intervals
// of up to 256 bits leave open, and of those among them that need exact arithmetic or more. The exit code is 1 if the
// length of the curves differs from that in doubles by more than test::same_length.

#include "exact_offset_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/Radical_numbers.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>
#include <vector>

namespace {

typedef CGAL::Surface_mesh<test::Point_3> Mesh;
template <class K>
using Geodesic = CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<K, Mesh>>;
typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt Exact_kernel;

struct Run
{
  std::size_t curves = 0, pieces = 0;
  double length = 0, seconds = 0;
  std::size_t exact_arithmetic = 0; // signs
};

template <class G>
Run offset(G& geodesic, const typename G::FT& level)
{
  Run r;
  std::vector<typename G::Offset_curve> curves;
  const std::size_t exact_arithmetic = test::signs_by_exact_arithmetic();
  const auto start = std::chrono::steady_clock::now();
  geodesic.build_with_offset_curves(CGAL::Offset_levels<typename G::FT>(std::vector<typename G::FT>{level}),
                                    std::back_inserter(curves));
  r.exact_arithmetic = test::signs_by_exact_arithmetic() - exact_arithmetic;
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  r.curves = curves.size();
  for (const auto& c : curves)
  {
    r.pieces += c.pieces().size();
    for (const auto& p : c.pieces()) r.length += CGAL::to_double(p.length());
  }
  return r;
}

} // namespace

int main(int argc, char* argv[])
{
  double part = 0.5;
  unsigned seeds = 3;
  std::size_t only_faces = 0;
  std::string only_kind;
  for (int i = 1; i + 1 < argc; ++i)
  {
    const std::string a = argv[i];
    if (a == "--part") part = std::atof(argv[++i]);
    else if (a == "--seeds") seeds = unsigned(std::atoi(argv[++i]));
    else if (a == "--kind") only_kind = argv[++i];
    else if (a == "--faces") only_faces = std::size_t(std::atoi(argv[++i]));
  }
  bool is_right = true;
  std::printf("| mesh | seed | faces | curves | pieces | seconds | signs | not by intervals | not by identities |\n"
              "|---|---|---|---|---|---|---|---|---|\n");
  for (const test::Exact_offset_mesh& m : test::exact_offset_meshes())
    for (unsigned seed = 1; seed <= (m.is_random ? seeds : 1); ++seed)
    {
      if ((only_faces != 0 && m.faces != only_faces) || (!only_kind.empty() && m.kind != only_kind)) continue;
      const test::Generated_mesh<Mesh> data(m.make(seed));
      Geodesic<CGAL::Exact_predicates_inexact_constructions_kernel> rounded(data.mesh);
      Geodesic<Exact_kernel> exact(data.mesh);
      rounded.add_source_point(data.vertices[0]);
      exact.add_source_point(data.vertices[0]);
      rounded.build();
      const double level = part * rounded.largest_vertex_distance().value();
      const Run expected = offset(rounded, level), r = offset(exact, level);
      const auto statistics = exact.statistics();
      std::printf("| %s | %u | %zu | %zu | %zu | %.2f | %zu | %zu | %zu |\n", m.kind.c_str(), seed,
                  std::size_t(data.mesh.number_of_faces()), r.curves, r.pieces, r.seconds,
                  std::size_t(statistics.sign_decisions), std::size_t(statistics.exact_decisions), r.exact_arithmetic);
      std::fflush(stdout);
      if (!(std::abs(r.length - expected.length) <= test::same_length * expected.length))
      {
        std::printf("length %.17g, of doubles %.17g\n", r.length, expected.length);
        is_right = false;
      }
    }
  return is_right ? 0 : 1;
}
