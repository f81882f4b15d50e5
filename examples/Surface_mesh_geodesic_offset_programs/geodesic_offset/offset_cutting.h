// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The main computation: propagation of distances, and cutting of offsets during the propagation.

#ifndef GEODESIC_OFFSET_OFFSET_CUTTING_H
#define GEODESIC_OFFSET_OFFSET_CUTTING_H

#include "common/common.h"
#include "common/numbers.h"
#include "common/sources.h"
#include "curve_files.h"
#include "drawing.h"
#include "level_files.h"
#include "levels.h"
#include "options.h"
#include "progress.h"
#include "threads.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace geodesic_offset {
namespace internal {

inline bool is_only_drawn(const Options& options)
{
  const std::vector<std::string> files = options.files_written();
  return std::all_of(files.begin(), files.end(), [](const std::string& file) { return has_extension(file, ".svg"); });
}

// Whether some output needs all offsets at once.
inline bool needs_all_curves(const Options& options)
{
  return options.has_split_mesh() || !options.picture.empty() || options.order != Curve_order::as_cut ||
         !std::all_of(options.outputs.begin(), options.outputs.end(), Level_files::supports);
}

// Receives the offsets, which arrive by increasing distance: checks whether they can be written, writes those of files that are
// written level by level, and keeps the others.
class Offset_collector
{
  // of outputs that need all curves: up to 3 GB of memory, at 150 bytes per piece of a curve, each of which has at least one
  // point
  static constexpr std::size_t most_points = 20000000;

  double m_tolerance;
  std::optional<double> m_point_spacing;
  bool m_is_only_drawn;
  bool m_keeps_curves;
  Drawing_check& m_drawing;
  Level_files& m_files;
  Offsets& m_offsets;
  std::size_t m_levels = 0;
  double m_distance = 0;
  bool m_ends_without_curves;
  double m_last_start; // the largest start value of the sources
  bool m_has_ended = false;

public:
  Offset_collector(const Options& options, double tolerance, double last_start, Drawing_check& drawing, Level_files& files,
                   Offsets& offsets)
    : m_tolerance(tolerance), m_point_spacing(options.point_spacing), m_is_only_drawn(is_only_drawn(options)),
      m_keeps_curves(needs_all_curves(options)), m_drawing(drawing), m_files(files), m_offsets(offsets),
      m_ends_without_curves(!options.takes_everything() && !options.needs_field()), m_last_start(last_start)
  {
  }
  Offset_collector(const Offset_collector&) = delete;
  Offset_collector& operator=(const Offset_collector&) = delete;

  std::size_t number_of_levels() const { return m_levels; }
  double distance() const { return m_distance; }

  // Whether no curves are left: paths to farther points of one side would pass the last level on that side, as all start values
  // are less.
  bool has_ended() const { return m_has_ended; }

  // Throws Usage_error and Input_error.
  void operator()(double distance, std::vector<Offset_curve>&& curves)
  {
    ++m_levels;
    m_distance = distance;
    if(m_point_spacing) check_spacing(curves, distance);
    if(m_keeps_curves) count_points(curves);
    if(m_ends_without_curves && curves.empty() && distance > m_last_start) m_has_ended = true;
    m_drawing.look_at(curves);
    if(m_is_only_drawn && !m_drawing.problem().empty()) throw Input_error(m_drawing.problem());
    if(!curves.empty()) m_offsets.levels.push_back(figures_of(distance, curves));
    m_files.write(curves);
    if(m_keeps_curves)
      m_offsets.curves.insert(m_offsets.curves.end(), std::make_move_iterator(curves.begin()),
                              std::make_move_iterator(curves.end()));
  }

private:
  // Throws Usage_error.
  void check_spacing(const std::vector<Offset_curve>& curves, double distance) const
  {
    for(const Offset_curve& curve : curves)
      if(curve.length() / *m_point_spacing > double(most_points))
        throw Usage_error("--point-spacing " + short_number(*m_point_spacing) + " would give an offset at distance " +
                          short_number(distance) + " more than " + std::to_string(most_points) + " points");
  }

