// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures of a run as JSON.

#ifndef GEODESIC_OFFSET_STATS_OUTPUT_H
#define GEODESIC_OFFSET_STATS_OUTPUT_H

#include "common/common.h"
#include "curve_files.h"

#include <CGAL/Bbox_3.h>

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace geodesic_offset {

struct Run_figures
{
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t parts = 0;
  std::size_t border_cycles = 0;
  CGAL::Bbox_3 bounding_box;
  std::size_t unreached_parts = 0; // without sources
  std::size_t unreached_vertices = 0; // of the file
  std::size_t threads = 1;
  double load_seconds = 0;
  double setup_seconds = 0;
  double largest_distance = 0; // of the surface, up to the covered distance
  double covered_distance = infinity; // all distances up to it are known
  std::optional<Point> farthest_point; // if requested
  std::map<std::size_t, CGAL::Geodesic_inner_side> insides; // by source, of polylines that are offset inside or outside
  bool has_tolerance = false; // whether distances may be smaller than the exact ones
};

// The figures with those of requested distances without curves, in increasing order.
inline std::vector<Level_figures> with_requested(std::vector<Level_figures> levels, const std::vector<double>& distances)
{
  const auto is_less = [](const Level_figures& a, const Level_figures& b) { return a.distance < b.distance; };
  for(double distance : distances)
  {
    Level_figures level;
    level.distance = distance;
    const auto it = std::lower_bound(levels.begin(), levels.end(), level, is_less);
    if(it == levels.end() || it->distance != distance) levels.insert(it, level);
  }
  return levels;
}

inline std::uintmax_t peak_rss_bytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#if defined(__APPLE__)
  return static_cast<std::uintmax_t>(usage.ru_maxrss);
#else
  return static_cast<std::uintmax_t>(usage.ru_maxrss) * 1024;
#endif
}

// Places of the curves in the tree of nesting, with --order.
inline void write_nesting(std::ostream& out, const Offsets& offsets)
{
  if(offsets.places.empty()) return;
  const char* separator = "\n";
  out << "  \"nesting\": [";
  for(std::size_t i = 0; i < offsets.places.size(); ++i)
  {
    const CGAL::Offset_curve_nesting& place = offsets.places[i];
    out << separator << "    {\"curve\": " << i << ", \"distance\": " << offsets.curves[i].distance()
        << ", \"closed\": " << (offsets.curves[i].is_closed() ? "true" : "false") << ", \"parent\": "
        << (place.depth > 0 ? std::to_string(place.parent) : "null") << ", \"depth\": " << place.depth << ", \"inner_side\": "
        << (place.inner_side == CGAL::LEFT_TURN    ? "\"left\""
            : place.inner_side == CGAL::RIGHT_TURN ? "\"right\""
                                                   : "null")
        << '}';
    separator = ",\n";
  }
  out << "\n  ],\n";
}

inline void write_stats(std::ostream& out, const Run_figures& run, const Geodesic::Statistics& solver,
                        const std::vector<Level_figures>& levels, const Offsets& offsets)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "{\n"
      << "  \"vertices\": " << run.vertices << ",\n"
      << "  \"faces\": " << run.faces << ",\n"
      << "  \"parts\": " << run.parts << ",\n"
      << "  \"border_cycles\": " << run.border_cycles << ",\n"
      << "  \"bounding_box\": [[" << run.bounding_box.xmin() << ", " << run.bounding_box.ymin() << ", "
      << run.bounding_box.zmin() << "], [" << run.bounding_box.xmax() << ", " << run.bounding_box.ymax() << ", "
      << run.bounding_box.zmax() << "]],\n"
      << "  \"unreached_parts\": " << run.unreached_parts << ",\n"
      << "  \"unreached_vertices\": " << run.unreached_vertices << ",\n"
      << "  \"threads\": " << run.threads << ",\n"
      << "  \"load_seconds\": " << run.load_seconds << ",\n"
      << "  \"setup_seconds\": " << run.setup_seconds << ",\n"
      << "  \"solve_seconds\": " << solver.propagation_seconds << ",\n"
      << "  \"offset_seconds\": " << solver.offset_seconds << ",\n"
      << "  \"windows_created\": " << solver.windows_created << ",\n"
      << "  \"windows_propagated\": " << solver.windows_propagated << ",\n"
      << "  \"windows_peak\": " << solver.windows_peak << ",\n"
      << "  \"pieces_peak\": " << solver.pieces_peak << ",\n"
      << "  \"pieces\": " << solver.pieces << ",\n"
      << "  \"peak_rss_bytes\": " << peak_rss_bytes() << ",\n"
      << "  \"largest_distance\": " << run.largest_distance << ",\n"
      << "  \"covered_distance\": ";
  if(run.covered_distance < infinity)
    out << run.covered_distance;
  else
    out << "null";
  out << ",\n";
  if(run.has_tolerance)
    out << "  \"error_bound\": " << solver.error_bound << ",\n"
        << "  \"relative_error_bound\": " << solver.relative_error_bound << ",\n";
  if(run.farthest_point)
    out << "  \"farthest_point\": [" << run.farthest_point->x() << ", " << run.farthest_point->y() << ", "
        << run.farthest_point->z() << "],\n";
  const char* separator = "\n";
  if(!run.insides.empty())
  {
    out << "  \"insides\": [";
    for(const auto& [source, inner] : run.insides)
    {
      out << separator << "    {\"source\": " << source << ", \"inside\": \""
          << (inner.side == CGAL::Source_side::LEFT ? "left" : "right") << "\", \"area\": " << inner.inner_area
          << ", \"outer_area\": " << inner.outer_area << '}';
      separator = ",\n";
    }
    out << "\n  ],\n";
    separator = "\n";
  }
  write_nesting(out, offsets);
  out << "  \"curves\": [";
  for(const Level_figures& level : levels)
  {
    out << separator << "    {\"distance\": " << level.distance << ", \"number\": " << level.number
        << ", \"closed\": " << level.closed << ", \"length\": " << level.length << '}';
    separator = ",\n";
  }
  out << (levels.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_STATS_OUTPUT_H
