// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// All units have the results in closed form, and the same results to the last bit, whether they link the compiled library or are
// header-only.

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

#define GEODESIC_OFFSET_UNIT(name) std::vector<double> name();
#include "units.h"
#undef GEODESIC_OFFSET_UNIT

// Distances are correct up to rounding; a level is cut below itself by a fraction of 2^-42.
bool is_near(double found, double expected, double tolerance = 1e-14) { return std::abs(found - expected) <= tolerance; }

int main()
{
  const std::vector<std::vector<double>> results{
#define GEODESIC_OFFSET_UNIT(name) name(),
#include "units.h"
  };
  bool is_right = !results.empty();
  for (const std::vector<double>& r : results)
    is_right = is_right && r == results.front() && is_near(r[0], std::sqrt(2.0)) && is_near(r[1], std::atan(1.0), 3e-13) &&
               r.size() == 2 + 169 && r[2] > 0 && r[170] < 20;
  std::cout << results.size() << " units, distance " << results.front()[0] << ", length " << results.front()[1] << '\n';
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
