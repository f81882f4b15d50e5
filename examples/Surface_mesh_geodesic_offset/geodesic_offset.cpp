// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact geodesic distances on a triangle mesh and exact geodesic offsets of curves, as a program.
// --help lists the options. Exit codes: 0 success, 1 something that the command line names is wrong (one line on stderr
// says what), 2 the command line itself is wrong. Outputs appear only if everything succeeded.

#include "geodesic_offset/common.h"
#include "geodesic_offset/field_output.h"
#include "geodesic_offset/mesh_input.h"
#include "geodesic_offset/options.h"
#include "geodesic_offset/output_file.h"
#include "geodesic_offset/picture.h"
#include "geodesic_offset/png_output.h"
#include "geodesic_offset/program_main.h"
#include "geodesic_offset/progress.h"
#include "geodesic_offset/sources.h"
#include "geodesic_offset/stats_output.h"
#include "geodesic_offset/threads.h"

#include <CGAL/Surface_mesh_geodesic_offset/IO/write_dxf.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_obj.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_polylines.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_svg.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/write_vtk.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace geodesic_offset {
namespace {

std::vector<std::string> named_outputs(const Options& options)
{
  std::vector<std::string> files = options.outputs;
  for(const std::string& file : {options.field, options.picture, options.stats})
    if(!file.empty())
      files.push_back(file);
  return files;
}

// Without a count, the number of offsets follows from the spacing; a slip of the finger must not fill the disk.
void check_spacing(const Options& options, double diagonal)
{
  constexpr double most = 1e6;
  if(options.spacing && !options.count && diagonal / *options.spacing > most)
    throw Usage_error("--spacing " + short_number(*options.spacing) +
                      " would give more than a million offsets of this mesh; --count limits their number");
}

template <class Concurrency_tag>
std::vector<Offset_curve> cut(Geodesic& geodesic, const Options& options)
{
  const double maximum = options.maximum_distance.value_or(infinity);
  const auto parameters = CGAL::parameters::distance_limit(maximum);
  std::vector<Offset_curve> curves;
  if(options.spacing)
  {
    const auto levels =
      options.count ? CGAL::Offset_levels<double>::equally_spaced(*options.spacing, *options.count)
                    : CGAL::Offset_levels<double>::equally_spaced(*options.spacing);
    geodesic.build_with_offset_curves<Concurrency_tag>(levels, std::back_inserter(curves), options.selection, parameters);
  }
  else if(!options.distances.empty())
  {
    geodesic.build_with_offset_curves<Concurrency_tag>(options.distances, std::back_inserter(curves), options.selection,
                                                       parameters);
  }
  else
    geodesic.build<Concurrency_tag>(parameters);
  std::stable_sort(curves.begin(), curves.end(),
                   [](const Offset_curve& a, const Offset_curve& b) { return a.distance() < b.distance(); });
  return curves;
}

void write_svg(std::ostream& out, const std::string& file, const std::vector<Offset_curve>& curves)
{
  try
  {
    CGAL::IO::write_offset_SVG(out, curves);
  }
  catch(const std::invalid_argument& error)
  {
    throw Input_error("cannot write " + quoted(file) + ": " + error.what());
  }
}

void write_curves(Output_files& files, const std::string& file, const std::vector<Offset_curve>& curves, double tolerance)
{
  files.add(file, [&](std::ostream& out) {
    if(has_extension(file, ".vtk"))
      CGAL::IO::write_offset_VTK(out, curves, tolerance);
    else if(has_extension(file, ".obj"))
      CGAL::IO::write_offset_OBJ(out, curves, tolerance);
    else if(has_extension(file, ".dxf"))
      CGAL::IO::write_offset_DXF(out, curves, tolerance);
    else if(has_extension(file, ".svg"))
      write_svg(out, file, curves);
    else
      CGAL::IO::write_offset_polylines(out, curves, tolerance);
  });
}

template <class Concurrency_tag>
std::vector<Offset_curve> solve(Geodesic& geodesic, const Sources& sources, const Options& options)
{
  try
  {
    return cut<Concurrency_tag>(geodesic, options);
  }
  catch(const std::invalid_argument&)
  {
    // the library knows sources by their numbers, the user by their files
    if(options.selection.side == CGAL::Offset_side::INSIDE || options.selection.side == CGAL::Offset_side::OUTSIDE)
      sources.check_insides();
    throw;
  }
}

View view_of(const Options& options, const Mesh& mesh, const Sources& sources)
{
  const auto vector = [](const std::array<double, 3>& v) {
    return View::normalized(Vector(v[0], v[1], v[2]) / std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}));
  };
  const Vector up = options.up ? vector(*options.up) : Vector(0, 1, 0);
  if(options.view)
    return View(vector(*options.view), up);
  std::vector<Point> points = sources.points();
  for(const Polyline& polyline : sources.polylines())
    points.insert(points.end(), polyline.begin(), polyline.end());
  return choose_view(mesh, points, up);
}

