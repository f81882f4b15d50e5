// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GEODESIC_OFFSET_BENCHMARK_GROWTH_EXPONENT_H
#define GEODESIC_OFFSET_BENCHMARK_GROWTH_EXPONENT_H

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace benchmark {

/// Exponent e of the best fit c n^e for the points (n[i], y[i]), by least squares of the logarithms. NaN for fewer than two
/// points.
inline double growth_exponent(const std::vector<double>& n, const std::vector<double>& y)
{
  const double count = static_cast<double>(n.size());
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < n.size(); ++i)
  {
    mean_x += std::log(n[i]) / count;
    mean_y += std::log(y[i]) / count;
  }
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < n.size(); ++i)
  {
    const double x = std::log(n[i]) - mean_x;
    xx += x * x;
    xy += x * (std::log(y[i]) - mean_y);
  }
  return n.size() < 2 ? std::numeric_limits<double>::quiet_NaN() : xy / xx;
}

} // namespace benchmark

#endif // GEODESIC_OFFSET_BENCHMARK_GROWTH_EXPONENT_H
