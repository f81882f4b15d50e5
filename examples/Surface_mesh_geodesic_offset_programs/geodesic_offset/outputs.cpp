// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "outputs.h"

#include "drawing.h"
#include "picture_output.h"
#include "png_output.h"
#include "split_output.h"
#include "voronoi_output.h"

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace geodesic_offset {

Output_files::Report writing_bar(Progress& progress)
{
  return [&progress](const std::string& target, std::uintmax_t bytes, std::uintmax_t expected) {
    char size[32];
    std::snprintf(size, sizeof(size), "%.1f MB", static_cast<double>(bytes) / 1e6);
    if(expected != 0)
      progress.show("writing " + quoted(target), static_cast<double>(bytes) / static_cast<double>(expected), size);
    else
      progress.show("writing " + quoted(target), size);
  };
}

void write_outputs(const Solution& solution, const Mesh_input& input, const Sources& sources, const Path_queries& queries,
                   Geodesic& geodesic, const Options& options, Output_files& files, const Run_figures& figures,
                   Progress& progress)
{
  const std::vector<Offset_curve>& curves = solution.offsets.curves;
  const Stopwatch time;
  const std::string not_drawn = add_curve_files(files, options, solution.offsets, chord_tolerance(options, input));
  for(const std::string& file : options.fields)
    files.add(
      file, [&](std::ostream& out) { write_field(out, file, input.soup(), solution.field); },
      bytes_of_field(file, input.soup(), solution.field));
  if(!options.split.empty())
  {
    progress.show("splitting " + quoted(options.mesh));
    const Split_mesh split(input.mesh(), geodesic, curves, chord_tolerance(options, input));
    files.add(
      options.split, [&](std::ostream& out) { split.write(out); }, split.number_of_bytes());
  }
  if(!options.voronoi.empty())
    add_voronoi_files(files, options.voronoi, input.mesh(), geodesic, chord_tolerance(options, input), progress);
  const std::vector<Surface_path> paths = queries.paths(geodesic, progress);
  for(const std::string& file : options.path_outputs)
    files.add(file, [&](std::ostream& out) { write_paths(out, file, paths); });
  if(!options.source_output.empty()) files.add(options.source_output, [&](std::ostream& out) { write_sources(out, sources); });
  if(!options.picture.empty())
  {
    const Image image = picture_of(geodesic, input.mesh(), sources, options, curves, paths, figures.largest_distance, progress);
    files.add(options.picture, [&](std::ostream& out) { write_png(out, image); });
  }
  if(!options.stats.empty())
    files.add(options.stats, [&](std::ostream& out) {
      write_stats(out, figures, solution.statistics, with_requested(solution.offsets.levels, options.distances),
                  solution.offsets);
    });
  files.commit();
  for(const std::string& file : files.targets()) progress.line("wrote " + file);
  progress.line("outputs written", time.seconds());
  if(!not_drawn.empty()) throw Input_error(not_drawn);
}

} // namespace geodesic_offset
