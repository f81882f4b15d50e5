// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks that pieces do not cross in any face, neither within a level nor between levels. The pieces are swept by their
// bounding boxes in time O(n log n) plus the number of pairs whose boxes overlap along one axis.

#ifndef GEODESIC_OFFSET_TEST_VALIDATION_CROSSING_VALIDATION_H
#define GEODESIC_OFFSET_TEST_VALIDATION_CROSSING_VALIDATION_H

#include "Validation_level.h"
#include "Validation_report.h"

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

class Crossing_validation
{
public:
  Crossing_validation(double diagonal, const Validation_options& options, Validation_report& report)
    : m_diagonal(diagonal), m_options(options), m_report(report)
  {
  }

  void operator()(const std::vector<Validation_level>& levels)
  {
    std::vector<const Validation_piece*> pieces;
    for (const Validation_level& l : levels)
      for (const Validation_piece& p : l.pieces) pieces.push_back(&p);
    std::sort(pieces.begin(), pieces.end(), [](const Validation_piece* a, const Validation_piece* b) {
      return a->face != b->face ? a->face < b->face : a->low.x < b->low.x;
    });
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::size_t j = i + 1;
           j < pieces.size() && pieces[j]->face == pieces[i]->face && pieces[j]->low.x <= pieces[i]->high.x; ++j)
        if (pieces[i]->may_meet(*pieces[j])) check(*pieces[i], *pieces[j]);
  }

private:
  void check(const Validation_piece& a, const Validation_piece& b)
  {
    const double depth = a.crossing_depth(b) / m_diagonal;
    ++m_report.compared_pairs;
    m_report.worst_crossing = (std::max)(m_report.worst_crossing, depth);
    m_report.check(a.level == b.level ? NO_CROSSING : NESTING, depth <= m_options.level_tolerance, [&] {
      return "two pieces cross in face " + std::to_string(a.face) + ", " + validation_text(depth) + " diagonals deep";
    });
  }

  double m_diagonal;
  const Validation_options& m_options;
  Validation_report& m_report;
};

} // namespace CGAL::Geodesic_offset::internal

#endif // GEODESIC_OFFSET_TEST_VALIDATION_CROSSING_VALIDATION_H
