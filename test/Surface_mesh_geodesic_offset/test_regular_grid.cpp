// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// 300 x 300 squares, each split in two, source at a corner: all distances are correct to 1e-12 relative, none infinite.
// Apexes lie exactly on window boundaries, and most distances tie.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "test_check.h"

#include <string>

GEODESIC_OFFSET_TEST(test_regular_grid)
{
  using namespace test;
  const std::size_t n = argc > 1 ? std::stoul(argv[1]) : 300;
  const std::pair<Diagonals, const char*> kinds[] = {{Diagonals::forward, "forward"},
                                                     {Diagonals::backward, "backward"},
                                                     {Diagonals::alternating, "alternating"},
                                                     {Diagonals::random, "random"}};
  for (const auto& kind : kinds)
    for (std::size_t source : {std::size_t(0), n, (n / 2) * (n + 1) + n / 3})
    {
      const Generated_mesh<test::Surface_mesh> data(planar_grid(n, n, kind.first));
      Geodesic geodesic(data.mesh);
      geodesic.add_source_point(data.vertices[source]);
      geodesic.build();
      Report::instance().set_context(std::string(kind.second) + " diagonals, source vertex " + std::to_string(source));
      Worst_error worst(1e-12, 0);
      std::size_t infinite = 0;
      const double x = static_cast<double>(source % (n + 1)), y = static_cast<double>(source / (n + 1));
      for (std::size_t i = 0; i < data.vertices.size(); ++i)
      {
        const double expected = std::hypot(static_cast<double>(i % (n + 1)) - x, static_cast<double>(i / (n + 1)) - y);
        const double actual = geodesic.distance_to_sources(data.vertices[i]);
        infinite += std::isinf(actual) ? 1 : 0;
        CHECK_CLOSE(worst, actual, expected);
      }
      CHECK(infinite == 0);
      std::cout << Report::instance().context() << ": " << worst.count() << " vertices, " << infinite
                << " infinite, worst relative error " << worst.error() << ", "
                << static_cast<double>(geodesic.statistics().windows_propagated) / static_cast<double>(data.vertices.size())
                << " windows a vertex" << std::endl;
    }
  return Report::instance().finish("test_regular_grid");
}
