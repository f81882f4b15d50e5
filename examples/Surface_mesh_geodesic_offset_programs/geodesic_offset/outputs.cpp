// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "outputs.h"

#include "common/file_identity.h"
#include "drawing.h"
#include "picture_output.h"
#include "png_output.h"
#include "split_output.h"
#include "voronoi_output.h"

#include <cstdint>
#include <cstddef>
#include <cstdio>
#include <map>
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

namespace {

// Throws Usage_error and Input_error.
void add_band_files(Output_files& files, const Split_mesh& split, const Options& options)
{
  constexpr std::size_t most_files = 10000; // more are a typing error
  const std::map<std::size_t, std::vector<Face>> parts = split.parts(options.has_bands_by_source ? "source" : "band");
  if(parts.size() > most_files)
    throw Usage_error("--bands would write " + std::to_string(parts.size()) + " files; there can be no more than " +
                      std::to_string(most_files));
  std::vector<std::string> others = options.files_read(), names;
  for(const std::string& file : options.files_written()) others.push_back(file);
  for(const auto& [value, faces] : parts)
  {
    names.push_back(options.file_of_band(value == Geodesic::no_source() ? "none" : std::to_string(value)));
    if(value == 0) continue; // checked before
    Output_files::check(names.back());
    check_different_files(others, {names.back()});
  }
  auto name = names.begin();
  for(const auto& part : parts) files.add(*name++, [&](std::ostream& out) { split.write(out, part.second); });
}

} // namespace

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
  if(options.has_split_mesh())
  {
    progress.show("splitting " + quoted(options.mesh));
    const Split_mesh split(input.mesh(), geodesic, curves, chord_tolerance(options, input));
    if(!options.split.empty())
      files.add(
        options.split, [&](std::ostream& out) { split.write(out); }, split.number_of_bytes());
    if(!options.bands.empty()) add_band_files(files, split, options);
  }
  if(!options.voronoi.empty())
    add_voronoi_files(files, options.voronoi, input.mesh(), geodesic, chord_tolerance(options, input), progress);
  const std::vector<Surface_path> paths = queries.paths(input, geodesic, progress);
  for(const std::string& file : options.path_outputs)
    files.add(file, [&](std::ostream& out) { write_paths(out, file, paths); });
  if(!options.source_output.empty()) files.add(options.source_output, [&](std::ostream& out) { write_sources(out, sources); });
  if(!options.picture.empty())
  {
    const Image image = picture_of(geodesic, input, sources, options, curves, paths, figures.largest_distance, progress);
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
