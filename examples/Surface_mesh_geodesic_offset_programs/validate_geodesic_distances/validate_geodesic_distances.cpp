// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Program for testing other methods: how far the distances of any program are from certified bounds of the true distances.
// --help lists the options. Exit codes: 0 all distances are within the bounds or the tolerance; 3 some are not; 1 an error
// in something that the command line names (one line on stderr); 2 an error in the command line itself.

#include "common/common.h"
#include "common/file_bytes.h"
#include "common/mesh_input.h"
#include "common/output_file.h"
#include "common/program_main.h"
#include "common/sources.h"
#include "common/version.h"
#include "comparison.h"
#include "distance_table.h"
#include "file_vertices.h"
#include "options.h"
#include "ply_table.h"
#include "report.h"
#include "text_table.h"

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace geodesic_offset {
namespace {

using Enclosure = CGAL::Surface_mesh_geodesic_enclosure<Traits>;

constexpr int all_inside = 0, some_outside = 3;

Distance_table read_table(const Validation_options& options, const Mesh_input& input)
{
  const std::size_t vertices = input.soup().points.size();
  const File_bytes bytes(options.distances);
  Distance_table table = has_extension(options.distances, ".ply")
                         ? Ply_table_reader(options.distances, options.mesh, vertices)(bytes.view(), options.property)
                         : Text_table_reader(options.distances, options.mesh, vertices)(bytes.view());
  require_same_points(table, input, options.mesh);
  return table;
}

// For each vertex of the file. Vertices without faces are unreachable.
std::vector<Comparison::Bounds> bounds_of(const Mesh_input& input, const Enclosure& enclosure)
{
  std::vector<Comparison::Bounds> bounds(input.soup().points.size(), {infinity, infinity});
  for(std::size_t i = 0; i < bounds.size(); ++i)
    input.for_each_vertex_of(i, [&](Vertex v) { bounds[i] = enclosure.distance_bounds(v); });
  return bounds;
}

Enclosure enclosure_on(const Mesh_input& input, const std::string& path)
{
  try
  {
    return Enclosure(input.mesh());
  }
  catch(const std::invalid_argument& error)
  {
    throw Input_error(quoted(path) + ": " + error.what());
  }
}

int validate(const Validation_options& options)
{
  if(!options.per_vertex.empty()) Output_files::check(options.per_vertex);
  require_numbered_vertices(options.mesh);
  const Mesh_input input(options.mesh, Border_joining{false, 0});
  require_unchanged_vertices(input, options.mesh);
  const Distance_table table = read_table(options, input); // before the long computation
  if(!input.warning().empty()) print_warning("validate_geodesic_distances", input.warning());

  Enclosure enclosure = enclosure_on(input, options.mesh);
  const Sources sources(input, options, enclosure.mesh());
  sources.add_to(enclosure);
  if(const std::string far = sources.moved_points().warning(input.bounding_box_diagonal()); !far.empty())
    print_warning("validate_geodesic_distances", far);
  enclosure.build();
  const std::vector<Comparison::Bounds> bounds = bounds_of(input, enclosure);
  const Comparison comparison(bounds, table.distances, options.tolerance);

  Output_files files;
  if(!options.per_vertex.empty())
    files.add(options.per_vertex,
              [&](std::ostream& out) { write_per_vertex(out, bounds, table.distances, comparison.errors); });
  std::cout << "mesh: " << quoted(options.mesh) << ", " << counted(bounds.size(), "vertex", "vertices") << ", "
            << counted(input.soup().polygons.size(), "face") << '\n';
  for(const std::string& remark : input.remarks()) std::cout << "mesh: " << remark << '\n';
  if(const std::size_t unused = number_of_unused_vertices(input))
    std::cout << "mesh: " << counted(unused, "vertex", "vertices") << " without faces, infinitely far away\n";
  if(input.has_coinciding_border_edges()) std::cout << "mesh: some border edges are at the same place; they are not joined\n";
  for(const std::string& remark : sources.remarks()) std::cout << "sources: " << remark << '\n';
  for(const std::string& warning : sources.warnings()) print_warning("validate_geodesic_distances", warning);
  if(const std::string moved = sources.moved_points().remark(); !moved.empty()) std::cout << "sources: " << moved << '\n';
  std::cout << "sources: " << counted(enclosure.number_of_sources(), "source") << '\n' << "distances: " << table.name << '\n';
  Report_writer(std::cout, comparison)(bounds, table.distances, options.tolerance);
  check_standard_output();
  files.commit();
  return comparison.beyond_tolerance == 0 ? all_inside : some_outside;
}

} // namespace
} // namespace geodesic_offset

int main(int argc, char* argv[])
{
  using namespace geodesic_offset;
  return program_main("validate_geodesic_distances", [&] {
    const Validation_options options = parse_validation_options(argc, argv);
    if(options.help)
    {
      print_validation_help(std::cout);
      return 0;
    }
    if(options.version)
    {
      print_version(std::cout, "validate_geodesic_distances");
      return 0;
    }
    return validate(options);
  });
}
