// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Output of the distances at the vertices of the file, with and without their sides, as a binary PLY file with the vertices
// and faces of the file.

#ifndef GEODESIC_OFFSET_FIELD_OUTPUT_H
#define GEODESIC_OFFSET_FIELD_OUTPUT_H

#include "byte_writer.h"
#include "common.h"
#include "mesh_input.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

namespace geodesic_offset {

// One distance per vertex of the file; infinite for unreachable vertices and vertices without faces.
struct File_distances
{
  std::vector<double> distances;
  std::vector<double> signed_distances; // empty if no source has sides

  File_distances(const Mesh_input& input, const Geodesic& geodesic, bool with_sides)
    : distances(input.soup().points.size(), infinity)
  {
    if(with_sides)
      signed_distances = distances;
    for(std::size_t i = 0; i < distances.size(); ++i)
      input.for_each_vertex_of(i, [&](Vertex v) {
        const double distance = CGAL::to_double(geodesic.distance_to_sources(v));
        if(!(distance < distances[i]))
          return;
        distances[i] = distance;
        if(with_sides)
          signed_distances[i] = geodesic.signed_distance_to_sources(v);
      });
  }

  std::size_t number_of_unreached() const
  {
    return static_cast<std::size_t>(std::count(distances.begin(), distances.end(), infinity));
  }
};

// Size without the header.
inline std::uintmax_t bytes_of_field(const Soup& soup, const File_distances& field)
{
  std::uintmax_t bytes = (field.signed_distances.empty() ? 4 : 5) * sizeof(double) * soup.points.size();
  for(const Polygon& polygon : soup.polygons)
    bytes += 1 + sizeof(std::uint32_t) * polygon.size();
  return bytes;
}

inline void write_field(std::ostream& out, const Soup& soup, const File_distances& field)
{
  std::size_t largest = 0;
  for(const Polygon& polygon : soup.polygons)
    largest = std::max(largest, polygon.size());
  const bool small = (largest < 256);

  out << "ply\nformat binary_little_endian 1.0\ncomment geodesic distances\n"
      << "element vertex " << soup.points.size() << "\n"
      << "property double x\nproperty double y\nproperty double z\nproperty double distance\n"
      << (field.signed_distances.empty() ? "" : "property double signed_distance\n")
      << "element face " << soup.polygons.size() << "\n"
      << "property list " << (small ? "uchar" : "uint") << " int vertex_indices\nend_header\n";

  Byte_writer bytes(out);
  for(std::size_t i = 0; i < soup.points.size(); ++i)
  {
    for(int c = 0; c < 3; ++c) bytes.write(soup.points[i][c]);
    bytes.write(field.distances[i]);
    if(!field.signed_distances.empty()) bytes.write(field.signed_distances[i]);
  }
  for(const Polygon& polygon : soup.polygons)
  {
    if(small)
      bytes.write(static_cast<std::uint8_t>(polygon.size()));
    else
      bytes.write(static_cast<std::uint32_t>(polygon.size()));
    for(std::uint32_t v : polygon) bytes.write(v);
  }
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_FIELD_OUTPUT_H
