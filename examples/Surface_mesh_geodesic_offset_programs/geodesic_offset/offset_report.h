// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Inner sides, and reasons for missing offsets.

#ifndef GEODESIC_OFFSET_OFFSET_REPORT_H
#define GEODESIC_OFFSET_OFFSET_REPORT_H

#include "common/common.h"
#include "common/numbers.h"
#include "common/sources.h"
#include "curve_files.h"
#include "levels.h"
#include "options.h"
#include "progress.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace geodesic_offset {

// The largest distance by which points were moved, and a warning if it is large.
inline void report(const Moved_points& moved, const Mesh_input& input, const std::string& kind, Progress& progress)
{
  if(const std::string remark = moved.remark(); !remark.empty()) progress.line(kind + ": " + remark);
  if(const std::string far = moved.warning(input.bounding_box_diagonal()); !far.empty()) progress.warning(far);
}

// Warning about --side if no source has sides; otherwise empty.
inline std::string useless_side(const Options& options, const Sources& sources)
{
  if(options.selected_side == CGAL::Offset_side::BOTH || sources.has_polylines()) return std::string();
  return "--side " + options.side + " has no effect: only polylines and sections have sides, and there are none";
}

// Throws Input_error that names the polyline.
inline void require_closed(const Sources& sources, std::size_t polyline)
{
  if(!sources.surface_polylines()[polyline].is_closed)
    throw Input_error(sources.name_of_polyline(polyline) + ": an open polyline has no inside");
}

// The inner sides of closed polylines, by source id; for each a line, and a warning if it is in doubt. `all`: the inner sides of the
// sources; `advice`: end of a warning. Throws Input_error that names the first polyline without inside.
inline std::map<std::size_t, CGAL::Geodesic_inner_side> report_insides(
  const Sources& sources, const std::vector<std::size_t>& needed, const std::map<std::size_t, CGAL::Geodesic_inner_side>& all,
  const std::string& advice, Progress& progress)
{
  constexpr std::size_t most_lines = 20; // per kind; more would hide the other lines
  std::map<std::size_t, CGAL::Geodesic_inner_side> result;
  std::size_t left = 0, doubtful = 0;
  for(const std::size_t id : needed)
  {
    const auto it = all.find(id);
    if(it == all.end()) continue; // as short as a point
    const CGAL::Geodesic_inner_side& inner = it->second;
    const std::string& name = sources.name_of_polyline(id - sources.first_polyline());
    if(inner.side == CGAL::Source_side::NONE)
      throw Input_error(name + ": this curve does not divide the surface into an inside and an outside");
    result.insert(*it);
    const bool is_left = inner.side == CGAL::Source_side::LEFT;
    left += is_left ? 1 : 0;
    const std::string areas = "area " + short_number(inner.inner_area) + ", outside " + short_number(inner.outer_area);
    if(needed.size() <= most_lines)
      progress.line(name + ": inside = " + (is_left ? "left" : "right") + ", the side " +
                    (inner.is_by_area   ? "of smaller area"
                     : inner.has_border ? "that has an area"
                                        : "without border") +
                    " (" + areas + ")");
    if(inner.is_doubtful() && ++doubtful <= most_lines)
      progress.warning(name + ": inside = " + (is_left ? "left" : "right") + " is in doubt, as " +
                       (!inner.has_border  ? "both sides have about the same area"
                        : inner.is_by_area ? "both sides have border of the surface, of holes or around it"
                                           : "the curve is along a border, and there is another one on its only side") +
                       " (" + areas + ')' + advice);
  }
  if(needed.size() > most_lines)
    progress.line("sources: inside = left for " + counted(left, "polyline") + ", right for " +
                  std::to_string(result.size() - left));
  if(doubtful > most_lines) progress.warning(counted(doubtful, "polyline") + " in all whose inside is in doubt");
  return result;
}

// The inner sides of the polylines that are offset inside or outside, as above.
inline std::map<std::size_t, CGAL::Geodesic_inner_side> find_insides(const Options& options, const Sources& sources,
                                                                     const Geodesic& geodesic, Progress& progress)
{
  std::vector<std::size_t> needed;
  for(const auto& [id, side] : sources.sides(options.selected_side))
    if(side == CGAL::Offset_side::INSIDE || side == CGAL::Offset_side::OUTSIDE)
    {
      require_closed(sources, id - sources.first_polyline());
      needed.push_back(id);
    }
  if(needed.empty()) return {};
  return report_insides(sources, needed, geodesic.inner_sides(), "; --side left and --side right are certain", progress);
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
// value of the sources; `reach`: largest computed distance; `ends_before`: nothing is selected beyond; has_unreached_parts: whether
// parts of the surface have no sources.
inline std::vector<std::string> missing_offsets(const Options& options, const Levels& levels,
                                                const std::vector<Level_figures>& figures, double start, double reach,
                                                bool ends_before, bool has_unreached_parts)
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
    else if((distance > reach && !ends_before) || options.takes_everything())
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
