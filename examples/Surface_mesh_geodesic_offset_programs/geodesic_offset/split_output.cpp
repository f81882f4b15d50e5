// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "split_output.h"

#include "byte_writer.h"

#include <CGAL/Surface_mesh_geodesic_offset/split_along_geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace geodesic_offset {

namespace {

// A colour of its own for each number: hues differ by the golden angle, so that those of close numbers are far apart.
Color distinct_color(std::size_t i)
{
  constexpr double golden_angle = 2.399963229728653;
  const double hue = golden_angle * static_cast<double>(i);
  return color_from_oklab(0.78 - 0.06 * static_cast<double>(i % 3), 0.11 * std::cos(hue), 0.11 * std::sin(hue));
}

} // namespace

Split_mesh::Property& Split_mesh::add_property(const char* name)
{
  m_properties.push_back({name, m_mesh.add_property_map<Face, std::size_t>(std::string("f:") + name).first});
  return m_properties.back();
}

Split_mesh::Split_mesh(const Mesh& mesh, const Geodesic& geodesic, const std::vector<Offset_curve>& curves,
                       double chord_tolerance)
  : m_mesh(mesh)
{
  const auto band = add_property("band").map, source = add_property("source").map;
  const auto distance = m_mesh.add_property_map<Vertex, double>("v:distance").first;
  geodesic.vertex_distances(distance);
  CGAL::split_along_offset_curves(m_mesh, curves,
                                  CGAL::parameters::chord_tolerance(chord_tolerance)
                                    .face_band_map(band)
                                    .face_source_map(source)
                                    .distance_field(geodesic.field())
                                    .vertex_distance_map(distance));
  m_mesh.collect_garbage(); // of the input: vertices are counted without gaps
  std::size_t bands = 1;
  for(Face f : m_mesh.faces()) bands = std::max(bands, band[f] + 1);
  const Color_map color_at;
  for(std::size_t i = 0; i < bands; ++i)
    m_colors.push_back(color_at((static_cast<double>(i) + 0.5) / static_cast<double>(bands)));
}

Split_mesh::Split_mesh(const Mesh& mesh, const Geodesic::Field::Voronoi_diagram& diagram, std::size_t number_of_sources,
                       double chord_tolerance)
  : m_mesh(mesh)
{
  CGAL::split_along_geodesic_voronoi_diagram(
    m_mesh, diagram, CGAL::parameters::chord_tolerance(chord_tolerance).face_source_map(add_property("source").map));
  m_mesh.collect_garbage();
  for(std::size_t i = 0; i < number_of_sources; ++i) m_colors.push_back(distinct_color(i));
}

void Split_mesh::write(std::ostream& out) const
{
  write(out, {m_mesh.vertices().begin(), m_mesh.vertices().end()}, {m_mesh.faces().begin(), m_mesh.faces().end()});
}

void Split_mesh::write(std::ostream& out, const std::vector<Face>& faces) const
{
  std::vector<Vertex> vertices;
  for(Face f : faces)
    for(Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(f))) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  write(out, vertices, faces);
}

std::map<std::size_t, std::vector<Face>> Split_mesh::parts(const std::string& property) const
{
  const auto named =
    std::find_if(m_properties.begin(), m_properties.end(), [&](const Property& p) { return p.name == property; });
  std::map<std::size_t, std::vector<Face>> result;
  for(Face f : m_mesh.faces()) result[named->map[f]].push_back(f);
  return result;
}

// `vertices`: those of the faces, in increasing order.
void Split_mesh::write(std::ostream& out, const std::vector<Vertex>& vertices, const std::vector<Face>& faces) const
{
  out << "ply\nformat binary_little_endian 1.0\ncomment mesh split along geodesic curves\n"
      << "element vertex " << vertices.size() << "\n"
      << "property double x\nproperty double y\nproperty double z\n"
      << "element face " << faces.size() << "\nproperty list uchar int vertex_indices\n";
  for(const Property& property : m_properties) out << "property int " << property.name << "\n";
  out << "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
  Byte_writer bytes(out, Byte_order::little);
  for(Vertex v : vertices)
    for(int c = 0; c < 3; ++c) bytes.write(m_mesh.point(v)[c]);
  const Color gray = srgb(160, 160, 160);
  const Srgb_encoder encode;
  for(Face f : faces)
  {
    bytes.write(std::uint8_t(3));
    for(Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
      bytes.write(static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin()));
    for(const Property& property : m_properties)
    {
      const std::size_t value = property.map[f];
      bytes.write(value == Geodesic::no_source() ? ~std::uint32_t(0) : static_cast<std::uint32_t>(value));
    }
    const std::size_t value = m_properties.front().map[f];
    const Color color = value < m_colors.size() ? m_colors[value] : gray;
    for(float channel : {color.r, color.g, color.b}) bytes.write(encode(channel));
  }
}

std::uintmax_t Split_mesh::number_of_bytes() const
{
  return 24 * std::uintmax_t(m_mesh.number_of_vertices()) +
         (16 + 4 * m_properties.size()) * std::uintmax_t(m_mesh.number_of_faces());
}

} // namespace geodesic_offset
