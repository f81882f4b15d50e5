// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Small meshes with sources and numbers, from the text files of the folder data. A case consists of a line with its name; the numbers
// of points, faces, and sources; points; faces; sources; and further numbers, up to an empty line. A source is a start value and the
// number of points, each of which is a face and the weights of its corners (a closed polyline repeats its first point); or a start
// value, -1, the number of edges, and their pairs of vertices. Lines that begin with # are comments.

#ifndef GEODESIC_OFFSET_TEST_KNOWN_CASES_H
#define GEODESIC_OFFSET_TEST_KNOWN_CASES_H

#include "geodesic_types.h"
#include "locations.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test {

struct Known_case
{
  std::string name;
  Surface_mesh mesh;
  std::vector<Source> sources;
  std::vector<double> numbers; // behind the sources
};

inline std::vector<Known_case> known_cases(const std::string& file)
{
  typedef Surface_mesh::Vertex_index Vertex_index;
  std::ifstream in(std::filesystem::path(GEODESIC_OFFSET_TEST_DIR) / "data" / file);
  std::vector<Known_case> result;
  for (std::string line; std::getline(in, line);)
  {
    if (line.empty() || line.front() == '#') continue;
    result.emplace_back();
    Known_case& c = result.back();
    c.name = line;
    std::string text;
    while (std::getline(in, line) && !line.empty()) text += line + '\n';
    std::istringstream numbers(text);
    const auto number = [&] {
      double x;
      if (!(numbers >> x)) throw std::runtime_error("a number is missing in " + c.name);
      return x;
    };
    const auto index = [&] { return std::uint32_t(number()); };
    const std::uint32_t points = index(), faces = index(), sources = index();
    for (std::uint32_t i = 0; i < points; ++i)
    {
      const double x = number(), y = number();
      c.mesh.add_vertex(Point_3(x, y, number()));
    }
    std::vector<std::array<std::uint32_t, 3>> corners(faces);
    for (auto& t : corners)
    {
      for (std::uint32_t& v : t) v = index();
      c.mesh.add_face(Vertex_index(t[0]), Vertex_index(t[1]), Vertex_index(t[2]));
    }
    for (std::uint32_t i = 0; i < sources; ++i)
    {
      const double start = number();
      const int size = int(number());
      if (size < 0)
      {
        std::vector<Surface_mesh::Edge_index> edges(index());
        for (auto& e : edges)
        {
          const Vertex_index from(index());
          e = c.mesh.edge(c.mesh.halfedge(from, Vertex_index(index())));
        }
        c.sources.push_back(edge_source(edges, start));
        continue;
      }
      std::vector<Geodesic::Face_location> locations(static_cast<std::size_t>(size));
      for (auto& l : locations)
      {
        l.first = Surface_mesh::Face_index(index());
        std::array<double, 3> w;
        for (double& x : w) x = number();
        const auto order = Locations<Surface_mesh>(c.mesh).corners(l.first);
        const auto& t = corners[l.first];
        for (std::size_t k = 0; k < 3; ++k) l.second[k] = w[std::size_t(std::find(t.begin(), t.end(), order[k]) - t.begin())];
      }
      if (size == 1) c.sources.push_back(point_source(locations.front(), start));
      else c.sources.push_back(polyline_source(locations, size > 3 && locations.front() == locations.back(), start));
    }
    for (double x; numbers >> x;) c.numbers.push_back(x);
  }
  return result;
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_KNOWN_CASES_H
