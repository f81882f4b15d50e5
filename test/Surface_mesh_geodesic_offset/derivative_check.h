// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Check that the derivative of the area of {D < d} is the length of the offset at d, and totals of such checks.

#ifndef GEODESIC_OFFSET_TEST_DERIVATIVE_CHECK_H
#define GEODESIC_OFFSET_TEST_DERIVATIVE_CHECK_H

#include "offset_integrals.h"
#include "test_check.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace test {

struct Derivative_check
{
  std::size_t distances = 0, at_events = 0; // at events there is no derivative
  double worst = 0;                         // relative difference

  void operator()(Offset_integrals& integrals, double d)
  {
    Coarea coarea;
    ++distances;
    if (!integrals.derivative_at(d, coarea))
    {
      ++at_events;
      return;
    }
    worst = (std::max)(worst, coarea.relative_difference());
    CHECK_DETAIL(coarea.relative_difference() <= 1e-9, "at " + std::to_string(d) + ", " + values(coarea.area, coarea.integral));
  }
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_DERIVATIVE_CHECK_H
