// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GEODESIC_OFFSET_BENCHMARK_FASTEST_RUN_H
#define GEODESIC_OFFSET_BENCHMARK_FASTEST_RUN_H

#include "measured_run.h"

#include <utility>

namespace benchmark {

/// The fastest of up to `most` measured runs, within a total of one second. Short runs vary more than long ones, and other
/// work on the machine can only slow a run down.
template <class Computation>
Measured_run fastest_run(const Computation& computation, int most = 9)
{
  Measured_run best = measured_run(computation);
  double total = best.seconds;
  for (int i = 1; i < most && total < 1; ++i)
  {
    Measured_run run = measured_run(computation);
    total += run.seconds;
    if (run.seconds < best.seconds) best = std::move(run);
  }
  return best;
}

} // namespace benchmark

#endif // GEODESIC_OFFSET_BENCHMARK_FASTEST_RUN_H
