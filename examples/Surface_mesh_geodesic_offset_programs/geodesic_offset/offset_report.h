// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reasons for missing offsets.

#ifndef GEODESIC_OFFSET_OFFSET_REPORT_H
#define GEODESIC_OFFSET_OFFSET_REPORT_H

#include "common/common.h"
#include "common/numbers.h"
#include "common/sources.h"
#include "curve_files.h"
#include "levels.h"
#include "options.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace geodesic_offset {

// Warning about --side if no source has sides; otherwise empty.
inline std::string useless_side(const Options& options, const Sources& sources)
{
  if(options.selection.side == CGAL::Offset_side::BOTH || sources.has_polylines()) return std::string();
  return "--side " + options.side + " has no effect: only polylines and sections have sides, and there are none";
}

namespace internal {

// For example "distance 7", "3 distances from 7 on".
inline std::string named_distances(const std::vector<double>& distances)
{
  return distances.size() == 1
         ? "distance " + short_number(distances.front())
         : std::to_string(distances.size()) + " distances from " + short_number(distances.front()) + " on";
}

} // namespace internal

// One sentence per reason for named distances without offset. `figures`: of the distances with offsets; `start`: smallest start
// value of the sources; `reach`: largest computed distance; has_unreached_parts: whether parts of the surface have no sources.
inline std::vector<std::string> missing_offsets(const Options& options, const Levels& levels,
                                                const std::vector<Level_figures>& figures, double start, double reach,
                                                bool has_unreached_parts)
{
  std::vector<double> before_start, beyond_maximum, beyond_surface, not_selected;
  for(double distance : levels.named())
  {
    const auto it = std::lower_bound(figures.begin(), figures.end(), distance, [](const Level_figures& level, double d) {
      return level.distance < d;
    });
    if(it != figures.end() && it->distance == distance) continue;
    if(distance <= start)
      before_start.push_back(distance);
    else if(distance > options.maximum_distance.value_or(infinity))
      beyond_maximum.push_back(distance);
    else if(distance > reach || options.selection.is_everything())
      beyond_surface.push_back(distance);
    else
      not_selected.push_back(distance);
  }
  std::vector<std::string> reasons;
  if(!before_start.empty())
    reasons.push_back("no offset at " + internal::named_distances(before_start) + ": the smallest --start-value is " +
                      short_number(start));
  if(!beyond_maximum.empty())
    reasons.push_back("no offset at " + internal::named_distances(beyond_maximum) + ": --maximum-distance is " +
                      short_number(*options.maximum_distance));
  if(!beyond_surface.empty())
    reasons.push_back("no offset at " + internal::named_distances(beyond_surface) +
                      (has_unreached_parts ? ": on the parts of the surface with sources, no point is farther from them than "
                                           : ": no point of the surface is farther from the sources than ") +
                      short_number(reach));
  if(!not_selected.empty())
    reasons.push_back("no offset at " + internal::named_distances(not_selected) + " with " +
                      (options.side.empty() ? "--end " + options.end : "--side " + options.side) +
                      ": the selected part of the surface has no points at this distance");
  return reasons;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_OFFSET_REPORT_H