  // Throws Usage_error.
  void count_points(const std::vector<Offset_curve>& curves)
  {
    for(const Offset_curve& curve : curves)
    {
      if(m_point_spacing) m_offsets.points += std::size_t(curve.length() / *m_point_spacing) + 1;
      for(const auto& piece : curve.pieces()) m_offsets.points += piece.number_of_chords(m_tolerance);
    }
    if(m_offsets.points > most_points)
      throw Usage_error("the offsets up to distance " + short_number(m_distance) + " have more than " +
                        std::to_string(most_points) + " points, which some outputs need at once: use fewer distances, a " +
                        (m_point_spacing ? "--point-spacing larger than " + short_number(*m_point_spacing)
                                         : "--tolerance larger than " + short_number(m_tolerance)) +
                        ", or only --output files in .polylines.txt, .vtp, .obj or .csv");
  }

  static Level_figures figures_of(double distance, const std::vector<Offset_curve>& curves)
  {
    Level_figures level;
    level.distance = distance;
    level.number = curves.size();
    for(const Offset_curve& curve : curves)
    {
      level.closed += curve.is_closed() ? 1 : 0;
      level.length += CGAL::to_double(curve.length());
    }
    return level;
  }
};

// Progress bar of propagation and cutting.
class Solving_bar
{
  const Levels& m_levels;
  const Offset_collector& m_collector;
  double m_limit;
  Progress& m_progress;

public:
  Solving_bar(const Levels& levels, const Offset_collector& collector, double limit, Progress& progress)
    : m_levels(levels), m_collector(collector), m_limit(limit), m_progress(progress)
  {
  }

  // `done`: fraction of the surface that the front has passed. With a distance limit the last value is below 1. Returns false
  // when no curves are left.
  bool operator()(double done) const
  {
    if(m_levels.empty())
      m_progress.show("distances", done);
    else
      m_progress.show("distances and offsets", std::max(done, m_collector.distance() / m_limit),
                      std::to_string(m_collector.number_of_levels()) +
                        (m_levels.is_open_ended() ? "" : " of " + std::to_string(m_levels.size())) + " cut");
    return !m_collector.has_ended();
  }
};

} // namespace internal

// Limit of computed distances: unless the whole surface is needed, the largest offset distance.
inline double distance_limit(const Options& options, const Levels& levels, const Sources& sources)
{
  const double maximum = options.maximum_distance.value_or(infinity);
  if(levels.empty() || levels.is_open_ended() || options.needs_field() ||
     levels.largest() <= sources.smallest_start_value()) // then there would be no distances at all
    return maximum;
  return std::min(maximum, levels.largest());
}

// Builds the distances and returns the offsets. Those of `files` are written.
inline Offsets build_and_cut(Geodesic& geodesic, const Sources& sources,
                             const std::map<std::size_t, CGAL::Geodesic_inner_side>& insides, const Levels& levels,
                             const Options& options, double tolerance, Drawing_check& drawing, Level_files& files,
                             Progress& progress)
{
  Offsets offsets;
  const double limit = distance_limit(options, levels, sources);
  internal::Offset_collector collector(options, tolerance, sources.largest_start_value(), drawing, files, offsets);
  const auto parameters =
    CGAL::parameters::distance_limit(limit)
      .compute_largest_distance(true)
      .keep_windows(options.needs_windows())
      .relative_tolerance(options.relative_tolerance)
      .merging_tolerance(options.merging_tolerance)
      .visitor(internal::Solving_bar(levels, collector, limit, progress));
  with_concurrency_tag(options.threads, [&](auto tag) {
    if(levels.empty())
      geodesic.build(parameters.concurrency_tag(tag));
    else
      geodesic.build_with_offset_curves_by_distance(levels.distances(), collector,
                                                    parameters.offset_side(sources.sides(options.selected_side, insides))
                                                      .end_style(options.selected_end)
                                                      .concurrency_tag(tag));
  });
  return offsets;
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_OFFSET_CUTTING_H
