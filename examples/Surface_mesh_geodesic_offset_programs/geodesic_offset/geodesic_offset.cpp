// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Program for exact geodesic distances on a triangle mesh and exact geodesic offsets of curves. --help lists the options.
// Exit codes: 0 success, 1 an error in something that the command line names (one line on stderr), 2 an error in the
// command line itself. Outputs appear only if everything succeeded, with one exception: if curves are not planar, only the
// drawings are missing.

#include "common/common.h"
#include "common/mesh_input.h"
#include "common/output_file.h"
#include "common/program_main.h"
#include "common/sources.h"
#include "common/version.h"
#include "barriers.h"
#include "curve_order.h"
#include "drawing.h"
#include "level_files.h"
#include "levels.h"
#include "offset_cutting.h"
#include "offset_report.h"
#include "options.h"
#include "outputs.h"
#include "progress.h"
#include "reach.h"
#include "threads.h"

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace geodesic_offset {
namespace {

void describe(const Mesh_input& input, Run_figures& figures)
{
  figures.vertices = input.mesh().number_of_vertices();
  figures.faces = input.mesh().number_of_faces();
  figures.parts = input.parts().number();
  figures.border_cycles = input.parts().number_of_border_cycles();
  figures.bounding_box = input.bounding_box();
}

Mesh_input load(const Options& options, Run_figures& figures, Progress& progress)
{
  const Stopwatch time;
  progress.show("reading " + quoted(options.mesh));
  Mesh_input input(options.mesh, options.borders);
  describe(input, figures);
  figures.load_seconds = time.seconds();
  progress.line("mesh: " + counted(figures.vertices, "vertex", "vertices") + ", " + counted(figures.faces, "face"),
                figures.load_seconds);
  const auto corner = [&](double (CGAL::Bbox_3::*end)(int) const) {
    const CGAL::Bbox_3& box = figures.bounding_box;
    return short_number((box.*end)(0)) + ',' + short_number((box.*end)(1)) + ',' + short_number((box.*end)(2));
  };
  progress.line("mesh: " + counted(figures.parts, "part") + ", " + counted(figures.border_cycles, "border cycle") +
                ", bounding box from " + corner(&CGAL::Bbox_3::min) + " to " + corner(&CGAL::Bbox_3::max));
  for(const std::string& remark : input.remarks()) progress.line("mesh: " + remark);
  if(!input.warning().empty()) progress.warning(input.warning());
  if(options.barriers.have_effect() || internal::have_start_values(options))
  {
    progress.show("barriers");
    add_barriers(input, options, progress);
    describe(input, figures);
  }
  check_length("tolerance", options.tolerance, input.bounding_box_diagonal());
  check_length("point-spacing", options.point_spacing, input.bounding_box_diagonal());
  return input;
}

Sources find_sources(const Mesh_input& input, const Options& options, Geodesic& geodesic, Progress& progress)
{
  Sources sources(input, options, geodesic.mesh());
  sources.add_to(geodesic);
  for(const std::string& remark : sources.remarks()) progress.line("sources: " + remark);
  for(const std::string& warning : sources.warnings()) progress.warning(warning);
  report(sources.moved_points(), input, "sources", progress);
  if(options.maximum_distance && *options.maximum_distance <= sources.smallest_start_value())
    throw Input_error("--maximum-distance " + short_number(*options.maximum_distance) +
                      " leaves no distances: the smallest --start-value is " + short_number(sources.smallest_start_value()));
  if(const std::string useless = useless_side(options, sources); !useless.empty()) progress.warning(useless);
  if(options.has_levels() && !options.shows_offsets())
    progress.line("offsets: in no file, as there is no --output, --split, --bands, --picture or --stats");
  return sources;
}

// Numbers of parts without sources, and of the vertices of the file on these parts.
std::pair<std::size_t, std::size_t> unreached(const Mesh_input& input, const Sources& sources)
{
  const Surface_parts& parts = input.parts();
  if(parts.number() == 1) return {0, 0};
  std::vector<bool> has_source(input.mesh().number_of_vertices(), false); // the first vertex of a part
  sources.for_each_start([&](Vertex v, double) {
    if(!input.mesh().is_isolated(v)) has_source[parts.first_vertex(v)] = true;
  });
  std::size_t vertices = 0;
  for(std::size_t i = 0; i < input.soup().points.size(); ++i)
  {
    bool is_reached = false;
    input.for_each_vertex_of(i, [&](Vertex v) { is_reached = is_reached || has_source[parts.first_vertex(v)]; });
    vertices += input.has_vertex(i) && !is_reached ? 1 : 0;
  }
  const auto reached = static_cast<std::size_t>(std::count(has_source.begin(), has_source.end(), true));
  return {parts.number() - reached, vertices};
}

// Computes the levels, and reports their number before the long computation.
Levels plan_levels(const Mesh_input& input, const Sources& sources, Geodesic& geodesic, const Options& options,
                   Progress& progress)
{
  const auto exact_reach = [&] {
    with_concurrency_tag(options.threads, [&](auto tag) {
      geodesic.build(CGAL::parameters::compute_largest_distance(true).concurrency_tag(tag));
    });
    return geodesic.largest_distance().value();
  };
  const auto bound = [&] { // paths along edges may pass through barriers
    return input.has_barriers() ? exact_reach() : bound_of_reach(input.mesh(), sources);
  };
  Levels levels(options, input.bounding_box_diagonal(), bound, exact_reach);
  if(!levels.empty())
    progress.line("offsets: at " + std::string(levels.is_open_ended() ? "no more than " : "") +
                  counted(levels.size(), "distance"));
  return levels;
}

// Vertices without a path to a source although their part of the surface has one.
void report_cut_off(const Mesh_input& input, const File_field& field, const Run_figures& figures, Progress& progress)
{
  const std::vector<double>& distances = field.columns[0].values;
  std::size_t unreached = 0;
  for(std::size_t i = 0; i < distances.size(); ++i) unreached += input.has_vertex(i) && !(distances[i] < infinity) ? 1 : 0;
  const std::size_t n = unreached - figures.unreached_vertices;
  if(n != 0)
    progress.warning("barriers cut off " + counted(n, "vertex", "vertices") +
                     " from all sources: " + (n == 1 ? "its distance is" : "their distances are") + " infinite");
}

Solution solve(const Mesh_input& input, const Sources& sources, const Levels& levels, Geodesic& geodesic,
               const Options& options, Output_files& files, Run_figures& figures, Progress& progress)
{
  Drawing_check drawing(options.outputs, input.mesh(), input.bounding_box_diagonal(), sources);
  Level_files level_files(files, options, chord_tolerance(options, input));
  const Stopwatch time;
  Offsets offsets = build_and_cut(geodesic, sources, figures.insides, levels, options, chord_tolerance(options, input), drawing,
                                  level_files, progress);
  level_files.finish();
  if(options.order != Curve_order::as_cut) offsets.places = order_curves(offsets.curves, options.order);
  File_field field(input, geodesic, !options.fields.empty() && sources.has_polylines(), options.field_details,
                   options.has_tolerance());
  figures.largest_distance = geodesic.largest_distance().value();
  figures.covered_distance = geodesic.covered_distance();

  if(options.farthest_point)
  {
    const Point p = sources.point_of(geodesic.farthest_point()->first);
    figures.farthest_point = p;
    progress.line("farthest point: " + full_number(p.x()) + ',' + full_number(p.y()) + ',' + full_number(p.z()) +
                  " at distance " + full_number(figures.largest_distance));
  }

  if(input.has_barriers() && !(figures.covered_distance < infinity)) report_cut_off(input, field, figures, progress);
  const bool is_complete = figures.largest_distance < figures.covered_distance;
  progress.line("distances: " + std::string(is_complete ? "up to " : "computed up to ") +
                  short_number(figures.largest_distance) + ", " + counted(geodesic.statistics().windows_propagated, "window") +
                  " propagated",
                time.seconds());
  if(options.has_tolerance())
    progress.line("distances: smaller than the exact ones by at most " + short_number(geodesic.statistics().error_bound));
  if(!levels.empty())
    progress.line("offsets: " + counted(offsets.number_of_curves(), "curve") + " at " +
                  counted(offsets.levels.size(), "distance"));
  for(const std::string& reason :
      missing_offsets(options, levels, offsets.levels, sources.smallest_start_value(), figures.largest_distance,
                      geodesic.is_cancelled(), figures.unreached_parts != 0))
    progress.warning(reason);
  return {std::move(offsets), geodesic.statistics(), std::move(field)};
}

void run(const Options& options)
{
  const Working_threads threads(options.threads);
  Progress progress(options.quiet);
  for(const std::string& file : options.files_written()) Output_files::check(file);

  Run_figures figures;
  figures.threads = threads.number();
  figures.has_tolerance = options.has_tolerance();
  const Mesh_input input = load(options, figures, progress);

  const Stopwatch setup_time;
  progress.show("sources");
  std::optional<Geodesic> object;
  with_concurrency_tag(options.threads, [&](auto tag) {
    if(input.has_barriers())
      object.emplace(input.mesh(), CGAL::parameters::edge_is_constrained_map(input.barriers()).concurrency_tag(tag));
    else
      object.emplace(input.mesh(), CGAL::parameters::concurrency_tag(tag));
  });
  Geodesic& geodesic = *object;
  const Sources sources = find_sources(input, options, geodesic, progress);
  std::tie(figures.unreached_parts, figures.unreached_vertices) = unreached(input, sources);
  if(figures.unreached_parts != 0)
    progress.warning(std::to_string(figures.unreached_parts) + " of " + counted(figures.parts, "part") + " of the surface " +
                     (figures.unreached_parts == 1 ? "has no source: its " : "have no source: their ") +
                     counted(figures.unreached_vertices, "vertex is", "vertices are") + " not reached");
  const Path_queries queries(input, options, geodesic.mesh());
  report(queries.moved_points(), input, "paths", progress);
  figures.insides = find_insides(options, sources, geodesic, progress);
  figures.setup_seconds = setup_time.seconds();
  progress.line("sources: " + counted(geodesic.number_of_sources(), "source"), figures.setup_seconds);

  try
  {
    const Levels levels = plan_levels(input, sources, geodesic, options, progress);
    Output_files files(writing_bar(progress));
    const Solution solution = solve(input, sources, levels, geodesic, options, files, figures, progress);
    write_outputs(solution, input, sources, queries, geodesic, options, files, figures, progress);
  }
  catch(const std::bad_alloc&)
  {
    throw Input_error(quoted(options.mesh) + ": out of memory; fewer distances, a --maximum-distance, fewer --threads or a "
                                             "coarser mesh need less");
  }
}

} // namespace
} // namespace geodesic_offset

int main(int argc, char* argv[])
{
  using namespace geodesic_offset;
  return program_main("geodesic_offset", [&] {
    const Options options = parse_options(argc, argv);
    if(options.help)
      print_help(std::cout);
    else if(options.version)
      print_version(std::cout, "geodesic_offset", has_threads ? ", with TBB" : ", without TBB");
    else
      run(options);
    return 0;
  });
}