Image picture_of(const Options& options, const Mesh& mesh, const Sources& sources, const Geodesic& geodesic,
                 const std::vector<Offset_curve>& curves)
{
  std::vector<double> distances(mesh.number_of_vertices());
  for(Vertex v : mesh.vertices())
    distances[v] = CGAL::to_double(geodesic.distance_to_sources(v));
  Picture picture(mesh, distances, view_of(options, mesh, sources));
  for(const Point& point : sources.points())
    picture.add_source(point);
  for(const Polyline& polyline : sources.polylines())
    picture.add_source(polyline);
  for(const Offset_curve& curve : curves)
  {
    Polyline polyline;
    curve.points(picture.chord_tolerance(), std::back_inserter(polyline));
    picture.add_offset(polyline);
  }
  return picture.render();
}

template <class Concurrency_tag>
void run(const Options& options, Concurrency_tag tag)
{
  const Progress progress(options.quiet);
  for(const std::string& file : named_outputs(options))
    Output_files::check(file);

  Run_figures figures;
  const Stopwatch load_time;
  const Mesh_input input(options.mesh, options.stitch);
  const Mesh& mesh = input.mesh();
  figures.vertices = mesh.number_of_vertices();
  figures.faces = mesh.number_of_faces();
  figures.load_seconds = load_time.seconds();
  progress.line("mesh: " + counted(figures.vertices, "vertex", "vertices") + ", " + counted(figures.faces, "face"),
                figures.load_seconds);
  for(const std::string& remark : input.remarks())
    progress.line("mesh: " + remark);
  check_spacing(options, input.bounding_box_diagonal());

  const Stopwatch setup_time;
  Geodesic geodesic(mesh, Traits(), tag);
  const Sources sources(input, options, geodesic);
  sources.add_to(geodesic);
  figures.setup_seconds = setup_time.seconds();
  for(const std::string& remark : sources.remarks())
    progress.line("sources: " + remark);
  progress.line("sources: " + counted(geodesic.number_of_sources(), "source"), figures.setup_seconds);

  const Stopwatch solve_time;
  const std::vector<Offset_curve> curves = solve<Concurrency_tag>(geodesic, sources, options);
  const Geodesic::Statistics& statistics = geodesic.statistics();
  const File_distances field(input, geodesic, sources.has_polylines());
  std::size_t unreached = 0;
  for(double distance : field.distances)
    if(distance == infinity)
      ++unreached;
    else
      figures.largest_distance = std::max(figures.largest_distance, distance);
  progress.line("distances: up to " + short_number(figures.largest_distance) + ", " +
                  counted(statistics.windows_propagated, "window") + " propagated",
                solve_time.seconds());
  if(unreached != 0)
    progress.line("distances: " + counted(unreached, "vertex", "vertices") + " not reached");
  const std::vector<Level_figures> levels = level_figures(curves, options.distances);
  if(options.has_levels())
    progress.line("offsets: " + counted(curves.size(), "curve") + " at " + counted(levels.size(), "distance"));

  Output_files files;
  const double tolerance = options.tolerance.value_or(1e-4 * input.bounding_box_diagonal());
  const Stopwatch write_time;
  for(const std::string& file : options.outputs)
    write_curves(files, file, curves, tolerance);
  if(!options.field.empty())
    files.add(options.field, [&](std::ostream& out) { write_field(out, input.soup(), field); });
  if(!options.picture.empty())
  {
    const Image image = picture_of(options, mesh, sources, geodesic, curves);
    files.add(options.picture, [&](std::ostream& out) { write_png(out, image); });
  }
  if(!options.stats.empty())
    files.add(options.stats, [&](std::ostream& out) { write_stats(out, figures, statistics, levels); });
  files.commit();
  for(const std::string& file : named_outputs(options))
    progress.line("wrote " + file);
  progress.line("outputs written", write_time.seconds());
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
    else
      with_threads(options.threads, [&](auto tag) { run(options, tag); });
    return 0;
  });
}
