// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Shortest paths from points of the command line to the nearest source, and their files.

#ifndef GEODESIC_OFFSET_PATHS_H
#define GEODESIC_OFFSET_PATHS_H

#include "common/common.h"
#include "common/mesh_input.h"
#include "common/numbers.h"
#include "common/sources.h"
#include "options.h"
#include "polyline_output.h"
#include "progress.h"

#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace geodesic_offset {

struct Surface_path
{
  std::size_t query; // index of the point on the command line, vertices first
  std::vector<Point> points;
  double distance;
  std::size_t source;
  int side; // as in .vtk files of offsets
};

// The points from which paths are requested, located on the mesh.
class Path_queries
{
  struct Query
  {
    std::string name;
    std::vector<Vertex> vertices; // those at a vertex of the file; empty: the location
    Face_location location;
  };

  std::vector<Query> m_queries;
  Moved_points m_moved;

public:
  // Throws Input_error.
  Path_queries(const Mesh_input& input, const Options& options, const Geodesic_mesh& geodesic)
  {
    for(std::size_t i : options.path_vertices)
      m_queries.push_back({"--path-from-vertex " + std::to_string(i), vertices_at(input, i, "--path-from-vertex", options.mesh),
                           Face_location()});
    for(const std::array<double, 3>& p : options.path_points)
    {
      const std::string name = "--path-from " + short_number(p[0]) + ',' + short_number(p[1]) + ',' + short_number(p[2]);
      m_queries.push_back({name, {}, put_on_surface(geodesic, Point(p[0], p[1], p[2]), options, m_moved, [&] { return name; })});
    }
  }

  const Moved_points& moved_points() const { return m_moved; }

  // Leaves out points that no path reaches, with a warning. From inside faces the last build must have kept windows.
  std::vector<Surface_path> paths(const Mesh_input& input, const Geodesic& geodesic, Progress& progress) const
  {
    std::vector<Surface_path> result;
    for(std::size_t i = 0; i < m_queries.size(); ++i)
    {
      const Query& query = m_queries[i];
      const auto add = [&](const auto& location) {
        if(const auto nearest = geodesic.nearest_source(location))
        {
          result.push_back({i, {}, nearest->distance, nearest->source, static_cast<int>(nearest->side)});
          geodesic.shortest_path_points_to_sources(location, std::back_inserter(result.back().points));
        }
        else
          progress.warning("no path for " + query.name +
                           (geodesic.covered_distance() < infinity ? ": no distance was computed there"
                            : input.has_barriers()
                              ? ": barriers cut it off from the sources, or it is on another part of the surface"
                              : ": it is on another part of the surface than the sources"));
      };
      if(query.vertices.empty())
      {
        add(query.location);
        continue;
      }
      Vertex nearest = query.vertices.front();
      for(Vertex v : query.vertices)
        if(geodesic.distance_to_sources(v) < geodesic.distance_to_sources(nearest)) nearest = v;
      add(nearest);
    }
    return result;
  }
};

namespace internal {

inline void write_path_vtk(std::ostream& out, const std::vector<Surface_path>& paths)
{
  write_vtk_lines(out, "geodesic paths", paths);
  if(paths.empty()) return;
  out << "CELL_DATA " << paths.size() << "\nSCALARS distance double 1\nLOOKUP_TABLE default\n";
  for(const Surface_path& path : paths) out << path.distance << '\n';
  out << "FIELD paths 3\n";
  write_vtk_integers(out, "query", paths, [](const Surface_path& path) { return path.query; });
  write_vtk_integers(out, "source", paths, [](const Surface_path& path) { return path.source; });
  write_vtk_integers(out, "side", paths, [](const Surface_path& path) { return path.side; });
}

} // namespace internal

// In the format of the extension.
inline void write_paths(std::ostream& out, const std::string& file, const std::vector<Surface_path>& paths)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  if(has_extension(file, ".vtk"))
    internal::write_path_vtk(out, paths);
  else
    write_polylines(out, paths);
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_PATHS_H
