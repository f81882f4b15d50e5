// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "split_output.h"

#include "byte_writer.h"
#include "color_map.h"

#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>

#include <algorithm>

namespace geodesic_offset {

Split_mesh::Split_mesh(const Mesh& mesh, const Geodesic& geodesic, const std::vector<Offset_curve>& curves,
                       double chord_tolerance)
  : m_mesh(mesh), m_band(m_mesh.add_property_map<Face, std::size_t>("f:band").first),
    m_source(m_mesh.add_property_map<Face, std::size_t>("f:source").first)
{
  const auto distance = m_mesh.add_property_map<Vertex, double>("v:distance").first;
  geodesic.vertex_distances(distance);
  CGAL::split_along_offset_curves(m_mesh, curves,
                                  CGAL::parameters::chord_tolerance(chord_tolerance)
                                    .face_band_map(m_band)
                                    .face_source_map(m_source)
                                    .distance_field(geodesic.field())
                                    .vertex_distance_map(distance));
  m_mesh.collect_garbage(); // of the input: vertices are counted without gaps
}

void Split_mesh::write(std::ostream& out) const
{
  out << "ply\nformat binary_little_endian 1.0\ncomment mesh split along geodesic offsets\n"
      << "element vertex " << m_mesh.number_of_vertices() << "\n"
      << "property double x\nproperty double y\nproperty double z\n"
      << "element face " << m_mesh.number_of_faces() << "\n"
      << "property list uchar int vertex_indices\nproperty int band\nproperty int source\n"
      << "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
  Byte_writer bytes(out, Byte_order::little);
  for(Vertex v : m_mesh.vertices())
    for(int c = 0; c < 3; ++c) bytes.write(m_mesh.point(v)[c]);
  std::size_t last_band = 0;
  for(Face f : m_mesh.faces()) last_band = std::max(last_band, m_band[f]);
  const Color_map color_at;
  const Srgb_encoder encode;
  for(Face f : m_mesh.faces())
  {
    bytes.write(std::uint8_t(3));
    for(Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(f))) bytes.write(static_cast<std::uint32_t>(v));
    bytes.write(static_cast<std::uint32_t>(m_band[f]));
    bytes.write(m_source[f] == Geodesic::no_source() ? ~std::uint32_t(0) : static_cast<std::uint32_t>(m_source[f]));
    const Color color = color_at((static_cast<double>(m_band[f]) + 0.5) / static_cast<double>(last_band + 1));
    for(float channel : {color.r, color.g, color.b}) bytes.write(encode(channel));
  }
}

std::uintmax_t Split_mesh::number_of_bytes() const
{
  return 24 * std::uintmax_t(m_mesh.number_of_vertices()) + 24 * std::uintmax_t(m_mesh.number_of_faces());
}

} // namespace geodesic_offset
